# SPDX-License-Identifier: BSD-3-Clause
"""The desk in a browser: berm desk."""

from __future__ import annotations

import atexit
import subprocess
import tempfile

from .program import PathLike, begin, end, error_of, options


class Desk:
    """A desk that serves a folder to browsers of this machine until stop(), or until its `with` block or the interpreter ends."""

    def __init__(self, folder: PathLike, words: list[PathLike], program: PathLike | None) -> None:
        """Use desk(). Throws InputError and RunError."""
        with tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace") as said:
            self._process = begin(["desk", folder, *words], program, subprocess.PIPE, said)
            assert self._process.stdout is not None
            self.address = self._process.stdout.readline().strip()  #: with the token that lets a browser in
            if not self.address:
                status = self._process.wait()
                self._process.stdout.close()
                said.seek(0)
                raise error_of(status, said.read().splitlines())
        atexit.register(self.stop)

    def __repr__(self) -> str:
        return f"<desk: {self.address}>"

    def __enter__(self) -> Desk:
        return self

    def __exit__(self, *error: object) -> None:
        self.stop()

    @property
    def running(self) -> bool:
        return self._process.poll() is None

    def stop(self) -> None:
        """Ends it. Its runs stop with a checkpoint."""
        atexit.unregister(self.stop)
        if self.running:
            end(self._process)


def desk(
    folder: PathLike = ".",
    *,
    port: int | None = None,
    threads: int | None = None,
    no_browser: bool = False,
    program: PathLike | None = None,
) -> Desk:
    """Opens a desk for the cases and runs of a folder in the browser and returns it; a browser of this machine opens desk.address.
    port: None, one that is free. threads: of all its runs together. Throws InputError and RunError."""
    return Desk(folder, options(port=port, threads=threads, no_browser=no_browser), program)
