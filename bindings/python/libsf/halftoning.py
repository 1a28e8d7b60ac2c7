"""Tones to materials: by a mask or by diffused errors, shells to keep clear, and what it takes."""

from __future__ import annotations

from typing import Any, Iterator, Sequence

import numpy as np
import numpy.typing as npt

from . import _core, _types
from ._core import Progress, documented, ffi, lib, ok, running
from ._types import MaskKind, ToneType
from .layers import Layer
from .mesh import as_mesh
from .voxel import Lattice, _lattice

Ids = npt.NDArray[np.uint8]
KeepOut = tuple[Layer, int, int]
TYPES = {np.dtype(np.uint8): ToneType.U8, np.dtype(np.float32): ToneType.F32, np.dtype(np.float64): ToneType.F64}


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

    @classmethod
    @documented("sf_mask_from_ranks")
    def of(cls, ranks: Any) -> Mask:
        """One of ranks that were kept, (layer, y, x) of uint32."""
        ranks, made = _core.array_in(ranks, np.uint32, (None, None, None), "ranks"), ffi.new("sf_mask **")
        nz, ny, nx = ranks.shape
        ok(lib.sf_mask_from_ranks(nx, ny, nz, _core.pointer("uint32_t", ranks), ffi.NULL, made))
        return cls(made[0], True)

    def ranks(self) -> npt.NDArray[np.uint32]:
        """The ranks in (layer, y, x) order."""
        size = ffi.new("uint32_t[3]")
        lib.sf_mask_size(self._c, size)
        nx, ny, nz = size
        return np.array([[[lib.sf_mask_rank(self._c, x, y, z) for x in range(nx)]
                          for y in range(ny)] for z in range(nz)], np.uint32)


# --- Tones --------------------------------------------------------------------------------------


class _Asked:
    """Tones of a slice as the library has them, and where its materials go."""

    def __init__(self, tones: Any, solid: Any, layer: int, keep_outs: Sequence[KeepOut]) -> None:
        tones = np.asarray(tones)
        if tones.ndim == 2:
            rest = (255 - tones) if tones.dtype == np.uint8 else (1 - tones)
            tones = np.stack([rest, tones]).astype(tones.dtype)
        if tones.ndim != 3 or tones.dtype not in TYPES:
            raise TypeError(f"tones: {tones.dtype} of {tones.ndim} axes, and uint8, float32 or float64 "
                            "of (materials, y, x) is needed")
        self._tones = np.ascontiguousarray(tones)
        self.count, height, width = tones.shape
        self._planes = ffi.new("sf_tone_plane[]", self.count)
        for m in range(self.count):
            self._planes[m].values, self._planes[m].stride = ffi.from_buffer(self._tones[m]), width
        self.c = ffi.new("sf_tones *")
        self.c.struct_size = ffi.sizeof("sf_tones")
        self.c.width, self.c.height, self.c.layer = width, height, layer
        self.c.type, self.c.planes = int(TYPES[tones.dtype]), self._planes
        self._layers = [_layer(solid, (height, width), "solid")] if solid is not None else []
        if self._layers:
            self.c.solid = self._layers[0]._c
        self._keep = ffi.new("sf_keep_out[]", max(len(keep_outs), 1))
        for i, (where, material, instead) in enumerate(keep_outs):
            kept = _layer(where, (height, width), "keep_outs")
            self._layers.append(kept)
            self._keep[i].where, self._keep[i].material, self._keep[i].instead = kept._c, material, instead
        self.c.keep_outs, self.c.keep_out_count = self._keep, len(keep_outs)
        self.ids = np.zeros((height, width), np.uint8)
        self.to = ffi.new("sf_materials *")
        self.to.ids, self.to.ids_stride = _core.pointer("uint8_t", self.ids), width


def _layer(given: Any, shape: tuple[int, int], name: str) -> Layer:
    layer = given if isinstance(given, Layer) else Layer.from_array(np.asarray(given, np.bool_))
    if layer.shape != shape:
        raise ValueError(f"{name}: its shape is {layer.shape}, and {shape} is needed")
    return layer


@documented("sf_halftone_slice")
def halftone(tones: Any, *, solid: Any = None, layer: int = 0, mask: Mask | None = None,
             keep_outs: Sequence[KeepOut] = (), threads: int | None = 1) -> Ids:
    """Materials of a slice: 0 none, else the material's number and 1.

    `tones` is (materials, y, x) or, for two materials, the tone (y, x) of the second, as float32,
    float64 or uint8 (255 is all); they add up to at most 1, and the last material gets what is
    left. `solid` is a Layer or a bool array (y, x). Of each of `keep_outs`, a Layer and two
    materials, the second takes the first one's place where the layer is solid.
    """
    asked, made = _Asked(tones, solid, layer, keep_outs), ffi.new("sf_halftone **")
    ok(lib.sf_halftone_create((mask or Mask.builtin())._c, asked.count, ffi.NULL, made))
    kept = ffi.gc(made[0], lib.sf_halftone_destroy)
    with running(None, threads) as task:
        ok(lib.sf_halftone_slice(kept, asked.c, asked.to, task))
    return asked.ids


class Diffuser(_core.InTurn):
    """Diffuses errors through slices of one size, from the lowest up."""

    @documented("sf_diffuser_create")
    def __init__(self, width: int, height: int, materials: int = 2,
                 pitch_mm: Sequence[float] = (1, 1, 1)) -> None:
        made = ffi.new("sf_diffuser **")
        ok(lib.sf_diffuser_create(width, height, materials, _core.numbers(list(pitch_mm), 3, "pitch_mm"),
                                  ffi.NULL, made))
        self._c, self._count = ffi.gc(made[0], lib.sf_diffuser_destroy), materials

    @documented("sf_diffuser_slice")
    @_core.in_turn
    def push(self, tones: Any, *, solid: Any = None, keep_outs: Sequence[KeepOut] = ()) -> Ids:
        """The materials of the next slice up; tones as `halftone` takes them."""
        asked = _Asked(tones, solid, 0, keep_outs)
        if asked.count != self._count:
            raise ValueError(f"tones: of {asked.count} materials, and the diffuser has {self._count}")
        ok(lib.sf_diffuser_slice(self._c, asked.c, asked.to))
        return asked.ids

    @documented("sf_diffuser_report")
    @_core.in_turn
    def report(self) -> list[_types.Diffusion]:
        """What became of the tones of each material so far, in voxels."""
        found = ffi.new("sf_diffusion[]", self._count)
        ok(lib.sf_diffuser_report(self._c, found))
        return [_core.value(d) for d in found]


# --- Shells -------------------------------------------------------------------------------------


class Shell(_core.InTurn):
    """The voxels that come nearer than a distance to a surface, any layer by its number."""

    @documented("sf_shell_create")
    def __init__(self, mesh: Any, lattice: Lattice, distance_mm: float = 0.0) -> None:
        self._mesh, made, fault = as_mesh(mesh), ffi.new("sf_shell **"), _core.new_fault()
        with _lattice(lattice) as c:
            ok(lib.sf_shell_create(self._mesh._view, c, distance_mm, ffi.NULL, made, fault), fault)
        self._c, self._lattice = ffi.gc(made[0], lib.sf_shell_destroy), lattice

    def __len__(self) -> int:
        return self._lattice.nz

    @documented("sf_shell_slice")
    @_core.in_turn
    def __getitem__(self, k: int) -> Layer:
        """Layer k; a new one each time."""
        if not -len(self) <= k < len(self):
            raise IndexError(f"layer {k} of {len(self)}")
        layer = Layer(self._lattice.nx, self._lattice.ny)
        ok(lib.sf_shell_slice(self._c, k % len(self), layer._c))
        return layer

    def __iter__(self) -> Iterator[Layer]:
        return (self[k] for k in range(len(self)))


@documented("sf_material_uses")
def material_uses(lattice: Lattice, counts: Any, density_g_cm3: Any = None) -> list[_types.MaterialUse]:
    """Voxels, volume and grams of each material, of its voxels in each layer: (layers, materials)."""
    counts = _core.array_in(counts, np.uint64, (lattice.nz, None), "counts")
    materials = counts.shape[1]
    found = ffi.new("sf_material_use[]", max(materials, 1))
    weights = ffi.NULL if density_g_cm3 is None else _core.numbers(density_g_cm3, materials, "density_g_cm3")
    with _lattice(lattice) as c:
        ok(lib.sf_material_uses(c, _core.pointer("uint64_t", counts), materials, weights, found))
    return [_core.value(found[i]) for i in range(materials)]


__all__ = ["Diffuser", "Mask", "MaskKind", "Shell", "halftone", "material_uses"]
