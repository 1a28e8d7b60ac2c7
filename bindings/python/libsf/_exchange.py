"""Exchange files by h5py, for builds of the library that have no HDF5: the same layout."""

from __future__ import annotations

import io
import uuid
from typing import Any

import numpy as np

from . import _files, errors
from ._types import Property
from .refining import Channel, Tets

SI = ("m", "kg", "s", "A", "K", "mol", "cd")
# As the library writes units: mass first.
ORDER = ("kg", "m", "s", "A", "K", "mol", "cd")


def _unit(si: Any) -> str:
    exponents = dict(zip(SI, si))
    words = [name if exponents[name] == 1 else f"{name}^{exponents[name]}" for name in ORDER if exponents[name]]
    return " ".join(words) or "1"


def _h5py() -> Any:
    try:
        import h5py
    except ImportError:
        raise errors.UnsupportedError("this build has no HDF5: install h5py") from None
    return h5py


def save(tets: Tets, to: _files.Writable) -> None:
    """Write tetrahedra; whole or not at all."""
    memory = io.BytesIO()
    with _h5py().File(memory, "w") as file:
        file.attrs["format"], file.attrs["length_unit"] = np.bytes_("libsf-exchange"), np.bytes_("mm")
        file.attrs["version"] = np.uint32(1)
        packed = {"compression": "gzip", "shuffle": True}
        file.create_dataset("positions", data=tets.points, **packed)
        file.create_dataset("tets", data=tets.corners, **packed)
        folder = file.create_group("properties")
        for channel in tets.channels().values():
            kind = channel.property
            group = folder.create_group(str(uuid.UUID(bytes=bytes(kind.uuid))))
            group.attrs["name"], group.attrs["unit"] = np.bytes_(kind.name.encode()), np.bytes_(_unit(kind.si))
            group.attrs["si_exponents"] = np.array(kind.si, np.int8)
            group.attrs["low"], group.attrs["high"] = kind.low, kind.high
            group.create_dataset("values", data=channel.values, **packed)
            index = tets.corners if channel.indices is None else channel.indices
            group.create_dataset("index", data=index, **packed)
    if _files.is_path(to):
        _files.replace(to, memory.getvalue())  # type: ignore[arg-type]
    else:
        _files.put(to, memory.getvalue())


def _text(value: Any) -> str:
    return value.decode() if isinstance(value, bytes) else str(value)


def load(of: _files.Readable) -> Tets:
    """Read tetrahedra."""
    h5py = _h5py()
    if isinstance(of, (bytes, bytearray, memoryview)):
        of = io.BytesIO(bytes(of))
    try:
        with h5py.File(of, "r") as file:
            if _text(file.attrs.get("format", b"")) != "libsf-exchange":
                raise errors.FormatError("this is no exchange file: it lacks the attribute format = libsf-exchange")
            if int(file.attrs["version"]) != 1:
                raise errors.UnsupportedError(f"version {file.attrs['version']} of exchange files is not known")
            points = np.ascontiguousarray(_table(file, "positions"), np.float64)
            corners = np.ascontiguousarray(_table(file, "tets"), np.uint32)
            channels = []
            for name in file["properties"]:
                group = file["properties"][name]
                kind = Property(_text(group.attrs["name"]), tuple(uuid.UUID(name).bytes),
                                tuple(int(x) for x in group.attrs["si_exponents"]), float(group.attrs["low"]),
                                float(group.attrs["high"]))
                channels.append(Channel(kind, np.ascontiguousarray(_table(group, "values"), np.float64),
                                        np.ascontiguousarray(_table(group, "index"), np.uint32)))
    except (KeyError, ValueError, OSError, TypeError) as error:
        if isinstance(error, errors.Error):
            raise
        if isinstance(error, FileNotFoundError):
            raise errors.FileError(str(error)) from None
        raise errors.FormatError(f"this is no exchange file: {error}") from None
    return Tets(points, corners, channels)


def _table(group: Any, name: str) -> Any:
    found = group.get(name, getlink=True)
    if type(found).__name__ != "HardLink" or group[name].is_virtual or group[name].external:
        raise errors.FormatError(f"{name} is no table of this file")
    return group[name][:]
