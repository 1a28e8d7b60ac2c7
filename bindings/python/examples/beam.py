"""Grade a beam and halftone it: stiff below, soft above, in two materials.

usage: beam.py [PICTURE.png]
"""

import sys

import libsf
import libsf.plot
import matplotlib.pyplot as plt
import numpy as np

cage = libsf.Cage.block((6, 2, 2), (-40, -12, 0), (40, 12, 24))
points = np.array(cage.points)
points[:, 2] += 9 * (points[:, 0] / 40) ** 2
cage.add_property("stiffness", np.clip(1.1 - cage.points[:, 2] / 24, 0, 1))
cage.move(points)

lattice = libsf.Lattice(170, 54, 72, 0.5, 0.5, (-42.5, -13.5, -1))
sampler = cage.limit().slices(lattice, ["stiffness"])
solid = np.stack([s.solid for s in sampler])
tones = np.stack([s.values["stiffness"] for s in sampler]).astype(np.float32)
layers = np.stack([libsf.halftone(t, solid=s, layer=k) for k, (t, s) in enumerate(zip(tones, solid))])
share = (layers == 2).sum() / solid.sum()
print(f"{solid.sum()} voxels, {100 * share:.2f} % of them stiff; {100 * tones[solid].mean():.2f} % were asked for")
assert abs(share - tones[solid].mean()) < 0.01

figure, axes = plt.subplots(2, 1, figsize=(9, 6))
shown = np.ma.masked_where(~solid[:, 27], tones[:, 27])
axes[0].imshow(shown, origin="lower", extent=(-42.5, 42.5, -1, 35), vmin=0, vmax=1)
axes[0].set_title("stiffness, cut through the middle")
libsf.plot.materials(layers[:, 27], pitch_mm=(0.5, 0.5), axes=axes[1]).set_title("as it is printed")
figure.tight_layout()
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "beam.png", dpi=80)
