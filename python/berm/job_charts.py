# SPDX-License-Identifier: BSD-3-Clause
"""The charts that answer the question of a run: those of curves.json, and its tables in the same form."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Protocol

from .errors import RunError
from .history import History
from .quantity import Quantity
from .table import Table


class Results(Protocol):
    """Data of the charts of a Run."""

    @property
    def curves(self) -> Mapping[str, dict[str, Any]]:
        ...

    @property
    def quantities(self) -> Mapping[str, Quantity]:
        ...

    @property
    def history(self) -> History:
        ...

    @property
    def line(self) -> Table:
        ...

    @property
    def half_cycles(self) -> Table:
        ...

WHERE = {"symbol": "x", "unit": "m", "meaning": "position along the line"}
TIME = {"symbol": "t", "unit": "s", "meaning": "time"}


def axis(symbol: str, unit: str, meaning: str) -> dict[str, str]:
    return {"symbol": symbol, "unit": unit, "meaning": meaning}


def shapes(run: Results) -> dict[str, Any]:
    """y(x) of a pipeline at the end of each stage, to 1.5 times the length that moves by more than a hundredth of the maximum."""
    line = run.line
    last = {stage: time for stage, time in zip(line["stage"], line["time_s"])}
    far = 1.5 * line["x_m"][abs(line["y_m"]) > 0.01 * abs(line["y_m"]).max()].max()
    curves = []
    for name, time in last.items():
        at = (line["time_s"] == time) & (line["x_m"] <= far)
        curves.append({"name": name, "x": line["x_m"][at], "y": line["y_m"][at]})
    return {"chart": "y_x", "x": WHERE, "y": axis("y", "m", "lateral displacement"), "curves": curves}


def half_cycles(run: Results) -> dict[str, Any]:
    """Size of each half-cycle against the time in the record at which it ends."""
    cycles = run.half_cycles
    sizes = abs(cycles["u_end_m"] - cycles["u_begin_m"])
    time = {**TIME, "meaning": "time of the record at the end of the half-cycle"}
    curves = [{"name": "half cycles", "x": cycles["end_s"], "y": sizes, "points": True}]
    return {"chart": "half_cycles", "x": time, "y": axis("|Δu|", "m", "displacement in a half-cycle"), "curves": curves}


def consolidation(run: Results) -> dict[str, Any]:
    """U against the time since each stage in which the body does not move began."""
    import numpy as np

    curves = []
    for stage in dict.fromkeys(run.history.stage):
        rows = run.history.in_stage(stage)
        U, time = run.history["U"][rows], run.history["time_s"][rows]
        if f"U_of_{stage}" in run.quantities and np.isfinite(U).any():
            curves.append({"name": stage, "x": time - time[0], "y": U})
    time_axis = {**TIME, "meaning": "time of the run since the stage began"}
    return {"chart": "U_t", "x": time_axis, "y": axis("U", "1", "degree of consolidation"), "curves": curves}


def lifts(run: Results) -> dict[str, Any]:
    """R(s) = -V of bodies that are lifted, as an uplift resistance is read."""
    chart = run.curves["V_s"]
    turned = [{**each, **{key: -each[key] for key in ("y", "smoothed") if key in each}} for each in chart["curves"]]
    return {**chart, "chart": "R_s", "y": {**chart["y"], "symbol": "R", "meaning": "uplift resistance"}, "curves": turned}


OF_TABLES = {"y_x": shapes, "half_cycles": half_cycles, "U_t": consolidation, "R_s": lifts}


def charts_of(run: Results) -> dict[str, dict[str, Any]]:
    """All charts of a run that have a curve, by name."""
    charts = dict(run.curves)
    for name, make in OF_TABLES.items():
        try:
            charts[name] = make(run)
        except (RunError, KeyError, ValueError):  # it has no such table, column or curve
            continue
    return {name: chart for name, chart in charts.items() if chart["curves"]}


def answering(charts: dict[str, dict[str, Any]]) -> list[str]:
    """Which of the charts answer the question of the run; none where those are the push and the drags of curves.png."""
    if "y_x" in charts:
        first = ["y_x", "y_load", "M_load"]
    elif "p_y" in charts:
        first = ["H_u", "p_y"]
    elif "q_z" in charts:
        first = ["q_z", "N_z"]
    elif "half_cycles" in charts:
        first = ["H_u", "w_u", "half_cycles"]
    elif "R_s" in charts:
        first = ["V_w", "R_s"]
    elif "U_t" in charts:
        first = ["V_w", "H_u"]
    else:
        return []
    return [name for name in [*first, "U_t"] if name in charts]
