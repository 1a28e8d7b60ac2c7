# Why: a library that builds but cannot be used from outside is of no use. Installs into an empty
# folder, moves everything (so that nothing can be found where it was made for) and builds
# consumer.c there: by pkg-config and by CMake, with the shared and with the static libraries.
# The example in the README is built the same way and run: one that does not work is worse than none.
# usage: install.sh MESON BUILD VERSION SF COMPILER...; SF: the command line program, or empty
set -u
meson=$1 build=$2 version=$3 sf=$4
shift 4
compiler=$*
# CMake wants the compiler alone, without what remembers its work or its options.
case ${1##*/} in ccache | sccache | distcc) shift ;; esac
program=$1
source=$(cd "$(dirname "$0")" && pwd)
here=$(mktemp -d) || exit 99
trap 'rm -rf "$here"' EXIT
unset DESTDIR
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

skip() {
    count=$((count + 1))
    echo "ok $count - $1 # SKIP $2"
}

# can KIND: whether there is a libsf of that kind, KIND being shared or static.
can() {
    case $1 in
    shared) ls "$here/whole/$libdir"/libsf.so* "$here/whole/$libdir"/libsf*.dylib ;;
    static) ls "$here/whole/$libdir/libsf.a" ;;
    esac 2>/dev/null | grep -q .
}

# The libraries of one kind alone, so that the linker has no choice; then what a user would type.
by_pkg_config() {
    cp -R "$here/whole" "$here/$1"
    case $1 in
    shared) flags='' unwanted='libsf*.a' ;;
    static) flags=--static unwanted='libsf*.so* libsf*.dylib' ;;
    esac
    # shellcheck disable=SC2086
    (
        cd "$here/$1/$libdir" && rm -f $unwanted
        export PKG_CONFIG_PATH="$here/$1/$libdir/pkgconfig:${PKG_CONFIG_PATH:-}"
        [ "$(pkg-config --modversion libsf)" = "$version" ] || exit 1
        $compiler "$source/consumer.c" -o "$here/$1/consumer" \
            $(pkg-config $flags --cflags --libs libsf-io libsf) || exit 1
        [ $1 = static ] || export LD_LIBRARY_PATH="$PWD" DYLD_LIBRARY_PATH="$PWD"
        "$here/$1/consumer" || exit 1
        # The same in C++, where there is one.
        command -v c++ >/dev/null || exit 0
        c++ -x c++ "$source/consumer.c" -x none -o "$here/$1/consumer++" \
            $(pkg-config $flags --cflags --libs libsf-io libsf) || exit 1
        "$here/$1/consumer++"
    ) >"$here/log" 2>&1
}

# Headers of ours include those of the C library alone, so nobody's folder is asked for but ours, and
# those that spng and jansson bring along.
asks_for_few_folders() {
    (
        export PKG_CONFIG_PATH="$here/whole/$libdir/pkgconfig:${PKG_CONFIG_PATH:-}"
        brought=" $(pkg-config --cflags-only-I spng jansson 2>/dev/null) "
        {
            pkg-config --cflags-only-I libsf-io || exit 1
            pkg-config --static --cflags-only-I libsf-io || exit 1
        } | tr ' ' '\n' | grep -v '^$' | while read -r folder; do
            case $brought in *" $folder "*) continue ;; esac
            [ "$(cd "${folder#-I}" && pwd -P)" = "$(cd "$here/whole/include" && pwd -P)" ] || { echo "$folder" && exit 1; }
        done
    ) >"$here/log" 2>&1
}

# The README's example, on a mesh of the garden of which not all prints at 45 degrees.
readme_example() {
    sed -n '/^```c$/,/^```$/p' "$source/../../README.md" | sed '/^```/d' >"$here/example.c"
    (
        cd "$here" && export PKG_CONFIG_PATH="$here/whole/$libdir/pkgconfig:${PKG_CONFIG_PATH:-}"
        export LD_LIBRARY_PATH="$here/whole/$libdir" DYLD_LIBRARY_PATH="$here/whole/$libdir"
        # shellcheck disable=SC2046
        $compiler -std=c99 -Wall -Wextra -pedantic -Werror example.c -o example \
            $(pkg-config --cflags --libs libsf-io libsf) || exit 1
        ./example 2>refusal && exit 1
        grep 'part.stl' refusal || exit 1
        [ -n "$sf" ] || exit 0
        "$sf" trim scene:garden --angle 75 --resolution 96 -o part.stl -q || exit 1
        ./example | tee answer
        grep -Eq '^[1-9][0-9]+ voxels print, [1-9][0-9]+ do not$' answer
    ) >"$here/log" 2>&1
}

by_cmake() {
    static=OFF
    [ "$1" = shared ] || static=ON
    {
        cmake -S "$source" -B "$here/cmake-$1" -DVERSION="$version" -DSTATIC=$static \
            -DCMAKE_PREFIX_PATH="$here/whole" -DCMAKE_C_COMPILER="$program" &&
            cmake --build "$here/cmake-$1" && "$here/cmake-$1/consumer"
    } >"$here/log" 2>&1
}

# A version that is not there must be refused, or a program would find out while it runs.
cmake_refuses() {
    cmake -S "$source" -B "$here/refused" -DVERSION="$1" -DCMAKE_PREFIX_PATH="$here/whole" \
        -DCMAKE_C_COMPILER="$program" >"$here/log" 2>&1 && return 1
    grep -q 'version: ' "$here/log"
}

"$meson" install -C "$build" --no-rebuild --quiet --destdir "$here/root" >"$here/log" 2>&1
ok $? "meson install into an empty folder"
header=$(find "$here/root" -path '*/include/sf/base.h')
prefix=${header%/include/sf/base.h}
pc=$(find "$prefix" -name libsf.pc)
libdir=$(dirname "$(dirname "${pc#"$prefix"/}")")
mv "$prefix" "$here/whole"

headers=$(cd "$here/whole/include/sf" && echo *.h)
[ "$headers" = "$(cd "$source/../../libsf/include/sf" && echo *.h)" ]
ok $? "the public headers are installed, and no other: $headers"

# A program must not find a library whose interface may be another: before 1.0, any other minor.
case $version in
0.*) interface=${version%.*} ;;
*) interface=${version%%.*} ;;
esac
if [ -e "$here/whole/$libdir/libsf.so" ]; then
    (cd "$here/whole/$libdir" && ls libsf.so.$interface libsf-io.so.$interface) >"$here/log" 2>&1
    ok $? "programs ask for libsf.so.$interface"
else
    skip "programs ask for libsf.so.$interface" "this build has no libsf.so"
fi

for kind in shared static; do
    if ! can $kind; then
        skip "pkg-config, $kind" "this build has no $kind library"
        skip "CMake, $kind" "this build has no $kind library"
        continue
    fi
    if command -v pkg-config >/dev/null; then
        by_pkg_config $kind
        ok $? "pkg-config, $kind"
    else
        skip "pkg-config, $kind" "pkg-config is not installed"
    fi
    if command -v cmake >/dev/null && command -v make >/dev/null; then
        by_cmake $kind
        ok $? "CMake, $kind"
    else
        skip "CMake, $kind" "cmake is not installed"
    fi
done
if command -v pkg-config >/dev/null; then
    asks_for_few_folders
    ok $? "libsf-io asks for the folder of its own headers, and for none of HDF5"
fi
if command -v pkg-config >/dev/null && can shared; then
    readme_example
    ok $? "the example in the README"
else
    skip "the example in the README" "no pkg-config, or no shared library"
fi
if command -v cmake >/dev/null && command -v make >/dev/null; then
    cmake_refuses 99.0 && cmake_refuses 0.0.9 && cmake_refuses "$version.1"
    ok $? "CMake refuses versions that are not installed"
fi
echo "1..$count"
exit $((failures > 0))
