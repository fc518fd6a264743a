/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "terminal/grid.h"

#include "base/assertion.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/mman.h>
#include <unistd.h>
#include <wchar.h>

#include <curses.h>
#include <term.h>

/* Terminals where the system has no descriptions of them: two that are compiled in. */

enum { FALLBACK_MANY_COLOURS, FALLBACK_FEW_COLOURS, FALLBACKS };

static const struct {
    const char *name, *description;
} terminals[FALLBACKS] = {
#include "terminal/fallback.inc"
};

/* --- the terminal's description -------------------------------------------------------------------- */

bool grid_choose_glyphs(const char *name, const char *codeset, const char *term, Glyphs *glyphs)
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

/* A server's database seldom knows the newest terminals and often not PuTTY; almost all of them understand
 * what a better known one does. In the order in which they are tried, ended by NULL. */
static const char *const *stand_ins_of(const char *term)
{
    static const char *const as_xterm[] = {"xterm-256color", "xterm", "vt100", NULL};
    static const char *const as_screen[] = {"screen-256color", "screen", "vt100", NULL};
    static const char *const as_any[] = {"vt100", "ansi", NULL};
    static const struct {
        const char *begins;
        const char *const *stand_ins;
    } families[] = {
        {"xterm", as_xterm},   {"putty", as_xterm},   {"rxvt", as_xterm},    {"alacritty", as_xterm},
        {"foot", as_xterm},    {"gnome", as_xterm},   {"konsole", as_xterm}, {"vte", as_xterm},
        {"st-", as_xterm},     {"wezterm", as_xterm}, {"ghostty", as_xterm}, {"contour", as_xterm},
        {"mintty", as_xterm},  {"nsterm", as_xterm},  {"iterm", as_xterm},   {"ms-terminal", as_xterm},
        {"screen", as_screen}, {"tmux", as_screen},   {"", as_any}, /* any other */
    };
    size_t family = 0;
    while (strncasecmp(term, families[family].begins, strlen(families[family].begins)) != 0)
        family++;
    return families[family].stand_ins;
}

static const char *capability(const char *name)
{
    const char *text = tigetstr(name);
    return text && text != (char *)-1 ? text : "";
}

/* Without padding, "$<5>", which a handler of signals could not wait for either. */
static void append(Grid *grid, const char *text)
{
    for (; *text && grid->farewell_length + 1 < sizeof grid->farewell; text++) {
        if (strncmp(text, "$<", 2) == 0 && strchr(text, '>'))
            text = strchr(text, '>');
        else
            grid->farewell[grid->farewell_length++] = *text;
    }
}

static const char mouse_on[] = "\033[?1000h\033[?1002h\033[?1006h",
                  mouse_off[] = "\033[?1002l\033[?1006l\033[?1000l";
static const char paste_on[] = "\033[?2004h", paste_off[] = "\033[?2004l";
static const char hold_on[] = "\033[?2026h", hold_off[] = "\033[?2026l", hold_query[] = "\033[?2026$p";

static void compose_farewell(Grid *grid)
{
    grid->farewell_length = 0;
    append(grid, grid->synchronised ? hold_off : "");
    append(grid, paste_off);
    append(grid, grid->mouse ? mouse_off : "");
    append(grid, capability("sgr0"));
    /* without an alternate screen the shell goes on on an empty one */
    append(grid, capability("rmcup")[0] ? "" : capability("clear"));
    append(grid, capability("rmkx"));
    append(grid, capability("cnorm"));
    append(grid, capability("rmcup"));
}

/* --- bytes ----------------------------------------------------------------------------------------- */

void grid_redraw(Grid *grid)
{
    clearok(curscr, TRUE);
    canvas_close(&grid->shown);
    erase();
}

/* The next picture is drawn whole; who cannot show it again looks at `why_lost`. */
static void lose(Grid *grid, int why)
{
    grid->why_lost = why;
    grid_redraw(grid);
}

static void put(Grid *grid, const char *bytes, size_t count)
{
    if (grid->length + count > grid->room) {
        const size_t room = 2 * (grid->length + count);
        char *more = realloc(grid->bytes, room);
        if (!more) {
            lose(grid, ENOMEM);
            return;
        }
        grid->bytes = more;
        grid->room = room;
    }
    memcpy(grid->bytes + grid->length, bytes, count);
    grid->length += count;
}

/* What curses wrote into its file since then is dropped: the next picture is written over it, which spares
 * the kernel to fetch and clear the same pages 30 times a second. */
static void drop(const Grid *grid)
{
    (void)!lseek(grid->memory, 0, SEEK_SET);
}

/* What curses wrote and now writes into its file is to be sent. That a write of its failed curses tells by
 * errno alone, which the caller clears before the first one. */
static void take(Grid *grid)
{
    char piece[4096];
    ssize_t got = 0;
    refresh();
    int why = errno == ENOSPC || errno == ENOMEM || errno == EFBIG || errno == EIO ? errno : 0;
    off_t left = lseek(grid->memory, 0, SEEK_CUR);
    drop(grid);
    while (left > 0 &&
           (got = read(grid->memory, piece, left < (off_t)sizeof piece ? (size_t)left : sizeof piece)) > 0) {
        put(grid, piece, (size_t)got);
        left -= got;
    }
    drop(grid);
    if (why || left != 0)
        lose(grid, why ? why : EIO);
}

const char *grid_bytes(const Grid *grid, size_t *left)
{
    *left = grid->length - grid->first;
    return *left > 0 ? grid->bytes + grid->first : NULL;
}

void grid_sent(Grid *grid, size_t count)
{
    ASSERT_INT(count, <=, grid->length - grid->first);
    grid->first += count;
    if (grid->first == grid->length)
        grid->first = grid->length = 0;
}

/* --- opening and closing --------------------------------------------------------------------------- */

static FILE *open_memory(void)
{
#ifdef HAVE_MEMFD_CREATE
    const int descriptor = memfd_create("matvib", MFD_CLOEXEC);
    return descriptor >= 0 ? fdopen(descriptor, "w+") : NULL;
#else
    return tmpfile();
#endif
}

/* NULL: neither the terminal nor one like it is known here, nor those that the program knows by itself. */
static SCREEN *open_curses(const char *term, FILE *output, FILE *input, const char **stand_in)
{
    *stand_in = NULL;
    SCREEN *screen = newterm(term, output, input);
    for (const char *const *name = stand_ins_of(term); !screen && *name; name++) {
        *stand_in = *name;
        screen = newterm(*name, output, input);
    }
    if (screen)
        return screen;
    /* curses may not be able to take a description from the program */
    const int which = strstr(stand_ins_of(term)[0], "256") ? FALLBACK_MANY_COLOURS : FALLBACK_FEW_COLOURS;
    const char *given = getenv("TERMINFO");
    char *before = given ? strdup(given) : NULL;
    *stand_in = "most terminals of today";
    if ((!given || before) && setenv("TERMINFO", terminals[which].description, 1) == 0) {
        screen = newterm(terminals[which].name, output, input);
        if (before)
            setenv("TERMINFO", before, 1);
        else
            unsetenv("TERMINFO");
    }
    free(before);
    return screen;
}

static FILE *curses_output, *curses_input; /* keys are read past curses */

static void close_files(void)
{
    if (curses_output)
        fclose(curses_output);
    if (curses_input)
        fclose(curses_input);
    curses_output = curses_input = NULL;
}

static bool cannot_draw(const char *term, Status *status)
{
    return status_refuse(
        status, "the laboratory cannot draw on this terminal (TERM=%s); use --plain, or: matvib run SCENARIO",
        term && *term ? term : "unset");
}

bool grid_open(Grid *grid, const char *term, bool mouse, const char **stand_in, Status *status)
{
    if (!term || !*term || strcmp(term, "dumb") == 0)
        return cannot_draw(term, status);
    curses_output = open_memory();
    curses_input = open_memory();
    if (!curses_output || !curses_input) {
        status_fail(status, "not enough memory or files for the screen");
        close_files();
        return false;
    }
    setenv("NCURSES_NO_PADDING", "1", 1); /* it was for terminals that could not keep up with their line */
    grid->memory = fileno(curses_output);
    grid->mouse = mouse;
    grid->curses = open_curses(term, curses_output, curses_input, stand_in);
    if (!grid->curses)
        status_refuse(
            status, "the terminal TERM=%s is not known on this machine; use --plain, or: matvib run SCENARIO",
            term);
    else if (!capability("cup")[0])
        cannot_draw(term, status);
    else {
        /* What pictures need, once curses knows the terminal. */
        orig_colors = NULL; /* the user's palette is not to be reset */
        const char *no_color = getenv("NO_COLOR");
        const int colours = tigetnum("colors");
        if (!(no_color && *no_color) && colours >= 8 && start_color() != ERR && use_default_colors() != ERR)
            grid->colours = colours >= 256 ? 256 : 8;
        grid->mouse = grid->mouse && capability("kmous")[0] != '\0';
        typeahead(-1); /* whether a key waits is asked by who draws */
        compose_farewell(grid);
        return true;
    }
    grid_close(grid);
    return false;
}

void grid_close(Grid *grid)
{
    if (grid->curses) {
        endwin();
        delscreen(grid->curses);
    }
    close_files();
    canvas_close(&grid->shown);
    free(grid->bytes);
    *grid = (Grid){0};
}

void grid_enter(Grid *grid)
{
    errno = 0;
    grid_redraw(grid);
    take(grid);
    put(grid, capability("smkx"), strlen(capability("smkx")));
    put(grid, paste_on, sizeof paste_on - 1);
    if (grid->mouse)
        put(grid, mouse_on, sizeof mouse_on - 1);
    if (!grid->synchronised)
        put(grid, hold_query, sizeof hold_query - 1);
    clearok(curscr, TRUE); /* a terminal that does not know the query may show a letter of it */
}

/* The same bytes as after a crash: so they are tried each time. */
void grid_leave(Grid *grid)
{
    endwin();
    drop(grid);
    put(grid, grid->farewell, grid->farewell_length);
}

void grid_resize(Grid *grid, int width, int height)
{
    ASSERT_INT(width, >=, 1);
    ASSERT_INT(height, >=, 1);
    if (resize_term(height, width) == ERR)
        grid->why_lost = ENOMEM;
    grid_redraw(grid);
}

void grid_ask(Grid *grid)
{
    static const char status_query[] = "\033[5n";
    put(grid, status_query, sizeof status_query - 1);
}

void grid_synchronise(Grid *grid)
{
    grid->synchronised = true;
    compose_farewell(grid);
}

/* --- cells ----------------------------------------------------------------------------------------- */

/* The last word before the terminal: what the C library takes for wider, narrower or no character at all
 * than the canvas does would move all that stands behind it. */
static void put_cell(const Grid *grid, int x, int y, Cell cell)
{
    const Look look = theme_look(grid->colours, grid->light, cell.style, cell.back);
    const bool fits =
        cell.glyph < 0x7f || (grid->utf8 && wcwidth((wchar_t)cell.glyph) == glyph_columns(cell.glyph));
    const wchar_t text[] = {cell.glyph < ' ' ? L' ' : fits ? (wchar_t)cell.glyph : L'?', L'\0'};
    const bool coloured = look.foreground != LOOK_DEFAULT || look.background != LOOK_DEFAULT;
    const int pair = coloured ? alloc_pair(look.foreground, look.background) : 0;
    cchar_t character;
    const int count = text[0] == L'?' && glyph_columns(cell.glyph) == 2 ? 2 : 1;
    for (int i = 0; i < count; i++)
        if (setcchar(&character, text,
                     (attr_t)((look.attributes & LOOK_BOLD ? A_BOLD : 0) |
                              (look.attributes & LOOK_DIM ? A_DIM : 0) |
                              (look.attributes & LOOK_UNDERLINE ? A_UNDERLINE : 0) |
                              (look.attributes & LOOK_REVERSE ? A_REVERSE : 0)),
                     (short)(pair > 0 ? pair : 0), NULL) == OK)
            mvadd_wch(y, x + i, &character);
}

void grid_show(Grid *grid, const Canvas *canvas)
{
    Canvas *shown = &grid->shown;
    const bool fresh = shown->width != canvas->width || shown->height != canvas->height;
    if (fresh && !canvas_open(shown, canvas->width, canvas->height, NULL)) {
        lose(grid, ENOMEM);
        return;
    }
    const size_t before = grid->length;
    if (grid->synchronised)
        put(grid, hold_on, sizeof hold_on - 1);
    for (int y = 0; y < canvas->height && y < LINES; y++)
        for (int x = 0; x < canvas->width && x < COLS; x++) {
            const size_t at = (size_t)y * (size_t)canvas->width + (size_t)x;
            const Cell *cell = &canvas->cells[at], *old = &shown->cells[at];
            if (cell->glyph != CELL_FOLLOWS &&
                (fresh || cell->glyph != old->glyph || cell->style != old->style || cell->back != old->back))
                put_cell(grid, x, y, *cell);
        }
    errno = 0; /* curs_set() writes too */
    const bool visible =
        canvas->cursor_x >= 0 && canvas->cursor_x < COLS && canvas->cursor_y >= 0 && canvas->cursor_y < LINES;
    leaveok(stdscr, !visible);
    if (visible)
        move(canvas->cursor_y, canvas->cursor_x);
    curs_set(visible);
    memcpy(shown->cells, canvas->cells, (size_t)canvas->width * (size_t)canvas->height * sizeof(Cell));
    const size_t began = grid->length;
    take(grid);
    /* What a terminal draws finer than cells (canvas_vector()), behind the colour numbers of all styles: an
     * operating system command of our own, which others leave alone. Sent where it is another one than
     * before. */
    static const char begin[] = "\033]7770;P", end[] = "\a";
    if (canvas->vectors && (!shown->vectors || strcmp(shown->vectors, canvas->vectors) != 0)) {
        free(shown->vectors);
        shown->vectors = strdup(canvas->vectors);
        put(grid, begin, sizeof begin - 1);
        for (unsigned style = 0; style < STYLE_COUNT; style++) {
            char number[16];
            const int length = snprintf(number, sizeof number, style ? ",%d" : "%d",
                                        theme_look(grid->colours, grid->light, style, 0).foreground);
            put(grid, number, (size_t)length);
        }
        put(grid, canvas->vectors, strlen(canvas->vectors));
        put(grid, end, sizeof end - 1);
    }
    if (grid->length == began)
        grid->length = before; /* nothing changed */
    else if (grid->synchronised)
        put(grid, hold_off, sizeof hold_off - 1);
}
