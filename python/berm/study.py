# SPDX-License-Identifier: BSD-3-Clause
"""Studies: many runs, and statistics of a sample of them."""

from __future__ import annotations

import csv
import json
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

from .commands import springs
from .errors import InputError, RunError
from .history import imported
from .program import PathLike, call, options
from .quantity import Quantity
from .run import Run

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

KINDS = ("row", "best", "low", "high", "draw")


@dataclass(frozen=True)
class Row:
    """A row of a study: the names of its case and of the values of its axes (but the sample), what it is in a sample (one of KINDS: "row"
    is of none), the folder of its run, and whether that is finished."""

    names: tuple[str, ...]
    kind: str
    folder: Path
    finished: bool

    @cached_property
    def run(self) -> Run:
        return Run(self.folder)


@dataclass(frozen=True)
class Estimate:
    """Statistics of a measure in a sample, in the unit of the study's table: the best run; 5, 50 and 95 % and the mean of the sample (NaN:
    not known); how many runs have a number, and how many failed."""

    names: tuple[str, ...]
    measure: str
    best: float
    low: float
    middle: float
    high: float
    mean: float
    count: int
    failed: int


class Study:
    """The output of a study with its runs."""

    def __init__(self, folder: PathLike) -> None:
        """Throws InputError where the folder holds no study, RunError where its study.json is damaged."""
        self.folder = Path(folder)
        file = self.folder / "study.json"
        if not file.is_file():
            raise InputError(f"{self.folder} holds no study: it has no study.json")
        try:
            content = json.loads(file.read_text(encoding="utf-8"))
            self.title: str = content["title"]
            self.rows = [Row(tuple(row["names"]), row["kind"], self.folder / row["run"], row["finished"]) for row in content["rows"]]
        except (ValueError, KeyError, TypeError) as error:
            raise RunError(f"{file}: {error}") from None

    def __repr__(self) -> str:
        return f"berm.open({str(self.folder)!r})"

    def rows_of(self, kind: str | None = None, names: Sequence[str] | None = None) -> list[Row]:
        """The rows of a kind and of a combination of case and axes (None: of all). Throws InputError where there can be none."""
        if kind is not None and kind not in KINDS:
            raise InputError(f"no row of a study is of kind {kind!r}; kinds are {', '.join(KINDS)}")
        if names is not None and tuple(names) not in {row.names for row in self.rows}:
            there = "; ".join(dict.fromkeys(", ".join(row.names) for row in self.rows))
            raise InputError(f"the study has no {', '.join(names)}; it has {there}")
        return [row for row in self.rows if kind in (None, row.kind) and (names is None or row.names == tuple(names))]

    def runs(self, kind: str | None = None, names: Sequence[str] | None = None) -> list[Run]:
        """The finished runs of these rows."""
        return [row.run for row in self.rows_of(kind, names) if row.finished]

    def values(self, quantity: str, kind: str | None = None, names: Sequence[str] | None = None) -> NDArray[np.float64]:
        """A key result by row: NaN of a run that did not finish or has none. Throws InputError where no run has it."""
        import numpy as np

        none = Quantity(float("nan"), "1", "")
        found = [row.run.quantities if row.finished else {} for row in self.rows_of(kind, names)]
        if not any(quantity in quantities for quantities in found):
            there = sorted({name for quantities in found for name in quantities})
            raise InputError(f"no run has the key result {quantity!r}; there are {', '.join(there)}")
        return np.array([quantities.get(quantity, none).value for quantities in found])

    @cached_property
    def sample(self) -> dict[str, list[str]]:
        """The sample as samples.csv has it: by key (and unit, in brackets) what each draw gets. Empty where the study draws none."""
        file = self.folder / "samples.csv"
        if not file.is_file():
            return {}
        with file.open(newline="", encoding="utf-8") as opened:
            heads, *rows = list(csv.reader(opened))
        return {head: [row[k] for row in rows] for k, head in enumerate(heads)}

    @cached_property
    def estimates(self) -> list[Estimate]:
        """Low, best and high of each measure of the study, of each combination: estimates.csv. Empty without a sample. Throws RunError."""
        file = self.folder / "estimates.csv"
        if not file.is_file():
            return []
        try:
            with file.open(newline="", encoding="utf-8") as opened:
                heads, *rows = list(csv.reader(opened))
            first = heads.index("measure")
            numbers = [[float(cell or "nan") for cell in row[first + 1 : first + 6]] for row in rows]
            return [
                Estimate(tuple(row[:first]), row[first], best, low, middle, high, mean, int(row[first + 6]), int(row[first + 7]))
                for row, (best, low, middle, high, mean) in zip(rows, numbers)
            ]
        except (ValueError, TypeError, IndexError) as error:
            raise RunError(f"{file}: {error}") from None

    @cached_property
    def distribution(self) -> list[dict[str, str | float]]:
        """Mean, scatter, lognormal distribution and the probability of a limit, of each measure and combination: distribution.csv, by its
        heads (NaN: not known). Empty without a sample. Throws RunError."""
        file = self.folder / "distribution.csv"
        if not file.is_file():
            return []
        try:
            with file.open(newline="", encoding="utf-8") as opened:
                heads, *rows = list(csv.reader(opened))
            first = heads.index("measure") + 1
            return [dict(zip(heads, [*row[:first], *(float(cell or "nan") for cell in row[first:])])) for row in rows]
        except ValueError as error:
            raise RunError(f"{file}: {error}") from None

    def table(self) -> Any:
        """A pandas.DataFrame with a row for each run: names, kind, what the sample gave it, key results. Needs python3-pandas."""
        pandas = imported("pandas", "python3-pandas")
        lines, draws = [], dict.fromkeys((row.names for row in self.rows), 0)
        for row in self.rows:
            line: dict[str, Any] = {"names": ", ".join(row.names), "kind": row.kind, "finished": row.finished}
            if row.kind == "draw":
                line.update({key: cells[draws[row.names]] for key, cells in self.sample.items()})
                draws[row.names] += 1
            line.update({name: q.value for name, q in row.run.quantities.items()} if row.finished else {})
            lines.append(line)
        return pandas.DataFrame(lines).apply(pandas.to_numeric, errors="ignore")

    @cached_property
    def designs(self) -> list[dict[str, Any]]:
        """Springs of each combination, with low, best and high, as `berm export --to json` writes them. Throws RunError."""
        return springs(self.folder)

    @property
    def springs(self) -> dict[str, Any]:
        """The same of a study with one combination. Throws InputError where there are several."""
        if len(self.designs) != 1:
            raise InputError(f"{self.folder} has springs of {', '.join(design['name'] for design in self.designs)}: take them from designs")
        return self.designs[0]

    def plot_springs(self) -> Any:
        """Lateral springs, low, best and high, over the curves of all runs of the sample, as in springs.png: a matplotlib Figure. Needs
        python3-matplotlib. Throws InputError where there are none."""
        from .springs_plot import Panel, plot_springs

        panels = []
        for design in self.designs:
            names = next(row.names for row in self.rows if ".".join(row.names) == design["name"])
            for stage in [lateral["stage"] for lateral in design["springs"]["best"]["lateral"]]:
                sets = {
                    name: columns_of(lateral["spring"])
                    for name, springs in design["springs"].items()
                    for lateral in springs["lateral"]
                    if lateral["stage"] == stage
                }
                scale = design["prototype_over_model"]  # a centrifuge's results are those of its prototype
                sample, best = ([computed(run, stage, scale) for run in self.runs(kind, names)] for kind in ("draw", "best"))
                panels.append(Panel(f"{design['name']}, {stage}", design["diameter_m"], sets, sample, best))
        if not panels:
            raise InputError(f"{self.folder}: its runs have no drag, so that there are no lateral springs")
        return plot_springs(panels)


def columns_of(points: Any) -> tuple[Any, Any]:
    import numpy as np

    u, H = np.array(points, dtype=float).T
    return u, H


def computed(run: Run, stage: str, scale: float) -> tuple[Any, Any]:
    """Travel and H of a drag times this scale, freed from noise; empty where the run has no such drag."""
    import numpy as np

    curves = run.curves["H_travel"]["curves"] if "H_travel" in run.curves else []
    return next(((of["x"] * scale, of["y"] * scale) for of in curves if of["name"] == stage), (np.array([]), np.array([])))


@overload
def open(folder: PathLike) -> Run | Study:
    ...


@overload
def open(folder: PathLike, kind: type[Run]) -> Run:
    ...


@overload
def open(folder: PathLike, kind: type[Study]) -> Study:
    ...


def open(folder: PathLike, kind: type[Run] | type[Study] | None = None) -> Run | Study:
    """The run or the study in a folder. Throws InputError where there is neither, or not that of `kind`."""
    if kind is None:
        kind = Study if (Path(folder) / "study.json").is_file() else Run
    return kind(folder)


def study(
    file: PathLike,
    folder: PathLike,
    *,
    threads: int | None = None,
    runner: str | None = None,
    sbatch: str | None = None,
    pack: int | None = None,
    no_wait: bool = False,
    quiet: bool = False,
    program: PathLike | None = None,
) -> Study:
    """Runs a study (study.toml or its folder), `threads` runs at a time, and returns it; what has its result already is not run again.

    runner: "slurm", or a command with {jobs}, the file with one command per line; sbatch: options of Slurm; pack: runs per Slurm task;
    no_wait: submits the runs and returns, and the same call later collects their results. Throws InputError, RunError (also where a row
    failed: open(folder) has the others) and Stopped."""
    jobs = options(threads=threads, runner=runner, sbatch=sbatch, pack=pack, no_wait=no_wait)
    call(["study", file, "-o", folder, *jobs], quiet=quiet, program=program)
    return Study(folder)
