# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic bodies by the material point method in the plane, as matvib-equations(7) has them.

Of each particle the nodes of its support are arrays [particle, 3 or 2 times as many]; each field has a grid of its own.
"""
import numpy as np

import golden

PAD = 4


def shape_1d(kind, r, P):
    """First node, N, dN/dr of a place r in cells."""
    if kind == "hat":
        i = np.floor(r)
        t = r - i
        return i, np.array([1 - t, t]), np.array([-np.ones_like(t), np.ones_like(t)])
    if kind == "gimp":
        l = 1 / (2 * P)
        i = np.floor(r - l)
        s = r - l - i
        o = np.maximum(0, s + 2 * l - 1)
        b = o / (2 * l)
        n2 = o * b / 2
        return i, np.array([1 - (s + l) + n2, s + l - 2 * n2, n2]), np.array([b - 1, 1 - 2 * b, b])
    i = np.floor(r - 0.5)
    t = r - i - 1
    return i, np.array([(0.5 - t) ** 2 / 2, 0.75 - t * t, (0.5 + t) ** 2 / 2]), np.array([t - 0.5, -2 * t, t + 0.5])


class Bodies:
    def __init__(self, case):
        text = golden.settings(case)
        value = {key: float(word) for key, word in text.items() if word[0] in "-0123456789"}
        self.text, self.value = text, value
        E, nu, self.rho, self.dx, self.P = value["E"], value["nu"], value["rho"], value["dx"], int(value["P"])
        self.G, self.lam = E / (2 * (1 + nu)), E * nu / ((1 + nu) * (1 - 2 * nu))
        stress = text["plane"] == "stress"
        self.D11 = E / (1 - nu * nu) if stress else self.lam + 2 * self.G
        self.D12 = nu * self.D11 if stress else self.lam
        self.dt = value["courant"] * self.dx / np.sqrt(self.D11 / self.rho)
        self.g = np.array([value["gx"], value["gy"]])
        self.cells = [round(value["W"] / self.dx), round(value["H"] / self.dx)]
        self.gx, self.gy = self.cells[0] + 2 * PAD + 1, self.cells[1] + 2 * PAD + 1
        places, velocities, fields, spins = [], [], [], []
        shapes = [line[1:] for line in case if line[0] == "body"]
        d = self.dx / self.P
        for k, (kind, *words) in enumerate(shapes):
            n = golden.numbers(words)
            size, (vx, vy, w) = n[:-3], n[-3:]
            J, I = np.meshgrid(np.arange(-2, value["H"] / d + 2), np.arange(-2, value["W"] / d + 2), indexing="ij")
            X, Y = ((I + 0.5) * d).ravel(), ((J + 0.5) * d).ravel()
            if kind == "block":
                inside = (X > size[0]) & (X < size[2]) & (Y > size[1]) & (Y < size[3])
                c = ((size[0] + size[2]) / 2, (size[1] + size[3]) / 2)
            else:
                c, square = size[:2], (X - size[0]) ** 2 + (Y - size[1]) ** 2
                inside = square < size[-1] ** 2
                if kind == "ring":
                    inside &= square > size[2] ** 2
            X, Y = X[inside], Y[inside]
            places.append([X, Y])
            velocities.append([vx - w * (Y - c[1]), vy + w * (X - c[0])])
            fields.append(np.full(len(X), k if value["contact"] else 0))
            spins.append(np.full(len(X), w))
        self.x, self.v = np.hstack(places), np.hstack(velocities)
        self.field, spin = np.hstack(fields), np.hstack(spins)
        self.n_fields = self.field.max() + 1
        n = self.x.shape[1]
        self.m, self.V0 = self.rho * d * d, d * d
        self.V, self.s = np.full(n, self.V0), np.zeros((3, n))
        self.F = np.array([np.ones(n), np.zeros(n), np.zeros(n), np.ones(n)])
        self.B = np.zeros((4, n))
        self.find()
        if value["apic"]:
            self.B[1], self.B[2] = -spin * self.D[1], spin * self.D[0]
        self.count = 0

    def find(self):
        """Nodes of each particle, N, dN/dx, dN/dy, and the arms to them."""
        first, N, dN = zip(*[shape_1d(self.text["shape"], self.x[k] / self.dx + PAD, self.P) for k in range(2)])
        a = len(N[0])
        grid = self.field * self.gx * self.gy
        self.node = np.array([grid + (first[1] + j) * self.gx + first[0] + i for j in range(a) for i in range(a)]).astype(int)
        self.N = np.array([N[0][i] * N[1][j] for j in range(a) for i in range(a)])
        self.dN = np.array([[dN[0][i] * N[1][j] for j in range(a) for i in range(a)],
                            [N[0][i] * dN[1][j] for j in range(a) for i in range(a)]]) / self.dx
        self.arm = np.array([[(first[k] + (i, j)[k] - PAD) * self.dx - self.x[k] for j in range(a) for i in range(a)]
                             for k in range(2)])
        self.D = [sum(N[k][i] * ((first[k] + i - PAD) * self.dx - self.x[k]) ** 2 for i in range(a)) for k in range(2)]

    def onto(self, terms):
        return np.bincount(self.node.ravel(), terms.ravel(), self.n_fields * self.gx * self.gy)

    def mapped(self):
        q = []
        for k in range(2):
            given = np.broadcast_to(self.v[k], self.N.shape)
            if self.value["apic"]:
                inverse = [np.where(D > 0, 1 / np.where(D > 0, D, 1), 0) for D in self.D]
                given = given + sum(self.B[2 * k + l] * inverse[l] * self.arm[l] for l in range(2))
            q.append(self.onto(self.m * self.N * given))
        return np.array(q)

    def fix(self, q):
        value, G, near = self.value, self.gx * self.gy, self.value["near"] * self.dx
        node = np.arange(len(self.mass))
        at = [node % G % self.gx - PAD, node % G // self.gx - PAD]
        for side, axis, out in (("left", 0, -1), ("right", 0, 1), ("bottom", 1, -1), ("top", 1, 1)):
            kind = self.text[side]
            there = self.heavy & ((at[axis] <= 0) if out < 0 else (at[axis] >= self.cells[axis]))
            if kind == "clamp":
                q[:, there] = 0
                self.q0[:, there] = 0
            if kind not in ("slip", "fric"):
                continue
            place = 0 if out < 0 else self.cells[axis] * self.dx
            for i in np.flatnonzero(there & (q[axis] * out > 0)):
                if abs(self.r[axis, i] / self.mass[i] - place) > near:
                    continue
                most, t = value["muw"] * abs(q[axis, i]), q[1 - axis, i]
                q[axis, i] = 0
                if kind == "fric":
                    q[1 - axis, i] = np.sign(t) * max(abs(t) - most, 0)
        for a in range(self.n_fields):
            for b in range(a + 1, self.n_fields):
                for i in np.flatnonzero(self.heavy[a * G:(a + 1) * G] & self.heavy[b * G:(b + 1) * G]):
                    self.meet(q, a * G + i, b * G + i, 2 * near)

    def normal(self, a, b):
        return self.n[:, a] - self.n[:, b]

    def turned(self, L):
        angle = 2 * np.arctan((L[2] - L[1]) / 4)
        c, s = np.cos(angle), np.sin(angle)
        xx, yy, xy = self.s
        return (c * c * xx + s * s * yy - 2 * c * s * xy, s * s * xx + c * c * yy + 2 * c * s * xy,
                c * s * (xx - yy) + (c * c - s * s) * xy)

    def meet(self, q, a, b, near):
        n = self.normal(a, b)
        length = np.hypot(*n)
        if not length > 0:
            return
        n = n / length
        if (self.r[:, b] / self.mass[b] - self.r[:, a] / self.mass[a]) @ n > near:
            return
        v = q[:, a] / self.mass[a] - (q[:, a] + q[:, b]) / (self.mass[a] + self.mass[b])
        vn = v @ n
        if not vn > 0:
            return
        t = v - vn * n
        size = np.hypot(*t)
        J = self.mass[a] * (vn * n + (min(1, self.value["mu"] * vn / size) if size > 0 else 1) * t)
        q[:, a] -= J
        q[:, b] += J

    def first_fix(self, q):
        self.fix(q)

    def strain(self, q):
        velocity = q * self.inverse
        light = ~self.heavy[self.node]
        v = [np.where(light, self.v[k], velocity[k][self.node]) for k in range(2)]
        L = [(v[k] * self.dN[l]).sum(axis=0) * self.dt for k in range(2) for l in range(2)]
        if self.text["law"] == "neo":
            F = self.F
            self.F = np.array([F[0] + L[0] * F[0] + L[1] * F[2], F[1] + L[0] * F[1] + L[1] * F[3],
                               F[2] + L[2] * F[0] + L[3] * F[2], F[3] + L[2] * F[1] + L[3] * F[3]])
            F = self.F
            J = F[0] * F[3] - F[1] * F[2]
            swell = self.lam * np.log(J)
            self.s = np.array([self.G * (F[0] ** 2 + F[1] ** 2 - 1) + swell, self.G * (F[2] ** 2 + F[3] ** 2 - 1) + swell,
                               self.G * (F[0] * F[2] + F[1] * F[3])]) / J
            self.V = J * self.V0
            return
        xx, yy, xy = self.turned(L) if self.text["law"] == "hypo" else self.s
        self.s = np.array([xx + self.D11 * L[0] + self.D12 * L[3], yy + self.D12 * L[0] + self.D11 * L[3],
                           xy + self.G * (L[1] + L[2])])
        self.V = self.V * (1 + L[0] + L[3])

    def step(self):
        algorithm, alpha = self.text["algo"], self.value["alpha"]
        self.find()
        self.mass = self.onto(self.m * self.N)
        self.heavy = self.mass > 1e-12 * self.rho * self.dx ** 2
        self.inverse = np.where(self.heavy, 1 / np.where(self.heavy, self.mass, 1), 0)
        self.n = np.array([self.onto(self.m * self.dN[k]) for k in range(2)])
        self.r = np.array([self.onto(self.m * self.N * self.x[k]) for k in range(2)])
        q = self.mapped()
        self.q0 = q.copy()
        self.first_fix(q)
        if algorithm == "usf":
            self.strain(q)
        xx, yy, xy = self.s
        f = [self.onto(self.m * self.N * self.g[0] - self.V * (xx * self.dN[0] + xy * self.dN[1])),
             self.onto(self.m * self.N * self.g[1] - self.V * (xy * self.dN[0] + yy * self.dN[1]))]
        q = q + self.dt * np.array(f)
        self.fix(q)
        carry, kick = q * self.inverse, (q - self.q0) * self.inverse
        u = np.array([(self.N * carry[k][self.node]).sum(axis=0) for k in range(2)])
        if self.value["apic"]:
            self.B = np.array([(self.N * carry[k][self.node] * self.arm[l]).sum(axis=0) for k in range(2) for l in range(2)])
            self.v = u
        else:
            gain = np.array([(self.N * kick[k][self.node]).sum(axis=0) for k in range(2)])
            self.v = alpha * (self.v + gain) + (1 - alpha) * u
        self.x = self.x + self.dt * u
        if algorithm == "musl":
            q = self.mapped()
            self.fix(q)
        if algorithm != "usf":
            self.strain(q)
        self.count += 1

    def columns(self):
        return [*self.x, *self.v, *self.s, self.m / self.V]

    def sums(self):
        return [self.m * (self.v ** 2).sum() / 2, -self.m * (self.g @ self.x).sum(), self.m * self.v[0].sum(),
                self.m * self.v[1].sum()]


def compare(name, case):
    bodies, what = Bodies(case), golden.Comparison("bodies.py " + name)
    loose = 1e-7 if name == "spin-hat-hypo-unrotated" else 1e-9
    E = bodies.value["E"]
    states = [k for k, words in enumerate(case) if words[0] == "state"] + [len(case)]
    what.near("dt", bodies.dt, float([words for words in case if words[0] == "dt"][0][1]), 1e-15 * bodies.dt)
    for begin, end in zip(states, states[1:]):
        while bodies.count < int(case[begin][1]):
            bodies.step()
        kinetic, _, potential, px, py, _ = golden.numbers(case[begin][2:8])
        got, energy = bodies.sums(), abs(kinetic) + abs(potential)
        for value, expected in zip(got[:2], (kinetic, potential)):
            what.near("energy", value, expected, loose * energy)
        spots = [(int(words[1]), golden.numbers(words[2:])) for words in case[begin + 1:end] if words[0] == "at"]
        for k, column in enumerate(bodies.columns()):
            most = max([abs(values[k]) for _, values in spots] + [1e-6 * E if 4 <= k < 7 else 1e-12])
            for particle, values in spots:
                what.near(f"column {k} of {particle} at step {bodies.count}", column[particle], values[k], loose * most)
    what.tell()


if __name__ == "__main__":
    for name, case in golden.cases("bodies.txt"):
        compare(name, case)
    golden.end()
