# SPDX-License-Identifier: BSD-3-Clause
"""Runs that several tests look at. BERM names the program, BERM_SOURCE the source folder, PYTHONPATH the built package."""

import os
from pathlib import Path

import berm
import pytest

SOURCE = Path(os.environ["BERM_SOURCE"])
CASE = SOURCE / "tests" / "ranks" / "sand.toml"

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
"""


@pytest.fixture(scope="session")
def case() -> Path:
    return CASE


@pytest.fixture(scope="session")
def finished(tmp_path_factory: pytest.TempPathFactory) -> berm.Run:
    return berm.run(CASE, tmp_path_factory.mktemp("run") / "sand", threads=1, quiet=True)


@pytest.fixture(scope="session")
def sampled(tmp_path_factory: pytest.TempPathFactory) -> berm.Study:
    folder = tmp_path_factory.mktemp("study")
    (folder / "study.toml").write_text(STUDY)
    return berm.study(folder / "study.toml", folder / "out", quiet=True)
