"""The laws of checking, trimming, growing and preserving, through Python, on shapes that Hypothesis
thinks of; and check and trim against a few lines of numpy that share no code with the library."""

import unittest

import numpy as np

import libsf

try:
    from hypothesis import given, settings
    from hypothesis import strategies as st
    from hypothesis.extra import numpy as hnp
except ImportError:
    raise unittest.SkipTest("hypothesis is not there") from None

shapes = hnp.arrays(np.bool_, st.tuples(st.integers(1, 6), st.integers(1, 7), st.integers(1, 9)))
rules = st.sampled_from(["box3", "octagon", "disk", "slack"])
quick = settings(max_examples=60, deadline=None)


def carried(below):
    """Which voxels of a layer the nine below carry: box3."""
    padded = np.pad(below, 1)
    ny, nx = below.shape
    return np.any([padded[j:j + ny, i:i + nx] for j in range(3) for i in range(3)], axis=0)


def trimmed(array):
    result = array.copy()
    layers = np.flatnonzero(array.any(axis=(1, 2)))
    for k in range(layers[0] + 1 if layers.size else 0, len(array)):
        result[k] &= carried(result[k - 1])
    return result


class Laws(unittest.TestCase):
    @quick
    @given(shapes)
    def test_trim_is_what_numpy_says(self, array):
        result, report = libsf.trim(libsf.Grid.from_array(array))
        np.testing.assert_array_equal(result.array(), trimmed(array))
        self.assertEqual(report.kept_voxels, trimmed(array).sum())
        self.assertEqual(report.kept_voxels + report.removed_voxels, array.sum())

    @quick
    @given(shapes, rules)
    def test_trim(self, array, rule):
        grid = libsf.Grid.from_array(array)
        once = libsf.trim(grid, rule).grid
        self.assertTrue(libsf.check(once, rule))
        self.assertEqual(libsf.trim(once, rule).grid, once)  # idempotent
        self.assertEqual(once - grid, libsf.Grid(grid.lattice))  # within
        self.assertEqual(bool(libsf.check(grid, rule)), once == grid)
        self.assertEqual(libsf.check(grid, rule).report.trimmed_voxels, (grid - once).count())

    @quick
    @given(shapes, shapes, rules)
    def test_trim_is_monotone(self, a, b, rule):
        shape = tuple(min(n, m) for n, m in zip(a.shape, b.shape))
        cut = tuple(slice(0, n) for n in shape)
        large = libsf.Grid.from_array(np.ascontiguousarray(a[cut] | b[cut]))
        small = libsf.Grid.from_array(np.ascontiguousarray(a[cut]))
        less = libsf.trim(small, rule, bed_layer=0).grid
        self.assertEqual((less - libsf.trim(large, rule, bed_layer=0).grid).count(), 0)

    @quick
    @given(shapes, rules)
    def test_grow(self, array, rule):
        grid = libsf.Grid.from_array(array)
        result, report = libsf.grow(grid, rule, bed_layer=0)
        self.assertTrue(libsf.check(result, rule, bed_layer=0))
        self.assertEqual((grid - result).count(), 0)
        self.assertEqual(report.added_voxels, (result - grid).count())

    @quick
    @given(shapes, rules)
    def test_repair(self, array, rule):
        grid = libsf.Grid.from_array(array)
        result, report = libsf.repair(grid, rule, bed_layer=0)
        self.assertTrue(libsf.check(result, rule, bed_layer=0))
        self.assertEqual(report.added_voxels, (result - grid).count())
        self.assertEqual(report.removed_voxels, (grid - result).count())

    @quick
    @given(shapes, rules, st.randoms(use_true_random=False))
    def test_preserve(self, array, rule, random):
        grid = libsf.trim(libsf.Grid.from_array(array), rule, bed_layer=0).grid
        mask = np.array([random.random() < 0.4 for _ in range(array.size)]).reshape(array.shape)
        brush = libsf.Grid.from_array(mask)
        result, _ = libsf.preserve(grid, brush, rule, bed_layer=0)
        self.assertTrue(libsf.check(result, rule, bed_layer=0))
        self.assertEqual(result - brush, grid - brush)  # outside the brush nothing changes
        self.assertEqual((result - grid).count(), 0)

    @quick
    @given(shapes, rules)
    def test_layers_one_by_one(self, array, rule):
        whole = libsf.check(libsf.Grid.from_array(array), rule)
        nz, ny, nx = array.shape
        checker = libsf.Checker(nx, ny, rule)
        greys = libsf.Checker(nx, ny, rule)
        for layer in array:
            checker.push(layer)
            greys.push((layer * 200).astype(np.uint8), threshold=128)
        for each in (checker.report(), greys.report()):
            self.assertEqual(each.report.unsupported_voxels, whole.report.unsupported_voxels)
            self.assertEqual(each.support_free, whole.support_free)
            self.assertEqual(len(each.findings), len(whole.findings))

    def test_unsupported_voxels_are_those_that_nothing_carries(self):
        array = np.zeros((3, 5, 5), bool)
        array[0, 0, 0] = array[1, 3, 3] = array[2, 3, 4] = True
        found = libsf.unsupported(libsf.Grid.from_array(array)).array()
        self.assertEqual(np.argwhere(found).tolist(), [[1, 3, 3]])
        checked = libsf.check(libsf.Grid.from_array(array))
        self.assertFalse(checked)
        self.assertEqual(checked.report.trimmed_voxels, 2)
        self.assertEqual((checked.findings[0].layer, checked.findings[0].box.x0), (1, 3))


if __name__ == "__main__":
    unittest.main()
