# SPDX-License-Identifier: BSD-3-Clause
"""Laboratory tests of one piece of soil: berm element."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from .history import History
from .program import PathLike, call, default_folder, options, settings


def element(
    file: PathLike,
    folder: PathLike | None = None,
    *,
    set: Mapping[str, Any] = {},
    force: bool = False,
    sandbox: bool = False,
    no_sandbox: bool = False,
    program: PathLike | None = None,
) -> dict[str, History]:
    """Runs the tests of a file and returns the rows of each by its name, as of element.csv. folder: where results and their page go; else
    where the program puts them. set, force, sandbox, no_sandbox: as of berm.run. Throws InputError and RunError."""
    into = Path(folder) if folder is not None else default_folder(file)
    call(["element", file, *settings(set), "-o", into, *options(force=force, sandbox=sandbox, no_sandbox=no_sandbox)], program=program)
    return {rows.parent.name: History(rows) for rows in sorted(into.glob("*/element.csv"))}
