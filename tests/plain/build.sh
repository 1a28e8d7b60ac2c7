#!/bin/sh
# Builds libsf, the command line and (asked for "test" or "bench") the test programs or the benches
# with nothing but cc: no meson, no libraries beside libc. usage: build.sh FOLDER run|test|bench
#
# What belongs to a program is what lies in its folder, so there is no list here that could fall
# behind meson's (tests/house compares those with the folders). Objects are made again only when a
# source or any header is newer. Tests that need more than the library and libc (the installed
# package, other programs) stay with meson.
set -eu
out=$1 purpose=$2
mkdir -p "$out"
cc=${CC:-cc}
flags="-std=c99 ${PLAIN_FLAGS:--O2} -ffp-contract=off -DSF_STATIC -DSF_BUILDING -Ilibsf/include"
# Doubles in the 80-bit registers of 32-bit x86 would be other bytes than everywhere else, and floats
# that s390x's gcc computes as doubles.
case $($cc -dumpmachine 2>/dev/null) in
i?86-*) flags="$flags -msse2 -mfpmath=sse" ;;
s390x-*) flags="$flags -fexcess-precision=fast" ;;
esac
inside="-Ilibsf -Itests -Idemo/scenes"

# One header that is newer than the last build stands for all of them.
headers=$(find libsf demo tests -name '*.h' -newer "$out/.built" 2>/dev/null | head -n 1)
[ -f "$out/.built" ] || headers=all

# $1: source, then flags of its own. Prints the object's name; compiles when it is out of date.
compile() {
    source=$1
    shift
    object=$out/$(printf '%s' "${source%.c}" | tr / -).o
    if [ -n "$headers" ] || [ ! -f "$object" ] || [ -n "$(find "$source" -newer "$object")" ]; then
        # shellcheck disable=SC2086
        $cc $flags "$@" -c "$source" -o "$object" || { rm -f "$object"; exit 1; }
    fi
    printf '%s ' "$object"
}

library=
for source in libsf/*/*.c libsf/*/*/*.c; do
    library="$library$(compile "$source" -Ilibsf)"
done
scenes=
for source in demo/scenes/*.c; do
    scenes="$scenes$(compile "$source" -Idemo/scenes -Idemo/shade)"
done
program=
for source in demo/sf/*.c; do
    program="$program$(compile "$source" -D_XOPEN_SOURCE=700 -Idemo/scenes -Idemo/shade)"
done
# shellcheck disable=SC2086
$cc $program $scenes $library -lm -lpthread -o "$out/sf"

if [ "$purpose" = bench ]; then
    # shellcheck disable=SC2086
    $cc $flags $inside tests/bench/*.c $library -lm -lpthread -o "$out/sf-bench"
fi
if [ "$purpose" = test ]; then
    rm -f "$out"/test-*
    # A test program is one file that ends with the framework's words.
    for source in $(grep -l 'return test_finish()' tests/*/*.c tests/*/*/*.c); do
        case $source in tests/verify/* | tests/gl/* | tests/alloc/*) continue ;; esac
        name=test-$(printf '%s' "${source%.c}" | sed 's:^tests/::' | tr / -)
        # shellcheck disable=SC2086
        $cc $flags $inside "$source" $scenes $library -lm -lpthread -o "$out/$name"
    done
fi
touch "$out/.built"
