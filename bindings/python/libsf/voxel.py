"""Lattices, and grids of voxels on them.

Arrays are in (layer, y, x) order, C order. A grid keeps its voxels as bits; `words` is that memory
itself, `array()` a copy with a byte for each voxel.
"""

from __future__ import annotations

import operator
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core, _types
from ._core import documented, ffi, lib, ok
from ._types import Status

Bools = npt.NDArray[np.bool_]


@dataclass(frozen=True)
class Lattice:
    """Where voxels lie: counts, the size of a voxel in mm, and the corner of the first one in mm.

    `layer_mm` is the height of a layer; or a sequence of heights, one for each layer.
    """

    nx: int
    ny: int
    nz: int
    pitch_mm: tuple[float, float] = (1.0, 1.0)
    layer_mm: float | tuple[float, ...] = 1.0
    origin_mm: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        pitch: Any = self.pitch_mm
        if _core.is_number(pitch):
            object.__setattr__(self, "pitch_mm", (float(pitch), float(pitch)))
        else:
            object.__setattr__(self, "pitch_mm", (float(pitch[0]), float(pitch[1])))
        layer: Any = self.layer_mm
        same = _core.is_number(layer)
        object.__setattr__(self, "layer_mm", float(layer) if same else tuple(float(h) for h in layer))
        x, y, z = self.origin_mm
        object.__setattr__(self, "origin_mm", (float(x), float(y), float(z)))
        for name in ("nx", "ny", "nz"):
            object.__setattr__(self, name, operator.index(getattr(self, name)))
        with _lattice(self) as c:
            status = lib.sf_lattice_validate(c)
        if status != 0:
            size = f"{self.nx} x {self.ny} x {self.nz} voxels of {self.pitch_mm} mm, layers of {self.layer_mm} mm"
            more = ("make the voxels larger" if status == Status.ERR_OVERFLOW else
                    "counts and sizes must be above 0, places finite")
            ok(status, said=f"no lattice can have {size}; {more}")

    @property
    def shape(self) -> tuple[int, int, int]:
        """The shape of arrays on it: (nz, ny, nx)."""
        return (self.nz, self.ny, self.nx)

    @documented("sf_lattice_layer_bottom")
    def layer_bottom(self, k: int) -> float:
        """The height of the bottom of layer k, mm; of k = nz the top of the last."""
        if not 0 <= k <= self.nz:
            raise IndexError(f"layer {k} of {self.nz}")
        with _lattice(self) as c:
            return float(lib.sf_lattice_layer_bottom(c, k))

    @documented("sf_lattice_layer_height")
    def layer_height(self, k: int) -> float:
        """The height of layer k, mm."""
        if not 0 <= k < self.nz:
            raise IndexError(f"layer {k} of {self.nz}")
        with _lattice(self) as c:
            return float(lib.sf_lattice_layer_height(c, k))

    @classmethod
    def around(cls, low_mm: Any, high_mm: Any, pitch_mm: float, layer_mm: float | None = None,
               margin: int = 1) -> Lattice:
        """A lattice of cubes, or of layers of another height, around a box, with voxels to spare."""
        layer = pitch_mm if layer_mm is None else layer_mm
        for name, step in (("pitch_mm", pitch_mm), ("layer_mm", layer)):
            if not 0 < step < np.inf:
                raise ValueError(f"{name}: {step}; give a size in mm, above 0")
        steps = (pitch_mm, pitch_mm, layer)
        counts = [int(np.ceil((h - l) / s - 1e-9)) + 2 * margin
                  for l, h, s in zip(low_mm, high_mm, steps)]
        middle = [0.5 * (l + h) for l, h in zip(low_mm, high_mm)]
        corner = [m - 0.5 * n * s for m, n, s in zip(middle, counts, steps)]
        corner[2] = low_mm[2] - margin * layer
        return cls(counts[0], counts[1], counts[2], (pitch_mm, pitch_mm), layer,
                   (corner[0], corner[1], corner[2]))


def lattice_needed(what: Any) -> None:
    """Refuse what is no lattice, and say what was meant where that can be told."""
    if isinstance(what, Lattice):
        return
    more = ("; name the size of a voxel: pitch_mm=..." if isinstance(what, (int, float)) else
            "; Grid.from_array makes a grid of an array" if isinstance(what, np.ndarray) else "")
    raise TypeError(f"lattice: a Lattice is needed, not {type(what).__name__}{more}")


class _lattice:
    """A lattice as the library has it, while it is needed."""

    def __init__(self, lattice: Lattice) -> None:
        heights = lattice.layer_mm
        self._heights = ffi.NULL if _core.is_number(heights) else ffi.new("double[]", heights)
        if self._heights != ffi.NULL and len(heights) != lattice.nz:  # type: ignore[arg-type]
            raise ValueError(f"layer_mm: {len(heights)} heights for {lattice.nz} layers")  # type: ignore[arg-type]
        self.c = ffi.new("sf_lattice *")
        for name, n in (("nx", lattice.nx), ("ny", lattice.ny), ("nz", lattice.nz)):
            if not 0 <= n < 1 << 32:
                raise ValueError(f"{name}: {n} voxels along an axis")
            setattr(self.c, name, n)
        self.c.pitch_x_mm, self.c.pitch_y_mm = lattice.pitch_mm
        self.c.layer_mm = heights if _core.is_number(heights) else 0
        self.c.heights_mm = self._heights
        self.c.origin_mm = lattice.origin_mm

    def __enter__(self) -> Any:
        return self.c

    def __exit__(self, *_: object) -> None:
        pass


def lattice_of(c: Any) -> Lattice:
    """A lattice of the library as ours."""
    layer = c.layer_mm if c.heights_mm == ffi.NULL else tuple(c.heights_mm[0:c.nz])
    return Lattice(c.nx, c.ny, c.nz, (c.pitch_x_mm, c.pitch_y_mm), layer, tuple(c.origin_mm))


class Grid:
    """Voxels on a lattice, a bit each.

    Make an empty one of a lattice, or one of an array of bools in (layer, y, x) order:

        grid = Grid(Lattice(64, 64, 64, 0.25, 0.25))
        grid = Grid.from_array(array, pitch_mm=0.25, layer_mm=0.25)
    """

    _c: Any

    @documented("sf_grid_create")
    def __init__(self, lattice: Lattice) -> None:
        lattice_needed(lattice)
        made = ffi.new("sf_grid **")
        with _lattice(lattice) as c:
            ok(lib.sf_grid_create(c, ffi.NULL, made))
        self._take(made[0])

    def _take(self, c: Any) -> None:
        self._c = ffi.gc(c, lib.sf_grid_destroy)
        self._lattice = lattice_of(lib.sf_grid_lattice(self._c))

    @classmethod
    def _of(cls, c: Any) -> Grid:
        """A grid of the library's, which it becomes the owner of."""
        grid = cls.__new__(cls)
        grid._take(c)
        return grid

    @classmethod
    def _borrowed(cls, c: Any, owner: Any) -> Grid:
        """A copy of a grid that belongs to something else."""
        made = ffi.new("sf_grid **")
        ok(lib.sf_grid_clone(c, ffi.NULL, made))
        return cls._of(made[0])

    @classmethod
    def from_array(cls, array: Any, lattice: Lattice | None = None, *,
                   pitch_mm: float | tuple[float, float] = 1.0,
                   layer_mm: float | tuple[float, ...] = 1.0,
                   origin_mm: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> Grid:
        """A grid of an array of bools, (layer, y, x); on a lattice, or one of these sizes."""
        array = _bools(array, "array")
        if lattice is None:
            nz, ny, nx = array.shape
            lattice = Lattice(nx, ny, nz, pitch_mm, layer_mm, origin_mm)  # type: ignore[arg-type]
        grid = cls(lattice)
        grid.set_array(array)
        return grid

    @property
    def lattice(self) -> Lattice:
        return self._lattice

    @property
    def shape(self) -> tuple[int, int, int]:
        """(nz, ny, nx)."""
        return self._lattice.shape

    @property
    def words(self) -> npt.NDArray[np.uint64]:
        """The grid's own memory: (nz, ny, stride) words of 64 voxels, to be read and written.

        Voxel x of a row is bit x % 64 of word x // 64. Bits past the row's end must stay 0.
        """
        nz, ny, _ = self.shape
        first = lib.sf_grid_slice(self._c, 0)
        return _core.memory(first.words, "uint64", (nz, ny, first.stride), self._c, True)

    def array(self, out: Bools | None = None) -> Bools:
        """The voxels as bools in (layer, y, x) order: a new array, or `out`, which is filled."""
        nz, ny, nx = self.shape
        if out is not None:
            out = _core.array_out(out, np.bool_, self.shape, "out")
        bits = np.unpackbits(self.words.view(np.uint8).reshape(nz, ny, -1), axis=2, count=nx,
                             bitorder="little").view(np.bool_)
        if out is None:
            return bits
        out[...] = bits
        return out

    def set_array(self, array: Any) -> None:
        """Take the voxels of an array of bools in (layer, y, x) order."""
        array = _bools(array, "array")
        if array.shape != self.shape:
            raise ValueError(f"array: its shape is {array.shape}, and {self.shape} is needed")
        packed = np.packbits(array, axis=2, bitorder="little")
        bytes_of = self.words.view(np.uint8).reshape(*self.shape[:2], -1)
        bytes_of[:, :, :packed.shape[2]] = packed
        bytes_of[:, :, packed.shape[2]:] = 0

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> npt.NDArray[Any]:
        array = self.array()
        return array if dtype is None else array.astype(dtype)

    def copy(self) -> Grid:
        return Grid._borrowed(self._c, self)

    __copy__ = copy

    def __deepcopy__(self, memo: Any) -> Grid:
        return self.copy()

    @documented("sf_grid_popcount")
    def count(self) -> int:
        """How many voxels are solid."""
        return int(lib.sf_grid_popcount(self._c))

    @documented("sf_grid_bounds")
    def bounds(self) -> _types.Box:
        """The box of all solid voxels, its high ends without; all 0 where there are none."""
        return _core.value(lib.sf_grid_bounds(self._c))  # type: ignore[no-any-return]

    @documented("sf_grid_measure")
    def moments(self) -> _types.Moments:
        """Exact sums over the solid voxels."""
        found = ffi.new("sf_moments *")
        ok(lib.sf_grid_measure(self._c, ffi.NULL, found))
        return _core.value(found)  # type: ignore[no-any-return]

    def __getitem__(self, place: tuple[int, int, int]) -> bool:
        """Whether voxel (layer, y, x) is solid."""
        k, y, x = self._place(place)
        return bool(lib.sf_slice_get(lib.sf_grid_slice(self._c, k), x, y))

    def __setitem__(self, place: tuple[int, int, int], solid: bool) -> None:
        k, y, x = self._place(place)
        ok(lib.sf_slice_set(lib.sf_grid_slice(self._c, k), x, y, bool(solid)))

    def _place(self, place: tuple[int, int, int]) -> tuple[int, int, int]:
        if not isinstance(place, tuple) or len(place) != 3:
            raise TypeError("give a voxel as (layer, y, x); for more at once take array() or words")
        found = [operator.index(i) + (n if operator.index(i) < 0 else 0)
                 for i, n in zip(place, self.shape)]
        if any(not 0 <= i < n for i, n in zip(found, self.shape)):
            raise IndexError(f"voxel {place} in a grid of {self.shape}")
        return found[0], found[1], found[2]

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Grid):
            return NotImplemented
        return bool(lib.sf_grid_equal(self._c, other._c))

    __hash__ = None  # type: ignore[assignment]

    def _with(self, other: Grid, call: Any) -> Grid:
        if not isinstance(other, Grid):
            return NotImplemented
        if other.shape != self.shape:
            raise ValueError(f"grids of {self.shape} and {other.shape}")
        made = self.copy()
        for k in range(self.shape[0]):
            to = lib.sf_grid_slice(made._c, k)
            ok(call(to, to, lib.sf_grid_slice(other._c, k)))
        return made

    def __and__(self, other: Grid) -> Grid:
        return self._with(other, lib.sf_slice_and)

    def __or__(self, other: Grid) -> Grid:
        return self._with(other, lib.sf_slice_or)

    def __xor__(self, other: Grid) -> Grid:
        return self._with(other, lib.sf_slice_xor)

    def __sub__(self, other: Grid) -> Grid:
        return self._with(other, lib.sf_slice_subtract)

    def __repr__(self) -> str:
        nz, ny, nx = self.shape
        return f"<libsf.Grid {nx} x {ny} x {nz}, {self.count()} solid voxels>"


def _bools(array: Any, name: str) -> Bools:
    if isinstance(array, Grid):
        return array.array()
    if not isinstance(array, np.ndarray):
        array = np.asarray(array, np.bool_)
    if array.dtype != np.bool_:
        raise TypeError(f"{name}: the array is of {array.dtype}, and bool is needed; "
                        f"{name} > 0 is one")
    if array.ndim != 3:
        raise ValueError(f"{name}: the array has {array.ndim} axes, and (layer, y, x) is needed")
    checked: Bools = array
    return checked


def grid_of(what: Any, name: str = "grid") -> Grid:
    """A grid that is one; else what makes one of what was handed in."""
    if isinstance(what, Grid):
        return what
    raise TypeError(f"{name}: a Grid is needed, not {type(what).__name__}; libsf.voxelize(mesh, pitch_mm=...) "
                    f"makes one of a mesh, libsf.Grid.from_array(array) one of an array of bools")


def grid_or_null(grid: Grid | None, name: str = "grid") -> Any:
    return ffi.NULL if grid is None else grid_of(grid, name)._c
