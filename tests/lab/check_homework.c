/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a student sees is what a teacher gets: homework is done by keys that come at any time, while a page is
 * still on its way too, and the recording is marked. Keys are drawn at random, and come from the corpus of
 * recordings with some left out, doubled or put between. The marks are those of the screen, each time.
 *
 *     MATVIB_SEQUENCES=N  so many sessions (20)   MATVIB_SEED=N  the first one's number */
#include "suite.h"
#include "lab/tui_case.h"

#include "scenario/scenario.h"
#include "lab/session/grading.h"
#include "lab/session/session_internal.h"
#include "picture/canvas.h"

#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

/* Pages that are entered at once, on the way, and by way of more than one place of the run. */
static const char lesson_text[] = "@title Any time\n@about for the test\n"
                                  "@page Steps\n@do open mode5\n@do set time.end 5\n@do goto 4\n"
                                  "@variant initial.mode from 3 to 12\n"
                                  "@ask How many steps?\n@answer steps within 0.5\n"
                                  "@page Others\n@do open mode1\n@do set mesh.cell_size 2.5\n"
                                  "@do set time.end 5\n@do goto 3\n"
                                  "@ask How many steps?\n@answer steps within 0.5\n"
                                  "@page Which\n@do open mode5\n@do goto 5\n"
                                  "@variant mpm.mistake from no_volume, keep_grid\n"
                                  "@ask Which?\n@right this if mpm.mistake is no_volume\n"
                                  "@right that if mpm.mistake is keep_grid\n@reveal\n@do goto 8\n"
                                  "@page Better\n@do open mode5\n@do set time.end 6\n@do goto 3\n"
                                  "@do set mpm.flip_fraction 0.9\n@do goto 5\n@field mesh.cell_size\n"
                                  "@goal cells > was cells and time.end >= was time.end\n"
                                  "@solve set mesh.cell_size 0.5\n"
                                  "@page Words\n@ask Why?\n@words\n";

static uint64_t state;

static int below(int count)
{
    state += 0x9e3779b97f4a7c15u;
    uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (int)((z ^ (z >> 31)) % (uint64_t)count);
}

/* Keys parted by blanks; what begins with '"' is typed. */
static const char *const actions[] = {"n",
                                      "n",
                                      "n",
                                      "b",
                                      "Enter",
                                      "1",
                                      "2",
                                      "Space",
                                      "Space",
                                      "^C",
                                      "Esc",
                                      "$",
                                      "0",
                                      ".",
                                      "Right",
                                      "r",
                                      "u",
                                      "T",
                                      "D",
                                      "Tab",
                                      "PageDown",
                                      "Enter \"500 Enter",
                                      "Enter \"200 Enter",
                                      "Enter \"500 Enter n Enter \"200 Enter",
                                      "n Enter \"200 Enter",
                                      "n Right Space",
                                      "n : \"mesh.cell_size=0.5 Enter $",
                                      ": \"mesh.cell_size=0.5 Enter",
                                      ": \"time.end=2 Enter",
                                      ": \"until end Enter",
                                      ": \"until t 5.5 Enter",
                                      ": \"initial.mode=4 Enter",
                                      "b n 1",
                                      "n ^C Enter \"500 Enter"};

/* A laboratory on a clock that only its steps and its user move. */
typedef struct Live {
    Laboratory lab;
    Canvas canvas;
    double time;
} Live;

static double now(void *context)
{
    return ((Live *)context)->time;
}

static void worked(void *context, long steps)
{
    ((Live *)context)->time += (double)steps / 2000;
}

static bool go_on(void *context)
{
    (void)context;
    return below(200) > 0; /* ^C now and then */
}

static void nothing(void *context)
{
    (void)context;
}

/* A key, and as many frames behind it as its user takes before the next one: none, few, or until all is done.
 */
static void press_live(Live *live, const Key *key)
{
    static const int frames[] = {0, 0, 0, 1, 2, 4, 1000};
    if (live->lab.closed)
        return;
    laboratory_key(&live->lab, key);
    for (int left = frames[below(7)]; left > 0 && laboratory_active(&live->lab); left--) {
        laboratory_frame(&live->lab, live->time + FRAME_SECONDS);
        live->time += FRAME_SECONDS;
    }
    ck_assert(laboratory_draw(&live->lab, &live->canvas, 80, 24));
}

static void press_name(Live *live, const char *name)
{
    Key key = {.x = -1, .y = -1};
    snprintf(key.name, sizeof key.name, "%s", name);
    press_live(live, &key);
}

static void act(Live *live, const char *keys)
{
    char list[128], *place;
    snprintf(list, sizeof list, "%s", keys);
    for (char *name = strtok_r(list, " ", &place); name; name = strtok_r(NULL, " ", &place)) {
        char typed[2] = "";
        if (*name != '"')
            press_name(live, name);
        else
            while ((typed[0] = *++name))
                press_name(live, typed);
    }
}

/* The keys of a recording, now and then one left out, twice, or with others before it. */
static void act_again(Live *live, const Session *session)
{
    const SessionEvent *event;
    for (size_t i = 0; (event = session_event(session, i)); i++) {
        const int how = below(12);
        if (event->is_end || event->is_stop || how == 0)
            continue;
        if (how == 1)
            act(live, actions[below((int)(sizeof actions / sizeof *actions))]);
        press_live(live, &event->key);
        if (how == 2)
            press_live(live, &event->key);
    }
}

static void check_same(const Homework *homework, const Grades *grades, int number)
{
    ck_assert_msg(!*grades->remark, "session %d: %s", number, grades->remark);
    for (int i = 0; i < grades->count; i++) {
        const ExerciseMark *graded = &grades->grades[i].mark,
                           *seen = &homework->marks[grades->grades[i].page];
        ck_assert_msg(graded->tries == seen->tries && graded->judged == seen->judged &&
                          graded->right == seen->right && strcmp(graded->value, seen->value) == 0 &&
                          strcmp(graded->right_answer, seen->right_answer) == 0,
                      "session %d, page %d: %s %s, %d tries, on the screen; %s %s, %d tries, marked", number,
                      grades->grades[i].page + 1, seen->value, seen->right ? "right" : "wrong", seen->tries,
                      graded->value, graded->right ? "right" : "wrong", graded->tries);
    }
}

/* A laboratory with the lesson, by nobody's clock; its options live as long as it does. */
static void open_live(Live *live, LaboratoryOptions *options)
{
    static Settings settings;
    Status status = {STATUS_DONE, ""};
    ck_assert(scenario_load("mode1", &settings, &status));
    *options = (LaboratoryOptions){.settings = &settings,
                                   .scenario = "mode1",
                                   .lesson = "any.lesson",
                                   .student = "Ada Lovelace",
                                   .paused = true,
                                   .history = 4 << 20};
    const Host host = {now, worked, go_on, nothing, nothing, live, NULL, NULL};
    *live = (Live){.time = 0};
    ck_assert_msg(laboratory_open(&live->lab, options, &host, &status), "%s", status.text);
    ck_assert(laboratory_draw(&live->lab, &live->canvas, 80, 24));
}

static void close_live(Live *live)
{
    laboratory_close(&live->lab);
    canvas_close(&live->canvas);
}

/* One session, done and marked. Its marks that are right are counted. */
static int do_homework(const Session *again, int number)
{
    static Live live;
    static Grades grades;
    Status status = {STATUS_DONE, ""};
    LaboratoryOptions options;
    int right = 0;
    state = (uint64_t)number;
    open_live(&live, &options);
    Session *session = session_begin(&options, &status);
    ck_assert_msg(session != NULL, "%s", status.text);
    remove("any.session");
    session_record(session, "any.session", false);
    live.lab.recording = session;
    session_note_start(session, &live.lab);
    if (again)
        act_again(&live, again);
    else
        for (int i = 0; i < 25; i++)
            act(&live, actions[below((int)(sizeof actions / sizeof *actions))]);
    session_note(session, &live.lab, (SessionEvent){.is_end = true, .key = {.x = -1}});
    const bool any = session_has_keys(session);
    ck_assert_msg(session_finish(session, &status), "%s", status.text);
    session_free(session);
    const GradingTask task = {.lesson = "any.lesson", .threads = 1, .seconds = 1000};
    if (any) {
        ck_assert_msg(grading_session(&task, "any.session", &grades, &status), "%s", status.text);
        check_same(&live.lab.homework, &grades, number);
        for (int i = 0; i < grades.count; i++)
            right += grades.grades[i].mark.right;
    }
    close_live(&live);
    return right;
}

static long number_of(const char *name, long otherwise)
{
    return getenv(name) ? atol(getenv(name)) : otherwise;
}

static void enter_with_lesson(char folder[64])
{
    enter_folder(folder);
    setenv("XDG_STATE_HOME", folder, 1);
    FILE *file = fopen("any.lesson", "w");
    ck_assert(file && fputs(lesson_text, file) >= 0 && fclose(file) == 0);
}

START_TEST(marks_are_what_was_seen)
{
    char folder[64];
    int right = 0;
    const int first = (int)number_of("MATVIB_SEED", 30),
              count = (int)number_of("MATVIB_SEQUENCES", suite_wide() ? 20 : 12);
    enter_with_lesson(folder);
    for (int i = 0; i < count; i++)
        right += do_homework(NULL, first + i);
    ck_assert_int_gt(right, count / 5); /* or nothing was held against anything */
    leave_folder(folder);
}
END_TEST

START_TEST(so_they_are_of_recordings)
{
    static const char *const names[] = {"homework", "keys"};
    const char *source = getenv("MATVIB_SRCDIR");
    char folder[64], path[512], *top = realpath(source ? source : ".", NULL);
    enter_with_lesson(folder);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        Status status = {STATUS_DONE, ""};
        snprintf(path, sizeof path, "%.400s/tests/fuzz/corpus/recording/%s", top, names[i]);
        Session *session = session_read(path, &status);
        ck_assert_msg(session != NULL, "%s", status.text);
        for (int k = 0; k < 4; k++)
            do_homework(session, 1000 * (int)(i + 1) + k);
        session_free(session);
    }
    free(top);
    leave_folder(folder);
}
END_TEST

static void press_at_once(Live *live, const char *name)
{
    Key key = {.x = -1, .y = -1};
    snprintf(key.name, sizeof key.name, "%s", name);
    laboratory_key(&live->lab, &key);
}

/* What a page that was given up on its way asks has no right answer, until it is entered again. */
START_TEST(a_page_given_up_is_not_judged)
{
    static Live live;
    LaboratoryOptions options;
    char folder[64];
    const char *const problem = live.lab.prompting.shown.problem;
    const ExerciseMark *marks = live.lab.homework.marks;
    enter_with_lesson(folder);
    open_live(&live, &options);
    ck_assert_int_eq(live.lab.screen.playback->state, STATE_COMPUTING);
    press_at_once(&live, "^C");
    ck_assert(!live.lab.play.arriving);
    press_at_once(&live, "Enter");
    press_at_once(&live, "5");
    press_at_once(&live, "Enter");
    ck_assert_ptr_nonnull(strstr(problem, "was cancelled"));
    ck_assert_int_eq(marks[0].tries, 0);
    press_at_once(&live, "Esc");
    for (int i = 0; i < 3; i++)
        press_at_once(&live, "n"); /* on their way: keys that leave them do not wait */
    ck_assert_int_eq(live.lab.screen.lesson->page, 3);
    press_at_once(&live, "^C");
    act(&live, ": \"mesh.cell_size=0.5 Enter");
    player_seek(&live.lab, experiment_last_step(live.lab.screen.experiment), 0);
    while (laboratory_active(&live.lab))
        laboratory_frame(&live.lab, live.time + FRAME_SECONDS);
    ck_assert(experiment_at_end(live.lab.screen.experiment));
    ck_assert_int_eq(marks[3].tries, 0);
    close_live(&live);
    leave_folder(folder);
}
END_TEST

/* Whoever records learns at once that the disk is full, not when all is done. */
START_TEST(a_recording_that_ends_is_told)
{
    static Live live;
    LaboratoryOptions options;
    Status status = {STATUS_DONE, ""};
    char folder[64];
    const Message *message = &live.lab.message;
    enter_with_lesson(folder);
    open_live(&live, &options);
    Session *session = session_begin(&options, &status);
    session_record(session, "any.session", true);
    live.lab.recording = session;
    session_note_start(session, &live.lab);
    press_at_once(&live, "^C"); /* the page is on its way: others would wait */
    ck_assert_int_ne(message->kind, MESSAGE_ERROR);
    struct rlimit limit, none;
    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &limit);
    none = (struct rlimit){.rlim_cur = 100, .rlim_max = limit.rlim_max};
    ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &none), 0);
    press_at_once(&live, "z");
    ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &limit), 0);
    ck_assert_int_eq(message->kind, MESSAGE_ERROR);
    ck_assert_ptr_nonnull(strstr(message->text, "this session is kept no further: any.session"));
    press_at_once(&live, "z");
    ck_assert_int_ne(message->kind, MESSAGE_ERROR); /* once */
    ck_assert(!session_finish(session, &status));
    session_free(session);
    close_live(&live);
    leave_folder(folder);
}
END_TEST

/* So is one for which memory is short at its first key; one without keys has no file, and misses none. */
START_TEST(a_recording_that_never_begins_is_told)
{
    static Live live;
    LaboratoryOptions options;
    Status status = {STATUS_DONE, ""};
    char folder[64];
    enter_with_lesson(folder);
    open_live(&live, &options);
    Session *session = session_begin(&options, &status);
    ck_assert_msg(session != NULL, "%s", status.text);
    session_record(session, "any.session", true);
    ck_assert(!session_is_lost(session, &status) && session_finish(session, &status));
    session->full = true; /* the first key found no room */
    ck_assert(session_is_lost(session, &status) && !session_finish(session, &status));
    ck_assert_str_eq(status.text, "any.session: memory was short for more than its first 0 keys");
    session_free(session);
    close_live(&live);
    leave_folder(folder);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *homework = tcase_create("homework");
    tcase_set_timeout(homework, 60);
    tcase_add_test(homework, marks_are_what_was_seen);
    tcase_add_test(homework, a_page_given_up_is_not_judged);
    tcase_add_test(homework, a_recording_that_ends_is_told);
    tcase_add_test(homework, a_recording_that_never_begins_is_told);
    tcase_add_test(homework, so_they_are_of_recordings);
    suite_add_tcase(suite, homework);
}
