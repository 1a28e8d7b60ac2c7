# SPDX-License-Identifier: MIT
# Why: figures in commits and documents come from sf-bench, so what it prints, what it keeps and what
# it says to a wrong name must be so. How large the figures are is nobody's pass or fail. Speaks TAP.
#
# usage: runs.py SF-BENCH

import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

BENCH = sys.argv[1]


def run(*words):
    return subprocess.run([BENCH, "--rounds", "1", *words], capture_output=True, text=True)


def main():
    results = []
    with tempfile.TemporaryDirectory() as name:
        kept = pathlib.Path(name) / "runs.json"
        done = run("--json", kept, "components")
        results.append((done.returncode == 0, "two jobs run"))
        rows = json.loads(kept.read_text())
    names = [row["job"] for row in rows]
    results.append((len(rows) == 2 and all(n.startswith("components") for n in names),
                    f"those whose names begin as asked, and no other: {names}"))
    good = all(math.isfinite(row[key]) and row[key] > 0
               for row in rows for key in ("median_ms", "limit_ms", "ratio"))
    results.append((good, "times, limits and ratios are above 0"))
    lines = done.stdout.splitlines()
    good = all(any(re.match(re.escape(n) + " ", line) for line in lines) for n in names)
    results.append((good, "a line of the table for each"))
    done = run("no such job")
    results.append((done.returncode == 2 and "no job begins with" in done.stderr,
                    "a name that is none's is refused"))
    for number, (good, text) in enumerate(results, 1):
        print(f"{'' if good else 'not '}ok {number} - {text}")
    print(f"1..{len(results)}")
    return not all(good for good, _ in results)


sys.exit(main())
