/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cracks of a plate (fronts.h). First the run's broken bonds are gone through in the order in which they
 * broke, and each node that cracks is dealt to the front that it is connected with; when all are known, each
 * node cracks once more, for the advance over time and the steps at which lines split. Called after whole
 * steps by code that shows or tabulates the cracks; nothing here changes the motion. */
#include "base/assertion.h"
#include "methods/bonds/cracks/front_shape.h"

#include "base/math/functions.h"
#include "methods/bonds/cracks/crack.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { OF_CUT = -1 };

/* A node while the run is gone through. */
enum { NODE_WHOLE, NODE_CRACKED, NODE_OF_CUT, NODE_ASKED };

/* --- whose node it is ------------------------------------------------------------------------ */

static void add_end(CrackFronts *fronts, const Beam *beam, const PlateCut *cut, const double from[2],
                    const double to[2])
{
    const double x = to[0] - from[0], y = to[1] - from[1], length = math_hypot(x, y);
    if (!beam_holds(beam, to[0], to[1]) || fronts->count == CRACK_FRONTS_MAX)
        return;
    CrackFront *front = &fronts->fronts[fronts->count++];
    *front = (CrackFront){.end = {to[0], to[1]},
                          .along = {x / length, y / length},
                          .beside = beam->def.horizon,
                          .first = NAN,
                          .branch_time = NAN,
                          .half_angle = NAN,
                          .angle = NAN,
                          .fastest = NAN,
                          .fastest_at = NAN};
    memcpy(front->cut, cut->name, sizeof front->cut);
    front->axis = fabs(x) >= fabs(y) ? 0 : 1;
    front->sign = front->along[front->axis] > 0 ? 1 : -1;
}

/* Each front grows along the axis along which its cracked nodes reach farther from its end. */
static void turn_fronts(Growth *growth)
{
    const Beam *beam = growth->beam;
    double least[CRACK_FRONTS_MAX][2] = {{0}}, most[CRACK_FRONTS_MAX][2] = {{0}};
    for (size_t k = 0; k < growth->n_cracks; k++) {
        const size_t node = growth->cracks[k].node;
        const int f = growth->front_of[node];
        for (int d = 0; d < 2; d++) {
            const double away =
                front_place(beam, d, front_line_of(beam, d, node)) - growth->fronts->fronts[f].end[d];
            least[f][d] = fmin(least[f][d], away);
            most[f][d] = fmax(most[f][d], away);
        }
    }
    for (int f = 0; f < growth->fronts->count; f++) {
        CrackFront *front = &growth->fronts->fronts[f];
        const int own = front->axis;
        const double reach[2] = {fmax(-least[f][0], most[f][0]), fmax(-least[f][1], most[f][1])};
        if (reach[1 - own] > reach[own]) {
            front->axis = 1 - own;
            front->sign = most[f][1 - own] >= -least[f][1 - own] ? 1 : -1;
        }
    }
}

/* --- in the order in which they broke -------------------------------------------------------- */

/* The step in which a bond broke; at most the one that has begun. */
static int32_t step_of(const Beam *beam, size_t slot)
{
    const int32_t begun = (int32_t)beam->sim.step + 1;
    return beam_bit(beam->notched, slot)   ? OF_CUT
           : beam->broken_at[slot] < begun ? beam->broken_at[slot]
                                           : begun;
}

/* The bonds that broke up to the state's step, step by step and in a step by their slots: counted first, and
 * then put where those of their step begin. */
static bool gather(Growth *growth)
{
    const Beam *beam = growth->beam;
    const size_t slots = lattice_slots(&beam->lattice), steps = (size_t)(beam->sim.step + 1 - OF_CUT);
    /* by step - OF_CUT; the last are those of the step that has begun, which do not count yet */
    uint32_t *place = calloc(steps + 2, sizeof *place);
    if (!place)
        return false;
    for (size_t slot = 0; (slot = beam_next_bit(beam->broken, slot, slots)) < slots; slot++)
        place[step_of(beam, slot) - OF_CUT + 1]++;
    for (size_t k = 0; k <= steps; k++)
        place[k + 1] += place[k];
    growth->n_of_cuts = place[1];
    growth->n_breaks = place[steps];
    growth->breaks = malloc((place[steps + 1] + 1) * sizeof *growth->breaks);
    for (size_t slot = 0; growth->breaks && (slot = beam_next_bit(beam->broken, slot, slots)) < slots; slot++)
        growth->breaks[place[step_of(beam, slot) - OF_CUT]++] = (uint32_t)slot;
    free(place);
    return growth->breaks != NULL;
}

/* A bond is gone: its nodes, and the shares of their families that are. */
static void weaken(Growth *growth, size_t slot, size_t nodes[2], double gone[2])
{
    const Lattice *lattice = &growth->beam->lattice;
    const BondPlace place = lattice_slot_place(lattice, slot);
    lattice_ends(lattice, place, nodes);
    for (int end = 0; end < 2; end++) {
        const size_t node = nodes[end];
        double broken;
        if (growth->all[node] == 0)
            growth->all[node] = beam_family_weight(growth->beam, node, 0, &broken);
        growth->broken[node] += lattice->offsets[place.offset].weight;
        gone[end] = growth->broken[node] / growth->all[node];
    }
}

/* --- whose node it is ------------------------------------------------------------------------ */

/* A horizon of a cut's end is its front's, and from there on a node is of the front of the nearest node of
 * its family that is of one: cracks that pass each other by stay two. */
static int front_of_node(const Growth *growth, uint32_t node)
{
    const Beam *beam = growth->beam;
    const Lattice *lattice = &beam->lattice;
    const int i = front_line_of(beam, 0, node), j = front_line_of(beam, 1, node);
    const double x = front_place(beam, 0, i), y = front_place(beam, 1, j);
    int nearest = FRONT_NONE;
    double least = (1 + 1e-9) * beam->def.horizon;
    for (int f = 0; f < growth->fronts->count; f++) {
        const double *end = growth->fronts->fronts[f].end, away = math_hypot(x - end[0], y - end[1]);
        if (away < least)
            least = away, nearest = f;
    }
    for (int k = 0; k < 2 * lattice->n_offsets; k++) {
        const Offset *offset = &lattice->offsets[k / 2];
        const int sign = k % 2 ? -1 : 1, other_i = i + sign * offset->p, other_j = j + sign * offset->q;
        if (!lattice_has(lattice, other_i, other_j))
            continue;
        const int f = growth->front_of[lattice_node(lattice, other_i, other_j)];
        const double away = math_hypot(offset->p, offset->q) * lattice->spacing;
        if (f != FRONT_NONE && (away < least || (away == least && f < nearest)))
            least = away, nearest = f;
    }
    if (nearest == FRONT_NONE)
        return FRONT_NONE;
    const CrackFront *front = &growth->fronts->fronts[nearest];
    /* beyond the end, or so far to a side that the cut itself damaged no bond of it */
    const double dx = x - front->end[0], dy = y - front->end[1];
    const double along = dx * front->along[0] + dy * front->along[1],
                 aside = fabs(dx * front->along[1] - dy * front->along[0]);
    return along > 1e-6 * lattice->spacing || aside > beam->def.horizon ? nearest : FRONT_NONE;
}

/* For all nodes of a round by what was so before it, so that their order does not matter; those that cracked
 * before, of no front until one of these reached them, come in the next round. */
static void take_round(Growth *growth, int32_t step, size_t *count)
{
    const Lattice *lattice = &growth->beam->lattice;
    const size_t first = growth->n_cracks;
    size_t n_next = 0;
    for (size_t k = 0; k < *count; k++) {
        growth->found[k] = (uint8_t)front_of_node(growth, growth->asked[k]);
        growth->cracked[growth->asked[k]] = NODE_CRACKED;
    }
    for (size_t k = 0; k < *count; k++)
        if (growth->found[k] != FRONT_NONE) {
            growth->front_of[growth->asked[k]] = growth->found[k];
            growth->cracks[growth->n_cracks++] = (CrackedNode){step, growth->asked[k]};
        }
    for (size_t k = first; k < growth->n_cracks; k++) {
        BondPlace family[FAMILY_MAX];
        const uint32_t node = growth->cracks[k].node;
        const size_t n = beam_family_of(growth->beam, node, family);
        for (size_t b = 0; b < n; b++) {
            size_t ends[2];
            lattice_ends(lattice, family[b], ends);
            const size_t near = ends[ends[0] == node];
            if (growth->cracked[near] != NODE_CRACKED || growth->front_of[near] != FRONT_NONE)
                continue;
            growth->cracked[near] = NODE_ASKED;
            growth->next[n_next++] = (uint32_t)near;
        }
    }
    uint32_t *asked = growth->asked;
    growth->asked = growth->next;
    growth->next = asked;
    *count = n_next;
}

/* Which nodes cracked, when, and of which front. The cuts' bonds count in the damage from the start, and
 * damage by them alone is not a crack. */
static void deal(Growth *growth)
{
    const Beam *beam = growth->beam;
    size_t nodes[2];
    double gone[2];
    memset(growth->front_of, FRONT_NONE, lattice_nodes(&beam->lattice));
    for (size_t k = 0; k < growth->n_of_cuts; k++) {
        weaken(growth, growth->breaks[k], nodes, gone);
        for (int end = 0; end < 2; end++)
            if (gone[end] > CRACK_DAMAGE)
                growth->cracked[nodes[end]] = NODE_OF_CUT;
    }
    for (size_t next = growth->n_of_cuts; next < growth->n_breaks;) {
        const int32_t step = step_of(beam, growth->breaks[next]);
        size_t count = 0;
        for (; next < growth->n_breaks && step_of(beam, growth->breaks[next]) == step; next++) {
            weaken(growth, growth->breaks[next], nodes, gone);
            for (int end = 0; end < 2; end++) {
                if (gone[end] <= CRACK_DAMAGE || growth->cracked[nodes[end]] != NODE_WHOLE ||
                    beam->unbreakable[nodes[end]])
                    continue;
                growth->cracked[nodes[end]] = NODE_ASKED;
                growth->asked[count++] = (uint32_t)nodes[end];
            }
        }
        while (count > 0)
            take_round(growth, step, &count);
    }
}

/* --- how far it has come --------------------------------------------------------------------- */

static void go_through(Growth *growth)
{
    const Beam *beam = growth->beam;
    CrackFronts *fronts = growth->fronts;
    const long last = beam->sim.step, every = lround(fronts->every / beam->sim.dt);
    size_t next = 0;
    memset(growth->cracked, NODE_WHOLE, lattice_nodes(&beam->lattice));
    for (long step = 0; step <= last; step++) {
        for (; next < growth->n_cracks && growth->cracks[next].step <= step; next++) {
            const CrackedNode *crack = &growth->cracks[next];
            const int f = growth->front_of[crack->node];
            CrackFront *front = &fronts->fronts[f];
            const int line = front_line_of(beam, front->axis, crack->node);
            const size_t at = (size_t)f * (size_t)growth->lines + (size_t)line;
            growth->cracked[crack->node] = NODE_CRACKED;
            if (!growth->is_touched[at])
                growth->touched[growth->n_touched++] = (uint32_t)at;
            growth->is_touched[at] = 1;
            const double advance =
                front->sign * (front_place(beam, front->axis, line) - front->end[front->axis]);
            if (advance <= 0)
                continue;
            if (!front->begun)
                front->first = crack->step * beam->sim.dt;
            front->begun = true;
            front->advance = fmax(front->advance, advance);
        }
        /* a line can only have come apart where a node of it has cracked */
        for (size_t k = 0; step % CRACK_FRONT_LOOK == 0 && k < growth->n_touched; k++) {
            const uint32_t at = growth->touched[k];
            const int f = (int)(at / (uint32_t)growth->lines), line = (int)(at % (uint32_t)growth->lines);
            Group groups[FRONT_GROUPS_MAX];
            growth->is_touched[at] = 0;
            if (growth->split[at] < 0 && front_groups(growth, f, line, groups) > 1)
                growth->split[at] = (int32_t)step;
        }
        if (step % CRACK_FRONT_LOOK == 0)
            growth->n_touched = 0;
        for (int f = 0; step % every == 0 && f < fronts->count; f++)
            fronts->fronts[f].advances[step / every] = fronts->fronts[f].advance;
    }
}

/* --- all together ---------------------------------------------------------------------------- */

double crack_fronts_speed(const CrackFronts *fronts, const CrackFront *front, size_t sample)
{
    ASSERT_INDEX(sample, fronts->n_samples);
    const size_t half = fronts->window / 2;
    if (sample < half || sample + half >= fronts->n_samples)
        return NAN;
    for (size_t k = sample - half; k < sample + half; k++)
        if (front->advances[k + 1] - front->advances[k] > front->beside)
            return NAN;
    double across[CRACK_FRONT_WINDOW_MAX] = {0};
    return crack_tip_speed(front->advances + (sample - half), across, 2 * half + 1, fronts->every);
}

/* Times at which the advance is kept: as many as fit into the window of a speed, at most one a step. */
static bool plan_samples(CrackFronts *fronts, const Beam *beam)
{
    const double dt = beam->sim.dt;
    const double window = crack_speed_window(beam->def.horizon, beam->def.youngs_modulus, beam->def.density);
    const long every = (long)fmin(1e9, fmax(1, ceil(window / dt / (CRACK_FRONT_WINDOW_MAX - 2))));
    fronts->every = (double)every * dt;
    fronts->window = 2 * (size_t)fmax(1, round(window / fronts->every / 2)) + 1;
    fronts->n_samples = (size_t)(beam->sim.step / every) + 1;
    for (int f = 0; f < fronts->count; f++)
        if (!(fronts->fronts[f].advances = calloc(fronts->n_samples, sizeof(double))))
            return false;
    return true;
}

static bool work_out(Growth *growth)
{
    const Beam *beam = growth->beam;
    CrackFronts *fronts = growth->fronts;
    if (!plan_samples(fronts, beam) || !gather(growth))
        return false;
    deal(growth);
    turn_fronts(growth);
    memset(growth->split, -1, (size_t)fronts->count * (size_t)growth->lines * sizeof *growth->split);
    go_through(growth);
    for (int f = 0; f < fronts->count; f++) {
        CrackFront *front = &fronts->fronts[f];
        front_find_tips(growth, f);
        front_find_branch(growth, f);
        for (size_t k = 0; front->begun && k < fronts->n_samples; k++) {
            const double speed = crack_fronts_speed(fronts, front, k);
            if (isfinite(speed) && !(speed <= front->fastest)) {
                front->fastest = speed;
                front->fastest_at = (double)k * fronts->every;
            }
        }
        if (!front_find_lines(growth, f) || !front_find_paths(growth, f))
            return false;
        front->angle = crack_fronts_angle(front, INFINITY);
        for (const CrackPath *path = front->paths; path < front->paths + front->n_paths; path++) {
            double length = 0;
            for (size_t k = 1; k < path->count; k++)
                length += math_hypot(path->x[k] - path->x[k - 1], path->y[k] - path->y[k - 1]);
            fronts->length += length;
        }
    }
    double cut_length = 0;
    for (const PlateCut *cut = beam->def.plate.cuts; cut < beam->def.plate.cuts + beam->def.plate.n_cuts;
         cut++)
        cut_length += math_hypot(cut->x1 - cut->x0, cut->y1 - cut->y0);
    fronts->surface = beam->facts.notch_bonds > 0
                          ? (double)beam->head->broken * cut_length / (double)beam->facts.notch_bonds
                          : NAN;
    return true;
}

/* Where each array is in the block, NULL: nowhere yet; returns the bytes of all. */
static size_t lay_out(Growth *growth, char *block, size_t nodes, size_t lines)
{
    size_t used = 0;
    growth->cracks = beam_piece(block, &used, nodes * sizeof *growth->cracks);
    growth->all = beam_piece(block, &used, nodes * sizeof *growth->all);
    growth->broken = beam_piece(block, &used, nodes * sizeof *growth->broken);
    growth->asked = beam_piece(block, &used, nodes * sizeof *growth->asked);
    growth->next = beam_piece(block, &used, nodes * sizeof *growth->next);
    growth->front_of = beam_piece(block, &used, nodes);
    growth->cracked = beam_piece(block, &used, nodes);
    growth->found = beam_piece(block, &used, nodes);
    growth->split = beam_piece(block, &used, lines * sizeof *growth->split);
    growth->touched = beam_piece(block, &used, lines * sizeof *growth->touched);
    growth->is_touched = beam_piece(block, &used, lines);
    return used;
}

void crack_fronts_free(CrackFronts *fronts)
{
    for (int f = 0; f < fronts->count; f++) {
        free(fronts->fronts[f].advances);
        free(fronts->fronts[f].away);
        for (int k = 0; k < fronts->fronts[f].n_paths; k++)
            free(fronts->fronts[f].paths[k].x);
    }
    *fronts = (CrackFronts){.count = 0};
}

bool crack_fronts_update(CrackFronts *fronts, const Simulation *sim)
{
    const Beam *beam = sim->method->links == beam_links ? (const Beam *)sim : NULL;
    if (beam && fronts->count > 0 && fronts->of == sim && fronts->step == sim->step &&
        fronts->broken == beam->head->broken && fronts->dissipated == beam->head->dissipated)
        return true;
    crack_fronts_free(fronts);
    if (!beam || beam->def.problem != BEAM_PLATE)
        return false;
    for (int i = 0; i < beam->def.plate.n_cuts; i++) {
        const PlateCut *cut = &beam->def.plate.cuts[i];
        const double from[2] = {cut->x0, cut->y0}, to[2] = {cut->x1, cut->y1};
        add_end(fronts, beam, cut, from, to);
        add_end(fronts, beam, cut, to, from);
    }
    const int nx = beam->lattice.nx, ny = beam->lattice.ny;
    Growth growth = {.beam = beam, .fronts = fronts, .lines = nx > ny ? nx : ny};
    const size_t nodes = lattice_nodes(&beam->lattice), lines = (size_t)fronts->count * (size_t)growth.lines;
    char *block = fronts->count > 0 ? calloc(1, lay_out(&growth, NULL, nodes, lines)) : NULL;
    lay_out(&growth, block, nodes, lines);
    const bool sound = block && work_out(&growth);
    free(block);
    free(growth.breaks);
    if (!sound) {
        crack_fronts_free(fronts);
        return false;
    }
    fronts->of = sim;
    fronts->step = sim->step;
    fronts->broken = beam->head->broken;
    fronts->dissipated = beam->head->dissipated;
    return true;
}
