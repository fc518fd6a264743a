/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Broken bonds: when each broke, what it cost, and the damage of nodes, the last stage of a step:
 *
 *     mu = 1 while s < s0 at all times so far, else 0                                                  (6)
 *     phi_i = 1 - sum_j mu w V_j / sum_j w V_j                                                         (5)
 *     cost = c G w s_n s_{n+1} |xi| V^2/2                           J, times the thickness
 *
 * A bond stretched to s0 is broken by the kernels (bond_kernels.c) and carries no force in that same
 * evaluation. In the step in which it breaks it pulled with c s_n at the step's start and with nothing at its
 * end, so the step took c s_n (s_{n+1} - s_n)/2 from the motion, beside the c s_n^2/2 that the bond held
 * before. The sum, not c s_{n+1}^2/2, goes to "dissipated". The bond's ends are marked; only marked nodes
 * compute their damage again. The notch's bonds count in phi but in neither sum. On the notched beam the
 * stage also follows the crack (crack.c). */
#include "base/assertion.h"
#include "methods/bonds/plane/bonds_internal.h"

#include <math.h>
#include <string.h>

/* Damage of a bond's ends is worked out again at the end of the step, once for all bonds that broke. */
static void mark_ends(Beam *beam, BondPlace place)
{
    size_t ends[2];
    lattice_ends(&beam->lattice, place, ends);
    for (int end = 0; end < 2; end++) {
        if (!beam->is_dirty[ends[end]])
            beam->dirty[beam->n_dirty++] = (uint32_t)ends[end];
        beam->is_dirty[ends[end]] = 1;
    }
}

double beam_energy_at(const Beam *beam, BondPlace place, double squared)
{
    return lattice_coefficient(&beam->lattice, place) * squared * beam->lattice.offsets[place.offset].length *
           beam->system.energy_scale;
}

/* The displacements of the step before are u - dt v^{n+1/2}: the bonds stage lies between the drift and the
 * second kick. A bond that breaks at the start (step -1) has not moved: s_n = s_{n+1}. */
static double break_cost(const Beam *beam, BondPlace place, long step)
{
    const Lattice *lattice = &beam->lattice;
    const NodeArrays *nodes = &beam->nodes;
    const Offset *offset = &lattice->offsets[place.offset];
    const double dt = step < 0 ? 0 : beam->sim.dt;
    const double ex = lattice_apart(lattice, place, nodes->ux), ey = lattice_apart(lattice, place, nodes->uy);
    const double before = offset_stretch(offset, ex - dt * lattice_apart(lattice, place, nodes->vx),
                                         ey - dt * lattice_apart(lattice, place, nodes->vy));
    return beam_energy_at(beam, place, before * offset_stretch(offset, ex, ey));
}

/* The breaks of one band in the order in which the kernels met them: bands one after the other, so that
 * dissipated is the same sum at any number of threads. Step -1 is the start: broken_at 0. False: memory was
 * short, the log is not whole. */
bool beam_take_log(Beam *beam, BondLog *log, long step)
{
    ASSERT_INT(step, >=, -1);
    bool written = !log->no_memory;
    for (size_t k = 0; k < log->n_breaks; k++) {
        BondPlace place = lattice_slot_place(&beam->lattice, log->breaks[k]);
        beam->broken_at[log->breaks[k]] = (int32_t)(step + 1);
        beam->head->broken++;
        beam->head->dissipated += break_cost(beam, place, step);
        if (beam->def.problem == BEAM_NOTCHED) { /* its crack starts within two horizons of the notch's end */
            const Offset *offset = &beam->lattice.offsets[place.offset];
            const double x = lattice_x(&beam->lattice, place.i) + offset->x / 2 - beam->def.notch_position;
            const double y = lattice_y(&beam->lattice, place.j) + offset->y / 2 - beam->def.notch_depth;
            const double limit = 2 * beam->def.horizon * (1 + 1e-9);
            beam->head->near_tip += x * x + y * y <= limit * limit;
        }
        mark_ends(beam, place);
    }
    log->n_breaks = 0;
    log->no_memory = false;
    return written;
}

double beam_family_weight(const Beam *beam, size_t node, long step, double *broken)
{
    BondPlace family[FAMILY_MAX];
    const size_t n = beam_family_of(beam, node, family);
    double all = *broken = 0;
    for (size_t k = 0; k < n; k++) {
        const double weight = beam->lattice.offsets[family[k].offset].weight;
        const size_t slot = lattice_slot(&beam->lattice, family[k]);
        all += weight;
        if (beam_bit(beam->broken, slot) && beam->broken_at[slot] <= step)
            *broken += weight;
    }
    return all;
}

/* Eq. 5, the volumes being equal: sum w of broken bonds over sum w of the family, counting bonds that broke
 * in steps up to `step`. 0 whole, 1 alone; a node beside a crack that has passed has 0.4 to 0.5. */
static double node_damage(const Beam *beam, size_t node, long step)
{
    double broken;
    const double all = beam_family_weight(beam, node, step, &broken);
    return all > 0 ? broken / all : 0;
}

void beam_report(Beam *beam, EventKind kind, long step, const char *text)
{
    ASSERT_INT(step, >=, 0);
    Simulation *sim = &beam->sim;
    int before = sim->n_events;
    simulation_report(sim, kind, text);
    if (sim->n_events > before)
        sim->events[before].step = step;
}

/* What paper P says of its crack: when it began (first and twentieth bond with the middle within two
 * horizons of the notch's end), and when it came to the load: within half a horizon of the protected zone,
 * which bonds cannot pass. */
static void report_crack(Beam *beam, long step)
{
    StateHead *head = beam->head;
    if (head->first_break < 0 && head->near_tip >= 1) {
        head->first_break = step;
        beam_report(beam, EVENT_BREAK, step, "first bond broke near the notch's end");
    }
    if (head->twentieth_break < 0 && head->near_tip >= 20) {
        head->twentieth_break = step;
        beam_report(beam, EVENT_BREAK, step, "twentieth bond broke near the notch's end");
    }
    crack_follow(beam);
    if (head->arrival < 0 && beam->def.protected_depth > 0 &&
        head->tip_y >= beam->def.height - beam->def.protected_depth - beam->def.horizon / 2) {
        head->arrival = step;
        beam_report(beam, EVENT_BREAK, step, "the crack reached the protected zone of the load");
    }
}

/* The damage stage of a step: the damage of marked nodes, and what follows from it; `step` counts the one
 * that ends. The tip is noted every few steps whether or not anything broke, for its speed is a slope over
 * time. */
void beam_update_damage(Beam *beam, long step)
{
    ASSERT_INT(step, >=, 0);
    const bool notched = beam->def.problem == BEAM_NOTCHED, any = beam->n_dirty > 0;
    for (size_t k = 0; k < beam->n_dirty; k++) {
        const size_t node = beam->dirty[k];
        beam->damage[node] = node_damage(beam, node, step);
        beam->is_dirty[node] = 0;
    }
    beam->n_dirty = 0;
    if (any && notched)
        report_crack(beam, step);
    else if (any && beam->head->first_break < 0 && beam->head->broken > 0) {
        beam->head->first_break = step;
        beam_report(beam, EVENT_BREAK, step, "first bond broke");
    }
    if (notched)
        crack_note_tip(beam, step);
}

/* After a snapshot is restored: damage follows from the bits of broken bonds and their steps. In the middle
 * of a step bonds that broke in this step do not count yet; their ends stay marked for the coming damage
 * stage. */
void beam_rebuild_damage(Beam *beam)
{
    const Lattice *lattice = &beam->lattice;
    long step = beam->sim.step;
    memset(beam->is_dirty, 0, lattice_nodes(lattice));
    memset(beam->damage, 0, lattice_nodes(lattice) * sizeof *beam->damage);
    beam->n_dirty = 0;
    const size_t slots = lattice_slots(lattice);
    for (size_t slot = 0; (slot = beam_next_bit(beam->broken, slot, slots)) < slots; slot++)
        mark_ends(beam, lattice_slot_place(lattice, slot));
    for (size_t k = 0; k < beam->n_dirty; k++)
        beam->damage[beam->dirty[k]] = node_damage(beam, beam->dirty[k], step);
    size_t n_due = 0;
    for (size_t k = 0; k < beam->n_dirty; k++) {
        uint32_t node = beam->dirty[k];
        beam->is_dirty[node] = node_damage(beam, node, step + 1) > beam->damage[node];
        if (beam->is_dirty[node])
            beam->dirty[n_due++] = node;
    }
    beam->n_dirty = n_due;
}

bool beam_holds(const Beam *beam, double x, double y)
{
    const double spacing = beam->lattice.spacing;
    return x > spacing && x < beam->def.length - spacing && y > spacing && y < beam->def.height - spacing;
}

void beam_set_breaking(Beam *beam)
{
    bool fronts = false;
    for (int i = 0; beam->def.problem == BEAM_PLATE && i < beam->def.plate.n_cuts; i++) {
        const PlateCut *cut = &beam->def.plate.cuts[i];
        fronts = fronts || beam_holds(beam, cut->x0, cut->y0) || beam_holds(beam, cut->x1, cut->y1);
    }
    beam->sim.has |= HAS_BREAKING | (fronts ? HAS_FRONTS : 0u);
}
