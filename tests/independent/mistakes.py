# SPDX-License-Identifier: GPL-3.0-or-later
"""Codes of one's own that are wrong in one place: the bar (bar.py) and the beam (beams.py) with a mistake.

mistakes.py                          against tests/golden/mistakes.txt
mistakes.py --mistake ID [CASE] [N]  N rows of a case (bar_A, bar_B, beam, beam_plain, bodies) as CSV: step, time, v_cm
                                     or vy; of bodies energies and momenta

Besides the mistakes ID may be right, and naive_stretch: a beam's |y| - |xi| as it stands.
"""
import sys

import numpy as np

import bar
import beams
import bodies
import bonds
import golden
import plane


class WrongBar(bar.Bar):
    """Lumped masses, each stage as bar.py has it but for the mistake."""

    def __init__(self, mistake, n, A, **given):
        super().__init__(modes=((n, A),), **given)
        self.mistake, self.made, beta = mistake, 0, (n - 0.5) * np.pi / self.L
        if mistake == "start_at_centres":
            self.v = A * np.sin(beta * (np.floor(self.x / self.dx) + 0.5) * self.dx)
        elif mistake == "mode_of_fixed_fixed":
            self.v = A * np.sin(n * np.pi / self.L * self.x)
        elif mistake == "mass_of_cell":
            self.m = np.full(len(self.x), self.rho0 * self.dx)
        elif mistake in ("gimp_whole_length", "gimp_half_of_half"):
            self.half *= 2 if mistake == "gimp_whole_length" else 0.5
        self.home, self.rho_before = np.floor(self.x / self.dx), self.rho

    def shapes(self):
        super().shapes()
        if self.mistake == "cells_kept":  # both hats of the first cell, as straight lines
            s = (self.x - self.xmin) / self.dx - (self.home - self.xmin / self.dx)
            here = (self.node[None, :] - self.xmin) / self.dx - (self.home - self.xmin / self.dx)[:, None]
            left, right = abs(here) < 1e-9, abs(here - 1) < 1e-9
            self.N = left * (1 - s)[:, None] + right * s[:, None]
            self.dN = (right * 1.0 - left) / self.dx
        self.right_dN = self.dN
        if self.mistake == "gradient_without_h":
            self.dN = self.dN * self.dx
        elif self.mistake == "natural_slope":
            self.dN = self.dN * self.dx / 2
        if self.mistake == "fix_next_node":
            ends = np.flatnonzero(~self.free)  # of the left end alone
            self.free[ends], self.free[ends[-1] + 1] = True, False

    def velocity_of(self, p):
        """Of every node, also of one that should be held and was forgotten."""
        return np.where(self.active, p / np.where(self.active, self.mass, 1), 0)

    def map(self):
        left = (0, 0)
        if self.mistake.startswith("keep_grid") and self.made:
            left = self.mass, self.p_integrated if self.mistake == "keep_grid_integrated" else self.p
        super().map()
        self.mass, self.p = self.mass + left[0], self.p + left[1]

    def map_momentum(self):
        super().map_momentum()
        if self.mistake == "keep_grid_twice" and self.stage == "map_again":
            self.p = self.p + self.p_integrated

    def fix(self):
        held = self.free.copy()
        again = self.stage == "map_again"
        if self.mistake in ("no_fix_momentum", "fix_after_strain", "fix_at_end") and not again:
            self.free[:] = True
        if self.mistake == "no_second_fix" and again:
            self.free[:] = True
        super().fix()
        self.free = held

    def gradient(self, u):
        return super().gradient(u) * (self.dx / 2 if self.mistake == "natural_slope_in_strain" else 1)

    def strain(self):
        old = self.stress, self.rho
        self.rho_before = self.rho
        super().strain()
        de = (self.stress - old[0]) / self.E
        if self.mistake in ("strain_without_dt", "stress_not_added", "density_kept", "density_inverted"):
            u, (first, last) = self.u.copy(), np.flatnonzero(self.active)[[0, -1]]
            u[:first], u[last + 1:] = u[first], u[last]
            de = (1 if self.mistake == "strain_without_dt" else self.dt) * (self.dN @ u)
        if self.mistake == "strain_without_dt":
            self.stress, self.rho = old[0] + self.E * de, old[1] / (1 + de)
        elif self.mistake == "stress_not_added":
            self.stress = self.E * de
        elif self.mistake == "density_kept":
            self.rho = old[1]
        elif self.mistake == "density_inverted":
            self.rho = old[1] * (1 + de)
        elif self.mistake == "fix_after_strain":
            self.p[~self.free] = 0
        self.stress_before = old[0]

    def force(self):
        stress = self.stress_before if self.mistake == "old_stress_new_start" else self.stress
        volume = self.m / self.rho
        if self.mistake == "volume_of_cell":
            volume = volume * round(1 / (2 * self.half))
        elif self.mistake == "mass_for_volume":
            volume = self.m
        elif self.mistake == "volume_late":
            volume = self.m / self.rho_before
        elif self.mistake == "volume_kept":
            volume = self.m / self.rho0
        elif self.mistake == "no_volume":
            volume = 1
        if self.mistake == "stress_of_next":
            stress = np.append(stress[1:], stress[-1])
        self.f = (1 if self.mistake == "force_sign" else -1) * (self.dN.T @ (stress * volume))
        if self.mistake == "natural_slope_in_force":
            self.f = self.f * self.dx / 2
        if self.mistake == "half_first_kick" and not self.made:
            self.f = self.f / 2
        if self.mistake not in ("no_fix_force", "held_acceleration", "fix_at_end"):
            self.f[~self.free] = 0
        self.a, self.u_before = self.velocity_of(self.f), self.velocity_of(self.p)

    def integrate(self):
        super().integrate()
        if self.mistake in ("held_acceleration", "fix_at_end"):
            self.p[~self.free] = 0
            self.new = self.velocity_of(self.p)
            self.u = self.u if self.algorithm == "usf" else self.new
        self.p_integrated = self.p

    def update(self):
        before = self.v
        super().update()
        if self.transfer == "apic" and self.shape == "hat":  # by the right slopes, whatever strains
            u, (first, last) = self.new.copy(), np.flatnonzero(self.active)[[0, -1]]
            u[:first], u[last + 1:] = u[first], u[last]
            self.C = self.right_dN @ u
            if self.mistake in ("affine_of_bspline", "affine_undivided"):
                self.C = (self.N * self.arm) @ u * (4 / self.dx ** 2 if self.mistake == "affine_of_bspline" else 1)
        if self.mistake == "x_by_own_velocity":
            self.moved = self.x + self.dt * self.v
        elif self.mistake == "x_by_old_node_velocity":
            self.moved = self.x + self.dt * (self.N @ self.u_before)
        elif self.mistake == "x_by_half_step":
            self.moved = self.x + self.dt * (self.N @ (self.u_before + self.new)) / 2
        elif self.mistake == "moved_weights":
            there = bar.hat if self.shape == "hat" else lambda r: bar.hat_mean(r, self.half)
            self.v = before + self.dt * (there((self.moved[:, None] - self.node) / self.dx)[0] @ self.a)

    def step(self):
        for self.stage in bar.STAGES[self.algorithm].split():
            getattr(self, self.stage)()
            if self.mistake == "x_by_mapped_velocity" and self.stage == "map_again":
                self.moved = self.x + self.dt * (self.N @ self.u)
        self.made += 1

    def told(self):
        kinetic = (self.m * self.v ** 2).sum() / 2
        if self.transfer == "apic" and self.mistake != "plain_kinetic":
            self.shapes()
            kinetic += (self.m * (self.N * self.arm ** 2).sum(1) * self.C ** 2).sum() / 2
        return {"v_cm": self.v.mean(), "kinetic": kinetic}


class WrongBody(bonds.Body):
    """The scheme of bonds.py but for the mistake; nothing breaks."""

    mistake, stepping = "right", "verlet"

    def set_bonds(self, volume, influence):
        delta = self.delta
        if self.mistake == "horizon_strict":
            self.delta = delta * (1 - 1e-8)
        if self.mistake == "horizon_as_diameter":
            self.delta = delta / 2
        super().set_bonds(volume, influence)
        if self.mistake == "horizon_as_diameter":  # c and w are still those of the whole
            self.delta, self.c, self.w = delta, 9 * self.E / (np.pi * delta ** 3), np.ones(len(self.w))
        elif self.mistake == "horizon_strict":  # the family alone is smaller
            whole = self.length <= delta - self.dx / 2
            self.delta, self.c = delta, 9 * self.E / (np.pi * delta ** 3)
            self.w = np.where(whole, 1, (delta + self.dx / 2 - self.length) / self.dx)
        elif self.mistake == "no_volume_factor":
            self.w = np.ones(len(self.w))
        elif self.mistake == "micromodulus_3d":
            self.c = 12 * self.E / (np.pi * delta ** 4)
        elif self.mistake == "micromodulus_plane_strain":
            self.c = 48 * self.E / (5 * np.pi * delta ** 3)

    def surface_factors(self, surface):
        return super().surface_factors("none" if self.mistake == "no_surface_factor" else surface)

    def start(self):
        super().start()
        if self.mistake == "start_unsupported":  # held from the first step on
            self.u = self.u_given
            self.bonds()

    def half_kick(self):
        self.v_before = self.v
        share = STEPPINGS[self.stepping][0]
        if self.stepping.startswith("leapfrog") and self.step_number == 0:
            share = 1 / 2
        if self.mistake == "no_first_force" and self.step_number == 0:
            share = 0
        self.v = self.v + share * self.dt * self.f / self.rho
        self.hold(self.step_number)
        if self.mistake == "euler_forward":  # the whole kick at once, by the force of the old place
            self.v = self.v_before + self.dt * self.f / self.rho
            self.hold(self.step_number)

    def drift(self):
        kicked = self.v
        if self.mistake == "euler_forward":
            self.v = self.v_before
        super().drift()
        if self.mistake == "u_added_twice":
            self.u = self.u + self.dt * self.v
        self.v = kicked

    def bonds(self):
        f_before = self.f
        super().bonds()
        if self.mistake == "force_not_reset":
            self.f = f_before + self.f
        elif self.mistake == "naive_stretch":  # no mistake: round-off of a difference of nearly equal lengths
            now = self.xi + self.u[:, self.j] - self.u[:, self.i]
            length = np.hypot(*now)
            self.s = (length - self.length) / self.length
            self.f = np.array([self.families(p, -p) for p in self.k * self.s * now / length])
        elif self.mistake in ("counted_twice", "bond_sign", "half_bond"):
            self.f = {"counted_twice": 2, "bond_sign": -1, "half_bond": 0.5}[self.mistake] * self.f
        elif self.mistake in ("one_way", "one_way_row_major", "stretch_of_current", "stretch_without_length",
                              "direction_of_reference", "first_neighbour", "last_neighbour"):
            now = self.xi + self.u[:, self.j] - self.u[:, self.i]
            length = np.hypot(*now)
            pull = self.k * self.s * now / length
            if self.mistake == "stretch_of_current":
                pull = pull * self.length / length
            elif self.mistake == "direction_of_reference":
                pull = self.k * self.s * self.xi / self.length
            elif self.mistake == "stretch_without_length":
                pull = pull * self.length
            first = (self.xi[0] > 0) | ((self.xi[0] == 0) & (self.xi[1] > 0))  # which end is the left one
            if self.mistake == "one_way_row_major":
                first = self.i < self.j
            at_i, at_j = (first, ~first) if self.mistake.startswith("one_way") else (1, 1)
            if self.mistake.endswith("_neighbour"):  # of each node's list, by numbers, one end is left out
                all_of, out = np.maximum if self.mistake == "last_neighbour" else np.minimum, np.arange(self.nx * self.ny)
                out = out * 0 + (-1 if self.mistake == "last_neighbour" else len(out))
                all_of.at(out, self.i, self.j)
                all_of.at(out, self.j, self.i)
                at_i, at_j = out[self.i] != self.j, out[self.j] != self.i
            self.f = np.array([self.families(p * at_i, -p * at_j) for p in pull])

    def load(self, step):
        return super().load(step) * (self.b if self.mistake == "weight_by_thickness" else 1)

    def second_kick(self):
        if self.mistake not in ("euler_forward", "no_second_kick"):
            self.v = self.v + STEPPINGS[self.stepping][1] * self.dt * self.f / self.rho
        self.hold(self.step_number + 1)

    def told(self):
        return {"v_probe": self.v[1, self.probe].mean()}


STEPPINGS = {"verlet": (1 / 2, 1 / 2), "euler": (1, 0), "euler_position": (0, 1), "leapfrog": (1, 0),
             "leapfrog_ahead": (0, 1)}


class WrongRod:
    """The bar, fixed at the left and free at the right, by bonds: each node asks all others; a fixed end is a mirror."""

    def __init__(self, mistake, stepping, mode, speed, L, E, rho, h, dt, surface, volume):
        self.mistake, self.stepping, self.rho, self.dt, self.number = mistake, stepping, rho, dt, 0
        n, delta = round(L / h), 3 * h
        reach = {"horizon_strict": delta * (1 - 1e-9), "horizon_as_diameter": delta / 2}.get(mistake, delta) * (1 + 1e-12)
        self.X = (np.arange(n) + 0.5) * h
        place = np.concatenate([-self.X[::-1], self.X])  # those left of 0 are the images
        self.xi = place[None, :] - self.X[:, None]
        far = abs(self.xi)
        bond = (far > h / 2) & (far <= reach)
        if mistake == "horizon_strict":
            bond &= far < delta - h / 2
        w = np.ones_like(far)
        if volume == "partial" and mistake != "no_volume_factor":
            w = np.clip((delta + h / 2 - far) / h, 0, 1)
        c = 2 * E / delta ** 2
        if mistake in ("first_neighbour", "last_neighbour"):  # after the factors of the whole family
            self.left_out = [np.flatnonzero(row)[0 if mistake == "first_neighbour" else -1] for row in bond]
        held = (c * w * h * far / 4 * bond).sum(1)
        g = np.ones(n) if surface == "none" or mistake == "no_surface_factor" else E / 2 / held
        both = np.concatenate([g[::-1], g])
        self.k = np.where(bond, c * w * h * (g[:, None] + both[None, :]) / 2, 0)
        if mistake in ("first_neighbour", "last_neighbour"):
            self.k[np.arange(n), self.left_out] = 0
        self.u, self.f = np.zeros(n), np.zeros(n)
        self.v = speed * np.sin((mode - 0.5) * np.pi / L * self.X)
        self.bonds()

    def bonds(self):
        whole = np.concatenate([-self.u[::-1], self.u])
        now = self.xi + whole[None, :] - self.u[:, None]
        rest = abs(np.where(self.k > 0, self.xi, 1))
        eta = now - self.xi
        lengthening = np.where(self.k > 0, eta * (2 * self.xi + eta) / (abs(now) + rest), 0)
        over = {"stretch_of_current": np.where(self.k > 0, abs(now), 1), "stretch_without_length": 1}.get(self.mistake, rest)
        factor = {"counted_twice": 2, "bond_sign": -1, "half_bond": 0.5}.get(self.mistake, 1)
        if self.mistake == "one_way":
            factor = self.xi > 0
        f = (factor * self.k * lengthening / over * np.sign(now)).sum(1)
        self.f = self.f + f if self.mistake == "force_not_reset" else f

    def step(self):
        first, second = STEPPINGS[self.stepping]
        if self.stepping.startswith("leapfrog") and self.number == 0:
            first = 1 / 2
        if self.mistake == "euler_forward":
            self.u, self.v = self.u + self.dt * self.v, self.v + self.dt * self.f / self.rho
            first = second = 0
        else:
            if self.mistake != "no_first_force" or self.number > 0:
                self.v = self.v + first * self.dt * self.f / self.rho
            self.u = self.u + (2 if self.mistake == "u_added_twice" else 1) * self.dt * self.v
        self.bonds()
        if self.mistake != "no_second_kick":
            self.v = self.v + second * self.dt * self.f / self.rho
        self.number += 1

    def told(self):
        return {"v_cm": self.v.mean()}


class WrongCells(plane.Beam):
    """The supported beam by the material point method, each stage as plane.py has it but for the mistake."""

    def __init__(self, mistake, given):
        number = lambda key: float(given[key])
        self.mistake, self.mass = mistake, 0
        super().__init__(*(number("beam." + key) for key in ("length", "height", "thickness", "youngs_modulus", "density", "poisson")),
                         number("mesh.cell_size"), int(given["mesh.particles_per_cell"]), number("initial.amplitude"),
                         number("time.courant"), 2, False, given["mpm.shape"], given["mpm.algorithm"])
        if mistake == "mass_of_cell":
            self.m *= self.P ** 2
        self.rho_before = self.rho

    def shapes(self):
        box = {"gimp_whole_length": 2, "gimp_half_of_half": 0.5}.get(self.mistake, 1)
        self.P, P = self.P / box, self.P
        super().shapes()
        self.P = P

    def slope(self, stage):
        natural = self.mistake in ("natural_slope", "natural_slope_in_" + stage)
        return self.dx if self.mistake == "gradient_without_h" else self.dx / 2 if natural else 1

    def held(self, step):
        if self.mistake != "fix_next_node":
            return super().held(step)
        x, y = self.nodes(step)
        left, right = (abs(x - place) < 1e-6 * self.dx for place in (self.dx, self.L - self.dx))
        return left & (abs(y) < 1e-6 * self.dx), left | right

    def map(self):
        mass, p = (self.mass, self.p_kept) if self.mistake.startswith("keep_grid") and self.step_number else (0, 0)
        super().map()
        self.mass, self.p = self.mass + mass, self.p + p

    def hold(self):
        if self.mistake in ("no_fix_momentum", "fix_after_strain", "fix_at_end"):
            self.u = self.velocity()
        else:
            super().hold()
        self.u_before = self.velocity()

    def hold_again(self):
        if self.mistake == "keep_grid_twice":
            self.p = self.p + self.p_integrated
        if self.mistake == "no_second_fix":
            self.u = self.velocity()
        else:
            super().hold()
        if self.mistake == "x_by_mapped_velocity":
            self.x = self.x + self.dt * self.u @ self.N.T

    def strain(self):
        k, self.s_before, self.rho_before = self.mistake, self.s, self.rho
        e = (1 if k == "strain_without_dt" else self.dt) * self.strain_by(self.u) * self.slope("strain")
        self.s = (0 if k == "stress_not_added" else self.s) + self.stress_of(e)
        left = 1 + e[0] + e[1]
        self.rho = self.rho if k == "density_kept" else self.rho * left if k == "density_inverted" else self.rho / left
        if k == "fix_after_strain":
            along, across = self.held(self.step_number)
            self.p[0, along] = self.p[1, across] = 0
            self.u_before = self.velocity()

    def force(self):
        k, whole = self.mistake, np.ones_like(self.rho)
        V = {"no_volume": whole, "mass_for_volume": self.m * whole, "volume_of_cell": self.P ** 2 * self.m / self.rho,
             "volume_kept": self.dx ** 2 / self.P ** 2 * whole, "volume_late": self.m / self.rho_before}.get(k, self.m / self.rho)
        s = self.s_before if k == "old_stress_new_start" else self.s
        if k == "stress_of_next":
            s = np.concatenate([s[:, 1:], s[:, -1:]], axis=1)
        xx, yy, xy = (1 if k == "force_sign" else -1) * self.slope("force") * s * V
        self.f = np.array([xx @ self.Nx + xy @ self.Ny, xy @ self.Nx + yy @ self.Ny])
        if k == "half_first_kick" and self.step_number == 0:
            self.f = self.f / 2

    def hold_force(self):
        self.pull = self.f.copy()
        if self.mistake != "no_fix_force":
            super().hold_force()
        if self.mistake not in ("held_acceleration", "fix_at_end"):
            self.pull = self.f

    def integrate(self):
        if self.mistake == "fix_at_end":
            along, across = self.held(self.step_number)
            self.p[0, along] = self.p[1, across] = 0
        super().integrate()
        self.p_integrated = self.p

    def update(self):
        move = {"x_by_own_velocity": None, "x_by_old_node_velocity": self.u_before, "x_by_half_step": (self.u_before + self.new) / 2,
                "x_by_mapped_velocity": 0 * self.new}.get(self.mistake, self.new)
        before, self.f = self.x, self.pull
        super().update()
        self.x = before + self.dt * (self.v if move is None else move @ self.N.T)

    def step(self):
        super().step()
        self.p_kept = self.p_integrated if self.mistake == "keep_grid_integrated" else self.p

    def told(self):
        return {"v_probe": self.v[1, self.probe].mean()}


class WrongBodies(bodies.Bodies):
    def __init__(self, mistake, given):
        words = {"hypoelastic": "hypo", "neo-hookean": "neo"}
        of = lambda key, other: given.get(key, other)
        case = [["set", short, words.get(of(key, other), of(key, other))] for short, key, other in (
            ("E", "material.youngs_modulus", "1000"), ("nu", "material.poisson", "0.3"), ("rho", "material.density", "1000"),
            ("dx", "mesh.cell_size", "0.05"), ("P", "mesh.particles_per_cell", "2"), ("courant", "time.courant", "0.2"),
            ("W", "domain.width", "1"), ("H", "domain.height", "1"), ("left", "domain.left", "open"),
            ("right", "domain.right", "open"), ("bottom", "domain.bottom", "open"), ("top", "domain.top", "open"),
            ("muw", "domain.wall_friction", "0"), ("mu", "contact.friction", "0"), ("near", "contact.gap", "0.4"),
            ("law", "material.law", "hypo"), ("plane", "material.plane", "strain"), ("shape", "mpm.shape", "gimp"),
            ("algo", "mpm.algorithm", "usf"), ("alpha", "mpm.flip_fraction", "1"))]
        case += [["set", "apic", "1" if of("mpm.transfer", "flip") == "apic" else "0"], ["set", "contact", "1"],
                 ["set", "gx", "0"], ["set", "gy", "-" + of("load.gravity", "0")]]
        self.names = [key[7:] for key in given if key.startswith("bodies.")]
        for name in self.names:  # KIND SIZE... [velocity VX VY] [spin W]
            kind, *rest = given["bodies." + name].split()
            sizes = [w for w in rest[:4 if kind != "disc" else 3]]
            behind = lambda word, n: rest[rest.index(word) + 1:][:n] if word in rest else ["0"] * n
            case.append(["body", kind, *sizes, *behind("velocity", 2), *behind("spin", 1)])
        self.mistake = mistake
        super().__init__(case)

    def turned(self, L):
        if self.mistake == "no_rotation":
            return self.s
        return super().turned([L[0], L[2], L[1], L[3]] if self.mistake == "spin_sign" else L)

    def normal(self, a, b):
        return self.n[:, a] if self.mistake == "normal_of_one" else super().normal(a, b)

    def first_fix(self, q):
        if self.mistake != "no_first_fix":
            self.fix(q)
        if self.mistake == "start_after_contact":
            self.q0 = q.copy()

    def strain(self, q):
        G, V = self.G, self.V
        self.G = G / 2 if self.mistake == "tensor_shear" else G
        super().strain(q)
        self.G = G
        if self.mistake == "body_volume_kept":
            self.V = V

    def told(self):
        last = self.field == self.n_fields - 1
        return {f"{self.names[-1]}.vx": self.v[0, last].mean(), "kinetic": self.sums()[0]}

    def series(self):
        """What --mistake writes besides."""
        kinetic, potential, px, py = self.sums()
        middle = np.array([self.value["W"], self.value["H"]]) / 2
        x = self.x - middle[:, None]
        turn = self.m * (x[0] * self.v[1] - x[1] * self.v[0]).sum()
        if self.value["apic"]:
            turn += self.m * (self.B[2] - self.B[1]).sum()
        return {"kinetic": kinetic, "potential": potential, "momentum_x": px, "momentum_y": py, "angular": turn}


def code_of(given, mistake):
    """A code of one's own at its start, made from the settings of a case."""
    number = lambda *keys: [float(given[key]) for key in keys]
    if given.get("scenario.method") == "pd":
        L, E, rho, dx, courant = number("bar.length", "bar.youngs_modulus", "bar.density", "mesh.cell_size",
                                        "time.courant")
        return WrongRod(mistake, given.get("pd.stepping", "verlet"), int(given["initial.mode"]),
                        float(given["initial.velocity"]), L, E, rho, dx / int(given["mesh.particles_per_cell"]),
                        courant * dx / np.sqrt(E / rho), given["pd.surface_correction"], given["pd.volume_correction"])
    if any(key.startswith("bodies.") for key in given):
        return WrongBodies(mistake, given)
    if "bar.length" in given:
        L, E, rho, dx, courant = number("bar.length", "bar.youngs_modulus", "bar.density", "mesh.cell_size",
                                        "time.courant")
        return WrongBar(mistake, int(given["initial.mode"]), float(given["initial.velocity"]), L=L, E=E, rho=rho, dx=dx,
                        P=int(given["mesh.particles_per_cell"]), courant=courant,
                        **{key: given[f"mpm.{key}"] for key in ("algorithm", "shape", "transfer") if f"mpm.{key}" in given})
    if given.get("scenario.method") == "mpm":
        return WrongCells(mistake, given)
    kind = type("WrongBeam", (WrongBody,), {"mistake": mistake, "stepping": given.get("pd.stepping", "verlet")})
    beams.Body, right = kind, beams.Body
    E, rho, thickness, dt = number("beam.youngs_modulus", "beam.density", "beam.thickness", "time.step")
    body = beams.supported_beam(*number("beam.length", "beam.height", "pd.spacing", "pd.horizon", "initial.amplitude"),
                                E=E, rho=rho, thickness=thickness, dt=dt, surface=given["pd.surface_correction"],
                                volume=given["pd.volume_correction"])
    beams.Body, body.u_given = right, body.u.copy()
    body.weight = float(given.get("load.body_force", 0))
    left, slide = np.arange(body.ny) * body.nx, None
    if mistake == "support_edges":
        body.supports = [(left, (0, 0)), (left + body.nx - 1, (slide, 0))]
    elif mistake == "supports_pinned":
        body.supports = [(nodes, (0, 0)) for nodes, _ in body.supports]
    body.start()
    return body


def compare(name, case):
    given, steps = golden.settings(case), [int(n) for n in next(words for words in case if words[0] == "steps")[1:]]
    rows = {}
    for words in case:
        if words[0] == "mistake":
            rows.setdefault(words[1], {})[words[2]] = golden.numbers(words[3:])
    for mistake, expected in rows.items():
        told, code, step = golden.Comparison(f"mistakes.txt {name} {mistake}"), code_of(given, mistake), 0
        share = 1e-11 if isinstance(code, bar.Bar) else 1e-9
        for at, position in zip(steps, range(max(len(digits) for digits in expected.values()))):
            while step < at:
                code.step()
                step += 1
            for what, value in code.told().items():
                digits = expected[what][:position + 1]
                if position < len(expected[what]) and abs(digits[-1]) < 1e150:  # beyond it, squares are no numbers
                    told.near(f"{what} at step {at}", value, digits[-1], share * np.abs(digits).max())
        told.tell()


def write_rows(mistake, name, steps):
    code = code_of(golden.settings(dict(golden.cases("mistakes.txt"))[name]), mistake)
    several = isinstance(code, WrongBodies)
    column = "v_cm" if isinstance(code, (bar.Bar, WrongRod)) else ",".join(code.series()) if several else "vy"
    print(f"step,time,{column}")
    for step in range(steps + 1):
        if step:
            code.step()
        told = list(code.series().values()) if several else [next(iter(code.told().values()))]
        print(f"{step},{step * code.dt:.17g}," + ",".join("%.17g" % value for value in told))


if __name__ == "__main__":
    if sys.argv[1:2] == ["--mistake"]:
        write_rows(sys.argv[2], *sys.argv[3:4] or ["bar_A"], int((sys.argv[4:5] or ["100"])[0]))
        sys.exit()
    with np.errstate(all="ignore"):  # some of them blow up
        for name, case in golden.cases("mistakes.txt"):
            compare(name, case)
    golden.end()
