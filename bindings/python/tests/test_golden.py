"""The golden vectors that C, Python and Rust share (tests/golden/make.py)."""

import json
import os
import unittest

import numpy as np

import libsf

FOLDER = os.path.join(os.path.dirname(__file__), "..", "..", "..", "tests", "golden")


def cases_of(name):
    with open(os.path.join(FOLDER, name), encoding="ascii") as file:
        return json.load(file)["cases"]


class Golden(unittest.TestCase):
    def test_all_cases(self):
        cases = cases_of("box3.json")
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

    def test_all_bodies(self):
        cases = cases_of("tetrahedra.json")
        self.assertEqual(len(cases), 39)
        for case in cases:
            mesh = libsf.Mesh(np.array(case["vertices"], float), case["triangles"])
            mass = mesh.measure()
            np.testing.assert_allclose(mass.volume_mm3, case["volume_mm3"], rtol=1e-12)
            np.testing.assert_allclose(mass.com_mm, case["com_mm"], atol=1e-12)
            np.testing.assert_allclose(mass.inertia_mm5, case["inertia_mm5"], atol=1e-9)
            margin = libsf.Stance(mesh).judge(mass.com_mm).margin_rad
            self.assertAlmostEqual(margin, case["margin_rad"], 12)


if __name__ == "__main__":
    unittest.main()
