"""Sculpting by program: after every stroke the model is support-free, and undo is exact."""

import os
import tempfile
import unittest

import numpy as np

import libsf

KINDS = ["add-trim", "remove-preserve", "add-grow", "remove-trim", "smooth-trim", "paint"]
SESSION = """libsf-session 1
space 40 40 40 0.25 0.25 0.25 -5 -5 0
rule box3 0.7853981633974483
bed 0
ghosts 0
history 1048576
tip sphere 6 6 6
stroke add-trim 0 1 1 0 1
 20 20 0
undo
redo
end
"""


class Strokes(unittest.TestCase):
    def test_a_mesh_is_a_tip(self):
        cube = libsf.surface(libsf.Grid.from_array(np.ones((4, 4, 4), bool)))
        for layer_mm in (1, 1.0, (1.0,) * 8):
            mask, anchor = libsf.Tip.mesh(cube, libsf.Lattice(8, 8, 8, 1, layer_mm)).mask()
            self.assertEqual((mask.count(), mask[anchor[::-1]]), (64, True))

    def test_a_ball_on_the_bed(self):
        model = libsf.Sculpt(libsf.Lattice(64, 64, 64))
        change = model.stroke("add-trim", libsf.Tip.shaped("sphere", 10), [(32, 32, 0)], material=3)
        z, y, x = np.indices((64, 64, 64))
        ball = (x - 32) ** 2 + (y - 32) ** 2 + z**2 <= 100
        kept = libsf.trim(libsf.Grid.from_array(ball), bed_layer=0).grid
        self.assertEqual(model.printable(), kept)
        self.assertEqual(change.added_voxels, kept.count())
        self.assertTrue((model.materials[kept.array()] == 3).all())
        self.assertFalse(model.materials.flags.writeable)

    def test_random_strokes(self):
        rng = np.random.default_rng(5)
        model = libsf.Sculpt(libsf.Lattice(40, 40, 40), "octagon")
        states = [model.printable()]
        for _ in range(60):
            tip = libsf.Tip.shaped(rng.choice(["sphere", "box", "cylinder", "cone"]), rng.uniform(2, 9, 3).tolist())
            dabs = rng.integers(0, 40, (rng.integers(1, 4), 3))
            model.stroke(rng.choice(KINDS), tip, dabs, material=int(rng.integers(1, 9)))
            now = model.printable()
            self.assertTrue(libsf.check(now, "octagon", bed_layer=0))
            if model.history.undo_count >= len(states):
                states.append(now)
        for state in reversed(states[:-1]):
            self.assertIsNotNone(model.undo())
            self.assertEqual(model.printable(), state)
        self.assertIsNone(model.undo())
        while model.redo():
            pass
        self.assertEqual(model.printable(), states[-1])

    def test_tips(self):
        model = libsf.Sculpt(libsf.Lattice(32, 32, 32))
        mask = libsf.Grid.from_array(np.ones((2, 3, 4), bool))
        model.stroke("add-trim", libsf.Tip.of(mask, (0, 0, 0)), [(5, 6, 0)])
        np.testing.assert_array_equal(np.argwhere(model.printable().array()).max(0), (1, 8, 8))
        image = np.zeros((5, 7), np.uint8)
        image[2, 3] = 255
        model.replace(None)
        model.stroke("add-trim", libsf.Tip.stamp(image, 4), [(10, 10, 0)])
        self.assertEqual(np.argwhere(model.printable().array()).tolist(), [[k, 10, 10] for k in range(4)])
        line = libsf.Sculpt.line((0, 0, 0), (5, 2, 0))
        self.assertEqual((line[0].tolist(), line[-1].tolist(), len(line)), ([0, 0, 0], [5, 2, 0], 6))
        with self.assertRaises(libsf.ArgumentError):
            libsf.Tip.shaped("sphere", -1)

    def test_a_session(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.session")
            with open(path, "w", encoding="ascii") as file:
                file.write(SESSION)
            model = libsf.Sculpt.replay(path)
            same = libsf.Sculpt(model.lattice)
            same.stroke("add-trim", libsf.Tip.shaped("sphere", 6), [(20, 20, 0)])
            self.assertEqual(model.printable(), same.printable())
            with open(path, "w", encoding="ascii") as file:
                file.write(SESSION.replace("redo", "once more"))
            with self.assertRaises(libsf.FormatError) as caught:
                libsf.Sculpt.replay(path)
            self.assertEqual(caught.exception.line, 11)


if __name__ == "__main__":
    unittest.main()
