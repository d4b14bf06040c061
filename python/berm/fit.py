# SPDX-License-Identifier: BSD-3-Clause
"""Parameters of a soil from measured tests: berm fit."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .program import PathLike, call, settings
from .run import default_folder


@dataclass(frozen=True)
class Fit:
    """What came of a fit. values and errors: in SI units, by key of the material; an error is NaN where the key ended at a bound or is
    not told. correlation: by pairs of keys. misfit: root of the mean square of computed less measured, over the largest of each curve.
    doubts: what the tests do not tell. material: TOML to paste into a case."""

    folder: Path
    values: dict[str, float]
    errors: dict[str, float]
    correlation: dict[str, dict[str, float]]
    misfit: float
    doubts: list[str]
    material: str


def fit(
    file: PathLike, folder: PathLike | None = None, *, set: Mapping[str, Any] = {}, force: bool = False, program: PathLike | None = None
) -> Fit:
    """Fits the soil of an input of berm fit. folder: where the results and their page go; else where the program puts them. set, force:
    as of berm.run. Throws InputError and RunError."""
    into = Path(folder) if folder is not None else default_folder(file)
    call(["fit", file, *settings(set), "-o", into, *(["--force"] if force else [])], program=program)
    summary = json.loads((into / "summary.json").read_text(encoding="utf-8"))
    number = lambda name: float("nan") if (value := summary["quantities"][name]["value"]) is None else float(value)
    keys = list(summary["correlation"])
    return Fit(
        folder=into,
        values={key: number(key) for key in keys},
        errors={key: number(f"{key}.standard_error") for key in keys},
        correlation=summary["correlation"],
        misfit=number("misfit"),
        doubts=summary["doubts"],
        material=(into / "material.toml").read_text(encoding="utf-8"),
    )
