"""Stacks of layers in folders: layer_00000.png and so on, and stack.json, which says it all."""

from __future__ import annotations

from typing import Any, Iterable, NamedTuple, Sequence

import numpy as np
import numpy.typing as npt

from . import _core, _files, _types
from ._core import Progress, documented, ffi, lib, ok, running
from ._types import RuleKind
from .support import BED_AUTO, Rule
from .voxel import Grid, Lattice, _lattice, grid_of


class Stack(NamedTuple):
    grid: Grid
    rule: Rule | None
    bed_layer: int | None


@documented("sf_stack_write")
def save_stack(grid: Grid, folder: _files.Path, *, rule: Rule | None = None,
               bed_layer: int | None = None, progress: Progress = None) -> None:
    """Write a grid as a stack; the folder shows when it is whole, or not at all."""
    info, fault = ffi.new("sf_stack_info *"), _core.new_fault()
    if rule is not None:
        info.has_rule, info.rule, info.angle_rad = 1, int(rule.kind), rule.angle_rad
        info.bridge_span_mm, info.bridge_anchor_mm = rule.bridge_span_mm, rule.bridge_anchor_mm
    info.bed_layer = BED_AUTO if bed_layer is None else bed_layer
    with _files.folder_to_write(folder) as to, running(progress) as task:
        ok(lib.sf_stack_write(grid_of(grid)._c, info, to, task, fault), fault)


@documented("sf_stack_read")
def load_stack(folder: _files.Path, *, progress: Progress = None) -> Stack:
    """Read a stack: its grid, and the rule and bed that it was made for, if it says so."""
    info, fault = ffi.new("sf_stack_info *"), _core.new_fault()
    found = ffi.new("sf_grid **")
    with _files.folder_to_read(folder) as of, running(progress) as task:
        ok(lib.sf_stack_read(of, ffi.NULL, task, found, info, fault), fault)
    rule = Rule(RuleKind(info.rule), info.angle_rad, info.bridge_span_mm, info.bridge_anchor_mm) \
        if info.has_rule else None
    return Stack(Grid._of(found[0]), rule, None if info.bed_layer == BED_AUTO else info.bed_layer)


# --- Materials ----------------------------------------------------------------------------------


class Material(NamedTuple):
    """What a material is called, looks like, and weighs; a density of 0 is not known."""

    name: str
    colour: tuple[int, int, int] = (0, 0, 0)
    density_g_cm3: float = 0.0


@documented("sf_layers_begin", "sf_layers_add", "sf_layers_finish")
def save_materials(layers: Iterable[npt.NDArray[np.uint8]], folder: _files.Path, lattice: Lattice,
                   materials: Sequence[Material]) -> list[_types.MaterialUse]:
    """Write slices of materials as a stack, from the lowest up: ids (y, x) as `halftone` makes them.

    The slices may come from a generator, and none is kept. What of each material there is.
    """
    c, fault = ffi.new("sf_material[]", max(len(materials), 1)), _core.new_fault()
    for i, m in enumerate(materials):
        c[i].name, c[i].colour, c[i].density_g_cm3 = _core.text(m.name, "name"), list(m.colour), m.density_g_cm3
    made, uses = ffi.new("sf_layers **"), ffi.new("sf_material_use[]", max(len(materials), 1))
    with _files.folder_to_write(folder) as to, _lattice(lattice) as on:
        ok(lib.sf_layers_begin(to, on, len(materials), c, ffi.NULL, made, fault), fault)
        kept = ffi.gc(made[0], lib.sf_layers_end)
        for ids in layers:
            ids = _core.array_in(ids, np.uint8, (lattice.ny, lattice.nx), "layers")
            ok(lib.sf_layers_add(kept, _core.pointer("uint8_t", ids), lattice.nx, fault), fault)
        ok(lib.sf_layers_finish(kept, uses, fault), fault)
    return [_core.value(uses[i]) for i in range(len(materials))]


@documented("sf_png_write_rgb")
def save_picture(pixels: Any, to: _files.Writable) -> None:
    """Write a picture, (height, width, 3) of uint8, as PNG."""
    pixels = _core.array_in(pixels, np.uint8, (None, None, 3), "pixels")
    with _files.sink(to) as sink:
        ok(lib.sf_png_write_rgb(_core.pointer("uint8_t", pixels), pixels.shape[1], pixels.shape[0], sink))


@documented("sf_stack_has_png")
def stacks_are_png() -> bool:
    """Whether this build reads and writes layers as PNG; else they are PBM."""
    return bool(lib.sf_stack_has_png())


__all__ = ["Material", "Stack", "load_stack", "save_materials", "save_picture", "save_stack", "stacks_are_png"]
