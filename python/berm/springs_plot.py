# SPDX-License-Identifier: BSD-3-Clause
"""Lateral springs of a sample, low, best and high, over the curves of all its runs, as in springs.png."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from .picture import BEST, BEST_RUN, HIGH, LOW, SAMPLE, add_axes, force_unit, new_figure, span

SETS = {"low": LOW, "best": BEST, "high": HIGH}


@dataclass(frozen=True)
class Panel:
    """Travel (m) and H (N/m) of one drag of one combination: of its springs by low, best and high, and of the runs."""

    title: str
    diameter: float
    springs: dict[str, tuple[Any, Any]]
    sample: list[tuple[Any, Any]]
    best: list[tuple[Any, Any]]


def plot_springs(panels: Sequence[Panel]) -> Any:
    """The panels one under the other."""
    import numpy as np

    figure = new_figure(9, 4 * len(panels))
    grid = figure.add_gridspec(len(panels), 1)
    for row, panel in enumerate(panels):
        D = panel.diameter
        lines: list[tuple[Any, Any, dict[str, Any]]] = []
        for runs, color, width, label in (
            (panel.sample, SAMPLE, 0.8, "computed, runs of the sample"),
            (panel.best, BEST_RUN, 1.6, "computed, best"),
        ):
            for k, (u, H) in enumerate(runs):
                lines.append((u, H, {"color": color, "linewidth": width, "label": None if k else label}))
        for name, color in SETS.items():
            if name in panel.springs:
                lines.append((*panel.springs[name], {"color": color, "linewidth": 2.4, "label": name}))
        unit = force_unit(max(float(np.nanmax(H, initial=0)) for _, H, _ in lines))
        axes = add_axes(figure, grid[row, 0])
        for u, H, style in lines:
            axes.plot(u / D, H * unit.per_si, **style)
        axes.set(xlabel="u / D", ylabel=f"H ({unit.name})", title=panel.title)
        axes.set(xlim=(0, span([u / D for u, _, _ in lines])[1] / 1.04), ylim=span([H * unit.per_si for _, H, _ in lines]))
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.17), ncol=3, frameon=False)
    return figure
