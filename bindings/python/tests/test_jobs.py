"""Jobs of resin printers, against zipfile of Python's and bytes that are made by hand."""

import io
import os
import struct
import tempfile
import unittest
import zipfile

import numpy as np

import libsf


def photon(layers, pitch=0.05, height=0.1):
    """A .photon of bools (layer, y, x), row 0 the lowest."""
    nz, ny, nx = layers.shape
    runs = []
    for layer in layers:
        bits = layer[::-1].ravel()
        runs.append(bytes((128 if bit else 0) | 1 for bit in bits))  # a run for each pixel
    table, at = b"", 112 + 36 * nz
    for k, data in enumerate(runs):
        table += struct.pack("<3f2I4I", k * height, 1, 1, at, len(data), 0, 0, 0, 0)
        at += len(data)
    head = struct.pack("<2I3f", 0x12FD0019, 1, nx * pitch, ny * pitch, 100).ljust(0x20, b"\0")
    head += struct.pack("<f", height).ljust(0x14, b"\0") + struct.pack("<2I", nx, ny).ljust(12, b"\0")
    head += struct.pack("<2I", 112, nz)
    return head.ljust(112, b"\0") + table + b"".join(runs)


class Jobs(unittest.TestCase):
    def setUp(self):
        self.array = np.random.default_rng(9).random((4, 21, 67)) < 0.4

    def test_photon(self):
        with libsf.Job(photon(self.array)) as job:
            self.assertEqual(job.lattice.shape, (4, 21, 67))
            self.assertEqual((job.lattice.pitch_mm, job.lattice.layer_mm), ((0.05, 0.05), 0.1))
            self.assertEqual(job.info.format, libsf.JobFormat.PHOTON)
            for k, layer in enumerate(job):
                np.testing.assert_array_equal(layer.array(), self.array[k])
            np.testing.assert_array_equal(job.greys(-1), self.array[3] * np.uint8(255))
        with self.assertRaisesRegex(libsf.FormatError, "cut short|does not lie"):
            libsf.Job(photon(self.array)[:-5])

    def test_runs_and_bits_say_the_same(self):
        array = np.zeros((6, 20, 50), bool)
        for k in range(6):
            array[k, 5:15, 10 + k:30 + k] = True
        array[3:, 2, 2:4] = True
        reports = []
        for layer_runs in (0, 5, 1000):
            checker = libsf.Checker(50, 20, layer_runs=layer_runs)
            for layer in array:
                checker.push_runs(libsf.Layer.from_array(layer).runs())
            reports.append(checker.report().report)
        self.assertEqual(reports[0], reports[1])
        self.assertEqual(reports[0], reports[2])
        self.assertEqual(reports[0].unsupported_voxels, 2)

    def test_voids_as_layers_come(self):
        array = np.ones((5, 6, 6), bool)
        array[1:3, 2:4, 2:4] = array[3:, 1, 1] = False
        grid = libsf.Grid.from_array(array)
        search = libsf.VoidSearch(6, 6)
        for k in range(5):
            search.push(libsf.Layer.of(grid, k))
        found, whole = search.finish(), libsf.voids(grid)
        self.assertEqual(found.report, whole.report)
        self.assertEqual([v.vent_layer for v in found.voids], [v.vent_layer for v in whole.voids])
        self.assertEqual((found.report.trap_count, found.report.cup_count), (1, 1))

    @unittest.skipUnless(libsf.jobs_have_sl1(), "this build has no SL1")
    def test_sl1(self):
        grid = libsf.Grid.from_array(self.array, pitch_mm=(0.1, 0.2), layer_mm=0.05)
        file = io.BytesIO()
        libsf.save_sl1(grid, file, name="part", exposure_s=6)
        names = zipfile.ZipFile(file).namelist()
        self.assertEqual(names[2:], [f"part{k:05}.png" for k in range(4)])
        self.assertIn(b"expTime = 6\n", zipfile.ZipFile(file).read("config.ini"))
        with tempfile.TemporaryDirectory() as folder:
            path, fixed = os.path.join(folder, "job.sl1"), os.path.join(folder, "fixed.sl1")
            with open(path, "wb") as to:
                to.write(file.getvalue())
            with libsf.Job(path) as job:
                self.assertEqual(job.grid(), grid)
                changed = libsf.trim(grid, "box3").grid
                self.assertEqual(job.rewrite(grid, io.BytesIO()), 0)
                self.assertGreater(job.rewrite(changed, fixed), 0)
            with libsf.Job(fixed) as job:
                self.assertEqual(job.grid(), changed)
            before, after = zipfile.ZipFile(path), zipfile.ZipFile(fixed)
            self.assertIsNone(after.testzip())
            self.assertEqual(before.read("config.ini"), after.read("config.ini"))

    def test_a_job_is_of_a_path_or_bytes(self):
        for wrong in (10**12, io.BytesIO(b"no job"), [1, 2, 3], None):
            with self.assertRaisesRegex(TypeError, "path or bytes"):
                libsf.Job(wrong)

    def test_what_is_no_job(self):
        for data in (b"", b"PK", b"solid part", b"PK\5\6" + 18 * b"\0"):
            with self.assertRaises((libsf.FormatError, libsf.UnsupportedError)):
                libsf.Job(data)
        with self.assertRaises(libsf.ArgumentError):
            libsf.Job(photon(self.array), threshold=0)


if __name__ == "__main__":
    unittest.main()
