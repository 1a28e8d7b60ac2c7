"""Is my part printable? A table on one leg: what hangs, what a repair adds, what a trim leaves.

usage: printable.py [PICTURE.png]
"""

import sys

import libsf
import libsf.plot
import matplotlib.pyplot as plt

table = libsf.Grid(libsf.Lattice(60, 40, 44, 0.5, 0.5))
array = table.array()
array[:30, 16:24, 26:34] = True
array[30:36, 4:36, 6:54] = True
table.set_array(array)

found = libsf.check(table, "octagon")
print(f"support-free: {found.support_free}; {found.report.unsupported_voxels} voxels hang in "
      f"{len(found.findings)} place{'' if len(found.findings) == 1 else 's'}")
repaired, report = libsf.repair(table, "octagon")
print(f"a repair adds {report.added_voxels} voxels and removes {report.removed_voxels}")
trimmed, report = libsf.trim(table, "octagon")
print(f"a trim removes {report.removed_voxels}")
assert libsf.check(repaired, "octagon") and libsf.check(trimmed, "octagon")

figure, axes = plt.subplots(1, 3, figsize=(12, 4))
libsf.plot.findings(table, found, axes=axes[0])
libsf.plot.side(repaired, axes=axes[1]).set_title("repaired")
libsf.plot.side(trimmed, axes=axes[2]).set_title("trimmed")
figure.tight_layout()
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "printable.png", dpi=80)
