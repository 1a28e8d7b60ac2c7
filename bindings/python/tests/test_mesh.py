"""Meshes: what other libraries' objects become, files, voxels and surfaces against formulas."""

import math
import os
import tempfile
import types
import unittest

import numpy as np

import libsf

CORNERS = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
FACES = [[0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4],
         [2, 6, 3], [3, 6, 7], [0, 4, 2], [2, 4, 6], [1, 3, 5], [3, 7, 5]]


def box(x, y, z):
    return libsf.Mesh(CORNERS * (x, y, z), FACES)


class Meshes(unittest.TestCase):
    def test_a_box_is_measured(self):
        mass = box(2, 3, 5).measure()
        self.assertAlmostEqual(mass.volume_mm3, 30)
        self.assertAlmostEqual(mass.area_mm2, 62)
        np.testing.assert_allclose(mass.com_mm, (1, 1.5, 2.5))
        self.assertTrue(box(1, 1, 1).topology().closed)
        np.testing.assert_array_equal(box(2, 3, 5).bounds(), [[0, 0, 0], [2, 3, 5]])

    def test_objects_of_other_libraries(self):
        trimesh = types.SimpleNamespace(vertices=CORNERS, faces=np.array(FACES, np.int64))
        meshio = types.SimpleNamespace(points=CORNERS, cells_dict={"triangle": np.array(FACES, np.int32)})
        for other in (trimesh, meshio):
            np.testing.assert_array_equal(libsf.Mesh(other).faces, FACES)
            self.assertEqual(libsf.voxelize(other, pitch_mm=0.25).count(), 64)
        with self.assertRaises(TypeError):
            libsf.Mesh("part.stl")
        with self.assertRaises(ValueError):
            libsf.Mesh(CORNERS, np.array([[0, 1, -1]]))

    def test_the_libraries_themselves(self):
        try:
            import trimesh
        except ImportError:
            self.skipTest("trimesh is not there")
        ball = trimesh.creation.icosphere(3, 5)
        mesh = libsf.Mesh(ball)
        self.assertAlmostEqual(mesh.measure().volume_mm3, ball.volume)
        self.assertAlmostEqual(mesh.to_trimesh().volume, ball.volume)

    def test_colours_in_glb(self):
        colors = np.arange(24, dtype=np.uint8).reshape(8, 3)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "box.glb")
            box(2, 3, 5).save(path, colors=colors)
            with open(path, "rb") as file:
                data = file.read()
            self.assertTrue(data.startswith(b"glTF") and b"COLOR_0" in data)
            with self.assertRaises(ValueError):
                box(2, 3, 5).save(os.path.join(folder, "box.stl"), colors=colors)
            with self.assertRaises(ValueError):
                box(2, 3, 5).save(path, colors=colors[:7])
            with self.assertRaises(TypeError):
                box(2, 3, 5).save(path, colors=colors.astype(float))
            try:
                back = libsf.Mesh.load(path)
            except libsf.UnsupportedError:
                self.skipTest("this build does not read glTF")
            self.assertAlmostEqual(back.measure().volume_mm3, 30)

    def test_voxels_of_a_box(self):
        lattice = libsf.Lattice(12, 12, 12, 0.5, 0.5, (-1, -1, -1))
        array = libsf.voxelize(box(2, 3, 4), lattice).array()
        centres = np.arange(12) * 0.5 - 0.75
        inside = [(centres > 0) & (centres < n) for n in (2, 3, 4)]
        np.testing.assert_array_equal(
            array, inside[2][:, None, None] & inside[1][None, :, None] & inside[0][None, None, :])

    def test_surfaces_come_back(self):
        grid = libsf.voxelize(box(2, 3, 4), pitch_mm=0.5)
        self.assertEqual(libsf.voxelize(libsf.surface(grid), grid.lattice), grid)
        mesh = libsf.surface(grid, smooth_passes=5)
        self.assertTrue(mesh.topology().closed)
        self.assertAlmostEqual(libsf.surface(grid).measure().volume_mm3, grid.count() / 8)

    def test_moved(self):
        c, s = math.cos(0.3), math.sin(0.3)
        turned = box(2, 3, 5).transformed([[c, -s, 0, 7], [s, c, 0, 8], [0, 0, 1, 9]])
        self.assertAlmostEqual(turned.measure().volume_mm3, 30)
        self.assertAlmostEqual(turned.measure().com_mm[2], 11.5)
        with self.assertRaises(ValueError):
            box(1, 1, 1).transformed(np.eye(2))

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            for ending in ("stl", "obj", "ply"):
                path = os.path.join(folder, f"box.{ending}")
                box(2, 3, 5).save(path)
                self.assertAlmostEqual(libsf.Mesh.load(path).measure().volume_mm3, 30, 5)
            with self.assertRaisesRegex(ValueError, "stl"):
                box(1, 1, 1).save(os.path.join(folder, "box.txt"))
            with self.assertRaises(libsf.FileError):
                box(1, 1, 1).save(os.path.join(folder, "nowhere", "box.stl"))
            with open(os.path.join(folder, "broken.obj"), "w", encoding="ascii") as file:
                file.write("v 0 0 0\nv 1 x 0\n")
            with self.assertRaises(libsf.FormatError) as caught:
                libsf.Mesh.load(os.path.join(folder, "broken.obj"))
            self.assertEqual(caught.exception.line, 2)


class Ways(unittest.TestCase):
    def test_a_part_is_put_on_its_best_side(self):
        funnel = CORNERS * (10, 10, 10)  # wide above, so that it hangs over
        funnel[4:, :2] = (funnel[4:, :2] - 5) * 4 + 5
        mesh = libsf.Mesh(funnel, FACES)
        best = libsf.orient(mesh, resolution=48)[0]
        self.assertLess(best.trimmed_mm3, 1e-6 + libsf.orient(mesh, resolution=48)[-1].trimmed_mm3)
        turned = mesh.transformed(np.column_stack([np.reshape(best.turn.matrix, (3, 3)), best.turn.shift_mm]))
        self.assertAlmostEqual(turned.bounds()[0][2], 0)
        self.assertLess(best.up[2], 0)  # upside down

    def test_stacks(self):
        grid = libsf.voxelize(box(4, 3, 2), libsf.Lattice(12, 10, 8, (0.5, 0.4), 0.3, (-1, 0, 0)))
        rule = libsf.Rule.named("octagon", 40)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "stack")
            try:
                libsf.save_stack(grid, path, rule=rule, bed_layer=0)
                again = libsf.load_stack(path)
            except libsf.UnsupportedError as error:
                self.skipTest(str(error))
            self.assertEqual((again.grid, again.rule, again.bed_layer), (grid, rule, 0))
            self.assertEqual(again.grid.lattice, grid.lattice)
            with self.assertRaises(libsf.Error):
                libsf.load_stack(folder)


class Lattices(unittest.TestCase):
    def test_heights(self):
        lattice = libsf.Lattice(2, 2, 3, 1, (0.1, 0.2, 0.3))
        self.assertAlmostEqual(lattice.layer_bottom(3), 0.6)
        grid = libsf.Grid(lattice)
        self.assertEqual(grid.lattice.layer_mm, (0.1, 0.2, 0.3))
        self.assertEqual(libsf.trim(grid, "octagon").grid, grid)
        with self.assertRaises(ValueError):
            libsf.Lattice(2, 2, 3, 1, (0.1, 0.2))

    def test_around(self):
        lattice = libsf.Lattice.around((0, 0, 0), (1, 2, 3), 0.25)
        self.assertEqual(lattice.shape, (14, 10, 6))
        self.assertAlmostEqual(lattice.origin_mm[2], -0.25)


if __name__ == "__main__":
    unittest.main()
