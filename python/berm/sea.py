# SPDX-License-Identifier: BSD-3-Clause
"""Loads of a sea state on a pipe on the seabed: berm sea."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .program import PathLike, call, default_folder, options, settings


@dataclass(frozen=True)
class SeaLoads:
    """Loads and displacements of a pipe in a sea state. quantities: all numbers of summary.json, SI, NaN where there is none. By seed:
    records, loads on a pipe at rest in the whole sea state (time_s, H_N_m, V_N_m); waves, the water in its largest waves (time_s,
    water_m_s); tracks, displacements of the pipe (time_s, u_m, w_m), empty without [soil]. answer: in words."""

    folder: Path
    quantities: dict[str, float]
    records: list[Path]
    waves: list[Path]
    tracks: list[Path]
    answer: str


def sea(
    file: PathLike, folder: PathLike | None = None, *, set: Mapping[str, Any] = {}, force: bool = False, program: PathLike | None = None
) -> SeaLoads:
    """Loads of the sea state of an input of berm sea. folder: where the results and their page go; else where the program puts them. set,
    force: as of berm.run. Throws InputError and RunError."""
    into = Path(folder) if folder is not None else default_folder(file)
    call(["sea", file, *settings(set), "-o", into, *options(force=force)], program=program)
    summary = json.loads((into / "summary.json").read_text(encoding="utf-8"))

    def of_seeds(name: str) -> list[Path]:
        return sorted(into.glob(f"{name}_*.csv"), key=lambda path: int(path.stem.rsplit("_", 1)[1]))

    return SeaLoads(
        folder=into,
        quantities={name: float("nan") if q["value"] is None else float(q["value"]) for name, q in summary["quantities"].items()},
        records=of_seeds("record"),
        waves=of_seeds("waves"),
        tracks=of_seeds("track"),
        answer=summary["text"]["answer"],
    )
