"""Meshes: triangles in and out as numpy arrays, voxels of them, and surfaces of voxels."""

from __future__ import annotations

from typing import Any, Iterator

import numpy as np
import numpy.typing as npt

from . import _core, _files, _types
from ._core import Progress, documented, ffi, lib, ok, running
from ._types import Fill, MeshFormat, RuleKind
from .errors import ArgumentError
from .layers import Layer
from .voxel import Grid, Lattice, _lattice, grid_of, lattice_needed


class Mesh:
    """Triangles: vertices in mm, (n, 3) float64, and faces, (m, 3) uint32.

    Takes trimesh's and meshio's objects as they are, and anything that has `vertices` and `faces`,
    or `points` and `cells_dict["triangle"]`.
    """

    _c: Any

    @documented("sf_mesh_add_vertices", "sf_mesh_add_triangles")
    def __init__(self, vertices: Any, faces: Any = None) -> None:
        if faces is None:
            vertices, faces = _parts_of(vertices)
        vertices = _core.array_in(_plain(vertices, np.float64), np.float64, (None, 3), "vertices")
        faces = _core.array_in(_plain(faces, np.uint32), np.uint32, (None, 3), "faces")
        made = ffi.new("sf_mesh **")
        ok(lib.sf_mesh_create(ffi.NULL, made))
        self._take(made[0])
        ok(lib.sf_mesh_add_vertices(self._c, _core.pointer("double", vertices), len(vertices)))
        beyond = np.argwhere(faces >= len(vertices))
        if len(beyond) > 0:
            i, j = beyond[0]
            raise ArgumentError(f"faces[{i}]: there is no vertex {faces[i, j]}; vertices has {len(vertices)}")
        ok(lib.sf_mesh_add_triangles(self._c, _core.pointer("uint32_t", faces), len(faces)))
        fault = _core.new_fault()
        ok(lib.sf_mesh_validate(self._view, fault), fault)

    def _take(self, c: Any) -> None:
        self._c = ffi.gc(c, lib.sf_mesh_destroy)

    @classmethod
    def _of(cls, c: Any) -> Mesh:
        """A mesh of the library's, which it becomes the owner of."""
        mesh = cls.__new__(cls)
        mesh._take(c)
        return mesh

    @classmethod
    def _copied(cls, view: Any) -> Mesh:
        """A copy of what a view shows."""
        vertices = _core.memory(view.vertices, "float64", (view.vertex_count, 3), None)
        faces = _core.memory(view.triangles, "uint32", (view.triangle_count, 3), None)
        return cls(vertices, faces)

    @property
    def _view(self) -> Any:
        return lib.sf_mesh_get_view(self._c)

    @property
    def vertices(self) -> npt.NDArray[np.float64]:
        """(n, 3), mm; the mesh's own memory, to be read."""
        v = self._view
        return _core.memory(v.vertices, "float64", (v.vertex_count, 3), self._c)

    @property
    def faces(self) -> npt.NDArray[np.uint32]:
        """(m, 3), counter-clockwise seen from outside; the mesh's own memory, to be read."""
        v = self._view
        return _core.memory(v.triangles, "uint32", (v.triangle_count, 3), self._c)

    @documented("sf_mesh_bounds")
    def bounds(self) -> npt.NDArray[np.float64]:
        """The box around it: (2, 3), mm."""
        low, high = ffi.new("double[3]"), ffi.new("double[3]")
        ok(lib.sf_mesh_bounds(self._view, low, high))
        return np.array([list(low), list(high)])

    @documented("sf_mesh_measure")
    def measure(self) -> _types.Mass:
        """Volume, area, centre of mass and inertia."""
        found = ffi.new("sf_mass *")
        ok(lib.sf_mesh_measure(self._view, found))
        return _core.value(found)  # type: ignore[no-any-return]

    @documented("sf_mesh_analyze")
    def topology(self) -> _types.Topology:
        """Whether it is closed, and the rest of how it hangs together."""
        found = ffi.new("sf_topology *")
        ok(lib.sf_mesh_analyze(self._view, ffi.NULL, found))
        return _core.value(found)  # type: ignore[no-any-return]

    @documented("sf_mesh_transform")
    def transformed(self, matrix: Any) -> Mesh:
        """A copy that a 3 x 3, 3 x 4 or 4 x 4 matrix has moved."""
        m: Any = np.asarray(matrix, np.float64)
        if m.shape not in ((3, 3), (3, 4), (4, 4)):
            raise ValueError(f"matrix: its shape is {m.shape}, and (3, 3), (3, 4) or (4, 4) is needed")
        if m.shape == (4, 4) and not np.allclose(m[3], (0, 0, 0, 1)):
            raise ValueError("matrix: its last row is not 0, 0, 0, 1")
        copy = Mesh(np.array(self.vertices), np.array(self.faces))
        c = ffi.new("sf_transform *")
        c.matrix = [float(x) for x in m[:3, :3].reshape(-1)]
        c.shift_mm = [float(x) for x in (m[:3, 3] if m.shape[1] == 4 else (0, 0, 0))]
        ok(lib.sf_mesh_transform(copy._c, c))
        return copy

    @documented("sf_mesh_read")
    @classmethod
    def load(cls, of: _files.Readable, *, format: MeshFormat | str | None = None,
             bytes_max: int | None = None, triangles_max: int | None = None,
             vertices_max: int | None = None) -> Mesh:
        """Read STL, OBJ, PLY, OFF or, in a build with them, 3MF and glTF: a path, bytes, or a file that is open."""
        limits = _core.options("sf_read_limits", bytes_max=bytes_max, triangles_max=triangles_max,
                               vertices_max=vertices_max)
        fault, made = _core.new_fault(), ffi.new("sf_mesh **")
        kind = _format_of(of, format)
        with _files.source(of) as source:
            ok(lib.sf_mesh_read(source, int(kind), limits, ffi.NULL, made, fault), fault)
        return cls._of(made[0])

    @documented("sf_mesh_write")
    def save(self, to: _files.Writable, format: MeshFormat | str | None = None, *,
             colors: npt.ArrayLike | None = None) -> None:
        """Write STL, OBJ, PLY, 3MF or GLB: by the ending of a path, or in a format that is named.

        colors, for GLB only: red, green and blue of each vertex, 0 to 255, as a screen shows them.
        """
        kind = _format_of(to, format)
        if kind in (MeshFormat.AUTO, MeshFormat.OFF):
            raise ValueError(f"{to}: give a name that ends in .stl, .obj, .ply, .3mf or .glb, or a format")
        if colors is not None:
            self._save_colored(to, kind, np.asarray(colors))
            return
        with _files.sink(to) as sink:
            ok(lib.sf_mesh_write(self._view, int(kind), sink))

    @documented("sf_gltf_write")
    def _save_colored(self, to: _files.Writable, kind: MeshFormat, colors: Any) -> None:
        """Write GLB with a colour for each vertex."""
        shape = (self._view.vertex_count, 3)
        if kind != MeshFormat.GLTF:
            raise ValueError("colors: only GLB has them; give a name that ends in .glb")
        if colors.dtype != np.uint8:
            raise TypeError(f"colors: they are {colors.dtype}, and uint8 is needed")
        if colors.shape != shape:
            raise ValueError(f"colors: their shape is {colors.shape}, and {shape} is needed")
        colors = np.ascontiguousarray(colors)
        with _files.sink(to) as sink:
            ok(lib.sf_gltf_write(self._view, ffi.from_buffer("uint8_t[]", colors), sink))

    @documented("sf_mesh_merge")
    def merged(self) -> Mesh:
        """A copy in which vertices of equal position are one."""
        made = ffi.new("sf_mesh **")
        ok(lib.sf_mesh_merge(self._view, ffi.NULL, made))
        return Mesh._of(made[0])

    @documented("sf_mesh_cut")
    def cut(self, axis: int, at_mm: float) -> tuple[Mesh, Mesh]:
        """Two closed halves, the lower one first, on both sides of a plane across an axis."""
        low, high, fault = ffi.new("sf_mesh **"), ffi.new("sf_mesh **"), _core.new_fault()
        ok(lib.sf_mesh_cut(self._view, axis, at_mm, ffi.NULL, low, high, fault), fault)
        return Mesh._of(low[0]), Mesh._of(high[0])

    def to_trimesh(self) -> Any:
        """The same as a trimesh.Trimesh."""
        import trimesh

        return trimesh.Trimesh(np.array(self.vertices), np.array(self.faces, np.int64), process=False)

    def to_meshio(self) -> Any:
        """The same as a meshio.Mesh."""
        import meshio

        return meshio.Mesh(np.array(self.vertices), [("triangle", np.array(self.faces))])

    def __repr__(self) -> str:
        v = self._view
        return f"<libsf.Mesh {v.vertex_count} vertices, {v.triangle_count} faces>"


def _format_of(file: Any, format: MeshFormat | str | None) -> MeshFormat:
    """The format that is named, or that a path's ending names."""
    if format is not None:
        if isinstance(format, str):
            name = {"3MF": "THREEMF", "GLB": "GLTF"}.get(format.upper(), format.upper())
            if name not in MeshFormat.__members__:
                raise ValueError(f"format: there is no {format!r}; there are stl, obj, ply, off, 3mf and glb")
            return MeshFormat[name]
        return format
    return MeshFormat(lib.sf_mesh_format_from_name(_files.c_path(file) if _files.is_path(file) else b""))


def _plain(array: Any, dtype: npt.DTypeLike) -> Any:
    """Subclasses of arrays, as trimesh has them, and faces of other integers, which must fit."""
    if isinstance(array, np.ndarray):
        array = np.asarray(array)
        if array.dtype.kind in "iu" and np.dtype(dtype).kind == "u" and array.dtype != dtype:
            if array.size > 0 and (array.min() < 0 or array.max() > np.iinfo(np.uint32).max):
                raise ValueError("faces: a number is below 0 or beyond 32 bits")
            return np.ascontiguousarray(array, dtype)
    return array


def _parts_of(other: Any) -> tuple[Any, Any]:
    if hasattr(other, "vertices") and hasattr(other, "faces"):
        return other.vertices, other.faces
    if hasattr(other, "points") and hasattr(other, "cells_dict"):
        return other.points, other.cells_dict["triangle"]
    if _files.is_path(other):
        raise TypeError(f"{other!r} is a name; libsf.Mesh.load({other!r}) reads the file")
    raise TypeError("give vertices and faces, or an object that has them, as trimesh's and meshio's do")


def as_mesh(mesh: Any) -> Mesh:
    """What was handed in as a mesh of ours."""
    return mesh if isinstance(mesh, Mesh) else Mesh(mesh)


@documented("sf_grid_voxelize")
def voxelize(mesh: Any, lattice: Lattice | None = None, *, pitch_mm: float | None = None,
             layer_mm: float | None = None, fill: Fill | None = None, progress: Progress = None,
             threads: int | None = 1) -> Grid:
    """The voxels whose centres lie in a mesh: on a lattice, or on one of a pitch around it."""
    mesh = as_mesh(mesh)
    if lattice is not None:
        lattice_needed(lattice)
    else:
        if pitch_mm is None:
            raise TypeError("give the size of a voxel, pitch_mm=0.2 say, or a lattice")
        low, high = mesh.bounds()
        lattice = Lattice.around(low, high, pitch_mm, layer_mm)
    grid = Grid(lattice)
    options = _core.options("sf_voxelize_options", fill=fill)
    with running(progress, threads) as task:
        ok(lib.sf_grid_voxelize(grid._c, mesh._view, options, ffi.NULL, task, ffi.NULL))
    return grid


class Voxelizer(_core.InTurn):
    """The slices of a mesh on a lattice, any one by its number; for shapes that no memory holds."""

    @documented("sf_voxelizer_create")
    def __init__(self, mesh: Any, lattice: Lattice, *, fill: Fill | None = None) -> None:
        self._mesh, fault = as_mesh(mesh), _core.new_fault()
        made, options = ffi.new("sf_voxelizer **"), _core.options("sf_voxelize_options", fill=fill)
        with _lattice(lattice) as c:
            ok(lib.sf_voxelizer_create(self._mesh._view, c, options, ffi.NULL, made, fault), fault)
        self._c, self._lattice = ffi.gc(made[0], lib.sf_voxelizer_destroy), lattice

    def __len__(self) -> int:
        return self._lattice.nz

    @documented("sf_voxelizer_slice")
    @_core.in_turn
    def __getitem__(self, k: int) -> Layer:
        """Slice k; a new one each time."""
        if not -len(self) <= k < len(self):
            raise IndexError(f"slice {k} of {len(self)}")
        layer = Layer(self._lattice.nx, self._lattice.ny)
        ok(lib.sf_voxelizer_slice(self._c, k % len(self), layer._c))
        return layer

    def __iter__(self) -> Iterator[Layer]:
        return (self[k] for k in range(len(self)))

    @documented("sf_voxelizer_report")
    @_core.in_turn
    def report(self) -> _types.VoxelizeReport:
        """What was found so far, over all slices that were asked for."""
        found = ffi.new("sf_voxelize_report *")
        ok(lib.sf_voxelizer_report(self._c, found))
        return _core.value(found)  # type: ignore[no-any-return]


@documented("sf_grid_surface")
def surface(grid: Grid, *, smooth_passes: int = 0, progress: Progress = None) -> Mesh:
    """The boundary of the solid voxels, closed, as it is or smoothed."""
    made = ffi.new("sf_mesh **")
    options = _core.options("sf_surface_options", smooth_passes=smooth_passes)
    with running(progress) as task:
        ok(lib.sf_grid_surface(grid_of(grid)._c, options, ffi.NULL, task, made))
    return Mesh._of(made[0])


@documented("sf_mesh_orient")
def orient(mesh: Any, *, rule: RuleKind | None = None, angle_rad: float | None = None,
           resolution: int | None = None, fine_count: int | None = None, progress: Progress = None,
           threads: int | None = 1) -> list[_types.Orientation]:
    """The ways up in which a part prints best, the best one first; `turn` of each brings it there."""
    mesh = as_mesh(mesh)
    options = _core.options("sf_orient_options", rule=None if rule is None else int(rule),
                            angle_rad=angle_rad, resolution=resolution, fine_count=fine_count)
    room = options.fine_count + 1
    found, count = ffi.new("sf_orientation[]", room), ffi.new("size_t *")
    with running(progress, threads) as task:
        ok(lib.sf_mesh_orient(mesh._view, options, ffi.NULL, task, found, room, count, ffi.NULL))
    return [_core.value(found[i]) for i in range(count[0])]


__all__ = ["Fill", "Mesh", "MeshFormat", "Voxelizer", "orient", "surface", "voxelize"]
