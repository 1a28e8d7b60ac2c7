"""Sculpting by program: strokes after each of which the shape prints without supports."""

from __future__ import annotations

from contextlib import contextmanager
from typing import Any, Callable, Iterator, Sequence

import numpy as np
import numpy.typing as npt

from . import _core, _files, _types
from ._core import documented, ffi, lib, ok
from ._types import BrushKind, TipShape
from .mesh import as_mesh
from .support import AnyRule, _rule
from .voxel import Grid, Lattice, _lattice, lattice_of

Triple = Sequence[float]


class Tip:
    """The voxels that a brush covers."""

    def __init__(self, c: Any) -> None:
        self._c = ffi.gc(c, lib.sf_tip_destroy)

    @classmethod
    @documented("sf_tip_create")
    def shaped(cls, shape: TipShape | str, radius_vx: float | Triple) -> Tip:
        """A sphere, box, cylinder or cone; half its extents in voxels."""
        shape = _core.member(TipShape, shape, "shape")
        radius = _core.numbers(_core.for_each(radius_vx, 3), 3, "radius_vx")
        made = ffi.new("sf_tip **")
        ok(lib.sf_tip_create(int(shape), radius, ffi.NULL, made))
        return cls(made[0])

    @classmethod
    @documented("sf_tip_create_mask")
    def of(cls, mask: Grid, anchor: Sequence[int] | None = None) -> Tip:
        """The solid voxels of a grid; the anchor (x, y, z), which comes to lie on each dab, is the
        middle where none is given."""
        nz, ny, nx = mask.shape
        x, y, z = (nx // 2, ny // 2, nz // 2) if anchor is None else anchor
        made = ffi.new("sf_tip **")
        ok(lib.sf_tip_create_mask(mask._c, (x, y, z), ffi.NULL, made))
        return cls(made[0])

    @classmethod
    @documented("sf_tip_create_stamp")
    def stamp(cls, heights: npt.NDArray[np.uint8], depth_vx: int) -> Tip:
        """A relief of an image of heights, (y, x) of uint8."""
        image = _core.array_in(heights, np.uint8, (None, None), "heights")
        made = ffi.new("sf_tip **")
        ok(lib.sf_tip_create_stamp(_core.pointer("uint8_t", image), image.shape[1], image.shape[1],
                                   image.shape[0], depth_vx, ffi.NULL, made))
        return cls(made[0])

    @documented("sf_tip_mask")
    def mask(self) -> tuple[Grid, tuple[int, int, int]]:
        """The voxels that it covers, as a copy, and the anchor's place (x, y, layer) among them."""
        anchor = ffi.new("sf_dab *")
        grid = Grid._borrowed(lib.sf_tip_mask(self._c, anchor), self)
        return grid, (anchor.x, anchor.y, anchor.z)

    @classmethod
    def mesh(cls, mesh: Any, lattice: Lattice) -> Tip:
        """A mesh as voxels of a model's pitch, about the middle of its box."""
        from .mesh import voxelize

        mesh = as_mesh(mesh)
        low, high = mesh.bounds()
        layer = lattice.layer_mm if isinstance(lattice.layer_mm, float) else lattice.layer_mm[0]
        return cls.of(voxelize(mesh, Lattice.around(low, high, lattice.pitch_mm[0], layer)))


class Sculpt(_core.InTurn):
    """A model that is support-free after every stroke.

        model = libsf.Sculpt(libsf.Lattice(128, 128, 128, 0.25, 0.25))
        model.stroke("add-trim", libsf.Tip.shaped("sphere", 10), [(64, 64, 0)])
        model.printable().count()
    """

    @documented("sf_sculpt_create")
    def __init__(self, lattice: Lattice, rule: AnyRule = "box3", *, bed_layer: int = 0,
                 keep_drawn: bool = False, history_size: int | None = None) -> None:
        self._rule = _rule(rule, lattice)
        options = _core.options("sf_sculpt_options", bed_layer=bed_layer, keep_drawn=int(keep_drawn),
                                history_size=history_size)
        made = ffi.new("sf_sculpt **")
        with _lattice(lattice) as c:
            options.lattice = c[0]
            options.rule = self._rule.c[0]
            ok(lib.sf_sculpt_create(options, ffi.NULL, made))
        self._c = ffi.gc(made[0], lib.sf_sculpt_destroy)
        self._lattice = lattice

    @property
    def lattice(self) -> Lattice:
        return self._lattice

    @_core.in_turn
    def printable(self) -> Grid:
        """What prints without supports; a copy."""
        return Grid._borrowed(lib.sf_sculpt_printable(self._c), self)

    @_core.in_turn
    def drawn(self) -> Grid:
        """What was drawn, ghosts included; a copy."""
        return Grid._borrowed(lib.sf_sculpt_drawn(self._c), self)

    @property
    def materials(self) -> npt.NDArray[np.uint8]:
        """A byte for each voxel, (layer, y, x); the model's own memory, to be read."""
        return _core.memory(lib.sf_sculpt_materials(self._c), "uint8", self._lattice.shape, self._c)

    @documented("sf_sculpt_stroke")
    @_core.in_turn
    def stroke(self, kind: BrushKind | str, tip: Tip, dabs: Any, *, material: int = 1,
               passes: int = 1, mirror_x: bool = False, mirror_y: bool = False) -> _types.SculptChange:
        """A stroke: a brush put down at voxels (x, y, z), all at once."""
        brush = c_brush(kind, tip, material, passes, mirror_x, mirror_y)
        places, change = c_dabs(dabs), ffi.new("sf_sculpt_change *")
        ok(lib.sf_sculpt_stroke(self._c, brush, places.c, places.count, change))
        return _core.value(change)  # type: ignore[no-any-return]

    @_core.in_turn
    def _do(self, call: Any, *given: Any) -> None:
        ok(call(self._c, *given))

    @contextmanager
    @documented("sf_sculpt_begin", "sf_sculpt_end", "sf_sculpt_abandon")
    def stroking(self, kind: BrushKind | str, tip: Tip, *, material: int = 1, passes: int = 1,
                 mirror_x: bool = False, mirror_y: bool = False) -> Iterator[Callable[[Any], _types.SculptChange]]:
        """A stroke that grows: each call of what it gives puts the brush on more places.

            with model.stroking("add-trim", tip) as dab:
                dab([(64, 64, 0)])
                dab([(65, 64, 0)])

        What is raised inside gives the stroke up: the model is as it was before it.
        """
        self._do(lib.sf_sculpt_begin, c_brush(kind, tip, material, passes, mirror_x, mirror_y))

        def dab(dabs: Any) -> _types.SculptChange:
            places, change = c_dabs(dabs), ffi.new("sf_sculpt_change *")
            self._do(lib.sf_sculpt_dab, places.c, places.count, change)
            return _core.value(change)  # type: ignore[no-any-return]

        try:
            yield dab
        except BaseException:
            self._do(lib.sf_sculpt_abandon, ffi.NULL)
            raise
        self._do(lib.sf_sculpt_end, ffi.NULL)

    @documented("sf_sculpt_drop_ghosts")
    @_core.in_turn
    def drop_ghosts(self) -> _types.SculptChange:
        """Let what was trimmed and kept as a ghost go."""
        change = ffi.new("sf_sculpt_change *")
        ok(lib.sf_sculpt_drop_ghosts(self._c, change))
        return _core.value(change)  # type: ignore[no-any-return]

    @staticmethod
    @documented("sf_dab_line")
    def line(start: Sequence[int], end: Sequence[int]) -> npt.NDArray[np.int32]:
        """The voxels of a line, both ends included, for strokes along it."""
        count = ffi.new("size_t *")
        a, b = tuple(map(int, start)), tuple(map(int, end))
        lib.sf_dab_line(a, b, ffi.NULL, 0, count)
        found = np.empty((count[0], 3), np.int32)
        ok(lib.sf_dab_line(a, b, ffi.cast("sf_dab *", ffi.from_buffer(found)), count[0], count))
        return found

    @_core.in_turn
    def _step(self, call: Any) -> _types.SculptChange | None:
        change = ffi.new("sf_sculpt_change *")
        status = call(self._c, change)
        if status == int(_types.Status.ERR_INFEASIBLE):
            return None
        ok(status)
        return _core.value(change)  # type: ignore[no-any-return]

    @documented("sf_sculpt_undo")
    def undo(self) -> _types.SculptChange | None:
        """Undo a step; None where there is none."""
        return self._step(lib.sf_sculpt_undo)

    @documented("sf_sculpt_redo")
    def redo(self) -> _types.SculptChange | None:
        """Redo a step; None where there is none."""
        return self._step(lib.sf_sculpt_redo)

    @property
    def history(self) -> _types.SculptHistory:
        return _core.value(lib.sf_sculpt_history_of(self._c))  # type: ignore[no-any-return]

    @documented("sf_sculpt_replace")
    @_core.in_turn
    def replace(self, drawn: Grid | None, materials: Any = None) -> _types.SculptChange:
        """Another shape in the place of all; None is an empty one."""
        ids = None if materials is None else _core.array_in(materials, np.uint8,
                                                            self._lattice.shape, "materials")
        change = ffi.new("sf_sculpt_change *")
        ok(lib.sf_sculpt_replace(self._c, ffi.NULL if drawn is None else drawn._c,
                                 _core.pointer("uint8_t", ids), change))
        return _core.value(change)  # type: ignore[no-any-return]

    @classmethod
    @documented("sf_session_read", "sf_session_replay")
    def replay(cls, of: _files.Readable) -> Sculpt:
        """The model that a session in a file makes; see Session for the session itself."""
        from .sessions import Session

        model: Sculpt = Session.load(of).replay()
        return model

    @classmethod
    def _of(cls, c: Any, kept: Any) -> Sculpt:
        """A model of the library's, and what its rule's table belongs to."""
        model = cls.__new__(cls)
        model._c, model._rule = ffi.gc(c, lib.sf_sculpt_destroy), kept
        model._lattice = lattice_of(lib.sf_sculpt_options_of(model._c).lattice)
        return model


# --- Brushes as the library has them ------------------------------------------------------------


def kind_of(kind: BrushKind | str) -> BrushKind:
    return _core.member(BrushKind, kind, "kind")


@documented("sf_brush_kind_name")
def brush_name(kind: BrushKind) -> str:
    """Its name as a person types it: "add-trim"."""
    name = lib.sf_brush_kind_name(int(kind))
    if name == ffi.NULL:
        raise ValueError(f"{kind} is no kind of brush")
    return ffi.string(name).decode()  # type: ignore[no-any-return]


def c_brush(kind: BrushKind | str, tip: Tip | None, material: int, passes: int, mirror_x: bool,
            mirror_y: bool) -> Any:
    brush = _core.options("sf_brush", kind=int(kind_of(kind)), material=material, passes=passes,
                          mirror_x=int(mirror_x), mirror_y=int(mirror_y))
    if tip is not None:
        brush.tip = tip._c
    return brush


class c_dabs:
    """Voxels (n, 3) as dabs; the array must be kept while they are used."""

    def __init__(self, dabs: Any) -> None:
        array = _core.whole_numbers(dabs, np.int32, "dabs")
        if array.size > 0 and (array.ndim > 2 or array.shape[-1] != 3):
            raise ValueError(f"dabs: their shape is {array.shape}, and (n, 3) or (3,) is needed")
        self._array = array.reshape(-1, 3)
        self.count = len(self._array)
        self.c = ffi.cast("sf_dab *", ffi.from_buffer(self._array)) if self.count else ffi.NULL


__all__ = ["BrushKind", "Sculpt", "Tip", "TipShape", "brush_name"]
