# SPDX-License-Identifier: BSD-3-Clause
"""The package as a whole: what its import costs, its types, its installation, and the scripts of its page."""

import ast
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import berm
import numpy as np
import pytest

SOURCE = Path(os.environ["BERM_SOURCE"])


def python(*words: object, **options: Any) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, *map(str, words)], capture_output=True, text=True, **options)


def test_import_takes_less_than_a_fifth_of_a_second() -> None:
    script = "import time; begin = time.process_time(); import berm; print(time.process_time() - begin)"
    took = min(float(python("-c", script).stdout) for _ in range(3))
    assert took < 0.2, "of a processor; 0.03 s on the machine that this was written on"


def test_import_loads_neither_numpy_nor_what_draws() -> None:
    loaded = python("-c", "import sys, berm; print([name for name in ('numpy', 'matplotlib', 'pandas', 'xarray') if name in sys.modules])")
    assert loaded.stdout.strip() == "[]", loaded.stderr


def test_all_names_of_the_package_are_there() -> None:
    assert sorted(berm.__all__) == berm.__all__ and all(hasattr(berm, name) for name in berm.__all__)


def test_the_reference_of_the_site_has_all_names_of_the_package() -> None:
    page = (SOURCE / "docs" / "site" / "python.md.in").read_text()
    assert sorted(re.findall(r"^\.\. auto(?:function|class|exception):: berm\.(\w+)$", page, re.M)) == berm.__all__


def test_modules_import_one_another_in_one_direction() -> None:
    package = SOURCE / "python" / "berm"
    uses = {
        file.stem: {node.module for node in ast.walk(ast.parse(file.read_text())) if isinstance(node, ast.ImportFrom) and node.level == 1}
        for file in package.glob("*.py")
    }
    while leaves := [name for name, used in uses.items() if not used & uses.keys()]:
        for name in leaves:
            del uses[name]
    assert not uses, "these import one another, for types or within functions, too"


def test_types_hold() -> None:
    if python("-m", "mypy", "--version").returncode != 0:
        pytest.skip("mypy is not installed")
    folder = SOURCE / "python"
    checked = python("-m", "mypy", "--cache-dir", os.devnull, "-p", "berm", cwd=folder, env={**os.environ, "PYTHONPATH": ""})
    assert checked.returncode == 0, checked.stdout + checked.stderr


def test_it_can_be_installed_by_pip(tmp_path: Path) -> None:
    if python("-c", "import pip, setuptools, wheel").returncode != 0:
        pytest.skip("pip, setuptools or wheel is not installed")
    shutil.copytree(SOURCE / "python", tmp_path / "python")
    offline = ("--no-index", "--no-build-isolation", "--no-deps", "--root-user-action", "ignore")
    installed = python("-m", "pip", "install", "--quiet", *offline, "--target", tmp_path / "site", tmp_path / "python")
    assert installed.returncode == 0, installed.stderr
    files = {file.name for file in (tmp_path / "site" / "berm").iterdir() if file.is_file()}
    assert files == {file.name for file in (SOURCE / "python" / "berm").iterdir() if file.is_file()}
    assert (tmp_path / "site" / f"berm-{berm.__version__}.dist-info").is_dir()


def scripts() -> dict[str, str]:
    """The scripts of docs/how_to/python.md, by their heading."""
    page = (SOURCE / "docs" / "how_to" / "python.md").read_text()
    return {found[1]: found[2] for found in re.finditer(r"^## ([^\n]+)\n(?:(?!^## ).)*?^```python\n(.*?)^```", page, re.M | re.S)}


def test_low_best_and_high_take_fifteen_lines_as_the_page_has_them(sampled: berm.Study, study_text: str, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    script = scripts()["Low, best and high in fifteen lines"]
    assert len(script.splitlines()) <= 15
    # The page's study takes a minute; in its place is a small one that has run.
    (tmp_path / "examples" / "low_best_high").mkdir(parents=True)
    (tmp_path / "examples" / "low_best_high" / "study.toml").write_text(study_text)
    shutil.copytree(sampled.folder, tmp_path / "out" / "low_best_high")
    ran = python("-c", script, cwd=tmp_path)
    assert ran.returncode == 0, ran.stderr
    low, best, high = (float(number) for number in ran.stdout.split()[:3])
    lateral = {name: sampled.springs["springs"][name]["lateral"][0]["peak_N_m"] for name in ("low", "best", "high")}
    assert np.allclose([low, best, high], [lateral["low"], lateral["best"], lateral["high"]], rtol=1e-3)
    made = {file.relative_to(tmp_path / "out").as_posix() for file in (tmp_path / "out").rglob("*.*")}
    assert {"springs.png", "orcaflex/springs_low.csv", "abaqus/springs_high.inp"} <= made
