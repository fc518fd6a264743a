/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Beams against runs of an independent program, digit by digit: only these catch a small error of convention.
 */
#include "base/text.h"
#include "methods/beam_case.h"
#include "methods/bonds/cracks/crack.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NODES_MAX = 4, ROWS_MAX = 10, COLUMNS = 12 };
enum { STEP, UY, VY, UX, VX, KINETIC, STRAIN, WORK, BROKEN, DAMAGE, STRETCH, DISSIPATED };

typedef struct NodeValue {
    int i, j;
    double x, y;
} NodeValue;

typedef struct Golden {
    char name[32];
    BeamDef def;
    size_t nodes, bonds, notch_bonds;
    int nx, ny;
    double micromodulus, sum_coefficient, sum_weight, strain;
    NodeValue forces[NODES_MAX], factors[NODES_MAX];
    int n_forces, n_factors, n_rows;
    double rows[ROWS_MAX][COLUMNS];
    double first_break, twentieth_break; /* 0: not told */
} Golden;

typedef struct Word {
    const char *word;
    int value;
} Word;

static int value_of(const Word *words, const char *word)
{
    for (; words->word; words++)
        if (strcmp(words->word, word) == 0)
            return words->value;
    ck_abort_msg("unknown word %s", word);
    return -1;
}

static const Word problems[] = {{"simply-supported-beam", BEAM_SIMPLY_SUPPORTED},
                                {"moving-cantilever", BEAM_MOVING_CANTILEVER},
                                {"notched-beam", BEAM_NOTCHED},
                                {NULL, 0}};
static const Word corrections[] = {
    {"none", SURFACE_NONE}, {"energy", SURFACE_ENERGY}, {"volume", SURFACE_VOLUME}, {NULL, 0}};
static const Word volumes[] = {{"none", VOLUME_NONE}, {"partial", VOLUME_PARTIAL}, {NULL, 0}};
static const Word clamps[] = {{"full", CLAMP_FULL}, {"guide", CLAMP_GUIDE}, {NULL, 0}};
static const Word yes_no[] = {{"yes", 1}, {"no", 0}, {NULL, 0}};

static void define(BeamDef *def, const char *key, const char *value)
{
    const struct {
        const char *key;
        double *number;
    } numbers[] = {
        {"beam.length", &def->length},
        {"beam.height", &def->height},
        {"beam.thickness", &def->thickness},
        {"beam.youngs_modulus", &def->youngs_modulus},
        {"beam.density", &def->density},
        {"pd.horizon", &def->horizon},
        {"pd.spacing", &def->spacing},
        {"pd.protected", &def->protected_depth},
        {"pd.critical_stretch", &def->critical_stretch},
        {"time.step", &def->dt},
        {"initial.amplitude", &def->amplitude},
        {"motion.speed", &def->speed},
        {"motion.channel", &def->channel},
        {"notch.position", &def->notch_position},
        {"notch.depth", &def->notch_depth},
        {"load.position", &def->load_position},
        {"load.width", &def->load_width},
        {"load.stress", &def->load_stress},
        {"load.ramp", &def->load_ramp},
        {"supports.left", &def->support_left},
        {"supports.right", &def->support_right},
    };
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++)
        if (strcmp(numbers[k].key, key) == 0) {
            ck_assert(text_to_double(value, numbers[k].number));
            return;
        }
    if (strcmp(key, "problem") == 0)
        def->problem = (BeamProblem)value_of(problems, value);
    else if (strcmp(key, "pd.surface_correction") == 0)
        def->surface_correction = (SurfaceCorrection)value_of(corrections, value);
    else if (strcmp(key, "pd.volume_correction") == 0)
        def->volume_correction = (VolumeCorrection)value_of(volumes, value);
    else if (strcmp(key, "motion.clamp") == 0)
        def->clamp = (Clamp)value_of(clamps, value);
    else if (strcmp(key, "supports.pinned") == 0)
        def->pinned = value_of(yes_no, value) == 1;
    else
        ck_abort_msg("unknown key %s", key);
}

static NodeValue node_value(const char *text)
{
    NodeValue node;
    ck_assert_int_eq(sscanf(text, "%d %d %lf %lf", &node.i, &node.j, &node.x, &node.y), 4);
    return node;
}

static void read_row(Golden *golden, const char *text)
{
    ck_assert_int_lt(golden->n_rows, ROWS_MAX);
    double *row = golden->rows[golden->n_rows++];
    char *next;
    for (int k = 0; k < COLUMNS; k++, text = next) {
        row[k] = strtod(text, &next);
        ck_assert_ptr_ne(text, next);
    }
}

static void read_line(Golden *golden, const char *key, const char *text)
{
    if (strcmp(key, "lattice") == 0)
        ck_assert_int_eq(sscanf(text, "%zu %d %d %zu %zu %lf %lf %lf %lf", &golden->nodes, &golden->nx,
                                &golden->ny, &golden->bonds, &golden->notch_bonds, &golden->micromodulus,
                                &golden->sum_coefficient, &golden->sum_weight, &golden->strain),
                         9);
    else if (strcmp(key, "force") == 0)
        golden->forces[golden->n_forces++] = node_value(text);
    else if (strcmp(key, "factor") == 0)
        golden->factors[golden->n_factors++] = node_value(text);
    else if (strcmp(key, "row") == 0)
        read_row(golden, text);
    else if (strcmp(key, "near") == 0)
        ck_assert_int_eq(sscanf(text, "%lf %lf", &golden->first_break, &golden->twentieth_break), 2);
    else
        define(&golden->def, key, text);
}

static const char *const case_names[] = {"A_mo", "A_none", "A_volmethod", "B_xy", "C_small"};
enum { CASES = sizeof case_names / sizeof *case_names };

static Golden read_case(const char *name)
{
    Golden golden = {.def = {.end = 1e-4, .threads = 1}};
    FILE *file = fopen(source_path("tests/golden/pd.txt"), "r");
    ck_assert_msg(file != NULL, "cannot read tests/golden/pd.txt");
    char line[512], key[64];
    while (fgets(line, sizeof line, file)) {
        line[strcspn(line, "\n")] = '\0';
        int length = 0;
        if (line[0] == '#' || sscanf(line, "%63s %n", key, &length) != 1)
            continue;
        if (strcmp(key, "case") == 0)
            snprintf(golden.name, sizeof golden.name, "%s", line + length);
        else if (strcmp(golden.name, name) == 0)
            read_line(&golden, key, line + length);
    }
    fclose(file);
    ck_assert_msg(golden.n_rows > 0, "no case %s", name);
    snprintf(golden.name, sizeof golden.name, "%s", name);
    return golden;
}

static void expect_near(const Golden *golden, const char *what, double value, double expected,
                        double tolerance)
{
    ck_assert_msg(fabs(value - expected) <= tolerance,
                  "%s: %s is %.17g, expected %.17g, off by %.3g (allowed %.3g)", golden->name, what, value,
                  expected, fabs(value - expected), tolerance);
}

START_TEST(lattices_agree)
{
    Golden golden = read_case(case_names[_i]);
    Simulation *sim = beam_case_create(&golden.def, NULL);
    const Beam *beam = (const Beam *)sim;
    BeamFacts facts;
    beam_facts(sim, &facts);
    ck_assert_int_eq(facts.nx, golden.nx);
    ck_assert_int_eq(facts.ny, golden.ny);
    ck_assert_uint_eq(sim->counts[SET_PARTICLE], golden.nodes);
    ck_assert_uint_eq(facts.bonds, golden.bonds);
    ck_assert_uint_eq(facts.notch_bonds, golden.notch_bonds);
    expect_near(&golden, "micromodulus", facts.micromodulus, golden.micromodulus,
                1e-14 * golden.micromodulus);

    /* the sums run over all bonds, the notch's included */
    double sum_coefficient = 0, sum_weight = 0, area = beam_volume(beam);
    for (size_t k = 0; k < facts.bonds; k++) {
        BondPlace place = lattice_bond_place(&beam->lattice, k);
        sum_coefficient += lattice_coefficient(&beam->lattice, place) / area;
        sum_weight += beam->lattice.offsets[place.offset].weight;
    }
    expect_near(&golden, "sum of w", sum_weight, golden.sum_weight, 1e-11 * golden.sum_weight);
    expect_near(&golden, "sum of c G w", sum_coefficient, golden.sum_coefficient,
                1e-11 * golden.sum_coefficient);
    /* the factors are those of the energy method, whichever the case uses */
    Lattice by_energy;
    Status status = {0};
    golden.def.surface_correction = SURFACE_ENERGY;
    ck_assert_msg(lattice_init(&by_energy, &golden.def, &status), "%s", status.text);
    for (int k = 0; k < golden.n_factors; k++) {
        size_t node = (size_t)golden.factors[k].j * (size_t)golden.nx + (size_t)golden.factors[k].i;
        expect_near(&golden, "g_x", by_energy.factor_x[node], golden.factors[k].x,
                    1e-11 * golden.factors[k].x);
        expect_near(&golden, "g_y", by_energy.factor_y[node], golden.factors[k].y,
                    1e-11 * golden.factors[k].y);
    }
    lattice_free(&by_energy);
    simulation_destroy(sim);
}
END_TEST

START_TEST(forces_at_the_start_agree)
{
    Golden golden = read_case(case_names[_i]);
    Simulation *sim = beam_case_create(&golden.def, NULL);
    expect_near(&golden, "strain energy", series_now(sim, "strain"), golden.strain, 1e-11 * golden.strain);
    double *fx = field_now(sim, SET_PARTICLE, "fx"), *fy = field_now(sim, SET_PARTICLE, "fy"), largest = 0;
    for (size_t k = 0; k < golden.nodes; k++)
        largest = fmax(largest, fmax(fabs(fx[k]), fabs(fy[k])));
    for (int k = 0; k < golden.n_forces; k++) {
        size_t node = (size_t)golden.forces[k].j * (size_t)golden.nx + (size_t)golden.forces[k].i;
        expect_near(&golden, "fx", fx[node], golden.forces[k].x, 1e-11 * largest);
        expect_near(&golden, "fy", fy[node], golden.forces[k].y, 1e-11 * largest);
    }
    free(fx);
    free(fy);
    simulation_destroy(sim);
}
END_TEST

static double largest_of(const Golden *golden, int column)
{
    double largest = 0;
    for (int k = 0; k < golden->n_rows; k++)
        largest = fmax(largest, fabs(golden->rows[k][column]));
    return largest;
}

static double largest_value(const Simulation *sim, const char *name)
{
    double *values = field_now(sim, SET_PARTICLE, name), largest = 0;
    for (size_t k = 0; k < sim->counts[SET_PARTICLE]; k++)
        largest = fmax(largest, values[k]);
    free(values);
    return largest;
}

START_TEST(histories_agree)
{
    Golden golden = read_case(case_names[_i]);
    Simulation *sim = beam_case_create(&golden.def, NULL);
    for (int k = 0; k < golden.n_rows; k++) {
        const double *row = golden.rows[k];
        advance(sim, (long)row[STEP] - sim->step);
        const struct {
            const char *series;
            int column;
            double share; /* of the column's largest value */
        } columns[] = {
            {"u_probe", UY, 1e-9},    {"v_probe", VY, 1e-6}, {"kinetic", KINETIC, 1e-9},
            {"strain", STRAIN, 1e-9}, {"work", WORK, 1e-9},  {"dissipated", DISSIPATED, 1e-9},
        };
        for (size_t c = 0; c < sizeof columns / sizeof *columns; c++)
            expect_near(&golden, columns[c].series, series_now(sim, columns[c].series),
                        row[columns[c].column], columns[c].share * largest_of(&golden, columns[c].column));
        ck_assert_int_eq((long)series_now(sim, "broken_bonds"), (long)row[BROKEN]);
        expect_near(&golden, "largest damage", largest_value(sim, "damage"), row[DAMAGE], 1e-9);
        expect_near(&golden, "largest stretch", largest_value(sim, "stretch"), row[STRETCH],
                    1e-8 * largest_of(&golden, STRETCH));
    }
    Crack crack;
    if (golden.first_break > 0) {
        ck_assert(crack_measure(sim, &crack));
        expect_near(&golden, "first break", crack.first_break, golden.first_break, 1e-12);
        expect_near(&golden, "twentieth break", crack.twentieth_break, golden.twentieth_break, 1e-12);
    }
    simulation_destroy(sim);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *start = tcase_create("start");
    tcase_add_loop_test(start, lattices_agree, 0, CASES);
    tcase_add_loop_test(start, forces_at_the_start_agree, 0, CASES);
    suite_add_tcase(suite, start);
    TCase *histories = tcase_create("histories");
    tcase_add_loop_test(histories, histories_agree, 0, CASES);
    suite_add_tcase(suite, histories);
}
