/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "terminal/terminal.h"

#include "base/signals.h"
#include "base/wait.h"
#include "terminal/grid.h"

#include <errno.h>
#include <fcntl.h>
#include <langinfo.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/select.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

/* Signals reach a handler, and a handler reaches only what is static. */
static volatile sig_atomic_t signal_resized, signal_stop, signal_continued;
static struct termios before; /* the terminal's modes when we came */
static bool in_use;           /* from before it is opened until it is closed */
static Terminal *opened;      /* NULL: the screen is the shell's */

static const int crashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
static const int others[] = {SIGWINCH, SIGTSTP, SIGCONT};
enum { N_CRASHES = sizeof crashes / sizeof *crashes, N_OTHERS = sizeof others / sizeof *others };

/* How long the answer to a status report is waited for, s: the first one, and once one has come. */
#define FIRST_REPORT_SECONDS 1.0
#define REPORT_SECONDS       10.0
#define LAST_REPORT_SECONDS  2.0 /* on leaving: what comes later is typed into the shell */

enum { PATIENCE_MS = 300, PATIENCE_PIECES = 20 }; /* with a terminal that takes nothing, when we leave */

struct Terminal {
    Grid grid;
    int width, height;
    int input, output; /* what is read from and written to; neither blocks */
    Glyphs glyphs;
    const char *stand_in; /* as which an unknown TERM is treated; NULL: it is known */
    KeyReader keys;
    bool reports;          /* it has answered a status report */
    int asked;             /* status reports that it has not answered */
    double asked_at;       /* when the last of them was asked for */
    sigset_t mask_outside; /* the signal mask before we came, in force while sleeping */
    struct sigaction old_crashes[N_CRASHES], old_others[N_OTHERS];
};

/* --- bytes to the terminal -------------------------------------------------------------------------- */

/* Writes what the terminal takes. The rest waits: neither keys nor signals do, so that a terminal that takes
 * nothing any more (a connection that hangs) can still be left. */
static void send_some(Terminal *terminal)
{
    size_t left;
    for (const char *bytes; bytes = grid_bytes(&terminal->grid, &left), left > 0;) {
        const ssize_t written = write(terminal->output, bytes, left);
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0 && (errno == EAGAIN || errno == EWOULDBLOCK))
            return;
        /* that the terminal is gone will be noticed when reading */
        grid_sent(&terminal->grid, written > 0 ? (size_t)written : left);
    }
}

/* Also allowed in a handler of signals. False: the terminal takes nothing for too long. */
static bool wait_for_room(int output)
{
    struct pollfd screen = {.fd = output, .events = POLLOUT};
    int ready;
    do
        ready = poll(&screen, 1, PATIENCE_MS);
    while (ready < 0 && errno == EINTR);
    return ready > 0;
}

static bool has_bytes(const Terminal *terminal)
{
    size_t left;
    grid_bytes(&terminal->grid, &left);
    return left > 0;
}

/* --- status reports: one picture under way ---------------------------------------------------------- */

/* When it is not waited for any longer; 0: nothing is asked. */
static double report_due(const Terminal *terminal)
{
    return terminal->asked == 0
               ? 0
               : terminal->asked_at + (terminal->reports ? REPORT_SECONDS : FIRST_REPORT_SECONDS);
}

/* Not where the last report did not come in time: it comes late, and counts then, or never. */
static void ask(Terminal *terminal)
{
    if (terminal->asked > 0 && clock_seconds() >= report_due(terminal)) {
        terminal->reports = false;
        return;
    }
    grid_ask(&terminal->grid);
    terminal->asked++;
    terminal->asked_at = clock_seconds();
}

static void count_reports(Terminal *terminal)
{
    KeyReader *keys = &terminal->keys;
    if (keys->reports == 0)
        return;
    terminal->reports = true;
    terminal->asked = keys->reports < terminal->asked ? terminal->asked - keys->reports : 0;
    keys->reports = 0;
}

/* --- crashes ---------------------------------------------------------------------------------------- */

/* Gives the screen back without curses, in whatever state that is; all calls here are allowed in a handler.
 */
static void say_farewell(void)
{
    const Terminal *terminal = opened;
    if (!terminal)
        return;
    const char *bytes = terminal->grid.farewell;
    size_t left = terminal->grid.farewell_length;
    while (left > 0 && wait_for_room(terminal->output)) {
        const ssize_t written = write(terminal->output, bytes, left);
        if (written < 0)
            break;
        bytes += written;
        left -= (size_t)written;
    }
    tcsetattr(STDIN_FILENO, TCSANOW, &before);
}

/* A crash must not leave a terminal without echo behind. */
static void on_crash(int number)
{
    say_farewell();
    signals_end_at_once(number);
}

/* What was typed while something is computed that never asks for keys. The terminal makes no signal of ^C:
 * the first one waits here for terminal_key(), and the second one ends the program. */
static struct {
    char bytes[KEYS_ROOM];
    size_t count;
    bool interrupted;
} unread;

static void look_for_interrupt(int number)
{
    (void)number;
    const int errno_before = errno;
    char bytes[KEYS_ROOM];
    ssize_t got = opened ? read(opened->input, bytes, sizeof bytes) : 0;
    const bool again = unread.interrupted;
    for (ssize_t i = 0; i < got; i++) {
        if (unread.count < KEYS_ROOM)
            unread.bytes[unread.count++] = bytes[i];
        unread.interrupted |= bytes[i] == '\003';
        if (again && bytes[i] == '\003') {
            say_farewell();
            signals_end_at_once(SIGINT);
        }
    }
    errno = errno_before;
}

static void on_signal(int number)
{
    if (number == SIGWINCH)
        signal_resized = 1;
    else if (number == SIGTSTP)
        signal_stop = 1;
    else
        signal_continued = 1;
}

static void catch_signal(int number, void (*handler)(int), int flags, struct sigaction *old)
{
    struct sigaction action = {.sa_handler = handler, .sa_flags = flags};
    sigemptyset(&action.sa_mask);
    sigaction(number, &action, old);
}

static void release_signals(const Terminal *terminal)
{
    for (int i = 0; i < N_CRASHES; i++)
        sigaction(crashes[i], &terminal->old_crashes[i], NULL);
    signals_release();
    for (int i = 0; i < N_OTHERS; i++)
        sigaction(others[i], &terminal->old_others[i], NULL);
    sigprocmask(SIG_SETMASK, &terminal->mask_outside, NULL);
}

/* --- opening and closing ---------------------------------------------------------------------------- */

static bool read_size(Terminal *terminal)
{
    struct winsize size;
    int width = 80, height = 24;
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0) {
        width = size.ws_col;
        height = size.ws_row;
    }
    bool changed = width != terminal->width || height != terminal->height;
    terminal->width = width;
    terminal->height = height;
    return changed;
}

/* Opens the terminal again, not blocking: set on the descriptor that is shared with the shell, the flag
 * would change the shell's too. */
static int open_again(int descriptor, int how)
{
    const char *name = ttyname(descriptor);
    const int own = name ? open(name, how | O_NONBLOCK | O_NOCTTY | O_CLOEXEC) : -1;
    if (own >= 0 && own < FD_SETSIZE)
        return own;
    if (own >= 0)
        close(own);
    return descriptor;
}

static void close_again(int own, int descriptor)
{
    if (own >= 0 && own != descriptor)
        close(own);
}

/* Every key comes as it is, nothing is echoed, and output is not changed on its way. */
static void take_screen(Terminal *terminal)
{
    struct termios raw = before;
    raw.c_iflag &= ~(tcflag_t)(BRKINT | ICRNL | INLCR | IGNCR | ISTRIP | IXON);
    raw.c_lflag &= ~(tcflag_t)(ECHO | ECHONL | ICANON | ISIG | IEXTEN);
    raw.c_oflag &= ~(tcflag_t)OPOST;
    raw.c_cc[VMIN] = 0; /* reading never waits */
    raw.c_cc[VTIME] = 0;
    tcsetattr(STDIN_FILENO, TCSANOW, &raw);
    grid_enter(&terminal->grid);
    ask(terminal);
    send_some(terminal);
}

/* Never waits for the line to drain, which may take for ever. */
static void give_screen_back(Terminal *terminal)
{
    grid_leave(&terminal->grid);
    send_some(terminal);
    for (int i = 0; i < PATIENCE_PIECES && has_bytes(terminal) && wait_for_room(terminal->output); i++)
        send_some(terminal);
    /* Takes the answers that are still to come, byte by byte: what is typed behind them is the shell's. */
    const double latest = clock_seconds() + LAST_REPORT_SECONDS;
    struct pollfd keyboard = {.fd = terminal->input, .events = POLLIN};
    Key key;
    char byte;
    while (terminal->reports && terminal->asked > 0 && clock_seconds() < latest &&
           poll(&keyboard, 1, PATIENCE_MS) >= 0 && !(keyboard.revents & (POLLHUP | POLLERR | POLLNVAL))) {
        while (keys_next(&terminal->keys, &key))
            continue;
        if (keyboard.revents && read(terminal->input, &byte, 1) == 1)
            keys_feed(&terminal->keys, &byte, 1, clock_seconds());
        while (keys_next(&terminal->keys, &key))
            continue;
        count_reports(terminal);
    }
    terminal->asked = 0;
    tcsetattr(STDIN_FILENO, TCSANOW, &before);
}

/* A library that finds no memory or no thread may leave by exit(), in the middle of anything: ncurses does.
 * What it wrote before may have gone with the screen. */
static void leave(void)
{
    if (!in_use)
        return;
    say_farewell();
    fputs("matvib: a library ended the program, most likely for want of memory\n", stderr);
}

static bool open_picture(Terminal *terminal, const LaboratoryOptions *options, Status *status)
{
    const char *term = getenv("TERM"), *codeset = nl_langinfo(CODESET);
    Grid *grid = &terminal->grid;
    if (!grid_choose_glyphs(options->glyphs, codeset, term, &terminal->glyphs))
        return status_refuse(status, "--glyphs: unknown set '%s' (auto, braille, block or ascii)",
                             options->glyphs);
    if (!isatty(STDIN_FILENO) || !isatty(STDOUT_FILENO))
        return status_refuse(status, "the laboratory needs a terminal; without one use: matvib run SCENARIO, "
                                     "matvib lesson --list, or --plain");
    if (terminal->glyphs != GLYPHS_ASCII && strcmp(codeset, "UTF-8") != 0)
        return status_refuse(status,
                             "--glyphs: %s needs UTF-8, and this locale has %.40s (ascii; or LC_ALL=C.UTF-8)",
                             options->glyphs, codeset);
    grid->light = theme_is_light(options->theme, getenv("COLORFGBG"));
    grid->utf8 = strcmp(codeset, "UTF-8") == 0;
    terminal->input = open_again(STDIN_FILENO, O_RDONLY);
    terminal->output = open_again(STDOUT_FILENO, O_WRONLY);
    return grid_open(grid, term, !options->no_mouse, &terminal->stand_in, status);
}

static void free_terminal(Terminal *terminal)
{
    close_again(terminal->input, STDIN_FILENO);
    close_again(terminal->output, STDOUT_FILENO);
    free(terminal);
    in_use = false;
}

Terminal *terminal_open(const LaboratoryOptions *options, Status *status)
{
    static bool prepared;
    prepared = prepared || atexit(leave) == 0;
    Terminal *terminal = prepared ? calloc(1, sizeof *terminal) : NULL;
    if (!terminal) {
        status_fail(status, "out of memory");
        return NULL;
    }
    terminal->input = STDIN_FILENO;
    terminal->output = STDOUT_FILENO;
    in_use = true;
    /* before curses, which installs handlers for signals that have none */
    /* What asks for a look at the terminal comes only while terminal_wait() sleeps; what asks for an end
     * comes also while something is computed, so that the second time it ends even what never looks. */
    static char spare[32768]; /* for the handler when the stack is what has run out */
    const stack_t stack = {.ss_sp = spare, .ss_size = sizeof spare};
    sigset_t blocked;
    signal_resized = signal_stop = signal_continued = 0;
    signals_catch();
    signals_farewell(say_farewell);
    sigemptyset(&blocked);
    for (int i = 0; i < N_OTHERS; i++)
        sigaddset(&blocked, others[i]);
    sigprocmask(SIG_BLOCK, &blocked, &terminal->mask_outside);
    sigaltstack(&stack, NULL);
    for (int i = 0; i < N_CRASHES; i++)
        catch_signal(crashes[i], on_crash, SA_ONSTACK, &terminal->old_crashes[i]);
    for (int i = 0; i < N_OTHERS; i++)
        catch_signal(others[i], on_signal, 0, &terminal->old_others[i]);
    if (!open_picture(terminal, options, status)) {
        release_signals(terminal);
        free_terminal(terminal);
        return NULL;
    }
    keys_open(&terminal->keys, getenv("ESCDELAY"));
    tcgetattr(STDIN_FILENO, &before);
    read_size(terminal);
    grid_resize(&terminal->grid, terminal->width, terminal->height);
    opened = terminal;
    take_screen(terminal);
    wait_look(look_for_interrupt);
    return terminal;
}

void terminal_close(Terminal *terminal)
{
    if (!terminal)
        return;
    wait_look(NULL);
    give_screen_back(terminal);
    opened = NULL;
    grid_close(&terminal->grid);
    release_signals(terminal);
    free_terminal(terminal);
}

void terminal_size(const Terminal *terminal, int *width, int *height)
{
    *width = terminal->width;
    *height = terminal->height;
}

TerminalLook terminal_look(const Terminal *terminal)
{
    const Grid *grid = &terminal->grid;
    return (TerminalLook){terminal->glyphs, grid->colours, grid->light, grid->utf8, terminal->stand_in};
}

/* --- pictures and keys ------------------------------------------------------------------------------ */

void terminal_show(Terminal *terminal, const Canvas *canvas)
{
    grid_show(&terminal->grid, canvas);
    if (has_bytes(terminal))
        ask(terminal);
    send_some(terminal);
}

bool terminal_is_behind(const Terminal *terminal)
{
    return has_bytes(terminal) || clock_seconds() < report_due(terminal);
}

void terminal_redraw(Terminal *terminal)
{
    grid_redraw(&terminal->grid);
}

static void answer_signals(Terminal *terminal)
{
    if (signal_stop) {
        signal_stop = 0;
        terminal_suspend(terminal);
    }
    if (signal_continued) { /* after SIGSTOP, which cannot be caught: the shell has used the screen */
        signal_continued = 0;
        signal_resized = 1;
        grid_leave(&terminal->grid);
        take_screen(terminal);
    }
}

void terminal_wait(Terminal *terminal, double seconds)
{
    sigset_t ours;
    wait_look(NULL);
    signals_block(&ours); /* none is lost between looking and sleeping */
    if (signals_ended_by() || signal_resized || signal_stop || signal_continued) {
        sigprocmask(SIG_SETMASK, &ours, NULL);
        answer_signals(terminal); /* it came through terminal_signal() */
        wait_look(look_for_interrupt);
        return;
    }
    const double now = clock_seconds(), report = report_due(terminal);
    const double left = fmin(keys_due(&terminal->keys), report > now ? report : INFINITY) - now;
    if (left < INFINITY)
        seconds = fmax(0, seconds < 0 ? left : fmin(seconds, left));
    if (unread.count > 0)
        seconds = 0;
    struct timespec time = {.tv_sec = (time_t)seconds};
    time.tv_nsec = (long)((seconds - (double)time.tv_sec) * 1e9);
    struct pollfd files[] = {
        {.fd = terminal->input, .events = POLLIN},
        {.fd = has_bytes(terminal) ? terminal->output : -1, .events = POLLOUT},
    };
    const int ready = wait_for(files, 2, seconds < 0 ? NULL : &time, &terminal->mask_outside);
    sigprocmask(SIG_SETMASK, &ours, NULL);
    if (ready > 0 && files[0].revents & (POLLHUP | POLLERR | POLLNVAL))
        signals_end(SIGHUP); /* nobody is there any more */
    if (ready > 0 && files[1].revents)
        send_some(terminal);
    answer_signals(terminal);
    wait_look(look_for_interrupt);
}

bool terminal_has_input(const Terminal *terminal)
{
    struct pollfd keyboard = {.fd = terminal->input, .events = POLLIN};
    const struct timespec at_once = {0, 0};
    return unread.count > 0 || wait_for(&keyboard, 1, &at_once, NULL) > 0;
}

bool terminal_key(Terminal *terminal, Key *key)
{
    KeyReader *keys = &terminal->keys;
    bool any;
    wait_look(NULL);
    while (!(any = keys_next(keys, key))) {
        char bytes[KEYS_ROOM];
        const ssize_t got =
            unread.count > 0 ? (ssize_t)unread.count : read(terminal->input, bytes, sizeof bytes);
        if (got <= 0)
            break;
        keys_feed(keys, unread.count > 0 ? unread.bytes : bytes, (size_t)got, clock_seconds());
        unread.count = 0;
        unread.interrupted = false;
    }
    count_reports(terminal);
    wait_look(look_for_interrupt);
    any = any || keys_silence(keys, clock_seconds(), key);
    if (keys->answered && !terminal->grid.synchronised)
        grid_synchronise(&terminal->grid);
    return any;
}

bool terminal_resized(Terminal *terminal)
{
    if (!signal_resized)
        return false;
    signal_resized = 0;
    if (!read_size(terminal))
        return terminal->grid.shown.width == 0;
    grid_resize(&terminal->grid, terminal->width, terminal->height);
    return true;
}

int terminal_signal(const Terminal *terminal)
{
    sigset_t ours;
    /* one that waits comes in between */
    sigprocmask(SIG_SETMASK, &terminal->mask_outside, &ours);
    sigprocmask(SIG_SETMASK, &ours, NULL);
    return signals_ended_by();
}

void terminal_suspend(Terminal *terminal)
{
    give_screen_back(terminal);
    struct sigaction ours;
    catch_signal(SIGTSTP, SIG_DFL, 0, &ours);
    sigset_t stop, old;
    sigemptyset(&stop);
    sigaddset(&stop, SIGTSTP);
    raise(SIGTSTP);
    sigprocmask(SIG_UNBLOCK, &stop, &old); /* here the program stops, and here it goes on */
    sigprocmask(SIG_SETMASK, &old, NULL);
    sigaction(SIGTSTP, &ours, NULL);
    /* the SIGCONT that woke us has done its work */
    sigset_t woken, pending;
    int number;
    sigemptyset(&woken);
    sigaddset(&woken, SIGCONT);
    while (sigpending(&pending) == 0 && sigismember(&pending, SIGCONT) == 1 && sigwait(&woken, &number) == 0)
        continue;
    signal_continued = 0;
    signal_resized = 1; /* meanwhile the window may have become another */
    take_screen(terminal);
}
