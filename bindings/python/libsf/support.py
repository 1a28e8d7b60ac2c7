"""What may rest on what, and the operators that make a shape support-free.

Functions that change a shape return a new grid, and leave the one they are given as it is.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Iterable, NamedTuple, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _core, _types
from ._core import Progress, documented, ffi, lib, ok, running
from ._types import Landing, PreserveMode, RuleKind
from .contours import ContourFill, c_contours
from .errors import ArgumentError
from .layers import Element, Layer, c_runs
from .voxel import Grid, Lattice, _lattice, grid_of, grid_or_null

BED_AUTO = 0xFFFFFFFF


@dataclass(frozen=True)
class Rule:
    """What may rest on what: a kind, an angle from the vertical in radians, and bridges.

    `box3` is the papers' rule: a voxel is carried by any of the nine below it; it takes no angle.
    `octagon`, `disk` and `slack` accept overhangs up to the angle, whatever the voxels' proportions.
    """

    kind: RuleKind = RuleKind.BOX3
    angle_rad: float = math.pi / 4
    bridge_span_mm: float = 0.0
    bridge_anchor_mm: float = 0.0

    @classmethod
    def named(cls, name: str, angle_deg: float = 45.0, **more: float) -> Rule:
        """A rule by its name: "box3", "octagon", "disk", "slack"; its angle in degrees."""
        kind = ffi.new("sf_rule_kind *")
        if lib.sf_rule_kind_from_name(_core.text(name, "name"), kind) != 0:
            known = ", ".join(ffi.string(lib.sf_rule_kind_name(k)).decode() for k in RuleKind)
            raise ArgumentError(f"rule: there is no {name!r}; there are {known}")
        return cls(RuleKind(kind[0]), math.radians(angle_deg), **more)

    @property
    def name(self) -> str:
        return ffi.string(lib.sf_rule_kind_name(self.kind)).decode()  # type: ignore[no-any-return]

    @documented("sf_rule_measure")
    def measure(self, lattice: Lattice) -> _types.RuleAngles:
        """What it accepts on a lattice, as angles."""
        found = ffi.new("sf_rule_angles *")
        made = _rule(self, lattice)
        with _lattice(lattice) as c:
            ok(lib.sf_rule_measure(made.c, c, found))
        return _core.value(found)  # type: ignore[no-any-return]


    @documented("sf_rule_element")
    def element(self, lattice: Lattice, layer: int) -> Element:
        """What carries a voxel in one step: the layer above must lie within `layer` dilated by it."""
        c, made = ffi.new("sf_element *"), _rule(self, lattice)
        ok(lib.sf_rule_element(made.c, layer, c))
        return Element._of(c[0])


AnyRule = Union[Rule, str]


def bed_of(bed_layer: int | None, count: int) -> int:
    """The bed's layer as the library has it; one of the layers, or the first that holds matter."""
    if bed_layer is None:
        return BED_AUTO
    if bed_layer != BED_AUTO and not 0 <= bed_layer < count:
        raise ArgumentError(f"bed_layer: {bed_layer}, and the grid's layers are 0 to {count - 1}")
    return bed_layer


class _rule:
    """A rule on a lattice as the library has it; its table must be kept while it is used."""

    def __init__(self, rule: AnyRule, lattice: Lattice) -> None:
        rule = Rule.named(rule) if isinstance(rule, str) else rule
        if not isinstance(rule, Rule):
            raise TypeError(f"rule: {rule!r} is none; give a name, or Rule.named(\"octagon\", 40) for 40 degrees")
        fault = _core.new_fault()
        with _lattice(lattice) as c:
            count = lib.sf_rule_table_count(c)
            self.table = ffi.new("uint64_t[]", count) if count > 0 else ffi.NULL
            self.c = ffi.new("sf_rule *")
            ok(lib.sf_rule_make(rule.kind, rule.angle_rad, c, self.table, self.c, fault), fault)
            if rule.bridge_span_mm > 0:
                ok(lib.sf_rule_set_bridges(self.c, rule.bridge_span_mm, rule.bridge_anchor_mm, c,
                                           fault), fault)


class _terms:
    """Rule, bed and masks as the library has them."""

    def __init__(self, grid: Grid, rule: AnyRule, bed_layer: int | None, exempt: Grid | None = None,
                 keep: Grid | None = None, forbid: Grid | None = None,
                 act: Grid | None = None) -> None:
        self._rule = _rule(rule, grid_of(grid).lattice)
        self._masks = (exempt, keep, forbid, act)
        self.c = ffi.new("sf_terms *", lib.sf_terms_default())
        self.c.rule = self._rule.c[0]
        self.c.bed_layer = bed_of(bed_layer, grid.shape[0])
        for name, mask in zip(("exempt", "keep", "forbid", "act"), self._masks):
            setattr(self.c, name, grid_or_null(mask, name))


# --- Checking -----------------------------------------------------------------------------------


@dataclass(frozen=True)
class Checked:
    """What a check found: the library's report, and the places in the order they were found."""

    report: _types.CheckReport
    findings: Sequence[_types.Finding]

    @property
    def support_free(self) -> bool:
        return bool(self.report.support_free)

    def __bool__(self) -> bool:
        return self.support_free


def _check_options(rule: _rule, width: int, height: int, first_layer: int, bed_layer: int | None,
                   findings: int) -> tuple[Any, Any]:
    places = ffi.new("sf_finding[]", findings) if findings > 0 else ffi.NULL
    c = _core.options("sf_check_options", width=width, height=height, first_layer=first_layer,
                      bed_layer=bed_layer, findings=places, finding_capacity=findings,
                      run_capacity=None if findings > 0 else 0)
    c.rule = rule.c[0]
    return c, places


@documented("sf_grid_check")
def check(grid: Grid, rule: AnyRule = "box3", *, bed_layer: int | None = None, findings: int = 1024,
          progress: Progress = None, threads: int | None = 1) -> Checked:
    """Whether a shape prints without supports, and where it does not.

    `bed_layer` is the layer that rests on the bed, None the first that holds matter; `findings` the
    most places that are told.
    """
    made = _rule(rule, grid_of(grid).lattice)
    nz, ny, nx = grid.shape
    bed_of(bed_layer, nz)
    options, places = _check_options(made, nx, ny, 0, bed_layer, findings)
    report, count = ffi.new("sf_check_report *"), ffi.new("size_t *")
    with running(progress, threads) as task:
        ok(lib.sf_grid_check(grid._c, options, ffi.NULL, task, report, count))
    return Checked(_core.value(report), _core.Values(places, count[0]))


class Checker(_core.InTurn):
    """A check of layers as they come, from the bottom up, in memory of a few layers.

        checker = Checker(width=1440, height=2560)
        for layer in layers:      # bool arrays (y, x), or bytes of grey with a threshold
            checker.push(layer)
        checker.report().support_free
    """

    @documented("sf_checker_place")
    def __init__(self, width: int, height: int, rule: AnyRule = "box3", *,
                 pitch_mm: float | tuple[float, float] = 1.0, layer_mm: float = 1.0,
                 bed_layer: int | None = None, findings: int = 1024, layer_runs: int = 0) -> None:
        """`layer_runs`: a layer pushed as at most that many runs, which all rest, is not painted."""
        lattice = Lattice(width, height, 1, pitch_mm, layer_mm)  # type: ignore[arg-type]
        self._lattice = lattice
        self._rule = _rule(rule, lattice)
        self._options, self._places = _check_options(self._rule, width, height, 0, bed_layer,
                                                     findings)
        self._options.layer_run_capacity = layer_runs
        size, made = ffi.new("size_t *"), ffi.new("sf_checker **")
        ok(lib.sf_checker_size(self._options, size))
        self._memory = ffi.new("char[]", size[0] + 64)
        start = int(ffi.cast("uintptr_t", self._memory))
        aligned = ffi.cast("void *", start + (-start) % 64)
        ok(lib.sf_checker_place(self._options, aligned, size[0], made))
        self._c = made[0]
        self._shape = (height, width)

    @_core.in_turn
    def push(self, layer: Any, threshold: int | None = None) -> None:
        """The next layer: a Layer, an array of bools (y, x), or of uint8, solid from `threshold` on."""
        if isinstance(layer, Layer):
            ok(lib.sf_checker_push(self._c, layer._c))
            return
        if not isinstance(layer, np.ndarray):
            layer = np.asarray(layer, np.bool_)
        if layer.shape != self._shape:
            raise ValueError(f"layer: its shape is {layer.shape}, and {self._shape} is needed")
        if threshold is not None:
            grey = _core.array_in(layer, np.uint8, self._shape, "layer")
            ok(lib.sf_checker_push_grey(self._c, _core.pointer("uint8_t", grey), self._shape[1],
                                        threshold))
            return
        if layer.dtype != np.bool_:
            raise TypeError(f"layer: the array is of {layer.dtype}, and bool is needed; or give a "
                            "threshold for uint8")
        ok(lib.sf_checker_push(self._c, Layer.from_array(layer)._c))

    @documented("sf_checker_push_runs")
    @_core.in_turn
    def push_runs(self, runs: npt.NDArray[np.void]) -> None:
        """The next layer as runs, as `Layer.runs()` gives them."""
        ok(lib.sf_checker_push_runs(self._c, *c_runs(runs)))

    @documented("sf_checker_push_contours")
    @_core.in_turn
    def push_contours(self, polygons: Iterable[Any], fill: ContourFill = ContourFill.NONZERO) -> None:
        """The next layer as closed polygons of points (n, 2), in mm from the corner of the first voxel."""
        fault = _core.new_fault()
        with _lattice(self._lattice) as on, c_contours(polygons) as c:
            ok(lib.sf_checker_push_contours(self._c, on, c, int(fill), ffi.NULL, fault), fault)

    @documented("sf_checker_report")
    @_core.in_turn
    def report(self) -> Checked:
        """What was found so far."""
        report, count = ffi.new("sf_check_report *"), ffi.new("size_t *")
        ok(lib.sf_checker_report(self._c, report, count))
        kept = ffi.new("sf_finding[]", max(count[0], 1))
        ffi.memmove(kept, self._places, count[0] * ffi.sizeof("sf_finding"))
        return Checked(_core.value(report), _core.Values(kept, count[0]))


@documented("sf_grid_unsupported")
def unsupported(grid: Grid, rule: AnyRule = "box3", *, bed_layer: int | None = None,
                exempt: Grid | None = None, progress: Progress = None) -> Grid:
    """The voxels that nothing carries, each on its own."""
    found = Grid(grid_of(grid).lattice)
    terms = _terms(grid, rule, bed_layer, exempt)
    with running(progress) as task:
        ok(lib.sf_grid_unsupported(grid._c, terms.c, ffi.NULL, task, found._c, ffi.NULL))
    return found


# --- Operators ----------------------------------------------------------------------------------


class Trimmed(NamedTuple):
    grid: Grid
    report: _types.TrimReport


class Grown(NamedTuple):
    grid: Grid
    report: _types.GrowReport


class Repaired(NamedTuple):
    grid: Grid
    report: _types.RepairReport


class Preserved(NamedTuple):
    grid: Grid
    report: _types.PreserveReport


@documented("sf_grid_trim", "sf_grid_trim_on")
def trim(grid: Grid, rule: AnyRule = "box3", *, bed_layer: int | None = None,
         exempt: Grid | None = None, keep: Grid | None = None, act: Grid | None = None,
         progress: Progress = None) -> Trimmed:
    """The largest support-free part of a shape; with masks an error where what must stay cannot."""
    result, report = grid_of(grid).copy(), ffi.new("sf_trim_report *")
    terms = _terms(grid, rule, bed_layer, exempt, keep, None, act)
    with running(progress) as task:
        if exempt is None and keep is None and act is None:
            ok(lib.sf_grid_trim(result._c, terms._rule.c, terms.c.bed_layer, task, report))
        else:
            ok(lib.sf_grid_trim_on(result._c, terms.c, ffi.NULL, task, ffi.NULL, report))
    return Trimmed(result, _core.value(report))


@documented("sf_grid_trim_box")
def update_trim(drawn: Grid, printable: Grid, box: _types.Box, rule: AnyRule = "box3", *,
                bed_layer: int | None = None) -> _types.Box:
    """Bring printable = trim(drawn), in place, up to date after `drawn` changed within a box.

    The box around the voxels of `printable` that are others now.
    """
    made, changed = _rule(rule, drawn.lattice), ffi.new("sf_box *")
    ok(lib.sf_grid_trim_box(drawn._c, printable._c, made.c, BED_AUTO if bed_layer is None else bed_layer,
                            _box(box), changed))
    return _core.value(changed)  # type: ignore[no-any-return]


def _box(box: _types.Box) -> Any:
    return {name: getattr(box, name) for name in ("x0", "y0", "z0", "x1", "y1", "z1")}


@documented("sf_grid_grow")
def grow(grid: Grid, rule: AnyRule = "box3", *, bed_layer: int | None = None,
         exempt: Grid | None = None, forbid: Grid | None = None, act: Grid | None = None,
         progress: Progress = None, threads: int | None = 1) -> Grown:
    """The shape with what it lacks to be support-free; nothing is removed."""
    result, report = grid_of(grid).copy(), ffi.new("sf_grow_report *")
    terms = _terms(grid, rule, bed_layer, exempt, None, forbid, act)
    with running(progress, threads) as task:
        ok(lib.sf_grid_grow(result._c, terms.c, ffi.NULL, task, ffi.NULL, report))
    return Grown(result, _core.value(report))


def _costs(costs: Any, grid: Grid, name: str) -> npt.NDArray[np.uint8] | None:
    return None if costs is None else _core.array_in(costs, np.uint8, grid.shape, name)


@documented("sf_grid_repair")
def repair(grid: Grid, rule: AnyRule = "box3", *, bed_layer: int | None = None,
           exempt: Grid | None = None, keep: Grid | None = None, forbid: Grid | None = None,
           act: Grid | None = None, add_cost: Any = None, remove_cost: Any = None,
           min_feature_vx: int | None = None, rounds: int | None = None, progress: Progress = None,
           threads: int | None = 1) -> Repaired:
    """The shape made support-free by adding here and removing there, at least cost.

    Costs are uint8 arrays in (layer, y, x) order: what a voxel costs to add, and to remove.
    """
    result, report = grid_of(grid).copy(), ffi.new("sf_repair_report *")
    terms = _terms(grid, rule, bed_layer, exempt, keep, forbid, act)
    added, removed = _costs(add_cost, grid, "add_cost"), _costs(remove_cost, grid, "remove_cost")
    options = _core.options("sf_repair_options", min_feature_vx=min_feature_vx, rounds=rounds)
    options.terms = terms.c[0]
    options.add_cost = _core.pointer("uint8_t", added)
    options.remove_cost = _core.pointer("uint8_t", removed)
    with running(progress, threads) as task:
        ok(lib.sf_grid_repair(result._c, options, ffi.NULL, task, ffi.NULL, report))
    return Repaired(result, _core.value(report))


@documented("sf_grid_preserve")
def preserve(grid: Grid, brush: Grid, rule: AnyRule = "box3", *, bed_layer: int | None = None,
             exempt: Grid | None = None, keep: Grid | None = None, forbid: Grid | None = None,
             act: Grid | None = None, mode: PreserveMode | None = None,
             must_go: Grid | None = None, strut_width: int | None = None,
             accept_unsupported: bool | None = None, progress: Progress = None,
             threads: int | None = 1) -> Preserved:
    """The shape without a brush, but for what of the brush carries the rest."""
    result, report = grid_of(grid).copy(), ffi.new("sf_preserve_report *")
    terms = _terms(grid, rule, bed_layer, exempt, keep, forbid, act)
    options = _core.options("sf_preserve_options", mode=mode, strut_width=strut_width,
                            accept_unsupported=accept_unsupported)
    if must_go is not None:
        options.must_go = must_go._c
    with running(progress, threads) as task:
        ok(lib.sf_grid_preserve(result._c, brush._c, terms.c, options, ffi.NULL, task, report))
    return Preserved(result, _core.value(report))


__all__ = [
    "Checked", "Checker", "Grown", "Landing", "Preserved", "Repaired", "Rule", "Trimmed", "check",
    "grow", "preserve", "repair", "trim", "unsupported", "update_trim",
]
