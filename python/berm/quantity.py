# SPDX-License-Identifier: BSD-3-Clause
"""A number with its unit and meaning."""

from __future__ import annotations

from typing import NamedTuple


class Quantity(NamedTuple):
    """A key result: value in SI (NaN: not found), unit ("1": a bare number) and meaning; kind (answer, ratio, quality, prescribed) and of
    which travel or state it is ("": of the run)."""

    value: float
    unit: str
    meaning: str
    kind: str = "answer"
    of: str = ""
