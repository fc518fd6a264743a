# SPDX-License-Identifier: GPL-3.0-or-later
"""What a lattice of bonds does in small motion: the supported beam's lowest period, and its sag under weight.

The matrix K of f = -K u couples columns that are a horizon apart at most. Taken together by as many columns as the
horizon reaches, it has blocks on its diagonal and beside it alone, and is factored block by block.
"""
import numpy as np

import golden
from beams import supported_beam


class Stiffness:
    """K with held components left alone, factored: K = L L^T in blocks."""

    def __init__(self, body):
        self.body, reach = body, int(abs(body.j % body.nx - body.i % body.nx).max())
        self.size, blocks = 2 * reach * body.ny, -(-body.nx // reach)
        node = np.arange(body.nx * body.ny)
        number = 2 * (node % body.nx * body.ny + node // body.nx)  # by columns; x and y of a node side by side
        self.place = np.array([number, number + 1])
        self.free = np.ones(blocks * self.size, bool)
        for nodes, speeds in body.supports:
            for axis, speed in enumerate(speeds):
                if speed is not None:
                    self.free[self.place[axis, nodes]] = False
        main, beside = (np.zeros((blocks, self.size, self.size)) for _ in range(2))
        n, own = body.xi / body.length, np.concatenate([node, body.i, body.j])
        other = np.concatenate([node, body.j, body.i])
        for a, b in ((0, 0), (0, 1), (1, 0), (1, 1)):
            stiff = body.k / body.length * n[a] * n[b]
            row, column = self.place[a, own], self.place[b, other]
            value = np.concatenate([body.families(stiff, stiff), -stiff, -stiff]) * self.free[row] * self.free[column]
            for matrix, far in ((main, 0), (beside, 1)):
                here = column // self.size - row // self.size == far
                r, c = row[here], column[here]
                matrix[r // self.size, r % self.size, c % self.size] = value[here]
        unused = np.ones(blocks * self.size, bool)
        unused[self.place] = False
        alone = np.flatnonzero(~self.free | unused)
        main[alone // self.size, alone % self.size, alone % self.size] += body.k.max() / body.length.min()
        self.inverse, self.beside = main, beside
        for g in range(blocks):
            if g:
                main[g] -= beside[g - 1].T @ main[g - 1] @ beside[g - 1]
            main[g] = np.linalg.inv(main[g])

    def solve(self, force):
        """u of K u = force; force of every node, 2 rows."""
        x = np.zeros(len(self.free))
        x[self.place] = force
        x = (x * self.free).reshape(-1, self.size)
        for g in range(1, len(x)):
            x[g] -= self.beside[g - 1].T @ (self.inverse[g - 1] @ x[g - 1])
        for g in range(len(x) - 1, -1, -1):
            x[g] = self.inverse[g] @ (x[g] - (self.beside[g] @ x[g + 1] if g + 1 < len(x) else 0))
        return x.ravel()[self.place]


def lowest_frequency(body):
    """Inverse iteration from the shape of eqs. 15, 16; then the quotient of energies, a sum of positive terms."""
    K, u = Stiffness(body), body.u
    for _ in range(6):
        u = K.solve(u)
        u = u / np.abs(u).max()
    eta = ((u[:, body.j] - u[:, body.i]) * body.xi / body.length).sum(0)
    return np.sqrt((body.k / body.length * eta ** 2).sum() / (body.rho * (u ** 2).sum()))


def paper_beam(dx, delta, surface, volume, influence="constant"):
    return supported_beam(0.1, 0.005, dx * 1e-3, delta * 1e-3, 1.0, E=71e9, rho=2700.0, surface=surface,
                          volume=volume, influence=influence)


def compare_period(told, words, volume, influence):
    dx, delta = golden.numbers(words[:2])
    period = 2e3 * np.pi / lowest_frequency(paper_beam(dx, delta, words[2], volume, influence))
    told.near(" ".join(words), period, float(words[-1]), 1e-8 * period)


if __name__ == "__main__":
    finest = 0.15  # mm: finer lattices take long, and the finest a gigabyte
    told = golden.Comparison("periods.txt")
    for words in golden.lines("periods.txt"):
        if float(words[0]) > finest:
            compare_period(told, words, words[3], "constant")
    told.tell()
    told = golden.Comparison("influence.txt, periods")
    for words in golden.lines("influence.txt"):
        if words[0] == "period" and float(words[1]) > finest:
            compare_period(told, words[1:], "partial", "conical")
    told.tell()
    told = golden.Comparison("rest.txt, sag")
    for words in golden.lines("rest.txt"):
        if words[0] == "sag":
            body = paper_beam(*golden.numbers(words[1:3]), words[3], "partial")
            force = np.zeros_like(body.u)
            force[1] = -9.81 * body.rho
            sag, expected = Stiffness(body).solve(force)[1, body.probe].mean(), float(words[4])
            told.near(" ".join(words), sag, expected, 1e-8 * abs(expected))
    told.tell()
    golden.end()
