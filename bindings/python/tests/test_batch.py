"""A folder of models: bad ones are results and stop nothing, a run that was stopped goes on."""

import json
import os
import tempfile
import unittest

import libsf
import libsf.batch
from test_mesh import box


ONE = libsf.batch.one


def dies_on_two(path, *given):
    if path.endswith("2.stl"):
        os._exit(9)
    return ONE(path, *given)


class Batch(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        os.mkdir(self.path("models"))
        for i in range(6):
            box(2 + i, 3, 4).save(self.path("models", f"{i}.stl"))
        with open(self.path("models", "bad.obj"), "w", encoding="ascii") as file:
            file.write("v 0 0\n")
        with open(self.path("models", "empty.stl"), "w", encoding="ascii"):
            pass
        with open(self.path("models", "readme.txt"), "w", encoding="ascii") as file:
            file.write("no model")

    def path(self, *parts):
        return os.path.join(self.folder.name, *parts)

    def run_all(self, **more):
        return list(libsf.batch.run(self.path("models"), self.path("report.jsonl"), resolution=16, **more))

    def test_bad_files_stop_nothing(self):
        shares = []
        results = {os.path.basename(r["file"]): r for r in self.run_all(workers=2, progress=shares.append)}
        self.assertEqual(len(results), 8)
        self.assertTrue(all(results[f"{i}.stl"]["support_free"] for i in range(6)))
        self.assertIn("error", results["bad.obj"])
        self.assertIn("error", results["empty.stl"])
        self.assertAlmostEqual(shares[-1], 1)

    def test_it_goes_on(self):
        some = []
        for result in libsf.batch.run(self.path("models"), self.path("report.jsonl"), resolution=16, workers=1):
            some.append(result["file"])
            if len(some) == 3:
                break
        with open(self.path("report.jsonl"), "a", encoding="utf-8") as file:
            file.write('{"file": "cut sho')  # a run that was killed
        with open(self.path("report.jsonl"), encoding="utf-8") as file:
            before = len(file.readlines())
        results = self.run_all(workers=1)
        self.assertEqual(len({r["file"] for r in results}), 8)
        with open(self.path("report.jsonl"), encoding="utf-8") as file:
            lines = file.readlines()
        self.assertEqual(len(lines), before + 8 - 3)
        box(9, 9, 9).save(self.path("models", "0.stl"))  # another file is looked at again
        self.run_all(workers=1)
        with open(self.path("report.jsonl"), encoding="utf-8") as file:
            self.assertEqual(json.loads(file.readlines()[-1])["size_mm"], [9, 9, 9])

    def test_repaired(self):
        top = libsf.Grid(libsf.Lattice(40, 40, 40, 0.5, 0.5))
        array = top.array()
        array[:30, 18:22, 18:22] = True
        array[30:36, 2:38, 2:38] = True
        top.set_array(array)
        libsf.surface(top).save(self.path("models", "table.stl"))
        results = {os.path.basename(r["file"]): r for r in self.run_all(workers=1, repaired=self.path("out"))}
        mended = results["table.stl"]
        self.assertFalse(mended["support_free"])
        grid = libsf.voxelize(libsf.Mesh.load(mended["repaired"]), pitch_mm=18 / 16)
        self.assertGreater(grid.count(), 0)
        self.assertEqual(os.listdir(self.path("out")), ["table.stl"])

    def test_names_are_kept_apart(self):
        leaning = libsf.Grid(libsf.Lattice(12, 12, 12, 1, 1))
        array = leaning.array()
        array[:8, :4], array[8:] = True, True
        leaning.set_array(array)
        mesh = libsf.surface(leaning)
        os.makedirs(self.path("models", "sub"))
        names = ["a.obj", "a.stl", "sub/a.stl", "A.STL", "a.obj.stl"]
        for name in names:
            mesh.save(self.path("models", name))
        made = {os.path.relpath(r["file"], self.path("models")): os.path.relpath(r["repaired"], self.path("out"))
                for r in self.run_all(workers=2, repaired=self.path("out")) if "repaired" in r}
        self.assertEqual(set(made), set(names))
        self.assertEqual(made["sub/a.stl"], "sub/a.stl")
        self.assertEqual(len({m.lower() for m in made.values()}), len(names))
        self.assertTrue(all(os.path.getsize(self.path("out", m)) > 84 for m in made.values()))

    def test_a_later_wish_for_repair(self):
        self.test_names_are_kept_apart()
        first = len(self.lines())
        os.remove(self.path("out", "sub", "a.stl"))  # one is missing: it alone is made again
        self.run_all(workers=1, repaired=self.path("out"))
        self.assertEqual(len(self.lines()), first + 1)
        self.assertTrue(os.path.exists(self.path("out", "sub", "a.stl")))
        self.run_all(workers=1, repaired=self.path("elsewhere"))
        self.assertTrue(os.path.exists(self.path("elsewhere", "sub", "a.stl")))

    def lines(self):
        with open(self.path("report.jsonl"), encoding="utf-8") as file:
            return file.readlines()

    def test_a_list_of_files(self):
        paths = [self.path("models", "0.stl"), self.path("models", "bad.obj")]
        results = list(libsf.batch.run(paths, self.path("report.jsonl"), resolution=16, workers=1,
                                       repaired=self.path("out")))
        self.assertEqual([r["file"] for r in results], paths)

    def test_a_worker_that_dies(self):
        before = libsf.batch.one
        libsf.batch.one = dies_on_two
        self.addCleanup(setattr, libsf.batch, "one", before)
        results = {os.path.basename(r["file"]): r for r in self.run_all(workers=2)}
        self.assertEqual(len(results), 8)
        self.assertIn("the worker failed", results["2.stl"]["error"])
        self.assertTrue(results["5.stl"]["support_free"])

    def test_a_cluster(self):
        try:
            from dask.distributed import Client, LocalCluster
        except ImportError:
            self.skipTest("dask.distributed is not there")
        with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
            results = self.run_all(client=client)
        self.assertEqual(len(results), 8)
        self.assertEqual(sum("error" in r for r in results), 2)


if __name__ == "__main__":
    unittest.main()
