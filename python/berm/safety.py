# SPDX-License-Identifier: BSD-3-Clause
"""The factor of safety of a slope or of any loads: berm safety."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .program import PathLike, call, options, settings
from .table import Table, read_table


@dataclass(frozen=True)
class Safety:
    """By how much the strength can be divided until the soil fails. factor lies midway between stands, the largest factor at which the soil
    stands, and fails, the smallest at which it fails; NaN where the search did not enclose it. trials: safety.csv, a row a factor.
    warnings: reasons for doubt."""

    folder: Path
    factor: float
    stands: float
    fails: float
    trials: Table
    warnings: list[str]


def safety(
    case: PathLike,
    folder: PathLike | None = None,
    *,
    set: Mapping[str, Any] = {},
    low: float | None = None,
    high: float | None = None,
    tolerance: float | None = None,
    threads: int | None = None,
    runner: str | None = None,
    sbatch: str | None = None,
    pack: int | None = None,
    no_wait: bool = False,
    quiet: bool = False,
    program: PathLike | None = None,
) -> Safety:
    """Finds the factor of safety of a case.

    folder: where the results go; else where the program puts them. low, high: factors between which the search begins. tolerance: the
    largest difference of the two final factors. threads: trials at a time. runner, sbatch, pack, no_wait: on a cluster. Throws InputError,
    RunError and Stopped."""
    into = Path(folder) if folder is not None else Path("out/safety") / Path(case).stem
    jobs = options(threads=threads, runner=runner, sbatch=sbatch, pack=pack, no_wait=no_wait)
    own = options(low=low, high=high, tolerance=tolerance)
    call(["safety", case, *settings(set), *own, *jobs, "-o", into], quiet=quiet, program=program)
    summary = json.loads((into / "summary.json").read_text(encoding="utf-8"))

    def number(name: str) -> float:
        value = summary["quantities"].get(name, {}).get("value")
        return float("nan") if value is None else float(value)

    return Safety(
        folder=into,
        factor=number("factor_of_safety"),
        stands=number("factor_that_stands"),
        fails=number("factor_that_fails"),
        trials=read_table(into / "safety.csv"),
        warnings=list(summary.get("warnings", [])),
    )
