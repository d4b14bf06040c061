# SPDX-License-Identifier: BSD-3-Clause
"""The macro-element of a pipe on the seabed, as `berm macro-element` fitted it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from .errors import InputError
from .program import PathLike, call, options

if TYPE_CHECKING:
    from .engine import MacroElement


def macro_element(file: str | Path) -> MacroElement:
    """The macro-element of a macro_element.json (or of the folder that holds it), with the pipe at the seabed.

    It is the C code that stands beside the file, as an object with start(w=, V=) and step(x=, u=, w=); copy.copy() gives one to try a step.
    Throws InputError where the file is no such one.
    """
    from .engine import MacroElement

    path = Path(file)
    if path.is_dir():
        path = path / "macro_element.json"
    if not path.is_file():
        raise InputError(f"{path}: there is no such file")
    try:
        text = path.read_text()
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{path}: {error}") from error
    return MacroElement(text, str(path))


def fit_macro_element(
    *runs: PathLike,
    folder: PathLike | None = None,
    check: Sequence[PathLike] = (),
    axial_friction: float | None = None,
    program: PathLike | None = None,
) -> Path:
    """Fits a macro-element to runs or studies and returns its folder, which macro_element() opens.

    folder: None, out/macro_element. check: runs that it is compared with. axial_friction: a coefficient in place of that of the runs'
    contact. Throws InputError and RunError."""
    into = Path(folder) if folder is not None else Path("out/macro_element")
    call(["macro-element", *runs, *options(check=list(check), axial_friction=axial_friction, output=into)], program=program)
    return into
