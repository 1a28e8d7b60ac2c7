"""Layers as closed polygons, and stacks of them: how slicers exchange layers.

Polygons are arrays of points (n, 2) in mm; the last point is joined to the first.
"""

from __future__ import annotations

import operator
from dataclasses import dataclass
from typing import Any, Iterable, Sequence

import numpy as np
import numpy.typing as npt

from . import _core, _files
from ._core import Progress, documented, ffi, lib, ok, running
from ._types import ContourFill, ContourFormat
from .layers import Layer
from .voxel import Grid, Lattice, _lattice, lattice_of

Points = npt.NDArray[np.float64]


class c_contours:
    """Polygons as the library has them: `with c_contours(polygons) as c: ...`.

    C has no more than the address of the points, so they must stay until its call has returned; what
    is handed out of a `with` does.
    """

    def __init__(self, polygons: Iterable[Any]) -> None:
        arrays = [_core.array_in(p, np.float64, (None, 2), "polygon") for p in polygons]
        self._starts = np.zeros(len(arrays) + 1, np.uintp)
        np.cumsum([len(p) for p in arrays], out=self._starts[1:], dtype=np.uintp)
        self._points = np.concatenate(arrays) if arrays else np.zeros((0, 2))
        self._c = ffi.new("sf_contours *")
        self._c.points_mm = _core.pointer("double", self._points)
        self._c.starts = ffi.cast("size_t *", ffi.from_buffer(self._starts))
        self._c.contour_count = len(arrays)

    def __enter__(self) -> Any:
        return self._c

    def __exit__(self, *_: object) -> None:
        pass


@dataclass(frozen=True)
class ContourLayer:
    """One layer of a stack: from where to where it reaches, and its polygons."""

    bottom_mm: float
    top_mm: float
    polygons: Sequence[Points]

    @property
    @documented("sf_contours_area_mm2")
    def area_mm2(self) -> float:
        """The signed area inside."""
        with c_contours(self.polygons) as c:
            return float(lib.sf_contours_area_mm2(c))


class ContourStack(_core.InTurn):
    """Layers of polygons with their heights, from the bottom up.

        stack = libsf.ContourStack()
        stack.add(0.1, [square, hole])
        grid = stack.grid(stack.lattice(0.05))
    """

    @documented("sf_contour_stack_create")
    def __init__(self, bottom_mm: float = 0.0) -> None:
        made = ffi.new("sf_contour_stack **")
        ok(lib.sf_contour_stack_create(bottom_mm, ffi.NULL, made))
        self._take(made[0])

    def _take(self, c: Any) -> None:
        self._c = ffi.gc(c, lib.sf_contour_stack_destroy)

    @classmethod
    def _of(cls, c: Any) -> ContourStack:
        made = cls.__new__(cls)
        made._take(c)
        return made

    @classmethod
    @documented("sf_contour_stack_read")
    def load(cls, file: _files.Readable, *, points_max: int | None = None) -> ContourStack:
        """Read a CLI file: a path, bytes, or an open file."""
        made, fault = ffi.new("sf_contour_stack **"), _core.new_fault()
        limits = ffi.new("sf_read_limits *", lib.sf_read_limits_default())
        if points_max is not None:
            limits.vertices_max = points_max
        with _files.source(file) as of:
            ok(lib.sf_contour_stack_read(of, limits, ffi.NULL, made, fault), fault)
        return cls._of(made[0])

    @documented("sf_contour_stack_write")
    @_core.in_turn
    def save(self, file: _files.Writable, format: ContourFormat = ContourFormat.TEXT) -> None:
        """Write a CLI file."""
        with _files.sink(file) as to:
            ok(lib.sf_contour_stack_write(self._c, int(format), to))

    @documented("sf_contour_stack_add")
    @_core.in_turn
    def add(self, top_mm: float, polygons: Iterable[Any]) -> None:
        """A layer on top, up to `top_mm`."""
        fault = _core.new_fault()
        with c_contours(polygons) as c:
            ok(lib.sf_contour_stack_add(self._c, top_mm, c, fault), fault)

    @documented("sf_contour_stack_trace")
    @_core.in_turn
    def trace(self, top_mm: float, layer: Layer, lattice: Lattice) -> None:
        """A layer on top: the border of a plane of voxels."""
        with _lattice(lattice) as c:
            ok(lib.sf_contour_stack_trace(self._c, top_mm, layer._c, c))

    @classmethod
    def of(cls, grid: Grid) -> ContourStack:
        """The borders of all layers of a grid."""
        lattice = grid.lattice
        made = cls(lattice.layer_bottom(0))
        for k in range(lattice.nz):
            made.trace(lattice.layer_bottom(k + 1), Layer.of(grid, k), lattice)
        return made

    @documented("sf_contour_stack_count")
    def __len__(self) -> int:
        return int(lib.sf_contour_stack_count(self._c))

    @documented("sf_contour_stack_layer")
    @_core.in_turn
    def __getitem__(self, layer: int) -> ContourLayer:
        k = operator.index(layer) + (len(self) if layer < 0 else 0)
        if not 0 <= k < len(self):
            raise IndexError(f"layer {layer} of {len(self)}")
        c, bottom, top = ffi.new("sf_contours *"), ffi.new("double *"), ffi.new("double *")
        ok(lib.sf_contour_stack_layer(self._c, k, c, bottom, top))
        starts = [c.starts[i] for i in range(c.contour_count + 1)]
        points = np.empty((starts[-1], 2))
        if starts[-1] > 0:
            ffi.memmove(ffi.from_buffer(points), c.points_mm, points.nbytes)
        return ContourLayer(bottom[0], top[0], [points[a:b] for a, b in zip(starts, starts[1:])])

    @documented("sf_contour_stack_lattice")
    @_core.in_turn
    def lattice(self, pitch_mm: float | tuple[float, float]) -> Lattice:
        """A lattice that holds all of it, a layer of voxels for each of its own."""
        x, y = _core.for_each(pitch_mm, 2)
        heights, c = ffi.new("double[]", max(len(self), 1)), ffi.new("sf_lattice *")
        ok(lib.sf_contour_stack_lattice(self._c, x, y, heights, len(self), c))
        return lattice_of(c)

    @documented("sf_grid_from_contours")
    @_core.in_turn
    def grid(self, lattice: Lattice, fill: ContourFill = ContourFill.NONZERO, *,
             progress: Progress = None) -> Grid:
        """Its voxels: solid where the centre is inside."""
        made = ffi.new("sf_grid **")
        with _lattice(lattice) as c, running(progress, 1) as task:
            ok(lib.sf_grid_from_contours(self._c, c, int(fill), ffi.NULL, task, made))
        return Grid._of(made[0])

    def __repr__(self) -> str:
        return f"<libsf.ContourStack of {len(self)} layers>"


@documented("sf_slice_from_contours")
def layer_from_contours(lattice: Lattice, polygons: Iterable[Any],
                        fill: ContourFill = ContourFill.NONZERO) -> Layer:
    """A plane of voxels that is solid where polygons have a centre inside."""
    made, fault = Layer(lattice.nx, lattice.ny), _core.new_fault()
    with _lattice(lattice) as on, c_contours(polygons) as c:
        ok(lib.sf_slice_from_contours(made._c, on, c, int(fill), ffi.NULL, fault), fault)
    return made


__all__ = ["ContourFill", "ContourFormat", "ContourLayer", "ContourStack", "layer_from_contours"]
