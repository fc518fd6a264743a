/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parameter table: rows that fit the screen, values that survive the way through text, nudges. */
#include "answers/beam_answers.h"
#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_time.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_output.h"
#include "scenario/settings.h"
#include "methods/mpm/mpm.h"
#include "methods/default_defs.h"
#include "scenario/parameters.h"
#include "base/text.h"
#include "base/visible.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { N_PROBLEMS = 4 };

static Settings set_of(const Problem *problem)
{
    Settings settings;
    settings_default(&settings, problem);
    return settings;
}

static void set(Settings *settings, const char *key, const char *text)
{
    Status status;
    ck_assert_msg(settings_set(settings, key, text, &status), "%s", status.text);
}

static void expect(const Settings *settings, const char *key, const char *text)
{
    char value[LIST_MAX];
    settings_get(settings, parameter_find(key), value);
    ck_assert_str_eq(value, text);
}

static void expect_refused(const Settings *settings, const char *key, const char *text, const char *message)
{
    Settings copy = *settings;
    Status status;
    ck_assert_msg(!settings_set(&copy, key, text, &status), "%s = %s was taken", key, text);
    ck_assert_str_eq(status.text, message);
    ck_assert_int_eq(status.code, STATUS_USAGE);
    ck_assert_msg(memcmp(&copy, settings, sizeof copy) == 0, "%s changed something", key);
}

START_TEST(rows_fit_the_screen)
{
    for (int i = 0; i < n_parameters; i++) {
        const Parameter *row = &parameters[i];
        ck_assert_msg(strchr(row->key, '.') && strlen(row->key) < KEY_MAX, "%s", row->key);
        ck_assert_msg(*row->help && strlen(row->help) <= 90, "help of %s: %zu", row->key, strlen(row->help));
        if (row->concern == CONCERN_NONE) {
            ck_assert(row->type == PARAMETER_TEXT && row->size > 0 && !row->label);
            ck_assert(parameter_text_find(row->key) == row && !parameter_find(row->key));
            continue;
        }
        ck_assert_msg(strlen(row->label) <= 15 && *row->label, "label of %s", row->key);
        ck_assert_msg(row->choices || row->nudge != NUDGE_NEXT, "%s", row->key);
        ck_assert_ptr_eq(parameter_find(row->key), row);
        bool of_any = false;
        for (int p = 0; problems[p]; p++)
            of_any |= parameter_applies(row, problems[p]);
        ck_assert_msg(of_any, "%s", row->key);
    }
}
END_TEST

/* The table and the engines must not drift apart. */
START_TEST(defaults_are_those_of_the_engines)
{
    Settings bar = set_of(&problem_bar);
    MpmDef engine = bar_default();
    ck_assert(settings_geometry(&bar)->length == engine.length &&
              settings_time(&bar)->courant == engine.courant);
    ck_assert_int_eq(settings_mesh(&bar)->padding, engine.padding);
    ck_assert_int_eq(settings_mesh(&bar)->particles_per_cell, engine.particles_per_cell);
    static const BeamProblem engines[] = {BEAM_SIMPLY_SUPPORTED, BEAM_MOVING_CANTILEVER, BEAM_NOTCHED};
    for (int p = 1; problems[p] && problems[p]->concerns & CONCERN_BEAM; p++) {
        Settings settings = set_of(problems[p]);
        BeamDef def = beam_default(engines[p - 1]);
        const BeamDef beam = beam_definition(&settings, 1), *got = &beam;
        ck_assert(got->length == def.length && got->height == def.height && got->thickness == def.thickness);
        ck_assert(got->youngs_modulus == def.youngs_modulus && got->density == def.density);
        ck_assert(got->horizon == def.horizon && got->spacing == def.spacing);
        ck_assert(got->critical_stretch == def.critical_stretch && got->dt == def.dt);
        ck_assert(got->protected_depth == def.protected_depth && got->amplitude == def.amplitude);
        ck_assert(got->speed == def.speed && got->channel == def.channel &&
                  got->load_stress == def.load_stress);
        ck_assert(got->notch_depth == def.notch_depth && got->load_width == def.load_width);
        ck_assert(got->support_left == def.support_left && got->support_right == def.support_right);
        ck_assert(settings_time(&settings)->end == def.end);
    }
}
END_TEST

START_TEST(defaults_are_sound)
{
    Settings settings = set_of(problems[_i]);
    Status status;
    ck_assert_msg(settings_check(&settings, &status), "%s", status.text);
}
END_TEST

START_TEST(values_read_back)
{
    Settings from = set_of(problems[_i]), to = from;
    for (int i = 0; i < n_parameters; i++) {
        const Parameter *row = &parameters[i];
        if (!parameter_applies(row, problems[_i]) || strcmp(row->key, "pd.critical_energy") == 0 ||
            strcmp(row->key, "scenario.method") == 0)
            continue;
        /* what only the other method reads is read by that one */
        if (!parameter_applies_to(&from, row)) {
            ck_assert(problems[_i]->concerns & CONCERN_METHODS);
            from.method = to.method = from.method == METHOD_PD ? METHOD_MPM : METHOD_PD;
        } else if (problems[_i] == &problem_bar) {
            from.method = to.method = row->methods == BY_PD ? METHOD_PD : METHOD_MPM;
        }
        char value[LIST_MAX];
        settings_get(&from, row, value);
        set(&to, row->key, value);
    }
    ck_assert(memcmp(&from, &to, sizeof from) == 0);
    set(&from, "time.end", "0.123456789012345678");
    expect(&from, "time.end", "0.12345678901234568");
    char shown[LIST_MAX];
    settings_show(&from, parameter_find("time.end"), shown);
    ck_assert_str_eq(shown, "0.123457");
}
END_TEST

START_TEST(wrong_values_are_refused)
{
    Settings bar = set_of(&problem_bar), notched = set_of(&problem_notched_beam);
    expect_refused(&bar, "mesh.cell_size", "abc", "mesh.cell_size: abc is not a number (> 0)");
    expect_refused(&bar, "mesh.cell_size", "0", "mesh.cell_size: 0 is out of range (> 0)");
    expect_refused(&bar, "mesh.cell_size", "", "mesh.cell_size: has no value (> 0)");
    expect_refused(&bar, "mesh.cell_size", "nan", "mesh.cell_size: nan is not a number (> 0)");
    expect_refused(&bar, "mesh.cell_size", "1,5", "mesh.cell_size: 1,5 is not a number (> 0)");
    expect_refused(&bar, "mesh.particles_per_cell", "9",
                   "mesh.particles_per_cell: 9 is out of range (1 to 8)");
    expect_refused(&bar, "mesh.particles_per_cell", "2.5",
                   "mesh.particles_per_cell: 2.5 is not a whole number (1 to 8)");
    expect_refused(&bar, "mpm.algorithm", "usx", "mpm.algorithm: usx is not a choice (usf | usl | musl)");
    expect_refused(&bar, "mesh.cellsize", "1", "mesh.cellsize: unknown key (did you mean mesh.cell_size?)");
    expect_refused(&bar, "cell_size", "1", "cell_size: unknown key (did you mean mesh.cell_size?)");
    expect_refused(&bar, "bar.cell_size", "1", "bar.cell_size: unknown key (did you mean mesh.cell_size?)");
    expect_refused(&bar, "zebra", "1", "zebra: unknown key (see: matvib params bar)");
    expect_refused(&bar, "notch.depth", "1",
                   "notch.depth: is not a parameter of problem bar (only of notched-beam)");
    expect_refused(&bar, "scenario.problem", "bar",
                   "scenario.problem: cannot be changed (choose another scenario)");
    expect_refused(&bar, "scenario.title", "two\nlines",
                   "scenario.title: has characters that cannot be kept (one line of UTF-8)");
    expect_refused(&notched, "supports.pinned", "true", "supports.pinned: true is not a choice (no | yes)");
    expect_refused(&notched, "load.traction_layer", "auto",
                   "load.traction_layer: is not a parameter of problem notched-beam (only of bar)");
    expect_refused(&notched, "time.step", "-1", "time.step: -1 is out of range (auto | > 0)");
}
END_TEST

static void expect_unsound(const Settings *settings, const char *message)
{
    Status status;
    ck_assert_msg(!settings_check(settings, &status), "allowed; expected %s", message);
    ck_assert_msg(strncmp(status.text, message, strlen(message)) == 0, "%s\nexpected %s", status.text,
                  message);
}

START_TEST(the_whole_is_checked)
{
    static const struct {
        const Problem *problem;
        const char *key, *value, *message;
    } cases[] = {
        {&problem_bar, "mesh.cell_size", "0.7", "mesh.cell_size: the length 25"},
        {&problem_bar, "initial.mode", "0", "initial.mode: 0 is rigid motion"},
        {&problem_bar, "initial.mode", "51", "initial.mode: 51 is finer"},
        {&problem_bar, "initial.overtones", "1:0.1", "initial.overtones: mode 1 is initial.mode"},
        {&problem_bar, "initial.overtones", "3:0.1,3:0.2", "initial.overtones: mode 3 is given twice"},
        {&problem_bar, "initial.overtones", "3", "initial.overtones: \"3\" cannot be read"},
        {&problem_bar, "initial.overtones", "3:0.1,", "initial.overtones: ends in a comma"},
        {&problem_bar, "load.traction_layer", "26", "load.traction_layer: 26 is out of range"},
        {&problem_bar, "output.at", "1,x", "output.at: \"x\" is not a time"},
        {&problem_bar, "output.at", "2,1", "output.at: 1 does not come after 2"},
        {&problem_bar, "output.at", "101", "output.at: 101 is after the end"},
        {&problem_bar, "time.end", "1e40", "time.end: 1e+40 takes"},
        {&problem_bar, "question.key", "bar.length", "question.key: bar.length cannot be toggled"},
        {&problem_supported_beam, "pd.horizon", "1e-4", "pd.horizon: 0.0001 is below the spacing"},
        {&problem_moving_cantilever, "time.end", "6e-3", "motion.channel: 0.055 is too short"},
        {&problem_notched_beam, "notch.position", "0.3", "notch.position: 0.3 is outside the beam"},
        {&problem_notched_beam, "notch.depth", "0.08", "notch.depth: 0.08"},
        {&problem_notched_beam, "load.position", "0.21", "load.position: the load from"},
        {&problem_notched_beam, "supports.right", "0.22", "supports.right: 0.22 is off the beam"},
        {&problem_notched_beam, "supports.left", "0.205", "supports.left: 0.205"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Settings settings = set_of(cases[i].problem);
        set(&settings, cases[i].key, cases[i].value);
        expect_unsound(&settings, cases[i].message);
    }
    Settings free_bar = set_of(&problem_bar);
    set(&free_bar, "initial.mode", "0");
    set(&free_bar, "bar.supports", "free-free");
    ck_assert(settings_check(&free_bar, NULL));
}
END_TEST

static void expect_nudge(Settings *settings, const char *key, int direction, const char *value)
{
    ck_assert_msg(settings_nudge(settings, parameter_find(key), direction, false, NULL), "%s %+d: nothing",
                  key, direction);
    expect(settings, key, value);
    ck_assert(settings_check(settings, NULL));
}

static const struct {
    const char *problem, *words, *key; /* "": several; NULL: nothing is called so */
} meanings[] = {
    {"bar", "mesh.cell_size", "mesh.cell_size"},
    {"bar", "cell_size", "mesh.cell_size"},
    {"bar", "size", "mesh.cell_size"},
    {"bar", "Cell Size", "mesh.cell_size"},
    {"bar", "particles/cell", "mesh.particles_per_cell"},
    {"bar", "Young's modulus", "bar.youngs_modulus"},
    {"bar", "length", "bar.length"},
    {"bar", "window", "view.window"},
    {"bar", "ize", NULL},
    {"bar", "", NULL},
    {"bar", "spacing", NULL}, /* of peridynamics */
    {"simply-supported-beam", "length", "beam.length"},
    {"simply-supported-beam", "spacing", "pd.spacing"},
    {"notched-beam", "notch.position", "notch.position"},
    {"notched-beam", "position", ""},
    {"notched-beam", "load position", "load.position"},
};

START_TEST(keys_are_meant_by_end_and_label)
{
    Settings settings;
    char key[KEY_MAX] = "";
    Status status = {STATUS_DONE, ""};
    const char *wanted = meanings[_i].key;
    settings_default(&settings, problem_find(meanings[_i].problem));
    const bool one = settings_resolve_key(&settings, meanings[_i].words, key, &status);
    ck_assert_int_eq(one, !wanted || *wanted);
    if (one)
        ck_assert_str_eq(key, wanted ? wanted : meanings[_i].words);
    else
        ck_assert_str_eq(status.text, "position: which one? (notch.position, load.position)");
}
END_TEST

static void expect_fine(Settings *settings, const char *key, int direction, const char *value)
{
    ck_assert_msg(settings_nudge(settings, parameter_find(key), direction, true, NULL), "%s %+d: nothing",
                  key, direction);
    expect(settings, key, value);
}

START_TEST(fine_nudges_take_a_little_more)
{
    Settings bar, beam;
    settings_default(&bar, problem_find("bar"));
    settings_default(&beam, problem_find("notched-beam"));
    expect_fine(&bar, "bar.youngs_modulus", -1, "99");
    expect_fine(&bar, "bar.youngs_modulus", 1, "100");
    expect_fine(&bar, "bar.youngs_modulus", 1, "110");
    expect_fine(&bar, "mpm.flip_fraction", -1, "0.999");
    expect_fine(&bar, "mpm.flip_fraction", -1, "0.998");
    expect_fine(&bar, "initial.velocity", 1, "0.11");
    expect_fine(&bar, "initial.mode", 1, "2");
    expect_fine(&bar, "bar.length", 1, "26");
    expect_fine(&bar, "mesh.cell_size", -1, "0.9629629629629629"); /* 27 cells */
    expect_fine(&bar, "load.body_force", -1, "-0.001");
    expect_fine(&bar, "load.body_force", -1, "-0.0011");
    expect_fine(&bar, "load.body_force", 1, "-0.001");
    expect_fine(&bar, "load.body_force", 1, "0");
    expect_fine(&bar, "mpm.algorithm", 1, "usl");
    expect_fine(&beam, "notch.position", 1, "0.0655");
    expect_fine(&beam, "load.stress", 1, "61000000");
    ck_assert(!settings_nudge(&bar, parameter_find("initial.overtones"), 1, true, NULL));
}
END_TEST

START_TEST(nudges_take_the_next_value)
{
    Settings bar = set_of(&problem_bar), beam = set_of(&problem_notched_beam);
    expect_nudge(&bar, "initial.mode", 1, "2");
    expect_nudge(&bar, "mesh.cell_size", -1, "0.5");
    expect_nudge(&bar, "mesh.cell_size", 1, "1");
    ck_assert(!settings_nudge(&bar, parameter_find("mesh.cell_size"), 1, false, NULL)); /* 12.5 cells */
    expect(&bar, "mesh.cell_size", "1");
    expect_nudge(&bar, "initial.velocity", 1, "0.2");
    expect_nudge(&bar, "initial.velocity", 1, "0.5");
    expect_nudge(&bar, "initial.velocity", 1, "1");
    expect_nudge(&bar, "initial.velocity", -1, "0.5");
    set(&bar, "initial.velocity", "1e-4");
    expect_nudge(&bar, "initial.velocity", -1, "0");
    expect_nudge(&bar, "initial.velocity", -1, "-0.0001");
    expect_nudge(&bar, "initial.velocity", 1, "0");
    expect_nudge(&bar, "load.body_force", 1, "0.001");
    expect_nudge(&bar, "load.traction_layer", 1, "0.5");
    expect_nudge(&bar, "mpm.algorithm", 1, "usl");
    expect_nudge(&bar, "mpm.algorithm", -1, "usf");
    expect_nudge(&bar, "mpm.algorithm", -1, "musl");
    expect_nudge(&bar, "mpm.flip_fraction", -1, "0.999");
    expect_nudge(&bar, "mpm.flip_fraction", 1, "1");
    expect_nudge(&bar, "time.courant", -1, "0.05");
    expect_nudge(&bar, "time.courant", -1, "0.025");
    ck_assert(!settings_nudge(&bar, parameter_find("mpm.flip_fraction"), 1, false, NULL));
    set(&bar, "mesh.particles_per_cell", "8");
    ck_assert(!settings_nudge(&bar, parameter_find("mesh.particles_per_cell"), 1, false, NULL));
    expect_nudge(&bar, "output.every", 1, "2");
    expect_nudge(&bar, "output.frames", 1, "1");
    expect_nudge(&bar, "output.frames", -1, "");
    ck_assert(!settings_nudge(&bar, parameter_find("initial.overtones"), 1, false, NULL));
    expect_nudge(&beam, "load.width", 1, "0.0035");
    expect_nudge(&beam, "notch.position", -1, "0.06");
    expect_nudge(&beam, "supports.pinned", 1, "yes");
    expect_nudge(&beam, "load.stress", 1, "100000000");
    expect_nudge(&beam, "pd.critical_stretch", 1, "0.001");
    ck_assert(!settings_nudge(&beam, parameter_find("mesh.cell_size"), 1, false, NULL));
}
END_TEST

START_TEST(two_handles_on_breaking)
{
    Settings beam = set_of(&problem_notched_beam);
    ck_assert(fabs(settings_bonds(&beam)->critical_energy - 35.68) < 0.005);
    ck_assert(!settings_bonds(&beam)->energy_given);
    set(&beam, "pd.critical_energy", "50");
    ck_assert(settings_bonds(&beam)->energy_given);
    double wanted = sqrt(4 * M_PI * 50 / (9 * 34.48e9 * 2e-3));
    ck_assert(fabs(settings_bonds(&beam)->critical_stretch / wanted - 1) < 1e-14);
    set(&beam, "pd.horizon", "1.5e-3"); /* the handle keeps its value, the other follows */
    ck_assert(fabs(settings_bonds(&beam)->critical_stretch / (wanted * sqrt(2e-3 / 1.5e-3)) - 1) < 1e-14);
    set(&beam, "pd.critical_stretch", "0.001");
    ck_assert(!settings_bonds(&beam)->energy_given &&
              fabs(settings_bonds(&beam)->critical_energy / 50 - 1) > 0.01);
}
END_TEST

START_TEST(differences_are_named)
{
    Settings a = set_of(&problem_bar), b = a;
    char text[60];
    ck_assert(settings_same(&a, &b));
    settings_name(&a, &b, text, sizeof text);
    ck_assert_str_eq(text, "the same");
    set(&b, "output.every", "10");
    set(&b, "scenario.title", "another");
    ck_assert(settings_same(&a, &b));
    set(&b, "mpm.algorithm", "usl");
    set(&b, "initial.mode", "5");
    ck_assert(!settings_same(&a, &b));
    settings_name(&a, &b, text, sizeof text);
    ck_assert_str_eq(text, "mode 1, USF");
    settings_name(&b, &a, text, sizeof text);
    ck_assert_str_eq(text, "mode 5, USL");
    char small[12];
    settings_name(&b, &a, small, sizeof small);
    ck_assert_str_eq(small, "...");
}
END_TEST

START_TEST(lists_are_read)
{
    Overtone overtones[OVERTONES_MAX];
    ck_assert_int_eq(overtones_read("", overtones, NULL), 0);
    ck_assert_int_eq(overtones_read("3:0.03, 7:-0.01", overtones, NULL), 2);
    ck_assert(overtones[1].mode == 7 && overtones[1].velocity == -0.01);
    double times[TIMES_MAX];
    ck_assert_int_eq(settings_times_read("0,1e-4, 2e-4", times, NULL), 3);
    ck_assert(times[2] == 2e-4);
    ck_assert(visible_is_clean("\xc3\xa9 \xe2\x82\xac") && !visible_is_clean("\xc3") &&
              !visible_is_clean("\xc0\xaf"));
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *table = tcase_create("table");
    tcase_add_test(table, rows_fit_the_screen);
    tcase_add_test(table, defaults_are_those_of_the_engines);
    tcase_add_loop_test(table, defaults_are_sound, 0, N_PROBLEMS);
    tcase_add_loop_test(table, values_read_back, 0, N_PROBLEMS);
    suite_add_tcase(suite, table);
    TCase *values = tcase_create("values");
    tcase_add_test(values, wrong_values_are_refused);
    tcase_add_test(values, the_whole_is_checked);
    tcase_add_test(values, nudges_take_the_next_value);
    tcase_add_test(values, fine_nudges_take_a_little_more);
    tcase_add_loop_test(values, keys_are_meant_by_end_and_label, 0, sizeof meanings / sizeof *meanings);
    tcase_add_test(values, two_handles_on_breaking);
    tcase_add_test(values, differences_are_named);
    tcase_add_test(values, lists_are_read);
    suite_add_tcase(suite, values);
}
