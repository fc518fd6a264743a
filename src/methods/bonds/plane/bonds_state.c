/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The state as bytes, and the parameters that may change in mid-run. A snapshot is the block of the state
 * (head, six node arrays, bits of broken bonds); what follows from it (coefficients, damage, the crack) is
 * computed again when it is put back. */
#include "base/assertion.h"
#include "methods/bonds/plane/bonds_mistakes.h"

#include <math.h>
#include <string.h>

size_t beam_state_size(const Simulation *sim)
{
    return ((const Beam *)sim)->state_size;
}

/* Bonds that could break once in a run may have done so: that stays true of it. */
static void set_breaking(Beam *beam)
{
    bonds_set_limits(&beam->system, beam->head->critical_stretch);
    if (beam->head->critical_stretch > 0)
        beam_set_breaking(beam);
}

/* Puts a snapshot back: only bonds whose bit differs are touched, so a short way back is cheap; damage and
 * crack are computed again from the bits. */
void beam_load(Simulation *sim, const void *bytes)
{
    Beam *beam = (Beam *)sim;
    size_t head = (size_t)((char *)beam->broken - (char *)beam->state);
    /* coefficients follow the bits: a bond whose bit differs is broken or made whole again */
    const uint8_t *bits = (const uint8_t *)bytes + head;
    for (size_t byte = 0; byte < lattice_slots(&beam->lattice) / 8; byte++) {
        const unsigned differ = beam->broken[byte] ^ bits[byte];
        for (size_t bit = 0; differ >> bit != 0; bit++) {
            const size_t slot = 8 * byte + bit;
            if (differ >> bit & 1)
                beam->coefficient[slot] =
                    beam_bit(bits, slot)
                        ? 0
                        : lattice_coefficient(&beam->lattice, lattice_slot_place(&beam->lattice, slot));
        }
    }
    memcpy(beam->state, bytes, beam->state_size);
    set_breaking(beam);
    sim->at_rest = beam->head->rested;
    sim->kinetic_left = beam->head->kinetic_left;
    beam_rebuild_damage(beam);
    beam_set_stages(beam);
    beam->strain_known = beam->kinetic_known = false;
}

/* Of a bar: sqrt(m) v, then sqrt(m) c/h u, c the speed of long waves and h the spacing. */
size_t beam_small(Simulation *sim, double *x, double unit, bool put)
{
    Beam *beam = (Beam *)sim;
    const Lattice *lattice = &beam->lattice;
    const size_t count = lattice_nodes(lattice), first = lattice_at(lattice, lattice->images[0], 0);
    const double root = sqrt(beam->def.density * lattice->spacing);
    const double rate = sqrt(beam->def.youngs_modulus / beam->def.density) / lattice->spacing;
    ASSERT(lattice->line);
    for (size_t i = 0; x && i < 2 * count; i++) {
        double *value = (i < count ? beam->nodes.vx : beam->nodes.ux) + first + i % count;
        const double scale = i < count ? root : unit * root * rate;
        if (put)
            *value = x[i] / scale;
        else
            x[i] = *value * scale;
    }
    if (x && put) {
        bonds_line_mirror(beam);
        beam_ask_forces(beam, 1, NULL);
        beam->strain_known = beam->kinetic_known = false;
    }
    return 2 * count;
}

/* Parameters that a run may change between steps, those of its problem: they are in the state's head, so a
 * snapshot brings back its own. */
static const struct {
    const char *key;
    size_t offset; /* in the state's head */
} live_parameters[] = {
    {"load.body_force", offsetof(StateHead, body_force)},
    {"load.stress", offsetof(StateHead, load_stress)},
    {"load.traction", offsetof(StateHead, load_stress)},
    {"pd.critical_stretch", offsetof(StateHead, critical_stretch)},
};

bool beam_change(Simulation *sim, const char *key, double value, Status *status)
{
    ASSERT_INT(sim->stage, ==, 0);
    Beam *beam = (Beam *)sim;
    if (strcmp(key, "pd.mistake") == 0) {
        const bool changed = bonds_change_mistake(beam, value, status);
        if (changed)
            beam_set_stages(beam);
        return changed;
    }
    for (size_t k = 0; k < sizeof live_parameters / sizeof *live_parameters; k++) {
        if (strcmp(live_parameters[k].key, key) != 0)
            continue;
        const size_t offset = live_parameters[k].offset;
        const bool stretch = offset == offsetof(StateHead, critical_stretch);
        if (stretch && bonds_mistake(beam) && value != 0)
            return status_refuse(status, "pd.mistake: %s is defined for %s = 0 only",
                                 beam->def.conceals_mistake ? "?" : bonds_mistake(beam)->id, key);
        if (stretch && !(value >= 0 && value < 0.5))
            return status_refuse(status, "%s: %g is not allowed (0 to below 0.5)", key, value);
        memcpy((char *)beam->head + offset, &value, sizeof value);
        set_breaking(beam);
        /* it may move again */
        beam->head->most_kinetic = 0;
        beam->head->moved = sim->step;
        beam->head->kinetic_left = sim->kinetic_left = beam->def.to_rest ? 1 : 0;
        beam->head->rested = sim->at_rest = false;
        beam_set_stages(beam);
        if (!beam->lattice.line ||
            bonds_does(beam, BONDS_WRONG_FORCE_STAYS)) /* which would add it once more */
            return true;
        /* forces of the displacements as they are: the half kick that comes takes those of the new load */
        beam_bond_forces(beam, false);
        for (int j = 0; j < beam->lattice.ny; j++) {
            beam_add_halos(beam, j);
            beam_weigh(beam, j);
            beam_add_loads(beam, j, simulation_time(sim));
        }
        return true;
    }
    return status_refuse(status, "%s: cannot change in mid-run (see: matvib params, marked live)", key);
}
