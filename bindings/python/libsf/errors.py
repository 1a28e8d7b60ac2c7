"""What may go wrong: one class for each status of the library."""

from __future__ import annotations

from ._types import Status


class Error(Exception):
    """A call that failed; it has changed nothing.

    `status` says which way it failed; `line` and `offset` where in a file, 0 where that means
    nothing.
    """

    status: Status = Status.ERR_INTERNAL

    def __init__(self, message: str, line: int = 0, offset: int = 0) -> None:
        super().__init__(message)
        self.line = line
        self.offset = offset


class ArgumentError(Error, ValueError):
    """Something handed in is out of range, or makes no sense with the rest."""

    status = Status.ERR_ARGUMENT


class ShapeError(Error, ValueError):
    """Sizes that do not belong together."""

    status = Status.ERR_SHAPE


class CapacityError(Error):
    """There are too few places for a result."""

    status = Status.ERR_CAPACITY


class TooLargeError(Error, OverflowError):
    """More than the library, the machine or a limit allows."""

    status = Status.ERR_OVERFLOW


class OutOfMemoryError(Error, MemoryError):
    """There is no memory."""

    status = Status.ERR_MEMORY


class FileError(Error, OSError):
    """A file cannot be read or written."""

    status = Status.ERR_IO


class FormatError(Error, ValueError):
    """A file is not what it should be."""

    status = Status.ERR_FORMAT


class UnsupportedError(Error, NotImplementedError):
    """Something that is well formed and not served."""

    status = Status.ERR_UNSUPPORTED


class CancelledError(Error):
    """Somebody asked for it to stop."""

    status = Status.ERR_CANCELLED


class InternalError(Error):
    """A fault of the library itself; please report it."""

    status = Status.ERR_INTERNAL


class InfeasibleError(Error):
    """What is asked for cannot be had."""

    status = Status.ERR_INFEASIBLE


BY_STATUS: dict[int, type[Error]] = {
    int(c.status): c
    for c in (
        ArgumentError,
        ShapeError,
        CapacityError,
        TooLargeError,
        OutOfMemoryError,
        FileError,
        FormatError,
        UnsupportedError,
        CancelledError,
        InternalError,
        InfeasibleError,
    )
}
