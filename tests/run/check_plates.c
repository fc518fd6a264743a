/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Plates: against runs of independent programs (tests/golden/plates.txt), digit by digit; and what holds of
 * any plate: symmetry, the balance of energies, loads that end, what moves and what is protected. */
#include "problems/problem.h"
#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/settings.h"
#include "answers/summary.h"
#include "run/lab_case.h"
#include "scenario/scenario.h"
#include "methods/bonds/plane/bonds_plane.h"
#include "methods/bonds/cracks/crack.h"
#include "methods/bonds/cracks/crack_cost.h"
#include "methods/run_case.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- the reference runs --------------------------------------------------------------------------- */

enum { PARTICLES, BONDS };
enum { ROWS_MOST = 12, BREAKS_MOST = 12, CUTS_MOST = 16, COLUMNS = 7 };
enum { STEP, BROKEN, KINETIC, STRAIN, DISSIPATED, WORK, TIP_X };
enum { UY = 1, VY, MOTION_KINETIC, MOTION_STRAIN, MOMENTUM };

typedef struct Golden {
    Settings settings;
    char lattice[3][16];
    long breaks[BREAKS_MOST][3];
    double rows[ROWS_MOST][COLUMNS], motion[ROWS_MOST][COLUMNS];
    char cuts[CUTS_MOST][64];
    long cut_bonds[CUTS_MOST];
    bool in_turn[CUTS_MOST];
    int n_breaks, n_rows, n_motion, n_cuts;
} Golden;

static void read_numbers(double out[COLUMNS], const char *text, int count)
{
    char *next;
    for (int k = 0; k < count; k++, text = next) {
        out[k] = strtod(text, &next);
        ck_assert_ptr_ne(text, next);
    }
}

static void read_line(Golden *golden, const char *key, const char *text)
{
    if (strcmp(key, "lattice") == 0) {
        ck_assert_int_eq(
            sscanf(text, "%15s %15s %15s", golden->lattice[0], golden->lattice[1], golden->lattice[2]), 3);
    } else if (strcmp(key, "bonds") == 0) {
        long *at = golden->breaks[golden->n_breaks++];
        ck_assert_int_eq(sscanf(text, "%ld %ld %ld", &at[0], &at[1], &at[2]), 3);
    } else if (strcmp(key, "row") == 0) {
        read_numbers(golden->rows[golden->n_rows++], text, 7);
    } else if (strcmp(key, "motion") == 0) {
        read_numbers(golden->motion[golden->n_motion++], text, 6);
    } else if (strcmp(key, "cut") == 0 || strcmp(key, "turn") == 0) {
        const char *last = strrchr(text, ' ');
        snprintf(golden->cuts[golden->n_cuts], 64, "%.*s", (int)(last - text), text);
        golden->cut_bonds[golden->n_cuts] = atol(last);
        golden->in_turn[golden->n_cuts++] = key[0] == 't';
    } else {
        set(&golden->settings, key, text);
    }
}

static Golden read_case(const char *name)
{
    static Golden golden;
    golden = (Golden){0};
    settings_default(&golden.settings, &problem_plate);
    set(&golden.settings, "time.end", "1");
    FILE *file = fopen(source_path("tests/golden/plates.txt"), "r");
    ck_assert_msg(file != NULL, "cannot read tests/golden/plates.txt");
    char line[512], key[64];
    bool here = false, found = false;
    while (fgets(line, sizeof line, file)) {
        line[strcspn(line, "\n")] = '\0';
        int length = 0;
        if (line[0] == '#' || sscanf(line, "%63s %n", key, &length) != 1)
            continue;
        if (strcmp(key, "case") == 0)
            here = strcmp(line + length, name) == 0;
        else if (here)
            read_line(&golden, key, line + length);
        found = found || here;
    }
    fclose(file);
    ck_assert_msg(found, "no case %s", name);
    return golden;
}

static Simulation *simulation_of(const Settings *settings, int threads)
{
    Status status = {0};
    ck_assert_msg(settings_check(settings, &status), "%s", status.text);
    Simulation *sim = problem_simulate(settings, threads, &status);
    ck_assert_msg(sim != NULL, "%s", status.text);
    return sim;
}

static void expect_near(const char *what, double value, double expected, double tolerance)
{
    ck_assert_msg(fabs(value - expected) <= tolerance,
                  "%s is %.17g, expected %.17g, off by %.3g (allowed %.3g)", what, value, expected,
                  fabs(value - expected), tolerance);
}

static void expect_count(const char *told, size_t count)
{
    if (strcmp(told, "-") != 0)
        ck_assert_int_eq(atol(told), (long)count);
}

static double tip_of(const Simulation *sim)
{
    double *damage = field_now(sim, 0, "damage"), *x = field_now(sim, 0, "x0"), tip = 0;
    for (size_t k = 0; k < sim->counts[0]; k++)
        if (damage[k] > CRACK_DAMAGE)
            tip = fmax(tip, x[k]);
    free(damage);
    free(x);
    return tip;
}

/* The bonds that broke in the step that was just done, in the order of their nodes. */
static void expect_breaks(const Golden *golden, const Simulation *sim, int *next)
{
    if (golden->breaks[*next][2] != sim->step)
        return;
    double *a = field_now(sim, BONDS, "i"), *b = field_now(sim, BONDS, "j"),
           *broken_at = field_now(sim, BONDS, "broken_at");
    for (size_t k = 0; k < sim->counts[BONDS] && *next < golden->n_breaks; k++) {
        if ((long)broken_at[k] != sim->step)
            continue;
        const long *told = golden->breaks[(*next)++];
        ck_assert_int_eq(told[2], sim->step);
        ck_assert_int_eq(told[0], (long)a[k]);
        ck_assert_int_eq(told[1], (long)b[k]);
    }
    free(a);
    free(b);
    free(broken_at);
}

static void expect_history(const char *name)
{
    const Golden golden = read_case(name);
    const double *last = golden.rows[golden.n_rows - 1];
    Simulation *sim = simulation_of(&golden.settings, 1);
    BeamFacts facts;
    beam_facts(sim, &facts);
    expect_count(golden.lattice[0], sim->counts[PARTICLES]);
    expect_count(golden.lattice[1], facts.bonds);
    expect_count(golden.lattice[2], facts.notch_bonds);
    int next = 0;
    advance(sim, golden.breaks[0][2] - 1);
    ck_assert_int_eq((long)series_now(sim, "broken_bonds"), 0);
    for (; next < golden.n_breaks; expect_breaks(&golden, sim, &next))
        advance(sim, 1);
    simulation_destroy(sim);

    sim = simulation_of(&golden.settings, 1);
    for (int k = 0; k < golden.n_rows; k++) {
        const double *row = golden.rows[k];
        advance(sim, (long)row[STEP] - sim->step);
        ck_assert_int_eq((long)series_now(sim, "broken_bonds"), (long)row[BROKEN]);
        expect_near("kinetic", series_now(sim, "kinetic"), row[KINETIC], 1e-9 * last[WORK]);
        expect_near("strain", series_now(sim, "strain"), row[STRAIN], 1e-9 * last[WORK]);
        expect_near("dissipated", series_now(sim, "dissipated"), row[DISSIPATED], 1e-9 * last[WORK]);
        expect_near("work", series_now(sim, "work"), row[WORK], 1e-9 * last[WORK]);
        expect_near("tip", tip_of(sim), row[TIP_X], 1e-6);
    }
    simulation_destroy(sim);
}

static const char *const histories[] = {"branching-1", "branching-0.5", "kalthoff-1"};

START_TEST(histories_agree)
{
    if (!suite_wide() && _i == 2) /* a second */
        return;
    expect_history(histories[_i]);
}
END_TEST

/* Without corrections, with protected edges. */
START_TEST(an_example_of_others_begins_alike)
{
    const Golden golden = read_case("ornl");
    Simulation *sim = simulation_of(&golden.settings, 1);
    BeamFacts facts;
    int next = 0;
    beam_facts(sim, &facts);
    expect_count(golden.lattice[1], facts.bonds);
    expect_count(golden.lattice[2], facts.notch_bonds);
    advance(sim, golden.breaks[0][2] - 1);
    for (; next < golden.n_breaks; expect_breaks(&golden, sim, &next))
        advance(sim, 1);
    simulation_destroy(sim);
}
END_TEST

START_TEST(an_initial_velocity_agrees)
{
    const Golden golden = read_case("initial-velocity");
    Simulation *sim = simulation_of(&golden.settings, 1);
    for (int k = 0; k < golden.n_motion; k++) {
        const double *row = golden.motion[k];
        advance(sim, (long)row[STEP] - sim->step);
        expect_near("u", series_now(sim, "u_probe"), row[UY], 1e-9 * 4.5e-7);
        expect_near("v", series_now(sim, "v_probe"), row[VY], 1e-6 * 0.41);
        expect_near("kinetic", series_now(sim, "kinetic"), row[MOTION_KINETIC], 1e-9 * 0.447);
        expect_near("strain", series_now(sim, "strain"), row[MOTION_STRAIN], 1e-9 * 0.447);
        double *vx = field_now(sim, 0, "vx"), momentum = 0;
        for (size_t i = 0; i < sim->counts[0]; i++)
            momentum += vx[i] * 2235 * 1e-6;
        free(vx);
        expect_near("momentum", momentum, row[MOMENTUM], 1e-12);
    }
    simulation_destroy(sim);
}
END_TEST

START_TEST(cuts_part_the_bonds_that_they_should)
{
    const Golden golden = read_case("cuts");
    long in_turn = 0;
    Settings all = golden.settings;
    for (int k = 0; k < golden.n_cuts; k++) {
        char name[8];
        snprintf(name, sizeof name, "c%d", k);
        Settings settings = golden.in_turn[k] ? all : golden.settings;
        ck_assert(settings_row_set(&settings, ROWS_CUTS, name, golden.cuts[k], NULL));
        if (golden.in_turn[k])
            all = settings;
        in_turn += golden.in_turn[k] ? golden.cut_bonds[k] : 0;
        const long expected = golden.in_turn[k] ? in_turn : golden.cut_bonds[k];
        Simulation *sim = simulation_of(&settings, 1);
        BeamFacts facts;
        beam_facts(sim, &facts);
        expect_count(golden.lattice[1], facts.bonds);
        ck_assert_msg((long)facts.notch_bonds == expected, "%s: %zu, not %ld", golden.cuts[k],
                      facts.notch_bonds, expected);
        simulation_destroy(sim);
    }
}
END_TEST

/* --- what holds of any plate ---------------------------------------------------------------------- */

static Settings small_plate(void)
{
    Settings settings;
    settings_default(&settings, &problem_plate);
    set(&settings, "plate.length", "40 mm");
    set(&settings, "plate.height", "20 mm");
    set(&settings, "plate.thickness", "1");
    set(&settings, "pd.spacing", "1 mm");
    set(&settings, "pd.horizon", "3 mm");
    set(&settings, "pd.critical_stretch", "0");
    set(&settings, "time.step", "1e-7");
    set(&settings, "time.end", "1");
    return settings;
}

START_TEST(what_is_the_same_above_and_below_stays_so)
{
    const Golden golden = read_case("branching-1");
    Simulation *sim = simulation_of(&golden.settings, 1);
    advance(sim, 200);
    double *damage = field_now(sim, 0, "damage");
    const size_t nx = sim->columns, ny = sim->rows;
    for (size_t j = 0; j < ny / 2; j++)
        for (size_t i = 0; i < nx; i++)
            expect_near("damage", damage[j * nx + i], damage[(ny - 1 - j) * nx + i], 1e-14);
    free(damage);
    simulation_destroy(sim);
}
END_TEST

static double balance(Simulation *sim, double start)
{
    return series_now(sim, "total") - start - series_now(sim, "work");
}

/* Of second order in the time step while nothing breaks, whatever pulls and moves; and braked the same,
 * though a support that moves has to make up for what damping takes from it. */
START_TEST(energies_balance)
{
    static const char *const rows[][2] = {
        {"loads.a", "top 0% 100% 1MPa 4MPa"},
        {"loads.a", "left 20% 60% -5MPa 1MPa ramp 3us"},
        {"loads.a", "right 0% 100% 5MPa -1MPa until 4.5us"},
        {"loads.a", "bottom 0% 30% 2MPa 2MPa"},
        {"supports.a", "0 0 1mm 100% ux 0.5 uy -0.25"},
        {"supports.a", "0 0 100% 1mm uy 0.5"},
    };
    Settings settings = small_plate();
    set(&settings, "time.step", "5e-8");
    set(&settings, "supports.z", "50% 50% 60% 60% ux 0 uy 0");
    set(&settings, rows[_i % 6][0], rows[_i % 6][1]);
    set(&settings, "damping.rate", _i < 6 ? "0" : "1e6");
    Simulation *sim = simulation_of(&settings, 1);
    const double start = series_now(sim, "kinetic");
    double most = 0;
    for (int k = 0; k < 40; k++) {
        advance(sim, 10);
        most = fmax(most, fabs(series_now(sim, "work")));
    }
    ck_assert_double_gt(most, 1e-6);
    expect_near("balance", balance(sim, start), 0, 5e-4 * most);
    simulation_destroy(sim);
}
END_TEST

/* F t: the momentum that a load has given, of a plate that nothing holds. */
START_TEST(loads_give_their_impulse)
{
    Settings settings = small_plate();
    set(&settings, "loads.a", "right 25% 75% 3MPa -2MPa ramp 2us until 4us");
    Simulation *sim = simulation_of(&settings, 1);
    advance(sim, 100);
    double *vx = field_now(sim, 0, "vx"), *vy = field_now(sim, 0, "vy"), x = 0, y = 0;
    for (size_t i = 0; i < sim->counts[0]; i++) {
        x += vx[i] * 2235 * 1e-6;
        y += vy[i] * 2235 * 1e-6;
    }
    /* ten nodes; half of the ramp, and then 2 us */
    expect_near("px", x, 3e6 * 10e-3 * (1e-6 + 2e-6), 1e-12);
    expect_near("py", y, -2e6 * 10e-3 * (1e-6 + 2e-6), 1e-12);
    free(vx);
    free(vy);
    simulation_destroy(sim);
}
END_TEST

START_TEST(supports_keep_their_velocity)
{
    Settings settings = small_plate();
    set(&settings, "impulses.all", "0 0 100% 100% 3 4");
    set(&settings, "supports.a", "0 0 1mm 100% ux 2");
    set(&settings, "supports.b", "39mm 0 40mm 100% ux 0 uy 0");
    Simulation *sim = simulation_of(&settings, 1);
    double *vy = field_now(sim, 0, "vy");
    ck_assert_double_eq(vy[0], 4);
    free(vy);
    advance(sim, 50);
    double *vx = field_now(sim, 0, "vx"), *ux = field_now(sim, 0, "ux"), *uy = field_now(sim, 0, "uy");
    double *held = field_now(sim, 0, "held");
    for (size_t j = 0; j < sim->rows; j++) {
        const size_t left = j * sim->columns, right = left + sim->columns - 1;
        ck_assert_double_eq(vx[left], 2);
        expect_near("ux", ux[left], 2 * 50e-7, 1e-18);
        ck_assert_double_eq(ux[right], 0);
        ck_assert_double_eq(uy[right], 0);
        ck_assert(held[left] == 1 && held[right] == 1 && held[left + 1] == 0);
    }
    free(vx);
    free(ux);
    free(uy);
    free(held);
    simulation_destroy(sim);
}
END_TEST

/* It oscillates for all to see; there is no theory of its period, and that is no rest. */
START_TEST(a_plate_that_oscillates_is_not_at_rest)
{
    Settings settings = small_plate();
    char out[SUMMARY_MAX];
    RunSummary summary;
    set(&settings, "impulses.a", "0 0 50% 100% 0 1");
    set(&settings, "time.end", "1e-5");
    Experiment *experiment = open_experiment(&settings, 1 << 20);
    ck_assert(experiment_advance(experiment, 100, NULL));
    summary_of(experiment, &summary);
    summary_text(&summary, &settings, out);
    ck_assert_msg(strstr(out, "energy") && !strstr(out, "nothing vibrates"), "%s", out);
    experiment_destroy(experiment);
}
END_TEST

static const Stage *body_force_of(const Simulation *sim)
{
    return &sim->stages[simulation_find_stage(sim, "body-force")];
}

/* The stage says that the nodes are weighed while they are. */
START_TEST(a_stage_tells_of_the_weight)
{
    Settings settings = small_plate();
    set(&settings, "loads.a", "top 0 100% 0 1");
    Simulation *sim = simulation_of(&settings, 1);
    ck_assert(!strstr(body_force_of(sim)->equation, "ρ b"));
    unsigned char *before = snapshot_now(sim);
    ck_assert(sim->method->change(sim, "load.body_force", -9.81, NULL));
    ck_assert_str_eq(body_force_of(sim)->equation,
                     "f(i) += ρ b on every node + (sx, sy) min(1, t/t0)/Δx on loaded nodes");
    simulation_restore(sim, before);
    ck_assert(!strstr(body_force_of(sim)->equation, "ρ b"));
    free(before);
    simulation_destroy(sim);
}
END_TEST

/* Strictly inside: a region that ends on a row of nodes leaves that row out. */
START_TEST(protected_nodes_keep_their_bonds)
{
    Settings settings = small_plate();
    set(&settings, "protected.a", "0.5mm 0.5mm 5.5mm 3.5mm");
    Simulation *sim = simulation_of(&settings, 1);
    double *protected = field_now(sim, 0, "protected"), sum = 0;
    for (size_t i = 0; i < sim->counts[0]; i++)
        sum += protected[i];
    ck_assert_double_eq(sum, 4 * 2);
    ck_assert_double_eq(protected[sim->columns + 1], 1);
    free(protected);
    simulation_destroy(sim);

    settings = read_case("branching-1").settings;
    set(&settings, "protected.all", "0 0 100% 100%");
    sim = simulation_of(&settings, 1);
    advance(sim, 100);
    ck_assert_double_eq(series_now(sim, "broken_bonds"), 0);
    simulation_destroy(sim);
}
END_TEST

/* In stages, in slices, with two threads, rewound: the same bits, works included. */
START_TEST(steps_and_stages_have_the_same_bits)
{
    Settings settings = read_case("branching-1").settings;
    set(&settings, "supports.a", "0 0 1mm 30% ux 1 uy 0");
    set(&settings, "supports.b", "0 70% 1mm 100% ux -1");
    set(&settings, "loads.r", "right 0 100% 1MPa 0 ramp 2us until 9us");
    set(&settings, "load.body_force", "-1.2345e6");
    set(&settings, "damping.rate", "12345");
    Simulation *fast = simulation_of(&settings, 1), *slow = simulation_of(&settings, 1);
    Simulation *both = simulation_of(&settings, 2);
    advance(fast, 60);
    advance(both, 60);
    Status status = {0};
    for (bool done; slow->step < 60;)
        ck_assert_msg(simulation_slice(slow, 3, &done, &status), "%s", status.text);
    ck_assert_double_gt(series_now(fast, "broken_bonds"), 0);
    expect_same_states(fast, slow, "in slices");
    expect_same_states(fast, both, "by two threads");
    unsigned char *there = snapshot_now(fast);
    advance(slow, 25);
    advance(fast, 25);
    simulation_restore(fast, there);
    advance(fast, 25);
    expect_same_states(fast, slow, "rewound");
    free(there);
    simulation_destroy(fast);
    simulation_destroy(slow);
    simulation_destroy(both);
}
END_TEST

/* A cone is 0 at the horizon: bonds as long as that would pull nothing, could never break and would count as
 * whole in the damage. Their nodes lie within the horizon all the same, for its area. */
START_TEST(a_cone_binds_nothing_at_its_horizon)
{
    Settings settings = small_plate();
    set(&settings, "pd.horizon", _i ? "5 mm" : "4 mm");
    set(&settings, "pd.surface_correction", "volume");
    Simulation *flat = simulation_of(&settings, 1);
    set(&settings, "pd.influence", "conical");
    Simulation *cone = simulation_of(&settings, 1);
    const size_t middle = 10 * 40 + 20;
    const int family = simulation_find_field(cone, 0, "family"),
              factor = simulation_find_field(cone, 0, "surface_factor");
    ck_assert_double_eq(simulation_value(flat, family, middle), _i ? 80 : 48);
    ck_assert_double_eq(simulation_value(cone, family, middle), _i ? 68 : 44);
    for (size_t node = 0; node < cone->counts[0]; node++)
        ck_assert(simulation_value(flat, factor, node) == simulation_value(cone, factor, node));
    simulation_destroy(flat);
    simulation_destroy(cone);
}
END_TEST

/* What an upright plane costs in a plate that is lower than a family: every bond from left to right of the
 * middle, counted one by one. */
START_TEST(a_plane_through_a_low_plate_is_what_is_there)
{
    Settings settings = small_plate();
    set(&settings, "plate.height", _i ? "20 mm" : "3 mm");
    set(&settings, "plate.length", _i ? "4 mm" : "20 mm");
    set(&settings, "pd.horizon", "4 mm");
    set(&settings, "pd.surface_correction", "none");
    set(&settings, "pd.volume_correction", "none");
    set(&settings, "pd.critical_stretch", "1e-3");
    Simulation *sim = simulation_of(&settings, 1);
    const double middle = settings_geometry(&settings)->length / 2;
    double *from = field_now(sim, BONDS, "x_i"), *to = field_now(sim, BONDS, "x_j"),
           *low = field_now(sim, BONDS, "y_i"), *high = field_now(sim, BONDS, "y_j"), lengths = 0;
    for (size_t k = 0; k < sim->counts[BONDS]; k++)
        if ((from[k] < middle) != (to[k] < middle))
            lengths += hypot(to[k] - from[k], high[k] - low[k]);
    const double c = 9 * settings_material(&settings)->youngs_modulus / (M_PI * pow(4e-3, 3)),
                 expected = c * 1e-3 * 1e-3 * lengths * 1e-12 / 2 / settings_geometry(&settings)->height;
    CrackCost cost;
    ck_assert(crack_cost_along(sim, NULL, 0, 1, &(Cancel){0}, &cost));
    expect_near("plane", cost.plane, expected, 1e-12 * expected);
    free(from);
    free(to);
    free(low);
    free(high);
    simulation_destroy(sim);
}
END_TEST

static const struct {
    const char *place;
    const char *key;
    double of[2];
} probes[] = {{"20.4mm", "probe.x", {20, 20}},
              {"20mm", "probe.x", {19, 20}},
              {"0", "probe.x", {0, 0}},
              {"40mm", "probe.x", {39, 39}},
              {"20.6mm", "probe.x", {20, 20}}};

START_TEST(the_probe_is_the_nearest_node)
{
    Settings settings = small_plate();
    set(&settings, probes[_i].key, probes[_i].place);
    Simulation *sim = simulation_of(&settings, 1);
    double *probe = field_now(sim, 0, "probe");
    for (size_t i = 0; i < sim->counts[0]; i++) {
        const double column = (double)(i % sim->columns), row = (double)(i / sim->columns);
        ck_assert((probe[i] != 0) ==
                  ((column == probes[_i].of[0] || column == probes[_i].of[1]) && (row == 9 || row == 10)));
    }
    free(probe);
    simulation_destroy(sim);
}
END_TEST

static const struct {
    const char *cut;
    bool along;
} directions[] = {{"0 50% 20mm 50%", false},        {"0 10.5mm 20mm 10.5mm", true},
                  {"5mm 0 5mm 10mm", false},        {"5.5mm 10mm 5.5mm 0", true},
                  {"0.5mm 0.5mm 9mm 9mm", true},    {"1mm 0.5mm 9mm 8.5mm", false},
                  {"0.5mm 10mm 0.9mm 10mm", false}, {"0 10.5mm 0.9mm 10.5mm", false}};

START_TEST(a_cut_along_an_edge_is_told)
{
    static const char *const cuts[] = {"0 0 100% 0", "100% 0 100% 100%", "0 19.6mm 100% 20mm", "0 0 0 100%"};
    Settings settings = small_plate();
    char advice[160];
    set(&settings, "cuts.edge", cuts[_i]);
    ck_assert(problem_advice(&settings, advice, sizeof advice, NULL));
    ck_assert_str_eq(advice, "cut edge runs along an edge and parts no bond");
}
END_TEST

START_TEST(a_cut_along_nodes_is_told)
{
    Settings settings = small_plate();
    char advice[160];
    set(&settings, "cuts.edge", directions[_i].cut);
    ck_assert(problem_advice(&settings, advice, sizeof advice, NULL));
    ck_assert_str_eq(advice, directions[_i].along
                                 ? "cut edge runs along nodes, which hang on its right: shift it by half a "
                                   "spacing, 0.0005 m"
                                 : "");
}
END_TEST

/* Nodes on a cut hang on its right: rightwards on what is below, leftwards on what is above. */
START_TEST(nodes_on_a_cut_hang_on_its_right)
{
    static const char *const cuts[] = {"0 10.5mm 100% 10.5mm", "100% 10.5mm 0 10.5mm"};
    Settings settings = small_plate();
    set(&settings, "cuts.a", cuts[_i]);
    Simulation *sim = simulation_of(&settings, 1);
    double *low = field_now(sim, BONDS, "y_i"), *high = field_now(sim, BONDS, "y_j"),
           *cut = field_now(sim, BONDS, "notch");
    const double row = 10.5e-3, above = _i == 0 ? row + 0.5e-3 : row - 0.5e-3;
    for (size_t k = 0; k < sim->counts[BONDS]; k++)
        ck_assert((cut[k] != 0) == ((low[k] < above) != (high[k] < above)));
    free(low);
    free(high);
    free(cut);
    simulation_destroy(sim);
}
END_TEST

static const struct {
    const char *key, *value, *said;
} refused[] = {
    {"cuts.a", "1mm 1mm 1mm 1mm", "cuts.a: has no length (two places: X0 Y0 X1 Y1)"},
    {"loads.a", "top 0.6mm 1.4mm 0 1",
     "loads.a: holds no node of the edge (a stretch of at least pd.spacing = 0.001)"},
    {"supports.a", "0 0 0.4mm 1mm ux 0", "supports.a: holds no node (at least pd.spacing = 0.001 both ways)"},
    {"impulses.a", "0 0 1mm 0.4mm 1 1", "impulses.a: holds no node (at least pd.spacing = 0.001 both ways)"},
    {"protected.a", "0.5mm 0 1.5mm 1mm",
     "protected.a: holds no node (at least pd.spacing = 0.001 both ways)"},
    {"supports.b", "0 0 2mm 2mm ux 1",
     "supports.b: moves nodes that supports.there moves or holds (regions apart)"},
    {"pd.spacing", "1um", "pd.horizon: 0.003 is 3000 spacings (at most 8 times pd.spacing)"},
    {"plate.length", "20m", "pd.spacing: 2e+06 nodes with 14 bonds each are too many"},
    {"plate.height", "1mm", "pd.spacing: the plate is only 1 nodes high (at least 2; plate.height is 0.001)"},
    {"impulses.a", "0 0 1mm 1mm 3301 -4401",
     "impulses.a: 5501.4 m/s is faster than waves in the plate (at most "
     "sqrt(youngs_modulus/density) = 5392.84 m/s)"},
    {"supports.a", "5mm 5mm 6mm 6mm ux 5393",
     "supports.a: 5393 m/s is faster than waves in the plate (at most "
     "sqrt(youngs_modulus/density) = 5392.84 m/s)"},
};

START_TEST(a_plate_that_is_none_is_refused)
{
    Settings settings = small_plate();
    Status status = {0};
    set(&settings, "supports.there", "0 0 1mm 1mm ux 0");
    if (_i == 7)
        set(&settings, "plate.height", "100 m");
    set(&settings, refused[_i].key, refused[_i].value);
    ck_assert(!settings_check(&settings, &status));
    if (_i != 7)
        ck_assert_str_eq(status.text, refused[_i].said);
    else
        ck_assert_str_eq(status.text,
                         "pd.spacing: 2e+09 nodes with 14 bonds each are too many for memory (at "
                         "most 19173961 nodes: a larger spacing, or a smaller horizon)");
}
END_TEST

/* What `t` and `d` propose on a plate leaves it one that can be trusted: neighbours as far as is usual. */
START_TEST(a_question_leaves_the_lattice_usual)
{
    for (const BuiltinScenario *builtin = builtin_scenarios; builtin->name; builtin++) {
        Settings settings;
        Status status = {0};
        ck_assert_msg(scenario_load(builtin->name, &settings, &status), "%s", status.text);
        const Parameter *asked = settings_question(&settings);
        if (settings.problem != &problem_plate)
            continue;
        const double before = settings_lattice(&settings)->horizon / settings_lattice(&settings)->spacing;
        ck_assert_msg(settings_answer_otherwise(&settings, asked), "%s", builtin->name);
        const double after = settings_lattice(&settings)->horizon / settings_lattice(&settings)->spacing;
        ck_assert_msg(after <= fmax(before, 4) * (1 + 1e-9) && after >= 3 * (1 - 1e-9), "%s: %g spacings",
                      builtin->name, after);
    }
}
END_TEST

#define LOOP(cases, test, table) tcase_add_loop_test(cases, test, 0, (int)(sizeof table / sizeof *table))

void add_cases(Suite *suite)
{
    TCase *golden = tcase_create("golden");
    LOOP(golden, histories_agree, histories);
    tcase_add_test(golden, an_example_of_others_begins_alike);
    tcase_add_test(golden, an_initial_velocity_agrees);
    tcase_add_test(golden, cuts_part_the_bonds_that_they_should);
    suite_add_tcase(suite, golden);
    TCase *plates = tcase_create("plates");
    tcase_add_test(plates, what_is_the_same_above_and_below_stays_so);
    tcase_add_loop_test(plates, energies_balance, 0, 12);
    tcase_add_test(plates, loads_give_their_impulse);
    tcase_add_test(plates, supports_keep_their_velocity);
    tcase_add_test(plates, a_plate_that_oscillates_is_not_at_rest);
    tcase_add_test(plates, a_stage_tells_of_the_weight);
    tcase_add_test(plates, protected_nodes_keep_their_bonds);
    tcase_add_test(plates, steps_and_stages_have_the_same_bits);
    tcase_add_loop_test(plates, a_cone_binds_nothing_at_its_horizon, 0, 2);
    tcase_add_loop_test(plates, a_plane_through_a_low_plate_is_what_is_there, 0, 2);
    LOOP(plates, the_probe_is_the_nearest_node, probes);
    LOOP(plates, a_cut_along_nodes_is_told, directions);
    tcase_add_loop_test(plates, a_cut_along_an_edge_is_told, 0, 4);
    tcase_add_loop_test(plates, nodes_on_a_cut_hang_on_its_right, 0, 2);
    LOOP(plates, a_plate_that_is_none_is_refused, refused);
    tcase_add_test(plates, a_question_leaves_the_lattice_usual);
    suite_add_tcase(suite, plates);
}
