"""Whether a shape stands or hangs, and derivatives for optimisers of one's own."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Sequence

import numpy as np
import numpy.typing as npt

from . import _core, _types
from ._core import documented, ffi, lib, ok
from ._types import StanceKind
from .mesh import Mesh, as_mesh
from .voxel import Grid

Vectors = npt.NDArray[np.float64]
FAR = 1e12


# --- Bodies -------------------------------------------------------------------------------------


@documented("sf_mesh_body", "sf_grid_body")
def body(shape: Any, density: Any = 1.0) -> _types.Body:
    """The mass and first moments of the solid that a closed mesh bounds, or of a grid's voxels.

    `density` is a number; of a grid also a float32 array in (layer, y, x) order.
    """
    found = ffi.new("sf_body *")
    if isinstance(shape, Grid):
        if isinstance(density, np.ndarray):
            weights = _core.array_in(density, np.float32, shape.shape, "density")
            ok(lib.sf_grid_body(shape._c, _core.pointer("float", weights), ffi.NULL, found))
            return _core.value(found)  # type: ignore[no-any-return]
        ok(lib.sf_grid_body(shape._c, ffi.NULL, ffi.NULL, found))
        scaled = lib.sf_body_add({"mass": 0, "moment": [0, 0, 0]}, float(density), found[0])
        return _core.value(scaled)  # type: ignore[no-any-return]
    ok(lib.sf_mesh_body(as_mesh(shape)._view, density, found))
    return _core.value(found)  # type: ignore[no-any-return]


def c_body(body: _types.Body) -> Any:
    """A body as the library has it."""
    return {"mass": body.mass, "moment": list(body.moment)}


@documented("sf_body_add")
def add_bodies(a: _types.Body, b: _types.Body, factor: float = 1.0) -> _types.Body:
    """a + factor * b: with -1 the one less the other."""
    return _core.value(lib.sf_body_add(c_body(a), factor, c_body(b)))  # type: ignore[no-any-return]


def c_ballast(ballast: Any) -> tuple[Any, int]:
    """Masses in points as the library has them."""
    masses = [(float(m), [float(x) for x in at]) for m, at in ballast]
    return ffi.new("sf_ballast[]", [{"mass": m, "at_mm": at} for m, at in masses] or 1), len(masses)


@documented("sf_ballast_body")
def ballast_body(ballast: Sequence[tuple[float, Sequence[float]]]) -> _types.Body:
    """The body of masses in points: pairs of a mass and a place in mm."""
    return _core.value(lib.sf_ballast_body(*c_ballast(ballast)))  # type: ignore[no-any-return]


@documented("sf_body_com")
def center_of_mass(shape: Any) -> Vectors:
    """The centre of mass of a body, of a grid, or of the solid that a closed mesh bounds, mm."""
    b, found = shape if isinstance(shape, _types.Body) else body(shape), ffi.new("double[3]")
    ok(lib.sf_body_com(c_body(b), found))
    return np.array(list(found))


class Balance:
    """Mass, centre of mass and margin of a mesh as functions of its vertices, with derivatives.

    For any optimiser: each takes (n, 3) vertices, or those numbers in a row, and returns the value
    and its gradient.

        balance = libsf.Balance(mesh.faces)
        result = scipy.optimize.minimize(lambda x: balance.mass(x), x0, jac=True)
    """

    def __init__(self, faces: Any, density: float = 1.0) -> None:
        self._faces = _core.whole_numbers(faces, np.uint32, "faces")
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

    _c: Any

    @documented("sf_stance_create")
    def __init__(self, mesh: Any, kind: StanceKind | str = StanceKind.STAND, *,
                 up: Sequence[float] = (0, 0, 1), gamma_rad: float | None = None,
                 tolerance_rad: float | None = None, range_rad: float | None = None,
                 contact_mm: float | None = None, region_mm: Any = None,
                 point_mm: Sequence[float] | None = None, lever_mm: float | None = None) -> None:
        mesh, fault = as_mesh(mesh), _core.new_fault()
        made = ffi.new("sf_stance **")
        kind = _core.member(StanceKind, kind, "kind")
        options = _core.options(
            "sf_stance_options", kind=int(kind), up=[float(x) for x in up], gamma_rad=gamma_rad,
            tolerance_rad=tolerance_rad, range_rad=range_rad, contact_mm=contact_mm,
            point_mm=None if point_mm is None else [float(x) for x in point_mm], lever_mm=lever_mm)
        if region_mm is not None:
            low, high = region_mm
            options.region_low_mm = [max(float(x), -FAR) for x in low]
            options.region_high_mm = [min(float(x), FAR) for x in high]
        ok(lib.sf_stance_create(mesh._view, options, ffi.NULL, made, fault), fault)
        self._c = ffi.gc(made[0], lib.sf_stance_destroy)

    @classmethod
    def _like(cls, c: Any, mesh: Any) -> Stance:
        """A stance of a mesh with the options of one of the library's."""
        stance, made, fault = cls.__new__(cls), ffi.new("sf_stance **"), _core.new_fault()
        options = ffi.new("sf_stance_options *", lib.sf_stance_get_options(c))
        ok(lib.sf_stance_create(mesh, options, ffi.NULL, made, fault), fault)
        stance._c = ffi.gc(made[0], lib.sf_stance_destroy)
        return stance

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

    @documented("sf_stance_flatten")
    def flattened(self, vertices: Any) -> Vectors:
        """A copy of the mesh's vertices, (n, 3), with every contact put onto the ground."""
        moved = np.array(_core.array_in(vertices, np.float64, (None, 3), "vertices"))
        ok(lib.sf_stance_flatten(self._c, _core.pointer("double", moved), len(moved)))
        return moved


@documented("sf_mesh_rest")
def rest(mesh: Any, com_mm: Any, ups: Any) -> list[_types.Rest]:
    """How a body comes to rest that is let go on level ground, for each `up` of (n, 3) starts."""
    mesh, fault = as_mesh(mesh), _core.new_fault()
    starts = _core.array_in(ups, np.float64, (None, 3), "ups")
    found = ffi.new("sf_rest[]", max(len(starts), 1))
    ok(lib.sf_mesh_rest(mesh._view, _core.numbers(com_mm, 3, "com_mm"), _core.pointer("double", starts),
                        len(starts), ffi.NULL, found, fault), fault)
    return [_core.value(found[i]) for i in range(len(starts))]


__all__ = ["Balance", "Stance", "StanceKind", "Verdict", "add_bodies", "ballast_body", "body",
           "center_of_mass", "rest"]
