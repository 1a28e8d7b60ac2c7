"""Certificates: a claim that a shape is support-free, with what somebody else needs to check it."""

from __future__ import annotations

from typing import Any

from . import _core, _files, _types
from ._core import Progress, documented, ffi, lib, ok, running
from ._types import Operation
from .support import AnyRule, Rule, _terms
from .voxel import Grid


@documented("sf_grid_sha256")
def sha256(grid: Grid, *, progress: Progress = None) -> bytes:
    """The fingerprint of a grid's voxels."""
    digest = ffi.new("uint8_t[]", 32)
    with running(progress) as task:
        ok(lib.sf_grid_sha256(grid._c, task, digest))
    return bytes(digest)


class Certificate:
    """That a shape is support-free under a rule but for exempt voxels; an error where it is not."""

    @documented("sf_certificate_make")
    def __init__(self, shape: Grid, rule: AnyRule = "box3", *, bed_layer: int | None = None,
                 exempt: Grid | None = None, operation: Operation | str = Operation.CHECK,
                 before: Grid | None = None, progress: Progress = None) -> None:
        rule = Rule.named(rule) if isinstance(rule, str) else rule
        terms = _terms(shape, rule, bed_layer, exempt)
        kind = _core.member(Operation, operation, "operation")
        claim = _core.options("sf_claim", angle_rad=rule.angle_rad, bridge_span_mm=rule.bridge_span_mm,
                              bridge_anchor_mm=rule.bridge_anchor_mm, operation=int(kind))
        claim.terms = terms.c
        claim.before = ffi.NULL if before is None else before._c
        made, fault = ffi.new("sf_certificate **"), _core.new_fault()
        with running(progress) as task:
            ok(lib.sf_certificate_make(shape._c, claim, ffi.NULL, task, made, fault), fault)
        self._c = ffi.gc(made[0], lib.sf_certificate_destroy)

    @property
    def _view(self) -> Any:
        return lib.sf_certificate_get_view(self._c)

    @property
    def operation(self) -> str:
        """What made the shape, as certificates spell it."""
        return ffi.string(lib.sf_operation_name(self._view.operation)).decode()  # type: ignore[no-any-return]

    @property
    def input_sha256(self) -> bytes:
        return bytes(self._view.input_sha256)

    @property
    def output_sha256(self) -> bytes:
        return bytes(self._view.output_sha256)

    @property
    def counts(self) -> dict[str, int]:
        """Voxels of the input and of the shape, and those added and removed."""
        view = self._view
        return {name: int(getattr(view, f"{name}_voxels")) for name in ("input", "output", "added", "removed")}

    @property
    def layers(self) -> _core.Values[_types.CertificateLayer]:
        """The counts of each layer."""
        view = self._view
        return _core.Values(view.layers, int(view.lattice.nz), self._c)

    @property
    def spans(self) -> _core.Values[_types.CertificateSpan]:
        """The gaps that bridges span."""
        view = self._view
        return _core.Values(view.spans, int(view.span_count), self._c)

    @documented("sf_certificate_write")
    def save(self, to: _files.Writable) -> None:
        """Write it as JSON, whole or not at all; sf-verify holds it against a stack."""
        with _files.sink(to) as sink:
            ok(lib.sf_certificate_write(self._c, sink))


__all__ = ["Certificate", "Operation", "sha256"]
