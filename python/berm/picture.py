# SPDX-License-Identifier: BSD-3-Clause
"""What pictures share: colours, units, axes and numbers as in the pictures that the program draws."""

from __future__ import annotations

import io
import math
from typing import TYPE_CHECKING, Any, NamedTuple

from .history import imported

if TYPE_CHECKING:
    from collections.abc import Sequence

PUSH, PUSH_ROWS, PUSH_BAND = "#1764ab", "#b8d0ea", "#dfe9f4"
DRAG, DRAG_ROWS, DRAG_BAND = "#c8452f", "#f0c4bb", "#f8e3df"
FIRST_DRAG, LAST_DRAG = (0xF2, 0x9C, 0x6B), (0x7A, 0x12, 0x2B)  # of several, from light to dark
LOW, BEST, HIGH, SAMPLE, BEST_RUN = DRAG, "#2f8f4e", "#8155a6", "#b0b0b0", "#606060"
GRID, BORDER, TEXT, GROUND = "#dddddd", "#444444", "#222222", "#666666"
RIGID, RIGID_EDGE = "#c9ccd1", "#33373d"


class Unit(NamedTuple):
    """Of numbers in a picture: how many there are in one of SI, and its name."""

    per_si: float
    name: str


def length_unit(size: float) -> Unit:
    return Unit(1000, "mm") if size < 1 else Unit(1, "m")


def force_unit(size: float) -> Unit:
    """Of a force per metre, N/m."""
    return Unit(1, "N/m") if size < 100 else Unit(1e-3, "kN/m")


def drag_color(number: int, count: int) -> str:
    """Of a drag of several, counted from 0."""
    if count == 1:
        return DRAG
    part = number / (count - 1)
    return "#" + "".join(f"{round(light + part * (dark - light)):02x}" for light, dark in zip(FIRST_DRAG, LAST_DRAG))


def round_up(value: float) -> float:
    """The next of 1, 1.5, 2, 3, 4, 5, 6, 8, 10 times a power of ten."""
    if not value > 0:
        return 1
    power = 10.0 ** math.floor(math.log10(value))
    return next(step * power for step in (1, 1.5, 2, 3, 4, 5, 6, 8, 10) if value <= step * power * (1 + 1e-9))


def new_figure(width: float, height: float) -> Any:
    """A matplotlib Figure of this size in inches, without a window, that a notebook shows. Throws RunError where it is not installed."""
    figure = imported("matplotlib.figure", "python3-matplotlib").Figure(figsize=(width, height), layout="constrained")

    def png() -> bytes:
        file = io.BytesIO()
        figure.savefig(file, format="png", dpi=90)
        return file.getvalue()

    figure._repr_png_ = png  # which notebooks ask for
    return figure


def add_axes(figure: Any, place: Any) -> Any:
    """Axes in a place of a grid, as in all pictures."""
    axes = figure.add_subplot(place)
    axes.grid(color=GRID, linewidth=0.8)
    axes.set_axisbelow(True)
    axes.tick_params(colors=TEXT)
    for spine in axes.spines.values():
        spine.set_color(BORDER)
    return axes


def second_axis(axes: Any, letter: str, factor: float, label: str) -> None:
    """An axis on the other side: the first one times a factor."""
    both = (lambda x: x * factor), (lambda x: x / factor)
    second = axes.secondary_xaxis("top", functions=both) if letter == "x" else axes.secondary_yaxis("right", functions=both)
    second.set(**{f"{letter}label": label})
    second.tick_params(colors=TEXT)


def span(values: Sequence[Any]) -> tuple[float, float]:
    """The range of an axis: from 0, or the least number where that is negative by more than noise, to the most, with a margin."""
    import numpy as np

    numbers = np.concatenate([np.ravel(part) for part in values] + [np.zeros(1)])
    least, most = float(np.nanmin(numbers)), float(np.nanmax(numbers))
    margin = 0.04 * (most - least) if most > least else 1.0
    return (least - margin if -least > 0.05 * (most - least) else 0.0), most + margin
