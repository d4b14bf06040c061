# SPDX-License-Identifier: BSD-3-Clause
"""history.csv of a run: columns of numbers with their units."""

from __future__ import annotations

import csv
import importlib
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
    """Description of a column: its name in the file, its label, SI unit ("1": a bare number; None: text), meaning, and what it is of."""

    name: str
    label: str
    unit: str | None
    meaning: str
    of: str


class History:
    """The rows of a run, one array of the number of rows for each column: history["V_N_m"], or by its label, history["V"]."""

    def __init__(self, file: Path) -> None:
        """Reads a CSV file and NAME.schema.json beside it; a last line without its end is left out. Throws RunError."""
        import numpy as np

        try:
            with file.with_suffix(".schema.json").open(encoding="utf-8") as schema:
                self.columns = {column["name"]: Column(**column) for column in json.load(schema)["columns"]}
            text = file.read_text(encoding="utf-8")
            rows = list(csv.reader(text[: text.rfind("\n") + 1].splitlines()))
            names = rows[0] if rows else []
            if names != list(self.columns) or any(len(row) != len(names) for row in rows):
                raise ValueError(f"its columns are not those of {file.stem}.schema.json")
            words = [k for k, name in enumerate(names) if self.columns[name].unit is None]
            numbers = {name: np.array([float(row[k]) for row in rows[1:]]) for k, name in enumerate(names) if k not in words}
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise RunError(f"{file}: {error}") from None
        self.stage: list[str] = [row[names.index("stage")] for row in rows[1:]] if "stage" in names else [""] * (len(rows) - 1)
        self._values: dict[str, NDArray[np.float64]] = numbers

    def __len__(self) -> int:
        return len(self.stage)

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __repr__(self) -> str:
        return f"<history: {len(self)} rows of {', '.join(self.columns)}>"

    def column(self, name: str) -> Column:
        """Description of a column of numbers. Throws InputError, with those that there are."""
        if name in self._values:
            return self.columns[name]
        for column in self.columns.values():
            if column.label == name and column.name in self._values:
                return column
        raise InputError(f"the history has no column {name!r}; it has {', '.join(self._values)}")

    def __contains__(self, name: object) -> bool:
        return any(name in (column.name, column.label) for column in self.columns.values() if column.name in self._values)

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        return self._values[self.column(name).name]

    def unit(self, name: str) -> str:
        """The SI unit of a column, "1" of a bare number."""
        return self.column(name).unit or ""

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
        frame = pandas.DataFrame({name: self._values.get(name, self.stage) for name in self.columns})
        frame.attrs["units"] = {name: column.unit for name, column in self.columns.items()}
        return frame

    def to_xarray(self) -> Any:
        """An xarray.Dataset over its first column (time_s), with unit and meaning of each variable. Needs python3-xarray."""
        xarray = imported("xarray", "python3-xarray")
        over = next(iter(self._values))

        def variable(name: str) -> Any:
            column = self.columns[name]
            return (over, self._values[name], {"units": column.unit, "long_name": column.meaning})

        data = {name: variable(name) for name in self._values if name != over}
        return xarray.Dataset(data, coords={over: variable(over), "stage": (over, self.stage)})


def imported(module: str, package: str) -> Any:
    """A module that only some functions need. Throws ImportError that says how to install it; package: Debian's, "" where it has none."""
    try:
        return importlib.import_module(module)
    except ImportError:
        name = module.partition(".")[0]
        debian = f"apt-get install {package}, or " if package else ""
        raise ImportError(f"{name} is not installed: {debian}pip install {name}") from None
