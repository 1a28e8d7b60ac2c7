"""Check or repair a folder of models: thousands of them, with progress, resumed after a stop.

    import libsf.batch
    for result in libsf.batch.run("models", "report.jsonl", rule="octagon", workers=8, progress=True):
        print(result["file"], result.get("support_free"), result.get("error"))

Each result is a line of JSON that is written as it comes, so a run that was stopped goes on where it
was. A file that cannot be read is a result with an `error`; one that brings a worker down is, too,
and none of them stops the rest. With `client=` the same work goes to a Dask cluster.
"""

from __future__ import annotations

import json
import os
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from typing import Any, Iterable, Iterator

from . import _core
from ._core import Progress

ENDINGS = (".stl", ".obj", ".ply", ".off")


def one(path: str, rule: str = "octagon", resolution: int = 128, repaired: str | None = None) -> dict[str, Any]:
    """One model: what a check finds at so many voxels along its longest side; and, where a folder
    is named, its repaired shape in that, under the same name."""
    from . import Error, Mesh, check, repair, surface, voxelize

    result: dict[str, Any] = {"file": path, "rule": rule, "resolution": resolution}
    try:
        mesh = Mesh.load(path)
        low, high = mesh.bounds()
        size = float((high - low).max())
        if not size > 0:
            return {**result, "error": "the mesh has no size"}
        grid = voxelize(mesh, pitch_mm=size / resolution)
        found = check(grid, rule)
        result.update(size_mm=(high - low).tolist(), support_free=found.support_free,
                      unsupported_voxels=found.report.unsupported_voxels,
                      trimmed_voxels=found.report.trimmed_voxels,
                      solid_voxels=found.report.solid_voxels)
        if repaired is not None and not found.support_free:
            mended = repair(grid, rule)
            name = os.path.join(repaired, os.path.splitext(os.path.basename(path))[0] + ".stl")
            surface(mended.grid).save(name)
            result.update(repaired=name, added_voxels=mended.report.added_voxels,
                          removed_voxels=mended.report.removed_voxels)
    except (Error, OSError, ValueError, MemoryError) as error:
        result["error"] = str(error)
    return result


def _stamp(path: str) -> list[Any]:
    """What tells whether a file is the one that was looked at."""
    try:
        facts = os.stat(path)
        return [facts.st_size, facts.st_mtime_ns]
    except OSError:
        return []


def _models(folder: str) -> list[str]:
    return sorted(os.path.join(root, name) for root, _, names in os.walk(folder) for name in names
                  if name.lower().endswith(ENDINGS))


def _done(report: str, asked: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """Results that are there already, of the same question; a line cut short is none."""
    found = {}
    if os.path.exists(report):
        with open(report, encoding="utf-8") as file:
            for line in file:
                try:
                    result = json.loads(line)
                except ValueError:
                    continue
                if all(result.get(k) == v for k, v in asked.items()):
                    found[result["file"]] = result
    return found


def run(models: str | Iterable[str], report: str, *, rule: str = "octagon", resolution: int = 128,
        repaired: str | None = None, workers: int | None = None, progress: Progress = None,
        client: Any = None) -> Iterator[dict[str, Any]]:
    """Results of a folder's models, or of a list of files, as they come; in `report` as well.

    Those that are in `report` already, of the same file and question, come first and are not
    computed again.
    """
    paths = _models(models) if isinstance(models, str) else list(models)
    asked = {"rule": rule, "resolution": resolution}
    before = {p: r for p, r in _done(report, asked).items() if r.get("stamp") == _stamp(p)}
    if repaired is not None:
        os.makedirs(repaired, exist_ok=True)
    call = _core._to_call(progress)
    left = [p for p in paths if p not in before]
    done = 0
    for path in paths:
        if path in before:
            done += 1
            yield before[path]
    given = (rule, resolution, repaired)
    results = _on_cluster(client, left, given) if client is not None else _here(left, given, workers)
    with open(report, "a", encoding="utf-8") as file:
        if file.tell() > 0 and not _ends_whole(report):
            file.write("\n")
        for result in results:
            result["stamp"] = _stamp(result["file"])
            file.write(json.dumps(result) + "\n")
            file.flush()
            done += 1
            if call is not None:
                call(done / max(len(paths), 1))
            yield result


def _ends_whole(report: str) -> bool:
    with open(report, "rb") as file:
        file.seek(-1, os.SEEK_END)
        return file.read(1) == b"\n"


def _on_cluster(client: Any, paths: list[str], given: tuple[Any, ...]) -> Iterator[dict[str, Any]]:
    from dask.distributed import as_completed

    asked = {client.submit(one, p, *given, retries=0, pure=False): p for p in paths}
    for future in as_completed(list(asked)):  # type: ignore[no-untyped-call, unused-ignore]
        error = future.exception()
        yield future.result() if error is None else _failed(asked[future], given, error)


def _failed(path: str, given: tuple[Any, ...], error: BaseException) -> dict[str, Any]:
    return {"file": path, "rule": given[0], "resolution": given[1], "error": f"the worker failed: {error}"}


def _here(paths: list[str], given: tuple[Any, ...], workers: int | None) -> Iterator[dict[str, Any]]:
    """A pool of processes. Where one dies, those that were under way are tried again one by one."""
    waiting = list(reversed(paths))
    count = workers or os.cpu_count() or 1
    while waiting:
        running: dict[Future[dict[str, Any]], str] = {}
        try:
            with ProcessPoolExecutor(count) as pool:
                while waiting or running:
                    while waiting and len(running) < 2 * count:
                        path = waiting.pop()
                        running[pool.submit(one, path, *given)] = path
                    for future in wait(running, return_when=FIRST_COMPLETED).done:
                        result = future.result()
                        del running[future]
                        yield result
        except BrokenProcessPool:
            for path in running.values():
                yield _alone(path, given)


def _alone(path: str, given: tuple[Any, ...]) -> dict[str, Any]:
    try:
        with ProcessPoolExecutor(1) as pool:
            return pool.submit(one, path, *given).result()
    except BrokenProcessPool as error:
        return _failed(path, given, error)
