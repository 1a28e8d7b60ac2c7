"""Limits of cages under Catmull-Clark subdivision: evaluated, searched, and sliced."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Iterator, Sequence

import numpy as np
import numpy.typing as npt

from . import _core, _types
from ._core import Progress, documented, ffi, lib, ok, running
from ._types import RefineRules
from .cages import Cage, Floats
from .layers import Layer
from .mesh import Mesh
from .refining import Tets
from .voxel import Lattice, _lattice

# A place of a limit: a piece of a cell, and parameters in it.
PLACE = np.dtype([("piece", np.uint32), ("u", np.float64, 3)], align=True)
# The piece of a place that there is not.
NO_PIECE = 0xFFFFFFFF
Places = npt.NDArray[np.void]


class Limit:
    """The limit of a cage under Catmull-Clark subdivision.

    Where `positions`, `values` and their derivatives are asked for, give places as `places` and a
    Locator make them; or numbers of cells and parameters (n, 3) in them, from 0 to 1.
    """

    @documented("sf_limit_create")
    def __init__(self, cage: Cage, rules: RefineRules = RefineRules.STANDARD, *,
                 progress: Progress = None) -> None:
        made = ffi.new("sf_limit **")
        with running(progress) as task:
            ok(lib.sf_limit_create(cage._c, int(rules), ffi.NULL, task, made))
        self._c = ffi.gc(made[0], lib.sf_limit_destroy)
        self._cage, self._changes = cage, 0
        self._dimension = int(cage._view.dimension)

    @property
    @documented("sf_limit_piece_count")
    def piece_count(self) -> int:
        """How many pieces there are: one for each corner of each cell."""
        return int(lib.sf_limit_piece_count(self._c))

    @documented("sf_limit_place")
    def places(self, cells: Any, u: Any) -> Places:
        """Places at parameters (n, 3) of whole cells."""
        cells = np.atleast_1d(np.asarray(cells, np.int64))
        at = np.atleast_2d(np.asarray(u, np.float64))
        if at.shape != (len(cells), 3):
            raise ValueError(f"u: its shape is {at.shape}, and ({len(cells)}, 3) is needed")
        found = np.zeros(len(cells), PLACE)
        c = _c_places(found)
        for i, (cell, p) in enumerate(zip(cells, at)):
            if cell < 0:
                raise IndexError(f"cell {cell}")
            ok(lib.sf_limit_place(self._c, int(cell), list(map(float, p)), c + i))
        return found

    def _at(self, cells: Any, u: Any) -> Places:
        if u is not None:
            return self.places(cells, u)
        return _core.array_in(cells, PLACE, (None,), "places")

    def _positions(self, places: Places, threads: int | None, derivatives: bool) -> tuple[Floats, Floats | None]:
        found = np.empty((len(places), 3))
        more = np.empty((len(places), 3, self._dimension)) if derivatives else None
        with running(None, threads) as task:
            ok(lib.sf_limit_positions(self._c, len(places), _c_places(places), ffi.NULL, task,
                                      _core.pointer("double", found), _core.pointer("double", more)))
        return found, more

    @documented("sf_limit_positions")
    def positions(self, cells: Any, u: Any = None, *, threads: int | None = 1) -> Floats:
        """Where places lie, (n, 3), mm."""
        return self._positions(self._at(cells, u), threads, False)[0]

    def derivatives(self, cells: Any, u: Any = None, *, threads: int | None = 1) -> Floats:
        """How places move with their parameters, (n, 3, dimension): x, y and z by each of them."""
        found = self._positions(self._at(cells, u), threads, True)[1]
        assert found is not None
        return found

    def _values(self, name: str, places: Places, threads: int | None, derivatives: bool) -> tuple[Floats, Floats | None]:
        found = np.empty(len(places))
        more = np.empty((len(places), self._dimension)) if derivatives else None
        with running(None, threads) as task:
            ok(lib.sf_limit_values(self._c, self._cage._channel(name), len(places), _c_places(places),
                                   ffi.NULL, task, _core.pointer("double", found),
                                   _core.pointer("double", more)))
        return found, more

    @documented("sf_limit_values")
    def values(self, name: str, cells: Any, u: Any = None, *, threads: int | None = 1) -> Floats:
        """What a property is at places, (n,)."""
        return self._values(name, self._at(cells, u), threads, False)[0]

    def value_derivatives(self, name: str, cells: Any, u: Any = None, *, threads: int | None = 1) -> Floats:
        """How a property changes with the parameters of places, (n, dimension)."""
        found = self._values(name, self._at(cells, u), threads, True)[1]
        assert found is not None
        return found

    @documented("sf_limit_check")
    def check(self, *, progress: Progress = None) -> _types.LimitReport:
        """Whether it lies the right way out everywhere."""
        found = ffi.new("sf_limit_report *")
        with running(progress) as task:
            ok(lib.sf_limit_check(self._c, ffi.NULL, task, found))
        return _core.value(found)  # type: ignore[no-any-return]

    @documented("sf_limit_bounds")
    def bounds(self) -> Floats:
        """The box around it: (2, 3), mm."""
        low, high = ffi.new("double[3]"), ffi.new("double[3]")
        ok(lib.sf_limit_bounds(self._c, ffi.NULL, ffi.NULL, low, high))
        return np.array([list(low), list(high)])

    @documented("sf_limit_update_positions", "sf_limit_update_values")
    def update(self) -> None:
        """Take the cage's points and values as they are now; samplers and locators that were made
        before are of no use then."""
        view = self._cage._view
        self._changes += 1
        ok(lib.sf_limit_update_positions(self._c, view.positions, ffi.NULL))
        for i in range(view.channel_count):
            ok(lib.sf_limit_update_values(self._c, i, view.channels[i].values, ffi.NULL))

    @documented("sf_sampler_create", "sf_sampler_slice")
    def slices(self, lattice: Lattice, names: Sequence[str] = (), *, tolerance: float | None = None,
               progress: Progress = None) -> Sampler:
        """Its slices on a lattice, with the properties of each voxel."""
        channels, options = _channels(self._cage, names), _core.options("sf_sample_options", tolerance=tolerance)
        made, fault = ffi.new("sf_sampler **"), _core.new_fault()
        with _lattice(lattice) as c, running(progress) as task:
            ok(lib.sf_sampler_create(self._c, c, options, len(names), channels, ffi.NULL, task, made,
                                     fault), fault)
        return Sampler(made[0], self, lattice, names)


def _c_places(places: Places) -> Any:
    return ffi.cast("sf_place *", ffi.from_buffer(places)) if places.size else ffi.NULL


def _channels(of: Any, names: Sequence[str]) -> Any:
    return ffi.new("size_t[]", [of._channel(n) for n in names] or [0])


class _Followed:
    """What was made of something that must not change meanwhile."""

    def __init__(self, of: Any) -> None:
        self._of, self._seen = of, of._changes

    def check(self) -> None:
        if self._of._changes != self._seen:
            raise RuntimeError("what this was made of has changed since: make a new one")


class Locator:
    """Finds the places of a limit, as it is now, that lie at points in space."""

    @documented("sf_locator_create")
    def __init__(self, limit: Limit) -> None:
        made = ffi.new("sf_locator **")
        ok(lib.sf_locator_create(limit._c, ffi.NULL, made))
        self._c, self._limit = ffi.gc(made[0], lib.sf_locator_destroy), _Followed(limit)

    @documented("sf_locator_find")
    def find(self, points: Any, reach_mm: float = 0.0, *, threads: int | None = 1) -> tuple[Places, Floats]:
        """The places of points (n, 3), and how far off they lie in mm: infinite, and the piece
        NO_PIECE, where none is within reach."""
        self._limit.check()
        points = _core.array_in(points, np.float64, (None, 3), "points")
        places, distances = np.zeros(len(points), PLACE), np.empty(len(points))
        with running(None, threads) as task:
            ok(lib.sf_locator_find(self._c, len(points), _core.pointer("double", points), reach_mm,
                                   ffi.NULL, task, _c_places(places), _core.pointer("double", distances)))
        return places, distances


# --- Slices -------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Slice:
    """A slice: what is solid, (y, x), and each property there, 0 elsewhere."""

    solid: npt.NDArray[np.bool_]
    values: dict[str, Floats]


class Sampler(_core.InTurn):
    """Slices of a limit or of tetrahedra: any one by its number, or all by iterating."""

    def __init__(self, c: Any, of: Any, lattice: Lattice, names: Sequence[str]) -> None:
        self._c, self._of = ffi.gc(c, lib.sf_sampler_destroy), _Followed(of)
        self._lattice, self._names = lattice, tuple(names)

    @classmethod
    @documented("sf_sampler_of_tets")
    def of_tets(cls, tets: Tets, lattice: Lattice, names: Sequence[str] = ()) -> Sampler:
        """Slices of tetrahedra."""
        made, fault = ffi.new("sf_sampler **"), _core.new_fault()
        with _lattice(lattice) as c:
            ok(lib.sf_sampler_of_tets(tets._c, c, len(names), _channels(tets, names), ffi.NULL, made,
                                      fault), fault)
        return cls(made[0], tets, lattice, names)

    def __len__(self) -> int:
        return self._lattice.nz

    @_core.in_turn
    def __getitem__(self, k: int) -> Slice:
        self._of.check()
        if not -len(self) <= k < len(self):
            raise IndexError(f"slice {k} of {len(self)}")
        values = {n: np.empty((self._lattice.ny, self._lattice.nx)) for n in self._names}
        planes = ffi.new("double *[]", [_core.pointer("double", v) for v in values.values()] or [ffi.NULL])
        layer = Layer(self._lattice.nx, self._lattice.ny)
        ok(lib.sf_sampler_slice(self._c, k % len(self), layer._c, ffi.cast("double *const *", planes)))
        return Slice(layer.array(), values)

    def __iter__(self) -> Iterator[Slice]:
        return (self[k] for k in range(len(self)))

    @documented("sf_sampler_surface")
    @_core.in_turn
    def surface(self) -> Mesh:
        """The surface by which voxels are solid."""
        return Mesh._copied(lib.sf_sampler_surface(self._c, ffi.NULL))

    @documented("sf_sampler_report")
    @_core.in_turn
    def report(self) -> _types.SampleReport:
        """What became of the voxels of all slices so far."""
        found = ffi.new("sf_sample_report *")
        ok(lib.sf_sampler_report(self._c, found))
        return _core.value(found)  # type: ignore[no-any-return]


__all__ = ["NO_PIECE", "Limit", "Locator", "Sampler", "Slice"]
