"""Layers, one plane of voxels at a time: morphology, runs and components.

A layer of a grid is a view of that grid's memory: what is written to it changes the grid.
"""

from __future__ import annotations

import operator
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core, _types
from ._core import documented, ffi, lib, ok
from ._types import Border, Connectivity, Isa
from .voxel import Bools, Grid

# A maximal run of solid voxels, as `Layer.runs` gives them: x0 <= x < x1 of row y.
RUN = np.dtype([("x0", np.uint32), ("x1", np.uint32), ("y", np.uint32), ("label", np.uint32)])


# --- Structuring elements -----------------------------------------------------------------------


class Element:
    """What a layer is dilated or eroded by: symmetric in x and y, and convex along rows.

    `half_widths[d]` is the reach along x in the rows that lie d off.
    """

    def __init__(self, half_widths: Any) -> None:
        widths = [operator.index(n) for n in half_widths]
        if not 1 <= len(widths) <= 256 or any(not 0 <= n <= 255 for n in widths):
            raise ValueError("half_widths: give 1 to 256 numbers from 0 to 255")
        self._c = ffi.new("sf_element *")
        self._c.reach_y = len(widths) - 1
        for i, n in enumerate(widths):
            self._c.half_width[i] = n

    @classmethod
    def _of(cls, c: Any) -> Element:
        made = cls.__new__(cls)
        made._c = ffi.new("sf_element *", c)
        return made

    @classmethod
    @documented("sf_element_box3")
    def box3(cls) -> Element:
        """The 3 x 3 square."""
        return cls._of(lib.sf_element_box3())

    @classmethod
    @documented("sf_element_plus3")
    def plus3(cls) -> Element:
        """A voxel and the four beside it."""
        return cls._of(lib.sf_element_plus3())

    @classmethod
    @documented("sf_element_ellipse")
    def ellipse(cls, rx_vx: float, ry_vx: float) -> Element:
        """The voxels of an ellipse of these radii, which are rounded to 1/65536 voxel."""
        made = ffi.new("sf_element *")
        if not (0 <= rx_vx < 1 << 32 and 0 <= ry_vx < 1 << 32):
            raise ValueError(f"radii of {rx_vx} and {ry_vx} voxels")
        ok(lib.sf_element_ellipse(round(rx_vx * 65536), round(ry_vx * 65536), made))
        return cls._of(made[0])

    @property
    def half_widths(self) -> tuple[int, ...]:
        return tuple(self._c.half_width[0:self._c.reach_y + 1])

    @documented("sf_element_sum")
    def __add__(self, other: Element) -> Element:
        """The Minkowski sum: dilating by it is dilating by one and then by the other."""
        if not isinstance(other, Element):
            return NotImplemented
        made = ffi.new("sf_element *")
        ok(lib.sf_element_sum(self._c, other._c, made))
        return Element._of(made[0])

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Element) and self.half_widths == other.half_widths

    def __hash__(self) -> int:
        return hash(self.half_widths)

    def __repr__(self) -> str:
        return f"libsf.Element({list(self.half_widths)})"


# --- Layers -------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Components:
    """The connected parts of a layer: its runs with their labels, and each part's area and box."""

    runs: npt.NDArray[np.void]
    parts: _core.Values[_types.Component]


class Layer:
    """A plane of voxels: one of its own, or a grid's.

        layer = libsf.Layer(1440, 2560)     # empty
        layer = libsf.Layer.of(grid, 12)    # the grid's own memory
    """

    def __init__(self, width: int, height: int) -> None:
        if not (0 < width <= 65535 and 0 < height <= 65535):
            raise ValueError(f"a layer of {width} x {height} voxels; 1 to 65535 each are possible")
        words = np.zeros((height, lib.sf_slice_stride(width)), np.uint64)
        self._take(words, width)

    def _take(self, words: npt.NDArray[np.uint64], width: int) -> None:
        # A view, which numpy does not resize, and a pointer, which keeps what is seen from being moved.
        self._words, self._p = words.view(), ffi.new("sf_slice *")
        self._kept = _core.pointer("uint64_t", words)
        self._p.words = self._kept
        self._p.height, self._p.width = words.shape[0], width
        self._p.stride = words.shape[1]

    @property
    def _c(self) -> Any:
        return self._p[0]

    @classmethod
    @documented("sf_grid_slice")
    def of(cls, grid: Grid, layer: int) -> Layer:
        """Layer `layer` of a grid, to be read and written; it keeps the grid alive."""
        nz, _, nx = grid.shape
        k = operator.index(layer) + (nz if layer < 0 else 0)
        if not 0 <= k < nz:
            raise IndexError(f"layer {layer} of {nz}")
        made = cls.__new__(cls)
        made._take(grid.words[k], nx)
        return made

    @classmethod
    def from_array(cls, array: Any) -> Layer:
        """A layer of an array of bools, (y, x)."""
        array = _plane(array)
        made = cls(array.shape[1], array.shape[0])
        packed = np.packbits(array, axis=1, bitorder="little")
        made._words.view(np.uint8)[:, :packed.shape[1]] = packed
        return made

    @property
    def shape(self) -> tuple[int, int]:
        """(height, width)."""
        return (int(self._p.height), int(self._p.width))

    @property
    def words(self) -> npt.NDArray[np.uint64]:
        """Its own memory, (height, stride) words of 64 voxels; see `Grid.words`."""
        return self._words

    def array(self) -> Bools:
        """The voxels as bools, (y, x)."""
        return np.unpackbits(self._words.view(np.uint8), axis=1, count=self.shape[1],
                             bitorder="little").view(np.bool_)

    @documented("sf_slice_copy")
    def copy(self) -> Layer:
        made = Layer(self.shape[1], self.shape[0])
        ok(lib.sf_slice_copy(made._c, self._c))
        return made

    @documented("sf_slice_get")
    def __getitem__(self, place: tuple[int, int]) -> bool:
        """Whether voxel (y, x) is solid."""
        y, x = self._place(place)
        return bool(lib.sf_slice_get(self._c, x, y))

    def __setitem__(self, place: tuple[int, int], solid: bool) -> None:
        y, x = self._place(place)
        ok(lib.sf_slice_set(self._c, x, y, bool(solid)))

    def _place(self, place: tuple[int, int]) -> tuple[int, int]:
        if not isinstance(place, tuple) or len(place) != 2:
            raise TypeError("give a voxel as (y, x); for more at once take array() or words")
        found = [operator.index(i) + (n if operator.index(i) < 0 else 0)
                 for i, n in zip(place, self.shape)]
        if any(not 0 <= i < n for i, n in zip(found, self.shape)):
            raise IndexError(f"voxel {place} in a layer of {self.shape}")
        return found[0], found[1]

    @documented("sf_slice_fill")
    def fill(self, solid: bool = True, *, x: tuple[int, int] | None = None,
             y: tuple[int, int] | None = None) -> None:
        """Make a rectangle solid or empty: columns x[0] to x[1], without the last; None is all."""
        (x0, x1), (y0, y1) = x or (0, self.shape[1]), y or (0, self.shape[0])
        ok(lib.sf_slice_fill(self._c, {"x0": x0, "y0": y0, "x1": x1, "y1": y1}, bool(solid)))

    @documented("sf_slice_popcount")
    def count(self) -> int:
        """How many voxels are solid."""
        return int(lib.sf_slice_popcount(self._c))

    @documented("sf_slice_bounds")
    def bounds(self) -> _types.Rect:
        """The rectangle around the solid voxels, its high ends without."""
        return _core.value(lib.sf_slice_bounds(self._c))  # type: ignore[no-any-return]

    @documented("sf_slice_measure")
    def sums(self) -> _types.SliceSums:
        """Exact sums over the solid voxels."""
        found = ffi.new("sf_slice_sums *")
        ok(lib.sf_slice_measure(self._c, found))
        return _core.value(found)  # type: ignore[no-any-return]

    @documented("sf_slice_equal")
    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Layer):
            return NotImplemented
        return bool(lib.sf_slice_equal(self._c, other._c))

    __hash__ = None  # type: ignore[assignment]

    def _with(self, other: Layer, call: Any) -> Layer:
        if not isinstance(other, Layer):
            return NotImplemented
        made = Layer(self.shape[1], self.shape[0])
        ok(call(made._c, self._c, other._c))
        return made

    def __and__(self, other: Layer) -> Layer:
        return self._with(other, lib.sf_slice_and)

    def __or__(self, other: Layer) -> Layer:
        return self._with(other, lib.sf_slice_or)

    def __xor__(self, other: Layer) -> Layer:
        return self._with(other, lib.sf_slice_xor)

    def __sub__(self, other: Layer) -> Layer:
        return self._with(other, lib.sf_slice_subtract)

    # --- Morphology ---

    @documented("sf_slice_dilate")
    def dilated(self, element: Element, border: Border = Border.EMPTY) -> Layer:
        """Solid where the element, placed there, meets something solid."""
        made = Layer(self.shape[1], self.shape[0])
        ok(lib.sf_slice_dilate(made._c, self._c, element._c, int(border)))
        return made

    @documented("sf_slice_erode")
    def eroded(self, element: Element, border: Border = Border.EMPTY) -> Layer:
        """Solid where the element, placed there, lies in what is solid."""
        made = Layer(self.shape[1], self.shape[0])
        ok(lib.sf_slice_erode(made._c, self._c, element._c, int(border)))
        return made

    @documented("sf_slice_and_dilate")
    def resting_on(self, below: Layer, element: Element) -> Layer:
        """What of this layer lies on the dilation of the one below: a step of trimming."""
        made = Layer(self.shape[1], self.shape[0])
        ok(lib.sf_slice_and_dilate(made._c, self._c, below._c, element._c))
        return made

    # --- Runs and components ---

    @documented("sf_slice_runs")
    def runs(self) -> npt.NDArray[np.void]:
        """The runs of solid voxels, row by row, as an array of `x0, x1, y, label`."""
        count = ffi.new("size_t *")
        ok(lib.sf_slice_run_count(self._c, count))
        found = np.empty(count[0], RUN)
        ok(lib.sf_slice_runs(self._c, *c_runs(found), count))
        return found

    @classmethod
    @documented("sf_slice_from_runs")
    def from_runs(cls, runs: npt.NDArray[np.void], width: int, height: int) -> Layer:
        """A layer that is solid where a run is."""
        made = cls(width, height)
        ok(lib.sf_slice_from_runs(made._c, *c_runs(runs)))
        return made

    @documented("sf_runs_label", "sf_runs_measure")
    def components(self, connectivity: Connectivity = Connectivity.CORNERS) -> Components:
        """The connected parts: runs with labels from 0 on, and the area and box of each label."""
        runs, count = self.runs(), ffi.new("uint32_t *")
        ok(lib.sf_runs_label(*c_runs(runs), int(connectivity), count))
        parts = ffi.new("sf_component[]", max(count[0], 1))
        ok(lib.sf_runs_measure(*c_runs(runs), parts, count[0]))
        return Components(runs, _core.Values(parts, count[0]))

    def __repr__(self) -> str:
        height, width = self.shape
        return f"<libsf.Layer {width} x {height}, {self.count()} solid voxels>"


def c_runs(runs: npt.NDArray[np.void]) -> tuple[Any, int]:
    """Runs as the library has them, and how many: the array's own memory, which the pointer keeps."""
    array = _core.array_in(runs, RUN, (None,), "runs")
    return _core.pointer("sf_run", array), len(array)


def _plane(array: Any) -> Bools:
    array = array if isinstance(array, np.ndarray) else np.asarray(array, np.bool_)
    if array.dtype != np.bool_ or array.ndim != 2:
        raise TypeError(f"array: it is of {array.dtype} with {array.ndim} axes; bools in (y, x) order "
                        "are needed")
    return array  # type: ignore[no-any-return]


@documented("sf_isa_limit")
def limit_isa(limit: Isa | None = None) -> str:
    """Use no instruction set above a limit, for tests; None lifts it. The one that is in use."""
    return ffi.string(lib.sf_isa_limit(int(Isa.COUNT if limit is None else limit))).decode()  # type: ignore[no-any-return]


__all__ = ["Border", "Components", "Connectivity", "Element", "Isa", "Layer", "limit_isa"]
