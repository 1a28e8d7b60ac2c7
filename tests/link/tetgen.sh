# Why: the adapter to TetGen is in no build that did not ask for it, so that nobody gets its licence
# unawares; but it must not rot. Where TetGen is installed, the adapter, its test and its program are built
# here in a folder of their own, against the libraries of this build, and run.
# usage: tetgen.sh SOURCE BUILD TAP SF CC CXX; CC and CXX are words
source=$1 build=$2 tap=$3 sf=$4 cc=$5 cxx=$6
here=$(mktemp -d) || exit 99
trap 'rm -rf "$here"' EXIT
flags="-O1 -I$source/libsf/include -I$source/libsf"
libraries="-L$build/libsf -L$build/libsf/io -lsf-io -lsf -ltet -lm -Wl,-rpath,$build/libsf -Wl,-rpath,$build/libsf/io"
cd "$here" || exit 99

printf '#define TETLIBRARY\n#include <tetgen.h>\nint main() { tetgenio in; return in.numberofpoints; }\n' >there.cpp
# shellcheck disable=SC2086
if ! $cxx there.cpp -ltet -o there 2>/dev/null; then
    echo '1..0 # SKIP TetGen is not installed'
    exit 0
fi
# shellcheck disable=SC2086
{
    $cc $flags -c "$source/libsf/base/fault.c" -o fault.o &&
        $cxx $flags -std=c++14 -DSF_BUILDING -c "$source/libsf/link/tetgen.cpp" -o adapter.o &&
        $cc $flags -std=c99 -c "$source/tests/link/tetgen.c" -o test.o &&
        $cc $flags -std=c99 -D_XOPEN_SOURCE=700 -DSF_FILL_BY_TETGEN -c "$source/demo/fill/fill.c" -o fill.o &&
        $cxx test.o adapter.o fault.o $libraries -o test &&
        $cxx fill.o adapter.o fault.o $libraries -o sf-tetgen
} >log 2>&1 || {
    sed 's/^/# /' log
    printf 'not ok 1 - the adapter is built\n1..1\n'
    exit 1
}
failed=0
./test >test.tap || failed=1
SF=$here/sf-tetgen GRADE=$sf sh "$source/tests/link/fill.sh" "$tap" >fill.tap || failed=1
# Both as one list.
cat test.tap fill.tap | awk '/^1\.\./ { next } /^(not )?ok / { n++; sub(/ok [0-9]+/, "ok " n) } { print } END { print "1.." n }'
exit $failed
