# SPDX-License-Identifier: BSD-3-Clause
"""Tables that the program writes as CSV files."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

from .errors import RunError
from .history import imported


class Table(dict[str, Any]):
    """Columns by their names, which end with the unit: numbers as arrays (NaN: none), words as lists."""

    def to_pandas(self) -> Any:
        """A pandas.DataFrame. Needs pandas."""
        return imported("pandas", "python3-pandas").DataFrame(dict(self))


def read_table(file: Path) -> Table:
    """A CSV file; lines that begin with # say what it is. Throws RunError where it is missing."""
    import numpy as np

    def column(cells: list[str]) -> Any:
        try:
            return np.array([float(cell) if cell else float("nan") for cell in cells])
        except ValueError:
            return cells

    try:
        lines = [line for line in file.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
        heads, *rows = csv.reader(lines)
        return Table({head: column([row[k] for row in rows]) for k, head in enumerate(heads)})
    except (OSError, ValueError, IndexError) as error:
        raise RunError(f"{file}: {error}") from None
