# Why: libsf must build inside somebody else's meson project, with nothing of its own beside the
# libraries: no tests, no program, no package for Python. That project is written here; it asks for
# dependency('libsf-io') and builds consumer.c, in C and in C++.
# usage: subproject.sh MESON SOURCE
set -u
meson=$1 source=$2
here=$(mktemp -d) || exit 99
trap 'rm -rf "$here"' EXIT
mkdir -p "$here/host/subprojects"
cp "$source/tests/install/consumer.c" "$here/host/consumer.c"
cp "$source/tests/install/consumer.c" "$here/host/consumer.cpp"
# A copy, so that nothing is found that is not libsf's: what a subproject gets is libsf/ and three files.
mkdir "$here/host/subprojects/libsf"
cp -R "$source/libsf" "$source/meson.build" "$source/meson_options.txt" "$here/host/subprojects/libsf"
cat >"$here/host/meson.build" <<'TEXT'
project('host', 'c', 'cpp', version: '7.7', default_options: ['default_library=static', 'optimization=0'])
subproject('libsf')
libsf = dependency('libsf-io', version: '>=0.1')
test('c', executable('consumer', 'consumer.c', dependencies: libsf))
test('c++', executable('consumer++', 'consumer.cpp', dependencies: libsf))
TEXT
count=0 failures=0

ok() {
    count=$((count + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $count - $2"
    else
        failures=$((failures + 1))
        echo "not ok $count - $2"
        tail -20 "$here/log" | sed 's/^/#   /'
    fi
}

"$meson" setup "$here/build" "$here/host" >"$here/log" 2>&1
ok $? "set up as a subproject"
"$meson" introspect --targets "$here/build" >"$here/targets"
! grep -Eo '"filename": \["[^"]*/(sf|sf-bench|sculpt)"' "$here/targets" >"$here/log" && grep -q consumer "$here/targets"
ok $? "nothing but the libraries is built with it"
"$meson" test -C "$here/build" >"$here/log" 2>&1
ok $? "a program in C and one in C++ build and run"
"$meson" install -C "$here/build" --destdir "$here/root" --quiet >"$here/log" 2>&1 &&
    find "$here/root" -name io.h | grep -q . && [ "$(find "$here/root" -name 'libsf*.a' | wc -l)" = 2 ]
ok $? "installed with the project around it"
echo "1..$count"
exit $((failures > 0))
