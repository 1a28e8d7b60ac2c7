"""Hollow and balance a statue: one that leans is carved and bent until it stands.

usage: statue.py [PICTURE.png]
"""

import sys

import libsf
import libsf.plot
import matplotlib.pyplot as plt
import numpy as np

z, y, x = np.indices((60, 40, 72)) + 0.5
body = (z > 2) & (z < 7) & ((x - 18) ** 2 + (y - 20) ** 2 < 100)
for cx, cz, r in ((18, 12, 8), (23, 23, 10), (33, 35, 9), (45, 44, 8), (56, 48, 6)):
    body |= (x - cx) ** 2 + (y - 20) ** 2 + (z - cz) ** 2 < r * r
statue = libsf.surface(libsf.Grid.from_array(body), smooth_passes=20)

before = libsf.Stance(statue).judge(libsf.center_of_mass(statue))
print(f"as it is it {'stands' if before.stands else 'falls'}: {np.degrees(before.margin_rad):.1f} degrees")
standing = libsf.stand(statue, resolution=56, wall_mm=2)
report = standing.report
print(f"now it stands until the ground tilts by {np.degrees(report.margin_rad):.1f} degrees; "
      f"{report.carved_mm3:.0f} mm3 carved, moved by at most {report.displacement_mm:.1f} mm")
assert standing.succeeded

figure, axes = plt.subplots(1, 3, figsize=(13, 4.2))
libsf.plot.balance(statue, libsf.Stance(statue), axes=axes[0])
libsf.plot.balance(standing.outer, libsf.Stance(standing.outer, contact_mm=0.5), report.com_mm, axes=axes[1])
libsf.plot.side(standing.grid, axes=axes[2]).set_title("what is left: paler where it is hollow")
figure.tight_layout()
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "statue.png", dpi=80)
