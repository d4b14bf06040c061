# SPDX-License-Identifier: BSD-3-Clause
"""Curves of a run: V(w) of the push, H(u) and w(u) of the drags, as in curves.png."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .picture import DRAG_BAND, DRAG_ROWS, PUSH, PUSH_BAND, PUSH_ROWS, Unit
from .picture import add_axes, drag_color, force_unit, length_unit, new_figure, second_axis, span
from .travel import HALF_WIDTH, freed_from_noise

if TYPE_CHECKING:
    from .quantity import Quantity
    from .travel import Drag, Push

MOST_NAMES = 6  # drags with a name in the key


@dataclass(frozen=True)
class Curves:
    """What is drawn of a run. half: of the window in which noise is averaged, m; 0: there is none. measure: what forces are divided by,
    N/m, with its letters as meaning. bands: those of --uncertainty, as summary.json has them."""

    title: str
    push: Push
    drags: list[Drag]
    diameter: float | None
    half: float
    measure: Quantity | None
    bands: list[dict[str, Any]]

    def bands_of(self, chart: str) -> list[list[Any]]:
        """x, low and high of the bands of a chart (V_w, H_u, w_u)."""
        import numpy as np

        return [[np.array(band[key], dtype=float) for key in ("x", "low", "high")] for band in self.bands if band["chart"] == chart]


@dataclass(frozen=True)
class Shown:
    """Curves in the units of their picture."""

    curves: Curves
    length: Unit
    force: Unit

    def label(self, axes: Any, letter: str, words: str, symbol: str, second: bool = True) -> None:
        """Names an axis, and one on the other side that has no unit."""
        of_force, D, measure = symbol in "HV", self.curves.diameter, self.curves.measure
        unit = self.force if of_force else self.length
        axes.set(**{f"{letter}label": f"{words} {symbol} ({unit.name})"})
        if second and of_force and measure:
            letters = measure.meaning.replace("s_u", "$s_u$")
            second_axis(axes, letter, 1 / (measure.value * unit.per_si), f"{symbol}/({letters})")
        if second and not of_force and D:
            second_axis(axes, letter, 1 / (D * unit.per_si), f"{symbol}/D")


def largest(parts: list[Any]) -> float:
    """Of all numbers without their sign; 0 where there are none."""
    import numpy as np

    numbers = np.abs(np.concatenate([np.ravel(part) for part in parts] + [np.zeros(1)]))
    return float(np.nanmax(numbers))


def plot_push(shown: Shown, axes: Any) -> None:
    """V over w of the way down, from the surface on."""
    push = shown.curves.push
    w, V = push.w[push.w >= 0], push.V[push.w >= 0]
    length, force = shown.length.per_si, shown.force.per_si
    bands = shown.curves.bands_of("V_w")
    for x, low, high in bands:
        axes.fill_betweenx(x * length, low * force, high * force, color=PUSH_BAND, linewidth=0)
    axes.plot(V * force, w * length, color=PUSH_ROWS, linewidth=0.8)
    axes.plot(freed_from_noise(w, V, shown.curves.half) * force, w * length, color=PUSH, linewidth=2, label="push")
    axes.set(xlim=span([V * force] + [side * force for _, *sides in bands for side in sides]), ylim=span([w * length])[::-1])
    shown.label(axes, "x", "vertical reaction", "V")
    shown.label(axes, "y", "embedment", "w")
    axes.legend(loc="best", frameon=False)


def name_of(drag: int, count: int) -> str | None:
    """In the key."""
    if count == 1:
        return "drag"
    if count <= MOST_NAMES:
        return f"drag {drag + 1}"
    return {0: "first drag", count - 1: f"last of {count} drags"}.get(drag)


def plot_drags(shown: Shown, H_axes: Any, w_axes: Any) -> None:
    """H over u and w over u of all drags; H along x, so that of a drag back it is negative."""
    drags, half = shown.curves.drags, shown.curves.half
    length, force = shown.length.per_si, shown.force.per_si
    u = [drag.u * length for drag in drags]
    H, w = [drag.direction * drag.H * force for drag in drags], [drag.w * length for drag in drags]
    for axes, chart, rows, per_si in ((H_axes, "H_u", H, force), (w_axes, "w_u", w, length)):
        bands = shown.curves.bands_of(chart)
        for x, low, high in bands:
            axes.fill_between(x * length, low * per_si, high * per_si, color=DRAG_BAND, linewidth=0)
        for k, drag in enumerate(drags):
            if half and chart == "H_u":
                axes.plot(u[k], rows[k], color=DRAG_ROWS, linewidth=0.8, zorder=1.5)
            smooth = freed_from_noise(drag.travel, rows[k], half)
            axes.plot(u[k], smooth, color=drag_color(k, len(drags)), linewidth=2, label=name_of(k, len(drags)))
        axes.set(xlim=span(u), ylim=span(rows + [side * per_si for _, *sides in bands for side in sides])[:: 1 if chart == "H_u" else -1])
    both_ways = any(drag.direction < 0 for drag in drags)
    shown.label(H_axes, "x", "horizontal displacement", "u")
    shown.label(H_axes, "y", "reaction along x" if both_ways else "horizontal resistance", "H")
    shown.label(w_axes, "x", "horizontal displacement", "u", second=False)
    shown.label(w_axes, "y", "embedment", "w")
    H_axes.legend(loc="best", frameon=False)


def plot_curves(curves: Curves) -> Any:
    """The figure: V(w) on the left, H(u) above w(u) on the right, or the one of them that there is."""
    push, drags, D = curves.push, curves.drags, curves.diameter
    has_push = bool((push.w >= 0).any())
    travels = [push.w, *(drag.u for drag in drags)]
    forces = [push.V, *(drag.H for drag in drags), *(drag.V for drag in drags)]
    shown = Shown(curves, length_unit(D or largest(travels)), force_unit(largest(forces)))
    columns = has_push + bool(drags)
    figure = new_figure(6 * columns, 7.5)
    grid = figure.add_gridspec(2, columns)
    if has_push:
        plot_push(shown, add_axes(figure, grid[:, 0]))
    if drags:
        plot_drags(shown, add_axes(figure, grid[0, columns - 1]), add_axes(figure, grid[1, columns - 1]))
    words = f"\nthin: rows; thick: mean over ±{HALF_WIDTH:g} D" if curves.half else ""
    figure.suptitle(curves.title + words, fontsize="medium")
    return figure
