/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The key line: what can be done now, a message, or a question with what was typed. */
#include "lessons/lesson_shown.h"
#include "panes/panes.h"
#include "run/playback.h"
#include "views/view.h"

#include <stdio.h>
#include <string.h>

/* The commands that the bar offers; a pair shares one word. */
typedef struct Offer {
    CommandId id, pair;
    const char *word; /* NULL: the command's own */
} Offer;

#define PAIR(command, other, word)                                                                           \
    {                                                                                                        \
        COMMAND_##command, COMMAND_##other, word                                                             \
    }
#define AS(command, word) PAIR(command, NONE, word)
#define KEY(command)      PAIR(command, NONE, NULL)

/* What the bar offers, what matters most first; ended by COMMAND_NONE where there are fewer. */
typedef struct Offers {
    Offer all[KEY_OFFERS_MAX];
} Offers;

static const Offers running_keys = {{KEY(RUN_PAUSE), PAIR(FASTER, SLOWER, "speed"), KEY(NEXT_PANE),
                                     KEY(REFERENCES), KEY(HELP), KEY(QUIT), KEY(RESTART), KEY(ZOOM),
                                     KEY(QUESTION), KEY(PIN)}};
static const Offers paused_keys = {{KEY(RUN_PAUSE), PAIR(STEP_BACK, STEP_FORWARD, "step"),
                                    PAIR(STAGE_BACK, STAGE_FORWARD, "stage"), KEY(NEXT_PANE), KEY(EXPORT),
                                    KEY(HELP), KEY(QUIT), KEY(INSPECT), KEY(GO_TO), KEY(ZOOM),
                                    KEY(REFERENCES), KEY(RESTART)}};
static const Offers paused_parameters_keys = {{KEY(RUN_PAUSE), PAIR(LEFT, RIGHT, "change"), AS(ENTER, "edit"),
                                               KEY(STEP_FORWARD), KEY(STAGE_FORWARD), KEY(EXPORT), KEY(HELP),
                                               KEY(QUIT), KEY(NEXT_PANE), KEY(ZOOM), KEY(UNDO)}};
static const Offers rows_of_plate_keys = {{KEY(RUN_PAUSE), AS(ENTER, "edit"), KEY(ROW_MOVE), KEY(ROW_COPY),
                                           KEY(ROW_DELETE), KEY(ROW_ADD), KEY(HELP), KEY(QUIT),
                                           KEY(NEXT_PANE), KEY(UNDO)}};
static const Offers running_parameters_keys = {
    {KEY(RUN_PAUSE), PAIR(LEFT, RIGHT, "change"), AS(ENTER, "edit"), PAIR(FASTER, SLOWER, "speed"),
     KEY(REFERENCES), KEY(HELP), KEY(QUIT), KEY(NEXT_PANE), KEY(RESTART), KEY(QUESTION)}};
static const Offers ended_keys = {{KEY(RUN_PAUSE), KEY(EXPORT), KEY(STEP_BACK), KEY(START), KEY(NEXT_PANE),
                                   KEY(HELP), KEY(QUIT), KEY(REFERENCES), KEY(PIN), KEY(QUESTION),
                                   KEY(ZOOM)}};
static const Offers computing_keys = {{AS(INTERRUPT, "stop here"), AS(CANCEL, "stop here")}};
static const Offers help_keys = {
    {PAIR(LEFT, RIGHT, "page"), PAIR(UP, DOWN, "scroll"), AS(CANCEL, "back"), AS(FILTER, "search")}};
static const Offers editing_keys = {{AS(ENTER, "apply"), AS(CANCEL, "cancel")}};
static const Offers lesson_keys = {{PAIR(PAGE_UP, PAGE_DOWN, "page"), KEY(RUN_PAUSE), KEY(STEP_FORWARD),
                                    KEY(STAGE_FORWARD), AS(LESSONS, "close"), KEY(HELP), KEY(QUIT),
                                    KEY(SHEET), KEY(NEXT_PANE)}};
static const Offers lessons_keys = {{PAIR(UP, DOWN, "choose"), AS(ENTER, "open"), AS(LESSONS, "close"),
                                     KEY(RUN_PAUSE), KEY(HELP), KEY(QUIT), AS(FILTER, "search"),
                                     KEY(NEXT_PANE)}};
static const Offers lesson_fields_keys = {{PAIR(PAGE_UP, PAGE_DOWN, "page"), PAIR(LEFT, RIGHT, "change"),
                                           KEY(RUN_PAUSE), AS(LESSONS, "close"), KEY(HELP), KEY(QUIT),
                                           KEY(STEP_FORWARD), KEY(SHEET), KEY(NEXT_PANE)}};
static const Offers lesson_stages_keys = {
    {PAIR(PAGE_UP, PAGE_DOWN, "page"), PAIR(STAGE_BACK, STAGE_FORWARD, "stage"), KEY(INSPECT),
     AS(LESSONS, "close"), KEY(HELP), KEY(QUIT), KEY(SHEET), KEY(NEXT_PANE)}};
static const Offers plain_keys = {{KEY(RUN_PAUSE), PAIR(LEFT, RIGHT, "change"), KEY(SHEET), KEY(HELP),
                                   KEY(LESSONS), KEY(QUIT), AS(ENTER, "edit"), KEY(STAGE_FORWARD), KEY(OPEN),
                                   KEY(LECTURE)}};
static const Offers plain_at_first_keys = {{KEY(RUN_PAUSE), PAIR(LEFT, RIGHT, "change"),
                                            AS(ENTER, "first lesson"), KEY(SHEET), KEY(HELP), KEY(QUIT)}};
static const Offers lecture_keys = {{KEY(RUN_PAUSE), PAIR(STAGE_BACK, STAGE_FORWARD, "stage"),
                                     PAIR(LEFT, RIGHT, "change"), AS(LECTURE, "small"), KEY(HELP),
                                     KEY(QUIT)}};
static const Offers magnified_keys = {{PAIR(LEFT, RIGHT, "move"), PAIR(UP, DOWN, "move"),
                                       PAIR(FASTER, SLOWER, "size"), AS(CANCEL, "whole"), KEY(RUN_PAUSE),
                                       KEY(STEP_FORWARD), KEY(STAGE_FORWARD), KEY(ZOOM)}};

/* Help aside, of which the first page tells them. */
static const Offers *offers_of(const Screen *screen)
{
    const bool in_fields = screen->panes.focus == PANE_PARAMETERS, plain = screen_is_plain(screen);
    const RunState state = screen->playback->state;
    RowPlace place;
    if (screen->parameters->edit.open)
        return &editing_keys;
    if (state == STATE_COMPUTING)
        return &computing_keys;
    if (screen->panes.lecture && !screen->lesson->open)
        return &lecture_keys;
    if (screen->eye.open && !in_fields)
        return &magnified_keys;
    if (in_fields && screen->lesson->open && !screen->lesson->lesson)
        return &lessons_keys;
    if (in_fields && screen->lesson->open) {
        const LessonPage *page = &screen->lesson->lesson->pages[screen->lesson->page];
        const bool steps = page->until.kind == UNTIL_STAGE || page->until.kind == UNTIL_STEP;
        return page->n_fields > 0 ? &lesson_fields_keys : steps ? &lesson_stages_keys : &lesson_keys;
    }
    if (in_fields && plain && screen->offers_lesson)
        return &plain_at_first_keys;
    if (in_fields && screen_selected_row(screen, &place) && !place.value)
        return &rows_of_plate_keys;
    if (in_fields && plain)
        return &plain_keys;
    if (state == STATE_RUNNING)
        return in_fields ? &running_parameters_keys : &running_keys;
    if (state == STATE_ENDED || state == STATE_FAILED)
        return &ended_keys;
    return in_fields ? &paused_parameters_keys : &paused_keys;
}

const char *pane_command_brief(const Command *command)
{
    const View *view = view_of_digit(command_digit(command->id));
    return !view ? command->brief : view->brief ? view->brief : view->word;
}

const char *pane_command_help(const Command *command)
{
    const View *view = view_of_digit(command_digit(command->id));
    return view ? view->help : command->help;
}

/* A key's name as the bar shows it: short. In ASCII no "<", for that is the key of ten steps. */
static const char *short_key(const Screen *screen, const char *key)
{
    static const char *const shorter[][3] = {
        {"Left", "←", "<-"}, {"Right", "→", "->"}, {"Up", "↑", "Up"}, {"Down", "↓", "Down"}};
    if (screen->lesson->open && screen->lesson->lesson && strncmp(key, "Page", 4) == 0)
        return key[4] == 'U' ? "b" : "n"; /* not every keyboard has the other ones */
    for (size_t i = 0; i < sizeof shorter / sizeof *shorter; i++)
        if (strcmp(key, shorter[i][0]) == 0)
            return shorter[i][screen->look.glyphs == GLYPHS_ASCII ? 2 : 1];
    return key;
}

/* What the key does now. */
static const char *word_of(const Screen *screen, const Command *command)
{
    const Playback *playback = screen->playback;
    if (command->id == COMMAND_SHEET)
        return parameter_sheet_words[screen_is_plain(screen) ? SHEET_FULL : SHEET_PLAIN];
    if (command->id != COMMAND_RUN_PAUSE)
        return pane_command_brief(command);
    return playback->state == STATE_RUNNING                                    ? "pause"
           : playback->state == STATE_ENDED || playback->state == STATE_FAILED ? "again"
                                                                               : pane_command_brief(command);
}

static void bring_forward(Offer *offers, CommandId id, int to)
{
    for (int i = to + 1; i < KEY_OFFERS_MAX; i++)
        if (offers[i].id == id) {
            const Offer brought = offers[i];
            memmove(&offers[to + 1], &offers[to], (size_t)(i - to) * sizeof brought);
            offers[to] = brought;
            return;
        }
}

static bool describe_offer(const Screen *screen, const Offer *offer, KeyOffer *out)
{
    *out = (KeyOffer){.command = command_find(offer->id), .pair = command_find(offer->pair)};
    if (!out->command || (offer->pair != COMMAND_NONE && !out->pair))
        return false;
    const Command *const both[] = {out->command, out->pair};
    for (int k = 0; k < 2 && both[k]; k++) {
        char key[COMMAND_KEY_MAX];
        command_first_key(both[k], key);
        snprintf(out->keys[k], COMMAND_KEY_MAX, "%s", short_key(screen, key));
    }
    out->word = offer->word ? offer->word : word_of(screen, out->command);
    return true;
}

int pane_key_offers(const Screen *screen, KeyOffer out[KEY_OFFERS_MAX])
{
    const Offer *offers = offers_of(screen)->all;
    int count = 0;
    for (int i = 0; i < KEY_OFFERS_MAX && offers[i].id != COMMAND_NONE; i++)
        count += describe_offer(screen, &offers[i], &out[count]);
    return count;
}

/* Lays the offers out from the left; draws them if `area` is not NULL. Returns the command at column x. */
static CommandId lay_out_bar(const Screen *screen, int width, const Area *area, int wanted_x)
{
    enum { KEYS_OF_ONE_PANE = 80, PANE_PLACE = 1, HELP_PLACE = 3 };
    Offers offers = screen->help->open ? help_keys : *offers_of(screen);
    CommandId found = COMMAND_NONE;
    int x = 1;
    /* Where one pane is seen at a time and room is short, the key to the others comes second and that to all
     * keys fourth, wherever they are on the list. */
    if (width < KEYS_OF_ONE_PANE) {
        bring_forward(offers.all, COMMAND_NEXT_PANE, PANE_PLACE);
        bring_forward(offers.all, COMMAND_HELP, HELP_PLACE);
    }
    for (int i = 0; i < KEY_OFFERS_MAX && offers.all[i].id != COMMAND_NONE; i++) {
        KeyOffer offer;
        if (!describe_offer(screen, &offers.all[i], &offer))
            continue;
        const int first = glyphs_columns(offer.keys[0]),
                  keys = first + (offer.pair ? 1 + glyphs_columns(offer.keys[1]) : 0);
        const int columns = keys + 1 + glyphs_columns(offer.word);
        if (x + columns > width - 1)
            continue;
        if (area) {
            area_text(*area, x, 0, offer.keys[0], STYLE_KEY);
            area_text(*area, x + first + 1, 0, offer.keys[1], STYLE_KEY);
            area_text(*area, x + keys + 1, 0, offer.word, STYLE_TITLE);
        }
        if (wanted_x >= x && wanted_x < x + columns)
            found = offer.pair && wanted_x > x + first && wanted_x <= x + keys ? offer.pair->id
                                                                               : offer.command->id;
        x += columns + 2;
    }
    return found;
}

CommandId screen_key_command(const Screen *screen, int width, int x)
{
    return lay_out_bar(screen, width, NULL, x);
}

/* What was refused, and why, in full: it takes as many lines as it needs, the last one at row y of the bar's
 * area (row -1 lies above it). Returns how many. */
static int draw_notice(Area bar, int y, const char *text, Style style)
{
    const int width = bar.rect.width - 2, last = bar.rect.y + y;
    int rows = area_paragraph_lines(width, text);
    rows = rows < last ? rows : last;
    Area area = {bar.canvas, {bar.rect.x, last - rows + 1, bar.rect.width, rows}, bar.glyphs};
    for (int row = 0; row < rows; row++)
        area_blank(area, 0, bar.rect.width, row, style);
    area_paragraph(area, 1, 0, width, rows, text, style);
    return rows;
}

/* --- the scenarios to choose from ----------------------------------------------------------------- */

/* On as many rows as there are and fit, above row `bottom`. */
static void pane_scenarios(const ScenarioList *list, Area area, int bottom)
{
    const int width = area.rect.width;
    int names = 0, titles = 0; /* the widest of them */
    for (int i = 0; i < list->n_shown; i++) {
        const int name = glyphs_columns(list->entries[list->shown[i]].name),
                  title = glyphs_columns(list->entries[list->shown[i]].title);
        names = name > names ? name : names;
        titles = title > titles ? title : titles;
    }
    const bool beside = 1 + names + 2 + titles + 1 <= width;
    const char *chosen = list->chosen >= 0 ? list->entries[list->shown[list->chosen]].title : "";
    const int below = !beside && *chosen ? area_paragraph_lines(width - 2, chosen) : 0;
    const int room = bottom - 1 - below; /* the title line stays */
    const int rows = list->n_shown < room ? list->n_shown : room;
    if (rows < 1)
        return;
    int first = (list->chosen >= 0 ? list->chosen : list->open) - rows / 2;
    first = first > list->n_shown - rows ? list->n_shown - rows : first;
    first = first > 0 ? first : 0;
    for (int row = 0; row < rows; row++) {
        const int i = first + row, y = bottom - below - rows + row, entry = list->shown[i];
        const Style style = i == list->chosen ? STYLE_SELECTED : STYLE_TITLE;
        area_blank(area, 0, width, y, style);
        area_text(area, 0, y, i == list->open ? ">" : "", style);
        area_text(area, 1, y, list->entries[entry].name, style);
        if (beside)
            area_text(area, 1 + names + 2, y, list->entries[entry].title, style);
        const bool more_above = row == 0 && first > 0, more_below = row == rows - 1 && i < list->n_shown - 1;
        if (more_above || more_below)
            area_text_right(area, width - 1, y, more_above ? "↑" : "↓", style);
    }
    for (int y = bottom - below; y < bottom; y++)
        area_blank(area, 0, width, y, STYLE_TITLE);
    area_paragraph(area, 1, bottom - below, width - 2, below, chosen, STYLE_TITLE);
}

static void draw_prompt(const Screen *screen, Area area)
{
    const Prompt *prompt = screen->prompt;
    int x = area_text(area, 1, 0, prompt->question, STYLE_KEY) + 2;
    if (prompt->yes_no) {
        area_text(area, x, 0, "y / n", STYLE_TITLE);
        if (prompt->problem[0])
            draw_notice(area, -1, prompt->problem, STYLE_WARNING);
        area.canvas->cursor_x = area.rect.x + x;
        area.canvas->cursor_y = area.rect.y;
        return;
    }
    const char *notice = prompt->problem[0] ? prompt->problem : prompt->hint;
    int above = area.rect.y;
    if (*notice)
        above -= draw_notice(area, -1, notice, prompt->problem[0] ? STYLE_ERROR : STYLE_TITLE);
    if (prompt->scenarios)
        pane_scenarios(prompt->scenarios,
                       (Area){area.canvas, {area.rect.x, 0, area.rect.width, area.rect.y}, area.glyphs},
                       above);
    pane_field(area_part(area, x, 0, area.rect.width - x - 1, 1), prompt->text, prompt->cursor);
}

void pane_keys(const Screen *screen, Area area)
{
    enum { EDIT_HINT_COLUMN = 31 };
    static const Style styles[] = {
        [MESSAGE_NONE] = STYLE_TITLE,
        [MESSAGE_INFO] = STYLE_TITLE,
        [MESSAGE_WARNING] = STYLE_WARNING,
        [MESSAGE_ERROR] = STYLE_ERROR,
    };
    area_blank(area, 0, area.rect.width, 0, STYLE_TITLE);
    if (screen->prompt->open)
        draw_prompt(screen, area);
    else if (screen->parameters->edit.open && screen->parameters->edit.problem[0])
        draw_notice(area, 0, screen->parameters->edit.problem, STYLE_ERROR);
    else if (screen->message->kind != MESSAGE_NONE && screen->message->text[0])
        draw_notice(area, 0, screen->message->text, styles[screen->message->kind]);
    else {
        ParameterRow row;
        lay_out_bar(screen, area.rect.width, &area, -1);
        if (screen->parameters->edit.open && screen_chosen_row(screen, &row) && row.parameter) {
            /* beside the keys, what the field under edit is and what it may be */
            const Parameter *parameter = row.parameter;
            const Problem *problem = screen_problem(screen);
            const char *unit = problem->si ? parameter->unit : "";
            char range[96], text[320];
            parameter_range(parameter, problem, range, sizeof range);
            snprintf(text, sizeof text, "%s (%s%s%s): %s", parameter->key, range, *unit ? " " : "", unit,
                     parameter_in(parameter, problem).help);
            if (EDIT_HINT_COLUMN + glyphs_columns(text) < area.rect.width)
                area_text(area, EDIT_HINT_COLUMN, 0, text, STYLE_TITLE);
            else
                draw_notice(area, -1, text, STYLE_TITLE);
        }
    }
    if (screen->offers_lesson && !screen_is_plain(screen))
        draw_notice(area, -1, "First time here?  Enter begins the first lesson.  Any other key goes on.",
                    STYLE_SELECTED);
}
