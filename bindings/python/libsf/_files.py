"""Where bytes come from and go to: paths, bytes, and file objects of Python's.

A file that is written by its path shows when it is whole, or not at all.
"""

from __future__ import annotations

import io
import os
from contextlib import contextmanager
from typing import IO, Any, Iterator, Union

from . import _core, errors
from ._core import ffi, lib, ok
from ._types import Status

Path = Union[str, "os.PathLike[str]"]
Readable = Union[Path, bytes, bytearray, memoryview, IO[bytes]]
Writable = Union[Path, IO[bytes]]


def is_path(what: Any) -> bool:
    return isinstance(what, (str, os.PathLike))


def c_path(path: Path) -> bytes:
    """A path as the library takes it."""
    return _core.no_zero(os.fsencode(path), "path")


class _Stream:
    """A file object that the library reads or writes, and what it raised meanwhile."""

    def __init__(self, file: Any) -> None:
        self.file = file
        self.error: BaseException | None = None
        self.handle = ffi.new_handle(self)


@ffi.def_extern(error=int(Status.ERR_IO))  # type: ignore[misc, unused-ignore, untyped-decorator]
def sf_py_read(user: Any, to: Any, size: int, got: Any) -> int:
    stream: _Stream = ffi.from_handle(user)
    try:
        found = stream.file.read(size)
        if len(found) > size:
            raise ValueError("a file gave more bytes than were asked for")
        ffi.memmove(to, found, len(found))
        got[0] = len(found)
        return 0
    except BaseException as error:
        stream.error = error
        return int(Status.ERR_IO)


@ffi.def_extern(error=int(Status.ERR_IO))  # type: ignore[misc, unused-ignore, untyped-decorator]
def sf_py_write(user: Any, data: Any, size: int) -> int:
    stream: _Stream = ffi.from_handle(user)
    try:
        put(stream.file, bytes(ffi.buffer(ffi.cast("const char *", data), size)))
        return 0
    except BaseException as error:
        stream.error = error
        return int(Status.ERR_IO)


def put(file: Any, data: bytes) -> None:
    """Write all of it: a raw file takes as much as it likes, and says how much that was."""
    while data:
        taken = file.write(data)
        if taken is None and isinstance(file, io.RawIOBase):
            raise BlockingIOError("the file takes nothing at the moment, and must not be waited for")
        if not isinstance(taken, int):
            return
        if not 0 < taken <= len(data):
            raise OSError(f"the file took {taken} bytes of {len(data)}")
        data = data[taken:]


@contextmanager
def _told(stream: _Stream) -> Iterator[None]:
    """Raise what a file object raised, not the status that came of it."""
    try:
        yield
    except errors.FileError:
        if stream.error is None:
            raise
    if stream.error is not None:
        raise stream.error


@contextmanager
def named(path: Any) -> Iterator[None]:
    """Put a file's name, and the place in it, before what is said of what it holds."""
    try:
        yield
    except errors.Error as error:
        said = str(error)
        if is_path(path) and os.fsdecode(path) not in said and not isinstance(error, errors.CancelledError):
            place = f", line {error.line}" if error.line else f", byte {error.offset}" if error.offset else ""
            error.args = (f"{os.fsdecode(path)}{place}: {said}",)
        raise


@contextmanager
def source(of: Readable) -> Iterator[Any]:
    """A source of bytes for a call."""
    if is_path(of):
        fault, file = _core.new_fault(), ffi.new("sf_file **")
        ok(lib.sf_file_open(c_path(of), ffi.NULL, file, fault), fault)  # type: ignore[arg-type]
        try:
            with named(of):
                yield lib.sf_file_source(file[0])
        finally:
            lib.sf_file_close(file[0])
    elif isinstance(of, (bytes, bytearray, memoryview)):
        held, cursor = ffi.from_buffer(of), ffi.new("sf_memory_cursor *")
        cursor.data, cursor.size = held, len(held)
        yield lib.sf_memory_source(cursor)
    elif hasattr(of, "read"):
        stream, made = _Stream(of), ffi.new("sf_source *")
        made.user, made.read = stream.handle, lib.sf_py_read
        with _told(stream):
            yield made[0]
    else:
        raise TypeError("give a path, bytes, or a file that is open for reading bytes")


@contextmanager
def sink(to: Writable) -> Iterator[Any]:
    """A sink of bytes for a call: what is written to a path appears when all went well."""
    if is_path(to):
        fault, save = _core.new_fault(), ffi.new("sf_save **")
        ok(lib.sf_save_begin(c_path(to), ffi.NULL, save, fault), fault)  # type: ignore[arg-type]
        try:
            yield lib.sf_save_sink(save[0])
        except BaseException:
            lib.sf_save_abort(save[0])
            raise
        ok(lib.sf_save_commit(save[0], fault), fault)
    elif hasattr(to, "write"):
        stream, made = _Stream(to), ffi.new("sf_sink *")
        made.user, made.write = stream.handle, lib.sf_py_write
        with _told(stream):
            yield made[0]
    else:
        raise TypeError("give a path, or a file that is open for writing bytes")


@contextmanager
def folder_to_read(path: Path) -> Iterator[Any]:
    """A folder whose files a call reads."""
    fault, made = _core.new_fault(), ffi.new("sf_directory **")
    ok(lib.sf_directory_read(c_path(path), ffi.NULL, made, fault), fault)
    try:
        yield lib.sf_directory_folder(made[0])
    finally:
        lib.sf_directory_close(made[0])


@contextmanager
def folder_to_write(path: Path) -> Iterator[Any]:
    """A folder that a call fills; it shows when all went well."""
    fault, made = _core.new_fault(), ffi.new("sf_directory **")
    ok(lib.sf_directory_write(c_path(path), ffi.NULL, made, fault), fault)
    try:
        yield lib.sf_directory_folder(made[0])
    except BaseException:
        lib.sf_directory_close(made[0])
        raise
    ok(lib.sf_directory_commit(made[0], fault), fault)


def replace(path: Path, data: bytes) -> None:
    """Write a file of bytes: whole, or not at all."""
    with sink(path) as to:
        held = ffi.from_buffer(data)
        ok(to.write(to.user, held, len(data)))
