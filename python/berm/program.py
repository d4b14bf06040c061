# SPDX-License-Identifier: BSD-3-Clause
"""The program berm: where it is, how it is called, and what it answers."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple, Union

from .errors import InputError, RunError, Stopped

PathLike = Union[str, "os.PathLike[str]"]
WARNING = "berm: warning: "


class Answer(NamedTuple):
    """What a command printed, and its messages (standard error) by line."""

    text: str
    messages: list[str]

    @property
    def warnings(self) -> list[str]:
        return [line[len(WARNING) :] for line in self.messages if line.startswith(WARNING)]


def find_program(program: PathLike | None = None) -> str:
    """The program: `program`, else the environment variable BERM; else that of the build folder, the source folder or the installation that
    this package lies in; else the one in PATH. Throws RunError where there is none."""
    for named, by in ((program, "program"), (os.environ.get("BERM"), "the environment variable BERM")):
        if named:
            path = shutil.which(os.fspath(named))
            if path is None:
                raise RunError(f"{os.fspath(named)}: no such program; {by} names it")
            return path
    above = Path(__file__).resolve().parents
    near = [above[2] / "berm", above[2] / "build" / "release" / "berm"]
    if len(above) > 4:
        near.append(above[4] / "bin" / "berm")
    for place in near:
        if place.is_file() and os.access(place, os.X_OK):
            return str(place)
    found = shutil.which("berm")
    if found is None:
        raise RunError("the program berm is not in PATH: install it, or name it by program= or in the environment variable BERM")
    return found


def include_folder(program: PathLike | None = None) -> Path:
    """The folder with berm/law.h, which a law of your own in C includes: that of the program's installation or source. Throws RunError
    where there is none."""
    near = Path(find_program(program)).resolve().parents
    for folder in [above / "include" for above in near[:3]]:
        if (folder / "berm" / "law.h").is_file():
            return folder
    raise RunError("there is no berm/law.h beside the program: install libberm-dev")


def toml_value(value: Any) -> str:
    """A value of Python as TOML: text, paths, numbers, truth, and lists of them, with those of NumPy and pandas. Throws InputError for
    others."""
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    elif hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(toml_value(item) for item in value) + "]"
    try:
        return repr(value) if isinstance(value, int) else repr(float(value))
    except (TypeError, ValueError):
        raise InputError(f"set: {value!r} is neither a number, text, True or False, nor a list of them") from None


def settings(changes: Mapping[str, Any]) -> list[PathLike]:
    """--set KEY=VALUE for each change."""
    return [word for key, value in changes.items() for word in ("--set", f"{key}={toml_value(value)}")]


def call(arguments: Sequence[PathLike], *, quiet: bool = True, program: PathLike | None = None) -> Answer:
    """Runs the program to its end; its messages go to stderr unless quiet. Ctrl-C is passed on, so that a run leaves a checkpoint, and a
    second one ends the program at once. Throws InputError, RunError and Stopped with the program's own message."""
    words = [find_program(program), *(os.fspath(word) for word in arguments)]
    with tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace") as printed:
        # In a session of its own: a terminal's Ctrl-C reaches it once, from here.
        try:
            process = subprocess.Popen(
                words,
                stdin=subprocess.DEVNULL,
                stdout=printed,
                stderr=subprocess.PIPE,
                encoding="utf-8",
                errors="replace",
                start_new_session=True,
            )
        except OSError as error:
            raise RunError(f"{words[0]}: {error.strerror}") from None
        messages: list[str] = []
        assert process.stderr is not None
        try:
            for line in process.stderr:
                messages.append(line.rstrip("\n"))
                if not quiet:
                    sys.stderr.write(line)
            process.wait()
        except BaseException:
            end(process)
            raise
        if process.returncode != 0:
            raise error_of(process.returncode, messages)
        printed.seek(0)
        return Answer(printed.read(), messages)


def end(process: subprocess.Popen[str]) -> None:
    """Asks the program to stop and waits until it has written its checkpoint; another Ctrl-C ends it without one."""
    process.send_signal(signal.SIGINT)
    try:
        process.communicate()
    except KeyboardInterrupt:
        process.send_signal(signal.SIGINT)
        process.communicate()


def error_of(status: int, messages: Sequence[str]) -> Exception:
    """The exception for an exit status (less than 0: the signal that ended the program), with what the program said."""
    if status == 75:
        stopped = [line[len(WARNING) :] for line in messages if line.startswith(WARNING + "stopped")]
        return Stopped("\n".join(stopped) or "stopped")
    said = [line[len("berm: ") :] for line in messages if line.startswith("berm: ") and not line.startswith(WARNING)]
    ended = f"berm was ended by {signal.Signals(-status).name}" if status < 0 else f"berm ended with status {status}"
    message = "\n".join(said) or "\n".join([ended, *[line for line in messages if line][-1:]])
    return InputError(message) if status == 2 else RunError(message)


def version(*, program: PathLike | None = None) -> str:
    """The version of the program, such as "0.1.0"."""
    return call(["--version"], program=program).text.split()[1]


def new(
    kind: str,
    file: PathLike,
    *,
    size: str | None = None,
    soil: str | None = None,
    cpt: PathLike | None = None,
    location: str | None = None,
    n_kt: float | None = None,
    phi: str | None = None,
    program: PathLike | None = None,
) -> Path:
    """Writes a commented case to begin with, as `berm new` lists them: pipe-in-sand, pipe-in-clay, ...; with the options of that command:
    size quick, normal or fine; a soil by its name; strength from a sounding. Throws InputError."""
    given = {"size": size, "soil": soil, "cpt": cpt, "location": location, "n-kt": n_kt, "phi": phi}
    options = [f"--{name}={os.fspath(v) if isinstance(v, os.PathLike) else v}" for name, v in given.items() if v is not None]
    call(["new", kind, file, *options], program=program)
    return Path(file)


def check(case: PathLike, *, set: Mapping[str, Any] = {}, program: PathLike | None = None) -> str:
    """What `berm check` says of a case: warnings, then size, memory, time. Throws InputError where it is wrong or makes no sense."""
    answer = call(["check", case, *settings(set)], program=program)
    return "".join(f"warning: {line}\n" for line in answer.warnings) + answer.text


def fmu(case: PathLike, output: PathLike, *, set: Mapping[str, Any] = {}, program: PathLike | None = None) -> list[Path]:
    """Writes the slice of soil of a case as functional mock-up units, OUTPUT.fmi2.fmu and OUTPUT.fmi3.fmu. Throws InputError."""
    return [Path(line) for line in call(["fmu", case, *settings(set), "-o", output], program=program).text.splitlines()]


def report(
    *folders: PathLike, output: PathLike | None = None, pdf: bool = False, quiet: bool = True, program: PathLike | None = None
) -> Path:
    """Writes the page of one or several runs and returns its path. Throws InputError and RunError."""
    words = ["report", *folders, *(["-o", output] if output is not None else []), *(["--pdf"] if pdf else [])]
    return Path(call(words, quiet=quiet, program=program).text.splitlines()[0])


def export(
    *folders: PathLike,
    to: str = "json",
    output: PathLike | None = None,
    state: str | None = None,
    travels: Sequence[str] = (),
    strength_ratio: float | None = None,
    ocr_exponent: float | None = None,
    consolidation: float | None = None,
    interface_angle: float | None = None,
    program: PathLike | None = None,
) -> list[Path]:
    """Springs of runs or studies for other programs (table, json, abaqus, orcaflex, ansys, sima, calculix, opensees, moordyn, buckpy), to
    FOLDER/export or `output`; of a state of the pipe (None: operation) and these drags (none: those in it). strength_ratio and what follows
    it: of clay that consolidated at the pipe, for its axial spring; the angle in degrees. Returns the files. Throws
    InputError and RunError."""
    words = ["export", *folders, "--to", to, *(["-o", output] if output is not None else [])]
    words += [*(["--state", state] if state is not None else []), *(["--travels", ",".join(travels)] if travels else [])]
    clay = {
        "strength-ratio": strength_ratio,
        "ocr-exponent": ocr_exponent,
        "consolidation": consolidation,
        "interface-angle": interface_angle,
    }
    for name, value in clay.items():
        words += [f"--{name}", str(value)] if value is not None else []
    return [Path(line) for line in call(words, program=program).text.splitlines()]


def springs(folder: PathLike, *, program: PathLike | None = None) -> list[dict[str, Any]]:
    """The springs of a run, or of each combination of a study with a sample, as `berm export --to json` writes them: N and m, None where a
    number is not known. Throws InputError and RunError."""
    with tempfile.TemporaryDirectory() as output:
        files = export(folder, to="json", output=output, program=program)
        return [json.loads(file.read_text(encoding="utf-8")) for file in files if file.suffix == ".json"]
