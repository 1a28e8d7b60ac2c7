"""What is said to whoever hands in the wrong thing: what it is, and what to write instead.

Each case is a slip that a first hour with the package brings. The sentence has to name the argument
or the file, and the way out; a bare status of the library names neither.
"""

import os
import tempfile
import unittest

import numpy as np

import libsf

CORNERS = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]]
FACES = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]


class Mistakes(unittest.TestCase):
    def setUp(self):
        self.mesh = libsf.Mesh(CORNERS, FACES)
        self.grid = libsf.voxelize(self.mesh, pitch_mm=0.5)

    def says(self, error, words, call, *given, **named):
        with self.assertRaises(error) as raised:
            call(*given, **named)
        for word in words:
            self.assertIn(word, str(raised.exception))
        return raised.exception

    def test_rules(self):
        known = ("octogon", "box3", "octagon", "disk", "slack")
        self.assertIsInstance(self.says(ValueError, known, libsf.check, self.grid, "octogon"), libsf.ArgumentError)
        self.says(ValueError, known, libsf.repair, self.grid, "octogon")
        for wrong in (45, None, 2.5):
            self.says(TypeError, ("rule: ", "Rule.named"), libsf.check, self.grid, wrong)

    def test_names_of_kinds(self):
        self.says(ValueError, ("kind: ", "'lie'", "stand", "hang"), libsf.Stance, self.mesh, "lie")
        self.says(ValueError, ("kind: ", "'lie'", "stand", "hang"), libsf.stand, self.mesh, [{"kind": "lie"}])
        self.says(ValueError, ("shape: ", "'star'"), libsf.Tip.shaped, "star", 1)
        self.assertIn("stands", repr(libsf.Stance(self.mesh, "stand").judge((1, 1, 1))))

    def test_beds(self):
        layers = f"0 to {self.grid.shape[0] - 1}"
        for wrong in (self.grid.shape[0], -1):
            for call in (libsf.check, libsf.unsupported, libsf.trim):
                self.says(libsf.ArgumentError,
                          (f"bed_layer: {wrong}", layers), call, self.grid, "box3",
                          bed_layer=wrong)
        self.assertTrue(libsf.check(self.grid, "box3", bed_layer=1).support_free)

    def test_meshes_and_arrays_are_no_grids(self):
        solid = np.ones((3, 3, 3), bool)
        way = ("voxelize", "Grid.from_array")
        for call in (libsf.check, libsf.unsupported, libsf.trim, libsf.grow, libsf.repair):
            self.says(TypeError, ("grid: ", "Mesh", *way), call, self.mesh, "octagon")
            self.says(TypeError, ("grid: ", "ndarray", *way), call, solid, "octagon")
        self.says(TypeError, ("grid: ", *way), libsf.surface, self.mesh)
        self.says(TypeError, ("grid: ", *way), libsf.wall, self.mesh, self.mesh, 1)
        self.says(TypeError, ("grid: ", *way), libsf.wall_inside, self.mesh, 1)
        self.says(TypeError, ("walls: ", *way), libsf.carve, self.grid, None)
        self.says(TypeError, ("grid: ", *way), libsf.drain, solid, 1)
        for mask in ("keep", "forbid", "act", "exempt"):
            self.says(TypeError, (f"{mask}: ", *way), libsf.repair, self.grid, "octagon", **{mask: solid})
        with tempfile.TemporaryDirectory() as folder:
            self.says(TypeError, way, libsf.save_stack, self.mesh, os.path.join(folder, "stack"))
            self.says(TypeError, way, libsf.save_sl1, self.mesh, os.path.join(folder, "job.sl1"))
            self.assertEqual(os.listdir(folder), [])

    def test_sizes(self):
        for wrong in (0, -1, float("nan"), float("inf")):
            self.says(ValueError, ("pitch_mm: ", "above 0"), libsf.voxelize, self.mesh, pitch_mm=wrong)
            self.says(ValueError, ("layer_mm: ",), libsf.voxelize, self.mesh, pitch_mm=1, layer_mm=wrong)
            self.says(libsf.ArgumentError, ("no lattice", "above 0"), libsf.Lattice, 3, 3, 3, wrong)
        self.says(libsf.TooLargeError, ("400002 x", "larger"), libsf.voxelize, self.mesh, pitch_mm=1e-5)
        self.says(TypeError, ("pitch_mm=",), libsf.voxelize, self.mesh)
        self.says(TypeError, ("lattice: ", "pitch_mm="), libsf.voxelize, self.mesh, 0.5)
        self.says(TypeError, ("lattice: ", "from_array"), libsf.Grid, np.ones((3, 3, 3), bool))

    def test_meshes(self):
        self.says(libsf.ArgumentError, ("faces[3]: ", "vertex 4", "has 4"), libsf.Mesh, CORNERS, FACES[:3] + [[0, 1, 4]])
        self.says(TypeError, ("'part.stl'", "Mesh.load"), libsf.voxelize, "part.stl", pitch_mm=1)
        self.says(ValueError, ("'step'", "stl", "3mf"), self.mesh.save, "part", format="step")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "part.bin")
            self.mesh.save(path, "glb")
            with open(path, "rb") as file:
                self.assertEqual(file.read(4), b"glTF")

    def test_files_are_named(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "part.stl")
            with open(path, "w") as file:
                file.write("hello")
            error = self.says(libsf.FormatError, (f"{path}, byte 5: ", "too short"), libsf.Mesh.load, path)
            self.assertEqual(error.offset, 5)
            self.says(libsf.FormatError, (f"{path}: ", "no job"), libsf.Job, path)
            self.says(libsf.FormatError, (f"{path}", "Medit"), libsf.Cage.load, path)
            missing = os.path.join(folder, "none.stl")
            error = self.says(libsf.FileError, (missing, "check the name"), libsf.Mesh.load, missing)
            self.assertEqual(str(error).count(missing), 1)
        self.assertNotIn("b'hello'", str(self.says(libsf.FormatError, ("too short",), libsf.Mesh.load, b"hello", format="stl")))


if __name__ == "__main__":
    unittest.main()
