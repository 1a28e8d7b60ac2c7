"""Sessions: strokes and other steps on a model, kept, written and played again, bit for bit."""

from __future__ import annotations

from typing import Any, NamedTuple, Sequence

import numpy as np
import numpy.typing as npt

from . import _core, _files, _types
from ._core import Progress, documented, ffi, lib, ok, running
from ._types import BrushKind, SessionStep, TipShape
from .sculpting import Sculpt, c_brush, c_dabs
from .support import AnyRule, Rule
from .voxel import Grid, Lattice, _lattice, lattice_of


class Stroke(NamedTuple):
    """A step that is a stroke."""

    kind: BrushKind
    material: int
    passes: int
    mirror_x: bool
    mirror_y: bool
    dabs: npt.NDArray[np.int32]


class Session:
    """A list of steps in a space; it holds the tips of its strokes by their numbers.

        session = libsf.Session(libsf.Lattice(64, 64, 64, 0.5, 0.5))
        ball = session.add_tip("sphere", 6)
        session.stroke("add-trim", ball, [(32, 32, 0)])
        session.save("ball.session")
        model = session.replay()
    """

    _c: Any

    @documented("sf_session_create")
    def __init__(self, lattice: Lattice, rule: AnyRule = "box3", *, bed_layer: int = 0,
                 keep_drawn: bool = False, history_size: int | None = None) -> None:
        rule = Rule.named(rule) if isinstance(rule, str) else rule
        options = _core.options("sf_session_options", rule=int(rule.kind), angle_rad=rule.angle_rad,
                                bed_layer=bed_layer, keep_drawn=int(keep_drawn), history_size=history_size)
        made = ffi.new("sf_session **")
        with _lattice(lattice) as c:
            options.lattice = c[0]
            ok(lib.sf_session_create(options, ffi.NULL, made))
        self._c = ffi.gc(made[0], lib.sf_session_destroy)

    @classmethod
    @documented("sf_session_read")
    def load(cls, of: _files.Readable) -> Session:
        """Read one: a path, bytes, or a file that is open."""
        made, fault = ffi.new("sf_session **"), _core.new_fault()
        with _files.source(of) as source:
            ok(lib.sf_session_read(source, 0, ffi.NULL, made, fault), fault)
        session = cls.__new__(cls)
        session._c = ffi.gc(made[0], lib.sf_session_destroy)
        return session

    @documented("sf_session_write")
    def save(self, to: _files.Writable) -> None:
        """Write it as text."""
        with _files.sink(to) as sink:
            ok(lib.sf_session_write(self._c, sink))

    @property
    def lattice(self) -> Lattice:
        """The space."""
        return lattice_of(lib.sf_session_options_of(self._c).lattice)

    @property
    def counts(self) -> _types.SessionCounts:
        """How many tips, steps, strokes and dabs it has, and whether the state at its end."""
        return _core.value(lib.sf_session_count(self._c))  # type: ignore[no-any-return]

    # --- Steps ---

    @documented("sf_session_add_tip")
    def add_tip(self, shape: TipShape | str, radius_vx: float | Sequence[float]) -> int:
        """A tip by formula; its number."""
        shape = _core.member(TipShape, shape, "shape")
        radius = _core.numbers(_core.for_each(radius_vx, 3), 3, "radius_vx")
        number = ffi.new("uint32_t *")
        ok(lib.sf_session_add_tip(self._c, int(shape), radius, number))
        return int(number[0])

    @documented("sf_session_add_mask")
    def add_mask(self, mask: Grid, anchor: Sequence[int] | None = None) -> int:
        """A tip of the solid voxels of a grid, its anchor (x, y, layer) the middle; its number."""
        nz, ny, nx = mask.shape
        x, y, z = (nx // 2, ny // 2, nz // 2) if anchor is None else anchor
        number = ffi.new("uint32_t *")
        ok(lib.sf_session_add_mask(self._c, mask._c, (x, y, z), number))
        return int(number[0])

    @documented("sf_session_tip")
    def tip_mask(self, tip: int) -> Grid:
        """The voxels that a tip covers; a copy."""
        if not 0 <= tip < self.counts.tips:
            raise IndexError(f"tip {tip} of {self.counts.tips}")
        return Grid._borrowed(lib.sf_tip_mask(lib.sf_session_tip(self._c, tip), ffi.NULL), self)

    @documented("sf_session_add_stroke")
    def stroke(self, kind: BrushKind | str, tip: int, dabs: Any, *, material: int = 1, passes: int = 1,
               mirror_x: bool = False, mirror_y: bool = False) -> None:
        """A stroke of a tip at voxels (x, y, z)."""
        places = c_dabs(dabs)
        ok(lib.sf_session_add_stroke(self._c, c_brush(kind, None, material, passes, mirror_x, mirror_y),
                                     tip, places.c, places.count))

    @documented("sf_session_add_step")
    def step(self, step: SessionStep | str) -> None:
        """A step that is no stroke: "undo", "redo", "drop_ghosts"."""
        ok(lib.sf_session_add_step(self._c, int(_core.member(SessionStep, step, "step"))))

    @documented("sf_session_add_shape")
    def replace(self, drawn: Grid, materials: Any = None) -> None:
        """A shape that takes the place of what is drawn."""
        ids = None if materials is None else _core.array_in(materials, np.uint8, drawn.shape, "materials")
        ok(lib.sf_session_add_shape(self._c, drawn._c, _core.pointer("uint8_t", ids)))

    @documented("sf_session_keep_state")
    def keep_state(self, model: Sculpt | None) -> None:
        """Keep the state of a model as that at the end; None keeps none."""
        ok(lib.sf_session_keep_state(self._c, ffi.NULL if model is None else model._c))

    @documented("sf_session_stroke")
    def __getitem__(self, step: int) -> Stroke | None:
        """A step, where it is a stroke; else None."""
        if not 0 <= step < len(self):
            raise IndexError(f"step {step} of {len(self)}")
        brush, dabs, count = ffi.new("sf_brush *"), ffi.new("sf_dab **"), ffi.new("size_t *")
        if not lib.sf_session_stroke(self._c, step, brush, ffi.cast("const sf_dab **", dabs), count):
            return None
        places = np.array(_core.memory(dabs[0], "int32", (count[0], 3), self._c))
        return Stroke(BrushKind(brush.kind), brush.material, brush.passes, bool(brush.mirror_x),
                      bool(brush.mirror_y), places)

    def __len__(self) -> int:
        """How many steps there are."""
        return int(self.counts.steps)

    # --- Playing ---

    @documented("sf_session_begin")
    def begin(self) -> Sculpt:
        """An empty model in its space, to `play` steps on."""
        made = ffi.new("sf_sculpt **")
        ok(lib.sf_session_begin(self._c, ffi.NULL, made))
        return Sculpt._of(made[0], self._c)

    @documented("sf_session_play")
    def play(self, step: int, model: Sculpt) -> _types.SculptChange:
        """Do one step on a model."""
        change = ffi.new("sf_sculpt_change *")
        ok(lib.sf_session_play(self._c, step, ffi.NULL, model._c, change))
        return _core.value(change)  # type: ignore[no-any-return]

    @documented("sf_session_replay")
    def replay(self, *, progress: Progress = None) -> Sculpt:
        """Do all steps on a new model."""
        made = ffi.new("sf_sculpt **")
        with running(progress) as task:
            ok(lib.sf_session_replay(self._c, ffi.NULL, task, made))
        return Sculpt._of(made[0], self._c)

    @documented("sf_session_open")
    def open(self) -> Sculpt:
        """The state that is kept, without playing."""
        made = ffi.new("sf_sculpt **")
        ok(lib.sf_session_open(self._c, ffi.NULL, made))
        return Sculpt._of(made[0], self._c)

    def __repr__(self) -> str:
        counts = self.counts
        return f"<libsf.Session {counts.steps} steps, {counts.tips} tips>"


__all__ = ["Session", "SessionStep", "Stroke"]
