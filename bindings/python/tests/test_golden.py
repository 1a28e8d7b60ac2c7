"""The golden vectors that C, Python and Rust share (tests/golden/make.py)."""

import json
import os
import unittest

import numpy as np

import libsf

PATH = os.path.join(os.path.dirname(__file__), "..", "..", "..", "tests", "golden", "box3.json")


class Golden(unittest.TestCase):
    def test_all_cases(self):
        with open(PATH, encoding="ascii") as file:
            cases = json.load(file)["cases"]
        self.assertEqual(len(cases), 45)
        for case in cases:
            nx, ny, nz = case["size"]

            def array(key):
                return (np.array(list(case[key])) == "1").reshape(nz, ny, nx)

            grid = libsf.Grid.from_array(array("voxels"))
            b = grid.bounds()
            self.assertEqual(grid.count(), case["count"])
            self.assertEqual([b.x0, b.y0, b.z0, b.x1, b.y1, b.z1], case["bounds"])
            trimmed, report = libsf.trim(grid, bed_layer=0)
            np.testing.assert_array_equal(trimmed.array(), array("trimmed"))
            self.assertEqual(report.kept_voxels, case["kept"])
            np.testing.assert_array_equal(libsf.unsupported(grid, bed_layer=0).array(), array("unsupported"))


if __name__ == "__main__":
    unittest.main()
