"""Explicit steps of subdivision, tetrahedra of them, and the exchange of tetrahedra as files."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable

import numpy as np
import numpy.typing as npt

from . import _core, _files, _types
from ._core import Progress, documented, ffi, lib, ok, running
from ._types import Property, RefineRules
from .cages import Cage, Floats, c_property

Indices = npt.NDArray[np.uint32]


@dataclass(frozen=True)
class Channel:
    """The values of a property: a value for each point, or by `indices` for each corner."""

    property: Property
    values: Floats
    indices: Indices | None = None


def _channels_of(view: Any, corner_shape: tuple[int, ...], owner: Any) -> dict[str, Channel]:
    found = {}
    for i in range(view.channel_count):
        c = view.channels[i]
        indices = None if c.indices == ffi.NULL else _core.memory(c.indices, "uint32", corner_shape, owner)
        kind = _core.value(c.property)
        found[kind.name] = Channel(kind, _core.memory(c.values, "float64", (c.value_count,), owner), indices)
    return found


class _Channelled:
    """What has properties that are found by their names."""

    channels: Callable[[], dict[str, Channel]]

    def _channel(self, name: str) -> int:
        names = list(self.channels())
        if name not in names:
            raise KeyError(f"{name}: there are {', '.join(names) or 'no properties'}")
        return names.index(name)


# --- Steps --------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Step:
    """A refined cage: points (n, 3), and its cells' corners, those of cell i from starts[i] on."""

    points: Floats
    starts: Indices
    corners: Indices
    channels: dict[str, Channel]


class Refinement:
    """A cage after so many steps of subdivision; new points and values run through all of them."""

    @documented("sf_refine")
    def __init__(self, cage: Cage, steps: int = 1, rules: RefineRules = RefineRules.STANDARD, *,
                 progress: Progress = None, threads: int | None = 1) -> None:
        options = _core.options("sf_refine_options", steps=steps, rules=int(rules))
        made = ffi.new("sf_refinement **")
        with running(progress, threads) as task:
            ok(lib.sf_refine(cage._c, options, ffi.NULL, task, made))
        self._c, self._cage, self._changes = ffi.gc(made[0], lib.sf_refinement_destroy), cage, 0

    @documented("sf_refinement_get_view")
    def step(self, step: int) -> Step:
        """The cage after some steps; its arrays are the refinement's own memory, to be read."""
        v = ffi.new("sf_cage_view *")
        ok(lib.sf_refinement_get_view(self._c, step, v))
        starts = _core.memory(v.starts, "uint32", (v.cell_count + 1,), self._c)
        count = int(starts[-1])
        return Step(_core.memory(v.positions, "float64", (v.point_count, 3), self._c), starts,
                    _core.memory(v.corners, "uint32", (count,), self._c), _channels_of(v, (count,), self._c))

    @documented("sf_refinement_update_positions", "sf_refinement_update_values")
    def update(self, *, threads: int | None = 1) -> None:
        """Take the cage's points and values as they are now."""
        view = self._cage._view
        self._changes += 1
        with running(None, threads) as task:
            ok(lib.sf_refinement_update_positions(self._c, view.positions, task))
            for i in range(view.channel_count):
                ok(lib.sf_refinement_update_values(self._c, i, view.channels[i].values, task))

    @documented("sf_refinement_stencil")
    def stencil(self, step: int, point: int) -> tuple[Indices, Floats]:
        """Of which of the cage's points, by which weights, a point after a step is made."""
        count = ffi.new("size_t *")
        status = lib.sf_refinement_stencil(self._c, step, point, ffi.NULL, 0, ffi.NULL, ffi.NULL, count)
        if status != int(_types.Status.ERR_CAPACITY):
            ok(status)
        points, weights = np.empty(count[0], np.uint32), np.empty(count[0])
        ok(lib.sf_refinement_stencil(self._c, step, point, ffi.NULL, len(points),
                                     _core.pointer("uint32_t", points), _core.pointer("double", weights), count))
        return points, weights

    @documented("sf_tets_of_refinement")
    def tets(self, step: int) -> Tets:
        """Six tetrahedra for each cell of a step; they change with the refinement."""
        made = ffi.new("sf_tets **")
        ok(lib.sf_tets_of_refinement(self._c, step, ffi.NULL, made))
        found: Tets = Tets._of(made[0], self)
        return found


# --- Tetrahedra ---------------------------------------------------------------------------------


class Tets(_Channelled):
    """Tetrahedra with properties: points (n, 3) in mm, and corners (m, 4)."""

    _c: Any

    @documented("sf_tets_create")
    def __init__(self, points: Any, corners: Any, channels: Any = ()) -> None:
        points = _core.array_in(points, np.float64, (None, 3), "points")
        corners = _core.array_in(corners, np.uint32, (None, 4), "corners")
        c, kept = ffi.new("sf_channel[]", max(len(channels), 1)), []
        for i, channel in enumerate(channels):
            values = _core.array_in(channel.values, np.float64, (None,), "values")
            c[i].property = c_property(channel.property)
            c[i].value_count, c[i].values = len(values), _core.pointer("double", values)
            kept.append(values)
            if channel.indices is not None:
                indices = _core.array_in(channel.indices, np.uint32, corners.shape, "indices")
                c[i].indices = _core.pointer("uint32_t", indices)
                kept.append(indices)
        view, made, fault = ffi.new("sf_tets_view *"), ffi.new("sf_tets **"), _core.new_fault()
        view.point_count, view.positions = len(points), _core.pointer("double", points)
        view.tet_count, view.corners = len(corners), _core.pointer("uint32_t", corners)
        view.channel_count, view.channels = len(channels), c
        ok(lib.sf_tets_create(view, ffi.NULL, made, fault), fault)
        self._take(made[0], None)

    def _take(self, c: Any, owner: Refinement | None) -> None:
        self._c, self._owner, self._own_changes = ffi.gc(c, lib.sf_tets_destroy), owner, 0

    @classmethod
    def _of(cls, c: Any, owner: Refinement | None) -> Tets:
        tets = cls.__new__(cls)
        tets._take(c, owner)
        return tets

    @property
    def _changes(self) -> int:
        return self._own_changes + (self._owner._changes if self._owner is not None else 0)

    @property
    def points(self) -> Floats:
        """(n, 3), mm; their own memory, to be read."""
        v = lib.sf_tets_get_view(self._c)
        return _core.memory(v.positions, "float64", (v.point_count, 3), self)

    @property
    def corners(self) -> Indices:
        """(m, 4); their own memory, to be read."""
        v = lib.sf_tets_get_view(self._c)
        return _core.memory(v.corners, "uint32", (v.tet_count, 4), self)

    def channels(self) -> dict[str, Channel]:
        """The properties, by their names; the arrays are their own memory, to be read."""
        v = lib.sf_tets_get_view(self._c)
        return _channels_of(v, (int(v.tet_count), 4), self)

    @documented("sf_tets_set_values")
    def set_values(self, name: str, values: Any, first: int = 0) -> None:
        """Change values of a property."""
        values = _core.array_in(values, np.float64, (None,), "values")
        self._own_changes += 1
        ok(lib.sf_tets_set_values(self._c, self._channel(name), first, len(values), _core.pointer("double", values)))

    @documented("sf_tets_check")
    def check(self) -> _types.TetsReport:
        """Their volume, and whether they conform."""
        found = ffi.new("sf_tets_report *")
        ok(lib.sf_tets_check(self._c, ffi.NULL, found))
        return _core.value(found)  # type: ignore[no-any-return]

    @documented("sf_exchange_write")
    def save(self, to: _files.Writable) -> None:
        """Write an exchange file (HDF5): by the library, or where it has no HDF5 by h5py."""
        if not lib.sf_exchange_is_served():
            from . import _exchange

            _exchange.save(self, to)
            return
        fault = _core.new_fault()
        with _files.sink(to) as sink:
            ok(lib.sf_exchange_write(self._c, sink, fault), fault)

    @classmethod
    @documented("sf_exchange_read")
    def load(cls, of: _files.Readable) -> Tets:
        """Read an exchange file (HDF5): by the library, or where it has no HDF5 by h5py."""
        if not lib.sf_exchange_is_served():
            from . import _exchange

            return _exchange.load(of)
        made, fault = ffi.new("sf_tets **"), _core.new_fault()
        with _files.source(of) as source:
            ok(lib.sf_exchange_read(source, 0, ffi.NULL, made, fault), fault)
        return cls._of(made[0], None)

    def __repr__(self) -> str:
        return f"<libsf.Tets {len(self.points)} points, {len(self.corners)} tetrahedra, {list(self.channels())}>"


__all__ = ["Channel", "RefineRules", "Refinement", "Step", "Tets"]
