#include "tui/terminal/terminal.h"

#include "base/wait.h"
#include "tui/terminal/description.h"
#include "tui/terminal/theme.h"

#include <errno.h>
#include <fcntl.h>
#include <langinfo.h>
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
static volatile sig_atomic_t signal_end, signal_resized, signal_stop, signal_continued;
static struct termios before; /* the terminal's modes when we came */
static char farewell[256];    /* what restores the screen, for a crash */
static size_t farewell_length;
static bool in_use;            /* from before it is opened until it is closed */
static const Terminal *opened; /* NULL: the screen is the shell's */

static const int ends[] = {SIGTERM, SIGHUP, SIGINT, SIGQUIT, SIGPIPE};
static const int crashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
enum { N_ENDS = sizeof ends / sizeof *ends, N_CRASHES = sizeof crashes / sizeof *crashes, INPUT_MAX = 512 };

struct Terminal {
    Painter painter;
    int width, height;
    int output; /* what is written to */
    bool mouse;
    Glyphs glyphs;
    const char *stand_in; /* as which an unknown TERM is treated; NULL: it is known */
    ScreenFrame frame;
    KeyDecoder decoder;
    unsigned char input[INPUT_MAX];
    size_t input_first, input_end;
    double read_at;        /* when the last byte came */
    bool expired;          /* no byte came in time after a beginning of a sequence */
    sigset_t mask_outside; /* the signal mask before we came, in force while sleeping */
    struct sigaction old_ends[N_ENDS], old_crashes[N_CRASHES], old_resize, old_stop, old_continue;
};

static void on_signal(int number)
{
    if (number == SIGWINCH)
        signal_resized = 1;
    else if (number == SIGTSTP)
        signal_stop = 1;
    else if (number == SIGCONT)
        signal_continued = 1;
    else
        signal_end = number;
}

/* A crash must not leave a terminal without echo behind; all calls here are allowed in a handler. */
static void on_crash(int number)
{
    ssize_t written = write(STDOUT_FILENO, farewell, farewell_length);
    (void)written;
    tcsetattr(STDIN_FILENO, TCSANOW, &before);
    signal(number, SIG_DFL);
    raise(number);
}

static void catch_signal(int number, void (*handler)(int), struct sigaction *old)
{
    struct sigaction action = {.sa_handler = handler};
    sigemptyset(&action.sa_mask);
    sigaction(number, &action, old);
}

static void block_signals(Terminal *terminal)
{
    sigset_t blocked;
    sigemptyset(&blocked);
    for (int i = 0; i < N_ENDS; i++)
        sigaddset(&blocked, ends[i]);
    sigaddset(&blocked, SIGWINCH);
    sigaddset(&blocked, SIGTSTP);
    sigaddset(&blocked, SIGCONT);
    sigprocmask(SIG_BLOCK, &blocked, &terminal->mask_outside);
}

static void catch_signals(Terminal *terminal)
{
    signal_end = signal_resized = signal_stop = signal_continued = 0;
    block_signals(terminal);
    for (int i = 0; i < N_ENDS; i++)
        catch_signal(ends[i], on_signal, &terminal->old_ends[i]);
    for (int i = 0; i < N_CRASHES; i++)
        catch_signal(crashes[i], on_crash, &terminal->old_crashes[i]);
    catch_signal(SIGWINCH, on_signal, &terminal->old_resize);
    catch_signal(SIGTSTP, on_signal, &terminal->old_stop);
    catch_signal(SIGCONT, on_signal, &terminal->old_continue);
}

static void release_signals(Terminal *terminal)
{
    for (int i = 0; i < N_ENDS; i++)
        sigaction(ends[i], &terminal->old_ends[i], NULL);
    for (int i = 0; i < N_CRASHES; i++)
        sigaction(crashes[i], &terminal->old_crashes[i], NULL);
    if (signal_end) {
        /* shell, terminal and kernel each say it: the second must not cut off what is still to be written */
        signal(SIGHUP, SIG_IGN);
        signal(SIGTERM, SIG_IGN);
    }
    sigaction(SIGWINCH, &terminal->old_resize, NULL);
    sigaction(SIGTSTP, &terminal->old_stop, NULL);
    sigaction(SIGCONT, &terminal->old_continue, NULL);
    sigprocmask(SIG_SETMASK, &terminal->mask_outside, NULL);
}

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

/* A terminal that takes nothing any more (a connection that hangs) must not keep the program: so writes do
 * not block, and signals come through while it waits. False: not all was written. */
static bool write_all(const Terminal *terminal, const char *bytes, size_t length)
{
    struct timespec patience = {.tv_nsec = 300000000}; /* with a farewell, once a signal has ended it */
    while (length > 0) {
        ssize_t written = write(terminal->output, bytes, length);
        if (written > 0) {
            bytes += written;
            length -= (size_t)written;
        } else if (written < 0 && errno == EAGAIN) {
            struct pollfd screen = {.fd = terminal->output, .events = POLLOUT};
            bool ending = signal_end != 0;
            if (wait_for(&screen, 1, ending ? &patience : NULL, &terminal->mask_outside) <= 0 && signal_end)
                return false;
        } else if (errno != EINTR)
            return false; /* the terminal is gone; reading it will tell */
    }
    return true;
}

/* The terminal once more, for writing that does not block: on the descriptor that the shell has too, that
 * would be its business. */
static int open_output(void)
{
    const char *name = ttyname(STDOUT_FILENO);
    int output = name ? open(name, O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC) : -1;
    if (output >= 0 && output < FD_SETSIZE)
        return output;
    if (output >= 0)
        close(output);
    return STDOUT_FILENO;
}

/* Every key comes as it is, nothing is echoed, and output is not changed on its way. */
static void take_screen(Terminal *terminal)
{
    struct termios raw = before;
    raw.c_iflag &= ~(tcflag_t)(BRKINT | ICRNL | INLCR | IGNCR | ISTRIP | IXON);
    raw.c_lflag &= ~(tcflag_t)(ECHO | ECHONL | ICANON | ISIG | IEXTEN);
    raw.c_oflag &= ~(tcflag_t)OPOST;
    raw.c_cc[VMIN] = 1;
    raw.c_cc[VTIME] = 0;
    tcsetattr(STDIN_FILENO, TCSADRAIN, &raw);
    write_all(terminal, terminal->frame.enter, strlen(terminal->frame.enter));
    painter_forget(&terminal->painter);
}

static void give_screen_back(const Terminal *terminal)
{
    bool written = write_all(terminal, terminal->frame.leave, strlen(terminal->frame.leave));
    tcsetattr(STDIN_FILENO, written ? TCSADRAIN : TCSANOW, &before);
}

/* A library that finds no memory or no thread may leave by exit(), in the middle of anything: ncurses does,
 * and the runtime of OpenMP. What it wrote before may have gone with the screen. */
static void leave(void)
{
    if (!in_use)
        return;
    if (opened)
        give_screen_back(opened);
    fputs("matvib: a library ended the program, most likely for want of memory\n", stderr);
}

/* The description of the terminal is in force when this returns true; description_close() ends that. */
static bool describe(const char *term, const char **stand_in, Status *status)
{
    static bool prepared;
    if (!prepared && atexit(leave) != 0)
        return status_fail(status, STATUS_FAILED, "out of memory");
    prepared = true;
    in_use = true;
    in_use = description_open(term, stand_in, status);
    return in_use;
}

static void forget_description(void)
{
    description_close();
    in_use = false;
}

Terminal *terminal_open(const TerminalOptions *options, Status *status)
{
    const char *term = getenv("TERM"), *codeset = nl_langinfo(CODESET);
    Glyphs glyphs;
    if (!description_choose_glyphs(options->glyphs, codeset, term, &glyphs)) {
        status_fail(status, STATUS_USAGE, "--glyphs: unknown set '%s' (auto, braille, block or ascii)",
                    options->glyphs);
        return NULL;
    }
    const char *stand_in = NULL;
    if (!describe(term, &stand_in, status))
        return NULL;
    Terminal *terminal = calloc(1, sizeof *terminal);
    if (!terminal) {
        forget_description();
        status_fail(status, STATUS_FAILED, "out of memory");
        return NULL;
    }
    Painter *painter = &terminal->painter;
    terminal->glyphs = glyphs;
    terminal->stand_in = stand_in;
    description_read(&painter->can);
    painter->colours = description_colours(&painter->can);
    painter->light = theme_is_light(options->theme, getenv("COLORFGBG"));
    painter->utf8 = strcmp(codeset, "UTF-8") == 0;
    terminal->mouse = options->mouse && description_has_mouse();
    description_frame(terminal->mouse, &terminal->frame);
    farewell_length = strlen(terminal->frame.leave);
    memcpy(farewell, terminal->frame.leave, farewell_length);
    keys_reset(&terminal->decoder);
    tcgetattr(STDIN_FILENO, &before);
    terminal->output = open_output();
    catch_signals(terminal);
    read_size(terminal);
    opened = terminal;
    take_screen(terminal);
    return terminal;
}

void terminal_close(Terminal *terminal)
{
    if (!terminal)
        return;
    give_screen_back(terminal);
    opened = NULL;
    release_signals(terminal);
    painter_close(&terminal->painter);
    if (terminal->output != STDOUT_FILENO)
        close(terminal->output);
    forget_description();
    free(terminal);
}

void terminal_size(const Terminal *terminal, int *width, int *height)
{
    *width = terminal->width;
    *height = terminal->height;
}

int terminal_colours(const Terminal *terminal)
{
    return terminal->painter.colours;
}

bool terminal_is_light(const Terminal *terminal)
{
    return terminal->painter.light;
}

bool terminal_is_utf8(const Terminal *terminal)
{
    return terminal->painter.utf8;
}

const char *terminal_stand_in(const Terminal *terminal)
{
    return terminal->stand_in;
}

Glyphs terminal_glyphs(const Terminal *terminal)
{
    return terminal->glyphs;
}

void terminal_show(Terminal *terminal, const Canvas *canvas)
{
    size_t length;
    const char *bytes = painter_paint(&terminal->painter, canvas, terminal->width, terminal->height, &length);
    write_all(terminal, bytes, length);
}

void terminal_redraw(Terminal *terminal)
{
    painter_forget(&terminal->painter);
}

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void read_input(Terminal *terminal)
{
    terminal->read_at = now();
    if (terminal->input_first == terminal->input_end)
        terminal->input_first = terminal->input_end = 0;
    size_t room = INPUT_MAX - terminal->input_end;
    if (room == 0)
        return;
    ssize_t got = read(STDIN_FILENO, terminal->input + terminal->input_end, room);
    if (got > 0)
        terminal->input_end += (size_t)got;
    else if (got == 0 || (errno != EINTR && errno != EAGAIN))
        signal_end = SIGHUP; /* nobody is there any more */
}

void terminal_wait(Terminal *terminal, double seconds)
{
    if (terminal->input_first < terminal->input_end)
        seconds = 0;
    /* a sequence may be cut short while the engine works and nobody sleeps */
    const int sequence_ms = keys_timeout(&terminal->decoder);
    const double expires = terminal->read_at + sequence_ms * 1e-3, left = expires - now();
    if (sequence_ms >= 0 && (seconds < 0 || left < seconds))
        seconds = left > 0 ? left : 0;
    struct timespec time = {.tv_sec = (time_t)seconds};
    time.tv_nsec = (long)((seconds - (double)time.tv_sec) * 1e9);
    struct pollfd keyboard = {.fd = STDIN_FILENO, .events = POLLIN};
    int ready = wait_for(&keyboard, 1, seconds < 0 ? NULL : &time, &terminal->mask_outside);
    if (ready > 0)
        read_input(terminal);
    else if (ready == 0 && sequence_ms >= 0 && now() >= expires)
        terminal->expired = true;
    if (signal_stop) {
        signal_stop = 0;
        terminal_suspend(terminal);
    }
    if (signal_continued) {
        signal_continued = 0;
        signal_resized = 1;
        terminal_redraw(terminal);
    }
}

bool terminal_has_input(const Terminal *terminal)
{
    struct pollfd keyboard = {.fd = STDIN_FILENO, .events = POLLIN};
    const struct timespec at_once = {0, 0};
    return terminal->input_first < terminal->input_end || wait_for(&keyboard, 1, &at_once, NULL) > 0;
}

bool terminal_key(Terminal *terminal, Key *key)
{
    if (terminal->expired) {
        if (keys_expire(&terminal->decoder, key))
            return true;
        terminal->expired = false;
    }
    while (terminal->input_first < terminal->input_end)
        if (keys_feed(&terminal->decoder, terminal->input[terminal->input_first++], key))
            return true;
    return false;
}

bool terminal_resized(Terminal *terminal)
{
    if (!signal_resized)
        return false;
    signal_resized = 0;
    if (!read_size(terminal))
        return terminal->painter.shown.width == 0;
    terminal_redraw(terminal);
    return true;
}

int terminal_signal(const Terminal *terminal)
{
    (void)terminal;
    return signal_end;
}

void terminal_suspend(Terminal *terminal)
{
    give_screen_back(terminal);
    struct sigaction ours;
    catch_signal(SIGTSTP, SIG_DFL, &ours);
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
    signal_resized = 1;
    take_screen(terminal);
}
