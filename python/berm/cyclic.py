# SPDX-License-Identifier: BSD-3-Clause
"""Cyclic strength of clay for a storm: berm cyclic."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .program import PathLike, call, default_folder, options, settings


@dataclass(frozen=True)
class CyclicStrength:
    """Results of a storm on contours. strength_factor: average and cyclic shear stress at failure divided by the undrained strength.
    equivalent_cycles: of the largest load, to failure. load_multiplier: of the cyclic loads, to failure. quantities: all numbers of
    summary.json, NaN where there is none. answer: in words. material: TOML to paste into a case; "" where the input has no material."""

    folder: Path
    strength_factor: float
    equivalent_cycles: float
    load_multiplier: float
    quantities: dict[str, float]
    answer: str
    material: str


def cyclic(
    file: PathLike, folder: PathLike | None = None, *, set: Mapping[str, Any] = {}, force: bool = False, program: PathLike | None = None
) -> CyclicStrength:
    """Follows the storm of an input of berm cyclic along its contours. folder: where the results and their page go; else where the program
    puts them. set, force: as of berm.run. Throws InputError and RunError."""
    into = Path(folder) if folder is not None else default_folder(file)
    call(["cyclic", file, *settings(set), "-o", into, *options(force=force)], program=program)
    summary = json.loads((into / "summary.json").read_text(encoding="utf-8"))
    values = {name: float("nan") if q["value"] is None else float(q["value"]) for name, q in summary["quantities"].items()}
    material = into / "material.toml"
    return CyclicStrength(
        folder=into,
        strength_factor=values["strength_factor"],
        equivalent_cycles=values["equivalent_cycles"],
        load_multiplier=values["load_multiplier"],
        quantities=values,
        answer=summary["text"]["answer"],
        material=material.read_text(encoding="utf-8") if material.is_file() else "",
    )
