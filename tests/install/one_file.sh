# Why: sf.c and sf.h are made by a script that knows less of C than a compiler does. Here compilers
# say whether it was right: with warnings as errors, as C99 and from C++, with the optional libraries
# and without, and the golden vectors hold for it as they do for the library.
# usage: one_file.sh FOLDER SOURCE GOLDEN NM COMPILER...; FOLDER: of sf.c and sf.h; GOLDEN: box3.json,
# with tetrahedra.json beside it; NM may be empty
set -u
folder=$1 source=$2 golden=$3 nm=$4
shift 4
compiler=$*
here=$(mktemp -d) || exit 99
trap 'rm -rf "$here"' EXIT
# In one file the inline functions of headers are its own, and some are called by optional parts alone.
strict='-Wall -Wextra -Werror -Wno-unused-function -ffp-contract=off'
count=0 failures=0

ok() {
    count=$((count + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $count - $2"
    else
        failures=$((failures + 1))
        echo "not ok $count - $2"
        head -20 "$here/log" | sed 's/^/#   /'
    fi
}

skip() {
    count=$((count + 1))
    echo "ok $count - $1 # SKIP $2"
}

# The flags of the optional libraries that are here, by the definitions that the sources ask for.
optional_flags() {
    for pair in spng:SPNG jansson:JANSSON hdf5-serial:HDF5 zlib:ZLIB expat,zlib:THREEMF; do
        names=$(printf '%s' "${pair%:*}" | tr , ' ')
        # shellcheck disable=SC2086
        pkg-config --exists $names 2>/dev/null || continue
        # shellcheck disable=SC2086
        printf '%s ' "-DSF_HAVE_${pair#*:}" "$(pkg-config --cflags $names)"
    done
    if pkg-config --exists expat zlib 2>/dev/null; then
        printf '%s ' -DSF_HAVE_THREEMF "$(pkg-config --cflags expat zlib)"
    fi
}

# Two warnings are guesses of the optimizer, which sees more in one file, and here guesses wrong.
build() {
    $compiler -std=c99 $strict -Wno-maybe-uninitialized -Wno-stringop-overread -O1 -c "$folder/sf.c" -o "$here/sf.o"
}

as_c() {
    $compiler -std=c99 -pedantic $strict -DSF_ONE_FILE -I"$folder" "$source/tests/install/consumer.c" \
        "$here/sf.o" -lm -o "$here/as_c" && "$here/as_c"
}

as_cpp() {
    c++ -std=c++11 -x c++ -pedantic $strict -DSF_ONE_FILE -I"$folder" -c \
        "$source/tests/install/consumer.c" -o "$here/cpp.o" &&
        c++ "$here/cpp.o" "$here/sf.o" -lm -o "$here/as_cpp" && "$here/as_cpp"
}

# Nothing but our own names leaves the file, and of the public ones none is missing.
names() {
    $nm -g "$here/sf.o" | sed -n 's/^[0-9a-f]* [A-TV-Z] //p' | sed 's/^_\(sf\)/\1/' | sort >"$here/names"
    grep -v '^sfi\{0,1\}_' "$here/names" && return 1
    grep -ho '^SF_API [^(]*(' "$source"/libsf/include/sf/*.h | sed 's/($//; s/.*[ *]//' | sort >"$here/public"
    [ "$(wc -l <"$here/public")" -gt 300 ] && comm -13 "$here/names" "$here/public" | tee "$here/missing"
    [ ! -s "$here/missing" ]
}

vectors() {
    # shellcheck disable=SC2046
    $compiler -std=c99 -DSF_STATIC -I"$source/libsf/include" -I"$source/tests" \
        "$source/tests/golden/golden.c" "$here/sf.o" $(pkg-config --cflags --libs jansson) -lm \
        -o "$here/golden" && "$here/golden" "$golden" "$(dirname "$golden")/tetrahedra.json"
}

build >"$here/log" 2>&1
ok $? "sf.c compiles without a warning"
as_c >"$here/log" 2>&1
ok $? "a program in C99 with sf.h and sf.o"
if command -v c++ >/dev/null; then
    as_cpp >"$here/log" 2>&1
    ok $? "a program in C++ with sf.h and sf.o"
else
    skip "a program in C++ with sf.h and sf.o" "there is no c++"
fi
clang=$(command -v clang || command -v clang-14 || :)
if [ -n "$clang" ]; then
    "$clang" -std=c99 $strict -fsyntax-only "$folder/sf.c" >"$here/log" 2>&1
    ok $? "clang takes sf.c without a warning"
else
    skip "clang takes sf.c without a warning" "clang is not installed"
fi
flags=$(optional_flags)
if [ -n "$flags" ]; then
    # shellcheck disable=SC2086
    $compiler -std=c99 $strict -fsyntax-only $flags "$folder/sf.c" >"$here/log" 2>&1
    ok $? "with the optional libraries: $(printf '%s' "$flags" | grep -o 'HAVE_[A-Z0-9]*' | tr '\n' ' ')"
else
    skip "with the optional libraries" "there are none"
fi
if [ -n "$nm" ]; then
    names >"$here/log" 2>&1
    ok $? "all public functions are in it, and no names but ours"
else
    skip "all public functions are in it, and no names but ours" "nm is not installed"
fi
if pkg-config --exists jansson 2>/dev/null; then
    vectors >"$here/log" 2>&1
    ok $? "the golden vectors"
else
    skip "the golden vectors" "jansson is not installed"
fi
echo "1..$count"
exit $((failures > 0))
