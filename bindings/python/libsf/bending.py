"""Handles of a solid, their weights, and points that follow when handles are posed."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, NamedTuple, Sequence

import numpy as np
import numpy.typing as npt

from . import _core, _types
from ._core import Progress, documented, ffi, lib, ok, running
from ._types import HandleKind, WeightsMethod
from .mesh import as_mesh
from .voxel import Grid

Vectors = npt.NDArray[np.float64]
Triple = Sequence[float]


# --- Handles ------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Handle:
    """A place of a solid that is posed: a point, a ball, or a base that is held."""

    at_mm: tuple[float, ...]
    radius_mm: float = 0.0
    region: Grid | None = None
    locked: bool = False

    @property
    def kind(self) -> HandleKind:
        if self.region is not None:
            return HandleKind.BASE
        return HandleKind.BALL if self.radius_mm > 0 else HandleKind.POINT

    @classmethod
    @documented("sf_handle_base")
    def base(cls, region: Grid) -> Handle:
        """A region that is held still."""
        c = ffi.new("sf_handle *")
        ok(lib.sf_handle_base(region._c, c))
        return cls(tuple(c.at_mm), 0.0, region, bool(c.locked))


def c_handles(handles: Any) -> tuple[Any, list[Handle]]:
    """Handles as the library has them; what is no handle is a place (x, y, z) of a point."""
    made = [h if isinstance(h, Handle) else Handle(tuple(float(x) for x in h)) for h in handles]
    c = ffi.new("sf_handle[]", max(len(made), 1))
    for i, h in enumerate(made):
        c[i].kind, c[i].at_mm, c[i].radius_mm = int(h.kind), list(h.at_mm), h.radius_mm
        c[i].region = ffi.NULL if h.region is None else h.region._c
        c[i].locked = int(h.locked)
    return c, made


@documented("sf_handles_place")
def place_handles(solid: Grid, count: int = 5, *, base: Grid | None = None, ball: float = 0.0,
                  most_cells: int | None = None, progress: Progress = None) -> list[Handle]:
    """Handles that find their places: deep in the solid, far from the base and from each other."""
    found, n, fault = ffi.new("sf_handle[]", max(count, 1)), ffi.new("size_t *"), _core.new_fault()
    options = _core.options("sf_place_options", count=count, ball=ball, most_cells=most_cells)
    if base is not None:
        options.base = base._c
    with running(progress) as task:
        ok(lib.sf_handles_place(solid._c, options, ffi.NULL, task, found, count, n, fault), fault)
    return [Handle(tuple(found[i].at_mm), found[i].radius_mm) for i in range(n[0])]


@documented("sf_handle_center")
def handle_center(solid: Grid, from_mm: Triple, direction: Triple) -> tuple[float, ...]:
    """The middle of the solid behind a point, as one who points at its surface means it."""
    found, fault = ffi.new("double[3]"), _core.new_fault()
    ok(lib.sf_handle_center(solid._c, _core.numbers(list(from_mm), 3, "from_mm"),
                            _core.numbers(list(direction), 3, "direction"), found, fault), fault)
    return tuple(found)


@documented("sf_grid_foot")
def foot(solid: Grid, up: Triple = (0, 0, 1), height_mm: float = 0.0) -> Grid:
    """The voxels of a solid that lie lowest, seen against a direction."""
    made = ffi.new("sf_grid **")
    ok(lib.sf_grid_foot(solid._c, _core.numbers(list(up), 3, "up"), height_mm, ffi.NULL, made))
    return Grid._of(made[0])


@documented("sf_grid_cover")
def cover(solid: Grid, mesh: Any, *, progress: Progress = None) -> Grid:
    """A solid together with the voxels that a surface touches."""
    mesh, made = as_mesh(mesh), ffi.new("sf_grid **")
    with running(progress) as task:
        ok(lib.sf_grid_cover(solid._c, mesh._view, ffi.NULL, task, made))
    return Grid._of(made[0])


# --- Poses --------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Change:
    """How a pose changes, or what a function changes by it."""

    scale: float = 0.0
    shift_mm: tuple[float, ...] = (0.0, 0.0, 0.0)
    spin_rad: tuple[float, ...] = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Pose:
    """What becomes of a handle: p -> scale * turn (p - centre) + centre + shift."""

    scale: float = 1.0
    turn: tuple[float, ...] = field(default_factory=lambda: tuple(lib.sf_pose_identity().turn))
    shift_mm: tuple[float, ...] = (0.0, 0.0, 0.0)

    @documented("sf_pose_move")
    def moved(self, change: Change) -> Pose:
        """With a change: scale and shift are added, the spin turns after what is there."""
        pose = ffi.new("sf_pose *", c_pose(self))
        step = ffi.new("sf_pose_change *", _c_change(change))
        ok(lib.sf_pose_move(pose, step))
        return pose_of(pose)


def c_pose(pose: Pose) -> Any:
    return {"scale": pose.scale, "turn": [float(x) for x in np.reshape(pose.turn, 9)],
            "shift_mm": [float(x) for x in pose.shift_mm]}


def pose_of(c: Any) -> Pose:
    return Pose(c.scale, tuple(c.turn), tuple(c.shift_mm))


def _c_change(change: Change) -> Any:
    return {"scale": change.scale, "shift_mm": [float(x) for x in change.shift_mm],
            "spin_rad": [float(x) for x in change.spin_rad]}


def _c_poses(poses: Sequence[Pose], count: int) -> Any:
    if len(poses) != count:
        raise ValueError(f"poses: {len(poses)} of them for {count} handles")
    return ffi.new("sf_pose[]", [c_pose(p) for p in poses])


# --- Weights ------------------------------------------------------------------------------------


class Unbent(NamedTuple):
    """Rest points (n, 3), how far the bend of each is off, and how many were not found."""

    rest_mm: Vectors
    residual_mm: Vectors
    missed: int


class Weights:
    """How much each place of a solid follows each of its handles."""

    @documented("sf_weights_create")
    def __init__(self, solid: Grid, handles: Any, *, method: WeightsMethod | None = None,
                 most_cells: int | None = None, cell_mm: float | None = None,
                 tolerance: float | None = None, progress: Progress = None,
                 threads: int | None = 1) -> None:
        c, self.handles = c_handles(handles)
        options = _core.options("sf_weights_options", method=None if method is None else int(method),
                                most_cells=most_cells, cell_mm=cell_mm, tolerance=tolerance)
        made, fault = ffi.new("sf_weights **"), _core.new_fault()
        with running(progress, threads) as task:
            ok(lib.sf_weights_create(solid._c, c, len(self.handles), options, ffi.NULL, task, made,
                                     fault), fault)
        self._c = ffi.gc(made[0], lib.sf_weights_destroy)

    @property
    def facts(self) -> _types.WeightsFacts:
        """What they were made of."""
        return _core.value(lib.sf_weights_describe(self._c))  # type: ignore[no-any-return]

    @property
    def centers(self) -> Vectors:
        """The centres of all handles, (handles, 3), mm."""
        return _core.memory(lib.sf_weights_centers(self._c), "float64", (len(self.handles), 3), self._c)

    @documented("sf_weights_at")
    def at(self, p_mm: Triple) -> tuple[Vectors, Vectors]:
        """The weights at a point, (handles,), and their gradients, (handles, 3), per mm."""
        w, gradient = np.empty(len(self.handles)), np.empty((len(self.handles), 3))
        ok(lib.sf_weights_at(self._c, _core.numbers(list(p_mm), 3, "p_mm"), _core.pointer("double", w),
                             _core.pointer("double", gradient)))
        return w, gradient

    @documented("sf_weights_sample")
    def sample(self, points: Any, *, progress: Progress = None, threads: int | None = 1) -> Vectors:
        """The weights at points (n, 3): (n, handles)."""
        points = _core.array_in(points, np.float64, (None, 3), "points")
        found = np.empty((len(points), len(self.handles)))
        with running(progress, threads) as task:
            ok(lib.sf_weights_sample(self._c, _core.pointer("double", points), len(points), task,
                                     _core.pointer("double", found)))
        return found

    @documented("sf_weights_fold")
    def fold(self, poses: Sequence[Pose]) -> _types.Fold:
        """Whether these poses fold the solid over itself, and how much they stretch it."""
        found = ffi.new("sf_fold *")
        with running() as task:
            ok(lib.sf_weights_fold(self._c, _c_poses(poses, len(self.handles)), task, found))
        return _core.value(found)  # type: ignore[no-any-return]

    @documented("sf_weights_unbend")
    def unbend(self, points: Any, poses: Sequence[Pose], tolerance_mm: float, guesses: Any = None, *,
               progress: Progress = None, threads: int | None = 1) -> Unbent:
        """Where bent points (n, 3) lay before; a guess for each is the point itself, if none is given."""
        points = _core.array_in(points, np.float64, (None, 3), "points")
        rest = np.array(points if guesses is None
                        else _core.array_in(guesses, np.float64, (len(points), 3), "guesses"))
        residual, missed = np.empty(len(points)), ffi.new("size_t *")
        with running(progress, threads) as task:
            ok(lib.sf_weights_unbend(self._c, _c_poses(poses, len(self.handles)),
                                     _core.pointer("double", points), len(points), tolerance_mm, ffi.NULL,
                                     task, _core.pointer("double", rest), _core.pointer("double", residual),
                                     missed))
        return Unbent(rest, residual, int(missed[0]))


class Blend:
    """Points that follow the handles: bent, and the derivatives of that, for optimisers."""

    def __init__(self, weights: Weights, points: Any) -> None:
        self._points = np.array(_core.array_in(points, np.float64, (None, 3), "points"))
        self._w, self._count = weights.sample(self._points), len(weights.handles)
        self._centers = np.array(weights.centers)
        self._p = ffi.new("sf_blend *")
        self._p.rest_mm, self._p.weights = _core.pointer("double", self._points), _core.pointer("double", self._w)
        self._p.point_count, self._p.handle_count = len(self._points), self._count
        self._p.centers_mm = _core.pointer("double", self._centers)

    @documented("sf_blend_apply")
    def apply(self, poses: Sequence[Pose]) -> Vectors:
        """The points bent, (n, 3)."""
        found = np.empty_like(self._points)
        ok(lib.sf_blend_apply(self._p[0], _c_poses(poses, self._count), ffi.NULL, _core.pointer("double", found)))
        return found

    @documented("sf_blend_push")
    def push(self, poses: Sequence[Pose], changes: Sequence[Change]) -> Vectors:
        """How the points move, (n, 3), when poses change."""
        if len(changes) != self._count:
            raise ValueError(f"changes: {len(changes)} of them for {self._count} handles")
        found, c = np.empty_like(self._points), ffi.new("sf_pose_change[]", [_c_change(x) for x in changes])
        ok(lib.sf_blend_push(self._p[0], _c_poses(poses, self._count), c, ffi.NULL, _core.pointer("double", found)))
        return found

    @documented("sf_blend_pull")
    def pull(self, poses: Sequence[Pose], gradient: Any) -> list[Change]:
        """What a function of the points, of which this is the gradient (n, 3), changes by each pose."""
        gradient = _core.array_in(gradient, np.float64, self._points.shape, "gradient")
        found = ffi.new("sf_pose_change[]", self._count)
        ok(lib.sf_blend_pull(self._p[0], _c_poses(poses, self._count), _core.pointer("double", gradient),
                             ffi.NULL, ffi.NULL, found))
        return [Change(c.scale, tuple(c.shift_mm), tuple(c.spin_rad)) for c in found]


__all__ = ["Blend", "Change", "Handle", "HandleKind", "Pose", "Unbent", "Weights", "WeightsMethod", "cover",
           "foot", "handle_center", "place_handles"]
