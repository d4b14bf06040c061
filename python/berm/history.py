# SPDX-License-Identifier: BSD-3-Clause
"""history.csv of a run: columns of numbers with their units."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .errors import InputError, RunError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


@dataclass(frozen=True)
class Column:
    """What is said of a column: its name in the file, its label, SI unit ("1": a bare number), meaning, and what it is of."""

    name: str
    label: str
    unit: str | None
    meaning: str
    of: str


class History:
    """The rows of a run, one array of the number of rows for each column: history["V_N_m"], or by its label, history["V"]."""

    def __init__(self, file: Path) -> None:
        """Reads history.csv and history.schema.json beside it; a last line without its end is left out. Throws RunError."""
        import numpy as np

        try:
            with open(file.parent / "history.schema.json", encoding="utf-8") as schema:
                self.columns = {column["name"]: Column(**column) for column in json.load(schema)["columns"]}
            text = file.read_text(encoding="utf-8")
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise RunError(f"{file}: {error}") from None
        rows = list(csv.reader(text[: text.rfind("\n") + 1].splitlines()))
        names = rows[0] if rows else []
        if names != list(self.columns) or any(len(row) != len(names) for row in rows):
            raise RunError(f"{file}: its columns are not those of history.schema.json")
        self.stage: list[str] = [row[names.index("stage")] for row in rows[1:]]
        self._values: dict[str, NDArray[np.float64]] = {
            name: np.array([float(row[k]) for row in rows[1:]]) for k, name in enumerate(names) if name != "stage"
        }

    def __len__(self) -> int:
        return len(self.stage)

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def _name(self, name: str) -> str:
        if name in self._values:
            return name
        for column in self.columns.values():
            if column.label == name and column.name in self._values:
                return column.name
        raise InputError(f"the history has no column {name!r}; it has {', '.join(self._values)}")

    def __contains__(self, name: object) -> bool:
        return any(name in (column.name, column.label) for column in self.columns.values())

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        return self._values[self._name(name)]

    def unit(self, name: str) -> str:
        """The SI unit of a column, "1" of a bare number."""
        return self.columns[self._name(name)].unit or ""

    def in_stage(self, stage: str) -> NDArray[np.bool_]:
        """Which rows are of a stage. Throws InputError where none is."""
        import numpy as np

        found = np.array([name == stage for name in self.stage], dtype=bool)
        if not found.any():
            raise InputError(f"no row is of the stage {stage!r}; there are {', '.join(dict.fromkeys(self.stage))}")
        return found

    def to_pandas(self) -> Any:
        """A pandas.DataFrame with the unit of each column in its attrs. Needs python3-pandas."""
        pandas = imported("pandas", "python3-pandas")
        values: dict[str, Any] = {"stage": self.stage, **self._values}
        frame = pandas.DataFrame(values)[list(self.columns)]
        frame.attrs["units"] = {name: column.unit for name, column in self.columns.items()}
        return frame

    def to_xarray(self) -> Any:
        """An xarray.Dataset over time_s, with unit and meaning of each variable. Needs python3-xarray."""
        xarray = imported("xarray", "python3-xarray")
        data = {
            name: ("time_s", values, {"units": self.columns[name].unit, "long_name": self.columns[name].meaning})
            for name, values in self._values.items()
            if name != "time_s"
        }
        return xarray.Dataset(data, coords={"time_s": self._values["time_s"], "stage": ("time_s", self.stage)})


def imported(module: str, package: str) -> Any:
    """A module that only some functions need. Throws RunError that names its Debian package."""
    import importlib

    try:
        return importlib.import_module(module)
    except ImportError:
        raise RunError(f"{module} is not installed: apt-get install {package}") from None
