/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The laboratory on a real terminal while an allocation, of ours or of a library, finds no memory: it goes
 * on, or it ends and says why; the terminal is as it was before. */
#include "pty/session.h"
#include "suite.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum { ARGUMENTS_MAX = 6, KEYS_MAX = 8 };

static const int ends[] = {SIGINT, SIGTERM, SIGHUP};
enum { ENDS = sizeof ends / sizeof *ends };

/* What is opened, and what is done then; "resize" makes the terminal larger. */
typedef struct Visit {
    const char *arguments[ARGUMENTS_MAX], *keys[KEYS_MAX];
} Visit;

static const Visit visits[] = {
    {{"mode1", "--paused"}, {".", "]"}},
    {{"mode1", "--paused"}, {"resize", "."}},
    {{"lesson"}, {"\r", "\033[6~", "\033[6~", "T"}},
    {{"mode1", "--paused"}, {":duel mode5\r", "."}},
    {{"notched-beam-coarse", "--paused"}, {".", "\t"}},
};
enum { VISITS = sizeof visits / sizeof *visits };

static void open_visit(Session *session, const Visit *visit, const char *folder, const char *kind,
                       long fails_at)
{
    const char *build = getenv("MATVIB_BUILDDIR");
    char program[512], fault[64], count[128], state[128];
    snprintf(program, sizeof program, "%s/matvib_faults", build ? build : ".");
    snprintf(fault, sizeof fault, "MATVIB_FAULT=%s:%ld", kind, fails_at);
    snprintf(count, sizeof count, "MATVIB_FAULT_COUNT=%s/count", folder);
    snprintf(state, sizeof state, "XDG_STATE_HOME=%s/state", folder);
    const char *command[ARGUMENTS_MAX + 1] = {program};
    for (int i = 0; i < ARGUMENTS_MAX - 1 && visit->arguments[i]; i++)
        command[i + 1] = visit->arguments[i];
    const char *environment[] = {fault, count, state, "OMP_NUM_THREADS=1", NULL};
    session_open(session, 80, 24, environment, command);
}

/* Keys go on until it leaves by ^C or by itself. */
static int play(Session *session, const Visit *visit)
{
    bool there = session_idle_or_gone(session);
    for (int i = 0; there && i < KEYS_MAX && visit->keys[i]; i++) {
        if (strcmp(visit->keys[i], "resize") == 0)
            session_resize(session, 132, 43);
        else
            session_send(session, visit->keys[i]);
        there = session_idle_or_gone(session);
    }
    for (int i = 0; there && i < 4; i++) {
        session_send(session, "\003");
        there = session_idle_or_gone(session);
    }
    return session_exit(session);
}

static long count_of(const char *folder)
{
    char name[128];
    long count = 0;
    snprintf(name, sizeof name, "%s/count", folder);
    FILE *file = fopen(name, "r");
    ck_assert_ptr_nonnull(file);
    ck_assert_int_eq(fscanf(file, "%ld", &count), 1);
    fclose(file);
    return count;
}

/* What stands behind the last picture: the terminal writes a newline as two characters. */
static void check_told(const Session *session, long place)
{
    const char *left = session->bytes ? session->bytes : "", *line = NULL;
    for (const char *next = left; (next = strstr(next, "matvib: ")); next++)
        line = next;
    ck_assert_msg(line && strstr(line, "\r\n") && !strstr(line, "\033[?1049l"),
                  "allocation %ld: it ends and does not say why", place);
}

/* ncurses does not ask whether it got memory, neither for the description of a terminal nor for a text with
 * arguments, tiparm(); what is ours is found without a terminal by check_memory and tests/faults/run. Then
 * too the terminal has to be as it was. What curses leaves of its heap may end the program later, in
 * malloc(); an assertion of ours (base/assertion.h) ends in abort() too. */
static bool crashed_in_library(const Session *session, int status)
{
    const bool asserted = session->bytes && strstr(session->bytes, "does not hold");
    return status == 128 + SIGSEGV || (status == 128 + SIGABRT && !asserted);
}

/* MATVIB_FAULTS places (4), spread over all. */
START_TEST(no_memory_on_a_terminal)
{
    const char *wanted = getenv("MATVIB_FAULTS");
    const long places = wanted ? atol(wanted) : 4;
    char folder[] = "/tmp/matvib-XXXXXX", command[64];
    Session session;
    ck_assert_ptr_nonnull(mkdtemp(folder));
    open_visit(&session, &visits[_i], folder, "memory", 0);
    ck_assert_int_eq(play(&session, &visits[_i]), 0);
    session_check_restored(&session);
    session_close(&session);
    const long count = count_of(folder), stride = count / places + 1;
    for (long place = 1 + count % stride; place <= count; place += stride) {
        open_visit(&session, &visits[_i], folder, "memory", place);
        const int status = play(&session, &visits[_i]);
        const bool excused = crashed_in_library(&session, status);
        ck_assert_msg(status <= 2 || excused, "allocation %ld of %ld: exit status %d", place, count, status);
        session_check_restored(&session);
        if (status != 0 && !excused)
            check_told(&session, place);
        session_close(&session);
    }
    snprintf(command, sizeof command, "rm -r %s", folder);
    ck_assert_int_eq(system(command), 0);
}
END_TEST

/* A file waits for its name for ever, so that nothing looks for keys or signals any more: the first ^C, TERM
 * or HUP is not answered, and a later one ends the program. */
START_TEST(the_second_signal_ends_what_hangs)
{
    const Visit visit = {{"mode1", "--paused"}, {NULL}};
    char folder[] = "/tmp/matvib-XXXXXX", command[128], answer[128];
    Session session;
    ck_assert_ptr_nonnull(mkdtemp(folder));
    open_visit(&session, &visit, folder, "hang", 1);
    session_idle(&session);
    snprintf(answer, sizeof answer, ":figure probe %s/f.svg\r", folder);
    session_send(&session, answer);
    snprintf(command, sizeof command, "ls %s/*.part >/dev/null 2>&1", folder);
    for (int i = 0; i < 1200 && system(command) != 0; i++)
        usleep(50000);
    siginfo_t info = {0};
    int sent = 0;
    for (int i = 0; i < 120 && info.si_pid == 0; i++) {
        if (ends[_i] == SIGINT)
            session_send(&session, "\003");
        else
            kill(session.child, ends[_i]);
        sent++;
        usleep(1200000);
        ck_assert_int_eq(waitid(P_PID, (id_t)session.child, &info, WEXITED | WNOHANG | WNOWAIT), 0);
    }
    ck_assert_int_ge(sent, 2); /* it did hang */
    ck_assert_int_eq(session_exit(&session), 128 + ends[_i]);
    session_check_restored(&session);
    session_close(&session);
    snprintf(command, sizeof command, "test -z \"$(ls %s/*.part 2>/dev/null)\" && rm -r %s", folder, folder);
    ck_assert_int_eq(system(command), 0);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("terminal faults");
    tcase_add_loop_test(tcase, no_memory_on_a_terminal, 0, VISITS);
    suite_add_tcase(suite, tcase);
    tcase = tcase_create("hanging");
    tcase_add_loop_test(tcase, the_second_signal_ends_what_hangs, 0, ENDS);
    suite_add_tcase(suite, tcase);
}
