/* Lessons: pages beside the run, and what the laboratory does when one is opened. */
#include "tui/control/laboratory.h"
#include "tui/control/prompt/line.h"
#include "tui/control/lesson/lesson_progress.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int *reached_of(Laboratory *lab)
{
    for (int i = 0; i < LESSONS_MAX && builtin_lessons[i].name; i++)
        if (strcmp(builtin_lessons[i].name, lab->play.name) == 0)
            return &lab->screen.lesson.reached[i];
    return NULL;
}

/* --- what a page does ------------------------------------------------------------------------------- */

static const LessonPage *page_now(const LessonShown *shown)
{
    return shown->open && shown->lesson ? &shown->lesson->pages[shown->page] : NULL;
}

static void queue_part(LessonPlay *play, const LessonPart *part)
{
    for (int i = 0; i < part->n_actions && play->n_queue < LESSON_QUEUE_MAX; i++)
        play->queue[play->n_queue++] = part->actions[i];
}

static void run_action(Laboratory *lab, const char *action)
{
    const CommandSet used = lab->play.used;
    const bool changed = lab->editing.changed; /* quitting does not ask about what the lesson changes */
    const bool opens = strncmp(action, "open ", 5) == 0;
    const Asker user = lab->asker;
    lab->asker = ASKER_LESSON;
    const bool done = lab->run_line(lab, action);
    lab->asker = user;
    if (!done)
        laboratory_say(lab, MESSAGE_ERROR, "%s: %s", action, lab->screen.prompt.problem);
    else if (opens)
        player_pause(lab); /* a page is read before it is run */
    lab->play.used = used;
    lab->editing.changed = lab->editing.changed && changed;
}

static bool has_value(const Laboratory *lab, const LessonUntil *until)
{
    const Settings *now = experiment_settings(lab->screen.experiment);
    const Parameter *parameter = parameter_find(until->word);
    Settings wanted = *now;
    char is[LIST_MAX], should_be[LIST_MAX];
    if (!settings_set(&wanted, until->word, until->value, NULL))
        return false;
    settings_get(now, parameter, is);
    settings_get(&wanted, parameter, should_be);
    return strcmp(is, should_be) == 0;
}

static bool is_met(const Laboratory *lab, const LessonUntil *until)
{
    const Experiment *experiment = lab->screen.experiment;
    const Command *command = until->kind == UNTIL_COMMAND ? command_by_name(until->word) : NULL;
    switch (until->kind) {
    case UNTIL_NOTHING:
        return true;
    case UNTIL_STEP:
        return (double)experiment_step(experiment) >= until->number;
    case UNTIL_TIME:
        return experiment_time(experiment) >= until->number;
    case UNTIL_STAGE:
        return (double)experiment_stage(experiment) >= until->number;
    case UNTIL_END:
        return experiment_at_end(experiment);
    case UNTIL_COMMAND:
        return !command || command_set_has(&lab->play.used, command->id);
    case UNTIL_VALUE:
        return has_value(lab, until);
    }
    return true;
}

void lesson_play_continue(Laboratory *lab)
{
    LessonPlay *play = &lab->play;
    if (play->busy)
        return;
    play->busy = true;
    while (play->next < play->n_queue && lab->screen.playback.state != STATE_COMPUTING)
        run_action(lab, play->queue[play->next++]);
    const LessonPage *page = page_now(&lab->screen.lesson);
    if (page && play->next == play->n_queue && !lab->screen.lesson.met)
        lab->screen.lesson.met = is_met(lab, &page->until);
    play->busy = false;
}

/* --- pages ------------------------------------------------------------------------------------------ */

static bool opens_scenario(const LessonPage *page)
{
    return page->first.n_actions > 0 && strncmp(page->first.actions[0], "open ", 5) == 0;
}

/* The row of the parameter pane that the arrows change, so that fields beside a text work as they do there.
 */
static void select_field(Laboratory *lab, const char *key)
{
    ParameterRow rows[PARAMETER_ROWS_MAX];
    lab->screen.parameters.filter[0] = '\0';
    const int count = screen_parameter_rows(&lab->screen, rows);
    for (int i = 0; i < count; i++)
        if (rows[i].parameter && strcmp(rows[i].parameter->key, key) == 0)
            lab->screen.parameters.selected = i;
}

/* Turns to a page. What it shows rests on what the pages before it did since the last that opened a scenario;
 * whoever does not come from the page before needs all of that. */
static void show_page(Laboratory *lab, int page)
{
    LessonShown *shown = &lab->screen.lesson;
    LessonPlay *play = &lab->play;
    int from = page;
    const bool goes_on = play->next == play->n_queue && page == shown->page + 1;
    while (!goes_on && from > 0 && !opens_scenario(&shown->lesson->pages[from]))
        from--;
    play->n_queue = play->next = 0;
    for (; from < page; from++) {
        queue_part(&lab->play, &shown->lesson->pages[from].first);
        queue_part(&lab->play, &shown->lesson->pages[from].revealed);
    }
    queue_part(&lab->play, &shown->lesson->pages[page].first);
    shown->page = page;
    shown->answer = -1;
    shown->scroll = 0;
    shown->met = false;
    play->used = (CommandSet){{0}};
    play->warned = false;
    play->asker = lab->asker;
    int *reached = reached_of(lab);
    if (reached && *reached < page + 1)
        *reached = page + 1;
    lab->screen.panes.focus = PANE_PARAMETERS;
    lesson_play_continue(lab);
    const LessonPage *now = page_now(&lab->screen.lesson);
    if (now->n_fields > 0)
        select_field(lab, now->fields[0]);
}

static void turn_page(Laboratory *lab, int direction)
{
    LessonShown *shown = &lab->screen.lesson;
    const LessonPage *page = page_now(&lab->screen.lesson);
    const bool open_question = page->question && shown->answer < 0;
    if (direction > 0 && (open_question || !shown->met) && !lab->play.warned) {
        lab->play.warned = true; /* pressed again, the key leaves the page out */
        laboratory_say(lab, MESSAGE_INFO, "%s; PageDown again leaves it out",
                       open_question ? "the question waits for an answer" : "this page waits for something");
    } else if (shown->page + direction >= 0 && shown->page + direction < shown->lesson->n_pages) {
        show_page(lab, shown->page + direction);
    } else {
        laboratory_say(lab, MESSAGE_INFO,
                       direction > 0 ? "that was the last page; T closes the lesson"
                                     : "this is the first page");
    }
}

static void take_answer(Laboratory *lab, int choice)
{
    lab->screen.lesson.answer = choice;
    lab->play.warned = false;
    queue_part(&lab->play, &page_now(&lab->screen.lesson)->revealed);
}

/* --- opening and closing ---------------------------------------------------------------------------- */

static void forget_lesson(Laboratory *lab)
{
    lesson_free(&lab->play.lesson);
    lab->play.n_queue = lab->play.next = 0;
    lab->play.name[0] = '\0';
    lab->screen.lesson.lesson = NULL;
}

const char laboratory_all_lessons[] = "-";

bool lesson_play_open(Laboratory *lab, const char *name, Status *status)
{
    if (strcmp(name, laboratory_all_lessons) == 0) {
        lab->screen.lesson.open = true;
        return true;
    }
    Lesson lesson;
    if (!lesson_load(name, command_line_for_lessons, &lesson, status))
        return false;
    forget_lesson(lab);
    lab->play.lesson = lesson;
    snprintf(lab->play.name, sizeof lab->play.name, "%s", name);
    LessonShown *shown = &lab->screen.lesson;
    shown->open = true;
    shown->lesson = &lab->play.lesson;
    shown->page = -1;
    const int *reached = reached_of(lab);
    const int page = reached && *reached > 1 && *reached < lesson.n_pages ? *reached - 1 : 0;
    show_page(lab, page);
    if (page > 0)
        laboratory_say(lab, MESSAGE_INFO, "you had come to page %d; PageUp turns back", page + 1);
    return true;
}

void lesson_play_close(Laboratory *lab)
{
    if (lab->play.name[0])
        lesson_progress_write(lab->play.asker, lab->screen.lesson.reached);
    forget_lesson(lab);
    lab->screen.lesson.open = false;
}

void lesson_play_toggle(Laboratory *lab)
{
    if (lab->screen.lesson.open) {
        lesson_play_close(lab);
        return;
    }
    lab->screen.lesson.open = true;
    lab->screen.lesson.scroll = 0;
    lab->screen.panes.focus = PANE_PARAMETERS;
}

bool lesson_play_answer(Laboratory *lab, const char *text)
{
    Status status = {STATUS_DONE, ""};
    return lesson_play_open(lab, text, &status) || prompt_refuse(&lab->prompting, status.text);
}

/* --- keys ------------------------------------------------------------------------------------------- */

static int digit_of(const Key *key)
{
    return key->name[0] >= '1' && key->name[0] <= '9' && !key->name[1] ? key->name[0] - '1' : -1;
}

static void open_from_list(Laboratory *lab, int lesson)
{
    Status status = {STATUS_DONE, ""};
    if (lesson >= screen_lesson_count())
        return;
    lab->screen.lesson.chosen = lesson;
    if (!lesson_play_open(lab, builtin_lessons[lesson].name, &status))
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
}

bool lesson_play_click(Laboratory *lab, int x, int y)
{
    const int lesson = screen_lesson_at(&lab->screen, lab->width, lab->height, x, y);
    if (lesson >= 0)
        open_from_list(lab, lesson);
    return lesson >= 0;
}

void lesson_play_enter(Laboratory *lab)
{
    const LessonPage *page = page_now(&lab->screen.lesson);
    if (!page)
        open_from_list(lab, lab->screen.lesson.chosen);
    else if (page->n_fields > 0)
        edit_begin(lab);
    else if (page->question && lab->screen.lesson.answer < 0)
        laboratory_say(lab, MESSAGE_INFO, "a number answers the question: 1 to %d", page->n_choices);
    else
        laboratory_say(lab, MESSAGE_INFO, "there is no field on this page; PageDown and PageUp turn pages");
}

bool lesson_play_key(Laboratory *lab, const Key *key)
{
    const LessonShown *shown = &lab->screen.lesson;
    const LessonPage *page = page_now(&lab->screen.lesson);
    const int digit = digit_of(key);
    if (!shown->open)
        return false;
    if (!page && digit >= 0) {
        open_from_list(lab, digit);
        return true;
    }
    if (page && page->question && shown->answer < 0 && digit >= 0) {
        if (digit < page->n_choices)
            take_answer(lab, digit);
        return true;
    }
    if (page && (strcmp(key->name, "PageDown") == 0 || strcmp(key->name, "PageUp") == 0)) {
        turn_page(lab, key->name[4] == 'D' ? 1 : -1);
        return true;
    }
    return false;
}

void lesson_play_move(Laboratory *lab, int x, int y)
{
    LessonShown *shown = &lab->screen.lesson;
    const LessonPage *page = page_now(&lab->screen.lesson);
    if (x) {
        if (page && page->n_fields > 0)
            edit_nudge(lab, x);
        return;
    }
    if (!page) {
        const int chosen = shown->chosen + y, last = screen_lesson_count() - 1;
        shown->chosen = chosen < 0 ? 0 : chosen > last ? last : chosen;
        return;
    }
    const int most = screen_lesson_most(&lab->screen, lab->width, lab->height), to = shown->scroll + y;
    if (page->n_fields > 1 && most == 0) {
        const Parameter *selected = edit_selected(&lab->screen);
        int at = 0;
        while (selected && at < page->n_fields && strcmp(page->fields[at], selected->key) != 0)
            at++;
        at += y < 0 ? -1 : 1;
        if (at >= 0 && at < page->n_fields)
            select_field(lab, page->fields[at]);
        return;
    }
    shown->scroll = to < 0 ? 0 : to > most ? most : to;
}
