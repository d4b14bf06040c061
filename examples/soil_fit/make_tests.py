# SPDX-License-Identifier: BSD-3-Clause
"""Writes tests.csv, a laboratory's sheet: the rows of `berm element truth.toml -o FOLDER`, every tenth, with noise of 2 % of the largest q and of the largest volumetric
strain of each test. Usage: make_tests.py FOLDER"""

import csv
import math
import random
import sys
from pathlib import Path


def sheet(folder: Path) -> None:
    random.seed(1)
    with open("tests.csv", "w", newline="", encoding="utf-8") as file:
        out = csv.writer(file)
        out.writerow(["specimen", "eps_a (%)", "eps_v (%)", "q (kPa)", "sigma_r (kPa)", "e0"])
        for path in sorted(folder.glob("*/element.csv")):
            rows = list(csv.DictReader(path.open(encoding="utf-8")))
            engineering = lambda natural: 100 * (1 - math.exp(-float(natural)))
            most_q = max(float(row["q_Pa"]) for row in rows)
            most_v = max(abs(engineering(row["volumetric_strain"])) for row in rows)
            for n, row in enumerate(rows[::10]):
                noise = 0.02 if n else 0.0
                out.writerow(
                    [
                        path.parent.name,
                        f"{engineering(row['axial_strain']):.3f}",
                        f"{engineering(row['volumetric_strain']) + random.gauss(0, noise * most_v):.3f}",
                        f"{(float(row['q_Pa']) + random.gauss(0, noise * most_q)) / 1e3:.2f}",
                        f"{float(row['lateral_stress_Pa']) / 1e3:.1f}",
                        {"loose": 0.82, "medium": 0.74, "dense": 0.66}[path.parent.name.split("_")[0]],
                    ]
                )


sheet(Path(sys.argv[1]))
