#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Why: a promise on halftones is one on the pictures that a printer gets; so they are measured there:
# a box of one tone is written as PNGs by sf grade, and tests/unit/grade/spectrum.py reads a period of
# them. Asked: in a period, round(t N) voxels of N; what is left below 0.125 cycles per voxel is at most
# 0.08 of white noise, and 0.1 for the middle of three materials; on voxels of 0.0423 x 0.0846 x 0.027
# mm the half-power frequencies along x and y, in cycles per mm, agree within 5 %. Speaks TAP.
#
# usage: tones.py SPECTRUM    SF and SF_WRAPPER as for the scripts beside

import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

SPECTRUM = sys.argv[1]
SF = os.environ.get("SF_WRAPPER", "").split() + [os.environ["SF"]]
CUBE = ["1", "1", "1"]
WIDE = ["0.0423", "0.0846", "0.027"]
PERIOD = (64, 64, 32)
PURE = [([1, 0], 0), ([0, 1], 1)]
THIRDS = [([1, 0, 0], 0), ([1 / 3, 1 / 3, 1 / 3], 0.5), ([0, 0, 1], 1)]


# A box of tetrahedra, some voxels larger than what is measured.
def box(path, pitch, tone):
    sides = [float(p) * (n + 4) for p, n in zip(pitch, PERIOD)]
    corners = [[sides[axis] * (i >> axis & 1) for axis in range(3)] for i in range(8)]
    tets = ("0 1 3 7", "0 3 2 7", "0 2 6 7", "0 6 4 7", "0 4 5 7", "0 5 1 7")
    path.write_text("# vtk DataFile Version 3.0\nbox\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                    "POINTS 8 double\n" + "".join("%r %r %r\n" % tuple(c) for c in corners) +
                    "CELLS 6 30\n" + "".join(f"4 {t}\n" for t in tets) + "CELL_TYPES 6\n" + "10\n" * 6 +
                    "POINT_DATA 8\nSCALARS tone double 1\nLOOKUP_TABLE default\n" + f"{tone!r}\n" * 8)


def materials(path, mixtures):
    path.write_text(json.dumps({
        "format": "libsf-materials", "version": 1,
        "materials": [{"name": f"material {n}"} for n in range(len(mixtures[0][0]))],
        "properties": ["tone"],
        "mixtures": [{"fractions": f, "values": [v]} for f, v in mixtures]}))


# What spectrum.py says of a material of a box, from inside of it.
def measure(pitch, mixtures, tone, material):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        box(folder / "box.vtk", pitch, tone)
        materials(folder / "materials.json", mixtures)
        subprocess.run(SF + ["grade", folder / "box.vtk", "--materials", folder / "materials.json",
                             "--pitch", ",".join(pitch), "-o", folder / "layers", "--quiet"],
                       check=True, stdout=subprocess.DEVNULL)
        line = subprocess.run([sys.executable, SPECTRUM, folder / "layers", "--pitch",
                               ",".join(pitch[:2]), "--from", "3,3,2", "--size",
                               ",".join(map(str, PERIOD)), "0", str(material)],
                              check=True, capture_output=True, text=True).stdout
    print("# " + " x ".join(pitch) + f", tone {tone:g}: " + line.splitlines()[-1])
    empty = int(re.search(r"material 0 voxels (\d+)", line).group(1))
    found = re.search(rf"material {material} voxels (\d+) .* low (\S+) half x (\S+) y (\S+)", line)
    return empty, int(found.group(1)), *map(float, found.groups()[1:])


def main():
    results, period = [], math.prod(PERIOD)
    for pitch in (CUBE, WIDE):
        for tone in (0.1, 0.25, 0.5):
            empty, voxels, low, x, y = measure(pitch, PURE, tone, 2)
            results.append((empty == 0, f"all that is measured is inside: {empty} voxels are not"))
            results.append((low <= 0.08, f"tone {tone}: {low} below 0.125 cycles per voxel"))
            results.append((voxels == math.floor(tone * period + 0.5),
                            f"tone {tone}: {voxels} voxels"))
            if pitch == WIDE:
                results.append((abs(x / y - 1) <= 0.05, f"tone {tone}: {x} along x, {y} along y"))
    _, voxels, low, _, _ = measure(CUBE, THIRDS, 0.5, 2)
    results.append((low <= 0.1, f"the middle of three: {low} below 0.125 cycles per voxel"))
    middle = math.floor(2 / 3 * period + 0.5) - math.floor(1 / 3 * period + 0.5)
    results.append((voxels == middle, f"the middle of three: {voxels} voxels"))
    for number, (good, text) in enumerate(results, 1):
        print(f"{'' if good else 'not '}ok {number} - {text}")
    print(f"1..{len(results)}")
    return not all(good for good, _ in results)


sys.exit(main())
