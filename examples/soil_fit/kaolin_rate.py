# SPDX-License-Identifier: BSD-3-Clause
# Strength of kaolin by rate and by overconsolidation, from the triaxial rate tests of Aarhus University (CC BY 4.0). kaolin_rate.py FOLDER_OF_DATA
import csv
import math
import sys


def rows(name):
    with open(f"{sys.argv[1]}/{name}") as file:
        return list(csv.DictReader(file))


def slope(pairs):
    """Through the origin, and the largest distance of one pair's own slope from it."""
    s = sum(x * y for x, y in pairs) / sum(x * x for x, y in pairs)
    return s, max(abs(y / x - s) for x, y in pairs)


# dq / q over the logarithm of the ratio of rates. The first step, at 1 % of strain, is left out: q still rises steeply there.
print("beta per tenfold rate, steps beyond 1.5 % of strain: soon after the step, at the end of its stage")
steps = [r for r in rows("kaolin_rate_steps.csv") if float(r["shear_strain_percent"]) > 1.5]
for test in dict.fromkeys(r["test"] for r in steps):
    own = [r for r in steps if r["test"] == test]
    decades = [math.log10(float(r["rate_after_percent_per_min"]) / float(r["rate_before_percent_per_min"])) for r in own]
    found = [slope([(d, float(r[key]) / float(r["q_before_kPa"])) for d, r in zip(decades, own)]) for key in ("dq_max_kPa", "dq_end_kPa")]
    print(f"{test}: {len(own)} steps, " + ", ".join(f"{s:.4f} (worst step {w:.4f} off)" for s, w in found))

# s_u/p0' at one rate, 0.05 %/min, by the gain that the data set says is kept (mean of before and after the peak).
print("test, soil, OCR: beta max, beta end by the data set; s_u/p0' as measured, at 0.05 %/min")
at = {}
for r in rows("kaolin_summary.csv"):
    most, end = ((float(r[f"beta_{k}_before_peak"]) + float(r[f"beta_{k}_after_peak"])) / 2 for k in ("max", "end"))
    at[r["test"]] = float(r["su_over_p0"]) * (1 + end * math.log10(0.05 / float(r["rate_reference_percent_per_min"])))
    print(f"{r['test']}, {r['soil']}, {r['OCR_nominal']}: {most:.3f}, {end:.3f}; {float(r['su_over_p0']):.3f}, {at[r['test']]:.3f}")

# The exponent of s_u/p0' = S OCR^m, by the nominal OCR and by the points of the compression stages.
largest = max(float(r["p_eff_at_t100_kPa"]) for r in rows("kaolin_compression.csv") if r["test"] == "D3")
p0 = next(float(r["p0_kPa"]) for r in rows("kaolin_summary.csv") if r["test"] == "D3")
S = (at["A7"] + at["F2"]) / 2
for ocr in (4, largest / p0):
    m = math.log(at["D3"] / S) / math.log(ocr)
    print(f"OCR of D3 {ocr:.2f}: S {S:.4f}, m {m:.3f}; s_u/p0' at OCR 2 {S * 2**m:.3f}")
for m in (0.66, 0.8, 0.9):
    print(f"m {m}: at OCR {ocr:.2f} and 4 over D3 {S * ocr**m / at['D3']:.2f}, {S * 4**m / at['D3']:.2f}; "
          f"S from D3 at OCR 4: OCR 1 over A7 and F2 {at['D3'] / 4**m / S:.2f}")
