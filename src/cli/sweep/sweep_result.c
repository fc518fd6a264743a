/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The columns of the result of a sweep: name, unit and meaning of each, and the numbers of a finished run.
 * A column is a bar's (frequency), a beam's (period) or of cracks. */
#include "cli/sweep/sweep_plan.h"

#include "scenario/concern_bonds.h"
#include "scenario/settings.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const struct {
    const char *name, *unit, *meaning;
} texts[RESULT_COLUMNS] = {
    [RESULT_FREQUENCY_MEASURED] = {"frequency_measured", "1/time",
                                   "bar: radians per time, fitted to the series"},
    [RESULT_FREQUENCY_UNCERTAINTY] = {"frequency_uncertainty", "1/time",
                                      "its standard deviation if the residual is noise"},
    [RESULT_FREQUENCY_R2] = {"frequency_r2", "1",
                             "share of the series' variance that the fit explains; below 0.5 it is not one "
                             "frequency, and there is none measured"},
    [RESULT_FREQUENCY_PREDICTED] = {"frequency_predicted", "1/time",
                                    "the same by the equations of this very mesh or lattice"},
    [RESULT_FREQUENCY_EXACT] = {"frequency_exact", "1/time", "the same of the continuum"},
    [RESULT_FREQUENCY_ERROR] = {"frequency_error", "%", "measured against exact"},
    [RESULT_PERIOD_MEASURED] = {"period_measured", "s", "beam: fitted to the series"},
    [RESULT_PERIOD_UNCERTAINTY] = {"period_uncertainty", "s",
                                   "its standard deviation if the residual is noise"},
    [RESULT_PERIOD_R2] = {"period_r2", "1", "as frequency_r2"},
    [RESULT_PERIOD_PREDICTED] = {"period_predicted", "s",
                                 "the same by the equations of this very lattice (supported beam)"},
    [RESULT_PERIOD_THEORY] = {"period_theory", "s",
                              "the same by beam theory: Timoshenko's (supported beam), the modal equations "
                              "(moving cantilever)"},
    [RESULT_PERIOD_ERROR] = {"period_error", "%", "measured against theory"},
    [RESULT_PERIOD_EULER] = {"period_euler", "s", "period by Euler-Bernoulli's theory"},
    [RESULT_PERIOD_ERROR_EULER] = {"period_error_euler", "%", "measured against Euler-Bernoulli's"},
    [RESULT_REAL_HEIGHT] = {"real_height", "m", "height of the lattice: rows times spacing"},
    [RESULT_REAL_SPAN] = {"real_span", "m", "length of the lattice that vibrates"},
    [RESULT_FIRST_BREAK] = {"first_break", "s", "time at which the first bond breaks at the notch's end"},
    [RESULT_CRACK_ANGLE] = {"crack_angle", "degree",
                            "between the notch and the straight line through the whole path of the crack; of "
                            "a plate between a cut and the fastest crack from it"},
    [RESULT_CRACK_LENGTH] = {"crack_length", "m", "length of the crack at the end"},
    [RESULT_TIP_SPEED] = {"tip_speed", "m/s",
                          "of the crack's tip at its fastest, until it came to the protected zone; of a "
                          "plate the fastest of all tips"},
    [RESULT_TIPS] = {"tips", "1", "plate: tips of cracks at the end"},
    [RESULT_BRANCHED] = {"branched", "1", "plate: 1 where a crack has branched, else 0"},
    [RESULT_BRANCH_X] = {"branch_x", "m", "plate: where along it the first crack that branched did so"},
    [RESULT_BRANCH_TIME] = {"branch_time", "s", "when it did"},
    [RESULT_HALF_ANGLE] = {"half_angle", "degree", "half of the angle between its two branches"},
    [RESULT_CRACK_COST] = {"crack_cost", "J/m^2",
                           "energy of all broken bonds over the area of the cracks; to be set beside "
                           "pd.critical_energy"},
    [RESULT_BROKEN_BONDS] = {"broken_bonds", "1", "bonds broken at the end"},
    [RESULT_ENERGY_LEFT] =
        {"energy_left", "1",
         "energy at the end as a share of that at the start: E* where there is one, else the "
         "means of total less the work of loads over the first and the last period"},
    [RESULT_STEPS] = {"steps", "1", "time steps done"},
    [RESULT_WALL] = {"wall", "s", "seconds that the run took"},
    [RESULT_KEPT_MEASURED] = {"kept_measured", "1",
                              "share of its energy that the motion keeps in one exact period, fitted to the "
                              "series"},
    [RESULT_KEPT_PREDICTED] = {"kept_predicted", "1",
                               "the same as predicted: by this very mesh, or by the damping"},
    [RESULT_MISTAKE] = {"with_a_mistake", "1",
                        "1: by a code that is wrong in one place (mpm.mistake, pd.mistake)"},
};

const char *sweep_result_name(ResultColumn column)
{
    return texts[column].name;
}

Quantity sweep_result_quantity(ResultColumn column)
{
    return (Quantity){texts[column].name, texts[column].name, texts[column].unit, texts[column].meaning};
}

static double percent(double value, double reference)
{
    return 100 * (value / reference - 1);
}

/* The numbers of a run without motion are no answers, even where theory knows them. */
static void put_readout(const RunSummary *summary, double cells[RESULT_COLUMNS])
{
    const Readout *readout = &summary->readout;
    if (!readout->moving)
        return;
    /* six columns for either: measured, its uncertainty, R2, predicted, exact or theory, and the error */
    double *six = cells + (readout->is_period ? RESULT_PERIOD_MEASURED : RESULT_FREQUENCY_MEASURED);
    if (readout->measured_known)
        six[0] = readout->measured;
    six[1] = readout->uncertainty;
    six[2] = readout->r2;
    if (readout->predicted_known)
        six[3] = readout->predicted;
    if (readout->exact_known)
        six[4] = readout->exact;
    six[5] = percent(six[0], six[4]);
    cells[RESULT_KEPT_MEASURED] = readout->kept_measured;
    cells[RESULT_KEPT_PREDICTED] = readout->kept_predicted;
    cells[RESULT_PERIOD_EULER] = run_summary_derived(summary, "period_euler");
    cells[RESULT_PERIOD_ERROR_EULER] = percent(cells[RESULT_PERIOD_MEASURED], cells[RESULT_PERIOD_EULER]);
}

void sweep_result_of(const RunSummary *summary, const Settings *settings, double wall, SweepResult *result)
{
    double *cells = result->cells;
    for (int i = 0; i < RESULT_COLUMNS; i++)
        cells[i] = NAN;
    put_readout(summary, cells);
    cells[RESULT_REAL_HEIGHT] = run_summary_derived(summary, "real_height");
    cells[RESULT_REAL_SPAN] = run_summary_derived(summary, "real_span");
    if (settings->problem->concerns & CONCERN_BREAKING && settings_bonds(settings)->critical_stretch > 0)
        cells[RESULT_BROKEN_BONDS] = summary->broken_bonds;
    /* The notched beam has one crack, a plate any number. */
    const FrontsFacts *fronts = &summary->fronts;
    if (summary->crack_known) {
        cells[RESULT_FIRST_BREAK] = summary->crack.measured.first_break;
        cells[RESULT_CRACK_ANGLE] = summary->crack.angle;
        if (summary->crack.measured.fastest > 0)
            cells[RESULT_TIP_SPEED] = summary->crack.measured.fastest;
    }
    if (summary->fronts_known) {
        cells[RESULT_CRACK_ANGLE] = fronts->angle;
        cells[RESULT_TIP_SPEED] = fronts->fastest;
        cells[RESULT_TIPS] = fronts->n_tips;
        cells[RESULT_BRANCHED] = fronts->branched;
    }
    if (summary->fronts_known && fronts->branched) {
        cells[RESULT_BRANCH_X] = fronts->branch[0];
        cells[RESULT_BRANCH_TIME] = fronts->branch_time;
        cells[RESULT_HALF_ANGLE] = fronts->half_angle;
    }
    if (summary->price_known)
        cells[RESULT_CRACK_COST] = summary->price.cost.total / summary->price.cost.area;
    cells[RESULT_CRACK_LENGTH] = summary->crack_length;
    if (summary->energy_measure != ENERGY_NOT_KNOWN && !summary->energy_of_work)
        cells[RESULT_ENERGY_LEFT] = 1 + summary->energy_change / 100;
    cells[RESULT_STEPS] = (double)summary->steps;
    cells[RESULT_WALL] = wall;
    if (summary->mistake)
        cells[RESULT_MISTAKE] = 1;
    result->done = true;
    if (summary->readout.moving && !summary->readout.measured_known)
        snprintf(result->failure.text, sizeof result->failure.text, "%s", summary->readout.unmeasured);
}
