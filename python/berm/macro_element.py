# SPDX-License-Identifier: BSD-3-Clause
"""The macro-element of a pipe on the seabed, as `berm macro-element` fitted it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

from .errors import InputError

if TYPE_CHECKING:
    from .engine import MacroElement


def macro_element(file: str | Path) -> MacroElement:
    """The macro-element of a macro_element.json (or of the folder that holds it), with the pipe at the seabed.

    It is the C code that stands beside the file, as an object with start(u, w, V) and step(du, dw).
    Throws InputError where the file is no such one.
    """
    from .engine import MacroElement

    path = Path(file)
    if path.is_dir():
        path = path / "macro_element.json"
    if not path.is_file():
        raise InputError(f"{path}: there is no such file")
    try:
        parameters = {name: entry["value"] for name, entry in json.loads(path.read_text())["parameters"].items()}
        w, V = parameters.pop("backbone_w"), parameters.pop("backbone_V")
        return MacroElement(parameters, w, V)
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise InputError(f"{path}: not a macro_element.json of this version of berm: {error}") from error
