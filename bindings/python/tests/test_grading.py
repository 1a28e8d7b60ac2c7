"""Grading: what a block of cells is at its limit, slices of it, tones and mixtures."""

import os
import tempfile
import unittest

import numpy as np

import libsf


def graded():
    cage = libsf.Cage.block((4, 2, 2), (0, 0, 0), (4, 2, 2))
    cage.add_property("tone", cage.points[:, 0] / 4, 0, 1)
    return cage


class Cages(unittest.TestCase):
    def test_a_block(self):
        cage = graded()
        self.assertEqual(cage.points.shape, (45, 3))
        self.assertEqual(list(cage.properties), ["tone"])
        self.assertEqual(cage.properties["tone"].high, 1)
        self.assertEqual(cage.check().inverted_cells, 0)
        self.assertAlmostEqual(cage.check().volume_mm3, 16)
        np.testing.assert_allclose(cage.values("tone"), cage.points[:, 0] / 4)
        cage.set_values("tone", np.zeros(45))
        self.assertEqual(cage.values("tone").max(), 0)
        with self.assertRaises(libsf.ArgumentError):
            cage.set_values("tone", np.full(45, 2.0))  # beyond its bounds
        with self.assertRaisesRegex(KeyError, "tone"):
            cage.values("stiffness")

    def test_painted(self):
        cage = graded()
        changed = cage.paint("tone", (0, 0, 0), 1.5, 1, falloff=libsf.Falloff.CONSTANT)
        near = np.linalg.norm(cage.points, axis=1) <= 1.5
        self.assertEqual(changed, near.sum())
        self.assertTrue((cage.values("tone")[near] == 1).all())
        self.assertEqual(cage.paint("tone", (0, 0, 0), 1.5, -0.25, operation="add", falloff=libsf.Falloff.CONSTANT), changed)
        self.assertTrue((cage.values("tone")[near] == 0.75).all())

    def test_of_arrays(self):
        points = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
        cage = libsf.Cage(points, [[0, 1, 3, 2, 4, 5, 7, 6]], properties={"heat": np.arange(8.0)})
        self.assertAlmostEqual(cage.check().volume_mm3, 1)
        with self.assertRaises(libsf.Error):
            libsf.Cage(points, [[0, 1, 3, 2, 4, 5, 7]])
        with self.assertRaises(libsf.ArgumentError):
            libsf.Cage(points, [[0, 1, 3, 2, 4, 5, 7, 9]])

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "cage.vtk")
            graded().save(path)
            again = libsf.Cage.load(path)
            np.testing.assert_array_equal(again.points, graded().points)
            np.testing.assert_array_equal(again.values("tone"), graded().values("tone"))
            with self.assertRaises(libsf.FileError):
                libsf.Cage.load(path + "x")


class Built(unittest.TestCase):
    def test_bodies(self):
        square = libsf.Cage([[1, 0, 0], [2, 0, 0], [2, 0, 3], [1, 0, 3]], [[0, 1, 2, 3]], dimension=2)
        ring = square.revolved(64)
        self.assertAlmostEqual(ring.check().volume_mm3, np.pi * 3 * 3, delta=0.05)
        self.assertAlmostEqual(square.extruded((0, -2, 0), 3).check().volume_mm3, 6)
        with self.assertRaises(libsf.ArgumentError):
            square.extruded((1, 0, 0), 3)  # along the faces
        bone = libsf.Cage.skeleton([((0, 0, 0), 1), ((10, 0, 0), 1)], [(0, 1, 4)])
        self.assertAlmostEqual(bone.check().volume_mm3, 12 * 4)
        with self.assertRaises(libsf.ArgumentError):
            libsf.Cage.skeleton([((0, 0, 0), 1)], [(0, 5, 1)])

    def test_by_functions(self):
        cage = graded()
        before = np.array(cage.points)
        cage.map_points(lambda p: (p[0], p[1], p[2] + p[0]**2))
        np.testing.assert_allclose(cage.points[:, 2], before[:, 2] + before[:, 0]**2)
        cage.map_values("tone", lambda p, tone: tone / 2)
        np.testing.assert_allclose(cage.values("tone"), before[:, 0] / 8)
        with self.assertRaises(ZeroDivisionError):
            cage.map_points(lambda p: 1 / 0)
        np.testing.assert_allclose(cage.points[:, 0], before[:, 0])
        cage.remove_property("tone")
        self.assertEqual(list(cage.properties), [])

    def test_undone(self):
        cage = graded()
        history, before = libsf.CageHistory(cage), np.array(cage.points)
        weights = cage.select((0, 0, 0), 1.5)
        self.assertEqual(cage.drag(weights, (0, 0, -1)), (weights > 0).sum())
        np.testing.assert_allclose(cage.points, before + weights[:, None] * (0, 0, -1))
        self.assertGreater(history.record(), 0)
        self.assertGreater(cage.smooth(np.ones(45), 0.5), 0)
        history.record()
        self.assertEqual(history.state.undo_count, 2)
        after = np.array(cage.points)
        history.undo()
        history.undo()
        np.testing.assert_array_equal(cage.points, before)
        self.assertEqual(history.undo(), 0)
        history.redo()
        history.redo()
        np.testing.assert_array_equal(cage.points, after)

    def test_known_properties(self):
        self.assertEqual(libsf.known_property("density").si, (-3, 1, 0, 0, 0, 0, 0))
        with self.assertRaises(KeyError):
            libsf.known_property("taste")


class Steps(unittest.TestCase):
    def test_stencils_make_the_points(self):
        cage = graded()
        refined = cage.refined(2)
        step = refined.step(2)
        self.assertEqual(len(step.starts), 16 * 64 + 1)
        for point in (0, 17, len(step.points) - 1):
            points, weights = refined.stencil(2, point)
            self.assertAlmostEqual(weights.sum(), 1)
            np.testing.assert_allclose(weights @ cage.points[points], step.points[point], atol=1e-12)
        cage.move(cage.points * (1.0, 1.0, 2.0))
        refined.update()
        np.testing.assert_allclose(refined.step(2).points, cage.refined(2).step(2).points, atol=1e-12)
        np.testing.assert_allclose(step.channels["tone"].values, refined.step(2).channels["tone"].values)


class Limits(unittest.TestCase):
    def test_found_again(self):
        cage = graded()
        limit = cage.limit()
        self.assertEqual(limit.piece_count, 16 * 8)
        self.assertEqual(limit.check().inverted, 0)
        random = np.random.default_rng(1)
        places = limit.places(random.integers(0, 16, 100), random.random((100, 3)))
        at = limit.positions(places)
        locator = libsf.Locator(limit)
        found, distances = locator.find(at)
        self.assertLess(distances.max(), 1e-9)
        np.testing.assert_allclose(limit.positions(found), at, atol=1e-9)
        np.testing.assert_allclose(limit.values("tone", found), limit.values("tone", places), atol=1e-9)
        far, distances = locator.find(np.array([[100.0, 0, 0]]), 1.0)
        self.assertEqual((int(far[0]["piece"]), distances[0]), (libsf.NO_PIECE, np.inf))
        step = 1e-6
        moved = places.copy()
        inside = places["u"][:, 0] < 0.9
        moved["u"][inside, 0] += step
        np.testing.assert_allclose(limit.derivatives(places)[inside, :, 0],
                                   (limit.positions(moved) - at)[inside] / step, atol=1e-4)
        np.testing.assert_allclose(limit.value_derivatives("tone", places)[inside, 0],
                                   (limit.values("tone", moved) - limit.values("tone", places))[inside] / step, atol=1e-4)
        sampler = limit.slices(libsf.Lattice(8, 8, 8))
        cage.move(cage.points * (2.0, 1.0, 1.0))
        limit.update()
        np.testing.assert_allclose(limit.positions(places), at * (2, 1, 1), atol=1e-9)
        for stale in (lambda: locator.find(at), lambda: sampler[0]):
            with self.assertRaisesRegex(RuntimeError, "changed"):
                stale()

    def test_the_inside_of_a_block_is_where_it_was(self):
        limit = graded().limit()
        u = np.array([[0.5, 1, 1], [0.25, 1, 1]])
        at = limit.positions([1, 1], u)  # two cells from either end: nothing has moved along x
        np.testing.assert_allclose(at[:, 1:], 1, atol=1e-12)
        np.testing.assert_allclose(limit.values("tone", [1, 1], u), at[:, 0] / 4, atol=1e-12)
        low, high = limit.bounds()
        self.assertTrue((low > -0.01).all() and (high < (4.01, 2.01, 2.01)).all())
        self.assertTrue((high - low > (3.5, 1.8, 1.8)).all())

    def test_slices_hold_what_the_limit_is(self):
        lattice = libsf.Lattice(80, 40, 40, 0.05, 0.05)
        sampler = graded().limit().slices(lattice, ["tone"])
        self.assertEqual(len(sampler), 40)
        middle = sampler[20]
        self.assertTrue(middle.solid[20, 40])
        x = (np.arange(80) + 0.5) * 0.05
        row = middle.solid[20] & (x > 1.2) & (x < 2.8)  # away from the ends values are linear
        np.testing.assert_allclose(middle.values["tone"][20][row], x[row] / 4, atol=1e-3)
        self.assertEqual(middle.values["tone"][~middle.solid].max(initial=0), 0)
        volume = sum(s.solid.sum() for s in sampler) * 0.05**3
        self.assertAlmostEqual(sampler.surface().measure().volume_mm3, volume, delta=0.01 * volume)
        with self.assertRaises(IndexError):
            sampler[40]


class Tones(unittest.TestCase):
    def test_a_tone_comes_out_exactly(self):
        for tone in (0.0, 0.1, 0.5, 1.0):
            count = sum((libsf.halftone(np.full((32, 32), tone, np.float32), layer=k) == 2).sum() for k in range(32))
            self.assertEqual(count, int(np.floor(np.float32(tone) * 32**3 + 0.5)))

    def test_three_materials_and_a_shape(self):
        tones = np.stack([np.full((40, 50), t, np.float32) for t in (0.2, 0.3, 0.5)])
        solid = np.zeros((40, 50), bool)
        solid[5:30, 7:41] = True
        ids = libsf.halftone(tones, solid=solid)
        self.assertTrue((ids[~solid] == 0).all() and (ids[solid] > 0).all())
        shares = [(ids == m + 1).sum() / solid.sum() for m in range(3)]
        np.testing.assert_allclose(shares, (0.2, 0.3, 0.5), atol=0.05)
        with self.assertRaises(TypeError):
            libsf.halftone(np.zeros((4, 4), np.int32))
        with self.assertRaises(libsf.ArgumentError):
            libsf.halftone(np.full((3, 4, 4), 0.9, np.float32))

    def test_masks(self):
        ranks = libsf.Mask.create((4, 4, 4)).ranks()
        self.assertEqual(sorted(ranks.reshape(-1)), list(range(64)))
        self.assertEqual(libsf.Mask.builtin().ranks().shape, (32, 32, 32))


class Mixtures(unittest.TestCase):
    def test_curves(self):
        curve = libsf.Curve([(0, 1), (0.5, 2), (1, 5)])
        self.assertAlmostEqual(curve(0.5), 2)
        self.assertEqual((curve(-1), curve(2), curve.change), (1, 5, 0))
        x, miss = curve.inverse(curve(0.7))
        self.assertAlmostEqual(x, 0.7)
        self.assertAlmostEqual(miss, 0)
        y, slope = curve.value_and_slope(0.3)
        self.assertAlmostEqual(slope, (curve(0.3001) - curve(0.2999)) / 2e-4, places=4)
        self.assertAlmostEqual(libsf.Curve([(0, 1), (0.4, 3), (0.6, 2), (1, 5)]).change, 0.5)
        with self.assertRaises(ValueError):
            libsf.Curve([1, 2, 3])

    def test_simplices(self):
        mixture = libsf.Mixture([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1 / 3, 1 / 3, 1 / 3]], [[1.0], [2.0], [3.0], [2.0]])
        self.assertEqual([list(s) for s in sorted(mixture.simplices().tolist())], [[0, 1, 3], [0, 2, 3], [1, 2, 3]])

    def test_two_materials(self):
        mixture = libsf.Mixture([[1, 0], [0.5, 0.5], [0, 1]], [[1.0], [2.0], [5.0]])
        fractions, miss = mixture.fractions(3.5)
        np.testing.assert_allclose(fractions, (0.25, 0.75))
        self.assertAlmostEqual(miss, 0)
        np.testing.assert_allclose(mixture.properties(fractions), (3.5,))
        fractions, miss = mixture.fractions(9)
        np.testing.assert_allclose(fractions, (0, 1))
        self.assertGreater(miss, 0)


if __name__ == "__main__":
    unittest.main()
