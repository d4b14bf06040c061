# SPDX-License-Identifier: BSD-3-Clause
"""Springs along a route and screening for buckling: berm route."""

from __future__ import annotations

import csv
import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .program import PathLike, call, default_folder, options, settings


@dataclass(frozen=True)
class Route:
    """Springs of a line by KP. quantities: all numbers of summary.json, SI, by "SECTION.NUMBER". rows: springs.csv, a row for each section.
    answer: in words."""

    folder: Path
    quantities: dict[str, float]
    rows: list[dict[str, str]]
    answer: str


def route(
    file: PathLike, folder: PathLike | None = None, *, set: Mapping[str, Any] = {}, force: bool = False, program: PathLike | None = None
) -> Route:
    """Springs and screening of an input of berm route. folder: where the results and their page go; else where the program puts them. set,
    force: as of berm.run. Throws InputError and RunError."""
    into = Path(folder) if folder is not None else default_folder(file)
    call(["route", file, *settings(set), "-o", into, *options(force=force)], program=program)
    summary = json.loads((into / "summary.json").read_text(encoding="utf-8"))
    with (into / "springs.csv").open(encoding="utf-8", newline="") as table:
        rows = list(csv.DictReader(table))
    return Route(
        folder=into,
        quantities={name: float(q["value"]) for name, q in summary["quantities"].items()},
        rows=rows,
        answer=summary["text"]["answer"],
    )
