# SPDX-License-Identifier: BSD-3-Clause
"""The soil of a frame in the plane, coloured by a field, as in soil.png."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .errors import InputError
from .history import imported
from .picture import GROUND, RIGID, RIGID_EDGE, Unit, add_axes, length_unit, new_figure, round_up

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from .frames import Frame

PARTS = ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5))  # of a quadratic triangle, between corners and middles of sides


def color_range(values: NDArray[Any]) -> tuple[float, float]:
    """From zero to the value that one point in a hundred exceeds, on each side that has any, rounded up."""
    ordered = sorted(float(value) for value in values if value == value) or [0.0]
    part = len(ordered) // 100

    def end(hundredth: float, farthest: float) -> float:
        return hundredth if hundredth > 0 else max(0.0, farthest)

    above, below = end(ordered[-1 - part], ordered[-1]), end(-ordered[part], -ordered[0])
    return (-round_up(below) if below > 0 else 0.0), (round_up(above) if above > 0 or below == 0 else 0.0)


def view_around(outline: NDArray[Any], soil: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Lower and upper corner of the part around a rigid body: 2.5 widths to each side of its middle, 1.2 below and 1.3 above its lowest
    point, and up to a berm that stands there, but for the highest point in a thousand, which may be thrown up."""
    import numpy as np

    width = np.ptp(outline[:, 0])
    lower = np.array([outline[:, 0].min() - 2 * width, outline[:, 1].min() - 1.2 * width])
    upper = lower + np.array([5, 2.5]) * width
    levels = np.sort(soil[(soil[:, 0] >= lower[0]) & (soil[:, 0] <= upper[0]), 1])
    if levels.size:
        upper[1] = max(upper[1], levels[-1 - levels.size // 1000] + 0.2 * width)
    return lower, upper


def paint(axes: Any, frame: Frame, values: NDArray[Any], shown: NDArray[Any], unit: Unit) -> Any:
    """Triangles filled, or particles as disks that close the ground between them; returns what a colour bar explains."""
    import numpy as np

    x, triangles = frame.position[:, :2] * unit.per_si, frame.triangles
    least, most = color_range(values[shown])
    if triangles.size:
        parts = np.concatenate([triangles[:, part] for part in PARTS])
        return axes.tripcolor(x[:, 0], x[:, 1], parts, values, shading="gouraud", cmap="viridis", vmin=least, vmax=most, rasterized=True)
    size = 2 * np.sqrt(frame["volume"][shown]) * unit.per_si
    disks = imported("matplotlib.collections", "python3-matplotlib").EllipseCollection(
        size, size, 0 * size, units="xy", offsets=x[shown], transOffset=axes.transData, cmap="viridis", linewidth=0, rasterized=True
    )
    disks.set(array=values[shown], clim=(least, most))
    return axes.add_collection(disks)


def plot_soil(frame: Frame, name: str, title: str, ground: NDArray[np.float64] | float, whole: bool) -> Any:
    """The figure of a field. ground: the corners of its line, of shape (corners, 2), or the level all along, m; whole: not only what lies
    around the rigid body."""
    import numpy as np

    field, position = frame.field(name), frame.position[:, :2]
    values = field.values if field.values.ndim == 1 else np.linalg.norm(field.values, axis=1)
    outlines = [outline[:, :2] for outline in frame.rigid_bodies]
    lower, upper = position.min(axis=0), position.max(axis=0)
    if outlines and not whole:
        lower, upper = view_around(outlines[0], position)
    reach = np.sqrt(frame["volume"])[:, None]
    shown = ((position >= lower - reach) & (position <= upper + reach)).all(axis=1)
    if not shown.any():
        raise InputError(f"no soil lies around the rigid body at {frame.time:.4g} s; whole=True shows all of it")
    unit = length_unit(float((upper - lower).max()))
    aspect = float((upper[1] - lower[1]) / (upper[0] - lower[0]))
    figure = new_figure(10, min(max(8 * aspect + 1.1, 3.0), 12.0))
    axes = add_axes(figure, 111)
    axes.grid(False)
    painted = paint(axes, frame, values, shown, unit)
    for outline in outlines:
        axes.fill(*(outline * unit.per_si).T, facecolor=RIGID, edgecolor=RIGID_EDGE, linewidth=1.5)
    line = np.array([[lower[0], ground], [upper[0], ground]]) if isinstance(ground, float) else ground
    axes.plot(*(line[:, :2] * unit.per_si).T, color=GROUND, linewidth=0.8, dashes=(5, 5))
    axes.set(xlim=np.array([lower[0], upper[0]]) * unit.per_si, ylim=np.array([lower[1], upper[1]]) * unit.per_si, aspect="equal")
    axes.set(xlabel=f"x ({unit.name})", ylabel=f"y ({unit.name})")
    axes.set_title(f"{title}: {frame.stage}, {frame.time:.4g} s")
    words = ("" if field.values.ndim == 1 else "size of ") + field.label
    figure.colorbar(painted, ax=axes, label=f"{words} ({field.unit})" if field.unit else words, fraction=0.03)
    return figure
