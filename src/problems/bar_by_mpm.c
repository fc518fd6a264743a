/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bar by the material point method: settings to simulation, exact and predicted answers beside. */
#include "base/assertion.h"
#include "answers/bar_answers.h"
#include "scenario/concern_body.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "problems/solver.h"
#include "theory/bar_waves.h"
#include "theory/oscillation.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>

static double best_blend(const Settings *settings)
{
    return bar_mass_blend_auto(settings_transfer(settings)->shape,
                               settings_mesh(settings)->particles_per_cell, settings_time(settings)->courant);
}

/* mu, with what stands for "auto". */
static double bar_mass_blend_of(const Settings *settings)
{
    const double given = settings_transfer(settings)->mass_blend;
    return given > 0 ? given : best_blend(settings);
}

/* The mesh on which it is predicted; `dt` as the simulation has it. */
static BarMesh bar_mesh_of(const Settings *settings, double dt)
{
    ASSERT_REAL(dt, >, 0);
    const Transfer *mpm = settings_transfer(settings);
    return (BarMesh){.cell_size = settings_mesh(settings)->cell_size,
                     .particles_per_cell = settings_mesh(settings)->particles_per_cell,
                     .offset = settings_start(settings)->offset,
                     .algorithm = mpm->algorithm,
                     .shape = mpm->shape == MPM_CPDI       ? MPM_GIMP
                              : mpm->shape == MPM_UNIFORM3 ? MPM_BSPLINE3
                                                           : mpm->shape,
                     .apic = mpm->transfer == MPM_APIC,
                     .flip_fraction = mpm->flip_fraction,
                     .consistent = 1 - bar_mass_blend_of(settings),
                     .fmpm_order = mpm->transfer == MPM_FMPM ? mpm->fmpm_order : 0,
                     .dt = dt};
}

static bool check(const Settings *settings, Status *status)
{
    const double length = settings_geometry(settings)->length;
    const double cells = round(length / settings_mesh(settings)->cell_size);
    const char *text = settings_start(settings)->pulse;
    Pulse pulse;
    if (!mpm_check_settings(settings, status) || !pulse_read(text, &pulse, status))
        return false;
    /* a pulse off the bar, or wider than it, has no front whose way could be measured */
    if (pulse.velocity != 0 && !(pulse.centre >= 0 && pulse.centre <= length && pulse.width <= length))
        return status_refuse(status, "initial.pulse: %s is not on the bar (centre 0 to %g, width at most %g)",
                             text, length, length);
    return bar_check_modes(settings, cells * settings_mesh(settings)->particles_per_cell, status);
}

/* The bar with the start of a theory, which lives as long as the call takes. */
static Simulation *create(MpmDef def, const Settings *settings, const BarTheory *theory, Status *status)
{
    def.initial_velocity = bar_start;
    def.initial_slope = settings_transfer(settings)->affine_start == AFFINE_GRADIENT ? bar_start_slope : NULL;
    def.initial_stress = theory->pulse.velocity != 0 ? bar_start_stress : NULL;
    def.initial_context = theory;
    return mpm_create(&def, status);
}

static Simulation *simulate(const Settings *settings, int threads, Status *status)
{
    BarTheory theory;
    if (!bar_theory_of(settings, &theory, status))
        return NULL;
    if (mpm_mistake_starts_as_held(settings_transfer(settings)->mistake) ||
        mpm_mistake_starts_as_held(settings_transfer(settings)->mistake_beside))
        theory.right_fixed = theory.left_fixed;
    return create(mpm_definition(settings, threads), settings, &theory, status);
}

/* --- what the step predicts ----------------------------------------------------------------------- */

/* Of a right code, without loads. More than two cells beyond the ends change no shape function that the bar
 * touches. */
static MpmDef right_definition(const Settings *settings)
{
    MpmDef def = mpm_right_definition(settings);
    def.body_force = def.traction = 0;
    def.padding = def.padding < 2 ? def.padding : 2;
    def.cancel = (Cancel){0}; /* the steps ask */
    return def;
}

static Simulation *start_of(const Settings *settings, const BarTheory *theory)
{
    return create(right_definition(settings), settings, theory, NULL);
}

static Dispersion wave_on_mesh(const Settings *settings, const BarTheory *theory, double wave_number)
{
    const BarMesh mesh = bar_mesh_of(settings, bar_time_step(settings));
    return dispersion_of_bar(theory, &mesh, wave_number);
}

static StepMode step_mode(const Settings *settings, const BarTheory *theory, int number)
{
    const BarStep step = {start_of, wave_on_mesh, settings_mesh(settings)->cell_size,
                          bar_is_layered(theory) ? 20000 : 2000};
    return bar_step_mode(&step, settings, theory, number);
}

/* The largest Courant number dt c/dx, c that of the faster material, with which the bar at rest on its mesh
 * stays bounded: the smaller of its own, and that of the waves of an endless mesh. Of a longer bar 32 cells,
 * whose limit is at most 1e-3 below: each end keeps its material, or both half of the cells. (A node that has
 * lost nearly all its mass to a crossing lowers it.) NAN: not enough memory. */
static double largest_courant(const Settings *settings)
{
    enum { CELLS_MOST = 32 };
    MpmDef def = right_definition(settings);
    const double cells = round(def.length / def.cell_size), at = round(def.joint / def.cell_size);
    const double half = CELLS_MOST / 2;
    const BarMesh mesh = bar_mesh_of(settings, bar_time_step(settings));
    def.mass_blend = bar_mass_blend_of(settings);
    if (cells > CELLS_MOST) {
        def.length = CELLS_MOST * def.cell_size;
        def.joint = def.cell_size * (at < half ? at : cells - at < half ? CELLS_MOST - (cells - at) : half);
    }
    def.courant = 1;
    Simulation *moving = mpm_create(&def, NULL);
    def.courant = 0x1p-60;
    Simulation *still = mpm_create(&def, NULL);
    const double limit =
        still && moving ? step_modes_limit(still, moving, settings->cancel) / moving->dt : NAN;
    simulation_destroy(still);
    simulation_destroy(moving);
    return isnan(limit) ? NAN : fmin(limit, dispersion_endless_courant(&mesh));
}

static double predicted_frequency(const Settings *settings, const BarTheory *theory, int mode)
{
    const StepMode found = step_mode(settings, theory, mode);
    return found.known ? found.frequency : NAN;
}

static bool predict(const Settings *settings, Prediction *out, Status *status)
{
    BarTheory theory;
    if (!bar_theory_of(settings, &theory, status))
        return false;
    const int mode = bar_watched_mode(&theory), before = shortage_begin();
    *out = (Prediction){NAN, NAN, NAN, NAN};
    if (mode > 0) {
        out->theory = out->real_size = bar_frequency(&theory, mode);
        out->predicted = predicted_frequency(settings, &theory, mode);
    }
    shortage_end(before);
    return true;
}

/* Whether v_cm is predicted from the first step to the last: as long as particles keep their places the grid
 * takes nothing from them. */
static bool has_whole_motion(const BarTheory *bar, const BarMesh *mesh)
{
    const bool hats = mesh->shape == MPM_HAT && mesh->offset == 0 && bar->left_fixed && !bar->right_fixed;
    return (hats || bar_is_layered(bar)) && mesh->flip_fraction == 1 && !mesh->apic &&
           mesh->fmpm_order == 0 && mesh->algorithm != MPM_USL && bar->body_force == 0 &&
           bar->traction == 0 && bar->pulse.velocity == 0;
}

static bool prepare(References *refs, const Settings *settings, const Simulation *sim, Status *status)
{
    BarAnswers *bar = bar_answers_create(refs, settings, status);
    if (!bar)
        return false;
    bar->mesh = bar_mesh_of(settings, sim->dt);
    const int before = shortage_begin();
    const bool whole = has_whole_motion(&bar->theory, &bar->mesh) &&
                       !refs->unaccounted[REFERENCE_PREDICTED] && bar_find_motion(bar, settings, start_of);
    bar_prepare(refs, settings, sim, predicted_frequency, whole,
                "velocity of the centre of mass predicted for this mesh");
    const StepMode found = step_mode(settings, &bar->theory, bar->watch.mode);
    if (bar->watch.mode > 0 && found.known) {
        bar->watch.overlap = found.overlap;
        bar->watch.kept = found.frequency > 0 ? oscillation_kept(found.decay, bar->watch.exact) : NAN;
    }
    return bar_prediction_is_whole(
        before, round(settings_geometry(settings)->length / settings_mesh(settings)->cell_size), "cells",
        status);
}

/* --- derived numbers and advice ------------------------------------------------------------------- */

static int derived(const Settings *settings, const Simulation *sim, Derived out[DERIVED_MAX])
{
    int n = 0;
    BarTheory theory;
    double dt = sim ? sim->dt : bar_time_step(settings);
    double cells = round(settings_geometry(settings)->length / settings_mesh(settings)->cell_size);
    if (!bar_theory_of(settings, &theory, NULL))
        return 0;
    const int before = shortage_begin();
    bar_derived_step(out, &n, bar_wave_speed(&theory), dt);
    bar_derived_wave(out, &n, settings, &theory, predicted_frequency, dt);
    int mode = bar_watched_mode(&theory);
    if (bar_watch(&theory).moving)
        derived_add(out, &n, "cells_per_wave", "cells/wave", "1",
                    2 * M_PI / bar_largest_wave_number(&theory, mode > 0 ? mode : 1) /
                        settings_mesh(settings)->cell_size,
                    false);
    /* the sampled mode is a mixture, and oscillates at more than the frequency predicted */
    const StepMode found = step_mode(settings, &theory, mode);
    if (mode > 0 && found.known && found.overlap < READOUT_PURE)
        derived_add_answer(out, &n, REFERENCE_PREDICTED, "mode_overlap", "mode overlap", "1", found.overlap);
    if (settings_transfer(settings)->mass_blend == 0)
        derived_add(out, &n, "mass_blend", "mass blend mu*", "1", bar_mass_blend_of(settings), false);
    derived_add(out, &n, "cells", "cells", "1", cells, true);
    derived_add(out, &n, "particles", "particles", "1", cells * settings_mesh(settings)->particles_per_cell,
                true);
    const double largest = largest_courant(settings);
    if (isfinite(largest))
        derived_add_answer(out, &n, REFERENCE_PREDICTED, "largest_courant", "courant limit", "1", largest);
    shortage_end(before);
    return n;
}

/* Whether the end particle at x passes a node by the exact motion, where that is known. */
static bool passes_node(const BarTheory *theory, const Settings *settings, double x)
{
    enum { LOOKS = 1000 };
    const double dx = settings_mesh(settings)->cell_size, end = settings_time(settings)->end;
    for (int i = 1; i <= LOOKS; i++) {
        const double there = x + bar_waves_displacement(theory, x, end * i / LOOKS);
        if (isfinite(there) && floor(there / dx) != floor(x / dx))
            return true;
    }
    return false;
}

static bool advice(const Settings *settings, char *text, size_t size, Status *status)
{
    const MpmDef def = mpm_definition(settings, 1);
    BarTheory theory;
    if (!bar_theory_of(settings, &theory, status))
        return false;
    const double share = def.cell_size / def.particles_per_cell, first = (0.5 + def.offset) * share;
    if (bar_feels_light_nodes(&def, def.transfer) &&
        ((!theory.left_fixed && passes_node(&theory, settings, first)) ||
         (!theory.right_fixed && passes_node(&theory, settings, def.length - share + first))))
        snprintf(text, size, BAR_LIGHT_NODES ": gimp does not");
    return true;
}

/* The largest Courant number that is stable, asked for one that is not. The best mass blend depends on it:
 * what is stable with the share of the step asked for need not be with its own, so the step falls until it
 * is. */
static double stable_courant(const Settings *settings, double largest)
{
    enum { TRIES_MAX = 100 };
    Settings smaller = *settings;
    if (settings_transfer(settings)->mass_blend > 0)
        return largest;
    for (int i = 0; i < TRIES_MAX; i++) {
        settings_edit_time(&smaller)->courant = largest * (1 - 1e-4);
        largest = largest_courant(&smaller);
        if (settings_time(&smaller)->courant <= largest)
            break;
    }
    return settings_time(&smaller)->courant;
}

bool bar_limit(const Settings *settings, char *text, size_t size, Status *status)
{
    const int before = shortage_begin();
    const double largest = largest_courant(settings);
    const bool known = errno != ENOMEM;
    shortage_end(before);
    if (!known)
        return status_fail(status, "not enough memory for the largest stable time step");
    const bool refused = settings_time(settings)->courant > largest && !settings_time(settings)->unstable;
    return problem_limit_courant(settings, largest, refused ? stable_courant(settings, largest) : largest,
                                 text, size, status);
}

/* --- every mode on the mesh ----------------------------------------------------------------------- */

/* With two materials a mode does not have one wavelength. */
static int modes(const Settings *settings)
{
    BarTheory theory;
    if (!bar_theory_of(settings, &theory, NULL) || bar_is_layered(&theory))
        return 0;
    return bar_modes_of(round(settings_geometry(settings)->length / settings_mesh(settings)->cell_size));
}

/* The lumped mesh alone, sqrt(K)/theta; particle -> node -> particle, sqrt(F); masses that are not lumped, T;
 * the time step. */
static void mesh_factors(const Dispersion *wave, ModeOnMesh *mode)
{
    const double filter = sqrt(wave->filter);
    int n = 0;
    mode->factors[n++] =
        (ModeFactor){"mesh K", "lumped mass matrix", wave->space_only / (filter * wave->moves * mode->exact)};
    mode->factors[n++] = (ModeFactor){"filter F", "low-pass filter of the mapping", filter};
    if (wave->moves != 1)
        mode->factors[n++] = (ModeFactor){"masses T", "effect of the mass blend", wave->moves};
    mode->factors[n++] = (ModeFactor){"dt", NULL, wave->frequency / wave->space_only};
    mode->n_factors = n;
}

static bool mode(const Settings *settings, int number, ModeOnMesh *out)
{
    return bar_mode(settings, number, wave_on_mesh, mesh_factors, out);
}

/* Lumped and consistent masses, the blend between, and FMPM that comes to the consistent ones. */
static const char *other_way(const Settings *settings, int which, int number, double *frequency)
{
    const double best = best_blend(settings);
    const bool allowed = best >= BAR_MASS_BLEND_LEAST && settings_start(settings)->offset == 0;
    const struct {
        const char *name;
        double blend;
        int order;
    } ways[] = {
        {"lumped", 1, 0},     {allowed ? "mu*" : "no mu*", allowed ? best : 1, 0},
        {"consistent", 0, 0}, {"FMPM(2)", 1, 2},
        {"FMPM(4)", 1, 4},
    };
    BarTheory theory;
    if (which < 0 || which >= (int)(sizeof ways / sizeof *ways) || !bar_theory_of(settings, &theory, NULL))
        return NULL;
    BarMesh mesh = bar_mesh_of(settings, bar_time_step(settings));
    mesh.apic = false;
    mesh.flip_fraction = 1;
    mesh.consistent = 1 - ways[which].blend;
    mesh.fmpm_order = ways[which].order;
    const Dispersion wave = dispersion_of_bar(&theory, &mesh, bar_wave_number(&theory, number));
    *frequency = wave.known && wave.frequency > 0 ? wave.frequency : NAN;
    return ways[which].name;
}

static const char *damping(const Settings *settings)
{
    const Transfer *mpm = settings_transfer(settings);
    if (mpm->transfer == MPM_FLIP && mpm->flip_fraction < 1)
        return "PIC damping";
    if (mpm->transfer == MPM_FMPM)
        return "FMPM filters velocities";
    if (mpm->transfer == MPM_APIC)
        return "APIC filters velocities";
    return mpm->algorithm == MPM_USL ? "USL damping" : NULL;
}

/* Waves are followed through a joint for a while, and without loads. */
static const char *unaccounted(const Settings *settings, Reference reference)
{
    BarTheory theory;
    if (reference != REFERENCE_EXACT || !bar_theory_of(settings, &theory, NULL) ||
        bar_waves_known(&theory, settings_time(settings)->end))
        return NULL;
    return "bar2.joint";
}

/* The energy E* is that of the right code's step; the other answers are those of the right code too, and
 * are beside what a wrong one does. */
static const char *const of_energy[] = {BAR_KEYS, BAR_MESH_KEYS, BAR_TRANSFER_KEYS, BAR_WAVE_KEYS, NULL};
static const char *const known[] = {BAR_KEYS,      BAR_MESH_KEYS, BAR_TRANSFER_KEYS,
                                    BAR_WAVE_KEYS, "mpm.mistake", NULL};
/* The continuum does not know by what it is computed; its frequencies do not depend on the loads. */
static const char *const of_mistakes[] = {"mpm.mistake", NULL};
#define CHANGES "mpm.algorithm", "mpm.transfer", "mpm.flip_fraction", "mpm.mass_blend", "mpm.fmpm_order"
static const char *const method_changes[] = {CHANGES, "mpm.mistake", NULL};
static const char *const all_changes[] = {CHANGES, "mpm.mistake", "load.body_force", "load.traction", NULL};
static const char *const energy_changes[] = {CHANGES, "load.body_force", "load.traction", NULL};

const Solver bar_by_mpm = {
    .method = METHOD_MPM,
    .validity = {[REFERENCE_EXACT] = {known, method_changes},
                 [REFERENCE_PREDICTED] = {known, of_mistakes},
                 [REFERENCE_FREQUENCY] = {known, all_changes},
                 [REFERENCE_ENERGY] = {of_energy, energy_changes}},
    .unaccounted = unaccounted,
    .check = check,
    .simulate = simulate,
    .advice = advice,
    .limit = bar_limit,
    .derived = derived,
    .predict = predict,
    .prepare = prepare,
    .profile = bar_profile,
    .readout = bar_read_out,
    .findings = bar_findings,
    .modes = modes,
    .mode = mode,
    .other_way = other_way,
    .invariant = bar_invariant,
    .invariant_kept = bar_invariant_kept,
    .damping = damping,
};
