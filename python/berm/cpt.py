# SPDX-License-Identifier: BSD-3-Clause
"""Layers of a cone penetration test: berm cpt."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .program import PathLike, call, default_folder, options


@dataclass(frozen=True)
class Cpt:
    """Layers of a CPT sounding. layers: those of summary.json, from the seabed down, each with top_m, base_m, zone, soil, and mean and
    deviation of each quantity, None where there is none. profile: the file of the rows. doubts: warnings about the sounding. toml:
    materials and layers to paste into a case."""

    folder: Path
    layers: list[dict[str, Any]]
    profile: Path
    doubts: list[str]
    toml: str


def cpt(
    file: PathLike,
    folder: PathLike | None = None,
    *,
    location: str | None = None,
    n_kt: float | None = None,
    phi: str | None = None,
    thinnest: float | None = None,
    force: bool = False,
    program: PathLike | None = None,
) -> Cpt:
    """Layers of a sounding. folder: where the results and their page go; else where the program puts them. location, n_kt, phi, thinnest:
    as of the command. Throws InputError and RunError."""
    into = Path(folder) if folder is not None else default_folder(file)
    call(["cpt", file, *options(location=location, n_kt=n_kt, phi=phi, thinnest=thinnest, output=into, force=force)], program=program)
    summary = json.loads((into / "summary.json").read_text(encoding="utf-8"))
    return Cpt(
        folder=into,
        layers=summary["layers"],
        profile=into / "profile.csv",
        doubts=summary["doubts"],
        toml=(into / "layers.toml").read_text(encoding="utf-8"),
    )
