# SPDX-License-Identifier: BSD-3-Clause
"""A number with its unit and meaning."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple


class Quantity(NamedTuple):
    """A key result: value in SI (NaN: not found), unit ("1": a bare number) and meaning; kind (answer, ratio, quality, prescribed) and of
    which travel or state it is ("": of the run)."""

    value: float
    unit: str
    meaning: str
    kind: str = "answer"
    of: str = ""


def quantities_in(entries: Mapping[str, Mapping[str, Any]]) -> dict[str, Quantity]:
    """Those of a summary.json by name."""
    return {
        name: Quantity(
            float("nan") if q.get("value") is None else float(q["value"]),
            q.get("unit", "1"),
            q.get("meaning", ""),
            q.get("kind", "answer"),
            q.get("of", ""),
        )
        for name, q in entries.items()
    }
