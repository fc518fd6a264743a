/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The help: keys by group, what the curves mean, and what is solved, with every equation and every slip of
 * the papers. */
#include "answers/choices.h"
#include "help/help_text.h"
#include "panes/panes.h"
#include "scenario/settings.h"

#include <stdio.h>
#include <string.h>

enum { TEXT_MAX = 24000, LINES_MAX = 400 };
/* keys, curves, what is solved, and where the papers are silent, if something is said of that */
enum { HELP_PAGES = 4 };

/* Lines of text with a style each. Too many: the last ones are left out. */
typedef struct HelpLines {
    char text[TEXT_MAX];
    size_t used;
    struct {
        size_t at;
        Style style;
    } lines[LINES_MAX];
    int count;
} HelpLines;

static void put_line(HelpLines *written, Style style, const char *text)
{
    size_t length = strlen(text) + 1;
    if (written->count == LINES_MAX || written->used + length > TEXT_MAX)
        return;
    memcpy(written->text + written->used, text, length);
    written->lines[written->count].at = written->used;
    written->lines[written->count++].style = style;
    written->used += length;
}

/* A paragraph, broken into lines of `width` columns, further ones indented like the first. */
static void put_text(HelpLines *written, Style style, int width, int indent, const char *text)
{
    const int least = indent + 8;
    width = width > least ? width : least;
    while (*text) {
        char line[512];
        const char *rest;
        const size_t length = glyphs_line(text, width - indent, &rest);
        snprintf(line, sizeof line, "%*s%.*s", indent, "", (int)length, text);
        put_line(written, style, line);
        text = rest;
    }
}

/* --- keys ----------------------------------------------------------------------------------------- */

/* The keys, and what they do beside them or, on a narrow screen, below. */
static void put_key(HelpLines *written, int width, const char *keys, const char *help)
{
    enum { COLUMN = 13 };
    char line[256];
    const bool beside = COLUMN < width / 3 && glyphs_columns(keys) < COLUMN - 2;
    const char *rest = help;
    if (beside) {
        const size_t length = glyphs_line(help, width - COLUMN, &rest);
        snprintf(line, sizeof line, "  %s%*s %.*s", keys, 10 - glyphs_columns(keys), "", (int)length, help);
    } else {
        snprintf(line, sizeof line, "  %s", keys);
    }
    put_line(written, STYLE_NORMAL, line);
    put_text(written, STYLE_NORMAL, width, beside ? COLUMN : 4, rest);
}

static void write_keys(HelpLines *written, int width)
{
    const char *group = "";
    for (int i = 0; i < n_commands; i++) {
        if (strcmp(commands[i].group, group) != 0) {
            if (*group)
                put_line(written, STYLE_NORMAL, "");
            put_line(written, STYLE_HEADING, group = commands[i].group);
        }
        if (pane_command_help(&commands[i]))
            put_key(written, width, commands[i].keys, pane_command_help(&commands[i]));
    }
    put_line(written, STYLE_NORMAL, "");
    put_line(written, STYLE_HEADING, "Behind :");
    for (int i = 0; i < n_line_verbs; i++) {
        char line[256];
        snprintf(line, sizeof line, "  %s %s", line_verbs[i].name, line_verbs[i].arguments);
        put_line(written, STYLE_NORMAL, line);
        put_text(written, STYLE_NORMAL, width, 13 < width / 3 ? 13 : 4, line_verbs[i].help);
    }
}

/* What the key line offers, in full. */
static void write_offers(HelpLines *written, int width, const Screen *screen)
{
    KeyOffer offers[KEY_OFFERS_MAX];
    const int count = pane_key_offers(screen, offers);
    put_line(written, STYLE_HEADING, "Keys of this screen");
    for (int i = 0; i < count; i++) {
        const KeyOffer *offer = &offers[i];
        const char *help = pane_command_help(offer->command),
                   *other = offer->pair ? pane_command_help(offer->pair) : NULL;
        char keys[32], text[256];
        snprintf(keys, sizeof keys, "%s%s%s", offer->keys[0], offer->pair ? " " : "", offer->keys[1]);
        snprintf(text, sizeof text, "%s%s%s", help ? help : offer->word, other ? "; " : "",
                 other ? other : "");
        put_key(written, width, keys, text);
    }
}

/* --- curves --------------------------------------------------------------------------------------- */

static void write_curves(HelpLines *written, int width, const HelpText *text)
{
    static const struct {
        const char *word, *meaning;
    } words[] = {
        {"measured",
         "what this run does: solid. A number with ~ is a little behind while the run goes on. "
         "A frequency is shown to the first digit of its uncertainty, and not at all where R2 < 0.5. "
         "In a time plot each column shows the least and the largest of "
         "its rows, so no peak is lost."},
        {"predicted", "what the equations of this very mesh or lattice and this time step give, worked out "
                      "beforehand: dashed. It holds the error of the method."},
        {"faint",
         "curves of an earlier run: the one before the last edit, or pinned ones with their letter."},
    };
    static const struct {
        const char *word, *meaning;
    } last_words[] = {
        {"timeline",
         "under the plots, from 0 to the end of the run: the line is what has been computed, the "
         "dot is where we are. x: a particle crossed into another cell; b: bonds broke; t: two bodies, or a "
         "body and a wall, touched for the first time; p: they parted; T: a body is torn, as "
         "neighbouring particles have parted (b, t, p and T in the plots over time too); L: half a period, a "
         "whole one "
         "and so on behind or ahead; E: the energy left "
         "its range; c: a "
         "parameter was changed; R: it came to rest; !: the run stopped."},
        {"spectrum",
         "view 6: how large each sine in the record is. A record of the length t shows no line finer than "
         "2 pi/t: a longer one is sharper."},
    };
    put_line(written, STYLE_HEADING, "What the curves mean");
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        put_line(written, STYLE_FOCUS, words[i].word);
        put_text(written, STYLE_NORMAL, width, 4, words[i].meaning);
    }
    put_line(written, STYLE_NORMAL, "");
    for (size_t i = 0; i < text->n_words; i++) {
        put_line(written, STYLE_FOCUS, text->words[i].word);
        put_text(written, STYLE_NORMAL, width, 4, text->words[i].meaning);
    }
    put_line(written, STYLE_NORMAL, "");
    for (size_t i = 0; i < sizeof last_words / sizeof *last_words; i++) {
        put_line(written, STYLE_FOCUS, last_words[i].word);
        put_text(written, STYLE_NORMAL, width, 4, last_words[i].meaning);
    }
}

/* --- what is solved ------------------------------------------------------------------------------- */

static void write_passages(HelpLines *written, int width, Glyphs glyphs, const HelpPassage *passages,
                           size_t count)
{
    for (size_t i = 0; i < count; i++) {
        char text[1024];
        glyphs_plain(glyphs, passages[i].text, text, sizeof text);
        if (passages[i].heading && written->count > 0)
            put_line(written, STYLE_NORMAL, "");
        if (passages[i].heading)
            put_text(written, STYLE_HEADING, width, 0, text);
        else
            put_text(written, STYLE_NORMAL, width, 2, text);
    }
}

/* --- the pages ------------------------------------------------------------------------------------- */

int help_pages(const Screen *screen)
{
    const Settings *settings = experiment_settings(screen->experiment);
    const Choice *choice = choices;
    while (choice < choices + n_choices && !choice_is_about(choice, settings->problem, settings->method))
        choice++;
    return choice < choices + n_choices ? HELP_PAGES : HELP_PAGES - 1;
}

static int page_of(const Screen *screen)
{
    const int page = screen->help->page, count = help_pages(screen);
    return page < 0 ? 0 : page >= count ? count - 1 : page;
}

/* The lines of a page, for a screen of this width. */
static void write_page(HelpLines *written, const Screen *screen, int page, int screen_width)
{
    const int width = screen_width - 2 < 100 ? screen_width - 2 : 100;
    const HelpText *text = help_text_of(experiment_simulation(screen->experiment));
    written->used = 0;
    written->count = 0;
    if (page == 0) {
        write_offers(written, width, screen);
        put_line(written, STYLE_NORMAL, "");
        /* What there is to see: the caption has room for its first sentences only. */
        const Settings *settings = experiment_settings(screen->experiment);
        put_text(written, STYLE_HEADING, width, 0,
                 settings->title[0] ? settings->title : settings->problem->title);
        if (settings->about[0])
            put_text(written, STYLE_NORMAL, width, 2, settings->about);
        put_line(written, STYLE_NORMAL, "");
        write_keys(written, width);
    }
    if (page == 1)
        write_curves(written, width, text);
    if (page == 2) {
        const Simulation *sim = experiment_simulation(screen->experiment);
        const Glyphs glyphs = screen->look.glyphs;
        const HelpPassage step = {true, text->step};
        write_passages(written, width, glyphs, text->before, text->n_before);
        write_passages(written, width, glyphs, text->answers, text->n_answers);
        write_passages(written, width, glyphs, &step, 1);
        for (int i = 0; i < sim->n_stages; i++) {
            const Stage *stage = &sim->stages[i];
            char line[512];
            snprintf(line, sizeof line, "%d %s   (%s)", i + 1, stage->name, stage->source);
            put_text(written, STYLE_FOCUS, width, 2, line);
            glyphs_plain(glyphs, stage->equation, line, sizeof line);
            put_text(written, STYLE_NORMAL, width, 4, line);
            put_text(written, STYLE_FAINT, width, 4, stage->sentence);
        }
        write_passages(written, width, glyphs, text->after, text->n_after);
    }
    if (page == 3) {
        const Settings *settings = experiment_settings(screen->experiment);
        put_text(written, STYLE_HEADING, width, 0,
                 "Where the paper is silent or does otherwise, and what is done here");
        for (const Choice *choice = choices; choice < choices + n_choices; choice++) {
            char line[512];
            if (!choice_is_about(choice, settings->problem, settings->method))
                continue;
            put_text(written, STYLE_FOCUS, width, 0, choice->what);
            snprintf(line, sizeof line, "paper: %s", choice->paper);
            put_text(written, STYLE_FAINT, width, 4, line);
            snprintf(line, sizeof line, "here: %s", choice->here);
            put_text(written, STYLE_NORMAL, width, 4, line);
        }
    }
}

int help_most(const Screen *screen, int width, int height)
{
    HelpLines written;
    if (layout_make(screen, width, height).kind == LAYOUT_TOO_SMALL)
        return 0; /* nothing of it is shown, and its lines need some width */
    write_page(&written, screen, page_of(screen), width);
    const int room = height - 3; /* without title, heading and bar */
    return written.count > room ? written.count - room : 0;
}

/* Words may be broken at the end of the line. */
static bool begins_in_line(const HelpLines *written, int line, const char *words)
{
    const char *own = written->text + written->lines[line].at;
    const char *next = line + 1 < written->count ? written->text + written->lines[line + 1].at : "";
    char joined[1024];
    snprintf(joined, sizeof joined, "%s %s", own, next + strspn(next, " "));
    const char *at = strcasestr(joined, words);
    return at && (size_t)(at - joined) < strlen(own);
}

bool help_search(const Screen *screen, int width, const char *words, HelpShown *at)
{
    const int pages = help_pages(screen), first = page_of(screen);
    for (int turn = 0; turn <= pages; turn++) {
        HelpLines written;
        const int page = (first + turn) % pages;
        write_page(&written, screen, page, width);
        for (int y = turn > 0 ? 0 : at->found ? at->found : at->scroll; y < written.count; y++)
            if (begins_in_line(&written, y, words)) {
                at->page = page;
                at->scroll = y;
                at->found = y + 1;
                return true;
            }
    }
    return false;
}

void help_draw(const Screen *screen, Area area)
{
    static const char *const names[HELP_PAGES] = {"this scenario, the keys", "the curves", "what is solved",
                                                  "where the paper is silent"};
    const int page = page_of(screen), room = area.rect.height - 1;
    HelpLines written;
    write_page(&written, screen, page, area.rect.width);

    int first = screen->help->scroll;
    if (first > written.count - room)
        first = written.count - room;
    if (first < 0)
        first = 0;
    char heading[96];
    snprintf(heading, sizeof heading, "Help %d of %d: %s", page + 1, help_pages(screen), names[page]);
    area_rule(area, heading, STYLE_FOCUS);
    if (written.count > room) {
        snprintf(heading, sizeof heading, " lines %d-%d of %d ", first + 1,
                 first + room < written.count ? first + room : written.count, written.count);
        if (glyphs_columns(heading) + 30 < area.rect.width)
            area_text_right(area, area.rect.width - 2, 0, heading, STYLE_FAINT);
    }
    for (int y = 0; y < room && first + y < written.count; y++)
        area_text(area, 1, 1 + y, written.text + written.lines[first + y].at,
                  first + y + 1 == screen->help->found ? STYLE_SELECTED : written.lines[first + y].style);
}
