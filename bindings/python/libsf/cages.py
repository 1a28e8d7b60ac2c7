"""Cages: control meshes of cells with properties at their points; built, read, painted, undone."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Callable, Sequence

import numpy as np
import numpy.typing as npt

from . import _core, _files, _types
from ._core import documented, ffi, lib, ok
from ._types import CageFormat, Falloff, PaintOperation, PaintWhere, Property

if TYPE_CHECKING:
    from .limits import Limit
    from .refining import Refinement

Floats = npt.NDArray[np.float64]
Place = tuple[float, float, float]


# --- Properties ---------------------------------------------------------------------------------


@documented("sf_property_density", "sf_property_young", "sf_property_poisson")
def known_property(name: str) -> Property:
    """A property whose meaning never changes: "density", "young" or "poisson"."""
    made = {"density": lib.sf_property_density, "young": lib.sf_property_young,
            "poisson": lib.sf_property_poisson}
    if name not in made:
        raise KeyError(f"{name}: known are {', '.join(made)}")
    return _core.value(made[name]())  # type: ignore[no-any-return]


def c_property(known: Property) -> Any:
    """A property as the library has it."""
    return {"name": _core.text(known.name, "name"), "uuid": list(known.uuid), "si": list(known.si), "low": known.low,
            "high": known.high}


# --- Functions of places ------------------------------------------------------------------------


class _Function:
    """A function of the caller's that the library asks, and what it raised."""

    def __init__(self, function: Callable[[Place, Any], Any]) -> None:
        self.function = function
        self.error: BaseException | None = None
        self.handle = ffi.new_handle(self)

    def ask(self, at: Any, to: Any, count: int) -> int:
        try:
            found = self.function((at[0], at[1], at[2]), to[0])
            if count == 1:
                to[0] = float(found)
            else:
                to[0], to[1], to[2] = (float(x) for x in found)
            return 1
        except BaseException as error:
            self.error = error
            return 0

    def ok(self, status: int) -> None:
        if self.error is not None:
            raise self.error
        ok(status)


@ffi.def_extern(error=0)  # type: ignore[misc, unused-ignore, untyped-decorator]
def sf_py_place(user: Any, at: Any, moved: Any) -> int:
    function: _Function = ffi.from_handle(user)
    return function.ask(at, moved, 3)


@ffi.def_extern(error=0)  # type: ignore[misc, unused-ignore, untyped-decorator]
def sf_py_value(user: Any, at: Any, value: Any) -> int:
    function: _Function = ffi.from_handle(user)
    return function.ask(at, value, 1)


# --- Cages --------------------------------------------------------------------------------------


class Cage(_core.InTurn):
    """A control mesh of cells, or of faces alone, with properties at its points.

    `cells` is an (n, 8) array of hexahedra, or a list of cells of any kind that is served: 4 points
    are a tetrahedron, 6 a wedge, 8 a hexahedron; with `dimension=2` faces of 3 points and more.
    """

    @documented("sf_cage_create")
    def __init__(self, points: Any, cells: Any, *, dimension: int = 3,
                 properties: dict[str, Any] | None = None,
                 creases: Sequence[tuple[int, int, float]] = ()) -> None:
        points = _core.array_in(points, np.float64, (None, 3), "points")
        counts = np.array([len(c) for c in cells], np.uint32)
        starts = np.concatenate([[0], np.cumsum(counts)]).astype(np.uint32)
        corners = _core.whole_numbers(np.concatenate([np.asarray(c) for c in cells]) if len(counts) else (),
                                      np.uint32, "cells")
        sharp = ffi.new("sf_crease[]", [{"points": [a, b], "sharpness": s} for a, b, s in creases] or 1)
        view, fault, made = ffi.new("sf_cage_view *"), _core.new_fault(), ffi.new("sf_cage **")
        view.dimension = dimension
        view.point_count, view.positions = len(points), _core.pointer("double", points)
        view.cell_count, view.starts = len(counts), _core.pointer("uint32_t", starts)
        view.corners = _core.pointer("uint32_t", corners)
        view.crease_count, view.creases = len(creases), sharp
        ok(lib.sf_cage_create(view, ffi.NULL, made, fault), fault)
        self._take(made[0])
        for name, values in (properties or {}).items():
            self.add_property(name, values)

    def _take(self, c: Any) -> None:
        self._c = ffi.gc(c, lib.sf_cage_destroy)

    @classmethod
    def _of(cls, c: Any) -> Cage:
        """A cage of the library's, which it becomes the owner of."""
        cage = cls.__new__(cls)
        cage._take(c)
        return cage

    @classmethod
    @documented("sf_cage_block")
    def block(cls, counts: Sequence[int], low_mm: Sequence[float], high_mm: Sequence[float]) -> Cage:
        """A box of so many cells along x, y and z."""
        made = ffi.new("sf_cage **")
        ok(lib.sf_cage_block([int(n) for n in counts], _core.numbers(list(low_mm), 3, "low_mm"),
                             _core.numbers(list(high_mm), 3, "high_mm"), ffi.NULL, made))
        return cls._of(made[0])

    @documented("sf_cage_extrude")
    def extruded(self, vector_mm: Sequence[float], layers: int) -> Cage:
        """Faces drawn along a line: a cage of cells."""
        made, fault = ffi.new("sf_cage **"), _core.new_fault()
        ok(lib.sf_cage_extrude(self._c, _core.numbers(list(vector_mm), 3, "vector_mm"), layers, ffi.NULL,
                               made, fault), fault)
        return Cage._of(made[0])

    @documented("sf_cage_revolve")
    def revolved(self, sectors: int, angle_rad: float = 2 * math.pi) -> Cage:
        """Faces turned about the z axis: a cage of cells."""
        made, fault = ffi.new("sf_cage **"), _core.new_fault()
        ok(lib.sf_cage_revolve(self._c, sectors, angle_rad, ffi.NULL, made, fault), fault)
        return Cage._of(made[0])

    @classmethod
    @documented("sf_cage_skeleton")
    def skeleton(cls, nodes: Sequence[tuple[Sequence[float], float]],
                 struts: Sequence[tuple[int, int, int]] = ()) -> Cage:
        """Cubes at nodes, (place, half a side), and struts between them: two nodes and how many cells."""
        n = ffi.new("sf_skeleton_node[]", [{"at_mm": [float(x) for x in at], "half_side_mm": half}
                                           for at, half in nodes] or 1)
        s = ffi.new("sf_skeleton_strut[]", [{"nodes": [a, b], "cells": cells} for a, b, cells in struts] or 1)
        made, fault = ffi.new("sf_cage **"), _core.new_fault()
        ok(lib.sf_cage_skeleton(len(nodes), n, len(struts), s, ffi.NULL, made, fault), fault)
        return cls._of(made[0])

    @classmethod
    @documented("sf_cage_read")
    def load(cls, of: _files.Readable, *, format: CageFormat | None = None,
             bytes_max: int | None = None) -> Cage:
        """Read legacy VTK, Medit .mesh or MFEM .mesh: a path, bytes, or a file that is open."""
        options = _core.options("sf_cage_read_options", bytes_max=bytes_max,
                                format=None if format is None else int(format))
        fault, made = _core.new_fault(), ffi.new("sf_cage **")
        with _files.source(of) as source:
            ok(lib.sf_cage_read(source, options, ffi.NULL, made, ffi.NULL, fault), fault)
        return cls._of(made[0])

    @documented("sf_cage_write_vtk")
    def save(self, to: _files.Writable) -> None:
        """Write legacy VTK, which ParaView opens and `load` reads."""
        view, fault = ffi.new("sf_cage_view *", self._view), _core.new_fault()
        with _files.sink(to) as sink:
            ok(lib.sf_cage_write_vtk(view, 1, ffi.NULL, sink, fault), fault)

    @property
    def _view(self) -> Any:
        return lib.sf_cage_get_view(self._c)

    @property
    def points(self) -> Floats:
        """(n, 3), mm; the cage's own memory, to be read."""
        v = self._view
        return _core.memory(v.positions, "float64", (v.point_count, 3), self._c)

    @documented("sf_cage_set_positions")
    @_core.in_turn
    def move(self, points: Any, first: int = 0) -> None:
        """Put points elsewhere."""
        points = _core.array_in(points, np.float64, (None, 3), "points")
        ok(lib.sf_cage_set_positions(self._c, first, len(points), _core.pointer("double", points)))

    @documented("sf_cage_map_positions")
    @_core.in_turn
    def map_points(self, function: Callable[[Place], Sequence[float]]) -> None:
        """Move all points by a function of their places."""
        given = _Function(lambda at, _: function(at))
        given.ok(lib.sf_cage_map_positions(self._c, lib.sf_py_place, given.handle, ffi.NULL))

    @documented("sf_cage_map_values")
    @_core.in_turn
    def map_values(self, name: str, function: Callable[[Place, float], float]) -> None:
        """Set all values of a property by a function of the place, and of what the value is before."""
        given = _Function(function)
        given.ok(lib.sf_cage_map_values(self._c, self._channel(name), lib.sf_py_value, given.handle, ffi.NULL))

    @property
    def properties(self) -> dict[str, Property]:
        """What is known of each property, by its name."""
        v = self._view
        found = [_core.value(v.channels[i].property) for i in range(v.channel_count)]
        return {p.name: p for p in found}

    def _channel(self, name: str) -> int:
        names = list(self.properties)
        if name not in names:
            raise KeyError(f"{name}: the cage has {', '.join(names) or 'no properties'}")
        return names.index(name)

    def values(self, name: str) -> Floats:
        """The values of a property; the cage's own memory, to be read."""
        i, v = self._channel(name), self._view
        return _core.memory(v.channels[i].values, "float64", (v.channels[i].value_count,), self._c)

    @documented("sf_cage_set_values")
    @_core.in_turn
    def set_values(self, name: str, values: Any, first: int = 0) -> None:
        """Change values of a property."""
        i = self._channel(name)
        values = _core.array_in(values, np.float64, (None,), "values")
        ok(lib.sf_cage_set_values(self._c, i, first, len(values), _core.pointer("double", values)))

    @documented("sf_cage_add_property", "sf_property_named")
    @_core.in_turn
    def add_property(self, name: str | Property, values: Any, low: float = -np.inf,
                     high: float = np.inf) -> None:
        """A new property: a value for each point; by a name and its bounds, or one that is known."""
        values = _core.array_in(values, np.float64, (self._view.point_count,), "values")
        channel, fault = ffi.new("sf_channel *"), _core.new_fault()
        if isinstance(name, str):
            ok(lib.sf_property_named(_core.text(name, "name"), ffi.addressof(channel, "property")))
            channel.property.low, channel.property.high = low, high
        else:
            channel.property = c_property(name)
        channel.value_count, channel.values = len(values), _core.pointer("double", values)
        ok(lib.sf_cage_add_property(self._c, channel, fault), fault)

    @documented("sf_cage_remove_property")
    @_core.in_turn
    def remove_property(self, name: str) -> None:
        """Take a property away."""
        ok(lib.sf_cage_remove_property(self._c, self._channel(name)))

    # --- Painting ---

    @documented("sf_paint_select")
    def select(self, at_mm: Sequence[float], radius_mm: float, *, to_mm: Sequence[float] | None = None,
               strength: float = 1.0, falloff: Falloff | None = None, where: PaintWhere | None = None,
               weights: Floats | None = None) -> Floats:
        """A weight from 0 to 1 for each point: what a ball touches, or what it sweeps on its way to
        another place; in `weights` that are given the greater of both is left."""
        brush = _core.options("sf_paint_brush", from_mm=[float(x) for x in at_mm],
                              to_mm=[float(x) for x in (at_mm if to_mm is None else to_mm)],
                              radius_mm=radius_mm, strength=strength,
                              falloff=None if falloff is None else int(falloff),
                              where=None if where is None else int(where))
        found = np.zeros(self._view.point_count) if weights is None else \
            _core.array_out(weights, np.float64, (self._view.point_count,), "weights")
        ok(lib.sf_paint_select(self._c, brush, _core.pointer("double", found), ffi.NULL))
        return found

    @documented("sf_paint_values")
    def paint(self, name: str, at_mm: Sequence[float], radius_mm: float, amount: float, *,
              operation: PaintOperation | str = PaintOperation.SET, **brush: Any) -> int:
        """Paint a property with a brush, as `select` takes it. How many values are others now."""
        return self.paint_selected(name, self.select(at_mm, radius_mm, **brush), amount, operation)

    @_core.in_turn
    def paint_selected(self, name: str, weights: Floats, amount: float,
                       operation: PaintOperation | str = PaintOperation.SET) -> int:
        """Paint a property by weights of the points."""
        operation = _core.member(PaintOperation, operation, "operation")
        changed = ffi.new("size_t *")
        ok(lib.sf_paint_values(self._c, self._channel(name), self._weights(weights), int(operation), amount,
                               ffi.NULL, changed))
        return int(changed[0])

    @documented("sf_paint_move")
    @_core.in_turn
    def drag(self, weights: Floats, vector_mm: Sequence[float]) -> int:
        """Move points, each by its weight times a vector. How many are elsewhere now."""
        changed = ffi.new("size_t *")
        ok(lib.sf_paint_move(self._c, self._weights(weights), _core.numbers(list(vector_mm), 3, "vector_mm"),
                             ffi.NULL, changed))
        return int(changed[0])

    @documented("sf_paint_smooth")
    @_core.in_turn
    def smooth(self, weights: Floats, amount: float = 1.0) -> int:
        """Move points towards the means of their neighbours. How many are elsewhere now."""
        changed = ffi.new("size_t *")
        ok(lib.sf_paint_smooth(self._c, self._weights(weights), amount, ffi.NULL, changed))
        return int(changed[0])

    def _weights(self, weights: Floats) -> Any:
        return _core.pointer("double", _core.array_in(weights, np.float64, (self._view.point_count,), "weights"))

    @documented("sf_cage_check")
    def check(self) -> _types.CageReport:
        """How it hangs together, and whether its cells are the right way out."""
        report = ffi.new("sf_cage_report *")
        ok(lib.sf_cage_check(self._c, ffi.NULL, report, ffi.NULL))
        return _core.value(report)  # type: ignore[no-any-return]

    @documented("sf_limit_create")
    def limit(self) -> Limit:
        """The smooth solid that it makes, to be evaluated and sliced."""
        from .limits import Limit

        made: Limit = Limit(self)
        return made

    @documented("sf_refine")
    def refined(self, steps: int = 1) -> Refinement:
        """It after some steps of subdivision, to be changed and made tetrahedra of."""
        from .refining import Refinement

        made: Refinement = Refinement(self, steps)
        return made

    def __repr__(self) -> str:
        v = self._view
        return f"<libsf.Cage {v.point_count} points, {v.cell_count} cells, {list(self.properties)}>"


# --- Undo ---------------------------------------------------------------------------------------


class CageHistory:
    """Undo and redo for a cage that is painted and pulled: to the bit, within so many bytes.

        history = libsf.CageHistory(cage)
        cage.paint("tone", (0, 0, 0), 2, 1)
        history.record()
        history.undo()
    """

    @documented("sf_cage_history_create")
    def __init__(self, cage: Cage, bytes_max: int = 1 << 26) -> None:
        made = ffi.new("sf_cage_history **")
        ok(lib.sf_cage_history_create(cage._c, bytes_max, ffi.NULL, made))
        self._c, self._cage = ffi.gc(made[0], lib.sf_cage_history_destroy), cage

    def _do(self, call: Any) -> int:
        changed = ffi.new("size_t *")
        ok(call(self._c, self._cage._c, changed))
        return int(changed[0])

    @documented("sf_cage_history_record")
    def record(self) -> int:
        """Keep what has changed since the last call as one step; how many numbers are others."""
        return self._do(lib.sf_cage_history_record)

    @documented("sf_cage_history_undo")
    def undo(self) -> int:
        """Undo the last step; 0 where there was none."""
        return self._do(lib.sf_cage_history_undo)

    @documented("sf_cage_history_redo")
    def redo(self) -> int:
        """Redo the step that was undone last; 0 where there was none."""
        return self._do(lib.sf_cage_history_redo)

    @property
    def state(self) -> _types.CageHistoryState:
        """How many steps there are to undo and to redo, and the bytes of both."""
        return _core.value(lib.sf_cage_history_get_state(self._c))  # type: ignore[no-any-return]


__all__ = ["Cage", "CageFormat", "CageHistory", "Falloff", "PaintOperation", "PaintWhere", "Property", "known_property"]
