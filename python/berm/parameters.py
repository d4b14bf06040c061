# SPDX-License-Identifier: BSD-3-Clause
"""The parameters of a case, as the program declares them."""

from __future__ import annotations

import re
from dataclasses import dataclass

from .errors import RunError
from .program import PathLike, call


@dataclass(frozen=True)
class Parameter:
    """A key of the input: table ("mesh", "material.NAME"; "": the top), key, kind of value, SI unit ("": a bare number or text), what is
    allowed, default ("required"; "": not set), meaning, and of which choice it is a key ('kind = "seabed"'; "": of all)."""

    table: str
    key: str
    kind: str
    unit: str
    values: str
    default: str
    meaning: str
    of: str

    @property
    def path(self) -> str:
        """As `set` takes it, with a name of yours for NAME."""
        return f"{self.table}.{self.key}" if self.table else self.key


def parameters(*, program: PathLike | None = None) -> list[Parameter]:
    """All parameters of a case in the order of docs/parameters.md, from the program. Throws RunError."""
    found: list[Parameter] = []
    table, of_table, of_rows = "", "", ""
    for line in call(["params", "--markdown"], program=program).text.splitlines():
        heading = re.fullmatch(r"## (?:`\[+([^\]]+)\]+`(?:, with (.*))?|(.*))", line)
        if heading:
            table, of_table, of_rows = heading[1] or "", heading[2] or "", ""
            if heading[3] and not heading[3].startswith("The case"):
                break  # what follows is the input of other commands
        elif line.startswith("With `"):
            of_rows = line.split("`")[1]
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]] if line.startswith("| `") else []
        if len(cells) == 6:
            key, kind, unit, values, default, meaning = cells
            found.append(Parameter(table, key.strip("`"), kind, unit, values, default, meaning, of_rows or of_table))
    if not found:
        raise RunError("berm params --markdown: no table of parameters")
    return found
