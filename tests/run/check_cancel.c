/* SPDX-License-Identifier: GPL-3.0-or-later */
/* No work without an end: whatever the parameters say, within their limits, a run that is being built asks
 * often enough whether to go on, and is given up as soon as the answer is no. Questions are counted, and no
 * clock is read; MATVIB_TELL=1 tells the longest time between two of them too, for people. */
#include "run/experiment.h"
#include "scenario/settings.h"
#include "scenario/parameters.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum {
    ASKED = 2,        /* so often the answer is yes */
    AFTERWARDS = 4,   /* questions, at most, on the way out */
    SMALL = 32 << 20, /* bytes of state of what may be built without a question */
};

typedef struct Listening {
    long questions, most; /* behind the first `most` the answer is no */
    double last, longest; /* s of the processor, told only */
} Listening;

static double processor_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static bool listen(double share, void *context)
{
    (void)share;
    Listening *listening = context;
    const double now = processor_seconds();
    listening->longest = fmax(listening->longest, now - listening->last);
    listening->last = now;
    return ++listening->questions <= listening->most;
}

static Listening build(Settings *settings, long most, Experiment **experiment)
{
    Status status = {0};
    Listening listening = {.most = most, .last = processor_seconds()};
    settings->cancel = (Cancel){listen, &listening};
    *experiment = settings_check(settings, &status) ? experiment_create(settings, 1000000, 1, &status) : NULL;
    return listening;
}

static void expect_answer(const Problem *problem, MethodKind method, const Parameter *parameter, double value)
{
    Settings settings;
    Experiment *experiment;
    settings_default(&settings, problem);
    settings.method = method;
    if (!parameter_applies_to(&settings, parameter) || !settings_in_range(parameter, problem, value))
        return;
    settings_put(&settings, parameter, value);
    const Listening listening = build(&settings, ASKED, &experiment);
    ck_assert_msg(listening.questions <= ASKED + AFTERWARDS, "%s, %s = %g: asks %ld times after the answer",
                  problem->word, parameter->key, value, listening.questions - ASKED);
    ck_assert_msg(listening.questions <= ASKED || !experiment, "%s, %s = %g: built all the same",
                  problem->word, parameter->key, value);
    ck_assert_msg(!experiment || simulation_snapshot_size(experiment_simulation(experiment)) < SMALL,
                  "%s, %s = %g: large, and built without a question", problem->word, parameter->key, value);
    experiment_destroy(experiment);
}

/* The limits of a value, and where it has none far more and far less than is usual. */
START_TEST(no_value_makes_the_building_deaf)
{
    static const double factors[] = {1e-6, 1e-3, 1e3, 4e4, 1e9};
    const Solver *solver;
    for (int p = 0; problems[p]; p++)
        for (int s = 0; (solver = problems[p]->solvers[s]) != NULL; s++)
            for (const Parameter *one = parameters; one < parameters + n_parameters; one++) {
                if (one->type == PARAMETER_TEXT || !parameter_applies(one, problems[p]))
                    continue;
                expect_answer(problems[p], solver->method, one, one->least);
                expect_answer(problems[p], solver->method, one, one->most);
                const double usual = parameter_in(one, problems[p]).usual, scale = usual != 0 ? usual : 1;
                for (size_t k = 0; one->type == PARAMETER_REAL && k < sizeof factors / sizeof *factors; k++)
                    expect_answer(problems[p], solver->method, one, scale * factors[k]);
            }
}
END_TEST

/* Large enough that every part of the building has its questions, and how many they are together, but for a
 * twentieth. */
static const struct {
    const char *problem, *method; /* NULL: it has but one */
    const char *set[9];           /* key, value, ...; NULL */
    long questions;
} large[] = {
    {"moving-cantilever", "pd", {"motion.channel", "1.65"}, 3090},
    {"moving-cantilever", "mpm", {"motion.channel", "2"}, 168},
    {"simply-supported-beam", "pd", {"beam.length", "0.2"}, 2880},
    {"simply-supported-beam", "pd", {"beam.height", "0.006"}, 3380},
    {"simply-supported-beam", "mpm", {"beam.length", "0.2"}, 398},
    {"notched-beam", NULL, {"beam.length", "1.05"}, 11700},
    {"bar",
     "pd",
     {"bar.length", "1000", "pd.horizon", "12", "initial.mode", "10", "initial.overtones", "3:.1,4:.1"},
     424},
    {"bar", "mpm", {"bar.length", "19000", "mpm.shape", "bspline3", "bar.supports", "fixed-fixed"}, 22},
};

/* Each part of a large building asks, not only its first. */
START_TEST(every_part_of_a_building_asks)
{
    if (!suite_wide() &&
        (_i % 2 == 0 || strcmp(large[_i].problem, "notched-beam") == 0)) /* one of each method */
        return;
    Settings settings;
    Status status = {0};
    Experiment *experiment;
    settings_default(&settings, problem_find(large[_i].problem));
    ck_assert(!large[_i].method || settings_set(&settings, "scenario.method", large[_i].method, &status));
    for (int k = 0; large[_i].set[k]; k += 2)
        ck_assert(settings_set(&settings, large[_i].set[k], large[_i].set[k + 1], &status));
    const Listening listening = build(&settings, 1000000, &experiment);
    ck_assert_ptr_nonnull(experiment);
    experiment_destroy(experiment);
    if (getenv("MATVIB_TELL"))
        fprintf(stderr, "%s, %s = %s: %ld questions, at most %.1f ms between two\n", large[_i].problem,
                large[_i].set[0], large[_i].set[1], listening.questions, 1e3 * listening.longest);
    ck_assert_int_ge(listening.questions, large[_i].questions);
    /* given up in the middle too */
    const Listening half = build(&settings, listening.questions / 2, &experiment);
    ck_assert_ptr_null(experiment);
    ck_assert_int_le(half.questions, listening.questions / 2 + AFTERWARDS);
}
END_TEST

void add_cases(Suite *suite)
{
    suite_fork();
    TCase *tcase = tcase_create("limits");
    tcase_add_test(tcase, no_value_makes_the_building_deaf);
    tcase_add_loop_test(tcase, every_part_of_a_building_asks, 0, sizeof large / sizeof *large);
    suite_add_tcase(suite, tcase);
}
