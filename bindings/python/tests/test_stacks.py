"""Bytes in and out: files, bytes and file objects; layers of materials; sessions; exchange files."""

import io
import os
import pathlib
import tempfile
import unittest

import numpy as np

import libsf

from test_grading import graded
from test_mesh import box


class Broken(io.BytesIO):
    def read(self, size=-1):
        raise PermissionError("not today")

    def write(self, data):
        raise PermissionError("not today")


class Streams(unittest.TestCase):
    def test_bytes_and_file_objects(self):
        memory = io.BytesIO()
        box(2, 3, 5).save(memory, "ply")
        data = memory.getvalue()
        memory.seek(0)
        for of in (data, bytearray(data), memoryview(data), memory):
            self.assertAlmostEqual(libsf.Mesh.load(of).measure().volume_mm3, 30)
        with self.assertRaises(libsf.TooLargeError):
            libsf.Mesh.load(data, triangles_max=3)
        with self.assertRaises(TypeError):
            libsf.Mesh.load(7)
        with self.assertRaises(ValueError):
            box(1, 1, 1).save(memory)

    def test_what_a_file_raises(self):
        with self.assertRaises(PermissionError):
            libsf.Mesh.load(Broken())
        with self.assertRaises(PermissionError):
            box(1, 1, 1).save(Broken(), "stl")
        with self.assertRaises(PermissionError):
            libsf.Cage.load(Broken())

    def test_raw_files_get_all_of_it(self):
        class Raw(io.RawIOBase):
            """Takes a few bytes at a time, as pipes and sockets may."""

            def __init__(self, answers):
                super().__init__()
                self.data, self.answers = b"", answers

            def writable(self):
                return True

            def write(self, data):
                taken = self.answers(len(data))
                self.data += bytes(data[:taken or 0])
                return taken

        whole = io.BytesIO()
        box(2, 3, 5).save(whole, "stl")
        raw = Raw(lambda size: min(size, 7))
        box(2, 3, 5).save(raw, "stl")
        self.assertEqual(raw.data, whole.getvalue())
        for answers, error in ((lambda size: None, BlockingIOError), (lambda size: 0, OSError),
                               (lambda size: size + 1, OSError)):
            with self.assertRaises(error):
                box(2, 3, 5).save(Raw(answers), "stl")

    def test_nothing_is_left_half_written(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "part.ply")
            box(1, 1, 1).save(path)
            before = pathlib.Path(path).read_bytes()
            with self.assertRaises(KeyboardInterrupt):
                with libsf._files.sink(path) as sink:
                    self.assertEqual(sink.write(sink.user, b"half a part", 11), 0)
                    raise KeyboardInterrupt
            self.assertEqual(pathlib.Path(path).read_bytes(), before)
            self.assertEqual(os.listdir(folder), ["part.ply"])


class Materials(unittest.TestCase):
    def test_layers_and_their_use(self):
        if not libsf.stacks_are_png():
            self.skipTest("this build has no PNG")
        lattice = libsf.Lattice(40, 30, 6, (0.05, 0.05), 0.1)
        tone = np.tile(np.linspace(0, 1, 40, dtype=np.float32), (30, 1))
        ids = [libsf.halftone(tone, layer=k) for k in range(6)]
        counts = np.array([[(i == m + 1).sum() for m in range(2)] for i in ids], np.uint64)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "stack")
            soft, hard = libsf.Material("soft", (255, 200, 0), 1.1), libsf.Material("hard", (30, 30, 30), 1.2)
            uses = libsf.save_materials(iter(ids), path, lattice, [soft, hard])
            self.assertEqual([u.voxels for u in uses], list(counts.sum(axis=0)))
            self.assertEqual(uses, libsf.material_uses(lattice, counts, [1.1, 1.2]))
            self.assertEqual(libsf.load_stack(path).grid.count(), 40 * 30 * 6)
            with self.assertRaises(libsf.ArgumentError):
                libsf.save_materials(iter(ids[:5]), path + "2", lattice, [soft, hard])
            self.assertFalse(os.path.exists(path + "2"))
            picture = io.BytesIO()
            libsf.save_picture(np.zeros((4, 5, 3), np.uint8), picture)
            self.assertEqual(picture.getvalue()[:8], b"\x89PNG\r\n\x1a\n")

    def test_diffusion_keeps_the_sum(self):
        diffuser = libsf.Diffuser(64, 64, 2)
        found = [diffuser.push(np.full((64, 64), 0.3, np.float32)) for _ in range(8)]
        share = np.mean([ids == 2 for ids in found])
        self.assertAlmostEqual(share, 0.3, delta=0.005)
        second = diffuser.report()[1]
        self.assertAlmostEqual(second.asked, 0.3 * 64 * 64 * 8, delta=0.01)
        self.assertAlmostEqual(second.asked, second.placed + second.dropped + second.carried, delta=1e-3)

    def test_shells_keep_a_material_off(self):
        lattice = libsf.Lattice(24, 24, 24, 1, 1, (-2, -2, -2))
        shell = libsf.Shell(box(20, 20, 20), lattice, 1.0)
        self.assertEqual(len(shell), 24)
        solid = libsf.voxelize(box(20, 20, 20), lattice)
        near = shell[12]
        ids = libsf.halftone(np.full((24, 24), 0.5, np.float32), solid=libsf.Layer.of(solid, 12),
                             keep_outs=[(near, 1, 0)])
        self.assertFalse(((ids == 2) & near.array()).any())
        self.assertTrue((ids == 2).any())
        # Of each layer deep inside, all is shell but what lies two voxels and more within.
        self.assertEqual(int((near.array() & libsf.Layer.of(solid, 12).array()).sum()), 20**2 - 16**2)

    def test_masks_of_ranks(self):
        ranks = libsf.Mask.create((4, 4, 4), seed=3).ranks()
        np.testing.assert_array_equal(libsf.Mask.of(ranks).ranks(), ranks)
        with self.assertRaises(libsf.FormatError):
            libsf.Mask.of(np.zeros((4, 4, 4), np.uint32))


class Sessions(unittest.TestCase):
    def made(self):
        session = libsf.Session(libsf.Lattice(48, 48, 48, 0.5, 0.5))
        ball, dot = session.add_tip("sphere", 8), session.add_mask(libsf.Grid.from_array(np.ones((3, 3, 3), bool)))
        session.stroke("add-trim", ball, [(24, 24, 4)])
        session.stroke("add-grow", dot, [(30, 24, 30)], material=2)
        session.step("undo")
        session.step("redo")
        return session

    def test_played_and_written(self):
        session = self.made()
        self.assertEqual((len(session), session.counts.tips, session.counts.strokes), (4, 2, 2))
        self.assertEqual(session[1].kind, libsf.BrushKind.ADD_GROW)
        np.testing.assert_array_equal(session[1].dabs, [(30, 24, 30)])
        self.assertIsNone(session[2])
        self.assertEqual(session.tip_mask(1).count(), 27)
        model = session.replay()
        by_steps = session.begin()
        for step in range(len(session)):
            session.play(step, by_steps)
        self.assertEqual(by_steps.printable(), model.printable())
        self.assertTrue(libsf.check(model.printable(), bed_layer=0).support_free)
        session.keep_state(model)
        memory = io.BytesIO()
        session.save(memory)
        again = libsf.Session.load(memory.getvalue())
        self.assertEqual(again.open().printable(), model.printable())
        np.testing.assert_array_equal(again.replay().materials, model.materials)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "model.session")
            again.save(path)
            self.assertEqual(pathlib.Path(path).read_bytes(), memory.getvalue())
            self.assertEqual(libsf.Sculpt.replay(path).printable(), model.printable())
        with self.assertRaises(libsf.FormatError):
            libsf.Session.load(b"no session")

    def test_strokes_that_grow(self):
        lattice = libsf.Lattice(48, 48, 48)
        tip = libsf.Tip.shaped("sphere", 6)
        grid, anchor = tip.mask()
        self.assertEqual((grid.shape, anchor), ((13, 13, 13), (6, 6, 6)))
        whole, parts = libsf.Sculpt(lattice), libsf.Sculpt(lattice)
        path = libsf.Sculpt.line((10, 24, 3), (36, 24, 12))
        whole.stroke("add-trim", tip, path)
        with parts.stroking("add-trim", tip) as dab:
            for place in path:
                dab([place])
        self.assertEqual(parts.printable(), whole.printable())
        self.assertEqual(parts.history.undo_count, 1)
        with self.assertRaises(KeyError):
            with parts.stroking("remove-trim", tip) as dab:
                dab(path)
                raise KeyError
        self.assertEqual(parts.printable(), whole.printable())
        self.assertEqual(libsf.brush_name(libsf.BrushKind.SMOOTH_TRIM), "smooth-trim")
        ghostly = libsf.Sculpt(lattice, keep_drawn=True)
        ghostly.stroke("add-trim", tip, [(24, 24, 30)])
        self.assertGreater(ghostly.drawn().count(), 0)
        ghostly.drop_ghosts()
        self.assertEqual(ghostly.drawn().count(), 0)


class Exchanged(unittest.TestCase):
    def tets(self):
        cage = graded()
        cage.add_property(libsf.known_property("density"), np.linspace(900, 1200, 45))
        return cage, cage.refined(2).tets(2)

    def test_the_library_and_h5py_write_the_same(self):
        try:
            import h5py
        except ImportError:
            self.skipTest("h5py is not there")
        from libsf import _exchange
        from libsf._sf import lib

        _, tets = self.tets()
        ways = [(_exchange.save, _exchange.load)]
        if lib.sf_exchange_is_served():
            ways.append((libsf.Tets.save, libsf.Tets.load))
        files = []
        for save, _ in ways:
            memory = io.BytesIO()
            save(tets, memory)
            files.append(memory.getvalue())
        for data in files:
            for _, load in ways:
                again = load(data)
                np.testing.assert_array_equal(again.points, tets.points)
                np.testing.assert_array_equal(again.corners, tets.corners)
                self.assertEqual({n: c.property for n, c in again.channels().items()},
                                 {n: c.property for n, c in tets.channels().items()})
                for name, channel in tets.channels().items():
                    at = tets.corners if channel.indices is None else channel.indices
                    other = again.channels()[name]
                    to = again.corners if other.indices is None else other.indices
                    np.testing.assert_array_equal(other.values[to], channel.values[at])
        with h5py.File(io.BytesIO(files[0])) as ours, h5py.File(io.BytesIO(files[-1])) as theirs:
            for key, group in theirs["properties"].items():
                self.assertEqual(ours["properties"][key].attrs["unit"], group.attrs["unit"])
        for data in (b"nothing", files[0][:200]):
            for _, load in ways:
                with self.assertRaises(libsf.Error):
                    load(data)

    def test_tetrahedra(self):
        cage, tets = self.tets()
        report = tets.check()
        self.assertEqual((report.inverted, report.crowded_faces), (0, 0))
        own = libsf.Tets(np.array(tets.points), np.array(tets.corners), list(tets.channels().values()))
        self.assertEqual(own.check(), report)
        self.assertEqual(list(own.channels()), list(tets.channels()))
        lattice = libsf.Lattice(40, 20, 20, 0.1, 0.1)
        sampler = libsf.Sampler.of_tets(own, lattice, ["tone"])
        middle = sampler[10]
        self.assertTrue(middle.solid[10, 20])
        self.assertAlmostEqual(middle.values["tone"][10, 20], 2.05 / 4, places=2)
        self.assertGreater(sampler.report().solid, 0)
        own.set_values("tone", np.zeros(len(own.channels()["tone"].values)))
        with self.assertRaisesRegex(RuntimeError, "changed"):
            sampler[0]
        with self.assertRaises(libsf.UnsupportedError):
            tets.set_values("tone", np.zeros(3))


if __name__ == "__main__":
    unittest.main()
