# SPDX-License-Identifier: BSD-3-Clause
"""Writes t_bar.csv, the sheet of a T-bar in clay, from a run of berm.

make_t_bar.py case > FILE   a case: examples/t_bar/cyclic.toml with twelve passages
make_t_bar.py FOLDER        t_bar.csv from the results of its run: depth, 10 m more than in the run, whose clay has a pressure but no surface, and resistance V/(D/2) of half a bar"""

import csv
import re
import sys
from pathlib import Path

here = Path(__file__).parent


def case() -> str:
    times, factors, sense = ["0 s", "0.1 s"], [0, 1], 1
    for passage in range(12):
        end = 4 + 4.1 * passage
        times += [f"{end:.1f} s", f"{end + 0.2:.1f} s"]
        factors += [sense, -sense]
        sense = -sense
    text = (here.parent / "t_bar" / "cyclic.toml").read_text(encoding="utf-8")
    text = re.sub("load_times = .*", f"load_times = {times[:-1]}".replace("'", '"'), text)
    text = re.sub("load_factors = .*", f"load_factors = {factors[:-1]}", text)
    text = re.sub('file = "', f'file = "{(here.parent / "t_bar").resolve()}/', text)
    return re.sub("until.time = .*", f'until.time = "{times[-2]}"', text)


def sheet(folder: Path) -> None:
    with open(folder / "history.csv", encoding="utf-8") as history, open(here / "t_bar.csv", "w", newline="", encoding="utf-8") as file:
        out = csv.writer(file)
        out.writerow(["depth (m)", "resistance (kPa)"])
        last = None
        for row in csv.DictReader(history):
            depth, resistance = float(row["w_m"]) + 10, float(row["V_N_m"]) / 0.5 / 1e3
            if last is None or abs(depth - last) >= 0.04:
                out.writerow([f"{depth:.3f}", f"{resistance:.2f}"])
                last = depth


if sys.argv[1] == "case":
    print(case(), end="")
else:
    sheet(Path(sys.argv[1]))
