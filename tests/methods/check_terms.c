/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The loops of the engines held to their tables of exchanges: of every stage, the products that a thing is
 * given come to what its field is, or to what was added to it, but for the rounding of as many additions. */
#include "methods/bar_case.h"
#include "methods/beam_case.h"
#include "methods/default_defs.h"
#include "methods/mpm/mpm.h"
#include "methods/run_case.h"
#include "suite.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LINKS_MAX = 256, EXCHANGES_MAX = 16 };

static double add_terms(const Simulation *sim, int e, size_t to, double *scale)
{
    Link links[LINKS_MAX];
    double sum = 0;
    const size_t n = sim->method->links(sim, sim->exchanges[e].to, to, links, LINKS_MAX);
    for (size_t k = 0; k < n; k++) {
        const ExchangeTerm term = simulation_exchange(sim, e, to, &links[k]);
        ck_assert_int_gt(term.count, 0);
        sum += term.product;
        *scale += fabs(term.product);
    }
    return sum;
}

/* Of the stage that comes; returns how many exchanges it has. The last one ends the step, and with it what
 * was exchanged. `loose`: numbers that the stage has written over are solved for. */
static int expect_stage(Simulation *sim)
{
    double *before[EXCHANGES_MAX] = {NULL};
    const char *id = sim->stages[sim->stage].id;
    const bool last = sim->stage + 1 == sim->n_stages;
    int seen = 0;
    Status status = {0};
    ck_assert_int_le(sim->n_exchanges, EXCHANGES_MAX);
    for (int e = 0; e < sim->n_exchanges; e++)
        if (strcmp(sim->exchanges[e].stage, id) == 0)
            before[e] = field_now(sim, sim->exchanges[e].to, sim->exchanges[e].field);
    ck_assert_msg(simulation_stage(sim, &status), "%s", status.text);
    for (int e = 0; e < sim->n_exchanges; e++) {
        const Exchange *exchange = &sim->exchanges[e];
        Link link;
        size_t some = 0; /* one that is linked */
        while (before[e] && sim->method->links(sim, exchange->to, some, &link, 1) == 0)
            some++;
        if (!before[e] || last || simulation_exchange(sim, e, some, &link).count == 0) {
            free(before[e]);
            continue;
        }
        double *now = field_now(sim, exchange->to, exchange->field), most = 0;
        for (size_t k = 0; k < sim->counts[exchange->to]; k++)
            most = fmax(most, fabs(now[k]));
        for (size_t k = 0; k < sim->counts[exchange->to]; k++) {
            double scale = exchange->adds ? fabs(before[e][k]) : 0;
            const double sum = add_terms(sim, e, k, &scale) + (exchange->adds ? before[e][k] : 0);
            const double bound = 16 * DBL_EPSILON * scale + 1e-14 * most;
            /* what a support holds has no force any more */
            const bool held = strcmp(id, "update") != 0 && now[k] == 0;
            ck_assert_msg(held || fabs(sum - now[k]) <= bound, "%s, %s of %zu: %.17g, the engine has %.17g",
                          id, exchange->field, k, sum, now[k]);
        }
        free(now), free(before[e]);
        seen++;
    }
    return seen;
}

static void expect_step(Simulation *sim, int least)
{
    int seen = 0;
    ck_assert_ptr_nonnull(sim);
    for (int k = 0; k < 3; k++) {
        do
            seen += expect_stage(sim);
        while (sim->stage > 0);
        ck_assert_int_ge(seen, least);
        Status status = {0};
        ck_assert(simulation_steps(sim, 5, NULL, NULL, &status));
        seen = 0;
    }
    simulation_destroy(sim);
}

static const struct {
    MpmTransfer transfer;
    double flip, blend;
} ways[] = {{MPM_FLIP, 1, 1},   {MPM_FLIP, 0.5, 1},   {MPM_FLIP, 0, 1}, {MPM_APIC, 1, 1},
            {MPM_FLIP, 1, 0.5}, {MPM_FLIP, 0.5, 0.5}, {MPM_FMPM, 1, 1}};
enum { WAYS = 7, PLANE_WAYS = 3, BODY_WAYS = 4 };

START_TEST(sums_of_bars)
{
    static const MpmShape shapes[] = {MPM_HAT, MPM_GIMP, MPM_CPDI, MPM_BSPLINE2, MPM_BSPLINE3};
    BarCase bar = bar_case(5, 0.1);
    bar.def.algorithm = (MpmAlgorithm)(_i % 3);
    bar.def.shape = shapes[_i / 3 % 5];
    bar.def.transfer = ways[_i / 15].transfer;
    bar.def.flip_fraction = ways[_i / 15].flip;
    bar.def.mass_blend = ways[_i / 15].blend;
    bar.def.fmpm_order = 2;
    bar.def.body_force = 1e-3;
    expect_step(bar_case_create(&bar), 6);
}
END_TEST

START_TEST(sums_of_beams)
{
    MpmDef def = plane_default(_i % 2);
    Status status = {0};
    def.length = 0.02;
    def.cell_size = 0.00125;
    def.end = 1e-4;
    def.algorithm = (MpmAlgorithm)(_i / 2 % 3);
    def.shape = _i / 6 % 2 ? MPM_GIMP : MPM_HAT;
    def.flip_fraction = ways[_i / 12].flip;
    expect_step(mpm_create(&def, &status), 5);
}
END_TEST

/* Two discs in contact, with weight and damping. */
START_TEST(sums_of_bodies)
{
    static const MpmShape shapes[] = {MPM_HAT, MPM_GIMP, MPM_BSPLINE2};
    static const BodyWall walls[WALLS] = {WALL_SLIP, WALL_FRICTION, WALL_CLAMP, WALL_OPEN};
    MpmDef def = bodies_default();
    memcpy(def.walls, walls, sizeof walls);
    def.bodies[0].size[0] = .3, def.bodies[0].size[1] = .2;
    def.bodies[1].size[0] = .7, def.bodies[1].size[1] = .25;
    def.friction = .3;
    def.gap = INFINITY;
    def.gravity[0] = .1, def.gravity[1] = -.2;
    def.damping = .1;
    Status status = {0};
    def.algorithm = (MpmAlgorithm)(_i % 3);
    def.shape = shapes[_i / 3 % 3];
    def.transfer = ways[_i / 9].transfer;
    def.flip_fraction = ways[_i / 9].flip;
    ck_assert_msg(mpm_check(&def, &status), "%s", status.text);
    expect_step(mpm_create(&def, &status), 5);
}
END_TEST

static double uneven(double x, const void *context)
{
    (void)context;
    return 0.01 * x * (20 - x);
}

/* Bars with mirror images and without, and a beam of which bonds break; by the right code, then by each wrong
 * one that these runs can have. */
START_TEST(sums_of_bonds)
{
    const BeamDef bar = {.problem = BEAM_BAR,
                         .length = 25,
                         .youngs_modulus = 100,
                         .density = 1,
                         .left_fixed = _i % 3 == 1,
                         .spacing = 0.5,
                         .horizon = 1.5,
                         .surface_correction = SURFACE_ENERGY,
                         .volume_correction = VOLUME_PARTIAL,
                         .dt = 0.01,
                         .initial_velocity = uneven};
    BeamDef def = _i % 3 == 2 ? small_beam(BEAM_NOTCHED) : bar;
    Status status = {0};
    def.mistake = _i / 3;
    if (def.mistake)
        def.critical_stretch = 0;
    if (!beam_mistake_words[def.mistake] || !beam_check(&def, &status)) {
        ck_assert_msg(def.mistake != 0, "%s", status.text);
        return;
    }
    Simulation *sim = beam_case_create(&def, NULL);
    ck_assert_msg(simulation_steps(sim, _i == 2 ? 700 : 20, NULL, NULL, &status), "%s", status.text);
    ck_assert(_i != 2 || series_now(sim, "broken_bonds") > 20);
    expect_step(sim, def.problem == BEAM_BAR ? 1 : 2);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *terms = tcase_create("terms");
    tcase_add_loop_test(terms, sums_of_bars, 0, 15 * WAYS);
    tcase_add_loop_test(terms, sums_of_beams, 0, 12 * PLANE_WAYS);
    tcase_add_loop_test(terms, sums_of_bodies, 0, 9 * BODY_WAYS);
    tcase_add_loop_test(terms, sums_of_bonds, 0, 3 * 26);
    suite_add_tcase(suite, terms);
}
