# SPDX-License-Identifier: GPL-3.0-or-later
"""Beams by bonds (bonds.py): supported, drawn out of a channel, and bent with a notch; damped and at rest."""
import numpy as np

import golden
from bonds import Body

ROOT = 1.8751040687119611  # the first of 1 + cosh z cos z = 0


def middle(body, columns):
    return [j * body.nx + i for j in ((body.ny - 1) // 2, body.ny // 2) for i in columns]


def supported_beam(L, h, dx, delta, U=0.0, **more):
    ny = int(np.floor(h / dx + 1e-9))
    body = Body(round(L / dx), ny, dx, delta, y0=-ny * dx / 2, **more)
    k, left = np.pi / L, (ny - 1) // 2 * body.nx
    body.u = np.array([-body.Y * U * k * np.cos(k * body.X), U * np.sin(k * body.X)])
    body.supports = [([left], (0, 0)), ([left + body.nx - 1], (None, 0))]
    body.probe = middle(body, [(body.nx - 1) // 2, body.nx // 2])
    return body


def moving_cantilever(L, h, dx, delta, U, speed, channel, clamp, **more):
    ny = int(np.floor(h / dx + 1e-9))
    body = Body(round((L + channel) / dx), ny, dx, delta, x0=-channel, y0=-ny * dx / 2, **more)
    k, r = ROOT / L, (np.sinh(ROOT) - np.sin(ROOT)) / (np.cosh(ROOT) + np.cos(ROOT))
    x = k * np.maximum(body.X, 0)  # nothing is bent in the channel
    bend = U * (np.cosh(x) - np.cos(x) - r * (np.sinh(x) - np.sin(x)))
    slope = U * k * (np.sinh(x) + np.sin(x) - r * (np.cosh(x) - np.cos(x)))
    body.u, body.v[0] = np.array([-body.Y * slope, bend]), speed
    body.speed, body.clamp, body.probe = speed, clamp, middle(body, [body.nx - 1])
    return body


def notched_beam(L, h, dx, delta, notch, depth, load, width, stress, ramp, ends, pinned, near, **more):
    body = Body(round(L / dx), round(h / dx), dx, delta, **more)
    bottom, top, t = body.Y[0], body.Y[-1], 1e-6 * dx
    body.cut_along(notch, 0, notch, depth)
    row = lambda x, half, y: body.region(x - half, y, x + half, y)
    body.supports = [(row(x, dx / 2, bottom), (0 if pinned and x == ends[0] else None, 0)) for x in ends]
    body.loads = [(row(load, width / 2, top), (0, -stress), ramp, np.inf)]
    beside = lambda x, reach: abs(body.X - x) < reach - t
    body.protected = (body.Y > h - near + t) & beside(load, width / 2 + near)
    body.protected |= (body.Y < near - t) & (beside(ends[0], near) | beside(ends[1], near))
    body.probe = [(body.ny - 1) * body.nx + body.nx // 2]
    return body


# --- against the golden digits ---------------------------------------------------------------------------------
def beam_of(case):
    given = {words[0]: words[1] for words in case if len(words) == 2}
    number = lambda *keys: [float(given[key]) for key in keys]
    size = number("beam.length", "beam.height", "pd.spacing", "pd.horizon")
    E, rho, thickness, dt = number("beam.youngs_modulus", "beam.density", "beam.thickness", "time.step")
    most = {"E": E, "rho": rho, "thickness": thickness, "dt": dt, "surface": given["pd.surface_correction"],
            "volume": given["pd.volume_correction"], "s0": float(given.get("pd.critical_stretch", 0))}
    if given["problem"] == "simply-supported-beam":
        return supported_beam(*size, *number("initial.amplitude"), **most)
    if given["problem"] == "moving-cantilever":
        return moving_cantilever(*size, *number("initial.amplitude", "motion.speed", "motion.channel"),
                                 given["motion.clamp"], **most)
    return notched_beam(*size, *number("notch.position", "notch.depth", "load.position", "load.width", "load.stress",
                                       "load.ramp"), number("supports.left", "supports.right"),
                        given["supports.pinned"] == "yes", *number("pd.protected"), **most)


def compare_start(told, body, case):
    given = {words[0]: words[1:] for words in case}
    x = golden.numbers(given["lattice"])
    told.near("nodes", len(body.X), x[0], 0)
    told.near("bonds", len(body.i), x[3], 0)
    told.near("cut bonds", body.cut, x[4], 0)
    told.near("c", body.c, x[5], 1e-14 * x[5])
    G = body.surface_factors(given["pd.surface_correction"][0])
    told.near("sum of c G w", body.c * (G * body.w).sum(), x[6], 1e-11 * x[6])
    told.near("sum of w", body.w.sum(), x[7], 1e-11 * x[7])
    body.start()
    told.near("strain at the start", body.row()["strain"], x[8], 1e-11 * x[8])
    for words in case:
        if words[0] in ("force", "factor"):
            node, values = int(words[2]) * body.nx + int(words[1]), golden.numbers(words[3:])
            for axis, value in enumerate(values):
                if words[0] == "force":
                    told.near(f"force of node {node}", body.f[axis, node], value, 1e-11 * abs(body.f).max())
                else:
                    told.near(f"g of node {node}", body.g[axis, node], value, 1e-11 * value)


def compare(name, case):
    told, body = golden.Comparison("pd.txt " + name), beam_of(case)
    compare_start(told, body, case)
    near = [golden.numbers(words[1:]) for words in case if words[0] == "near"]
    notch = [float(words[1]) for words in case if words[0] in ("notch.position", "notch.depth")]
    rows, breaks = [golden.numbers(words[1:]) for words in case if words[0] == "row"], []
    most = np.abs(rows).max(0)
    for row in rows:
        while body.step_number < row[0]:
            body.step()
            if near:  # the times of breaks whose middle is within two horizons of the notch's end
                x, y = np.array([body.X, body.Y])[:, body.i[body.gone]] + body.xi[:, body.gone] / 2
                close = np.hypot(x - notch[0], y - notch[1]) <= 2 * body.delta * (1 + 1e-9)
                breaks += [body.step_number * body.dt] * close.sum()
        got = body.row() | {"damage": body.phi.max(), "stretch": body.s[body.alive].max()}
        for column, what, share in ((1, "uy", 1e-9), (2, "vy", 1e-6), (5, "kinetic", 1e-9), (6, "strain", 1e-9),
                                    (7, "work", 1e-9), (8, "broken", 0), (9, "damage", 1e-9), (10, "stretch", 1e-8),
                                    (11, "dissipated", 1e-9)):
            told.near(f"{what} at step {body.step_number}", got[what], row[column], share * most[column])
    for first, twentieth in near:
        told.near("first break near the notch", breaks[0], first, 1e-12)
        told.near("twentieth", breaks[19], twentieth, 1e-12)
    told.tell()


def compare_rest(name, alpha, dt, amplitude, weight, rows):
    """The simply supported beam of paper P, damped; pulled down by its weight or let go."""
    told = golden.Comparison("rest.txt " + name)
    body = supported_beam(0.1, 0.005, 5e-4, 2e-3, amplitude, E=71e9, rho=2700.0, dt=dt)
    body.alpha, body.weight = alpha, weight
    body.start()
    most = np.abs(rows).max(0)
    for row in rows:
        while body.step_number < row[0]:
            body.step()
        got = body.row()
        for column, what in enumerate(("uy", "vy", "kinetic", "strain", "work", "damped"), 1):
            told.near(f"{what} at step {body.step_number}", got[what], row[column], 1e-9 * most[column])
    told.tell()


if __name__ == "__main__":
    for name, case in golden.cases("pd.txt"):
        compare(name, case)
    for name, case in golden.cases("rest.txt"):
        rows = [golden.numbers(words[1:]) for words in case if words[0] == "row"]
        compare_rest(name, *golden.numbers(case[0][2:]), rows)
    golden.end()
