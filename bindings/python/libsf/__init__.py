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
from .balance import (Balance, Stance, StanceKind, Verdict, add_bodies, ballast_body, body,
                      center_of_mass, rest)
from .bending import (Blend, Change, Handle, HandleKind, Pose, Unbent, Weights, WeightsMethod,
                      cover, foot, handle_center, place_handles)
from .cages import (Cage, CageFormat, CageHistory, Falloff, PaintOperation, PaintWhere, Property,
                    known_property)
from .carving import (CarveGoal, CarveMode, Carved, Drained, carve, clearance, density, drain,
                      wall, wall_inside)
from .certificates import Certificate, Operation, sha256
from .contours import (ContourFill, ContourFormat, ContourLayer, ContourStack,
                       layer_from_contours)
from .errors import (ArgumentError, CancelledError, CapacityError, Error, FileError, FormatError,
                     InfeasibleError, InternalError, OutOfMemoryError, ShapeError, TooLargeError,
                     UnsupportedError)
from .halftoning import Diffuser, Mask, MaskKind, Shell, halftone, material_uses
from .jobs import Job, JobFormat, jobs_have_sl1, save_sl1
from .layers import Border, Components, Connectivity, Element, Isa, Layer, limit_isa
from .limits import Limit, Locator, NO_PIECE, Sampler, Slice
from .mesh import Fill, Mesh, MeshFormat, Voxelizer, orient, surface, voxelize
from .mixing import Curve, Mixture, Trend
from .paths import Emitted, Path, PathCost, PathEnd, PathFinder, PathMap, emit
from .places import (Costs, Printing, Voids, VoidSearch, complete, costs, culprits, printing,
                     steepest, voids)
from .refining import Channel, RefineRules, Refinement, Step, Tets
from .sculpting import BrushKind, Sculpt, Tip, TipShape, brush_name
from .sessions import Session, SessionStep, Stroke
from .stacks import (Material, Stack, load_stack, save_materials, save_picture, save_stack,
                     stacks_are_png)
from .standing import Stand, StandSolver, Standing, stand
from .support import (Checked, Checker, Grown, Landing, Preserved, Repaired, Rule, Trimmed, check,
                      grow, preserve, repair, trim, unsupported, update_trim)
from .threemf import (Color, Filling, Part, Placed, ThreeMF, ThreemfKind, save_threemf,
                      threemf_is_served)
from .voxel import Grid, Lattice

__version__: str = _ffi.string(_lib.sf_version()).decode()

__all__ = [
    "ArgumentError", "Balance", "Blend", "Border", "BrushKind", "Cage", "CageFormat",
    "CageHistory", "CancelledError", "CapacityError", "CarveGoal", "CarveMode", "Carved",
    "Certificate", "Change", "Channel", "Checked", "Checker", "Color", "Components",
    "Connectivity", "ContourFill", "ContourFormat", "ContourLayer", "ContourStack", "Costs",
    "Curve", "Diffuser", "Drained", "Element", "Emitted", "Error", "Falloff", "FileError", "Fill",
    "Filling", "FormatError", "Grid", "Grown", "Handle", "HandleKind", "InfeasibleError",
    "InternalError", "Isa", "Job", "JobFormat", "Landing", "Lattice", "Layer", "Limit", "Locator",
    "Mask", "MaskKind", "Material", "Mesh", "MeshFormat", "Mixture", "NO_PIECE", "Operation",
    "OutOfMemoryError", "PaintOperation", "PaintWhere", "Part", "Path", "PathCost", "PathEnd",
    "PathFinder", "PathMap", "Placed", "Pose", "Preserved", "Printing", "Property", "RefineRules",
    "Refinement", "Repaired", "Rule", "Sampler", "Sculpt", "Session", "SessionStep", "ShapeError",
    "Shell", "Slice", "Stack", "Stance", "StanceKind", "Stand", "StandSolver", "Standing", "Step",
    "Stroke", "Tets", "ThreeMF", "ThreemfKind", "Tip", "TipShape", "TooLargeError", "Trend",
    "Trimmed", "Unbent", "UnsupportedError", "Verdict", "VoidSearch", "Voids", "Voxelizer",
    "Weights", "WeightsMethod", "add_bodies", "ballast_body", "body", "brush_name", "carve",
    "center_of_mass", "check", "clearance", "complete", "costs", "cover", "culprits", "density",
    "drain", "emit", "foot", "grow", "halftone", "handle_center", "jobs_have_sl1",
    "known_property", "layer_from_contours", "limit_isa", "load_stack", "material_uses", "orient",
    "place_handles", "preserve", "printing", "repair", "rest", "save_materials", "save_picture",
    "save_sl1", "save_stack", "save_threemf", "sha256", "stacks_are_png", "stand", "steepest",
    "surface", "threemf_is_served", "trim", "unsupported", "update_trim", "voids", "voxelize",
    "wall", "wall_inside",
]
