# SPDX-License-Identifier: BSD-3-Clause
"""Parameters of a soil from measured tests: berm fit."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .program import PathLike, call, default_folder, options, settings


@dataclass(frozen=True)
class Fit:
    """Results of a fit. values and errors: in SI units, by key of the material; an error is NaN where the key ended at a bound or is
    not determined. correlation: by pairs of keys. misfit: root of the mean square of computed less measured, divided by the largest of each
    curve. doubts: what the tests do not determine. material: TOML to paste into a case."""

    folder: Path
    values: dict[str, float]
    errors: dict[str, float]
    correlation: dict[str, dict[str, float]]
    misfit: float
    doubts: list[str]
    material: str


def fit(
    file: PathLike,
    folder: PathLike | None = None,
    *,
    tests: Sequence[PathLike] = (),
    kind: str | None = None,
    undrained: bool = False,
    extension: bool = False,
    k0: float | None = None,
    diameter: str | None = None,
    set: Mapping[str, Any] = {},
    force: bool = False,
    program: PathLike | None = None,
) -> Fit:
    """Fits the soil of an input of berm fit; or, where tests are given, the law that `file` names to these tables, with usual numbers and
    bounds.

    folder: where the results and their page go; else where the program puts them. kind: of the tests, triaxial, simple_shear, t_bar ...;
    undrained, extension: whether they are; k0: horizontal stress divided by vertical at their start; diameter: of a T-bar or ball, "40 mm".
    set, force: as of berm.run. Throws InputError and RunError."""
    into = Path(folder) if folder is not None else default_folder(tests[-1] if tests else file)
    own = options(kind=kind, undrained=undrained, extension=extension, k0=k0, diameter=diameter)
    call(["fit", file, *tests, *own, *settings(set), "-o", into, *options(force=force)], program=program)
    summary = json.loads((into / "summary.json").read_text(encoding="utf-8"))

    def number(name: str) -> float:
        value = summary["quantities"][name]["value"]
        return float("nan") if value is None else float(value)

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
