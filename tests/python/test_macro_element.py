# SPDX-License-Identifier: BSD-3-Clause
"""berm.macro_element steps the C code that berm macro-element writes."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

import berm

pytest.importorskip("berm.engine")

PARAMETERS = {
    "diameter": 0.5,
    "vertical_stiffness": 1e6,
    "horizontal_stiffness": 8e5,
    "backbone_factor": 1.2e4,
    "backbone_power": 0.5,
    "peak_ratio": 0.35,
    "surface_beta": 0.05,
    "surface_b1": 0.5,
    "surface_b2": 0.6,
    "uplift_ratio": 0.03,
    "flow_slope": 1.5,
    "flow_zero": 0.35,
    "flow_climb": 0.0,
    "first_yield": 0.6,
    "mobilisation_length": 0.01,
    "residual_ratio": 0.6,
    "softening_length": 0.2,
    "berm_rate": 0.0,
    "berm_length": 0.5,
    "berm_reach": 0.1,
}


def write(folder: Path, **changes: float) -> Path:
    parameters = {name: {"value": value} for name, value in {**PARAMETERS, **changes}.items()}
    file = folder / "macro_element.json"
    file.write_text(json.dumps({"parameters": {**parameters, "backbone_w": {"value": []}, "backbone_V": {"value": []}}}))
    return file


def test_inside_the_surface_the_force_is_the_stiffness_times_the_step(tmp_path: Path) -> None:
    pipe = berm.macro_element(write(tmp_path).parent)
    pipe.start(w=0.1, V=2000)
    H, V = pipe.step(1e-4, -2e-4)
    assert H == pytest.approx(80, abs=1e-9)
    assert V == pytest.approx(1800, abs=1e-9)
    assert pipe.stiffness == [[8e5, 0], [0, 1e6]]
    assert (pipe.u, pipe.w, pipe.H, pipe.V) == (1e-4, pytest.approx(0.0998), H, V)


def test_what_makes_no_sense_is_refused_and_the_state_stays(tmp_path: Path) -> None:
    with pytest.raises(berm.InputError, match="out of its range"):
        berm.macro_element(write(tmp_path, peak_ratio=-1))
    with pytest.raises(berm.InputError, match="no_such"):
        berm.macro_element(tmp_path / "no_such.json")
    (tmp_path / "deep.json").write_text("[" * 100_000)
    with pytest.raises(berm.InputError, match="deep.json: not a macro_element.json"):
        berm.macro_element(tmp_path / "deep.json")
    os.mkfifo(tmp_path / "pipe.json")
    with pytest.raises(berm.InputError, match="pipe.json: there is no such file"):
        berm.macro_element(tmp_path / "pipe.json")
    pipe = berm.macro_element(write(tmp_path))
    with pytest.raises(ValueError, match="displacement"):
        pipe.step(float("nan"), 0)
    assert pipe.u == 0
