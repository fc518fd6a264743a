# SPDX-License-Identifier: GPL-3.0-or-later
"""Bond-based peridynamics on a square lattice, as matvib-equations(7) has it; beams.py and plates.py are its bodies.

Each bond stands once in the arrays, from node i to node j; what it pulls is added to both. A step is a list of
stages, each a function; nothing else changes the state. Of a pair (x, y) there is one array with two rows.
"""
import numpy as np

STAGES = "half_kick drift constraints bonds body_force second_kick damage"


class Body:
    def __init__(self, nx, ny, dx, delta, E, rho, x0=0.0, y0=0.0, thickness=1.0, surface="energy", volume="partial",
                 influence="constant", s0=0.0, dt=0.0):
        self.nx, self.ny, self.dx, self.delta = nx, ny, dx, delta
        self.E, self.rho, self.V, self.b = E, rho, dx * dx, thickness
        self.s0, self.dt = s0 if s0 > 0 else np.inf, dt
        node = np.arange(nx * ny)
        self.X, self.Y = x0 + (node % nx + 0.5) * dx, y0 + (node // nx + 0.5) * dx
        self.set_bonds(volume, influence)
        self.g = self.energy_factors()
        self.k = self.c * self.shape * self.surface_factors(surface) * self.w * self.V  # c G w V
        self.alive = np.ones(len(self.i), bool)
        # at rest; held, loaded, protected by whom makes a body of it
        self.u, self.v, self.f = (np.zeros((2, nx * ny)) for _ in range(3))
        self.step_number, self.work, self.dissipated, self.damped, self.broken, self.cut = 0, 0.0, 0.0, 0.0, 0, 0
        self.supports, self.loads, self.protected, self.probe = [], [], np.zeros(nx * ny, bool), [0]
        self.s = None  # before the first force
        self.clamp, self.speed, self.weight, self.alpha = None, 0.0, 0.0, 0.0

    # --- the lattice -------------------------------------------------------------------------------------------
    def set_bonds(self, volume, influence):
        """Half of each family: partners above, and in the same row those to the right."""
        dx, delta, parts = self.dx, self.delta, []
        node = np.arange(self.nx * self.ny).reshape(self.ny, self.nx)
        farthest = (delta + dx / 2) * (1 - 1e-9) if volume == "hhb" else delta * (1 + 1e-9)
        reach = int(farthest / dx)
        for q in range(min(reach + 1, self.ny)):
            for p in range(-reach if q else 1, reach + 1):
                length = np.hypot(p * dx, q * dx)
                if length > farthest:
                    continue
                first = node[:self.ny - q, max(0, -p):self.nx - max(0, p)].ravel()
                w = 1 if volume == "none" or length <= delta - dx / 2 else (delta + dx / 2 - length) / dx
                shape = 1 - length / delta if influence == "conical" else 1
                alike = np.outer((p * dx, q * dx, w, shape), np.ones(len(first)))
                parts.append(np.vstack([first, first + q * self.nx + p, alike]))
        bonds = np.concatenate(parts, axis=1)
        bonds = bonds[:, np.lexsort((bonds[1], bonds[0]))]
        self.i, self.j = bonds[:2].astype(int)
        self.xi, self.w, self.shape = bonds[2:4], bonds[4], bonds[5]
        self.length = np.hypot(*self.xi)
        self.area = self.families(self.w * self.V, self.w * self.V)  # of all within reach, whatever their c
        if influence == "conical":
            bonded = self.length < delta * (1 - 1e-9)
            self.i, self.j, self.xi, self.w = self.i[bonded], self.j[bonded], self.xi[:, bonded], self.w[bonded]
            self.shape, self.length = self.shape[bonded], self.length[bonded]
        self.c = 9 * self.E / (np.pi * delta ** 3) * (4 if influence == "conical" else 1)

    def families(self, to_i, to_j):
        """What bonds give to their two ends, summed over the family of each node."""
        n = self.nx * self.ny
        return np.bincount(self.i, to_i, n) + np.bincount(self.j, to_j, n)

    def energy_factors(self):
        """g: the energy density of a unit stretch along x (y), over what the node's family holds of it."""
        held = self.c * self.shape * (self.xi / self.length) ** 4 * self.length * self.w * self.V / 4
        return 9 / 16 * self.E / np.array([self.families(h, h) for h in held])

    def surface_factors(self, surface):
        """G of each bond."""
        if surface == "energy":  # an ellipse with the half axes g
            axes = (self.g[:, self.i] + self.g[:, self.j]) / 2
            return ((self.xi / self.length / axes) ** 2).sum(0) ** -0.5
        if surface == "volume":
            return 2 * np.pi * self.delta ** 2 / (self.area[self.i] + self.area[self.j])
        return np.ones(len(self.i))

    def cut_along(self, x0, y0, x1, y1):
        """Takes away the bonds that cross a line, and tells how many these are."""
        t, size = 1e-6 * self.dx, np.hypot(x1 - x0, y1 - y0)
        tx, ty = (x1 - x0) / size, (y1 - y0) / size
        across = tx * (self.Y - y0) - ty * (self.X - x0)
        along = tx * (self.X - x0) + ty * (self.Y - y0)
        left = across > t
        parted = np.flatnonzero(self.alive & (left[self.i] != left[self.j]))
        i, j = self.i[parted], self.j[parted]
        s = along[i] + (along[j] - along[i]) * across[i] / (across[i] - across[j])
        gone = parted[(s >= -t) & (s <= size + t)]
        self.alive[gone], self.k[gone] = False, 0
        self.cut += len(gone)
        return len(gone)

    def region(self, x0, y0, x1, y1, inside=False):
        """The nodes of a rectangle, those on its edges included; or those strictly inside."""
        t = (-1e-6 if inside else 1e-6) * self.dx
        return np.flatnonzero((self.X > min(x0, x1) - t) & (self.X < max(x0, x1) + t)
                              & (self.Y > min(y0, y1) - t) & (self.Y < max(y0, y1) + t))

    # --- what is held, and what pulls --------------------------------------------------------------------------
    def hold(self, step, places=False):
        """Supports are (nodes, (vx, vy)), None a component that is free; the clamp holds what is in its channel."""
        for nodes, speeds in self.supports:
            for axis, speed in enumerate(speeds):
                if speed is not None:
                    self.v[axis, nodes] = speed
        if self.clamp:
            inside = self.X + self.speed * step * self.dt < -1e-6 * self.dx
            self.v[1, inside] = 0
            self.u[1, inside] *= not places
            if self.clamp == "full":
                self.v[0, inside] = self.speed
                self.u[0, inside] = self.speed * step * self.dt if places else self.u[0, inside]

    def load(self, step):
        """Force density of the loads, (nodes, (sx, sy), ramp, until), and of the weight."""
        density = np.zeros_like(self.u)
        density[1] = self.rho * self.weight
        for nodes, traction, ramp, until in self.loads:
            share = min(1, step * self.dt / ramp) if ramp > 0 else 1
            late = step - round(until / self.dt) if until < np.inf else -1
            share *= 0 if late > 0.25 else 0.5 if late > -0.25 else 1
            density[:, nodes] += np.array(traction)[:, None] * share / self.dx
        return density

    def take_reaction(self):
        """Half a step's work of what moves supports: against the force, and against the damping."""
        power = sum(((self.alpha * self.rho * speed - self.f[axis, nodes]) * speed).sum()
                    for nodes, speeds in self.supports for axis, speed in enumerate(speeds) if speed)
        self.work += power * self.V * self.b * self.dt / 2

    def start(self):
        """Supports begin as they go on, and undeformed; then the first force, and the first damage."""
        for nodes, speeds in self.supports:
            for axis, speed in enumerate(speeds):
                if speed is not None:
                    self.u[axis, nodes], self.v[axis, nodes] = 0, speed
        self.bonds()
        self.f = self.f + self.load(0)
        self.damage()

    # --- the stages --------------------------------------------------------------------------------------------
    def half_kick(self):
        ahead = np.array([[self.speed], [0]])  # a beam that is drawn along is braked beside that
        self.v = ahead + (1 - self.alpha * self.dt / 2) * (self.v - ahead) + self.dt / 2 * self.f / self.rho
        self.hold(self.step_number)

    def drift(self):
        self.u = self.u + self.dt * self.v
        scale, ahead = self.V * self.b * self.dt, np.array([[self.speed], [0]])
        self.work += (self.load(self.step_number + 0.5) * self.v).sum() * scale
        self.damped += self.alpha * self.rho * ((self.v - ahead) ** 2).sum() * scale
        self.take_reaction()

    def constraints(self):
        self.hold(self.step_number + 1, places=True)

    def bonds(self):
        eta = self.u[:, self.j] - self.u[:, self.i]
        now = self.xi + eta
        length = np.hypot(*now)
        before, self.s = self.s, (eta * (self.xi + now)).sum(0) / (self.length * (length + self.length))
        before = self.s if before is None else before
        safe = self.protected[self.i] | self.protected[self.j]
        self.gone = np.flatnonzero(self.alive & (self.s >= self.s0) & ~safe)
        self.dissipated += self.energies(before * self.s)[self.gone].sum()
        self.alive[self.gone], self.k[self.gone] = False, 0
        self.broken += len(self.gone)
        pull = self.k * self.s * now / length
        self.f = np.array([self.families(p, -p) for p in pull])

    def body_force(self):
        self.f = self.f + self.load(self.step_number + 1)

    def second_kick(self):
        ahead = np.array([[self.speed], [0]])
        self.v = ahead + (self.v - ahead + self.dt / 2 * self.f / self.rho) / (1 + self.alpha * self.dt / 2)
        self.hold(self.step_number + 1)
        self.take_reaction()

    def damage(self):
        if len(self.gone) or self.step_number == 0:
            whole, left = self.w * self.V, self.alive * self.w * self.V
            self.phi = 1 - self.families(left, left) / self.families(whole, whole)

    def step(self):
        for stage in STAGES.split():
            getattr(self, stage)()
        self.step_number += 1

    # --- what is told between steps ----------------------------------------------------------------------------
    def energies(self, squared):
        return self.k * squared * self.length * self.V / 2 * self.b

    def row(self):
        (ux, uy), (vx, vy) = self.u[:, self.probe].mean(1), self.v[:, self.probe].mean(1)
        return {"ux": ux, "uy": uy, "vx": vx, "vy": vy, "strain": self.energies(self.s ** 2).sum(), "work": self.work,
                "kinetic": self.rho / 2 * (self.v ** 2).sum() * self.V * self.b, "dissipated": self.dissipated,
                "damped": self.damped, "broken": self.broken}
