"""Calls into the library: arrays in and out without copies, statuses as exceptions, tasks.

Every call releases the interpreter's lock while the library works. A long one has a task: it
reports progress, and each report is where Ctrl-C, or an exception of the caller's own `progress`,
stops it. Threads are the caller's: `threads=4` lends the library that many, its own among them.
"""

from __future__ import annotations

import enum
import functools
import itertools
import math
import os
import threading
from contextlib import contextmanager
from numbers import Real
from typing import Any, Callable, Iterator, Sequence, TypeVar, Union, cast, overload

import numpy as np
import numpy.typing as npt

from . import _docs, _types, errors
from ._sf import ffi as ffi
from ._sf import lib as lib

Progress = Union[None, bool, Callable[[float], Any], Any]
C = TypeVar("C", bound=Callable[..., Any])
T = TypeVar("T")
E = TypeVar("E", bound=enum.Enum)


def documented(*names: str) -> Callable[[C], C]:
    """Put the words of the headers behind a docstring."""

    def put(function: C) -> C:
        own = (function.__doc__ or "").rstrip()
        said = "\n\n".join(f"{name}(): {_docs.DOCS[name]}" for name in names)
        function.__doc__ = f"{own}\n\n{said}" if own else said
        return function

    return put


# --- Statuses -----------------------------------------------------------------------------------


def ok(status: int, fault: Any = None, said: str = "") -> None:
    """Raise what a status stands for, in the words of the fault, in those that are said, or its own."""
    if status == 0:
        return
    message, line, offset = said, 0, 0
    if fault is not None and fault.status != 0:
        message = ffi.string(fault.message).decode("utf-8", "replace")
        line, offset = fault.line, fault.offset
    if not message:
        message = ffi.string(lib.sf_status_message(status)).decode()
    raise errors.BY_STATUS.get(status, errors.InternalError)(message, line, offset)


def member(kinds: type[E], what: E | str, name: str) -> E:
    """One of an enum's values, or the one that is called so."""
    if not isinstance(what, str):
        return what
    found = kinds.__members__.get(what.replace("-", "_").upper())
    if found is None:
        raise ValueError(f"{name}: there is no {what!r}; there are {', '.join(k.lower() for k in kinds.__members__)}")
    return found


def new_fault() -> Any:
    return ffi.new("sf_fault *")


# --- Tasks --------------------------------------------------------------------------------------


def _to_call(progress: Progress) -> Callable[[float], Any] | None:
    """A function of a share from 0 to 1, of what the caller handed in."""
    if progress is None or progress is False:
        return None
    if progress is True:
        progress = _bar()
    if hasattr(progress, "update") and hasattr(progress, "n"):  # a bar like tqdm's
        bar: Any = progress
        whole = bar.total if getattr(bar, "total", None) else 1.0
        return lambda share: bar.update(share * whole - bar.n)
    if not callable(progress):
        raise TypeError("progress: give a function of a number from 0 to 1, a bar like tqdm's, or True")
    return progress


def _bar() -> Any:
    try:
        from tqdm.auto import tqdm
    except ImportError:
        import sys

        return lambda share: print(f"\r{100 * share:3.0f} %", end="" if share < 1 else "\n",
                                   file=sys.stderr, flush=True)
    return tqdm(total=1.0, bar_format="{l_bar}{bar}| {elapsed}<{remaining}")


class Task:
    """A task of the library while a call runs."""

    def __init__(self, progress: Progress, threads: int) -> None:
        self._call = _to_call(progress)
        self._threads = threads
        self.error: BaseException | None = None
        self.handle = ffi.new_handle(self)
        self.c = ffi.new("sf_task *", lib.sf_task_default())
        self._ticker = ffi.new("sf_py_ticker *", [self.handle, 0])
        if self._call is None and threads == 1:
            self.c.user = self._ticker
            self.c.progress = ffi.addressof(lib, "sf_py_tick")
        else:
            self.c.user = self.handle
            self.c.progress = lib.sf_py_progress
        if threads > 1:
            self.c.parallel_for = lib.sf_py_parallel

    def report(self, share: float) -> None:
        try:
            if self._call is not None and self.error is None:
                self._call(share)
        except BaseException as error:  # Ctrl-C, too
            self.fail(error)

    def fail(self, error: BaseException) -> None:
        if self.error is None:
            self.error = error
        lib.sf_task_cancel(self.c)

    def share_out(self, count: int, body: Any, context: Any) -> None:
        """Call body(context, i) once for each i, from several threads; the lock is free meanwhile.

        The library believes that all is done when this returns, and takes back what the pieces work
        on. So whatever is raised meanwhile, Ctrl-C too, is kept, and the pieces are ended before; and
        where there are no more threads to be had, this one does them.
        """
        begun = ffi.new("unsigned char[]", count)
        pieces = ffi.new("sf_py_pieces *", [body, context, begun, 0])
        numbers, through = itertools.count(), threading.Semaphore(0)

        def work(_kept: Any = begun) -> None:  # which a helper may look at when all has ended
            try:
                for i in numbers:
                    if i >= count:
                        return
                    lib.sf_py_piece(pieces, i)
            finally:
                through.release()

        helpers = min(self._threads, count) - 1
        while lib.sf_py_ended(pieces) < count:
            try:
                while helpers > 0:
                    helpers -= 1
                    _start(work)
                for i in numbers:
                    if i >= count:
                        break
                    lib.sf_py_piece(pieces, i)
                for i in range(count):  # what an exception has left out
                    lib.sf_py_piece(pieces, i)
                while lib.sf_py_ended(pieces) < count:
                    through.acquire(timeout=0.1)
            except BaseException as error:
                self.fail(error)


def _start(work: Callable[[], None]) -> None:
    """A thread that helps; none where the machine has no more, or the interpreter is on its way out."""
    try:
        threading.Thread(target=work, daemon=True).start()
    except (RuntimeError, MemoryError):
        pass


# The tasks of this thread's calls, the innermost last: where Ctrl-C falls between the lines of a
# callback, the call that is under way is the one that stops.
_under_way = threading.local()


def _interrupted(kind: Any, error: BaseException, trace: Any) -> None:
    for task in getattr(_under_way, "tasks", [])[-1:]:
        task.fail(error)


@ffi.def_extern(onerror=_interrupted)  # type: ignore[misc, unused-ignore, untyped-decorator]
def sf_py_progress(user: Any, share: float) -> None:
    task: Task = ffi.from_handle(user)
    task.report(share)


@ffi.def_extern(onerror=_interrupted)  # type: ignore[misc, unused-ignore, untyped-decorator]
def sf_py_parallel(user: Any, count: int, body: Any, context: Any) -> None:
    ffi.from_handle(user).share_out(count, body, context)


@contextmanager
def running(progress: Progress = None, threads: int | None = 1) -> Iterator[Any]:
    """A task for a call: `with running(progress, threads) as task: ok(lib.sf_...(..., task))`.

    What stopped the call is raised in the place of its status.
    """
    task = Task(progress, threads if threads is not None else (os.cpu_count() or 1))
    if not hasattr(_under_way, "tasks"):
        _under_way.tasks = []
    _under_way.tasks.append(task)
    try:
        yield task.c
    except errors.CancelledError:
        if task.error is None:
            raise
    finally:
        _under_way.tasks.pop()
    if task.error is not None:
        raise task.error


# --- Turns --------------------------------------------------------------------------------------


class InTurn:
    """An object of the library's that serves one call at a time.

    The interpreter's lock is free while the library works, so it keeps no two threads apart, nor a
    callback from the object that calls it. Here threads wait for each other, and a callback is refused.
    """

    _turn: threading.Lock
    _serves: int | None

    def __new__(cls: type[T], *_: Any, **__: Any) -> T:
        made: Any = object.__new__(cls)
        made._turn, made._serves = threading.Lock(), None
        return cast(T, made)


def in_turn(method: C) -> C:
    """A method of such an object during which no other one runs."""

    @functools.wraps(method)
    def call(self: Any, *given: Any, **named: Any) -> Any:
        me = threading.get_ident()
        if self._serves == me:
            raise RuntimeError(f"{method.__name__}: the object is in the middle of a call, which is to return first")
        with self._turn:
            self._serves = me
            try:
                return method(self, *given, **named)
            finally:
                self._serves = None

    return call  # type: ignore[return-value]


# --- Arrays -------------------------------------------------------------------------------------


def array_in(value: Any, dtype: npt.DTypeLike, shape: tuple[int | None, ...], name: str) -> npt.NDArray[Any]:
    """An array to be read: numpy's as they are, lists and tuples made into one.

    An array of another type or order is refused, not copied in silence.
    """
    if not isinstance(value, np.ndarray):
        try:
            value = np.ascontiguousarray(value, dtype=dtype)
        except (TypeError, ValueError) as error:
            raise TypeError(f"{name}: {error}") from None
    return _checked(value, dtype, shape, name)


def array_out(value: Any, dtype: npt.DTypeLike, shape: tuple[int | None, ...], name: str) -> npt.NDArray[Any]:
    """An array to be written."""
    if not isinstance(value, np.ndarray):
        raise TypeError(f"{name}: give a numpy array of {np.dtype(dtype)}")
    array = _checked(value, dtype, shape, name)
    if not array.flags.writeable:
        raise ValueError(f"{name}: the array is read-only")
    return array


def _checked(array: npt.NDArray[Any], dtype: npt.DTypeLike, shape: tuple[int | None, ...],
             name: str) -> npt.NDArray[Any]:
    wanted = np.dtype(dtype)
    if array.dtype != wanted:
        raise TypeError(f"{name}: the array is of {array.dtype}, and {wanted} is needed; "
                        f"numpy.ascontiguousarray({name}, dtype='{wanted}') makes a copy that is")
    if array.ndim != len(shape) or any(n is not None and n != m for n, m in zip(shape, array.shape)):
        asked = ", ".join("n" if n is None else str(n) for n in shape)
        raise ValueError(f"{name}: the array's shape is {array.shape}, and ({asked}) is needed")
    if not array.flags.c_contiguous:
        raise ValueError(f"{name}: the array is not in C order; numpy.ascontiguousarray({name}) "
                         "makes a copy that is")
    return array


def whole_numbers(value: Any, dtype: npt.DTypeLike, name: str) -> npt.NDArray[Any]:
    """Numbers of places, of any type of integers that fit; a copy where it is another type."""
    array = np.asarray(value)
    if array.size == 0:
        return np.zeros(array.shape, dtype)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name}: they are of {array.dtype}, and integers are needed")
    ends = np.iinfo(np.dtype(dtype))
    if array.dtype != ends.dtype and (array.min() < ends.min or array.max() > ends.max):
        raise ValueError(f"{name}: a number is not from {ends.min} to {ends.max}")
    return np.ascontiguousarray(array, dtype)


def text(words: str, name: str) -> bytes:
    """Text as the library takes it."""
    return no_zero(words.encode(), name)


def no_zero(said: bytes, name: str) -> bytes:
    """What C reads as it is; it would take a 0 for the end."""
    if b"\0" in said:
        raise ValueError(f"{name}: {said!r} holds a 0 character")
    return said


def pointer(kind: str, array: npt.NDArray[Any] | None) -> Any:
    """A C pointer to an array's own memory; the array must be kept meanwhile."""
    if array is None:
        return ffi.NULL
    if array.size == 0:
        return ffi.new(f"{kind}[1]")
    return ffi.from_buffer(f"{kind}[]", array)


def memory(address: Any, kind: str, shape: tuple[int, ...], owner: Any, writable: bool = False) -> npt.NDArray[Any]:
    """A numpy array over memory of the library, which keeps the owner of that memory alive."""
    dtype = np.dtype(kind)
    count = math.prod(shape)
    if count == 0 or address == ffi.NULL:
        return np.empty(shape, dtype)
    kept = ffi.gc(ffi.cast("char *", address), _Holder(owner))
    seen = memoryview(ffi.buffer(kept, count * dtype.itemsize))
    array: npt.NDArray[Any] = np.frombuffer(seen if writable else seen.toreadonly(), dtype).reshape(shape)
    return array


class _Holder:
    """Holds an object for as long as a pointer lives."""

    def __init__(self, owner: Any) -> None:
        self._owner = owner

    def __call__(self, address: Any) -> None:
        self._owner = None


def is_number(value: Any) -> bool:
    """Whether it is one number, Python's or numpy's, and no sequence."""
    return isinstance(value, Real)


def for_each(value: Any, count: int) -> list[float]:
    """A number for each of so many things: the one that was given, or those."""
    return [float(value)] * count if is_number(value) else [float(x) for x in value]


def numbers(values: Any, count: int, name: str) -> Any:
    """A C array of so many doubles."""
    return ffi.new("double[]", [float(x) for x in array_in(values, np.float64, (count,), name)])


# --- Structs ------------------------------------------------------------------------------------


def value(c: Any) -> Any:
    """A struct of the library as a frozen dataclass of numbers and enums."""
    kind = ffi.typeof(c)
    if kind.kind == "pointer":
        kind, c = kind.item, c[0]
    made, fields = _plan(kind)
    return made(*[convert(getattr(c, name)) if convert else getattr(c, name) for name, convert in fields])


@functools.lru_cache(maxsize=None)
def _plan(kind: Any) -> tuple[Any, list[tuple[str, Callable[[Any], Any] | None]]]:
    """The class of a struct, and what is to be done to each of its fields."""
    made = _types.STRUCTS[kind.cname.removeprefix("struct ")]
    return made, [(name, _converter(field.type)) for name, field in kind.fields]


def _converter(kind: Any) -> Callable[[Any], Any] | None:
    if kind.kind == "struct":
        return value
    if kind.kind == "enum":
        known = {int(x): x for x in _types.ENUMS[kind.cname]}
        return lambda found: known.get(found, found)
    if kind.kind == "array" and kind.item.cname == "char":
        return lambda found: ffi.string(found).decode("utf-8", "replace")
    if kind.kind == "array":
        inside = _converter(kind.item)
        return lambda found: tuple(inside(x) if inside else x for x in found)
    return None


class Values(Sequence[T]):
    """An array of the library's structs, each made a dataclass when it is asked for."""

    def __init__(self, c: Any, count: int, owner: Any = None) -> None:
        self._c, self._count, self._owner = c, count, owner

    def __len__(self) -> int:
        return self._count

    @overload
    def __getitem__(self, i: int) -> T: ...
    @overload
    def __getitem__(self, i: slice) -> list[T]: ...
    def __getitem__(self, i: int | slice) -> T | list[T]:
        if isinstance(i, slice):
            return [value(self._c[k]) for k in range(*i.indices(self._count))]
        k = i + self._count if i < 0 else i
        if not 0 <= k < self._count:
            raise IndexError(f"{i} of {self._count}")
        return value(self._c[k])  # type: ignore[no-any-return]

    def __repr__(self) -> str:
        return repr(list(self))


def options(name: str, **given: Any) -> Any:
    """An options struct at its default, with what is given; None leaves the default."""
    c = ffi.new(f"{name} *", getattr(lib, f"{name}_default")())
    fields = dict(ffi.typeof(name).fields)
    for key, x in given.items():
        if x is None:
            continue
        if key not in fields or key == "struct_size":
            known = ", ".join(sorted(set(fields) - {"struct_size"}))
            raise TypeError(f"there is no option {key!r}; there are {known}")
        setattr(c, key, x)
    return c
