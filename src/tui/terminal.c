#include "tui/terminal.h"

#include "tui/theme.h"

#include <errno.h>
#include <langinfo.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include <curses.h>
#include <term.h>

/* Signals reach a handler, and a handler reaches only what is static. */
static volatile sig_atomic_t signal_end, signal_resized, signal_stop, signal_continued;
static struct termios before; /* the terminal's modes when we came */
static char farewell[256];    /* what restores the screen, for a crash */
static size_t farewell_length;

static const int ends[] = {SIGTERM, SIGHUP, SIGINT, SIGQUIT, SIGPIPE};
static const int crashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
enum { N_ENDS = sizeof ends / sizeof *ends, N_CRASHES = sizeof crashes / sizeof *crashes, INPUT_MAX = 512 };

struct Terminal {
    SCREEN *screen;
    int width, height;
    int colours;
    bool light, utf8, mouse;
    Glyphs glyphs;
    Canvas shown; /* what the terminal shows; width 0: not known */
    bool cursor_shown;
    KeyDecoder decoder;
    unsigned char input[INPUT_MAX];
    size_t input_first, input_end;
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
    sigaction(SIGWINCH, &terminal->old_resize, NULL);
    sigaction(SIGTSTP, &terminal->old_stop, NULL);
    sigaction(SIGCONT, &terminal->old_continue, NULL);
    sigprocmask(SIG_SETMASK, &terminal->mask_outside, NULL);
}

bool terminal_choose_glyphs(const char *name, const char *codeset, const char *term, Glyphs *glyphs)
{
    static const char *const names[] = {"braille", "block", "ascii"};
    for (int i = 0; name && i < GLYPHS_COUNT; i++)
        if (strcmp(name, names[i]) == 0) {
            *glyphs = (Glyphs)i;
            return true;
        }
    if (name && strcmp(name, "auto") != 0)
        return false;
    if (!codeset || strcmp(codeset, "UTF-8") != 0)
        *glyphs = GLYPHS_ASCII;
    else /* the font of the Linux console has blocks, but no braille */
        *glyphs = term && strcmp(term, "linux") == 0 ? GLYPHS_BLOCK : GLYPHS_BRAILLE;
    return true;
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

static void keep_farewell(bool mouse)
{
    static const char *const capabilities[] = {"sgr0", "cnorm", "rmkx", "rmcup"};
    farewell_length = 0;
    farewell[0] = '\0';
    for (size_t i = 0; i < sizeof capabilities / sizeof *capabilities; i++) {
        const char *text = tigetstr(capabilities[i]);
        if (!text || text == (char *)-1 || farewell_length + strlen(text) + 32 >= sizeof farewell)
            continue;
        strcpy(farewell + farewell_length, text);
        farewell_length += strlen(text);
    }
    if (mouse) {
        strcpy(farewell + farewell_length, "\033[?1006l\033[?1000l");
        farewell_length = strlen(farewell);
    }
}

static int count_colours(void)
{
    const char *no_color = getenv("NO_COLOR");
    if ((no_color && *no_color) || !has_colors() || start_color() == ERR)
        return 0;
    use_default_colors();
    return COLORS >= 256 ? 256 : COLORS >= 8 ? 8 : 0;
}

static void set_mouse(const Terminal *terminal, bool on)
{
    if (terminal->mouse)
        putp(on ? "\033[?1000h\033[?1006h" : "\033[?1006l\033[?1000l");
}

static bool is_usable(const char *term, Status *status)
{
    if (!isatty(STDIN_FILENO) || !isatty(STDOUT_FILENO))
        return status_fail(status, STATUS_USAGE,
                           "the laboratory needs a terminal; without one use: matvib run SCENARIO");
    int error = 0;
    if (!term || !*term || strcmp(term, "dumb") == 0)
        return status_fail(status, STATUS_USAGE,
                           "the laboratory cannot draw on this terminal (TERM=%s); use: matvib run SCENARIO",
                           term && *term ? term : "unset");
    if (setupterm(term, STDOUT_FILENO, &error) != OK)
        return status_fail(status, STATUS_USAGE,
                           "the terminal TERM=%s is not known on this machine; use: matvib run SCENARIO",
                           term);
    const char *move_to = tigetstr("cup");
    bool addressable = move_to && move_to != (char *)-1;
    del_curterm(cur_term);
    if (!addressable)
        return status_fail(status, STATUS_USAGE,
                           "the laboratory cannot draw on this terminal (TERM=%s); use: matvib run SCENARIO",
                           term);
    return true;
}

Terminal *terminal_open(const TerminalOptions *options, Status *status)
{
    const char *term = getenv("TERM");
    if (!is_usable(term, status))
        return NULL;
    Terminal *terminal = calloc(1, sizeof *terminal);
    if (!terminal) {
        status_fail(status, STATUS_FAILED, "out of memory");
        return NULL;
    }
    const char *codeset = nl_langinfo(CODESET);
    if (!terminal_choose_glyphs(options->glyphs, codeset, term, &terminal->glyphs)) {
        status_fail(status, STATUS_USAGE, "--glyphs: unknown set '%s' (auto, braille, block or ascii)",
                    options->glyphs);
        free(terminal);
        return NULL;
    }
    terminal->utf8 = strcmp(codeset, "UTF-8") == 0;
    terminal->light = theme_is_light(options->theme, getenv("COLORFGBG"));
    keys_reset(&terminal->decoder);
    tcgetattr(STDIN_FILENO, &before);
    /* before curses looks: it leaves signals alone that somebody handles */
    catch_signals(terminal);
    terminal->screen = newterm(NULL, stdout, stdin);
    if (!terminal->screen) {
        release_signals(terminal);
        free(terminal);
        status_fail(status, STATUS_FAILED, "the terminal TERM=%s cannot be opened", term);
        return NULL;
    }
    const char *mouse = tigetstr("kmous");
    terminal->mouse = options->mouse && mouse && mouse != (char *)-1;
    keep_farewell(terminal->mouse);
    raw();
    noecho();
    nonl();
    keypad(stdscr, TRUE);
    typeahead(-1);
    leaveok(stdscr, FALSE);
    terminal->colours = count_colours();
    curs_set(0);
    terminal->cursor_shown = false;
    read_size(terminal);
    resizeterm(terminal->height, terminal->width);
    set_mouse(terminal, true);
    return terminal;
}

void terminal_close(Terminal *terminal)
{
    if (!terminal)
        return;
    set_mouse(terminal, false);
    curs_set(1);
    endwin();
    delscreen(terminal->screen);
    tcsetattr(STDIN_FILENO, TCSADRAIN, &before);
    release_signals(terminal);
    canvas_close(&terminal->shown);
    free(terminal);
}

void terminal_size(const Terminal *terminal, int *width, int *height)
{
    *width = terminal->width;
    *height = terminal->height;
}

int terminal_colours(const Terminal *terminal)
{
    return terminal->colours;
}

bool terminal_is_light(const Terminal *terminal)
{
    return terminal->light;
}

bool terminal_is_utf8(const Terminal *terminal)
{
    return terminal->utf8;
}

Glyphs terminal_glyphs(const Terminal *terminal)
{
    return terminal->glyphs;
}

static cchar_t complex_character(const Terminal *terminal, const Cell *cell)
{
    Look look = theme_look(terminal->colours, terminal->light, cell->style, cell->back);
    attr_t attributes =
        (look.attributes & LOOK_BOLD ? A_BOLD : 0) | (look.attributes & LOOK_UNDERLINE ? A_UNDERLINE : 0) |
        (look.attributes & LOOK_REVERSE ? A_REVERSE : 0) | (look.attributes & LOOK_DIM ? A_DIM : 0);
    int pair = 0;
    if (look.foreground != LOOK_DEFAULT || look.background != LOOK_DEFAULT)
        pair = alloc_pair(look.foreground, look.background);
    if (pair < 0)
        pair = 0;
    uint32_t glyph = cell->glyph ? cell->glyph : ' ';
    if (glyph > 0x7e && !terminal->utf8)
        glyph = '?';
    wchar_t text[2] = {(wchar_t)glyph, L'\0'};
    cchar_t character;
    setcchar(&character, text, attributes, (short)pair, &pair);
    return character;
}

static bool same_cell(const Cell *a, const Cell *b)
{
    return a->glyph == b->glyph && a->style == b->style && a->back == b->back;
}

/* Copies what differs; returns whether anything did. */
static bool copy_cells(Terminal *terminal, const Canvas *canvas)
{
    bool changed = false;
    int rows = canvas->height < terminal->height ? canvas->height : terminal->height;
    int row_width = canvas->width < terminal->width ? canvas->width : terminal->width;
    for (int y = 0; y < rows; y++)
        for (int x = 0; x < row_width; x++) {
            size_t at = (size_t)y * (size_t)canvas->width + (size_t)x;
            if (same_cell(&terminal->shown.cells[at], &canvas->cells[at]))
                continue;
            cchar_t character = complex_character(terminal, &canvas->cells[at]);
            mvadd_wchnstr(y, x, &character, 1);
            terminal->shown.cells[at] = canvas->cells[at];
            changed = true;
        }
    return changed;
}

void terminal_show(Terminal *terminal, const Canvas *canvas)
{
    Canvas *shown = &terminal->shown;
    bool changed = false;
    if (shown->width != canvas->width || shown->height != canvas->height) {
        if (!canvas_open(shown, canvas->width, canvas->height, NULL))
            return;
        erase();
        clearok(curscr, TRUE);
        canvas_clear(shown);
        shown->cursor_x = shown->cursor_y = -1;
        changed = true;
    }
    changed |= copy_cells(terminal, canvas);
    bool visible = canvas->cursor_x >= 0 && canvas->cursor_x < terminal->width && canvas->cursor_y >= 0 &&
                   canvas->cursor_y < terminal->height;
    if (visible != terminal->cursor_shown) {
        terminal->cursor_shown = visible;
        curs_set(visible);
        changed = true;
    }
    if (canvas->cursor_x != shown->cursor_x || canvas->cursor_y != shown->cursor_y) {
        shown->cursor_x = canvas->cursor_x;
        shown->cursor_y = canvas->cursor_y;
        changed = true;
    }
    if (!changed)
        return;
    if (visible)
        move(canvas->cursor_y, canvas->cursor_x);
    wnoutrefresh(stdscr);
    doupdate();
}

void terminal_redraw(Terminal *terminal)
{
    canvas_close(&terminal->shown);
    terminal->shown = (Canvas){0};
}

static void read_input(Terminal *terminal)
{
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
    int sequence_ms = keys_timeout(&terminal->decoder);
    bool in_sequence = sequence_ms >= 0 && (seconds < 0 || sequence_ms < seconds * 1e3);
    if (in_sequence)
        seconds = sequence_ms * 1e-3;
    struct timespec time = {.tv_sec = (time_t)seconds};
    time.tv_nsec = (long)((seconds - (double)time.tv_sec) * 1e9);
    struct pollfd keyboard = {.fd = STDIN_FILENO, .events = POLLIN};
    int ready = ppoll(&keyboard, 1, seconds < 0 ? NULL : &time, &terminal->mask_outside);
    if (ready > 0)
        read_input(terminal);
    else if (ready == 0 && in_sequence)
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
        return terminal->shown.width == 0;
    resizeterm(terminal->height, terminal->width);
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
    set_mouse(terminal, false);
    curs_set(1);
    endwin();
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
    sigset_t woken;
    struct timespec at_once = {0, 0};
    sigemptyset(&woken);
    sigaddset(&woken, SIGCONT);
    while (sigtimedwait(&woken, NULL, &at_once) > 0)
        continue;
    signal_continued = 0;
    signal_resized = 1;
    refresh();
    set_mouse(terminal, true);
    curs_set(terminal->cursor_shown);
    terminal_redraw(terminal);
}
