# SPDX-License-Identifier: BSD-3-Clause
"""Lateral springs of a sample, low, best and high, over the curves of all its runs, as in springs.png."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .errors import InputError
from .picture import BEST, BEST_RUN, HIGH, LOW, SAMPLE, add_axes, force_unit, new_figure, span
from .travel import HALF_WIDTH, freed_from_noise

if TYPE_CHECKING:
    from .run import Run
    from .study import Study

SETS = {"low": LOW, "best": BEST, "high": HIGH}


def computed(run: Run, stage: str) -> tuple[Any, Any]:
    """Travel and H of a drag, freed from noise; empty where the run has no such drag."""
    for drag in run.drags:
        if drag.stage == stage:
            half = HALF_WIDTH * (run.diameter or 0) if run.case["method"] == "mpm" else 0.0
            return drag.travel, freed_from_noise(drag.travel, drag.H, half, whole_window=True)
    return [], []


def plot_springs(study: Study) -> Any:
    """A panel for each drag of each combination. A centrifuge's results are those of its prototype."""
    import numpy as np

    panels = [(design, lateral["stage"]) for design in study.designs for lateral in design["springs"]["best"]["lateral"]]
    if not panels:
        raise InputError(f"{study.folder}: its runs have no drag, so that there are no lateral springs")
    figure = new_figure(9, 4 * len(panels))
    grid = figure.add_gridspec(len(panels), 1)
    for row, (design, stage) in enumerate(panels):
        names = next(each.names for each in study.rows if ".".join(each.names) == design["name"])
        D, scale = design["diameter_m"], design["prototype_over_model"]
        lines: list[tuple[Any, Any, dict[str, Any]]] = []
        for kind, color, width, label in (("draw", SAMPLE, 0.8, "computed, runs of the sample"), ("best", BEST_RUN, 1.6, "computed, best")):
            for k, run in enumerate(study.runs(kind, names)):
                u, H = (np.asarray(part, dtype=float) * scale for part in computed(run, stage))
                lines.append((u, H, {"color": color, "linewidth": width, "label": None if k else label}))
        for name, color in SETS.items():
            for lateral in design["springs"].get(name, {"lateral": []})["lateral"]:
                if lateral["stage"] == stage:
                    u, H = np.array(lateral["spring"]).T
                    lines.append((u, H, {"color": color, "linewidth": 2.4, "label": name}))
        unit = force_unit(max(float(np.nanmax(H, initial=0)) for _, H, _ in lines))
        axes = add_axes(figure, grid[row, 0])
        for u, H, style in lines:
            axes.plot(u / D, H * unit.per_si, **style)
        axes.set(xlabel="u / D", ylabel=f"H ({unit.name})", title=f"{design['name']}, {stage}")
        axes.set(xlim=(0, span([u / D for u, _, _ in lines])[1] / 1.04), ylim=span([H * unit.per_si for _, H, _ in lines]))
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.17), ncol=3, frameon=False)
    return figure
