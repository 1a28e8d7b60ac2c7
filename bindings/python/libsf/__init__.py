"""Shapes that print without supports, stand when they should, and grade between materials.

    import libsf
    mesh = libsf.Mesh.load("part.stl")
    grid = libsf.voxelize(mesh, pitch_mm=0.2)
    if not libsf.check(grid, "octagon"):
        grid = libsf.repair(grid, "octagon").grid

Arrays are numpy's, in (layer, y, x) order; lengths are in mm, angles in radians where a name ends
in `_rad`. A long call takes `progress=` (a function, or tqdm's bar) and `threads=`.
"""

from __future__ import annotations

from ._core import ffi as _ffi
from ._core import lib as _lib
from .balance import (Balance, CarveMode, Carved, Stance, StanceKind, Standing, StandSolver, Verdict,
                      body, carve, center_of_mass, stand, wall)
from .errors import (ArgumentError, CancelledError, CapacityError, Error, FileError, FormatError,
                     InfeasibleError, InternalError, OutOfMemoryError, ShapeError, TooLargeError,
                     UnsupportedError)
from .grading import (Cage, Falloff, Limit, Mask, MaskKind, Mixture, PaintOperation, PaintWhere,
                      Property, Sampler, Slice, Trend, halftone)
from .mesh import Fill, Mesh, orient, surface, voxelize
from .sculpting import BrushKind, Sculpt, Tip, TipShape
from .stacks import Stack, load_stack, save_stack
from .support import (Checked, Checker, Grown, Landing, Preserved, Repaired, Rule, Trimmed, check,
                      grow, preserve, repair, trim, unsupported)
from .voxel import Grid, Lattice

__version__: str = _ffi.string(_lib.sf_version()).decode()

__all__ = [
    "ArgumentError", "Balance", "BrushKind", "Cage", "CancelledError", "CapacityError",
    "CarveMode", "Carved", "Checked", "Checker", "Error", "Falloff", "FileError", "Fill",
    "FormatError", "Grid", "Grown", "InfeasibleError", "InternalError", "Landing", "Lattice",
    "Limit", "Mask", "MaskKind", "Mesh", "Mixture", "OutOfMemoryError", "PaintOperation",
    "PaintWhere", "Preserved", "Property", "Repaired", "Rule", "Sampler", "Sculpt",
    "ShapeError", "Slice", "Stack", "Stance", "StanceKind", "StandSolver", "Standing", "Tip",
    "TipShape", "TooLargeError", "Trend", "Trimmed", "UnsupportedError", "Verdict", "body",
    "carve", "center_of_mass", "check", "grow", "halftone", "load_stack", "orient", "preserve",
    "repair", "save_stack", "stand", "surface", "trim", "unsupported", "voxelize", "wall",
]
