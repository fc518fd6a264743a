/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One scenario, one set of bits: however a run is cut, watched, rewound. */
#include "methods/bar_case.h"
#include "suite.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const uint64_t PINNED = 0x54424defb021c3f0u;

/* PINNED is of the first so many, as they were when it was taken. */
enum { ALGORITHMS = 3, SHAPES = 4, TRANSFERS = 5, PINNED_TRANSFERS = 3 };
enum { ALL_SHAPES = ALGORITHMS * SHAPES * TRANSFERS, VARIANTS = ALL_SHAPES + ALGORITHMS * 3 };
enum { PINNED_VARIANTS = ALGORITHMS * SHAPES * PINNED_TRANSFERS };

/* Every algorithm, shape and transfer in turn: FLIP, some PIC, APIC, a mass blend, FMPM. Fast enough that
 * particles cross cells, with loads. */
static BarCase variant(int number)
{
    BarCase bar = bar_case(2, 1.0);
    bar.def.algorithm = (MpmAlgorithm)(number % ALGORITHMS);
    bar.def.shape = (MpmShape)(number / ALGORITHMS % SHAPES);
    int transfer = number / (ALGORITHMS * SHAPES);
    if (number >= ALL_SHAPES) { /* CPDI with FLIP, a mass blend, FMPM */
        static const int transfers[] = {0, 3, 4};
        bar.def.shape = MPM_CPDI;
        transfer = transfers[(number - ALL_SHAPES) / ALGORITHMS];
    }
    bar.def.transfer = transfer == 2 ? MPM_APIC : transfer == 4 ? MPM_FMPM : MPM_FLIP;
    bar.def.mass_blend = transfer == 3 ? 0.4 : 1.0;
    bar.def.fmpm_order = 3;
    bar.def.flip_fraction = transfer == 1 ? 0.95 : 1.0;
    bar.def.length = 40;
    bar.def.particles_per_cell = 1 + number % 5;
    bar.def.body_force = 1e-3;
    bar.def.traction = 1e-2;
    return bar;
}

static void expect_same_state(const Simulation *a, const Simulation *b, const char *when)
{
    size_t size = simulation_snapshot_size(a);
    ck_assert_uint_eq(size, simulation_snapshot_size(b));
    unsigned char *of_a = snapshot_now(a), *of_b = snapshot_now(b);
    if (memcmp(of_a, of_b, size) != 0) {
        size_t at = 0;
        while (of_a[at] == of_b[at])
            at++;
        ck_abort_msg("%s: states differ from byte %zu of %zu, step %ld stage %d", when, at, size, a->step,
                     a->stage);
    }
    free(of_a);
    free(of_b);
}

START_TEST(replay_from_every_stage)
{
    BarCase bar = variant(_i);
    Simulation *sim = bar_case_create(&bar), *straight = bar_case_create(&bar);
    advance(sim, 30);
    advance(straight, 30);
    Status status;
    for (int stage = 0; stage < sim->n_stages; stage++) {
        ck_assert_int_eq(sim->stage, stage);
        unsigned char *bytes = snapshot_now(sim);
        advance(sim, 5); /* the rest of this step, then five */
        simulation_restore(sim, bytes);
        expect_same_state(sim, straight, "restored");
        advance(sim, 5);
        Simulation *other = bar_case_create(&bar);
        advance(other, stage == 0 ? 35 : 36);
        expect_same_state(sim, other, "replayed");
        simulation_destroy(other);
        simulation_restore(sim, bytes);
        free(bytes);
        ck_assert(simulation_stage(sim, &status));
        ck_assert(simulation_stage(straight, &status));
    }
    simulation_destroy(sim);
    simulation_destroy(straight);
}
END_TEST

START_TEST(slices_of_stages)
{
    BarCase bar = variant(_i);
    bar.def.length = 3000; /* of several chunks */
    bar.modes[0].number = 150;
    Simulation *whole = bar_case_create(&bar), *sliced = bar_case_create(&bar);
    ck_assert_uint_gt(sliced->stage_items, 2);
    advance(whole, 25);
    Status status;
    size_t items = 1;
    while (sliced->step < 25) {
        bool done;
        ck_assert(simulation_slice(sliced, items, &done, &status));
        items = items % 3 + 1;
    }
    expect_same_state(whole, sliced, "sliced");
    ck_assert_int_eq(whole->n_events, sliced->n_events);
    for (int i = 0; i < whole->n_events; i++) {
        ck_assert_str_eq(whole->events[i].text, sliced->events[i].text);
        ck_assert_int_eq(whole->events[i].step, sliced->events[i].step);
    }
    simulation_destroy(whole);
    simulation_destroy(sliced);
}
END_TEST

START_TEST(watched_or_not)
{
    enum { STEPS = 70 };
    BarCase bar = variant(_i);
    Simulation *alone = bar_case_create(&bar), *watched = bar_case_create(&bar),
               *asked = bar_case_create(&bar);
    double *rows = malloc(sizeof(double) * STEPS * (size_t)watched->n_series);
    double *row = malloc(sizeof(double) * (size_t)asked->n_series);
    advance(alone, STEPS);
    ck_assert(simulation_steps(watched, STEPS, rows, NULL, NULL));
    for (int step = 0; step < STEPS; step++) {
        advance(asked, 1);
        simulation_row(asked, row);
        ck_assert_mem_eq(row, rows + step * asked->n_series, sizeof(double) * (size_t)asked->n_series);
    }
    expect_same_state(alone, watched, "watched");
    expect_same_state(alone, asked, "asked each step");
    free(rows);
    free(row);
    simulation_destroy(alone);
    simulation_destroy(watched);
    simulation_destroy(asked);
}
END_TEST

/* Steps asked one stage at a time are whole steps. Fast enough that many particles cross cells. */
START_TEST(stages_are_whole_steps)
{
    enum { STEPS = 70 };
    if (!suite_wide() && (_i % VARIANTS + _i / VARIANTS) % 2 != 0)
        return; /* each variant with crossings or without */
    BarCase bar = variant(_i % VARIANTS);
    bar.def.body_force = bar.def.traction = 0;
    bar.def.length = 1500;
    bar.modes[0].number = 60;
    if (_i >= VARIANTS) { /* without crossings */
        bar.modes[0].velocity = 0.01;
        bar.def.length = 1003;
    }
    Simulation *whole = bar_case_create(&bar), *staged = bar_case_create(&bar),
               *watched = bar_case_create(&bar);
    advance(whole, STEPS);
    double *rows = malloc(sizeof(double) * STEPS * (size_t)whole->n_series);
    double *row = malloc(sizeof(double) * (size_t)whole->n_series);
    ck_assert(simulation_steps(watched, STEPS, rows, NULL, NULL));
    for (int step = 0; step < STEPS; step++) {
        do
            ck_assert(simulation_stage(staged, NULL));
        while (staged->stage > 0);
        simulation_row(staged, row);
        ck_assert_mem_eq(row, rows + step * whole->n_series, sizeof(double) * (size_t)whole->n_series);
    }
    expect_same_state(whole, staged, "by stages");
    expect_same_state(watched, staged, "watched");
    ck_assert(_i >= VARIANTS || whole->n_events == SIMULATION_EVENTS_MAX);
    const Simulation *others[] = {whole, watched};
    for (int i = 0; i < 2; i++) {
        ck_assert_int_eq(others[i]->n_events, staged->n_events);
        ck_assert_mem_eq(&others[i]->events_beyond, &staged->events_beyond, sizeof staged->events_beyond);
        for (int k = 0; k < staged->n_events; k++) {
            ck_assert_str_eq(others[i]->events[k].text, staged->events[k].text);
            ck_assert_int_eq(others[i]->events[k].step, staged->events[k].step);
        }
    }
    free(rows);
    free(row);
    simulation_destroy(whole);
    simulation_destroy(staged);
    simulation_destroy(watched);
}
END_TEST

/* A failure in the midst of a batch of steps: the run stands where it would have stood. */
START_TEST(failure_in_a_batch)
{
    BarCase bar = bar_case(90, 20.0);
    bar.def.length = 2000;
    bar.def.algorithm = (MpmAlgorithm)_i;
    Simulation *whole = bar_case_create(&bar), *staged = bar_case_create(&bar);
    Status status, other;
    long done = 0;
    ck_assert(!simulation_steps(whole, 5000, NULL, &done, &status));
    while (simulation_stage(staged, &other))
        ck_assert_int_le(staged->step, done);
    ck_assert_int_eq(staged->step, done);
    ck_assert_str_eq(status.text, other.text);
    Simulation *sound = bar_case_create(&bar);
    advance(sound, done);
    expect_same_state(sound, whole, "before the failure");
    ck_assert_int_eq(sound->n_events, whole->n_events);
    simulation_destroy(whole);
    simulation_destroy(staged);
    simulation_destroy(sound);
}
END_TEST

static double parabola(double x, const void *context)
{
    (void)context;
    return x * (50.0 - x) * 0.001;
}

/* The bits are those of IEEE arithmetic, whatever compiler, flags and machine: one number stands for all of
 * them. (The starting velocity needs no library function.) A change of it is a change of the method. */
START_TEST(pinned_bits)
{
    uint64_t hash = 0xcbf29ce484222325u;
    for (int number = 0; number < PINNED_VARIANTS; number++) {
        MpmDef def = variant(number).def;
        def.initial_velocity = parabola;
        Simulation *sim = mpm_create(&def, NULL);
        ck_assert_ptr_nonnull(sim);
        advance(sim, 200);
        static const char *const names[] = {"x", "v", "stress", "density"};
        for (int i = 0; i < 4; i++) {
            double *values = field_now(sim, 0, names[i]);
            const unsigned char *bytes = (const unsigned char *)values;
            for (size_t k = 0; k < sim->counts[0] * sizeof *values; k++)
                hash = (hash ^ bytes[k]) * 0x100000001b3u;
            free(values);
        }
        simulation_destroy(sim);
    }
    ck_assert_msg(hash == PINNED, "the bits are 0x%016llx", (unsigned long long)hash);
}
END_TEST

START_TEST(live_changes_belong_to_the_state)
{
    BarCase bar = bar_case(5, 0.1);
    Simulation *sim = bar_case_create(&bar);
    Status status;
    advance(sim, 10);
    unsigned char *before = snapshot_now(sim);
    static const struct {
        const char *key;
        double value;
    } changes[] = {{"mpm.algorithm", MPM_MUSL}, {"mpm.flip_fraction", 0.5}, {"load.body_force", 0.1},
                   {"load.traction", 0.2},      {"mpm.transfer", MPM_APIC}, {"mpm.transfer", MPM_FLIP},
                   {"mpm.mass_blend", 0},       {"mpm.mass_blend", 1},      {"mpm.transfer", MPM_FMPM},
                   {"mpm.fmpm_order", 4}};
    for (size_t i = 0; i < sizeof changes / sizeof changes[0]; i++) {
        unsigned char *bytes = snapshot_now(sim);
        advance(sim, 10);
        Simulation *other = bar_case_create(&bar);
        advance(other, sim->step);
        simulation_restore(sim, bytes);
        ck_assert(sim->method->change(sim, changes[i].key, changes[i].value, &status));
        advance(sim, 10);
        double *v = field_now(sim, 0, "v"), *w = field_now(other, 0, "v");
        ck_assert_mem_ne(v, w, 50 * sizeof *v);
        free(v);
        free(w);
        free(bytes);
        simulation_destroy(other);
    }
    ck_assert_int_eq(sim->n_stages, 8);
    simulation_restore(sim, before);
    ck_assert_int_eq(sim->n_stages, 7);
    advance(sim, 10);
    Simulation *other = bar_case_create(&bar);
    advance(other, 20);
    expect_same_state(sim, other, "back before the changes");
    ck_assert(!sim->method->change(sim, "bar.length", 3, &status));
    ck_assert(!sim->method->change(sim, "mpm.mass_blend", 0.04, &status));
    ck_assert(sim->method->change(sim, "mpm.mass_blend", 0.05, &status));
    ck_assert(!sim->method->change(sim, "mpm.transfer", MPM_FMPM, &status));
    free(before);
    simulation_destroy(other);
    simulation_destroy(sim);
}
END_TEST

START_TEST(fields_come_and_go_with_the_stages)
{
    BarCase bar = bar_case(5, 0.1);
    Simulation *sim = bar_case_create(&bar);
    Status status;
    advance(sim, 20);
    int stage_of_mass = simulation_find_stage(sim, "map"),
        stage_of_force = simulation_find_stage(sim, "force");
    for (int done = 0; done < sim->n_stages; done++) {
        double *mass = field_now(sim, 1, "mass"), *force = field_now(sim, 1, "f_int");
        ck_assert(done > stage_of_mass ? mass[3] > 0 : mass[3] == 0);
        ck_assert(done > stage_of_force ? force[3] != 0 : force[3] == 0);
        free(mass);
        free(force);
        ck_assert(simulation_stage(sim, &status));
    }
    simulation_destroy(sim);
}
END_TEST

/* kinetic_grid of the series is what the table of nodes adds up to. */
START_TEST(the_table_of_nodes_holds_kinetic_grid)
{
    BarCase bar = variant(_i);
    Simulation *sim = bar_case_create(&bar);
    Status status;
    advance(sim, 20);
    double expected = series_now(sim, "kinetic_grid"), sum = 0;
    for (int i = 0; i < sim->sets[1].ready_after; i++)
        ck_assert(simulation_stage(sim, &status));
    ck_assert_str_eq(sim->stages[sim->stage].id, "integrate");
    double *mass = field_now(sim, 1, "mass"), *momentum = field_now(sim, 1, "momentum");
    for (size_t i = 0; i < sim->counts[1]; i++)
        if (mass[i] > 0)
            sum += momentum[i] * momentum[i] / (2 * mass[i]);
    ck_assert_double_eq_tol(sum, expected, 1e-12 * expected);
    free(mass);
    free(momentum);
    simulation_destroy(sim);
}
END_TEST

/* Columns that are left out change no other: rows by themselves and of a call. */
START_TEST(columns_that_are_left_out)
{
    BarCase bar = bar_case(5, 0.1);
    bar.def.length = _i % 2 ? 700 : 20;
    if (_i >= 2) {
        bar.def.joint = bar.def.length / 2;
        bar.def.joint_modulus = 400;
        bar.def.joint_density = 2;
    }
    static const char *const asked[] = {"all", "", "kinetic_grid", "kinetic_null", "x_cm_rate", "reaction"};
    static const int left_out[] = {0, 5, 4, 4, 4, 4};
    enum { CHOICES = 6 };
    double rows[CHOICES][40 * 16]; /* of steps 1 to 39, and the last once more */
    Simulation *sims[CHOICES];
    for (int k = 0; k < CHOICES; k++) {
        sims[k] = bar_case_create(&bar);
        simulation_ask_columns(sims[k], asked[k]);
        ck_assert_int_eq(sims[k]->n_series, sims[0]->n_series - left_out[k]);
        Status status;
        ck_assert(simulation_steps(sims[k], 39, rows[k], NULL, &status));
        simulation_row(sims[k], rows[k] + 39 * sims[k]->n_series);
        expect_same_state(sims[0], sims[k], asked[k]);
    }
    for (int k = 1; k < CHOICES; k++)
        for (int i = 0; i < sims[k]->n_series; i++) {
            const char *name = sims[k]->series[i].name;
            const int other = simulation_find_series(sims[0], name);
            for (int row = 0; row < 40; row++) {
                const double value = rows[k][row * sims[k]->n_series + i];
                ck_assert_double_eq(value, rows[0][row * sims[0]->n_series + other]);
            }
        }
    for (int k = 0; k < CHOICES; k++)
        simulation_destroy(sims[k]);
}
END_TEST

/* Equations fit their box, and links are a partition of unity. */
START_TEST(words_fit)
{
    BarCase bar = variant(_i);
    Simulation *sim = bar_case_create(&bar);
    advance(sim, 20);
    for (int stage = 0; stage < sim->n_stages; stage++) {
        for (const char *line = sim->stages[stage].equation; *line; line += *line == '\n') {
            int columns = 0;
            for (; *line && *line != '\n'; line++)
                columns += ((unsigned char)*line & 0xc0) != 0x80;
            ck_assert_int_le(columns, 76);
        }
    }
    for (size_t p = 0; p < sim->counts[0]; p++) {
        Link links[8], back[64];
        size_t count = sim->method->links(sim, 0, p, links, 8);
        double sum = 0, slope = 0;
        for (size_t i = 0; i < count; i++) {
            sum += links[i].weight, slope += links[i].gradient[0];
            ck_assert_int_eq(links[i].set, 1);
            size_t n = sim->method->links(sim, 1, links[i].index, back, 64), found = 0;
            for (size_t k = 0; k < n; k++)
                found += back[k].index == p && back[k].weight == links[i].weight;
            ck_assert_uint_eq(found, 1);
        }
        ck_assert_double_eq_tol(sum, 1, 1e-14);
        ck_assert_double_eq_tol(slope, 0, 1e-13);
    }
    simulation_destroy(sim);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *test = tcase_create("bits");
    tcase_add_loop_test(test, replay_from_every_stage, 0, VARIANTS);
    tcase_add_loop_test(test, slices_of_stages, 0, VARIANTS);
    tcase_add_loop_test(test, watched_or_not, 0, VARIANTS);
    tcase_add_loop_test(test, stages_are_whole_steps, 0, 2 * VARIANTS);
    tcase_add_loop_test(test, failure_in_a_batch, 0, ALGORITHMS);
    tcase_add_test(test, pinned_bits);
    tcase_add_test(test, live_changes_belong_to_the_state);
    tcase_add_test(test, fields_come_and_go_with_the_stages);
    tcase_add_loop_test(test, the_table_of_nodes_holds_kinetic_grid, 0, VARIANTS);
    tcase_add_loop_test(test, columns_that_are_left_out, 0, 4);
    tcase_add_loop_test(test, words_fit, 0, VARIANTS);
    suite_add_tcase(suite, test);
}
