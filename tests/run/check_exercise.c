/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Exercises: the grammar of what they ask, a student's variants and names, and cells of the table of marks.
 */
#include "export/export.h"
#include "scenario/settings.h"
#include "lessons/exercise.h"
#include "lessons/variant.h"
#include "scenario/scenario.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- expressions ------------------------------------------------------------------------------------ */

/* A run of mode 5 that came to these numbers, beside the same with cells of 2. */
typedef struct HeldRun {
    Settings settings, was_settings;
    RunSummary summary, before;
} HeldRun;

static HeldRun *held(void)
{
    static HeldRun run;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scenario_load("mode5", &run.settings, &status), "%s", status.text);
    run.was_settings = run.settings;
    ck_assert(settings_set(&run.was_settings, "mesh.cell_size", "2.5", &status));
    ck_assert_msg(run_numbers_beforehand(&run.was_settings, &run.before, &status), "%s", status.text);
    ck_assert(run_numbers_beforehand(&run.settings, &run.summary, &status));
    run.summary.readout.error_frequency = -4.5;
    run.summary.readout.measured = 5.5;
    run.summary.readout.measured_known = true;
    run.summary.readout.late = NAN;
    run.summary.time = 100;
    run.summary.energy_measure = ENERGY_NOT_KNOWN;
    return &run;
}

static double value_of(const char *text, ExpressionKind kind)
{
    const HeldRun *run = held();
    Expression expression;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(expression_read(text, kind, &expression, &status), "%s: %s", text, status.text);
    return expression_value(&expression, &(ExpressionRun){&run->settings, &run->summary},
                            &(ExpressionRun){&run->was_settings, &run->before});
}

static const struct {
    const char *text;
    double value;
} sums[] = {{"1", 1},
            {"1 + 2 * 3", 7},
            {"(1 + 2) * 3", 9},
            {"10 - 4 - 3", 3},
            {"8 / 4 / 2", 1},
            {"2 * -3^2 + 4 ^ -1", -17.75},
            {"-2 * -3", 6},
            {"2 - -3", 5},
            {"abs(-3) + abs(1 - 3)", 5},
            {"1e3 - 1.5e-1", 999.85},
            {"4 %", 4},
            {"error", -4.5},
            {"abs(error)", 4.5},
            {"measured", 5.5},
            {"end", 100},
            {"cells", 25},
            {"was cells", 10},
            {"particles/cells", 2},
            {"mesh.cell_size", 1},
            {"was mesh.cell_size - mesh.cell_size", 1.5},
            {"was dt / dt", 2.5},
            {"initial.mode", 5},
            {"late", NAN},
            {"energy_change", NAN},
            {"crack_start", NAN},
            {"beam.density", NAN},
            {"1 / 0 - 1 / 0", NAN}};

START_TEST(a_sum_has_a_value)
{
    const double value = value_of(sums[_i].text, EXPRESSION_NUMBER);
    if (isnan(sums[_i].value))
        ck_assert_msg(isnan(value), "%s is %g", sums[_i].text, value);
    else
        ck_assert_msg(fabs(value - sums[_i].value) < 1e-12, "%s is %.17g", sums[_i].text, value);
}
END_TEST

/* Each word is the number that it says. */
START_TEST(a_word_is_its_number)
{
    static const struct {
        const char *word;
        double value;
    } rows[] = {{"measured", 1},      {"predicted", 2},       {"exact", 3},          {"error", 4},
                {"period_error", 5},  {"predicted_error", 6}, {"late", 7},           {"energy_change", 8},
                {"end", 9},           {"steps", 10},          {"crack_start", 11},   {"crack_angle", 12},
                {"crack_length", 13}, {"crack_speed", 14},    {"crack_cost", 15},    {"broken_bonds", 16},
                {"dt", 17},           {"cells", 18},          {"rayleigh_speed", 19}};
    RunSummary run = {
        .readout = {.measured_known = true,
                    .predicted_known = true,
                    .exact_known = true,
                    .measured = 1,
                    .predicted = 2,
                    .exact = 3,
                    .error_frequency = 4,
                    .error_period = 5,
                    .predicted_error_frequency = 6,
                    .late = 7},
        .energy_measure = ENERGY_PERIOD,
        .energy_change = 8,
        .time = 9,
        .steps = 10,
        .crack_known = true,
        .price_known = true,
        .crack = {.measured = {.first_break = 11, .length = 13, .fastest = 14, .broken = 16}, .angle = 12},
        .price = {.cost = {.total = 30, .area = 2}},
        .n_derived = 3,
        .derived = {{.name = "dt", .value = 17},
                    {.name = "cells", .value = 18},
                    {.name = "rayleigh_speed", .value = 19}}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const RunNumber *number = run_number_find(rows[i].word);
        ck_assert_ptr_nonnull(number);
        ck_assert_msg(number->value(&run, number->word) == rows[i].value, "%s", rows[i].word);
    }
    static const struct {
        const char *word;
        double value;
    } of_plates[] = {{"crack_angle", 20}, {"crack_speed", 21},  {"broken_bonds", 22},
                     {"branch_time", 23}, {"branch_angle", 24}, {"crack_tips", 25}};
    run.crack_known = false;
    run.fronts_known = true;
    run.fronts = (FrontsFacts){.angle = 20,
                               .fastest = 21,
                               .broken = 22,
                               .branch_time = 23,
                               .half_angle = 24,
                               .n_tips = 25,
                               .branched = true};
    for (size_t i = 0; i < sizeof of_plates / sizeof *of_plates; i++)
        ck_assert_msg(run_number_find(of_plates[i].word)->value(&run, "") == of_plates[i].value, "%s",
                      of_plates[i].word);
    run.fronts.branched = false;
    ck_assert(isnan(run_number_find("branch_time")->value(&run, "")));
    /* bonds break without a cut too */
    run.fronts_known = false;
    run.broken_bonds = 26;
    ck_assert(run_number_find("broken_bonds")->value(&run, "") == 26);
    /* without them there is none */
    run = (RunSummary){.readout = {.error_frequency = NAN,
                                   .error_period = NAN,
                                   .predicted_error_frequency = NAN,
                                   .late = NAN},
                       .broken_bonds = NAN};
    for (const RunNumber *number = run_numbers; number->word; number++)
        ck_assert_msg(strcmp(number->word, "end") == 0 || strcmp(number->word, "steps") == 0 ||
                          isnan(number->value(&run, number->word)),
                      "%s", number->word);
}
END_TEST

static const struct {
    const char *text;
    bool holds;
} truths[] = {{"error < 1", true},
              {"0.99999 >= 1", true},
              {"0.9999 >= 1", false},
              {"0.99999 < 1", true},
              {"1.00001 <= 1", true},
              {"1 < 1.00001", true},
              {"0.1 + 0.2 = 0.3", true},
              {"14704 <= 14700", false},
              {"14704 != 14700", true},
              {"abs(error) < 1", false},
              {"abs(error) < 5 % and cells <= 60", true},
              {"cells <= 24", false},
              {"cells >= 25", true},
              {"cells > 25", false},
              {"cells < 25", false},
              {"cells = 25", true},
              {"cells != 25", false},
              {"dt >= was dt", false},
              {"dt <= was dt", true},
              {"mpm.algorithm = usf", true},
              {"mpm.algorithm = usl", false},
              {"mpm.algorithm != usl", true},
              {"was mesh.cell_size = 2.5", true},
              {"cells = 1 or cells = 25", true},
              {"cells = 25 or cells = 1 and cells = 1", true}, /* and binds closer */
              {"cells = 1 and cells = 1 or cells = 25", true},
              {"cells = 1 or cells = 25 and cells = 1", false},
              {"(cells = 25 or cells = 1) and cells = 1", false},
              {"1 < 2 and (1 < 2 or 2 < 1) and 2 < 3", true},
              {"(cells = 1 and cells = 1) or cells = 25", true},
              {"(error + 5) * 2 = 1", true},
              {"((cells = 25))", true},
              /* what is not known fulfils nothing */
              {"late < 1", false},
              {"late >= 1", false},
              {"late != 1", false},
              {"energy_change > -20", false},
              {"time.step = 1 or time.step != 1", false}};

START_TEST(a_goal_holds_or_not)
{
    ck_assert_msg((value_of(truths[_i].text, EXPRESSION_TRUTH) != 0) == truths[_i].holds, "%s",
                  truths[_i].text);
}
END_TEST

static const struct {
    const char *text, *says;
    ExpressionKind kind;
} wrong[] = {
    {"", "a number is expected, not: the end of the line", EXPRESSION_NUMBER},
    {"1 +", "a number is expected, not: the end of the line", EXPRESSION_NUMBER},
    {"1 2", "+ - * / is expected, not: 2", EXPRESSION_NUMBER},
    {"1 < 2", "+ - * / is expected, not: <", EXPRESSION_NUMBER},
    {"(1", ") is expected, not: the end of the line", EXPRESSION_NUMBER},
    {"abs 1", "( after abs is expected, not: 1", EXPRESSION_NUMBER},
    {"1.2.3", "a number is expected, not: 1.2.3", EXPRESSION_NUMBER},
    {"$", "a number is expected, not: $", EXPRESSION_NUMBER},
    {"was 3", "a parameter or a word of the mesh after was is expected, not: 3", EXPRESSION_NUMBER},
    {"was error",
     "was error: is known of a run that has ended only (was is for parameters, mesh and time step)",
     EXPRESSION_NUMBER},
    {"errors", "errors is neither a number of a run nor a parameter (see: man 5 matvib)", EXPRESSION_NUMBER},
    {"initial.overtones", "initial.overtones is not a number", EXPRESSION_NUMBER},
    {"error", "a relation (< <= > >= = !=) is expected, not: the end of the line", EXPRESSION_TRUTH},
    {"error < 1 and", "a number is expected, not: the end of the line", EXPRESSION_TRUTH},
    {"error < 1 but cells < 3", "and, or is expected, not: but", EXPRESSION_TRUTH},
    {"error < 1 < 2", "and, or is expected, not: <", EXPRESSION_TRUTH},
    {"(1 < 2) + 1 < 3", "a number is expected, not a relation", EXPRESSION_TRUTH},
    {"1 + (1 < 2) > 1", "a number is expected, not a relation", EXPRESSION_TRUTH},
    {"(1 < 2)", "a number is expected, not a relation", EXPRESSION_NUMBER},
    {"1 < 2 and 3", "a relation (< <= > >= = !=) is expected, not: the end of the line", EXPRESSION_TRUTH},
    {"1 < 2 or 3", "a relation (< <= > >= = !=) is expected, not: the end of the line", EXPRESSION_TRUTH},
    {"mpm.algorithm = usx", "mpm.algorithm is compared with one of its choices (usf | usl | musl)",
     EXPRESSION_TRUTH},
    {"mpm.algorithm < usf", "= or != is expected, not: <", EXPRESSION_TRUTH},
    {"1<2 and 1<2 and 1<2 and 1<2 and 1<2 and 1<2 and 1<2 and 1<2 and 1<2",
     "asks for too much (at most 8 things)", EXPRESSION_TRUTH},
    {"1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1",
     "is too long (at most 96 numbers and signs)", EXPRESSION_NUMBER},
    {"((((((((((((((((((((((((((((((((1))))))))))))))))))))))))))))))))",
     "has too many brackets in each other (at most 20)", EXPRESSION_NUMBER},
    {"--------------------------------1", "has too many brackets in each other (at most 20)",
     EXPRESSION_NUMBER},
};

START_TEST(what_is_no_expression_is_told)
{
    Expression expression;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(!expression_read(wrong[_i].text, wrong[_i].kind, &expression, &status), "%s",
                  wrong[_i].text);
    ck_assert_str_eq(status.text, wrong[_i].says);
    ck_assert_int_eq(status.code, STATUS_USAGE);
}
END_TEST

START_TEST(an_endless_one_is_refused)
{
    char text[4 * EXPRESSION_MAX];
    Expression expression;
    Status status = {STATUS_DONE, ""};
    memset(text, '1', sizeof text - 1);
    text[sizeof text - 1] = '\0';
    ck_assert(!expression_read(text, EXPRESSION_NUMBER, &expression, &status));
    ck_assert_str_eq(status.text, "is too long (at most 239 bytes)");
}
END_TEST

/* The first thing that is missing is told with what it is. */
START_TEST(why_a_goal_is_missed_is_told)
{
    const HeldRun *run = held();
    const ExpressionRun now = {&run->settings, &run->summary}, was = {&run->was_settings, &run->before};
    Exercise exercise;
    char why[ANSWER_MAX];
    Status status = {STATUS_DONE, ""};
    ck_assert(exercise_read_goal("cells <= 60 and abs(error) < 1 % and cells <= 20", &exercise, &status));
    ck_assert(exercise_failing(&exercise, &now, &was, why, sizeof why));
    ck_assert_str_eq(why, "error 4.5 %, must be within 1 %; cells 25, must be at most 20. Met: cells");
    ck_assert(exercise_read_goal("mpm.algorithm = usl", &exercise, &status));
    ck_assert(exercise_failing(&exercise, &now, &was, why, sizeof why));
    ck_assert_str_eq(why, "algorithm usf, must be usl");
    ck_assert(exercise_read_goal("late < 1", &exercise, &status));
    ck_assert(exercise_failing(&exercise, &now, &was, why, sizeof why));
    ck_assert_str_eq(why, "late is not known, must be below 1");
    ck_assert(exercise_read_goal("cells <= 60", &exercise, &status));
    ck_assert(!exercise_failing(&exercise, &now, &was, why, sizeof why));
}
END_TEST

/* A cell of 25/55 and a Courant number of .22: dt is 0.01 but for its last bit. */
START_TEST(numbers_are_compared_as_they_are_told)
{
    HeldRun run = *held();
    const ExpressionRun now = {&run.settings, &run.summary}, was = {&run.was_settings, &run.before};
    Exercise exercise;
    char why[ANSWER_MAX];
    Status status = {STATUS_DONE, ""};
    ck_assert(exercise_read_goal("dt >= was dt and cells <= 60", &exercise, &status));
    for (int i = 0; i < run.before.n_derived; i++)
        if (strcmp(run.before.derived[i].name, "dt") == 0)
            run.before.derived[i].value = 0.01;
    ck_assert(settings_set(&run.settings, "mesh.cell_size", "0.45454545454545453", &status));
    ck_assert(settings_set(&run.settings, "time.courant", "0.22", &status));
    ck_assert(run_numbers_beforehand(&run.settings, &run.summary, &status));
    ck_assert(!exercise_failing(&exercise, &now, &was, why, sizeof why));
    ck_assert(settings_set(&run.settings, "time.courant", "0.219998", &status));
    ck_assert(run_numbers_beforehand(&run.settings, &run.summary, &status));
    ck_assert(!exercise_failing(&exercise, &now, &was, why, sizeof why));
    ck_assert(settings_set(&run.settings, "time.courant", "0.2199", &status));
    ck_assert(run_numbers_beforehand(&run.settings, &run.summary, &status));
    ck_assert(exercise_failing(&exercise, &now, &was, why, sizeof why));
    ck_assert_str_eq(why, "time step 0.009995, must be at least 0.01 (Courant 0.22). Met: cells");
}
END_TEST

/* Without a run, on paper. */
START_TEST(a_goal_is_told_in_words)
{
    Exercise exercise;
    char text[ANSWER_MAX];
    Status status = {STATUS_DONE, ""};
    ck_assert(
        exercise_read_goal("abs(error) < 1 % and cells <= 60 and dt >= was dt and mpm.algorithm = usl and "
                           "late < 2 * was mesh.cell_size",
                           &exercise, &status));
    exercise_tell_goal(&exercise, NULL, text, sizeof text);
    ck_assert_str_eq(text,
                     "error within 1 %; cells at most 60; time step at least as the page opens it; algorithm "
                     "usl; late below 2 * was mesh.cell_size");
}
END_TEST

/* --- answers ---------------------------------------------------------------------------------------- */

START_TEST(an_answer_is_near_enough_or_not)
{
    Exercise exercise;
    Status status = {STATUS_DONE, ""};
    ck_assert(exercise_read_answer("error within 2 %", &exercise, &status));
    ck_assert(exercise_accepts(&exercise, -100, -102));
    ck_assert(!exercise_accepts(&exercise, -100, -102.01));
    ck_assert(!exercise_accepts(&exercise, -100, 100));
    ck_assert(!exercise_accepts(&exercise, NAN, 0));
    ck_assert(exercise_read_answer("error within 0.1", &exercise, &status));
    ck_assert(exercise_accepts(&exercise, 0.9, 1));
    ck_assert(exercise_accepts(&exercise, 0, -0.1));
    ck_assert(!exercise_accepts(&exercise, 0, 0.11));
}
END_TEST

START_TEST(a_number_is_read_as_it_is_written)
{
    static const struct {
        const char *text;
        double number;
    } rows[] = {{"1.5", 1.5}, {" -4,25 ", -4.25},     {"4 %", 4},           {"1e-3", 1e-3},
                {"+2", 2},    {"100/17", 100.0 / 17}, {"-1,5 / 3 %", -0.5}, {"\u22122,5", -2.5}};
    double number;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        ck_assert_msg(exercise_read_number(rows[i].text, &number), "%s", rows[i].text);
        ck_assert_double_eq(number, rows[i].number);
    }
    static const char *const none[] = {"",    "%",   "four", "1.000,5", "1,2,3", "nan",    "inf",
                                       "1 2", "1/0", "/2",   "1/",      "1/2/3", "\u2212", "\u2212-1"};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        ck_assert_msg(!exercise_read_number(none[i], &number), "%s", none[i]);
}
END_TEST

/* --- variants --------------------------------------------------------------------------------------- */

static void draw(const char *text, const char *student, char out[NUMBER_TEXT_MAX])
{
    Variant variant;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(variant_read(text, &variant, &status), "%s", status.text);
    variant_draw(&variant, "A lesson", student, out);
}

/* The same on every machine: these are written down. */
START_TEST(a_name_has_its_values)
{
    static const struct {
        const char *text, *student, *value;
    } rows[] = {{"initial.mode from 3 to 12", "Ada Lovelace", "10"},
                {"initial.mode from 3 to 12", "Emmy Noether", "11"},
                {"initial.mode from 3 to 12", "", "7"},
                {"time.courant from 0.06 to 0.16", "Ada Lovelace", "0.075"},
                {"time.courant from 0.06 to 0.16", "Sof\xc3\xad\x61", "0.065"},
                {"beam.youngs_modulus from 60e9 to 90e9", "Ada Lovelace", "6.2e10"},
                {"initial.amplitude from -1e-6 to 1e-6", "Emmy Noether", "3e-7"}};
    char value[NUMBER_TEXT_MAX];
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        draw(rows[i].text, rows[i].student, value);
        ck_assert_str_eq(value, rows[i].value);
    }
}
END_TEST

static const struct {
    const char *text;
    double from, to;
    int least; /* different values among 400 names */
    size_t longest;
} ranges[] = {{"initial.mode from 3 to 12", 3, 12, 10, 2},
              {"initial.mode from 1 to 2", 1, 2, 2, 1},
              {"time.courant from 0.06 to 0.16", 0.06, 0.16, 20, 5},
              {"bar.density from 0.333 to 7.77", 0.333, 7.77, 17, 3},
              {"beam.youngs_modulus from 60e9 to 90e9", 60e9, 90e9, 17, 6},
              {"load.stress from 50e6 to 70e6", 50e6, 70e6, 17, 8},
              {"time.end from 100 to 100.0001", 100, 100.0001, 17, 10},
              {"initial.amplitude from -1e-6 to 1e-6", -1e-6, 1e-6, 17, 7}};

/* Spread over the range, within it, in few digits. */
START_TEST(values_lie_in_their_range)
{
    enum { NAMES = 400 };
    static char values[NAMES][NUMBER_TEXT_MAX];
    int different = 0;
    for (int i = 0; i < NAMES; i++) {
        char name[16];
        bool seen = false;
        snprintf(name, sizeof name, "student %d", i);
        draw(ranges[_i].text, name, values[i]);
        const double value = strtod(values[i], NULL);
        ck_assert_msg(value >= ranges[_i].from && value <= ranges[_i].to, "%s: %s", ranges[_i].text,
                      values[i]);
        ck_assert_msg(strlen(values[i]) <= ranges[_i].longest, "%s: %s", ranges[_i].text, values[i]);
        for (int k = 0; k < i && !seen; k++)
            seen = strcmp(values[k], values[i]) == 0;
        different += !seen;
    }
    ck_assert_msg(different >= ranges[_i].least && different <= 50, "%s: %d values", ranges[_i].text,
                  different);
}
END_TEST

START_TEST(a_lesson_has_its_own_values)
{
    Variant variant;
    Status status = {STATUS_DONE, ""};
    ck_assert(variant_read("bar.density from 1 to 2", &variant, &status));
    int other = 0;
    for (int i = 0; i < 20; i++) {
        char name[16], one[NUMBER_TEXT_MAX], two[NUMBER_TEXT_MAX];
        snprintf(name, sizeof name, "%d", i);
        variant_draw(&variant, "One", name, one);
        variant_draw(&variant, "Two", name, two);
        other += strcmp(one, two) != 0;
    }
    ck_assert_int_ge(other, 15);
}
END_TEST

START_TEST(a_name_is_part_of_a_files_name)
{
    char word[16];
    static const struct {
        const char *name, *word;
    } cases[] = {{"Ada Lovelace", "Ada-Lovelace"},
                 {"../../etc/passwd", "etc-passwd"},
                 {"-rf *", "rf"},
                 {" .. ", ""},
                 {"a.b--c_1", "a-b-c-1"},
                 {"", ""},
                 {"Twenty letters and more", "Twenty-letters"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        variant_file_word(cases[i].name, word, sizeof word);
        ck_assert_str_eq(word, cases[i].word);
    }
#ifdef HAVE_UTF8PROC
    variant_file_word("Zo\xc3\xab \xe6\x9d\x8e\xe2\x88\x95x", word, sizeof word); /* U+2215: a slash */
    ck_assert_str_eq(word, "Zo\xc3\xab-\xe6\x9d\x8e-x");
#endif
}
END_TEST

START_TEST(a_name_is_a_name)
{
    char name[STUDENT_MAX];
    Status status = {STATUS_DONE, ""};
    ck_assert(variant_student("  Ada   Lovelace ", name, &status));
    ck_assert_str_eq(name, "Ada Lovelace");
    ck_assert(
        variant_student("Ada\xc2\xa0Lovelace \xe3\x80\x80\xe2\x80\x89", name, &status)); /* other blanks */
    ck_assert_str_eq(name, "Ada Lovelace");
    ck_assert(variant_student("Zo\xc3\xab", name, &status));
    ck_assert_str_eq(name, "Zo\xc3\xab");
    const bool composed = variant_student("Zoe\xcc\x88", name, &status); /* e and two dots, as a Mac has it */
#ifdef HAVE_UTF8PROC
    ck_assert(composed);
    ck_assert_str_eq(name, "Zo\xc3\xab");
#else
    ck_assert(!composed && strstr(status.text, "an accent is a character of its own"));
#endif
    ck_assert(variant_student("\xd0\xa1\xd0\xbe\xd1\x84\xd1\x8c\xd1\x8f", name, &status));
    ck_assert(!variant_student("   ", name, &status));
    ck_assert_str_eq(status.text, "the name is empty");
    status = (Status){STATUS_DONE, ""};
    ck_assert(!variant_student("a\nb", name, &status));
    ck_assert(!variant_student("\x1b[2J", name, &status));
    ck_assert(!variant_student("a\xe2\x80\xae"
                               "b",
                               name, &status)); /* turns the direction of writing */
    ck_assert(!variant_student("\xff", name, &status));
    char longest[70];
    memset(longest, 'x', sizeof longest);
    longest[60] = '\0';
    ck_assert(variant_student(longest, name, &status));
    longest[60] = 'x';
    longest[61] = '\0';
    ck_assert(!variant_student(longest, name, &status));
}
END_TEST

/* --- the table -------------------------------------------------------------------------------------- */

START_TEST(no_cell_is_a_formula)
{
    static const char *const cells[] = {"=1+1",  "+x", "-x",  "@x",  "-4.5", "a,b",
                                        "\"q\"", "",   "1.5", "\tx", "a=b"};
    char *text = NULL;
    size_t size = 0;
    for (int dialect = 0; dialect < 2; dialect++) {
        FILE *stream = open_memstream(&text, &size);
        csv_words(stream, dialect ? DIALECT_SEMICOLON : DIALECT_COMMA, cells, sizeof cells / sizeof *cells);
        fclose(stream);
        ck_assert_str_eq(text, dialect ? "'=1+1;'+x;'-x;'@x;-4,5;\"a,b\";\"\"\"q\"\"\";;1,5;'\tx;a=b\n"
                                       : "'=1+1,'+x,'-x,'@x,-4.5,\"a,b\",\"\"\"q\"\"\",,1.5,'\tx,a=b\n");
        free(text);
    }
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *expressions = tcase_create("expressions"), *answers = tcase_create("answers");
    TCase *variants = tcase_create("variants");
    tcase_add_loop_test(expressions, a_sum_has_a_value, 0, (int)(sizeof sums / sizeof *sums));
    tcase_add_test(expressions, a_word_is_its_number);
    tcase_add_loop_test(expressions, a_goal_holds_or_not, 0, (int)(sizeof truths / sizeof *truths));
    tcase_add_loop_test(expressions, what_is_no_expression_is_told, 0, (int)(sizeof wrong / sizeof *wrong));
    tcase_add_test(expressions, an_endless_one_is_refused);
    tcase_add_test(expressions, why_a_goal_is_missed_is_told);
    tcase_add_test(expressions, numbers_are_compared_as_they_are_told);
    tcase_add_test(expressions, a_goal_is_told_in_words);
    tcase_add_test(answers, an_answer_is_near_enough_or_not);
    tcase_add_test(answers, a_number_is_read_as_it_is_written);
    tcase_add_test(answers, no_cell_is_a_formula);
    tcase_add_test(variants, a_name_has_its_values);
    tcase_add_loop_test(variants, values_lie_in_their_range, 0, (int)(sizeof ranges / sizeof *ranges));
    tcase_add_test(variants, a_lesson_has_its_own_values);
    tcase_add_test(variants, a_name_is_a_name);
    tcase_add_test(variants, a_name_is_part_of_a_files_name);
    suite_add_tcase(suite, expressions);
    suite_add_tcase(suite, answers);
    suite_add_tcase(suite, variants);
}
