/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Signals that ask for an end: the first is noted, and the second ends what does not look. */
#include "base/signals.h"
#include "suite.h"

#include <signal.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static const int ends[] = {SIGINT, SIGTERM, SIGHUP};

/* As in a program: of the tests' driver they have handlers, which signals_catch() would leave alone. */
static void catch_all(void)
{
    for (int i = 0; i < 3; i++)
        signal(ends[i], SIG_DFL);
    signals_catch();
}

/* It is sent again and again: how soon the process gets to run does not matter. */
START_TEST(what_never_looks_is_ended_by_the_second)
{
    const struct timespec between = {0, 100000000};
    int ready[2], status = 0;
    char byte;
    ck_assert_int_eq(pipe(ready), 0);
    const pid_t child = fork();
    if (child == 0) {
        catch_all();
        (void)!write(ready[1], "", 1);
        for (;;)
            pause();
    }
    ck_assert_int_gt(child, 0);
    ck_assert_int_eq(read(ready[0], &byte, 1), 1);
    for (int i = 0; i < 600 && waitpid(child, &status, WNOHANG) == 0; i++) {
        kill(child, ends[_i]);
        nanosleep(&between, NULL);
    }
    ck_assert_msg(WIFSIGNALED(status), "it goes on");
    ck_assert_int_eq(WTERMSIG(status), ends[_i]);
}
END_TEST

START_TEST(the_first_is_noted)
{
    catch_all();
    raise(ends[_i]);
    raise(ends[(_i + 1) % 3]); /* at once: shell and kernel say it both */
    ck_assert_int_eq(signals_ended_by(), ends[_i]);
    signals_forget();
    ck_assert_int_eq(signals_ended_by(), 0);
    raise(SIGTERM);
    ck_assert_int_eq(signals_ended_by(), SIGTERM);
}
END_TEST

void add_cases(Suite *suite)
{
    suite_fork();
    TCase *tcase = tcase_create("signals");
    tcase_set_timeout(tcase, 120);
    tcase_add_loop_test(tcase, what_never_looks_is_ended_by_the_second, 0, 3);
    tcase_add_loop_test(tcase, the_first_is_noted, 0, 3);
    suite_add_tcase(suite, tcase);
}
