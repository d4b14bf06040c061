# SPDX-License-Identifier: BSD-3-Clause
"""The program berm: where it is, and its commands."""

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
from typing import Any, Union

from .errors import InputError, RunError, Stopped

PathLike = Union[str, "os.PathLike[str]"]


def find_program() -> str:
    """The program: the environment variable BERM, else the one in the build folder that this package lies in, else the one in PATH. Throws RunError where there is none."""
    named = os.environ.get("BERM")
    if named:
        return named
    built = Path(__file__).resolve().parents[2] / "berm"
    if built.is_file() and os.access(built, os.X_OK):
        return str(built)
    found = shutil.which("berm")
    if found is None:
        raise RunError("the program berm is not in PATH: install it, or name it in the environment variable BERM")
    return found


def toml_value(value: Any) -> str:
    """A value of Python as TOML: text, numbers, truth, and lists of them. Throws InputError for others."""
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


def settings(changes: Mapping[str, Any]) -> list[str]:
    """KEY=VALUE for each change, as --set takes it."""
    return [f"{key}={toml_value(value)}" for key, value in changes.items()]


def call(arguments: Sequence[PathLike], quiet: bool = True) -> str:
    """Runs the program and returns what it prints; messages go to stderr unless quiet. An interrupt (Ctrl-C) is passed on, so that the run leaves a checkpoint.
    Throws InputError, RunError and Stopped with the program's own message."""
    words = [find_program(), *(os.fspath(word) for word in arguments)]
    with tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace") as output:
        try:
            process = subprocess.Popen(words, stdout=output, stderr=subprocess.PIPE, text=True, errors="replace", start_new_session=True)
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
        except KeyboardInterrupt:
            process.send_signal(signal.SIGINT)
            process.stderr.close()
            process.wait()
            raise
        if process.returncode != 0:
            raise error_of(process.returncode, messages)
        output.seek(0)
        return output.read()


def error_of(status: int, messages: Sequence[str]) -> Exception:
    """The exception for an exit status, with what the program said last of all."""
    said = [line[len("berm: ") :] for line in messages if line.startswith("berm: ")]
    message = "\n".join(said) or next((line for line in reversed(messages) if line), f"berm ended with status {status}")
    if status == 2:
        return InputError(message)
    return Stopped(message) if status == 75 else RunError(message)


def version() -> str:
    """The version of the program, such as "0.1.0"."""
    return call(["--version"]).split()[1]


def check(case: PathLike, set: Mapping[str, Any] = {}) -> str:
    """What `berm check` says of a case: size, memory, time. Throws InputError where it is wrong or makes no sense."""
    return call(["check", case, *(word for change in settings(set) for word in ("--set", change))])


def report(*folders: PathLike, quiet: bool = True) -> Path:
    """Writes the page of one or several runs and returns its path."""
    printed = call(["report", *folders], quiet).split()
    return Path(printed[0])


def export(*folders: PathLike, to: str = "json", output: PathLike | None = None) -> list[Path]:
    """Springs of runs or studies for pipeline programs (table, json, abaqus, orcaflex, ansys, sima); returns the files."""
    printed = call(["export", *folders, "--to", to, *(["-o", output] if output is not None else [])])
    return [Path(line) for line in printed.splitlines()]


def parameters() -> str:
    """All parameters of a case, as a table in text."""
    return call(["params"])
