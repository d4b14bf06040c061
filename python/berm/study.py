# SPDX-License-Identifier: BSD-3-Clause
"""Studies: many runs, and what a sample of them says."""

from __future__ import annotations

import json
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .errors import InputError, RunError
from .history import imported
from .program import PathLike, call
from .run import Run

if TYPE_CHECKING:
    from numpy.typing import NDArray


class Study:
    """The output of a study with its runs."""

    def __init__(self, folder: PathLike) -> None:
        """Throws InputError where the folder holds no study, RunError where its study.json is damaged."""
        self.folder = Path(folder)
        file = self.folder / "study.json"
        if not file.is_file():
            raise InputError(f"{self.folder} holds no study: it has no study.json")
        try:
            self.rows: list[dict[str, Any]] = json.loads(file.read_text(encoding="utf-8"))["rows"]
        except (ValueError, KeyError, TypeError) as error:
            raise RunError(f"{file}: {error}") from None

    def __repr__(self) -> str:
        return f"berm.open({str(self.folder)!r})"

    def runs(self, kind: str | None = None) -> list[Run]:
        """The finished runs, all or of a kind: row (of no sample), best, low, high, draw."""
        return [Run(self.folder / row["run"]) for row in self.rows if row["finished"] and kind in (None, row["kind"])]

    def values(self, quantity: str, kind: str | None = None) -> NDArray[Any]:
        """A key result of each finished run, NaN where it has none."""
        import numpy as np

        found = [run.quantities.get(quantity) for run in self.runs(kind)]
        return np.array([q.value if q is not None else np.nan for q in found])

    def table(self) -> Any:
        """Rows with their names and key results, a pandas.DataFrame. Needs python3-pandas."""
        pandas = imported("pandas", "python3-pandas")
        finished = [row for row in self.rows if row["finished"]]
        return pandas.DataFrame(
            [
                {"name": ", ".join(row["names"]), "kind": row["kind"], **{k: q.value for k, q in run.quantities.items()}}
                for row, run in zip(finished, self.runs())
            ]
        )

    @cached_property
    def springs(self) -> dict[str, Any]:
        """Springs of the sample with low, best and high estimates, as `berm export --to json` writes them."""
        import tempfile

        with tempfile.TemporaryDirectory() as output:
            call(["export", self.folder, "--to", "json", "-o", output])
            (file,) = Path(output).rglob("springs.json")
            content: dict[str, Any] = json.loads(file.read_text(encoding="utf-8"))
            return content

    def plot_springs(self) -> Any:
        """Lateral springs, low, best and high, over the curves of all runs: a matplotlib Figure. Needs python3-matplotlib."""
        from .plots import plot_springs

        return plot_springs(self)


def study(file: PathLike, folder: PathLike, *, threads: int | None = None, quiet: bool = False) -> Study:
    """Runs a study (study.toml or its folder), several runs at a time, and returns it. Throws InputError, RunError and Stopped."""
    words: list[PathLike] = ["study", file, "-o", folder]
    words += ["--threads", str(threads)] if threads is not None else []
    call(words, quiet)
    return Study(folder)
