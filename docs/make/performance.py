# The page of figures, from what sf-bench wrote. The figures are taken on a machine that somebody chose, and
# kept with its name in docs/performance.json, so that the page does not change with whoever builds it:
#
#     build/tests/bench/sf-bench --json bench.json JOB
#     python3 docs/make/performance.py --take docs/performance.json MACHINE bench.json...

import datetime
import json
import os
import sys

import words

HEAD = """
Each job is timed beside what the machine's memory alone would take to read and write the same bytes, in the
same rounds: *limit*. *Ratio* is how far from that it is, which says more of the code than milliseconds of some
machine do; where no limit makes sense there is none. Of brushes the worst of a hundred strokes is given. All of it
is one core.

``./dev bench`` prints the table for your machine. Figures of whole operations on real parts are on the pages of
these: :doc:`/operators`, :doc:`/repair`, :doc:`/balance`, :doc:`/grade`, :doc:`/sculpt`.
"""


def number(value):
    return "" if not value else f"{value:.3g}" if value < 100 else f"{value:.0f}"


def page(path):
    with open(path, encoding="utf-8") as file:
        kept = json.load(file)
    lines = words.title("Performance", "=") + HEAD.strip().split("\n") + ["", words.inline(
        f"Taken on {kept['taken']}: {kept['machine']}. Median of seven rounds or more."), ""]
    group = None
    # What is below nothing is what a stroke took beyond its path's share, and means something only beside that.
    for f in [f for f in kept["figures"] if f["median_ms"] > 0]:
        first = f["job"].split(" ")[0]
        if first != group:
            group = first
            lines += ["", ".. list-table::", "   :header-rows: 1", "   :widths: 35 20 13 12 10 10", "",
                      "   * - job", "     - size", "     - median, ms", "     - worst, ms", "     - limit, ms",
                      "     - ratio"]
        ratio = f["ratio"] if f["limit_ms"] else 0
        lines += [f"   * - {words.plain(f['job'])}", f"     - {words.plain(f['size'])}", f"     - {number(f['median_ms'])}",
                  f"     - {number(f.get('p99_ms'))}", f"     - {number(f['limit_ms'])}", f"     - {number(ratio)}"]
    return "\n".join(lines) + "\n"


def take(path, machine, results):
    figures = []
    for result in results:
        with open(result, encoding="utf-8") as file:
            figures += json.load(file)
    whole = {"taken": datetime.date.today().isoformat(), "machine": machine,
             "figures": sorted(figures, key=lambda f: f["job"].split(" ")[0])}
    with open(path + ".new", "w", encoding="utf-8") as file:
        json.dump(whole, file, indent=1)
        file.write("\n")
    os.replace(path + ".new", path)


if __name__ == "__main__" and sys.argv[1:2] == ["--take"]:
    take(sys.argv[2], sys.argv[3], sys.argv[4:])
