# SPDX-License-Identifier: BSD-3-Clause
"""What goes wrong, as the program says it."""


class InputError(ValueError):
    """The input is wrong (exit status 2); the message names file, line, key and what is allowed."""


class RunError(RuntimeError):
    """The run failed (exit status 1)."""


class Stopped(RuntimeError):
    """The run was stopped with a checkpoint (exit status 75): berm.run(resume=FOLDER) goes on."""
