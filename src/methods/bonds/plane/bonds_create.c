/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A beam from its definition: lattice and bonds (the model), memory, state at t = 0, critical time step, and
 * the table of functions through which a driver runs it (method.h). Long work calls BeamDef.cancel and may
 * be stopped by it; on any failure nothing is left allocated. */
#include "base/assertion.h"
#include "base/text.h"
#include "methods/bonds/plane/bonds_mistakes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void destroy(Simulation *sim)
{
    Beam *beam = (Beam *)sim;
    pool_destroy(beam->pool);
    for (int band = 0; beam->band_logs && band < beam->n_bands; band++)
        free(beam->band_logs[band].breaks);
    free(beam->band_of_row);
    free(beam->band_first);
    free(beam->block);
    free(beam->broken_at);
    free(beam->backup);
    lattice_free(&beam->lattice);
    free(beam);
}

/* Zeroed, aligned to a cache line. NULL: no memory, or given up on the way, for gigabytes take their time. */
static void *zeroed(Beam *beam, size_t bytes)
{
    const size_t piece = 4 << 20;
    bytes = (bytes + 63) / 64 * 64;
    char *block = aligned_alloc(64, bytes ? bytes : 64);
    for (size_t at = 0; block && at < bytes; at += piece) {
        memset(block + at, 0, bytes - at < piece ? bytes - at : piece);
        if (!beam_go_on(beam, BUILDING_BONDS, NULL)) {
            free(block);
            return NULL;
        }
    }
    return block;
}

/* Two threads begin at the two ends and meet near the middle, so bands get smaller towards it: nobody waits
 * long for the last one. Elsewhere they are as large as is worth while, since each has a halo to add. */
static void cut_into_bands(Beam *beam)
{
    int ny = beam->lattice.ny, middle = ny / 2, most = 8 + ny / 8192;
    beam->n_bands = 0;
    for (int row = 0; row < ny;) {
        /* above the middle the mirror image of below */
        int rows = row < middle ? (middle - row) / 2 : (row - middle + 1);
        rows = rows < 1 ? 1 : rows > most ? most : rows;
        beam->band_first[beam->n_bands] = row;
        for (int end = row + rows; row < end && row < ny; row++)
            beam->band_of_row[row] = beam->n_bands;
        beam->n_bands++;
    }
    beam->band_first[beam->n_bands] = ny;
}

/* Where each array is in the block, NULL: nowhere yet; returns the bytes of all. */
static size_t lay_out(Beam *beam, void *block)
{
    const Lattice *lattice = &beam->lattice;
    const size_t nodes = lattice_nodes(lattice), slots = lattice_slots(lattice), rows = (size_t)lattice->ny;
    const size_t bands = (size_t)beam->n_bands, threads = (size_t)beam->def.threads;
    const size_t halo = bands * 2 * (size_t)lattice->rise * lattice->stride;
    size_t used = 0;
    beam->coefficient = beam_piece(block, &used, slots * sizeof *beam->coefficient);
    beam->state = beam_piece(block, &used, beam->state_size);
    beam->notched = beam_piece(block, &used, slots / 8);
    beam->unbreakable = beam_piece(block, &used, nodes);
    beam->rooted = beam_piece(block, &used, rows * lattice->n_tiles * (size_t)lattice->n_offsets);
    beam->damage = beam_piece(block, &used, nodes * sizeof *beam->damage);
    beam->dirty = beam_piece(block, &used, nodes * sizeof *beam->dirty);
    beam->is_dirty = beam_piece(block, &used, nodes);
    beam->halo = beam_piece(block, &used, halo * sizeof *beam->halo);
    beam->row_energy = beam_piece(block, &used, rows * sizeof *beam->row_energy);
    beam->row_work = beam_piece(block, &used, 2 * rows * sizeof *beam->row_work);
    beam->row_speeds = beam_piece(block, &used, 2 * rows * sizeof *beam->row_speeds);
    beam->band_logs = beam_piece(block, &used, bands * sizeof *beam->band_logs);
    beam->scratch = beam_piece(block, &used, threads * BONDS_SCRATCH * sizeof *beam->scratch);
    return used;
}

/* All arrays. The state is one piece, so that a snapshot is one copy: head, then ux, uy, vx, vy, fx, fy (each
 * ny rows of `stride` doubles), then a bit for each slot of a bond, set where it is broken; the head is
 * padded to a cache line. */
static bool allocate(Beam *beam, Status *status)
{
    const Lattice *lattice = &beam->lattice;
    const size_t slots = lattice_slots(lattice);
    beam->array = (size_t)lattice->ny * lattice->stride;
    size_t head = (sizeof(StateHead) + 63) / 64 * 64, arrays = 6 * beam->array * sizeof(double);
    beam->state_size = head + arrays + slots / 8;

    beam->band_of_row = calloc((size_t)lattice->ny, sizeof *beam->band_of_row);
    beam->band_first = calloc((size_t)lattice->ny + 1, sizeof *beam->band_first);
    if (!beam->band_of_row || !beam->band_first)
        return status_fail(status, "not enough memory for %d rows (pd.spacing)", lattice->ny);
    cut_into_bands(beam);
    beam->block = zeroed(beam, lay_out(beam, NULL));
    beam->broken_at = calloc(slots, sizeof *beam->broken_at);
    beam->backup = malloc(beam->state_size);
    if (!beam->block || !beam->broken_at || !beam->backup)
        return beam_go_on(beam, BUILDING_BONDS, status) &&
               status_fail(status, "not enough memory for %zu bonds (pd.spacing)", lattice_bonds(lattice));
    lay_out(beam, beam->block);
    beam->sim.state = beam->state;

    double *arrays_at = (double *)((char *)beam->state + head);
    double **each[] = {&beam->nodes.ux, &beam->nodes.uy, &beam->nodes.vx,
                       &beam->nodes.vy, &beam->nodes.fx, &beam->nodes.fy};
    for (size_t k = 0; k < 6; k++)
        *each[k] = arrays_at + k * beam->array;
    beam->head = beam->state;
    beam->broken = (uint8_t *)beam->state + head + arrays;
    beam->head->load_stress = beam->lattice.line ? beam->def.traction : beam->def.load_stress;
    beam->head->critical_stretch = beam->def.critical_stretch;
    beam->head->body_force = beam->def.body_force;
    beam->head->mistake = beam->def.mistake;
    beam->head->first_break = beam->head->twentieth_break = beam->head->arrival = -1;
    if (beam->def.threads > 1) {
        beam->pool = pool_create(beam->def.threads, status);
        return beam->pool != NULL;
    }
    return true;
}

/* Velocity Verlet is stable for dt < 2/omega_max of the lattice (bonds_critical.c); auto takes half of it. A
 * step above it is refused. (Paper P takes 1e-8 s, far below; periods do not depend on it.) */
static bool set_time_step(Beam *beam, Status *status)
{
    double critical = INFINITY;
    if (beam->lattice.line) { /* which runs beyond it, to where it bursts */
        beam->sim.dt = beam->def.dt;
        return bonds_line_critical_step(&beam->def, &beam->facts.critical_step, status);
    }
    if (beam->def.mistake != 0 &&
        !beam->def.step_is_known) { /* a wrong code is run with the step of the right one */
        BeamDef right = beam->def;
        right.mistake = right.mistake_beside = 0;
        Simulation *sim = beam_create(&right, status);
        if (!sim)
            return false;
        critical = ((const Beam *)sim)->facts.critical_step;
        destroy(sim);
    } else if (!(beam->def.step_is_known && beam->def.dt > 0) && !beam_critical_step(beam, &critical, status))
        return false;
    beam->facts.critical_step = critical;
    beam->sim.dt = beam->def.dt > 0 ? beam->def.dt : critical / 2;
    if (!(beam->sim.dt <= critical))
        return status_refuse(status, "time.step: %g is above the critical time step (at most %s, or auto)",
                             beam->sim.dt, text_limit(critical, 4).text);
    return true;
}

/* Forces at t = 0, which the first half kick needs: eq. 8 with the load at t = 0. A bond that is stretched
 * too far by the initial shape breaks now and counts as broken before the first step. */
static bool start(Beam *beam, Status *status)
{
    bonds_set_limits(&beam->system, beam->def.critical_stretch);
    if (!beam_ask_forces(beam, BUILDING_START, status))
        return false;
    for (int band = 0; band < beam->n_bands; band++) {
        const BeamDef *def = &beam->def;
        if (beam->band_logs[band].unstable &&
            !isfinite(def->youngs_modulus / def->density / (def->spacing * def->spacing)))
            return status_refuse(status,
                                 "%s.density: %g is too light for the forces of its bonds (a larger one)",
                                 beam_word(def), def->density);
        if (beam->band_logs[band].unstable)
            return status_refuse(status,
                                 "initial.amplitude: %g tears the beam apart at the start (a smaller one)",
                                 beam->def.amplitude);
        if (!beam_take_log(beam, &beam->band_logs[band], -1))
            return status_fail(status, "not enough memory for the broken bonds");
    }
    for (int j = 0; j < beam->lattice.ny; j++)
        beam_add_loads(beam, j, 0);
    for (int j = 0; j < beam->lattice.ny; j++)
        beam_weigh(beam, j);
    crack_begin(beam);
    beam_update_damage(beam, 0);
    beam_rebuild_damage(beam);
    return true;
}

static const Method beam_method = {
    .name = "pd",
    .title = "peridynamics",
    .destroy = destroy,
    .stage = beam_stage,
    .steps = beam_steps,
    .row = beam_row,
    .on_request = (const char *const[]){"momentum", "reaction", "momentum_x", "momentum_y", "reaction_x",
                                        "reaction_y", NULL},
    .field = beam_field,
    .links = beam_links,
    .exchange = beam_exchange,
    .load_on = beam_load_on,
    .explain = beam_explain,
    .state_size = beam_state_size,
    .load = beam_load,
    .small = beam_small,
    .change = beam_change,
};

/* In this order, for each part needs those before it: sizes, lattice, memory, bonds, what is held and loaded,
 * time step, start. The critical step is found with u = 0 and nothing held, so before the initial motion is
 * set; the first force comes last, when what is held already stands where it should. */
static bool build(Beam *beam, const BeamOptions *options, Status *status)
{
    const BeamDef *def = &beam->def;
    if (!lattice_init(&beam->lattice, &beam->def, status) || !allocate(beam, status) ||
        !beam_set_bonds(beam, status))
        return false;
    if (!beam_set_problem(beam, status) || !set_time_step(beam, status) || !beam_set_damping(beam, status))
        return false;
    beam_set_fields(beam); /* which a term of the force may read at the start */
    if (!beam_set_motion(beam, options, status) || !start(beam, status))
        return false;

    const Lattice *lattice = &beam->lattice;
    beam->facts.micromodulus = lattice->micromodulus;
    beam->facts.damping = beam->damping;
    beam->facts.nx = lattice_wide(lattice);
    beam->facts.ny = lattice->ny;
    beam->facts.real_height = lattice->ny * lattice->spacing;
    if (def->problem == BEAM_MOVING_CANTILEVER)
        beam->facts.real_span = def->length;
    beam->facts.family = 2 * (size_t)lattice->n_offsets;
    beam->facts.bonds = lattice_bonds(lattice);
    if (lattice->line) {
        beam->facts.modulus = lattice->micromodulus * lattice_moment(lattice);
        beam->facts.end_factor = lattice->factor_x[def->right_fixed ? 0 : lattice_nodes(lattice) - 1];
    }
    beam_set_stages(beam);
    beam->sim.stage_items = (size_t)lattice->ny;
    beam_set_series(beam);
    return true;
}

Simulation *beam_create_with(const BeamDef *definition, const BeamOptions *options, Status *status)
{
    ASSERT(beam_check(definition, NULL));
    Beam *beam = calloc(1, sizeof *beam);
    if (!beam) {
        status_fail(status, "not enough memory");
        return NULL;
    }
    beam->sim.method = &beam_method;
    beam->def = *definition;
    if (definition->problem == BEAM_BAR)
        bonds_line_complete(&beam->def);
    beam->free_body = options && options->free_body;
    beam->kernels = bond_kernels(options && options->force_level ? options->level : bonds_cpu_best());
    if (!beam->kernels || !build(beam, options, status)) {
        if (!beam->kernels)
            status_fail(status, "this machine does not have %s", bonds_cpu_name(options->level));
        destroy(&beam->sim);
        return NULL;
    }
    return &beam->sim;
}

Simulation *beam_create(const BeamDef *definition, Status *status)
{
    return beam_create_with(definition, NULL, status);
}

void beam_facts(const Simulation *sim, BeamFacts *facts)
{
    *facts = ((const Beam *)sim)->facts;
}
