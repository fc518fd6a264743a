/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The log says what happened and when: against what is known of these runs. */
#include "run/experiment.h"
#include "scenario/settings.h"
#include "scenario/parameters.h"
#include "scenario/scenario.h"
#include "suite.h"

#include <math.h>
#include <string.h>

static Experiment *run(const char *scenario, const char *const *keys, long steps)
{
    static Settings settings;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scenario_load(scenario, &settings, &status), "%s", status.text);
    for (; keys && *keys; keys += 2)
        ck_assert_msg(settings_set(&settings, keys[0], keys[1], &status), "%s", status.text);
    Experiment *experiment = experiment_create(&settings, 64 << 20, 1, &status);
    ck_assert_msg(experiment != NULL, "%s", status.text);
    experiment_advance(experiment, steps, NULL);
    experiment_rest(experiment);
    return experiment;
}

/* The first event of a kind; NULL: there is none. */
static const Event *first_of(Experiment *experiment, EventKind kind)
{
    int count;
    const Event *events = experiment_events(experiment, &count);
    for (int i = 0; i < count; i++) {
        ck_assert_int_ge(events[i].step, i > 0 ? events[i - 1].step : 0);
        ck_assert_int_le(events[i].step, experiment_newest(experiment));
    }
    for (int i = 0; i < count; i++)
        if (events[i].kind == kind)
            return &events[i];
    return NULL;
}

static int count_of(Experiment *experiment, EventKind kind)
{
    int count, found = 0;
    const Event *events = experiment_events(experiment, &count);
    for (int i = 0; i < count; i++)
        found += events[i].kind == kind;
    return found;
}

/* Half a period behind at t = 13.1 (n = 5) and 1.49 (n = 10); mode 1 is not in 100. */
START_TEST(lags_come_at_their_time)
{
    static const struct {
        const char *scenario;
        double time;
    } lags[] = {{"mode5", 13.1}, {"mode10", 1.49}};
    for (int i = 0; i < 2; i++) {
        Experiment *experiment = run(lags[i].scenario, NULL, 10000);
        const Event *event = first_of(experiment, EVENT_LATE);
        ck_assert_ptr_nonnull(event);
        ck_assert_double_eq_tol(0.01 * (double)event->step, lags[i].time, i == 0 ? 0.05 : 0.005);
        ck_assert_str_eq(event->text, "half a period behind exact");
        experiment_destroy(experiment);
    }
    Experiment *experiment = run("mode1", NULL, 10000);
    int count;
    experiment_events(experiment, &count);
    ck_assert_int_eq(count, 0);
    experiment_destroy(experiment);
}
END_TEST

/* The ripple is no drift: undamped runs without crossings say nothing of energy. */
START_TEST(the_ripple_is_no_drift)
{
    static const char *const algorithms[] = {"usf", "musl"};
    static const char *const scenarios[] = {"mode1", "mode5", "mode10", "mode10-fine"};
    for (int a = 0; a < 2; a++)
        for (int s = 0; s < 4; s++) {
            Experiment *experiment =
                run(scenarios[s], (const char *const[]){"mpm.algorithm", algorithms[a], NULL}, 10000);
            ck_assert_int_eq(count_of(experiment, EVENT_ENERGY), 0);
            experiment_destroy(experiment);
        }
}
END_TEST

START_TEST(energy_that_drifts_is_told_with_its_cause)
{
    Experiment *experiment = run("crossing", NULL, 10000);
    const Event *event = first_of(experiment, EVENT_ENERGY);
    ck_assert_ptr_nonnull(event);
    ck_assert_str_eq(event->text, "energy 2.4 % above the start: cell crossing");
    ck_assert_ptr_nonnull(strstr(first_of(experiment, EVENT_CROSSING)->text, "crossed into cell"));
    experiment_destroy(experiment);
    experiment = run("mode5", (const char *const[]){"mpm.algorithm", "usl", NULL}, 10000);
    event = first_of(experiment, EVENT_ENERGY);
    ck_assert_ptr_nonnull(event);
    ck_assert_ptr_nonnull(strstr(event->text, "below the start: USL damping"));
    ck_assert_int_ge(count_of(experiment, EVENT_ENERGY), 3); /* 5, 10, 20, 50 % */
    experiment_destroy(experiment);
    experiment = run("mode5", (const char *const[]){"mpm.flip_fraction", "0.99", NULL}, 2000);
    ck_assert_ptr_nonnull(strstr(first_of(experiment, EVENT_ENERGY)->text, "PIC damping"));
    experiment_destroy(experiment);
}
END_TEST

/* A beam that is drawn out of its channel: growth is told where the energies on screen show it, at the first
 * step that is looked at, whatever the channel's work in the laboratory comes to (it is more than the energy
 * of the vibration). */
START_TEST(growth_is_told_when_the_energy_has_grown)
{
    Experiment *experiment =
        run("moving-cantilever-hat-coarse", (const char *const[]){"time.courant", "1", NULL}, 1900);
    const Event *event = first_of(experiment, EVENT_ENERGY);
    ck_assert_ptr_nonnull(event);
    ck_assert_str_eq(event->text, "the energy has grown by 10 %");
    int n_columns, total = 0, work = 0;
    const Column *columns = experiment_columns(experiment, &n_columns);
    for (int i = 0; i < n_columns; i++) {
        total = strcmp(columns[i].quantity.name, "total") == 0 ? i : total;
        work = strcmp(columns[i].quantity.name, "work") == 0 ? i : work;
    }
    const Record *record = experiment_record(experiment);
    const double start = record_row(record, 0)[total];
    long first = -1;
    double most_work = 0;
    for (size_t i = 0; i < record->count && first < 0; i++) {
        const double *row = record_row(record, i);
        const long step = lround(row[0]);
        most_work = fmax(most_work, fabs(row[work]));
        first = step % 64 == 0 && row[total] > 1.1 * start ? step : -1;
    }
    ck_assert_int_eq(event->step, first);
    ck_assert_double_gt(most_work, start);
    experiment_destroy(experiment);
}
END_TEST

START_TEST(advice_changes_and_failure_are_told)
{
    Experiment *experiment = run("mode5", (const char *const[]){"time.courant", "1.7", NULL}, 0);
    const Event *event = first_of(experiment, EVENT_ADVICE);
    ck_assert_ptr_nonnull(event);
    ck_assert_int_eq(event->step, 0);
    ck_assert_ptr_nonnull(strstr(event->text, "courant 1.7 is near the largest stable one, 1.732"));
    experiment_destroy(experiment);

    experiment = run("mode1", NULL, 200);
    Settings settings = *experiment_settings(experiment);
    ck_assert(settings_set(&settings, "mpm.algorithm", "usl", NULL));
    ck_assert(experiment_edit(experiment, &settings, NULL));
    ck_assert(experiment_advance(experiment, 100, NULL));
    event = first_of(experiment, EVENT_CHANGE);
    ck_assert_ptr_nonnull(event);
    ck_assert_int_eq(event->step, 200);
    ck_assert_str_eq(event->text, "mpm.algorithm = usl");
    /* back before it, and on in another way: it never happened */
    experiment_seek(experiment, 100, 0);
    while (experiment_pending(experiment, NULL))
        ck_assert(experiment_work(experiment, (Effort){.steps = 1000}, &(bool){false}, NULL));
    ck_assert_int_eq(count_of(experiment, EVENT_CHANGE), 1); /* rewound: still known */
    settings = *experiment_settings(experiment);
    ck_assert(settings_set(&settings, "mpm.flip_fraction", "0.5", NULL));
    ck_assert(experiment_edit(experiment, &settings, NULL));
    ck_assert(experiment_advance(experiment, 300, NULL));
    ck_assert_int_eq(count_of(experiment, EVENT_CHANGE), 1);
    ck_assert_int_eq(first_of(experiment, EVENT_CHANGE)->step, 100);
    experiment_destroy(experiment);

    /* particles leave the mesh */
    experiment = run("mode1", (const char *const[]){"initial.velocity", "8", NULL}, 10000);
    event = first_of(experiment, EVENT_FAILURE);
    ck_assert_ptr_nonnull(event);
    ck_assert_int_eq(event->step, experiment_newest(experiment));
    ck_assert_ptr_nonnull(strstr(event->text, "particle"));
    experiment_destroy(experiment);
}
END_TEST

/* Many crossings fill the method's own list; what matters is still told. */
START_TEST(many_crossings_hide_nothing)
{
    Experiment *experiment =
        run("crossing", (const char *const[]){"mesh.cell_size", "0.1", "mesh.padding", "200", NULL}, 9000);
    ck_assert_int_gt(experiment_simulation(experiment)->events_beyond.of[EVENT_CROSSING], 0);
    Settings settings = *experiment_settings(experiment);
    ck_assert(settings_set(&settings, "mpm.algorithm", "musl", NULL));
    ck_assert(experiment_edit(experiment, &settings, NULL));
    ck_assert(experiment_advance(experiment, 10, NULL));
    ck_assert_int_eq(first_of(experiment, EVENT_CHANGE)->step, 9000);
    experiment_destroy(experiment);
}
END_TEST

START_TEST(asking_often_or_once_gives_the_same)
{
    Experiment *once = run("crossing", NULL, 6000), *often = run("crossing", NULL, 0);
    int n_once, n_often;
    for (int i = 0; i < 60; i++) {
        ck_assert(experiment_advance(often, 100, NULL));
        experiment_events(often, &n_often);
    }
    experiment_rest(often);
    const Event *a = experiment_events(once, &n_once), *b = experiment_events(often, &n_often);
    ck_assert_int_eq(n_once, n_often);
    for (int i = 0; i < n_once; i++) {
        ck_assert_str_eq(a[i].text, b[i].text);
        ck_assert_int_eq(a[i].step, b[i].step);
    }
    experiment_destroy(once);
    experiment_destroy(often);
}
END_TEST

START_TEST(a_beam_tells_its_first_break)
{
    Experiment *experiment = run("notched-beam-coarse", NULL, 900);
    const Event *event = first_of(experiment, EVENT_BREAK);
    ck_assert_ptr_nonnull(event);
    ck_assert_str_eq(event->text, "first bond broke near the notch's end");
    ck_assert_int_eq(event->step, 732);
    experiment_destroy(experiment);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("events");
    tcase_add_test(tcase, lags_come_at_their_time);
    tcase_add_test(tcase, the_ripple_is_no_drift);
    tcase_add_test(tcase, energy_that_drifts_is_told_with_its_cause);
    tcase_add_test(tcase, growth_is_told_when_the_energy_has_grown);
    tcase_add_test(tcase, advice_changes_and_failure_are_told);
    tcase_add_test(tcase, many_crossings_hide_nothing);
    tcase_add_test(tcase, asking_often_or_once_gives_the_same);
    tcase_add_test(tcase, a_beam_tells_its_first_break);
    suite_add_tcase(suite, tcase);
}
