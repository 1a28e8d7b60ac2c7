"""3MF files as a whole: objects, colors, places, slices, and what fills an object.

`Mesh.load()` and `Mesh.save()` are enough for one mesh.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Iterable, Sequence

import numpy as np
import numpy.typing as npt

from . import _core, _files
from ._core import Progress, documented, ffi, lib, ok, running
from ._types import Status
from ._types import ThreemfKind as ThreemfKind
from .contours import ContourStack
from .mesh import Mesh, as_mesh
from .voxel import Lattice, _lattice

NONE = 2**32 - 1
Fill = Callable[[int], Any]


@dataclass(frozen=True)
class Color:
    """A material, which has a name, or a color of a group: red, green, blue and alpha, 0 to 255."""

    rgba: tuple[int, int, int, int]
    name: str = ""
    group: int = 0


@dataclass(frozen=True)
class Part:
    """An object of a file.

    `colors` are numbers of the file's colors, (faces, 3), one for each corner, or -1 for none.
    """

    mesh: Mesh
    name: str = ""
    kind: ThreemfKind = ThreemfKind.MODEL
    colors: npt.NDArray[np.int64] | None = None
    is_rough: bool = False
    is_sliced: bool = False


@dataclass(frozen=True)
class Placed:
    """A part in its place: the part's number and a 4 x 4 matrix to the axes of the bed."""

    part: int
    matrix: npt.NDArray[np.float64]


@dataclass(frozen=True)
class Filling:
    """Properties inside a part, on a lattice.

    `fields` are a name, a low and a high value each; `layer(k)` returns an array (fields, y, x) of
    their values in layer k.
    """

    lattice: Lattice
    fields: Sequence[tuple[str, float, float]]
    layer: Fill
    part: int = 0


class ThreeMF:
    """A 3MF file that was read.

        file = libsf.ThreeMF.load("part.3mf")
        mesh = file.merged()
        if file.is_sliced:
            stack = file.contours()
    """

    @classmethod
    @documented("sf_threemf_read")
    def load(cls, of: _files.Readable, *, bytes_max: int | None = None,
             triangles_max: int | None = None, vertices_max: int | None = None) -> ThreeMF:
        """Read a file: a path, bytes, or a file that is open."""
        limits = _core.options("sf_read_limits", bytes_max=bytes_max, triangles_max=triangles_max,
                               vertices_max=vertices_max)
        fault, made = _core.new_fault(), ffi.new("sf_threemf **")
        with _files.source(of) as source:
            ok(lib.sf_threemf_read(source, limits, ffi.NULL, made, fault), fault)
        found = cls.__new__(cls)
        found._c = ffi.gc(made[0], lib.sf_threemf_destroy)
        return found

    _c: Any

    @property
    def _view(self) -> Any:
        return lib.sf_threemf_get_view(self._c)

    @property
    @documented("sf_threemf_get_view")
    def colors(self) -> list[Color]:
        """All materials and colors of groups."""
        v = self._view
        return [Color(tuple(v.colours[i].rgba), _text(v.colours[i].name), v.colours[i].group)
                for i in range(v.colour_count)]

    @property
    def parts(self) -> list[Part]:
        """Objects that have triangles, in mm and their own axes."""
        v = self._view
        return [_part(v.objects[i]) for i in range(v.object_count)]

    @property
    def build(self) -> list[Placed]:
        """What is printed, and where; components are resolved."""
        v = self._view
        return [Placed(v.items[i].object, _matrix(v.items[i].placed)) for i in range(v.item_count)]

    @documented("sf_threemf_merge")
    def merged(self, *, triangles_max: int | None = None) -> Mesh:
        """One mesh of all that is built."""
        limits = _core.options("sf_read_limits", triangles_max=triangles_max)
        fault, made = _core.new_fault(), ffi.new("sf_mesh **")
        ok(lib.sf_threemf_merge(self._c, limits, ffi.NULL, made, fault), fault)
        return Mesh._of(made[0])

    @property
    @documented("sf_threemf_is_sliced")
    def is_sliced(self) -> bool:
        """Whether all that is built has slices."""
        return bool(lib.sf_threemf_is_sliced(self._c))

    @documented("sf_threemf_contours")
    def contours(self) -> ContourStack:
        """The slices of all that is built."""
        fault, made = _core.new_fault(), ffi.new("sf_contour_stack **")
        ok(lib.sf_threemf_contours(self._c, ffi.NULL, made, fault), fault)
        return ContourStack._of(made[0])

    def __repr__(self) -> str:
        v = self._view
        return f"<libsf.ThreeMF {v.object_count} parts, {v.item_count} places>"


def _text(c: Any) -> str:
    return ffi.string(c).decode()  # type: ignore[no-any-return]


def _matrix(c: Any) -> npt.NDArray[np.float64]:
    made = np.eye(4)
    made[:3, :3] = np.array(list(c.matrix)).reshape(3, 3)
    made[:3, 3] = list(c.shift_mm)
    return made


def _part(c: Any) -> Part:
    colors = None
    if c.colours != ffi.NULL:
        found = np.frombuffer(bytes(ffi.buffer(c.colours, 12 * c.mesh.triangle_count)), np.uint32)
        colors = np.where(found == NONE, -1, found.astype(np.int64)).reshape(-1, 3)
    return Part(Mesh._copied(c.mesh), _text(c.name), ThreemfKind(c.kind), colors, bool(c.is_rough),
                c.stack != NONE)


# --- writing -------------------------------------------------------------------------------------


class _Layers:
    """What fills a part, while it is written, and what it raised meanwhile."""

    def __init__(self, filling: Filling) -> None:
        self.filling = filling
        self.error: BaseException | None = None
        self.handle = ffi.new_handle(self)

    def fill(self, k: int, planes: Any) -> None:
        lattice, fields = self.filling.lattice, self.filling.fields
        values = np.asarray(self.filling.layer(k), np.float64)
        if np.isnan(values).any():
            raise ValueError(f"layer {k}: it holds what is no number")
        if values.shape != (len(fields), lattice.ny, lattice.nx):
            raise ValueError(f"layer {k}: its shape is {values.shape}, and "
                             f"{(len(fields), lattice.ny, lattice.nx)} is needed")
        for i, (_, low, high) in enumerate(fields):
            share = np.clip((values[i] - low) / (high - low), 0, 1)
            levels = np.ascontiguousarray(np.floor(share * 65535 + 0.5), np.uint16)
            ffi.memmove(planes[i], levels, levels.nbytes)


@ffi.def_extern(error=int(Status.ERR_IO))  # type: ignore[misc, unused-ignore, untyped-decorator]
def sf_py_layer(user: Any, k: int, planes: Any) -> int:
    layers: _Layers = ffi.from_handle(user)
    try:
        layers.fill(k, planes)
        return 0
    except BaseException as error:
        layers.error = error
        return int(Status.ERR_IO)


class _Kept:
    """What C structs point at, for as long as they do."""

    def __init__(self) -> None:
        self.all: list[Any] = []

    def text(self, words: str) -> Any:
        return self.keep(ffi.new("char[]", _core.text(words, "name")))

    def keep(self, what: Any) -> Any:
        self.all.append(what)
        return what


def _c_object(to: Any, part: Part, colors: int, kept: _Kept) -> None:
    mesh = kept.keep(as_mesh(part.mesh))
    to.name, to.kind, to.mesh, to.stack = kept.text(part.name), int(part.kind), mesh._view, NONE
    if part.colors is None:
        return
    numbers = _core.whole_numbers(part.colors, np.int64, "colors")
    if numbers.shape != mesh.faces.shape or ((numbers < -1) | (numbers >= colors)).any():
        raise ValueError(f"colors: give numbers of colors, one for each corner of {len(mesh.faces)} faces")
    held = kept.keep(np.ascontiguousarray(np.where(numbers < 0, NONE, numbers), np.uint32))
    to.colours = _core.pointer("uint32_t", held)


def _c_volume(filling: Filling, c_lattice: Any, layers: _Layers, kept: _Kept) -> Any:
    fields = kept.keep(ffi.new("sf_threemf_field[]", max(len(filling.fields), 1)))
    for i, (name, low, high) in enumerate(filling.fields):
        fields[i].name, fields[i].low, fields[i].high = kept.text(name), low, high
    c = kept.keep(ffi.new("sf_threemf_volume *"))
    c.object, c.lattice, c.mixed_group = filling.part, c_lattice[0], NONE
    c.field_count, c.fields = len(filling.fields), fields
    c.layer, c.user = lib.sf_py_layer, layers.handle
    return c


def _c_view(parts: Sequence[Part], build: Iterable[Placed], colors: Sequence[Color], kept: _Kept) -> Any:
    c = kept.keep(ffi.new("sf_threemf_view *"))
    items = list(build)
    c.colours = kept.keep(ffi.new("sf_threemf_colour[]", max(len(colors), 1)))
    c.objects = kept.keep(ffi.new("sf_threemf_object[]", max(len(parts), 1)))
    c.items = kept.keep(ffi.new("sf_threemf_item[]", max(len(items), 1)))
    c.colour_count, c.object_count, c.item_count = len(colors), len(parts), len(items)
    for i, color in enumerate(colors):
        c.colours[i].name, c.colours[i].rgba, c.colours[i].group = kept.text(color.name), color.rgba, color.group
    for i, part in enumerate(parts):
        _c_object(c.objects[i], part, len(colors), kept)
    for i, item in enumerate(items):
        matrix: Any = np.asarray(item.matrix, np.float64)
        if matrix.shape != (4, 4) or not np.allclose(matrix[3], (0, 0, 0, 1)):
            raise ValueError("matrix: give one of 4 x 4, its last row 0, 0, 0, 1")
        c.items[i].object = item.part
        c.items[i].placed.matrix = [float(x) for x in matrix[:3, :3].reshape(-1)]
        c.items[i].placed.shift_mm = [float(x) for x in matrix[:3, 3]]
    return c


@documented("sf_threemf_write")
def save_threemf(to: _files.Writable, parts: Iterable[Part | Mesh], *, build: Iterable[Placed] | None = None,
                 colors: Sequence[Color] = (), thumbnail: bytes | None = None,
                 filling: Filling | None = None, progress: Progress = None) -> None:
    """Write a file of parts, each in its own place where `build` says nothing.

        libsf.save_threemf("two.3mf", [mesh, other])
    """
    kept = _Kept()
    all_parts = [p if isinstance(p, Part) else Part(as_mesh(p)) for p in parts]
    places = [Placed(i, np.eye(4)) for i in range(len(all_parts))] if build is None else build
    view = _c_view(all_parts, places, colors, kept)
    extras = _core.options("sf_threemf_extras")
    if thumbnail is not None:
        extras.thumbnail, extras.thumbnail_size = kept.keep(ffi.from_buffer(thumbnail)), len(thumbnail)
    fault = _core.new_fault()
    layers = _Layers(filling) if filling is not None else None
    with _files.sink(to) as sink, running(progress, 1) as task:
        if filling is None or layers is None:
            ok(lib.sf_threemf_write(view, extras, sink, ffi.NULL, task, fault), fault)
            return
        with _lattice(filling.lattice) as lattice:
            extras.volume = _c_volume(filling, lattice, layers, kept)
            status = lib.sf_threemf_write(view, extras, sink, ffi.NULL, task, fault)
        if layers.error is not None:
            raise layers.error
        ok(status, fault)


@documented("sf_threemf_is_served")
def threemf_is_served() -> bool:
    """Whether this build reads and writes 3MF."""
    return bool(lib.sf_threemf_is_served())
