/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energy view, read as it stands on the screen: the hidden share, E*, and a name for every band. */
#include "suite.h"
#include "panes/panes.h"
#include "views/scene.h"
#include "panes/screen.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void open_scene(Scene *scene, const char *words)
{
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scene_open(scene, words, &status), "%s: %s", words, status.text);
}

/* The number behind a word on the screen. */
static double number_behind(const Scene *scene, const char *word)
{
    char *text = canvas_dump(&scene->canvas);
    ck_assert_ptr_nonnull(text);
    double value = NAN;
    for (const char *at = text; isnan(value) && (at = strstr(at, word)); at++)
        sscanf(at + strlen(word), "%lf", &value); /* the word in the legend has no number */
    if (isnan(value))
        ck_abort_msg("no number behind %s in\n%s", word, text);
    free(text);
    return value;
}

/* Share of the kinetic energy that the lumped grid has not, USF, P = 2, v0 = .1, as independent solvers gave
 * it; on screen it is told in two: lumping, and the null space of the map to the grid. */
static const struct {
    int mode, end;
    double share;
} hidden_shares[] = {
    {1, 10, .0007}, {1, 100, .0008}, {5, 10, .059}, {5, 100, .248}, {10, 10, .252}, {10, 100, .942},
};

START_TEST(the_hidden_share_is_that_of_the_reference)
{
    char words[96];
    Scene scene;
    snprintf(words, sizeof words, "mode1 80x24 %d lower 3 window 10 initial.mode=%d",
             100 * hidden_shares[_i].end, hidden_shares[_i].mode);
    open_scene(&scene, words);
    const double null = number_behind(&scene, "null space ") / 100;
    ck_assert_double_eq_tol(null + number_behind(&scene, "lumping ") / 100, hidden_shares[_i].share, 1e-3);
    /* nothing is hidden at first; with the tenth mode nearly all at last */
    ck_assert_int_eq(null > 0.9, hidden_shares[_i].share > 0.9);
    ck_assert_int_eq(null < 0.03, hidden_shares[_i].end == 10 || hidden_shares[_i].mode == 1);
    scene_close(&scene);
}
END_TEST

/* Without crossings E* is kept where the sum of the energies ripples. */
static const char *const kept[] = {"usf", "musl"};

START_TEST(the_sharp_energy_does_not_ripple)
{
    for (int mode = 1; mode <= 10; mode += 4) {
        double start, now, most = 0, ripple = 0;
        char words[160];
        Scene scene;
        snprintf(words, sizeof words, "mode1 80x24 1 initial.velocity=1e-8 initial.mode=%d mpm.algorithm=%s",
                 mode, kept[_i]);
        open_scene(&scene, words);
        Experiment *experiment = scene.duel.a;
        const int total = experiment_record(experiment)->n_columns - 1;
        for (int k = 0; k < 100; k++) {
            ck_assert(experiment_advance(experiment, 97, NULL));
            ck_assert(experiment_invariant(experiment, &now, &start));
            most = fmax(most, fabs(now / start - 1));
            const double *row = experiment_row(experiment),
                         *first = record_row(experiment_record(experiment), 0);
            ripple = fmax(ripple, fabs(row[total] / first[total] - 1));
        }
        ck_assert_double_lt(most, 3e-10);
        ck_assert_double_gt(ripple, 1e-3);
        scene_close(&scene);
    }
}
END_TEST

/* Looking at it leaves no trace in the run. */
START_TEST(looking_changes_no_bit)
{
    Scene looked, other;
    double now, start;
    open_scene(&looked, "crossing 80x24 10");
    open_scene(&other, "crossing 80x24 10");
    for (int k = 0; k < 40; k++) {
        experiment_invariant(looked.screen.experiment, &now, &start);
        ck_assert(experiment_advance(looked.duel.a, 50, NULL));
        ck_assert(experiment_advance(other.duel.a, 50, NULL));
    }
    const Simulation *a = experiment_simulation(looked.screen.experiment);
    const Simulation *b = experiment_simulation(other.screen.experiment);
    const size_t size = simulation_snapshot_size(a);
    ck_assert_uint_eq(size, simulation_snapshot_size(b));
    void *one = malloc(size), *two = malloc(size);
    simulation_snapshot(a, one);
    simulation_snapshot(b, two);
    ck_assert_int_eq(memcmp(one, two, size), 0);
    int n_a, n_b;
    experiment_events(looked.screen.experiment, &n_a);
    experiment_events(other.screen.experiment, &n_b);
    ck_assert_int_eq(n_a, n_b);
    free(one);
    free(two);
    scene_close(&looked);
    scene_close(&other);
}
END_TEST

START_TEST(usl_loses_and_crossings_heat)
{
    Scene scene;
    open_scene(&scene, "mode5 80x24 10000 lower 3 mpm.algorithm=usl");
    ck_assert_double_eq_tol(number_behind(&scene, ", loss "), 100 - 20.7, 10);
    scene_close(&scene);
    open_scene(&scene, "mode1 80x24 10000 lower 3 initial.velocity=1 mesh.padding=16");
    ck_assert_double_eq_tol(number_behind(&scene, ", gain "), 25.8, 4);
    scene_close(&scene);
}
END_TEST

/* Every band has its name, however narrow or low the pane. */
START_TEST(the_legend_is_never_cut)
{
    static const char *const scenes[][2] = {
        {"mode5 80x24 700 lower 3", "grid lumping null strain"},
        {"gravity 80x24 700 lower 3", "grid lumping null strain work"},
        {"notched-beam-coarse 80x24 60 lower 3", "kinetic strain dissipated work"}};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        Scene scene;
        open_scene(&scene, scenes[i][0]);
        scene.screen.panes.focus = PANE_LOWER;
        static const int sizes[][2] = {{80, 24}, {60, 18}, {40, 12}, {60, 20}, {120, 40}, {100, 30}};
        for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
            ck_assert(canvas_open(&scene.canvas, sizes[k][0], sizes[k][1], NULL));
            screen_draw(&scene.screen, &scene.canvas);
            char *text = canvas_dump(&scene.canvas), words[64], *place;
            snprintf(words, sizeof words, "%s", scenes[i][1]);
            for (char *word = strtok_r(words, " ", &place); word; word = strtok_r(NULL, " ", &place))
                ck_assert_msg(strstr(text, word) != NULL, "no %s at %dx%d:\n%s", word, sizes[k][0],
                              sizes[k][1], text);
            free(text);
        }
        scene_close(&scene);
    }
}
END_TEST

/* The residual that is shown, where bonds break: what the balance lacks over the work. */
START_TEST(the_residual_is_small_where_bonds_break)
{
    Scene scene;
    open_scene(&scene, "pulled-plate 80x24 400 lower 3 time.step=2e-7");
    const double *row = experiment_row(scene.screen.experiment);
    const double residual = 100 * (row[experiment_column(scene.screen.experiment, "total")] /
                                       row[experiment_column(scene.screen.experiment, "work")] -
                                   1);
    ck_assert_double_gt(row[experiment_column(scene.screen.experiment, "broken_bonds")], 4000);
    ck_assert_double_eq_tol(number_behind(&scene, "residual "), residual, 0.0051);
    ck_assert_double_lt(fabs(residual), 0.1);
    scene_close(&scene);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("energies");
    tcase_add_loop_test(tcase, the_hidden_share_is_that_of_the_reference, 0,
                        (int)(sizeof hidden_shares / sizeof *hidden_shares));
    tcase_add_loop_test(tcase, the_sharp_energy_does_not_ripple, 0, (int)(sizeof kept / sizeof *kept));
    tcase_add_test(tcase, looking_changes_no_bit);
    tcase_add_test(tcase, usl_loses_and_crossings_heat);
    tcase_add_test(tcase, the_legend_is_never_cut);
    tcase_add_test(tcase, the_residual_is_small_where_bonds_break);
    suite_add_tcase(suite, tcase);
}
