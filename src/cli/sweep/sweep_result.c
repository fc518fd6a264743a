#include "cli/sweep/sweep_result.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct ColumnText {
    const char *name, *unit_bar, *unit_beam, *meaning;
} ColumnText;

/* Of the bar a frequency in radians per unit time is compared, of beams a period. */
static const ColumnText texts[RESULT_COLUMNS] = {
    [RESULT_MEASURED] = {"measured", "1/time", "s",
                         "frequency in radians per time (bar) or period (beams), fitted to the series"},
    [RESULT_PREDICTED] =
        {"predicted", "1/time", "s",
         "the same predicted by the equations of this very mesh (bar) or lattice (supported beam)"},
    [RESULT_EXACT] = {"exact", "1/time", "s",
                      "the same exact: of the continuum (bar), by Timoshenko's theory (supported beam), by "
                      "the modal equations (moving cantilever)"},
    [RESULT_ERROR] = {"error", "%", "%", "measured against exact"},
    [RESULT_EXACT_EULER] = {"exact_euler", "s", "s", "period by Euler-Bernoulli's theory"},
    [RESULT_ERROR_EULER] = {"error_euler", "%", "%", "measured against exact_euler"},
    [RESULT_REAL_HEIGHT] = {"real_height", "m", "m", "height of the lattice: rows times spacing"},
    [RESULT_REAL_SPAN] = {"real_span", "m", "m", "length of the lattice that vibrates"},
    [RESULT_BROKEN_BONDS] = {"broken_bonds", "1", "1", "bonds broken at the end"},
    [RESULT_CRACK_LENGTH] = {"crack_length", "m", "m", "length of the crack at the end"},
    [RESULT_ENERGY_LEFT] =
        {"energy_left", "1", "1",
         "energy at the end as a share of that at the start: E* where there is one, else the "
         "means of total less the work of loads over the first and the last period"},
    [RESULT_STEPS] = {"steps", "1", "1", "time steps done"},
    [RESULT_WALL] = {"wall", "s", "s", "seconds that the run took"},
};

const char *result_name(ResultColumn column)
{
    return texts[column].name;
}

Quantity result_quantity(ResultColumn column, const Problem *problem)
{
    const ColumnText *text = &texts[column];
    const char *unit = problem->si ? text->unit_beam : text->unit_bar;
    return (Quantity){text->name, text->name, unit, text->meaning};
}

static double derived_value(const RunSummary *summary, const char *name)
{
    for (int i = 0; i < summary->n_derived; i++)
        if (strcmp(summary->derived[i].name, name) == 0)
            return summary->derived[i].value;
    return NAN;
}

static double last_value(const RunSummary *summary, const char *column)
{
    for (int i = 0; i < summary->n_columns; i++)
        if (strcmp(summary->columns[i].quantity.name, column) == 0)
            return summary->last_row[i];
    return NAN;
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
    if (readout->measured_known)
        cells[RESULT_MEASURED] = readout->measured;
    if (readout->predicted_known)
        cells[RESULT_PREDICTED] = readout->predicted;
    if (readout->exact_known)
        cells[RESULT_EXACT] = readout->exact;
    cells[RESULT_ERROR] = percent(cells[RESULT_MEASURED], cells[RESULT_EXACT]);
    cells[RESULT_EXACT_EULER] = derived_value(summary, "period_euler");
    cells[RESULT_ERROR_EULER] = percent(cells[RESULT_MEASURED], cells[RESULT_EXACT_EULER]);
}

void result_of(const RunSummary *summary, const Settings *settings, double wall, SweepResult *result)
{
    double *cells = result->cells;
    for (int i = 0; i < RESULT_COLUMNS; i++)
        cells[i] = NAN;
    put_readout(summary, cells);
    cells[RESULT_REAL_HEIGHT] = derived_value(summary, "real_height");
    cells[RESULT_REAL_SPAN] = derived_value(summary, "real_span");
    if (settings->problem != &bar_problem && settings->bonds.critical_stretch > 0)
        cells[RESULT_BROKEN_BONDS] = last_value(summary, "broken_bonds");
    cells[RESULT_CRACK_LENGTH] = last_value(summary, "crack_length");
    if (summary->energy_told != ENERGY_UNTOLD && !summary->energy_of_work)
        cells[RESULT_ENERGY_LEFT] = 1 + summary->energy_change / 100;
    cells[RESULT_STEPS] = (double)summary->steps;
    cells[RESULT_WALL] = wall;
    result->done = true;
    if (summary->readout.moving && !summary->readout.measured_known)
        snprintf(result->failure.text, sizeof result->failure.text, "%s", summary->readout.unmeasured);
}
