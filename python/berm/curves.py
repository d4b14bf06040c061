# SPDX-License-Identifier: BSD-3-Clause
"""Curves of a run as curves.json has them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

HALF_WIDTH = 0.01  # of the diameter: forces are means over travel +- this, as in key results and on the page


@dataclass(frozen=True)
class Push:
    """Penetration by row: pushes before the first drag that load the pipe further. w in m, V in N/m."""

    w: NDArray[np.float64]
    V: NDArray[np.float64]


@dataclass(frozen=True)
class Drag:
    """One drag by row, from the row before it on. direction: +1 along x, -1 against it; u in m, along x from where the first drag began;
    travel in m, from its own begin along its direction; w in m; H (positive where the soil resists) and V in N/m."""

    stage: str
    direction: float
    u: NDArray[np.float64]
    travel: NDArray[np.float64]
    w: NDArray[np.float64]
    H: NDArray[np.float64]
    V: NDArray[np.float64]


def arrays_in(value: Any, name: str = "") -> Any:
    """A table of JSON with its lists of numbers, null among them, as arrays: of rows as integers, for they are indices."""
    import numpy as np

    if isinstance(value, dict):
        return {key: arrays_in(each, key) for key, each in value.items()}
    if isinstance(value, list) and not any(isinstance(each, (dict, str)) for each in value) and name not in ("curves", "bands"):
        return np.array(value, dtype=int if name == "rows" else float)
    return [arrays_in(each) for each in value] if isinstance(value, list) else value
