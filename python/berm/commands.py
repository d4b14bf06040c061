# SPDX-License-Identifier: BSD-3-Clause
"""Commands of the program that write files: cases, drawings, pages, springs, units for co-simulations."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from .program import PathLike, call, options, settings


def new(
    kind: str,
    file: PathLike | None = None,
    *,
    size: str | None = None,
    soil: str | None = None,
    cpt: PathLike | None = None,
    location: str | None = None,
    n_kt: float | None = None,
    phi: str | None = None,
    program: PathLike | None = None,
) -> Path:
    """Writes a commented case to begin with and returns its path.

    kind: pipe-in-sand, pipe-in-clay, ..., as kinds() has them. file: where (None: KIND.toml here). size: of the cells, quick, normal or
    fine. soil: a name of soils(), in place of the clay or sand of the kind. cpt: a sounding (.ags, .gef, .csv) that gives the strength;
    location: which of an AGS file; n_kt: cone factor of clay, 5 to 30; phi: correlation of sand. Throws InputError."""
    into = Path(file) if file is not None else Path(f"{kind}.toml")
    call(["new", kind, into, *options(size=size, soil=soil, cpt=cpt, location=location, n_kt=n_kt, phi=phi)], program=program)
    return into


def kinds(*, program: PathLike | None = None) -> list[dict[str, Any]]:
    """The kinds of `new`: kind, title, group, the question that it answers, sizes, soils, example."""
    return list(json.loads(call(["new", "--json"], program=program).text))


def soils(*, program: PathLike | None = None) -> list[dict[str, Any]]:
    """The soils of `new` by name: soil, material (clay or sand), title, source, how far to trust them."""
    return list(json.loads(call(["new", "--soils", "--json"], program=program).text))


def draw(
    case: PathLike,
    output: PathLike,
    *,
    set: Mapping[str, Any] = {},
    no_programs: bool = False,
    sandbox: bool = False,
    no_sandbox: bool = False,
    program: PathLike | None = None,
) -> Path:
    """Draws the model of a case before it is run, as .svg or .png, and returns the picture. no_programs, sandbox, no_sandbox: as of run.
    Throws InputError and RunError."""
    guards = options(no_programs=no_programs, sandbox=sandbox, no_sandbox=no_sandbox)
    call(["draw", case, *settings(set), *guards, "-o", output], program=program)
    return Path(output)


def report(
    *folders: PathLike,
    output: PathLike | None = None,
    expected: PathLike | None = None,
    pdf: bool = False,
    figures: bool = False,
    quiet: bool = True,
    program: PathLike | None = None,
) -> Path:
    """Writes the page of one or several runs and returns its path. expected: a file of expected values, which stand beside the results.
    pdf: prints it, too. figures: draws its curves as SVG and PNG. Throws InputError and RunError."""
    words = ["report", *folders, *options(output=output, expected=expected, pdf=pdf, figures=figures)]
    return Path(call(words, quiet=quiet, program=program).text.splitlines()[0])


def export(
    *folders: PathLike,
    to: str = "json",
    output: PathLike | None = None,
    state: str | None = None,
    travels: Sequence[str] = (),
    units: str | None = None,
    strength_ratio: float | None = None,
    ocr_exponent: float | None = None,
    consolidation: float | None = None,
    interface_angle: float | None = None,
    program: PathLike | None = None,
) -> list[Path]:
    """Writes the springs of runs or studies for other programs (table, json, abaqus, orcaflex, ansys, sima, calculix, opensees, moordyn,
    buckpy), the shapes of a pipeline (line), its curves or those of a pile (py), all curves (curves) or a workbook (xlsx).

    output: a folder (None: FOLDER/export). state: of the pipe (None: operation). travels: these drags (none: those in that state).
    units: of a workbook, SI or imperial. strength_ratio: s_u/sigma'_v of the normally consolidated clay at the pipe, for its axial
    spring after consolidation, with the exponent of the overconsolidation ratio and the degree of consolidation, 0 to 1.
    interface_angle: of pipe and clay after many cycles, degrees. Returns the files. Throws InputError and RunError."""
    words = options(
        to=to,
        output=output,
        state=state,
        travels=",".join(travels) or None,
        units=units,
        strength_ratio=strength_ratio,
        ocr_exponent=ocr_exponent,
        consolidation=consolidation,
        interface_angle=interface_angle,
    )
    return [Path(line) for line in call(["export", *folders, *words], program=program).text.splitlines()]


def springs(folder: PathLike, *, program: PathLike | None = None) -> list[dict[str, Any]]:
    """The springs of a run, or of each combination of a study with a sample, as `berm export --to json` writes them: N and m, None where a
    number is not known. Throws InputError and RunError."""
    with tempfile.TemporaryDirectory() as output:
        files = export(folder, to="json", output=output, program=program)
        return [json.loads(file.read_text(encoding="utf-8")) for file in files if file.suffix == ".json"]


def fmu(case: PathLike, output: PathLike, *, set: Mapping[str, Any] = {}, program: PathLike | None = None) -> list[Path]:
    """Writes the slice of soil of a case as functional mock-up units, OUTPUT.fmi2.fmu and OUTPUT.fmi3.fmu, which a co-simulation drives in
    its last stage. Throws InputError, with the stage to append where the case ends with another one."""
    return [Path(line) for line in call(["fmu", case, *settings(set), "-o", output], program=program).text.splitlines()]
