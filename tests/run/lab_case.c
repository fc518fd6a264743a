/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/lab_case.h"
#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "methods/bonds/plane/bonds_plane.h"
#include "suite.h"

#include <stdlib.h>
#include <string.h>

Settings bar_settings(int mode, double end)
{
    Settings settings;
    settings_default(&settings, &problem_bar);
    settings_edit_start(&settings)->mode = mode;
    settings_edit_time(&settings)->end = end;
    return settings;
}

void set(Settings *settings, const char *key, const char *value)
{
    Status status = {0};
    ck_assert_msg(settings_set(settings, key, value, &status), "%s", status.text);
}

Settings beam_settings(const Problem *problem, double end)
{
    Settings settings;
    settings_default(&settings, problem);
    settings_edit_time(&settings)->end = end;
    if (problem == &problem_notched_beam) {
        settings_edit_geometry(&settings)->length = 0.1;
        settings_edit_geometry(&settings)->height = 0.04;
        set(&settings, "pd.horizon", "4e-3");
        set(&settings, "pd.spacing", "1e-3");
        set(&settings, "notch.position", "0.03");
        set(&settings, "notch.depth", "0.01");
        set(&settings, "load.position", "0.05");
        set(&settings, "load.width", "0.004");
        settings_edit_supports(&settings)->left = 0.0055;
        settings_edit_supports(&settings)->right = 0.0945;
        settings_edit_bonds(&settings)->protected_depth = 0.006;
        settings_edit_time(&settings)->step = 2e-7;
    } else {
        set(&settings, "pd.horizon", "3.75e-3");
        set(&settings, "pd.spacing", "1.25e-3");
    }
    return settings;
}

Experiment *open_experiment(const Settings *settings, size_t history)
{
    Status status = {0};
    Experiment *experiment = experiment_create(settings, history, 1, &status);
    ck_assert_msg(experiment != NULL, "%s", status.text);
    return experiment;
}

void finish_work(Experiment *experiment)
{
    long left;
    Status status = {0};
    for (int rounds = 0; experiment_pending(experiment, &left); rounds++) {
        ck_assert_int_lt(rounds, 1000000);
        ck_assert_int_ge(left, 0);
        ck_assert_msg(experiment_work(experiment, (Effort){.steps = 37}, &(bool){false}, &status), "%s",
                      status.text);
    }
}

unsigned long draw(unsigned long *state, unsigned long below)
{
    *state = *state * 6364136223846793005ul + 1442695040888963407ul;
    return (*state >> 33) % below;
}

unsigned char *state_of(const Simulation *sim, size_t *size)
{
    *size = simulation_snapshot_size(sim);
    unsigned char *bytes = calloc(1, *size);
    ck_assert_ptr_nonnull(bytes);
    simulation_snapshot(sim, bytes);
    return bytes;
}

void expect_same_states(const Simulation *a, const Simulation *b, const char *what)
{
    ck_assert_msg(a->step == b->step && a->stage == b->stage, "%s: step %ld stage %d and step %ld stage %d",
                  what, a->step, a->stage, b->step, b->stage);
    size_t size, other;
    unsigned char *x = state_of(a, &size), *y = state_of(b, &other);
    ck_assert_uint_eq(size, other);
    /* every assertion tells its place through a pipe: one for all bytes */
    size_t k = 0;
    while (k < size && x[k] == y[k])
        k++;
    ck_assert_msg(k == size, "%s: byte %zu of %zu differs at step %ld stage %d", what, k, size, a->step,
                  a->stage);
    free(x);
    free(y);
}

void expect_same_records(const Record *a, const Record *b, const char *what)
{
    ck_assert_msg(a->count == b->count, "%s: %zu and %zu rows", what, a->count, b->count);
    ck_assert_int_eq(a->n_columns, b->n_columns);
    size_t bytes = (size_t)a->n_columns * sizeof(double), i = 0;
    while (i < a->count && memcmp(record_row(a, i), record_row(b, i), bytes) == 0)
        i++;
    ck_assert_msg(i == a->count, "%s: row %zu differs", what, i);
}

int column_of(const Experiment *experiment, const char *name)
{
    Column columns[COLUMNS_MAX];
    const int n = references_columns(experiment_references(experiment), columns);
    for (int i = 0; i < n; i++)
        if (strcmp(columns[i].quantity.name, name) == 0)
            return i;
    return -1;
}
