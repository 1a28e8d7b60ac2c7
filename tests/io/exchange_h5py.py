# SPDX-License-Identifier: MIT
# Why: an exchange file is for others. It is read here by h5py, as docs/exchange.md says, without a
# line of libsf, and must hold what the writing program put into it.
import os
import subprocess
import sys
import tempfile

try:
    import h5py
    import numpy
except ImportError:
    print("1..0 # SKIP h5py is not installed")
    sys.exit(0)

count = 0


def ok(good, words):
    global count
    count += 1
    print(f"{'ok' if good else 'not ok'} {count} - {words}")


with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "pair.h5")
    subprocess.run([sys.argv[1], path], check=True)
    if not os.path.exists(path):
        print("1..0 # SKIP this build has no libhdf5")
        sys.exit(0)
    with h5py.File(path, "r") as file:
        ok(file.attrs["format"].decode() == "libsf-exchange" and file.attrs["version"] == 1, "format and version")
        ok(file.attrs["length_unit"].decode() == "mm", "lengths are mm")
        positions, tets = file["positions"][:], file["tets"][:]
        ok(positions.dtype == numpy.float64 and positions.shape == (5, 3), "positions are f64[n,3]")
        ok(positions[4].tolist() == [1, 1, 1.0 / 3], "to the bit")
        ok(tets.dtype == numpy.uint32 and tets.tolist() == [[0, 1, 2, 3], [1, 4, 2, 3]], "tets are u32[m,4]")
        ok(sorted(file["properties"]) == ["2b3d5e79-5dc1-4ea8-8d04-c48865cea0c1",
                                          "408b9c0d-608a-45f0-9af1-ffeeda90d9ea"], "properties by UUID")
        density = file["properties/408b9c0d-608a-45f0-9af1-ffeeda90d9ea"]
        ok(density.attrs["name"].decode() == "density" and density.attrs["unit"].decode() == "kg m^-3", "name and unit")
        ok(density.attrs["si_exponents"].tolist() == [-3, 1, 0, 0, 0, 0, 0], "exponents of m kg s A K mol cd")
        ok(density.attrs["low"] == 0 and numpy.isinf(density.attrs["high"]), "bounds")
        corners = density["values"][:][density["index"][:]]
        ok(corners.tolist() == [[1000] * 4, [1200.5] * 4], "a value for each corner; it jumps")
        young = file["properties/2b3d5e79-5dc1-4ea8-8d04-c48865cea0c1"]
        ok(young.attrs["unit"].decode() == "kg m^-1 s^-2", "pascal in base units")
        ok((young["index"][:] == tets).all() and len(young["values"]) == 5, "and where it does not, points have values")
        ok(file["positions"].compression == "gzip" and file["positions"].shuffle, "deflate and shuffle")
print(f"1..{count}")
