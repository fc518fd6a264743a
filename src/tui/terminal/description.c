#include "tui/terminal/description.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include <curses.h>
#include <term.h>

bool description_choose_glyphs(const char *name, const char *codeset, const char *term, Glyphs *glyphs)
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
 * what a better known one does. The name of the first that is known and whose description is in force then;
 * NULL: none is. */
static const char *set_up_stand_in(const char *term)
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
    for (const char *const *name = families[family].stand_ins; *name; name++) {
        int error = 0;
        if (setupterm(*name, STDOUT_FILENO, &error) == OK)
            return *name;
    }
    return NULL;
}

bool description_open(const char *term, const char **stand_in, Status *status)
{
    if (!isatty(STDIN_FILENO) || !isatty(STDOUT_FILENO))
        return status_fail(status, STATUS_USAGE,
                           "the laboratory needs a terminal; without one use: matvib run SCENARIO");
    int error = 0;
    if (!term || !*term || strcmp(term, "dumb") == 0)
        return status_fail(status, STATUS_USAGE,
                           "the laboratory cannot draw on this terminal (TERM=%s); use: matvib run SCENARIO",
                           term && *term ? term : "unset");
    *stand_in = NULL;
    if (setupterm(term, STDOUT_FILENO, &error) != OK && !(*stand_in = set_up_stand_in(term)))
        return status_fail(status, STATUS_USAGE,
                           "the terminal TERM=%s is not known on this machine; use: matvib run SCENARIO",
                           term);
    const char *move_to = tigetstr("cup");
    if (!move_to || move_to == (char *)-1) {
        del_curterm(cur_term);
        return status_fail(status, STATUS_USAGE,
                           "the laboratory cannot draw on this terminal (TERM=%s); use: matvib run SCENARIO",
                           term);
    }
    return true;
}

void description_close(void)
{
    del_curterm(cur_term);
}

static const char *capability(const char *name)
{
    const char *text = tigetstr(name);
    return text && text != (char *)-1 ? text : "";
}

static void copy_capability(char *to, size_t size, const char *name)
{
    /* what does not fit is no use in part */
    const char *text = capability(name);
    snprintf(to, size, "%s", strlen(text) < size ? text : "");
}

void description_read(Capabilities *can)
{
    const struct {
        char *to;
        size_t size;
        const char *name;
    } wanted[] = {
        {can->move, sizeof can->move, "cup"},
        {can->clear, sizeof can->clear, "clear"},
        {can->plain, sizeof can->plain, "sgr0"},
        {can->bold, sizeof can->bold, "bold"},
        {can->dim, sizeof can->dim, "dim"},
        {can->underline, sizeof can->underline, "smul"},
        {can->reverse, sizeof can->reverse, "rev"},
        {can->foreground, sizeof can->foreground, "setaf"},
        {can->background, sizeof can->background, "setab"},
        {can->hide_cursor, sizeof can->hide_cursor, "civis"},
        {can->show_cursor, sizeof can->show_cursor, "cnorm"},
    };
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++)
        copy_capability(wanted[i].to, wanted[i].size, wanted[i].name);
    can->margin_scrolls = tigetflag("am") > 0 && tigetflag("xenl") <= 0;
}

int description_colours(const Capabilities *can)
{
    const char *no_color = getenv("NO_COLOR");
    int colours = tigetnum("colors");
    if ((no_color && *no_color) || !can->foreground[0] || !can->background[0])
        return 0;
    return colours >= 256 ? 256 : colours >= 8 ? 8 : 0;
}

bool description_has_mouse(void)
{
    return capability("kmous")[0] != '\0';
}

/* Appends without padding, "$<5>", which a handler of signals could not wait for either. */
static void append(char *out, size_t size, const char *text)
{
    size_t length = strlen(out);
    for (; *text && length + 1 < size; text++) {
        if (strncmp(text, "$<", 2) == 0 && strchr(text, '>'))
            text = strchr(text, '>');
        else
            out[length++] = *text;
    }
    out[length] = '\0';
}

void description_frame(bool mouse, ScreenFrame *frame)
{
    frame->enter[0] = frame->leave[0] = '\0';
    append(frame->enter, sizeof frame->enter, capability("smcup"));
    append(frame->enter, sizeof frame->enter, capability("smkx"));
    append(frame->enter, sizeof frame->enter, mouse ? "\033[?1000h\033[?1006h" : "");
    /* pasted text is told from keys; who does not know the mode ignores it */
    append(frame->enter, sizeof frame->enter, "\033[?2004h");
    append(frame->leave, sizeof frame->leave, "\033[?2004l");
    append(frame->leave, sizeof frame->leave, mouse ? "\033[?1006l\033[?1000l" : "");
    append(frame->leave, sizeof frame->leave, capability("sgr0"));
    /* without an alternate screen the shell goes on on an empty one */
    append(frame->leave, sizeof frame->leave, capability("rmcup")[0] ? "" : capability("clear"));
    append(frame->leave, sizeof frame->leave, capability("rmkx"));
    append(frame->leave, sizeof frame->leave, capability("cnorm"));
    append(frame->leave, sizeof frame->leave, capability("rmcup"));
}
