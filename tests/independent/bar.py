# SPDX-License-Identifier: GPL-3.0-or-later
"""The bar by the material point method, as matvib-equations(7) has it.

Shape functions are one matrix, particles times nodes, so that each sum of the page is one product: m = N^T m_p.
That is slow and plain. A step is a list of stages, each a function; nothing else changes the state.
"""
import numpy as np

import golden

STAGES = {"usf": "map fix strain force integrate update forget",
          "usl": "map fix force integrate update strain forget",
          "musl": "map fix force integrate update map_again strain forget"}


def hat(r):
    """1 - |r| within a cell of the node, r in cells; and its slope. At r = 0 the cell is the one on the right."""
    inside = np.where(r >= 0, r < 1, r >= -1)
    return np.where(inside, 1 - abs(r), 0), np.where(inside, np.where(r >= 0, -1.0, 1.0), 0)


def hat_mean(r, h):
    """uGIMP: the hat's mean over a width 2h, and its slope, which is the difference of hats over 2h."""
    near, far = abs(r) < h, abs(r) > 1 - h
    rest, sign = np.maximum(1 + h - abs(r), 0), np.sign(r)  # how far it reaches into the hat from outside
    value = np.where(near, 1 - (r * r + h * h) / (2 * h), np.where(far, rest ** 2 / (4 * h), 1 - abs(r)))
    slope = np.where(near, -r / h, np.where(far, -sign * rest / (2 * h), -sign))
    return value, slope


def hat_of_ends(r, h):
    """CPDI: half the sum of the hats at the ends of the particle's domain, and their difference over 2h."""
    left, right = hat(r - h)[0], hat(r + h)[0]
    return (left + right) / 2, (right - left) / (2 * h)


def spline(s, degree, cells):
    """B-splines on open knots, by the recursion of Cox and de Boor; s in cells from the mesh's left end."""
    knot = np.concatenate([np.zeros(degree), np.arange(cells + 1), np.full(degree, cells)])
    share = lambda above, below: above / below if below > 0 else 0.0
    n = [((knot[i] <= s) & (s < knot[i + 1])).astype(float) for i in range(len(knot) - 1)]
    for d in range(1, degree + 1):
        slope = [d * (share(n[i], knot[i + d] - knot[i]) - share(n[i + 1], knot[i + d + 1] - knot[i + 1]))
                 for i in range(len(n) - 1)]
        n = [share((s - knot[i]) * n[i], knot[i + d] - knot[i])
             + share((knot[i + d + 1] - s) * n[i + 1], knot[i + d + 1] - knot[i + 1]) for i in range(len(n) - 1)]
    greville = np.array([knot[i + 1:i + degree + 1].mean() for i in range(len(n))])
    return np.array(n).T, np.array(slope).T, greville


def spline_of_node(r, degree):
    """The B-spline about a node, and its slope; r in cells."""
    a = abs(r)
    if degree == 2:
        return (np.where(a < 0.5, 0.75 - r * r, np.maximum(1.5 - a, 0) ** 2 / 2),
                np.where(a < 0.5, -2 * r, -np.sign(r) * np.maximum(1.5 - a, 0)))
    return (np.where(a < 1, 2 / 3 - r * r + a ** 3 / 2, np.maximum(2 - a, 0) ** 3 / 6),
            np.where(a < 1, -2 * r + 1.5 * r * a, -np.sign(r) * np.maximum(2 - a, 0) ** 2 / 2))


class Bar:
    def __init__(self, L=25.0, E=100.0, rho=1.0, supports="fixed-free", modes=((1, 0.1),), dx=1.0, P=2, padding=4,
                 algorithm="usf", shape="hat", transfer="flip", alpha=1.0, mu=1.0, order=2, affine_start="gradient",
                 courant=0.1, offset=0.0):
        self.left, self.right = (end == "fixed" for end in supports.split("-"))
        self.E, self.rho0, self.dx, self.L = E, rho, dx, L
        self.algorithm, self.shape, self.transfer = algorithm, shape, transfer
        self.alpha, self.mu, self.order = alpha, mu, order
        self.dt = courant * dx / np.sqrt(E / rho)
        # the mesh: its left end, its cells; nodes are made with the shape functions
        before, beyond = (0 if self.left else padding), (0 if self.right else padding)
        self.xmin, self.cells = -before * dx, round(L / dx) + before + beyond
        # particles: (cell + (j + 1/2 + offset)/P) dx
        self.x = (np.arange(round(L / dx) * P) + 0.5 + offset) * dx / P
        self.m = np.full(len(self.x), rho * dx / P)
        self.half = 0.5 / P
        self.stress, self.rho = np.zeros(len(self.x)), np.full(len(self.x), rho)
        self.v, self.C = np.zeros(len(self.x)), np.zeros(len(self.x))
        for n, A in modes:
            beta = n * np.pi / L if self.left == self.right else (n - 0.5) * np.pi / L
            f, df = (np.sin, np.cos) if self.left else (np.cos, lambda y: -np.sin(y))
            self.v += A * f(beta * self.x)
            if transfer == "apic" and affine_start == "gradient":
                self.C += A * beta * df(beta * self.x)

    # --- shape functions ---------------------------------------------------------------------------------------
    def shapes(self):
        """N and N' of every particle at every node, at the places of now."""
        s = (self.x - self.xmin) / self.dx
        uniform = self.shape.endswith("_uniform")
        ends = 1 if self.shape in ("gimp", "cpdi") or uniform else 0
        if self.shape.startswith("bspline") and not uniform:
            self.N, slope, where = spline(s, int(self.shape[-1]), self.cells)
        else:
            where = np.arange(-ends, self.cells + 1 + ends, dtype=float)
            r = s[:, None] - where
            if self.shape == "hat":
                self.N, slope = hat(r)
            elif self.shape == "gimp":
                self.N, slope = hat_mean(r, self.half)
            elif uniform:
                self.N, slope = spline_of_node(r, int(self.shape[7]))
            else:
                self.N, slope = hat_of_ends(r, (self.m / self.rho / (2 * self.dx))[:, None])
        self.dN = slope / self.dx
        self.node = self.xmin + where * self.dx
        self.arm = self.node - self.x[:, None]
        self.free = np.ones(len(where), bool)
        if self.left:
            self.free[:1 + ends] = False
        if self.right:
            self.free[-1 - ends:] = False

    # --- the stages --------------------------------------------------------------------------------------------
    @property
    def active(self):
        return self.mass > 1e-12 * self.rho0 * self.dx

    def map(self):
        self.shapes()
        self.mass = self.N.T @ self.m
        self.map_momentum()

    def map_momentum(self):
        given = self.v[:, None] + (self.C[:, None] * self.arm if self.transfer == "apic" else 0)
        self.p = (self.N * given).T @ self.m

    def fix(self):
        self.p[~self.free] = 0
        self.u = self.velocity_of(self.p)

    def velocity_of(self, p):
        """The velocities that go with momenta: lumped, blended masses, or FMPM's series."""
        moving, v = self.free & self.active, np.zeros(len(p))
        if self.transfer == "fmpm":
            back = lambda d: np.where(moving, self.N.T @ (self.m * (self.N @ d)) / np.where(moving, self.mass, 1), 0)
            term = np.where(moving, p / np.where(moving, self.mass, 1), 0)
            for _ in range(self.order):
                v, term = v + term, term - back(term)
        elif self.mu < 1:
            consistent = (self.N.T * self.m) @ self.N
            M = (1 - self.mu) * consistent + self.mu * np.diag(self.mass)
            v[moving] = np.linalg.solve(M[np.ix_(moving, moving)], p[moving])
        else:
            v[moving] = p[moving] / self.mass[moving]
        return v

    def gradient(self, u):
        """sum N' u at each particle; with hats an inactive node beside the bar's end moves with its neighbour."""
        if self.shape == "hat":
            first, last = np.flatnonzero(self.active)[[0, -1]]
            u = np.concatenate([np.full(first, u[first]), u[first:last + 1], np.full(len(u) - last - 1, u[last])])
        return self.dN @ u

    def strain(self):
        de = self.dt * self.gradient(self.u)
        self.stress = self.stress + self.E * de
        self.rho = self.rho / (1 + de)

    def force(self):
        self.f = -self.dN.T @ (self.stress * self.m / self.rho)
        self.f[~self.free] = 0
        self.a = self.velocity_of(self.f)

    def integrate(self):
        self.p = self.p + self.dt * self.f
        self.new = self.velocity_of(self.p)
        if self.algorithm != "usf":
            self.u = self.new

    def update(self):
        before, of_grid = self.v, self.N @ self.new
        self.moved = self.x + self.dt * of_grid
        if self.transfer == "flip":
            self.v = self.alpha * (self.v + self.dt * (self.N @ self.a)) + (1 - self.alpha) * of_grid
        else:
            self.v = of_grid
        if self.transfer == "fmpm":
            self.moved = self.x + self.dt * (before + self.v) / 2
        if self.transfer == "apic" and self.shape == "hat":
            self.C = self.gradient(self.new)
        elif self.transfer == "apic":
            self.C = (self.N * self.arm) @ self.new / (self.N * self.arm ** 2).sum(1)

    def map_again(self):
        self.map_momentum()
        self.fix()

    def forget(self):
        self.x = self.moved

    def step(self):
        for stage in STAGES[self.algorithm].split():
            getattr(self, stage)()

    # --- what is told between steps ----------------------------------------------------------------------------
    def row(self):
        self.map()
        self.fix()
        moving = self.free & self.active
        spread = (self.N * self.arm ** 2).sum(1)
        weight = np.sqrt(self.m)
        best = np.linalg.lstsq(weight[:, None] * self.N[:, moving], weight * self.v, rcond=None)[0]
        unseen = self.v - self.N[:, moving] @ best
        kinetic = (self.m * self.v ** 2).sum() / 2
        return {"v_cm": self.v.mean(), "x_cm": self.x.mean(), "kinetic": kinetic,
                "strain": (self.stress ** 2 * self.m / self.rho).sum() / (2 * self.E),
                "kinetic_grid": (self.p[moving] ** 2 / self.mass[moving]).sum() / 2,
                "kinetic_null": (self.m * unseen ** 2).sum() / 2,
                "kinetic_whole": kinetic + (self.m * spread * self.C ** 2).sum() / 2}


# --- against the golden digits ---------------------------------------------------------------------------------
def bar_of(given, default_start):
    modes = [(int(given["initial.mode"]), float(given["initial.velocity"]))]
    if "initial.overtones" in given:
        n, A = given["initial.overtones"].split(":")
        modes.append((int(n), float(A)))
    number = lambda key, other: float(given.get(key, other))
    return Bar(number("bar.length", 0), number("bar.youngs_modulus", 0), number("bar.density", 0),
               given["bar.supports"], modes, number("mesh.cell_size", 0), int(given["mesh.particles_per_cell"]),
               int(given["mesh.padding"]),
               given["mpm.algorithm"], given["mpm.shape"], given["mpm.transfer"], number("mpm.flip_fraction", 1),
               number("mpm.mass_blend", 1), int(given.get("mpm.fmpm_order", 2)),
               given.get("mpm.affine_start", default_start), number("time.courant", 0),
               number("initial.offset", 0))


def compare(name, case, default_start):
    given, told = golden.settings(case), golden.Comparison(name)
    bar = bar_of(given, default_start)
    samples = [(int(words[1]), golden.numbers(words[2:])) for words in case if words[0] == "sample"]
    speed = abs(float(given["initial.velocity"]))
    energy = max(values[2] + values[3] for _, values in samples)
    scale = max(abs(values[0]) for _, values in samples)
    scale = scale if scale > 1e-6 * speed else speed  # symmetry may hold the centre of mass at rest
    v_most, stress_most, step = 0.0, 0.0 if int(given["initial.mode"]) else np.sqrt(bar.E * bar.rho0) * speed, 0
    names = ["v_cm", "x_cm", "kinetic", "strain", "kinetic_grid", "kinetic_null", "kinetic_whole"]
    allowed = dict.fromkeys(names, 1e-12 * energy) | {"v_cm": 1e-12 * scale, "x_cm": 1e-13 * bar.L}

    def particle(p, values):
        digits = (("x", bar.x, 1e-13 * bar.L), ("v", bar.v, 1e-11 * v_most), ("stress", bar.stress, 1e-11 * stress_most),
                  ("density", bar.rho, 1e-12), ("slope", bar.C, 1e-11 * v_most))
        for (what, field, most), expected in zip(digits, values):
            told.near(f"{what} of particle {p} at step {step}", field[p], expected, most)

    for at, expected in samples:
        while step < at:
            bar.step()
            step += 1
        v_most, stress_most = max(v_most, abs(bar.v).max()), max(stress_most, abs(bar.stress).max(), 1e-3)
        row = bar.row()
        for what, value in zip(names, expected):
            if what != "kinetic_grid" or bar.transfer == "flip":  # golden: of v alone
                told.near(f"{what} at step {at}", row[what], value, allowed[what])
        for words in case:
            if words[0] == "at" and int(words[1]) == at:
                particle(int(words[2]), golden.numbers(words[3:]))
    for p, words in enumerate(words for words in case if words[0] == "particle"):
        particle(p, golden.numbers(words[1:]))
    told.tell()


if __name__ == "__main__":
    for file in "mpm.txt", "cures.txt":
        for name, case in golden.cases(file):
            compare(f"{file} {name}", case, "zero")
    golden.end()
