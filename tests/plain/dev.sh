# Why: ./dev is what a fresh machine is told to call, and promises to install what is missing for the
# verb at hand. For `fmt` it asked the caller to. Here apt, its user and the formatter are stand-ins
# that write down what they are asked, in a project of one file.
# usage: dev.sh SOURCE
set -u
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
        sed 's/^/#   /' "$here/said" "$here/asked"
    fi
}

mkdir -p "$here/bin" "$here/project/libsf" "$here/project/demo" "$here/project/tests" "$here/project/fuzz"
cp "$1/dev" "$here/project/dev"
: >"$here/project/libsf/one.c"
: >"$here/asked"
for tool in sh cat dirname mkdir find rm grep sed chmod; do
    ln -s "$(command -v $tool)" "$here/bin/$tool"
done
cat >"$here/bin/id" <<'SCRIPT'
#!/bin/sh
echo 0
SCRIPT
cat >"$here/bin/apt-get" <<SCRIPT
#!/bin/sh
echo "apt-get \$*" >>"$here/asked"
case \$* in *install*clang-format-14*) ;; *) exit 0 ;; esac
cat >"$here/bin/clang-format-14" <<'TOOL'
#!/bin/sh
[ "\$1" != --version ] || echo "Debian clang-format version 14.0.6"
[ "\$1" = --version ] || echo "format \$*" >>"$here/asked"
TOOL
chmod +x "$here/bin/clang-format-14"
SCRIPT
cat >"$here/bin/clang-format" <<'SCRIPT'
#!/bin/sh
echo "clang-format version 19.1.0"
SCRIPT
chmod +x "$here/bin/id" "$here/bin/apt-get" "$here/bin/clang-format"

# dev ARGS: leaves exit, and $here/said.
dev() {
    exit=0
    (cd "$here/project" && env PATH="$here/bin" "$@" sh ./dev fmt) >"$here/said" 2>&1 || exit=$?
}

dev DEV_NO_INSTALL=1
[ $exit -eq 3 ] && [ ! -s "$here/asked" ] && grep -q 'clang-format-14' "$here/said"
ok $? "where nothing may be installed, fmt says what is missing; another version will not do"
dev DEV=1
[ $exit -eq 0 ] && grep -q 'install.*clang-format-14' "$here/asked" && grep -q 'installing' "$here/said"
ok $? "fmt installs the formatter, and says so"
! grep -q 'meson\|gcc' "$here/asked"
ok $? "and nothing else"
grep -q 'format -i libsf/one.c' "$here/asked"
ok $? "and formats the sources"
: >"$here/asked"
dev DEV=1
[ $exit -eq 0 ] && ! grep -q apt-get "$here/asked"
ok $? "a second call installs nothing"
echo "1..$count"
exit $((failures > 0))
