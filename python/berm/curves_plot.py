# SPDX-License-Identifier: BSD-3-Clause
"""Curves of a run: V(w) of the push, H(u) and w(u) of the drags, as in curves.png."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .errors import InputError

from .picture import DRAG_BAND, DRAG_ROWS, PUSH, PUSH_BAND, PUSH_ROWS, Unit
from .picture import add_axes, drag_color, force_unit, length_unit, new_figure, second_axis, span
from .travel import HALF_WIDTH, freed_from_noise

if TYPE_CHECKING:
    from .run import Run

MOST_NAMES = 6  # drags with a name in the key


def force_measure(run: Run) -> tuple[float, str] | None:
    """What forces per metre are shown over, N/m, and its letters: gamma' D^2 of soil with friction, D s_u of clay where the push ended.
    None where case and key results alone do not tell it: layers, profiles, ground that is not level, other laws."""
    if not (run.folder / "summary.json").exists():
        return None
    case, results, of = run.case, run.quantities, run.history.column("w").of
    contact = [each for each in case.get("contact", {}).values() if each.get("rigid") == of]
    body = case["body"].get(contact[-1].get("body"), {}) if contact else {}
    soil, mesh = case["material"].get(body.get("material"), {}), case["mesh"]
    if soil.get("law") != "mohr_coulomb":
        return None
    if soil["friction_angle"] > 0:
        for name, result in results.items():
            over = results.get(f"{name}_over_gammaD2")
            if over is not None and abs(over.value) > 0:
                return result.value / over.value, "γ′D²"
        return None
    sloping = mesh.get("slope") or "trench" in mesh or "step" in mesh
    layered = "profile" in soil or body.get("soil_layer") or body.get("region_material")
    gradient, depth = float(soil.get("cohesion_gradient", 0)), results.get("w_end_of_push")
    if sloping or layered or run.diameter is None or (gradient and depth is None):
        return None
    strength = float(soil["cohesion"]) + (gradient * depth.value if depth is not None else 0)
    return (run.diameter * strength, "D $s_u$") if strength > 0 else None


def bands_of(run: Run, chart: str) -> list[list[Any]]:
    """x, low and high of the bands of a chart (V_w, H_u, w_u) that --uncertainty found."""
    import numpy as np

    summary = run.summary if (run.folder / "summary.json").exists() else {}
    curves = summary.get("uncertainty", {}).get("curves", [])
    return [[np.array(curve[key], dtype=float) for key in ("x", "low", "high")] for curve in curves if curve["chart"] == chart]


@dataclass(frozen=True)
class Shown:
    """A run in the units of its picture. half: of the window in which noise is averaged, m; 0: there is none."""

    run: Run
    length: Unit
    force: Unit
    half: float
    measure: tuple[float, str] | None

    def label(self, axes: Any, letter: str, words: str, symbol: str, second: bool = True) -> None:
        """Names an axis, and one on the other side that has no unit."""
        of_force, D = symbol in "HV", self.run.diameter
        unit = self.force if of_force else self.length
        axes.set(**{f"{letter}label": f"{words} {symbol} ({unit.name})"})
        if second and of_force and self.measure:
            second_axis(axes, letter, 1 / (self.measure[0] * unit.per_si), f"{symbol}/({self.measure[1]})")
        if second and not of_force and D:
            second_axis(axes, letter, 1 / (D * unit.per_si), f"{symbol}/D")


def largest(parts: list[Any]) -> float:
    """Of all numbers without their sign; 0 where there are none."""
    import numpy as np

    numbers = np.abs(np.concatenate([np.ravel(part) for part in parts] + [np.zeros(1)]))
    return float(np.nanmax(numbers))


def plot_push(shown: Shown, axes: Any) -> None:
    """V over w of the way down, from the surface on."""
    push = shown.run.push
    w, V = push.w[push.w >= 0], push.V[push.w >= 0]
    length, force = shown.length.per_si, shown.force.per_si
    bands = bands_of(shown.run, "V_w")
    for x, low, high in bands:
        axes.fill_betweenx(x * length, low * force, high * force, color=PUSH_BAND, linewidth=0)
    axes.plot(V * force, w * length, color=PUSH_ROWS, linewidth=0.8)
    axes.plot(freed_from_noise(w, V, shown.half) * force, w * length, color=PUSH, linewidth=2, label="push")
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
    drags, length, force = shown.run.drags, shown.length.per_si, shown.force.per_si
    u = [drag.u * length for drag in drags]
    H, w = [drag.direction * drag.H * force for drag in drags], [drag.w * length for drag in drags]
    for axes, chart, rows, per_si in ((H_axes, "H_u", H, force), (w_axes, "w_u", w, length)):
        bands = bands_of(shown.run, chart)
        for x, low, high in bands:
            axes.fill_between(x * length, low * per_si, high * per_si, color=DRAG_BAND, linewidth=0)
        for k, drag in enumerate(drags):
            if shown.half and chart == "H_u":
                axes.plot(u[k], rows[k], color=DRAG_ROWS, linewidth=0.8, zorder=1.5)
            smooth = freed_from_noise(drag.travel, rows[k], shown.half)
            axes.plot(u[k], smooth, color=drag_color(k, len(drags)), linewidth=2, label=name_of(k, len(drags)))
        axes.set(xlim=span(u), ylim=span(rows + [side * per_si for _, *sides in bands for side in sides])[:: 1 if chart == "H_u" else -1])
    both_ways = any(drag.direction < 0 for drag in drags)
    shown.label(H_axes, "x", "horizontal displacement", "u")
    shown.label(H_axes, "y", "reaction along x" if both_ways else "horizontal resistance", "H")
    shown.label(w_axes, "x", "horizontal displacement", "u", second=False)
    shown.label(w_axes, "y", "embedment", "w")
    H_axes.legend(loc="best", frameon=False)


def plot_curves(run: Run) -> Any:
    """The figure: V(w) on the left, H(u) above w(u) on the right, or the one of them that there is."""
    push, drags, D = run.push, run.drags, run.diameter
    has_push = bool((push.w >= 0).any())
    if not has_push and not drags:
        raise InputError(f"{run.folder}: nothing has been pushed or dragged; draw columns of its history")
    half = HALF_WIDTH * D if D and run.case["method"] == "mpm" else 0.0
    travels = [push.w, *(drag.u for drag in drags)]
    forces = [push.V, *(drag.H for drag in drags), *(drag.V for drag in drags)]
    shown = Shown(run, length_unit(D or largest(travels)), force_unit(largest(forces)), half, force_measure(run))
    columns = has_push + bool(drags)
    figure = new_figure(6 * columns, 7.5)
    grid = figure.add_gridspec(2, columns)
    if has_push:
        plot_push(shown, add_axes(figure, grid[:, 0]))
    if drags:
        plot_drags(shown, add_axes(figure, grid[0, columns - 1]), add_axes(figure, grid[1, columns - 1]))
    title = run.case.get("title", run.folder.name)
    figure.suptitle(f"{title}\nthin: rows; thick: mean over ±{HALF_WIDTH:g} D" if half else title, fontsize="medium")
    return figure
