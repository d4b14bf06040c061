# SPDX-License-Identifier: BSD-3-Clause
"""Pictures with the axes of the report's page."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .errors import InputError
from .history import imported

if TYPE_CHECKING:
    from .run import Run
    from .study import Study

BLUE, RED, GREY = "#1f5fa8", "#b3391f", "#9aa0a6"


def figure(columns: int, width: float = 4.2, height: float = 3.6) -> tuple[Any, list[Any]]:
    """An empty figure without a window, and its axes side by side."""
    matplotlib = imported("matplotlib.figure", "python3-matplotlib")
    made = matplotlib.Figure(figsize=(width * columns, height), layout="constrained")
    return made, [made.add_subplot(1, columns, k + 1) for k in range(columns)]


def scale(unit: str) -> tuple[float, str]:
    """Forces are shown in kN, lengths in m."""
    return (1e-3, "k" + unit) if unit.startswith("N") else (1.0, unit)


def plot_curves(run: Run) -> Any:
    history = run.history
    for needed in ("u", "w", "H", "V"):
        if needed not in history:
            raise InputError(f"{run.folder}: the history has no {needed}: no rigid body is driven")
    drags = [s["name"] for s in run.case["stage"] if s["kind"] == "drag"]
    pushes = [s["name"] for s in run.case["stage"] if s["kind"] == "push"]
    made, (v_of_w, h_of_u, w_of_u) = figure(3)
    by, unit = scale(history.unit("V"))
    for stage in pushes:
        rows = history.in_stage(stage)
        v_of_w.plot(history["V"][rows] * by, history["w"][rows], color=BLUE, label=stage)
    v_of_w.invert_yaxis()
    v_of_w.set(xlabel=f"V ({unit})", ylabel="w (m)")
    for stage in drags:
        rows = history.in_stage(stage)
        u = history["u"][rows]
        h_of_u.plot(u, history["H"][rows] * by, label=stage)
        w_of_u.plot(u, history["w"][rows], label=stage)
    h_of_u.set(xlabel="u (m)", ylabel=f"H ({unit})")
    w_of_u.invert_yaxis()
    w_of_u.set(xlabel="u (m)", ylabel="w (m)")
    for axes in (v_of_w, h_of_u, w_of_u):
        axes.grid(alpha=0.3)
    if len(drags) > 1:
        h_of_u.legend(fontsize="small")
    made.suptitle(run.case.get("title", run.folder.name), fontsize="medium")
    return made


def plot_soil(run: Run, frame: int, field: str) -> Any:
    import numpy as np

    if not run.frames:
        raise InputError(f"{run.folder} has no frames")
    try:
        shown = run.frames[frame]
    except IndexError:
        raise InputError(f"frame {frame}: there are {len(run.frames)}, 0 to {len(run.frames) - 1}") from None
    data = shown.field(field)
    values = data.values if data.values.ndim == 1 else np.linalg.norm(data.values, axis=1)
    made, (axes,) = figure(1, 9, 4)
    points = axes.scatter(shown.position[:, 0], shown.position[:, 1], c=values, s=2, linewidths=0, cmap="viridis", rasterized=True)
    axes.set(aspect="equal", xlabel="x (m)", ylabel="y (m)", title=f"{run.case.get('title', run.folder.name)}, t = {shown.time:.4g} s")
    made.colorbar(points, ax=axes, label=f"{data.label} ({data.unit})" if data.unit else data.label)
    return made


def plot_springs(study: Study) -> Any:
    springs = study.springs["springs"]
    stages = [lateral["stage"] for lateral in springs["best"]["lateral"]]
    if not stages:
        raise InputError(f"{study.folder}: its runs have no drag")
    made, panels = figure(len(stages), 5.5, 4)
    for stage, axes in zip(stages, panels):
        for run in study.runs():
            rows = run.history.in_stage(stage)
            u = run.history["u"][rows]
            axes.plot(u - u[0], run.history["H"][rows] * 1e-3, color=GREY, linewidth=0.7, alpha=0.7)
        for name, color, width in (("low", BLUE, 1.6), ("best", "black", 2.2), ("high", RED, 1.6)):
            for lateral in springs.get(name, {"lateral": []})["lateral"]:
                if lateral["stage"] == stage:
                    spring = lateral["spring"]
                    axes.plot([p[0] for p in spring], [p[1] * 1e-3 for p in spring], color=color, linewidth=width, marker="o", markersize=3, label=name)
        axes.set(xlabel="displacement (m)", ylabel="H (kN/m)", title=stage)
        axes.grid(alpha=0.3)
        axes.legend()
    return made
