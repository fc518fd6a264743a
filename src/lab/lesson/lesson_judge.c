/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Calculates what is right and holds runs against goals (lesson_play.h). */

#include "export/export.h"
#include "answers/summary.h"
#include "scenario/parameters.h"
#include "lab/laboratory.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static const LessonPage *page_of(const Laboratory *lab)
{
    return &lab->play.shown.lesson->pages[lab->play.shown.page];
}

bool lesson_judge_counts(const Laboratory *lab)
{
    const char *opened = lab->options.lesson;
    return opened && strncmp(opened, lab->play.name, sizeof lab->play.name - 1) == 0;
}

/* The mark of the page that is open. */
ExerciseMark *lesson_judge_mark(Laboratory *lab)
{
    return lesson_judge_counts(lab) ? &lab->homework.marks[lab->play.shown.page] : &lab->homework.elsewhere;
}

void lesson_judge_say(Laboratory *lab, bool right, const char *format, ...)
{
    LessonShown *shown = &lab->play.shown;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(shown->verdict, sizeof shown->verdict, format, arguments);
    va_end(arguments);
    shown->verdict_right = right;
}

/* --- the right number ------------------------------------------------------------------------------- */

static bool wait_for_run(double share, void *context)
{
    Laboratory *lab = context;
    if (!lab->given_up && lab->host.now(lab->host.context) < lab->work_since + QUIET_SECONDS)
        return true;
    return laboratory_work(lab, "checking your answer: %d %%   ^C cancels", (int)(100 * share));
}

/* The numbers of a run before it begins, for words behind "was". */
static bool summary_before(const Exercise *exercise, const Settings *entered, RunSummary *before,
                           Status *status)
{
    *before = (RunSummary){0};
    return !exercise->expression.has_was || run_numbers_beforehand(entered, before, status);
}

bool lesson_judge_run(Laboratory *lab, const Settings *of, RunSummary *summary, Status *status)
{
    Settings settings = *of;
    lab->work_since = lab->host.now(lab->host.context);
    settings.cancel = (Cancel){wait_for_run, lab};
    return export_run(&settings, &(Outputs){0}, lab->options.threads, wait_for_run, lab, summary, status);
}

bool lesson_judge_value(const Laboratory *lab, const Settings *settings, const RunSummary *summary,
                        double *value, Status *status)
{
    const Exercise *exercise = page_of(lab)->exercise;
    RunSummary before;
    *value = NAN;
    if (!summary_before(exercise, settings, &before, status))
        return false;
    *value = expression_value(&exercise->expression, &(ExpressionRun){settings, summary},
                              &(ExpressionRun){settings, &before});
    return true;
}

bool lesson_judge_number(Laboratory *lab, double *right, Status *status)
{
    const ExerciseRun *run = &lab->play.run;
    RunSummary summary;
    *right = NAN;
    if (!run->known)
        return status_refuse(status, "computing this page was cancelled: turn to another one and back");
    return lesson_judge_run(lab, &run->entered, &summary, status) &&
           lesson_judge_value(lab, &run->entered, &summary, right, status);
}

/* --- goals ------------------------------------------------------------------------------------------ */

/* A run that was changed on its way is another one at each time: no goal is met by it. Nor by a run that
 * differs in something else than what the page gives to be changed: what a goal asks is asked of its run. */
static bool fulfils(Laboratory *lab, const Exercise *exercise, char *why, size_t size)
{
    Experiment *experiment = laboratory_run(lab);
    const ExerciseRun *run = &lab->play.run;
    RunSummary summary, before;
    Status status = {STATUS_DONE, ""};
    if (experiment_base(experiment)->n_changes > run->entered.n_changes) {
        snprintf(why, size, "a value was changed on the way; r restarts it");
        return false;
    }
    if (!summary_before(exercise, &run->entered, &before, &status)) {
        snprintf(why, size, "%s", status.text);
        return false;
    }
    summary_of(experiment, &summary);
    if (exercise_failing(exercise, &(ExpressionRun){experiment_settings(experiment), &summary},
                         &(ExpressionRun){&run->entered, &before}, why, size))
        return false;
    const LessonPage *page = page_of(lab);
    char key[KEY_MAX];
    if (page->n_fields == 0 || !settings_differ_beyond(experiment_base(experiment), &run->entered,
                                                       page->fields, page->n_fields, key))
        return true;
    snprintf(why, size, "%s was changed too", key);
    return false;
}

bool lesson_judge_goal(Laboratory *lab)
{
    const LessonPage *page = page_of(lab);
    Experiment *experiment = laboratory_run(lab);
    ExerciseRun *run = &lab->play.run;
    const Settings *base = experiment_base(experiment);
    char why[EXPRESSION_MAX + ANSWER_MAX];
    if (!run->known || !experiment_at_end(experiment) || experiment_failed(experiment, NULL) ||
        lab->player.playback.state == STATE_COMPUTING || settings_same(base, &run->entered) ||
        (run->was_judged && settings_same(base, &run->judged)))
        return false;
    const bool met = fulfils(lab, page->exercise, why, sizeof why);
    ExerciseMark *mark = lesson_judge_mark(lab);
    run->judged = *base;
    run->was_judged = true;
    lesson_judge_say(lab, met, met ? "Done." : "Not yet: %s.", why);
    if (mark->right)
        return met;
    mark->tries++;
    mark->judged = true;
    mark->right = met;
    settings_name(base, &run->entered, mark->value, sizeof mark->value);
    RunSummary before;
    Status ignored = {0};
    const bool known = summary_before(page->exercise, &run->entered, &before, &ignored);
    exercise_tell_goal(page->exercise, known ? &(ExpressionRun){&run->entered, &before} : NULL,
                       mark->right_answer, sizeof mark->right_answer);
    return met;
}
