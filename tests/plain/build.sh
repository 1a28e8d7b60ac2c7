#!/bin/sh
# Builds libsf, the command line and (asked for "test") the test programs with nothing but cc: no
# meson, no libraries beside libc. usage: build.sh FOLDER run|test
#
# Objects are made again only when a source or any header is newer. Tests that need more than the
# library and libc (the installed package, the finished program) stay with meson.
set -eu
out=$1 purpose=$2
mkdir -p "$out"
cc=${CC:-cc}
flags="-std=c99 -O2 -ffp-contract=off -DSF_STATIC -DSF_BUILDING -Ilibsf/include -Ilibsf -Idemo -Itests"

# The newest header stands for all of them.
headers=$(find libsf demo tests -name '*.h' -newer "$out/.built" 2>/dev/null | head -n 1)
[ -f "$out/.built" ] || headers=all

# $1: source. Prints the object's name; compiles when it is out of date.
compile() {
    object=$out/$(printf '%s' "${1%.c}" | tr / -).o
    if [ -n "$headers" ] || [ ! -f "$object" ] || [ -n "$(find "$1" -newer "$object")" ]; then
        # shellcheck disable=SC2086
        $cc $flags -c "$1" -o "$object" || { rm -f "$object"; exit 1; }
    fi
    printf '%s ' "$object"
}

library=
for source in libsf/*/*.c; do
    library="$library$(compile "$source")"
done
program=
for source in demo/sf/*.c demo/scenes/*.c; do
    [ ! -f "$source" ] || program="$program$(compile "$source")"
done
# shellcheck disable=SC2086
$cc $program $library -lm -lpthread -o "$out/sf"

if [ "$purpose" = test ]; then
    rm -f "$out"/test-*
    for source in tests/unit/*/*.c tests/simd/*.c tests/law/*.c tests/io/*.c; do
        [ -f "$source" ] && grep -q 'test_finish()' "$source" || continue
        name=test-$(printf '%s' "${source%.c}" | sed 's:^tests/::' | tr / -)
        # shellcheck disable=SC2086
        $cc $flags "$source" $library -lm -lpthread -o "$out/$name" ||
            echo "dev: $source is not for this build"
    done
fi
touch "$out/.built"
