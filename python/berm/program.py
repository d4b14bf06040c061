# SPDX-License-Identifier: BSD-3-Clause
"""The program berm: where it is, how it is called, and how its errors become exceptions."""

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
    """What a command printed, its messages (standard error) by line, and its exit status, which is 0 or one that was accepted."""

    text: str
    messages: list[str]
    status: int = 0

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


def options(**values: Any) -> list[PathLike]:
    """--n-kt 12 of n_kt=12: a flag where it is True, an option for each where it is a list; nothing of None and False."""
    words: list[PathLike] = []
    for name, value in values.items():
        option = "--" + name.replace("_", "-")
        if value is True:
            words.append(option)
        elif value is not None and value is not False:
            for one in value if isinstance(value, (list, tuple)) else [value]:
                words += [option, one if isinstance(one, os.PathLike) else str(one)]
    return words


def begin(arguments: Sequence[PathLike], program: PathLike | None, stdout: Any, stderr: Any) -> subprocess.Popen[str]:
    """The program as a process in a session of its own: a terminal's Ctrl-C does not reach it. Throws RunError where it cannot start."""
    words = [find_program(program), *(os.fspath(word) for word in arguments)]
    try:
        return subprocess.Popen(
            words,
            stdin=subprocess.DEVNULL,
            stdout=stdout,
            stderr=stderr,
            encoding="utf-8",
            errors="replace",
            start_new_session=True,
        )
    except OSError as error:
        raise RunError(f"{words[0]}: {error.strerror}") from None


def call(
    arguments: Sequence[PathLike], *, quiet: bool = True, accept: Sequence[int] = (), program: PathLike | None = None
) -> Answer:
    """Runs the program to its end; its messages go to stderr unless quiet. Ctrl-C is passed on, so that a run leaves a checkpoint, and a
    second one ends the program at once. accept: exit statuses besides 0 that are no errors. Throws InputError, RunError and Stopped with
    the program's own message."""
    with tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace") as printed:
        process = begin(arguments, program, printed, subprocess.PIPE)
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
        if process.returncode != 0 and process.returncode not in accept:
            raise error_of(process.returncode, messages)
        printed.seek(0)
        return Answer(printed.read(), messages, process.returncode)


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
    said: list[str] = []
    goes_on = False  # a refusal may have further lines
    for line in messages:
        if line.startswith("berm: "):
            goes_on = not line.startswith(WARNING)
        elif status != 2:
            goes_on = False
        if goes_on:
            said.append(line.removeprefix("berm: "))
    ended = f"berm was ended by {signal.Signals(-status).name}" if status < 0 else f"berm ended with status {status}"
    message = "\n".join(said) or "\n".join([ended, *[line for line in messages if line][-1:]])
    return InputError(message) if status == 2 else RunError(message)


def version(*, program: PathLike | None = None) -> str:
    """The version of the program, such as "0.1.0"."""
    return call(["--version"], program=program).text.split()[1]


def default_folder(file: PathLike) -> Path:
    """Where the program puts the results of a case or input: out/FOLDER/NAME of FOLDER/NAME.toml."""
    path = Path(os.path.normpath(file))
    return Path("out") / path.parent.name.strip(".") / path.stem
