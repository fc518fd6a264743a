/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows of a plate: what is read, what is refused and how that is said, what is written reads back to the last
 * bit, and how settings compare that have other rows. */
#include "scenario/parameters.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_output.h"
#include "scenario/settings.h"
#include "scenario/rows/rows.h"
#include "scenario/scenario.h"
#include "run/lab_case.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool read_rows(const char *lines, Settings *settings, Status *status)
{
    char text[2000];
    snprintf(text, sizeof text, "[scenario]\nproblem = plate\n%s", lines);
    FILE *stream = fmemopen(text, strlen(text), "r");
    const bool read = scenario_read(stream, "f.ini", settings, status);
    fclose(stream);
    return read;
}

static Settings rows_of(const char *lines)
{
    Settings settings;
    Status status;
    ck_assert_msg(read_rows(lines, &settings, &status), "%s", status.text);
    return settings;
}

static void expect_row(const Settings *settings, int kind, int row, const char *text)
{
    char line[ROW_TEXT_MAX];
    ck_assert_int_lt(row, settings->rows[kind].count);
    settings_row_get(settings, kind, row, line);
    ck_assert_str_eq(line, text);
}

static double value_of(const Settings *settings, int kind, int column)
{
    return settings_row_value(settings, kind, 0, column);
}

START_TEST(a_row_is_read_and_written_back)
{
    const Settings s =
        rows_of("[cuts]\nnotch = 0 50% 5cm 20 mm\n2 = 100/3mm (1+1)*3mm 0.1 25 %\n"
                "[loads]\ntop = top 0% 100% 0 12 MPa ramp 1us until 2e-5\n"
                "left_1 = left 10% 90 % -1e6 .5kN/mm^2\n"
                "[supports]\nimpact = 0 0 1mm 4cm ux 16.5\nfoot-2 = 99mm 0 100mm 1mm uy 0 ux 0\n"
                "[impulses]\ni = 0 0 20mm 20mm 1 -2\n[protected]\np = 0 95% 100% 100%\n"
                "[probe]\ny = 1mm\n");
    expect_row(&s, ROWS_CUTS, 0, "0 50% 0.05 0.02");
    ck_assert_str_eq(s.rows[ROWS_CUTS].rows[1].name, "2");
    expect_row(&s, ROWS_CUTS, 1, "0.03333333333333333 0.006 0.1 25%");
    expect_row(&s, ROWS_LOADS, 0, "top 0% 100% 0 12000000 ramp 1e-6 until 2e-5");
    expect_row(&s, ROWS_LOADS, 1, "left 10% 90% -1000000 500000000");
    expect_row(&s, ROWS_SUPPORTS, 0, "0 0 0.001 0.04 ux 16.5");
    expect_row(&s, ROWS_SUPPORTS, 1, "0.099 0 0.1 0.001 ux 0 uy 0");
    expect_row(&s, ROWS_IMPULSES, 0, "0 0 0.02 0.02 1 -2");
    expect_row(&s, ROWS_PROTECTED, 0, "0 95% 100% 100%");
    expect_row(&s, ROWS_PROBE, 0, "50% 0.001");
    /* in metres: a share of the length, of the height, of the edge that is named */
    ck_assert_double_eq(value_of(&s, ROWS_CUTS, 1), 0.02);
    ck_assert_double_eq(value_of(&s, ROWS_PROBE, 0), 0.05);
    ck_assert_double_eq(value_of(&s, ROWS_LOADS, 2), 0.1);
    ck_assert_double_eq_tol(settings_row_value(&s, ROWS_LOADS, 1, 2), 0.036, 1e-16);
    ck_assert_double_eq(settings_row_value(&s, ROWS_LOADS, 1, 5), 0);
    ck_assert(isinf(settings_row_value(&s, ROWS_LOADS, 1, 6)));

    char *text;
    size_t size;
    Status status;
    FILE *stream = open_memstream(&text, &size);
    ck_assert_msg(scenario_write(stream, &s, NULL, &status), "%s", status.text);
    fclose(stream);
    Settings again;
    stream = fmemopen(text, size, "r");
    ck_assert_msg(scenario_read(stream, "g.ini", &again, &status), "%s", status.text);
    fclose(stream);
    ck_assert_msg(memcmp(&s, &again, sizeof s) == 0, "%s", text);
    ck_assert(strstr(text, "[probe]\nx = 50%\ny = 0.001\n"));
    free(text);
}
END_TEST

/* Of another size it is where it was asked for. */
START_TEST(a_share_follows_the_plate)
{
    const Settings s = rows_of("[plate]\nlength = 0.3\n[cuts]\na = 50% 0 50% 25%\n");
    ck_assert_double_eq(value_of(&s, ROWS_CUTS, 0), 0.15);
    ck_assert_double_eq(value_of(&s, ROWS_CUTS, 3), 0.01);
}
END_TEST

static const struct {
    const char *lines, *said;
} refused[] = {
    {"[cuts]\na =\n", "f.ini:4: cuts.a: has no value (X0 Y0 X1 Y1)"},
    {"[cuts]\na = 0 0 1cm\n", "f.ini:4: cuts.a: y1 is missing (X0 Y0 X1 Y1)"},
    {"[cuts]\na = 0 0 1cm 1cm 5\n", "f.ini:4: cuts.a: unexpected 5 (X0 Y0 X1 Y1)"},
    {"[cuts]\na = 0 0 1cx 1cm\n",
     "f.ini:4: cuts.a: x1: 1cx cannot be read: no unit cx here (a place in m, or a share such as 50%)"},
    {"[cuts]\na = 0 0 1s 1cm\n",
     "f.ini:4: cuts.a: x1: 1s is not in m (a place in m, or a share such as 50%)"},
    {"[cuts]\na = 0 0 50%/2 1cm\n",
     "f.ini:4: cuts.a: x1: 50%/2 is not a share (a place in m, or a share such as 50%)"},
    {"[cuts]\na = 0 0 101% 1cm\n", "f.ini:4: cuts.a: x1: 101% is off the plate (0% to 100%)"},
    {"[cuts]\na = 0 -1mm 1cm 1cm\n", "f.ini:4: cuts.a: y0: -1mm is off the plate (0 or more)"},
    {"[cuts]\na = 0 0 20cm 1cm\n", "f.ini:4: cuts.a: x1 = 0.2 is off the plate (0 to plate.length = 0.1)"},
    {"[cuts]\na = 0 0 1cm 0.05\n", "f.ini:4: cuts.a: y1 = 0.05 is off the plate (0 to plate.height = 0.04)"},
    {"[cuts]\na = 0 0 1 1\na = 0 0 1 1\n", "f.ini:5: cuts.a: is given twice (first in line 4)"},
    {"[cuts]\nwith-a-name-that-is-long = 0 0 1 1\n",
     "f.ini:4: cuts.with-a-name-that-is-long: invalid name of a cut (1 to 23 letters, digits, _ and -)"},
    {"[cuts]\na.b = 0 0 1 1\n", "f.ini:4: cuts.a: there is no cut of that name (none at all)"},
    {"[cuts]\na = 0 0 1cm 1cm\na.x9 = 1\n", "f.ini:5: cuts.a.x9: a cut has no such value (x0, y0, x1, y1)"},
    {"[loads]\na = up 0 1 0 0\n", "f.ini:4: loads.a: unknown edge up: top, bottom, left or right"},
    {"[loads]\na = left 0 5cm 0 0\n",
     "f.ini:4: loads.a: to = 0.05 is off the plate (0 to plate.height = 0.04)"},
    {"[loads]\na = top 0 1cm 0\n", "f.ini:4: loads.a: sy is missing (EDGE FROM TO SX SY [ramp T] [until T])"},
    {"[loads]\na = top 0 1cm 0 ramp 1us\n",
     "f.ini:4: loads.a: sy is missing (EDGE FROM TO SX SY [ramp T] [until T])"},
    {"[loads]\na = top 0 1cm 0 1 ramp\n",
     "f.ini:4: loads.a: ramp has no value (EDGE FROM TO SX SY [ramp T] [until T])"},
    {"[loads]\na = top 0 1cm 0 1 ramp 1us ramp 2us\n",
     "f.ini:4: loads.a: ramp is given twice (EDGE FROM TO SX SY [ramp T] [until T])"},
    {"[loads]\na = top 0 1cm 0 1 until 0\n", "f.ini:4: loads.a: until: 0 is not allowed (a time above 0)"},
    {"[loads]\na = top 0 1cm 0 1 until 1m\n", "f.ini:4: loads.a: until: 1m is not in s (in s)"},
    {"[loads]\na = top 0 1cm 0 1 until 1us ramp 2us sx 3 1 2 3 4 5 6\n",
     "f.ini:4: loads.a: has more or longer values than it can have (EDGE FROM TO SX SY [ramp T] [until T])"},
    {"[supports]\na = 0 0 1cm 1cm\n", "f.ini:4: supports.a: gives no velocity (X0 Y0 X1 Y1 [ux V] [uy V])"},
    {"[supports]\na = 0 0 1cm 1cm uz 0\n", "f.ini:4: supports.a: unexpected uz (X0 Y0 X1 Y1 [ux V] [uy V])"},
    {"[supports]\na = 0 0 1cm 1cm ux fast\n", "f.ini:4: supports.a: ux: fast is not a number (in m/s)"},
    {"[impulses]\na = 0 0 1cm 1cm 1e999 0\n", "f.ini:4: impulses.a: vx: 1e999 is not a number (in m/s)"},
    {"[probe]\nz = 1\n", "f.ini:4: probe.z: a probe has no such value (x, y)"},
    {"[probe]\nx = none\n", "f.ini:4: probe: x: none is not a number (a place in m, or a share such as 50%)"},
    {"[plate]\nlength = 0.1\n[probe]\nx = 0.2\n",
     "f.ini:6: probe.x = 0.2 is off the plate (0 to plate.length = 0.1)"},
    {"[loads]\nl = top 0 100% 0 10%\n",
     "f.ini:4: loads.l: sy: 10% is a share, which only a place can be (in Pa)"},
    {"[supports]\ns = 0 0 1mm 100% ux 5%\n",
     "f.ini:4: supports.s: ux: 5% is a share, which only a place can be (in m/s)"},
    {"[probe]\nx = 0.2\n", "f.ini:4: probe.x = 0.2 is off the plate (0 to plate.length = 0.1)"},
    {"[cut]\na = 0 0 1 1\n", "f.ini:3: [cut]: unknown section (did you mean [cuts]?)"},
};

START_TEST(a_damaged_row_is_refused)
{
    Settings settings;
    Status status;
    ck_assert(!read_rows(refused[_i].lines, &settings, &status));
    ck_assert_str_eq(status.text, refused[_i].said);
    ck_assert_int_eq(status.code, STATUS_USAGE);
}
END_TEST

START_TEST(there_are_at_most_sixteen)
{
    Settings s = rows_of("");
    Status status;
    char name[8];
    for (int i = 0; i < ROWS_OF_KIND_MAX; i++) {
        snprintf(name, sizeof name, "c%d", i);
        ck_assert(settings_row_set(&s, ROWS_CUTS, name, "0 0 1mm 1mm", &status));
    }
    ck_assert(!settings_row_set(&s, ROWS_CUTS, "more", "0 0 1mm 1mm", &status));
    ck_assert_str_eq(status.text, "cuts.more: too many cuts (at most 16)");
    /* one that is there is replaced where it stands */
    ck_assert(settings_row_set(&s, ROWS_CUTS, "c3", "0 0 2mm 2mm", &status));
    expect_row(&s, ROWS_CUTS, 3, "0 0 0.002 0.002");
    ck_assert(settings_row_remove(&s, ROWS_CUTS, "c3", &status));
    ck_assert_str_eq(s.rows[ROWS_CUTS].rows[3].name, "c4");
    ck_assert_int_eq(s.rows[ROWS_CUTS].count, ROWS_OF_KIND_MAX - 1);
    ck_assert(!settings_row_remove(&s, ROWS_CUTS, "c3", &status));
    ck_assert(!settings_row_remove(&s, ROWS_PROBE, "", &status));
    ck_assert_str_eq(status.text, "probe: cannot be left out (X Y)");
    ck_assert(!settings_row_set(&s, ROWS_CUTS, "a b", "0 0 1mm 1mm", &status));
    ck_assert(!settings_row_set(&s, ROWS_CUTS, "", "0 0 1mm 1mm", &status));
    /* nothing that acts on a terminal or hides, nothing endless */
    ck_assert(!settings_row_set(&s, ROWS_CUTS, "\033[2J", "0 0 1mm 1mm", &status));
    ck_assert(!settings_row_set(&s, ROWS_CUTS, "a\xe2\x80\xae", "0 0 1mm 1mm", &status));
    ck_assert(!settings_row_set(&s, ROWS_CUTS, "a", "0 0 1mm \033[2J", &status));
    ck_assert(!strchr(status.text, '\033'));
    char text[5000];
    memset(text, '1', sizeof text);
    text[sizeof text - 1] = '\0';
    ck_assert(!settings_row_set(&s, ROWS_CUTS, "a", text, &status));
    ck_assert(!settings_row_set(&s, ROWS_CUTS, text, "0 0 1mm 1mm", &status));
    ck_assert(!settings_row_key_set(&s, text, "0 0 1mm 1mm", &status));
    for (int i = 0; i + 1 < (int)sizeof text; i += 2)
        text[i] = ' ';
    ck_assert(!settings_row_set(&s, ROWS_CUTS, "a", text, &status));
}
END_TEST

START_TEST(rows_and_their_values_are_keys)
{
    Settings s = rows_of("[loads]\ntop = top 0% 100% 0 12MPa\n");
    Status status;
    ck_assert(settings_set(&s, "loads.top.sy", "7 MPa", &status));
    expect_row(&s, ROWS_LOADS, 0, "top 0% 100% 0 7000000");
    ck_assert_double_eq(settings_row_number(&s, "loads.top.sy"), 7e6);
    ck_assert(isnan(settings_row_number(&s, "loads.top")));
    ck_assert(isnan(settings_row_number(&s, "loads.none.sy")));
    ck_assert(settings_set(&s, "loads.top.ramp", "1us", &status));
    expect_row(&s, ROWS_LOADS, 0, "top 0% 100% 0 7000000 ramp 1e-6");
    ck_assert(!settings_set(&s, "loads.top.ramp", "-1us", &status));
    ck_assert(settings_set(&s, "supports.left", "0 0 1mm 100% ux 0", &status));
    static const char *const shown[][2] = {{"loads.top.sy", "7e6"},
                                           {"loads.top.edge", "top"},
                                           {"loads.top.to", "0.1"},
                                           {"loads.top.until", "none"},
                                           {"loads.low.sy", "none"},
                                           {"probe.y", "0.02"},
                                           {"supports.left", "0 0 0.001 100% ux 0"}};
    for (size_t i = 0; i < sizeof shown / sizeof *shown; i++) {
        char text[ROW_TEXT_MAX];
        settings_row_key_show(&s, shown[i][0], text);
        ck_assert_str_eq(text, shown[i][1]);
    }
    ck_assert(settings_set(&s, "loads.top", "none", &status));
    ck_assert_int_eq(s.rows[ROWS_LOADS].count, 0);
    /* other problems have none */
    settings_default(&s, &problem_notched_beam);
    ck_assert(!settings_set(&s, "cuts.a", "0 0 1mm 1mm", &status));
    ck_assert_str_eq(status.text, "cuts.a: problem notched-beam has no [cuts] (a plate has)");
    ck_assert(settings_set(&s, "supports.left", "0.01", &status));
    ck_assert_double_eq(settings_supports(&s)->left, 0.01);
}
END_TEST

/* A whole row, one value, or one of all rows of a section, which keep their balance; in its order. */
START_TEST(a_scenario_asks_about_its_rows)
{
    Settings s = rows_of("[cuts]\nnotch = 0 50% 50% 50%\n[loads]\ntop = top 0% 100% 0 12e6\n"
                         "left = left 0% 100% 3 0\nbottom = bottom 0% 100% 0 -9e6\n"
                         "[pd]\nspacing = 5e-4\nhorizon = 2e-3\n"
                         "[screen]\nask = cuts.notch, loads.sy, pd.horizon, probe.x\n");
    Asked asked[ASKED_MAX];
    char name[64], value[ROW_TEXT_MAX];
    ck_assert_int_eq(settings_asked(&s, asked), 4);
    settings_row_place_show(&s, &asked[0].place, name, value);
    ck_assert_str_eq(name, "cut notch");
    ck_assert_str_eq(value, "0 50% 50% 50%");
    settings_row_place_show(&s, &asked[1].place, name, value);
    ck_assert_str_eq(name, "sy of all loads");
    ck_assert_str_eq(value, "1.2e7 Pa");
    ck_assert_str_eq(asked[2].parameter->key, "pd.horizon");
    settings_row_place_show(&s, &asked[3].place, name, value);
    ck_assert_str_eq(name, "x of probe");
    ck_assert(settings_row_nudge(&s, &asked[1].place, -1, false));
    expect_row(&s, ROWS_LOADS, 0, "top 0% 100% 0 10000000");
    expect_row(&s, ROWS_LOADS, 1, "left 0% 100% 3 0");
    expect_row(&s, ROWS_LOADS, 2, "bottom 0% 100% 0 -7500000");
    ck_assert(settings_row_place_set(&s, &asked[1].place, "6MPa", NULL));
    expect_row(&s, ROWS_LOADS, 2, "bottom 0% 100% 0 -4500000");
    ck_assert(settings_row_nudge(&s, &asked[1].place, 1, true));
    expect_row(&s, ROWS_LOADS, 0, "top 0% 100% 0 6100000");
    ck_assert(settings_row_nudge(&s, &asked[3].place, 1, true)); /* a spacing, and still a share */
    expect_row(&s, ROWS_PROBE, 0, "50.5% 50%");
    ck_assert(settings_row_key_set(&s, "probe.x", "100%", NULL));
    ck_assert(!settings_row_nudge(&s, &asked[3].place, 1, true)); /* off the plate */
    ck_assert(settings_row_key_set(&s, "cuts.notch", "none", NULL));
    ck_assert_str_eq(settings_view(&s)->ask, "loads.sy, pd.horizon, probe.x");
    ck_assert(settings_row_key_set(&s, "loads.sy", "none", NULL) == false);
    ck_assert(settings_row_place_set(&s, &asked[1].place, "0", NULL)); /* nothing left to be scaled */
    ck_assert_int_eq(settings_asked(&s, asked), 2);
}
END_TEST

START_TEST(a_row_that_is_asked_about_is_there)
{
    static const struct {
        const char *ask, *says;
    } wrong[] = {
        {"loads.tpo", "screen.ask: loads.tpo: there is no load of that name (top)"},
        {"loads.tpo.sy", "screen.ask: loads.tpo: there is no load of that name (top)"},
        {"cuts.notch", "screen.ask: cuts.notch: there is no cut of that name (none at all)"},
        {"loads.top.s", "screen.ask: loads.top.s: a load has no such number (from, to, sx, sy, ramp, until)"},
        {"loads.edge", "screen.ask: loads.edge: a load has no such number ("},
        {"probe.z", "screen.ask: probe.z: a probe has no such number (x, y)"},
        {"probe", "screen.ask: probe is not a parameter of problem plate (see: matvib params plate)"},
        {"loads.", "screen.ask: loads: there is no load of that name (top)"},
        {"loads.a-name-that-is-longer-than-any.sy", "screen.ask: loads.a-name-"},
    };
    char text[160];
    Settings settings;
    Status status = {STATUS_DONE, ""};
    snprintf(text, sizeof text, "[loads]\ntop = top 0%% 100%% 0 1e6\n[screen]\nask = %s\n", wrong[_i].ask);
    ck_assert(!read_rows(text, &settings, &status));
    ck_assert_msg(strstr(status.text, wrong[_i].says) != NULL, "%s", status.text);
    ck_assert_int_eq(status.code, STATUS_USAGE);
}
END_TEST

START_TEST(settings_with_other_rows_are_another_run)
{
    const Settings a = rows_of("[loads]\ntop = top 0 100% 0 12MPa\n[cuts]\nn = 0 50% 5cm 50%\n");
    Settings b = a;
    char text[400];
    Status status;
    ck_assert(settings_same(&a, &b));
    ck_assert(settings_row_key_set(&b, "loads.top.sy", "7MPa", &status));
    ck_assert(!settings_same(&a, &b));
    settings_name(&b, &a, text, sizeof text);
    ck_assert_str_eq(text, "load top sy 7e6");
    settings_name_change(&a, &b, text, sizeof text);
    ck_assert_str_eq(text, "load top sy 1.2e7 -> sy 7e6");
    b = a;
    ck_assert(settings_row_remove(&b, ROWS_CUTS, "n", &status));
    ck_assert(settings_row_set(&b, ROWS_CUTS, "m", "0 0 1mm 1mm", &status));
    settings_name_change(&a, &b, text, sizeof text);
    ck_assert_str_eq(text, "cut n 0 50% 0.05 50% -> none, cut m none -> 0 0 0.001 0.001");
    ck_assert(!settings_same(&a, &b));
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *cases = tcase_create("rows");
    tcase_add_test(cases, a_row_is_read_and_written_back);
    tcase_add_test(cases, a_share_follows_the_plate);
    tcase_add_loop_test(cases, a_damaged_row_is_refused, 0, (int)(sizeof refused / sizeof *refused));
    tcase_add_test(cases, there_are_at_most_sixteen);
    tcase_add_test(cases, rows_and_their_values_are_keys);
    tcase_add_test(cases, a_scenario_asks_about_its_rows);
    tcase_add_loop_test(cases, a_row_that_is_asked_about_is_there, 0, 9);
    tcase_add_test(cases, settings_with_other_rows_are_another_run);
    suite_add_tcase(suite, cases);
}
