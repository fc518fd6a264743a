# SPDX-License-Identifier: GPL-3.0-or-later
"""Plane waves in an endless body of bonds, as matvib-equations(7) has them: rho w^2 over that of long waves."""
import numpy as np

import golden

POINT, WEIGHT = np.polynomial.legendre.leggauss(200)
R, DR = (POINT + 1) / 2, WEIGHT / 2  # 0 to the horizon, which is 1 here
TURN = 2 * np.pi * np.arange(400) / 400


def cone(r, shape):
    return 1 - r if shape == "conical" else 1 + 0 * r


def line(shape, z):
    """E = 1: both sides of a point."""
    c = (6 if shape == "conical" else 2) * cone(R, shape)
    return (c / R * 2 * (2 * np.sin(z * R / 2) ** 2) * DR).sum() / z ** 2


def plane(shape, wave, z):
    """E = 1: all around a point; L moves along the wave's way, T across."""
    c = (36 if shape == "conical" else 9) / np.pi * cone(R, shape)
    along = np.cos(TURN)[:, None] if wave == "L" else np.sin(TURN)[:, None]
    ring = (along ** 2 * 2 * np.sin(z * R * np.cos(TURN)[:, None] / 2) ** 2).mean(0) * 2 * np.pi
    return (c * ring * DR).sum() / ((9 if wave == "L" else 3) / 8 * z ** 2)


def lattice(shape, wave, m, z):
    """E = 1, dx = 1/m, along the rows; volumes partial."""
    p, q = (grid.ravel() for grid in np.meshgrid(*2 * [np.arange(-int(m), int(m) + 1)]))
    r = np.hypot(p, q) / m
    own = (r > 0) & (r <= 1 + 1e-9)
    p, q, r = p[own], q[own], r[own]
    w = np.minimum(1, (1 - r) * m + 0.5)
    c = (36 if shape == "conical" else 9) / np.pi * cone(np.minimum(r, 1), shape)
    along = (p if wave == "L" else q) / m / r
    longest = (9 if wave == "L" else 3) / 8 * z ** 2
    return (c / r * along ** 2 * 2 * np.sin(z * p / m / 2) ** 2 * w / m ** 2).sum() / longest


if __name__ == "__main__":
    told = golden.Comparison("influence.txt, waves")
    for words in golden.lines("influence.txt"):
        if words[0] == "line":
            told.near(" ".join(words), line(words[1], float(words[3])), float(words[4]), 0.52e-9)
        elif words[0] == "plane":
            told.near(" ".join(words), plane(words[1], words[2], float(words[3])), float(words[4]), 0.51e-8)
        elif words[0] == "lattice":
            told.near(" ".join(words), lattice(words[1], words[2], float(words[3]), 0.1), float(words[4]), 0.51e-6)
    told.tell()
    golden.end()
