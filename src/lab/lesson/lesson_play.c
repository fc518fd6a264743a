/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lessons: pages beside the run, and what the laboratory does when one is opened. */
#include "lab/laboratory.h"
#include "panes/panes.h"
#include "lab/session/state_file.h"

#include <stdio.h>
#include <string.h>
#include <math.h>

/* Exercises of a page: answers are asked for, judged and noted. */

/* What follows is shown; more answers change nothing. */
static void reveal(Laboratory *lab, int answer)
{
    lab->play.shown.answer = answer;
    lab->play.warned = false;
    lesson_entry_reveal(lab);
}

static bool take_words(Laboratory *lab, const char *text, Status *status)
{
    ExerciseMark *mark = lesson_judge_mark(lab);
    if (!text[strspn(text, " ")])
        return status_refuse(status, "a few words are expected");
    mark->tries++;
    snprintf(mark->value, sizeof mark->value, "%s", text);
    lesson_judge_say(lab, true, "Kept for the teacher.");
    reveal(lab, 0);
    return true;
}

static bool take_number(Laboratory *lab, const char *text, Status *status)
{
    const Exercise *exercise = lesson_entry_page(lab) ? lesson_entry_page(lab)->exercise : NULL;
    double given, right;
    if (!exercise_read_number(text, &given))
        return status_refuse(status, "a number is expected");
    if (!exercise || exercise->kind != EXERCISE_NUMBER)
        return true; /* another page was turned to meanwhile */
    if (!lesson_judge_number(lab, &right, status))
        return false;
    laboratory_say(lab, MESSAGE_NONE, "%s", "");
    const bool known = isfinite(right), accepted = known && exercise_accepts(exercise, right, given);
    ExerciseMark *mark = lesson_judge_mark(lab);
    if (!mark->right) { /* once it was right it stays so */
        mark->tries++;
        mark->judged = known;
        mark->right = accepted;
        text_shortest(mark->value, given);
        exercise_write_number(right, mark->right_answer);
    }
    if (!known)
        lesson_judge_say(lab, false, "Noted. What is right is not known here.");
    else
        lesson_judge_say(lab, accepted, accepted ? "Right: %s." : "Not %s. Try again.", text);
    if (accepted || !known)
        reveal(lab, 0);
    return true;
}

/* Notes the choice that was taken; only the first one counts, for then the right one is shown. */
static void take_answer(Laboratory *lab, int choice)
{
    const LessonPage *page = lesson_entry_page(lab);
    ExerciseMark *mark = lesson_judge_mark(lab);
    if (mark->tries++ > 0) {
        if (lab->play.shown.counts)
            lesson_judge_say(lab, mark->right, "Your first answer counts: %s.", mark->value);
    } else {
        mark->judged = true;
        mark->right = choice == page->right;
        snprintf(mark->value, sizeof mark->value, "%s", page->choices[choice]);
        snprintf(mark->right_answer, sizeof mark->right_answer, "%s", page->choices[page->right]);
    }
    reveal(lab, choice);
}

/* --- opening and closing ---------------------------------------------------------------------------- */

static void forget_lesson(Laboratory *lab)
{
    lesson_free(&lab->play.lesson);
    lab->play.n_queue = lab->play.next = lab->play.n_waiting = 0;
    lab->play.name[0] = '\0';
    lab->play.resumes = 0;
    lab->play.shown.lesson = NULL;
}

const char laboratory_all_lessons[] = "-";

bool lesson_play_open(Laboratory *lab, const char *name, Status *status)
{
    if (strcmp(name, laboratory_all_lessons) == 0) {
        lab->play.shown.open = true;
        return true;
    }
    Lesson lesson;
    if (!lesson_load_for(name, lab->options.student ? lab->options.student : "", command_line_for_lessons,
                         &lesson, status))
        return false;
    /* from lesson to lesson the sheet from before the first one is kept */
    if (!lab->play.shown.lesson)
        lab->play.before = (int)lab->screen.panes.sheet, lab->play.full = false;
    forget_lesson(lab);
    lab->play.lesson = lesson;
    snprintf(lab->play.name, sizeof lab->play.name, "%s", name);
    LessonShown *shown = &lab->play.shown;
    shown->open = true;
    shown->lesson = &lab->play.lesson;
    shown->page = -1;
    shown->counts = lab->options.student && lesson_judge_counts(lab);
    const int *reached = lesson_entry_reached(lab);
    /* a lesson that was read to its end begins again */
    const int page = reached && *reached > 1 && *reached < lesson.n_pages ? *reached - 1 : 0;
    lab->play.resumes = page > 0 ? page + 1 : 0;
    lesson_entry_show(lab, page);
    return true;
}

void lesson_play_close(Laboratory *lab)
{
    /* of a laboratory that was not opened whole there is no run */
    const Parameter *chosen = laboratory_run(lab) ? edit_selected(&lab->screen) : NULL;
    if (lab->play.name[0])
        state_file_write_lessons(lab->play.asker, lab->play.shown.reached);
    if (lab->play.name[0] && lab->options.sheet)
        lab->screen.panes.sheet = (Sheet)lab->play.before;
    forget_lesson(lab);
    lab->play.shown.open = false;
    if (screen_is_plain(&lab->screen) && laboratory_run(lab))
        lab->parameters.selected = screen_row_of(&lab->screen, chosen);
    lab->editing.changed = false; /* what was tried beside a page is nobody's work */
}

void lesson_play_toggle(Laboratory *lab)
{
    if (lab->play.shown.open) {
        lesson_play_close(lab);
        return;
    }
    lab->play.shown.open = true;
    lab->play.shown.scroll = 0;
    lab->screen.panes.focus = PANE_PARAMETERS;
}

static void open_from_list(Laboratory *lab, int lesson)
{
    Status status = {STATUS_DONE, ""};
    if (lesson >= screen_lesson_count())
        return;
    lab->play.shown.chosen = lesson;
    if (!lesson_play_open(lab, builtin_lessons[lesson].name, &status))
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
}

/* `unasked`: whatever the page waits for. */
static void turn_page(Laboratory *lab, int direction, bool unasked)
{
    LessonShown *shown = &lab->play.shown;
    const LessonPage *page = lesson_entry_page(lab);
    const bool open_question = page->question && shown->answer < 0;
    if (direction > 0 && !unasked && (open_question || !shown->met) && !lab->play.warned) {
        char wanted[160];
        lab->play.warned = true; /* pressed again, the key leaves the page out */
        pane_lesson_footer(&lab->screen, wanted, sizeof wanted);
        if (shown->counts && lesson_exercise(page) != EXERCISE_NONE)
            laboratory_tell(lab, "this exercise has no mark yet; n goes on anyway, b comes back");
        else if (open_question)
            laboratory_tell(lab, "the question waits for an answer; n goes on anyway");
        else
            laboratory_tell(lab, "this page waits: %s; n goes on anyway", wanted);
    } else if (shown->page + direction < 0) {
        laboratory_tell(lab, "this is the first page");
    } else if (shown->page + direction == shown->lesson->n_pages) {
        /* At the end of a lesson comes the next one, after the last the list; a file has none. */
        int next = 0;
        while (builtin_lessons[next].name && strcmp(builtin_lessons[next].name, lab->play.name) != 0)
            next++;
        if (builtin_lessons[next].name) {
            lesson_play_close(lab);
            lesson_play_toggle(lab);
            open_from_list(lab, next + 1);
        } else {
            laboratory_tell(lab, "that was the last page; T closes the lesson");
        }
    } else {
        lesson_entry_show(lab, shown->page + direction);
    }
}

/* --- keys ------------------------------------------------------------------------------------------- */

bool lesson_play_click(Laboratory *lab, int x, int y)
{
    const int lesson = screen_lesson_at(&lab->screen, lab->width, lab->height, x, y);
    if (lesson >= 0)
        open_from_list(lab, lesson);
    return lesson >= 0;
}

/* What the page offers comes first: its question, then its field until it has the value. */
void lesson_play_enter(Laboratory *lab)
{
    const LessonShown *shown = &lab->play.shown;
    const LessonPage *page = lesson_entry_page(lab);
    const bool waits = page && page->n_fields > 0 && (page->until.kind == UNTIL_NOTHING || !shown->met);
    if (!page)
        open_from_list(lab, shown->chosen);
    else if (page->n_choices > 0 && shown->answer < 0 && shown->marked >= 0)
        take_answer(lab, shown->marked);
    else if (page->n_choices > 0 && shown->answer < 0)
        laboratory_tell(lab, "a number answers the question: 1 to %d; n goes on anyway", page->n_choices);
    else if (page->question && shown->answer < 0) {
        /* Asks for the number or the words of the page. */
        static const Typing of_number = {.retyped = true, .leaves = "nb"};
        const bool words = lesson_exercise(page) == EXERCISE_WORDS;
        prompt_ask(lab, words ? take_words : take_number, words ? &prompt_retyped : &of_number, "", "%s",
                   words ? "your words" : "your answer");
        snprintf(lab->prompting.shown.hint, sizeof lab->prompting.shown.hint, "%s",
                 words ? "one line for the teacher" : "a number, as 1.5");
    } else if (waits)
        edit_begin(lab);
    else
        turn_page(lab, 1, false);
}

bool lesson_play_turn(Laboratory *lab, int direction)
{
    if (!lesson_entry_page(lab) || lab->screen.panes.focus != PANE_PARAMETERS)
        return false;
    turn_page(lab, direction, false);
    return true;
}

/* In the list. Of two digits the first one chooses, where more lessons begin with it. */
static bool list_key(Laboratory *lab, const char *key)
{
    enum { JUMP = 5 };
    LessonShown *shown = &lab->play.shown;
    const int count = screen_lesson_count(), before = lab->play.digit;
    lab->play.digit = 0;
    if (strcmp(key, "PageDown") == 0 || strcmp(key, "PageUp") == 0) {
        lesson_play_move(lab, 0, key[4] == 'D' ? JUMP : -JUMP);
        return true;
    }
    if (key[0] < (before ? '0' : '1') || key[0] > '9' || key[1])
        return false;
    const int digit = key[0] - '0', both = 10 * before + digit, number = both <= count ? both : digit;
    if (10 * number > count) {
        open_from_list(lab, number - 1);
    } else {
        shown->chosen = number - 1;
        lab->play.digit = number;
        laboratory_tell(lab, "Enter opens lesson %d; a second digit: %d to %d", number, 10 * number,
                        10 * number + 9 < count ? 10 * number + 9 : count);
    }
    return true;
}

static bool holds(const char *text, const char *words)
{
    return text && strcasestr(text, words);
}

/* The first page with these words, from 1; 0: none. What the list says of a lesson belongs to page 1. */
static int page_with(const char *name, const char *words)
{
    Lesson lesson = {0};
    Status ignored = {STATUS_DONE, ""};
    if (!lesson_load(name, command_line_for_lessons, &lesson, &ignored))
        return 0;
    int found = holds(lesson.title, words) || holds(lesson.about, words);
    for (int i = 0; i < lesson.n_pages && !found; i++) {
        const LessonPage *page = &lesson.pages[i];
        if (holds(page->title, words) || holds(page->first.text, words) ||
            holds(page->revealed.text, words) || holds(page->question, words))
            found = i + 1;
    }
    lesson_free(&lesson);
    return found;
}

static bool answer_search(Laboratory *lab, const char *text, Status *status)
{
    LessonShown *shown = &lab->play.shown;
    const int count = screen_lesson_count();
    snprintf(lab->help.sought, sizeof lab->help.sought, "%s", text);
    for (int turn = 1; turn <= count && *text; turn++) {
        const int lesson = (shown->chosen + turn) % count,
                  page = page_with(builtin_lessons[lesson].name, text);
        if (page > 0) {
            shown->chosen = lesson;
            laboratory_tell(lab, "on page %d; / Enter searches on", page);
            return true;
        }
    }
    return !*text || status_refuse(status, "no lesson has these words");
}

void lesson_play_search(Laboratory *lab)
{
    prompt_ask(lab, answer_search, &prompt_retyped, lab->help.sought, "search the lessons");
}

bool lesson_play_key(Laboratory *lab, const Key *key)
{
    static const struct {
        const char *key;
        int direction;
        bool unasked;
    } turns[] = {{"n", 1, true}, {"b", -1, true}, {"PageDown", 1, false}, {"PageUp", -1, false}};
    const LessonShown *shown = &lab->play.shown;
    const LessonPage *page = lesson_entry_page(lab);
    const int digit = key->name[0] >= '1' && key->name[0] <= '9' && !key->name[1] ? key->name[0] - '1' : -1;
    if (!shown->open)
        return false;
    if (!page)
        return list_key(lab, key->name);
    /* while a question is open a digit answers it, and changes no view even where it is not a choice */
    if (page->n_choices > 0 && shown->answer < 0 && digit >= 0) {
        if (digit < page->n_choices)
            take_answer(lab, digit);
        return true;
    }
    for (size_t i = 0; i < sizeof turns / sizeof *turns; i++)
        if (strcmp(key->name, turns[i].key) == 0) {
            turn_page(lab, turns[i].direction, turns[i].unasked);
            return true;
        }
    /* under a page that is read within a step, or step by step, a run would carry off what it speaks of:
     * Space does the next stage, or says how to go on */
    if (lab->player.playback.state == STATE_RUNNING || strcmp(key->name, "Space") != 0 ||
        (page->until.kind != UNTIL_STAGE && page->until.kind != UNTIL_STEP && lab->play.place.stage <= 0))
        return false;
    if (page->n_choices > 0 && shown->answer < 0)
        laboratory_tell(lab, "a number answers the question: 1 to %d", page->n_choices);
    else if (page->until.kind == UNTIL_NOTHING || shown->met)
        laboratory_tell(lab, "this page waits for nothing more: n goes on");
    else
        lab->carry_out(lab, COMMAND_STAGE_FORWARD);
    return true;
}

void lesson_play_move(Laboratory *lab, int x, int y)
{
    LessonShown *shown = &lab->play.shown;
    const LessonPage *page = lesson_entry_page(lab);
    if (x) {
        if (page && page->n_fields > 0)
            edit_nudge(lab, x, false);
        return;
    }
    if (!page) {
        const int chosen = shown->chosen + y, last = screen_lesson_count() - 1;
        shown->chosen = chosen < 0 ? 0 : chosen > last ? last : chosen;
        return;
    }
    /* choices and fields are gone through where the whole page is seen; else the keys turn it */
    const int most = screen_lesson_most(&lab->screen, lab->width, lab->height), to = shown->scroll + y;
    if (page->n_choices > 0 && shown->answer < 0 && most == 0) {
        const int last = page->n_choices - 1, marked = shown->marked + y;
        shown->marked = shown->marked < 0 ? (y > 0 ? 0 : last)
                        : marked < 0      ? 0
                        : marked > last   ? last
                                          : marked;
        return;
    }
    if (page->n_fields > 1 && most == 0) {
        const Parameter *selected = edit_selected(&lab->screen);
        int at = 0;
        while (selected && at < page->n_fields && strcmp(page->fields[at], selected->key) != 0)
            at++;
        at += y < 0 ? -1 : 1;
        if (at >= 0 && at < page->n_fields)
            lesson_entry_select(lab, page->fields[at]);
        return;
    }
    shown->scroll = to < 0 ? 0 : to > most ? most : to;
}
