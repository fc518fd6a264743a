/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The state in which a page of a lesson is entered, and its goal. */

#include "base/assertion.h"
#include "lab/laboratory.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define GOAL_SECONDS 8.0 /* within which a page's run comes to its goal, slowly enough to be watched */
#define EVENT_PACE   0.2 /* steps a frame at most, where the distance is not known */
#define HURRY_PACE   1e6 /* steps a frame, for what is not to be watched */

const LessonPage *lesson_entry_page(const Laboratory *lab)
{
    const LessonShown *shown = &lab->play.shown;
    return shown->open && shown->lesson ? &shown->lesson->pages[shown->page] : NULL;
}

/* --- goals ------------------------------------------------------------------------------------------ */

/* What the run is to stop at for it. The end of a run needs no stop. */
static Stop goal_stop(const Laboratory *lab, const LessonUntil *until)
{
    Stop stop = {.kind = STOP_NEVER};
    if (until->kind == UNTIL_TIME)
        stop = (Stop){.kind = STOP_AT_TIME, .time = until->number};
    else if (until->kind == UNTIL_STEP)
        stop = (Stop){.kind = STOP_AT_STEP, .step = (long)until->number};
    else if (until->kind == UNTIL_EVENT && !stop_read(&stop, until->word, laboratory_run(lab), NULL))
        stop.kind = STOP_NEVER;
    return stop;
}

/* The whole step at which the goal is a place of the run; -1: it is none, or not known. That of an event is
 * the first one behind the place where the page was opened, as far as the run has come. */
static long goal_step(const Laboratory *lab, const LessonUntil *until)
{
    const Experiment *experiment = laboratory_run(lab);
    const Stop stop = goal_stop(lab, until);
    const long last = experiment_last_step(experiment);
    if (until->kind == UNTIL_END || until->kind == UNTIL_GOAL)
        return last;
    if (stop.kind != STOP_AT_EVENT)
        return stop_step(&stop, experiment) < last ? stop_step(&stop, experiment) : last;
    int count;
    const Event *events = experiment_events(experiment, &count);
    for (int i = 0; i < count; i++)
        if (events[i].step > lab->play.place.step && events[i].step <= experiment_step(experiment) &&
            stop.events >> events[i].kind & 1)
            return events[i].step;
    return -1;
}

static bool is_met(Laboratory *lab, const LessonUntil *until)
{
    const Experiment *experiment = laboratory_run(lab);
    const Command *command = until->kind == UNTIL_COMMAND ? command_by_name(until->word) : NULL;
    switch (until->kind) {
    case UNTIL_NOTHING:
        return true;
    case UNTIL_STEP:
    case UNTIL_TIME:
    case UNTIL_END:
    case UNTIL_EVENT:
        return goal_step(lab, until) >= 0 && experiment_step(experiment) >= goal_step(lab, until);
    case UNTIL_STAGE:
        return (double)experiment_stage(experiment) >= until->number;
    case UNTIL_COMMAND:
        return !command || command_set_has(&lab->play.used, command->id);
    case UNTIL_VALUE: {
        const Settings *now = laboratory_settings(lab);
        Settings wanted = *now;
        return settings_set(&wanted, until->word, until->value, NULL) &&
               !settings_differ(now, &wanted, parameter_find(until->word));
    }
    case UNTIL_GOAL:
        return lesson_judge_goal(lab);
    }
    return true;
}

/* Where a page's goal leaves a run that is `from` there; a command that is looked at leaves it there. */
static Place goal_place(const Laboratory *lab, const LessonUntil *until, Place from)
{
    if (until->kind == UNTIL_STAGE)
        return (Place){from.step, (int)until->number};
    const long step = goal_step(lab, until);
    return step >= 0 ? (Place){step, 0} : from;
}

/* --- what a page does ------------------------------------------------------------------------------- */

static bool is_run(const LessonAction *action)
{
    return action->line && strcmp(action->line, "run-pause") == 0;
}

static void run_line(Laboratory *lab, const char *line)
{
    const bool changed = lab->editing.changed; /* quitting does not ask about what the lesson changes */
    const CommandSet used = lab->play.used, hinted = lab->used;
    const Asker user = lab->asker;
    lab->asker = ASKER_LESSON;
    Status status = {STATUS_DONE, ""};
    const bool done = lab->run_line(lab, line, &status);
    lab->asker = user;
    if (!done) {
        snprintf(lab->play.refused, sizeof lab->play.refused, "%.80s: %.200s", line, status.text);
        laboratory_say(lab, MESSAGE_ERROR, "%s", lab->play.refused);
    }
    if (done && lesson_opening(line))
        player_pause(lab); /* a page is read before it is run */
    if (screen_view_in(&lab->screen, lab->screen.panes.focus)) {
        /* on a small screen a view comes to the front: below the page, to which the keys still go */
        lab->screen.panes.last_plot = lab->screen.panes.focus;
        lab->screen.panes.focus = PANE_PARAMETERS;
    }
    lab->play.used = used;
    lab->used = hinted;
    lab->editing.changed = lab->editing.changed && changed;
}

static void run_action(Laboratory *lab, const LessonAction *action)
{
    const LessonUntil *goal = action->goal;
    char line[KEY_MAX + VALUE_MAX + 8];
    if (is_run(action) && lab->player.playback.state == STATE_RUNNING)
        return; /* it would pause */
    if (action->line) {
        run_line(lab, action->line);
    } else if (goal->kind == UNTIL_VALUE) {
        snprintf(line, sizeof line, "set %s %s", goal->word, goal->value);
        run_line(lab, line);
    } else if (goal->kind == UNTIL_EVENT) {
        const Stop stop = goal_stop(lab, goal);
        lab->play.place.step = experiment_step(laboratory_run(lab));
        lab->play.hurries = true;
        lab->player.playback.pace = HURRY_PACE;
        lab->player.resume = STATE_RUNNING;
        player_stop_at(lab, &stop);
        player_settle(lab);
    } else {
        const Place to = goal_place(lab, goal, (Place){experiment_step(laboratory_run(lab)), 0});
        player_seek(lab, to.step, to.stage);
    }
}

/* A goal is run to, and where a number is asked for the end, so fast that one can follow. */
void lesson_entry_choose_pace(Laboratory *lab)
{
    const LessonPage *page = lesson_entry_page(lab);
    player_choose_pace(&lab->player);
    if (!page)
        return;
    const bool to_end = page->exercise && page->exercise->kind == EXERCISE_NUMBER;
    const long goal = to_end ? experiment_last_step(laboratory_run(lab)) : goal_step(lab, &page->until);
    const long way = goal - experiment_step(laboratory_run(lab));
    if (way > 0)
        lab->player.playback.pace = player_pace_for((double)way, GOAL_SECONDS);
    else if (page->until.kind == UNTIL_EVENT)
        lab->player.playback.pace = fmin(lab->player.playback.pace, EVENT_PACE);
}

/* A page that waits for nothing goes on to where the next one begins in the same run. */
static Stop next_begin(const Laboratory *lab)
{
    const LessonShown *shown = &lab->play.shown;
    Stop stop = {.kind = STOP_NEVER};
    if (shown->page + 1 >= shown->lesson->n_pages || lesson_entry_page(lab)->exercise)
        return stop;
    const LessonPart *next = &shown->lesson->pages[shown->page + 1].first;
    for (int i = 0; i < next->n_actions && !lesson_opening(next->actions[i]); i++) {
        const LineMeaning line = line_meaning(next->actions[i]);
        double time;
        char more;
        if (strncmp(next->actions[i], "goto ", 5) == 0 && sscanf(line.words, "%lf %c", &time, &more) == 1 &&
            time > experiment_time(laboratory_run(lab)))
            return (Stop){.kind = STOP_AT_TIME, .time = time};
    }
    return stop;
}

/* Where the page begins its reader's part: from here a goal is run to. */
static void arrive(Laboratory *lab)
{
    LessonPlay *play = &lab->play;
    const LessonUntil *until = &lesson_entry_page(lab)->until;
    const Stop stop = until->kind == UNTIL_NOTHING ? next_begin(lab) : goal_stop(lab, until);
    play->arriving = false;
    play->place = (Place){experiment_step(laboratory_run(lab)), experiment_stage(laboratory_run(lab))};
    if (lesson_entry_page(lab)->exercise) {
        play->run.known = true;
        play->run.entered = *experiment_base(laboratory_run(lab));
        play->run.was_judged = false;
        lab->homework.elsewhere = (ExerciseMark){0};
    }
    player_stop_at(lab, &stop);
    if (lab->message.kind != MESSAGE_ERROR && play->resumes > 0)
        laboratory_tell(lab, "you had come to page %d; b turns back", play->resumes);
    else if (lab->message.kind != MESSAGE_ERROR)
        laboratory_say(lab, MESSAGE_NONE, "%s", ""); /* its text says what the page did */
    play->resumes = 0;
    if (lab->player.pace_automatic)
        lesson_entry_choose_pace(lab);
}

/* Whether the run is on its way to where it should be. */
static bool is_on_the_way(const Laboratory *lab)
{
    const RunState state = lab->player.playback.state;
    return state == STATE_COMPUTING || (lab->play.hurries && state == STATE_RUNNING);
}

void lesson_play_continue(Laboratory *lab)
{
    LessonPlay *play = &lab->play;
    const LessonPage *page = lesson_entry_page(lab);
    LessonShown *shown = &lab->play.shown;
    if (play->busy)
        return;
    play->busy = true;
    if (play->hurries && !is_on_the_way(lab)) {
        play->hurries = false;
        laboratory_say(lab, MESSAGE_NONE, "%s", ""); /* the reader need not be told where it stopped */
    }
    while (play->next < play->n_queue && !is_on_the_way(lab)) {
        if (page && play->next == play->n_queue - 1 && is_run(&play->queue[play->next]))
            arrive(lab); /* where it stands before it runs */
        run_action(lab, &play->queue[play->next++]);
    }
    if (page && play->arriving && play->next == play->n_queue && !is_on_the_way(lab))
        arrive(lab);
    if (page && !play->arriving && !shown->met)
        shown->met = is_met(lab, &page->until);
    play->busy = false;
}

/* --- keys on its way --------------------------------------------------------------------------------- */

static bool is_arriving(const Laboratory *lab)
{
    return lab->play.arriving && lesson_entry_page(lab);
}

/* Whether a key is that of one of some commands, which end with COMMAND_NONE. */
static bool is_one_of(const Key *key, const CommandId *ids)
{
    const Command *command = command_by_key(key->name);
    while (command && *ids != COMMAND_NONE && command->id != *ids)
        ids++;
    return command && *ids != COMMAND_NONE;
}

bool lesson_entry_keeps(Laboratory *lab, const Key *key)
{
    static const CommandId always[] = {COMMAND_INTERRUPT, COMMAND_CANCEL, COMMAND_REDRAW, COMMAND_SUSPEND,
                                       COMMAND_NONE},
                           leaving[] = {COMMAND_PAGE_UP, COMMAND_PAGE_DOWN, COMMAND_LESSONS, COMMAND_QUIT,
                                        COMMAND_NONE};
    LessonPlay *play = &lab->play;
    /* Turning the page, closing the lesson or the program does not wait, unless something before it does. */
    const bool leaves = play->n_waiting == 0 && (strcmp(key->name, "n") == 0 || strcmp(key->name, "b") == 0 ||
                                                 is_one_of(key, leaving));
    if (!is_arriving(lab) || leaves || (lab->prompting.shown.open && lab->prompting.shown.yes_no) ||
        is_one_of(key, always))
        return false;
    if (key->x < 0 && play->n_waiting < LESSON_KEYS_MAX)
        play->waiting[play->n_waiting++] = *key;
    laboratory_tell(lab, "computing this page; keys are kept until then; ^C cancels");
    return true;
}

bool lesson_entry_next_key(Laboratory *lab, Key *key)
{
    LessonPlay *play = &lab->play;
    if (play->n_waiting == 0 || is_arriving(lab) || lab->closed)
        return false;
    *key = play->waiting[0];
    memmove(play->waiting, play->waiting + 1, (size_t)--play->n_waiting * sizeof *play->waiting);
    return true;
}

bool lesson_entry_cancel(Laboratory *lab)
{
    LessonPlay *play = &lab->play;
    const bool computes = lab->player.playback.state == STATE_COMPUTING, arrives = is_arriving(lab);
    if (computes)
        duel_cancel(&lab->player.duel);
    if (arrives) {
        play->n_queue = play->next = play->n_waiting = 0;
        play->arriving = play->hurries = play->run.known = false;
        play->touched = true;
    }
    if (computes || arrives)
        player_pause(lab);
    return computes || arrives;
}

/* --- the state of a page ---------------------------------------------------------------------------- */

/* Only goes to a place of the run, whatever the place before it was. */
static bool is_move(const LessonAction *action)
{
    if (!action->line)
        return action->goal->kind == UNTIL_STEP || action->goal->kind == UNTIL_TIME ||
               action->goal->kind == UNTIL_END;
    return line_meaning(action->line).kind == LINE_PLACE || strncmp(action->line, "goto ", 5) == 0;
}

/* A goal that a later one overtakes is left out; opening a scenario makes all before it void. */
static void queue_action(LessonPlay *play, LessonAction action)
{
    const bool in_step = action.goal && action.goal->kind == UNTIL_STAGE;
    if (action.line && lesson_opening(action.line))
        play->n_queue = 0;
    for (int i = play->n_queue - 1; i >= 0 && (is_move(&action) || in_step); i--) {
        LessonAction *before = &play->queue[i];
        const bool stage = before->goal && before->goal->kind == UNTIL_STAGE;
        if (stage || (!in_step && is_move(before)))
            memmove(before, before + 1, (size_t)(--play->n_queue - i) * sizeof *before);
        else if (!(before->line &&
                   (strncmp(before->line, "show ", 5) == 0 || strncmp(before->line, "particle ", 9) == 0 ||
                    strncmp(before->line, "node ", 5) == 0)))
            break;
    }
    if (play->n_queue < LESSON_QUEUE_MAX)
        play->queue[play->n_queue++] = action;
}

static void queue_part(LessonPlay *play, const LessonPart *part, bool own)
{
    for (int i = 0; i < part->n_actions; i++) {
        const LessonAction action = {.line = part->actions[i]};
        /* Holds on its own page only. */
        if (own || !(is_run(&action) || strncmp(action.line, "sheet", 5) == 0))
            queue_action(play, action);
    }
}

static bool has_opening(const LessonPart *part)
{
    for (int i = 0; i < part->n_actions; i++)
        if (lesson_opening(part->actions[i]))
            return true;
    return false;
}

/* Whether the run is just what this page leaves to the next one. */
static bool page_state_reusable(const Laboratory *lab, const LessonPage *page, const LessonPage *next)
{
    const Experiment *experiment = laboratory_run(lab);
    const LessonPlay *play = &lab->play;
    if (!page || play->touched || play->arriving || play->next < play->n_queue)
        return false;
    if (page->question && lab->play.shown.answer < 0 && page->revealed.n_actions > 0)
        return false;
    if (page->until.kind == UNTIL_VALUE || page->until.kind == UNTIL_STEP || page->until.kind == UNTIL_GOAL)
        return false; /* other values before it, or its last stage, are seen still */
    for (int i = 0; i < next->first.n_actions; i++) { /* nor may the next one go back */
        const LessonAction action = {.line = next->first.actions[i]};
        double time;
        if (is_move(&action) &&
            (sscanf(action.line, "%*[a-z] %lf", &time) != 1 || time < experiment_time(experiment)))
            return false;
    }
    const Place left = goal_place(lab, &page->until, play->place);
    return experiment_step(experiment) == left.step && experiment_stage(experiment) == left.stage &&
           experiment_newest(experiment) == left.step && !experiment_failed(experiment, NULL);
}

int *lesson_entry_reached(Laboratory *lab)
{
    for (int i = 0; i < LESSONS_MAX && builtin_lessons[i].name; i++)
        if (strcmp(builtin_lessons[i].name, lab->play.name) == 0)
            return &lab->play.shown.reached[i];
    return NULL;
}

static void queue_page(Laboratory *lab, int page)
{
    const LessonShown *shown = &lab->play.shown;
    const LessonPage *pages = shown->lesson->pages;
    LessonPlay *play = &lab->play;
    const bool goes_on = shown->page >= 0 && page == shown->page + 1 &&
                         page_state_reusable(lab, lesson_entry_page(lab), &pages[page]);
    play->n_queue = play->next = 0;
    /* the page from which on the state has to be made */
    int first = page;
    bool needed = !goes_on && !has_opening(&pages[page].first);
    while (needed && first > 0) {
        first--;
        needed = !has_opening(&pages[first].first) && !has_opening(&pages[first].revealed);
    }
    for (int i = first; i < page; i++) {
        queue_part(play, &pages[i].first, false);
        queue_part(play, &pages[i].revealed, false);
        /* Of what the reader finds himself the way that the lesson knows is gone, to the end of its run. */
        static const LessonUntil end = {.kind = UNTIL_END};
        const LessonUntil *until = &pages[i].until;
        queue_part(play, &pages[i].solution, false);
        if (until->kind == UNTIL_GOAL)
            until = &end;
        if (until->kind != UNTIL_NOTHING && until->kind != UNTIL_COMMAND)
            queue_action(play, (LessonAction){.goal = until});
    }
    queue_part(play, &pages[page].first, true);
}

/* The row of the parameter pane that the arrows change, so that fields beside a text work as there. */
void lesson_entry_select(Laboratory *lab, const char *key)
{
    lab->parameters.filter[0] = '\0';
    lab->parameters.selected = screen_row_of(&lab->screen, parameter_find(key));
}

void lesson_entry_show(Laboratory *lab, int page)
{
    ASSERT_INT(page, >=, 0);
    Screen *screen = &lab->screen;
    LessonShown *shown = &lab->play.shown;
    LessonPlay *play = &lab->play;
    if (lab->player.playback.state == STATE_COMPUTING)
        duel_cancel(&lab->player.duel); /* for the page that is left */
    player_pause(lab);
    queue_page(lab, page);
    shown->page = page;
    shown->answer = shown->marked = -1;
    shown->verdict[0] = '\0';
    shown->scroll = 0;
    shown->met = false;
    play->arriving = true;
    play->run.known = false;
    play->touched = false;
    play->refused[0] = '\0';
    play->used = (CommandSet){{0}};
    play->warned = false;
    play->asker = lab->asker;
    int *reached = lesson_entry_reached(lab);
    if (reached && *reached < page + 1)
        *reached = page + 1;
    screen->panes.zoomed = screen->panes.inspecting = lab->player.playback.at_limit = false;
    screen->panes.focus = PANE_PARAMETERS;
    if (lab->options.sheet)
        screen->panes.sheet = play->full ? SHEET_FULL : SHEET_PLAIN;
    lab->player.playback.rate = 0;
    lab->player.pace_automatic = true;
    play->hurries = false;
    lesson_play_continue(lab);
    const LessonPage *now = lesson_entry_page(lab);
    if (now->n_fields > 0)
        lesson_entry_select(lab, now->fields[0]);
}

void lesson_entry_reveal(Laboratory *lab)
{
    LessonPlay *play = &lab->play;
    play->n_queue -= play->next;
    memmove(play->queue, play->queue + play->next, (size_t)play->n_queue * sizeof *play->queue);
    play->next = 0;
    queue_part(play, &lesson_entry_page(lab)->revealed, true);
    play->arriving = true;
}

void lesson_entry_note(Laboratory *lab, const Key *key)
{
    static const CommandId harmless[] = {
        COMMAND_RUN_PAUSE,     COMMAND_STEP_FORWARD, COMMAND_STEP_FORWARD_TEN,
        COMMAND_STAGE_FORWARD, COMMAND_STEP_BACK,    COMMAND_STEP_BACK_TEN,
        COMMAND_STAGE_BACK,    COMMAND_FASTER,       COMMAND_SLOWER,
        COMMAND_ENTER,         COMMAND_PAGE_UP,      COMMAND_PAGE_DOWN,
        COMMAND_NARROWER,      COMMAND_REDRAW,       COMMAND_NONE};
    const LessonPage *page = lesson_entry_page(lab);
    const bool answers = page && page->question && lab->play.shown.answer < 0 && key->name[0] >= '1' &&
                         key->name[0] < '1' + page->n_choices && !key->name[1];
    if (page &&
        (!(answers || is_one_of(key, harmless)) || lab->parameters.edit.open || lab->prompting.shown.open))
        lab->play.touched = true;
}
