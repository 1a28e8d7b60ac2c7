"""Pictures on matplotlib, which is not needed for anything else."""

from __future__ import annotations

from typing import Any

import numpy as np

from .balance import Stance, center_of_mass
from .support import Checked
from .voxel import Grid

SOLID, HANGING, SAFE, FALLS = "#5a7ca2", "#e8622c", "#2e8c46", "#d03228"


def _axes(axes: Any) -> Any:
    if axes is not None:
        return axes
    import matplotlib.pyplot as plt

    return plt.subplots()[1]


def layer(grid: Grid, k: int, *, marked: Grid | None = None, axes: Any = None) -> Any:
    """A layer from above, in mm; voxels of `marked` in orange."""
    from matplotlib.colors import ListedColormap

    axes = _axes(axes)
    lattice = grid.lattice
    picture = grid.array()[k].astype(np.uint8)
    if marked is not None:
        picture[marked.array()[k]] = 2
    x, y, _ = lattice.origin_mm
    extent = (x, x + lattice.nx * lattice.pitch_mm[0], y, y + lattice.ny * lattice.pitch_mm[1])
    axes.imshow(picture, origin="lower", extent=extent, cmap=ListedColormap(["white", SOLID, HANGING]),
                vmin=0, vmax=2, interpolation="nearest")
    axes.set(title=f"layer {k}, {lattice.layer_bottom(k):.2f} mm", xlabel="x, mm", ylabel="y, mm")
    return axes


def side(grid: Grid, *, marked: Grid | None = None, axis: str = "y", axes: Any = None) -> Any:
    """All layers from the side: how much solid lies behind each place, `marked` in orange."""
    axes = _axes(axes)
    lattice = grid.lattice
    across = {"x": 2, "y": 1}[axis]
    depth = grid.array().sum(axis=across)
    width, pitch, start = (lattice.nx, lattice.pitch_mm[0], lattice.origin_mm[0]) if axis == "y" else \
        (lattice.ny, lattice.pitch_mm[1], lattice.origin_mm[1])
    edges = [lattice.layer_bottom(k) for k in range(lattice.nz + 1)]
    places = start + np.arange(width + 1) * pitch
    shown = np.where(depth > 0, depth.astype(float), np.nan)
    axes.pcolormesh(places, edges, shown, cmap="Blues", vmin=-0.4 * max(depth.max(), 1), vmax=depth.max() * 1.2)
    if marked is not None:
        found = marked.array().any(axis=across)
        hangs = np.where(found, 1.0, np.nan)
        axes.pcolormesh(places, edges, hangs, cmap="autumn", vmin=0, vmax=2)
    axes.set(xlabel=f"{'x' if axis == 'y' else 'y'}, mm", ylabel="z, mm")
    axes.set_aspect("equal")
    return axes


def findings(grid: Grid, found: Checked, *, axes: Any = None) -> Any:
    """The side view with what hangs, and the boxes of what was found."""
    from matplotlib.patches import Rectangle

    axes = side(grid, axes=axes)
    lattice = grid.lattice
    for f in found.findings:
        b = f.box
        axes.add_patch(Rectangle(
            (lattice.origin_mm[0] + b.x0 * lattice.pitch_mm[0], lattice.layer_bottom(b.z0)),
            (b.x1 - b.x0) * lattice.pitch_mm[0],
            lattice.layer_bottom(b.z1) - lattice.layer_bottom(b.z0), color=HANGING, lw=1.5, fill=False))
    count = len(found.findings)
    axes.set_title("prints without supports" if found else
                   f"{count} place{'' if count == 1 else 's'} hang{'s' if count == 1 else ''}")
    return axes


def balance(mesh: Any, stance: Stance, com_mm: Any = None, *, axes: Any = None) -> Any:
    """What a shape stands on, from above, and where its centre of mass lies over it."""
    axes = _axes(axes)
    com = np.asarray(center_of_mass(mesh) if com_mm is None else com_mm)
    verdict = stance.judge(com)
    corners = stance.polygon()
    ring = np.vstack([corners, corners[:1]])
    axes.fill(ring[:, 0], ring[:, 1], color="#dfe6ee")
    axes.plot(ring[:, 0], ring[:, 1], color="#3c424e", lw=1.5)
    edge = np.array(verdict.edge_mm_pair)
    if not verdict.safe:
        axes.plot(edge[:, 0], edge[:, 1], color=FALLS, lw=3)
    axes.plot(com[0], com[1], "o", color=SAFE if verdict.safe else FALLS, ms=9)
    axes.set_aspect("equal")
    axes.set(title=f"{'stands' if verdict.stands else 'falls'}: {np.degrees(verdict.margin_rad):.1f} degrees",
             xlabel="x, mm", ylabel="y, mm")
    return axes


def materials(ids: Any, *, pitch_mm: tuple[float, float] = (1.0, 1.0), axes: Any = None) -> Any:
    """A halftoned slice, (y, x), a colour for each material."""
    from matplotlib.colors import ListedColormap

    axes = _axes(axes)
    ids = np.asarray(ids)
    colours = ["white", "#48505a", "#deb252", "#c46a42", "#708e62", "#8e6a8e", "#567aa2", "#e8e4dc"]
    extent = (0, ids.shape[1] * pitch_mm[0], 0, ids.shape[0] * pitch_mm[1])
    axes.imshow(ids, origin="lower", extent=extent, cmap=ListedColormap(colours), vmin=0,
                vmax=len(colours) - 1, interpolation="nearest")
    axes.set(xlabel="mm", ylabel="mm")
    return axes
