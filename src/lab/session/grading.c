/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Does sessions again on a host without a screen, whose clock goes on with the steps that are done and not
 * with the machine's, and notes what becomes of the exercises (grading.h). */
#include "lab/session/grading.h"
#include "base/wait.h"

#include "scenario/scenario.h"
#include "lab/laboratory.h"
#include "lab/session/script.h"
#include "lab/session/session_internal.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STEPS_MOST      200000000L
#define STEPS_A_SECOND  10000.0 /* of the host's clock */
#define BEYOND_PATIENCE 1e9     /* seconds: whatever waits for the clock waits no longer */

enum { HISTORY = 64 << 20 };

enum { KEPT_MAX = 8 };

/* What a run came to: several pages may ask about it. */
typedef struct Kept {
    bool known;
    Settings settings;
    RunSummary summary;
} Kept;

typedef struct Grader {
    Laboratory lab;
    Kept kept[KEPT_MAX]; /* of a key; the oldest gives way */
    unsigned n_kept;
    Canvas canvas;
    const GradingTask *task;
    double time; /* virtual */
    long steps;
    double share;
    double begun;
    bool given_up; /* cancelled */
} Grader;

/* --- the host --------------------------------------------------------------------------------------- */

static bool is_spent(const Grader *grader)
{
    return clock_seconds() - grader->begun > grader->task->seconds || grader->steps > STEPS_MOST;
}

static double now(void *context)
{
    const Grader *grader = context;
    return grader->time + (grader->given_up || is_spent(grader) ? BEYOND_PATIENCE : 0);
}

static void worked(void *context, long steps)
{
    Grader *grader = context;
    grader->time += (double)steps / STEPS_A_SECOND;
    grader->steps += steps;
}

static bool go_on(void *context)
{
    Grader *grader = context;
    if (cancel_requested(&grader->task->cancel, grader->share))
        grader->given_up = true;
    return !grader->given_up && !is_spent(grader);
}

static Grader *open_grader(const GradingTask *task, LaboratoryOptions *options, Status *status)
{
    Grader *grader = calloc(1, sizeof *grader);
    if (!grader) {
        status_fail(status, "not enough memory for a laboratory");
        return NULL;
    }
    const Host host = {now, worked, go_on, NULL, NULL, grader, NULL, NULL};
    grader->task = task;
    grader->begun = clock_seconds();
    options->lesson = task->lesson;
    options->threads = task->threads;
    options->history = HISTORY;
    options->replay = options->scenario; /* no one's keyboard: it may write nothing */
    if (laboratory_open(&grader->lab, options, &host, status))
        return grader;
    free(grader);
    return NULL;
}

static void close_grader(Grader *grader)
{
    laboratory_close(&grader->lab);
    canvas_close(&grader->canvas);
    free(grader);
}

/* A frame of whatever goes on. */
static bool frame(Grader *grader)
{
    laboratory_frame(&grader->lab, grader->time + FRAME_SECONDS);
    grader->time += FRAME_SECONDS;
    return go_on(grader);
}

static bool draw(Grader *grader, int width, int height, Status *status)
{
    return laboratory_draw(&grader->lab, &grader->canvas, width, height) ||
           status_fail(status, "not enough memory for a screen");
}

/* --- marks ------------------------------------------------------------------------------------------ */

static void begin_grades(const Lesson *lesson, Grades *grades)
{
    grades->count = 0;
    for (int page = 0; page < lesson->n_pages; page++)
        if (lesson_exercise(&lesson->pages[page]) != EXERCISE_NONE)
            grades->grades[grades->count++] = (Grade){.page = page};
}

/* Presses the keys; true: all of them, in time. */
static bool press_all(Grader *grader, const Session *session, Grades *grades, Status *status)
{
    Replay replay = {.session = session};
    size_t count = 0;
    double seconds = 0;
    int width = 80, height = 24;
    bool goes_on = true;
    while (session_event(session, count))
        count++;
    for (const SessionEvent *event; goes_on && (event = replay_next(&replay));) {
        grader->share = (double)replay.next / (double)count;
        if (event->width > 0 && event->height > 0 && event->width <= SCRIPT_CELLS_MAX &&
            event->height <= SCRIPT_CELLS_MAX) {
            width = event->width;
            height = event->height;
        }
        if (!draw(grader, width, height, status))
            return false;
        goes_on = go_on(grader);
        if (goes_on && replay_go_on(&replay, &grader->lab, grader->time + FRAME_SECONDS)) {
            seconds += event->seconds;
        } else {
            grader->time += FRAME_SECONDS;
        }
        for (int i = 0; i < grades->count; i++) {
            Grade *grade = &grades->grades[i];
            const ExerciseMark *mark = &grader->lab.homework.marks[grade->page];
            if (mark->tries != grade->mark.tries)
                grade->seconds = seconds;
            grade->mark = *mark;
        }
    }
    return goes_on;
}

static void remark(Grades *grades, const char *text)
{
    snprintf(grades->remark, sizeof grades->remark, "%s", text);
    grades->count = 0;
}

/* Why a session is not homework of this lesson, or not all of it. */
static const char *why_refused(const Session *session, const Lesson *lesson)
{
    if (strcmp(session->program, PACKAGE_VERSION) != 0)
        return "foreign: it is of another version of matvib (this is " PACKAGE_VERSION ")";
    if (!*session->lesson || session->version == 0)
        return "foreign: not the session of a lesson";
    if (session->version != lesson->version)
        return "foreign: the session of another lesson, or of another version of this one";
    if (!*session->student)
        return "foreign: no student name (matvib lesson NAME --name)";
    if (!session->ended)
        return "cut off: the end is missing";
    if (!session->sound)
        return "edited: checksum mismatch";
    return NULL;
}

bool grading_session(const GradingTask *task, const char *file, Grades *grades, Status *status)
{
    Lesson lesson;
    Status why = {STATUS_DONE, ""};
    *grades = (Grades){.student = ""};
    if (!lesson_load(task->lesson, command_line_for_lessons, &lesson, status))
        return false;
    Session *session = session_read_facts(file, &why);
    bool sound = true;
    if (session) {
        memcpy(grades->student, session->student, sizeof grades->student);
        memcpy(grades->id, session->id, sizeof grades->id);
        const char *refused = why_refused(session, &lesson);
        LaboratoryOptions options = {0};
        Status trouble = {STATUS_DONE, ""};
        session_options(session, &options);
        Grader *grader = refused ? NULL : open_grader(task, &options, &trouble);
        if (!grader) {
            remark(grades, refused ? refused : trouble.text);
        } else {
            begin_grades(&grader->lab.play.lesson, grades);
            const bool done = press_all(grader, session, grades, &trouble);
            const bool given_up = grader->given_up;
            close_grader(grader);
            if (given_up || *trouble.text)
                sound = status_fail(status, "%s", *trouble.text ? trouble.text : "interrupted");
            else if (!done)
                remark(grades, "it takes too long to replay");
        }
    } else {
        snprintf(grades->remark, sizeof grades->remark, "damaged: %.*s", (int)sizeof grades->remark - 10,
                 why.text);
    }
    session_free(session);
    lesson_free(&lesson);
    return sound;
}

void grading_origin(const Lesson *lesson, const char *file, GradingOrigin *origin)
{
    enum { KEYS_LEAST = 12 }; /* fewer may be the same by chance */
    Session *session = session_read_facts(file, NULL);
    *origin = (GradingOrigin){.known = false};
    if (session)
        *origin = (GradingOrigin){.known = session->count > KEYS_LEAST && !why_refused(session, lesson),
                                  .check = session->check,
                                  .keys = session->keys};
    session_free(session);
}

/* --- the key ---------------------------------------------------------------------------------------- */

/* The way that the lesson knows, to the end of its run. */
static bool solve(Grader *grader, const LessonPage *page, Grade *grade, Status *status)
{
    Laboratory *lab = &grader->lab;
    bool goes_on = true;
    for (int i = 0; i < page->solution.n_actions; i++)
        if (!lab->run_line(lab, page->solution.actions[i], status))
            return status_prefix(status, "%s", page->solution.actions[i]);
    player_go_to(lab, experiment_last_step(laboratory_run(lab)));
    for (bool any = true; goes_on && (any || lab->player.playback.state == STATE_COMPUTING); any = false)
        goes_on = frame(grader);
    grade->mark = lab->homework.marks[grade->page];
    if (!goes_on)
        return status_fail(status, "page %d takes too long", grade->page + 1);
    return grade->mark.right || status_fail(status, "page %d: its own way misses the goal: %s",
                                            grade->page + 1, lab->play.shown.verdict);
}

/* What a run comes to. NULL: it failed, or takes too long. */
static const RunSummary *run_of(Grader *grader, const Settings *settings, Status *status)
{
    for (int i = 0; i < KEPT_MAX; i++)
        if (grader->kept[i].known && settings_same(&grader->kept[i].settings, settings))
            return &grader->kept[i].summary;
    Kept *kept = &grader->kept[grader->n_kept++ % KEPT_MAX];
    kept->settings = *settings;
    kept->known = lesson_judge_run(&grader->lab, settings, &kept->summary, status);
    return kept->known ? &kept->summary : NULL;
}

static bool number_of(Grader *grader, const Settings *settings, double *number, Status *status)
{
    const RunSummary *summary = run_of(grader, settings, status);
    return summary && lesson_judge_value(&grader->lab, settings, summary, number, status);
}

static bool may_not_take(const Grade *grade, double other, const char *what, Status *status)
{
    char number[NUMBER_TEXT_MAX];
    exercise_write_number(other, number);
    return status_fail(status, "page %d: its tolerance takes %s too, %s (right is %s)", grade->page + 1,
                       number, what, grade->mark.right_answer);
}

/* Who has the next value of a variant, above or below, is asked for another number. */
static bool differs_from_neighbours(Grader *grader, const Grade *grade, double right, Status *status)
{
    const Lesson *lesson = &grader->lab.play.lesson;
    const Exercise *exercise = lesson->pages[grade->page].exercise;
    for (int i = 0; i < lesson->n_variants; i++) {
        const LessonVariant *variant = &lesson->variants[i];
        for (int direction = -1; direction <= 1 && variant->page == grade->page; direction += 2) {
            Settings settings = grader->lab.play.run.entered;
            char value[NUMBER_TEXT_MAX], what[KEY_MAX + NUMBER_TEXT_MAX + 40];
            double other;
            if (!variant_beside(&variant->variant, variant->value, direction, value))
                continue;
            if (!settings_set(&settings, variant->variant.key, value, status) ||
                !number_of(grader, &settings, &other, status))
                return status_prefix(status, "page %d with %s = %s", grade->page + 1, variant->variant.key,
                                     value);
            snprintf(what, sizeof what, "the answer for %s = %s", variant->variant.key, value);
            if (exercise_accepts(exercise, right, other))
                return may_not_take(grade, other, what, status);
        }
    }
    return true;
}

static bool answer_page(Grader *grader, Grade *grade, Status *status)
{
    /* to the page, until its state is reached */
    Laboratory *lab = &grader->lab;
    bool goes_on = draw(grader, 80, 24, status);
    lesson_entry_show(lab, grade->page);
    player_pause(lab);
    while (goes_on && (lab->player.playback.state == STATE_COMPUTING || lab->play.arriving))
        goes_on = frame(grader);
    if (!goes_on)
        return !*status->text && status_fail(status, "page %d takes too long", grade->page + 1);
    if (*lab->play.refused)
        return status_refuse(status, "page %d: %s", grade->page + 1, lab->play.refused);
    const LessonPage *page = lesson_entry_page(lab);
    const Settings *settings = &lab->play.run.entered;
    double right;
    switch (lesson_exercise(page)) {
    case EXERCISE_CHOICE:
        snprintf(grade->mark.right_answer, sizeof grade->mark.right_answer, "%s", page->choices[page->right]);
        return true;
    case EXERCISE_NUMBER: {
        const Exercise *exercise = page->exercise;
        if (!number_of(grader, settings, &right, status))
            return false;
        if (!isfinite(right))
            return status_fail(status, "page %d: what is right is not known of its run", grade->page + 1);
        exercise_write_number(right, grade->mark.right_answer);
        const RunSummary *end = run_of(grader, settings, status);
        const double start = end ? exercise_at_start(exercise, &(ExpressionRun){settings, end}) : NAN;
        if (exercise_accepts(exercise, right, 0))
            return may_not_take(grade, 0, "which anybody may guess", status);
        if (isfinite(start) && exercise_accepts(exercise, right, start))
            return may_not_take(grade, start, "which it is at the start", status);
        return differs_from_neighbours(grader, grade, right, status);
    }
    case EXERCISE_GOAL:
        /* The run that the page shows is not what it asks for. */
        if (!number_of(grader, settings, &right, status))
            return false;
        if (right > 0)
            return status_fail(status, "page %d: its run fulfils the goal as it is", grade->page + 1);
        return solve(grader, page, grade, status);
    default:
        return true;
    }
}

bool grading_key(const GradingTask *task, const char *student, Grades *grades, Status *status)
{
    Settings settings;
    if (!scenario_load(scenario_unnamed, &settings, status))
        return false;
    LaboratoryOptions options = {
        .settings = &settings, .scenario = scenario_unnamed, .student = student, .paused = true};
    *grades = (Grades){.student = ""};
    Grader *grader = open_grader(task, &options, status);
    if (!grader)
        return false;
    begin_grades(&grader->lab.play.lesson, grades);
    bool sound = true;
    for (int i = 0; i < grades->count && sound; i++) {
        grader->begun = clock_seconds();
        sound = answer_page(grader, &grades->grades[i], status);
    }
    close_grader(grader);
    return sound;
}
