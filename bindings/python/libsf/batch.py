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
from typing import Any, Iterable, Iterator, Optional, Tuple

from . import _core
from ._core import Progress

ENDINGS = (".stl", ".obj", ".ply", ".off", ".3mf")
Work = Tuple[str, str, int, Optional[str]]  # what one() takes


def one(path: str, rule: str = "octagon", resolution: int = 128, repaired: str | None = None) -> dict[str, Any]:
    """One model: what a check finds at so many voxels along its longest side; and, where a file is
    named, its repaired shape in that."""
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
            os.makedirs(os.path.dirname(repaired) or ".", exist_ok=True)
            surface(mended.grid).save(repaired)
            result.update(repaired=repaired, added_voxels=mended.report.added_voxels,
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


def _targets(paths: list[str], base: str, folder: str | None) -> dict[str, str | None]:
    """Where each repaired shape goes: its place under `base` is its place in the folder. No two
    share a file, not even where capitals do not count."""
    if folder is None:
        return dict.fromkeys(paths)
    targets: dict[str, str | None] = {}
    taken = set()
    for path in paths:
        name = os.path.relpath(path, base)
        while not name.lower().endswith(".stl") or name.lower() in taken:
            name += ".stl"
        taken.add(name.lower())
        targets[path] = os.path.join(folder, name)
    return targets


def _is_settled(result: dict[str, Any], target: str | None) -> bool:
    """Whether a result of an earlier run says all that is asked now."""
    if result.get("stamp") != _stamp(result["file"]):
        return False
    if target is None or result.get("support_free") or "error" in result:
        return True
    return result.get("repaired") == target and os.path.exists(target)


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
    computed again. Repaired shapes are STL files in the folder `repaired`, each where its model is
    in the folder of models.
    """
    paths = _models(models) if isinstance(models, str) else list(models)
    asked = {"rule": rule, "resolution": resolution}
    base = models if isinstance(models, str) else _common(paths)
    targets = _targets(paths, base, repaired)
    before = {p: r for p, r in _done(report, asked).items() if p in targets and _is_settled(r, targets[p])}
    call = _core._to_call(progress)
    left = [p for p in paths if p not in before]
    done = 0
    for path in paths:
        if path in before:
            done += 1
            yield before[path]
    work = [(p, rule, resolution, targets[p]) for p in left]
    results = _on_cluster(client, work) if client is not None else _here(work, workers)
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


def _common(paths: list[str]) -> str:
    """The folder that holds all files of a list."""
    folders = [os.path.dirname(os.path.abspath(p)) for p in paths]
    try:
        return os.path.commonpath(folders)
    except ValueError:  # none, or on several drives
        return os.curdir


def _on_cluster(client: Any, work: list[Work]) -> Iterator[dict[str, Any]]:
    from dask.distributed import as_completed

    asked = {client.submit(one, *given, retries=0, pure=False): given for given in work}
    for future in as_completed(list(asked)):  # type: ignore[no-untyped-call, unused-ignore]
        error = future.exception()
        yield future.result() if error is None else _failed(asked[future], error)


def _failed(given: Work, error: BaseException) -> dict[str, Any]:
    return {"file": given[0], "rule": given[1], "resolution": given[2], "error": f"the worker failed: {error}"}


def _here(work: list[Work], workers: int | None) -> Iterator[dict[str, Any]]:
    """A pool of processes. Where one dies, those that were under way are tried again one by one."""
    waiting = list(reversed(work))
    count = workers or os.cpu_count() or 1
    while waiting:
        running: dict[Future[dict[str, Any]], Work] = {}
        try:
            with ProcessPoolExecutor(count) as pool:
                while waiting or running:
                    while waiting and len(running) < 2 * count:
                        running[pool.submit(one, *waiting[-1])] = waiting[-1]
                        waiting.pop()
                    for future in wait(running, return_when=FIRST_COMPLETED).done:
                        result = future.result()
                        del running[future]
                        yield result
        except BrokenProcessPool:
            for given in running.values():
                yield _alone(given)


def _alone(given: Work) -> dict[str, Any]:
    try:
        with ProcessPoolExecutor(1) as pool:
            return pool.submit(one, *given).result()
    except BrokenProcessPool as error:
        return _failed(given, error)
