# SPDX-License-Identifier: BSD-3-Clause
"""What `berm check` finds in a case."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from .program import PathLike, call, error_of, options, settings


@dataclass(frozen=True)
class Finding:
    """One thing that is found. level: error (the case cannot be run), warning or note. file, line, key: what it is about; line and key
    are None where it is about none. set: the key of the change that it is about, None where it is about the file. expected: words that
    are allowed there."""

    level: str
    file: str
    line: int | None
    key: str | None
    message: str
    set: str | None = None
    expected: tuple[str, ...] = ()

    def __str__(self) -> str:
        if self.level == "note":
            return self.message
        place = f"--set {self.set}" if self.set else f"{self.file}:{self.line}" if self.line else self.file
        key = self.key if self.key and not self.set else None
        return f"{self.level}: " + ": ".join(part for part in (place, key, self.message) if part)


@dataclass(frozen=True)
class Effort:
    """What a run takes: cells, nodes, particles; memory (bytes, at most), time (s, of a free machine) and disk (bytes), NaN where not
    known; lines: the same in words."""

    cells: int
    nodes: int
    particles: int
    memory: float
    time: float
    disk: float
    lines: tuple[str, ...]


class Findings(list[Finding]):
    """The findings of a case, errors first, which print as `berm check` says them. effort: None where the case is wrong."""

    effort: Effort | None = None

    def of(self, level: str) -> list[Finding]:
        """Those of a level: error, warning or note."""
        return [finding for finding in self if finding.level == level]

    @property
    def errors(self) -> list[Finding]:
        return self.of("error")

    @property
    def warnings(self) -> list[Finding]:
        return self.of("warning")

    def __str__(self) -> str:
        return "\n".join([*map(str, self), *(self.effort.lines if self.effort else ())])


def check(
    case: PathLike,
    *,
    set: Mapping[str, Any] = {},
    threads: int | None = None,
    no_programs: bool = False,
    sandbox: bool = False,
    no_sandbox: bool = False,
    program: PathLike | None = None,
) -> Findings:
    """What `berm check` says of a case: errors, warnings, notes, and what a run takes with that many threads. no_programs: a geometry or a
    law that the case brings is an error; sandbox, no_sandbox: as of run. Throws RunError and InputError where the program cannot check."""
    guards = options(threads=threads, no_programs=no_programs, sandbox=sandbox, no_sandbox=no_sandbox)
    answer = call(["check", case, *settings(set), *guards, "--json"], accept=(2,), program=program)
    if not answer.text.strip():
        raise error_of(answer.status, answer.messages)
    of_case = json.loads(answer.text)[0]
    names = ("level", "file", "line", "key", "message")
    found = Findings(
        Finding(**{name: one[name] for name in names}, set=one.get("set"), expected=tuple(one.get("expected", ())))
        for one in of_case["findings"]
    )
    if estimate := of_case["estimate"]:
        numbers = {name: float("nan") if estimate[key] is None else float(estimate[key]) for name, key in EFFORT.items()}
        found.effort = Effort(estimate["cells"], estimate["nodes"], estimate["particles"], **numbers, lines=tuple(estimate["lines"]))
    return found


EFFORT = {"memory": "memory_bytes", "time": "time_s", "disk": "disk_bytes"}
