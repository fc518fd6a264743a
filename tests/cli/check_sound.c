/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is heard is what the readout says: the frequencies in both ears, fitted, have its ratio. */
#include "suite.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { HEAD = 44, RATE = 44100 };

static char folder[] = "/tmp/matvib-sound-XXXXXX";

static void enter_folder(void)
{
    strcpy(folder + strlen(folder) - 6, "XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(folder));
    ck_assert_int_eq(chdir(folder), 0);
}

static void leave_folder(void)
{
    remove("a.wav");
    remove("said.txt");
    ck_assert_int_eq(chdir("/"), 0);
    ck_assert_int_eq(rmdir(folder), 0);
}

/* Runs the program and leaves what it says in said.txt. */
static void run_program(const char *arguments)
{
    char command[1024];
    snprintf(command, sizeof command, "%s %s >said.txt", getenv("MATVIB"), arguments);
    ck_assert_msg(system(command) == 0, "%s", command);
}

/* The number behind a word that was said. */
static double said(const char *word)
{
    char line[512];
    double number = NAN;
    FILE *file = fopen("said.txt", "r");
    while (isnan(number) && fgets(line, sizeof line, file)) {
        const char *at = strstr(line, word);
        if (at)
            sscanf(at + strlen(word), "%lf", &number);
    }
    fclose(file);
    ck_assert_msg(isfinite(number), "%s", word);
    return number;
}

/* Hz of a channel, 0 or 1: from the first to the last zero at which it rises. */
static double fitted(const char *name, int channel)
{
    FILE *file = fopen(name, "rb");
    ck_assert_ptr_nonnull(file);
    ck_assert_int_eq(fseek(file, HEAD, SEEK_SET), 0);
    int16_t pair[2];
    double before = 0, first = 0, last = 0;
    long zeros = 0;
    for (long i = 0; fread(pair, sizeof pair, 1, file) == 1; i++) {
        const double value = pair[channel];
        if (i > RATE / 10 && before < 0 && value >= 0) {
            last = (double)i - value / (value - before);
            first = zeros == 0 ? last : first;
            zeros++;
        }
        before = value;
    }
    fclose(file);
    ck_assert_int_gt(zeros, 100);
    return (double)(zeros - 1) * RATE / (last - first);
}

START_TEST(a_bar_is_transposed_at_its_true_ratio)
{
    run_program("run mode5");
    const double ratio = said("measured ") / said("exact ");
    run_program("sound mode5 --seconds 3 --output a.wav");
    ck_assert_double_eq_tol(fitted("a.wav", 1), 440, 440e-4);
    ck_assert_double_eq_tol(fitted("a.wav", 0) / fitted("a.wav", 1), ratio, 1e-4);
}
END_TEST

START_TEST(a_beam_has_its_real_pitch)
{
    run_program("run supported-beam-coarse");
    const double measured = said("measured "), theory = said("beam theory ");
    run_program("sound supported-beam-coarse --output a.wav");
    const double right = fitted("a.wav", 1);
    ck_assert_double_eq_tol(right, said("exact "), 1e-4 * right);
    ck_assert(right > 1100 && right < 1200);
    ck_assert_double_eq_tol(fitted("a.wav", 0) / right, theory / measured, 1e-4);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("sound");
    tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
    tcase_add_test(tcase, a_bar_is_transposed_at_its_true_ratio);
    if (suite_long()) /* two whole beams; numbers.sh measures one in words */
        tcase_add_test(tcase, a_beam_has_its_real_pitch);
    suite_add_tcase(suite, tcase);
}
