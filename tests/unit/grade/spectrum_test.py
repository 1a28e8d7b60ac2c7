# Why: a halftone is good where its slices are even: measured on written layers, by spectrum.py. Asked:
# what is left below 0.125 cycles per voxel is at most 0.08 of white noise at tones 0.1, 0.25 and 0.5,
# and 0.1 for the middle of three materials at thresholds 1/3 and 2/3; on voxels of 0.0423 x 0.0846 x
# 0.027 mm as much in mm along x as along y (half-power frequencies within 5 %); tones exact to a voxel
# in a period. Speaks TAP.
#
# usage: spectrum_test.py unit-grade-layers spectrum.py

import math
import re
import subprocess
import sys
import tempfile

LAYERS, SPECTRUM = sys.argv[1:3]
WIDE = ["0.0423", "0.0846", "0.027"]


def measure(kind, pitch, size, tones, material):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([LAYERS, folder, kind, *pitch, *map(str, size), *map(str, tones)], check=True)
        line = subprocess.run([sys.executable, SPECTRUM, folder, "--pitch", ",".join(pitch[:2]),
                               str(material)], check=True, capture_output=True, text=True).stdout
    print("# " + " ".join([kind, "x".join(pitch), "x".join(map(str, size)), *map(str, tones)]) + ": " +
          line.strip())
    found = re.search(r"voxels (\d+) .* low (\S+) half x (\S+) y (\S+)", line)
    return int(found.group(1)), *map(float, found.groups()[1:])


def main():
    results = []
    for tone in (0.1, 0.25, 0.5):
        voxels, low, _, _ = measure("slice", ["1"] * 3, [32] * 3, [tone], 1)
        results.append((low <= 0.08, f"tone {tone}: {low} below 0.125 cycles per voxel"))
        results.append((voxels == math.floor(tone * 32 ** 3 + 0.5), f"tone {tone}: {voxels} voxels"))
    voxels, low, _, _ = measure("slice", ["1"] * 3, [32] * 3, [1 / 3, 1 / 3], 2)
    results.append((low <= 0.1, f"middle of three: {low} below 0.125 cycles per voxel"))
    results.append((voxels == 21845 - 10923, f"middle of three: {voxels} voxels"))
    for size in ([32] * 3, [64, 64, 32]):
        for tone in (0.1, 0.25, 0.5):
            _, low, x, y = measure("slice", WIDE, size, [tone], 1)
            results.append((abs(x / y - 1) <= 0.05 and low <= 0.08,
                            f"in mm, {size[0]} wide, tone {tone}: along x {x}, along y {y}"))
    # A plane through noise that is blue in space is not: the measure has to see that.
    _, low, _, _ = measure("isotropic", ["1"] * 3, [32] * 3, [0.25], 1)
    results.append((low > 0.15, f"slices of the isotropic mask: {low}"))
    for number, (good, text) in enumerate(results, 1):
        print(f"{'' if good else 'not '}ok {number} - {text}")
    print(f"1..{len(results)}")
    return not all(good for good, _ in results)


sys.exit(main())
