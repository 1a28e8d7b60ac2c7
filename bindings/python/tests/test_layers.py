"""Layers: morphology, runs and components against plain numpy; voids, costs and paths by hand."""

import json
import os
import tempfile
import unittest

import numpy as np

import libsf
from libsf.layers import c_runs


def scattered(seed, height=37, width=131, share=0.4):
    return np.random.default_rng(seed).random((height, width)) < share


def dilated(array, element, outside=False):
    """By the definition, a voxel at a time."""
    n = len(element.half_widths) - 1
    m = max(element.half_widths)
    wide = np.pad(array, ((n, n), (m, m)), constant_values=outside)
    found = np.zeros_like(array)
    for dy in range(-n, n + 1):
        for dx in range(-element.half_widths[abs(dy)], element.half_widths[abs(dy)] + 1):
            found |= wide[n + dy:n + dy + array.shape[0], m + dx:m + dx + array.shape[1]]
    return found


class Layers(unittest.TestCase):
    def test_a_layer_of_a_grid_is_its_memory(self):
        grid = libsf.Grid(libsf.Lattice(70, 5, 3))
        layer = libsf.Layer.of(grid, 1)
        layer[4, 69] = True
        layer.fill(x=(2, 5), y=(0, 2))
        self.assertTrue(grid[1, 4, 69])
        self.assertEqual(grid.count(), 7)
        self.assertEqual(layer.words.ctypes.data, grid.words[1].ctypes.data)
        self.assertEqual((layer.count(), layer.bounds().x1, layer.sums().x), (7, 70, 69 + 2 * (2 + 3 + 4)))
        copy = layer.copy()
        layer.fill(False)
        self.assertEqual((grid.count(), copy.count()), (0, 7))
        with self.assertRaises(IndexError):
            libsf.Layer.of(grid, 3)
        with self.assertRaises(libsf.ArgumentError):
            layer.fill(x=(2, 71))

    def test_sets(self):
        a, b = scattered(1), scattered(2)
        x, y = libsf.Layer.from_array(a), libsf.Layer.from_array(b)
        for found, wanted in ((x & y, a & b), (x | y, a | b), (x ^ y, a ^ b), (x - y, a & ~b)):
            np.testing.assert_array_equal(found.array(), wanted)
        with self.assertRaises(libsf.ShapeError):
            x & libsf.Layer(130, 37)

    def test_morphology(self):
        array = scattered(3, share=0.05)
        layer = libsf.Layer.from_array(array)
        elements = [libsf.Element.box3(), libsf.Element.plus3(), libsf.Element.ellipse(5, 3.5),
                    libsf.Element([2, 2, 0]), libsf.Element.box3() + libsf.Element.plus3()]
        self.assertEqual(elements[4].half_widths, (2, 2, 1))
        for element in elements:
            for border in libsf.Border:
                solid = border is libsf.Border.SOLID
                np.testing.assert_array_equal(layer.dilated(element, border).array(), dilated(array, element, solid))
                np.testing.assert_array_equal(layer.eroded(element, border).array(),
                                              ~dilated(~array, element, not solid))
        above = libsf.Layer.from_array(scattered(4))
        np.testing.assert_array_equal(above.resting_on(layer, elements[2]).array(),
                                      scattered(4) & dilated(array, elements[2]))
        with self.assertRaises(ValueError):
            libsf.Element([300])
        with self.assertRaises(libsf.Error):
            layer.dilated(libsf.Element([1, 2]))  # wider farther off

    def test_runs_and_components(self):
        array = np.zeros((4, 9), bool)
        array[0, 1:4] = array[1, 4] = array[3, 0] = array[3, 7:9] = True
        layer = libsf.Layer.from_array(array)
        runs = layer.runs()
        self.assertEqual([tuple(r)[:3] for r in runs], [(1, 4, 0), (4, 5, 1), (0, 1, 3), (7, 9, 3)])
        self.assertEqual(libsf.Layer.from_runs(runs, 9, 4), layer)
        parts = layer.components()
        self.assertEqual(list(parts.runs["label"]), [0, 0, 1, 2])
        self.assertEqual([p.area for p in parts.parts], [4, 1, 2])
        self.assertEqual(len(layer.components(libsf.Connectivity.EDGES).parts), 4)
        with self.assertRaises(TypeError):
            libsf.Layer.from_runs(np.zeros((3, 4), np.uint32), 9, 4)

    def test_runs_of_a_list_stay_while_they_are_read(self):
        pointer, count = c_runs([(3, 5, 1, 7)])
        others = [np.full(16, 255, np.uint8) for _ in range(1000)]
        self.assertEqual((count, pointer[0].x0, pointer[0].x1, len(others)), (1, 3, 5, 1000))
        self.assertEqual(libsf.Layer.from_runs([(3, 5, 1, 0), (0, 4, 2, 0)], 8, 4).count(), 6)

    def test_words_are_not_moved_from_under_a_layer(self):
        layer = libsf.Layer(6000, 6000)
        for words in (layer.words, layer.words.base):
            with self.assertRaises(ValueError):
                words.resize((1, 1))
        layer.fill()
        self.assertEqual(layer.count(), 6000 * 6000)

    def test_instruction_sets_agree(self):
        layer = libsf.Layer.from_array(scattered(5))
        best = layer.dilated(libsf.Element.ellipse(4, 4))
        try:
            self.assertEqual(libsf.limit_isa(libsf.Isa.REFERENCE), "reference")
            self.assertEqual(layer.dilated(libsf.Element.ellipse(4, 4)), best)
        finally:
            self.assertNotEqual(libsf.limit_isa(), "")

    def test_checkers_take_layers_and_runs(self):
        array = np.zeros((3, 8, 8), bool)
        array[0, 2:6, 2:6] = array[1, 1:7, 1:7] = array[2, 0, 0] = array[2, 7, 7] = True
        grid = libsf.Grid.from_array(array)
        by_layers, by_runs = libsf.Checker(8, 8), libsf.Checker(8, 8)
        for k in range(3):
            by_layers.push(libsf.Layer.of(grid, k))
            by_runs.push_runs(libsf.Layer.of(grid, k).runs())
        self.assertEqual(by_layers.report().report, libsf.check(grid).report)
        self.assertEqual(by_runs.report().report, by_layers.report().report)


class Places(unittest.TestCase):
    def setUp(self):
        """A closed box with a hollow, a cup on top of it, and an island."""
        array = np.zeros((12, 16, 16), bool)
        array[0:6, 1:11, 1:11] = True
        array[2:4, 4:7, 4:7] = False  # a trap
        array[6:9, 1:11, 1:11] = True
        array[6:9, 3:9, 3:9] = False  # a cup
        array[5, 14, 14] = True
        self.grid = libsf.Grid.from_array(array)

    def test_voids(self):
        found = libsf.voids(self.grid)
        self.assertEqual((found.report.trap_count, found.report.trap_voxels), (1, 18))
        self.assertEqual((found.report.cup_count, found.report.cup_voxels), (1, 108))
        self.assertEqual([v.volume for v in found.voids], [18, 108])
        self.assertEqual(len(libsf.voids(self.grid, limit=1).voids), 1)

    def test_what_mending_costs(self):
        checked = libsf.check(self.grid)
        found = libsf.costs(self.grid, checked)
        self.assertEqual(len(found.costs), len(checked.findings))
        island = [i for i, f in enumerate(checked.findings) if f.box.x0 == 14][0]
        self.assertEqual((found.costs[island].trim_voxels, found.costs[island].grow_voxels), (1, 3))
        self.assertEqual(sorted(found.order), list(range(len(found.costs))))
        self.assertTrue(libsf.check(self.grid | found.added).support_free)

    def test_steepest(self):
        wall = np.zeros((20, 3, 60), bool)
        for k in range(20):
            wall[k, :, 2 * k:2 * k + 5] = True  # two voxels out for one up
        found = libsf.steepest(libsf.Grid.from_array(wall))
        self.assertTrue(found.is_bounded)
        tangent = np.tan(found.angle_rad)  # two voxels may be said too little over the height
        self.assertTrue(2 - 2 / 19 - 0.01 <= tangent <= 2.01, tangent)

    def test_masks(self):
        needed = libsf.Grid(self.grid.lattice)
        needed[5, 14, 14] = True
        self.assertEqual(libsf.culprits(self.grid, needed).count(), 1)
        self.assertEqual(libsf.culprits(libsf.grow(self.grid).grid, needed).count(), 0)
        with self.assertRaises(libsf.InfeasibleError):
            libsf.trim(self.grid, keep=needed)
        self.assertTrue(libsf.trim(self.grid, exempt=needed).grid[5, 14, 14])
        whole = libsf.grow(self.grid).grid
        column = libsf.complete(whole, needed)
        self.assertEqual(column.count(), 6)  # it, the three that were grown, and one in each layer below
        self.assertTrue(libsf.check(column).support_free)

    def test_a_trim_is_kept_up(self):
        drawn = self.grid.copy()
        printable = libsf.trim(drawn).grid
        drawn[2, 14, 14] = drawn[3, 14, 14] = drawn[4, 14, 14] = True
        bounds = drawn.bounds()
        box = type(bounds)(14, 14, 2, 15, 15, 5)
        changed = libsf.update_trim(drawn, printable, box)
        self.assertEqual(printable, libsf.trim(drawn).grid)
        self.assertEqual((changed.z0, changed.z1), (2, 6) if printable[5, 14, 14] else (0, 0))

    def test_how_it_stands_while_it_prints(self):
        lean = np.zeros((30, 4, 40), bool)
        for k in range(30):
            lean[k, :, k:k + 4] = True
        found = libsf.printing(libsf.Grid.from_array(lean))
        self.assertEqual(found.margins_rad.shape, (30,))
        # A prism of squares that leans by 45 degrees: after n layers its middle has moved (n - 1) / 2.
        for n in (1, 3, 10):
            margin = np.arctan2(2 - (n - 1) / 2, n / 2)
            self.assertAlmostEqual(found.margins_rad[n - 1], min(margin, np.arctan2(2, n / 2)))
        self.assertAlmostEqual(found.report.margin_rad, found.margins_rad.min())


class Paths(unittest.TestCase):
    def test_the_nearest_support(self):
        array = np.zeros((10, 12, 12), bool)
        array[0:3, 0:4, 0:4] = True
        array[9, 5, 5] = True
        grid = libsf.Grid.from_array(array)
        finder, table = libsf.PathFinder(grid), libsf.PathMap(grid)
        path = finder.find((5, 5, 9))
        self.assertEqual((path.cost, path.end), (6, libsf.PathEnd.MATTER))
        self.assertEqual(len(path.voxels), 6)
        self.assertEqual(table.walk((5, 5, 9)).cost, 6)
        self.assertIsNone(libsf.PathFinder(grid, forbid=libsf.Grid.from_array(~array)).find((5, 5, 9)))
        dot = libsf.Grid.from_array(np.ones((1, 1, 1), bool))
        mended = libsf.emit(grid, path, dot)
        self.assertEqual(mended.report.added_voxels, 6)
        self.assertTrue(libsf.check(mended.grid).support_free)
        array[2] = False
        changed = libsf.Grid.from_array(array)
        grid.words[:] = changed.words
        finder.refresh()
        self.assertEqual(finder.find((5, 5, 9)).cost, 7)


class Certificates(unittest.TestCase):
    def test_a_certificate(self):
        array = np.zeros((4, 8, 8), bool)
        array[0, 2:6, 2:6] = array[1, 1:7, 1:7] = True
        before = array.copy()
        before[3, 0, 0] = True
        grid, raw = libsf.Grid.from_array(array), libsf.Grid.from_array(before)
        rule = libsf.Rule.named("box3")
        made = libsf.Certificate(libsf.trim(raw, rule).grid, rule, operation="trim", before=raw)
        self.assertEqual(made.operation, "trim")
        self.assertEqual(made.counts, {"input": 53, "output": 52, "added": 0, "removed": 1})
        self.assertEqual(made.output_sha256, libsf.sha256(grid))
        self.assertEqual([layer.solid for layer in made.layers], [16, 36, 0, 0])
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "part.json")
            made.save(path)
            with open(path, encoding="utf-8") as file:
                self.assertEqual(json.load(file)["output"]["sha256"], libsf.sha256(grid).hex())
        with self.assertRaisesRegex(libsf.InfeasibleError, "layer"):
            libsf.Certificate(raw, rule)


if __name__ == "__main__":
    unittest.main()
