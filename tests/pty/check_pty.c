/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The laboratory on a real terminal: what no script without one can show. */
#include "pty/session.h"
#include "suite.h"

#include <dirent.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include <wchar.h>

static const char *matvib(void)
{
    const char *path = getenv("MATVIB");
    return path ? path : "./matvib";
}

START_TEST(opens_answers_keys_and_leaves)
{
    Session session;
    session_open_paused(&session, 80, 24, NULL);
    ck_assert(session.alternate);
    ck_assert(session_shows(&session, "mode1"));
    ck_assert(session_shows(&session, "PAUSED"));
    ck_assert(session_shows(&session, "step 0"));
    session_keys(&session, ".");
    ck_assert(session_shows(&session, "step 1"));
    session_keys(&session, "]");
    ck_assert(session_shows(&session, "stage 1"));
    session_send(&session, "q");
    ck_assert_int_eq(session_exit(&session), 0);
    session_check_restored(&session);
    session_close(&session);
}
END_TEST

START_TEST(opens_running)
{
    Session session;
    session_open(&session, 80, 24, NULL, (const char *const[]){matvib(), "mode1", NULL});
    for (int i = 0; i < 5; i++)
        session_frame(&session);
    ck_assert(session_shows(&session, "RUNNING"));
    session_keys(&session, " ");
    ck_assert(session_shows(&session, "PAUSED"));
    ck_assert(!session_shows(&session, "step 0 "));
    session_close(&session);
}
END_TEST

START_TEST(a_still_picture_writes_nothing)
{
    Session session;
    session_open_paused(&session, 80, 24, NULL);
    size_t before = session.n_bytes;
    session_keys(&session, "\033[18~"); /* F7 means nothing */
    ck_assert_uint_eq(session.n_bytes, before);
    session_keys(&session, "\033[99~\033[I."); /* only the full stop is a key */
    ck_assert(session.n_bytes > before);
    session_close(&session);
}
END_TEST

START_TEST(pasted_text_runs_no_commands)
{
    Session session;
    session_open_paused(&session, 80, 24, NULL);
    ck_assert_ptr_nonnull(strstr(session.bytes, "\033[?2004h"));
    session_keys(&session, "\033[200~q\ry n \033[201~");
    ck_assert(session_shows(&session, "PAUSED"));
    ck_assert(session_shows(&session, "pasted text"));
    session_keys(&session, ":\033[200~show 3\r\033[201~");
    ck_assert(session_shows(&session, ": show 3"));
    session_keys(&session, "\r");
    ck_assert(session_shows(&session, "lumping"));
    session_send(&session, "q");
    ck_assert_int_eq(session_exit(&session), 0);
    ck_assert_ptr_nonnull(strstr(session.bytes, "\033[?2004l"));
    session_close(&session);
}
END_TEST

/* Whether all threads of a program sleep, and how often they have gone to sleep so far. Where the system does
 * not tell, they do. */
static bool asleep(pid_t child, long *times)
{
    char path[300], line[256], state = 'S';
    long switches = 0;
    bool all = true;
    *times = 0;
    snprintf(path, sizeof path, "/proc/%ld/task", (long)child);
    DIR *tasks = opendir(path);
    for (const struct dirent *task; tasks && (task = readdir(tasks)) != NULL;) {
        snprintf(path, sizeof path, "/proc/%ld/task/%.20s/status", (long)child, task->d_name);
        FILE *file = fopen(path, "r");
        while (file && fgets(line, sizeof line, file)) {
            if (sscanf(line, "State: %c", &state) == 1)
                all = all && state == 'S';
            if (sscanf(line, "voluntary_ctxt_switches: %ld", &switches) == 1)
                *times += switches;
        }
        if (file)
            fclose(file);
    }
    if (tasks)
        closedir(tasks);
    return all;
}

/* From when it sleeps nothing wakes it, and nothing comes. */
static void expect_quiet(const Session *session)
{
    struct pollfd both[2] = {{.fd = session->master, .events = POLLIN},
                             {.fd = session->frames, .events = POLLIN}};
    long before, after;
    while (!asleep(session->child, &before))
        usleep(1000);
    ck_assert_int_eq(poll(both, 2, 500), 0);
    ck_assert(asleep(session->child, &after));
    ck_assert_int_eq(after, before);
}

/* Who begins homework at a terminal is asked for a name, and told at the end what to hand in. */
START_TEST(homework_asks_whose_it_is)
{
    Session session;
    char folder[] = "/tmp/matvib-homework-XXXXXX", was[1024];
    char file[128], program[1100];
    ck_assert_ptr_nonnull(getcwd(was, sizeof was));
    ck_assert_ptr_nonnull(realpath(matvib(), program));
    ck_assert_ptr_nonnull(mkdtemp(folder));
    ck_assert_int_eq(chdir(folder), 0);
    session_open(&session, 80, 24, NULL, (const char *const[]){program, "lesson", "homework-late", NULL});
    session_wait_for(&session, "Your name");
    ck_assert(session_shows(&session, "Homework: the late mode") && !session_shows(&session, "\\x"));
    session_send(&session, "\033[2J\r");
    session_wait_for(&session, "is not a name");
    session_send(&session, "Ada Lovelace\r");
    session_wait_for(&session, "Your ID");
    session_send(&session, "17\r");
    session_wait_for(&session, "Your mode");
    session_send(&session, "q");
    session_wait_for(&session, "Hand in this file: homework-late-Ada-Lovelace.session");
    ck_assert_int_eq(session_exit(&session), 0);
    session_close(&session);
    snprintf(file, sizeof file, "%s/homework-late-Ada-Lovelace.session", folder);
    char text[400] = "";
    FILE *kept = fopen(file, "r");
    ck_assert_ptr_nonnull(kept);
    ck_assert_uint_gt(fread(text, 1, sizeof text - 1, kept), 0);
    fclose(kept);
    ck_assert_ptr_nonnull(strstr(text, "\nstudent Ada Lovelace\nid 17\n"));
    unlink(file);
    ck_assert_int_eq(chdir(was), 0);
    rmdir(folder);
}
END_TEST

START_TEST(idle_costs_nothing)
{
    Session session;
    session_open_paused(&session, 80, 24, NULL);
    expect_quiet(&session);
    session_close(&session);
}
END_TEST

/* At all: after how many milliseconds is what make bench measures. */
START_TEST(a_key_is_answered_while_a_crack_runs)
{
    Session session;
    session_open(&session, 80, 24, NULL, (const char *const[]){matvib(), "notched-beam", NULL});
    for (int i = 0; i < 8; i++) {
        session_frame(&session);
        ck_assert(!session_shows(&session, "PAUSED"));
        session_send(&session, " ");
        session_wait_for(&session, "PAUSED");
        session_send(&session, " ");
        session_wait_for(&session, "RUNNING");
    }
    session_close(&session);
}
END_TEST

/* The byte of Esc begins every sequence: that nothing follows must be seen while the engine takes all the
 * time. */
START_TEST(escape_is_answered_while_a_crack_runs)
{
    Session session;
    session_open(&session, 80, 24, NULL, (const char *const[]){matvib(), "notched-beam", NULL});
    session_frame(&session);
    session_send(&session, "g");
    session_wait_for(&session, "go to time");
    session_send(&session, "\033");
    while (session_shows(&session, "go to time"))
        session_frame(&session);
    ck_assert(!session_shows(&session, "go to time"));
    session_close(&session);
}
END_TEST

START_TEST(resizes)
{
    Session session;
    session_open_paused(&session, 80, 24, NULL);
    session_resize(&session, 132, 43);
    session_idle(&session);
    ck_assert(session_shows(&session, "PAUSED"));
    ck_assert(strlen(session_row(&session, 20)) > 100);
    session_resize(&session, 30, 8);
    session_idle(&session);
    ck_assert(!session_shows(&session, "PAUSED"));
    session_resize(&session, 80, 24);
    session_idle(&session);
    ck_assert(session_shows(&session, "PAUSED"));
    session_close(&session);
}
END_TEST

START_TEST(resizes_while_running)
{
    Session session;
    session_open(&session, 80, 24, NULL, (const char *const[]){matvib(), "mode1", NULL});
    session_frame(&session);
    for (int i = 0; i < 20; i++) {
        session_resize(&session, 40 + 7 * i, 12 + 2 * i);
        session_frame(&session);
    }
    session_keys(&session, " ");
    ck_assert(session_shows(&session, "PAUSED"));
    session_close(&session);
}
END_TEST

/* On one computer each begins at the first page of a homework, however far another came. */
START_TEST(a_homework_is_each_student_s_own)
{
    static const char *const names[] = {"Ada", "Max"};
    char folder[] = "/tmp/matvib-XXXXXX", state[64], file[64];
    ck_assert_ptr_nonnull(mkdtemp(folder));
    snprintf(state, sizeof state, "XDG_STATE_HOME=%s", folder);
    for (int i = 0; i < 2; i++) {
        Session session;
        snprintf(file, sizeof file, "%s/%s.session", folder, names[i]);
        session_open(
            &session, 80, 24, (const char *const[]){state, NULL},
            (const char *const[]){matvib(), "lesson", "late", "--name", names[i], "--record", file, NULL});
        session_wait_for(&session, " 1/");
        session_send(&session, "n");
        session_wait_for(&session, " 2/");
        session_send(&session, "q");
        ck_assert_int_eq(session_exit(&session), 0);
        session_close(&session);
    }
    char command[96];
    snprintf(command, sizeof command, "rm -r %s", folder);
    ck_assert_int_eq(system(command), 0);
}
END_TEST

START_TEST(a_recorded_session_is_the_last_one_too)
{
    char folder[] = "/tmp/matvib-XXXXXX", state[64], file[64], command[192];
    ck_assert_ptr_nonnull(mkdtemp(folder));
    snprintf(state, sizeof state, "XDG_STATE_HOME=%s", folder);
    snprintf(file, sizeof file, "%s/mine.session", folder);
    Session session;
    session_open(&session, 80, 24, (const char *const[]){state, NULL},
                 (const char *const[]){matvib(), "mode1", "--paused", "--record", file, NULL});
    session_idle(&session);
    session_keys(&session, ".");
    session_send(&session, "q");
    ck_assert_int_eq(session_exit(&session), 0);
    session_close(&session);
    snprintf(command, sizeof command, "cmp %s %s/matvib/last.session && rm -r %s", file, folder, folder);
    ck_assert_int_eq(system(command), 0);
}
END_TEST

/* Who has no state yet is offered the first lesson, in a line of its own; one key takes it, any other does
 * what it always does. Once left, the program knows its user; and the session that was the first can be done
 * again. */
START_TEST(a_first_start_offers_the_first_lesson)
{
    char folder[] = "/tmp/matvib-XXXXXX", state[64], file[64], command[64];
    ck_assert_ptr_nonnull(mkdtemp(folder));
    snprintf(state, sizeof state, "XDG_STATE_HOME=%s", folder);
    snprintf(file, sizeof file, "%s/mine.session", folder);
    const char *const environment[] = {state, NULL};
    for (int start = 0; start < 4; start++) {
        static const char *const key[] = {"\r", ".", "", "."};
        const char *const fresh[] = {matvib(), "mode1", "--paused", "--record", file, NULL};
        const char *const again[] = {matvib(), "--replay", file, "--fast", NULL};
        const char *const known[] = {matvib(), "mode1", "--paused", NULL};
        if (start == 1) { /* no state again, and another key */
            snprintf(command, sizeof command, "rm -r %s/matvib", folder);
            ck_assert_int_eq(system(command), 0);
        }
        Session session;
        session_open(&session, 80, 24, environment, start == 0 ? fresh : start == 2 ? again : known);
        session_idle(&session);
        ck_assert(start == 2 || session_shows(&session, "Enter first lesson") == (start < 2));
        ck_assert(start == 2 || session_shows(&session, "frequency error")); /* on the plain sheet */
        if (*key[start])
            session_keys(&session, key[start]);
        ck_assert(!session_shows(&session, "Enter first lesson"));
        ck_assert(session_shows(&session, "One step of MPM") == (start == 0 || start == 2));
        ck_assert(session_shows(&session, "t 0.01 ") == (start == 1 || start == 3));
        session_send(&session, "\003");
        session_exit(&session);
        session_close(&session);
    }
    snprintf(command, sizeof command, "rm -r %s", folder);
    ck_assert_int_eq(system(command), 0);
}
END_TEST

/* What a page is told behind a picture: a name that holds what parts the commands adds none. */
START_TEST(a_name_writes_no_command_of_the_page)
{
    char folder[] = "/tmp/matvib-page-XXXXXX", path[64], command[200];
    ck_assert_ptr_nonnull(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/x;M9999,9999 @9.ini", folder);
    snprintf(command, sizeof command, "\"%s\" show mode1 > \"%s\"", matvib(), path);
    ck_assert_int_eq(system(command), 0);
    Session session;
    session_open(&session, 80, 24, (const char *const[]){"MATVIB_VECTORS=1", NULL},
                 (const char *const[]){matvib(), path, "--paused", "--set", "mesh.cell_size=0.5", NULL});
    session_idle(&session);
    ck_assert(session_wrote(&session, ";Kmesh.cell_size=0.5"));
    ck_assert(session_wrote(&session, "/xM9999,9999 @9.ini;K"));
    snprintf(command, sizeof command, ";N%s/x;", folder);
    ck_assert(!session_wrote(&session, command));
    session_close(&session);
    ck_assert_int_eq(unlink(path), 0);
    ck_assert_int_eq(rmdir(folder), 0);
}
END_TEST

START_TEST(control_c_leaves)
{
    Session session;
    session_open_paused(&session, 80, 24, NULL);
    session_send(&session, "\003");
    ck_assert_int_eq(session_exit(&session), 0);
    session_check_restored(&session);
    session_close(&session);
}
END_TEST

START_TEST(escape_is_told_from_a_sequence)
{
    Session session;
    session_open_paused(&session, 80, 24, NULL);
    session_keys(&session, "?");
    ck_assert(!session_shows(&session, "PAUSED") || session_shows(&session, "elp"));
    session_keys(&session, "\033");
    ck_assert(session_shows(&session, "PAUSED"));
    session_keys(&session, "\033[4~\033[1~"); /* End, Home under xterm's TERM */
    ck_assert(session_shows(&session, "step 0"));
    session_close(&session);
}
END_TEST

/* A slow line brings the bytes of a key apart. However late they are here, ESCDELAY waits longer. */
START_TEST(a_torn_arrow_is_no_command)
{
    Session session;
    session_open_paused(&session, 80, 24, (const char *const[]){"ESCDELAY=10000", NULL});
    session_keys(&session, ".");
    ck_assert(session_shows(&session, "step 1"));
    for (const char *byte = "\033[B"; *byte; byte++) {
        session_send(&session, (char[]){*byte, '\0'});
        usleep(60000);
    }
    session_idle(&session);
    ck_assert(session_shows(&session, "step 1 "));
    session_keys(&session, ".");
    ck_assert(session_shows(&session, "step 2 ") && !session_shows(&session, "does nothing"));
    session_close(&session);
}
END_TEST

/* ^C leaves, whatever has begun and not ended. */
START_TEST(control_c_ends_a_paste)
{
    static const char *const beginnings[] = {"\033[200~", "\033P", "\033_"};
    for (int i = 0; i < 3; i++) {
        Session session;
        session_open_paused(&session, 80, 24, NULL);
        session_send(&session, beginnings[i]);
        session_send(&session, "some text\003");
        ck_assert_int_eq(session_exit(&session), 0);
        session_close(&session);
    }
}
END_TEST

/* A stopped program gets no SIGWINCH: that goes to whoever has the terminal then. */
START_TEST(takes_the_size_that_it_finds_after_a_stop)
{
    Session session;
    char script[4096];
    snprintf(script, sizeof script, "set -m; '%s' mode1 --paused; echo STOPPED; read line; fg >/dev/null",
             matvib());
    session_open(&session, 80, 24, NULL, (const char *const[]){"sh", "-c", script, NULL});
    session_idle(&session);
    session_send(&session, "\032");
    session_wait_for(&session, "STOPPED");
    session_resize(&session, 132, 43);
    session_send(&session, "\n");
    session_idle(&session);
    ck_assert(session_shows(&session, "PAUSED"));
    ck_assert(strstr(session_row(&session, 42), "quit") != NULL);
    session_close(&session);
}
END_TEST

START_TEST(suspends_and_comes_back)
{
    Session session;
    char script[4096];
    snprintf(
        script, sizeof script,
        "set -m; '%s' mode1 --paused --sheet full; echo STOPPED; read line; fg >/dev/null; echo \"left $?\"",
        matvib());
    session_open(&session, 80, 24, NULL, (const char *const[]){"sh", "-c", script, NULL});
    session_idle(&session);
    session_send(&session, "\032");
    session_wait_for(&session, "STOPPED");
    session_check_restored(&session);
    session_send(&session, "\n");
    session_idle(&session);
    ck_assert(session.alternate);
    ck_assert(session_shows(&session, "PAUSED"));
    session_keys(&session, ".");
    ck_assert(session_shows(&session, "step 1"));
    session_send(&session, "q");
    session_wait_for(&session, "left 0");
    ck_assert_int_eq(session_exit(&session), 0);
    session_check_restored(&session);
    session_close(&session);
}
END_TEST

START_TEST(colours_and_no_colours)
{
    Session session;
    session_open_paused(&session, 80, 24, NULL);
    ck_assert(session_wrote(&session, "\033[38;5;") || session_wrote(&session, ";38;5;"));
    session_close(&session);
    session_open_paused(&session, 80, 24, (const char *const[]){"NO_COLOR=1", NULL});
    ck_assert(!session_wrote(&session, "38;5;") && !session_wrote(&session, "48;5;"));
    for (int colour = 0; colour < 8; colour++) {
        char set[16];
        snprintf(set, sizeof set, "\033[3%dm", colour);
        ck_assert(!session_wrote(&session, set));
    }
    session_close(&session);
    session_open_paused(&session, 80, 24, (const char *const[]){"NO_COLOR=", NULL});
    ck_assert(session_wrote(&session, "38;5;"));
    session_close(&session);
}
END_TEST

START_TEST(the_mouse_is_asked_for_unless_it_is_not_wanted)
{
    Session session;
    session_open_paused(&session, 80, 24, NULL);
    ck_assert_int_eq(session.mouse, VTERM_PROP_MOUSE_DRAG);
    session_send(&session, "q");
    ck_assert_int_eq(session_exit(&session), 0);
    session_check_restored(&session);
    session_close(&session);
    session_open_paused(&session, 80, 24, NULL);
    session_keys(&session, "\033[<0;6;11M\033[<32;10;11M\033[<0;10;11m"); /* a value is pulled up */
    ck_assert(session_shows(&session, "velocity            0.5"));
    session_close(&session);
    session_open(&session, 80, 24, NULL,
                 (const char *const[]){matvib(), "mode1", "--paused", "--sheet", "full", "--no-mouse", NULL});
    session_idle(&session);
    ck_assert_int_eq(session.mouse, VTERM_PROP_MOUSE_NONE);
    session_keys(&session, "\033[<0;6;11M\033[<32;10;11M\033[<0;10;11m."); /* that of another program */
    ck_assert(session_shows(&session, "velocity            0.1"));
    session_close(&session);
}
END_TEST

/* Only a terminal that says so is told where a picture begins and ends. */
START_TEST(pictures_are_whole_where_the_terminal_can_wait)
{
    Session session;
    session_open_paused(&session, 80, 24, NULL);
    ck_assert(session_wrote(&session, "\033[?2026$p"));
    session_keys(&session, "\033[?2026;0$y.");
    ck_assert(session_shows(&session, "step 1"));
    ck_assert(!session_wrote(&session, "\033[?2026h"));
    session_keys(&session, "\033[?2026;2$y.");
    ck_assert(session_shows(&session, "step 2"));
    const char *begin = memmem(session.bytes, session.n_bytes, "\033[?2026h", 8);
    ck_assert_ptr_nonnull(begin);
    ck_assert(session_wrote_last(&session, "\033[?2026l", "\033[?2026h"));
    ck_assert_mem_eq(session.bytes + session.n_bytes - 12, "\033[?2026l\033[5n", 12);
    session_close(&session);
}
END_TEST

/* Wide characters, one that goes on top of another, one that turns the row, C1: from a keyboard all can come.
 */
START_TEST(no_text_leaves_its_cells)
{
    char row[256];
    Session session;
    session_open_paused(&session, 80, 24, NULL);
    session_keys(&session, ":梁の振動e\xcc\x81\xc2\x9b"
                           "31m\xe2\x80\xaex");
    /* what is no text does not arrive, so that a session that is recorded can be read */
    ck_assert_msg(session_shows(&session, ": 梁の振動e?31mx"), "%s", session_row(&session, 23));
    for (int i = 0; i < 50; i++) /* up to the end of the row, and beyond */
        session_keys(&session, "梁");
    ck_assert(!session_wrote(&session, "\xc2\x9b") && !session_wrote(&session, "\xcc\x81"));
    ck_assert(!session_wrote(&session, "\xe2\x80\xae"));
    snprintf(row, sizeof row, "%s", session_row(&session, 22));
    session_keys(&session, "\014"); /* drawn anew, nothing has moved */
    ck_assert_str_eq(session_row(&session, 22), row);
    session_close(&session);
}
END_TEST

/* A wide sign that the C library does not know is as many question marks as it has columns. */
START_TEST(an_unknown_sign_keeps_its_columns)
{
    const bool known = wcwidth(0x2fff0) == 2;
    Session session;
    session_open_paused(&session, 80, 24, NULL);
    session_keys(&session, ":\xf0\xaf\xbf\xb0x");
    ck_assert_msg(session_shows(&session, known ? ": \xf0\xaf\xbf\xb0x" : ": ??x"), "%s",
                  session_row(&session, 23));
    session_close(&session);
}
END_TEST

START_TEST(the_c_locale_gets_ascii)
{
    Session session;
    session_open_paused(&session, 80, 24, (const char *const[]){"LC_ALL=C", NULL});
    ck_assert(session_shows(&session, "PAUSED"));
    for (size_t i = 0; i < session.n_bytes; i++)
        ck_assert_msg((unsigned char)session.bytes[i] < 0x80, "byte %02x", (unsigned char)session.bytes[i]);
    session_close(&session);
}
END_TEST

/* ssh hands on the name of a locale that the machine may not have; its characters are those of UTF-8. */
START_TEST(a_locale_that_is_not_installed_gets_braille)
{
    Session session;
    session_open_paused(&session, 80, 24, (const char *const[]){"LC_ALL=xx_XX.UTF-8", NULL});
    ck_assert(session_shows(&session, "\u2812\u2812 measured"));
    session_close(&session);
}
END_TEST

START_TEST(braille_is_refused_where_it_would_be_question_marks)
{
    Session session;
    session_open(&session, 80, 24, (const char *const[]){"LC_ALL=C", NULL},
                 (const char *const[]){matvib(), "mode1", "--glyphs", "braille", NULL});
    ck_assert_int_eq(session_exit(&session), 2);
    ck_assert(session_shows(&session, "braille needs UTF-8, and this locale has"));
    session_close(&session);
}
END_TEST

START_TEST(keys_come_back_behind_a_message)
{
    Session session;
    session_open_paused(&session, 80, 24, NULL);
    session_keys(&session, ":help go\r");
    session_wait_for(&session, "to a time (12.5)");
    session_wait_for(&session, "q quit");
    session_close(&session);
}
END_TEST

/* Some a machine may not know: then the nearest that it does. */
static const char *const terms[] = {
    "TERM=xterm-256color",  "TERM=xterm",       "TERM=putty",           "TERM=putty-256color", "TERM=screen",
    "TERM=screen-256color", "TERM=tmux",        "TERM=tmux-256color",   "TERM=linux",          "TERM=vt100",
    "TERM=vt220",           "TERM=xterm-kitty", "TERM=no-such-terminal"};
static const char *const locales[] = {"LC_ALL=C.UTF-8", "LC_ALL=C"};
enum { N_TERMS = sizeof terms / sizeof *terms };

START_TEST(works_on_many_terminals)
{
    Session session;
    session_open_paused(&session, 80, 24,
                        (const char *const[]){terms[_i % N_TERMS], locales[_i / N_TERMS], NULL});
    ck_assert(session_shows(&session, "PAUSED"));
    session_keys(&session, "\033OB\033[B]");
    ck_assert(session_shows(&session, "stage 1"));
    session_keys(&session, ".");
    ck_assert(session_shows(&session, "step 1"));
    session_send(&session, "q");
    ck_assert_int_eq(session_exit(&session), 0);
    session_check_restored(&session);
    session_close(&session);
}
END_TEST

START_TEST(tells_what_an_unknown_terminal_is_taken_for)
{
    Session session;
    session_open_paused(&session, 80, 24, (const char *const[]){"TERM=xterm-nobody-knows", NULL});
    ck_assert(session_shows(&session, "TERM=xterm-nobody-knows"));
    ck_assert(session_shows(&session, "drawn as on xterm-256color"));
    ck_assert(session_wrote(&session, "38;5;"));
    session_close(&session);
    session_open_paused(&session, 80, 24, (const char *const[]){"TERM=no-such-terminal", NULL});
    ck_assert(session_shows(&session, "drawn as on vt100"));
    ck_assert(!session_wrote(&session, "38;5;") && !session_wrote(&session, "\033[34m"));
    session_close(&session);
}
END_TEST

/* Threads that wait for work cost nothing either, and leave signals to the one that sleeps until they come.
 */
START_TEST(several_threads_are_as_quiet_as_one)
{
    Session session;
    session_open(&session, 80, 24, NULL,
                 (const char *const[]){matvib(), "supported-beam-coarse", "--threads", "3", NULL});
    for (int i = 0; i < 3; i++)
        session_frame(&session);
    session_keys(&session, " ");
    expect_quiet(&session);
    for (int i = 0; i < 10; i++) {
        session_resize(&session, 81 - i % 2, 24);
        session_idle(&session);
    }
    kill(session.child, SIGTERM);
    ck_assert_int_eq(session_exit(&session), 128 + SIGTERM);
    session_check_restored(&session);
    session_close(&session);
}
END_TEST

static const char *const unusable[] = {"TERM=dumb", "TERM="};

START_TEST(says_what_to_use_where_it_cannot_draw)
{
    Session session;
    session_open(&session, 80, 24, (const char *const[]){unusable[_i], NULL},
                 (const char *const[]){matvib(), "mode1", NULL});
    ck_assert_int_eq(session_exit(&session), 2);
    ck_assert(session_wrote(&session, "matvib run"));
    session_check_restored(&session);
    session_close(&session);
}
END_TEST

/* 9600 baud: 960 bytes a second. The full sheet is some 3 kB once, and a frame of a run up to 1 kB. */
START_TEST(a_key_is_seen_behind_one_frame_of_a_slow_line)
{
    const char *const command[] = {matvib(), "mode5", "--sheet", "full", NULL};
    for (int mute = 0; mute < 2; mute++) {
        Session session;
        session_open(&session, 80, 24, NULL, command);
        session.mute = mute;
        session_trickle(&session, NULL, 960, 8);
        ck_assert(session_shows(&session, "RUNNING"));
        session_send(&session, " ");
        const size_t behind = session_trickle(&session, "PAUSED", 9600, 20);
        ck_assert(session_shows(&session, "PAUSED"));
        if (!mute) /* the picture under way and the one that says it, of up to 3000 bytes each */
            ck_assert_uint_lt(behind, 6000);
        session_send(&session, "q");
        ck_assert_int_eq(session_exit(&session), 0);
        session_check_restored(&session);
        session_close(&session);
    }
}
END_TEST

START_TEST(no_answer_is_typed_into_the_shell)
{
    Session session;
    session_open(&session, 80, 24, NULL, (const char *const[]){matvib(), "mode5", NULL});
    session_frame(&session);
    session_send(&session, "q");
    ck_assert_int_eq(session_exit(&session), 0);
    struct termios raw = session.modes;
    raw.c_lflag &= ~(tcflag_t)ICANON;
    raw.c_cc[VMIN] = raw.c_cc[VTIME] = 0;
    tcsetattr(session.slave, TCSANOW, &raw);
    char rest[64];
    ck_assert_int_eq(read(session.slave, rest, sizeof rest), 0);
    session_close(&session);
}
END_TEST

START_TEST(needs_a_terminal)
{
    char command[4096], line[512] = "";
    snprintf(command, sizeof command, "'%s' mode1 2>&1 </dev/null", matvib());
    FILE *pipe = popen(command, "r");
    ck_assert_ptr_nonnull(pipe);
    ck_assert_ptr_nonnull(fgets(line, sizeof line, pipe));
    ck_assert_ptr_nonnull(strstr(line, "matvib run"));
    ck_assert_ptr_null(fgets(line, sizeof line, pipe));
    int status = pclose(pipe);
    ck_assert(WIFEXITED(status) && WEXITSTATUS(status) == 2);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("terminal");
    tcase_add_test(tcase, opens_answers_keys_and_leaves);
    tcase_add_test(tcase, opens_running);
    tcase_add_test(tcase, a_still_picture_writes_nothing);
    tcase_add_test(tcase, pasted_text_runs_no_commands);
    tcase_add_test(tcase, homework_asks_whose_it_is);
    tcase_add_test(tcase, idle_costs_nothing);
    tcase_add_test(tcase, a_key_is_answered_while_a_crack_runs);
    tcase_add_test(tcase, escape_is_answered_while_a_crack_runs);
    tcase_add_test(tcase, resizes);
    tcase_add_test(tcase, resizes_while_running);
    tcase_add_test(tcase, a_homework_is_each_student_s_own);
    tcase_add_test(tcase, a_recorded_session_is_the_last_one_too);
    tcase_add_test(tcase, a_first_start_offers_the_first_lesson);
    tcase_add_test(tcase, a_name_writes_no_command_of_the_page);
    tcase_add_test(tcase, control_c_leaves);
    tcase_add_test(tcase, escape_is_told_from_a_sequence);
    tcase_add_test(tcase, a_torn_arrow_is_no_command);
    tcase_add_test(tcase, control_c_ends_a_paste);
    tcase_add_test(tcase, takes_the_size_that_it_finds_after_a_stop);
    tcase_add_test(tcase, suspends_and_comes_back);
    tcase_add_test(tcase, colours_and_no_colours);
    tcase_add_test(tcase, the_mouse_is_asked_for_unless_it_is_not_wanted);
    tcase_add_test(tcase, pictures_are_whole_where_the_terminal_can_wait);
    tcase_add_test(tcase, no_text_leaves_its_cells);
    tcase_add_test(tcase, an_unknown_sign_keeps_its_columns);
    tcase_add_test(tcase, the_c_locale_gets_ascii);
    tcase_add_test(tcase, a_locale_that_is_not_installed_gets_braille);
    tcase_add_test(tcase, braille_is_refused_where_it_would_be_question_marks);
    tcase_add_test(tcase, keys_come_back_behind_a_message);
    tcase_add_loop_test(tcase, works_on_many_terminals, 0, 2 * N_TERMS);
    tcase_add_test(tcase, tells_what_an_unknown_terminal_is_taken_for);
    tcase_add_test(tcase, several_threads_are_as_quiet_as_one);
    tcase_add_loop_test(tcase, says_what_to_use_where_it_cannot_draw, 0, 2);
    tcase_add_test(tcase, a_key_is_seen_behind_one_frame_of_a_slow_line);
    tcase_add_test(tcase, no_answer_is_typed_into_the_shell);
    tcase_add_test(tcase, needs_a_terminal);
    suite_add_tcase(suite, tcase);
}
