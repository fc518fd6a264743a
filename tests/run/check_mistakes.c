/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Codes that are wrong in one place: their digits against those of independent codes, what they are shown
 * with, and that nothing fast knows of them. */
#include "base/text.h"
#include "run/lab_case.h"

#include "answers/fit_search.h"
#include "answers/summary.h"
#include "methods/bonds/plane/bonds_plane.h"
#include "scenario/settings.h"
#include "methods/mpm/mistakes.h"
#include "problems/problem.h"
#include "suite.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { AT_MAX = 8 };

static Simulation *simulate(const Settings *settings)
{
    Status status = {0};
    Simulation *sim = problem_simulate(settings, 1, &status);
    ck_assert_msg(sim != NULL, "%s", status.text);
    return sim;
}

static int series_of(const Simulation *sim, const char *name)
{
    for (int i = 0; i < sim->n_series; i++)
        if (strcmp(sim->series[i].name, name) == 0)
            return i;
    ck_abort_msg("no column %s", name);
    return -1;
}

static const char *key_of(const Settings *settings)
{
    return settings->problem == &problem_bodies ? "mpm.body_mistake"
           : settings->method == METHOD_MPM     ? "mpm.mistake"
                                                : "pd.mistake";
}

/* --- digits ----------------------------------------------------------------------------------------- */

typedef struct Case {
    char name[40];
    Settings settings;
    int n_at;
    long at[AT_MAX];
} Case;

/* One line of a mistake: its column after the steps of the case, to a share of the largest so far; beyond
 * 1e150 squares are no numbers. */
static void compare(const Case *now, const char *mistake, const char *column, const char *numbers,
                    double *worst)
{
    Settings settings = now->settings;
    const bool bar = settings.problem == &problem_bar;
    const double share = bar && now->settings.method == METHOD_MPM ? 1e-11 : 1e-9;
    if (strcmp(mistake, "right") != 0)
        set(&settings, key_of(&settings), mistake);
    Simulation *sim = simulate(&settings);
    double largest = DBL_MIN; /* some begin with zeros */
    Status status = {0};
    const int column_at = series_of(sim, column);
    for (int i = 0; i < now->n_at; i++) {
        char *end;
        const double expected = strtod(numbers, &end);
        if (end == numbers)
            break;
        numbers = end;
        if (!(fabs(expected) < 1e150))
            break;
        largest = fmax(largest, fabs(expected));
        ck_assert_msg(simulation_steps(sim, now->at[i] - sim->step, NULL, NULL, &status), "%s %s: %s",
                      now->name, mistake, status.text);
        double row[COLUMNS_MAX];
        simulation_row(sim, row);
        const double off = fabs(row[column_at] - expected) / largest;
        *worst = fmax(*worst, off / share);
        ck_assert_msg(off <= share,
                      "%s %s: %s after step %ld is %.17g, not %.17g (off by %.2g of the largest)", now->name,
                      mistake, column, now->at[i], row[column_at], expected, off);
    }
    simulation_destroy(sim);
}

START_TEST(digits_are_those_of_codes_that_are_wrong_in_one_place)
{
    FILE *file = fopen(source_path("tests/golden/mistakes.txt"), "r");
    ck_assert_ptr_nonnull(file);
    static Case now;
    char line[800], key[40], value[64];
    int runs = 0, read = 0;
    double worst = 0;
    while (fgets(line, sizeof line, file)) {
        if (sscanf(line, "case %39s", now.name) == 1) {
            settings_default(&now.settings, strncmp(now.name, "bar", 3) == 0      ? &problem_bar
                                            : strncmp(now.name, "bodies", 6) == 0 ? &problem_bodies
                                                                                  : &problem_supported_beam);
            now.n_at = 0;
        } else if (sscanf(line, "set %39s %63[^\n]", key, value) == 2) {
            set(&now.settings, key, value);
        } else if (strncmp(line, "steps", 5) == 0) {
            for (char *at = line + 5, *end; now.n_at < AT_MAX; at = end) {
                now.at[now.n_at] = strtol(at, &end, 10);
                if (end == at)
                    break;
                now.n_at++;
            }
            ck_assert_int_eq(now.n_at, AT_MAX);
        } else if (sscanf(line, "mistake %39s %63s %n", key, value, &read) == 2) {
            compare(&now, key, value, line + read, &worst);
            runs += strcmp(value, "kinetic") != 0;
        }
    }
    fclose(file);
    ck_assert_int_eq(runs, 378);
    ck_assert_double_gt(worst, 0);
}
END_TEST

/* --- bars, then beams ------------------------------------------------------------------------------- */

static int count_words(const char *const *words)
{
    int n = 0;
    while (words[n + 1])
        n++;
    return n;
}

static Settings wrong_bar(int mistake)
{
    Settings settings = bar_settings(3, 100);
    set(&settings, "bar.length", "12");
    set(&settings, "mesh.cell_size", "0.5");
    set(&settings, "mesh.particles_per_cell", "3");
    set(&settings, "load.traction", "0.01");
    set(&settings, "mpm.mistake", mpm_mistake_words[mistake]);
    /* by the first scheme that it is defined for */
    for (int scheme = 0; !settings_check(&settings, NULL); scheme++) {
        static const char *const algorithms[] = {"usf", "musl"}, *const shapes[] = {"hat", "gimp"};
        ck_assert_int_lt(scheme, 8);
        set(&settings, "mpm.algorithm", algorithms[scheme % 2]);
        set(&settings, "mpm.shape", shapes[scheme / 2 % 2]);
        set(&settings, "mpm.transfer", scheme < 4 ? "flip" : "apic");
    }
    return settings;
}

static Settings wrong_beam(int mistake)
{
    Settings settings = beam_settings(&problem_supported_beam, 1e-3);
    set(&settings, "beam.length", "0.05");
    set(&settings, "pd.mistake", beam_mistake_words[mistake]);
    return settings;
}

/* The bar by bonds. */
static Settings wrong_rod(int mistake)
{
    Settings settings = bar_settings(3, 100);
    set(&settings, "scenario.method", "pd");
    set(&settings, "load.traction", "0.01");
    set(&settings, "pd.mistake", beam_mistake_words[mistake]);
    return settings;
}

/* Those that a line has, by the number of the beam's. */
static int rod_mistakes(int out[])
{
    int count = 0;
    for (int i = 1; beam_mistake_words[i]; i++) {
        const Settings settings = wrong_rod(i);
        if (settings_check(&settings, NULL))
            out[count++] = i;
    }
    return count;
}

enum { OF_BAR, OF_BEAM, OF_ROD, MOST = 64 };

/* The mistakes of all three, one after the other: whose it is, and which. */
static int whose(int i, int *mistake)
{
    const int bars = count_words(mpm_mistake_words), beams = count_words(beam_mistake_words);
    int rods[MOST];
    const int of_line = rod_mistakes(rods), rod = i - bars - beams;
    const bool of_bar = i < bars, of_beam = !of_bar && rod < 0;
    ck_assert_int_lt(rod, of_line);
    *mistake = of_bar ? i + 1 : of_beam ? i - bars + 1 : rods[rod];
    return of_bar ? OF_BAR : of_beam ? OF_BEAM : OF_ROD;
}

static const char *id_of(int i)
{
    int mistake;
    return (whose(i, &mistake) == OF_BAR ? mpm_mistake_words : beam_mistake_words)[mistake];
}

static bool is_of_start(int i)
{
    int mistake;
    return (whose(i, &mistake) == OF_BAR ? mpm_mistake_is_of_start : beam_mistake_is_of_start)(mistake);
}

static Settings wrong(int i)
{
    static Settings (*const makers[])(int) = {wrong_bar, wrong_beam, wrong_rod};
    int mistake;
    const int of = whose(i, &mistake);
    return makers[of](mistake);
}

static Settings right_of(int i)
{
    Settings settings = wrong(i);
    set(&settings, key_of(&settings), "none");
    return settings;
}

/* In pieces of three cells, in whole steps, and from a snapshot in the middle: one way. */
START_TEST(bits_do_not_depend_on_how_it_is_run)
{
    const Settings settings = wrong(_i);
    Simulation *whole = simulate(&settings), *pieces = simulate(&settings), *other = simulate(&settings);
    Status status = {0};
    double row[32];
    ck_assert(simulation_steps(whole, 70, NULL, NULL, &status));
    while (pieces->step < 70) {
        bool done;
        ck_assert(simulation_slice(pieces, 3, &done, &status));
        if (pieces->item == 0 && pieces->step == 20 && pieces->stage == 4) {
            size_t size;
            unsigned char *bytes = state_of(pieces, &size);
            simulation_restore(other, bytes);
            free(bytes);
        }
        if (pieces->stage == 0 && pieces->item == 0)
            simulation_row(pieces, row); /* whoever looks leaves no trace */
    }
    expect_same_states(whole, pieces, id_of(_i));
    ck_assert(simulation_steps(other, 69 - other->step, NULL, NULL, &status)); /* and the one begun */
    expect_same_states(whole, other, id_of(_i));
    simulation_destroy(whole);
    simulation_destroy(pieces);
    simulation_destroy(other);
}
END_TEST

/* Within three steps, on a bar whose cells are not 1, nor its particles one in each. */
START_TEST(each_differs_from_the_right_code)
{
    Settings settings = wrong(_i), other_settings = right_of(_i);
    if (strcmp(id_of(_i), "cells_kept") == 0) { /* seen as soon as one is left */
        set(&settings, "initial.velocity", "10");
        set(&other_settings, "initial.velocity", "10");
    }
    if (settings.problem ==
        &problem_supported_beam) { /* the energy correction calibrates the micromodulus away */
        set(&settings, "pd.surface_correction", "volume");
        set(&other_settings, "pd.surface_correction", "volume");
    }
    if (strcmp(id_of(_i), "weight_by_thickness") == 0) {
        set(&settings, "load.body_force", "-9.81");
        set(&other_settings, "load.body_force", "-9.81");
    }
    Simulation *off_track = simulate(&settings), *right = simulate(&other_settings);
    double one[32], other[32], off = 0;
    Status status = {0};
    ck_assert(simulation_steps(off_track, 3, NULL, NULL, &status) &&
              simulation_steps(right, 3, NULL, NULL, &status));
    simulation_row(off_track, one);
    simulation_row(right, other);
    for (int k = 0; k < off_track->n_series; k++)
        off = fmax(off, fabs(one[k] - other[k]) / fmax(fabs(other[k]), 1e-6));
    ck_assert_msg(off > 1e-11, "%s: %.2g", id_of(_i), off);
    simulation_destroy(off_track);
    simulation_destroy(right);
}
END_TEST

/* Also where a particle has come to another cell, whose nodes are others. */
START_TEST(weights_are_those_of_the_new_place)
{
    Settings settings = bar_settings(1, 10);
    set(&settings, "initial.velocity", "2");
    set(&settings, "mpm.mistake", "moved_weights");
    Simulation *sim = simulate(&settings);
    const int v = simulation_find_field(sim, 0, "v"), x = simulation_find_field(sim, 0, "x");
    const int a = simulation_find_field(sim, 1, "acceleration"),
              update = simulation_find_stage(sim, "update");
    const size_t n = sim->counts[0], nodes = sim->counts[1];
    double before[64], after[64], at[64], where[64], kick[64];
    Status status = {0};
    int crossed = 0;
    ck_assert(n <= 64 && nodes <= 64 && v >= 0 && x >= 0 && a >= 0 && update >= 0);
    for (long step = 0; step < 40; step++) {
        while (sim->stage < update)
            ck_assert(simulation_stage(sim, &status));
        sim->method->field(sim, v, 0, n, before);
        sim->method->field(sim, x, 0, n, where);
        sim->method->field(sim, a, 0, nodes, kick);
        ck_assert(simulation_stage(sim, &status));
        sim->method->field(sim, v, 0, n, after);
        sim->method->field(sim, x, 0, n, at);
        for (size_t p = 0; p < n; p++) {
            const int cell = (int)floor(at[p]); /* cells of 1, from the held end on */
            const double s = at[p] - cell, gain = sim->dt * ((1 - s) * kick[cell] + s * kick[cell + 1]);
            ck_assert_double_eq_tol(after[p], before[p] + gain, 1e-12);
            crossed += floor(where[p]) != cell;
        }
        ck_assert(simulation_steps(sim, 0, NULL, NULL, &status));
    }
    ck_assert_int_gt(crossed, 10);
    simulation_destroy(sim);
}
END_TEST

START_TEST(what_they_are_not_defined_for_is_refused_by_name)
{
    static const char *const others[][4] = {
        /* NULL: any; those of APIC are refused with other masses by the transfer's own check */
        {NULL, "mpm.transfer", "fmpm", NULL},
        {NULL, "bar2.joint", "6", "bar2.joint = 0"},
        {"fix_at_end", "mpm.algorithm", "usl", "mpm.algorithm = usf"},
        {"old_stress_new_start", "mpm.algorithm", "musl", "mpm.algorithm = usf"},
        {"no_second_fix", "mpm.algorithm", "usl", "mpm.algorithm = musl"},
        {"cells_kept", "mpm.shape", "gimp", "mpm.shape = hat"},
        {"gimp_whole_length", "mpm.shape", "hat", "mpm.shape = gimp"},
        {"gimp_whole_length", "mesh.particles_per_cell", "1", "mesh.particles_per_cell of 2 or more"},
        {"moved_weights", "mpm.transfer", "apic", "mpm.transfer = flip"},
        {"plain_kinetic", "mpm.transfer", "flip", "mpm.transfer = apic"},
        {"force_sign", "mpm.mass_blend", "0.5", "mpm.mass_blend = 1"},
    };
    const char *const id = mpm_mistake_words[_i + 1];
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        Settings settings = wrong_bar(_i + 1);
        Status status = {0};
        char expected[160];
        if (others[i][0] && strcmp(others[i][0], id) != 0)
            continue;
        set(&settings, "load.traction", "0");
        set(&settings, others[i][1], others[i][2]);
        ck_assert(!settings_check(&settings, &status));
        snprintf(expected, sizeof expected, "mpm.mistake: %s is defined for ", id);
        ck_assert_msg(strncmp(status.text, expected, strlen(expected)) == 0, "%s", status.text);
        snprintf(expected, sizeof expected, "%s only", others[i][3] ? others[i][3] : "");
        ck_assert_msg(strstr(status.text, expected) != NULL, "%s", status.text);
    }
}
END_TEST

static int count_of(const char *text, const char *mark)
{
    int n = 0;
    for (text = strstr(text, mark); text; text = strstr(text + strlen(mark), mark))
        n++;
    return n;
}

static int count_marks(const Simulation *sim)
{
    int n = 0;
    for (int i = 0; i < sim->n_stages; i++)
        n += count_of(sim->stages[i].equation, STAGE_WRONG_OPEN);
    return n;
}

/* The same bits by several threads, of the bonds too. */
START_TEST(threads_leave_no_trace)
{
    const Settings settings = wrong_beam(_i + 1);
    Status status = {0};
    Simulation *one = problem_simulate(&settings, 1, &status),
               *three = problem_simulate(&settings, 3, &status);
    ck_assert(simulation_steps(one, 5, NULL, NULL, &status) &&
              simulation_steps(three, 5, NULL, NULL, &status));
    expect_same_states(one, three, beam_mistake_words[_i + 1]);
    simulation_destroy(one);
    simulation_destroy(three);
}
END_TEST

START_TEST(what_a_beams_are_not_defined_for_is_refused_by_name)
{
    static const char *const others[][3] = {{"pd.influence", "conical", "pd.influence = constant"},
                                            {"pd.critical_stretch", "0.01", "pd.critical_stretch = 0"},
                                            {"damping.rate", "100", "damping.rate = 0"}};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        Settings settings = wrong_beam(_i + 1);
        Status status = {0};
        char expected[160];
        set(&settings, others[i][0], others[i][1]);
        ck_assert(!settings_check(&settings, &status));
        snprintf(expected, sizeof expected, "pd.mistake: %s is defined for %s only",
                 beam_mistake_words[_i + 1], others[i][2]);
        ck_assert_str_eq(status.text, expected);
    }
    const Settings settings = wrong_beam(_i + 1);
    Status status = {0};
    Simulation *sim = simulate(&settings);
    ck_assert(!sim->method->change(sim, "pd.critical_stretch", 0.01, &status));
    ck_assert(strstr(status.text, "pd.mistake") != NULL);
    simulation_destroy(sim);
}
END_TEST

/* Of half kicks where there are none, and of a first kick that nothing comes before. */
START_TEST(a_stepping_may_have_no_such_place)
{
    static const char *const rows[][3] = {{"euler_forward", "euler", "verlet"},
                                          {"no_second_kick", "leapfrog_ahead", "verlet"},
                                          {"no_first_force", "euler_position", "verlet, euler or leapfrog"}};
    Settings settings = beam_settings(&problem_supported_beam, 1e-3);
    Status status = {0};
    char expected[160];
    set(&settings, "pd.mistake", rows[_i][0]);
    ck_assert(settings_check(&settings, &status));
    set(&settings, "pd.stepping", rows[_i][1]);
    ck_assert(!settings_check(&settings, &status));
    snprintf(expected, sizeof expected, "pd.mistake: %s is defined for pd.stepping = %s only", rows[_i][0],
             rows[_i][2]);
    ck_assert_str_eq(status.text, expected);
}
END_TEST

/* From the start on, or on the way; and back. */
START_TEST(those_of_the_start_begin_the_run_anew)
{
    const Settings right = right_of(_i), faulty = wrong(_i);
    const char *key = key_of(&faulty);
    const double value = settings_number(&faulty, parameter_find(key));
    const bool of_start = is_of_start(_i);
    Status status = {0};
    Experiment *experiment = open_experiment(&right, 1 << 24);
    experiment_seek(experiment, 10, 0);
    finish_work(experiment);
    ck_assert_msg(experiment_edit(experiment, &faulty, &status), "%s", status.text);
    ck_assert_int_eq(experiment_settings(experiment)->n_changes, of_start ? 0 : 1);
    experiment_seek(experiment, 20, 0);
    finish_work(experiment);
    Simulation *sim = simulate(of_start ? &faulty : &right);
    ck_assert(simulation_steps(sim, 10, NULL, NULL, &status));
    ck_assert(of_start || sim->method->change(sim, key, value, &status));
    if (!of_start)
        simulation_report(sim, EVENT_CHANGE, "");
    ck_assert(simulation_steps(sim, 10, NULL, NULL, &status));
    expect_same_states(sim, experiment_simulation(experiment), id_of(_i));
    /* and back: the scheme is the right one again */
    ck_assert(sim->method->change(sim, key, 0, &status) == !of_start);
    ck_assert(of_start || count_marks(sim) == 0);
    ck_assert(!of_start || !sim->method->change(sim, key, 0, &status));
    Settings back = *experiment_settings(experiment);
    set(&back, key, "none");
    ck_assert_msg(experiment_edit(experiment, &back, &status), "%s", status.text);
    ck_assert_int_eq(experiment_settings(experiment)->n_changes, of_start ? 0 : 2);
    simulation_destroy(sim);
    experiment_destroy(experiment);
    Settings later = right;
    later.n_changes = 1;
    later.changes[0] = (Change){.step = 5, .to = {.key = ""}};
    snprintf(later.changes[0].to.key, KEY_MAX, "%s", key);
    snprintf(later.changes[0].to.value, VALUE_MAX, "%s", id_of(_i));
    ck_assert(settings_check(&later, &status) == !of_start);
}
END_TEST

/* --- what is shown ---------------------------------------------------------------------------------- */

/* The stage that a mistake is in shows what differs, once or more, and in both spellings alike. */
static void expect_marks(const Simulation *sim, const char *id)
{
    int marked = 0;
    for (int i = 0; i < sim->n_stages; i++) {
        const Stage *stage = &sim->stages[i];
        char equation[512];
        text_to_ascii(stage->equation, equation, sizeof equation);
        const int open = count_of(stage->equation, STAGE_WRONG_OPEN);
        ck_assert_int_eq(open, count_of(stage->equation, STAGE_WRONG_CLOSE));
        ck_assert_int_eq(open, count_of(equation, STAGE_WRONG_OPEN_ASCII));
        ck_assert_int_eq(open, count_of(equation, STAGE_WRONG_CLOSE_ASCII));
        ck_assert_int_eq(open > 0, strcmp(stage->source, id) == 0);
        marked += open;
        for (const char *line = stage->equation; open > 0 && *line;
             line += strcspn(line, "\n"), line += *line == '\n') {
            int columns = 0;
            for (const char *c = line; *c && *c != '\n'; c++)
                columns += ((unsigned char)*c & 0xc0) != 0x80;
            ck_assert_msg(columns <= 76, "%s: %d columns", id, columns);
        }
        for (const char *c = equation; *c; c++)
            ck_assert_msg((unsigned char)*c < 128, "%s: %s", id, equation);
    }
    ck_assert_msg(marked > 0, "%s is marked nowhere", id);
}

START_TEST(the_stage_shows_what_differs)
{
    const Settings settings = wrong(_i);
    Simulation *sim = simulate(&settings);
    expect_marks(sim, id_of(_i));
    simulation_destroy(sim);
}
END_TEST

/* --- who is told ------------------------------------------------------------------------------------ */

START_TEST(who_needs_the_right_code_refuses_it)
{
    Settings settings = wrong_bar(3);
    Status status = {0};
    FitResult result;
    const FitTask task = {.settings = &settings};
    ck_assert(!fit_solve(&task, &result, &status));
    ck_assert_str_eq(status.text, "mpm.mistake: mass_of_cell is a mistake, and a fit is of the right code");
    /* also where it comes later */
    settings = wrong_bar(0);
    ck_assert(settings_refuse_mistake(&settings, "", &status));
    settings.n_changes = 1;
    settings.changes[0] = (Change){3, {"mpm.mistake", "force_sign"}};
    ck_assert(!settings_refuse_mistake(&settings, "", &status));
    ck_assert_str_eq(settings_mistake(&settings), "force_sign");
    settings.changes[0] = (Change){3, {"mpm.mistake", "none"}};
    ck_assert(settings_mistake(&settings) == NULL);
}
END_TEST

static void read_summary(const Settings *settings, char text[SUMMARY_MAX], double *predicted)
{
    Experiment *experiment = open_experiment(settings, 1 << 26);
    static RunSummary summary;
    experiment_seek(experiment, experiment_last_step(experiment), 0);
    finish_work(experiment);
    summary_of(experiment, &summary);
    summary_text(&summary, settings, text);
    *predicted = summary.readout.predicted_known ? summary.readout.predicted : NAN;
    experiment_destroy(experiment);
}

/* Wherever a number is printed; and the prediction is that of the right code. */
START_TEST(a_summary_says_so)
{
    Settings bar = bar_settings(5, 100), beam = wrong_beam(2);
    set(&beam, "pd.surface_correction", "none");
    Settings *const bodies[] = {&bar, &beam};
    static const char *const mistakes[] = {"volume_kept", "micromodulus_plane_strain"};
    for (int i = 0; i < 2; i++) {
        char right[SUMMARY_MAX], wrong_one[SUMMARY_MAX];
        double of_right, of_wrong;
        set(bodies[i], key_of(bodies[i]), "none");
        read_summary(bodies[i], right, &of_right);
        set(bodies[i], key_of(bodies[i]), mistakes[i]);
        read_summary(bodies[i], wrong_one, &of_wrong);
        ck_assert(strstr(right, "mistake") == NULL && strstr(right, "right code") == NULL);
        ck_assert_msg(count_of(wrong_one, "with a mistake") >= 4, "%s", wrong_one);
        ck_assert_msg(strstr(wrong_one, mistakes[i]) && strstr(wrong_one, "predicted (right code)"), "%s",
                      wrong_one);
        ck_assert(isfinite(of_right) && of_right == of_wrong);
    }
}
END_TEST

/* Concealed it is the same mistake: the same bits, the stages as the right code has them, and "?" wherever it
 * is told; a file has it. */
START_TEST(a_concealed_one_is_made_and_not_told)
{
    const Settings told = wrong(_i);
    Settings hidden = told;
    const Parameter *row = parameter_find(key_of(&hidden));
    char value[LIST_MAX], text[LIST_MAX];
    snprintf(value, sizeof value, "?%s", id_of(_i));
    set(&hidden, row->key, value);
    ck_assert_str_eq(settings_mistake(&hidden), "?");
    settings_show(&hidden, row, text);
    ck_assert_str_eq(text, "?");
    settings_get(&hidden, row, text); /* as a cipher, which reads back to the same */
    ck_assert(text[0] == '?' && strstr(text, id_of(_i)) == NULL);
    set(&hidden, row->key, text);
    ck_assert_double_eq(settings_number(&hidden, row),
                        settings_number(&told, row)); /* no two share a cipher */
    settings_get(&hidden, row, value);
    ck_assert_str_eq(text, value);
    const Settings right = right_of(_i);
    Simulation *a = simulate(&told), *b = simulate(&hidden), *c = simulate(&right);
    Status status = {0};
    ck_assert(simulation_steps(a, 20, NULL, NULL, &status) && simulation_steps(b, 20, NULL, NULL, &status));
    expect_same_states(a, b, id_of(_i));
    for (int i = 0; i < b->n_stages && i < c->n_stages; i++)
        if (strcmp(b->stages[i].id, c->stages[i].id) == 0)
            ck_assert_str_eq(b->stages[i].equation, c->stages[i].equation);
    simulation_destroy(a);
    simulation_destroy(b);
    simulation_destroy(c);
    ck_assert(settings_nudge(&hidden, row, 1, false, NULL)); /* its neighbours would tell it */
    ck_assert_ptr_null(settings_mistake(&hidden));
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *digits = tcase_create("digits"), *bar = tcase_create("each");
    const int n = count_words(mpm_mistake_words), m = count_words(beam_mistake_words);
    int rods[MOST];
    const int of_line = rod_mistakes(rods), all = n + m + of_line;
    ck_assert_int_eq(of_line, 17);
    tcase_set_timeout(digits, 300);
    tcase_add_test(digits, digits_are_those_of_codes_that_are_wrong_in_one_place);
    tcase_add_loop_test(bar, bits_do_not_depend_on_how_it_is_run, 0, all);
    tcase_add_loop_test(bar, each_differs_from_the_right_code, 0, all);
    tcase_add_test(bar, weights_are_those_of_the_new_place);
    tcase_add_loop_test(bar, what_they_are_not_defined_for_is_refused_by_name, 0, n);
    tcase_add_loop_test(bar, those_of_the_start_begin_the_run_anew, 0, all);
    tcase_add_loop_test(bar, the_stage_shows_what_differs, 0, all);
    tcase_add_loop_test(bar, threads_leave_no_trace, 0, m);
    tcase_add_loop_test(bar, what_a_beams_are_not_defined_for_is_refused_by_name, 0, m);
    tcase_add_loop_test(bar, a_stepping_may_have_no_such_place, 0, 3);
    TCase *told = tcase_create("told");
    tcase_add_loop_test(told, a_concealed_one_is_made_and_not_told, 0, all);
    tcase_add_test(told, who_needs_the_right_code_refuses_it);
    tcase_add_test(told, a_summary_says_so);
    suite_add_tcase(suite, told);
    suite_add_tcase(suite, digits);
    suite_add_tcase(suite, bar);
}
