# SPDX-License-Identifier: BSD-3-Clause
# Piles in elastic soil of a part of G0: finite elements around the axis, displacements that go as the cosine of the angle. elastic.py FOLDER_OF_DATA [PART ...]
import csv
import math
import sys

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu

steel = (210e3, 0.3)  # Young's modulus, MPa, and Poisson's ratio


def graded(breaks, growth, end):
    """Lines between elements: pieces (from, to, size), then elements that grow to `end`."""
    x = [breaks[0][0]]
    for a, b, size in breaks:
        x += list(np.linspace(a, b, max(1, round((b - a) / size)) + 1)[1:])
    step = x[-1] - x[-2]
    while x[-1] < end:
        step *= growth
        x.append(x[-1] + step)
    x[-1] = end
    return np.array(x)


class Model:
    """Elements of 8 nodes in r, z; u_r = U cos, u_z = W cos, u_theta = V sin."""

    def __init__(self, R, L, size, far, wall=None):
        inner = [(0, R - (wall or 0), size)] + ([(R - wall, R, wall)] if wall else [])
        r = graded(inner + [(R, 2 * R, size)], 1.25, far)
        z = -graded([(0, L, size), (L, L + 2 * R, size)], 1.25, far)
        self.R, self.L, self.wall = R, L, wall
        number, self.nodes = {}, []

        def node(p):
            key = (round(p[0], 9), round(p[1], 9))
            if key not in number:
                number[key] = len(self.nodes)
                self.nodes.append(key)
            return number[key]

        self.cells = []
        for j in range(len(z) - 1):
            for i in range(len(r) - 1):
                if wall is None and r[i + 1] < R + 1e-9 and z[j + 1] > -L - 1e-9:
                    continue
                a, b, c, d = r[i], r[i + 1], z[j + 1], z[j]
                corners = [(a, c), (b, c), (b, d), (a, d)]
                self.cells.append([node(p) for p in corners] +
                                  [node(((p[0] + q[0]) / 2, (p[1] + q[1]) / 2)) for p, q in zip(corners, corners[1:] + corners[:1])])
        self.nodes = np.array(self.nodes)
        self.far = far

    def stiffness(self, shear, nu):
        g = math.sqrt(1 / 3)
        rows, cols, values = [], [], []
        for cell in self.cells:
            x = self.nodes[cell]
            a, b, c, d = x[0, 0], x[1, 0], x[0, 1], x[2, 1]
            middle = ((a + b) / 2, (c + d) / 2)
            is_steel = self.wall and self.R - self.wall < middle[0] < self.R and middle[1] > -self.L
            K = np.zeros((24, 24))
            for s in (-g, g):
                for t in (-g, g):
                    rr, zz = middle[0] + s * (b - a) / 2, middle[1] + t * (d - c) / 2
                    N, ds, dt = shape(s, t)
                    dr, dz = ds * 2 / (b - a), dt * 2 / (d - c)
                    B = np.zeros((6, 24))
                    B[0, 0::3] = dr
                    B[1, 0::3] = B[1, 1::3] = N / rr
                    B[2, 2::3] = dz
                    B[3, 0::3], B[3, 2::3] = dz, dr
                    B[4, 0::3], B[4, 1::3] = -N / rr, dr - N / rr
                    B[5, 1::3], B[5, 2::3] = dz, -N / rr
                    G, v = (steel[0] / (2 + 2 * steel[1]), steel[1]) if is_steel else (shear(-zz), nu)
                    C = np.diag([2 * G, 2 * G, 2 * G, G, G, G])
                    C[:3, :3] += 2 * G * v / (1 - 2 * v)
                    K += math.pi * rr * (b - a) * (d - c) / 4 * B.T @ C @ B
            index = np.array([[3 * n, 3 * n + 1, 3 * n + 2] for n in cell]).ravel()
            rows.append(np.repeat(index, 24))
            cols.append(np.tile(index, 24))
            values.append(K.ravel())
        size = 3 * len(self.nodes)
        return coo_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(cols))), shape=(size, size)).tocsc()

    def pile(self, shear, nu):
        """K of H, M at the bed over displacement and tilt there: of a rigid pile, or of a tube with soil in it."""
        K = self.stiffness(shear, nu)
        r, z = self.nodes.T
        if self.wall is None:
            moved = (r < self.R + 1e-6) & (z > -self.L - 1e-6)
        else:
            moved = (r > self.R - self.wall - 1e-6) & (r < self.R + 1e-6) & (z > -1e-6)
        held = ((r > self.far - 1e-6) | (z < -self.far + 1e-6)) & ~moved
        axis = (r < 1e-9) & ~moved & ~held
        U = np.zeros((3 * len(r), 2))
        U[0::3, 0], U[1::3, 0] = moved, -1.0 * moved
        U[0::3, 1], U[1::3, 1], U[2::3, 1] = z * moved, -z * moved, -r * moved
        # On the axis U = -V and W = 0.
        free = np.ones(3 * len(r), bool)
        for k in range(3):
            free[k::3] = ~(moved | held)
        free[2::3] &= ~axis
        free[1::3] &= ~axis
        T = coo_matrix((np.concatenate([np.ones(3 * len(r)), -np.ones(axis.sum())]),
                        (np.concatenate([np.arange(3 * len(r)), 3 * np.flatnonzero(axis) + 1]),
                         np.concatenate([np.arange(3 * len(r)), 3 * np.flatnonzero(axis)])))).tocsc()
        K = T.T @ K @ T
        inside = np.flatnonzero(free)
        solved = splu(K[inside][:, inside]).solve(np.ascontiguousarray(-(K @ U)[inside]))
        U[inside] = solved
        return U.T @ (K @ U)


def shape(s, t):
    N, ds, dt = np.zeros(8), np.zeros(8), np.zeros(8)
    for k, (a, b) in enumerate(((-1, -1), (1, -1), (1, 1), (-1, 1))):
        N[k] = (1 + a * s) * (1 + b * t) * (a * s + b * t - 1) / 4
        ds[k] = a * (1 + b * t) * (2 * a * s + b * t) / 4
        dt[k] = b * (1 + a * s) * (a * s + 2 * b * t) / 4
    for k, b in ((4, -1), (6, 1)):
        N[k], ds[k], dt[k] = (1 - s * s) * (1 + b * t) / 2, -s * (1 + b * t), b * (1 - s * s) / 2
    for k, a in ((5, 1), (7, -1)):
        N[k], ds[k], dt[k] = (1 + a * s) * (1 - t * t) / 2, a * (1 - t * t) / 2, -t * (1 + a * s)
    return N, ds, dt


def secants(K, height):
    """H over displacement at the bed, M over tilt, and the depth of no displacement."""
    v, tilt = np.linalg.solve(K, [1, height])
    return 1 / v, height / tilt, v / tilt


def mindlin(R, L, nu):
    """The same K of a rigid pile for G = 1 at all depths, by rings of Mindlin's (1936) forces inside it that move its surface as one body."""
    turn = (np.arange(24) + 0.5) * math.pi / 12
    inner, m = 0.85, 40
    bottom = L - (1 - inner) * R
    rings = [(inner * R, bottom * z) for z in (1 - np.cos(np.linspace(0, math.pi, m))) / 2] + [(inner * R * t, bottom) for t in (0.8, 0.6, 0.4, 0.2)]
    surface = [(R, L * z) for z in (1 - np.cos(np.linspace(0, math.pi, 2 * m))) / 2] + [(R * t, L) for t in np.linspace(0.05, 0.98, 14)]
    source = np.array([(r * math.cos(t), r * math.sin(t), z) for r, z in rings for t in turn])
    x = np.array([(r * math.cos(t), r * math.sin(t), z) for r, z in surface for t in (0, math.pi / 2)])
    X, Y = (x[:, None, k] - source[None, :, k] for k in (0, 1))
    z, c = x[:, None, 2], source[None, :, 2]
    R1, R2 = np.sqrt(X**2 + Y**2 + (z - c)**2), np.sqrt(X**2 + Y**2 + (z + c)**2)
    k, q, s = 3 - 4 * nu, 4 * (1 - nu) * (1 - 2 * nu), R2 + z + c
    along = lambda X: k / R1 + 1 / R2 + X**2 / R1**3 + k * X**2 / R2**3 + 2 * c * z / R2**3 * (1 - 3 * X**2 / R2**2) + q / s * (1 - X**2 / (R2 * s))
    across = X * Y * (1 / R1**3 + k / R2**3 - 6 * c * z / R2**5 - q / (R2 * s**2))
    down = (z - c) / R1**3 + k * (z - c) / R2**3 - 6 * c * z * (z + c) / R2**5 + q / (R2 * s)
    out = (z - c) / R1**3 + k * (z - c) / R2**3 - q / (R2 * s) + 6 * c * z * (z + c) / R2**5
    sink = (k / R1 + (8 * (1 - nu)**2 - k) / R2 + (z - c)**2 / R1**3 + (k * (z + c)**2 - 2 * c * z) / R2**3 + 6 * c * z * (z + c)**2 / R2**5)
    u = np.array([[along(X), across, X * out], [across, along(Y), Y * out], [X * down, Y * down, sink]]) / (16 * math.pi * (1 - nu))
    u = u.reshape(3, 3, len(x), len(rings), 24)
    cos, sin = np.cos(turn), np.sin(turn)
    parts = [np.array(p) for p in ((cos * cos, cos * sin, 0 * cos), (-sin * sin, sin * cos, 0 * cos), (0 * cos, 0 * cos, cos))]
    A = np.stack([np.einsum("ijxsn,jn->xis", u, p / 24) for p in parts], -1).reshape(3 * len(x), -1)
    K = np.zeros((2, 2))
    for mode in (0, 1):
        moved = np.zeros((len(x), 3))
        moved[:, 0] = 1 if mode == 0 else -x[:, 2]
        moved[:, 2] = 0 if mode == 0 else x[:, 0]
        force = np.linalg.lstsq(A, moved.ravel(), rcond=1e-12)[0].reshape(-1, 3)
        side = (force[:, 0] - force[:, 1]) / 2
        K[:, mode] = side.sum(), sum(-z * h + p * r / 2 for (r, z), h, p in zip(rings, side, force[:, 2]))
    return K


def rows(name):
    with open(f"{sys.argv[1]}/{name}") as file:
        return list(csv.DictReader(file))


if __name__ == "__main__":
    print("Rigid, L/D = 3 in homogeneous soil, G = 1, R = 1: K_HH, K_HM, K_MM")
    for nu in (0.2, 0.45):
        near, twice = (Model(1, 6, 0.15, far).pile(lambda depth: 1.0, nu) for far in (80, 160))
        for name, K in (("elements, walls at 80 and 160 R extrapolated", 2 * twice - near), ("Mindlin's forces", mindlin(1, 6, nu))):
            print(f"nu {nu}, {name}: {K[0, 0]:.2f}, {K[0, 1]:.2f}, {K[1, 1]:.1f}")
        by_fit = [(1 + 0.6 * abs(nu - 0.25)) * 2 * (1 + nu) * a * 3**b for a, b in ((6.4, 0.62), (-7.1, 1.56), (13.2, 2.5))]
        print(f"nu {nu}, Shadlou and Bhattacharya (2016): {by_fit[0]:.2f}, {by_fit[1]:.2f}, {by_fit[2]:.1f}")
    ground = rows("pisa_ground.csv")
    for pile in rows("pisa_secants.csv"):
        name, D, L, height, wall, k_H, k_M = (pile[k] if k == "pile" else float(pile[k]) for k in (
            "pile", "diameter_m", "embedded_length_m", "load_height_m", "wall_mm", "k_H_MN_per_m", "k_M_MNm_per_deg"))
        site = [(float(r["depth_m"]), float(r["G0_MPa"])) for r in ground if r["site"] == pile["site"]]
        nu = 0.2 if name == "DM7" else 0.45
        print(f"{name}: measured k_H {k_H} MN/m, k_M {k_M} MNm/deg, no displacement at {k_M * 180 / math.pi / (k_H * height):.2f} m")
        for part in [float(p) for p in sys.argv[2:]] or (1, 0.5, 0.25):
            for tube in (False, True):
                K = Model(D / 2, L, D / 12, 100, wall / 1000 if tube else None).pile(lambda d: part * np.interp(d, *zip(*site)), nu)
                H, M, depth = secants(K, height)
                M *= math.pi / 180
                print(f"  {part:.3g} G0, {'tube' if tube else 'rigid'}: k_H {H:.2f} MN/m ({H / k_H:.2f}), k_M {M:.3f} MNm/deg ({M / k_M:.2f}), {depth:.2f} m")
