/* What verify says of a number, and that it says so with its exit status. */
#include "cli/verify/verify.h"
#include "cli/verify/verify_sheet.h"
#include "suite.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

START_TEST(numbers_in_and_out_of_bounds)
{
    const Bound wide = {-1, 1}, narrow = {0.25, 0.75}, open = {5, INFINITY};
    const Bound both[2] = {wide, narrow};
    ck_assert_int_eq(verdict_of(0.5, both, 2), VERDICT_HOLDS);
    ck_assert_int_eq(verdict_of(0.25, both, 2), VERDICT_HOLDS);
    ck_assert_int_eq(verdict_of(0.75, both, 2), VERDICT_HOLDS);
    ck_assert_int_eq(verdict_of(0.2499999, both, 2), VERDICT_MISSED);
    ck_assert_int_eq(verdict_of(0.2499999, both, 1), VERDICT_HOLDS);
    ck_assert_int_eq(verdict_of(1.5, both, 2), VERDICT_MISSED);
    ck_assert_int_eq(verdict_of(-1.5, both, 2), VERDICT_MISSED);
    ck_assert_int_eq(verdict_of(4.9, &open, 1), VERDICT_MISSED);
    ck_assert_int_eq(verdict_of(1e300, &open, 1), VERDICT_HOLDS);
    /* what is no number can hold nothing */
    ck_assert_int_eq(verdict_of(NAN, &wide, 1), VERDICT_MISSED);
    ck_assert_int_eq(verdict_of(NAN, &open, 1), VERDICT_MISSED);
    ck_assert_int_eq(verdict_of(INFINITY, &wide, 1), VERDICT_MISSED);
    ck_assert_int_eq(verdict_of(NAN, NULL, 0), VERDICT_SHOWN);
    ck_assert_double_eq(within(3, 0.5).low, 2.5);
    ck_assert_double_eq(within(3, 0.5).high, 3.5);
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

START_TEST(a_miss_is_counted_and_ends_in_status_1)
{
    Capture out;
    capture_open(&out);
    Verify verify = {.out = out.file};
    VerifyRow row = {"omega", "about 5", 5.415, 5.415, 3, 1, {within(5.4, 0.02)}};
    verify_head(&verify, NULL);
    verify_row(&verify, &row);
    Status status = {0};
    ck_assert_int_eq(verify_end(&verify, &status), 0);
    ck_assert_int_eq(status.code, STATUS_DONE);
    row.measured = 5.65;
    verify_row(&verify, &row);
    ck_assert_int_eq(verify_end(&verify, &status), 1);
    ck_assert_int_eq(status.code, STATUS_FAILED);
    ck_assert_str_eq(status.text, "verify: 1 of 2 missed");
    row.measured = NAN;
    verify_row(&verify, &row);
    row.n_bounds = 0, row.measured = 1;
    verify_row(&verify, &row); /* shown only */
    ck_assert_int_eq(verify_end(&verify, &status), 1);
    ck_assert_str_eq(status.text, "verify: 2 of 3 missed");
    fclose(out.file);
    ck_assert_ptr_nonnull(strstr(out.text, "omega                  about 5        5.415     5.415"));
    ck_assert_ptr_nonnull(strstr(out.text, "5.380..5.420  holds\n"));
    ck_assert_ptr_nonnull(strstr(out.text, "5.650     5.380..5.420  MISSED\n"));
    ck_assert_ptr_nonnull(strstr(out.text, "none     5.380..5.420  MISSED\n"));
    ck_assert_ptr_nonnull(strstr(out.text, "1 of 3 hold\n"));
    free(out.text);
}
END_TEST

static void expect_allowed(int decimals, double low, double high, const char *text)
{
    Capture out;
    capture_open(&out);
    Verify verify = {.out = out.file};
    verify_row(&verify, &(VerifyRow){"x", NULL, NAN, (low + high) / 2, decimals, 1, {{low, high}}});
    fclose(out.file);
    ck_assert_msg(strstr(out.text, text) != NULL, "\"%s\" is not in \"%s\"", text, out.text);
    free(out.text);
}

START_TEST(what_is_allowed_is_legible)
{
    expect_allowed(1, 2, 3, " 2.0..3.0  ");
    expect_allowed(0, 1378, 1378, " 1378  ");
    expect_allowed(2, 5, INFINITY, " >= 5.00  ");
    expect_allowed(2, -INFINITY, 5, " <= 5.00  ");
    expect_allowed(0, 0.25, 0.75, " 0.2..0.8  ");
    expect_allowed(6, 1.139777, 1.139779, " within 1e-06  ");
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
                     "verify: unknown name \"M-fig5\" (the nearest is M-fig2; --list tells all)");
    ck_assert_str_eq(text, "");
    free(text);
    ck_assert_int_eq(verify_words("M-fig3 --ful", &text, &status), 2);
    ck_assert_ptr_nonnull(strstr(status.text, "--ful:"));
    free(text);
}
END_TEST

START_TEST(the_list_names_what_the_papers_show)
{
    static const char *const names[] = {"M-fig2", "M-fig3", "M-fig4", "M-cell",   "M-particles",
                                        "M-dt",   "M-usl",  "P-fig3", "P-table1", "P-fig4",
                                        "P-fig6", "P-fig7", "P-fig9", "P-fig10",  "P-bar"};
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
static char *expect_held(const char *words)
{
    char *text;
    Status status;
    ck_assert_msg(verify_words(words, &text, &status) == 0, "%s: %s\n%s", words, status.text, text);
    ck_assert_ptr_null(strstr(text, "MISSED"));
    expect_narrow(text);
    return text;
}

START_TEST(the_bar_holds)
{
    char *text = expect_held("M-fig2 M-fig3 M-fig4 M-cell M-particles M-dt");
    ck_assert_ptr_nonnull(strstr(text, "M-fig3  mode 5 of the bar"));
    ck_assert_ptr_nonnull(strstr(text, "30 of 30 hold\n"));
    ck_assert_ptr_null(strstr(text, "Left out"));
    free(text);
    free(expect_held("M-usl M-hidden M-crossing M-load"));
}
END_TEST

START_TEST(the_bar_by_peridynamics_holds)
{
    char *text = expect_held("P-bar");
    ck_assert_ptr_nonnull(strstr(text, "12 of 12 hold\n"));
    /* measured, predicted, exact of mode 5 between fixed ends, and how far off */
    ck_assert_ptr_nonnull(strstr(text, "6.28319"));
    ck_assert_ptr_nonnull(strstr(text, "-2.016"));
    free(text);
}
END_TEST

/* A beam that is quick, and what was left out of it. */
START_TEST(beams_hold)
{
    char *text = expect_held("P-step P-surface P-table1");
    ck_assert_ptr_nonnull(strstr(text, "Left out without --full:\n  P-step "));
    ck_assert_ptr_nonnull(strstr(text, "  P-table1     the four finer horizons\n"));
    ck_assert_ptr_null(strstr(text, "P-fig7"));
    free(text);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *verdicts = tcase_create("verdicts");
    tcase_add_test(verdicts, numbers_in_and_out_of_bounds);
    tcase_add_test(verdicts, a_miss_is_counted_and_ends_in_status_1);
    tcase_add_test(verdicts, what_is_allowed_is_legible);
    suite_add_tcase(suite, verdicts);
    TCase *words = tcase_create("words");
    tcase_add_test(words, bad_words_are_refused);
    tcase_add_test(words, the_list_names_what_the_papers_show);
    suite_add_tcase(suite, words);
    TCase *runs = tcase_create("runs");
    tcase_set_timeout(runs, 60);
    tcase_add_test(runs, the_bar_holds);
    tcase_add_test(runs, the_bar_by_peridynamics_holds);
    tcase_add_test(runs, beams_hold);
    suite_add_tcase(suite, runs);
}
