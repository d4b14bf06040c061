# SPDX-License-Identifier: BSD-3-Clause
"""Pushes and drags: the parts of a history in which the body travels, and forces freed from noise along it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .errors import InputError
from .history import History

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

HALF_WIDTH = 0.01  # of the diameter: forces are means over travel +- this, as in key results and on the page


@dataclass(frozen=True)
class Push:
    """The way down by row: pushes before the first drag that load the pipe further. w in m, V in N/m."""

    w: NDArray[np.float64]
    V: NDArray[np.float64]


@dataclass(frozen=True)
class Drag:
    """One drag by row, from the row before it on. direction: +1 along x, -1 against it; u in m, along x from where the first drag began;
    travel in m, from its own begin along its direction; w in m; H (positive where the soil resists) and V in N/m."""

    stage: str
    direction: float
    u: NDArray[np.float64]
    travel: NDArray[np.float64]
    w: NDArray[np.float64]
    H: NDArray[np.float64]
    V: NDArray[np.float64]


def _last(stage: dict[str, Any], key: str) -> float | None:
    """Velocity or force of a stage at the end of its load history."""
    value = stage.get(key)
    return None if value is None else float(value) * float((stage.get("load_factors") or [1])[-1])


def pushes_and_drags(history: History, stages: Sequence[dict[str, Any]]) -> tuple[Push, list[Drag]]:
    """The way down and the drags of a run, by the stages of its case. Throws InputError where no rigid body is driven."""
    import numpy as np

    for needed in ("u", "w", "H", "V"):
        if needed not in history:
            raise InputError(f"the history has no {needed}: no rigid body is driven")
    u, w, H, V = (history[name] for name in ("u", "w", "H", "V"))
    down: list[int] = []
    drags: list[Drag] = []
    origin = 0.0
    for stage in stages:
        rows = [k for k, name in enumerate(history.stage) if name == stage["name"]]
        if not rows:
            continue
        before = max(rows[0] - 1, 0)
        if stage["kind"] == "push" and not drags:
            force, velocity = _last(stage, "force"), _last(stage, "velocity")
            unloads = (velocity is not None and velocity < 0) or (force is not None and rows[0] > 0 and force < V[before])
            down += [] if unloads else rows
        if stage["kind"] == "drag" and stage.get("velocity") != 0:
            direction = -1.0 if stage.get("velocity", 0) < 0 or stage.get("force", 0) < 0 else 1.0
            at = np.array(rows if before == rows[0] else [before, *rows])
            origin = origin if drags else float(u[before])
            drags.append(Drag(stage["name"], direction, u[at] - origin, direction * (u[at] - u[before]), w[at], direction * H[at], V[at]))
    return Push(w[down], V[down]), drags


def freed_from_noise(
    travel: NDArray[np.float64], value: NDArray[np.float64], half: float, whole_window: bool = False
) -> NDArray[np.float64]:
    """The value at each travel: that of the straight line fitted over travel +- half. Towards the ends of the curve the window is less (as
    in curves.png), or stays whole and the line is followed to the end (as in springs and key results). Rows whose travel is not beyond
    that of all before them, or NaN, do not count; they get what the others give there."""
    import numpy as np

    beyond = np.maximum.accumulate(np.where(np.isnan(travel) | np.isnan(value), -np.inf, travel))
    kept = np.isfinite(beyond) & (beyond > np.append(-np.inf, beyond[:-1]))
    x, y = travel[kept], value[kept]
    smooth = np.full(travel.shape, np.nan)
    if not x.size:
        return smooth
    for k in np.flatnonzero((travel >= x[0]) & (travel <= x[-1])):
        s = travel[k]
        reach = half if whole_window else max(0.0, min(half, s - x[0], x[-1] - s))
        lower, upper = max(x[0], min(s - reach, x[-1] - 2 * reach)), min(x[-1], max(s + reach, x[0] + 2 * reach))
        window = slice(int(np.searchsorted(x, lower)), int(np.searchsorted(x, upper, side="right")))
        near, there = x[window], y[window]
        if near.size < 3:
            smooth[k] = np.interp(s, x, y)
            continue
        weight = np.diff(np.concatenate((near[:1], (near[:-1] + near[1:]) / 2, near[-1:])))
        mean = np.average(there, weights=weight)
        middle = np.average(near, weights=weight)
        away = near - middle
        slope = (weight * away * (there - mean)).sum() / (weight * away**2).sum()
        smooth[k] = mean + slope * (s - middle)
    return smooth
