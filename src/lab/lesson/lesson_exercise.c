/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Asks for answers and notes what became of them (lesson_exercise.h). */
#include "lab/lesson/lesson_exercise.h"

#include "base/text.h"
#include "lab/laboratory.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* What follows is shown; more answers change nothing. */
static void reveal(Laboratory *lab)
{
    lab->play.shown.answer = 0;
    lab->play.warned = false;
    lesson_entry_reveal(lab);
}

static bool take_words(Laboratory *lab, const char *text)
{
    ExerciseMark *mark = lesson_judge_mark(lab);
    if (!text[strspn(text, " ")])
        return prompt_refuse(&lab->prompting, "a few words are wanted");
    mark->tries++;
    snprintf(mark->value, sizeof mark->value, "%s", text);
    lesson_judge_say(lab, true, "Kept for the teacher.");
    reveal(lab);
    return true;
}

/* Once it was right it stays so. */
static void note_number(ExerciseMark *mark, const Exercise *exercise, double right, double given)
{
    if (mark->right)
        return;
    mark->tries++;
    mark->judged = isfinite(right);
    mark->right = mark->judged && exercise_accepts(exercise, right, given);
    text_shortest(mark->value, given);
    exercise_write_number(right, mark->right_answer);
}

static bool take_number(Laboratory *lab, const char *text)
{
    const Exercise *exercise = lesson_entry_page(lab) ? lesson_entry_page(lab)->exercise : NULL;
    char verdict[ANSWER_MAX + 40];
    double given, right;
    Status status = {STATUS_DONE, ""};
    if (!exercise_read_number(text, &given))
        return prompt_refuse(&lab->prompting, "a number is wanted");
    if (!exercise || exercise->kind != EXERCISE_NUMBER)
        return true; /* another page was turned to meanwhile */
    if (!lesson_judge_number(lab, &right, &status))
        return prompt_refuse(&lab->prompting, status.text);
    laboratory_say(lab, MESSAGE_NONE, "%s", "");
    note_number(lesson_judge_mark(lab), exercise, right, given);
    if (!isfinite(right)) {
        lesson_judge_say(lab, false, "Noted. What is right is not known here.");
        reveal(lab);
    } else if (exercise_accepts(exercise, right, given)) {
        snprintf(verdict, sizeof verdict, "Right: %s.", text);
        lesson_judge_say(lab, true, verdict);
        reveal(lab);
    } else {
        snprintf(verdict, sizeof verdict, "Not %s. Try again.", text);
        lesson_judge_say(lab, false, verdict);
    }
    return true;
}

void lesson_exercise_ask(Laboratory *lab)
{
    static const Typing of_words = {.retyped = true}, of_number = {.retyped = true, .leaves = "nb"};
    const bool words = lesson_exercise(lesson_entry_page(lab)) == EXERCISE_WORDS;
    prompt_ask(&lab->prompting, words ? take_words : take_number, false, "", "%s",
               words ? "your words" : "your answer");
    snprintf(lab->prompting.shown.hint, sizeof lab->prompting.shown.hint, "%s",
             words ? "one line for the teacher" : "a number, as 1.5");
    lab->prompting.typing = words ? &of_words : &of_number;
}

void lesson_exercise_choose(Laboratory *lab, int choice)
{
    const LessonPage *page = lesson_entry_page(lab);
    ExerciseMark *mark = lesson_judge_mark(lab);
    char first[ANSWER_MAX + 40];
    if (mark->tries++ > 0) {
        snprintf(first, sizeof first, "Your first answer counts: %s.", mark->value);
        if (lab->play.shown.counts)
            lesson_judge_say(lab, mark->right, first);
        return;
    }
    mark->judged = true;
    mark->right = choice == page->right;
    snprintf(mark->value, sizeof mark->value, "%s", page->choices[choice]);
    snprintf(mark->right_answer, sizeof mark->right_answer, "%s", page->choices[page->right]);
}
