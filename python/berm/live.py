# SPDX-License-Identifier: BSD-3-Clause
"""Runs in the background: progress, stop and resume."""

from __future__ import annotations

import atexit
import os
import re
import signal
import tempfile
import threading
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from .errors import InputError, RunError
from .program import PathLike, begin, error_of, options
from .run import Run, words_of_run

LINE = re.compile(r"\S+ \S+ (.+?)  (\d+) %(?:  ([^ ].*?) left)?(?:  |$)")  # of run.log: date, time, stage, how far
SECONDS = {"ms": 1e-3, "s": 1, "min": 60, "h": 3600, "years": 365.25 * 86400}
TAIL = 6000  # bytes of the log that are looked at


class Progress(NamedTuple):
    """Progress of a run: fraction of all stages (0 to 1), the stage that it is in, time left (s, NaN: not known)."""

    fraction: float
    stage: str
    time_left: float

    def __str__(self) -> str:
        left = f", {self.time_left:.3g} s left" if self.time_left > 0 else ""
        return f"{self.stage or 'start'}: {100 * self.fraction:.0f} %{left}"


def progress_in(log: str) -> Progress | None:
    """The last line of a log with the progress of the run."""
    for line in reversed(log.splitlines()):
        if found := LINE.match(line):
            words = (found[3] or "").split()
            left = sum(float(number) * SECONDS[unit] for number, unit in zip(words[::2], words[1::2]))
            return Progress(int(found[2]) / 100, found[1], left if len(words) > 1 else float("nan"))
    return None


class LiveRun:
    """A run in the background. It is stopped, with a checkpoint, when its `with` block or the interpreter
    ends."""

    def __init__(self, words: Sequence[PathLike], folder: Path, threads: int | None, program: PathLike | None) -> None:
        """Use start(). Throws RunError where the program cannot be started."""
        self.folder = folder  #: of the run
        self._words, self._threads, self._program = words, threads, program
        self._begin(words)

    def _begin(self, words: Sequence[PathLike]) -> None:
        self._said = tempfile.TemporaryFile()
        self._process = begin(words, self._program, self._said, self._said)
        RUNNING.append(self)
        self._waiter = threading.Thread(target=self._reap, daemon=True)
        self._waiter.start()

    def _reap(self) -> None:
        self._process.wait()
        RUNNING.remove(self)

    def __repr__(self) -> str:
        return f"<run in {self.folder}: {self.progress if self.running else 'running no more'}>"

    def __enter__(self) -> LiveRun:
        return self

    def __exit__(self, *error: object) -> None:
        if self.running:
            self.stop()

    @property
    def running(self) -> bool:
        return self._waiter.is_alive()

    @property
    def progress(self) -> Progress:
        """Its progress by its log, which has a line at each new stage, tenth of the run, or half minute."""
        if not self.running and self._process.returncode == 0:
            return Progress(1, progress.stage if (progress := self._logged()) else "", 0)
        return self._logged() or Progress(0, "", float("nan"))

    def _logged(self) -> Progress | None:
        try:
            with (self.folder / "run.log").open("rb") as log:
                log.seek(max(0, log.seek(0, 2) - TAIL))
                return progress_in(log.read().decode("utf-8", errors="replace"))
        except OSError:
            return None

    @property
    def messages(self) -> list[str]:
        """Messages of the program since the start, by line."""
        size = os.fstat(self._said.fileno()).st_size
        return os.pread(self._said.fileno(), size, 0).decode("utf-8", errors="replace").splitlines()

    @property
    def now(self) -> Run:
        """The run as it is at this moment: history, frames. Throws InputError before the program has made its folder."""
        return Run(self.folder)

    def wait(self, timeout: float | None = None) -> Run:
        """Waits for the end, at most that many s, and returns the run; Ctrl-C ends the waiting, not the run. Throws TimeoutError, and as
        berm.run does InputError, RunError and Stopped."""
        self._waiter.join(timeout)
        if self.running:
            raise TimeoutError(f"{self.folder}: still running after {timeout} s")
        if self._process.returncode != 0:
            raise error_of(self._process.returncode, self.messages)
        return Run(self.folder)

    def stop(self) -> None:
        """Stops it as Ctrl-C does and waits until its checkpoint is written. Throws InputError and RunError where it had failed."""
        if self.running:
            self._process.send_signal(signal.SIGINT)
        self._waiter.join()
        if self._process.returncode not in (0, 75, -signal.SIGINT):  # the last one: before the program could leave anything
            raise error_of(self._process.returncode, self.messages)

    def resume(self) -> LiveRun:
        """Continues a stopped run from its checkpoint, or starts it where it had not begun. Throws InputError where it is still running."""
        if self.running:
            raise InputError(f"{self.folder}: the run is running")
        if self._process.returncode != -signal.SIGINT:
            self._words, _ = words_of_run(None, None, resume=self.folder, threads=self._threads)
        self._begin(self._words)
        return self


RUNNING: list[LiveRun] = []


@atexit.register
def stop_all() -> None:
    """Runs stop when the Python that started them ends."""
    for run in list(RUNNING):
        try:
            run.stop()
        except (InputError, RunError):
            pass


def start(
    case: PathLike | None = None,
    folder: PathLike | None = None,
    *,
    set: Mapping[str, Any] = {},
    threads: int | None = None,
    resume: bool | PathLike = False,
    force: bool = False,
    uncertainty: bool = False,
    strict: bool = False,
    no_programs: bool = False,
    sandbox: bool = False,
    no_sandbox: bool = False,
    program: PathLike | None = None,
) -> LiveRun:
    """Starts a run and returns at once, with an object that gives its progress and stops it. Arguments are those of run. Throws InputError
    and RunError; what the program refuses is thrown by wait()."""
    more = options(uncertainty=uncertainty, strict=strict, no_programs=no_programs, sandbox=sandbox, no_sandbox=no_sandbox)
    words, into = words_of_run(case, folder, set=set, threads=threads, resume=resume, force=force, more=more)
    return LiveRun(words, into, threads, program)
