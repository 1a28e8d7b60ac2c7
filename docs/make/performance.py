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
machine do; where it would be over a hundred, the job is not about memory, and none is given. Of brushes the 99th of a
hundred strokes stands beside the median. All of it is one core.

``./dev bench`` prints the table for your machine. Figures of whole operations on real parts are on the pages of
these: :doc:`/operators`, :doc:`/repair`, :doc:`/balance`, :doc:`/grade`, :doc:`/sculpt`.
"""


# What the jobs of sf-bench are, by the first word of their names, in the order of the page.
JOBS = {"trim": "Trim of a whole grid, and after an edit", "preserve": "A brush taken away, what carries kept",
        "hollow": "Cavities", "repair": "Repair", "grow": "Paths to support", "path": "The map of all paths",
        "sculpt": "Strokes", "disk": "Dilation of a layer by a disk", "components": "Connected components of a layer",
        "moments": "Mass, centre and inertia of a grid", "voxelize": "Triangles to voxels",
        "surface": "Voxels to triangles", "carve": "Carving for balance", "weights": "Weights of handles",
        "blend": "Bending a mesh", "grade": "Sampling the limit solid", "refine": "Subdivision of a cage",
        "halftone": "Halftones", "mask": "Making a mask"}


def number(value):
    return "" if not value else f"{value:.3g}" if value < 100 else f"{value:.0f}"


def page(path):
    with open(path, encoding="utf-8") as file:
        kept = json.load(file)
    lines = words.title("Performance", "=") + HEAD.strip().split("\n") + ["", words.inline(
        f"Taken on {kept['taken']}: {kept['machine']}. Median of seven rounds or more."), ""]
    others = {f["job"].split(" ")[0] for f in kept["figures"]} - JOBS.keys()
    for first, heading in {**JOBS, **{name: name for name in sorted(others)}}.items():
        # What is below nothing is what a stroke took beyond its path's share, and means something only beside that.
        found = [f for f in kept["figures"] if f["job"].split(" ")[0] == first and f["median_ms"] > 0]
        if not found:
            continue
        lines += words.title(heading, "-") + [
            ".. list-table::", "   :header-rows: 1", "   :widths: 35 20 13 12 10 10", "",
            "   * - job", "     - size", "     - median, ms", "     - 99th, ms", "     - limit, ms", "     - ratio"]
        for f in found:
            near = 0 < f["ratio"] < 100
            lines += [f"   * - {words.plain(f['job'])}", f"     - {words.plain(f['size'])}",
                      f"     - {number(f['median_ms'])}", f"     - {number(f.get('p99_ms'))}",
                      f"     - {number(f['limit_ms'] if near else 0)}", f"     - {number(f['ratio'] if near else 0)}"]
        lines.append("")
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
