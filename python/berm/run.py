# SPDX-License-Identifier: BSD-3-Clause
"""Runs: started, and what they leave."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, overload

from .errors import InputError, RunError
from .frames import Frame, frames_in
from .history import History
from .program import PathLike, call, settings

if TYPE_CHECKING:
    from .study import Study


class Quantity(NamedTuple):
    """A key result: value in SI, unit ("1": a bare number) and meaning."""

    value: float
    unit: str
    meaning: str


class Run:
    """A run folder, read when asked for and kept."""

    def __init__(self, folder: PathLike) -> None:
        """Throws InputError where the folder is not one of a run."""
        self.folder = Path(folder)
        if not (self.folder / "resolved.toml").is_file():
            raise InputError(f"{self.folder} is no run folder: it has no resolved.toml")

    def __repr__(self) -> str:
        return f"berm.open({str(self.folder)!r})"

    def _json(self, name: str) -> dict[str, Any]:
        try:
            with (self.folder / name).open(encoding="utf-8") as file:
                content = json.load(file)
        except (OSError, ValueError) as error:
            raise RunError(f"{self.folder / name}: {error}") from None
        if not isinstance(content, dict):
            raise RunError(f"{self.folder / name}: is not a table")
        return content

    @cached_property
    def summary(self) -> dict[str, Any]:
        """summary.json: quantities, timing, checks, text, warnings."""
        return self._json("summary.json")

    @property
    def quantities(self) -> dict[str, Quantity]:
        """Key results by name; a value that the run could not find is NaN."""
        entries: dict[str, dict[str, Any]] = self.summary["quantities"]
        return {
            name: Quantity(float("nan") if q.get("value") is None else float(q["value"]), q.get("unit", "1"), q.get("meaning", ""))
            for name, q in entries.items()
        }

    @property
    def finished(self) -> bool:
        """Whether the run came to the end of its last stage."""
        return bool(self.summary.get("checks", {}).get("finished", False)) if (self.folder / "summary.json").exists() else False

    @cached_property
    def history(self) -> History:
        return History(self.folder / "history.csv")

    @cached_property
    def frames(self) -> list[Frame]:
        return frames_in(self.folder)

    @cached_property
    def case(self) -> dict[str, Any]:
        """The input with all defaults."""
        with (self.folder / "resolved.toml").open("rb") as file:
            return tomllib.load(file)

    @cached_property
    def origin(self) -> dict[str, Any]:
        """origin.json: SHA-256 of input and program, when the run began and was resumed."""
        return self._json("origin.json")

    def report(self) -> Path:
        """Writes the report's page and returns its path."""
        call(["report", self.folder])
        return self.folder / "report.html"

    def plot(self) -> Any:
        """V over w of the push, and H and w over u of drags, as on the page: a matplotlib Figure. Needs python3-matplotlib."""
        from .plots import plot_curves

        return plot_curves(self)

    def plot_soil(self, frame: int = -1, field: str = "deviatoric_strain") -> Any:
        """The soil of a frame, coloured by a field (of a vector or a stress by its magnitude): a matplotlib Figure. Needs python3-matplotlib."""
        from .plots import plot_soil

        return plot_soil(self, frame, field)


@overload
def open(folder: PathLike) -> Run | Study: ...
@overload
def open(folder: PathLike, kind: type[Run]) -> Run: ...
def open(folder: PathLike, kind: type[Run] | None = None) -> Run | Study:
    """The run or the study in a folder. Throws InputError where there is neither."""
    from .study import Study

    path = Path(folder)
    if kind is None and (path / "study.json").is_file():
        return Study(path)
    return Run(path)


def run(
    case: PathLike | None = None,
    folder: PathLike | None = None,
    *,
    set: Mapping[str, Any] = {},
    threads: int | None = None,
    resume: PathLike | None = None,
    force: bool = False,
    quiet: bool = False,
) -> Run:
    """Runs a case, or resumes the run in a folder, and returns it.

    case: a TOML file. folder: where results go; else where the program puts them. set: changes to the case, {"stage.drag.velocity": "2 m/s"}. force: replaces an earlier run in
    the folder. quiet: no progress on stderr. Throws InputError, RunError and Stopped with the program's message."""
    if (case is None) == (resume is None):
        raise InputError("either a case to run or a folder to resume must be given")
    words: list[PathLike] = ["run", *(["--resume", resume] if resume is not None else [case or ""])]
    words += [word for change in settings(set) for word in ("--set", change)]
    words += ["-o", folder] if folder is not None else []
    words += ["--threads", str(threads)] if threads is not None else []
    words += ["--force"] if force else []
    call(words, quiet)
    return Run(resume or folder or default_folder(case or ""))


def default_folder(case: PathLike) -> Path:
    """Where the program puts the results of a case: out/FOLDER/NAME of FOLDER/NAME.toml."""
    file = Path(case)
    parent = re.sub(r"^\.+$", "", file.parent.name)
    return Path("out") / parent / file.stem
