"""Supporting paths: what to fill so that a voxel is carried, and a brush along it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Sequence

import numpy as np
import numpy.typing as npt

from . import _core, _types
from ._core import Progress, documented, ffi, lib, ok, running
from ._types import Landing, PathCost, PathEnd
from .support import AnyRule, _terms
from .voxel import Grid

Voxels = npt.NDArray[np.uint32]


@dataclass(frozen=True)
class Path:
    """Voxels (n, 3) from the top down, x, y and layer of each; and what the last of them ends on."""

    voxels: Voxels
    end: PathEnd
    landing: _types.Voxel
    cost: int
    bed_square: int


def _found(grid: Grid, at: Sequence[int], ask: Any) -> Path | None:
    """The path that a finder or a map knows of; None where there is none."""
    x, y, z = (int(i) for i in at)
    voxels, found = np.empty((grid.shape[0], 3), np.uint32), ffi.new("sf_path *")
    status = ask({"x": x, "y": y, "z": z}, ffi.cast("sf_voxel *", ffi.from_buffer(voxels)), len(voxels), found)
    if status == int(_types.Status.ERR_INFEASIBLE):
        return None
    ok(status)
    return Path(voxels[:found.count].copy(), PathEnd(found.end), _core.value(found.landing),
                found.cost, found.bed_square)


class PathFinder:
    """Finds the closest supporting path of a voxel in a grid as it is when it is asked."""

    @documented("sf_path_finder_create")
    def __init__(self, grid: Grid, rule: AnyRule = "box3", *, bed_layer: int | None = None,
                 exempt: Grid | None = None, forbid: Grid | None = None, act: Grid | None = None,
                 landing: Landing = Landing.ANY, progress: Progress = None) -> None:
        self._grid, self._terms = grid, _terms(grid, rule, bed_layer, exempt, None, forbid, act)
        made = ffi.new("sf_path_finder **")
        with running(progress) as task:
            ok(lib.sf_path_finder_create(grid._c, self._terms.c, int(landing), ffi.NULL, task, made))
        self._c = ffi.gc(made[0], lib.sf_path_finder_destroy)

    @documented("sf_path_finder_refresh")
    def refresh(self, progress: Progress = None) -> None:
        """Look at the grid anew: needed where only living matter is landed on, or under slack."""
        with running(progress) as task:
            ok(lib.sf_path_finder_refresh(self._c, task))

    @documented("sf_path_finder_find")
    def find(self, at: Sequence[int]) -> Path | None:
        """The path of a voxel (x, y, layer); None where there is none."""
        return _found(self._grid, at, lambda *more: lib.sf_path_finder_find(self._c, *more))


class PathMap:
    """Knows the paths of all voxels of a grid, which must not change meanwhile."""

    @documented("sf_path_map_create")
    def __init__(self, grid: Grid, rule: AnyRule = "box3", *, bed_layer: int | None = None,
                 exempt: Grid | None = None, forbid: Grid | None = None, act: Grid | None = None,
                 landing: Landing = Landing.ANY, cost: PathCost | None = None,
                 progress: Progress = None) -> None:
        self._grid, self._terms = grid, _terms(grid, rule, bed_layer, exempt, None, forbid, act)
        options = _core.options("sf_path_map_options", landing=int(landing),
                                cost=None if cost is None else int(cost))
        made = ffi.new("sf_path_map **")
        with running(progress) as task:
            ok(lib.sf_path_map_create(grid._c, self._terms.c, options, ffi.NULL, task, made))
        self._c = ffi.gc(made[0], lib.sf_path_map_destroy)

    @documented("sf_path_map_walk")
    def walk(self, at: Sequence[int]) -> Path | None:
        """The path of a voxel (x, y, layer); None where there is none."""
        return _found(self._grid, at, lambda *more: lib.sf_path_map_walk(self._c, *more))


@dataclass(frozen=True)
class Emitted:
    grid: Grid
    report: _types.EmitReport


@documented("sf_grid_emit")
def emit(grid: Grid, path: Path | Voxels, brush: Grid, rule: AnyRule = "box3", *,
         anchor: Sequence[int] | None = None, bed_layer: int | None = None,
         exempt: Grid | None = None, forbid: Grid | None = None, act: Grid | None = None) -> Emitted:
    """The grid with a brush on every voxel of a path, less what of the brush would hang in the air.

    `anchor` is the brush's voxel (x, y, layer) that lies on the path; None: its middle.
    """
    voxels = _core.array_in(path.voxels if isinstance(path, Path) else path, np.uint32, (None, 3), "path")
    nz, ny, nx = brush.shape
    result, report, stroke = grid.copy(), ffi.new("sf_emit_report *"), ffi.new("sf_stroke *")
    stroke.brush, stroke.count = brush._c, len(voxels)
    stroke.anchor = tuple(int(i) for i in (anchor or (nx // 2, ny // 2, nz // 2)))
    stroke.path = ffi.cast("sf_voxel *", ffi.from_buffer(voxels)) if voxels.size else ffi.NULL
    terms = _terms(grid, rule, bed_layer, exempt, None, forbid, act)
    ok(lib.sf_grid_emit(result._c, terms.c, stroke, ffi.NULL, report))
    return Emitted(result, _core.value(report))


__all__ = ["Emitted", "Path", "PathCost", "PathEnd", "PathFinder", "PathMap", "emit"]
