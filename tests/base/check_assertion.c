/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Assertions: what holds passes, what does not says both sides and aborts; switched off they evaluate
 * nothing. */
#define MATVIB_ASSERTIONS 1
#include "base/assertion.h"
#include "suite.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

static int evaluated;

static int next(void)
{
    return ++evaluated;
}

/* What a child that runs the case writes to standard error, and how it ends. */
static int child(void (*run)(void), char *text, size_t size)
{
    int ends[2];
    ck_assert_int_eq(pipe(ends), 0);
    pid_t id = fork();
    ck_assert_int_ge(id, 0);
    if (id == 0) {
        setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
        signal(SIGABRT, SIG_DFL);
        dup2(ends[1], STDERR_FILENO);
        run();
        _exit(0);
    }
    close(ends[1]);
    FILE *stream = fdopen(ends[0], "r");
    ck_assert_ptr_nonnull(stream);
    text[fread(text, 1, size - 1, stream)] = '\0';
    fclose(stream);
    int status;
    ck_assert_int_eq(waitpid(id, &status, 0), id);
    return status;
}

static void fail_plain(void)
{
    const char *model = NULL;
    ASSERT(model);
}

static void fail_int(void)
{
    int stage = 8;
    ASSERT_INT(stage, <, 8L);
}

static void fail_index(void)
{
    size_t count = 4;
    ASSERT_INDEX(4, count);
}

static void fail_negative(void)
{
    int node = -1;
    ASSERT_INDEX(node, 4L);
}

static void fail_real(void)
{
    double dt = -0.5;
    ASSERT_REAL(dt, >, 0);
}

static void fail_nan(void)
{
    double zero = 0;
    ASSERT_REAL(zero / zero, ==, 0.0);
}

static void pass(void)
{
    ASSERT(evaluated == 0);
    ASSERT_INT(next(), ==, 1);
    ASSERT_INDEX(3, 4);
    ASSERT_REAL(1.5, <=, 1.5);
    if (evaluated != 1)
        _exit(3);
}

static void expect_failure(void (*run)(void), const char *message)
{
    char text[256];
    int status = child(run, text, sizeof text);
    ck_assert(WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT);
    ck_assert_msg(strstr(text, message), "%s", text);
    ck_assert_msg(strstr(text, "check_assertion.c:"), "%s", text);
    ck_assert_uint_eq(strcspn(text, "\n") + 1, strlen(text));
}

START_TEST(what_fails_says_both_sides)
{
    expect_failure(fail_plain, ": fail_plain: model does not hold\n");
    expect_failure(fail_int, ": fail_int: stage < 8L does not hold: 8 < 8\n");
    expect_failure(fail_index, ": fail_index: 4 is one of count does not hold: 4 of 4\n");
    expect_failure(fail_negative, ": fail_negative: node is one of 4L does not hold: -1 of 4\n");
    expect_failure(fail_real, ": fail_real: dt > 0 does not hold: -0.5 > 0\n");
    expect_failure(fail_nan, ": fail_nan: zero / zero == 0.0 does not hold: ");
}
END_TEST

START_TEST(what_holds_passes_and_is_evaluated_once)
{
    char text[256];
    ck_assert_int_eq(child(pass, text, sizeof text), 0);
    ck_assert_str_eq(text, "");
}
END_TEST

#undef MATVIB_ASSERTIONS
#undef BASE_ASSERTION_H
#undef ASSERT
#undef ASSERT_INT
#undef ASSERT_INDEX
#undef ASSERT_REAL
#undef ASSERTION_COMPARE
#include "base/assertion.h"

START_TEST(switched_off_nothing_is_evaluated)
{
    evaluated = 0;
    ASSERT(next() == 7);
    ASSERT_INT(next(), ==, 7);
    ASSERT_REAL(next(), ==, 7.0);
    ck_assert_int_eq(evaluated, 0);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *cases = tcase_create("assertions");
    tcase_add_test(cases, what_fails_says_both_sides);
    tcase_add_test(cases, what_holds_passes_and_is_evaluated_once);
    tcase_add_test(cases, switched_off_nothing_is_evaluated);
    suite_add_tcase(suite, cases);
}
