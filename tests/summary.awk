# Sums up meson's testlog.json: which cases were skipped and why, then "N passed, N failed".
# A case is a line of TAP; a program that speaks no TAP, or died, is one case.
{
    output = ""
    if (match($0, /"stdout": "([^"\\]|\\.)*"/))
        output = substr($0, RSTART + 11, RLENGTH - 12)
    result = ""
    if (match($0, /"result": "[A-Z]+"/))
        result = substr($0, RSTART + 11, RLENGTH - 12)
    name = ""
    if (match($0, /"name": "([^"\\]|\\.)*"/))
        name = substr($0, RSTART + 9, RLENGTH - 10)
    cases = failures = 0
    count = split(output, lines, /\\n/)
    for (i = 1; i <= count; i++) {
        line = lines[i]
        if (line ~ /^1\.\.0.*# SKIP/ || line ~ /^ok [0-9]+.*# SKIP/) { # a whole program, or a case
            cases++
            reason = line
            sub(/.*# SKIP */, "", reason)
            gsub(/\\"/, "\"", reason)
            skipped[reason]++
            skips++
        } else if (line ~ /^not ok /) {
            cases++
            failures++
        } else if (line ~ /^ok [0-9]+/) {
            cases++
            passed++
        }
    }
    bad = result != "OK" && result != "SKIP" && result != "EXPECTEDFAIL"
    if (result == "SKIP" && cases == 0) {
        skipped[name " cannot run here"]++
        skips++
    } else if (cases == 0 && !bad) {
        passed++
    } else if (bad && failures == 0) {
        failures = 1
    }
    failed += failures
}
END {
    printf "%d skipped\n", skips
    for (reason in skipped)
        printf "  %d: %s\n", skipped[reason], reason
    printf "%d passed, %d failed\n", passed, failed
    exit (failed > 0 || passed == 0)
}
