/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The key line: what can be done now, a message, or a question with what was typed. */
#include "panes/panes.h"
#include "scenario/settings.h"

#include <stdio.h>
#include <string.h>

/* The commands that the bar offers, what matters most first; a pair shares one word. */
typedef struct Offer {
    CommandId id, pair;
    const char *word; /* NULL: the command's own */
} Offer;

static int offers_of(const Screen *screen, const Offer **offers)
{
    static const Offer running[] = {
        {COMMAND_RUN_PAUSE, COMMAND_NONE, NULL}, {COMMAND_FASTER, COMMAND_SLOWER, "speed"},
        {COMMAND_NEXT_PANE, COMMAND_NONE, NULL}, {COMMAND_REFERENCES, COMMAND_NONE, NULL},
        {COMMAND_HELP, COMMAND_NONE, NULL},      {COMMAND_QUIT, COMMAND_NONE, NULL},
        {COMMAND_RESTART, COMMAND_NONE, NULL},   {COMMAND_ZOOM, COMMAND_NONE, NULL},
        {COMMAND_QUESTION, COMMAND_NONE, NULL},  {COMMAND_PIN, COMMAND_NONE, NULL},
    };
    static const Offer paused[] = {
        {COMMAND_RUN_PAUSE, COMMAND_NONE, NULL},
        {COMMAND_STEP_BACK, COMMAND_STEP_FORWARD, "step"},
        {COMMAND_STAGE_BACK, COMMAND_STAGE_FORWARD, "stage"},
        {COMMAND_NEXT_PANE, COMMAND_NONE, NULL},
        {COMMAND_EXPORT, COMMAND_NONE, NULL},
        {COMMAND_HELP, COMMAND_NONE, NULL},
        {COMMAND_QUIT, COMMAND_NONE, NULL},
        {COMMAND_INSPECT, COMMAND_NONE, NULL},
        {COMMAND_GO_TO, COMMAND_NONE, NULL},
        {COMMAND_ZOOM, COMMAND_NONE, NULL},
        {COMMAND_REFERENCES, COMMAND_NONE, NULL},
        {COMMAND_RESTART, COMMAND_NONE, NULL},
    };
    static const Offer paused_parameters[] = {
        {COMMAND_RUN_PAUSE, COMMAND_NONE, NULL},     {COMMAND_LEFT, COMMAND_RIGHT, "change"},
        {COMMAND_ENTER, COMMAND_NONE, "edit"},       {COMMAND_STEP_FORWARD, COMMAND_NONE, NULL},
        {COMMAND_STAGE_FORWARD, COMMAND_NONE, NULL}, {COMMAND_EXPORT, COMMAND_NONE, NULL},
        {COMMAND_HELP, COMMAND_NONE, NULL},          {COMMAND_QUIT, COMMAND_NONE, NULL},
        {COMMAND_NEXT_PANE, COMMAND_NONE, NULL},     {COMMAND_ZOOM, COMMAND_NONE, NULL},
        {COMMAND_UNDO, COMMAND_NONE, NULL},
    };
    static const Offer rows_of_plate[] = {
        {COMMAND_RUN_PAUSE, COMMAND_NONE, NULL},  {COMMAND_ENTER, COMMAND_NONE, "edit"},
        {COMMAND_ROW_MOVE, COMMAND_NONE, NULL},   {COMMAND_ROW_COPY, COMMAND_NONE, NULL},
        {COMMAND_ROW_DELETE, COMMAND_NONE, NULL}, {COMMAND_ROW_ADD, COMMAND_NONE, NULL},
        {COMMAND_HELP, COMMAND_NONE, NULL},       {COMMAND_QUIT, COMMAND_NONE, NULL},
        {COMMAND_NEXT_PANE, COMMAND_NONE, NULL},  {COMMAND_UNDO, COMMAND_NONE, NULL},
    };
    static const Offer running_parameters[] = {
        {COMMAND_RUN_PAUSE, COMMAND_NONE, NULL},  {COMMAND_LEFT, COMMAND_RIGHT, "change"},
        {COMMAND_ENTER, COMMAND_NONE, "edit"},    {COMMAND_FASTER, COMMAND_SLOWER, "speed"},
        {COMMAND_REFERENCES, COMMAND_NONE, NULL}, {COMMAND_HELP, COMMAND_NONE, NULL},
        {COMMAND_QUIT, COMMAND_NONE, NULL},       {COMMAND_NEXT_PANE, COMMAND_NONE, NULL},
        {COMMAND_RESTART, COMMAND_NONE, NULL},    {COMMAND_QUESTION, COMMAND_NONE, NULL},
    };
    static const Offer ended[] = {
        {COMMAND_RUN_PAUSE, COMMAND_NONE, NULL}, {COMMAND_EXPORT, COMMAND_NONE, NULL},
        {COMMAND_STEP_BACK, COMMAND_NONE, NULL}, {COMMAND_START, COMMAND_NONE, NULL},
        {COMMAND_NEXT_PANE, COMMAND_NONE, NULL}, {COMMAND_HELP, COMMAND_NONE, NULL},
        {COMMAND_QUIT, COMMAND_NONE, NULL},      {COMMAND_REFERENCES, COMMAND_NONE, NULL},
        {COMMAND_PIN, COMMAND_NONE, NULL},       {COMMAND_QUESTION, COMMAND_NONE, NULL},
        {COMMAND_ZOOM, COMMAND_NONE, NULL},
    };
    static const Offer computing[] = {
        {COMMAND_INTERRUPT, COMMAND_NONE, "stop here"},
        {COMMAND_CANCEL, COMMAND_NONE, "stop here"},
    };
    static const Offer help[] = {
        {COMMAND_LEFT, COMMAND_RIGHT, "page"},
        {COMMAND_UP, COMMAND_DOWN, "scroll"},
        {COMMAND_CANCEL, COMMAND_NONE, "back"},
    };
    static const Offer editing[] = {
        {COMMAND_ENTER, COMMAND_NONE, "take it"},
        {COMMAND_CANCEL, COMMAND_NONE, "leave it"},
    };
    static const Offer lesson[] = {
        {COMMAND_PAGE_UP, COMMAND_PAGE_DOWN, "page"}, {COMMAND_RUN_PAUSE, COMMAND_NONE, NULL},
        {COMMAND_STEP_FORWARD, COMMAND_NONE, NULL},   {COMMAND_STAGE_FORWARD, COMMAND_NONE, NULL},
        {COMMAND_LESSONS, COMMAND_NONE, "close"},     {COMMAND_HELP, COMMAND_NONE, NULL},
        {COMMAND_QUIT, COMMAND_NONE, NULL},           {COMMAND_SHEET, COMMAND_NONE, NULL},
        {COMMAND_NEXT_PANE, COMMAND_NONE, NULL},
    };
    static const Offer lessons[] = {
        {COMMAND_UP, COMMAND_DOWN, "choose"},     {COMMAND_ENTER, COMMAND_NONE, "open"},
        {COMMAND_LESSONS, COMMAND_NONE, "close"}, {COMMAND_RUN_PAUSE, COMMAND_NONE, NULL},
        {COMMAND_HELP, COMMAND_NONE, NULL},       {COMMAND_QUIT, COMMAND_NONE, NULL},
        {COMMAND_NEXT_PANE, COMMAND_NONE, NULL},
    };
    static const Offer lesson_fields[] = {
        {COMMAND_PAGE_UP, COMMAND_PAGE_DOWN, "page"}, {COMMAND_LEFT, COMMAND_RIGHT, "change"},
        {COMMAND_RUN_PAUSE, COMMAND_NONE, NULL},      {COMMAND_LESSONS, COMMAND_NONE, "close"},
        {COMMAND_HELP, COMMAND_NONE, NULL},           {COMMAND_QUIT, COMMAND_NONE, NULL},
        {COMMAND_STEP_FORWARD, COMMAND_NONE, NULL},   {COMMAND_SHEET, COMMAND_NONE, NULL},
        {COMMAND_NEXT_PANE, COMMAND_NONE, NULL},
    };
    static const Offer lesson_stages[] = {
        {COMMAND_PAGE_UP, COMMAND_PAGE_DOWN, "page"}, {COMMAND_STAGE_BACK, COMMAND_STAGE_FORWARD, "stage"},
        {COMMAND_INSPECT, COMMAND_NONE, NULL},        {COMMAND_LESSONS, COMMAND_NONE, "close"},
        {COMMAND_HELP, COMMAND_NONE, NULL},           {COMMAND_QUIT, COMMAND_NONE, NULL},
        {COMMAND_SHEET, COMMAND_NONE, NULL},          {COMMAND_NEXT_PANE, COMMAND_NONE, NULL},
    };
    static const Offer plain[] = {
        {COMMAND_RUN_PAUSE, COMMAND_NONE, NULL}, {COMMAND_LEFT, COMMAND_RIGHT, "change"},
        {COMMAND_SHEET, COMMAND_NONE, NULL},     {COMMAND_HELP, COMMAND_NONE, NULL},
        {COMMAND_LESSONS, COMMAND_NONE, NULL},   {COMMAND_QUIT, COMMAND_NONE, NULL},
        {COMMAND_ENTER, COMMAND_NONE, "edit"},   {COMMAND_STAGE_FORWARD, COMMAND_NONE, NULL},
        {COMMAND_OPEN, COMMAND_NONE, NULL},      {COMMAND_LECTURE, COMMAND_NONE, NULL},
    };
    static const Offer plain_at_first[] = {
        {COMMAND_RUN_PAUSE, COMMAND_NONE, NULL},
        {COMMAND_LEFT, COMMAND_RIGHT, "change"},
        {COMMAND_ENTER, COMMAND_NONE, "first lesson"},
        {COMMAND_SHEET, COMMAND_NONE, NULL},
        {COMMAND_HELP, COMMAND_NONE, NULL},
        {COMMAND_QUIT, COMMAND_NONE, NULL},
    };
    static const Offer lecture[] = {
        {COMMAND_RUN_PAUSE, COMMAND_NONE, NULL}, {COMMAND_STAGE_BACK, COMMAND_STAGE_FORWARD, "stage"},
        {COMMAND_LEFT, COMMAND_RIGHT, "change"}, {COMMAND_LECTURE, COMMAND_NONE, "small"},
        {COMMAND_HELP, COMMAND_NONE, NULL},      {COMMAND_QUIT, COMMAND_NONE, NULL},
    };
    static const Offer magnified[] = {
        {COMMAND_LEFT, COMMAND_RIGHT, "move"},       {COMMAND_UP, COMMAND_DOWN, "move"},
        {COMMAND_FASTER, COMMAND_SLOWER, "size"},    {COMMAND_CANCEL, COMMAND_NONE, "whole"},
        {COMMAND_RUN_PAUSE, COMMAND_NONE, NULL},     {COMMAND_STEP_FORWARD, COMMAND_NONE, NULL},
        {COMMAND_STAGE_FORWARD, COMMAND_NONE, NULL}, {COMMAND_ZOOM, COMMAND_NONE, NULL},
    };
#define GIVE(list) return *offers = list, (int)(sizeof list / sizeof *list)
    if (screen->help.open)
        GIVE(help);
    if (screen->parameters.edit.open)
        GIVE(editing);
    if (screen->playback.state == STATE_COMPUTING)
        GIVE(computing);
    const bool in_fields = screen->panes.focus == PANE_PARAMETERS;
    if (screen->panes.lecture && !screen->lesson.open)
        GIVE(lecture);
    if (screen->eye.open && !in_fields)
        GIVE(magnified);
    if (in_fields && screen->lesson.open) {
        const LessonShown *shown = &screen->lesson;
        if (!shown->lesson)
            GIVE(lessons);
        if (shown->lesson->pages[shown->page].n_fields > 0)
            GIVE(lesson_fields);
        if (shown->lesson->pages[shown->page].until.kind == UNTIL_STAGE ||
            shown->lesson->pages[shown->page].until.kind == UNTIL_STEP)
            GIVE(lesson_stages);
        GIVE(lesson);
    }
    RowPlace place;
    if (in_fields && screen_is_plain(screen) && !screen->lesson.open && screen->offers_lesson)
        GIVE(plain_at_first);
    if (in_fields && screen_selected_row(screen, &place) && !place.value && !screen->lesson.open)
        GIVE(rows_of_plate);
    if (in_fields && screen_is_plain(screen) && !screen->lesson.open)
        GIVE(plain);
    if (screen->playback.state == STATE_RUNNING) {
        if (in_fields)
            GIVE(running_parameters);
        GIVE(running);
    }
    if (screen->playback.state == STATE_ENDED || screen->playback.state == STATE_FAILED)
        GIVE(ended);
    if (in_fields)
        GIVE(paused_parameters);
    GIVE(paused);
#undef GIVE
}

/* A key's name as the bar shows it: short. In ASCII no "<", for that is the key of ten steps. */
static const char *short_key(const Screen *screen, const char *key)
{
    static const char *const shorter[][3] = {
        {"Left", "←", "<-"}, {"Right", "→", "->"}, {"Up", "↑", "Up"}, {"Down", "↓", "Down"}};
    if (screen->lesson.open && screen->lesson.lesson && strncmp(key, "Page", 4) == 0)
        return key[4] == 'U' ? "b" : "n"; /* not every keyboard has the other ones */
    for (size_t i = 0; i < sizeof shorter / sizeof *shorter; i++)
        if (strcmp(key, shorter[i][0]) == 0)
            return shorter[i][screen->look.glyphs == GLYPHS_ASCII ? 2 : 1];
    return key;
}

/* What the key does now. */
static const char *word_of(const Screen *screen, const Command *command)
{
    const Playback *playback = &screen->playback;
    if (command->id == COMMAND_SHEET)
        return parameter_sheet_words[screen_is_plain(screen) ? SHEET_FULL : SHEET_PLAIN];
    if (command->id != COMMAND_RUN_PAUSE)
        return command_brief(command);
    return playback->state == STATE_RUNNING                                    ? "pause"
           : playback->state == STATE_ENDED || playback->state == STATE_FAILED ? "again"
                                                                               : command_brief(command);
}

enum { KEYS_OF_ONE_PANE = 80 };

static int find_offer(const Offer *offers, int count, CommandId id)
{
    for (int i = 0; i < count; i++)
        if (offers[i].id == id)
            return i;
    return -1;
}

/* The one that stands at a place once the one at `from` was brought forward, if that is forward, to `to`. */
static int brought(int from, int to, int place)
{
    if (from < to || place < to || place > from)
        return place;
    return place == to ? from : place - 1;
}

/* The offer that stands at a place of the bar. Where one pane is seen at a time and room is short, the key to
 * the others comes second and that to all keys fourth, wherever they are on the list. */
static const Offer *offer_at(const Offer *offers, int count, int width, int place)
{
    enum { PANE_PLACE = 1, HELP_PLACE = 3 };
    const int pane = find_offer(offers, count, COMMAND_NEXT_PANE);
    int help = find_offer(offers, count, COMMAND_HELP);
    if (width >= KEYS_OF_ONE_PANE)
        return &offers[place];
    if (help >= PANE_PLACE && help < pane)
        help++; /* the other one has passed it */
    return &offers[brought(pane, PANE_PLACE, brought(help, HELP_PLACE, place))];
}

/* Lays the offers out from the left; draws them if `area` is not NULL. Returns the command at column x. */
static CommandId lay_out_bar(const Screen *screen, int width, const Area *area, int wanted_x)
{
    const Offer *offers;
    int count = offers_of(screen, &offers), x = 1;
    CommandId found = COMMAND_NONE;
    for (int i = 0; i < count; i++) {
        const Offer *offer = offer_at(offers, count, width, i);
        const Command *command = command_find(offer->id), *pair = command_find(offer->pair);
        if (!command || (offer->pair != COMMAND_NONE && !pair))
            continue;
        char key[COMMAND_KEY_MAX], other[COMMAND_KEY_MAX] = "";
        command_first_key(command, key);
        if (pair)
            command_first_key(pair, other);
        const char *first = short_key(screen, key), *second = short_key(screen, other);
        const char *word = offer->word ? offer->word : word_of(screen, command);
        int first_columns = glyphs_columns(first),
            keys = first_columns + (pair ? 1 + glyphs_columns(second) : 0);
        int columns = keys + 1 + glyphs_columns(word);
        if (x + columns > width - 1)
            continue;
        if (area) {
            area_text(*area, x, 0, first, STYLE_KEY);
            if (pair)
                area_text(*area, x + first_columns + 1, 0, second, STYLE_KEY);
            area_text(*area, x + keys + 1, 0, word, STYLE_TITLE);
        }
        if (wanted_x >= x && wanted_x < x + columns)
            found = pair && wanted_x > x + first_columns && wanted_x <= x + keys ? pair->id : command->id;
        x += columns + 2;
    }
    return found;
}

CommandId screen_key_command(const Screen *screen, int width, int x)
{
    return lay_out_bar(screen, width, NULL, x);
}

enum { EDIT_HINT_COLUMN = 31 };

/* What was refused, and why, in full: it takes as many lines as it needs, the last one at row y of the bar's
 * area (row -1 lies above it). Returns how many. */
static int draw_notice(Area bar, int y, const char *text, Style style)
{
    const int width = bar.rect.width - 2, last = bar.rect.y + y;
    int rows = area_paragraph_lines(width, text);
    rows = rows < last ? rows : last;
    Area area = {bar.canvas, {bar.rect.x, last - rows + 1, bar.rect.width, rows}, bar.glyphs};
    for (int row = 0; row < rows; row++)
        for (int x = 0; x < bar.rect.width; x++)
            area_put(area, x, row, ' ', style);
    area_paragraph(area, 1, 0, width, rows, text, style);
    return rows;
}

static void draw_prompt(const Screen *screen, Area area)
{
    const Prompt *prompt = &screen->prompt;
    int x = area_text(area, 1, 0, prompt->question, STYLE_KEY) + 2;
    if (prompt->yes_no) {
        area_text(area, x, 0, "y / n", STYLE_TITLE);
        if (prompt->problem[0])
            draw_notice(area, -1, prompt->problem, STYLE_WARNING);
        area.canvas->cursor_x = area.rect.x + x;
        area.canvas->cursor_y = area.rect.y;
        return;
    }
    /* a long text moves left so that the cursor is seen */
    int room = area.rect.width - x - 1, cursor = prompt->cursor;
    const char *text = prompt->text;
    for (; cursor >= room && *text; cursor--)
        glyph_next(&text);
    Area field = area_part(area, x, 0, room, 1);
    for (int i = 0; i < room; i++)
        area_put(field, i, 0, ' ', STYLE_EDIT);
    area_text(field, 0, 0, text, STYLE_EDIT);
    const char *notice = prompt->problem[0] ? prompt->problem : prompt->hint;
    int above = area.rect.y;
    if (*notice)
        above -= draw_notice(area, -1, notice, prompt->problem[0] ? STYLE_ERROR : STYLE_TITLE);
    if (prompt->scenarios)
        pane_scenarios(prompt->scenarios,
                       (Area){area.canvas, {area.rect.x, 0, area.rect.width, area.rect.y}, area.glyphs},
                       above);
    area.canvas->cursor_x = area.rect.x + x + (cursor < room ? cursor : room - 1);
    area.canvas->cursor_y = area.rect.y;
}

/* The keys; beside a field under edit, what it is and what it may be. */
static void draw_keys(const Screen *screen, Area area)
{
    lay_out_bar(screen, area.rect.width, &area, -1);
    ParameterRow rows[PARAMETER_ROWS_MAX];
    const int count = screen_parameter_rows(screen, rows);
    if (!screen->parameters.edit.open || screen->parameters.selected < 0 ||
        screen->parameters.selected >= count || !rows[screen->parameters.selected].parameter)
        return;
    const Parameter *parameter = rows[screen->parameters.selected].parameter;
    char range[96], text[320];
    const Problem *problem = experiment_settings(screen->experiment)->problem;
    parameter_range(parameter, problem, range, sizeof range);
    const char *unit = problem->si ? parameter->unit : "";
    snprintf(text, sizeof text, "%s (%s%s%s): %s", parameter->key, range, *unit ? " " : "", unit,
             parameter_help(parameter, problem));
    if (EDIT_HINT_COLUMN + glyphs_columns(text) < area.rect.width)
        area_text(area, EDIT_HINT_COLUMN, 0, text, STYLE_TITLE);
    else
        draw_notice(area, -1, text, STYLE_TITLE);
}

void pane_keys(const Screen *screen, Area area)
{
    static const Style styles[] = {
        [MESSAGE_NONE] = STYLE_TITLE,
        [MESSAGE_INFO] = STYLE_TITLE,
        [MESSAGE_WARNING] = STYLE_WARNING,
        [MESSAGE_ERROR] = STYLE_ERROR,
    };
    for (int x = 0; x < area.rect.width; x++)
        area_put(area, x, 0, ' ', STYLE_TITLE);
    if (screen->prompt.open)
        draw_prompt(screen, area);
    else if (screen->parameters.edit.open && screen->parameters.edit.problem[0])
        draw_notice(area, 0, screen->parameters.edit.problem, STYLE_ERROR);
    else if (screen->message.kind != MESSAGE_NONE && screen->message.text[0])
        draw_notice(area, 0, screen->message.text, styles[screen->message.kind]);
    else
        draw_keys(screen, area);
    if (screen->offers_lesson && !screen_is_plain(screen))
        draw_notice(area, -1, "First time here?  Enter begins the first lesson.  Any other key goes on.",
                    STYLE_SELECTED);
}
