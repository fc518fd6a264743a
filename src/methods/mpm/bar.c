/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A bar by the material point method is made and changed. At t = 0 particles stand at (j + 1/2 + offset)/P in
 * their cells, with stress 0, volume m/rho and the velocity of eq. 19; m = rho dx/P, dt by eq. 21. */
#include "base/assertion.h"
#include "methods/axial.h"
#include "methods/mpm/mistakes.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* mu, with what 0 stands for. */
static double blend_of(const BarDef *def, double mass_blend)
{
    return mass_blend == 0.0 ? bar_mass_blend_auto(def->shape, def->particles_per_cell, def->courant)
                             : mass_blend;
}

/* How momentum is transferred: the values that the run would have then, if they fit each other. C of APIC
 * begins at 0 where the transfer is changed: there is no slope to begin with. */
static bool change_method(Mpm *mpm, const char *key, double value, Status *status)
{
    BarDef def = mpm->bar;
    MpmHead *head = mpm->head;
    def.algorithm = head->algorithm;
    def.transfer = head->transfer;
    def.flip_fraction = head->flip_fraction;
    def.mass_blend = head->mass_blend;
    def.fmpm_order = head->fmpm_order;
    def.mistake = head->mistake;
    bool algorithm = strcmp(key, "mpm.algorithm") == 0, transfer = strcmp(key, "mpm.transfer") == 0;
    if (algorithm || transfer) {
        int last = algorithm ? MPM_MUSL : MPM_FMPM;
        if (!(value >= 0 && value <= last && value == floor(value)))
            return status_refuse(status, "%s: %g is not a choice (0 to %d)", key, value, last);
        if (algorithm)
            def.algorithm = (MpmAlgorithm)value;
        else
            def.transfer = (MpmTransfer)value;
    } else if (strcmp(key, "mpm.flip_fraction") == 0)
        def.flip_fraction = value;
    else if (strcmp(key, "mpm.mass_blend") == 0)
        def.mass_blend = value;
    else if (strcmp(key, "mpm.fmpm_order") == 0 && value >= 1 && value <= FMPM_ORDER_MAX &&
             value == floor(value))
        def.fmpm_order = (int)value;
    else if (strcmp(key, "mpm.mistake") == 0 && value >= 0 && value == floor(value) && value < INT_MAX)
        def.mistake = (int)value;
    else if (strcmp(key, "mpm.fmpm_order") == 0)
        return status_refuse(status, "%s: %g is out of range (1 to %d)", key, value, FMPM_ORDER_MAX);
    else
        return status_refuse(status, "%s: cannot be changed in mid-run", key);
    if (!bar_check(&def, status))
        return false;
    if (!mpm_change_mistake(mpm, def.mistake, def.conceals_mistake, status))
        return false;
    if (def.transfer != head->transfer)
        memset(mpm->affine, 0, (size_t)mpm->n_particles * sizeof(double));
    head->algorithm = def.algorithm;
    head->transfer = def.transfer;
    head->flip_fraction = def.flip_fraction;
    head->mass_blend = blend_of(&def, def.mass_blend);
    head->fmpm_order = def.fmpm_order;
    mpm_take_schedule(mpm);
    return true;
}

static bool change(Simulation *sim, const char *key, double value, Status *status)
{
    Mpm *mpm = mpm_of(sim);
    MpmHead *head = mpm->head;
    ASSERT_INT(sim->stage, ==, 0);
    if (strncmp(key, "mpm.", 4) == 0)
        return change_method(mpm, key, value, status);
    double *load = strcmp(key, "load.body_force") == 0 ? &head->body_force
                   : strcmp(key, "load.traction") == 0 ? &head->traction
                                                       : NULL;
    if (!load)
        return status_refuse(status, "%s: cannot be changed in mid-run", key);
    if (!isfinite(value))
        return status_refuse(status, "%s: %g is not a finite number", key, value);
    *load = value;
    mpm_take_schedule(mpm);
    return true;
}

static const Method method = {MPM_METHOD, .on_request = mpm_on_request, .small = mpm_small, .change = change};

/* Numbers of the model that follow from the definition: counts, m = rho dx/P, dt = courant dx/c with c =
 * sqrt(E/rho) (eq. 21; of two materials the faster), supports and the particles under traction (eq. 11). The
 * mesh has `padding` cells beyond each free end. A node that is not heavier than 1e-12 of a full cell is
 * inactive; a larger threshold would be seen in the results (1e-3 changes them visibly). */
/* Particles that are worked on together, so many that they are read ahead where there are many. */
static int chunk_of(int particles)
{
    const int chunk = particles / 8;
    return chunk < 512 ? 512 : chunk > 4096 ? 4096 : chunk;
}

static void derive(Mpm *mpm)
{
    BarDef *def = &mpm->bar;
    /* a joint between equals is none: the sums of a row would have two parts, and another last digit */
    if (def->joint_modulus == def->youngs_modulus && def->joint_density == def->density)
        def->joint = 0.0;
    bool left = def->supports == BAR_FIXED_FREE || def->supports == BAR_FIXED_FIXED;
    bool right = def->supports == BAR_FREE_FIXED || def->supports == BAR_FIXED_FIXED;
    const int P = def->particles_per_cell, places = (int)round(def->length / def->cell_size);
    const BarMistake *mistake = mpm_mistake_if(mpm, def->mistake);
    mpm->dim = 1;
    /* a quadratic B-spline about a node is the hat's mean over a cell */
    const bool mean = def->shape == MPM_UNIFORM2, uniform = mean || def->shape == MPM_UNIFORM3;
    mpm->shape = mean ? MPM_GIMP : uniform ? MPM_BSPLINE3 : def->shape;
    mpm->n_particles = places * P;
    /* cells whose splines differ lie beyond the bar; of these all nodes are held, as that of the end */
    const int behind = uniform ? shape_end_cells(mpm->shape) : 0;
    mpm->origin = left ? behind : def->padding + behind;
    mpm->cells = places + mpm->origin + (right ? behind : def->padding + behind);
    mpm->support = shape_support(mpm->shape);
    /* uGIMP and CPDI have a ghost node beyond each end, which is held as well */
    const int ghosts = mpm->shape == MPM_GIMP || mpm->shape == MPM_CPDI ? 1 : behind > 0 ? behind + 1 : 0;
    mpm->n_nodes = mpm->gx = mpm->cells + mpm->support - 1 + (mpm->shape == MPM_GIMP);
    mpm->fixed_left = left ? 1 + ghosts : 0;
    mpm->fixed_right = right ? 1 + ghosts : 0;
    mpm->stays = mistake && (mistake->does & WRONG_STAYS_IN_CELL);
    mpm->half = mean ? 0.5 : 0.5 / P * (mistake && mistake->box > 0 ? mistake->box : 1);
    mpm->edge = mpm->shape == MPM_GIMP ? 1.0 - mpm->half : 0.0;
    mpm->low[0] = mpm->edge;
    mpm->high[0] = mpm->cells + mpm->edge;
    mpm->n_chunks = (mpm->n_particles + chunk_of(mpm->n_particles) - 1) / chunk_of(mpm->n_particles);

    mpm->dx = def->length / places;
    double speed = sqrt(def->youngs_modulus / def->density), lightest = def->density;
    mpm->joint = mpm->n_particles;
    mpm->mass[0] = def->density * mpm->dx / P;
    mpm->modulus[0] = def->youngs_modulus;
    if (def->joint > 0.0) {
        mpm->joint = (int)round(def->joint / mpm->dx) * P;
        mpm->mass[1] = def->joint_density * mpm->dx / P;
        mpm->modulus[1] = def->joint_modulus;
        speed = fmax(speed, sqrt(def->joint_modulus / def->joint_density));
        lightest = fmin(lightest, def->joint_density);
    }
    mpm->dt = def->courant * mpm->dx / speed;
    if (mistake && (mistake->does & WRONG_MASS_OF_CELL))
        mpm->mass[0] = def->density * mpm->dx;
    mpm->floor = 1e-12 * lightest * mpm->dx;

    const double spacing = mpm->dx / P;
    mpm->spacing = def->cell_size / P;
    mpm->layer = def->traction_layer > 0.0 ? def->traction_layer : spacing;
    int in_layer = axial_particles_in_layer(mpm->layer, spacing, mpm->n_particles);
    mpm->layer_left = left ? 0 : in_layer;
    mpm->layer_right = right ? 0 : in_layer;
}

/* Each cell's particles take the mean of the stress where they lie: what differs within a cell no velocity of
 * the grid can change, and it would stay there for ever. */
static bool begin_stress(Mpm *mpm, Status *status)
{
    const BarDef *def = &mpm->bar;
    const int P = def->particles_per_cell;
    for (int first = 0; def->initial_stress && first < mpm->n_particles; first += P) {
        double sum = 0.0;
        for (int p = first; p < first + P; p++)
            sum += def->initial_stress(mpm_rest(mpm, 0, p), def->initial_context);
        if (!isfinite(sum))
            return status_refuse(status, "initial.pulse: no finite stress at x = %g",
                                 mpm_rest(mpm, 0, first));
        for (int p = first; p < first + P; p++)
            mpm->stress[0][p] = sum / P;
    }
    return true;
}

enum { PARTICLES_A_QUESTION = 16384 }; /* a millisecond or less, as each takes a sine for every mode */

/* The state at t = 0: v by eq. 19, volume m/rho, stress 0 or that of a pulse; APIC's slopes C = dv0/dx, since
 * from C = 0 it loses energy in the first step (a quarter of it for the paper's mode 10). */
static bool begin(Mpm *mpm, Status *status)
{
    const BarDef *def = &mpm->bar;
    const BarMistake *mistake = mpm_mistake_if(mpm, def->mistake);
    const bool at_centres = mistake && (mistake->does & WRONG_STARTS_AT_CENTRES);
    const int P = def->particles_per_cell;
    *mpm->head = (MpmHead){.algorithm = def->algorithm,
                           .transfer = def->transfer,
                           .flip_fraction = def->flip_fraction,
                           .body_force = def->body_force,
                           .traction = def->traction,
                           .mass_blend = blend_of(def, def->mass_blend),
                           .fmpm_order = def->fmpm_order,
                           .mistake = def->mistake};
    const int chunk = chunk_of(mpm->n_particles);
    for (int k = 0; k < mpm->n_chunks; k++) { /* even ones first: engine.h */
        const int even = (mpm->n_chunks + 1) / 2, which = k < even ? 2 * k : 2 * (k - even) + 1;
        const int first = which * chunk, rest = mpm->n_particles - first;
        mpm->chunks[k] = (MpmChunk){first, rest < chunk ? rest : chunk, 1, 0};
    }
    double moment = 0.0;
    for (int p = 0; p < mpm->n_particles; p++) {
        if (p % PARTICLES_A_QUESTION == 0 && cancel_requested(&def->cancel, (double)p / mpm->n_particles))
            return status_fail(status, "the building of the bar was cancelled");
        const double x = at_centres ? (p / P + 0.5) * mpm->dx : mpm_rest(mpm, 0, p);
        mpm->rest[0][p] = p / P + (mpm->origin + mpm->edge + (p % P + 0.5 + def->offset) / P);
        mpm->v[0][p] = def->initial_velocity ? def->initial_velocity(x, def->initial_context) : 0.0;
        mpm->volume[p] = mpm->mass[0] / def->density;
        mpm->kept_volume[p] = mpm_does(mpm, WRONG_VOLUME_LATE) ? mpm->volume[p] : 0.0;
        if (def->transfer == MPM_APIC && def->initial_slope)
            mpm->affine[p] = def->initial_slope(x, def->initial_context);
        if (!isfinite(mpm->v[0][p]))
            return status_refuse(status, "initial.velocity: no finite number at x = %g", x);
        mpm->whole_mass += mpm_mass(mpm, p);
        moment += mpm_mass(mpm, p) * mpm_rest(mpm, 0, p);
    }
    mpm->x_cm_start = moment / mpm->whole_mass;
    mpm_find_all(mpm);
    if (!begin_stress(mpm, status))
        return false;
    mpm->energy_start = mpm_energy(mpm);
    if (!isfinite(mpm->energy_start))
        return status_refuse(status, "initial.velocity: the kinetic energy is not a finite number");
    return true;
}

Simulation *bar_create(const BarDef *definition, Status *status)
{
    static const MpmMaker maker = {"bar", &method, HAS_LINE | HAS_MESH, derive, begin, mpm_set_series};
    ASSERT(bar_check(definition, NULL));
    Mpm *mpm = calloc(1, sizeof *mpm);
    if (mpm)
        mpm->bar = *definition;
    return mpm_create(mpm, &maker, (int[]){definition->mistake, definition->mistake_beside}, 1, status);
}
