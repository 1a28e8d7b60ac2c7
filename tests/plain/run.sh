#!/bin/sh
# Runs the test programs that build.sh made and sums them up as meson's would be. usage: run.sh FOLDER
set -eu
out=$1
log=$out/testlog.json
: >"$log"
for program in "$out"/test-*; do
    result=OK
    timeout 300 "$program" >"$out/stdout" 2>&1 || { result=FAIL; cat "$out/stdout" >&2; }
    text=$(sed 's/\\/\\\\/g; s/"/\\"/g' "$out/stdout" | awk '{ printf "%s\\n", $0 }')
    printf '{"name": "%s", "stdout": "%s", "result": "%s"}\n' "${program##*/}" "$text" "$result" >>"$log"
done
awk -f tests/summary.awk "$log"
