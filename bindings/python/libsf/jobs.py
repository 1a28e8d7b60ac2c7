"""Jobs of resin printers: layers as they are exposed, read one at a time, changed and written.

    with libsf.Job("part.sl1") as job:
        checker = libsf.Checker(job.lattice.nx, job.lattice.ny, pitch_mm=job.lattice.pitch_mm)
        for layer in job:
            checker.push(layer)
"""

from __future__ import annotations

import operator
from typing import Any, Iterator

import numpy as np
import numpy.typing as npt

from . import _core, _files, _types
from ._core import Progress, documented, ffi, lib, ok, running
from ._types import JobFormat
from .layers import Layer
from .voxel import Grid, Lattice, grid_of, lattice_of


class Job(_core.InTurn):
    """A job: .sl1 or .photon, a path or bytes. `threshold` is the least grey, of 255, that is solid."""

    @documented("sf_job_open", "sf_file_bytes", "sf_memory_bytes")
    def __init__(self, file: _files.Path | bytes, *, threshold: int = 128,
                 pitch_mm: float | tuple[float, float] | None = None,
                 bytes_max: int | None = None, layers_max: int | None = None) -> None:
        self._c, self._file = ffi.NULL, ffi.NULL
        options = _core.options("sf_job_options", threshold=threshold, bytes_max=bytes_max,
                                layers_max=layers_max)
        if pitch_mm is not None:
            options.pitch_mm = _core.for_each(pitch_mm, 2)
        made, fault = ffi.new("sf_job **"), _core.new_fault()
        try:
            with _files.named(file):
                ok(lib.sf_job_open(self._bytes(file), options, ffi.NULL, made, fault), fault)
        except BaseException:
            self.close()
            raise
        self._c = made[0]
        self._lattice = lattice_of(lib.sf_job_lattice(self._c))

    def _bytes(self, file: Any) -> Any:
        fault = _core.new_fault()
        if _files.is_path(file):
            opened, bytes_of = ffi.new("sf_file **"), ffi.new("sf_bytes *")
            ok(lib.sf_file_open(_files.c_path(file), ffi.NULL, opened, fault), fault)
            self._file = opened[0]
            ok(lib.sf_file_bytes(self._file, bytes_of, fault), fault)
            return bytes_of[0]
        if not isinstance(file, (bytes, bytearray, memoryview)):
            raise TypeError("give a path or bytes")
        self._memory = bytes(file)  # these themselves; of what may change a copy
        self._cursor = ffi.new("sf_memory_cursor *")
        self._cursor.data = ffi.from_buffer(self._memory)
        self._cursor.size = len(self._memory)
        return lib.sf_memory_bytes(self._cursor)

    @documented("sf_job_close")
    @_core.in_turn
    def close(self) -> None:
        """Close the file; the job is of no more use."""
        lib.sf_job_close(self._c)
        lib.sf_file_close(self._file)
        self._c = self._file = ffi.NULL

    def __enter__(self) -> Job:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __del__(self) -> None:
        if getattr(self, "_c", None) is not None:
            self.close()

    @property
    @documented("sf_job_lattice")
    def lattice(self) -> Lattice:
        """Its pixels, its layers and their heights."""
        return self._lattice

    @property
    @documented("sf_job_describe")
    @_core.in_turn
    def info(self) -> _types.JobInfo:
        """What it says of itself."""
        found = ffi.new("sf_job_info *")
        ok(lib.sf_job_describe(self._c, found))
        return _core.value(found)  # type: ignore[no-any-return]

    def __len__(self) -> int:
        return self._lattice.nz

    def _layer(self, layer: int) -> int:
        k = operator.index(layer) + (len(self) if layer < 0 else 0)
        if not 0 <= k < len(self):
            raise IndexError(f"layer {layer} of {len(self)}")
        return k

    @documented("sf_job_read")
    @_core.in_turn
    def __getitem__(self, layer: int) -> Layer:
        """A layer as it is exposed."""
        made, fault = Layer(self._lattice.nx, self._lattice.ny), _core.new_fault()
        ok(lib.sf_job_read(self._c, self._layer(layer), made._c, fault), fault)
        return made

    def __iter__(self) -> Iterator[Layer]:
        return (self[k] for k in range(len(self)))

    @documented("sf_job_read_grey")
    @_core.in_turn
    def greys(self, layer: int) -> npt.NDArray[np.uint8]:
        """The greys of a layer, (y, x), row 0 the lowest."""
        made, fault = np.empty((self._lattice.ny, self._lattice.nx), np.uint8), _core.new_fault()
        ok(lib.sf_job_read_grey(self._c, self._layer(layer), _core.pointer("uint8_t", made),
                                self._lattice.nx, fault), fault)
        return made

    @_core.in_turn
    def grid(self) -> Grid:
        """All layers in one grid."""
        made, fault = Grid(self._lattice), _core.new_fault()
        for k in range(len(self)):
            ok(lib.sf_job_read(self._c, k, Layer.of(made, k)._c, fault), fault)
        return made

    @documented("sf_job_rewrite")
    @_core.in_turn
    def rewrite(self, grid: Grid, file: _files.Writable, *, progress: Progress = None) -> int:
        """Write the job with the layers of a grid, and all else byte for byte; how many differ."""
        changed, fault = ffi.new("uint32_t *"), _core.new_fault()
        with _files.sink(file) as to, running(progress, 1) as task:
            ok(lib.sf_job_rewrite(self._c, grid._c, to, task, changed, fault), fault)
        return int(changed[0])

    def __repr__(self) -> str:
        return f"<libsf.Job of {len(self)} layers>"


@documented("sf_sl1_write")
def save_sl1(grid: Grid, file: _files.Writable, *, name: str | None = None,
             exposure_s: float | None = None, first_exposure_s: float | None = None,
             fade_layers: int | None = None, progress: Progress = None) -> None:
    """Write a grid as a new SL1 job."""
    called = ffi.new("char[]", _core.text(name, "name")) if name is not None else None
    settings = _core.options("sf_sl1_settings", exposure_s=exposure_s,
                             first_exposure_s=first_exposure_s, fade_layers=fade_layers)
    if called is not None:
        settings.name = called
    fault = _core.new_fault()
    with _files.sink(file) as to, running(progress, 1) as task:
        ok(lib.sf_sl1_write(grid_of(grid)._c, settings, ffi.NULL, to, task, fault), fault)


@documented("sf_job_has_sl1")
def jobs_have_sl1() -> bool:
    """Whether SL1 is read and written."""
    return bool(lib.sf_job_has_sl1())


__all__ = ["Job", "JobFormat", "jobs_have_sl1", "save_sl1"]
