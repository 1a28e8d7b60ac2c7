"""Making a shape stand or hang: carved inside, bent outside, in rounds or in one go."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Sequence

import numpy as np
import numpy.typing as npt

from . import _core, _types
from ._core import Progress, documented, ffi, lib, ok, running
from ._types import CarveMode, StanceKind, StandSolver
from .balance import Stance, c_ballast
from .bending import Handle, Pose, c_handles, c_pose, foot, place_handles, pose_of
from .mesh import Mesh, as_mesh, voxelize
from .support import AnyRule, Rule
from .voxel import Grid, Lattice

Place = tuple[float, float, float]


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


class _Fields:
    """The caller's functions of places, and what they raised."""

    def __init__(self, density: Callable[[Place], float] | None,
                 keep: Callable[[Place], bool] | None) -> None:
        self.density, self.keep = density, keep
        self.error: BaseException | None = None
        self.handle = ffi.new_handle(self)

    def ask(self, function: Any, p: Any, otherwise: Any) -> Any:
        if self.error is not None:
            return otherwise
        try:
            return function((p[0], p[1], p[2]))
        except BaseException as error:
            self.error = error
            return otherwise

    def ok(self, status: int, fault: Any = None) -> None:
        error, self.error = self.error, None
        if error is not None:
            raise error
        ok(status, fault)


@ffi.def_extern(error=1.0)  # type: ignore[misc, unused-ignore, untyped-decorator]
def sf_py_density(user: Any, p: Any) -> float:
    fields: _Fields = ffi.from_handle(user)
    return float(fields.ask(fields.density, p, 1.0))


@ffi.def_extern(error=1)  # type: ignore[misc, unused-ignore, untyped-decorator]
def sf_py_keep(user: Any, p: Any) -> int:
    fields: _Fields = ffi.from_handle(user)
    return int(bool(fields.ask(fields.keep, p, True)))


def _stance_options(given: Any) -> dict[str, Any]:
    known = {"kind", "up", "gamma_rad", "tolerance_rad", "range_rad", "contact_mm", "point_mm",
             "lever_mm"}
    if not isinstance(given, dict) or set(given) - known:
        raise TypeError(f"stances: give dicts of {', '.join(sorted(known))}")
    kind = given.get("kind", StanceKind.STAND)
    return {**given, "kind": int(_core.member(StanceKind, kind, "kind"))}


class Stand(_core.InTurn):
    """A shape on its way to standing: a round at a time, handles posed by hand in between.

        shape = libsf.Stand(mesh, handles=4)
        while not shape.report.ended:
            shape.round()
    """

    @documented("sf_stand_create")
    def __init__(self, mesh: Any, stances: Sequence[dict[str, Any]] = ({},), *, handles: Any = 5,
                 resolution: int = 64, wall_mm: float | None = None, carve: bool = True,
                 deform: bool = True, carve_mode: CarveMode | None = None, rule: AnyRule = "octagon",
                 solver: StandSolver | None = None, rounds_max: int | None = None,
                 turn: bool | None = None, ballast: Sequence[tuple[float, Sequence[float]]] = (),
                 density: Callable[[Place], float] | None = None,
                 keep: Callable[[Place], bool] | None = None, progress: Progress = None,
                 threads: int | None = 1) -> None:
        mesh = as_mesh(mesh)
        rule = Rule.named(rule) if isinstance(rule, str) else rule
        low, high = mesh.bounds()
        pitch = float((high - low).max()) / resolution
        asked = ffi.new("sf_stance_options[]", max(len(stances), 1))
        for i, given in enumerate(stances):
            filled = {"contact_mm": 0.01 * float(high[2] - low[2]) if deform else None,
                      **_stance_options(given)}
            asked[i] = _core.options("sf_stance_options", **filled)[0]
        placed = isinstance(handles, int)
        where = [] if not deform else _places(mesh, pitch, handles) if placed else handles
        c, self.handles = c_handles(where)
        masses, mass_count = c_ballast(ballast)
        options = _core.options(
            "sf_stand_options", pitch_mm=pitch, wall_mm=wall_mm, carve=int(carve), deform=int(deform),
            carve_mode=None if carve_mode is None else int(carve_mode), rule=int(rule.kind),
            angle_rad=rule.angle_rad, solver=None if solver is None else int(solver),
            rounds_max=rounds_max, turn=None if turn is None else int(turn), ballast=masses,
            ballast_count=mass_count)
        self._fields = _Fields(density, keep)
        if density is not None:
            options.density, options.density_user = lib.sf_py_density, self._fields.handle
        if keep is not None:
            options.keep, options.keep_user = lib.sf_py_keep, self._fields.handle
        made, fault = ffi.new("sf_stand **"), _core.new_fault()
        with running(progress, threads) as task:
            while True:
                count = len(self.handles)
                status = lib.sf_stand_create(mesh._view, asked, len(stances), c, count, options,
                                             ffi.NULL, task, made, fault)
                if status != int(_types.Status.ERR_INFEASIBLE) or not placed or count == 0:
                    break
                self.handles.pop()  # the last, which lies worst, may be too close to what holds still
            self._fields.ok(status, fault)
        self._c, self._stances = ffi.gc(made[0], lib.sf_stand_destroy), len(stances)

    @_core.in_turn
    def _go(self, call: Any, progress: Progress, threads: int | None) -> _types.StandReport:
        report = ffi.new("sf_stand_report *")
        with running(progress, threads) as task:
            self._fields.ok(call(self._c, task, report))
        return _core.value(report)  # type: ignore[no-any-return]

    @documented("sf_stand_round")
    def round(self, *, progress: Progress = None, threads: int | None = 1) -> _types.StandReport:
        """One round: bend, then carve the shape as it is then; the first only carves."""
        return self._go(lib.sf_stand_round, progress, threads)

    @documented("sf_stand_run")
    def run(self, *, progress: Progress = None, threads: int | None = 1) -> _types.StandReport:
        """Rounds until it is safe, or nothing improves."""
        return self._go(lib.sf_stand_run, progress, threads)

    @property
    def report(self) -> _types.StandReport:
        """How far it has come."""
        return _core.value(lib.sf_stand_describe(self._c))  # type: ignore[no-any-return]

    @documented("sf_stand_set_pose")
    @_core.in_turn
    def set_pose(self, handle: int, pose: Pose, *, lock: bool = True) -> None:
        """Pose a handle by hand; locked it keeps that, else the next round may move it on."""
        ok(lib.sf_stand_set_pose(self._c, handle, ffi.new("sf_pose *", c_pose(pose)), int(lock)))

    @documented("sf_stand_get_pose")
    def pose(self, handle: int) -> Pose:
        """The pose of a handle."""
        if not 0 <= handle < len(self.handles):
            raise IndexError(f"handle {handle} of {len(self.handles)}")
        return pose_of(lib.sf_stand_get_pose(self._c, handle))

    @documented("sf_stand_stance")
    @_core.in_turn
    def stance(self, index: int = 0) -> Stance:
        """A stance of the shape as it is."""
        c = lib.sf_stand_stance(self._c, index)
        if c == ffi.NULL:
            raise IndexError(f"stance {index} of {self._stances}")
        return Stance._like(c, lib.sf_stand_outer(self._c))

    @documented("sf_stand_density")
    @_core.in_turn
    def density(self) -> npt.NDArray[np.float32] | None:
        """What 1 mm3 of each voxel weighs, (layer, y, x); a copy; None where all weigh 1."""
        c = lib.sf_stand_density(self._c)
        if c == ffi.NULL:
            return None
        on = lib.sf_grid_lattice(lib.sf_stand_grid(self._c))
        return np.array(_core.memory(c, "float32", (on.nz, on.ny, on.nx), self._c))

    @_core.in_turn
    def result(self) -> Standing:
        """The shape as it is; after the first round at the earliest."""
        grid = lib.sf_stand_grid(self._c)
        if grid == ffi.NULL:
            raise ValueError("there was no round yet")
        cavity = lib.sf_stand_cavity(self._c)
        return Standing(Mesh._copied(lib.sf_stand_outer(self._c)),
                        Mesh._copied(cavity) if cavity.triangle_count > 0 else None,
                        Grid._borrowed(grid, self._c), self.report)


def _places(mesh: Mesh, pitch_mm: float, count: int) -> list[Handle]:
    low, high = mesh.bounds()
    grid = voxelize(mesh, Lattice.around(low, high, pitch_mm))
    return place_handles(grid, count, base=foot(grid))


@documented("sf_stand_run")
def stand(mesh: Any, stances: Sequence[dict[str, Any]] = ({},), *, progress: Progress = None,
          threads: int | None = 1, **more: Any) -> Standing:
    """Make a shape stand or hang: carve its inside, and bend its outside as little as will do.

    `stances` are dicts with what Stance takes; each bends on feet that are put flat. What else can
    be said is what Stand takes: `handles` are places (n, 3) in mm, or how many find theirs by
    themselves; `ballast` are pairs of a mass and a place; `density` and `keep` are functions of a
    place: what matter weighs there, and whether it must stay.
    """
    shape = Stand(mesh, stances, threads=threads, **more)
    shape.run(progress=progress, threads=threads)
    return shape.result()


__all__ = ["Stand", "StandSolver", "Standing", "stand"]
