"""Whether a shape stands or hangs, how to make it, and derivatives for optimisers of one's own."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Sequence

import numpy as np
import numpy.typing as npt

from . import _core, _types
from ._core import Progress, documented, ffi, lib, ok, running
from ._types import CarveMode, StanceKind, StandSolver
from .mesh import Mesh, as_mesh
from .support import AnyRule, Rule, _terms
from .voxel import Grid, Lattice

Vectors = npt.NDArray[np.float64]
FAR = 1e12


# --- Bodies -------------------------------------------------------------------------------------


@documented("sf_mesh_body")
def body(mesh: Any, density: float = 1.0) -> _types.Body:
    """The mass and first moments of the solid that a closed mesh bounds."""
    mesh = as_mesh(mesh)
    found = ffi.new("sf_body *")
    ok(lib.sf_mesh_body(mesh._view, density, found))
    return _core.value(found)  # type: ignore[no-any-return]


def center_of_mass(mesh: Any) -> Vectors:
    """The centre of mass of the solid that a closed mesh bounds, mm."""
    b = body(mesh)
    return np.asarray(b.moment) / b.mass


class Balance:
    """Mass, centre of mass and margin of a mesh as functions of its vertices, with derivatives.

    For any optimiser: each takes (n, 3) vertices, or those numbers in a row, and returns the value
    and its gradient.

        balance = libsf.Balance(mesh.faces)
        result = scipy.optimize.minimize(lambda x: balance.mass(x), x0, jac=True)
    """

    def __init__(self, faces: Any, density: float = 1.0) -> None:
        self._faces = np.ascontiguousarray(faces, np.uint32)
        self._density = density

    def _at(self, vertices: Any) -> tuple[Mesh, Any, Vectors]:
        points = np.ascontiguousarray(vertices, np.float64).reshape(-1, 3)
        mesh, b = Mesh(points, self._faces), ffi.new("sf_body *")
        gradient = np.empty((len(points), 4, 3))
        ok(lib.sf_mesh_body(mesh._view, self._density, b))
        ok(lib.sf_mesh_body_gradient(mesh._view, self._density, _core.pointer("double", gradient)))
        return mesh, b, gradient

    @documented("sf_mesh_body_gradient")
    def mass(self, vertices: Any) -> tuple[float, Vectors]:
        """The mass, and its derivatives by each coordinate, in the shape of the vertices."""
        _, b, gradient = self._at(vertices)
        return b.mass, gradient[:, 0].reshape(np.shape(vertices))

    @documented("sf_body_com_gradient")
    def center_of_mass(self, vertices: Any) -> tuple[Vectors, Vectors]:
        """The centre of mass (3,), and its derivatives (3, n, 3): of each part by each vertex."""
        _, b, gradient = self._at(vertices)
        found = np.empty((len(gradient), 3, 3))
        ok(lib.sf_body_com_gradient(b[0], _core.pointer("double", gradient), len(gradient),
                                    _core.pointer("double", found)))
        com = np.array(list(b.moment)) / b.mass
        return com, np.ascontiguousarray(found.transpose(1, 0, 2))

    def margin(self, vertices: Any, stance: Stance) -> tuple[float, Vectors]:
        """The tilt that a shape which stands survives, in radians, and its derivatives by vertices.

        The stance is as it was made: its contacts do not move along.
        """
        com, by_vertex = self.center_of_mass(vertices)
        verdict = stance.judge(com)
        up = np.asarray(stance.up)
        a, b = (np.asarray(p) for p in verdict.edge_mm_pair)
        along = b - a
        inward = np.cross(up, along) / np.linalg.norm(along)
        height = float(up @ com) - stance.ground_mm
        inside = float(inward @ (com - a))
        by_com = (height * inward - inside * up) / (height * height + inside * inside)
        gradient = np.einsum("i,inj->nj", by_com, by_vertex)
        return math.atan2(inside, height), gradient.reshape(np.shape(vertices))


# --- Stances ------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Verdict:
    """How a body of a given centre of mass fares in a stance; angles in radians."""

    margin_rad: float
    slack_mm: float
    edge_mm_pair: tuple[tuple[float, ...], tuple[float, ...]]
    stands: bool
    safe: bool


class Stance:
    """What a mesh stands on or hangs from, and where its centre of mass may lie for that."""

    @documented("sf_stance_create")
    def __init__(self, mesh: Any, kind: StanceKind | str = StanceKind.STAND, *,
                 up: Sequence[float] = (0, 0, 1), gamma_rad: float | None = None,
                 tolerance_rad: float | None = None, range_rad: float | None = None,
                 contact_mm: float | None = None, region_mm: Any = None,
                 point_mm: Sequence[float] | None = None, lever_mm: float | None = None) -> None:
        mesh, fault = as_mesh(mesh), _core.new_fault()
        made = ffi.new("sf_stance **")
        kind = StanceKind[kind.upper()] if isinstance(kind, str) else kind
        self._options = _core.options(
            "sf_stance_options", kind=int(kind), up=[float(x) for x in up], gamma_rad=gamma_rad,
            tolerance_rad=tolerance_rad, range_rad=range_rad, contact_mm=contact_mm,
            point_mm=None if point_mm is None else [float(x) for x in point_mm], lever_mm=lever_mm)
        if region_mm is not None:
            low, high = region_mm
            self._options.region_low_mm = [max(float(x), -FAR) for x in low]
            self._options.region_high_mm = [min(float(x), FAR) for x in high]
        ok(lib.sf_stance_create(mesh._view, self._options, ffi.NULL, made, fault), fault)
        self._c = ffi.gc(made[0], lib.sf_stance_destroy)

    @property
    def up(self) -> tuple[float, ...]:
        return tuple(lib.sf_stance_get_options(self._c).up)

    @property
    def ground_mm(self) -> float:
        """The height of the ground along `up`."""
        return float(lib.sf_stance_ground(self._c))

    @documented("sf_stance_polygon")
    def polygon(self) -> Vectors:
        """The corners of the support polygon, (n, 3), mm."""
        count = ffi.new("size_t *")
        lib.sf_stance_polygon(self._c, ffi.NULL, 0, count)
        found = np.empty((count[0], 3))
        ok(lib.sf_stance_polygon(self._c, _core.pointer("double", found), count[0], count))
        return found

    @documented("sf_stance_contacts")
    def contacts(self) -> npt.NDArray[np.uint32]:
        """The vertices that touch the ground."""
        count = ffi.new("size_t *")
        lib.sf_stance_contacts(self._c, ffi.NULL, 0, count)
        found = np.empty(count[0], np.uint32)
        ok(lib.sf_stance_contacts(self._c, _core.pointer("uint32_t", found), count[0], count))
        return found

    @documented("sf_stance_halfspaces")
    def halfspaces(self) -> tuple[Vectors, Vectors]:
        """Where the centre of mass may lie: normals (n, 3) and offsets (n,), normal . c >= offset."""
        count = ffi.new("size_t *")
        lib.sf_stance_halfspaces(self._c, ffi.NULL, 0, count)
        found = ffi.new("sf_halfspace[]", max(count[0], 1))
        ok(lib.sf_stance_halfspaces(self._c, found, count[0], count))
        normals = np.array([list(found[i].normal) for i in range(count[0])]).reshape(-1, 3)
        return normals, np.array([found[i].offset_mm for i in range(count[0])])

    @documented("sf_stance_judge")
    def judge(self, com_mm: Any) -> Verdict:
        """How a centre of mass fares."""
        v = ffi.new("sf_stance_verdict *")
        ok(lib.sf_stance_judge(self._c, _core.numbers(com_mm, 3, "com_mm"), v))
        return Verdict(v.margin_rad, v.slack_mm, (tuple(v.edge_mm[0]), tuple(v.edge_mm[1])),
                       bool(v.stands), bool(v.safe))


# --- Carving ------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Carved:
    grid: Grid
    report: _types.CarveReport


@documented("sf_grid_wall")
def wall(grid: Grid, mesh: Any, wall_mm: float, *, progress: Progress = None,
         threads: int | None = 1) -> Grid:
    """The voxels of a solid that are nearer to its surface than a wall may be thick."""
    mesh, found = as_mesh(mesh), Grid(grid.lattice)
    with running(progress, threads) as task:
        ok(lib.sf_grid_wall(grid._c, mesh._view, wall_mm, ffi.NULL, task, found._c))
    return found


@documented("sf_grid_carve")
def carve(grid: Grid, walls: Grid, stances: Sequence[Stance] = (), rule: AnyRule = "box3", *,
          bed_layer: int | None = None, mode: CarveMode | None = None, density: Any = None,
          strut_width_vx: int | None = None, progress: Progress = None,
          threads: int | None = 1) -> Carved:
    """The solid with a cavity: as large as can be, or as the stances need it.

    `density` is a float32 array in (layer, y, x) order: what 1 mm3 of each voxel weighs.
    """
    result, report = Grid(grid.lattice), ffi.new("sf_carve_report *")
    terms = _terms(grid, rule, bed_layer)
    weights = None if density is None else _core.array_in(density, np.float32, grid.shape, "density")
    c = ffi.new("sf_stance *[]", [s._c for s in stances] or [ffi.NULL])
    options = _core.options("sf_carve_options", mode=None if mode is None else int(mode),
                            strut_width_vx=strut_width_vx)
    options.density = _core.pointer("float", weights)
    options.stances = ffi.cast("sf_stance *const *", c)
    options.stance_count = len(stances)
    with running(progress, threads) as task:
        ok(lib.sf_grid_carve(grid._c, walls._c, terms.c, options, ffi.NULL, task, result._c, report))
    return Carved(result, _core.value(report))


# --- Standing -----------------------------------------------------------------------------------


@dataclass(frozen=True)
class Standing:
    """A shape that was made to stand: its outside, its cavity (None where it is solid), voxels."""

    outer: Mesh
    cavity: Mesh | None
    grid: Grid
    report: _types.StandReport

    @property
    def succeeded(self) -> bool:
        return bool(self.report.succeeded)


def _stance_options(given: Any) -> dict[str, Any]:
    known = {"kind", "up", "gamma_rad", "tolerance_rad", "range_rad", "contact_mm", "point_mm",
             "lever_mm"}
    if not isinstance(given, dict) or set(given) - known:
        raise TypeError(f"stances: give dicts of {', '.join(sorted(known))}")
    kind = given.get("kind", StanceKind.STAND)
    return {**given, "kind": int(StanceKind[kind.upper()] if isinstance(kind, str) else kind)}


def _place_handles(mesh: Mesh, pitch_mm: float, count: int) -> list[Any]:
    low, high = mesh.bounds()
    grid = Grid(Lattice.around(low, high, pitch_mm))
    ok(lib.sf_grid_voxelize(grid._c, mesh._view, ffi.NULL, ffi.NULL, ffi.NULL, ffi.NULL))
    foot, found, n = ffi.new("sf_grid **"), ffi.new("sf_handle[]", count), ffi.new("size_t *")
    ok(lib.sf_grid_foot(grid._c, [0.0, 0.0, 1.0], 0, ffi.NULL, foot))
    base = Grid._of(foot[0])
    options, fault = _core.options("sf_place_options", count=count), _core.new_fault()
    options.base = base._c
    ok(lib.sf_handles_place(grid._c, options, ffi.NULL, ffi.NULL, found, count, n, fault), fault)
    return [tuple(found[i].at_mm) for i in range(n[0])]


@documented("sf_stand_create", "sf_stand_run")
def stand(mesh: Any, stances: Sequence[dict[str, Any]] = ({},), *, handles: Any = 5,
          resolution: int = 64, wall_mm: float | None = None, carve: bool = True,
          deform: bool = True, carve_mode: CarveMode | None = None, rule: AnyRule = "octagon",
          solver: StandSolver | None = None, rounds_max: int | None = None,
          progress: Progress = None, threads: int | None = 1) -> Standing:
    """Make a shape stand or hang: carve its inside, and bend its outside as little as will do.

    `stances` are dicts with what Stance takes; each bends on feet that are put flat. `handles` are
    places (n, 3) in mm, or how many find theirs by themselves.
    """
    mesh = as_mesh(mesh)
    rule = Rule.named(rule) if isinstance(rule, str) else rule
    low, high = mesh.bounds()
    size = float((high - low).max())
    pitch = size / resolution
    asked = ffi.new("sf_stance_options[]", len(stances))
    for i, given in enumerate(stances):
        filled = {"contact_mm": 0.01 * float(high[2] - low[2]) if deform else None,
                  **_stance_options(given)}
        asked[i] = _core.options("sf_stance_options", **filled)[0]
    places = [] if not deform else _place_handles(mesh, pitch, handles) if isinstance(handles, int) \
        else [tuple(map(float, p)) for p in handles]
    c_handles = ffi.new("sf_handle[]", max(len(places), 1))
    for i, at in enumerate(places):
        c_handles[i].at_mm = at
    options = _core.options(
        "sf_stand_options", pitch_mm=pitch, wall_mm=wall_mm, carve=int(carve), deform=int(deform),
        carve_mode=None if carve_mode is None else int(carve_mode), rule=int(rule.kind),
        angle_rad=rule.angle_rad, solver=None if solver is None else int(solver),
        rounds_max=rounds_max)
    made, fault, report = ffi.new("sf_stand **"), _core.new_fault(), ffi.new("sf_stand_report *")
    with running(None, threads) as task:
        count = len(places)
        while True:
            status = lib.sf_stand_create(mesh._view, asked, len(stances), c_handles, count, options,
                                         ffi.NULL, task, made, fault)
            if status != int(_types.Status.ERR_INFEASIBLE) or not isinstance(handles, int) or count == 0:
                break
            count -= 1  # the last ones, which lie worst, may be too close to what holds still
        ok(status, fault)
    c = ffi.gc(made[0], lib.sf_stand_destroy)
    with running(progress, threads) as task:
        ok(lib.sf_stand_run(c, task, report))
    cavity = lib.sf_stand_cavity(c)
    return Standing(Mesh._copied(lib.sf_stand_outer(c)),
                    Mesh._copied(cavity) if cavity.triangle_count > 0 else None,
                    Grid._borrowed(lib.sf_stand_grid(c), c), _core.value(report))


__all__ = ["Balance", "CarveMode", "Carved", "Stance", "StanceKind", "Standing", "StandSolver",
           "Verdict", "body", "carve", "center_of_mass", "stand", "wall"]
