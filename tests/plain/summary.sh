# Why: whoever runs the tests reads two or three lines at the end. A test that could not run must
# stand there with its reason, be it a case, a whole program or a whole script, and not as passed:
# what is skipped unseen is not tested at all. usage: summary.sh SOURCE
set -u
cd "$1" || exit 99
here=$(mktemp -d) || exit 99
trap 'rm -rf "$here"' EXIT
count=0 failures=0

# says WORDS...: a line of the last summary.
says() {
    count=$((count + 1))
    if grep -qxF -- "$*" "$here/summary"; then
        echo "ok $count - $*"
    else
        failures=$((failures + 1))
        echo "not ok $count - $*"
        sed 's/^/#   /' "$here/summary"
    fi
}

cat >"$here/log" <<'LOG'
{"name": "a", "stdout": "ok 1 - x\nok 2 - y # SKIP no \"z\"\n1..2\n", "result": "OK"}
{"name": "b", "stdout": "1..0 # SKIP nothing here\n", "result": "SKIP"}
{"name": "c", "stdout": "1..0 # SKIP nothing here\n", "result": "OK"}
{"name": "d", "result": "SKIP"}
{"name": "e", "stdout": "no TAP\n", "result": "OK"}
{"name": "f", "stdout": "ok 1 - x\nnot ok 2 - y\n1..2\n", "result": "FAIL"}
LOG
awk -f tests/summary.awk "$here/log" >"$here/summary"
says "4 skipped"
says '  1: no "z"'
says "  2: nothing here"
says "  1: d cannot run here"
says "3 passed, 1 failed"

# The same from the plain build's own log, with programs and a script of ours.
mkdir "$here/plain"
printf '#!/bin/sh\necho "1..0 # SKIP no program"\n' >"$here/plain/test-skipped"
printf '#!/bin/sh\necho "ok 1 - it runs"\necho 1..1\n' >"$here/plain/test-runs"
printf 'echo "1..0 # SKIP no script"\n' >"$here/script.sh"
chmod +x "$here"/plain/test-*
sh tests/plain/run.sh "$here/plain" "$here/script.sh" >"$here/summary" 2>&1
says "  1: no program"
says "  1: no script"
says "  1: the verifier is built by meson, where libspng and jansson are"
says "1 passed, 0 failed"
grep '"result"' "$here/plain/testlog.json" | grep -o '"result": "[A-Z]*"' | sort | uniq -c |
    sed 's/^ *//' >"$here/summary"
says '3 "result": "SKIP"'
echo "1..$count"
exit $((failures > 0))
