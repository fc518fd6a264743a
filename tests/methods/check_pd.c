/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Beams keep what physics says they keep, and give the same bits whichever way a step is done. */
#include "base/text.h"
#include "methods/beam_case.h"
#include "methods/bonds/cracks/crack.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- conservation --- */

/* A bent body that flies, spins and is sheared. */
static void wild(double x, double y, double u[2], double v[2], const void *context)
{
    (void)context;
    u[0] = 1e-5 * sin(40 * x) - 2e-4 * y;
    u[1] = 2e-5 * sin(60 * x) + 1e-5 * cos(300 * y);
    v[0] = 3 - 40 * y + 0.2 * sin(70 * x);
    v[1] = -2 + 40 * (x - 0.025);
}

typedef struct Momentum {
    double x, y, spin, scale;
} Momentum;

static Momentum momentum(const Simulation *sim)
{
    static const char *const names[] = {"x0", "y0", "ux", "uy", "vx", "vy"};
    double *value[6];
    Momentum sum = {0};
    for (int k = 0; k < 6; k++)
        value[k] = field_now(sim, SET_PARTICLE, names[k]);
    for (size_t p = 0; p < sim->counts[SET_PARTICLE]; p++) {
        double x = value[0][p] + value[2][p], y = value[1][p] + value[3][p];
        sum.x += value[4][p];
        sum.y += value[5][p];
        sum.spin += x * value[5][p] - y * value[4][p];
        sum.scale += hypot(x, y) * hypot(value[4][p], value[5][p]);
    }
    for (int k = 0; k < 6; k++)
        free(value[k]);
    return sum;
}

START_TEST(momentum_is_kept)
{
    BeamDef def = small_beam(BEAM_SIMPLY_SUPPORTED);
    BeamOptions options = {.free_body = true, .initial = wild};
    Simulation *sim = beam_case_create(&def, &options);
    Momentum before = momentum(sim);
    advance(sim, 2000);
    Momentum after = momentum(sim);
    double count = (double)sim->counts[SET_PARTICLE];
    ck_assert_msg(fabs(after.x - before.x) < 1e-11 * count, "x momentum %.17g became %.17g", before.x,
                  after.x);
    ck_assert_msg(fabs(after.y - before.y) < 1e-11 * count, "y momentum %.17g became %.17g", before.y,
                  after.y);
    ck_assert_msg(fabs(after.spin - before.spin) < 1e-13 * after.scale, "spin %.17g became %.17g",
                  before.spin, after.spin);
    simulation_destroy(sim);
}
END_TEST

/* The largest relative error of the energy of the bent free body within 20 us. */
static double energy_error(double dt)
{
    BeamDef def = small_beam(BEAM_SIMPLY_SUPPORTED);
    BeamOptions options = {.free_body = true};
    def.dt = dt;
    Simulation *sim = beam_case_create(&def, &options);
    double start = series_now(sim, "total"), error = 0;
    for (int k = 0; k < 40; k++) {
        advance(sim, lround(5e-7 / dt));
        error = fmax(error, fabs(series_now(sim, "total") / start - 1));
    }
    simulation_destroy(sim);
    return error;
}

START_TEST(energy_error_falls_as_the_square_of_the_step)
{
    double coarse = energy_error(1e-7), middle = energy_error(5e-8), fine = energy_error(2.5e-8);
    ck_assert_msg(coarse < 0.05, "error %.3g", coarse);
    ck_assert_msg(coarse / middle > 3.2 && coarse / middle < 5.2, "halving gains %.3g", coarse / middle);
    ck_assert_msg(middle / fine > 3.6 && middle / fine < 4.4, "halving again gains %.3g", middle / fine);
}
END_TEST

START_TEST(damage_only_grows)
{
    BeamDef def = small_beam(BEAM_NOTCHED);
    Simulation *sim = beam_case_create(&def, NULL);
    size_t nodes = sim->counts[SET_PARTICLE];
    double *before = field_now(sim, SET_PARTICLE, "damage"), broken = 0, dissipated = 0;
    for (int k = 0; k < 30; k++) {
        advance(sim, 30);
        double *damage = field_now(sim, SET_PARTICLE, "damage");
        for (size_t p = 0; p < nodes; p++)
            if (!(damage[p] >= before[p] && damage[p] <= 1))
                ck_abort_msg("damage of %zu: %.17g after %.17g", p, damage[p], before[p]);
        free(before);
        before = damage;
        ck_assert(series_now(sim, "broken_bonds") >= broken && series_now(sim, "dissipated") >= dissipated);
        broken = series_now(sim, "broken_bonds");
        dissipated = series_now(sim, "dissipated");
        double total = series_now(sim, "total"), work = series_now(sim, "work");
        ck_assert_msg(fabs(total - work) < 0.02 * work, "energy %.6g, work %.6g", total, work);
    }
    ck_assert(broken > 3000);
    free(before);
    simulation_destroy(sim);
}
END_TEST

/* --- the same bits, whichever way --- */

/* To a step, from anywhere in an earlier one. */
static void advance_to(Simulation *sim, long step)
{
    advance(sim, 0); /* ends the step that has begun */
    advance(sim, step - sim->step);
}

/* A notched beam whose crack is on its way: bonds break in almost every step from here. */
enum { CRACKING = 380, LATER = 392 };

static Simulation *cracking(void)
{
    BeamDef def = small_beam(BEAM_NOTCHED);
    Simulation *sim = beam_case_create(&def, NULL);
    advance(sim, CRACKING);
    return sim;
}

START_TEST(snapshots_bring_back_every_stage)
{
    Simulation *straight = cracking(), *sim = cracking();
    double broken = series_now(straight, "broken_bonds");
    advance(straight, LATER - CRACKING);
    ck_assert_msg(series_now(straight, "broken_bonds") > broken + 20, "too little breaks for this test");
    Status status = {0};
    for (int stage = 0; stage < _i; stage++)
        ck_assert(simulation_stage(sim, &status));
    unsigned char *kept = snapshot_now(sim);
    advance_to(sim, LATER);
    unsigned char *late = snapshot_now(sim);
    expect_same_state(straight, sim, "by stages");

    for (int round = 0; round < 2; round++) {
        simulation_restore(sim, kept);
        unsigned char *again = snapshot_now(sim);
        ck_assert_int_eq(memcmp(kept, again, simulation_snapshot_size(sim)), 0);
        free(again);
        advance_to(sim, LATER);
        expect_same_state(straight, sim, "replayed");
    }
    /* back, and forth without a replay */
    simulation_restore(sim, kept);
    simulation_restore(sim, late);
    expect_same_state(straight, sim, "back and forth");
    advance(sim, 5);
    advance(straight, 5);
    expect_same_state(straight, sim, "after back and forth");
    free(kept);
    free(late);
    simulation_destroy(sim);
    simulation_destroy(straight);
}
END_TEST

START_TEST(stages_restore_what_they_show)
{
    /* damage and links in the middle of a step: bonds broken in it count only after the last stage */
    Simulation *sim = cracking();
    Status status = {0};
    for (int stage = 0; stage < N_STAGES; stage++) {
        double *damage = field_now(sim, SET_PARTICLE, "damage"),
               *broken_at = field_now(sim, SET_BOND, "broken_at");
        unsigned char *kept = snapshot_now(sim);
        advance(sim, 3);
        simulation_restore(sim, kept);
        double *damage_again = field_now(sim, SET_PARTICLE, "damage");
        double *broken_again = field_now(sim, SET_BOND, "broken_at");
        ck_assert_int_eq(memcmp(damage, damage_again, sim->counts[SET_PARTICLE] * sizeof *damage), 0);
        ck_assert_int_eq(memcmp(broken_at, broken_again, sim->counts[SET_BOND] * sizeof *broken_at), 0);
        free(damage);
        free(damage_again);
        free(broken_at);
        free(broken_again);
        free(kept);
        ck_assert(simulation_stage(sim, &status));
    }
    simulation_destroy(sim);
}
END_TEST

START_TEST(slices_are_stages)
{
    static const size_t cuts[] = {1, 3, 7, 0};
    Simulation *straight = cracking(), *sim = cracking();
    advance(straight, LATER - CRACKING);
    Status status = {0};
    while (sim->step < LATER) {
        bool done;
        ck_assert(simulation_slice(sim, cuts[_i], &done, &status));
    }
    expect_same_state(straight, sim, "in slices");
    ck_assert_double_gt(series_now(sim, "strain"), 0);
    ck_assert_double_eq(series_now(straight, "strain"), series_now(sim, "strain"));
    simulation_destroy(sim);
    simulation_destroy(straight);
}
END_TEST

/* The moving cantilever: the other way of holding nodes. */
START_TEST(moving_stages_are_steps)
{
    BeamDef def = small_beam(BEAM_MOVING_CANTILEVER);
    def.clamp = _i ? CLAMP_GUIDE : CLAMP_FULL;
    Simulation *straight = beam_case_create(&def, NULL), *sim = beam_case_create(&def, NULL);
    Status status = {0};
    advance(straight, 450); /* two columns are released on the way */
    while (sim->step < 450)
        ck_assert(simulation_stage(sim, &status));
    expect_same_state(straight, sim, "by stages");
    simulation_destroy(sim);
    simulation_destroy(straight);
}
END_TEST

START_TEST(every_stepping_is_its_stages)
{
    BeamDef def = small_beam(BEAM_MOVING_CANTILEVER);
    def.stepping = (Stepping)_i;
    Simulation *straight = beam_case_create(&def, NULL), *sim = beam_case_create(&def, NULL);
    Status status = {0};
    advance(straight, 40);
    while (sim->step < 40)
        ck_assert(simulation_stage(sim, &status));
    expect_same_state(straight, sim, "by stages");
    simulation_destroy(sim);
    simulation_destroy(straight);
}
END_TEST

static void same_with(const BeamDef *def, const BeamOptions *options, const char *what)
{
    BeamDef one = *def;
    one.threads = 1;
    Simulation *straight = beam_case_create(&one, NULL), *sim = beam_case_create(def, options);
    double rows[2][60 * SIMULATION_SERIES_MAX];
    Status status = {0};
    for (int round = 0; round < 8; round++) {
        ck_assert(simulation_steps(straight, 50, NULL, NULL, &status));
        ck_assert(simulation_steps(sim, 50, NULL, NULL, &status));
        expect_same_state(straight, sim, what);
        simulation_row(straight, rows[0]);
        simulation_row(sim, rows[1]);
        ck_assert_msg(memcmp(rows[0], rows[1], (size_t)sim->n_series * sizeof(double)) == 0,
                      "%s: rows differ", what);
    }
    static const char *const fields[] = {"strain_energy", "stretch"};
    for (size_t f = 0; f < sizeof fields / sizeof *fields; f++) {
        double *a = field_now(straight, SET_PARTICLE, fields[f]),
               *b = field_now(sim, SET_PARTICLE, fields[f]);
        ck_assert_msg(memcmp(a, b, sim->counts[SET_PARTICLE] * sizeof *a) == 0, "%s: %s differs", what,
                      fields[f]);
        free(a), free(b);
    }
    simulation_destroy(sim);
    simulation_destroy(straight);
}

START_TEST(threads_leave_no_trace)
{
    BeamDef def = small_beam(BEAM_NOTCHED);
    def.threads = _i;
    same_with(&def, NULL, "threads");
    def = small_beam(BEAM_MOVING_CANTILEVER);
    def.threads = _i;
    same_with(&def, NULL, "threads, moving");
    def.volume_correction = VOLUME_HHB;
    same_with(&def, NULL, "threads, moving, to half a spacing beyond the horizon");
}
END_TEST

START_TEST(vector_width_leaves_no_trace)
{
    if (!bonds_cpu_has((CpuLevel)_i))
        return;
    BeamOptions options = {.force_level = true, .level = (CpuLevel)_i};
    BeamDef def = small_beam(BEAM_NOTCHED);
    same_with(&def, &options, bonds_cpu_name((CpuLevel)_i));
    def = small_beam(BEAM_SIMPLY_SUPPORTED);
    def.dt = 0; /* the power iteration too */
    same_with(&def, &options, bonds_cpu_name((CpuLevel)_i));
    def.volume_correction = VOLUME_HHB;
    def.horizon = 4e-3; /* the largest family there is */
    same_with(&def, &options, bonds_cpu_name((CpuLevel)_i));
}
END_TEST

static size_t rooted_segments(const Beam *beam)
{
    const Lattice *lattice = &beam->lattice;
    size_t count = 0;
    for (size_t k = 0; k < (size_t)lattice->ny * lattice->n_tiles * (size_t)lattice->n_offsets; k++)
        count += beam->rooted[k];
    return count;
}

/* Where the strains leave the series' range: the same bits at every width, and whichever form was tried
 * first, for a run that goes back has other segments marked than one that comes for the first time. */
START_TEST(steep_waves_leave_no_trace)
{
    if (!bonds_cpu_has((CpuLevel)_i) || !suite_wide())
        return;
    BeamOptions options = {.force_level = true, .level = (CpuLevel)_i};
    const BeamDef def = struck_plate();
    same_with(&def, &options, bonds_cpu_name((CpuLevel)_i));

    Simulation *straight = beam_case_create(&def, NULL), *sim = beam_case_create(&def, &options);
    advance(sim, 50);
    ck_assert_uint_gt(rooted_segments((const Beam *)sim), 500);
    unsigned char *early = snapshot_now(sim);
    advance(sim, 500);
    ck_assert_double_gt(series_now(sim, "broken_bonds"), 0);
    simulation_restore(sim, early);
    advance(sim, 100);
    advance(straight, 150);
    ck_assert_uint_lt(rooted_segments((const Beam *)sim), 48 * 80 * 2 / 2);
    expect_same_state(straight, sim, "back and on");
    ck_assert_double_eq(series_now(straight, "strain"), series_now(sim, "strain"));
    free(early);
    simulation_destroy(sim);
    simulation_destroy(straight);
}
END_TEST

/* The struck plate just before its first bonds break. */
static Simulation *breaking_plate(void)
{
    const BeamDef def = struck_plate();
    Simulation *sim = beam_case_create(&def, NULL);
    unsigned char *before = NULL;
    do {
        free(before);
        before = snapshot_now(sim);
        advance(sim, 5);
    } while (sim->step < 600 && series_now(sim, "broken_bonds") == 0);
    ck_assert_double_gt(series_now(sim, "broken_bonds"), 0);
    simulation_restore(sim, before);
    free(before);
    return sim;
}

/* Of a cracking beam, and of a plate whose bonds break where the strains are for the root. */
START_TEST(watching_leaves_no_trace)
{
    Simulation *straight = _i ? breaking_plate() : cracking(), *sim = _i ? breaking_plate() : cracking();
    const double broken = series_now(sim, "broken_bonds");
    double rows[(LATER - CRACKING) * SIMULATION_SERIES_MAX], row[SIMULATION_SERIES_MAX];
    Status status = {0};
    long done = 0;
    ck_assert(simulation_steps(sim, LATER - CRACKING, rows, &done, &status));
    ck_assert_int_eq(done, LATER - CRACKING);
    for (long k = 0; k < done; k++) {
        advance(straight, 1);
        simulation_row(straight, row);
        for (int s = 0; s < sim->n_series; s++)
            ck_assert_msg(memcmp(&row[s], &rows[k * sim->n_series + s], sizeof row[s]) == 0,
                          "%s of step %ld: %.17g watched, %.17g asked", sim->series[s].name, straight->step,
                          rows[k * sim->n_series + s], row[s]);
    }
    expect_same_state(straight, sim, "watched");
    ck_assert_double_gt(series_now(sim, "broken_bonds"), broken);
    simulation_destroy(sim);
    simulation_destroy(straight);
}
END_TEST

/* --- what a reader of single bonds and nodes is told --- */

/* Of a cracking beam, and of a plate with strains for the root. */
START_TEST(links_add_up_to_the_force)
{
    const BeamDef plate = struck_plate();
    Simulation *sim = _i ? beam_case_create(&plate, NULL) : cracking();
    const size_t nodes[] = {0, 50 + 20 * 100, 30 + 11 * 100, 99 + 39 * 100, 31 + 5 * 100};
    if (_i)
        advance(sim, 50);
    double *x = field_now(sim, SET_PARTICLE, "x0"), *y = field_now(sim, SET_PARTICLE, "y0");
    double *ux = field_now(sim, SET_PARTICLE, "ux"), *uy = field_now(sim, SET_PARTICLE, "uy");
    double *fx = field_now(sim, SET_PARTICLE, "fx"), *fy = field_now(sim, SET_PARTICLE, "fy");
    double *family = field_now(sim, SET_PARTICLE, "family"), *damage = field_now(sim, SET_PARTICLE, "damage");
    for (size_t k = 0; k < sizeof nodes / sizeof *nodes; k++) {
        size_t p = nodes[k], n_broken = 0;
        Link links[FAMILY_MAX];
        ck_assert_uint_eq(sim->method->links(sim, SET_PARTICLE, p, links, 2), 2); /* room for no more */
        size_t n = sim->method->links(sim, SET_PARTICLE, p, links, FAMILY_MAX);
        ck_assert_uint_eq(n, (size_t)family[p]);
        double sum_x = 0, sum_y = 0, size = 0;
        for (size_t l = 0; l < n; l++) {
            size_t other = links[l].index;
            double dx = x[other] + ux[other] - x[p] - ux[p], dy = y[other] + uy[other] - y[p] - uy[p];
            double length = hypot(dx, dy), start = hypot(x[other] - x[p], y[other] - y[p]);
            ck_assert_msg(fabs(links[l].stretch - (length / start - 1)) < 1e-12, "stretch %.17g",
                          links[l].stretch);
            sum_x += link_pull(&links[l]) * dx / length;
            sum_y += link_pull(&links[l]) * dy / length;
            size += fabs(link_pull(&links[l]));
            n_broken += links[l].broken;
            ck_assert(!links[l].broken || links[l].stiffness == 0);
        }
        ck_assert_msg(fabs(sum_x - fx[p]) <= 1e-10 * size && fabs(sum_y - fy[p]) <= 1e-10 * size,
                      "node %zu: links %.10g %.10g, force %.10g %.10g", p, sum_x, sum_y, fx[p], fy[p]);
        ck_assert_int_eq(n_broken > 0, damage[p] > 0);
    }
    free(x), free(y), free(ux), free(uy), free(fx), free(fy), free(family), free(damage);
    simulation_destroy(sim);
}
END_TEST

START_TEST(bonds_are_listed_once)
{
    BeamDef def = small_beam(BEAM_NOTCHED);
    Simulation *sim = beam_case_create(&def, NULL);
    size_t n = sim->counts[SET_BOND], notch = 0;
    double *i = field_now(sim, SET_BOND, "i"), *j = field_now(sim, SET_BOND, "j");
    double *broken = field_now(sim, SET_BOND, "broken"), *at = field_now(sim, SET_BOND, "broken_at");
    for (size_t b = 0; b < n; b++) {
        bool in_order = b == 0 || i[b] > i[b - 1] || (i[b] == i[b - 1] && j[b] != j[b - 1]);
        if (!(i[b] < j[b] && in_order && at[b] == (broken[b] != 0 ? 0 : -1)))
            ck_abort_msg("bond %zu from %g to %g, broken at %g", b, i[b], j[b], at[b]);
        notch += broken[b] != 0;
    }
    ck_assert_uint_eq(notch, 378);
    for (size_t b = 7; b < n; b += 997) { /* one by one as in a whole */
        double one;
        sim->method->field(sim, simulation_find_field(sim, SET_BOND, "j"), b, 1, &one);
        ck_assert(one == j[b]);
    }
    free(i), free(j), free(broken), free(at);
    simulation_destroy(sim);
}
END_TEST

/* Of one tile of columns, and of three. */
START_TEST(fields_are_the_same_in_pieces)
{
    BeamDef def = small_beam(BEAM_NOTCHED);
    def.length += _i * 0.2;
    Simulation *sim = beam_case_create(&def, NULL);
    advance(sim, CRACKING);
    for (int field = 0; field < sim->n_fields; field++) {
        size_t count = sim->counts[sim->fields[field].set];
        double *whole = field_now(sim, sim->fields[field].set, sim->fields[field].quantity.name);
        double *pieces = malloc(count * sizeof *pieces);
        ck_assert_ptr_nonnull(pieces);
        for (size_t first = 0, size = 1; first < count; first += size, size = 2 * size + 1) {
            size = size < count - first ? size : count - first;
            sim->method->field(sim, field, first, size, pieces + first);
        }
        ck_assert_msg(memcmp(whole, pieces, count * sizeof *whole) == 0, "%s",
                      sim->fields[field].quantity.name);
        free(whole);
        free(pieces);
    }
    simulation_destroy(sim);
}
END_TEST

START_TEST(nodes_have_what_their_bonds_have)
{
    Simulation *sim = cracking();
    size_t nodes = sim->counts[SET_PARTICLE], bonds = sim->counts[SET_BOND];
    double *energy = field_now(sim, SET_PARTICLE, "strain_energy"),
           *stretch = field_now(sim, SET_PARTICLE, "stretch"), *of_bond = field_now(sim, SET_BOND, "energy");
    double *i = field_now(sim, SET_BOND, "i"), *j = field_now(sim, SET_BOND, "j");
    double *sum = calloc(nodes, sizeof *sum);
    ck_assert_ptr_nonnull(sum);
    for (size_t b = 0; b < bonds; b++) {
        sum[(size_t)i[b]] += of_bond[b] / 2;
        sum[(size_t)j[b]] += of_bond[b] / 2;
    }
    for (size_t p = 0; p < nodes; p++) {
        Link links[FAMILY_MAX];
        size_t n = sim->method->links(sim, SET_PARTICLE, p, links, FAMILY_MAX);
        double most = -1;
        for (size_t l = 0; l < n; l++)
            if (!links[l].broken)
                most = fmax(most, links[l].stretch);
        if (!(fabs(energy[p] - sum[p]) <= 1e-13 * sum[p] && stretch[p] == most))
            ck_abort_msg("node %zu: %.17g J of %.17g J, stretch %.17g of %.17g", p, energy[p], sum[p],
                         stretch[p], most);
    }
    free(energy), free(stretch), free(of_bond), free(i), free(j), free(sum);
    simulation_destroy(sim);
}
END_TEST

/* sigma_ab = 1/2 sum_j pull |y| n_a n_b, y = y_j - y_i, from the table of bonds; each has two ends. */
START_TEST(nodes_have_the_stress_of_their_bonds)
{
    static const char *const names[] = {"sxx", "syy", "sxy"};
    Simulation *sim = cracking();
    const size_t nodes = sim->counts[SET_PARTICLE], bonds = sim->counts[SET_BOND];
    double *i = field_now(sim, SET_BOND, "i"), *j = field_now(sim, SET_BOND, "j"),
           *pull = field_now(sim, SET_BOND, "pull");
    double *x = field_now(sim, SET_PARTICLE, "x0"), *y = field_now(sim, SET_PARTICLE, "y0");
    double *ux = field_now(sim, SET_PARTICLE, "ux"), *uy = field_now(sim, SET_PARTICLE, "uy");
    for (size_t p = 0; p < nodes; p++)
        x[p] += ux[p], y[p] += uy[p];
    for (int k = 0; k < 3; k++) {
        double *stress = field_now(sim, SET_PARTICLE, names[k]), *sum = calloc(2 * nodes, sizeof *sum);
        ck_assert_ptr_nonnull(sum);
        for (size_t b = 0; b < bonds; b++) {
            const size_t ends[2] = {(size_t)i[b], (size_t)j[b]};
            const double along = x[ends[1]] - x[ends[0]], across = y[ends[1]] - y[ends[0]];
            const double product = k == 0 ? along * along : k == 1 ? across * across : along * across;
            const double term = pull[b] * product / hypot(along, across) / 2;
            for (int end = 0; end < 2; end++) {
                sum[ends[end]] += term;
                sum[nodes + ends[end]] += fabs(term);
            }
        }
        for (size_t p = 0; p < nodes; p++)
            ck_assert_msg(fabs(stress[p] - sum[p]) <= 1e-11 * sum[nodes + p],
                          "%s of node %zu is %.17g, its bonds have %.17g", names[k], p, stress[p], sum[p]);
        free(stress), free(sum);
    }
    free(i), free(j), free(pull), free(x), free(y), free(ux), free(uy);
    simulation_destroy(sim);
}
END_TEST

START_TEST(energies_of_nodes_add_up)
{
    Simulation *sim = _i ? breaking_plate() : cracking();
    double *energy = field_now(sim, SET_PARTICLE, "strain_energy"), sum = 0,
           strain = series_now(sim, "strain");
    for (size_t p = 0; p < sim->counts[SET_PARTICLE]; p++)
        sum += energy[p];
    ck_assert_msg(fabs(sum - strain) <= 1e-12 * strain, "nodes have %.17g, the series tells %.17g", sum,
                  strain);
    free(energy);
    simulation_destroy(sim);
}
END_TEST

static double pull_back(const Simulation *sim, size_t node, int axis, const void *stiffness)
{
    const int field = simulation_find_field(sim, 0, axis ? "uy" : "ux");
    return -*(const double *)stiffness * simulation_value(sim, field, node);
}

/* A spring to the ground that is added from outside acts along both axes, keeps the energy, at any number of
 * threads, and stands in the stage and in its sum beside the weight. */
START_TEST(stages_say_what_acts)
{
    static const double stiffness = 1e13;
    static const ForceTerm springs[] = {
        {.name = "spring", .equation = "-k u(i)", .load = "-k u", .on = pull_back, .context = &stiffness},
        {0}};
    BeamDef def = small_beam(BEAM_SIMPLY_SUPPORTED);
    Simulation *loose = beam_case_create(&def, NULL);
    ck_assert_str_eq(loose->stages[simulation_find_stage(loose, "body-force")].equation,
                     "no load acts: f(i) stays");
    simulation_destroy(loose);
    def.forces = springs;
    def.threads = 1 + _i;
    def.dt = 1.25e-8;
    Simulation *sim = beam_case_create(&def, NULL);
    const int force = simulation_find_stage(sim, "body-force");
    ck_assert_str_eq(sim->stages[force].equation, "f(i) += -k u(i)");
    const double start = series_now(sim, "total");
    Status status;
    long done;
    ck_assert_msg(simulation_steps(sim, 1600, NULL, &done, &status), "%s", status.text);
    ck_assert_double_gt(fabs(series_now(sim, "work")), 0.01 * start);
    ck_assert_double_eq_tol(series_now(sim, "total") - series_now(sim, "work"), start, 1e-4 * start);
    ck_assert(sim->method->change(sim, "load.body_force", -9.81, &status));
    ck_assert_str_eq(sim->stages[force].equation, "f(i) += ρ b on every node + -k u(i)");
    for (int i = 0; i <= force; i++)
        ck_assert(simulation_stage(sim, &status));
    char text[8192];
    sim->method->explain(sim, force, 0, 55, NULL, 0, text, sizeof text);
    ck_assert_msg(strstr(text, "fx = fx + b = ") && strstr(text, "fy = fy + b = "), "%s", text);
    simulation_destroy(sim);
}
END_TEST

START_TEST(every_stage_explains_itself)
{
    Simulation *sim = cracking();
    Status status = {0};
    for (int stage = 0; stage < sim->n_stages; stage++) {
        unsigned char *before = malloc(sim->method->state_size(sim));
        ck_assert_ptr_nonnull(before);
        simulation_save(sim, before);
        ck_assert(simulation_stage(sim, &status));
        for (size_t node = 31 + 10 * 100; node < sim->counts[SET_PARTICLE]; node += 367) {
            char text[1024], little[12];
            sim->method->explain(sim, stage, SET_PARTICLE, node, before, 4, text, sizeof text);
            ck_assert_uint_gt(strlen(text), 10);
            ck_assert_uint_lt(strlen(text), sizeof text - 1);
            sim->method->explain(sim, stage, SET_PARTICLE, node, NULL, 4, little, sizeof little);
            ck_assert_uint_lt(strlen(little), sizeof little);
        }
        free(before);
        const Stage *told = &sim->stages[stage];
        ck_assert(told->equation && told->sentence && told->source);
        char equation[512];
        text_to_ascii(told->equation, equation, sizeof equation);
        for (const char *c = equation; *c; c++)
            ck_assert_msg((unsigned char)*c < 128, "stage %s is not ASCII", told->id);
    }
    simulation_destroy(sim);
}
END_TEST

/* Of a beam at rest: no sums of as many zeros as bonds. */
START_TEST(bonds_that_do_not_pull_are_no_terms)
{
    const BeamDef def = small_beam(BEAM_NOTCHED);
    Simulation *sim = beam_case_create(&def, NULL);
    const int bonds = simulation_find_stage(sim, "bonds");
    char text[8192];
    for (int i = 0; i <= bonds; i++)
        ck_assert(simulation_stage(sim, NULL));
    sim->method->explain(sim, bonds, 0, 0, NULL, 0, text, sizeof text);
    ck_assert_msg(strstr(text, "no bond pulls\n") && !strstr(text, "×"), "%s", text);
    simulation_destroy(sim);
}
END_TEST

/* --- a run that is changed, and one that bursts --- */

/* The critical step is that of the linear operator: finding it breaks no bond, however small s0 is. */
START_TEST(finding_the_step_breaks_nothing)
{
    BeamDef def = small_beam(BEAM_NOTCHED);
    def.dt = 0;
    BeamFacts facts[2];
    for (int k = 0; k < 2; k++) {
        Simulation *sim = beam_case_create(&def, NULL);
        beam_facts(sim, &facts[k]);
        ck_assert_double_eq(series_now(sim, "broken_bonds"), 0);
        simulation_destroy(sim);
        def.critical_stretch = 1e-12;
    }
    ck_assert_double_eq(facts[0].critical_step, facts[1].critical_step);
}
END_TEST

START_TEST(load_and_critical_stretch_change_in_mid_run)
{
    Simulation *sim = cracking(), *straight = cracking();
    Status status = {0};
    unsigned char *kept = snapshot_now(sim);
    ck_assert(sim->method->change(sim, "pd.critical_stretch", 0, &status));
    ck_assert(sim->method->change(sim, "load.stress", 10e6, &status));
    double broken = series_now(sim, "broken_bonds");
    advance(sim, 50);
    ck_assert(series_now(sim, "broken_bonds") == broken);
    ck_assert(!sim->method->change(sim, "pd.critical_stretch", -1, &status) &&
              strstr(status.text, "critical_stretch"));
    ck_assert(!sim->method->change(sim, "beam.height", 1, &status) && strstr(status.text, "beam.height"));
    simulation_restore(sim, kept);
    advance(sim, 50);
    advance(straight, 50);
    expect_same_state(straight, sim, "after a change taken back");
    free(kept);
    simulation_destroy(sim);
    simulation_destroy(straight);
}
END_TEST

START_TEST(a_bursting_run_stops_at_a_sound_step)
{
    BeamDef def = small_beam(BEAM_NOTCHED);
    def.critical_stretch = 0;
    def.load_stress = 3e11;
    Simulation *sim = beam_case_create(&def, NULL);
    unsigned char *start = snapshot_now(sim);
    Status status = {0};
    long done = 0;
    ck_assert(!simulation_steps(sim, 2000, NULL, &done, &status));
    ck_assert_int_eq(status.code, STATUS_FAILED);
    ck_assert_msg(strstr(status.text, "node") && strstr(status.text, "step") && strstr(status.text, "t = "),
                  "%s", status.text);
    ck_assert_int_eq(done, sim->step);
    ck_assert_int_eq(sim->stage, 0);
    ck_assert(sim->failed && isfinite(series_now(sim, "total")));

    /* and that is the state a run that far has */
    Simulation *straight = beam_case_create(&def, NULL);
    advance(straight, done);
    expect_same_state(straight, sim, "before the burst");

    ck_assert(!simulation_steps(sim, 1, NULL, NULL, &status));
    simulation_restore(sim, start);
    advance(sim, done / 2);
    free(start);
    simulation_destroy(straight);
    simulation_destroy(sim);
}
END_TEST

/* The way back to the last sound step goes once more past a crack that was told before: it is told once. */
START_TEST(a_crack_before_a_burst_is_told_once)
{
    BeamDef def = small_beam(BEAM_NOTCHED);
    def.load_stress = 7.68e9;
    Simulation *sim = beam_case_create(&def, NULL);
    Status status = {0};
    long done = 0;
    ck_assert(!simulation_steps(sim, 900, NULL, &done, &status));
    ck_assert_int_eq(sim->n_events, 1);
    ck_assert_int_eq(sim->events[0].kind, EVENT_BREAK);
    ck_assert_int_lt(sim->events[0].step, done);
    ck_assert_int_eq(sim->events_beyond.of[EVENT_BREAK], 0);
    simulation_destroy(sim);
}
END_TEST

/* Rows of paths shift as bonds break beside them; what has cracked stays cracked. */
START_TEST(a_crack_begins_above_the_notch_and_never_shrinks)
{
    BeamDef def = small_beam(BEAM_NOTCHED);
    Simulation *sim = beam_case_create(&def, NULL);
    double length = 0;
    long bonds_before = 0;
    for (int step = 1; step <= 600; step++) {
        Crack crack;
        advance(sim, 1);
        ck_assert(crack_measure(sim, &crack));
        ck_assert_msg(crack.length >= length, "%.17g after %.17g at step %d", crack.length, length, step);
        ck_assert(crack.begun == (crack.length > 0));
        ck_assert_double_eq(series_now(sim, "crack_length"), crack.length);
        if (!crack.begun) {
            ck_assert(crack.x == def.notch_position && crack.y == def.notch_depth);
            bonds_before = crack.broken;
        } else {
            ck_assert_double_gt(crack.y, def.notch_depth);
        }
        length = crack.length;
    }
    ck_assert_msg(bonds_before > 0 && length > 0, "%ld bonds broke before, length %g", bonds_before, length);

    /* and it is part of the state */
    unsigned char *kept = snapshot_now(sim);
    advance(sim, 100);
    simulation_restore(sim, kept);
    ck_assert_double_eq(series_now(sim, "crack_length"), length);
    free(kept);
    simulation_destroy(sim);
}
END_TEST

START_TEST(events_tell_of_the_crack)
{
    BeamDef def = small_beam(BEAM_NOTCHED);
    Simulation *sim = beam_case_create(&def, NULL);
    unsigned char *start = snapshot_now(sim);
    Crack crack;
    ck_assert(crack_measure(sim, &crack) && isnan(crack.first_break) && crack.broken == 0);
    advance(sim, 600);
    ck_assert_int_eq(sim->n_events, 3);
    ck_assert_int_eq(sim->events[0].step, 172);
    ck_assert_int_eq(sim->events[1].step, 319);
    ck_assert_int_eq(sim->events[2].kind, EVENT_BREAK);
    ck_assert(crack_measure(sim, &crack));
    ck_assert_double_eq_tol(crack.arrival, (double)sim->events[2].step * sim->dt, 1e-12);
    double angle = crack_angle(sim, 0.02);
    ck_assert_msg(angle > 10 && angle < 60, "angle %g", angle);
    simulation_restore(sim, start);
    ck_assert_int_eq(sim->n_events, 0);
    advance(sim, 600);
    ck_assert_int_eq(sim->n_events, 3);
    free(start);
    simulation_destroy(sim);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *kept = tcase_create("kept");
    tcase_add_test(kept, momentum_is_kept);
    tcase_add_test(kept, energy_error_falls_as_the_square_of_the_step);
    tcase_add_test(kept, damage_only_grows);
    suite_add_tcase(suite, kept);

    TCase *bits = tcase_create("bits");
    tcase_add_loop_test(bits, snapshots_bring_back_every_stage, 0, N_STAGES);
    tcase_add_test(bits, stages_restore_what_they_show);
    tcase_add_loop_test(bits, slices_are_stages, 0, 4);
    tcase_add_loop_test(bits, moving_stages_are_steps, 0, 2);
    tcase_add_loop_test(bits, every_stepping_is_its_stages, 0, STEPPING_LEAPFROG_AHEAD + 1);
    tcase_add_loop_test(bits, threads_leave_no_trace, 2, 4);
    tcase_add_loop_test(bits, vector_width_leaves_no_trace, 0, CPU_LEVELS);
    tcase_add_loop_test(bits, steep_waves_leave_no_trace, 0, CPU_LEVELS);
    tcase_add_loop_test(bits, watching_leaves_no_trace, 0, 2);
    suite_add_tcase(suite, bits);

    TCase *told = tcase_create("told");
    tcase_add_loop_test(told, links_add_up_to_the_force, 0, 2);
    tcase_add_test(told, bonds_are_listed_once);
    tcase_add_loop_test(told, fields_are_the_same_in_pieces, 0, 2);
    tcase_add_test(told, nodes_have_what_their_bonds_have);
    tcase_add_test(told, nodes_have_the_stress_of_their_bonds);
    tcase_add_loop_test(told, energies_of_nodes_add_up, 0, 2);
    tcase_add_test(told, every_stage_explains_itself);
    tcase_add_test(told, bonds_that_do_not_pull_are_no_terms);
    tcase_add_loop_test(told, stages_say_what_acts, 0, 2);
    suite_add_tcase(suite, told);

    TCase *changes = tcase_create("changes");
    tcase_add_test(changes, load_and_critical_stretch_change_in_mid_run);
    tcase_add_test(changes, finding_the_step_breaks_nothing);
    tcase_add_test(changes, a_bursting_run_stops_at_a_sound_step);
    tcase_add_test(changes, a_crack_before_a_burst_is_told_once);
    tcase_add_test(changes, events_tell_of_the_crack);
    tcase_add_test(changes, a_crack_begins_above_the_notch_and_never_shrinks);
    suite_add_tcase(suite, changes);
}
