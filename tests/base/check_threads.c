/* SPDX-License-Identifier: GPL-3.0-or-later */
/* As many threads as one may have, and no more. */
#include "base/threads.h"
#include "suite.h"

#include <sched.h>
#include <stdio.h>
#include <stdlib.h>

static void expect(const char *variable, int headless, int on_screen)
{
    if (variable)
        setenv("OMP_NUM_THREADS", variable, 1);
    else
        unsetenv("OMP_NUM_THREADS");
    ck_assert_int_eq(threads_default(false), headless);
    ck_assert_int_eq(threads_default(true), on_screen);
}

START_TEST(without_a_word_one_is_left_to_the_screen)
{
    const int all = threads_allowed();
    ck_assert_int_ge(all, 1);
    expect(NULL, all, all > 1 ? all - 1 : 1);
}
END_TEST

START_TEST(the_variable_of_openmp_is_heard)
{
    const int all = threads_allowed();
    expect("1", 1, 1);
    expect("1,4", 1, 1);
    expect(" 1 ", 1, 1);
    expect("1000000", all, all);
    expect("99999999999999999999", all, all);
    for (const char *const *nonsense = (const char *const[]){"", "0", "-2", "two", "1x", NULL}; *nonsense;
         nonsense++)
        expect(*nonsense, all, all > 1 ? all - 1 : 1);
}
END_TEST

#ifdef HAVE_SCHED_GETAFFINITY
START_TEST(the_mask_is_the_limit)
{
    cpu_set_t mine, one;
    ck_assert_int_eq(sched_getaffinity(0, sizeof mine, &mine), 0);
    for (size_t processor = 0; processor < CPU_SETSIZE; processor++) {
        if (!CPU_ISSET(processor, &mine))
            continue;
        CPU_ZERO(&one);
        CPU_SET(processor, &one);
        break;
    }
    ck_assert_int_eq(sched_setaffinity(0, sizeof one, &one), 0);
    ck_assert_int_eq(threads_allowed(), 1);
    expect(NULL, 1, 1);
    expect("8", 1, 1);
}
END_TEST
#endif

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("threads");
    tcase_add_test(tcase, without_a_word_one_is_left_to_the_screen);
    tcase_add_test(tcase, the_variable_of_openmp_is_heard);
#ifdef HAVE_SCHED_GETAFFINITY
    tcase_add_test(tcase, the_mask_is_the_limit);
#endif
    suite_add_tcase(suite, tcase);
}
