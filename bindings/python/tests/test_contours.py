"""Polygons to voxels and back, against areas and voxels that can be told by hand."""

import io
import unittest

import numpy as np

import libsf

SQUARE = [[0, 0], [4, 0], [4, 4], [0, 4]]
INNER = [[1, 1], [3, 1], [3, 3], [1, 3]]


class Contours(unittest.TestCase):
    def test_fills_say_what_a_nested_polygon_is(self):
        lattice = libsf.Lattice(5, 4, 1)
        solid = libsf.layer_from_contours(lattice, [SQUARE, INNER])
        ring = libsf.layer_from_contours(lattice, [SQUARE, INNER], libsf.ContourFill.EVEN_ODD)
        turned = libsf.layer_from_contours(lattice, [SQUARE, INNER[::-1]])
        self.assertEqual((solid.count(), ring.count()), (16, 12))
        self.assertEqual(ring, turned)
        np.testing.assert_array_equal(ring.array()[1], [True, False, False, True, False])

    def test_a_stack_has_heights_and_becomes_a_grid(self):
        stack = libsf.ContourStack(2.0)
        stack.add(2.25, [SQUARE, INNER[::-1]])
        stack.add(2.5, [])
        self.assertEqual((len(stack), stack[0].area_mm2, stack[-1].polygons), (2, 12.0, []))
        self.assertEqual((stack[1].bottom_mm, stack[1].top_mm), (2.25, 2.5))
        np.testing.assert_array_equal(stack[0].polygons[0], SQUARE)
        lattice = stack.lattice((0.5, 1.0))
        self.assertEqual((lattice.shape, lattice.layer_mm), ((2, 5, 9), 0.25))
        self.assertEqual(stack.grid(lattice).count(), 24)
        with self.assertRaisesRegex(libsf.ArgumentError, "below"):
            stack.add(2.5, [SQUARE])

    def test_voxels_come_back(self):
        array = np.random.default_rng(5).random((3, 20, 70)) < 0.5
        grid = libsf.Grid.from_array(array, pitch_mm=0.3, layer_mm=0.1)
        back = libsf.ContourStack.of(grid).grid(grid.lattice)
        self.assertEqual(back, grid)

    def test_a_checker_takes_polygons(self):
        checker = libsf.Checker(8, 8)
        checker.push_contours([INNER])
        checker.push_contours([SQUARE])
        self.assertTrue(checker.report().support_free)
        checker.push_contours([[[0, 0], [8, 0], [8, 8], [0, 8]]])
        self.assertEqual(checker.report().report.unsupported_voxels, 64 - 25)

    def test_points_stay_while_the_library_reads_them(self):
        # So many that they are memory of the system's, which is gone at once when it is given back.
        turn = np.linspace(0, 2 * np.pi, 200_000, endpoint=False)
        disk = np.column_stack([50 + 40 * np.cos(turn), 50 + 40 * np.sin(turn)])
        area = np.pi * 40 * 40
        self.assertAlmostEqual(libsf.ContourLayer(0, 1, [disk]).area_mm2, area, 4)
        stack = libsf.ContourStack()
        stack.add(1, [disk])
        self.assertAlmostEqual(stack[0].area_mm2, area, 4)
        layer = libsf.layer_from_contours(libsf.Lattice(100, 100, 1), [disk])
        self.assertAlmostEqual(layer.count(), area, delta=40)
        checker = libsf.Checker(100, 100)
        checker.push_contours([disk])
        self.assertEqual(checker.report().report.solid_voxels, layer.count())

    def test_files(self):
        stack = libsf.ContourStack()
        stack.add(0.1, [SQUARE, INNER[::-1]])
        stack.add(0.2, [SQUARE])
        for format in libsf.ContourFormat:
            file = io.BytesIO()
            stack.save(file, format)
            back = libsf.ContourStack.load(file.getvalue())
            self.assertEqual([k.area_mm2 for k in (back[0], back[1])], [12.0, 16.0])
        with self.assertRaises(libsf.TooLargeError):
            libsf.ContourStack.load(file.getvalue(), points_max=3)
        with self.assertRaisesRegex(libsf.FormatError, "CLI"):
            libsf.ContourStack.load(b"no such file")

    def test_points_that_cannot_be_are_named(self):
        with self.assertRaisesRegex(libsf.ArgumentError, "point 1 "):
            libsf.layer_from_contours(libsf.Lattice(5, 4, 1), [[[0, 0], [np.nan, 1], [2, 2]]])
        with self.assertRaisesRegex(libsf.TooLargeError, "131072"):
            libsf.layer_from_contours(libsf.Lattice(5, 4, 1), [[[0, 0], [1e9, 1], [2, 2]]])


if __name__ == "__main__":
    unittest.main()
