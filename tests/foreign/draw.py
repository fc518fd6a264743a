#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""draw.py SEED FOLDER: a hundred tables of codes drawn at random, right and wrong, and their `list`.

Bars by the material point method and by bonds, beams and plates by bonds, beams of cells, from tests/independent; written
as courses write them. A wrong code whose numbers are those of a right one, to the digits written, is drawn again: no table
can tell it."""
import math
import os
import random
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "independent"))
import mistakes  # noqa: E402 (of tests/independent)
import plates  # noqa: E402

STEPPINGS = {"verlet": "", "euler": "symplectic Euler (kick first)", "euler_position": "symplectic Euler (move first)",
             "leapfrog": "leapfrog (v half a step behind)", "leapfrog_ahead": "leapfrog (v half a step ahead)"}
OF_BAR = {  # and in which algorithm, with which shape they are defined
    "any": "start_at_centres mode_of_fixed_fixed mass_of_cell volume_of_cell keep_grid no_fix_momentum no_fix_force fix_next_node "
           "strain_without_dt gradient_without_h stress_not_added density_kept density_inverted force_sign mass_for_volume "
           "volume_kept no_volume x_by_own_velocity x_by_old_node_velocity moved_weights half_first_kick natural_slope "
           "natural_slope_in_strain natural_slope_in_force stress_of_next volume_late x_by_half_step",
    "usf": "fix_after_strain old_stress_new_start held_acceleration", "usl": "held_acceleration",
    "musl": "no_second_fix x_by_mapped_velocity keep_grid_integrated keep_grid_twice",
    "gimp": "gimp_whole_length gimp_half_of_half", "hat": "cells_kept"}
ONLY_OF_BAR = {"start_at_centres", "mode_of_fixed_fixed", "moved_weights", "cells_kept"}
OF_BONDS = ("horizon_strict one_way counted_twice stretch_of_current euler_forward bond_sign half_bond stretch_without_length "
            "no_second_kick u_added_twice horizon_as_diameter force_not_reset no_first_force first_neighbour last_neighbour")
OF_PLANE = ("micromodulus_3d micromodulus_plane_strain direction_of_reference one_way_row_major")
OF_BEAM = "start_unsupported support_edges supports_pinned weight_by_thickness"


# --- codes: rows of a run, each a dict ----------------------------------------------------------------------------

def run(code, tell, steps, single=False):
    rows = []
    with np.errstate(all="ignore"):
        for step in range(steps + 1):
            if step:
                try:
                    code.step()
                except IndexError:  # nothing is left in its grid
                    break
            if single:
                for name in ("x", "v", "stress", "rho", "u", "f"):
                    if isinstance(getattr(code, name, None), np.ndarray):
                        setattr(code, name, getattr(code, name).astype(np.float32).astype(float))
            row = tell(code)
            row["step"], row["time"] = step, step * code.dt
            if not all(np.isfinite(x).all() and np.abs(x).max() < 1e100 for x in row.values()):
                break
            rows.append({k: np.float32(x).astype(float) if single and k != "step" else x for k, x in row.items()})
    return rows


def tell_bar(b):
    out = {"v_cm": b.v.mean(), "x_cm": b.x.mean(), "kinetic": b.told()["kinetic"],
           "strain": (b.stress ** 2 * b.m / b.rho).sum() / (2 * b.E), "v": b.v.copy(), "x": b.x.copy(), "momentum": (b.m * b.v).sum()}
    if not hasattr(b, "x0"):
        b.x0 = b.x.copy()
    out["u"], out["total"] = b.x - b.x0, out["kinetic"] + out["strain"]
    return out


def tell_rod(b):
    return {"v_cm": b.v.mean(), "kinetic": b.rho * (b.v ** 2).sum() * (b.X[1] - b.X[0]) / 2, "v": b.v.copy(), "u": b.u.copy()}


def tell_body(b):
    row = b.row()
    return {k: row[k] for k in ("ux", "uy", "vx", "vy", "kinetic", "strain")} | {"field": np.array([b.u[0], b.u[1]])}


def tell_cells(b):
    xx, yy, xy = b.s  # not by row(), which maps: wrong codes keep what was mapped
    energy = (xx * xx + yy * yy - 2 * b.nu * xx * yy) / (2 * b.E) + xy * xy * (1 + b.nu) / b.E
    return {"uy": (b.x[1] - b.Y)[b.probe].mean(), "vy": b.v[1, b.probe].mean(), "kinetic": b.b * (b.m * b.v ** 2).sum() / 2,
            "strain": b.b * (energy * b.m / b.rho).sum(), "field": b.x.copy()}


# --- tables -------------------------------------------------------------------------------------------------------

ENERGIES = {"kinetic", "strain", "total"}
LENGTHS = {"x_cm", "u", "x", "ux", "uy"}


class Writer:
    """One way to write rows: columns, digits, separator, labels of time, which rows."""

    def __init__(self, draw, names, fields):
        pick = draw.choice
        self.form = draw.choices(["%.12g", "%.9g", "%.16e", "%.7g", "%.8e", "%.6f", "%.5g"], [30, 20, 15, 12, 12, 4, 7])[0]
        self.every = draw.choices([1, 2, 5], [75, 15, 10])[0]
        self.label = draw.choices(["plain", "early", "late", "half", "no start"], [72, 10, 4, 4, 10])[0]
        self.unit = draw.choices([1, 1e3, 1e6], [85, 12, 3])[0]
        self.sign = draw.choices([1, -1], [95, 5])[0]
        self.comma = draw.choices([",", ";", " ", "\t"], [70, 15, 10, 5])[0]
        self.point = pick([".", ","]) if self.comma == ";" else "."
        self.style = draw.choices(["plain", "units", "none", "D"], [70, 15, 10, 5])[0]
        self.kind = draw.choices(["series", "one", "point", "wide", "field"], [25, 35, 25, 7, 8])[0]
        self.index = draw.random()
        self.names, self.fields = names, fields
        self.column, self.others = pick(names), draw.sample(names, min(len(names), 3))
        self.field, self.time = pick(fields), pick(["t", "time", "Time", "step", "t"])
        self.from_one, self.bare = pick([0, 1]), draw.random() < 0.3
        self.noise = draw.choices([0, 1e-12], [94, 6])[0]
        self.random = random.Random(draw.random())
        self.length_unit = draw.choices([1, 1e3], [90, 10])[0]
        self.decimals = draw.random() < 0.08  # times of four decimals
        if self.noise:
            self.form = "%.16e"

    def scale(self, name):
        sign = 1 if name in ENERGIES else self.sign  # nobody turns an energy round
        return sign * (self.length_unit if name in LENGTHS else 1) * (1 + self.noise * self.random.uniform(-1, 1))

    def columns(self, rows):
        if self.kind in ("series", "one"):
            names = self.others if self.kind == "series" else [self.column]
            words = {"v_cm": pick_word(self.index, "v_cm", "vcm", "v_cm"), "kinetic": pick_word(self.index, "kinetic", "ke", "E_kin"),
                     "momentum": pick_word(self.index, "p", "momentum")}
            if self.comma == ";":
                words.update(v_cm="Geschwindigkeit", x_cm="x_cm")
            return [self.head(words.get(n, n), n) for n in names], lambda r: [self.scale(n) * r[n] for n in names]
        count = len(rows[0][self.field])
        if self.kind == "point":
            at = min(int(self.index * 1.6 * count), count - 1)  # the tip more often than any other
            return [self.head(self.field, self.field)], lambda r: [self.scale(self.field) * r[self.field][at]]
        return ["%s%d" % (self.field, i + 1) for i in range(count)], lambda r: [self.sign * x for x in r[self.field]]

    def head(self, word, name):
        return word + " (mm)" * (name in LENGTHS and self.length_unit != 1)

    def write(self, rows):
        if self.kind == "field":
            return self.write_field(rows)
        heads, values = self.columns(rows)
        shift = {"early": 1, "late": -1}.get(self.label, 0)
        taken = [(rows[i], rows[i + shift]) for i in range(self.label in ("late", "no start", "half"), len(rows) - max(shift, 0))]
        taken = taken[::self.every if self.kind != "wide" else max(1, len(taken) // 5)]
        time = "step" if self.time == "step" and self.label != "half" else "t" if self.time == "step" else self.time
        unit = 1 if time == "step" else self.unit
        back = (rows[1]["time"] - rows[0]["time"]) / 2 if self.label == "half" else 0
        lines = []
        if self.comma == ";" and time != "step":
            time = "Zeit"
        if self.style != "none" and not (self.kind == "wide" and self.bare):
            name = {1: "s", 1e3: "ms", 1e6: "us"}[unit]
            lines.append([time + (" (%s)" % name if time != "step" and (self.style == "units" or unit != 1) else "")] + heads)
        for at, row in taken:
            form = "%.4f" if self.decimals and rows[1]["time"] * unit > 2e-3 and self.label != "half" else "%.10g"
            first = "%d" % at["step"] if time == "step" else form % ((at["time"] - back) * unit)
            cells = [first] + [self.form % x for x in values(row)]
            lines.append([c.replace("e", "D") if self.style == "D" else c for c in cells])
        return "".join(self.comma.join(line) + "\n" for line in lines).replace(".", self.point)

    def write_field(self, rows):
        form = self.form if self.form != "%.6f" else "%.9g"
        names = ["v", "u", "x"] if "field" not in self.fields else ["a", "b"]
        names = [n for n in names if n in rows[0]] if "field" not in self.fields else self.pair
        of = lambda r: [r[n] for n in names] if "field" not in self.fields else list(r["field"])
        lines = [["step", self.thing] + names]
        for r in rows[::max(1, len(rows) // 3)][:4]:
            for k, values in enumerate(zip(*of(r))):
                lines.append(["%d" % r["step"], "%d" % (k + self.from_one)] + [form % x for x in values])
        return "".join(",".join(line) + "\n" for line in lines)


def pick_word(share, *words):
    return words[int(share * len(words)) % len(words)]


def is_same(one, two, share):
    """Whether two tables have the same numbers, but for the last digit and such a share of them."""
    if len(one) != len(two) or len(one.splitlines()) != len(two.splitlines()):
        a, b = one.split(), two.split()
        if len(a) != len(b):
            return False
    words = lambda text: [w for w in text.replace(",", "." if ";" in text else " ").replace(";", " ").replace("D", "e").split() if w[0] in "-0123456789"]
    a, b = words(one), words(two)
    digit = np.array([last_digit(x) for x in a])  # which may be rounded the other way
    a, b = np.array(a, float), np.array(b, float)
    return len(a) == len(b) and bool(np.all(np.abs(a - b) <= np.maximum(1.01 * digit, share * np.maximum(np.abs(a), 1e-3 * np.abs(b).max()))))


def last_digit(text):
    """A unit of it: of 1.25e-3 it is 1e-5."""
    digits, _, power = text.lower().partition("e")
    return 10.0 ** (int(power or 0) - len(digits.partition(".")[2]))


# --- classes ------------------------------------------------------------------------------------------------------

def sets(pairs):
    return " ".join("--set %s=%s" % (k, "%.10g" % v if isinstance(v, float) else v) for k, v in pairs.items())


def draw_bar(draw, wrong):
    pick = draw.choice
    dx, cells = pick([0.5, 1.0, 1.25, 2.0]), pick([8, 10, 12, 16, 20, 25])
    how = dict(L=dx * cells, E=pick([80.0, 100.0, 250.0, 1000.0]), rho=pick([0.5, 1.0, 1.2, 2.0, 7.8]), dx=dx, P=pick([1, 2, 2, 3, 4]),
               courant=draw.choices([0.05, 0.1, 0.2, 0.3, 0.5], [10, 50, 20, 10, 10])[0])
    mode, v0 = pick([1, 1, 2, 3]), pick([0.02, 0.05, 0.1])
    algorithm, shape = pick(["usf", "usl", "usl", "musl"]), draw.choices(["hat", "gimp", "bspline2_uniform"], [65, 25, 10])[0]
    transfer, alpha, mistake = "flip", 1.0, "right"
    if wrong:
        mistake = pick(" ".join(OF_BAR.get(k, "") for k in ("any", algorithm, shape)).split())
    else:
        transfer = draw.choices(["flip", "apic"], [88, 12])[0]
        if transfer == "flip":
            alpha = draw.choices([1.0, 0.0, 0.9, 0.95, 0.99], [75, 8, 6, 6, 5])[0]
    given = {"bar.length": how["L"], "bar.youngs_modulus": how["E"], "bar.density": how["rho"], "mesh.cell_size": dx,
             "mesh.particles_per_cell": how["P"], "initial.mode": mode, "initial.velocity": v0}
    if pick([0, 1, 1]):
        given["time.courant"] = how["courant"]
    if pick([0, 0, 1]):
        given["mpm.algorithm"] = algorithm
    if shape == "gimp" and (mistake.startswith("gimp") or pick([0, 1])):
        given["mpm.shape"] = "gimp"
    scheme = [algorithm.upper()] + [shape] * (shape != "hat") + [transfer] * (transfer != "flip")
    scheme += ["flip_fraction %g" % alpha] * (alpha != 1)

    def make(mistake, algorithm=algorithm, shape=shape):
        return run(mistakes.WrongBar(mistake, mode, v0, **how, algorithm=algorithm, shape=shape, transfer=transfer, alpha=alpha),
                   tell_bar, steps, single)
    steps, single = draw.randint(20, 120), draw.random() < 0.08 and transfer == "flip"
    make.single = single
    right = lambda: (make("right", a, s) for a in ("usf", "usl", "musl") for s in {"hat", "gimp", shape})
    return (make, mistake, right, "mode5", given, ", ".join(scheme),
            Writer(draw, ["v_cm", "x_cm", "kinetic", "strain", "total", "v_cm", "momentum"], ["v", "v", "u"]), "particle", [], {"time.courant": how["courant"]})


def draw_rod(draw, wrong):
    pick = draw.choice
    h, n = pick([0.4, 0.5, 1.0]), pick([20, 26, 30, 40])
    E, rho, mode, v0 = pick([100.0, 250.0]), pick([0.8, 1.0, 2.0, 7.8]), pick([1, 2, 3]), pick([0.05, 0.1])
    surface, volume = pick(["none", "energy"]), pick(["none", "partial"])
    stepping = draw.choices(list(STEPPINGS), [35, 30, 15, 10, 10])[0]
    courant = pick([0.1, 0.1, 0.2, 0.3])
    mistake = pick([m for m in OF_BONDS.split() if is_defined(m, volume, stepping)]) if wrong else "right"
    given = {"bar.length": h * n, "bar.youngs_modulus": E, "bar.density": rho, "mesh.cell_size": 2 * h, "mesh.particles_per_cell": 2,
             "pd.spacing": h, "pd.horizon": 3 * h, "initial.mode": mode, "initial.velocity": v0}
    if pick([0, 1]):
        given["time.courant"] = courant
    told = pick([0, 1])
    if told:
        given["pd.surface_correction"], given["pd.volume_correction"] = surface, volume
    steps, single = draw.randint(20, 120), draw.random() < 0.08
    dt = courant * 2 * h / math.sqrt(E / rho)

    def make(mistake, stepping=stepping):
        return run(mistakes.WrongRod(mistake, stepping, mode, v0, h * n, E, rho, h, dt, surface, volume), tell_rod, steps, single)
    make.single = single
    scheme = [STEPPINGS[stepping]] * (stepping != "verlet") + ["surface energy"] * (surface != "none") + ["volume partial"] * (volume != "none")
    return (make, mistake, lambda: (make("right", s) for s in STEPPINGS), "mode5-peridynamics", given, ", ".join(scheme),
            Writer(draw, ["v_cm", "kinetic", "v_cm"], ["v", "v", "u"]), "node", [], {"time.courant": courant})


def body_settings(draw):
    pick = draw.choice
    stepping = draw.choices(list(STEPPINGS), [35, 30, 15, 10, 10])[0]
    surface, volume = pick(["none", "energy", "volume"]), pick(["none", "partial"])
    scheme = [STEPPINGS[stepping]] * (stepping != "verlet") + ["surface " + surface] * (surface != "none")
    scheme += ["volume partial"] * (volume != "none")
    return stepping, surface, volume, ", ".join(scheme or ["no corrections"]) + \
        (", no corrections" if scheme and surface == volume == "none" else "")


def is_defined(mistake, volume, stepping):
    """A family that ends before the horizon is defined with partial volumes alone, a second kick where there are two."""
    return (mistake != "horizon_strict" or volume == "partial") and (mistake != "no_second_kick" or stepping == "verlet")


def kind_of(mistake, stepping):
    return type("Wrong", (mistakes.WrongBody,), {"mistake": mistake, "stepping": stepping})


def draw_beam(draw, wrong):
    pick = draw.choice
    dx, m, rows, aspect = pick([0.0005, 0.001]), pick([2, 3, 4]), pick([5, 6, 8, 10]), pick([4, 5, 6])
    h, L = dx * rows, dx * rows * aspect
    E, rho, thickness = pick([3e9, 7.1e10, 2.1e11]), pick([1200.0, 2700.0, 7800.0]), pick([1.0, 0.005, 0.01])
    stepping, surface, volume, scheme = body_settings(draw)
    weight = -9.81 if draw.random() < 0.4 else 0.0
    U = 0.0 if weight else pick([1e-6, 2e-6])
    known = [m for m in (OF_BONDS + " " + OF_PLANE + " " + OF_BEAM).split() if is_defined(m, volume, stepping)]
    mistake = pick([m for m in known if U or m != "start_unsupported"]) if wrong else "right"
    dt = float("%.2g" % (0.2 * dx / math.sqrt(E / rho)))
    given = {"beam.length": L, "beam.height": h, "beam.thickness": thickness, "beam.youngs_modulus": E, "beam.density": rho,
             "pd.spacing": dx, "pd.horizon": m * dx, "initial.amplitude": U}
    if pick([0, 1, 1]):
        given["time.step"] = dt
    if weight:
        given["load.body_force"] = weight
    if pick([0, 1]):
        given["pd.surface_correction"], given["pd.volume_correction"] = surface, volume
    steps, more = draw.randint(15, 60), 0.015 if not wrong and draw.random() < 0.15 else 0.0

    def make(mistake, stepping=stepping):
        case = {"beam.length": L, "beam.height": h, "pd.spacing": dx, "pd.horizon": (m + more) * dx, "initial.amplitude": U,
                "beam.youngs_modulus": E, "beam.density": rho, "beam.thickness": thickness, "time.step": dt,
                "pd.surface_correction": surface, "pd.volume_correction": volume, "pd.stepping": stepping,
                "load.body_force": weight}
        return run(mistakes.code_of(case, mistake), tell_body, steps)
    return (make, mistake, lambda: (make("right", s) for s in STEPPINGS), "supported-beam-coarse", given, scheme,
            Writer(draw, ["vy", "uy", "kinetic", "strain", "vy"], ["field"]), "node", ["ux", "uy"], {"time.step": dt})


def draw_plate(draw, wrong):
    pick = draw.choice
    dx, m, nx, ny = 0.001, pick([2, 3, 4]), pick([16, 24, 40]), pick([16, 24])
    E, rho, stress, uncut = pick([3e9, 6.5e10]), pick([1200.0, 2235.0, 2440.0]), pick([5e5, 1e6, 2e6]), pick([0, 1])
    stepping, surface, volume, scheme = body_settings(draw)
    mistake = pick([m for m in (OF_BONDS + " " + OF_PLANE).split() if is_defined(m, volume, stepping)]) if wrong else "right"
    dt, L, h = float("%.2g" % (0.25 * dx / math.sqrt(E / rho))), dx * nx, dx * ny
    given = {"plate.length": L, "plate.height": h, "plate.youngs_modulus": E, "plate.density": rho, "pd.spacing": dx, "pd.horizon": m * dx,
             "pd.critical_energy": 0, "time.step": dt, "loads.top.sy": stress, "loads.bottom.sy": -stress}
    if uncut:
        given["cuts.edge"] = "none"
    if pick([0, 1]):
        given["pd.surface_correction"], given["pd.volume_correction"] = surface, volume
    steps = draw.randint(15, 40)

    def make(mistake, stepping=stepping):
        plates.Body, right = kind_of(mistake, stepping), plates.Body
        rows = [("loads", ["top", "0", "1", "0", str(stress)]), ("loads", ["bottom", "0", "1", "0", str(-stress)])]
        rows = [(k, [w[0], "-1", "1"] + w[3:]) for k, w in rows]
        rows += [("cuts", ["0", str(h / 2), str(L / 2), str(h / 2)])] * (not uncut)
        body = plates.plate(L, h, dx, m * dx, rows, E=E, rho=rho, dt=dt, surface=surface, volume=volume, thickness=0.001)
        plates.Body = right
        middle = [(body.ny - 1) * body.nx + i for i in sorted({(body.nx - 1) // 2, body.nx // 2})]
        body.probe = middle
        body.start()
        return run(body, tell_body, steps)
    return (make, mistake, lambda: (make("right", s) for s in STEPPINGS), "pulled-plate", given, scheme,
            Writer(draw, ["vy", "uy", "kinetic", "strain", "vy"], ["field"]), "node", ["ux", "uy"], {"time.step": dt})


def draw_cells(draw, wrong):
    pick = draw.choice
    dx, rows, aspect = pick([0.00125, 0.0025]), pick([2, 4]), pick([3, 4, 5])
    h, P = dx * rows, pick([2, 2, 3])
    E, nu, rho, thickness = pick([3e9, 7.1e10, 2.1e11]), pick([0.0, 0.25, 0.3]), pick([2700.0, 7800.0]), pick([1.0, 0.005])
    algorithm, shape, alpha = pick(["usf", "usl", "usl", "musl"]), pick(["hat", "gimp"]), 1.0
    mistake, start, courant = "right", pick(["deflection", "velocity"]), draw.choices([0.1, 0.2, 0.5], [60, 25, 15])[0]
    if wrong:
        known = [w for w in " ".join(OF_BAR.get(k, "") for k in ("any", algorithm, shape)).split() if w not in ONLY_OF_BAR]
        mistake = pick(known)
    else:
        alpha = draw.choices([1.0, 0.0, 0.9], [85, 8, 7])[0]
    given = {"beam.length": h * aspect, "beam.height": h, "beam.thickness": thickness, "beam.youngs_modulus": E, "beam.density": rho,
             "beam.poisson": nu, "mesh.cell_size": dx, "mesh.particles_per_cell": P, "initial.amplitude": 1e-6, "initial.start": start}
    if courant != 0.1 or pick([0, 1]):
        given["time.courant"] = courant
    if pick([0, 0, 1]):
        given["mpm.algorithm"] = algorithm
    if pick([0, 1]) or mistake.startswith("gimp"):
        given["mpm.shape"] = shape
    steps = draw.randint(15, 50)

    def make(mistake, algorithm=algorithm, shape=shape):
        case = {"beam.length": h * aspect, "beam.height": h, "beam.thickness": thickness, "beam.youngs_modulus": E, "beam.density": rho,
                "beam.poisson": nu, "mesh.cell_size": dx, "mesh.particles_per_cell": P, "initial.amplitude": 1e-6,
                "time.courant": courant, "mpm.shape": shape, "mpm.algorithm": algorithm}
        cells = type("Cells", (mistakes.WrongCells,), {})
        init = mistakes.plane.Beam.__init__
        mistakes.plane.Beam.__init__ = lambda self, *a: init(self, *a, alpha=alpha, start=start)
        try:
            code = cells(mistake, case)
        finally:
            mistakes.plane.Beam.__init__ = init
        return run(code, tell_cells, steps)
    scheme = [algorithm.upper()] + [shape] * (shape != "hat") + ["flip_fraction %g" % alpha] * (alpha != 1)
    right = lambda: (make("right", a, s) for a in ("usf", "usl", "musl") for s in {"hat", "gimp", shape})
    return (make, mistake, right, "supported-beam-mpm-coarse", given, ", ".join(scheme),
            Writer(draw, ["vy", "uy", "kinetic", "strain", "vy"], ["field"]), "particle", ["x", "y"], {"time.courant": courant})


CLASSES = [("bar", draw_bar, 40), ("rod", draw_rod, 22), ("beam", draw_beam, 14), ("plate", draw_plate, 8), ("cells", draw_cells, 20)]


def main(seed, folder):
    os.makedirs(folder, exist_ok=True)
    draw, lines, again = random.Random(int(seed)), [], []
    for name, drawing, count in CLASSES:
        for number in range(count):
            wrong = number % 5 >= 2  # of five three
            while True:
                make, mistake, right, scenario, given, scheme, writer, writer.thing, writer.pair, dt = drawing(draw, wrong)
                if writer.fields == ["field"] and writer.kind in ("point", "wide"):
                    writer.kind = "one"
                if writer.kind == "field" or writer.time == "step":
                    given.update(dt)  # nothing else tells it
                rows = make(mistake)
                if len(rows) < 6:
                    continue
                text = writer.write(rows)
                others = [other for other in right() if len(other) == len(rows)] if wrong else []
                later = writer.label in ("late", "no start", "half")  # no start tells such from rows that are labelled late
                share = 2e-6 if getattr(make, "single", False) else 1e-9  # noise of single precision tells nothing
                if not any(is_same(text, writer.write(other), share) or
                           (later and is_same(writer.write(rows[1:]), writer.write(other[:-1]), share)) for other in others):
                    break
                again.append(mistake)
            file = "%s%03d.csv" % (name, number)
            with open(os.path.join(folder, file), "w") as out:
                out.write(text)
            lines.append("%s|%s|%s|%s %s|%s\n" % (file, "mistake" if wrong else "right", mistake if wrong else scheme, scenario, sets(given), scheme))
    with open(os.path.join(folder, "list"), "w") as out:
        out.writelines(lines)
    print(len(lines), "tables; drawn again, being the numbers of a right code:", " ".join(again) or "none")


if __name__ == "__main__":
    main(*sys.argv[1:3])
