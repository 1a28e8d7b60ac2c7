"""Handles, weights and blends against their formulas; walls, drains and densities; standing by rounds."""

import unittest

import numpy as np

import libsf

from test_mesh import box


def bar():
    """A bar along x with a handle at either end."""
    grid = libsf.Grid.from_array(np.ones((4, 4, 40), bool))
    return grid, libsf.Weights(grid, [(2, 2, 2), (38, 2, 2)])


class Handles(unittest.TestCase):
    def test_places(self):
        grid, _ = bar()
        placed = libsf.place_handles(grid, 2, base=libsf.foot(grid, up=(1, 0, 0)))
        self.assertEqual(len(placed), 2)
        self.assertTrue(all(h.at_mm[0] > 3 for h in placed))
        self.assertEqual(libsf.foot(grid, up=(1, 0, 0)).count(), 16)
        base = libsf.Handle.base(libsf.foot(grid))
        self.assertEqual((base.kind, base.locked), (libsf.HandleKind.BASE, True))
        np.testing.assert_allclose(base.at_mm, (20, 2, 0.5))
        np.testing.assert_allclose(libsf.handle_center(grid, (10, 2.5, 9), (0, 0, -1)), (10, 2.5, 2))
        with self.assertRaises(libsf.InfeasibleError):
            libsf.handle_center(grid, (10, 2.5, 9), (0, 0, 1))

    def test_weights(self):
        _, weights = bar()
        self.assertEqual(weights.facts.handle_count, 2)
        np.testing.assert_array_equal(weights.centers, [(2, 2, 2), (38, 2, 2)])
        points = np.column_stack([np.linspace(1, 39, 50), np.full(50, 2.0), np.full(50, 1.5)])
        w = weights.sample(points)
        np.testing.assert_allclose(w.sum(axis=1), 1, atol=1e-12)
        self.assertTrue((np.diff(w[:, 1]) > -1e-3).all())
        one, gradient = weights.at((20.25, 2, 2))
        self.assertAlmostEqual(one[0], 0.5, delta=0.03)
        ahead, behind = weights.at((20.26, 2, 2))[0], weights.at((20.24, 2, 2))[0]
        np.testing.assert_allclose(gradient[:, 0], (ahead - behind) / 0.02, atol=1e-6)

    def test_blends(self):
        grid, weights = bar()
        points = np.random.default_rng(1).random((200, 3)) * (40, 4, 4)
        blend = libsf.Blend(weights, points)
        poses = [libsf.Pose(1.1, shift_mm=(0, 0, 1)), libsf.Pose().moved(libsf.Change(0.2, (0, 1, 0), (0, 0, 0.3)))]
        bent = blend.apply(poses)
        by_hand = sum(weights.sample(points)[:, j:j + 1] * (
            poses[j].scale * (points - weights.centers[j]) @ np.reshape(poses[j].turn, (3, 3)).T
            + weights.centers[j] + poses[j].shift_mm) for j in range(2))
        np.testing.assert_allclose(bent, by_hand, atol=1e-12)
        changes = [libsf.Change(1e-4, (1e-5, 2e-5, 0), (1e-6, 0, 2e-6)), libsf.Change(shift_mm=(0, 1e-5, 0))]
        moved = blend.apply([p.moved(c) for p, c in zip(poses, changes)]) - bent
        np.testing.assert_allclose(blend.push(poses, changes), moved, atol=1e-8)
        gradient = np.random.default_rng(2).random(points.shape)
        pulled = blend.pull(poses, gradient)
        self.assertAlmostEqual(float((gradient * blend.push(poses, changes)).sum()),
                               sum(p.scale * c.scale + np.dot(p.shift_mm, c.shift_mm) + np.dot(p.spin_rad, c.spin_rad)
                                   for p, c in zip(pulled, changes)), places=10)
        again = weights.unbend(bent, poses, 1e-9)
        self.assertEqual(again.missed, 0)
        np.testing.assert_allclose(again.rest_mm, points, atol=1e-6)
        self.assertEqual(weights.fold(poses).folded, 0)
        self.assertGreater(weights.fold([libsf.Pose(), libsf.Pose(shift_mm=(-80, 0, 0))]).folded, 0)
        with self.assertRaises(ValueError):
            blend.apply(poses[:1])

    def test_a_surface_is_covered(self):
        grid, _ = bar()
        mesh = box(40.2, 4.2, 4.2)
        wide = libsf.Grid(libsf.Lattice(42, 6, 6))
        wide.set_array(np.pad(grid.array(), ((0, 2), (0, 2), (0, 2))))
        covered = libsf.cover(wide, mesh)
        self.assertEqual(covered.count(), 41 * 5 * 5)


class Hollows(unittest.TestCase):
    def setUp(self):
        self.mesh = box(20, 20, 20)
        self.grid = libsf.voxelize(self.mesh, libsf.Lattice(20, 20, 20))

    def test_walls(self):
        wall = libsf.wall(self.grid, self.mesh, 3)
        self.assertEqual(wall.count(), 20**3 - 14**3)
        self.assertEqual(libsf.wall_inside(self.grid, 3), wall)
        self.assertAlmostEqual(libsf.clearance(self.grid - wall, self.mesh), 3)

    def test_densities_and_bodies(self):
        weights = libsf.density(self.grid.lattice, density=2, regions=[
            (np.array([(0, 0, 0), (10, 20, 20)]), 4.0), (box(5, 20, 20), 8.0)])
        self.assertEqual([float(weights[3, 3, x]) for x in (2, 7, 15)], [8, 4, 2])
        b = libsf.body(self.grid, weights)
        self.assertAlmostEqual(b.mass, 400 * (5 * 8 + 5 * 4 + 10 * 2))
        self.assertAlmostEqual(libsf.body(self.grid, 3.0).mass, 24000)
        both = libsf.add_bodies(b, libsf.ballast_body([(100.0, (1, 2, 3)), (50.0, (0, 0, 0))]))
        self.assertAlmostEqual(both.mass - b.mass, 150)
        np.testing.assert_allclose(np.subtract(both.moment, b.moment), (100, 200, 300))
        np.testing.assert_allclose(libsf.center_of_mass(self.grid), (10, 10, 10))
        np.testing.assert_allclose(libsf.center_of_mass(libsf.add_bodies(b, b, -0.5)), libsf.center_of_mass(b))

    def test_drained(self):
        carved = libsf.carve(self.grid, libsf.wall(self.grid, self.mesh, 2), goal=libsf.CarveGoal.LIGHTEST).grid
        before = libsf.voids(carved, bed_is_open=True).report.trap_count
        drained = libsf.drain(carved, 2.0)
        self.assertGreater(before, 0)
        self.assertEqual(drained.report.drained_count, before)
        self.assertEqual(libsf.voids(drained.grid, bed_is_open=True).report.trap_count, 0)
        self.assertEqual(sum(d.voxels for d in drained.drains), carved.count() - drained.grid.count())


class Standing(unittest.TestCase):
    def sheared(self):
        """A block whose top is shifted so far that it falls."""
        mesh = box(20, 20, 30)
        vertices = np.array(mesh.vertices)
        vertices[vertices[:, 2] > 1, 0] += 27
        return libsf.Mesh(vertices, mesh.faces)

    def test_by_rounds(self):
        asked = []
        shape = libsf.Stand(self.sheared(), handles=3, resolution=32, carve=False,
                            density=lambda p: asked.append(p) or 1.5)
        shape.round()
        self.assertGreater(len(asked), 1000)
        self.assertAlmostEqual(shape.report.mass, 1.5 * 12000, delta=200)
        while not shape.report.ended and shape.report.rounds < 40:
            shape.round()
        self.assertTrue(shape.report.succeeded)
        self.assertEqual(float(shape.density().max()), 1.5)
        verdict = shape.stance().judge(shape.report.com_mm)
        self.assertAlmostEqual(verdict.margin_rad, shape.report.margin_rad)
        before = shape.pose(0)
        shape.set_pose(0, before.moved(libsf.Change(shift_mm=(0, 2, 0))))
        shape.round()
        np.testing.assert_allclose(np.subtract(shape.pose(0).shift_mm, before.shift_mm), (0, 2, 0), atol=1e-12)
        with self.assertRaises(IndexError):
            shape.pose(9)

    def test_what_functions_raise(self):
        def field(p):
            raise KeyError("no such place")

        with self.assertRaisesRegex(KeyError, "no such place"):
            shape = libsf.Stand(self.sheared(), handles=3, resolution=24, density=field)
            shape.round()
        kept = libsf.stand(box(20, 20, 30), resolution=24, deform=False, keep=lambda p: p[0] > 10)
        self.assertTrue(kept.grid.count() > 0)
        hollow = libsf.Stand(self.sheared(), resolution=24, deform=False, keep=lambda p: True)
        self.assertEqual(hollow.round().carved_mm3, 0)

    def test_rest_and_feet(self):
        mesh = box(10, 20, 30)
        found = libsf.rest(mesh, (5, 10, 15), [(0, 0, 1), (0.9, 0, 0.3)])
        np.testing.assert_allclose(found[0].up, (0, 0, 1), atol=1e-12)
        np.testing.assert_allclose(found[1].up, (1, 0, 0), atol=1e-9)
        vertices = np.array(mesh.vertices)
        vertices[0, 2] = 0.05
        stance = libsf.Stance(libsf.Mesh(vertices, mesh.faces), contact_mm=0.1)
        self.assertEqual(stance.flattened(vertices)[0, 2], 0)


if __name__ == "__main__":
    unittest.main()
