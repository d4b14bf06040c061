# SPDX-License-Identifier: BSD-3-Clause
"""Curves of a run: V(w) of the push, H(u) and w(u) of the drags, as in curves.png."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .curves import HALF_WIDTH
from .picture import DRAG_BAND, DRAG_ROWS, PUSH, PUSH_BAND, PUSH_ROWS, Unit
from .picture import add_axes, drag_color, force_unit, length_unit, new_figure, second_axis, span

if TYPE_CHECKING:
    from .quantity import Quantity

MOST_NAMES = 6  # drags with a name in the key


@dataclass(frozen=True)
class Curves:
    """What is drawn of a run. noisy: whether rows are drawn beside what is freed from noise. measure: what forces are divided by, N/m,
    with its letters as meaning."""

    title: str
    charts: dict[str, Any]
    diameter: float | None
    noisy: bool
    measure: Quantity | None


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
    """V against w in penetration, from the surface."""
    chart = shown.curves.charts["V_w"]
    curve, bands = chart["curves"][0], [[band[key] for key in ("x", "low", "high")] for band in chart["bands"]]
    w, V, smoothed = (curve[key][curve["x"] >= 0] for key in ("x", "y", "smoothed"))
    length, force = shown.length.per_si, shown.force.per_si
    for x, low, high in bands:
        axes.fill_betweenx(x * length, low * force, high * force, color=PUSH_BAND, linewidth=0)
    axes.plot(V * force, w * length, color=PUSH_ROWS, linewidth=0.8)
    axes.plot(smoothed * force, w * length, color=PUSH, linewidth=2, label="push")
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
    """H and w against u of all drags; H along x, so that of a drag back it is negative."""
    length = shown.length.per_si
    for axes, name, per_si in ((H_axes, "H_u", shown.force.per_si), (w_axes, "w_u", length)):
        curves, bands = (shown.curves.charts[name][key] for key in ("curves", "bands"))
        for band in bands:
            axes.fill_between(band["x"] * length, band["low"] * per_si, band["high"] * per_si, color=DRAG_BAND, linewidth=0)
        for k, drag in enumerate(curves):
            u, label = drag["x"] * length, name_of(k, len(curves))
            if shown.curves.noisy and name == "H_u":
                axes.plot(u, drag["y"] * per_si, color=DRAG_ROWS, linewidth=0.8, zorder=1.5)
            axes.plot(u, drag["smoothed"] * per_si, color=drag_color(k, len(curves)), linewidth=2, label=label)
        values = [drag["y"] for drag in curves] + [band[side] for band in bands for side in ("low", "high")]
        ylim = span([each * per_si for each in values])[:: 1 if name == "H_u" else -1]
        axes.set(xlim=span([drag["x"] * length for drag in curves]), ylim=ylim)
    both_ways = any(drag["direction"] < 0 for drag in shown.curves.charts["H_u"]["curves"])
    shown.label(H_axes, "x", "horizontal displacement", "u")
    shown.label(H_axes, "y", "reaction along x" if both_ways else "horizontal resistance", "H")
    shown.label(w_axes, "x", "horizontal displacement", "u", second=False)
    shown.label(w_axes, "y", "embedment", "w")
    H_axes.legend(loc="best", frameon=False)


def plot_curves(curves: Curves) -> Any:
    """The figure: V(w) on the left, H(u) above w(u) on the right, or the one of them that there is."""
    push, drags, V_of_drags = (curves.charts[name]["curves"] for name in ("V_w", "H_u", "V_u"))
    has_push = any((curve["x"] >= 0).any() for curve in push)
    travel = curves.diameter or largest([curve["x"] for curve in push + drags])
    shown = Shown(curves, length_unit(travel), force_unit(largest([curve["y"] for curve in push + drags + V_of_drags])))
    columns = has_push + bool(drags)
    figure = new_figure(6 * columns, 7.5)
    grid = figure.add_gridspec(2, columns)
    if has_push:
        plot_push(shown, add_axes(figure, grid[:, 0]))
    if drags:
        plot_drags(shown, add_axes(figure, grid[0, columns - 1]), add_axes(figure, grid[1, columns - 1]))
    words = f"\nthin: rows; thick: mean over ±{HALF_WIDTH:g} D" if curves.noisy else ""
    figure.suptitle(curves.title + words, fontsize="medium")
    return figure
