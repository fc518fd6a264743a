# SPDX-License-Identifier: GPL-3.0-or-later
"""Plates by bonds: cuts, loads, what is held, moved, set in motion or protected. The method is bonds.py."""
import numpy as np

import golden
from bonds import Body


def plate(L, h, dx, delta, rows, **more):
    """rows: (kind, words) as a scenario file has them; cuts in their order."""
    body = Body(round(L / dx), round(h / dx), dx, delta, **more)
    right, top, left, bottom = body.X[-1], body.Y[-1], body.X[0], body.Y[0]
    edge = {"top": lambda p, q: (p, top, q, top), "bottom": lambda p, q: (p, bottom, q, bottom),
            "left": lambda p, q: (left, p, left, q), "right": lambda p, q: (right, p, right, q)}
    for kind, words in rows:
        if kind == "loads":
            p, q, sx, sy = map(float, words[1:5])
            given = dict(zip(words[5::2], map(float, words[6::2])))
            nodes = body.region(*edge[words[0]](p, q))
            body.loads.append((nodes, (sx, sy), given.get("ramp", 0), given.get("until", np.inf)))
            continue
        place = [float(word) for word in words[:4]]
        if kind == "cuts":
            body.cut_along(*place)
        elif kind == "supports":
            given = dict(zip(words[4::2], map(float, words[5::2])))
            body.supports.append((body.region(*place), (given.get("ux"), given.get("uy"))))
        elif kind == "impulses":
            body.v[:, body.region(*place)] = np.array([[float(words[4])], [float(words[5])]])
        elif kind == "protected":
            body.protected[body.region(*place, inside=True)] = True
    return body


# --- against the golden digits ---------------------------------------------------------------------------------
def plate_of(case):
    given = {words[0]: words[1] for words in case}
    number = lambda key, other=0.0: float(given.get(key, other))
    E, delta, G0 = number("plate.youngs_modulus", 1), number("pd.horizon"), number("pd.critical_energy")
    rows = [(words[0].split(".")[0], words[1:]) for words in case if len(words) > 4 and "." in words[0]]
    body = plate(number("plate.length"), number("plate.height"), number("pd.spacing"), delta, rows, E=E,
                 rho=number("plate.density", 1), dt=number("time.step"), s0=np.sqrt(4 * np.pi * G0 / (9 * E * delta)),
                 surface=given.get("pd.surface_correction", "energy"),
                 volume=given.get("pd.volume_correction", "partial"))
    body.probe = body.region(*2 * (number("probe.x", body.X[0]), number("probe.y", body.Y[0])))
    return body


def compare_row(told, body, words, scale):
    values, got, n = golden.numbers(words[2:]), body.row(), body.step_number
    if words[0] == "row":
        allowed = {"broken": 0, "kinetic": 1e-9 * scale, "strain": 1e-9 * scale, "dissipated": 1e-9 * scale,
                   "work": 1e-9 * scale, "tip": 1e-6}
        got["tip"] = body.X[body.phi > 0.35].max()
    else:
        allowed = {"uy": 4.5e-16, "vy": 4.1e-7, "kinetic": 4.5e-10, "strain": 4.5e-10, "momentum": 1e-12}
        got["momentum"] = (body.v[0] * body.rho * body.V).sum()
    for (what, share), value in zip(allowed.items(), values):
        told.near(f"{what} at step {n}", got[what], value, share)


def compare(name, case):
    told, body, broken = golden.Comparison("plates.txt " + name), plate_of(case), []
    lattice = next(words[1:] for words in case if words[0] == "lattice") if name != "initial-velocity" else []
    for what, got, value in zip(("nodes", "bonds", "cut bonds"), (len(body.X), len(body.i), body.cut), lattice):
        if value != "-":
            told.near(what, got, float(value), 0)
    for words in case:
        if words[0] in ("cut", "turn"):  # alone; with those above it
            other = plate_of(case) if words[0] == "cut" else body
            told.near("bonds of " + " ".join(words), other.cut_along(*golden.numbers(words[1:5])), int(words[5]), 0)
    rows = {int(words[1]): words for words in case if words[0] in ("row", "motion")}
    first = [tuple(map(int, words[1:])) for words in case if words[0] == "bonds"]
    scale = golden.numbers(rows[max(rows)][1:])[-2] if rows else 0  # the work in the end
    body.start()
    while True:
        if body.step_number in rows:
            compare_row(told, body, rows[body.step_number], scale)
        if body.step_number >= max(list(rows) + [bond[2] for bond in first] + [0]):
            break
        body.step()
        broken += [(body.i[k], body.j[k], body.step_number) for k in body.gone]
    for bond, got in zip(first, broken):
        told.near(f"bond {bond}", float(bond == got), 1, 0)
    told.tell()


if __name__ == "__main__":
    for name, case in golden.cases("plates.txt"):
        compare(name, case)
    golden.end()
