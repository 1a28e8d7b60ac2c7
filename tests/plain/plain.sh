# Why: a machine may have a C compiler and nothing else. The build that ./dev then falls back on is
# used by nobody who works on this, so it is tried here: library and program from an empty folder,
# a check whose answer is known, and a second call that has nothing to do.
# usage: plain.sh SOURCE COMPILER...
set -u
cd "$1" || exit 99
shift
here=$(mktemp -d) || exit 99
trap 'rm -rf "$here"' EXIT
count=0 failures=0

ok() {
    count=$((count + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $count - $2"
    else
        failures=$((failures + 1))
        echo "not ok $count - $2"
        sed 's/^/#   /' "$here/log" | tail -20
    fi
}

build() {
    CC="$*" PLAIN_FLAGS=-O0 sh tests/plain/build.sh "$here/plain" run >"$here/log" 2>&1
}

build "$@"
ok $? "cc alone builds the library and the program"
"$here/plain/sf" check scene:garden --resolution 24 >"$here/log" 2>&1
[ $? -eq 1 ]
ok $? "the program checks: the garden does not print without supports"
touch "$here/then"
build "$@" && [ -z "$(find "$here/plain" -name '*.o' -newer "$here/then")" ]
ok $? "with nothing new, nothing is compiled again"
echo "1..$count"
exit $((failures > 0))
