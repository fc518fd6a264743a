/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Verdicts on a number. */
#include "cli/verify/verify.h"
#include "scenario/concern_output.h"
#include "base/cancel.h"
#include "scenario/scenario.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool lies_in(Band band, double number)
{
    return number >= band.low && number <= band.high; /* what is not a number lies nowhere */
}

VerifyNumbers verify_numbers(VerifyRun *run, const VerifyRow *row)
{
    VerifyQuantity *const quantities[VERIFY_COLUMNS] = {[VERIFY_THEORY] = row->theory,
                                                        [VERIFY_EIGENVALUE] = row->eigenvalue,
                                                        [VERIFY_PREDICTED] = row->predicted,
                                                        [VERIFY_MEASURED] = row->quantity};
    VerifyNumbers numbers;
    const double scale = row->scale != 0 ? row->scale : 1;
    int found = 0;
    for (int i = VERIFY_COLUMNS; i-- > 0;) {
        numbers.values[i] = run && quantities[i] ? scale * quantities[i](run, row) : NAN;
        if (quantities[i] && found++ == 0)
            numbers.own = numbers.beside = (VerifyColumn)i;
        else if (quantities[i] && found == 2)
            numbers.beside = (VerifyColumn)i;
    }
    return numbers;
}

static Verdict of_band(Band band, double number)
{
    if (band.low == 0 && band.high == 0)
        return VERDICT_NONE;
    return lies_in(band, number) ? VERDICT_GOOD : VERDICT_MISSED;
}

Verdict verify_reproduces(const VerifyRow *row, const VerifyNumbers *numbers)
{
    return of_band(row->reference, numbers->values[numbers->own]);
}

Verdict verify_is_bounded(const VerifyRow *row, const VerifyNumbers *numbers)
{
    return of_band(row->bound, numbers->values[numbers->own]);
}

Verdict verify_is_near(const VerifyRow *row, const VerifyNumbers *numbers)
{
    if (!(row->tolerance > 0))
        return VERDICT_NONE;
    double off = fabs(numbers->values[numbers->own] - numbers->values[numbers->beside]);
    return off <= row->tolerance ? VERDICT_GOOD : VERDICT_MISSED;
}

Agreement verify_agreement(const Claim *claim, double measured)
{
    if (!claim->words)
        return PAPER_SILENT;
    if (isnan(claim->number))
        return lies_in(claim->range, measured) ? PAPER_AGREES : PAPER_DIFFERS;
    double off = fabs(measured / claim->number - 1);
    return off <= claim->agrees ? PAPER_AGREES : off <= claim->near ? PAPER_NEAR : PAPER_DIFFERS;
}

/* Runs a scenario step by step as `matvib run` does, and keeps its rows. */

bool verify_settings(const char *scenario, Settings *settings, Status *status)
{
    enum { KEYS_MAX = 12 };
    char text[256], *place = NULL;
    Override overrides[KEYS_MAX];
    int count = 0;
    snprintf(text, sizeof text, "%s", scenario);
    const char *name = strtok_r(text, " ", &place);
    for (char *word; count < KEYS_MAX && (word = strtok_r(NULL, " ", &place)) != NULL; count++) {
        char *value = strchr(word, '=');
        while (*place && strcspn(place, " ") <= strcspn(place, "=")) { /* "bodies.left=disc 1 2 3" */
            place[-1] = ' ';
            place += strcspn(place, " ");
            if (*place)
                *place++ = '\0';
        }
        *value = '\0';
        overrides[count] = (Override){"--set", word, value + 1};
    }
    return scenario_load_with(name, overrides, count, settings, status);
}

/* Columns that need the past want a row of every step: those between are overwritten by the next. */
static bool fill_row(void *owner, Run *passing, long step, const double *row, Status *status)
{
    VerifyRun *run = owner;
    const long every = settings_output(&run->settings)->every;
    const size_t place = (size_t)((step + every - 1) / every);
    (void)status;
    if (place >= run->count)
        return true; /* the last step, where it is not a multiple */
    references_row(run->refs, step, (double)step * passing->sim->dt, row,
                   run->rows + place * (size_t)run->n_columns);
    return true;
}

bool verify_run_open(VerifyRun *run, const char *scenario, int threads, Cancel cancel)
{
    Status *status = &run->failure;
    *run = (VerifyRun){.scenario = scenario, .threads = threads};
    if (!verify_settings(scenario, &run->settings, status))
        return false;
    run->settings.cancel = cancel;
    if (!run_open(&run->passing, &run->settings, problem_simulate(&run->settings, threads, status), status))
        return false;
    run->refs = references_create(&run->settings, run->passing.sim, status);
    if (!run->refs)
        return false;
    run->n_columns = references_columns(run->refs, run->columns);
    /* Its rows, one for each `every`-th step up to its end, which may come before that of its time. */
    const long every = settings_output(&run->settings)->every;
    const Sink sink = {.every = references_memory(run->refs) ? 1 : every, .row = fill_row, .owner = run};
    run->count = (size_t)(run->passing.last / every) + 1;
    run->passing.last = (long)(run->count - 1) * every;
    run->spacing = (double)every * run->passing.sim->dt;
    run->rows = calloc(run->count * (size_t)run->n_columns, sizeof *run->rows);
    if (!run->rows)
        return status_fail(status, "not enough memory for the rows of a run");
    references_reset(run->refs);
    if (!run_start(&run->passing, &sink, status) || !run_to_end(&run->passing, &sink, status))
        return false;
    run->count = (size_t)(run->passing.last / every) + 1;
    references_readout(run->refs, run->rows, run->count, run->n_columns, &run->readout);
    if (run->readout.no_memory)
        return status_fail(status, "%s: %s", scenario, run->readout.unmeasured);
    run->n_derived = problem_derived(&run->settings, run->passing.sim, run->derived);
    return true;
}

void verify_run_close(VerifyRun *run)
{
    free(run->rows);
    references_destroy(run->refs);
    run_close(&run->passing);
    *run = (VerifyRun){0};
}

const double *verify_column(const VerifyRun *run, const char *name)
{
    const int column = references_column(run->columns, run->n_columns, name);
    return column >= 0 ? run->rows + column : NULL;
}

size_t verify_rows_between(const VerifyRun *run, double from, double to, size_t *first)
{
    const double slack = 1e-9; /* a time that should be a row's may miss it by rounding */
    double begin = fmax(ceil(from / run->spacing - slack), 0);
    double end = fmin(floor(to / run->spacing + slack), (double)run->count - 1);
    *first = (size_t)begin;
    return end >= begin ? (size_t)(end - begin) + 1 : 0;
}
