/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of a run's numbers (run_numbers.h). */
#include "answers/run_numbers.h"
#include "base/math/functions.h"

#include "problems/problem.h"
#include "scenario/concern_output.h"
#include "scenario/settings.h"

#include <math.h>
#include <string.h>

/* A number that is a formula of the summary. */
#define NUMBER(name, formula)                                                                                \
    static double name(const RunSummary *run, const char *word)                                              \
    {                                                                                                        \
        (void)word;                                                                                          \
        return formula;                                                                                      \
    }

NUMBER(measured, run->readout.measured_known ? run->readout.measured : NAN)
NUMBER(predicted, run->readout.predicted_known ? run->readout.predicted : NAN)
NUMBER(exact, run->readout.exact_known ? run->readout.exact : NAN)
NUMBER(error, run->readout.error_frequency)
NUMBER(period_error, run->readout.error_period)
NUMBER(predicted_error, run->readout.predicted_error_frequency)
NUMBER(late, run->readout.late)
NUMBER(energy_change, run->energy_measure == ENERGY_NOT_KNOWN ? NAN : run->energy_change)
NUMBER(last_time, run->time)
NUMBER(steps, (double)run->steps)
double run_summary_derived(const RunSummary *run, const char *word)
{
    return derived_named(run->derived, run->n_derived, word);
}

/* Of the notched beam's crack; of a plate what its cracks have. */
static double crack(const RunSummary *run, double value)
{
    return run->crack_known ? value : NAN;
}

static double either(const RunSummary *run, double of_crack, double of_fronts)
{
    return run->fronts_known ? of_fronts : crack(run, of_crack);
}

NUMBER(crack_start, crack(run, run->crack.measured.first_break))
NUMBER(crack_angle_all, either(run, run->crack.angle, run->fronts.angle))
NUMBER(crack_length, crack(run, run->crack.measured.length))
NUMBER(crack_speed, either(run, run->crack.measured.fastest, run->fronts.fastest))
NUMBER(broken_bonds, run->crack_known || run->fronts_known
                         ? either(run, (double)run->crack.measured.broken, (double)run->fronts.broken)
                         : run->broken_bonds)

static double of_branch(const RunSummary *run, double value)
{
    return run->fronts_known && run->fronts.branched ? value : NAN;
}

NUMBER(branch_time, of_branch(run, run->fronts.branch_time))
NUMBER(branch_angle, of_branch(run, run->fronts.half_angle))
NUMBER(crack_tips, run->fronts_known ? (double)run->fronts.n_tips : NAN)
NUMBER(crack_cost_of, run->price_known ? run->price.cost.total / run->price.cost.area : NAN)

static double finding(const RunSummary *run, const char *word)
{
    return finding_named(run->findings, run->n_findings, word).measured;
}

static double exact_of(const RunSummary *run, const char *word)
{
    return finding_named(run->findings, run->n_findings, word).exact;
}

NUMBER(acceleration_exact, exact_of(run, "acceleration"))

/* |u - u_ref|/|u_ref| */
static double tip_error(const RunSummary *run, const char *word)
{
    (void)word;
    const double x = exact_of(run, "tip_x"), y = exact_of(run, "tip_y"), size = math_hypot(x, y);
    return size > 0 ? math_hypot(finding(run, "tip_x") - x, finding(run, "tip_y") - y) / size : NAN;
}

/* What a scenario can be about: how it is called in large digits, of a negative one the other way round. */
#define ABOUT(unit_, label_, opposite_)                                                                      \
    .label = (label_), .opposite = (opposite_), .unit = (unit_), .scale = 1
#define ABOUT_IN(unit_, scale_, label_) .label = (label_), .unit = (unit_), .scale = (scale_)

const RunNumber run_numbers[] = {
    {"measured", "frequency of a bar (radians per time), period of a beam (s), as measured", measured,
     .label = NULL},
    {"predicted", "the same by the equations of this very mesh or lattice", predicted, .label = NULL},
    {"exact", "the same of the continuum, or by beam theory", exact, .label = NULL},
    {"error", "error of the measured frequency, %", error,
     ABOUT("%", "frequency too high", "frequency too low"), .judged = true},
    {"period_error", "error of the measured period, %", period_error,
     ABOUT("%", "period too long", "period too short"), .judged = true},
    {"predicted_error", "error of the predicted frequency, %", predicted_error, .label = NULL},
    {"late", "periods behind the exact answer at the end", late, ABOUT("", "periods behind", "periods ahead"),
     .judged = true},
    {"energy_change", "change of the energy from the start to the end, %", energy_change,
     ABOUT("%", "energy gained", "energy lost"), .part = SUMMARY_ENERGY},
    {"end", "the time at the end", last_time, .label = NULL},
    {"steps", "steps to the end", steps, .label = NULL},
    {"dt", "the time step", run_summary_derived, .beforehand = true, .called = "time step"},
    {"cells", "cells of the mesh", run_summary_derived, .beforehand = true},
    {"particles", "particles or lattice points", run_summary_derived, .beforehand = true},
    {"cells_per_wave", "cells to a wave length", run_summary_derived, .beforehand = true},
    {"wave_speed", "speed of waves", run_summary_derived, .beforehand = true},
    {"family", "neighbours of a lattice point inside the body", run_summary_derived, .beforehand = true},
    {"bonds", "bonds of the lattice", run_summary_derived, .beforehand = true},
    {"real_height", "height that a beam has on its lattice, m", run_summary_derived, .beforehand = true},
    {"critical_energy", "energy that an area of crack should cost, J/m^2", run_summary_derived,
     .beforehand = true},
    {"rayleigh_speed", "speed of Rayleigh's wave, m/s", run_summary_derived, .beforehand = true},
    {"crack_start", "time of the first break at the notch, s", crack_start,
     ABOUT_IN("µs", 1e6, "to the first break"), .part = SUMMARY_CRACK, .of_moment = true},
    {"crack_angle",
     "angle of the crack's path from the vertical, of a plate's fastest against its cut, degrees",
     crack_angle_all, ABOUT_IN("degrees", 1, "off its cut"), .part = SUMMARY_CRACK, .of_moment = true},
    {"crack_length", "length of the crack's path, m", crack_length, ABOUT_IN("mm", 1e3, "of crack so far"),
     .part = SUMMARY_CRACK, .of_moment = true},
    {"crack_speed", "largest speed of the crack's tip, m/s", crack_speed,
     ABOUT_IN("m/s", 1, "the tip's fastest"), .part = SUMMARY_CRACK, .of_moment = true},
    {"crack_cost", "energy that an area of crack took, J/m^2", crack_cost_of, .label = NULL},
    {"broken_bonds", "bonds that broke, those of notch and cuts apart", broken_bonds,
     ABOUT_IN("", 1, "bonds broken"), .part = SUMMARY_CRACK, .of_moment = true},
    {"crack_tips", "tips that the cracks of a plate have", crack_tips, ABOUT_IN("", 1, "tips of cracks"),
     .part = SUMMARY_CRACK, .of_moment = true},
    {"branch_time", "time at which a plate's crack branched first, s", branch_time,
     ABOUT_IN("µs", 1e6, "when it branched"), .part = SUMMARY_CRACK, .of_moment = true},
    {"branch_angle", "half of the angle between its branches, degrees", branch_angle, .label = NULL},
    {"v_error", "distance of a bar's velocities from the exact ones, as a share of these", finding,
     ABOUT_IN("%", 100, "error of v"), .part = SUMMARY_FINDINGS, .of_moment = true, .judged = true},
    {"v_peak", "largest velocity of a pulse, as a share of that at the start", finding,
     ABOUT_IN("%", 100, "of the peak is left"), .part = SUMMARY_FINDINGS, .of_moment = true},
    {"reflected", "what a joint sends back, as a share of the pulse that came", finding,
     ABOUT("", "R, sent back", NULL), .part = SUMMARY_FINDINGS, .of_moment = true},
    {"transmitted", "what a joint lets on, as a share of the pulse that came", finding,
     ABOUT("", "T, let on", NULL), .part = SUMMARY_FINDINGS, .of_moment = true},
    {"u_middle", "deflection at mid-span of a beam under its weight, m", finding, .label = "up at mid-span",
     .opposite = "down at mid-span", .unit = "µm", .scale = 1e6, .part = SUMMARY_FINDINGS},
    {"u_last", "displacement of a hanging column's last particle", finding,
     ABOUT("", "moved, at the last one", NULL), .part = SUMMARY_FINDINGS},
    {"invariant", "what one particle keeps of its motion, as a share of the start", finding,
     ABOUT_IN("%", 100, "of the invariant"), .part = SUMMARY_FINDINGS},
    {"first_touch", "time at which two bodies first act on each other", finding,
     ABOUT("", "first touch", NULL), .part = SUMMARY_FINDINGS, .of_moment = true},
    {"wall_touch", "time at which a wall first acts on a body", finding,
     ABOUT("", "first touch of a wall", NULL), .part = SUMMARY_FINDINGS, .of_moment = true},
    {"restitution", "speed at which two bodies part, as a share of that at which they met", finding,
     ABOUT_IN("%", 100, "of the speed is left"), .part = SUMMARY_FINDINGS, .of_moment = true},
    {"momentum_error", "distance of the momentum of bodies from the exact one, as a share", finding,
     ABOUT_IN("%", 100, "error of momentum"), .part = SUMMARY_FINDINGS, .of_moment = true, .judged = true},
    {"angular_kept", "angular momentum of bodies, as a share of the exact one", finding,
     ABOUT_IN("%", 100, "of angular momentum"), .part = SUMMARY_FINDINGS, .of_moment = true, .judged = true},
    {"body_spin", "spin of the second of two bodies, radians per time", finding,
     ABOUT("", "spin of body 2", NULL), .part = SUMMARY_FINDINGS, .of_moment = true},
    {"acceleration", "speed down an incline, per time", finding, ABOUT("", "acceleration so far", NULL),
     .part = SUMMARY_FINDINGS, .of_moment = true},
    {"acceleration_exact", "the same by the formula for sliding or rolling", acceleration_exact,
     .label = NULL},
    {"bounce_height", "height to which a body flies up from a floor", finding,
     ABOUT("", "height of the bounce", NULL), .part = SUMMARY_FINDINGS, .of_moment = true},
    {"tip_error",
     "distance of a falling beam's end from that by finite elements, as a share of its displacement",
     tip_error, ABOUT_IN("%", 100, "error of the end"), .part = SUMMARY_FINDINGS, .of_moment = true,
     .judged = true},
    {"u_error", "error of the displacement of a vibrating block, root mean square over the amplitude",
     finding, ABOUT_IN("%", 100, "error of u"), .part = SUMMARY_FINDINGS, .of_moment = true, .judged = true},
    {"sxx_error", "error of the stress sxx of a vibrating block, root mean square over the amplitude",
     finding, ABOUT_IN("%", 100, "error of sxx"), .part = SUMMARY_FINDINGS, .of_moment = true,
     .judged = true},
    {"stretch", "largest distance of neighbours, as a share of that at the start", finding,
     ABOUT("", "largest stretch", NULL), .part = SUMMARY_FINDINGS, .of_moment = true},
    {"torn", "time at which neighbours of a body parted", finding, ABOUT("", "torn at", NULL),
     .part = SUMMARY_FINDINGS, .of_moment = true},
    {NULL, NULL, NULL, .label = NULL},
};

const RunNumber *run_number_find(const char *word)
{
    for (const RunNumber *row = run_numbers; row->word; row++)
        if (strcmp(row->word, word) == 0)
            return row;
    return NULL;
}

const RunNumber *run_number_about(const Settings *settings)
{
    const RunNumber *named =
        settings_view(settings)->about[0] ? run_number_find(settings_view(settings)->about) : NULL;
    return named && named->label ? named : run_number_find(settings->problem->about);
}

bool run_numbers_beforehand(const Settings *settings, RunSummary *summary, Status *status)
{
    *summary = (RunSummary){.readout = {.error_frequency = NAN,
                                        .error_period = NAN,
                                        .predicted_error_frequency = NAN,
                                        .late = NAN},
                            .broken_bonds = NAN,
                            .crack_length = NAN};
    Simulation *sim = problem_simulate(settings, 1, status);
    if (!sim)
        return false;
    summary->dt = sim->dt;
    summary->n_derived = problem_derived(settings, sim, summary->derived);
    simulation_destroy(sim);
    return true;
}
