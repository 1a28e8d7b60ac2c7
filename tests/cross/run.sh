#!/bin/sh
# Why: the same bytes from any compiler, at any level of optimisation, on any machine. tests/cross/jobs.c
# has the jobs and the hashes that they must have; this builds it with each compiler that is here and
# runs it, by qemu where it is for another machine. One of these, s390x, keeps numbers the other way
# round; one, armv7, has words of 32 bits.
#
# usage: run.sh SOURCE FOLDER [NAME...]; speaks TAP. Objects are kept in FOLDER.
set -u
source=$1 out=$2
shift 2
mkdir -p "$out"
flags="-std=c99 -w -ffp-contract=off -DSF_STATIC -DSF_BUILDING -I$source/libsf/include -I$source/libsf -I$source/tests"
count=0 bad=0
CCACHE=$(command -v ccache || true)
export CCACHE

# Objects of the library and of the jobs in folder $1, by compiler $2 with flags $3.
compile() {
    mkdir -p "$1"
    changed=all # a header that is newer than the program stands for all of them
    [ ! -f "$1/jobs" ] || changed=$(find "$source/libsf" "$source/tests" -name '*.h' -newer "$1/jobs" | head -n 1)
    for file in "$source"/libsf/*/*.c "$source"/libsf/*/*/*.c "$source"/tests/cross/jobs.c; do
        case $file in */libsf/io/* | */libsf/link/*) continue ;; esac
        object=$1/$(printf '%s' "${file#"$source"/}" | tr / -).o
        if [ -f "$object" ] && [ -z "$changed" ] && [ -z "$(find "$file" -newer "$object")" ]; then
            continue
        fi
        printf '%s\0%s\0' "$file" "$object"
    done | xargs -0 -r -n 2 -P "${JOBS:-2}" sh -c "\$CCACHE $2 $flags $3 -c \"\$0\" -o \"\$1\""
}

# $1: name; $2: compiler; $3: flags; $4: what runs it, or nothing.
try() {
    name=$1 cc=$2 more=$3 by=$4
    case " $wanted " in *" $name "* | "  ") ;; *) return ;; esac
    count=$((count + 1))
    if ! command -v "$cc" >/dev/null 2>&1; then
        echo "ok $count - $name # SKIP $cc is not installed"
        return
    fi
    # shellcheck disable=SC2086
    if [ -n "$by" ] && ! command -v ${by%% *} >/dev/null 2>&1; then
        echo "ok $count - $name # SKIP ${by%% *} is not installed"
        return
    fi
    # shellcheck disable=SC2086
    if ! echo 'int main(void) { return 0; }' | $cc -x c $more - -lm -o "$out/probe" 2>/dev/null; then
        echo "ok $count - $name # SKIP $cc cannot link for it: its C library is not installed"
        return
    fi
    # shellcheck disable=SC2086
    if compile "$out/$name" "$cc" "$more" &&
        $cc $more "$out/$name"/*.o -lm -lpthread -o "$out/$name/jobs" &&
        $by "$out/$name/jobs" once >"$out/$name.log" 2>&1; then
        echo "ok $count - $name"
    else
        bad=1
        [ ! -f "$out/$name.log" ] || sed 's/^/# /' "$out/$name.log"
        echo "not ok $count - $name"
    fi
}

wanted="$*"
try gcc-O0 gcc -O0 ''
try gcc-O2 gcc -O2 ''
try gcc-O3 gcc '-O3 -march=native' ''
try gcc-ndebug gcc '-O2 -DNDEBUG' ''
try clang-O0 "${CLANG:-clang}" -O0 ''
try clang-O2 "${CLANG:-clang}" -O2 ''
try clang-O3 "${CLANG:-clang}" '-O3 -march=native' ''
try i686 gcc '-m32 -O2 -msse2 -mfpmath=sse' ''
try aarch64 aarch64-linux-gnu-gcc -O2 'qemu-aarch64 -L /usr/aarch64-linux-gnu'
try armv7 arm-linux-gnueabihf-gcc -O2 'qemu-arm -L /usr/arm-linux-gnueabihf'
try s390x s390x-linux-gnu-gcc '-O2 -fexcess-precision=fast' 'qemu-s390x -L /usr/s390x-linux-gnu'
echo "1..$count"
exit $bad
