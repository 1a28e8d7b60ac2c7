"""Stacks of layers in folders: layer_00000.png and so on, and stack.json, which says it all."""

from __future__ import annotations

import os
from typing import NamedTuple

from . import _core
from ._core import Progress, documented, ffi, lib, ok, running
from ._types import RuleKind
from .support import BED_AUTO, Rule
from .voxel import Grid


class Stack(NamedTuple):
    grid: Grid
    rule: Rule | None
    bed_layer: int | None


@documented("sf_stack_write")
def save_stack(grid: Grid, folder: str | os.PathLike[str], *, rule: Rule | None = None,
               bed_layer: int | None = None, progress: Progress = None) -> None:
    """Write a grid as a stack; the folder shows when it is whole, or not at all."""
    info, fault, made = ffi.new("sf_stack_info *"), _core.new_fault(), ffi.new("sf_directory **")
    if rule is not None:
        info.has_rule, info.rule, info.angle_rad = 1, int(rule.kind), rule.angle_rad
        info.bridge_span_mm, info.bridge_anchor_mm = rule.bridge_span_mm, rule.bridge_anchor_mm
    info.bed_layer = BED_AUTO if bed_layer is None else bed_layer
    ok(lib.sf_directory_write(os.fsencode(folder), ffi.NULL, made, fault), fault)
    with running(progress) as task:
        status = lib.sf_stack_write(grid._c, info, lib.sf_directory_folder(made[0]), task, fault)
        if status != 0:
            lib.sf_directory_close(made[0])
            ok(status, fault)
        ok(lib.sf_directory_commit(made[0], fault), fault)


@documented("sf_stack_read")
def load_stack(folder: str | os.PathLike[str], *, progress: Progress = None) -> Stack:
    """Read a stack: its grid, and the rule and bed that it was made for, if it says so."""
    info, fault, made = ffi.new("sf_stack_info *"), _core.new_fault(), ffi.new("sf_directory **")
    found = ffi.new("sf_grid **")
    ok(lib.sf_directory_read(os.fsencode(folder), ffi.NULL, made, fault), fault)
    try:
        with running(progress) as task:
            ok(lib.sf_stack_read(lib.sf_directory_folder(made[0]), ffi.NULL, task, found, info, fault), fault)
    finally:
        lib.sf_directory_close(made[0])
    rule = Rule(RuleKind(info.rule), info.angle_rad, info.bridge_span_mm, info.bridge_anchor_mm) \
        if info.has_rule else None
    return Stack(Grid._of(found[0]), rule, None if info.bed_layer == BED_AUTO else info.bed_layer)


__all__ = ["Stack", "load_stack", "save_stack"]
