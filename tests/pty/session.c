/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pty/session.h"

#include "suite.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#ifdef HAVE_PTY_H
#include <pty.h>
#endif
#ifdef HAVE_UTMP_H
#include <utmp.h>
#endif
#ifdef HAVE_UTIL_H
#include <util.h>
#endif
#ifdef HAVE_LIBUTIL_H
#include <libutil.h>
#endif

/* a program that hangs is found; one on a busy machine is not */
enum { PATIENCE_MS = 60000, FRAME_FD = 9 };

static int on_property(VTermProp property, VTermValue *value, void *user)
{
    Session *session = user;
    if (property == VTERM_PROP_ALTSCREEN)
        session->alternate = value->boolean;
    if (property == VTERM_PROP_CURSORVISIBLE)
        session->cursor_visible = value->boolean;
    if (property == VTERM_PROP_MOUSE)
        session->mouse = value->number;
    return 1;
}

static const VTermScreenCallbacks callbacks = {.settermprop = on_property};

static void become(Session *session, int frames, const char *const *environment, const char *const *command)
{
    signal(SIGTERM, SIG_DFL); /* the tests' own handler ends all that they started */
    setenv("TERM", "xterm-256color", 1);
    setenv("LC_ALL", "C.UTF-8", 1);
    unsetenv("NO_COLOR");
    unsetenv("COLORFGBG");
    for (; environment && *environment; environment++) {
        char *equals = strchr(*environment, '=');
        char name[64];
        snprintf(name, sizeof name, "%.*s", equals ? (int)(equals - *environment) : 63, *environment);
        if (equals)
            setenv(name, equals + 1, 1);
        else
            unsetenv(name);
    }
    char number[16];
    snprintf(number, sizeof number, "%d", FRAME_FD);
    setenv("MATVIB_FRAME_FD", number, 1);
    /* whoever started the tests may have left any descriptor open, so ours may stand at FRAME_FD already */
    int slave = fcntl(session->slave, F_DUPFD, FRAME_FD + 1);
    int pipe_end = fcntl(frames, F_DUPFD, FRAME_FD + 1);
    close(session->master);
    close(session->slave);
    close(frames);
    dup2(pipe_end, FRAME_FD);
    close(pipe_end);
    login_tty(slave);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    /* nohup has the first ignored, a shell in the background the others */
    signal(SIGHUP, SIG_DFL), signal(SIGINT, SIG_DFL), signal(SIGQUIT, SIG_DFL);
    char *arguments[16] = {NULL};
    for (int i = 0; command[i] && i < 15; i++)
        arguments[i] = (char *)(size_t)command[i];
    execvp(arguments[0], arguments);
    _exit(127);
}

void session_open(Session *session, int columns, int rows, const char *const *environment,
                  const char *const *command)
{
    struct winsize size = {.ws_row = (unsigned short)rows, .ws_col = (unsigned short)columns};
    int frames[2];
    *session = (Session){.rows = rows, .columns = columns, .cursor_visible = true};
    ck_assert_int_eq(openpty(&session->master, &session->slave, NULL, NULL, &size), 0);
    ck_assert_int_eq(pipe(frames), 0);
    tcgetattr(session->slave, &session->modes);
    session->frames = frames[0];
    session->vterm = vterm_new(rows, columns);
    vterm_set_utf8(session->vterm, 1);
    session->screen = vterm_obtain_screen(session->vterm);
    vterm_screen_enable_altscreen(session->screen, 1);
    vterm_screen_set_callbacks(session->screen, &callbacks, session);
    vterm_screen_reset(session->screen, 1);
    fflush(NULL);
    session->child = fork();
    ck_assert_int_ge(session->child, 0);
    if (session->child == 0) {
        close(frames[0]);
        become(session, frames[1], environment, command);
    }
    close(frames[1]);
    fcntl(session->master, F_SETFD, FD_CLOEXEC);
    fcntl(session->slave, F_SETFD, FD_CLOEXEC);
    fcntl(session->frames, F_SETFD, FD_CLOEXEC);
}

static const char *program(void)
{
    const char *path = getenv("MATVIB");
    return path ? path : "./matvib";
}

void session_open_paused(Session *session, int columns, int rows, const char *const *environment)
{
    session_open(session, columns, rows, environment,
                 (const char *const[]){program(), "mode1", "--paused", "--sheet", "full", NULL});
    session_idle(session);
}

void session_close(Session *session)
{
    if (session->child > 0) {
        kill(session->child, SIGKILL);
        kill(session->child, SIGCONT);
        waitpid(session->child, NULL, 0);
    }
    close(session->master);
    close(session->slave);
    close(session->frames);
    vterm_free(session->vterm);
    free(session->bytes);
}

/* `most` bytes, or fewer. */
static void take(Session *session, size_t most)
{
    char piece[4096];
    ssize_t got = read(session->master, piece, most < sizeof piece ? most : sizeof piece);
    if (got <= 0)
        return;
    if (session->n_bytes + (size_t)got > session->room) {
        session->room = 2 * (session->n_bytes + (size_t)got);
        session->bytes = realloc(session->bytes, session->room);
        ck_assert_ptr_nonnull(session->bytes);
    }
    memcpy(session->bytes + session->n_bytes, piece, (size_t)got);
    session->n_bytes += (size_t)got;
    vterm_input_write(session->vterm, piece, (size_t)got);
    /* what the terminal is asked for it answers */
    const size_t answer = vterm_output_read(session->vterm, piece, sizeof piece);
    if (answer > 0 && !session->mute)
        ck_assert_int_eq(write(session->master, piece, answer), (ssize_t)answer);
}

size_t session_trickle(Session *session, const char *text, double rate, double seconds)
{
    const struct timespec pause = {0, 50000000};
    size_t count = 0;
    for (double passed = 0; passed < seconds && !(text && session_shows(session, text)); passed += 0.05) {
        const size_t before = session->n_bytes;
        struct pollfd master = {.fd = session->master, .events = POLLIN};
        nanosleep(&pause, NULL);
        if (poll(&master, 1, 0) > 0)
            take(session, (size_t)(0.05 * rate));
        count += session->n_bytes - before;
    }
    return count;
}

/* Takes all that has been written already. */
static void drain(Session *session)
{
    struct pollfd master = {.fd = session->ignored ? -1 : session->master, .events = POLLIN};
    while (poll(&master, 1, 0) > 0 && (master.revents & POLLIN))
        take(session, SIZE_MAX);
}

/* Reads one line of the frame pipe if there is one; false: the program has closed it. */
static bool read_line(Session *session, char *line, size_t size)
{
    size_t length = 0;
    char byte;
    while (read(session->frames, &byte, 1) == 1) {
        if (byte == '\n') {
            line[length] = '\0';
            return true;
        }
        if (length + 1 < size)
            line[length++] = byte;
    }
    line[0] = '\0';
    return false;
}

/* Pumps until a line with `ending` has come; false: the program is gone or time is up. */
static bool pump(Session *session, const char *ending)
{
    struct pollfd both[2] = {{.fd = session->master, .events = POLLIN},
                             {.fd = session->frames, .events = POLLIN}};
    char line[64];
    while (poll(both, 2, PATIENCE_MS) > 0) {
        if (both[0].revents & POLLIN)
            take(session, SIZE_MAX);
        if (both[1].revents) {
            if (!read_line(session, line, sizeof line))
                return false;
            if (strstr(line, ending)) {
                drain(session);
                return true;
            }
        }
    }
    return false;
}

static void told(Session *session, const char *ending)
{
    if (pump(session, ending))
        return;
    drain(session);
    char all[8192] = "";
    for (int row = 0; row < session->rows; row++)
        snprintf(all + strlen(all), sizeof all - strlen(all), "%s\n", session_row(session, row));
    ck_abort_msg("no '%s' came; the screen:\n%s", ending, all);
}

void session_idle(Session *session)
{
    told(session, "idle");
}

bool session_idle_or_gone(Session *session)
{
    return pump(session, "idle");
}

void session_frame(Session *session)
{
    told(session, "frame");
}

void session_send(Session *session, const char *bytes)
{
    size_t length = strlen(bytes);
    ck_assert_int_eq(write(session->master, bytes, length), (ssize_t)length);
}

void session_keys(Session *session, const char *bytes)
{
    session_send(session, bytes);
    session_idle(session);
}

void session_resize(Session *session, int columns, int rows)
{
    struct winsize size = {.ws_row = (unsigned short)rows, .ws_col = (unsigned short)columns};
    session->rows = rows;
    session->columns = columns;
    vterm_set_size(session->vterm, rows, columns);
    ck_assert_int_eq(ioctl(session->master, TIOCSWINSZ, &size), 0);
}

void session_wait_for(Session *session, const char *text)
{
    struct pollfd master = {.fd = session->master, .events = POLLIN};
    while (!session_shows(session, text)) {
        ck_assert_msg(poll(&master, 1, PATIENCE_MS) > 0, "'%s' did not come", text);
        take(session, SIZE_MAX);
    }
}

void session_hang_up(Session *session)
{
    close(session->master);
    session->master = -1;
}

void session_ignore(Session *session)
{
    session->ignored = true;
}

void session_gone(Session *session)
{
    /* the frame pipe closes when the program is gone */
    struct pollfd both[2] = {{.fd = session->ignored ? -1 : session->master, .events = POLLIN},
                             {.fd = session->frames, .events = POLLIN}};
    char line[64];
    bool open = true;
    while (open) {
        ck_assert_msg(poll(both, 2, PATIENCE_MS) > 0, "the program does not end");
        if (both[0].revents & POLLIN)
            take(session, SIZE_MAX);
        if (both[1].revents)
            open = read_line(session, line, sizeof line);
    }
}

int session_exit(Session *session)
{
    session_gone(session);
    drain(session);
    int status;
    ck_assert_int_eq(waitpid(session->child, &status, 0), session->child);
    drain(session);
    session->child = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

const char *session_row(Session *session, int row)
{
    static char text[4096];
    VTermRect rect = {.start_row = row, .end_row = row + 1, .start_col = 0, .end_col = session->columns};
    size_t length = vterm_screen_get_text(session->screen, text, sizeof text - 1, rect);
    text[length] = '\0';
    return text;
}

bool session_shows(Session *session, const char *text)
{
    for (int row = 0; row < session->rows; row++)
        if (strstr(session_row(session, row), text))
            return true;
    return false;
}

static const char *last_of(const Session *session, const char *text)
{
    const char *left = session->bytes, *last = NULL;
    const char *end = left ? left + session->n_bytes : NULL; /* nothing was written yet */
    while (left < end && (left = memmem(left, (size_t)(end - left), text, strlen(text))) != NULL)
        last = left++;
    return last;
}

bool session_wrote(const Session *session, const char *text)
{
    return last_of(session, text) != NULL;
}

bool session_wrote_last(const Session *session, const char *text, const char *other)
{
    const char *one = last_of(session, text), *before = last_of(session, other);
    return one && (!before || one > before);
}

void session_check_restored(Session *session)
{
    struct termios modes;
    tcgetattr(session->slave, &modes);
    ck_assert_msg(!session->alternate, "the alternate screen is still on");
    ck_assert_msg(session->cursor_visible, "the cursor is still hidden");
    ck_assert_msg(session->mouse == VTERM_PROP_MOUSE_NONE, "the mouse is still reported");
    ck_assert_msg(!session_wrote_last(session, "\033[?2004h", "\033[?2004l"), "pastes are still marked");
    ck_assert_int_eq(modes.c_lflag, session->modes.c_lflag);
    ck_assert_int_eq(modes.c_iflag, session->modes.c_iflag);
    ck_assert_int_eq(modes.c_oflag, session->modes.c_oflag);
}
