# SPDX-License-Identifier: BSD-3-Clause
"""Runs: started, and what they leave."""

from __future__ import annotations

import csv
import json
import os
import tempfile
import tomllib
from bisect import bisect_left
from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .curves import HALF_WIDTH, Drag, Push, arrays_in
from .errors import InputError, RunError
from .frames import Frame, frames_in
from .history import History
from .program import PathLike, call, export, report, settings, springs
from .quantity import Quantity

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


class Run:
    """A run folder. What is read of it is read when it is asked for, and kept; of a run that goes on, open it again."""

    def __init__(self, folder: PathLike) -> None:
        """Throws InputError where the folder is not one of a run."""
        self.folder = Path(folder)
        if not (self.folder / "resolved.toml").is_file():
            inner = sorted(file.parent.name for file in self.folder.glob("*/resolved.toml"))
            why = f"it holds those of {', '.join(inner)}" if inner else "it has no resolved.toml"
            raise InputError(f"{self.folder} is not a run folder: {why}")

    def __repr__(self) -> str:
        return f"berm.open({str(self.folder)!r})"

    def _json(self, name: str) -> dict[str, Any]:
        try:
            content = json.loads((self.folder / name).read_text(encoding="utf-8"))
        except (OSError, ValueError) as error:
            raise RunError(f"{self.folder / name}: {error}") from None
        if not isinstance(content, dict):
            raise RunError(f"{self.folder / name}: is not a table")
        return content

    @cached_property
    def summary(self) -> dict[str, Any]:
        """summary.json: quantities, timing, checks, text, after --uncertainty the bands. Throws RunError where it is missing or damaged."""
        return self._json("summary.json")

    @cached_property
    def quantities(self) -> dict[str, Quantity]:
        """Key results by name."""
        entries: dict[str, dict[str, Any]] = self.summary["quantities"]
        return {
            name: Quantity(
                float("nan") if q.get("value") is None else float(q["value"]),
                q.get("unit", "1"),
                q.get("meaning", ""),
                q.get("kind", "answer"),
                q.get("of", ""),
            )
            for name, q in entries.items()
        }

    @property
    def invalid(self) -> list[str]:
        """Why its numbers are not to be used, in sentences: energy that does not balance ...; empty where nothing is wrong."""
        return list(self.summary.get("invalid", []))

    @property
    def finished(self) -> bool:
        """Whether the run came to the end of its last stage."""
        return (self.folder / "summary.json").exists() and bool(self.summary.get("checks", {}).get("finished", False))

    @cached_property
    def history(self) -> History:
        return History(self.folder / "history.csv")

    @cached_property
    def frames(self) -> list[Frame]:
        """In the order of time; none where none was written."""
        times, stages = self.history["time_s"].tolist(), self.history.stage

        def reached_in(time: float) -> str:
            return stages[min(bisect_left(times, time), len(stages) - 1)] if stages else ""

        return [Frame(time, reached_in(time), soil, rigid) for time, soil, rigid in frames_in(self.folder)]

    @cached_property
    def case(self) -> dict[str, Any]:
        """The input with all defaults, in SI units and radians; `tomllib.load` of case.toml in the folder is the input as it was given."""
        try:
            return tomllib.loads((self.folder / "resolved.toml").read_text(encoding="utf-8"))
        except (OSError, ValueError) as error:
            raise RunError(f"{self.folder / 'resolved.toml'}: {error}") from None

    def _columns(self, name: str) -> dict[str, Any]:
        """The columns of a CSV file of the folder: numbers as arrays, names as lists. Throws RunError where it is missing."""
        import numpy as np

        try:
            rows = list(csv.reader((self.folder / name).read_text(encoding="utf-8").splitlines()))
        except OSError as error:
            raise RunError(f"{self.folder / name}: {error}") from None
        columns = {head: [row[k] for row in rows[1:]] for k, head in enumerate(rows[0])}
        return {
            head: cells if head in ("body", "stage") else np.array([float(cell) if cell else float("nan") for cell in cells])
            for head, cells in columns.items()
        }

    @cached_property
    def depth_profile(self) -> dict[str, Any]:
        """Forces of the soil along the depth of bodies with depth_slices, by column of depth_profile.csv: body and stage as lists of
        names, z_top_m, V_N_m, axial_top_N ... as arrays, a row a slice at the end of a stage. Throws RunError where the run has none."""
        return self._columns("depth_profile.csv")

    @cached_property
    def tz(self) -> dict[str, Any]:
        """t-z curves of bodies with depth_slices that go up or down, by column of tz.csv. Throws RunError where the run has none."""
        return self._columns("tz.csv")

    @cached_property
    def py(self) -> dict[str, Any]:
        """p-y curves of a pile or skirt that is loaded sideways, by column of py.csv. Throws RunError where the run has none."""
        return self._columns("py.csv")

    @cached_property
    def origin(self) -> dict[str, Any]:
        """origin.json: SHA-256 of input and program, when the run began and was resumed."""
        return self._json("origin.json")

    @cached_property
    def curves(self) -> dict[str, Any]:
        """All curves of the run by chart, V_w, H_u ..., as curves.json has them, with arrays; where it is missing or of fewer rows than the
        history has, of a run that goes on or of an earlier version, the program derives them. Throws RunError where it is damaged."""
        data = self._json("curves.json") if (self.folder / "curves.json").exists() else {}
        if data.get("history_rows") != len(self.history):
            with tempfile.TemporaryDirectory() as output:
                data = json.loads(export(self.folder, to="curves", output=output)[0].read_text(encoding="utf-8"))
        try:
            return {chart["chart"]: arrays_in(chart) for chart in data["charts"]}
        except (KeyError, TypeError, ValueError) as error:
            raise RunError(f"{self.folder / 'curves.json'}: {error}") from None

    def _curves_in(self, chart: str) -> list[dict[str, Any]]:
        if chart not in self.curves:
            raise InputError(f"{self.folder}: it has no curve {chart}: no rigid body is driven")
        return list(self.curves[chart]["curves"])

    @cached_property
    def push(self) -> Push:
        """The way down: w and V of pushes that load the pipe further, by row. Throws InputError where no rigid body is driven."""
        import numpy as np

        down = [Push(curve["x"], curve["y"]) for curve in self._curves_in("V_w")]
        return down[0] if down else Push(np.zeros(0), np.zeros(0))

    @cached_property
    def drags(self) -> list[Drag]:
        """Drags and sweeps in their order: u, travel, w, H and V of each, by row. Throws InputError where no rigid body is driven."""
        drags = []
        for curve in self._curves_in("H_u"):
            direction, u, rows = float(curve["direction"]), curve["x"], curve["rows"]
            w, V = self.history["w"][rows], self.history["V"][rows]
            drags.append(Drag(curve["name"], direction, u, direction * (u - u[0]), w, direction * curve["y"], V))
        return drags

    @property
    def diameter(self) -> float | None:
        """Of the driven pipe, m; None where it is no circle, or there is none."""
        of = self.history.column("w").of if "w" in self.history else ""
        value = self.case.get("rigid", {}).get(of, {}).get("diameter")
        return None if value is None else float(value)

    @cached_property
    def force_measure(self) -> Quantity | None:
        """What forces per metre are divided by, N/m, with its letters as meaning: D s_u of clay, gamma' D^2 of other soil. None where
        summary.json has none: in space, in weightless sand, where nothing is pushed or dragged."""
        found = self.summary.get("force_measure") if (self.folder / "summary.json").exists() else None
        return Quantity(float(found["value"]), found["unit"], found["meaning"]) if found else None

    @property
    def averaging(self) -> float:
        """Half the travel over which noise is averaged, m: 0.01 D of the material point method; 0 where there is none."""
        return HALF_WIDTH * (self.diameter or 0) if self.case["method"] == "mpm" else 0.0

    @property
    def title(self) -> str:
        return str(self.case.get("title", self.folder.name))

    @cached_property
    def springs(self) -> dict[str, Any]:
        """Springs of the run, as `berm export --to json` writes them. Throws RunError where it has none."""
        return springs(self.folder)[0]

    def report(self) -> Path:
        """Writes the report's page, report.html in the folder, and returns its path."""
        return report(self.folder)

    def plot(self) -> Any:
        """V over w of the push, and H and w over u of drags, as in curves.png: a matplotlib Figure. Needs python3-matplotlib. Throws
        InputError where nothing is driven."""
        from .curves_plot import Curves, plot_curves

        if not (self.push.w >= 0).any() and not self.drags:
            raise InputError(f"{self.folder}: nothing has been pushed or dragged; draw columns of its history")
        return plot_curves(Curves(self.title, self.curves, self.diameter, self.case["method"] == "mpm", self.force_measure))

    def plot_soil(self, frame: int = -1, field: str = "deviatoric_strain", *, whole: bool = False) -> Any:
        """The soil of a frame in the plane around the rigid body (whole: all of it), coloured by a field, of a vector or a stress by its
        size: a matplotlib Figure. Needs python3-matplotlib. Throws InputError."""
        from .soil_plot import plot_soil

        if self.case["geometry"] == "space":
            raise InputError(f"{self.folder} is a run in space: berm report shows a slice of it, frames[k].to_pyvista() all")
        if not self.frames:
            raise InputError(f"{self.folder} has no frames")
        if not -len(self.frames) <= frame < len(self.frames):
            raise InputError(f"frame {frame}: there are {len(self.frames)}, 0 to {len(self.frames) - 1}")
        return plot_soil(self.frames[frame], field, self.title, self._ground(), whole)

    def _ground(self) -> NDArray[np.float64] | float:
        """The ground as it was: corners of its line of shape (corners, 2), or its level where that is the same all along, m."""
        import numpy as np

        file = self.folder / "ground.csv"
        if not file.exists():
            return float(self.case.get("surface", 0))
        try:
            return np.loadtxt(file, delimiter=",", skiprows=1, ndmin=2)
        except (OSError, ValueError) as error:
            raise RunError(f"{file}: {error}") from None


def run(
    case: PathLike | None = None,
    folder: PathLike | None = None,
    *,
    set: Mapping[str, Any] = {},
    threads: int | None = None,
    resume: bool | PathLike = False,
    force: bool = False,
    quiet: bool = False,
    program: PathLike | None = None,
) -> Run:
    """Runs a case and returns its run.

    case: a TOML file. folder: where results go; else where the program puts them. set: changes, {"stage.drag.velocity": "2 m/s"}.
    resume: True continues the run of this case that the folder holds, if there is one (one that is finished is only opened); or a
    folder, without a case, whose run is continued. force: replaces an earlier run. quiet: no progress on stderr. Throws InputError,
    RunError and Stopped with the program's message."""
    words: list[PathLike] = ["--threads", str(threads)] if threads is not None else []
    if isinstance(resume, bool):
        if case is None:
            raise InputError("either a case to run or a folder to resume must be given")
        into = Path(folder) if folder is not None else default_folder(case)
    else:
        if case is not None or folder is not None:
            raise InputError("resume: a folder is resumed without a case and another folder; resume=True continues a case")
        into = Path(resume)
    if resume and (set or force):
        raise InputError("resume: a run continues with the changes that it was begun with: leave out set and force")
    if case is not None and not (resume and (into / "resolved.toml").is_file()):
        words = ["run", case, *settings(set), "-o", into, *(["--force"] if force else []), *words]
    else:
        if case is not None and _bytes_of(case) != _bytes_of(into / "case.toml"):
            raise InputError(f"resume: {into} holds a run of another case than {case}: name another folder")
        words = ["run", "--resume", into, *words]
    call(words, quiet=quiet, program=program)
    return Run(into)


def _bytes_of(file: PathLike) -> bytes:
    try:
        return Path(file).read_bytes()
    except OSError as error:
        raise InputError(f"{file}: {error.strerror}") from None


def default_folder(case: PathLike) -> Path:
    """Where the program puts the results of a case: out/FOLDER/NAME of FOLDER/NAME.toml."""
    file = Path(os.path.normpath(case))
    return Path("out") / file.parent.name.strip(".") / file.stem
