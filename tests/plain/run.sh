#!/bin/sh
# Runs the test programs that build.sh made, and the tests of the command line, and sums them up as
# meson's would be. usage: run.sh FOLDER [SCRIPT...]
set -eu
out=$(cd "$1" && pwd)
shift
log=$out/testlog.json
: >"$log"

# record NAME COMMAND...: run a test and add a line like those of meson's log.
record() {
    name=$1 result=OK
    shift
    timeout 300 "$@" >"$out/stdout" 2>&1 || { result=FAIL; cat "$out/stdout" >&2; }
    ! grep -q '^1\.\.0.*# SKIP' "$out/stdout" || [ $result = FAIL ] || result=SKIP
    text=$(sed 's/\\/\\\\/g; s/"/\\"/g' "$out/stdout" | awk '{ printf "%s\\n", $0 }')
    printf '{"name": "%s", "stdout": "%s", "result": "%s"}\n' "$name" "$text" "$result" >>"$log"
}

for program in "$out"/test-*; do
    record "${program##*/}" "$program"
done
export SF="$out/sf" JSON_GET=
[ $# -gt 0 ] || set -- tests/cli/*.sh
for script; do
    case $script in */tap.sh) continue ;; esac
    record "$script" sh "$script" "$PWD/tests/cli/tap.sh"
done
record verify echo '1..0 # SKIP the verifier is built by meson, where libspng and jansson are'
awk -f tests/summary.awk "$log"
