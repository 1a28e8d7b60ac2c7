"""Graded solids: cages with properties, their limit, slices of it, mixtures and halftones."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Iterator, Sequence

import numpy as np
import numpy.typing as npt

from . import _core, _types
from ._core import Progress, documented, ffi, lib, ok, running
from ._types import Falloff, MaskKind, PaintOperation, PaintWhere, Property, Trend
from .mesh import Mesh
from .voxel import Grid, Lattice, _lattice

Floats = npt.NDArray[np.float64]


# --- Cages --------------------------------------------------------------------------------------


class Cage:
    """A control mesh of cells, or of faces alone, with properties at its points.

    `cells` is an (n, 8) array of hexahedra, or a list of cells of any kind that is served: 4 points
    are a tetrahedron, 6 a wedge, 8 a hexahedron; with `dimension=2` faces of 3 points and more.
    """

    @documented("sf_cage_create")
    def __init__(self, points: Any, cells: Any, *, dimension: int = 3,
                 properties: dict[str, Any] | None = None,
                 creases: Sequence[tuple[int, int, float]] = ()) -> None:
        points = _core.array_in(points, np.float64, (None, 3), "points")
        counts = np.array([len(c) for c in cells], np.uint32)
        starts = np.concatenate([[0], np.cumsum(counts)]).astype(np.uint32)
        corners = np.concatenate([np.asarray(c, np.uint32) for c in cells]) if len(counts) else \
            np.zeros(0, np.uint32)
        sharp = ffi.new("sf_crease[]", [{"points": [a, b], "sharpness": s} for a, b, s in creases] or 1)
        view, fault, made = ffi.new("sf_cage_view *"), _core.new_fault(), ffi.new("sf_cage **")
        view.dimension = dimension
        view.point_count, view.positions = len(points), _core.pointer("double", points)
        view.cell_count, view.starts = len(counts), _core.pointer("uint32_t", starts)
        view.corners = _core.pointer("uint32_t", corners)
        view.crease_count, view.creases = len(creases), sharp
        ok(lib.sf_cage_create(view, ffi.NULL, made, fault), fault)
        self._take(made[0])
        for name, values in (properties or {}).items():
            self.add_property(name, values)

    def _take(self, c: Any) -> None:
        self._c = ffi.gc(c, lib.sf_cage_destroy)

    @classmethod
    @documented("sf_cage_block")
    def block(cls, counts: Sequence[int], low_mm: Sequence[float], high_mm: Sequence[float]) -> Cage:
        """A box of so many cells along x, y and z."""
        made = ffi.new("sf_cage **")
        ok(lib.sf_cage_block([int(n) for n in counts], _core.numbers(list(low_mm), 3, "low_mm"),
                             _core.numbers(list(high_mm), 3, "high_mm"), ffi.NULL, made))
        cage = cls.__new__(cls)
        cage._take(made[0])
        return cage

    @classmethod
    @documented("sf_cage_read")
    def load(cls, path: str | os.PathLike[str]) -> Cage:
        """Read legacy VTK, Medit .mesh or MFEM .mesh."""
        fault, file, made = _core.new_fault(), ffi.new("sf_file **"), ffi.new("sf_cage **")
        ok(lib.sf_file_open(os.fsencode(path), ffi.NULL, file, fault), fault)
        try:
            ok(lib.sf_cage_read(lib.sf_file_source(file[0]), ffi.NULL, ffi.NULL, made, ffi.NULL, fault), fault)
        finally:
            lib.sf_file_close(file[0])
        cage = cls.__new__(cls)
        cage._take(made[0])
        return cage

    @documented("sf_cage_write_vtk")
    def save(self, path: str | os.PathLike[str]) -> None:
        """Write legacy VTK, which ParaView opens and `load` reads; whole or not at all."""
        save, fault = ffi.new("sf_save **"), _core.new_fault()
        view = ffi.new("sf_cage_view *", self._view)
        ok(lib.sf_save_begin(os.fsencode(path), ffi.NULL, save, fault), fault)
        status = lib.sf_cage_write_vtk(view, 1, ffi.NULL, lib.sf_save_sink(save[0]), fault)
        if status != 0:
            lib.sf_save_abort(save[0])
            ok(status, fault)
        ok(lib.sf_save_commit(save[0], fault), fault)

    @property
    def _view(self) -> Any:
        return lib.sf_cage_get_view(self._c)

    @property
    def points(self) -> Floats:
        """(n, 3), mm; the cage's own memory, to be read."""
        v = self._view
        return _core.memory(v.positions, "float64", (v.point_count, 3), self._c)

    @documented("sf_cage_set_positions")
    def move(self, points: Any, first: int = 0) -> None:
        """Put points elsewhere."""
        points = _core.array_in(points, np.float64, (None, 3), "points")
        ok(lib.sf_cage_set_positions(self._c, first, len(points), _core.pointer("double", points)))

    @property
    def properties(self) -> dict[str, Property]:
        """What is known of each property, by its name."""
        v = self._view
        found = [_core.value(v.channels[i].property) for i in range(v.channel_count)]
        return {p.name: p for p in found}

    def _channel(self, name: str) -> int:
        names = list(self.properties)
        if name not in names:
            raise KeyError(f"{name}: the cage has {', '.join(names) or 'no properties'}")
        return names.index(name)

    def values(self, name: str) -> Floats:
        """The values of a property; the cage's own memory, to be read."""
        i, v = self._channel(name), self._view
        return _core.memory(v.channels[i].values, "float64", (v.channels[i].value_count,), self._c)

    @documented("sf_cage_set_values")
    def set_values(self, name: str, values: Any, first: int = 0) -> None:
        """Change values of a property."""
        i = self._channel(name)
        values = _core.array_in(values, np.float64, (None,), "values")
        ok(lib.sf_cage_set_values(self._c, i, first, len(values), _core.pointer("double", values)))

    @documented("sf_cage_add_property")
    def add_property(self, name: str, values: Any, low: float = -np.inf, high: float = np.inf) -> None:
        """A new property: a value for each point."""
        values = _core.array_in(values, np.float64, (self._view.point_count,), "values")
        channel, fault = ffi.new("sf_channel *"), _core.new_fault()
        ok(lib.sf_property_named(name.encode(), ffi.addressof(channel, "property")))
        channel.property.low, channel.property.high = low, high
        channel.value_count, channel.values = len(values), _core.pointer("double", values)
        ok(lib.sf_cage_add_property(self._c, channel, fault), fault)

    @documented("sf_paint_select", "sf_paint_values")
    def paint(self, name: str, at_mm: Sequence[float], radius_mm: float, amount: float, *,
              to_mm: Sequence[float] | None = None, operation: PaintOperation | str = PaintOperation.SET,
              falloff: Falloff | None = None, where: PaintWhere | None = None,
              strength: float = 1.0) -> int:
        """Paint a property with a ball, or what it sweeps on its way to another place. How many
        values are others now."""
        operation = PaintOperation[operation.upper()] if isinstance(operation, str) else operation
        brush = _core.options("sf_paint_brush", from_mm=[float(x) for x in at_mm],
                              to_mm=[float(x) for x in (at_mm if to_mm is None else to_mm)],
                              radius_mm=radius_mm, strength=strength,
                              falloff=None if falloff is None else int(falloff),
                              where=None if where is None else int(where))
        weights, changed = np.zeros(self._view.point_count), ffi.new("size_t *")
        c = _core.pointer("double", weights)
        ok(lib.sf_paint_select(self._c, brush, c, ffi.NULL))
        ok(lib.sf_paint_values(self._c, self._channel(name), c, int(operation), amount, ffi.NULL, changed))
        return int(changed[0])

    @documented("sf_cage_check")
    def check(self) -> _types.CageReport:
        """How it hangs together, and whether its cells are the right way out."""
        report = ffi.new("sf_cage_report *")
        ok(lib.sf_cage_check(self._c, ffi.NULL, report, ffi.NULL))
        return _core.value(report)  # type: ignore[no-any-return]

    @documented("sf_limit_create")
    def limit(self) -> Limit:
        """The smooth solid that it makes, to be evaluated and sliced."""
        return Limit(self)

    def __repr__(self) -> str:
        v = self._view
        return f"<libsf.Cage {v.point_count} points, {v.cell_count} cells, {list(self.properties)}>"


class Limit:
    """The limit of a cage under Catmull-Clark subdivision."""

    def __init__(self, cage: Cage) -> None:
        made = ffi.new("sf_limit **")
        with running() as task:
            ok(lib.sf_limit_create(cage._c, 0, ffi.NULL, task, made))
        self._c = ffi.gc(made[0], lib.sf_limit_destroy)
        self._cage = cage

    def _places(self, cells: Any, u: Any) -> tuple[Any, int]:
        cells = np.atleast_1d(np.asarray(cells, np.int64))
        at = np.atleast_2d(np.asarray(u, np.float64))
        if at.shape != (len(cells), 3):
            raise ValueError(f"u: its shape is {at.shape}, and ({len(cells)}, 3) is needed")
        places = ffi.new("sf_place[]", max(len(cells), 1))
        for i, (cell, p) in enumerate(zip(cells, at)):
            ok(lib.sf_limit_place(self._c, int(cell), list(map(float, p)), places + i))
        return places, len(cells)

    @documented("sf_limit_positions")
    def positions(self, cells: Any, u: Any, *, threads: int | None = 1) -> Floats:
        """Where places lie, (n, 3): cells, and parameters (n, 3) from 0 to 1."""
        places, count = self._places(cells, u)
        found = np.empty((count, 3))
        with running(None, threads) as task:
            ok(lib.sf_limit_positions(self._c, count, places, ffi.NULL, task,
                                      _core.pointer("double", found), ffi.NULL))
        return found

    @documented("sf_limit_values")
    def values(self, name: str, cells: Any, u: Any, *, threads: int | None = 1) -> Floats:
        """What a property is at places, (n,)."""
        places, count = self._places(cells, u)
        found = np.empty(count)
        with running(None, threads) as task:
            ok(lib.sf_limit_values(self._c, self._cage._channel(name), count, places, ffi.NULL, task,
                                   _core.pointer("double", found), ffi.NULL))
        return found

    @documented("sf_limit_bounds")
    def bounds(self) -> Floats:
        """The box around it: (2, 3), mm."""
        low, high = ffi.new("double[3]"), ffi.new("double[3]")
        ok(lib.sf_limit_bounds(self._c, ffi.NULL, ffi.NULL, low, high))
        return np.array([list(low), list(high)])

    @documented("sf_sampler_create", "sf_sampler_slice")
    def slices(self, lattice: Lattice, names: Sequence[str] = ()) -> Sampler:
        """Its slices on a lattice, with the properties of each voxel."""
        return Sampler(self, lattice, names)


@dataclass(frozen=True)
class Slice:
    """A slice: what is solid, (y, x), and each property there, 0 elsewhere."""

    solid: npt.NDArray[np.bool_]
    values: dict[str, Floats]


class Sampler:
    """Slices of a limit: any one by its number, or all by iterating."""

    def __init__(self, limit: Limit, lattice: Lattice, names: Sequence[str]) -> None:
        channels = ffi.new("size_t[]", [limit._cage._channel(n) for n in names] or [0])
        made, fault = ffi.new("sf_sampler **"), _core.new_fault()
        with _lattice(lattice) as c, running() as task:
            ok(lib.sf_sampler_create(limit._c, c, ffi.NULL, len(names), channels, ffi.NULL, task,
                                     made, fault), fault)
        self._c = ffi.gc(made[0], lib.sf_sampler_destroy)
        self._kept = limit
        self._lattice = lattice
        self._names = tuple(names)
        self._layer = Grid(Lattice(lattice.nx, lattice.ny, 1))

    def __len__(self) -> int:
        return self._lattice.nz

    def __getitem__(self, k: int) -> Slice:
        if not -len(self) <= k < len(self):
            raise IndexError(f"slice {k} of {len(self)}")
        values = {n: np.empty((self._lattice.ny, self._lattice.nx)) for n in self._names}
        planes = ffi.new("double *[]", [_core.pointer("double", v) for v in values.values()] or [ffi.NULL])
        ok(lib.sf_sampler_slice(self._c, k % len(self), lib.sf_grid_slice(self._layer._c, 0),
                                ffi.cast("double *const *", planes)))
        return Slice(self._layer.array()[0], values)

    def __iter__(self) -> Iterator[Slice]:
        return (self[k] for k in range(len(self)))

    @documented("sf_sampler_surface")
    def surface(self) -> Mesh:
        """The surface by which voxels are solid."""
        return Mesh._copied(lib.sf_sampler_surface(self._c, ffi.NULL))


# --- Mixtures -----------------------------------------------------------------------------------


class Mixture:
    """Measured mixtures of materials: which fractions give wanted properties, and what they give.

    `fractions` is (n, materials), each row summing to 1; `properties` (n, properties).
    """

    @documented("sf_mixture_create")
    def __init__(self, fractions: Any, properties: Any) -> None:
        fractions = _core.array_in(fractions, np.float64, (None, None), "fractions")
        properties = _core.array_in(properties, np.float64, (len(fractions), None), "properties")
        samples, fault, made = ffi.new("sf_mixture_samples *"), _core.new_fault(), ffi.new("sf_mixture **")
        samples.material_count, samples.property_count = fractions.shape[1], properties.shape[1]
        samples.count = len(fractions)
        samples.fractions = _core.pointer("double", fractions)
        samples.properties = _core.pointer("double", properties)
        ok(lib.sf_mixture_create(samples, ffi.NULL, made, fault), fault)
        self._c = ffi.gc(made[0], lib.sf_mixture_destroy)
        self._shape = (fractions.shape[1], properties.shape[1])

    @documented("sf_mixture_fractions")
    def fractions(self, wanted: Any) -> tuple[Floats, float]:
        """The fractions whose properties come nearest, and how far off those are."""
        found, miss = np.empty(self._shape[0]), ffi.new("double *")
        hint = ffi.new("size_t *", 0)
        ok(lib.sf_mixture_fractions(self._c, _core.numbers(np.atleast_1d(np.asarray(wanted, np.float64)), self._shape[1], "wanted"),
                                    hint, _core.pointer("double", found), ffi.NULL, miss))
        return found, miss[0]

    @documented("sf_mixture_properties")
    def properties(self, fractions: Any) -> Floats:
        """What a mixture of these fractions gives."""
        found = np.empty(self._shape[1])
        ok(lib.sf_mixture_properties(self._c, _core.numbers(fractions, self._shape[0], "fractions"),
                                     _core.pointer("double", found), ffi.NULL))
        return found


# --- Halftones ----------------------------------------------------------------------------------


class Mask:
    """Ranks that spread what is below any threshold evenly, in millimetres."""

    def __init__(self, c: Any, owned: bool) -> None:
        self._c = ffi.gc(c, lib.sf_mask_destroy) if owned else c

    @classmethod
    @documented("sf_mask_builtin")
    def builtin(cls) -> Mask:
        """The one of 32 x 32 x 32 voxels that is part of the library."""
        return cls(lib.sf_mask_builtin(), False)

    @classmethod
    @documented("sf_mask_create")
    def create(cls, size: Sequence[int] = (32, 32, 32), pitch_mm: Sequence[float] = (1, 1, 1), *,
               kind: MaskKind | None = None, seed: int = 0, progress: Progress = None) -> Mask:
        """A new one for voxels of these proportions."""
        made = ffi.new("sf_mask **")
        options = _core.options("sf_mask_options", nx=size[0], ny=size[1], nz=size[2], seed=seed,
                                kind=None if kind is None else int(kind),
                                pitch_mm=[float(p) for p in pitch_mm])
        with running(progress) as task:
            ok(lib.sf_mask_create(options, ffi.NULL, task, made))
        return cls(made[0], True)

    def ranks(self) -> npt.NDArray[np.uint32]:
        """The ranks in (layer, y, x) order."""
        size = ffi.new("uint32_t[3]")
        lib.sf_mask_size(self._c, size)
        nx, ny, nz = size
        return np.array([[[lib.sf_mask_rank(self._c, x, y, z) for x in range(nx)]
                          for y in range(ny)] for z in range(nz)], np.uint32)


@documented("sf_halftone_slice")
def halftone(tones: Any, *, solid: Any = None, layer: int = 0, mask: Mask | None = None,
             threads: int | None = 1) -> npt.NDArray[np.uint8]:
    """Materials of a slice: 0 none, else the material's number and 1.

    `tones` is (materials, y, x) or, for two materials, the tone (y, x) of the second, as float32 or
    uint8 (255 is all); they add up to at most 1, and the last material gets what is left. `solid`
    is a bool array (y, x).
    """
    tones = np.asarray(tones)
    if tones.ndim == 2:
        rest = (255 - tones) if tones.dtype == np.uint8 else (1 - tones)
        tones = np.stack([rest, tones]).astype(tones.dtype)
    if tones.ndim != 3 or tones.dtype not in (np.uint8, np.float32, np.float64):
        raise TypeError(f"tones: {tones.dtype} of {tones.ndim} axes, and uint8, float32 or float64 "
                        "of (materials, y, x) is needed")
    tones = np.ascontiguousarray(tones)
    count, height, width = tones.shape
    planes = ffi.new("sf_tone_plane[]", count)
    for m in range(count):
        planes[m].values = ffi.from_buffer(tones[m])
        planes[m].stride = width
    asked = ffi.new("sf_tones *")
    asked.struct_size = ffi.sizeof("sf_tones")
    asked.width, asked.height, asked.layer = width, height, layer
    asked.type = {np.dtype(np.uint8): 0, np.dtype(np.float32): 1, np.dtype(np.float64): 2}[tones.dtype]
    asked.planes = planes
    shape = None
    if solid is not None:
        shape = Grid.from_array(np.asarray(solid, np.bool_)[None])
        if shape.shape != (1, height, width):
            raise ValueError(f"solid: its shape is {shape.shape[1:]}, and {(height, width)} is needed")
        asked.solid = lib.sf_grid_slice(shape._c, 0)
    found = np.zeros((height, width), np.uint8)
    to, made = ffi.new("sf_materials *"), ffi.new("sf_halftone **")
    to.ids, to.ids_stride = _core.pointer("uint8_t", found), width
    ok(lib.sf_halftone_create((mask or Mask.builtin())._c, count, ffi.NULL, made))
    kept = ffi.gc(made[0], lib.sf_halftone_destroy)
    with running(None, threads) as task:
        ok(lib.sf_halftone_slice(kept, asked, to, task))
    return found


__all__ = ["Cage", "Falloff", "Limit", "Mask", "MaskKind", "Mixture", "PaintOperation", "PaintWhere", "Property", "Sampler", "Slice", "Trend",
           "halftone"]
