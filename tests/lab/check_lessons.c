/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lessons: their files are read, and every page of the program's own does what it says and fits the screen.
 */
#include "suite.h"
#include "lab/lesson_numbers.h"
#include "scenario/settings.h"
#include "lab/tui_case.h"
#include "lab/prompt/prompt.h"
#include "views/view.h"
#include "panes/screen.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- the format ------------------------------------------------------------------------------------- */

static bool read_text(const char *text, Lesson *lesson, Status *status)
{
    FILE *stream = fmemopen((void *)text, strlen(text), "r");
    ck_assert_ptr_nonnull(stream);
    *status = (Status){STATUS_DONE, ""};
    bool sound = lesson_read(stream, "my.lesson", command_line_for_lessons, lesson, status);
    fclose(stream);
    return sound;
}

START_TEST(a_lesson_is_read)
{
    Lesson lesson;
    Status status;
    ck_assert_msg(
        read_text(
            "# mine\n@title A title\n@about More of it\n@group Bar\n@objective use it\n@prerequisites late\n"
            "@minutes 15\n\n@page One\n@do open mode5\n"
            "@field mesh.cell_size\nFirst\nline.\n\nSecond.\r\n@until value mesh.cell_size 0.5\n"
            "@page Two\n@ask Why?\n@choice so\n@right  thus \n@reveal\n@do pin\nBecause.\n",
            &lesson, &status),
        "%s", status.text);
    ck_assert_str_eq(lesson.title, "A title");
    ck_assert_str_eq(lesson.about, "More of it");
    ck_assert_str_eq(lesson.group, "Bar");
    ck_assert_str_eq(lesson.objective, "use it");
    ck_assert_str_eq(lesson.prerequisites, "late");
    ck_assert_str_eq(lesson.minutes, "15");
    ck_assert_int_eq(lesson.n_pages, 2);
    const LessonPage *one = &lesson.pages[0], *two = &lesson.pages[1];
    ck_assert_str_eq(one->title, "One");
    ck_assert_str_eq(one->first.text, "First line.\nSecond.");
    ck_assert_int_eq(one->first.n_actions, 1);
    ck_assert_str_eq(one->first.actions[0], "open mode5");
    ck_assert_int_eq(one->n_fields, 1);
    ck_assert_int_eq(one->until.kind, UNTIL_VALUE);
    ck_assert_str_eq(one->until.word, "mesh.cell_size");
    ck_assert_str_eq(one->until.value, "0.5");
    ck_assert_ptr_null(one->question);
    ck_assert_str_eq(two->question, "Why?");
    ck_assert_int_eq(two->n_choices, 2);
    ck_assert_int_eq(two->right, 1);
    ck_assert_str_eq(two->choices[1], "thus");
    ck_assert_str_eq(two->revealed.text, "Because.");
    ck_assert_str_eq(two->revealed.actions[0], "pin");
    ck_assert_ptr_null(two->first.text);
    lesson_free(&lesson);
}
END_TEST

/* Each word comes to somebody, and with it the choice that is right for it; a mistake is not told. */
START_TEST(a_choice_is_right_for_whom_it_is_drawn)
{
    static const char text[] =
        "@title x\n@page y\n@do open mode5\n@variant mpm.mistake from keep_grid, no_volume, force_sign\nIt "
        "is "
        "{mpm.mistake}.\n"
        "@ask a\n@right b, if you like if mpm.mistake is no_volume, keep_grid\n@choice no\n"
        "@right c if mpm.mistake is force_sign\n@page z\n@variant mpm.mistake from density_kept, "
        "volume_kept\n";
    static const char *const names[] = {"Ada", "Bob", "Cyd", "Dan", "Eve", "Fay", "Gus", "Hal", "Ida", "Jim"};
    int right[3] = {0, 0, 0};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        Lesson lesson;
        Status status;
        ck_assert_msg(read_text(text, &lesson, &status) && lesson_draw(&lesson, names[i], &status), "%s",
                      status.text);
        const LessonPage *page = &lesson.pages[0];
        const char *set = page->first.actions[1];
        ck_assert_str_eq(page->first.text, "It is ?.");
        ck_assert_str_eq(page->choices[0], "b, if you like");
        ck_assert_int_eq(page->right, strcmp(set, "set mpm.mistake ?force_sign") == 0 ? 2 : 0);
        ck_assert(strncmp(set, "set mpm.mistake ?", 17) == 0 && !strstr(set, "density_kept"));
        right[strstr(set, "force_sign") ? 2 : strstr(set, "keep_grid") ? 1 : 0]++;
        lesson_free(&lesson);
    }
    ck_assert(right[0] > 0 && right[1] > 0 && right[2] > 0);
}
END_TEST

static const struct {
    const char *text, *says;
} wrong[] = {
    {"", "my.lesson: is not a lesson (@title and a @page are expected)"},
    {"@title x\n", "my.lesson: is not a lesson (@title and a @page are expected)"},
    {"text\n", "my.lesson:1: text belongs to a page (@page TITLE)"},
    {"@title\n", "my.lesson:1: @title: something is missing after it"},
    {"@do x\n", "my.lesson:1: @do belongs to a page (@page TITLE)"},
    {"@title x\n@page y\n@title z\n", "my.lesson:3: @title belongs before the first page"},
    {"@minutes 15 min\n", "my.lesson:1: @minutes 15 min: not a whole number from 1 to 600"},
    {"@minutes 0.5\n", "my.lesson:1: @minutes 0.5: not a whole number from 1 to 600"},
    {"@titel x\n", "my.lesson:1: @titel is not known (@title | @about | @group | @objective | @prerequisites "
                   "| @minutes | @page | @do | @field | @ask | @choice | "
                   "@right | @reveal | @until | @variant | @answer | @words | @goal | @solve | @points)"},
    {"@title x\n@page y\n@field mesh.size\n",
     "my.lesson:3: mesh.size is not a parameter (see: matvib params)"},
    {"@title x\n@page y\n@until then\n", "my.lesson:3: until what? (step N | time T | stage N | end | "
                                         "crossing | break | touch | event | rest | command NAME "
                                         "| value KEY VALUE)"},
    {"@title x\n@page y\n@until step -1\n", "my.lesson:3: until what? (step N | time T | stage N | end | "
                                            "crossing | break | touch | event | rest | command "
                                            "NAME | value KEY VALUE)"},
    {"@title x\n@page y\n@ask a\nb?\n",
     "my.lesson:4: a question is one line (text comes before @ask, or after @reveal)"},
    {"@title x\n@page y\n@choice a\n", "my.lesson:3: a choice comes after its question (@ask)"},
    {"@title x\n@page y\n@ask a\n@right b\n@right c\n", "my.lesson:5: one choice only is right"},
    {"@title x\n@page y\n@ask a\n@right b\n@page z\n",
     "my.lesson:5: the question of page \"y\" needs two choices at least, one of them @right, or @answer or "
     "@words"},
    {"@title x\n@page y\n@ask a\n@choice b\n@choice c\n",
     "my.lesson: the question of page \"y\" needs two choices at least, one of them @right, or @answer or "
     "@words"},
    {"@title x\n@page y\n@reveal\n",
     "my.lesson: page \"y\" reveals, but neither asks (@ask) nor waits for anything (@until)"},
    {"@title x\n@page y\n@until end\n@reveal\n@do pin\n",
     "my.lesson: page \"y\" does something after its goal: only an answer is followed by @do"},
    {"@title x\n@page y\n@reveal now\n", "my.lesson:3: @reveal: takes nothing"},
    {"@title x\n@page y\n\xff\n", "my.lesson:3: is not text in UTF-8"},
    {"@title x\n@page \xc2\x9b 2J\n", "my.lesson:2: is not text in UTF-8"},
    {"@title x\n@page y\n@do write .bash_aliases\n",
     "my.lesson:3: @do: write: a lesson may not (it changes the laboratory only)"},
    {"@title x\n@page y\n@do write\n",
     "my.lesson:3: @do: write: a lesson may not (it changes the laboratory only)"},
    {"@title x\n@page y\n@do export a\n",
     "my.lesson:3: @do: export: a lesson may not (it changes the laboratory only)"},
    {"@title x\n@page y\n@do figure a.svg\n",
     "my.lesson:3: @do: figure: a lesson may not (it changes the laboratory only)"},
    {"@title x\n@page y\n@do lesson other\n",
     "my.lesson:3: @do: lesson: a lesson may not (it changes the laboratory only)"},
    {"@title x\n@page y\n@ask a\n@right b\n@choice c\n@reveal\n@do quit\n",
     "my.lesson:7: @do: quit: a lesson may not (it changes the laboratory only)"},
    {"@title x\n@page y\n@do suspend\n",
     "my.lesson:3: @do: suspend: a lesson may not (it changes the laboratory only)"},
    /* exercises */
    {"@title x\n@page y\n@answer 1 within 1\n", "my.lesson:3: an answer comes after its question (@ask)"},
    {"@title x\n@page y\n@words\n", "my.lesson:3: an answer comes after its question (@ask)"},
    {"@title x\n@page y\n@ask a\n@words\n@answer 1 within 1\n", "my.lesson:5: a page has one exercise only"},
    {"@title x\n@page y\n@ask a\n@answer error\n",
     "my.lesson:4: @answer: how near is right? (EXPRESSION within NUMBER, or NUMBER %)"},
    {"@title x\n@page y\n@ask a\n@answer error within 0\n",
     "my.lesson:4: @answer: within 0: is not a tolerance (NUMBER > 0, or NUMBER %)"},
    {"@title x\n@page y\n@ask a\n@answer error within 2 %%\n",
     "my.lesson:4: @answer: within 2 %%: is not a tolerance (NUMBER > 0, or NUMBER %)"},
    {"@title x\n@page y\n@ask a\n@answer eror within 2 %\n",
     "my.lesson:4: @answer: eror is neither a number of a run nor a parameter (see: man 5 matvib)"},
    {"@title x\n@page y\n@do open mode5\n@ask a\n@answer error within 2 %\n@choice b\n",
     "my.lesson: the question of page \"y\" has choices and @answer (one of them)"},
    {"@title x\n@page y\n@do open mode5\n@ask a\n@goal error < 1\n@solve pin\n",
     "my.lesson: page \"y\" asks (@ask) and has a @goal (one of them)"},
    {"@title x\n@page y\n@ask a\n@answer error within 1 %\n@reveal\n@do open mode5\n@page z\n",
     "my.lesson:7: page \"y\" asks about a run that no page up to it opens (@do open SCENARIO)"},
    {"@title x\n@page y\n@do open mode5\n@goal error < 1\n",
     "my.lesson: the goal of page \"y\" needs a way to it (@solve LINE)"},
    {"@title x\n@page y\n@solve pin\n", "my.lesson: page \"y\" has @solve without @goal"},
    {"@title x\n@page y\n@until end\n@goal error < 1\n",
     "my.lesson:4: a page has one goal (@until or @goal)"},
    {"@title x\n@page y\n@goal error < 1\n@until end\n",
     "my.lesson:4: a page has one goal (@until or @goal)"},
    {"@title x\n@page y\n@goal error\n",
     "my.lesson:3: @goal: a relation (< <= > >= = !=) is expected, not: the end of the line"},
    {"@title x\n@page y\n@goal error < 1\n@solve write a\n",
     "my.lesson:4: @solve: write: a lesson may not (it changes the laboratory only)"},
    {"@title x\n@page y\n@variant initial.mode\n",
     "my.lesson:3: @variant: \"initial.mode\" is not a variant (KEY from A to B, KEY from WORD, WORD ...)"},
    {"@title x\n@page y\n@variant mode from 1 to 2\n",
     "my.lesson:3: @variant: mode is not a parameter (see: matvib params)"},
    {"@title x\n@page y\n@variant mpm.shape from 1 to 2\n",
     "my.lesson:3: @variant: mpm.shape: 1 is none of its words (see: matvib params)"},
    {"@title x\n@page y\n@variant mpm.shape from hat\n",
     "my.lesson:3: @variant: mpm.shape: two words at least are expected to draw from"},
    {"@title x\n@page y\n@variant mpm.shape from hat, gimp, hat\n",
     "my.lesson:3: @variant: mpm.shape: hat listed twice"},
    {"@title x\n@page y\n@variant mpm.mistake from none, no_volume\n",
     "my.lesson:3: @variant: mpm.mistake: none is none of its words (see: matvib params)"},
    {"@title x\n@page y\n@ask a\n@right b if mpm.shape is hat\n",
     "my.lesson:4: if mpm.shape: there is no @variant of it above"},
    {"@title x\n@page y\n@variant mpm.shape from hat, gimp\n@ask a\n@right b if mpm.shape is hat\n@choice "
     "c\n",
     "my.lesson: page \"y\" has 0 right choices for mpm.shape = gimp (one is expected)"},
    {"@title x\n@page y\n@variant mpm.shape from hat, gimp\n@ask a\n@right b if mpm.shape is hat, gimp\n"
     "@right c if mpm.shape is gimp\n",
     "my.lesson: page \"y\" has 2 right choices for mpm.shape = gimp (one is expected)"},
    {"@title x\n@page y\n@variant mpm.shape from hat, gimp\n@ask a\n@right b\n@right c if mpm.shape is hat\n",
     "my.lesson:6: one choice only is right"},
    {"@title x\n@page y\n@variant initial.mode from 2 to 3\n@ask a\n@right b if initial.mode is 2\n@choice "
     "c\n",
     "my.lesson: page \"y\": initial.mode has no words to be asked for"},
    {"@title x\n@page y\n@variant initial.mode from 2 to 2\n",
     "my.lesson:3: @variant: initial.mode: nothing lies between 2 and 2 (the smaller one first)"},
    {"@title x\n@page y\n@variant bar.density from -1 to 2\n",
     "my.lesson:3: @variant: bar.density: from -1 to 2 is more than is allowed (see: matvib params)"},
    {"@title x\n@page y\n@ask a\n@words\n@reveal\n@variant initial.mode from 2 to 3\n",
     "my.lesson:6: @variant belongs before @reveal"},
    {"@title x\n@page y\n{initial.mode}\n", "my.lesson:3: {initial.mode}: there is no @variant of it above"},
    {"@title x\n@page y\n@do !rm\n",
     "my.lesson:3: @do: !rm: unknown (a command, KEY=VALUE or a time is expected)"},
};

START_TEST(what_is_wrong_is_told_with_its_line)
{
    Lesson lesson;
    Status status;
    ck_assert(!read_text(*wrong[_i].text ? wrong[_i].text : "\n", &lesson, &status));
    ck_assert_str_eq(status.text, wrong[_i].says);
    ck_assert_int_eq(status.code, STATUS_USAGE);
    ck_assert_int_eq(lesson.n_pages, 0);
}
END_TEST

/* --- the program's own ------------------------------------------------------------------------------ */

static const char *text_of(const Bench *bench)
{
    return bench->lab.screen.message->text;
}

static const LessonPage *page_of(const Bench *bench)
{
    const LessonShown *shown = bench->lab.screen.lesson;
    return &shown->lesson->pages[shown->page];
}

/* Steps that a page of a beam or a plate may take to where it shows its run, where not everything is
 * requested: one that shows a later time is left on its way there. */
enum { NEAR_STEPS = 50 };

static bool only_near; /* of the test case that runs */
static int frames;     /* that the page has had */

static bool is_arriving(const Bench *bench)
{
    return bench->lab.screen.playback->state == STATE_COMPUTING || bench->lab.play.arriving;
}

static void finish_work(Bench *bench)
{
    for (; is_arriving(bench) && (!only_near || frames < 1); frames++)
        frame(bench);
}

/* The study of convergence on the screen, which takes seconds: where not everything is requested it is left.
 */
static void finish_study(Bench *bench)
{
    while (suite_wide() && refining_is_due(&bench->lab))
        refining_work(&bench->lab);
}

/* Whether more of the run is needed than may be computed. */
static bool is_far(const Bench *bench, double time)
{
    const Experiment *experiment = bench->lab.screen.experiment;
    return only_near &&
           time > experiment_time(experiment) + NEAR_STEPS * experiment_simulation(experiment)->dt;
}

static double end_of(const Bench *bench)
{
    const Experiment *experiment = bench->lab.screen.experiment;
    return (double)experiment_last_step(experiment) * experiment_simulation(experiment)->dt;
}

/* Does what the page waits for, as a reader would: where time has to pass Space runs and stops there by
 * itself, and step by step Space is not more than the next stage. */
static void satisfy(Bench *bench, const LessonUntil *until)
{
    char line[160];
    Status status = {STATUS_DONE, ""};
    Laboratory *lab = &bench->lab;
    const bool steps = until->kind == UNTIL_STAGE || until->kind == UNTIL_STEP;
    switch (until->kind) {
    case UNTIL_STEP:
    case UNTIL_STAGE:
    case UNTIL_TIME:
    case UNTIL_END:
    case UNTIL_EVENT:
        for (int i = 0; i < 1000 && !lab->screen.lesson->met; i++) {
            if (lab->screen.playback->state != STATE_RUNNING)
                press(bench, "Space");
            ck_assert_msg(!steps || lab->screen.playback->state != STATE_RUNNING, "Space runs away");
            frame(bench);
        }
        ck_assert_msg(lab->screen.playback->state != STATE_RUNNING, "page %d does not stop by itself",
                      lab->screen.lesson->page + 1);
        break;
    case UNTIL_COMMAND:
        ck_assert_msg(command_by_name(until->word) != NULL, "no command %s", until->word);
        laboratory_command(lab, command_by_name(until->word)->id);
        if (lab->screen.prompt->open)
            press(bench, "Esc");
        break;
    case UNTIL_VALUE:
        snprintf(line, sizeof line, "set %s %s", until->word, until->value);
        ck_assert_msg(line_run(lab, line, &status), "%s", status.text);
        break;
    case UNTIL_GOAL:
        for (int i = 0; i < page_of(bench)->solution.n_actions; i++)
            ck_assert_msg(line_run(lab, page_of(bench)->solution.actions[i], &status), "%s", status.text);
        finish_work(bench);
        player_seek(lab, experiment_last_step(lab->screen.experiment), 0);
        break;
    case UNTIL_NOTHING:
        break;
    }
    finish_work(bench);
    lesson_play_continue(lab);
}

/* What a page has its reader set is so from the start of the run that is shown, not from where it stands. */
static void check_whole_run(const Bench *bench, const char *name)
{
    const Settings *settings = experiment_settings(bench->lab.screen.experiment);
    for (int i = 0; i < settings->n_changes; i++)
        ck_assert_msg(settings->changes[i].step == 0, "%s, page %d: %s holds from step %ld on only", name,
                      bench->lab.screen.lesson->page + 1, page_of(bench)->until.word,
                      settings->changes[i].step);
}

/* The box, or a drawing that has its terms. */
static bool shows_step(const Screen *screen, int width, int height)
{
    return screen_pane(screen, width, height, PANE_BOX).width > 0 ||
           (screen->views.upper->is_wide && screen_pane(screen, width, height, PANE_UPPER).width > 0);
}

/* On no usual screen anything has to be scrolled or, within a step, read without its terms, and nothing that
 * a page did was refused. */
static void check_page(Bench *bench, const char *name)
{
    const LessonShown *shown = bench->lab.screen.lesson;
    finish_work(bench);
    lesson_play_continue(&bench->lab);
    ck_assert_msg(bench->lab.screen.message->kind != MESSAGE_ERROR, "%s, page %d: %s", name, shown->page + 1,
                  text_of(bench));
    ck_assert(is_arriving(bench) || bench->lab.play.next == bench->lab.play.n_queue);
    static const int sizes[][2] = {{60, 18}, {80, 24}, {132, 43}};
    const bool in_step = experiment_stage(bench->lab.screen.experiment) > 0;
    if (bench->lab.screen.panes.focus != PANE_PARAMETERS)
        return; /* the inspector was asked for, and lies over the text */
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const int width = sizes[i][0], height = sizes[i][1];
        const int most = screen_lesson_most(&bench->lab.screen, width, height);
        ck_assert_msg(most == 0, "%s, page %d (%s) is %d rows too long at %dx%d", name, shown->page + 1,
                      page_of(bench)->title, most, width, height);
        ck_assert_msg(!in_step || shows_step(&bench->lab.screen, width, height),
                      "%s, page %d (%s) shows nothing of the step at %dx%d", name, shown->page + 1,
                      page_of(bench)->title, width, height);
    }
}

static void type(Bench *bench, const char *text)
{
    for (char key[2] = ""; (key[0] = *text); text++)
        press(bench, *text == ' ' ? "Space" : key);
}

/* Answers the question of the page as it is right. */
static void answer(Bench *bench, const LessonPage *page)
{
    char text[NUMBER_TEXT_MAX] = "because";
    Status status = {STATUS_DONE, ""};
    double right;
    if (lesson_exercise(page) == EXERCISE_CHOICE) {
        press(bench, (char[]){(char)('1' + page->right), '\0'});
        return;
    }
    if (lesson_exercise(page) == EXERCISE_NUMBER) {
        ck_assert_msg(lesson_judge_number(&bench->lab, &right, &status), "%s", status.text);
        exercise_write_number(right, text);
    }
    press(bench, "Enter");
    type(bench, text);
    press(bench, "Enter");
}

/* The whole screen, once the page's state is reached. */
static char *entered(Bench *bench)
{
    finish_work(bench);
    lesson_play_continue(&bench->lab);
    finish_study(bench);
    ck_assert(laboratory_draw(&bench->lab, &bench->canvas, bench->width, bench->height));
    char *dump = canvas_dump(&bench->canvas);
    ck_assert_ptr_nonnull(dump);
    return dump;
}

static Bench *open_lesson_on(const char *name, Sheet sheet)
{
    Status status = {STATUS_DONE, ""};
    Bench *bench = open_bench("mode1", true);
    bench->width = 132;
    bench->height = 43;
    bench->lab.options.sheet = parameter_sheet_words[sheet];
    ck_assert_msg(lesson_play_open(&bench->lab, name, &status), "%s", status.text);
    return bench;
}

static Bench *open_lesson(const char *name)
{
    return open_lesson_on(name, SHEET_PLAIN);
}

/* Names the first line that differs. */
static void check_same(Bench *bench, const char *page, const char *how)
{
    char *dump = entered(bench);
    if (is_arriving(bench)) {
        free(dump);
        return; /* it is far */
    }
    size_t line = 0, i = 0;
    for (; dump[i] && dump[i] == page[i]; i++)
        if (dump[i] == '\n')
            line = i + 1;
    ck_assert_msg(dump[i] == page[i], "%s, page %d, %s, is another one:\n%.*s\nand was:\n%.*s",
                  bench->lab.play.name, bench->lab.screen.lesson->page + 1, how,
                  (int)strcspn(dump + line, "\n"), dump + line, (int)strcspn(page + line, "\n"), page + line);
    free(dump);
}

static void check_on_screen(Bench *bench, const char *dump, const char *text)
{
    ck_assert_msg(strstr(dump, text), "%s, page %d: \"%s\" is not seen:\n%s", bench->lab.play.name,
                  bench->lab.screen.lesson->page + 1, text, dump);
}

/* The whole of a small screen. */
static char *entered_small(Bench *bench)
{
    const int width = bench->width, height = bench->height;
    bench->width = 60;
    bench->height = 18;
    char *dump = entered(bench);
    bench->width = width;
    bench->height = height;
    return dump;
}

/* Beside the text there is something to look at: a picture, or the box. */
static bool shows_more(const Bench *bench, int width, int height)
{
    int rows = 0;
    for (PaneId pane = PANE_UPPER; pane < PANE_COUNT; pane++)
        rows += screen_pane(&bench->lab.screen, width, height, pane).height;
    return rows > 0;
}

/* On a small screen too the page has all its choices, its field and its picture. */
static void check_small_page(Bench *bench)
{
    const LessonPage *now = page_of(bench);
    char *dump = entered_small(bench), text[64];
    ck_assert_msg(shows_more(bench, 60, 18), "%s, page %d is text alone:\n%s", bench->lab.play.name,
                  bench->lab.screen.lesson->page + 1, dump);
    check_on_screen(bench, dump, now->title);
    for (int i = 0; i < now->n_choices; i++) {
        snprintf(text, sizeof text, "  %d %.40s", i + 1, now->choices[i]);
        check_on_screen(bench, dump, text);
    }
    for (int i = 0; i < now->n_fields; i++)
        check_on_screen(bench, dump, parameter_find(now->fields[i])->label);
    free(dump);
}

/* And stays when it is answered, and the keys go to it. */
static void check_small_answer(Bench *bench, int count)
{
    const LessonPage *now = page_of(bench);
    if (now->until.kind == UNTIL_COMMAND)
        return;
    char *dump = entered_small(bench);
    check_on_screen(bench, dump, now->title);
    check_on_screen(bench, dump, bench->lab.screen.lesson->page + 1 < count ? "goes on" : "n next lesson");
    ck_assert_msg(shows_more(bench, 60, 18), "%s, page %d is text alone:\n%s", bench->lab.play.name,
                  bench->lab.screen.lesson->page + 1, dump);
    free(dump);
}

/* --- what the pages look like ------------------------------------------------------------------------ */

/* Sizes at which the screens of every page are kept: tests/golden/lessons/NAME-SIZE.txt. After a change that
 * is meant, write them again and look at the difference:
 *
 *     make -C build tests/lab/check_lessons &&
 *     MATVIB_WIDE=1 MATVIB_REGENERATE=1 MATVIB_SRCDIR=. build/tests/lab/check_lessons own && git diff
 *
 * MATVIB_LESSON=NAME takes one lesson alone, MATVIB_TELL=1 lists its numbers that want a reason. */
enum { N_KEPT = 2 };

static const struct {
    const char *name;
    int width, height;
} kept_sizes[N_KEPT] = {{"80x24", 80, 24}, {"132x43", 132, 43}};

/* The screens of a lesson, one below the other. */
typedef struct KeptScreens {
    FILE *stream;
    char *text;
    size_t size;
} KeptScreens;

static void keep_open(KeptScreens kept[N_KEPT])
{
    for (int i = 0; i < N_KEPT; i++) {
        kept[i].stream = open_memstream(&kept[i].text, &kept[i].size);
        ck_assert_ptr_nonnull(kept[i].stream);
    }
}

/* The state of a page, at the first sizes. */
static void keep_screens(Bench *bench, KeptScreens kept[N_KEPT], int sizes, const char *state)
{
    for (int i = 0; i < sizes; i++) {
        ck_assert(laboratory_draw(&bench->lab, &bench->canvas, kept_sizes[i].width, kept_sizes[i].height));
        char *dump = canvas_dump(&bench->canvas);
        ck_assert_ptr_nonnull(dump);
        fprintf(kept[i].stream, "page %d, %s\n%s", bench->lab.screen.lesson->page + 1, state, dump);
        free(dump);
    }
}

/* Where every page was come to, they look as they did. */
static void keep_close(KeptScreens kept[N_KEPT], const char *lesson, bool whole)
{
    char path[128];
    for (int i = 0; i < N_KEPT; i++) {
        ck_assert_int_eq(fclose(kept[i].stream), 0);
        snprintf(path, sizeof path, "tests/golden/lessons/%s-%s.txt", lesson, kept_sizes[i].name);
        if (whole)
            suite_compare(path, kept[i].text, lesson);
        free(kept[i].text);
    }
}

/* Reads the page to its end, as it is meant; false: it is too far. */
static bool read_page(Bench *bench, const char *name, SeenNumbers *seen)
{
    const LessonShown *shown = bench->lab.screen.lesson;
    const LessonPage *now = page_of(bench);
    const LessonUntil *until = &now->until;
    const bool number = now->question && lesson_exercise(now) == EXERCISE_NUMBER;
    if (is_arriving(bench))
        return false;
    if (now->question) {
        if (number && is_far(bench, end_of(bench)))
            return false;
        answer(bench, now);
        ck_assert_msg(shown->answer == (now->n_choices > 0 ? now->right : 0), "%s, page %d: %s", name,
                      shown->page + 1, shown->verdict);
        check_page(bench, name);
        finish_study(bench);
        lesson_numbers_see(bench, seen);
        if (is_arriving(bench) || refining_is_due(&bench->lab))
            return false;
    }
    if (is_far(bench, until->kind == UNTIL_TIME                               ? until->number
                      : until->kind == UNTIL_END || until->kind == UNTIL_GOAL ? end_of(bench)
                                                                              : 0))
        return false;
    satisfy(bench, until);
    if (until->kind == UNTIL_VALUE)
        check_whole_run(bench, name);
    ck_assert_msg(shown->met, "%s, page %d waits for ever", name, shown->page + 1);
    check_page(bench, name);
    lesson_numbers_see(bench, seen);
    return true;
}

/* Each page does what it says and fits. It is entered in one state: as one reads; backwards; and by somebody
 * who does something else on each page and goes on. */
START_TEST(every_page_is_entered_in_one_state)
{
    const char *name = builtin_lessons[_i].name, *wanted = getenv("MATVIB_LESSON");
    if (wanted && strcmp(wanted, name) != 0)
        return;
    Bench *bench = open_lesson(name);
    const LessonShown *shown = bench->lab.screen.lesson;
    const int count = shown->lesson->n_pages;
    const bool line = experiment_simulation(bench->lab.screen.experiment)->dimensions == 1;
    if (!line && !suite_wide() && _i % 2 == 0) { /* of beams and plates every other one */
        close_bench(bench);
        return;
    }
    char *pages[LESSON_PAGES_MAX];
    KeptScreens kept[N_KEPT];
    keep_open(kept);
    if (!line && !suite_wide()) {
        only_near = true;
        bench->rate = NEAR_STEPS / FRAME_SECONDS;
    }
    for (int page = 0; page < count; page++) {
        ck_assert_int_eq(shown->page, page);
        SeenNumbers seen = {.count = 0};
        frames = 0;
        check_small_page(bench);
        pages[page] = entered(bench);
        check_page(bench, name);
        keep_screens(bench, kept, N_KEPT, "entered");
        lesson_numbers_see(bench, &seen);
        const LessonPage *now = page_of(bench);
        ck_assert_msg(now->until.kind == UNTIL_NOTHING || !shown->met,
                      "%s, page %d waits for what is so already", name, page + 1);
        for (int i = 0; i < now->n_fields; i++)
            ck_assert_msg(parameter_applies_to(experiment_settings(bench->lab.screen.experiment),
                                               parameter_find(now->fields[i])),
                          "%s, page %d: %s is not of this problem", name, page + 1, now->fields[i]);
        const bool whole = read_page(bench, name, &seen);
        ck_assert(whole || only_near);
        if (whole) {
            lesson_numbers_check(bench, name, &seen);
            check_small_answer(bench, count);
            if (now->question || now->until.kind != UNTIL_NOTHING)
                keep_screens(bench, kept, 1, "read");
        }
        if (page + 1 < count)
            press(bench, !whole || (now->n_fields > 0 && now->until.kind == UNTIL_NOTHING) ? "n" : "Enter");
    }
    keep_close(kept, name, !only_near);
    /* backwards, and leaving pages out: where not everything is requested, each lesson one of both, in the
     * short form each on a bar, and of beams the pages that are near */
    const bool turned = line || suite_wide();
    const bool back = suite_long() || (turned && _i % 2 == 0),
               leaving = suite_long() || (turned && _i % 2 != 0);
    only_near = !line && !suite_long();
    const double rate = only_near ? NEAR_STEPS / FRAME_SECONDS : 0;
    bench->rate = rate;
    for (int page = count - 1; back && page >= 0; page--) {
        frames = 0;
        if (page + 1 < count)
            press(bench, "b");
        ck_assert_int_eq(shown->page, page);
        if (page + 1 < count)
            check_same(bench, pages[page], "from the next one");
    }
    close_bench(bench);
    bench = open_lesson(name);
    bench->rate = rate;
    shown = bench->lab.screen.lesson;
    for (int page = 0; leaving && page < count; page++) {
        frames = 0;
        ck_assert_int_eq(shown->page, page);
        check_same(bench, pages[page], "from one that was left out");
        static const char *const else_done[] = {"3 Tab Right z > Space", "e 5 Tab", "> <"};
        press_all(bench, is_arriving(bench) ? "" : else_done[page % 3]);
        for (int i = 0; i < 5; i++)
            frame(bench);
        if (bench->lab.screen.prompt->open)
            press(bench, "Esc"); /* Space at the end of a run may ask */
        if (page + 1 < count)
            press(bench, "n");
        /* it waits for what an answer computes */
        for (int i = 0; i < 20000 && page + 1 < count && shown->page == page; i++)
            frame(bench);
    }
    close_bench(bench);
    for (int page = 0; page < count; page++)
        free(pages[page]);
}
END_TEST

/* A field that was opened takes what the page asks for; one that takes nothing is left as its line says. */
static void close_field(Bench *bench)
{
    const FieldEdit *edit = &bench->lab.parameters.edit;
    const LessonUntil *until = &page_of(bench)->until;
    if (bench->lab.screen.prompt->open || edit->open)
        press(bench, "Enter");
    if (edit->open && until->kind == UNTIL_VALUE) {
        type(bench, until->value);
        press(bench, "Enter");
        ck_assert_msg(!edit->open, "%s: %s", until->value, edit->problem);
    }
    if (edit->open)
        press(bench, "Esc");
}

/* Whoever knows Enter, n, b, digits and arrows alone comes from the first page to the last, on both sheets:
 * nothing is refused, no key leads out of the lesson, and each question that a key opens another one closes.
 * Pages on their way are left out, for they are not waited for where only what is near is computed.
 * Where not everything is requested each lesson is read on one of the sheets, in the short form each on a
 * bar.
 */
START_TEST(few_keys_lead_through)
{
    static const char *const keys[] = {"Enter", "1",     "Down", "b",  "Right", "2",
                                       "Enter", "Enter", "3",    "Up", "Left",  "4"};
    enum { KEYS = sizeof keys / sizeof *keys, A_PAGE = 4 };
    const char *name = builtin_lessons[_i / 2].name;
    Bench *bench = open_lesson_on(name, _i % 2 ? SHEET_FULL : SHEET_PLAIN);
    const LessonShown *shown = bench->lab.screen.lesson;
    const int last = shown->lesson->n_pages - 1;
    const bool line = experiment_simulation(bench->lab.screen.experiment)->dimensions == 1;
    const bool wanted =
        suite_long() || ((line || suite_wide()) && _i / 2 % 2 == _i % 2 && (suite_wide() || _i % 3 == 0));
    only_near = !line;
    bench->rate = line ? 0 : NEAR_STEPS / FRAME_SECONDS;
    bench->width = 80;
    bench->height = 24;
    int pressed = 0;
    for (int turns = 0; wanted && shown->page < last; turns++) {
        ck_assert_msg(turns < 4 * last, "%s: page %d is not left", name, shown->page + 1);
        for (int i = 0; i < A_PAGE && !is_arriving(bench) && shown->page < last; i++, pressed++) {
            const char *key = keys[(pressed + _i) % KEYS];
            const bool leads_out = *key == 'b' && shown->page == 0; /* to the lesson before */
            press(bench, leads_out ? "Enter" : key);
            frames = 0;
            finish_work(bench);
            ck_assert_msg(shown->open && shown->lesson && strcmp(bench->lab.play.name, name) == 0,
                          "%s: %s led out of it", name, key);
            ck_assert_msg(bench->lab.screen.message->kind != MESSAGE_ERROR, "%s, page %d: %s", name,
                          shown->page + 1, text_of(bench));
        }
        close_field(bench);
        if (shown->page < last)
            press(bench, "n");
    }
    close_bench(bench);
}
END_TEST

/* Keys wait until the page is there that they are meant for, and then act in their order. */
START_TEST(keys_wait_for_a_page_on_its_way)
{
    Bench *bench = open_lesson("crack");
    const LessonShown *shown = bench->lab.screen.lesson;
    bench->rate = 10 / FRAME_SECONDS;
    while (!is_arriving(bench)) {
        ck_assert_int_lt(shown->page + 1, shown->lesson->n_pages);
        press(bench, "n");
    }
    const int page = shown->page;
    press_all(bench, "Down b"); /* b alone would leave it */
    ck_assert_int_eq(bench->lab.play.n_waiting, 2);
    ck_assert_int_eq(shown->page, page);
    bench->rate = 0;
    finish_work(bench);
    ck_assert_int_eq(bench->lab.play.n_waiting, 0);
    ck_assert_int_eq(shown->page, page - 1);
    close_bench(bench);
}
END_TEST

/* The arrows go among the choices, and Enter takes the one that they stand on. */
START_TEST(arrows_choose_an_answer)
{
    Bench *bench = open_lesson("one-step");
    const LessonShown *shown = bench->lab.screen.lesson;
    press(bench, "Enter");
    ck_assert_ptr_nonnull(page_of(bench)->question);
    press(bench, "Enter");
    ck_assert_int_eq(shown->answer, -1); /* none is marked */
    press(bench, "Up");
    ck_assert_int_eq(shown->marked, page_of(bench)->n_choices - 1);
    press_all(bench, "Up Up Down Enter");
    ck_assert_int_eq(shown->answer, 1);
    press(bench, "b");
    ck_assert_int_eq(shown->marked, -1);
    close_bench(bench);
}
END_TEST

/* A page that is left does not keep its reader waiting for what it computes. */
START_TEST(a_turned_page_is_not_waited_for)
{
    Bench *bench = open_lesson("late");
    press_all(bench, "n n");
    finish_work(bench);
    Key answer = {.name = "3", .x = -1, .y = -1}, on = {.name = "n", .x = -1, .y = -1};
    laboratory_key(&bench->lab, &answer);
    lesson_play_continue(&bench->lab);
    ck_assert_int_eq(bench->lab.screen.playback->state, STATE_COMPUTING);
    laboratory_key(&bench->lab, &on);
    ck_assert_int_eq(bench->lab.screen.lesson->page, 3);
    ck_assert_int_eq(player_place(&bench->lab).step, 1310); /* its own, not that of the answer */
    close_bench(bench);
}
END_TEST

START_TEST(a_page_can_be_left_out)
{
    Status status = {STATUS_DONE, ""};
    Bench *bench = open_bench("mode1", true);
    ck_assert(lesson_play_open(&bench->lab, "one-step", &status));
    const int pages = bench->lab.screen.lesson->lesson->n_pages;
    for (int i = 0; i < 2 * pages && bench->lab.screen.lesson->page < pages - 1; i++)
        press(bench, "PageDown");
    ck_assert_int_eq(bench->lab.screen.lesson->page, pages - 1);
    /* the next lesson by one key, after the last one the list */
    press(bench, "n");
    ck_assert_str_eq(bench->lab.play.name, builtin_lessons[1].name);
    ck_assert_int_eq(bench->lab.screen.lesson->page, 0);
    press(bench, "T");
    ck_assert(!bench->lab.screen.lesson->open);
    const char *last = builtin_lessons[screen_lesson_count() - 1].name;
    ck_assert(lesson_play_open(&bench->lab, last, &status));
    while (bench->lab.screen.lesson->lesson &&
           bench->lab.screen.lesson->page + 1 < bench->lab.screen.lesson->lesson->n_pages)
        press(bench, "n");
    press(bench, "n");
    ck_assert(bench->lab.screen.lesson->open);
    ck_assert_ptr_null(bench->lab.screen.lesson->lesson);
    press(bench, "T");
    ck_assert(!bench->lab.screen.lesson->open);
    close_bench(bench);
}
END_TEST

/* NULL or the same. */
static bool same_words(const char *one, const char *other)
{
    return one && other ? strcmp(one, other) == 0 : one == other;
}

/* The last page of a lesson names its objective; homework is marked; the list has each lesson's own title. */
START_TEST(the_last_page_names_the_objective)
{
    Lesson lesson;
    const BuiltinLesson *builtin = &builtin_lessons[_i];
    ck_assert(lesson_load(builtin->name, command_line_for_lessons, &lesson, NULL));
    ck_assert(same_words(builtin->title, lesson.title) && same_words(builtin->about, lesson.about) &&
              same_words(builtin->group, lesson.group));
    ck_assert_int_eq(builtin->n_pages, lesson.n_pages);
    const LessonPage *last = &lesson.pages[lesson.n_pages - 1];
    const char *parts[] = {last->first.text, last->revealed.text};
    bool told = strcmp(lesson.group, "Homework") == 0;
    for (int i = 0; i < 2; i++)
        told |= parts[i] && strstr(parts[i], "You can now ");
    ck_assert_msg(told, "%s: its last page, %s", builtin_lessons[_i].name, last->title);
    lesson_free(&lesson);
}
END_TEST

START_TEST(the_list_takes_two_digits_pages_and_words)
{
    const int last = screen_lesson_count() - 1;
    Bench *bench = open_bench("mode1", true);
    const LessonShown *shown = bench->lab.screen.lesson;
    ck_assert_int_gt(last, 12);
    press_all(bench, "T PageDown");
    ck_assert_int_eq(shown->chosen, 5);
    for (int i = 0; i < last; i++)
        press(bench, "PageDown");
    ck_assert_int_eq(shown->chosen, last);
    press_all(bench, "PageUp 1");
    ck_assert(!shown->lesson && shown->chosen == 0);
    press(bench, "2");
    ck_assert_str_eq(bench->lab.play.name, builtin_lessons[11].name);
    press_all(bench, "T T 1 Down 4"); /* another key parts two numbers */
    ck_assert_str_eq(bench->lab.play.name, builtin_lessons[3].name);
    press_all(bench, "T T / c o u r a n t Enter");
    ck_assert(!shown->lesson && shows(bench, "on page "));
    const int first = shown->chosen;
    press_all(bench, "/ Enter");
    ck_assert_int_ne(shown->chosen, first);
    press_all(bench, "/ q q q Enter");
    ck_assert(shows(bench, "no lesson has these words"));
    press_all(bench, "Esc Enter");
    ck_assert(shown->lesson);
    close_bench(bench);
}
END_TEST

/* The list has its groups, the sentence of the lesson that is chosen, and says how many are below; a title
 * opens its lesson wherever it stands. */
START_TEST(the_list_has_groups_and_says_how_many_more)
{
    const int last = screen_lesson_count() - 1;
    Bench *bench = open_bench("mode1", true);
    press(bench, "T");
    ck_assert(shows(bench, " Bar "));
    ck_assert(shows(bench, "What a time step does:"));
    ck_assert(shows(bench, "15 min"));
    ck_assert(!shows(bench, "Two discs meet, and no"));
    press(bench, "Down");
    ck_assert(shows(bench, "10 min"));
    ck_assert(shows(bench, "Two discs meet, and no"));
    ck_assert(!shows(bench, "What a time step does:"));
    /* what is below and what is seen are all */
    const Rect pane = screen_pane(&bench->lab.screen, 80, 24, PANE_PARAMETERS);
    int seen = 0;
    char more[32];
    for (int y = 0; y < 24; y++)
        seen += screen_lesson_at(&bench->lab.screen, 80, 24, pane.x + 5, y) >= 0;
    snprintf(more, sizeof more, "%d more", last + 1 - seen);
    ck_assert_int_gt(seen, 5);
    ck_assert_msg(shows(bench, more), "no '%s' with %d seen", more, seen);
    for (int i = 0; i < last; i++)
        press(bench, "Down");
    ck_assert(shows(bench, " Homework "));
    ck_assert(!shows(bench, " more"));
    for (int y = 0; y < 24; y++) {
        const int lesson = screen_lesson_at(&bench->lab.screen, 80, 24, pane.x + 5, y);
        if (lesson != last)
            continue;
        Key click = {.name = "Click", .x = pane.x + 5, .y = y};
        press_key(bench, &click);
        ck_assert_str_eq(bench->lab.play.name, builtin_lessons[last].name);
    }
    ck_assert_ptr_nonnull(bench->lab.screen.lesson->lesson);
    close_bench(bench);
}
END_TEST

void add_cases(Suite *suite)
{
    int count = 0;
    while (builtin_lessons[count].name)
        count++;
    TCase *format = tcase_create("format"), *own = tcase_create("own"), *turning = tcase_create("turning");
    tcase_add_test(format, a_lesson_is_read);
    tcase_add_test(format, a_choice_is_right_for_whom_it_is_drawn);
    tcase_add_test(turning, keys_wait_for_a_page_on_its_way);
    tcase_add_loop_test(format, what_is_wrong_is_told_with_its_line, 0, (int)(sizeof wrong / sizeof *wrong));
    tcase_add_loop_test(own, every_page_is_entered_in_one_state, 0, count);
    tcase_add_loop_test(turning, few_keys_lead_through, 0, 2 * count);
    tcase_add_test(turning, the_list_takes_two_digits_pages_and_words);
    tcase_add_test(turning, arrows_choose_an_answer);
    tcase_add_test(turning, a_turned_page_is_not_waited_for);
    tcase_add_test(turning, a_page_can_be_left_out);
    tcase_add_loop_test(format, the_last_page_names_the_objective, 0, count);
    tcase_add_test(turning, the_list_has_groups_and_says_how_many_more);
    suite_add_tcase(suite, format);
    suite_add_tcase(suite, own);
    suite_add_tcase(suite, turning);
}
