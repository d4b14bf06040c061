# SPDX-License-Identifier: BSD-3-Clause
"""Errors, with the messages of the program."""


class InputError(ValueError):
    """The input is wrong (exit status 2); the message names file, line, key and what is allowed."""


class RunError(RuntimeError):
    """The run failed (exit status 1), a file of it is damaged, or something that is needed is not installed."""


class Stopped(RuntimeError):
    """The run was stopped with a checkpoint (exit status 75); the message says how to resume it."""
