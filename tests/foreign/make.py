#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes tests/foreign/files and tests/foreign/list: tables as students and public codes write them.

A line of the list: file, verdict, mistake or scheme, then scenario and settings of `matvib diagnose`. The files are
kept, so that the test needs no Python; run this again after a change of it and read the difference."""
import os
import random

from bars import Bar

HERE = os.path.dirname(os.path.abspath(__file__))


# --- how they are written -----------------------------------------------------------------------------------

def table(head, rows, form="%.10g", comma=",", every=1):
    text = comma.join(head) + "\n" if head else ""
    for row in rows[::every]:
        text += comma.join(form % x if isinstance(x, float) else str(x) for x in row) + "\n"
    return text


def columns(names, **how):
    return lambda rows: table(names.split(), [[r[k] for k in names.split()] for r in rows], **how)


def point(kind, index, head, **how):
    return lambda rows: table(head, [[r["time"], r[kind][index]] for r in rows], **how)


def early(rows):
    """ta(end+1) = t before t = t + dt, and no row of the start: each row has the time before its step."""
    return table(["time", "v_cm"], [[one["time"], two["v_cm"]] for one, two in zip(rows, rows[1:])])


def late(rows):
    return table(["t", "vcm"], [[two["time"], one["v_cm"]] for one, two in zip(rows, rows[1:])])


def half(rows):
    return table(["t", "v_cm"], [[two["time"] - rows[1]["time"] / 2, two["v_cm"]] for one, two in zip(rows, rows[1:])])


def from_one(rows):
    return table(["step", "v_cm"], [[r["step"] + 1, r["v_cm"]] for r in rows])


def milli(rows):
    return table(["time (ms)", "v (mm/s)"], [[1000 * r["time"], 1000 * r["v_cm"]] for r in rows])


def momentum(rows):
    return table(["t", "p"], [[r["time"], 25 * r["v_cm"]] for r in rows])


def minus(rows):
    return table(["t", "v_cm"], [[r["time"], -r["v_cm"]] for r in rows])


def german(rows):
    return table(["Zeit", "Geschwindigkeit"], [[r["time"], r["v_cm"]] for r in rows], comma=";").replace(".", ",")


def fortran(rows):
    return "".join("  %s  %s  %s\n" % tuple(("%.12E" % x).replace("E", "D") for x in (r["time"], r["v_cm"], r["kinetic"])) for r in rows)


def units(rows):
    return table(["time [s]", "v_cm [m/s]", "kinetic (J)"], [[r["time"], r["v_cm"], r["kinetic"]] for r in rows])


def bare(rows):
    return table([], [[r["time"], r["v_cm"]] for r in rows], comma=" ")


def wide(kind):
    return lambda rows: table(["t"] + ["%s%d" % (kind, i + 1) for i in range(len(rows[0][kind]))],
                              [[r["time"]] + r[kind] for r in rows], form="%.9g", every=max(1, len(rows) // 4))


def particles(rows):
    return "step,particle,x,v\n" + "".join("%d,%d,%.12g,%.12g\n" % (r["step"], p + 1, r["x"][p], r["v"][p])
                                           for r in rows[-1:] for p in range(len(r["x"])))


def noisy(rows):
    draw = random.Random(46)
    return table(["t", "v_cm"], [[r["time"], r["v_cm"] + draw.uniform(-1e-13, 1e-13)] for r in rows], form="%.15g")


def node(rows):
    """A node's velocity as a step leaves it: 6 cells from the support, behind 4 of padding."""
    return table(["t", "v_node"], [[r["time"], r["node"][10]] for r in rows[1:]])


def arrays(rows):
    return table(["ta", "va"], [[one["time"], two["v"][-1]] for one, two in zip(rows, rows[1:])])


def numbered(rows):
    """As pandas writes a table, its row numbers without a name."""
    return table(["", "t_ms", "v_cm"], [[i, 1000 * r["time"], r["v_cm"]] for i, r in enumerate(rows)])


energies = columns("time kinetic strain total")
plain = columns("step v_cm x_cm kinetic strain", form="%.12g")
vcm = columns("time v_cm")
four = columns("time v_cm", form="%.4f", every=5)
six = columns("time v_cm kinetic", form="%.6f")
seven = columns("time v_cm kinetic strain", form="%.7g")
nine = columns("time v_cm kinetic strain", form="%.9g")
fifth = columns("time v_cm", every=5)
tip = point("v", -1, ["time", "v"])
tip_u = point("u", -1, ["t", "u"])
middle = point("v", 25, ["time", "velocity"])
tenth = point("v", 9, ["t", "v"], form="%.8e")
rounded_times = lambda rows: "time,v_cm\n" + "".join("%.4f,%.9g\n" % (r["time"], r["v_cm"]) for r in rows)

cases = []


def case(verdict, what, writer, steps=60, scenario="mode5", sets=(), **bar):
    cases.append((verdict, what, writer, steps, scenario, sets, bar))


# --- right --------------------------------------------------------------------------------------------------

for writer in (plain, energies, tip, middle, tenth, units, german, fortran, bare):
    case("right", "USL", writer, scheme="usl")
for writer in (momentum, wide("v"), wide("u"), particles, rounded_times, noisy, tip_u, vcm):
    case("right", "USF", writer)
for writer, scheme in ((early, "usl"), (early, "usf"), (late, "usl"), (half, "musl"), (from_one, "musl"), (milli, "usl"),
                       (milli, "usf"), (minus, "usl")):
    case("right but", scheme.upper(), writer, scheme=scheme)
for writer in (fifth, rounded_times, tip, plain):
    case("right", "MUSL", writer, scheme="musl", courant=0.2)
case("right", "USL", vcm, scheme="usl", courant=0.05, mode=1, scenario="mode1")
case("right", "USL", four, scheme="usl", courant=0.25, mode=1, scenario="mode1", steps=200)
case("right", "USL, gimp", tip, scheme="usl", shape="gimp", sets=("mpm.shape=gimp",))
case("right", "MUSL, gimp", energies, scheme="musl", shape="gimp")
case("right", "USL, gimp", plain, scheme="usl", shape="gimp", mode=1, scenario="mode1")
for writer, scheme in ((seven, "usl"), (nine, "usf"), (six, "musl")):
    case("right but", scheme.upper(), writer, scheme=scheme, rounded=True, steps=120)
soft = dict(E=250.0, rho=2.0, dx=0.5, ppc=3)
soft_sets = ("bar.youngs_modulus=250", "bar.density=2", "mesh.cell_size=0.5", "mesh.particles_per_cell=3")
case("right", "USL", tip, scheme="usl", sets=soft_sets, steps=30, **soft)
case("right", "MUSL", vcm, scheme="musl", sets=soft_sets, steps=30, **soft)
case("right", "USL", tip, scheme="usl", sets=("mpm.algorithm=usl",))

# --- wrong --------------------------------------------------------------------------------------------------

stiff = dict(sets=soft_sets, steps=24, **soft)
for mistake, scheme, writer, how in (
        ("force_sign", "usl", vcm, {}), ("force_sign", "musl", tip, {}), ("force_sign", "usf", early, {}),
        ("no_volume", "usl", vcm, stiff), ("no_volume", "usf", tip, stiff), ("mass_for_volume", "usl", tip, stiff),
        ("mass_for_volume", "musl", plain, stiff), ("volume_of_cell", "usl", plain, {}), ("volume_of_cell", "musl", plain, stiff),
        ("mass_of_cell", "usl", plain, {}), ("mass_of_cell", "musl", energies, {}),
        ("strain_without_dt", "usl", vcm, {}), ("strain_without_dt", "musl", tip, {}), ("strain_without_dt", "usf", middle, {}),
        ("stress_not_added", "usl", vcm, {}), ("stress_not_added", "musl", tip, {}), ("stress_not_added", "usf", german, {}),
        ("density_kept", "usl", plain, {}), ("density_kept", "musl", plain, {}), ("density_inverted", "usl", tip, {}),
        ("density_inverted", "musl", vcm, {}), ("x_by_own_velocity", "usl", plain, {}), ("x_by_own_velocity", "musl", plain, {}),
        ("x_by_own_velocity", "usl", tip, {}), ("x_by_old_node_velocity", "usl", plain, {}), ("x_by_half_step", "usl", plain, {}),
        ("x_by_half_step", "usf", plain, {}), ("no_fix_momentum", "musl", tenth, {}), ("no_fix_momentum", "usl", plain, {}),
        ("no_fix_force", "usl", vcm, {}), ("no_fix_force", "musl", plain, {}), ("no_second_fix", "musl", plain, {}),
        ("no_second_fix", "musl", vcm, {}), ("fix_next_node", "usl", vcm, {}), ("fix_next_node", "usf", milli, {}),
        ("fix_after_strain", "usf", fifth, dict(steps=120)), ("keep_grid", "usl", vcm, {}), ("keep_grid", "usf", tip, {}),
        ("mode_of_fixed_fixed", "usl", plain, {}), ("mode_of_fixed_fixed", "musl", plain, {}), ("start_at_centres", "usl", plain, {}),
        ("start_at_centres", "usl", particles, {}), ("gradient_without_h", "usl", vcm, stiff), ("gradient_without_h", "usf", plain, stiff),
        ("natural_slope", "usl", plain, {}), ("natural_slope", "usf", plain, {}), ("natural_slope_in_strain", "usl", plain, {}),
        ("natural_slope_in_force", "usl", plain, {}), ("natural_slope_in_force", "musl", plain, {}), ("stress_of_next", "usl", vcm, {}),
        ("stress_of_next", "usf", tip, {}), ("half_first_kick", "usf", tenth, {}), ("half_first_kick", "usf", late, {}),
        ("volume_kept", "usl", plain, stiff), ("held_acceleration", "usl", plain, {}),
        ("gimp_whole_length", "usl", plain, dict(shape="gimp", sets=("mpm.shape=gimp",))),
        ("gimp_whole_length", "musl", tip, dict(shape="gimp", sets=("mpm.shape=gimp",))),
        ("no_fix_force", "usf", nine, dict(rounded=True)), ("density_inverted", "usf", seven, dict(rounded=True)),
        ("stress_not_added", "usl", vcm, dict(courant=0.2))):
    case("mistake", mistake, writer, scheme=scheme, mistake=mistake, **how)

case("right", "USL", columns("time v_cm", form="%.6g"), scheme="usl", rho=7.0, sets=("bar.density=7",), steps=100)
case("right", "MUSL", columns("time v_cm", form="%.5g"), scheme="musl", rho=7.0, sets=("bar.density=7",), steps=600)

case("right", "USL", node, scheme="usl", steps=80)
case("right", "MUSL", node, scheme="musl", sets=soft_sets, steps=40, **soft)
case("right but", "MUSL", arrays, scheme="musl", courant=0.2)
case("right but", "USL", numbered, scheme="usl", steps=50)
case("right but", "USL", tip, scheme="usl", sets=soft_sets, steps=80, rounded=True, **soft)
for mistake, scheme, writer, how in (
        ("mode_of_fixed_fixed", "usl", tip, {}), ("start_at_centres", "musl", tip, stiff), ("mass_for_volume", "usl", middle, stiff),
        ("stress_of_next", "usl", node, {}), ("force_sign", "usl", nine, dict(rounded=True))):
    case("mistake", mistake, writer, scheme=scheme, mistake=mistake, **how)

names, lines = {}, []
for number, (verdict, what, writer, steps, scenario, sets, bar) in enumerate(cases, 1):
    bar = dict(bar)
    bar.setdefault("mode", 5)
    name = "%03d.csv" % number
    with open(os.path.join(HERE, "files", name), "w") as out:
        out.write(writer(Bar(**bar).run(steps)))
    lines.append("%s|%s|%s|%s\n" % (name, verdict, what, " ".join([scenario] + ["--set " + s for s in sets])))
with open(os.path.join(HERE, "list"), "w") as out:
    out.write("# file | verdict | scheme, or mistake | scenario and settings; written by make.py\n" + "".join(lines))
print(sum(c[0] != "mistake" for c in cases), "right,", sum(c[0] == "mistake" for c in cases), "wrong")
