/* SPDX-License-Identifier: GPL-3.0-or-later */
/* However the laboratory ends, and whatever it does then: the terminal is as it was, no half file is left,
 * the exit status tells why. */
#include "pty/session.h"
#include "suite.h"

#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static const char *matvib(void)
{
    const char *path = getenv("MATVIB");
    return path ? path : "./matvib";
}

/* All that end a process by default, and a real-time one. */
static const int ends[] = {
    SIGHUP,    SIGINT,  SIGQUIT, SIGTERM, SIGPIPE, SIGALRM, SIGUSR1, SIGUSR2, SIGXCPU, SIGXFSZ,
    SIGVTALRM, SIGPROF, SIGSYS,  SIGTRAP, SIGIO,   SIGSEGV, SIGBUS,  SIGFPE,  SIGILL,  SIGABRT,
#ifdef SIGPWR
    SIGPWR,
#endif
#ifdef SIGSTKFLT
    SIGSTKFLT,
#endif
};
enum { N_ENDS = sizeof ends / sizeof *ends };

START_TEST(signals_end_it_and_restore_the_terminal)
{
    const int number = _i < N_ENDS ? ends[_i] : SIGRTMIN + 3;
    Session session;
    session_open_paused(&session, 80, 24, NULL);
    ck_assert_int_eq(session.mouse, VTERM_PROP_MOUSE_DRAG);
    kill(session.child, number);
    ck_assert_int_eq(session_exit(&session), 128 + number);
    session_check_restored(&session);
    session_close(&session);
}
END_TEST

START_TEST(a_running_one_ends_by_signal_too)
{
    Session session;
    session_open(&session, 80, 24, NULL, (const char *const[]){matvib(), "mode1", NULL});
    session_frame(&session);
    kill(session.child, SIGTERM);
    ck_assert_int_eq(session_exit(&session), 128 + SIGTERM);
    session_check_restored(&session);
    session_close(&session);
}
END_TEST

START_TEST(a_terminal_that_goes_away_ends_it)
{
    Session session;
    session_open(&session, 80, 24, NULL,
                 (const char *const[]){matvib(), _i ? "notched-beam-coarse" : "mode1", NULL});
    for (int i = 0; i < 3; i++)
        session_frame(&session);
    session_hang_up(&session); /* in the middle of a frame or between two */
    ck_assert_int_eq(session_exit(&session), 128 + SIGHUP);
    session_close(&session);
}
END_TEST

/* Shell, terminal and kernel each say that it ends. What was done is kept whole, and what a session that was
 * killed left behind a while ago goes. */
START_TEST(a_session_that_is_ended_twice_is_kept)
{
    char folder[] = "/tmp/matvib-XXXXXX", state[64], path[128], old[128], command[192];
    ck_assert_ptr_nonnull(mkdtemp(folder));
    snprintf(state, sizeof state, "XDG_STATE_HOME=%s", folder);
    const pid_t gone = fork();
    if (gone == 0)
        _exit(0);
    waitpid(gone, NULL, 0);
    snprintf(command, sizeof command,
             "mkdir %s/matvib && touch -d '2 minutes ago' %s/matvib/last.session.%ld-0.part", folder, folder,
             (long)gone);
    ck_assert_int_eq(system(command), 0);
    snprintf(old, sizeof old, "%s/matvib/last.session.%ld-0.part", folder, (long)gone);
    snprintf(path, sizeof path, "%s/matvib/last.session", folder);
    Session session;
    session_open_paused(&session, 80, 24, (const char *const[]){state, NULL});
    session_keys(&session, "..");
    for (int i = 0; i < 20; i++) {
        kill(session.child, SIGHUP);
        kill(session.child, SIGTERM);
        usleep(200);
    }
    const int status = session_exit(&session);
    ck_assert(status == 128 + SIGHUP || status == 128 + SIGTERM);
    session_close(&session);
    ck_assert_int_eq(access(path, F_OK), 0);
    ck_assert_int_ne(access(old, F_OK), 0);
    snprintf(command, sizeof command, "test \"$(ls %s/matvib)\" = last.session && rm -r %s", folder, folder);
    ck_assert_int_eq(system(command), 0);
}
END_TEST

static const int leavings[] = {0, SIGTERM, SIGSEGV};

/* Nobody reads what it writes, as when a connection hangs: it stops in the middle of a picture. */
START_TEST(a_terminal_that_hangs_can_be_left)
{
    Session session;
    session_open(&session, 200, 60, NULL, (const char *const[]){matvib(), "mode1", NULL});
    session_frame(&session);
    struct pollfd frames = {.fd = session.frames, .events = POLLIN};
    char lines[4096];
    for (int i = 0; i < 100; i++)
        session_send(&session, "\014"); /* everything anew */
    while (poll(&frames, 1, 500) > 0)
        ck_assert_int_gt(read(session.frames, lines, sizeof lines), 0);
    if (_i == 0)
        session_send(&session, "q"); /* keys are answered */
    else
        kill(session.child, leavings[_i]);
    session_ignore(&session);
    ck_assert_int_eq(session_exit(&session), _i == 0 ? 0 : 128 + leavings[_i]);
    session_close(&session);
}
END_TEST

/* In the middle of a line or a value. */
START_TEST(a_signal_goes_before_what_is_typed)
{
    static const char *const typed[] = {":show 3", "\r1.5", "g12"};
    Session session;
    for (int i = 0; i < 3; i++) {
        session_open_paused(&session, 80, 24, NULL);
        session_keys(&session, typed[i]);
        kill(session.child, SIGUSR1);
        ck_assert_int_eq(session_exit(&session), 128 + SIGUSR1);
        session_check_restored(&session);
        session_close(&session);
    }
}
END_TEST

/* Keys come faster than they are answered, as when a book lies on the keyboard: pictures come all the same.
 */
START_TEST(a_signal_goes_before_keys_that_wait)
{
    Session session;
    session_open_paused(&session, 80, 24, NULL);
    pid_t typists[2];
    for (int i = 0; i < 2; i++) {
        typists[i] = fork();
        ck_assert_int_ge(typists[i], 0);
        while (typists[i] == 0)
            if (write(session.master, "........", 8) < 0)
                _exit(0);
    }
    for (int i = 0; i < 3; i++)
        session_frame(&session);
    kill(session.child, SIGTERM);
    session_gone(&session);
    for (int i = 0; i < 2; i++) { /* the restored terminal echoes, so that reading would have no end */
        kill(typists[i], SIGKILL);
        waitpid(typists[i], NULL, 0);
    }
    ck_assert_int_eq(session_exit(&session), 128 + SIGTERM);
    session_check_restored(&session);
    session_close(&session);
}
END_TEST

/* Before, while and after it takes the terminal over. */
START_TEST(a_signal_before_the_first_picture_ends_it_too)
{
    Session session;
    for (int i = 0; i < 12; i++) {
        session_open(&session, 80, 24, NULL, (const char *const[]){matvib(), "mode1", NULL});
        while (tcgetpgrp(session.master) != session.child) /* from when the terminal is its own */
            usleep(100);
        usleep((useconds_t)(1000 * i));
        kill(session.child, SIGTERM);
        ck_assert_int_eq(session_exit(&session), 128 + SIGTERM);
        session_check_restored(&session);
        session_close(&session);
    }
}
END_TEST

/* Opens a run of half a million steps in a folder of its own, so that the export of it takes seconds. */
static void open_long_run(Session *session, const char *folder)
{
    char script[4096];
    const char *program = matvib();
    char *whole = realpath(program, NULL);
    snprintf(script, sizeof script, "cd %s && exec '%s' mode1 --paused --set time.end=1e5", folder,
             whole ? whole : program);
    free(whole);
    session_open(session, 80, 24, NULL, (const char *const[]){"sh", "-c", script, NULL});
    session_idle(session);
}

START_TEST(a_signal_during_an_export_leaves_no_file)
{
    char folder[] = "/tmp/matvib-XXXXXX", command[128];
    Session session;
    ck_assert_ptr_nonnull(mkdtemp(folder));
    open_long_run(&session, folder);
    session_keys(&session, "g5000\r");
    session_send(&session, "xlong\r");
    session_wait_for(&session, "exporting");
    kill(session.child, SIGHUP);
    ck_assert_int_eq(session_exit(&session), 128 + SIGHUP);
    session_check_restored(&session);
    session_close(&session);
    snprintf(command, sizeof command, "test -z \"$(ls -A %s)\" && rm -r %s", folder, folder);
    ck_assert_int_eq(system(command), 0);
}
END_TEST

/* All bytes that it has read; 0 where the system does not tell. */
static long bytes_read(pid_t child)
{
    char path[64], line[256];
    long count = 0;
    snprintf(path, sizeof path, "/proc/%ld/io", (long)child);
    FILE *file = fopen(path, "r");
    while (file && fgets(line, sizeof line, file))
        sscanf(line, "rchar: %ld", &count);
    if (file)
        fclose(file);
    return count;
}

START_TEST(a_signal_during_the_reading_of_an_overlay_ends_it)
{
    char folder[] = "/tmp/matvib-XXXXXX", name[64];
    Session session;
    ck_assert_ptr_nonnull(mkdtemp(folder));
    snprintf(name, sizeof name, "%s/big.csv", folder);
    FILE *file = fopen(name, "w");
    ck_assert_ptr_nonnull(file);
    fputs("time,v_cm\n", file);
    for (int i = 0; i < 4000000; i++)
        fputs("1234.56789,0.123456789\n", file);
    ck_assert_int_eq(fclose(file), 0);
    open_long_run(&session, folder);
    session_send(&session, ":overlay big.csv\r");
    session_wait_for(&session, "reading");
    /* stopped, so that what it reads after the signal can be told from what it read before */
    kill(session.child, SIGSTOP);
    ck_assert_int_eq(waitpid(session.child, NULL, WUNTRACED), session.child);
    const long before = bytes_read(session.child);
    kill(session.child, SIGALRM);
    kill(session.child, SIGCONT);
    session_gone(&session);
    siginfo_t info;
    ck_assert_int_eq(waitid(P_PID, (id_t)session.child, &info, WEXITED | WNOWAIT), 0);
    ck_assert_int_lt(bytes_read(session.child) - before, 10000000);
    ck_assert_int_eq(session_exit(&session), 128 + SIGALRM);
    session_check_restored(&session);
    session_close(&session);
    ck_assert_int_eq(unlink(name), 0);
    ck_assert_int_eq(rmdir(folder), 0);
}
END_TEST

static void ends_by_signal(Session *session, int number)
{
    kill(session->child, number);
    ck_assert_int_eq(session_exit(session), 128 + number);
    session_check_restored(session);
}

/* A beam ten times as long takes seconds to build. */
START_TEST(a_building_shows_how_far_it_is_and_can_be_given_up)
{
    static const char *const keys[] = {"\033", "\003", NULL};
    Session session;
    session_open(&session, 80, 24, NULL, (const char *const[]){matvib(), "supported-beam", "--paused", NULL});
    session_idle(&session);
    session_send(&session, ":beam.length=2\r");
    session_wait_for(&session, "building the run: ");
    if (!keys[_i]) {
        ends_by_signal(&session, SIGXCPU);
    } else {
        session_send(&session, keys[_i]);
        session_wait_for(&session, "cancelled");
        session_idle(&session);
        ck_assert(session_shows(&session, ": beam.length=2")); /* for another value */
    }
    session_close(&session);
}
END_TEST

/* Points of a study are worked out one after another while their view is shown. */
START_TEST(a_study_shows_how_far_it_is_and_can_be_stopped)
{
    static const char *const keys[] = {"\033", "\003", NULL};
    Session session;
    session_open(&session, 80, 24, NULL, (const char *const[]){matvib(), "supported-beam", "--paused", NULL});
    session_idle(&session);
    session_send(&session, ":show convergence\r");
    session_wait_for(&session, "   ^C stops");
    if (!keys[_i]) {
        ends_by_signal(&session, SIGHUP);
    } else {
        session_send(&session, keys[_i]);
        session_wait_for(&session, "stopped; show the view again");
    }
    session_close(&session);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("ends");
    tcase_add_loop_test(tcase, signals_end_it_and_restore_the_terminal, 0, N_ENDS + 1);
    tcase_add_test(tcase, a_running_one_ends_by_signal_too);
    tcase_add_loop_test(tcase, a_terminal_that_goes_away_ends_it, 0, 2);
    tcase_add_test(tcase, a_session_that_is_ended_twice_is_kept);
    tcase_add_loop_test(tcase, a_terminal_that_hangs_can_be_left, 0, 3);
    tcase_add_test(tcase, a_signal_goes_before_what_is_typed);
    tcase_add_test(tcase, a_signal_goes_before_keys_that_wait);
    tcase_add_test(tcase, a_signal_before_the_first_picture_ends_it_too);
    tcase_add_test(tcase, a_signal_during_an_export_leaves_no_file);
    tcase_add_test(tcase, a_signal_during_the_reading_of_an_overlay_ends_it);
    tcase_add_loop_test(tcase, a_building_shows_how_far_it_is_and_can_be_given_up, 0, 3);
    tcase_add_loop_test(tcase, a_study_shows_how_far_it_is_and_can_be_stopped, 0, 3);
    suite_add_tcase(suite, tcase);
}
