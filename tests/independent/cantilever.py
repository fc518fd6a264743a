# SPDX-License-Identifier: GPL-3.0-or-later
"""A clamped block five times as long as high that falls, by finite elements: the rows of
src/problems/cantilever_rows.inc.

Plane strain, neo-Hookean, P = G (F - F^-T) + lambda ln J F^-T; bilinear quadrilaterals with 2 x 2 points, total
Lagrangian, lumped mass, central differences; E 5e5, nu .3, rho 1000, L 1, h .2, g 10. Three meshes, extrapolated.
Usage: python3 cantilever.py [elements along the height of the coarsest mesh, 16] [end, .8]
"""
import sys

import numpy as np

E, NU, RHO, LENGTH, HEIGHT, GRAVITY = 5e5, 0.3, 1000.0, 1.0, 0.2, 10.0
G, LAMBDA = E / (2 * (1 + NU)), E * NU / ((1 + NU) * (1 - 2 * NU))
SPACING, ORDER = 0.01, 1.7  # of the rows, in t; of the error in h as measured, 1.4 to 2.1


def corners(field):
    """Of each element the values at its corners, counterclockwise."""
    return field[:-1, :-1], field[1:, :-1], field[1:, 1:], field[:-1, 1:]


def fall(ny, end):
    """Rows of the displacement of the centre of mass and of the middle of the end: x, y, x, y."""
    nx, h = 5 * ny, HEIGHT / ny
    c = np.sqrt((LAMBDA + 2 * G) / RHO)
    steps = int(np.ceil(SPACING / (0.5 * h / c)))
    dt = SPACING / steps
    place = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    points = [(a / np.sqrt(3), b / np.sqrt(3)) for a, b in place]
    slope = [[(a * (1 + b * t) / (2 * h), b * (1 + a * s) / (2 * h)) for a, b in place] for s, t in points]
    u, v = np.zeros((2, nx + 1, ny + 1)), np.zeros((2, nx + 1, ny + 1))
    mass = np.zeros((nx + 1, ny + 1))
    for part in corners(mass):
        part += RHO * h * h / 4
    rows = [[0.0] * 4]
    for k in range(round(end / SPACING) * steps):
        f = np.zeros_like(u)
        for dN in slope:
            F = [[sum(dN[n][j] * part for n, part in enumerate(corners(u[i]))) for j in (0, 1)] for i in (0, 1)]
            F[0][0] += 1
            F[1][1] += 1
            J = F[0][0] * F[1][1] - F[0][1] * F[1][0]
            turned = [[F[1][1] / J, -F[1][0] / J], [-F[0][1] / J, F[0][0] / J]]  # F^-T
            swell = LAMBDA * np.log(J) - G
            for i in (0, 1):
                P = [(G * F[i][j] + swell * turned[i][j]) * (h * h / 4) for j in (0, 1)]
                for n, part in enumerate(corners(f[i])):
                    part -= P[0] * dN[n][0] + P[1] * dN[n][1]
        a = f / mass
        a[1] -= GRAVITY
        v += (0.5 if k == 0 else 1.0) * dt * a
        v[:, 0, :] = 0
        u += dt * v
        if (k + 1) % steps == 0:
            rows.append([(mass * u[i]).sum() / mass.sum() for i in (0, 1)] + [u[i][-1, ny // 2] for i in (0, 1)])
    return np.array(rows)


if __name__ == "__main__":
    coarse = int(sys.argv[1]) if len(sys.argv) > 1 else 16
    end = float(sys.argv[2]) if len(sys.argv) > 2 else 0.8
    runs = [fall(coarse * k, end) for k in (1, 2, 4)]
    best = runs[2] + (runs[2] - runs[1]) / (2**ORDER - 1)
    print("extrapolation moves the tip by %.1e" % np.abs(best - runs[2]).max(), file=sys.stderr)
    for row in best:
        print("{" + ", ".join("%.5f" % value for value in row) + "},")
