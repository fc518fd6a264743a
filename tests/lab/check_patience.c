/* SPDX-License-Identifier: GPL-3.0-or-later */
/* No work without an end: whatever the parameters say, within their limits, a run that is being built asks
 * often enough whether to go on, and is given up soon after the answer is no. Time is the processor's, so
 * that a machine that is busy with something else changes nothing. */
#include "lab/run/experiment.h"
#include "lab/settings/parameters.h"
#include "suite.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

#define PATIENCE 0.02 /* s, after which the answer is no */
#define LONG     0.06 /* s; what takes longer has to have asked since */
#define LONGEST  0.1  /* s between two questions: twice what is wanted, for a machine that is busy */
#define ANSWER   0.3  /* s, in which all is over; a lattice's eigenvalues are asked about every 10 ms or so */

static double processor_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Sanitizers slow everything down alike. */
static double slowness(void)
{
    const char *multiplier = getenv("CK_TIMEOUT_MULTIPLIER");
    return multiplier && atof(multiplier) > 1 ? atof(multiplier) : 1;
}

static bool until_deadline(double share, void *deadline)
{
    (void)share;
    return processor_seconds() < *(double *)deadline;
}

static void expect_answer(const Problem *problem, MethodKind method, const Parameter *parameter, double value)
{
    Settings settings;
    Status status = {0};
    settings_default(&settings, problem);
    settings.method = method;
    if (!settings_have(&settings, parameter) || !settings_in_range(parameter, problem, value))
        return;
    settings_put(&settings, parameter, value);
    const double began = processor_seconds();
    double deadline = began + PATIENCE;
    settings.patience = (Patience){until_deadline, &deadline};
    Experiment *experiment =
        settings_check(&settings, &status) ? experiment_create(&settings, 1000000, 1, &status) : NULL;
    const double took = processor_seconds() - began;
    ck_assert_msg(took < ANSWER * slowness(), "%s, %s = %g: no answer for %.2f s (%s)", problem->word,
                  parameter->key, value, took, status.text);
    ck_assert_msg(took < LONG * slowness() || !experiment, "%s, %s = %g: built within %.2f s without asking",
                  problem->word, parameter->key, value, took);
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
                const double usual = parameter_usual(one, problems[p]), scale = usual != 0 ? usual : 1;
                for (size_t k = 0; one->type == PARAMETER_REAL && k < sizeof factors / sizeof *factors; k++)
                    expect_answer(problems[p], solver->method, one, scale * factors[k]);
            }
}
END_TEST

/* How often a building asks, to its end or until it has taken long enough. */
typedef struct Listening {
    double began, last, longest; /* s; the longest time without a question */
    double patience;
} Listening;

static bool listen(double share, void *context)
{
    (void)share;
    Listening *listening = context;
    const double now = processor_seconds();
    listening->longest = fmax(listening->longest, now - listening->last);
    listening->last = now;
    return now - listening->began < listening->patience;
}

static const struct {
    const char *problem, *method; /* NULL: it has but one */
    const char *set[9];           /* key, value, ...; NULL */
} large[] = {
    {"moving-cantilever", "pd", {"motion.channel", "16.5"}},
    {"moving-cantilever", "mpm", {"motion.channel", "8"}},
    {"simply-supported-beam", "pd", {"beam.length", "1"}},
    {"simply-supported-beam", "pd", {"beam.height", "0.01"}},
    {"simply-supported-beam", "mpm", {"beam.length", "2"}},
    {"moving-cantilever", "mpm", {"motion.channel", "20"}},
    {"notched-beam", NULL, {"beam.length", "10.5"}},
    {"bar",
     "pd",
     {"bar.length", "5000", "pd.horizon", "12", "initial.mode", "10", "initial.overtones", "3:.1,4:.1"}},
    {"bar", "mpm", {"bar.length", "19000", "mpm.shape", "bspline3", "bar.supports", "fixed-fixed"}},
};

/* Each part of a large building asks, not only its first. */
START_TEST(every_part_of_a_building_asks)
{
    Settings settings;
    Status status = {0};
    settings_default(&settings, problem_find(large[_i].problem));
    ck_assert(!large[_i].method || settings_set(&settings, "scenario.method", large[_i].method, &status));
    for (int k = 0; large[_i].set[k]; k += 2)
        ck_assert(settings_set(&settings, large[_i].set[k], large[_i].set[k + 1], &status));
    ck_assert(settings_check(&settings, &status));
    const double now = processor_seconds();
    Listening listening = {now, now, 0, 3 * slowness()};
    settings.patience = (Patience){listen, &listening};
    Experiment *experiment = experiment_create(&settings, 1000000, 1, &status);
    if (experiment)
        listen(1, &listening);
    experiment_destroy(experiment);
    ck_assert_msg(listening.longest < LONGEST * slowness(), "%s by %s, %s = %s: %.2f s without a question",
                  large[_i].problem, settings_method_words[settings.method], large[_i].set[0],
                  large[_i].set[1], listening.longest);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("limits");
    tcase_add_test(tcase, no_value_makes_the_building_deaf);
    tcase_add_loop_test(tcase, every_part_of_a_building_asks, 0, sizeof large / sizeof *large);
    suite_add_tcase(suite, tcase);
}
