"""From measurements to materials: curves of a fraction, and mixtures of several materials."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _core
from ._core import documented, ffi, lib, ok
from ._types import Trend

Floats = npt.NDArray[np.float64]


class Found(NamedTuple):
    """Where a curve has a value, and how far its value there is from the wanted one."""

    x: float
    miss: float


class Curve:
    """A monotone curve through measurements: a property over a fraction.

    `samples` is (n, 2): what was set and what was found; (n, 3) with a weight for each.
    """

    @documented("sf_curve_create")
    def __init__(self, samples: Any, trend: Trend = Trend.AUTO) -> None:
        rows = np.asarray(samples, np.float64)
        if rows.ndim != 2 or rows.shape[1] not in (2, 3):
            raise ValueError(f"samples: their shape is {rows.shape}, and (n, 2) or (n, 3) is needed")
        if rows.shape[1] == 2:
            rows = np.column_stack([rows, np.ones(len(rows))])
        rows = np.ascontiguousarray(rows)
        made = ffi.new("sf_curve **")
        c = ffi.cast("sf_curve_sample *", ffi.from_buffer(rows)) if len(rows) else ffi.NULL
        ok(lib.sf_curve_create(c, len(rows), int(trend), ffi.NULL, made))
        self._c = ffi.gc(made[0], lib.sf_curve_destroy)

    @documented("sf_curve_value")
    def __call__(self, x: float) -> float:
        """The property at a fraction."""
        return self.value_and_slope(x)[0]

    def value_and_slope(self, x: float) -> tuple[float, float]:
        """The property at a fraction, and its derivative."""
        y, slope = ffi.new("double *"), ffi.new("double *")
        ok(lib.sf_curve_value(self._c, x, y, slope))
        return y[0], slope[0]

    @documented("sf_curve_inverse")
    def inverse(self, y: float) -> Found:
        """The least fraction that has a property, or the end that is nearest to it."""
        x, miss = ffi.new("double *"), ffi.new("double *")
        ok(lib.sf_curve_inverse(self._c, y, x, miss))
        return Found(x[0], miss[0])

    @property
    @documented("sf_curve_change")
    def change(self) -> float:
        """How far it is from the sample that it had to leave the most."""
        return float(lib.sf_curve_change(self._c))


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

    @documented("sf_mixture_simplex")
    def simplices(self) -> npt.NDArray[np.uint32]:
        """The measured mixtures at the corners of each simplex, (n, materials)."""
        found = np.empty((lib.sf_mixture_simplex_count(self._c), self._shape[0]), np.uint32)
        for i, corners in enumerate(found):
            ok(lib.sf_mixture_simplex(self._c, i, _core.pointer("uint32_t", corners)))
        return found

    @documented("sf_mixture_fractions")
    def fractions(self, wanted: Any) -> tuple[Floats, float]:
        """The fractions whose properties come nearest, and how far off those are."""
        found, miss = np.empty(self._shape[0]), ffi.new("double *")
        hint = ffi.new("size_t *", 0)
        asked = _core.numbers(np.atleast_1d(np.asarray(wanted, np.float64)), self._shape[1], "wanted")
        ok(lib.sf_mixture_fractions(self._c, asked, hint, _core.pointer("double", found), ffi.NULL, miss))
        return found, miss[0]

    @documented("sf_mixture_properties")
    def properties(self, fractions: Any) -> Floats:
        """What a mixture of these fractions gives."""
        found = np.empty(self._shape[1])
        ok(lib.sf_mixture_properties(self._c, _core.numbers(fractions, self._shape[0], "fractions"),
                                     _core.pointer("double", found), ffi.NULL))
        return found


__all__ = ["Curve", "Mixture", "Trend"]
