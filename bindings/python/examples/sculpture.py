"""Sculpt by program: a spiral of balls around a post, support-free after every stroke.

usage: sculpture.py [PICTURE.png]
"""

import sys

import libsf
import libsf.plot
import matplotlib.pyplot as plt
import numpy as np

model = libsf.Sculpt(libsf.Lattice(96, 96, 112, 0.5, 0.5))
post = libsf.Tip.shaped("cylinder", (9, 9, 50))
model.stroke("add-trim", post, [(48, 48, 50)], material=1)
ball = libsf.Tip.shaped("sphere", 8)
ball_voxels = 2109  # whose centres lie within 8 voxels of one
added = 0
for turn in np.linspace(0, 6 * np.pi, 40):
    at = (round(48 + 22 * np.cos(turn)), round(48 + 22 * np.sin(turn)), round(8 + 4.6 * turn))
    change = model.stroke("add-grow", ball, [at], material=2)
    added += change.added_voxels
    assert libsf.check(model.printable(), bed_layer=0)
model.stroke("smooth-trim", libsf.Tip.shaped("sphere", 14), [(48, 48, 100)], passes=3)
shape = model.printable()
print(f"{added} voxels were added by balls of {ball_voxels}, with what carries them; "
      f"{shape.count()} are there, and {model.history.undo_count} steps can be undone")

figure, axes = plt.subplots(1, 2, figsize=(9, 5))
libsf.plot.side(shape, axes=axes[0]).set_title("from the front")
libsf.plot.materials(model.materials[40], pitch_mm=(0.5, 0.5), axes=axes[1]).set_title("layer 40, its materials")
figure.tight_layout()
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "sculpture.png", dpi=80)
