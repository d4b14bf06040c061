# SPDX-License-Identifier: BSD-3-Clause
"""Runs and their results."""

from __future__ import annotations

import json
import tempfile
import tomllib
from bisect import bisect_left
from collections.abc import Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .curves import HALF_WIDTH, Drag, Push, arrays_in
from .errors import InputError, RunError
from .frames import Frame, frames_in
from .history import History, imported
from .job_charts import answering, charts_of
from .commands import export, report, springs
from .program import PathLike, call, default_folder, options, settings
from .quantity import Quantity, quantities_in
from .table import Table, read_table

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
        return quantities_in(self.summary["quantities"])

    def _by_what_they_are_of(self) -> dict[str, dict[str, Quantity]]:
        groups: dict[str, dict[str, Quantity]] = {}
        for name, quantity in self.quantities.items():
            if quantity.of:
                groups.setdefault(quantity.of, {})[name.removeprefix(f"{quantity.of}.")] = quantity
        return groups

    @cached_property
    def states(self) -> dict[str, dict[str, Quantity]]:
        """The states of a pipe (touchdown, laid, operation ...) with V and w of each: run.states["operation"]["w"]. Empty where it has
        none."""
        return {name: of for name, of in self._by_what_they_are_of().items() if f"{name}.w" in self.quantities}

    @cached_property
    def travels(self) -> dict[str, dict[str, Quantity]]:
        """Key results of each push, drag, lift or stage by the name of the stage ("push", of pushes: all together)."""
        return {name: of for name, of in self._by_what_they_are_of().items() if name not in self.states}

    def key_results(self, *, kinds: Sequence[str] = ("answer", "prescribed")) -> Any:
        """A pandas.DataFrame of key results of these kinds (answer, prescribed, ratio, quality): quantity, value (SI), unit, of (the state
        or travel), kind, meaning. Needs pandas."""
        pandas = imported("pandas", "python3-pandas")
        rows = [(name, q.value, q.unit, q.of, q.kind, q.meaning) for name, q in self.quantities.items() if q.kind in kinds]
        return pandas.DataFrame(rows, columns=["quantity", "value", "unit", "of", "kind", "meaning"])

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

    def table(self, name: str) -> Table:
        """A CSV file of the folder by its name without .csv: columns as arrays, those of words as lists. Throws RunError where the run has
        none."""
        return read_table(self.folder / f"{name}.csv")

    @cached_property
    def depth_profile(self) -> Table:
        """Forces of the soil along the depth of bodies with depth_slices: body and stage as words, z_top_m, V_N_m, axial_top_N ..., a row a
        slice at the end of a stage. Throws RunError where the run has none."""
        return self.table("depth_profile")

    @cached_property
    def tz(self) -> Table:
        """t-z curves of bodies with depth_slices that move axially. Throws RunError where the run has none."""
        return self.table("tz")

    @cached_property
    def py(self) -> Table:
        """p-y curves of a laterally loaded pile or skirt: z_m, u_at_bed_m, y_m, p_N_m. Throws RunError where the run has none."""
        return self.table("py")

    @cached_property
    def line(self) -> Table:
        """A pipeline at each frame, a row a node: time_s, stage, x_m along it, y_m lateral, z_m upwards from where it was laid, u_m along
        it, P_N (compression positive), M_Nm, strains. Throws RunError where the run has none."""
        return self.table("line")

    @cached_property
    def half_cycles(self) -> Table:
        """Each half cycle under a varying force: stage, begin_s and end_s (of the record), u_begin_m, u_end_m, w_end_m. Throws RunError
        where the run has none."""
        return self.table("half_cycles")

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
        """Penetration: w and V of pushes that load the pipe further, by row. Throws InputError where no rigid body is driven."""
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

    @cached_property
    def charts(self) -> dict[str, dict[str, Any]]:
        """The charts that plot() draws, by name: those of curves.json that have a curve, R_s of lifts, U_t of consolidation, half_cycles of
        a varying force, y_x of a pipeline."""
        return charts_of(self)

    def plot(self, *charts: str) -> Any:
        """The charts that answer the question of the run, or those that are named: a matplotlib Figure. V(w) of a push and H(u), w(u) of
        drags are as in curves.png; a lift has R(s), a laterally loaded pile H(u) and its p-y curves, a penetrometer q(z), a storm its half
        cycles, consolidation U(t), a pipeline y(x). Needs Matplotlib. Throws InputError where there is no such chart."""
        from .charts_plot import plot_charts
        from .curves_plot import Curves, plot_curves

        names = list(charts) or answering(self.charts)
        unknown = [name for name in names if name not in self.charts]
        if unknown:
            raise InputError(f"{self.folder} has no chart {', '.join(unknown)}; it has {', '.join(self.charts) or 'none'}")
        if names:
            return plot_charts(self.title, [self.charts[name] for name in names])
        if "V_w" not in self.charts and not self.drags:
            raise InputError(f"{self.folder}: nothing has been pushed, lifted or dragged; draw columns of its history")
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


def words_of_run(
    case: PathLike | None,
    folder: PathLike | None,
    *,
    set: Mapping[str, Any] = {},
    threads: int | None = None,
    resume: bool | PathLike = False,
    force: bool = False,
    more: Sequence[PathLike] = (),
) -> tuple[list[PathLike], Path]:
    """The command of run() and the folder of its results. Throws InputError."""
    words = [*options(threads=threads), *more]
    if isinstance(resume, bool):
        if case is None:
            raise InputError("either a case to run or a folder to resume must be given")
        into = Path(folder) if folder is not None else default_folder(case)
    else:
        if case is not None or folder is not None:
            raise InputError("resume: a folder is resumed without a case and another folder; resume=True continues a case")
        into = Path(resume)
    if resume and (force or (set and case is not None)):
        raise InputError("resume: a run continues with the changes that it was begun with: leave out set and force")
    if case is not None and not (resume and (into / "resolved.toml").is_file()):
        return ["run", case, *settings(set), "-o", into, *options(force=force), *words], into
    if case is not None and _bytes_of(case) != _bytes_of(into / "case.toml"):
        raise InputError(f"resume: {into} holds a run of another case than {case}: name another folder")
    return ["run", "--resume", into, *settings(set), *words], into


def run(
    case: PathLike | None = None,
    folder: PathLike | None = None,
    *,
    set: Mapping[str, Any] = {},
    threads: int | None = None,
    resume: bool | PathLike = False,
    force: bool = False,
    uncertainty: bool = False,
    strict: bool = False,
    no_programs: bool = False,
    sandbox: bool = False,
    no_sandbox: bool = False,
    quiet: bool = False,
    program: PathLike | None = None,
) -> Run:
    """Runs a case and returns its run.

    case: a TOML file. folder: where results go; else where the program puts them. set: changes, {"stage.drag.velocity": "2 m/s"}.
    resume: True continues the run of this case that the folder holds, if there is one (one that is finished is only opened); or a
    folder, without a case, whose run is continued: with set={"mesh.near_right": "3 m"} (near_left, left, length) on a longer mesh.
    force: replaces an earlier run. uncertainty: also runs on other cells and at another speed, for bands about its results. strict: an
    answer that is invalid is a RunError. no_programs: refuses a case that brings a geometry or a law; sandbox, no_sandbox: runs these so
    that they write only into the folder, or freely. quiet: no progress on stderr.
    Throws InputError, RunError and Stopped with the program's message."""
    more = options(uncertainty=uncertainty, strict=strict, no_programs=no_programs, sandbox=sandbox, no_sandbox=no_sandbox)
    words, into = words_of_run(case, folder, set=set, threads=threads, resume=resume, force=force, more=more)
    call(words, quiet=quiet, program=program)
    return Run(into)


def run_both(
    case: PathLike,
    folder: PathLike | None = None,
    *,
    set: Mapping[str, Any] = {},
    threads: int | None = None,
    force: bool = False,
    quiet: bool = False,
    program: PathLike | None = None,
) -> tuple[Run, Run]:
    """Runs a case by the material point method and by remeshed finite elements and returns both runs; the page of both lies in the folder.
    Throws InputError, RunError and Stopped."""
    words, into = words_of_run(case, folder, set=set, threads=threads, force=force, more=["--both"])
    call(words, quiet=quiet, program=program)
    return Run(into / "mpm"), Run(into / "fem")


def _bytes_of(file: PathLike) -> bytes:
    try:
        return Path(file).read_bytes()
    except OSError as error:
        raise InputError(f"{file}: {error.strerror}") from None
