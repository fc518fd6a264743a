# SPDX-License-Identifier: GPL-3.0-or-later
"""Beams by the material point method in plane stress, as matvib-equations(7) has them.

Shape functions are matrices, particles times nodes, as in bar.py; of a pair (x, y) there is one array with two rows.
"""
import numpy as np

import golden
from bar import hat, hat_mean

STAGES = {"usf": "map hold strain force hold_force integrate update",
          "usl": "map hold force hold_force integrate update strain",
          "musl": "map hold force hold_force integrate update map_again hold_again strain"}
ROOT = 1.8751040687119611  # the first of 1 + cosh z cos z = 0


class Beam:
    def __init__(self, L, h, b, E, rho, nu, dx, P, U, courant, pad, cantilever, shape, algorithm, alpha=1.0,
                 start="deflection", stress="relaxed", ends="section", clamp="full", v0=0.0, channel=0.0, grid_speed=0.0,
                 steps=0):
        self.L, self.h, self.b, self.E, self.rho0, self.nu, self.dx, self.P, self.U = L, h, b, E, rho, nu, dx, P, U
        self.cantilever, self.shape, self.algorithm, self.alpha = cantilever, shape, algorithm, alpha
        self.ends, self.clamp, self.v0, self.grid_speed = ends, clamp, v0, grid_speed
        self.dt = courant * dx / np.sqrt(E / (rho * (1 - nu * nu)))
        columns, rows, d = round((L + channel) / dx), round(h / dx), dx / P
        # the grid: node (i, j) has the index j gx + i; so many cells more as the beam comes further than the grid
        further = int(np.ceil((v0 - grid_speed) * steps * self.dt / dx))
        self.gx, self.gy = columns + 2 * pad + further + 1, rows + 2 * pad + 1
        self.edge = np.array([-channel - pad * dx, -h / 2 - pad * dx])
        # particles of the straight beam, bent or set in motion
        id = np.arange(columns * rows * P * P)
        self.nxp, self.nyp = columns * P, rows * P
        X, Y = (id % self.nxp + 0.5) * d - channel, (id // self.nxp + 0.5) * d - h / 2
        self.Y, self.m, self.work, self.step_number = Y, rho * d * d, 0.0, 0
        middle = (self.nyp - 1) // 2, self.nyp // 2
        across = (self.nxp - 1, self.nxp - 1) if cantilever else ((self.nxp - 1) // 2, self.nxp // 2)
        self.probe = [j * self.nxp + i for j in middle for i in across]
        w, slope, curvature = self.deflection(X)
        self.x, self.v = np.array([X, Y]), np.array([np.full(len(X), v0), np.zeros(len(X))])
        e = np.zeros((3, len(X)))
        if start == "velocity":
            z = ROOT if cantilever else np.pi
            self.v = self.v + (z / L) ** 2 * h * np.sqrt(E / (12 * rho)) * np.array([-Y * slope, w])
        else:
            of_beam = np.array([-Y * curvature, 0 * Y, 0 * Y])
            e = of_beam if stress == "exact" else self.strain_of_nodes(stress == "relaxed")
            self.x = np.array([X - Y * slope, Y + w])
        self.s, self.rho = self.stress_of(e), rho / (1 + e[0] + e[1])

    def deflection(self, x):
        """w, w' and w''."""
        if not self.cantilever:
            k = np.pi / self.L
            return self.U * np.array([np.sin(k * x), k * np.cos(k * x), -k * k * np.sin(k * x)])
        k, r = ROOT / self.L, (np.sinh(ROOT) - np.sin(ROOT)) / (np.cosh(ROOT) + np.cos(ROOT))
        a = k * x
        return self.U * (x > 0) * np.array([np.cosh(a) - np.cos(a) - r * (np.sinh(a) - np.sin(a)),
                                            k * (np.sinh(a) + np.sin(a) - r * (np.cosh(a) - np.cos(a))),
                                            k * k * (np.cosh(a) + np.cos(a) - r * (np.sinh(a) + np.sin(a)))])

    def strain_of_nodes(self, relaxed):
        """What the particles of the straight beam would be strained by, were the nodes where the bent beam is."""
        self.shapes()
        x, y = self.nodes()
        w, slope, curvature = self.deflection(x) * (not self.cantilever or x > 1e-6 * self.dx)
        return self.strain_by(np.array([-y * slope, w + relaxed * self.nu * curvature * y * y / 2]))

    def stress_of(self, e):
        direct, shear = self.E / (1 - self.nu ** 2), self.E / (2 * (1 + self.nu))
        return np.array([direct * (e[0] + self.nu * e[1]), direct * (e[1] + self.nu * e[0]), shear * e[2]])

    # --- the grid ----------------------------------------------------------------------------------------------
    def left_edge(self, step):
        return self.edge[0] + self.grid_speed * step * self.dt

    def nodes(self, step=0):
        i = np.arange(self.gx * self.gy)
        return self.left_edge(step) + i % self.gx * self.dx, self.edge[1] + i // self.gx * self.dx

    def shapes(self):
        """N, dN/dx and dN/dy of every particle at every node: products of those along x and along y."""
        along = lambda r: hat(r) if self.shape == "hat" else hat_mean(r, 0.5 / self.P)
        x, y = (self.x[0] - self.left_edge(self.step_number)) / self.dx, (self.x[1] - self.edge[1]) / self.dx
        nx, dnx = along(x[:, None] - np.arange(self.gx))
        ny, dny = along(y[:, None] - np.arange(self.gy))
        whole = lambda p, q: (q[:, :, None] * p[:, None, :]).reshape(len(x), -1)
        self.N, self.Nx, self.Ny = whole(nx, ny), whole(dnx, ny) / self.dx, whole(nx, dny) / self.dx

    def held(self, step):
        """Which nodes a support holds along x, and along y; decided anew in each step."""
        (x, y), t = self.nodes(step), 1e-6 * self.dx
        left, right, middle = x <= t, x >= self.L - t, abs(y) <= t
        if self.cantilever:
            return left & (self.clamp == "full"), left
        return left & middle, (left | right) & (middle | (self.ends == "section"))

    # --- the stages --------------------------------------------------------------------------------------------
    @property
    def active(self):
        return self.mass > 1e-12 * self.rho0 * self.dx ** 2

    def map(self):
        self.shapes()
        self.mass = self.N.sum(0) * self.m
        self.map_again()

    def map_again(self):
        self.p = self.m * self.v @ self.N

    def hold(self):
        along, across = self.held(self.step_number)
        self.p[0, along] = self.mass[along] * self.v0
        self.p[1, across] = 0
        self.u = self.velocity()

    hold_again = hold

    def velocity(self):
        """p/m; where there is hardly any mass that of the beam as a whole."""
        u = np.zeros_like(self.p)
        u[0] = self.v0
        u[:, self.active] = self.p[:, self.active] / self.mass[self.active]
        return u

    def strain_by(self, u):
        return np.array([self.Nx @ u[0], self.Ny @ u[1], self.Ny @ u[0] + self.Nx @ u[1]])

    def strain(self):
        e = self.dt * self.strain_by(self.u)
        self.s = self.s + self.stress_of(e)
        self.rho = self.rho / (1 + e[0] + e[1])

    def force(self):
        xx, yy, xy = self.s * self.m / self.rho
        self.f = -np.array([xx @ self.Nx + xy @ self.Ny, xy @ self.Nx + yy @ self.Ny])

    def hold_force(self):
        along, across = self.held(self.step_number)
        self.work -= self.f[0, along].sum() * self.v0 * self.dt * self.b
        self.f[0, along] = 0
        self.f[1, across] = 0

    def integrate(self):
        self.p = self.p + self.dt * self.f
        self.new = self.velocity()
        if self.algorithm != "usf":
            self.u = self.new

    def update(self):
        a = np.where(self.active, self.f / np.where(self.active, self.mass, 1), 0)
        of_grid = self.new @ self.N.T
        self.v = self.alpha * (self.v + self.dt * a @ self.N.T) + (1 - self.alpha) * of_grid
        self.x = self.x + self.dt * of_grid

    def step(self):
        for stage in STAGES[self.algorithm].split():
            getattr(self, stage)()
        self.step_number += 1

    # --- what is told between steps ----------------------------------------------------------------------------
    def row(self, supports_of=None):
        """supports_of: the step whose supports kinetic_grid is that of; the one to come, if not said."""
        self.map()
        along, across = self.held(self.step_number if supports_of is None else supports_of)
        beside = self.p - np.array([self.mass * self.v0, 0 * self.mass])
        beside[0, along] = beside[1, across] = 0
        xx, yy, xy = self.s
        G = self.E / (2 * (1 + self.nu))
        energy = (xx * xx + yy * yy - 2 * self.nu * xx * yy) / (2 * self.E) + xy * xy / (2 * G)
        return {"kinetic": self.b * self.m * ((self.v[0] - self.v0) ** 2 + self.v[1] ** 2).sum() / 2,
                "kinetic_grid": self.b * (beside ** 2).sum(0)[self.active] @ (1 / self.mass[self.active]) / 2,
                "strain": self.b * (energy * self.m / self.rho).sum(), "work": self.work,
                "uy": (self.x[1] - self.Y)[self.probe].mean(), "vy": self.v[1, self.probe].mean()}


# --- against the golden digits ---------------------------------------------------------------------------------
def beam_of(case):
    given = golden.settings(case)
    number = lambda key, other=0.0: float(given.get(key, other))
    steps = max(int(words[1]) for words in case if words[0] == "state")
    sup = given["sup"]
    return Beam(*(number(key) for key in ("L", "h", "b", "E", "rho", "nu", "dx")), int(given["ppc"]), number("U"),
                number("courant"), int(given["pad"]), given["case"] == "C", given["shape"], given["algo"],
                number("alpha"), given["start"], given["stress0"], sup, sup, number("v0"), number("channel"),
                number("gridv"), steps)


def compare(name, case):
    told, beam = golden.Comparison("mpm2d.txt " + name), beam_of(case)
    facts = {"dt": [beam.dt], "particles": [beam.nxp, beam.nyp], "nodes": [beam.gx, beam.gy], "edge": beam.edge}
    for words in case:
        for got, expected in zip(facts.get(words[0], []), golden.numbers(words[1:]) if words[0] in facts else []):
            told.near(words[0], got, expected, 1e-15 * abs(expected))
    states = [golden.numbers(words[1:]) for words in case if words[0] == "state"]
    spots = np.array([golden.numbers(words[1:]) for words in case if words[0] == "at"])
    most = np.abs(states).max(0)
    # boxes that move have light nodes, which two programs round differently
    loose = 3e-11 if beam.shape == "hat" else 1e-9 if beam.cantilever else 2e-11
    speed = max(abs(spots[:, 3] - beam.v0).max(), abs(spots[:, 4]).max())
    place, stress, whole = 1e-14 * beam.L, loose * abs(spots[:, 5:8]).max(), most[1] + most[4]
    step = -1
    for words in case:
        if words[0] == "state":
            step = int(words[1])
            while beam.step_number < step:
                beam.step()
            # on a grid that rides along the reference holds what the step just done has held
            row, values = beam.row(max(step - 1, 0) if beam.grid_speed else None), golden.numbers(words[2:])
            energy = max(1e-11, loose / 10) * whole
            for what, value, allowed in zip(("kinetic", None, "kinetic_grid", "strain", "work", "uy", "vy"), values,
                                            (energy, 0, energy, energy, 3e-8 * most[5], place, loose * most[7])):
                if what:
                    told.near(f"{what} at step {step}", row[what], value, allowed)
        elif words[0] == "at":
            p, values = int(words[1]), golden.numbers(words[2:])
            got = [*beam.x[:, p], *beam.v[:, p], *beam.s[:, p], beam.rho[p]]
            allowed = 2 * [place] + 2 * [loose * speed] + 3 * [stress] + [1e-11 * beam.rho0]
            for what, mine, value, most_off in zip("x y vx vy sxx syy sxy density".split(), got, values, allowed):
                told.near(f"{what} of particle {p} at step {step}", mine, value, most_off)
    told.tell()


if __name__ == "__main__":
    for name, case in golden.cases("mpm2d.txt"):
        compare(name, case)
    golden.end()
