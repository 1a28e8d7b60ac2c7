"""What a check looks for beside supports: voids, the steepest overhang, what mending costs.

And what can be asked before an operator is called: whether masks leave it any way at all.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple, Sequence

import numpy as np
import numpy.typing as npt

from . import _core, _types
from ._core import Progress, documented, ffi, lib, ok, running
from ._types import Connectivity
from .layers import Layer
from .support import BED_AUTO, AnyRule, Checked, _terms
from .voxel import Grid


def bed(layer: int | None) -> int:
    """A bed layer as the library has it."""
    return BED_AUTO if layer is None else layer


# --- Voids --------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Voids:
    """What resin or powder cannot leave: the counts, and the voids from the lowest top up."""

    report: _types.VoidsReport
    voids: Sequence[_types.Void]


@documented("sf_grid_voids")
def voids(grid: Grid, *, bed_layer: int | None = None, bed_is_open: bool = False,
          cup_area_min: int = 0, cup_layers_min: int = 0, limit: int = 1024,
          progress: Progress = None) -> Voids:
    """The traps of a shape, and the cups that it makes while it prints; at most `limit` are told."""
    places, count = ffi.new("sf_void[]", max(limit, 1)), ffi.new("size_t *")
    report = ffi.new("sf_voids_report *")
    options = _core.options("sf_voids_options", bed_layer=bed(bed_layer),
                            bed_is_open=int(bed_is_open), cup_area_min=cup_area_min,
                            cup_layers_min=cup_layers_min, voids=places, void_capacity=limit)
    with running(progress) as task:
        ok(lib.sf_grid_voids(grid._c, options, ffi.NULL, task, report, count))
    return Voids(_core.value(report), _core.Values(places, count[0]))


class VoidSearch:
    """The same of layers as they come, from the bottom up.

        search = libsf.VoidSearch(1440, 2560)
        for layer in job:
            search.push(layer)
        search.finish().report.trap_count
    """

    @documented("sf_void_search_create")
    def __init__(self, width: int, height: int, *, bed_layer: int | None = None,
                 bed_is_open: bool = False, cup_area_min: int = 0, cup_layers_min: int = 0,
                 limit: int = 1024) -> None:
        self._places, made = ffi.new("sf_void[]", max(limit, 1)), ffi.new("sf_void_search **")
        options = _core.options("sf_voids_options", bed_layer=bed(bed_layer),
                                bed_is_open=int(bed_is_open), cup_area_min=cup_area_min,
                                cup_layers_min=cup_layers_min, voids=self._places,
                                void_capacity=limit)
        ok(lib.sf_void_search_create(options, width, height, ffi.NULL, made))
        self._c = ffi.gc(made[0], lib.sf_void_search_destroy)

    @documented("sf_void_search_push")
    def push(self, layer: Layer) -> None:
        """The next layer."""
        ok(lib.sf_void_search_push(self._c, layer._c))

    @documented("sf_void_search_finish")
    def finish(self) -> Voids:
        """What was found; the search takes no more layers."""
        report, count = ffi.new("sf_voids_report *"), ffi.new("size_t *")
        ok(lib.sf_void_search_finish(self._c, report, count))
        return Voids(_core.value(report), _core.Values(self._places, count[0]))


# --- Overhangs ----------------------------------------------------------------------------------


@documented("sf_grid_steepest")
def steepest(grid: Grid, *, bed_layer: int | None = None, progress: Progress = None) -> _types.Steepest:
    """The steepest overhang that a shape has, as an angle from the vertical."""
    found = ffi.new("sf_steepest *")
    with running(progress) as task:
        ok(lib.sf_grid_steepest(grid._c, bed(bed_layer), ffi.NULL, task, found))
    return _core.value(found)  # type: ignore[no-any-return]


class Costs(NamedTuple):
    """What mending each finding takes, the order of the dearest first, and the matter to add."""

    costs: Sequence[_types.FindingCost]
    order: npt.NDArray[np.uint32]
    added: Grid


@documented("sf_findings_cost", "sf_findings_rank")
def costs(grid: Grid, checked: Checked, rule: AnyRule = "box3", *, bed_layer: int | None = None,
          forbid: Grid | None = None, act: Grid | None = None, progress: Progress = None) -> Costs:
    """What it takes to mend each finding of a check of this shape, under the rule it was made by."""
    terms, count = _terms(grid, rule, bed_layer, None, None, forbid, act), len(checked.findings)
    findings = checked.findings._c if isinstance(checked.findings, _core.Values) else ffi.NULL
    found, added = ffi.new("sf_finding_cost[]", max(count, 1)), Grid(grid.lattice)
    with running(progress) as task:
        ok(lib.sf_findings_cost(grid._c, terms.c, findings, count, ffi.NULL, task, found, added._c))
    order = np.empty(count, np.uint32)
    ok(lib.sf_findings_rank(findings, found, count, _core.pointer("uint32_t", order)))
    return Costs(_core.Values(found, count), order, added)


# --- Before operators ---------------------------------------------------------------------------


@documented("sf_grid_feasible")
def culprits(allowed: Grid, needed: Grid, rule: AnyRule = "box3", *, bed_layer: int | None = None,
             exempt: Grid | None = None, progress: Progress = None) -> Grid:
    """The voxels of `needed` that nothing within `allowed` can carry; none: it is possible."""
    found = Grid(allowed.lattice)
    terms = _terms(allowed, rule, bed_layer, exempt)
    with running(progress) as task:
        status = lib.sf_grid_feasible(allowed._c, needed._c, terms.c, ffi.NULL, task, found._c, ffi.NULL)
        if status != int(_types.Status.ERR_INFEASIBLE):
            ok(status)
    return found


@documented("sf_grid_complete")
def complete(shape: Grid, needed: Grid, rule: AnyRule = "box3", *, bed_layer: int | None = None,
             exempt: Grid | None = None, progress: Progress = None) -> Grid:
    """A support-free part of a support-free shape that holds what must stay, and little else."""
    found, terms = Grid(shape.lattice), _terms(shape, rule, bed_layer, exempt)
    with running(progress) as task:
        ok(lib.sf_grid_complete(shape._c, needed._c, terms.c, ffi.NULL, task, found._c))
    return found


# --- Printing -----------------------------------------------------------------------------------


class Printing(NamedTuple):
    """How a print stands: the worst of it, and the margin after each layer in radians."""

    report: _types.PrintingReport
    margins_rad: npt.NDArray[np.float64]


@documented("sf_grid_printing")
def printing(grid: Grid, *, bed_layer: int | None = None,
             connectivity: Connectivity = Connectivity.CORNERS, progress: Progress = None) -> Printing:
    """How far a part is from toppling after each of its layers."""
    margins, report = np.empty(grid.shape[0]), ffi.new("sf_printing_report *")
    options = _core.options("sf_printing_options", bed_layer=bed(bed_layer),
                            connectivity=int(connectivity), margins_rad=_core.pointer("double", margins),
                            margin_capacity=len(margins))
    with running(progress) as task:
        ok(lib.sf_grid_printing(grid._c, options, ffi.NULL, task, report))
    return Printing(_core.value(report), margins)


__all__ = ["Costs", "Printing", "Voids", "complete", "costs", "culprits", "printing", "steepest", "voids"]
