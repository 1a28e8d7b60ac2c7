"""Balance: formulas for boxes, derivatives against differences, a shape that is made to stand."""

import math
import unittest

import numpy as np

import libsf
from test_mesh import CORNERS, FACES, box


def leaning(shift):
    """A block of 20 x 20 x 30 mm with its top aside."""
    corners = CORNERS * (20, 20, 30)
    corners[4:, 0] += shift
    return libsf.Mesh(corners, FACES)


class Bodies(unittest.TestCase):
    def test_a_box(self):
        b = libsf.body(box(2, 3, 5), 2)
        self.assertAlmostEqual(b.mass, 60)
        np.testing.assert_allclose(libsf.center_of_mass(box(2, 3, 5)), (1, 1.5, 2.5))

    def test_derivatives_against_differences(self):
        rng = np.random.default_rng(2)
        points = CORNERS * (4, 5, 6) + rng.normal(0, 0.3, (8, 3))
        balance, h = libsf.Balance(FACES, 1.3), 1e-5
        stance = libsf.Stance(libsf.Mesh(points, FACES), contact_mm=2)
        mass, d_mass = balance.mass(points)
        com, d_com = balance.center_of_mass(points)
        margin, d_margin = balance.margin(points, stance)
        self.assertEqual(d_com.shape, (3, 8, 3))
        self.assertAlmostEqual(margin, stance.judge(com).margin_rad)
        for v in range(8):
            for k in range(3):
                step = np.zeros_like(points)
                step[v, k] = h
                more, less = points + step, points - step
                self.assertAlmostEqual(d_mass[v, k], (balance.mass(more)[0] - balance.mass(less)[0]) / (2 * h), 5)
                np.testing.assert_allclose(
                    d_com[:, v, k], (balance.center_of_mass(more)[0] - balance.center_of_mass(less)[0]) / (2 * h), atol=1e-7)
                self.assertAlmostEqual(
                    d_margin[v, k], (balance.margin(more, stance)[0] - balance.margin(less, stance)[0]) / (2 * h), 6)
        flat = balance.mass(points.reshape(-1))
        self.assertEqual((flat[0], flat[1].shape), (mass, (24,)))


class Stances(unittest.TestCase):
    def test_a_box_stands(self):
        stance = libsf.Stance(box(20, 10, 30), gamma_rad=0.1)
        verdict = stance.judge((10, 5, 15))
        self.assertAlmostEqual(verdict.margin_rad, math.atan2(5, 15))
        self.assertTrue(verdict.stands and verdict.safe)
        self.assertEqual(stance.polygon().shape, (4, 3))
        self.assertEqual(sorted(stance.contacts()), [0, 1, 2, 3])
        normals, offsets = stance.halfspaces()
        self.assertTrue((normals @ (10, 5, 15) >= offsets).all())
        self.assertFalse(stance.judge((25, 5, 15)).stands)
        with self.assertRaises(libsf.ArgumentError):
            libsf.Stance(box(1, 1, 1), gamma_rad=3)

    def test_a_box_hangs(self):
        stance = libsf.Stance(box(20, 10, 30), "hang", point_mm=(10, 5, 30))
        self.assertTrue(stance.judge((10, 5, 15)).stands)
        self.assertAlmostEqual(stance.judge((11, 5, 15)).margin_rad, -math.atan2(1, 15))


class Making(unittest.TestCase):
    def test_carved(self):
        mesh = box(20, 20, 20)
        grid = libsf.voxelize(mesh, pitch_mm=0.5)
        walls = libsf.wall(grid, mesh, 2)
        found = libsf.carve(grid, walls)
        self.assertEqual((walls - found.grid).count(), 0)
        self.assertEqual((found.grid - grid).count(), 0)
        self.assertTrue(libsf.check(found.grid))
        self.assertGreater(found.report.removed_mm3, 1000)
        self.assertEqual(found.report.removed_voxels, (grid - found.grid).count())

    def test_made_to_stand(self):
        mesh = leaning(27)
        self.assertFalse(libsf.Stance(mesh).judge(libsf.center_of_mass(mesh)).stands)
        shares = []
        found = libsf.stand(mesh, resolution=40, wall_mm=3, progress=shares.append)
        self.assertTrue(found.succeeded)
        self.assertGreaterEqual(found.report.margin_rad, math.radians(4))
        self.assertEqual(shares, sorted(shares))
        outside, inside = found.outer.measure(), found.cavity.measure()
        mass = outside.volume_mm3 + inside.volume_mm3
        com = (np.array(outside.com_mm) * outside.volume_mm3 + np.array(inside.com_mm) * inside.volume_mm3) / mass
        np.testing.assert_allclose(com, found.report.com_mm, atol=1e-6)
        again = libsf.stand(mesh, resolution=40, wall_mm=3, threads=2)
        np.testing.assert_array_equal(again.outer.vertices, found.outer.vertices)
        solid = libsf.stand(box(20, 20, 10), carve=False)
        self.assertTrue(solid.succeeded and solid.cavity is None)
        with self.assertRaises(TypeError):
            libsf.stand(mesh, [{"gravity": 9.81}])


if __name__ == "__main__":
    unittest.main()
