# SPDX-License-Identifier: BSD-3-Clause
"""Runs that several tests look at. BERM names the program, BERM_SOURCE the source folder, PYTHONPATH the built package."""

import os
from collections.abc import Callable
from pathlib import Path

import berm
import pytest

SOURCE = Path(os.environ["BERM_SOURCE"])
CASE = SOURCE / "tests" / "ranks" / "sand.toml"
FEM_CASE = SOURCE / "examples" / "pipe_suction" / "case.toml"

STUDY = f"""title = "friction of sand"
[[case]]
name = "pipe"
file = "{CASE}"
[sample]
size = 10
seed = 1
[[sample.parameter]]
name = "angle"
keys = ["material.sand.friction_angle"]
distribution = "normal"
low = "30 deg"
best = "33 deg"
high = "36 deg"
[[measure]]
name = "H at the end"
quantity = "H_end_of_drag"
unit = "kN/m"
scale = 0.001
"""


@pytest.fixture(scope="session")
def case() -> Path:
    return CASE


@pytest.fixture(scope="session")
def finished(tmp_path_factory: pytest.TempPathFactory) -> berm.Run:
    """A pipe pushed into sand and dragged, by the material point method; a second of one processor."""
    return berm.run(CASE, tmp_path_factory.mktemp("run") / "sand", threads=1, quiet=True)


@pytest.fixture(scope="session")
def finite_elements(tmp_path_factory: pytest.TempPathFactory) -> berm.Run:
    """A pipe wished in place in clay whose strength grows with depth; a second of one processor."""
    changes = {"stage.drag.until.displacement": "6 mm", "mesh.near_size": "120 mm", "fem.contact_size": "80 mm"}
    return berm.run(FEM_CASE, tmp_path_factory.mktemp("fem") / "clay", set=changes, threads=1, quiet=True)


@pytest.fixture(scope="session")
def study_text() -> str:
    return STUDY


@pytest.fixture(scope="session")
def sampled(tmp_path_factory: pytest.TempPathFactory) -> berm.Study:
    """Thirteen runs: best, low and high of the one parameter, and ten draws."""
    folder = tmp_path_factory.mktemp("study")
    (folder / "study.toml").write_text(STUDY)
    return berm.study(folder / "study.toml", folder / "out", threads=1, quiet=True)


@pytest.fixture
def pretended(tmp_path: Path) -> Callable[[str], Path]:
    """A program that does what a line of sh says."""

    def write(line: str) -> Path:
        file = tmp_path / "pretended"
        file.write_text(f"#!/bin/sh\n{line}\n")
        file.chmod(0o755)
        return file

    return write
