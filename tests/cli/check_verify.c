/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What verify says of a number in its two columns, and that it says so with its exit status. */
#include "cli/verify/verify.h"
#include "scenario/settings.h"
#include "suite.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A row whose number is measured, and one beside it. */
static VerifyNumbers beside(double measured, double eigenvalue)
{
    VerifyNumbers numbers = {.own = VERIFY_MEASURED, .beside = VERIFY_EIGENVALUE};
    numbers.values[VERIFY_MEASURED] = measured;
    numbers.values[VERIFY_EIGENVALUE] = eigenvalue;
    return numbers;
}

static Verdict verdict_of(Verdict (*of)(const VerifyRow *, const VerifyNumbers *), const VerifyRow *row,
                          double measured, double eigenvalue)
{
    const VerifyNumbers numbers = beside(measured, eigenvalue);
    return of(row, &numbers);
}

START_TEST(numbers_in_and_out_of_bounds)
{
    const VerifyRow of_reference = {.reference = WITHIN(0.5, 0.25)}, of_bound = {.bound = WITHIN(0.5, 0.25)};
    static const struct {
        double number;
        Verdict verdict;
    } cases[] = {{0.5, VERDICT_GOOD},         {0.25, VERDICT_GOOD},   {0.75, VERDICT_GOOD},
                 {0.2499999, VERDICT_MISSED}, {-0.5, VERDICT_MISSED}, {INFINITY, VERDICT_MISSED},
                 {NAN, VERDICT_MISSED}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const double number = cases[i].number;
        ck_assert_int_eq(verdict_of(verify_reproduces, &of_reference, number, 9), cases[i].verdict);
        ck_assert_int_eq(verdict_of(verify_is_bounded, &of_bound, number, 9), cases[i].verdict);
        /* each says nothing of the other */
        ck_assert_int_eq(verdict_of(verify_reproduces, &of_bound, number, 9), VERDICT_NONE);
        ck_assert_int_eq(verdict_of(verify_is_bounded, &of_reference, number, 9), VERDICT_NONE);
        ck_assert_int_eq(verdict_of(verify_is_near, &of_reference, number, 9), VERDICT_NONE);
    }
    const VerifyRow near = {.tolerance = 0.1};
    ck_assert_int_eq(verdict_of(verify_is_near, &near, 0.5, 0.59), VERDICT_GOOD);
    ck_assert_int_eq(verdict_of(verify_is_near, &near, 0.5, 0.61), VERDICT_MISSED);
    ck_assert_int_eq(verdict_of(verify_is_near, &near, 0.5, NAN), VERDICT_MISSED);
    ck_assert_int_eq(verdict_of(verify_is_near, &near, NAN, 0.5), VERDICT_MISSED);
    ck_assert_int_eq(verdict_of(verify_reproduces, &near, 0.5, 0.61), VERDICT_NONE);
}
END_TEST

static double one(VerifyRun *run, const VerifyRow *row)
{
    (void)run, (void)row;
    return 1;
}

static double two(VerifyRun *run, const VerifyRow *row)
{
    (void)run, (void)row;
    return 2;
}

START_TEST(a_number_stands_in_its_column)
{
    VerifyRun run = {0};
    const VerifyRow theory = {.theory = one}, both = {.quantity = one, .theory = two},
                    three = {.predicted = one, .eigenvalue = two, .theory = one};
    VerifyNumbers numbers = verify_numbers(&run, &theory);
    ck_assert_int_eq(numbers.own, VERIFY_THEORY);
    ck_assert_int_eq(numbers.beside, VERIFY_THEORY);
    ck_assert_double_eq(numbers.values[VERIFY_THEORY], 1);
    ck_assert_double_nan(numbers.values[VERIFY_MEASURED]);
    numbers = verify_numbers(&run, &both);
    ck_assert_int_eq(numbers.own, VERIFY_MEASURED);
    ck_assert_int_eq(numbers.beside, VERIFY_THEORY);
    numbers = verify_numbers(&run, &three);
    ck_assert_int_eq(numbers.own, VERIFY_PREDICTED);
    ck_assert_int_eq(numbers.beside, VERIFY_EIGENVALUE);
    /* without a run there are none, and what they would be is known */
    numbers = verify_numbers(NULL, &both);
    ck_assert_int_eq(numbers.own, VERIFY_MEASURED);
    ck_assert_double_nan(numbers.values[VERIFY_MEASURED]);
}
END_TEST

START_TEST(what_the_paper_says_has_a_verdict_of_its_own)
{
    const Claim silent = {.words = NULL}, printed = PRINTS("90", 90), about = ABOUT("about 5", -5),
                words = CLAIM("longer", 0, INFINITY);
    ck_assert_int_eq(verify_agreement(&silent, 1), PAPER_SILENT);
    ck_assert_int_eq(verify_agreement(&printed, 91), PAPER_AGREES);
    ck_assert_int_eq(verify_agreement(&printed, 82.8), PAPER_NEAR);
    ck_assert_int_eq(verify_agreement(&printed, 73.4), PAPER_DIFFERS);
    ck_assert_int_eq(verify_agreement(&printed, NAN), PAPER_DIFFERS);
    ck_assert_int_eq(verify_agreement(&about, -4.6), PAPER_AGREES);
    ck_assert_int_eq(verify_agreement(&about, -4.239), PAPER_NEAR);
    ck_assert_int_eq(verify_agreement(&about, 4.239), PAPER_DIFFERS);
    ck_assert_int_eq(verify_agreement(&words, 0.1), PAPER_AGREES);
    ck_assert_int_eq(verify_agreement(&words, -0.1), PAPER_DIFFERS);
    ck_assert_int_eq(verify_agreement(&words, NAN), PAPER_DIFFERS);
}
END_TEST

/* What a test wants to read of what is printed. */
typedef struct Capture {
    char *text; /* after the file is closed; the caller frees it */
    size_t size;
    FILE *file;
} Capture;

static void capture_open(Capture *capture)
{
    capture->file = open_memstream(&capture->text, &capture->size);
    ck_assert_ptr_nonnull(capture->file);
}

/* Runs a check of two rows on a quick run, with a reference and a run of its second. */
static int run_rows(Band reference, const char *scenario, char **text, Status *status)
{
    Capture out;
    capture_open(&out);
    const VerifyRow rows[] = {
        {.what = "v_cm at once",
         .scenario = "mode1 time.end=1",
         .quantity = quantity_value_at,
         .column = "v_cm",
         .decimals = 3,
         .reference = WITHIN(0.064, 0.001),
         .paper = PRINTS(".08", 0.08),
         .also = CLAIM("small", 0, 0.5)},
        {.what = "the same",
         .scenario = scenario,
         .quantity = quantity_value_at,
         .column = "v_cm",
         .decimals = 3,
         .reference = reference,
         .paper = PRINTS(".06", 0.06)},
        {.what = "of no reference",
         .scenario = "mode1 time.end=1",
         .quantity = quantity_value_at,
         .theory = quantity_other_at,
         .column = "v_cm",
         .other = "v_cm_exact",
         .decimals = 3,
         .bound = {0, 0.5},
         .tolerance = 1e-3},
        {.what = "late", .quantity = quantity_value_at, .column = "v_cm", .from = 99, .full = true},
    };
    const VerifyCheck check = {"X", "a check", VERIFY_ROWS(rows), "A note."};
    Verify verify = {.out = out.file, .threads = 1};
    *status = (Status){0};
    verify_check_run(&verify, &check, false);
    int result = verify_end(&verify, status);
    fclose(out.file);
    *text = out.text;
    return result;
}

static void expect_text(const char *text, const char *part)
{
    ck_assert_msg(strstr(text, part) != NULL, "\"%s\" is not in \"%s\"", part, text);
}

START_TEST(a_miss_ends_in_status_1_and_what_differs_does_not)
{
    char *text;
    Status status;
    ck_assert_int_eq(run_rows((Band)WITHIN(0.064, 0.001), NULL, &text, &status), 0);
    expect_text(text, "X  a check\n");
    expect_text(text, "  v_cm at once                                                         0.064\n"
                      "    our reference: 0.063..0.065: reproduces\n"
                      "    the paper: \".08\": differs, -20 %\n"
                      "    the paper: \"small\" (taken as 0..0.5): agrees\n");
    expect_text(text, "    the paper: \".06\": near, +6.1 %\n");
    expect_text(text, "  of no reference                     0.064                            0.064\n"
                      "    bound: 0.000..0.500: holds\n"
                      "    off theory by 2.");
    expect_text(text, "e-06 (at most 1.0e-03): holds\n");
    expect_text(text, "  A note.\n");
    /* what has no reference reproduces none */
    expect_text(text, "\nours: 2 of 2 reproduced; 2 of 2 bounds hold\n"
                      "paper: 1 agree, 1 near, 1 differs, 1 not given\n");
    ck_assert_ptr_null(strstr(text, "late"));
    free(text);
    ck_assert_int_eq(run_rows((Band){0.07, 0.08}, NULL, &text, &status), 1);
    ck_assert_int_eq(status.code, STATUS_FAILED);
    ck_assert_str_eq(status.text, "verify: 1 of 4 missed");
    expect_text(text, "0.064\n    our reference: 0.070..0.080: MISSED\n");
    expect_text(text, "\nours: 1 of 2 reproduced;");
    free(text);
    /* a run that cannot be made says why */
    ck_assert_int_eq(run_rows((Band)WITHIN(0.064, 0.001), "mode1 bar.length=-1", &text, &status), 1);
    expect_text(text, "      none\n    our reference: 0.063..0.065: MISSED\n");
    expect_text(text, "\n    --set: bar.length: ");
    free(text);
}
END_TEST

static void expect_reference(int decimals, double low, double high, const char *part)
{
    Capture out;
    capture_open(&out);
    const VerifyRow row = {.what = "x",
                           .scenario = "mode1 time.end=0.01",
                           .quantity = quantity_value_at,
                           .column = "v_cm",
                           .decimals = decimals,
                           .reference = {low, high}};
    const VerifyCheck check = {"X", "a check", &row, 1, NULL};
    Verify verify = {.out = out.file, .threads = 1};
    verify_check_run(&verify, &check, false);
    verify_end(&verify, &(Status){0});
    fclose(out.file);
    expect_text(out.text, part);
    free(out.text);
}

START_TEST(what_is_allowed_is_legible)
{
    expect_reference(1, 2, 3, " 2.0..3.0: ");
    expect_reference(0, 1378, 1378, " 1378: ");
    expect_reference(2, 5, INFINITY, " >= 5.00: ");
    expect_reference(2, -INFINITY, 5, " <= 5.00: ");
    expect_reference(0, 0.25, 0.75, " 0.2..0.8: ");
    expect_reference(6, 63.6630537, 63.6630539, " 63.663054 +- 1e-07: ");
}
END_TEST

/* --- the tables ----------------------------------------------------------------------------------- */

static void expect_sound(const VerifyCheck *check)
{
    ck_assert_msg(check->rows[0].scenario, "%s begins without a run", check->name);
    for (int i = 0; i < check->n_rows; i++) {
        const VerifyRow *row = &check->rows[i];
        Settings settings;
        Status status;
        const VerifyNumbers none = verify_numbers(NULL, row);
        ck_assert_msg(verify_reproduces(row, &none) || verify_is_bounded(row, &none) ||
                          verify_is_near(row, &none),
                      "%s, %s: cannot miss", check->name, row->what);
        ck_assert_msg(row->reference.low <= row->reference.high && row->bound.low <= row->bound.high,
                      "%s, %s", check->name, row->what);
        ck_assert_msg(row->tolerance == 0 || none.own != none.beside, "%s, %s: nothing beside it",
                      check->name, row->what);
        ck_assert_msg(!row->scenario || verify_settings(row->scenario, &settings, &status), "%s, %s: %s",
                      check->name, row->what, status.text);
    }
}

static void each_check(void (*what)(const VerifyCheck *))
{
    for (const VerifyCheck *check = verify_checks; check->name; check++)
        what(check);
}

START_TEST(every_row_can_be_run_and_can_miss)
{
    each_check(expect_sound);
}
END_TEST

/* What the papers say, letter by letter, where verify quotes them. */
static const char *const of_paper_m[] = {
    /* abstract */
    "The results of the first mode of vibration were the same as the analytical solution",
    "being 5% for the fifth mode and 20% to the tenth mode",
    "reduced the phase difference to about 1% for the fifth mode and 5% for the tenth",
    /* section 3 */
    "The two curves overlap, showing great correspondence of the simulation",
    "the curves, although having considerably similar amplitudes, are out of phase",
    "the difference between the analytical and simulation frequencies of approximately 5% of the analytical "
    "value",

    "also showed curves with similar amplitudes, but with an even greater phase offset between them",
    "The difference between the analytical and MPM frequencies reached something around 20%", NULL};
static const char *const of_paper_p[] = {
    /* section 3.1 and table 1 */
    "= 0.86 ms according to Euler-Bernoulli beam theory", "0.98 14", "0.90 4.7", "0.875 1.7", "0.87 1.2",
    "0.88 2.3", "0.865 0.6",
    "considering surface correction factor the peridynamic solution is almost identical to that of classic "
    "continuum "
    "mechanics",
    "leads to a longer vibration period of the beam",
    /* section 3.2 */
    "the peridynamic predictions are in excellent agreement with analytical solution",
    "the tip velocity curve of peridynamics also shows high frequency oscillations",
    "the vibration amplitude of displacement increases gradually while the velocity amplitude decreases",
    /* section 3.3 */
    "58 800 collocation points with a spacing of", "critical stretch of s0= 0.00085",
    "begins to growth at the time of 90", "the crack path initially grows at about 30",
    "then curves towards but does not go to the point of application of load",
    "the crack runs through the whole specimen", NULL};

static void expect_quoted(const char *name, const Claim *claim)
{
    const char *const *paper = *name == 'M' ? of_paper_m : of_paper_p;
    if (!claim->words)
        return;
    while (*paper && !strstr(*paper, claim->words))
        paper++;
    ck_assert_msg(*paper, "%s: the paper does not say \"%s\"", name, claim->words);
}

static void expect_the_papers_words(const VerifyCheck *check)
{
    for (int i = 0; i < check->n_rows; i++) {
        expect_quoted(check->name, &check->rows[i].paper);
        expect_quoted(check->name, &check->rows[i].also);
    }
}

START_TEST(what_is_quoted_stands_in_the_paper)
{
    each_check(expect_the_papers_words);
}
END_TEST

/* verify_main with words separated by spaces; the text that it wrote is the caller's. */
static int verify_words(const char *words, char **text, Status *status)
{
    char copy[200], *arguments[16];
    int count = 0;
    snprintf(copy, sizeof copy, "%s", words);
    for (char *word = strtok(copy, " "); word; word = strtok(NULL, " "))
        arguments[count++] = word;
    Capture out;
    capture_open(&out);
    *status = (Status){0};
    int result = verify_main(count, arguments, out.file, status);
    fclose(out.file);
    *text = out.text;
    return result;
}

START_TEST(bad_words_are_refused)
{
    char *text;
    Status status;
    ck_assert_int_eq(verify_words("M-fig5", &text, &status), 2);
    ck_assert_str_eq(status.text,
                     "verify: unknown name \"M-fig5\" (the nearest is M-fig2; --list shows all)");
    ck_assert_str_eq(text, "");
    free(text);
    ck_assert_int_eq(verify_words("M-fig3 --ful", &text, &status), 2);
    ck_assert_ptr_nonnull(strstr(status.text, "--ful:"));
    free(text);
}
END_TEST

START_TEST(the_list_names_what_the_papers_show)
{
    static const char *const names[] = {"M-fig2",  "M-fig3", "M-fig4",  "M-cell",   "M-particles", "M-dt",
                                        "M-shape", "M-usl",  "P-fig3",  "P-table1", "P-fig4",      "P-fig6",
                                        "P-fig7",  "P-fig9", "P-fig10", "P-bar"};
    char *text;
    Status status;
    ck_assert_int_eq(verify_words("--list", &text, &status), 0);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char line[32];
        snprintf(line, sizeof line, "\n%s ", names[i]);
        ck_assert_msg(strstr(text, line) || strncmp(text, line + 1, strlen(line) - 1) == 0, "no %s",
                      names[i]);
    }
    free(text);
}
END_TEST

static void expect_narrow(const char *text)
{
    while (*text) {
        size_t length = strcspn(text, "\n");
        ck_assert_msg(length <= 80, "%zu columns: %.*s", length, (int)length, text);
        text += length + (text[length] == '\n');
    }
}

/* Runs these and finds no miss, on lines that a terminal can show. The text is the caller's. */
static char *expect_reproduced(const char *words)
{
    char *text;
    Status status;
    ck_assert_msg(verify_words(words, &text, &status) == 0, "%s: %s\n%s", words, status.text, text);
    ck_assert_ptr_null(strstr(text, "MISSED"));
    expect_narrow(text);
    return text;
}

START_TEST(the_bar_is_reproduced)
{
    char *text = expect_reproduced("M-fig2 M-fig3 M-fig4 M-cell M-particles M-dt");
    ck_assert_ptr_nonnull(strstr(text, "M-fig3  mode 5 of the bar"));
    ck_assert_ptr_nonnull(strstr(
        text,
        "ours: 33 of 33 reproduced; 3 of 3 bounds hold\npaper: 7 agree, 3 near, 0 differ, 23 not given\n"));
    ck_assert_ptr_null(strstr(text, "Left out"));
    free(text);
    free(expect_reproduced(suite_wide() ? "M-shape M-usl M-hidden M-crossing M-load"
                                        : "M-shape M-usl M-hidden M-load"));
}
END_TEST

START_TEST(the_bar_by_peridynamics_is_reproduced)
{
    if (suite_wide())
        free(expect_reproduced("P-rest"));
    char *text = expect_reproduced("P-bar");
    ck_assert_ptr_nonnull(strstr(text, "ours: 0 of 0 reproduced; 12 of 12 bounds hold"));
    expect_text(text, "6.2831853  6.1565471             6.1565471\n");
    free(text);
}
END_TEST

/* A beam that is quick, and what was left out of it. */
START_TEST(beams_are_reproduced)
{
    char *text = expect_reproduced("P-step P-surface P-table1");
    ck_assert_ptr_nonnull(strstr(text, "Left out without --full:\n  P-step       5 of 11 rows\n"));
    ck_assert_ptr_nonnull(strstr(text, "  P-table1     16 of 27 rows\n"));
    ck_assert_ptr_null(strstr(text, "P-fig7"));
    free(text);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *verdicts = tcase_create("verdicts");
    tcase_add_test(verdicts, numbers_in_and_out_of_bounds);
    tcase_add_test(verdicts, a_number_stands_in_its_column);
    tcase_add_test(verdicts, what_the_paper_says_has_a_verdict_of_its_own);
    tcase_add_test(verdicts, a_miss_ends_in_status_1_and_what_differs_does_not);
    tcase_add_test(verdicts, what_is_allowed_is_legible);
    tcase_add_test(verdicts, every_row_can_be_run_and_can_miss);
    tcase_add_test(verdicts, what_is_quoted_stands_in_the_paper);
    suite_add_tcase(suite, verdicts);
    TCase *words = tcase_create("words");
    tcase_add_test(words, bad_words_are_refused);
    tcase_add_test(words, the_list_names_what_the_papers_show);
    suite_add_tcase(suite, words);
    TCase *runs = tcase_create("runs");
    tcase_add_test(runs, the_bar_is_reproduced);
    tcase_add_test(runs, the_bar_by_peridynamics_is_reproduced);
    if (suite_wide()) /* seconds */
        tcase_add_test(runs, beams_are_reproduced);
    suite_add_tcase(suite, runs);
}
