/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a scenario step by step as `matvib run` does, and keeps its rows. */
#include "cli/verify/verify_run.h"

#include "scenario/parameters.h"
#include "scenario/scenario.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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
        *value = '\0';
        overrides[count] = (Override){"--set", word, value + 1};
    }
    return scenario_load_with(name, overrides, count, settings, status);
}

bool verify_steps(const Settings *settings, Simulation *sim, long steps, double share, Status *status)
{
    const long block = simulation_steps_a_question(sim);
    for (long left = steps; left > 0; left -= block) {
        if (!patience_lasts(&settings->patience, share))
            return status_fail(status, STATUS_FAILED, "interrupted");
        if (!simulation_steps(sim, left < block ? left : block, NULL, NULL, status))
            return false;
    }
    return true;
}

/* Steps, and after every `every`-th a row. Columns that need the past want a row of every step: those between
 * are overwritten by the next. */
static bool fill_rows(VerifyRun *run, long every, Status *status)
{
    const long stride = references_memory(run->refs) ? 1 : every, last = (long)(run->count - 1) * every;
    double *method_row = calloc((size_t)run->sim->n_series, sizeof *method_row);
    bool sound = method_row || status_fail(status, STATUS_FAILED, "not enough memory");
    for (long step = 0; sound && step <= last; step += stride) {
        double *row = run->rows + (size_t)((step + every - 1) / every) * (size_t)run->n_columns;
        simulation_row(run->sim, method_row);
        references_row(run->refs, step, (double)step * run->sim->dt, method_row, row);
        sound = step == last ||
                verify_steps(&run->settings, run->sim, stride, (double)step / (double)last, status);
    }
    free(method_row);
    return sound;
}

bool verify_run_open(VerifyRun *run, const char *scenario, int threads, Patience patience)
{
    Status *status = &run->failure;
    *run = (VerifyRun){.scenario = scenario, .threads = threads};
    if (!verify_settings(scenario, &run->settings, status))
        return false;
    run->settings.patience = patience;
    run->sim = problem_simulate(&run->settings, threads, status);
    run->refs = run->sim ? references_create(&run->settings, run->sim, status) : NULL;
    if (!run->refs)
        return false;
    const long every = run->settings.output.every;
    run->n_columns = references_columns(run->refs, run->columns);
    run->count = (size_t)(problem_last_step(run->sim->dt, run->settings.time.end) / every) + 1;
    run->spacing = (double)every * run->sim->dt;
    run->rows = calloc(run->count * (size_t)run->n_columns, sizeof *run->rows);
    if (!run->rows)
        return status_fail(status, STATUS_FAILED, "not enough memory for the rows of a run");
    references_reset(run->refs);
    if (!fill_rows(run, every, status))
        return false;
    references_readout(run->refs, run->rows, run->count, run->n_columns, &run->readout);
    run->n_derived = problem_derived(&run->settings, run->sim, run->derived);
    return true;
}

void verify_run_close(VerifyRun *run)
{
    free(run->rows);
    references_destroy(run->refs);
    simulation_destroy(run->sim);
    *run = (VerifyRun){0};
}

const double *verify_column(const VerifyRun *run, const char *name)
{
    for (int i = 0; i < run->n_columns; i++)
        if (strcmp(run->columns[i].quantity.name, name) == 0)
            return run->rows + i;
    return NULL;
}

size_t verify_rows_between(const VerifyRun *run, double from, double to, size_t *first)
{
    const double slack = 1e-9; /* a time that should be a row's may miss it by rounding */
    double begin = fmax(ceil(from / run->spacing - slack), 0);
    double end = fmin(floor(to / run->spacing + slack), (double)run->count - 1);
    *first = (size_t)begin;
    return end >= begin ? (size_t)(end - begin) + 1 : 0;
}
