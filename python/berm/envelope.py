# SPDX-License-Identifier: BSD-3-Clause
"""Yield envelopes of a pipe or footing: berm envelope."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .program import PathLike, call, options, settings
from .quantity import Quantity, quantities_in
from .table import Table, read_table


@dataclass(frozen=True)
class Envelope:
    """The envelope of a body at its position. quantities: V_max, H_max, of a footing M_max ...; published: the same by formulas, their
    source as meaning. rows: envelope.csv: the end of each probe (kind direction, swipe), then the points of the path of the swipe (path),
    with V_N_m and H_N_m, of bodies in space V_N and H_N. probes: how each ended. folder: of its pictures and runs."""

    folder: Path
    quantities: dict[str, Quantity]
    published: dict[str, Quantity]
    rows: Table
    probes: dict[str, str]

    def plot(self) -> Any:
        """V against H of the probes' ends and of the swipe: a matplotlib Figure. Needs Matplotlib."""
        from .charts_plot import plot_charts

        kinds, unit = self.rows["kind"], self.quantities["V_max"].unit
        V, H = (self.rows[f"{letter}_{unit.replace('/', '_')}"] for letter in "VH")
        curves = []
        for name, wanted, points in (("swipe", ("path",), False), ("ends of the probes", ("direction", "swipe"), True)):
            chosen = [k for k, kind in enumerate(kinds) if kind in wanted]
            curves.append({"name": name, "x": H[chosen], "y": V[chosen], "points": points})
        x, y = ({"symbol": letter, "unit": unit, "meaning": f"{word} load"} for letter, word in (("H", "lateral"), ("V", "vertical")))
        return plot_charts(f"Envelope: {self.folder.name}", [{"chart": "envelope", "x": x, "y": y, "curves": curves}])


def envelope(
    case: PathLike,
    folder: PathLike | None = None,
    *,
    set: Mapping[str, Any] = {},
    points: int | None = None,
    turns: int | None = None,
    travel: float | None = None,
    threads: int | None = None,
    runner: str | None = None,
    sbatch: str | None = None,
    pack: int | None = None,
    no_wait: bool = False,
    quiet: bool = False,
    program: PathLike | None = None,
) -> Envelope:
    """Finds the envelope of the pipe (V and H) or footing (V, H and M) of a case at its position.

    folder: where the results go; else where the program puts them. points: directions without rotation, turns: with rotation (0: none).
    travel: of each probe divided by the diameter. threads: probes at a time. runner, sbatch, pack, no_wait: on a cluster. A probe that has
    its result is not run again. Throws InputError, RunError (also where a probe failed) and Stopped."""
    into = Path(folder) if folder is not None else Path("out/envelope") / Path(case).stem
    jobs = options(threads=threads, runner=runner, sbatch=sbatch, pack=pack, no_wait=no_wait)
    own = options(points=points, turns=turns, travel=travel)
    call(["envelope", case, *settings(set), *own, *jobs, "-o", into], quiet=quiet, program=program)
    summary = json.loads((into / "summary.json").read_text(encoding="utf-8"))
    return Envelope(
        folder=into,
        quantities=quantities_in(summary["quantities"]),
        published=quantities_in({name: {**q, "meaning": q["source"]} for name, q in summary["published"].items()}),
        rows=read_table(into / "envelope.csv"),
        probes=summary["probes"],
    )
