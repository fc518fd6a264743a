/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a definition comes to: lattices, critical steps, periods; and what is refused, with the key named. */
#include "methods/beam_case.h"
#include "methods/default_defs.h"
#include "suite.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

START_TEST(the_papers_notched_beam)
{
    BeamDef def = beam_default(BEAM_NOTCHED);
    Simulation *sim = beam_case_create(&def, NULL);
    BeamFacts facts;
    beam_facts(sim, &facts);
    ck_assert_uint_eq(sim->counts[SET_PARTICLE], 58800);
    ck_assert_uint_eq(facts.bonds, 1388854);
    ck_assert_uint_eq(facts.notch_bonds, 1378);
    ck_assert_uint_eq(facts.family, 48);
    ck_assert_double_eq_tol(facts.critical_step, 2.91e-7, 0.01e-7);
    ck_assert_double_eq_tol(facts.real_span, 0.2, 1e-12);
    double *loaded = field_now(sim, SET_PARTICLE, "loaded"), *held = field_now(sim, SET_PARTICLE, "held");
    double n_loaded = 0, n_held = 0;
    for (size_t p = 0; p < 58800; p++) {
        n_loaded += loaded[p];
        n_held += held[p];
    }
    ck_assert(n_loaded == 6 && n_held == 4);
    free(loaded);
    free(held);
    simulation_destroy(sim);
}
END_TEST

START_TEST(bulk_factors)
{
    BeamDef def = small_beam(BEAM_SIMPLY_SUPPORTED);
    Simulation *sim = beam_case_create(&def, NULL);
    double *factor = field_now(sim, SET_PARTICLE, "surface_factor");
    ck_assert_double_eq_tol(factor[25 + 5 * 100], 1.139778, 1e-6);
    free(factor);
    simulation_destroy(sim);
}
END_TEST

/* One row of Table 1: horizon and spacing in mm, what they come to. */
typedef struct TableRow {
    double horizon, spacing;
    int ny;
    double critical; /* s */
    double period;   /* ms, energy method with partial areas; 0: too long for this test */
} TableRow;

static const TableRow table[] = {
    {5, 1.2, 4, 4.25e-7, 0.9927}, {2.5, 0.6, 8, 2.72e-7, 0.9150}, {2, 0.5, 10, 2.14e-7, 0.8655},
    {1.5, 0.35, 14, 1.67e-7, 0},  {1.25, 0.3, 16, 1.39e-7, 0},    {1, 0.25, 20, 1.077e-7, 0},
};
enum { TABLE_ROWS = sizeof table / sizeof *table, PERIOD_ROWS = 3 };

static BeamDef row_beam(const TableRow *row)
{
    BeamDef def = beam_default(BEAM_SIMPLY_SUPPORTED);
    def.horizon = row->horizon * 1e-3;
    def.spacing = row->spacing * 1e-3;
    return def;
}

START_TEST(critical_steps)
{
    BeamDef def = row_beam(&table[_i]);
    Simulation *sim = beam_case_create(&def, NULL);
    BeamFacts facts;
    beam_facts(sim, &facts);
    ck_assert_int_eq(facts.ny, table[_i].ny);
    ck_assert_msg(fabs(facts.critical_step / table[_i].critical - 1) < 3e-3,
                  "critical step %.5g, expected %.4g", facts.critical_step, table[_i].critical);
    ck_assert(sim->dt == facts.critical_step / 2);
    simulation_destroy(sim);

    def.dt = facts.critical_step * 1.001;
    Status status = {0};
    ck_assert_ptr_null(beam_create(&def, &status));
    ck_assert_int_eq(status.code, STATUS_USAGE);
    ck_assert_msg(strncmp(status.text, "time.step: ", 11) == 0, "%s", status.text);
}
END_TEST

/* By 800 Lanczos steps of another program; without a surface correction the largest eigenvalues lie close
 * together, and 200 steps are 2e-6 away. */
START_TEST(the_critical_step_has_converged)
{
    BeamDef def = row_beam(&(TableRow){.horizon = 0.75, .spacing = 0.25});
    def.surface_correction = SURFACE_NONE;
    Simulation *sim = beam_case_create(&def, NULL);
    BeamFacts facts;
    beam_facts(sim, &facts);
    ck_assert_double_eq_tol(facts.critical_step / 2 / 4.677823117e-8, 1, 2e-7);
    simulation_destroy(sim);
}
END_TEST

/* 1.075e-7 is stable and 1.08e-7 blows up: so says the reference, and the refusal stands between them. */
START_TEST(the_edge_of_stability)
{
    BeamDef def = beam_default(BEAM_SIMPLY_SUPPORTED);
    Status status = {0};
    def.dt = 1.08e-7;
    ck_assert_ptr_null(beam_create(&def, &status));
    def.dt = 1.075e-7;
    Simulation *sim = beam_case_create(&def, NULL);
    double start = series_now(sim, "total");
    advance(sim, 1000);
    ck_assert_msg(fabs(series_now(sim, "total") / start - 1) < 0.2, "energy %g",
                  series_now(sim, "total") / start);
    simulation_destroy(sim);
}
END_TEST

/* What is left of a record after the best cosine, sine and offset of one frequency. */
static double misfit(const double *record, long n, double dt, double omega)
{
    double a[3][4] = {{0}}, rest = 0;
    for (long k = 0; k < n; k++) {
        double base[3] = {cos(omega * dt * (double)k), sin(omega * dt * (double)k), 1};
        for (int r = 0; r < 3; r++) {
            for (int c = 0; c < 3; c++)
                a[r][c] += base[r] * base[c];
            a[r][3] += base[r] * record[k];
        }
        rest += record[k] * record[k];
    }
    double right[3] = {a[0][3], a[1][3], a[2][3]};
    for (int r = 0; r < 3; r++)
        for (int below = r + 1; below < 3; below++) {
            double share = a[below][r] / a[r][r];
            for (int c = r; c < 4; c++)
                a[below][c] -= share * a[r][c];
        }
    for (int r = 2; r >= 0; r--) {
        for (int c = r + 1; c < 3; c++)
            a[r][3] -= a[r][c] * a[c][3];
        a[r][3] /= a[r][r];
        rest -= a[r][3] * right[r];
    }
    return rest;
}

static double fitted_period(const double *record, long n, double dt, double low, double high)
{
    const double golden = 0.6180339887498949;
    for (int round = 0; round < 60; round++) {
        double one = high - golden * (high - low), two = low + golden * (high - low);
        if (misfit(record, n, dt, 2 * 3.141592653589793 / one) <
            misfit(record, n, dt, 2 * 3.141592653589793 / two))
            high = two;
        else
            low = one;
    }
    return (low + high) / 2;
}

START_TEST(periods_of_table_1)
{
    if (!suite_wide() && _i == 2) /* a second */
        return;
    BeamDef def = row_beam(&table[_i]);
    Simulation *sim = beam_case_create(&def, NULL);
    enum { EVERY = 10 };
    long n = (long)(2e-3 / sim->dt) / EVERY + 1;
    double *record = malloc((size_t)n * sizeof *record);
    ck_assert_ptr_nonnull(record);
    for (long k = 0; k < n; k++) {
        record[k] = series_now(sim, "u_probe");
        advance(sim, EVERY);
    }
    double period = 1e3 * fitted_period(record, n, EVERY * sim->dt, 0.7e-3, 1.3e-3);
    ck_assert_msg(fabs(period / table[_i].period - 1) < 2e-3, "period %.5f ms, expected %.4f", period,
                  table[_i].period);
    free(record);
    simulation_destroy(sim);
}
END_TEST

/* --- what is refused --- */

typedef struct Wrong {
    BeamProblem problem;
    size_t member; /* of BeamDef, a double */
    double value;
    const char *key;
} Wrong;

#define MEMBER(name) offsetof(BeamDef, name)

static const Wrong wrongs[] = {
    {BEAM_SIMPLY_SUPPORTED, MEMBER(spacing), 0.9e-3, "pd.spacing"}, /* fine: the horizon holds it; see FINE */
    {BEAM_SIMPLY_SUPPORTED, MEMBER(spacing), 4e-3, "pd.horizon"},
    {BEAM_SIMPLY_SUPPORTED, MEMBER(spacing), 1e-6, "pd.horizon"},
    {BEAM_SIMPLY_SUPPORTED, MEMBER(horizon), 0.2e-3, "pd.horizon"},
    {BEAM_SIMPLY_SUPPORTED, MEMBER(horizon), 2.01e-3, "pd.horizon"},
    {BEAM_SIMPLY_SUPPORTED, MEMBER(horizon), 9, "pd.horizon"},
    {BEAM_SIMPLY_SUPPORTED, MEMBER(critical_stretch), 0.5, "pd.critical_stretch"},
    {BEAM_SIMPLY_SUPPORTED, MEMBER(amplitude), INFINITY, "initial.amplitude"},
    {BEAM_SIMPLY_SUPPORTED, MEMBER(length), 1e6, "pd.spacing"},
    {BEAM_SIMPLY_SUPPORTED, MEMBER(height), 0.4e-3, "pd.spacing"},
    {BEAM_MOVING_CANTILEVER, MEMBER(channel), 0.04, "motion.channel"},
    {BEAM_MOVING_CANTILEVER, MEMBER(end), 6e-3, "motion.channel"},
    {BEAM_NOTCHED, MEMBER(notch_position), 0.3, "notch.position"},
    {BEAM_NOTCHED, MEMBER(notch_depth), 0.07, "notch.depth"},
    {BEAM_NOTCHED, MEMBER(load_position), 0.2095, "load.position"},
    {BEAM_NOTCHED, MEMBER(load_width), 1e-5, "load.width"},
    {BEAM_NOTCHED, MEMBER(support_left), -0.01, "supports.left"},
    {BEAM_NOTCHED, MEMBER(support_right), 0.22, "supports.right"},
};
enum { WRONGS = sizeof wrongs / sizeof *wrongs, FINE = 0 };

/* Few columns, but so many rows that padding them alone would fill the memory. */
START_TEST(high_beams_are_measured_with_their_padding)
{
    BeamDef def = beam_default(BEAM_SIMPLY_SUPPORTED);
    def.length = 1e-3, def.horizon = def.spacing, def.height = 4000 * 1e-3;
    Status status = {0};
    ck_assert_msg(beam_check(&def, &status), "%s", status.text);
    def.height = 4e6 * def.spacing;
    ck_assert(!beam_check(&def, &status));
    ck_assert_str_eq(status.text,
                     "pd.spacing: 4e+06 rows of 4 nodes are too many for memory (at most 1198372 rows: a "
                     "larger spacing)");
}
END_TEST

START_TEST(wrong_definitions_are_refused_by_name)
{
    const Wrong *wrong = &wrongs[_i];
    BeamDef def = beam_default(wrong->problem);
    memcpy((char *)&def + wrong->member, &wrong->value, sizeof wrong->value);
    Status status = {0};
    Simulation *sim = beam_check(&def, &status) ? beam_create(&def, &status) : NULL;
    if (_i == FINE) {
        ck_assert_msg(sim != NULL, "%s", status.text);
        simulation_destroy(sim);
        return;
    }
    ck_assert_ptr_null(sim);
    ck_assert_int_eq(status.code, STATUS_USAGE);
    size_t length = strlen(wrong->key);
    ck_assert_msg(strncmp(status.text, wrong->key, length) == 0 && status.text[length] == ':',
                  "expected %s, was told: %s", wrong->key, status.text);
    ck_assert_ptr_null(strchr(status.text, '\n'));
}
END_TEST

/* Families of every size the lattice allows, their count by brute force; a few steps keep the energy. */
static void expect_family(int halves, VolumeCorrection volumes)
{
    const int farthest =
        volumes == VOLUME_HHB ? halves + 1 : halves; /* in half spacings; that of hhb is out */
    BeamDef def = small_beam(BEAM_SIMPLY_SUPPORTED);
    def.length = 0.02;
    def.horizon = 0.5 * halves * def.spacing;
    def.volume_correction = volumes;
    def.dt = 0;
    Simulation *sim = beam_case_create(&def, NULL);
    BeamFacts facts;
    beam_facts(sim, &facts);
    size_t family = 0;
    for (int p = -9; p <= 9; p++)
        for (int q = -9; q <= 9; q++)
            family +=
                (p != 0 || q != 0) && 4 * (p * p + q * q) <= farthest * farthest - (volumes == VOLUME_HHB);
    ck_assert_uint_eq(facts.family, family);
    double start = series_now(sim, "total");
    advance(sim, 200);
    ck_assert_msg(fabs(series_now(sim, "total") / start - 1) < 0.1, "energy %g",
                  series_now(sim, "total") / start);
    simulation_destroy(sim);
}

START_TEST(horizons_of_all_sizes)
{
    expect_family(_i, VOLUME_PARTIAL);
    expect_family(_i, VOLUME_HHB);
}
END_TEST

/* The sums over a family in the bulk, over the integrals that they stand for: of |xi| V, whose is the work of
 * a dilation, over 2 pi delta^3/3, and of |xi| cos^4 V, whose is that of a stretch, over pi delta^3/4. Digits
 * of an independent program. */
START_TEST(sums_over_families)
{
    static const struct {
        double ratio, dilation[3], stretch[3]; /* none, partial, hhb */
    } rows[] = {
        {3, {1.041, 0.869, 1.020}, {1.053, 0.867, 1.033}}, {4, {0.962, 0.880, 1.013}, {0.974, 0.877, 1.016}},
        {5, {1.049, 0.935, 1.016}, {1.027, 0.921, 1.018}}, {6, {0.999, 0.930, 1.006}, {0.991, 0.922, 1.008}},
        {8, {0.970, 0.930, 0.999}, {0.965, 0.926, 1.001}},
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
        for (int volumes = VOLUME_NONE; volumes <= VOLUME_HHB; volumes++) {
            BeamDef def = small_beam(BEAM_SIMPLY_SUPPORTED);
            def.horizon = rows[k].ratio * def.spacing;
            def.volume_correction = (VolumeCorrection)volumes;
            Lattice lattice;
            ck_assert(lattice_measure(&lattice, &def, NULL));
            double dilation = 0, stretch = 0;
            for (int o = 0; o < lattice.n_offsets; o++) {
                const Offset *offset = &lattice.offsets[o];
                const double work = 2 * offset->length * offset->weight * def.spacing * def.spacing;
                dilation += work / (2 * M_PI / 3 * pow(def.horizon, 3));
                stretch += work * pow(offset->x / offset->length, 4) / (M_PI / 4 * pow(def.horizon, 3));
            }
            ck_assert_msg(fabs(dilation - rows[k].dilation[volumes]) < 0.00051 &&
                              fabs(stretch - rows[k].stretch[volumes]) < 0.00051,
                          "m = %g, %d: %.5f %.5f", rows[k].ratio, volumes, dilation, stretch);
        }
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *facts = tcase_create("facts");
    tcase_add_test(facts, the_papers_notched_beam);
    tcase_add_test(facts, bulk_factors);
    tcase_add_test(facts, the_critical_step_has_converged);
    tcase_add_loop_test(facts, critical_steps, 0, TABLE_ROWS);
    tcase_add_test(facts, the_edge_of_stability);
    tcase_add_loop_test(facts, horizons_of_all_sizes, 2, 17);
    tcase_add_test(facts, sums_over_families);
    suite_add_tcase(suite, facts);

    TCase *periods = tcase_create("periods");
    tcase_add_loop_test(periods, periods_of_table_1, 0, PERIOD_ROWS);
    suite_add_tcase(suite, periods);

    TCase *refused = tcase_create("refused");
    tcase_add_loop_test(refused, wrong_definitions_are_refused_by_name, 0, WRONGS);
    tcase_add_test(refused, high_beams_are_measured_with_their_padding);
    suite_add_tcase(suite, refused);
}
