# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs that nobody chose: parameters drawn by chance (the same ones each time), done by the program and by the programs
of this folder. What the least change of the start makes of such a run is what two programs may differ by; runs that it
changes by more than 1e-9 tell nothing, nor do parameters that the program refuses.
"""
import csv
import math
import os
import random
import subprocess
import sys
import tempfile

import numpy as np

import golden
from bar import bar_of
from bodies import Bodies
from plane import Beam
from plates import plate

EACH = 40  # of a kind


class Drawn:
    """A scenario, {"section.key": value}, its steps, and the model of it: make(), fields(model), sums(model)."""

    def __init__(self, problem, method, values, steps, make, fields, sums):
        self.values = {"scenario.problem": problem, "scenario.method": method} | values | {"time.end": 1e6}
        self.steps, self.make, self.fields, self.sums = steps, make, fields, sums


def bar(r):
    dx, n, E, rho = r.choice([1, .5, .3, 2]), r.randint(6, 30), r.choice([100, 1e3, 2.5]), r.choice([1, 7.8, .3])
    transfer = r.choice(["flip", "flip", "apic", "fmpm"])
    values = {"bar.length": dx * n, "bar.youngs_modulus": E, "bar.density": rho, "mesh.cell_size": dx,
              "bar.supports": r.choice(["fixed-free", "free-fixed", "fixed-fixed", "free-free"]),
              "initial.mode": r.randint(1, n // 2), "initial.velocity": r.choice([.01, 1e-3, -.03]) * math.sqrt(E / rho),
              "initial.offset": r.choice([0, .2, -.3]), "mesh.particles_per_cell": r.randint(1, 5), "mesh.padding": 4,
              "mpm.algorithm": r.choice(["usf", "usl", "musl"]), "mpm.transfer": transfer,
              "mpm.shape": r.choice(["hat", "gimp", "cpdi", "bspline2", "bspline3", "bspline2_uniform"]),
              "time.courant": r.choice([.05, .1, .2, .4])}
    values |= {"flip": {"mpm.flip_fraction": r.choice([1, .99, .5]), "mpm.mass_blend": r.choice([1, .7])},
               "apic": {"mpm.affine_start": r.choice(["gradient", "zero"])}, "fmpm": {"mpm.fmpm_order": r.randint(2, 6)}}[transfer]
    speed = abs(values["initial.velocity"])
    stress = lambda m: max(abs(m.stress).max(), 1e-3 * math.sqrt(E * rho) * speed)
    fields = lambda m: {"x": (m.x, m.L / 100), "v": (m.v, speed), "stress": (m.stress, stress(m)), "density": (m.rho, rho / 100)}
    return Drawn("bar", "mpm", values, r.choice([1, 20, 100]), lambda: bar_of({k: str(v) for k, v in values.items()}, "gradient"),
                 fields, lambda m: {})


def beam(r):
    h, n, moves = r.choice([.004, .005]), r.choice([2, 4]), r.random() < .5
    dx, columns, P, nu, pad = h / n, r.randint(6, 16), r.choice([2, 3]), r.choice([0, .3, 1 / 3]), r.choice([2, 3])
    E, rho = r.choice([(71e9, 2700.0), (3e9, 1200.0)])
    U, courant, alpha = r.choice([1e-6, 1e-5]), r.choice([.1, .3, .5]), r.choice([1, .95])
    shape, algorithm, steps = r.choice(["hat", "gimp"]), r.choice(["usf", "usl", "musl"]), r.choice([1, 20, 60])
    start, stress = r.choice(["deflection", "velocity"]), r.choice(["relaxed", "grid", "beam"])
    ends, clamp = r.choice(["section", "point"]), r.choice(["full", "guide"])
    speed, channel = (r.choice([10.0, 100.0]), dx * r.randint(2, 6)) if moves else (0.0, 0.0)
    rides = r.choice([0.0, speed])
    values = {"beam.length": columns * dx, "beam.height": h, "beam.thickness": .001, "beam.youngs_modulus": E, "beam.density": rho,
              "beam.poisson": nu, "initial.amplitude": U, "initial.start": start, "initial.stress": stress, "mesh.cell_size": dx,
              "mesh.particles_per_cell": P, "mesh.padding": pad, "mpm.algorithm": algorithm, "mpm.shape": shape,
              "mpm.flip_fraction": alpha, "time.courant": courant}
    values |= {"mesh.velocity": rides, "motion.speed": speed, "motion.channel": channel, "motion.clamp": clamp} if moves else {
        "supports.ends": ends}
    make = lambda: Beam(columns * dx, h, .001, E, rho, nu, dx, P, U, courant, pad, moves, shape, algorithm, alpha, start,
                        "exact" if stress == "beam" else stress, ends, clamp, speed, channel, rides, steps)
    most = lambda m: max(abs(m.v[0] - speed).max(), abs(m.v[1]).max())
    fields = lambda m: ({"x": (m.x[0], m.L), "y": (m.x[1], m.L), "vx": (m.v[0], most(m)), "vy": (m.v[1], most(m)),
                         "density": (m.rho, rho)}
                        | {name: (s, abs(m.s).max()) for name, s in zip(("sxx", "syy", "sxy"), m.s)})
    return Drawn("moving-cantilever" if moves else "simply-supported-beam", "mpm", values, steps, make, fields, lambda m: {})


def bodies(r):
    dx = r.choice([.1, .125, .0625])
    W, H = dx * r.randint(round(1 / dx), round(1.6 / dx)), dx * r.randint(round(.8 / dx), round(1.4 / dx))
    E, rho, nu, P, law = r.choice([1000, 300.0]), r.choice([1000, 50.0]), r.choice([0, .3, .4]), r.choice([2, 3]), r.choice(
        ["hypo", "hypo", "neo", "unrot"])
    c, plane, apic = math.sqrt(E / rho), "strain" if law == "neo" else r.choice(["strain", "stress"]), r.random() < .4
    gravity, incline, near, one = r.choice([0, 1, 9.81]) * E / rho / 20, r.choice([0, 20, -35]), r.choice([.3, .5]), r.random() < .25
    walls = {side: r.choice(["open", "clamp", "slip", "friction"]) for side in ("left", "right", "bottom", "top")}
    shape, algorithm = r.choice(["hat", "gimp", "bspline2"]), r.choice(["usf", "usl", "musl"])
    mu, muw, courant, alpha = r.choice([0, .2, 2]), r.choice([0, .3]), r.choice([.1, .2, .4]), 1 if apic else r.choice([1, .95])
    shapes, values = [], {}
    for k in range(r.randint(1, 3)):
        R = r.uniform(.12, .3)
        x, y = r.uniform(R, W - R), r.uniform(R, H - R)
        size = r.choice([("disc", [x, y, R]), ("ring", [x, y, R / 2, R]), ("block", [x - R, y - R / 2, x + R, y + R / 2])])
        motion = [r.uniform(-.1, .1) * c, r.uniform(-.1, .1) * c, r.choice([0, .3]) * c]
        shapes.append([size[0], *map(repr, size[1] + motion)])
        values[f"bodies.b{k}"] = "%s %s velocity %r %r spin %r" % (size[0], " ".join(map(repr, size[1])), *motion)
    values |= {"domain.width": W, "domain.height": H, "domain.wall_friction": muw, "material.youngs_modulus": E,
               "material.density": rho, "material.poisson": nu, "material.plane": plane, "mesh.cell_size": dx,
               "material.law": "neo-hookean" if law == "neo" else "hypoelastic", "mesh.particles_per_cell": P, "mpm.shape": shape,
               "mpm.algorithm": algorithm, "mpm.transfer": "apic" if apic else "flip", "mpm.flip_fraction": alpha,
               "load.gravity": gravity, "load.incline": incline, "contact.fields": "one" if one else "each",
               "contact.friction": mu, "contact.gap": near, "time.courant": courant}
    values |= {"domain." + side: kind for side, kind in walls.items()}
    values |= {} if law == "neo" else {"mpm.rotation": "none" if law == "unrot" else "jaumann"}
    tilt = math.radians(incline)
    told = {"E": E, "nu": nu, "rho": rho, "dx": dx, "P": P, "gx": gravity * math.sin(tilt), "gy": -gravity * math.cos(tilt),
            "law": law, "alpha": alpha, "apic": int(apic), "contact": int(not one), "near": near, "mu": mu, "muw": muw, "W": W, "H": H,
            "plane": plane, "shape": "bsp2" if shape == "bspline2" else shape, "algo": algorithm, "courant": courant} | walls
    case = [["set", k, {"friction": "fric"}.get(v, str(v))] for k, v in told.items()] + [["body", *words] for words in shapes]
    names = ("x", "y", "vx", "vy", "sxx", "syy", "sxy", "density")
    fields = lambda m: {name: (f, max(abs(f).max(), 1e-6 * E if name[0] == "s" else 1e-12)) for name, f in zip(names, m.columns())}
    return Drawn("bodies", "mpm", values, r.choice([10, 40, 90]), lambda: Bodies(case), fields, lambda m: {})


def plates(r):
    dx, m = r.choice([.001, .002]), r.choice([3, 3.015, 4, 2.5, 5])
    L, h, delta = dx * r.randint(16, 50), dx * r.randint(12, 30), dx * m
    E, rho, s0, alpha, g = 71e9, 2700.0, r.choice([0, 1e-3, 5e-4]), r.choice([0, 1e4]), r.choice([0, -9.81e4])
    kind = {"surface_correction": r.choice(["none", "energy", "volume"]), "influence": r.choice(["constant", "conical"]),
            "volume_correction": r.choice(["none", "partial", "hhb"])}
    dt, rows = r.choice([.3, .6]) * dx / 5200, []
    number = lambda x: "%.8g" % x
    between = lambda most: sorted(r.uniform(0, most) for _ in range(2))

    def rectangle():
        (x0, x1), (y0, y1) = between(L), between(h)
        return [number(x) for x in (x0, y0, x1, y1)]

    for _ in range(r.randint(0, 2)):
        rows.append(("cuts", [number(r.uniform(0, L)), number(r.uniform(0, h)), number(r.uniform(0, L)), number(r.uniform(0, h))]))
        edge = r.choice(["top", "bottom", "left", "right"])
        load = [edge, *map(number, between(L if edge in ("top", "bottom") else h)), *[number(r.uniform(-2e7, 2e7)) for _ in range(2)]]
        rows.append(("loads", load + r.choice([[], ["ramp", number(10 * dx / 5000)], ["until", number(30 * dx / 5000)]])))
    if r.random() < .6:
        rows.append(("supports", rectangle() + r.choice([["ux", "0"], ["uy", "1.5"], ["ux", "-2", "uy", "0"]])))
    if r.random() < .6:
        rows.append(("impulses", rectangle() + [number(r.uniform(-3, 3)), number(r.uniform(-3, 3))]))
    if r.random() < .5:
        rows.append(("protected", rectangle()))
    values = {"plate.length": L, "plate.height": h, "plate.thickness": .001, "plate.youngs_modulus": E, "plate.density": rho,
              "pd.spacing": dx, "pd.horizon": delta, "pd.critical_stretch": s0, "load.body_force": g, "damping.rate": alpha,
              "time.step": dt} | {"pd." + key: word for key, word in kind.items()}
    values |= {f"{section}.r{k}": " ".join(words) for k, (section, words) in enumerate(rows)}

    def make():
        body = plate(L, h, dx, delta, rows, E=E, rho=rho, dt=dt, s0=s0, thickness=.001, surface=kind["surface_correction"],
                     volume=kind["volume_correction"], influence=kind["influence"])
        body.alpha, body.weight = alpha, g
        body.start()
        return body

    fields = lambda m: ({name: (f, abs(m.u).max() or 1) for name, f in zip(("ux", "uy"), m.u)} | {"damage": (m.phi, 1)}
                        | {name: (f, abs(m.v).max() or 1) for name, f in zip(("vx", "vy"), m.v)})

    def sums(m):
        row = m.row()
        most = sum(abs(row[name]) for name in ("kinetic", "strain", "work", "dissipated", "damped")) or 1
        return {name: (row[name], most) for name in ("kinetic", "strain", "work", "dissipated")} | {"broken_bonds": (row["broken"], 1)}

    return Drawn("plate", "pd", values, r.choice([1, 20, 80]), make, fields, sums)


def program(drawn, folder):
    """The columns of the program's tables at the end; None: it refuses."""
    sections = {}
    for key, value in drawn.values.items():
        section, name = key.split(".")
        sections.setdefault(section, []).append(f"{name} = {value}")
    names = [os.path.join(folder, name) for name in ("drawn.ini", "particles.csv", "series.csv")]
    with open(names[0], "w") as file:
        file.write("".join(f"[{section}]\n" + "\n".join(lines) + "\n" for section, lines in sections.items()))
    run = [os.environ.get("MATVIB", "matvib"), "run", names[0], "--steps", str(drawn.steps), "--particles", names[1], "-o", names[2]]
    if subprocess.run(run + ["--force", "-q"], capture_output=True).returncode:
        return None
    columns = {}
    for name in names[2], names[1]:
        with open(name) as file:
            table = list(csv.reader(line for line in file if not line.startswith("#")))
        rows = table[1:] if name == names[1] else table[-1:]
        columns |= {head: np.array([float(row[k] or "nan") for row in rows]) for k, head in enumerate(table[0])}
    return columns


def compare(kind, folder):
    told, ran, refused = golden.Comparison(kind.__name__ + " drawn"), 0, 0
    for seed in range(EACH):
        drawn = kind(random.Random(f"{kind.__name__} {seed}"))
        got = program(drawn, folder)
        if got is None:
            refused += 1
            continue
        one, other = drawn.make(), drawn.make()
        other.v = other.v * (1 + 2e-15 * np.sign(np.sin(1.7 * np.arange(other.v.size).reshape(other.v.shape))))
        for _ in range(drawn.steps):
            one.step()
            other.step()
        mine, beside = [drawn.fields(m) | drawn.sums(m) for m in (one, other)]
        moved = max(np.max(abs(mine[name][0] - beside[name][0])) / mine[name][1] for name in mine)
        if not moved < 1e-9:
            continue
        ran += 1
        for name, (values, most) in mine.items():
            off = np.max(abs(got[name] - values)) / most
            told.near(f"{name} of {seed}", off, 0, 3e-9 if kind is beam else 1e-10 + 100 * moved)
    told.near(f"runs that tell something: {ran} of {EACH}, {refused} refused", min(ran, EACH / 4), EACH / 4, 0)
    told.tell()


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder, np.errstate(all="ignore"):
        for kind in bar, beam, bodies, plates:
            compare(kind, folder)
    golden.end()
