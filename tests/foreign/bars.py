# SPDX-License-Identifier: GPL-3.0-or-later
"""A bar by the material point method as courses write it, in lists and loops: no numpy, no line of matvib's.

The conventions are those of public codes for teaching: a uniform grid, nodes a whole number of cells apart, the
held node at x = 0, two particles to a cell; the orders USF, USL and MUSL, hats or uGIMP. A mistake is one line
that is otherwise; its name is that of mpm.mistake."""
import math
import struct


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


class Bar:
    def __init__(self, scheme="usf", shape="hat", mistake="", mode=5, v0=0.1, E=100.0, rho=1.0, L=25.0, dx=1.0,
                 ppc=2, courant=0.1, pad=4, rounded=False):
        self.__dict__.update(locals())
        self.r = single if rounded else float
        self.dt = self.r(courant * dx / math.sqrt(E / rho))
        n = round(L / dx) * ppc
        self.lp = dx / ppc / 2  # half length of a particle's box
        if mistake == "gimp_whole_length":
            self.lp *= 2
        if mistake == "gimp_half_of_half":
            self.lp /= 2
        self.x = [self.r((i + 0.5) * dx / ppc) for i in range(n)]
        self.x0 = list(self.x)
        self.m = [self.r(rho * dx / (1 if mistake == "mass_of_cell" else ppc))] * n
        beta = (mode - 0.5) * math.pi / L
        if mistake == "mode_of_fixed_fixed":
            beta = mode * math.pi / L
        where = [(math.floor(x / dx) + 0.5) * dx for x in self.x] if mistake == "start_at_centres" else self.x
        self.v = [self.r(v0 * math.sin(beta * x)) for x in where]
        self.s = [0.0] * n
        self.rho_p = [float(rho)] * n
        self.before = list(self.s)
        self.steps = 0
        self.node_v = []
        self.nodes = round(L / dx) + 2 * pad + 1
        self.held = pad + (1 if mistake == "fix_next_node" else 0)
        self.kept = [[0.0] * self.nodes, [0.0] * self.nodes]
        self.cell = [math.floor(x / dx) for x in self.x]

    def weights(self, p):
        """Of a particle: (node, N, dN/dx)."""
        x, h, out = self.x[p], self.dx, []
        c = math.floor(x / h) if self.mistake != "cells_kept" else self.cell[p]
        for i in range(c - 1, c + 3):
            d = x - i * h
            if self.shape == "hat":
                if i not in (c, c + 1):
                    continue
                out.append((i + self.pad, 1 - abs(d) / h, -1 / h if i == c else 1 / h))
                continue
            l, a = self.lp, abs(d)
            if a >= h + l:
                continue
            sign = -1.0 if d > 0 else 1.0
            if a < l:
                out.append((i + self.pad, 1 - (d * d + l * l) / (2 * h * l), -d / (h * l)))
            elif a <= h - l:
                out.append((i + self.pad, 1 - a / h, sign / h))
            else:
                out.append((i + self.pad, (h + l - a) ** 2 / (4 * h * l), sign * (h + l - a) / (2 * h * l)))
        return out

    def strain(self, p_i, m_i):
        k = self.mistake
        slope = self.dx if k == "gradient_without_h" else self.dx / 2 if k in ("natural_slope", "natural_slope_in_strain") else 1
        self.before, self.rho_before = list(self.s), list(self.rho_p)
        for p, w in enumerate(self.w):
            rate = sum(dN * slope * p_i[i] / m_i[i] for i, N, dN in w if m_i[i] > 1e-12)
            de = self.r((1 if k == "strain_without_dt" else self.dt) * rate)
            self.s[p] = self.r((0 if k == "stress_not_added" else self.s[p]) + self.E * de)
            if k == "density_inverted":
                self.rho_p[p] = self.r(self.rho_p[p] * (1 + de))
            elif k != "density_kept":
                self.rho_p[p] = self.r(self.rho_p[p] / (1 + de))

    def forces(self):
        k, f = self.mistake, [0.0] * self.nodes
        slope = self.dx / 2 if k in ("natural_slope", "natural_slope_in_force") else 1
        if k == "gradient_without_h":
            slope = self.dx
        n = len(self.x)
        for p, w in enumerate(self.w):
            s = self.before[p] if k == "old_stress_new_start" else self.s[min(p + 1, n - 1)] if k == "stress_of_next" else self.s[p]
            volume = self.m[p] / (self.rho_before[p] if k == "volume_late" and self.steps + (self.scheme == "usf") else self.rho_p[p])
            if k == "volume_of_cell":
                volume *= self.ppc
            elif k == "mass_for_volume":
                volume = self.m[p]
            elif k == "volume_kept":
                volume = self.m[p] / self.rho
            elif k == "no_volume":
                volume = 1
            for i, N, dN in w:
                f[i] = self.r(f[i] + (1 if k == "force_sign" else -1) * dN * slope * s * volume)
        if k == "half_first_kick" and self.steps == 0:
            f = [0.5 * one for one in f]
        return f

    def map(self):
        m_i, p_i = self.kept if self.mistake == "keep_grid" else ([0.0] * self.nodes, [0.0] * self.nodes)
        for p, w in enumerate(self.w):
            for i, N, dN in w:
                m_i[i] = self.r(m_i[i] + self.m[p] * N)
                p_i[i] = self.r(p_i[i] + self.m[p] * self.v[p] * N)
        return m_i, p_i

    def fix(self, p_i):
        for i in range(self.held + 1):
            if self.mistake != "fix_next_node" or i == self.held:
                p_i[i] = 0.0

    def step(self):
        k, dt = self.mistake, self.dt
        self.w = [self.weights(p) for p in range(len(self.x))]
        m_i, p_i = self.map()
        if k not in ("no_fix_momentum", "fix_after_strain"):
            self.fix(p_i)
        if self.scheme == "usf":
            self.strain(p_i, m_i)
        if k == "fix_after_strain":
            self.fix(p_i)
        f = self.forces()
        if k not in ("no_fix_force", "held_acceleration"):
            self.fix(f)
        active = [m > 1e-12 for m in m_i]
        a = [f[i] / m_i[i] if active[i] else 0.0 for i in range(self.nodes)]
        if k == "held_acceleration":
            self.fix(f)
        old_v = [p_i[i] / m_i[i] if active[i] else 0.0 for i in range(self.nodes)]
        new_p = [self.r(p_i[i] + dt * f[i]) for i in range(self.nodes)]
        new_v = [new_p[i] / m_i[i] if active[i] else 0.0 for i in range(self.nodes)]
        if k == "keep_grid":
            self.kept = [m_i, new_p]
        for p, w in enumerate(self.w):
            kick = sum(N * a[i] for i, N, dN in w)
            move = sum(N * new_v[i] for i, N, dN in w)
            if k == "x_by_own_velocity":
                move = self.v[p] + dt * kick
            elif k == "x_by_old_node_velocity":
                move = sum(N * old_v[i] for i, N, dN in w)
            elif k == "x_by_half_step":
                move = sum(N * (old_v[i] + new_v[i]) / 2 for i, N, dN in w)
            self.v[p] = self.r(self.v[p] + dt * kick)
            self.x[p] = self.r(self.x[p] + dt * move)
        if self.scheme == "musl":
            new_p = [0.0] * self.nodes
            for p, w in enumerate(self.w):
                for i, N, dN in w:
                    new_p[i] = self.r(new_p[i] + self.m[p] * self.v[p] * N)
            if k != "no_second_fix":
                self.fix(new_p)
        if self.scheme != "usf":
            self.strain(new_p, m_i)
        self.node_v = new_v
        self.steps += 1

    def told(self):
        """What courses record."""
        M = sum(self.m)
        out = {"step": self.steps, "time": self.steps * self.dt,
               "v_cm": sum(m * v for m, v in zip(self.m, self.v)) / M,
               "x_cm": sum(m * x for m, x in zip(self.m, self.x)) / M,
               "kinetic": sum(0.5 * m * v * v for m, v in zip(self.m, self.v)),
               "strain": sum(0.5 * s * s / self.E * m / r for s, m, r in zip(self.s, self.m, self.rho_p))}
        out["total"] = out["kinetic"] + out["strain"]
        out = {k: self.r(x) if k != "step" else x for k, x in out.items()}
        out["v"], out["u"] = list(self.v), [x - x0 for x, x0 in zip(self.x, self.x0)]
        out["x"], out["sigma"], out["node"] = list(self.x), list(self.s), self.node_v
        return out

    def run(self, steps):
        rows = [self.told()]
        for _ in range(steps):
            try:
                self.step()
            except (IndexError, OverflowError):  # it has blown up
                break
            rows.append(self.told())
        return rows
