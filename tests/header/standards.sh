# Why: whoever includes a header has a standard of their own. Each public header is read alone, without
# a warning, by C11 and by what C is becoming, and, where there is a C++ compiler, by C++98 and C++20.
# usage: standards.sh SOURCE COMPILER...; speaks TAP
set -u
source=$1
shift
here=$(mktemp -d) || exit 99
trap 'rm -rf "$here"' EXIT
count=0 bad=0
mkdir "$here/headers"
for header in "$source"/libsf/include/sf/*.h; do
    name=$(basename "$header" .h)
    printf '#include <sf/%s.h>\n' "$name" | tee "$here/headers/$name.c" >"$here/headers/$name.cpp"
done

# try STANDARD ENDING COMPILER...
try() {
    standard=$1 ending=$2
    shift 2
    count=$((count + 1))
    if ! echo 'int i;' >"$here/probe.$ending" ||
        ! "$@" "-std=$standard" -fsyntax-only "$here/probe.$ending" 2>/dev/null; then
        echo "ok $count - $standard # SKIP $1 does not know it"
    elif "$@" "-std=$standard" -Wall -Wextra -pedantic -Werror -fsyntax-only \
        "-I$source/libsf/include" "$here"/headers/*."$ending" >"$here/log" 2>&1; then
        echo "ok $count - every header is $standard"
    else
        bad=1
        head -n 20 "$here/log" | sed 's/^/# /'
        echo "not ok $count - every header is $standard"
    fi
}

try c11 c "$@"
try c2x c "$@"
try c++98 cpp "${CXX:-c++}"
try c++20 cpp "${CXX:-c++}"
echo "1..$count"
exit $bad
