# SPDX-License-Identifier: BSD-3-Clause
"""Pictures show what the program's own pictures show: their numbers are compared with the data that it draws (plots/)."""

import re
from pathlib import Path

import berm
import numpy as np
import pytest

pytest.importorskip("matplotlib")
from berm.picture import drag_color, round_up  # noqa: E402
from berm.soil_plot import color_range, view_around  # noqa: E402

DIGITS = 1e-5  # the program writes six


def blocks(file: Path) -> list[np.ndarray]:
    """Of a data file of gnuplot, without comments."""
    parts = re.split(r"\n\s*\n", re.sub(r"#[^\n]*", "", file.read_text()))
    return [np.array([[float(word) for word in line.split()] for line in part.strip().splitlines()]) for part in parts if part.strip()]


@pytest.mark.parametrize("which", ["finished", "finite_elements"])
def test_curves_are_those_of_the_program(which: str, request: pytest.FixtureRequest) -> None:
    run: berm.Run = request.getfixturevalue(which)
    push, drag = blocks(run.folder / "plots" / "curves.dat")
    V_of_w, H_of_u, w_of_u = run.plot().axes
    V, w = V_of_w.lines[-1].get_data()
    assert np.allclose(w, push[:, 0], rtol=DIGITS)
    assert np.allclose(
        V, push[:, 2], rtol=DIGITS, atol=DIGITS * np.nanmax(push[:, 2]), equal_nan=True
    ), "NaN where a pipe rises for a while"
    u, H = H_of_u.lines[-1].get_data()
    assert np.allclose(u, drag[:, 0], rtol=DIGITS, atol=1e-6) and np.allclose(H, drag[:, 2], rtol=DIGITS, atol=DIGITS * drag[:, 2].max())
    assert np.allclose(w_of_u.lines[-1].get_ydata(), drag[:, 4], rtol=DIGITS)
    below, above = V_of_w.get_ylim()
    assert below > above == 0, "embedment grows downwards"


@pytest.mark.parametrize("which", ["finished", "finite_elements"])
def test_forces_are_over_what_the_program_divides_them_by(which: str, request: pytest.FixtureRequest) -> None:
    run: berm.Run = request.getfixturevalue(which)
    measure = run.force_measure
    assert measure is not None and measure.unit == "N/m"
    springs = run.springs
    assert np.isclose(measure.value, springs[f"{run.summary['force_measure']['name']}_N_m"] / springs["prototype_over_model"], rtol=1e-9)
    assert measure.meaning == ("D s_u" if which == "finite_elements" else "γ′ D²")
    labels = [second.get_xlabel() for axes in run.plot().axes for second in axes.child_axes]
    assert f"V/({measure.meaning.replace('s_u', '$s_u$')})" in labels


def test_bands_of_an_uncertainty_are_under_the_curves(finished: berm.Run) -> None:
    run = berm.open(finished.folder, berm.Run)
    sides = {"x": [0, 1e-4, 2e-4], "low": [10, 20, None], "high": [20, 30, 40]}
    for chart in ("V_w", "H_u", "w_u"):
        run.curves[chart]["bands"].append({key: np.array(side, dtype=float) for key, side in sides.items()})
    assert [len(axes.collections) for axes in run.plot().axes] == [1, 1, 1]
    assert [len(axes.collections) for axes in finished.plot().axes] == [0, 0, 0]


def test_view_and_colours_are_those_of_the_program(finished: berm.Run) -> None:
    axes = finished.plot_soil().axes[0]
    disks = axes.collections[0]
    assert len(disks.get_array()) > 0
    script = (finished.folder / "plots" / "soil.gp").read_text()
    found = re.search(r"set cbrange \[(.*):(.*)\]", script)
    assert found is not None and disks.get_clim() == pytest.approx((float(found[1]), float(found[2])))
    x = re.search(r"set xrange \[(.*):(.*)\]", script)
    assert x is not None
    low, high = float(x[1]), float(x[2])
    assert axes.get_xlim() == pytest.approx((low, high), abs=1e-5 * (high - low)), "a hundredth of a pixel"


def test_a_picture_reaches_above_a_berm_but_not_up_to_grains_that_fly() -> None:
    pipe = np.array([[2.0, 0.0], [3.0, 0.0], [3.0, 1.0], [2.0, 1.0]])
    soil = np.column_stack((np.linspace(0, 5, 2001), np.append(np.linspace(-1, 1.5, 2000), 9.0)))
    lower, upper = view_around(pipe, soil)
    assert lower == pytest.approx([0.0, -1.2]) and upper == pytest.approx([5.0, 1.7], abs=0.003)
    assert view_around(pipe, soil - [0, 1])[1] == pytest.approx([5.0, 1.3]), "1.3 widths above the lowest point"


def test_soil_of_finite_elements_is_filled_and_other_fields_can_be_shown(finite_elements: berm.Run) -> None:
    figure = finite_elements.plot_soil(0, "displacement", whole=True)
    axes, bar = figure.axes
    assert bar.get_ylabel() == "size of displacement since the start (m)"
    bed = finite_elements.case["mesh"]
    assert np.ptp(axes.get_xlim()) == pytest.approx(bed["length"], rel=1e-6)
    with pytest.raises(berm.InputError, match="frame 99: there are"):
        finite_elements.plot_soil(99)
    with pytest.raises(berm.InputError, match="no field 'strain'"):
        finite_elements.plot_soil(field="strain")


def test_springs_lie_over_the_curves_of_the_sample(sampled: berm.Study) -> None:
    (axes,) = sampled.plot_springs().axes
    by_label = {line.get_label(): line for line in axes.lines}
    assert len(axes.lines) == 10 + 1 + 3 and {"low", "best", "high", "computed, best"} <= set(by_label)
    design = sampled.springs
    for name in ("low", "best", "high"):
        u, H = np.array(design["springs"][name]["lateral"][0]["spring"]).T
        assert np.allclose(by_label[name].get_xdata(), u / design["diameter_m"]) and np.allclose(by_label[name].get_ydata(), H / 1000)
    computed = np.array(design["springs"]["best"]["lateral"][0]["computed"])
    drawn = by_label["computed, best"]
    H = np.interp(computed[:, 0] / design["diameter_m"], drawn.get_xdata(), drawn.get_ydata())
    assert np.allclose(H * 1000, computed[:, 1], rtol=1e-6)


def test_a_notebook_shows_a_picture(finished: berm.Run, tmp_path: Path) -> None:
    figure = finished.plot()
    assert figure._repr_png_().startswith(b"\x89PNG")
    figure.savefig(tmp_path / "curves.svg")
    assert (tmp_path / "curves.svg").stat().st_size > 5000


def test_colours_of_drags_go_from_light_to_dark() -> None:
    assert drag_color(0, 1) == "#c8452f" and drag_color(0, 4) == "#f29c6b" and drag_color(3, 4) == "#7a122b"


def test_a_range_of_colours_begins_at_zero_and_leaves_one_point_in_a_hundred_out() -> None:
    assert [round_up(value) for value in (0.0, 0.31, 1.0, 1.2, 4100.0)] == [1, 0.4, 1, 1.5, 5000]
    assert color_range(np.append(np.linspace(0, 0.9, 500), [100.0])) == (0, 1)
    assert color_range(np.linspace(0, 1.015, 1000)) == (0, 1.5), "1.005; of two points in a hundred it were 0.995"
    assert color_range(-np.linspace(0, 0.9, 500)) == (-1, 0)
    assert color_range(np.zeros(10)) == (0, 1) and color_range(np.array([np.nan])) == (0, 1)
