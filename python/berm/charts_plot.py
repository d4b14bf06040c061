# SPDX-License-Identifier: BSD-3-Clause
"""Charts of curves.json, and of tables in the same form, as the page shows them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from .curves_plot import MOST_NAMES, largest
from .picture import Unit, add_axes, drag_color, length_unit, new_figure, span

DOWNWARDS = "wz"  # symbols of lengths that are drawn downwards
FORCES = {"N/m", "N", "Pa", "N m", "N/m^2"}
ROWS_ALPHA = 0.35


def unit_for(unit: str, size: float) -> Unit:
    """In which numbers up to this size are drawn: mm or m, N, kN or MN."""
    if unit == "m":
        return length_unit(size)
    if unit in FORCES:
        for per_si, prefix in ((1e-6, "M"), (1e-3, "k")):
            if size * per_si >= (2 if prefix == "M" else 0.1):
                return Unit(per_si, prefix + unit)
    return Unit(1, unit)


def label(axis: Mapping[str, str], unit: Unit) -> str:
    return f"{axis['meaning']} {axis['symbol']}" + (f" ({unit.name})" if unit.name != "1" else "")


def has_mean(curve: Mapping[str, Any]) -> bool:
    """Whether it is freed from noise: NaN where a mean over a travel back and forth means nothing."""
    return "smoothed" in curve and bool((curve["smoothed"] == curve["smoothed"]).any())


def draw(axes: Any, chart: Mapping[str, Any]) -> None:
    """Rows pale under what is freed from noise; a depth as x goes down the page."""
    x_unit, y_unit = (unit_for(chart[letter]["unit"], largest([curve[letter] for curve in chart["curves"]])) for letter in "xy")
    upright = chart["x"]["symbol"] in DOWNWARDS
    count = len(chart["curves"])
    for k, curve in enumerate(chart["curves"]):
        x, y = curve["x"] * x_unit.per_si, curve["y"] * y_unit.per_si
        color, name = drag_color(k, count), curve["name"] if 1 < count <= 2 * MOST_NAMES or curve.get("points") else None
        lines = [(y, {"linewidth": 2, "label": name})]
        if curve.get("points"):
            lines = [(y, {"linestyle": "none", "marker": "o", "label": name})]
        elif has_mean(curve):
            lines = [(y, {"linewidth": 0.8, "alpha": ROWS_ALPHA}), (curve["smoothed"] * y_unit.per_si, {"linewidth": 2, "label": name})]
        for values, style in lines:
            axes.plot(*((values, x) if upright else (x, values)), color=color, **style)
    x_label, y_label = label(chart["x"], x_unit), label(chart["y"], y_unit)
    x_range, y_range = (span([curve[letter] * unit.per_si for curve in chart["curves"]]) for letter, unit in (("x", x_unit), ("y", y_unit)))
    if upright:
        axes.set(xlabel=y_label, ylabel=x_label, xlim=y_range, ylim=x_range[::-1])
    else:
        axes.set(xlabel=x_label, ylabel=y_label, xlim=x_range, ylim=y_range[::-1] if chart["y"]["symbol"] in DOWNWARDS else y_range)
    if axes.get_legend_handles_labels()[0]:
        axes.legend(loc="best", frameon=False, fontsize="small")


def plot_charts(title: str, charts: Sequence[Mapping[str, Any]]) -> Any:
    """The figure: charts side by side."""
    figure = new_figure(max(6.5, 5 * len(charts)), 5)
    grid = figure.add_gridspec(1, len(charts))
    for k, chart in enumerate(charts):
        draw(add_axes(figure, grid[0, k]), chart)
    figure.suptitle(title, fontsize="medium")
    return figure
