/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The laboratory by lines: every command and word of the tables is reached, every view tells of itself, and
 * what comes out is plain. Sentences about curves are held on curves whose numbers are known. */
#include "suite.h"
#include "lab/tui_case.h"

#include "base/signals.h"
#include "scenario/scenario.h"
#include "lab/session/session.h"
#include "plain/plain.h"
#include "picture/picture.h"
#include "views/view.h"

#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

/* A laboratory by lines, and all that it has said. */
typedef struct Talk {
    Plain plain;
    Settings settings;
    FILE *out;
    char *text;
    size_t size;
} Talk;

static Talk *open_talk(const char *scenario)
{
    Talk *talk = calloc(1, sizeof *talk);
    Status status = {STATUS_DONE, ""};
    ck_assert_ptr_nonnull(talk);
    ck_assert_msg(scenario_load(scenario, &talk->settings, &status), "%s", status.text);
    talk->out = open_memstream(&talk->text, &talk->size);
    const LaboratoryOptions options = {
        .settings = &talk->settings, .scenario = scenario, .threads = 1, .plain = true};
    ck_assert_msg(plain_open(&talk->plain, &options, talk->out, &status), "%s", status.text);
    return talk;
}

static void close_talk(Talk *talk)
{
    plain_close(&talk->plain);
    fclose(talk->out);
    free(talk->text);
    free(talk);
}

/* What a line brings, valid until the next one. */
static const char *line(Talk *talk, const char *text)
{
    Status status = {STATUS_DONE, ""};
    fflush(talk->out);
    const size_t before = talk->size;
    ck_assert_msg(plain_line(&talk->plain, text, &status), "%s", status.text);
    fflush(talk->out);
    return talk->text + before;
}

/* Printable ASCII in lines of at most WORDS_WIDTH. */
static void is_plain(const char *text)
{
    size_t column = 0;
    for (const char *at = text; *at; at++) {
        column = *at == '\n' ? 0 : column + 1;
        ck_assert_msg(*at == '\n' || (*at >= ' ' && *at <= '~'), "a byte %d in: %s", *at, text);
        ck_assert_msg(column <= WORDS_WIDTH, "too wide: %s", text);
    }
}

/* What a line brings holds a text, blanks and line ends apart. */
static void says(Talk *talk, const char *text, const char *wanted)
{
    const char *said = line(talk, text);
    char joined[1 << 16];
    size_t length = 0;
    for (const char *at = said; *at && length + 1 < sizeof joined; at++) {
        const char c = *at == '\n' ? ' ' : *at;
        if (c != ' ' || (length > 0 && joined[length - 1] != ' '))
            joined[length++] = c;
    }
    joined[length] = '\0';
    ck_assert_msg(strstr(joined, wanted), "%s: not '%s' in: %.900s", text, wanted, joined);
}

START_TEST(every_command_is_reached)
{
    for (int i = 0; i < n_commands; i++) {
        Talk *talk = open_talk("mode1");
        ck_assert(!command_set_has(talk->plain.lab.screen.used, commands[i].id));
        const char *said = line(talk, commands[i].name);
        ck_assert_msg(command_set_has(talk->plain.lab.screen.used, commands[i].id), "%s: %s",
                      commands[i].name, said);
        is_plain(talk->text);
        close_talk(talk);
    }
}
END_TEST

START_TEST(every_key_is_reached)
{
    for (int i = 0; i < n_commands; i++) {
        Talk *talk = open_talk("mode1");
        char key[COMMAND_KEY_MAX];
        command_first_key(&commands[i], key);
        if (strcmp(key, ":") != 0) { /* it begins what is not a key */
            const char *said = line(talk, key);
            ck_assert_msg(command_set_has(talk->plain.lab.screen.used, commands[i].id),
                          "%s: its key '%s' says: %s", commands[i].name, key, said);
        }
        close_talk(talk);
    }
}
END_TEST

START_TEST(every_word_with_arguments_is_reached)
{
    char folder[64];
    enter_folder(folder); /* some of them write */
    Talk *talk = open_talk("mode1");
    for (int i = 0; i < n_line_verbs; i++) {
        char text[64];
        snprintf(text, sizeof text, "%s no-such-thing", line_verbs[i].name);
        const char *said = line(talk, text);
        ck_assert_msg(*said && !strstr(said, "unknown:"), "%s: %s", text, said);
        if (talk->plain.lab.screen.prompt->open)
            line(talk, "Esc");
        ck_assert_msg(!talk->plain.lab.screen.prompt->open, "%s", text);
    }
    is_plain(talk->text);
    close_talk(talk);
    leave_folder(folder);
}
END_TEST

static void tell_views(const char *scenario)
{
    Talk *talk = open_talk(scenario);
    line(talk, ">");
    for (int i = 0; i < n_views; i++) {
        Screen *screen = &talk->plain.lab.screen;
        for (int variant = 0; variant < view_variants(views[i], screen); variant++) {
            Words words = {.text = NULL};
            view_choose_variant(views[i], screen, variant);
            tell_view(screen, views[i], &words);
            ck_assert_msg(words.text && strstr(words.text, views[i]->word), "%s %s", scenario,
                          views[i]->word);
            const char *more = strchr(words.text, '\n');
            ck_assert_msg(view_missing(views[i], screen) || more[1], "%s %s tells nothing: %s", scenario,
                          views[i]->word, words.text);
            is_plain(words.text);
            words_close(&words);
        }
    }
    close_talk(talk);
}

START_TEST(every_view_tells_of_itself)
{
    tell_views("mode5");
    tell_views("supported-beam-coarse");
    tell_views("notched-beam-coarse");
}
END_TEST

START_TEST(answers_go_where_they_are_asked)
{
    Talk *talk = open_talk("mode1");
    ck_assert_ptr_nonnull(strstr(line(talk, "initial.mode=3"), "initial.mode"));
    const Settings *settings = experiment_settings(talk->plain.lab.screen.experiment);
    ck_assert_double_eq(settings_number(settings, parameter_find("initial.mode")), 3);
    ck_assert_ptr_nonnull(strstr(line(talk, "initial.mode=0.5"), "initial.mode"));
    ck_assert(!talk->plain.lab.screen.prompt->open);
    ck_assert_ptr_nonnull(strstr(line(talk, "quit"), "Answer y or n"));
    line(talk, "n");
    ck_assert(!talk->plain.lab.closed);
    ck_assert_ptr_nonnull(strstr(line(talk, "g"), "Asked: "));
    line(talk, "#3");
    ck_assert_int_eq(experiment_step(talk->plain.lab.screen.experiment), 3);
    line(talk, ":2");
    ck_assert_double_eq_tol(experiment_time(talk->plain.lab.screen.experiment), 2, 1e-9);
    line(talk, "until end");
    ck_assert(experiment_at_end(talk->plain.lab.screen.experiment));
    close_talk(talk);
}
END_TEST

/* What comes back at its end, and what goes on by itself, comes to rest. */
START_TEST(what_never_ends_does)
{
    Talk *talk = open_talk("mode1");
    line(talk, "loop 1 2");
    line(talk, "Space");
    ck_assert_int_eq(talk->plain.lab.screen.playback->state, STATE_PAUSED);
    line(talk, "loop");
    line(talk, "0");
    ck_assert_ptr_nonnull(strstr(line(talk, "slow-motion"), "Stage 3 of 7"));
    ck_assert_int_eq(talk->plain.lab.screen.playback->state, STATE_PAUSED);
    ck_assert(!talk->plain.lab.screen.playback->slow);
    line(talk, "open mode5");
    ck_assert_int_eq(experiment_step(talk->plain.lab.screen.experiment), 0);
    close_talk(talk);
}
END_TEST

START_TEST(strange_lines_do_no_harm)
{
    enum { LINES = 300, MOST = 700 };
    char folder[64];
    enter_folder(folder);
    Talk *talk = open_talk("mode1");
    Status status = {STATUS_DONE, ""};
    Session *session = session_begin(&talk->plain.lab.options, &status);
    ck_assert_ptr_nonnull(session);
    session_record(session, "kept.session", false);
    talk->plain.lab.recording = session;
    session_note_start(session, &talk->plain.lab);
    ck_assert_ptr_nonnull(strstr(line(talk, "fo\xf6"), "not text in UTF-8"));
    ck_assert_ptr_nonnull(strstr(line(talk, "tell\twhere"), "step 0"));
    unsigned seed = 1;
    for (int i = 0; i < LINES && !talk->plain.lab.closed; i++) {
        char text[MOST + 1];
        size_t length = 0;
        for (seed = seed * 1103515245u + 12345u; length < (seed >> 16) % MOST; length++) {
            text[length] = (char)(1 + (seed = seed * 1103515245u + 12345u) / 65536 % 255);
            text[length] = text[length] == '\n' ? ' ' : text[length];
        }
        text[length] = '\0';
        line(talk, text);
    }
    is_plain(talk->text);
    session_note(session, &talk->plain.lab, (SessionEvent){.is_end = true, .key = {.x = -1}});
    ck_assert_msg(session_finish(session, &status), "%s", status.text);
    session_free(session);
    Session *again = session_read("kept.session", &status);
    ck_assert_msg(again != NULL, "%s", status.text);
    session_free(again);
    close_talk(talk);
    leave_folder(folder);
}
END_TEST

/* Each row of the parameter pane says what it is, and a field that is open what it waits for. */
START_TEST(rows_of_a_plate_are_told)
{
    Talk *talk = open_talk("two-cracks");
    ParameterRow rows[PARAMETER_ROWS_MAX];
    const Screen *screen = &talk->plain.lab.screen;
    line(talk, "pd.spacing=2e-3");
    line(talk, "pd.horizon=8e-3");
    for (int i = 0, count = screen_parameter_rows(screen, rows); i < count; i++) {
        const int before = screen->parameters->selected;
        const char *said = line(talk, "Down");
        ck_assert_msg(screen->parameters->selected == before || !strstr(said, "Done."), "%d: %s", i, said);
    }
    line(talk, "/");
    line(talk, "cuts");
    says(talk, "Enter", "The next line is its value; Esc leaves it.");
    says(talk, "nonsense", "Refused: a cut is NAME = X0 Y0 X1 Y1");
    says(talk, "nonsense", "The next line is its value; Esc leaves it.");
    says(talk, "left = 0 26e-3 50e-3 26e-3", "Row cut left (X0 Y0 X1 Y1): 0 0.026 0.05 0.026;");
    says(talk, "cut right 50e-3 34e-3 0.1 34e-3", "cut right: x0 0.05 x1 0.1, before: x0 0.048 x1 100%.");
    says(talk, "p", "first end: arrows");
    says(talk, "show shapes", "A row is being moved:");
    says(talk, "tell", "A row is being moved:");
    line(talk, "Esc");
    says(talk, "tell shapes", "View shapes");
    close_talk(talk);
}
END_TEST

/* ^C of somebody who sits there stops the work, not the program; a file's lines end with it. */
START_TEST(an_interrupt_means_the_work)
{
    char folder[64];
    enter_folder(folder);
    Talk *talk = open_talk("mode1");
    signal(SIGINT, SIG_DFL); /* the test's own handler ends it */
    signals_catch();
    line(talk, "until t 1");
    line(talk, "x");
    line(talk, "");
    line(talk, "overlay mode1-series.csv");
    talk->plain.talks = true;
    raise(SIGINT);
    says(talk, "fit bar.density", "interrupted");
    ck_assert_int_eq(signals_ended_by(), 0);
    talk->plain.talks = false;
    raise(SIGINT);
    line(talk, "until end");
    ck_assert_int_eq(signals_ended_by(), SIGINT);
    ck_assert(!experiment_at_end(talk->plain.lab.screen.experiment));
    signals_release();
    close_talk(talk);
    leave_folder(folder);
}
END_TEST

/* Bars and strokes that are no frame are the physics and the syntax. */
START_TEST(equations_and_alternatives_keep_their_bars)
{
    Talk *talk = open_talk("notched-beam-coarse");
    says(talk, "help", "help all prints all keys");
    says(talk, "help all", "s = (|xi+eta| - |xi|)/|xi|");
    says(talk, "help all", "all|exact|predicted|none");
    line(talk, "Esc");
    line(talk, "/");
    line(talk, "follow");
    says(talk, "tell", "(output.follow): -; allowed: particle 12 velocity, ...");
    close_talk(talk);
}
END_TEST

START_TEST(only_curves_of_one_thing_are_compared)
{
    Talk *talk = open_talk("notched-beam-coarse");
    line(talk, "step");
    says(talk, "show section", "ux over y. ");
    says(talk, "tell section", "measured lies on -y duy/dx (eq. 14).");
    ck_assert_ptr_null(strstr(line(talk, "tell shapes"), "lies on"));
    line(talk, "show dispersion shear");
    says(talk, "tell dispersion", "k at 45 deg: from");
    ck_assert_ptr_null(strstr(line(talk, "tell dispersion"), "is away from"));
    close_talk(talk);
}
END_TEST

/* A single step is told without its curves, several steps with them. */
static int lines_of(const char *text)
{
    int lines = 0;
    for (; *text; text++)
        lines += *text == '\n';
    return lines;
}

/* What it is about comes first, with its number; curves wait until they are asked for. */
START_TEST(the_number_is_told_and_curves_wait)
{
    Talk *talk = open_talk("mode5");
    ck_assert_msg(lines_of(talk->text) <= 18, "%s", talk->text);
    const char *const asked = strstr(talk->text, "Why is mode 5 late? Which cures it");
    ck_assert_msg(asked && strstr(asked, "(time.courant)") && strstr(asked, "t tries cell size 0.5."), "%s",
                  talk->text);
    ck_assert_ptr_nonnull(strstr(asked, "The number (periods behind) is not known yet."));
    ck_assert_ptr_nonnull(strstr(asked, "Bar: supports fixed-free."));
    ck_assert_ptr_null(strstr(talk->text, "View "));
    line(talk, "goto 5");
    const char *said = line(talk, "."); /* a step alone tells no number, some steps do */
    ck_assert_msg(!strstr(said, "The number"), "%s", said);
    said = line(talk, "goto 5.5"); /* fifty */
    ck_assert_msg(strstr(said, "The number: "), "%s", said);
    said = line(talk, "until t 10");
    ck_assert_msg(strstr(said, "The number: 0.38 periods behind.") && !strstr(said, "measured"), "%s", said);
    said = line(talk, "why");
    ck_assert_msg(strstr(said, "11 cells to a wave") &&
                      strstr(said, "Mode 5 oscillates on this mesh at 0.957"),
                  "%s", said);
    says(talk, "more", "measured is away from exact");
    says(talk, "show energies", "View energies");
    says(talk, "mesh.cell_size=0.5", "cell size (mesh.cell_size): 0.5, before: 1.");
    line(talk, "references none");
    says(talk, "tell number", "The number (periods behind) is hidden.");
    ck_assert_ptr_null(strstr(line(talk, "why"), "oscillates"));
    line(talk, "open notched-beam-coarse");
    says(talk, "tell setup", "Notch: position 0.065, depth 0.0175.");
    line(talk, "open two-cracks");
    says(talk, "tell setup", "Cut left (X0 Y0 X1 Y1): 0 0.026 0.052 0.026.");
    close_talk(talk);
}
END_TEST

/* A list names all its columns, whatever has room beside each other, and the chosen row stands in the middle.
 */
START_TEST(rows_of_a_list_are_told_whole)
{
    Talk *talk = open_talk("mode5");
    says(talk, "tell tables", "particle: x0; x; displacement; velocity; stress;");
    says(talk, "tell tables", "momentum; slope C 13: 6.75, 6.75, 0, -0.062524, 0, 0, 1, 0.5, 6, 0.75,");
    says(talk, "tell tables", " 25: 12.75, 12.75, 0, 0.079968, 0, 0, 1, 0.5, 12, 0.75, 0, 0.039984, 0 26:");
    ck_assert_ptr_null(strstr(line(talk, "tell tables"), " 12: "));
    ck_assert_ptr_null(strstr(line(talk, "tell tables"), " 38: "));
    says(talk, "tell log", "what happened: 0 events. nothing out of the ordinary so far");
    says(talk, "tell beam", "particle 25 and its nodes");
    close_talk(talk);
}
END_TEST

START_TEST(cracks_have_the_names_of_their_cuts)
{
    Talk *talk = open_talk("two-cracks");
    line(talk, "pd.spacing=2e-3");
    line(talk, "pd.horizon=8e-3");
    line(talk, "step");
    says(talk, "show cracks advance", "a left: 0 mm at t");
    says(talk, "tell cracks", "b right: 0 mm at t");
    line(talk, "open notched-beam-coarse");
    says(talk, "tell cracks", "View cracks: no cut of a plate ends inside");
    close_talk(talk);
}
END_TEST

enum { PAGE_LINES = 10 };

/* A clock by which each piece of work takes a frame. */
static double slow_work(void *context)
{
    return ((Plain *)context)->time += FRAME_SECONDS;
}

/* What is opened is built to its end, though an interrupt has come. */
static bool build(void *context)
{
    (void)context;
    return true;
}

/* As it is entered: whole, with its choices, and without what waits for `more`. */
static void check_page(Talk *talk, const char *lesson, const char *said)
{
    const Screen *screen = &talk->plain.lab.screen;
    const LessonShown *shown = screen->lesson;
    const int stage = experiment_stage(screen->experiment), number = shown->page + 1;
    const int n_choices = shown->lesson->pages[shown->page].n_choices;
    char heading[24], choice[24], told[24];
    if (strstr(said, "cancelled\n")) /* which takes a line of the page: told anew */
        said = line(talk, "^L");
    snprintf(heading, sizeof heading, "  %d/%d\n", number, shown->lesson->n_pages);
    snprintf(choice, sizeof choice, "\n  %d ", n_choices);
    snprintf(told, sizeof told, " 1 Stage %d of ", stage);
    ck_assert_msg(lines_of(said) <= PAGE_LINES, "%s: %d lines: %s", lesson, lines_of(said), said);
    ck_assert_msg(!strstr(said, "cancels"), "%s: work that is done: %s", lesson, said);
    ck_assert_msg(strstr(said, heading), "%s: no page %d: %s", lesson, number, said);
    ck_assert_msg(!strstr(said, "View ") && !strstr(said, " 1 Stage ") && !strstr(said, "more prints"),
                  "%s: %s", lesson, said);
    ck_assert_msg(n_choices == 0 || strstr(said, choice), "%s: %s", lesson, said);
    is_plain(said);
    if (stage > 0)
        says(talk, "more", told);
}

/* By `n`; of a beam or a plate, which takes long to be opened, where not everything is requested only to
 * pages that are within a step, and to others by their text. */
static const char *turn_page(Talk *talk)
{
    Screen *screen = &talk->plain.lab.screen;
    LessonShown *shown = &talk->plain.lab.play.shown;
    if (suite_wide() || shown->lesson->pages[shown->page].until.kind == UNTIL_STAGE ||
        experiment_stage(screen->experiment) > 0 ||
        parameter_applies_to(experiment_settings(screen->experiment), parameter_find("bar.length")))
        return line(talk, "n");
    shown->page++;
    shown->answer = -1;
    return line(talk, "^L");
}

/* A page is read in ten lines; stage, body and curves come when they are asked for. */
START_TEST(a_page_is_short_and_more_tells_the_rest)
{
    signal(SIGINT, SIG_DFL); /* the test's own handler ends it */
    signals_catch();
    raise(SIGINT); /* no run goes on for more than a frame */
    for (int i = 0; builtin_lessons[i].name; i++) {
        Talk *talk = open_talk("mode5");
        const LessonShown *shown = talk->plain.lab.screen.lesson;
        char text[80];
        talk->plain.lab.host.now = slow_work;
        talk->plain.lab.host.go_on = build;
        snprintf(text, sizeof text, "lesson %s", builtin_lessons[i].name);
        check_page(talk, builtin_lessons[i].name, line(talk, text));
        while (shown->page + 1 < shown->lesson->n_pages)
            check_page(talk, builtin_lessons[i].name, turn_page(talk));
        close_talk(talk);
    }
    signals_forget();
    signals_release();
    Talk *talk = open_talk("mode5");
    says(talk, "lesson late", "Why is mode 5 late? 1/");
    says(talk, "more", "View probe");
    says(talk, "more", "View profile");
    says(talk, "more", "50 particles");
    says(talk, "T", "Keys go to: the parameters");
    says(talk, "goto 2", "The number: ");
    close_talk(talk);
}
END_TEST

/* What a long page has no room for is told by `more`, once. */
START_TEST(a_long_page_goes_on)
{
    char folder[64];
    enter_folder(folder);
    FILE *file = fopen("long.lesson", "w");
    ck_assert_ptr_nonnull(file);
    fprintf(file, "@title Long\n@page One\n@do open mode5\n");
    for (int i = 1; i <= 12; i++)
        fprintf(file, "line %d of it.\n\n", i);
    fprintf(file, "@ask Which?\n@right this\n@choice that\n@page Two\n@do open mode5\nshort\n");
    fclose(file);
    Talk *talk = open_talk("mode5");
    const char *said = line(talk, "lesson long.lesson");
    ck_assert_msg(lines_of(said) == PAGE_LINES &&
                      strstr(said, "line 7 of it.\nmore prints the rest, with the choices.\n"),
                  "%s", said);
    said = line(talk, "more");
    ck_assert_msg(strncmp(said, " line 8 of it.\n", 15) == 0 &&
                      strstr(said, "line 12 of it.\n Which?\n  1 this\n  2 that\n"),
                  "%s", said);
    ck_assert_ptr_null(strstr(line(talk, "more"), "of it."));
    line(talk, "b");
    line(talk, "n");
    ck_assert_ptr_null(strstr(line(talk, "more"), "of it."));
    says(talk, "b", "line 7 of it. more prints the rest, with the choices.");
    says(talk, "n", "short");
    ck_assert_ptr_null(strstr(line(talk, "more"), "of it."));
    close_talk(talk);
    leave_folder(folder);
}
END_TEST

/* A lesson is opened where its reader had come to, and that is said, however long the way there is. */
START_TEST(a_lesson_that_resumes_says_so)
{
    Talk *talk = open_talk("mode5");
    int late = 0;
    while (strcmp(builtin_lessons[late].name, "late") != 0)
        late++;
    talk->plain.lab.play.shown.reached[late] = 4;
    says(talk, "lesson late", "you had come to page 4");
    talk->plain.lab.play.shown.reached[late] = 1;
    ck_assert_ptr_null(strstr(line(talk, "lesson late"), "you had come"));
    close_talk(talk);
}
END_TEST

START_TEST(the_help_of_a_plate_is_of_plates)
{
    Talk *talk = open_talk("two-cracks");
    ck_assert_ptr_nonnull(strstr(line(talk, "help all"), "surface"));
    ck_assert_ptr_null(strstr(talk->text, "antilever:"));
    ck_assert_ptr_null(strstr(talk->text, "Timoshenko"));
    ck_assert_ptr_nonnull(strstr(talk->text, "no contact"));
    line(talk, "Esc");
    line(talk, "open supported-beam-coarse");
    says(talk, "help all", "Moving cantilever:");
    close_talk(talk);
}
END_TEST

/* --- sentences --------------------------------------------------------------------------------------- */

/* Told of a curve y(x) from 0 to 10. */
static Words told_of(double (*curve)(double), double (*exact)(double), const char *heading)
{
    Picture picture;
    Words words = {.text = NULL};
    picture_open(&picture, WORDS_WIDTH, 0, WORDS_WIDTH, 16);
    picture.compares = true;
    picture_axes(&picture, axis_make(0, 10), "t", "", axis_make(-2, 2), "", "");
    picture_heading(&picture, "%s", heading);
    for (int which = 0; which < (exact ? 2 : 1); which++) {
        plot_begin(&picture.plot, STROKE_LINE,
                   (Pen){which ? LINE_DOTTED : LINE_SOLID, 'm', which ? STYLE_EXACT : STYLE_MEASURED,
                         RANK_MEASURED, 0});
        for (int i = 0; i <= 1000; i++)
            plot_point(&picture.plot, 0.01 * i, (which ? exact : curve)(0.01 * i));
    }
    picture_name(&picture, pen_exact, "exact");
    tell_picture(&picture, 5, &words);
    picture_close(&picture);
    is_plain(words.text);
    for (char *at = words.text; (at = strchr(at, '\n'));) /* as one line, for what is looked for */
        *at = ' ', at += strspn(at, " ") > 1 ? 1 : 0;
    return words;
}

static void tells(double (*curve)(double), double (*exact)(double), const char *heading, const char *wanted)
{
    Words words = told_of(curve, exact, heading);
    char joined[4000];
    size_t length = 0;
    for (const char *at = words.text; *at && length + 1 < sizeof joined; at++)
        if (*at != ' ' || (length > 0 && joined[length - 1] != ' '))
            joined[length++] = *at;
    joined[length] = '\0';
    ck_assert_msg(strstr(joined, wanted), "not '%s' in: %s", wanted, joined);
    words_close(&words);
}

static double wave(double t)
{
    return sin(M_PI * t / 2 + 0.1);
}

static double late_wave(double t)
{
    return sin(M_PI * (t - 0.2) / 2 + 0.1);
}

static double line_up(double t)
{
    return 0.1 * t - 0.5;
}

static double flat(double t)
{
    return 0 * t + 1.5;
}

START_TEST(sentences_tell_what_a_curve_does)
{
    tells(line_up, NULL, "u",
          "measured: from t 0 to 10: rises all the way from -0.5 to 0.5; crosses zero once, at 5.");
    tells(line_up, NULL, "u", "measured at the cursor, t 5: 0.");
    tells(flat, NULL, "u", "measured: from t 0 to 10: stays at 1.5.");
    tells(wave, NULL, "u",
          "begins at 0.09983, least -1 at 2.94, greatest 1 at 0.94; crosses zero 5 times, the last at 9.936;"
          " ends at -0.09983, falling.");
    tells(late_wave, wave, "u", "measured is away from exact by at most 0.3129");
    tells(wave, wave, "u", "measured lies on exact.");
}
END_TEST

START_TEST(units_go_with_their_numbers)
{
    tells(flat, NULL, "u x10^-3", "u over t. measured: from t 0 to 10: stays at 1.5.");
    tells(flat, NULL, "u, mm", "u over t. measured: from t 0 to 10: stays at 1.5 mm.");
}
END_TEST

/* A path that turns back, whether its view says so or not: as a function of x it would rise, fall and cross
 * zero. */
START_TEST(a_path_is_no_function)
{
    static const double path[][2] = {{1, -1}, {3, 1}, {2, 2}, {0.5, -0.5}};
    Picture picture;
    Words words = {.text = NULL};
    picture_open(&picture, WORDS_WIDTH, 0, WORDS_WIDTH, 16);
    picture.kind = _i == 0 ? PICTURE_PATH : PICTURE_FUNCTION;
    picture_axes(&picture, axis_make(0, 4), "u", "", axis_make(-2, 2), "v", "");
    plot_begin(&picture.plot, STROKE_LINE, pen_measured);
    for (int i = 0; i < 4; i++)
        plot_point(&picture.plot, path[i][0], path[i][1]);
    tell_picture(&picture, 2, &words);
    ck_assert_ptr_nonnull(strstr(words.text, "a path from u 1, v -1 to 0.5, -0.5;"));
    ck_assert_ptr_nonnull(strstr(words.text, "and 2."));
    ck_assert_ptr_null(strstr(words.text, "zero"));
    ck_assert_ptr_null(strstr(words.text, "rises"));
    ck_assert_ptr_null(strstr(words.text, "cursor"));
    words_close(&words);
    picture_close(&picture);
}
END_TEST

/* 5 by 3 pieces with one that stands out. */
static Words told_of_map(size_t greatest, double peak)
{
    Picture picture;
    Words words = {.text = NULL};
    picture_open(&picture, WORDS_WIDTH, 0, WORDS_WIDTH, 16);
    picture_axes(&picture, axis_make(0, 1), "x, mm", "", axis_make(0, 1), "", "");
    picture_heading(&picture, "damage");
    PictureMap *map = picture_map(&picture, 5, 3);
    ck_assert_ptr_nonnull(map);
    map->enlarged = 10;
    for (size_t i = 0; i < 15; i++)
        map->x[i] = map->y[i] = map->value[i] = 0;
    map->value[greatest] = peak;
    map->torn[greatest] = isnan(peak);
    tell_picture(&picture, NAN, &words);
    picture_close(&picture);
    return words;
}

START_TEST(a_map_tells_what_stands_out)
{
    static const struct {
        size_t piece;
        double peak;
        const char *said;
    } cases[] = {{13, .5, "greatest: 0.5, 75 % along, at the upper edge."},
                 {6, .5, "greatest: 0.5, 25 % along, 50 % up."},
                 {1, -2, "least: -2, 25 % along, at the lower edge."},
                 {1, 0, "everywhere 0."},
                 {1, NAN, "1 nodes are too much damaged"}};
    Words words = told_of_map(cases[_i].piece, cases[_i].peak);
    ck_assert_msg(strstr(words.text, cases[_i].said), "not '%s' in: %s", cases[_i].said, words.text);
    ck_assert_ptr_nonnull(strstr(words.text, "5 by 3 nodes, coloured by damage; displacements are drawn 10"));
    is_plain(words.text);
    words_close(&words);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("plain");
    tcase_add_test(tcase, every_command_is_reached);
    tcase_add_test(tcase, every_key_is_reached);
    tcase_add_test(tcase, every_word_with_arguments_is_reached);
    tcase_add_test(tcase, every_view_tells_of_itself);
    tcase_add_test(tcase, answers_go_where_they_are_asked);
    tcase_add_test(tcase, what_never_ends_does);
    tcase_add_test(tcase, equations_and_alternatives_keep_their_bars);
    tcase_add_test(tcase, only_curves_of_one_thing_are_compared);
    tcase_add_test(tcase, the_number_is_told_and_curves_wait);
    tcase_add_test(tcase, rows_of_a_list_are_told_whole);
    tcase_add_test(tcase, cracks_have_the_names_of_their_cuts);
    tcase_add_test(tcase, the_help_of_a_plate_is_of_plates);
    tcase_add_test(tcase, a_page_is_short_and_more_tells_the_rest);
    tcase_add_test(tcase, a_long_page_goes_on);
    tcase_add_test(tcase, a_lesson_that_resumes_says_so);
    tcase_add_test(tcase, strange_lines_do_no_harm);
    tcase_add_test(tcase, rows_of_a_plate_are_told);
    tcase_add_test(tcase, an_interrupt_means_the_work);
    tcase_add_loop_test(tcase, a_path_is_no_function, 0, 2);
    tcase_add_test(tcase, sentences_tell_what_a_curve_does);
    tcase_add_test(tcase, units_go_with_their_numbers);
    tcase_add_loop_test(tcase, a_map_tells_what_stands_out, 0, 5);
    suite_add_tcase(suite, tcase);
}
