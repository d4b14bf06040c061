# SPDX-License-Identifier: BSD-3-Clause
# From measured peaks and curves of Toyoura sand: the regression of the README, and curves.csv, volume.csv, peaks.csv and directions.csv for berm fit. toyoura.py FOLDER_OF_DATA FOLDER_OF_RESULTS
import csv
import math
import sys

import numpy as np

data, out = sys.argv[1:3]


def rows(name):
    with open(f"{data}/{name}") as file:
        return list(csv.DictReader(file))


# Plane strain, no end restraint: height over width at least 1, or the usual one of the first series (empty).
peaks = [r for r in rows("tatsuoka_peak.csv")
         if r["phi_peak_deg"] and r["mode"] == "plane_strain" and float(r["height_over_width"] or 2) >= 1]
e = np.array([float(r["e"]) for r in peaks])
stress = np.array([float(r["sigma3_kPa"]) for r in peaks])
phi = np.array([float(r["phi_peak_deg"]) for r in peaks])
A = np.column_stack([np.ones(len(e)), e - 0.7, np.log10(stress / 98)])
c = np.linalg.lstsq(A, phi, rcond=None)[0]
left = phi - A @ c
sd = math.sqrt(left @ left / (len(e) - 3))
error = sd * np.sqrt(np.diag(np.linalg.inv(A.T @ A)))
print(f"phi = {c[0]:.2f} ({error[0]:.2f}) + {c[1]:.1f} ({error[1]:.1f}) (e - 0.7) + {c[2]:.2f} ({error[2]:.2f}) log10(sigma3 / 98 kPa) deg;"
      f" {len(e)} tests, standard deviation {sd:.2f}, worst {abs(left).max():.2f}")

# Triaxial at 98 kPa: one slope in e, a level for each direction of sigma1 to the bedding.
tests = [r for r in rows("tatsuoka_peak.csv") if r["mode"] == "triaxial"]
directions = (90, 60, 30, 0)
A = np.array([[float(r["e"]) - 0.7] + [float(float(r["angle_sigma1_to_bedding_deg"]) == d) for d in directions] for r in tests])
t = np.linalg.lstsq(A, np.array([float(r["phi_peak_deg"]) for r in tests]), rcond=None)[0]
print("triaxial at e 0.7, 98 kPa:", ", ".join(f"{d} deg to the bedding {x:.2f}" for d, x in zip(directions, t[1:])),
      f"; along over square {t[4] / t[1]:.3f}; plane strain over triaxial {c[0] - t[1]:+.2f} deg")

# Secant to half the deviator at the peak, of the tests whose seating does not cover it; plane strain, E = (1 - nu^2) times the slope.
curves = rows("tatsuoka1986_plane_strain.csv") + [r for r in rows("lam_tatsuoka1988_curves.csv") if r["mode"] == "plane_strain"]
nu = 0.25
moduli = []
for name in ("T86_fig16a", "LT88_PSC_HW1.9"):
    curve = [r for r in curves if r["test"] == name and r["quantity"] == "sigma1_over_sigma3"]
    x, y = (np.array([float(r[k]) for r in curve]) for k in ("eps_a_percent", "value"))
    s3 = float(curve[0]["sigma3_kPa"])
    top = y.argmax()
    half = 1 + (y.max() - 1) / 2
    at = np.interp(half, y[:top + 1], x[:top + 1])
    E = (1 - nu**2) * (half - 1) * s3 / at / 10
    moduli.append(E / math.sqrt(s3 / 98))
    print(f"E50 of {name}: {E:.1f} MPa at {s3:.0f} kPa, {moduli[-1]:.1f} MPa at 98 kPa")
modulus = np.mean(moduli)


def n_gamma(degrees):
    """Rough footing, associated [Hjiaj, Lyamin and Sloan 2005]."""
    tan = math.tan(math.radians(degrees))
    return math.exp((math.pi + 3 * math.pi**2 * tan) / 6) * tan**(2 * math.pi / 5)


def in_bands(degrees, psi):
    f, p = math.radians(degrees), math.radians(psi)
    return math.degrees(math.atan(math.cos(p) * math.sin(f) / (1 - math.sin(p) * math.sin(f))))


critical = 32.5
measured = {r["test"]: 0.0 for r in rows("kimura1985_footing.csv")}
for r in rows("kimura1985_footing.csv"):
    measured[r["test"]] = max(measured[r["test"]], float(r["q_kPa"]))
for name, void, weight, share in (("V85.6", 0.652, 15.7, 1), ("H86.7", 0.648, 15.7, t[4] / t[1]), ("V64.6", 0.732, 15.0, 1),
                                  ("H61.0", 0.745, 14.8, t[4] / t[1])):
    bearing = lambda f: weight * 0.9 / 2 * n_gamma(f)
    s3 = 98.0
    for turn in range(2):
        f = share * (c[0] + c[1] * (void - 0.7) + c[2] * math.log10(s3 / 98))
        psi = (f - critical) / 0.8
        if turn == 0:
            s3 = bearing(in_bands(f, psi)) / 10 * (1 - math.sin(math.radians(f)))
    q = measured[name]
    print(f"{name}: sigma3 {s3:.1f} kPa, phi {f:.1f}, psi {psi:.1f}, phi* {in_bands(f, psi):.1f} deg, E {modulus * math.sqrt(s3 / 98):.1f} MPa,"
          f" {weight / 9.80665 * 1000:.0f} kg/m3; q / measured peak of {q:.0f} kPa: phi {bearing(f) / q:.2f}, phi* {bearing(in_bands(f, psi)) / q:.2f},"
          f" 39 deg {bearing(39) / q:.2f}, 32.5 deg {bearing(critical) / q:.2f}")

# Tests for berm fit: curves up to the peak, without seating, and single peaks with their strain.
with open(f"{out}/curves.csv", "w") as file:
    print("test,sigma3_kPa,e,eps1_percent,q_kPa", file=file)
    volume = ["test,sigma3_kPa,e,eps1_percent,eps_v_percent,q_kPa"]
    for name in dict.fromkeys(r["test"] for r in curves):
        own = [r for r in curves if r["test"] == name]
        ratio = [(float(r["eps_a_percent"]), float(r["value"])) for r in own if r["quantity"] == "sigma1_over_sigma3"]
        peak = max(ratio, key=lambda p: p[1])[0]
        head = f"{name},{own[0]['sigma3_kPa']},{own[0]['e']}"
        for x, y in [(0.0, 1.0)] + [p for p in ratio if 0 < p[0] <= peak and (p[1] > 3 or name != "T86_fig6a")]:
            print(f"{head},{x},{(y - 1) * float(own[0]['sigma3_kPa']):.2f}", file=file)
        q_at = lambda r: (np.interp(float(r["eps_a_percent"]), *zip(*ratio)) - 1) * float(r["sigma3_kPa"]) if float(r["eps_a_percent"]) else 0
        if name not in ("T86_fig16a", "T86_fig8"):
            volume += [f"{name}_v{head[len(name):]},{r['eps_a_percent']},{r['value']},{q_at(r):.2f}" for r in own if r["quantity"] == "eps_v_percent" and
                       float(r["eps_a_percent"]) <= peak + 0.5 and (name[0] == "T" or not 0 < float(r["eps_a_percent"]) < 1.4)]
with open(f"{out}/volume.csv", "w") as file:
    print("\n".join(volume), file=file)
with open(f"{out}/peaks.csv", "w") as file:
    print("test,sigma3_kPa,e,eps1_percent,q_kPa", file=file)
    for k, r in enumerate(p for p in peaks if p["eps_a_peak_percent"]):
        s3, sine = float(r["sigma3_kPa"]), math.sin(math.radians(float(r["phi_peak_deg"])))
        print(f"P{k + 1},{s3},{r['e']},0,0\nP{k + 1},{s3},{r['e']},{r['eps_a_peak_percent']},{2 * sine / (1 - sine) * s3:.2f}", file=file)
# Plane-strain peaks at e = 0.7 and 98 kPa: the level that NorSand has there with the keys of toyoura.toml, times the triaxial ratio of each direction, at the
# strain of that level. bedding.toml finds from them how the level goes with the direction.
level, strain = 45.62, 1.5
with open(f"{out}/directions.csv", "w") as file:
    print("test,sigma3_kPa,e,bedding_rad,eps1_percent,q_kPa", file=file)
    for d, x in zip(directions, t[1:]):
        sine = math.sin(math.radians(level * x / t[1]))
        for at, q in ((0, 0), (strain, 2 * sine / (1 - sine) * 98)):
            print(f"D{d},98,0.7,{math.radians(90 - d):.6f},{at},{q:.2f}", file=file)
