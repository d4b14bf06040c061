# SPDX-License-Identifier: BSD-3-Clause
"""Every command of the program and every option of it has its counterpart in the package, under the same name."""

import inspect
import re
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import berm
import pytest

# By command: the function with its options, and options that are elsewhere or nowhere, with the reason.
AS_FILE = "a case is a file here"
COUNTERPARTS: dict[str, tuple[Callable[..., Any], dict[str, str]]] = {
    "new": (berm.new, {"soils": "berm.soils()", "json": "berm.kinds() and berm.soils() read it"}),
    "draw": (berm.draw, {"stdin": AS_FILE}),
    "check": (berm.check, {"stdin": AS_FILE, "json": "what the function reads"}),
    "run": (
        berm.run,
        {"both": "berm.run_both()"} | dict.fromkeys(("runner", "sbatch", "pack", "no_wait"), "studies hand runs over: berm.study()"),
    ),
    "report": (berm.report, {}),
    "export": (berm.export, {}),
    "fmu": (berm.fmu, {}),
    "macro-element": (berm.fit_macro_element, {}),
    "study": (berm.study, {}),
    "envelope": (berm.envelope, {}),
    "safety": (berm.safety, {}),
    "element": (berm.element, {}),
    "fit": (berm.fit, {}),
    "cyclic": (berm.cyclic, {}),
    "cpt": (berm.cpt, {}),
    "sea": (berm.sea, {}),
    "route": (berm.route, {}),
    "desk": (berm.desk, {}),
    "params": (berm.parameters, {"markdown": "what the function reads", "json_schema": "for editors of cases"}),
}
NO_COUNTERPART = {
    "verify": "checks berm itself, by the examples of its source",
    "completion": "completes words in a shell",
    "man": "manual pages of the commands",
}
OUTPUTS = {"output", "folder"}  # both names of --output


def help_of(*words: str) -> str:
    return subprocess.run([berm.find_program(), *words, "--help"], capture_output=True, text=True, check=True).stdout


def commands() -> list[str]:
    listed = help_of().partition("Subcommands:")[2].partition("\n\n")[0]
    return re.findall(r"^  ([a-z-]+) ", listed, re.M)


def options_of(command: str) -> set[str]:
    found = {name.replace("-", "_") for name in re.findall(r"^  (?:-\w,)?--([a-z0-9-]+)", help_of(command), re.M)}
    return found - {"help"}


def test_every_command_has_its_function() -> None:
    assert len(commands()) > 15, "is the test blind?"
    assert sorted(commands()) == sorted([*COUNTERPARTS, *NO_COUNTERPART])


@pytest.mark.parametrize("command", COUNTERPARTS)
def test_every_option_has_its_keyword_and_every_keyword_its_option(command: str) -> None:
    function, elsewhere = COUNTERPARTS[command]
    keywords = inspect.signature(function).parameters.keys()
    options = options_of(command)
    assert elsewhere.keys() <= options, "a reason for an option that the program does not have"
    wanted = options - elsewhere.keys()
    if "output" in wanted:
        assert OUTPUTS & keywords, "--output is output or folder"
    assert wanted - {"output"} <= keywords
    own = {"program", "quiet"} | OUTPUTS
    named = {name for name in keywords if inspect.signature(function).parameters[name].kind is inspect.Parameter.KEYWORD_ONLY}
    assert named - own - wanted <= {"tests"}, "a keyword without its option"


def test_a_run_is_started_with_the_options_of_a_run() -> None:
    run, start = (inspect.signature(function).parameters for function in (berm.run, berm.start))
    assert [name for name in run if name != "quiet"] == list(start)
    assert all(run[name] == start[name] for name in start)


def test_kinds_and_soils_are_those_of_the_program(tmp_path: Path) -> None:
    kinds, soils = berm.kinds(), berm.soils()
    assert {"pipe-in-clay", "pile", "lateral-buckle"} <= {kind["kind"] for kind in kinds} and all(kind["question"] for kind in kinds)
    assert {soil["material"] for soil in soils} == {"clay", "sand"} and {name for kind in kinds for name in kind["soils"]} == {
        soil["soil"] for soil in soils
    }


def appended(message: str) -> str:
    """The lines that a refusal says to append."""
    return message[message.index("[[stage]]") :] + "\n"


@pytest.mark.parametrize("kind", [kind["kind"] for kind in berm.kinds()])
def test_a_template_becomes_a_unit_for_co_simulation_or_says_what_is_missing(kind: str, tmp_path: Path) -> None:
    """Of pipes and cables it says which stage to append, and with that stage there are units. Others are no slice across a pipe."""
    case = berm.new(kind, tmp_path / "case.toml", size="quick")
    why_not = dict.fromkeys(("anchor", "cpt", "footing", "pile", "spudcan"), "geometry") | {"slope": "rigid", "lateral-buckle": "pipeline"}
    with pytest.raises(berm.InputError) as refused:
        berm.fmu(case, tmp_path / "unit")
    if kind in why_not:
        assert f"{why_not[kind]}: FMU export needs" in str(refused.value) and "[[stage]]" not in str(refused.value)
        return
    case.write_text(case.read_text() + "\n" + appended(str(refused.value)))
    assert not berm.check(case).errors
    assert [unit.name for unit in berm.fmu(case, tmp_path / "unit")] == ["unit.fmi2.fmu", "unit.fmi3.fmu"]
