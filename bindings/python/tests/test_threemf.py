"""3MF files: what is written comes back, and another reader agrees where there is one."""

import io
import os
import unittest
import zipfile

import numpy as np

import libsf

CORNER = libsf.Mesh([[0, 0, 0], [3, 0, 0], [0, 3, 0], [0, 0, 3]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


def saved(*args, **kwargs):
    to = io.BytesIO()
    libsf.save_threemf(to, *args, **kwargs)
    return to.getvalue()


@unittest.skipUnless(libsf.threemf_is_served(), "this build has no 3MF")
class ThreeMF(unittest.TestCase):
    def test_a_mesh_is_saved_and_loaded_by_its_name(self):
        path = "threemf_test.3mf"
        CORNER.save(path)
        self.addCleanup(os.remove, path)
        back = libsf.Mesh.load(path)
        np.testing.assert_array_equal(back.vertices, CORNER.vertices)
        np.testing.assert_array_equal(back.faces, CORNER.faces)
        to = io.BytesIO()
        CORNER.save(to, "3mf")
        self.assertEqual(to.getvalue(), open(path, "rb").read())

    def test_parts_colors_and_places_come_back(self):
        colors = [libsf.Color((1, 2, 3, 255), "steel & more"), libsf.Color((9, 8, 7, 255), "gum"),
                  libsf.Color((255, 0, 0, 128), group=1)]
        parts = [libsf.Part(CORNER, "one", colors=[[0] * 3, [1] * 3, [-1] * 3, [0] * 3]),
                 libsf.Part(CORNER, colors=np.full((4, 3), 2))]
        matrix = np.array([[0, -2, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1.0]])
        file = libsf.ThreeMF.load(saved(parts, build=[libsf.Placed(0, np.eye(4)), libsf.Placed(1, matrix)],
                                        colors=colors))
        self.assertEqual(file.colors, colors)
        self.assertEqual([p.name for p in file.parts], ["one", ""])
        np.testing.assert_array_equal(file.parts[0].colors, parts[0].colors)
        np.testing.assert_array_equal(file.parts[1].colors, parts[1].colors)
        np.testing.assert_array_equal(file.build[1].matrix, matrix)
        self.assertAlmostEqual(file.merged().measure().volume_mm3, 4.5 + 9, 9)
        self.assertFalse(file.is_sliced)
        with self.assertRaisesRegex(libsf.FormatError, "no slices"):
            file.contours()

    def test_a_part_is_filled(self):
        lattice = libsf.Lattice(5, 4, 3, pitch_mm=1.0, layer_mm=1.5)
        asked = []

        def layer(k):
            asked.append(k)
            return np.stack([np.full((4, 5), k / 2.0), np.tile(np.linspace(10, 30, 5), (4, 1))])

        data = saved([CORNER], filling=libsf.Filling(lattice, [("rises", 0, 1), ("along x", 10, 30)], layer))
        self.assertEqual(asked, [0, 1, 2])
        names = zipfile.ZipFile(io.BytesIO(data)).namelist()
        self.assertIn("3D/volume_1_00002.png", names)
        self.assertEqual(libsf.ThreeMF.load(data).merged().measure().volume_mm3, 4.5)
        with self.assertRaisesRegex(ValueError, "shape"):
            saved([CORNER], filling=libsf.Filling(lattice, [("a", 0, 1)], lambda k: np.zeros((1, 2, 2))))
        with self.assertRaises(ZeroDivisionError):
            saved([CORNER], filling=libsf.Filling(lattice, [("a", 0, 1)], lambda k: 1 // 0))

    def test_what_is_no_number_no_color_no_place_is_refused(self):
        lattice, shades = libsf.Lattice(2, 2, 2), [libsf.Color((0, 0, 0, 0))]
        with self.assertRaisesRegex(ValueError, "layer 0: it holds what is no number"):
            saved([CORNER], filling=libsf.Filling(lattice, [("a", 0, 1)], lambda k: np.full((1, 2, 2), np.nan)))
        with self.assertRaisesRegex(TypeError, "integers"):
            saved([libsf.Part(CORNER, colors=np.full((4, 3), 0.9))], colors=shades)
        for matrix in (np.eye(3), np.diag([1, 1, 1, 2.0])):
            with self.assertRaisesRegex(ValueError, "4 x 4"):
                saved([CORNER], build=[libsf.Placed(0, matrix)])

    def test_what_cannot_be_is_refused(self):
        with self.assertRaisesRegex(libsf.FormatError, "3MF"):
            libsf.ThreeMF.load(b"PK\x03\x04 and no more")
        with self.assertRaisesRegex(ValueError, "colors"):
            saved([libsf.Part(CORNER, colors=[[5] * 3] * 4)], colors=[libsf.Color((0, 0, 0, 0))])
        with self.assertRaisesRegex(libsf.ArgumentError, "no items"):
            saved([CORNER], build=[])
        with self.assertRaisesRegex(libsf.ArgumentError, "PNG"):
            saved([CORNER], thumbnail=b"no picture")
        with self.assertRaises(libsf.TooLargeError):
            libsf.ThreeMF.load(saved([CORNER]), triangles_max=3)

    def test_trimesh_reads_the_same(self):
        try:
            import lxml  # noqa: F401
            import networkx  # noqa: F401
            import trimesh
        except ImportError:
            self.skipTest("trimesh, networkx or lxml is not installed")
        mesh = libsf.surface(libsf.Grid.from_array(np.random.default_rng(2).random((9, 10, 11)) < 0.6))
        loaded = trimesh.load(io.BytesIO(saved([mesh])), file_type="3mf", force="mesh")
        self.assertAlmostEqual(loaded.volume, mesh.measure().volume_mm3, 6)

    def test_lib3mf_reads_the_same(self):
        try:
            import lib3mf
        except ImportError:
            self.skipTest("lib3mf is not installed")
        mesh = libsf.surface(libsf.Grid.from_array(np.random.default_rng(3).random((9, 10, 11)) < 0.6))
        lattice = libsf.Lattice(11, 10, 9)
        filling = libsf.Filling(lattice, [("share", 0, 2)], lambda k: np.full((1, 10, 11), k / 8.0))
        wrapper = lib3mf.get_wrapper() if hasattr(lib3mf, "get_wrapper") else lib3mf.Wrapper(
            os.path.join(os.path.dirname(lib3mf.__file__), "lib3mf"))
        model = wrapper.CreateModel()
        reader = model.QueryReader("3mf")
        reader.SetStrictModeActive(True)
        reader.ReadFromBuffer(saved([mesh]))
        self.assertEqual(reader.GetWarningCount(), 0)
        found = model.GetMeshObjects()
        self.assertTrue(found.MoveNext())
        thing = found.GetCurrentMeshObject()
        self.assertTrue(thing.IsManifoldAndOriented())
        points = np.array([list(p.Coordinates) for p in thing.GetVertices()])
        faces = np.array([list(t.Indices) for t in thing.GetTriangleIndices()])
        self.assertAlmostEqual(libsf.Mesh(points, faces).measure().volume_mm3, mesh.measure().volume_mm3, 3)
        model = wrapper.CreateModel()
        model.QueryReader("3mf").ReadFromBuffer(saved([mesh], filling=filling))
        found = model.GetMeshObjects()
        found.MoveNext()
        volume = found.GetCurrentMeshObject().GetVolumeData()
        self.assertEqual(volume.GetPropertyCount(), 1)
        self.assertEqual(volume.GetProperty(0).GetName(), "libsf:p0_share")


if __name__ == "__main__":
    unittest.main()
