"""Hollow shapes: walls, cavities that print without supports, and the holes that drain them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Sequence

import numpy as np
import numpy.typing as npt

from . import _core, _types
from ._core import Progress, documented, ffi, lib, ok, running
from ._types import CarveGoal, CarveMode
from .balance import Stance, c_body
from .mesh import as_mesh
from .support import AnyRule, _terms
from .voxel import Grid, Lattice, _lattice, grid_of

Densities = npt.NDArray[np.float32]


@dataclass(frozen=True)
class Carved:
    grid: Grid
    report: _types.CarveReport


@documented("sf_grid_wall")
def wall(grid: Grid, mesh: Any, wall_mm: float, *, progress: Progress = None,
         threads: int | None = 1) -> Grid:
    """The voxels of a solid that are nearer to its surface than a wall may be thick."""
    mesh, found = as_mesh(mesh), Grid(grid_of(grid).lattice)
    with running(progress, threads) as task:
        ok(lib.sf_grid_wall(grid._c, mesh._view, wall_mm, ffi.NULL, task, found._c))
    return found


@documented("sf_grid_carve")
def carve(grid: Grid, walls: Grid, stances: Sequence[Stance] = (), rule: AnyRule = "box3", *,
          bed_layer: int | None = None, mode: CarveMode | None = None, goal: CarveGoal | None = None,
          density: Any = None, keep: Grid | None = None, act: Grid | None = None,
          strut_width_vx: int | None = None, progress: Progress = None,
          threads: int | None = 1) -> Carved:
    """The solid with a cavity: as large as can be, or as the stances need it.

    `density` is a float32 array in (layer, y, x) order: what 1 mm3 of each voxel weighs.
    """
    result, report = Grid(grid_of(grid).lattice), ffi.new("sf_carve_report *")
    terms = _terms(grid, rule, bed_layer, None, keep, None, act)
    weights = None if density is None else _core.array_in(density, np.float32, grid.shape, "density")
    c = ffi.new("sf_stance *[]", [s._c for s in stances] or [ffi.NULL])
    options = _core.options("sf_carve_options", mode=None if mode is None else int(mode),
                            goal=None if goal is None else int(goal),
                            strut_width_vx=strut_width_vx)
    options.density = _core.pointer("float", weights)
    options.stances = ffi.cast("sf_stance *const *", c)
    options.stance_count = len(stances)
    with running(progress, threads) as task:
        ok(lib.sf_grid_carve(grid._c, grid_of(walls, "walls")._c, terms.c, options, ffi.NULL, task, result._c, report))
    return Carved(result, _core.value(report))


@documented("sf_grid_wall_inside")
def wall_inside(grid: Grid, wall_mm: float, *, progress: Progress = None) -> Grid:
    """The voxels of a solid that are nearer to what is empty than a wall may be thick."""
    found = Grid(grid_of(grid).lattice)
    with running(progress) as task:
        ok(lib.sf_grid_wall_inside(grid._c, wall_mm, ffi.NULL, task, found._c))
    return found


@documented("sf_grid_clearance")
def clearance(grid: Grid, mesh: Any, *, progress: Progress = None, threads: int | None = 1) -> float:
    """How near a grid's voxels come to a surface, mm; infinite where nothing is solid."""
    mesh, found = as_mesh(mesh), ffi.new("double *")
    with running(progress, threads) as task:
        ok(lib.sf_grid_clearance(grid._c, mesh._view, ffi.NULL, task, found))
    return float(found[0])


# --- Densities ----------------------------------------------------------------------------------


@documented("sf_lattice_density")
def density(lattice: Lattice, *, density: float = 1.0, infill: float = 1.0, wall: Grid | None = None,
            regions: Sequence[tuple[Any, float]] = (), progress: Progress = None) -> Densities:
    """What 1 mm3 of each voxel weighs, as a float32 array in (layer, y, x) order.

    Regions are pairs of a shape and its density; of those that overlap the last one counts. A shape
    is a grid of the lattice, a mesh, or a box: two corners (2, 3) in mm.
    """
    found = np.empty(lattice.shape, np.float32)
    c, kept = ffi.new("sf_density_region[]", max(len(regions), 1)), []
    for i, (shape, weight) in enumerate(regions):
        c[i].density = weight
        if isinstance(shape, Grid):
            c[i].shape, c[i].mask = int(_types.DensityShape.MASK), shape._c
        elif np.shape(shape) == (2, 3):
            c[i].shape = int(_types.DensityShape.BOX)
            c[i].low_mm, c[i].high_mm = ([float(x) for x in corner] for corner in shape)
        else:
            mesh = as_mesh(shape)
            kept.append(mesh)
            c[i].shape, c[i].mesh = int(_types.DensityShape.MESH), mesh._view
    options = _core.options("sf_density_options", density=density, infill=infill, regions=c,
                            region_count=len(regions))
    if wall is not None:
        options.wall = wall._c
    with _lattice(lattice) as on, running(progress) as task:
        ok(lib.sf_lattice_density(on, options, ffi.NULL, task, _core.pointer("float", found)))
    return found


# --- Draining -----------------------------------------------------------------------------------


@dataclass(frozen=True)
class Drained:
    """The part with its holes, what became of the voids, and each hole."""

    grid: Grid
    report: _types.DrainReport
    drains: Sequence[_types.Drain]


@documented("sf_grid_drain")
def drain(grid: Grid, diameter_mm: float, rule: AnyRule | None = "box3", *, count: int | None = None,
          void_min: int | None = None, fill: bool = False, density: Any = None,
          stances: Sequence[Stance] = (), body: _types.Body | None = None,
          bed_layer: int | None = None, limit: int = 1024, progress: Progress = None) -> Drained:
    """The part with a hole for every closed void, through which a rod of a diameter passes.

    Without a rule nothing needs support. With stances, whose `body` is that of the part, holes lie
    where the balance changes least.
    """
    result, report = grid_of(grid).copy(), ffi.new("sf_drain_report *")
    weights = None if density is None else _core.array_in(density, np.float32, grid.shape, "density")
    places, c = ffi.new("sf_drain[]", max(limit, 1)), ffi.new("sf_stance *[]", [s._c for s in stances] or [ffi.NULL])
    options = _core.options("sf_drain_options", diameter_mm=diameter_mm, count=count, void_min=void_min,
                            fill=int(fill), drains=places, drain_capacity=limit,
                            body=None if body is None else c_body(body))
    options.density = _core.pointer("float", weights)
    options.stances, options.stance_count = ffi.cast("sf_stance *const *", c), len(stances)
    terms = None if rule is None else _terms(grid, rule, bed_layer)
    with running(progress) as task:
        ok(lib.sf_grid_drain(result._c, ffi.NULL if terms is None else terms.c, options, ffi.NULL, task, report))
    drilled = min(int(report.drain_count), limit)
    return Drained(result, _core.value(report), _core.Values(places, drilled))


__all__ = ["CarveGoal", "CarveMode", "Carved", "Drained", "carve", "clearance", "density", "drain",
           "wall", "wall_inside"]
