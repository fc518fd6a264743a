/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parts of the screen in words (tell.h). */
#include "picture/words/tell.h"
#include "scenario/concern_loads.h"
#include "scenario/settings.h"
#include "scenario/rows/rows.h"
#include "answers/dispersion_curves.h"
#include "base/text.h"
#include "answers/run_numbers.h"
#include "panes/panes.h"
#include "views/view.h"
#include "lessons/lesson_shown.h"
#include "run/playback.h"
#include "run/duel.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* As large as what is drawn there asks for; what adapts itself to the room leaves nothing out. */
enum { TALL = 80, HELP_ROWS = 2000, PICTURE_ROWS = 24, DIGITS = 5 };

static const struct {
    const char *word;
    TellPart part;
} names[] = {
    {"about", TELL_ABOUT},
    {"number", TELL_NUMBER},
    {"setup", TELL_SETUP},
    {"why", TELL_WHY},
    {"where", TELL_WHERE},
    {"stage", TELL_STAGE},
    {"parameters", TELL_PARAMETERS},
    {"lesson", TELL_LESSON},
    {"inspector", TELL_INSPECTOR},
    {"body", TELL_BODY},
    {"help", TELL_HELP},
};

static void tell_where(const Screen *screen, Words *words)
{
    static const char *const states[] = {"paused", "running", "on the way", "at the end",
                                         "stopped by a failure"};
    const Experiment *experiment = screen->experiment;
    const Settings *settings = experiment_settings(experiment);
    const Simulation *sim = experiment_simulation(experiment);
    const long back = experiment_newest(experiment) - experiment_step(experiment);
    const Duel *duel = screen_second_run(screen) ? screen->duel : NULL;
    char text[400];
    snprintf(text, sizeof text, "%s: %s, step %ld of %ld",
             screen->scenario && *screen->scenario ? screen->scenario : settings->title,
             screen_time_text(screen, experiment_time(experiment)).text, experiment_step(experiment),
             experiment_last_step(experiment));
    if (experiment_stage(experiment) > 0)
        text_append(text, sizeof text, ", stage %d of %d is done", experiment_stage(experiment),
                    sim->n_stages);
    text_append(text, sizeof text, ", %s", states[screen->playback->state]);
    if (back > 0)
        text_append(text, sizeof text, ", %ld step%s back from the newest", back, back == 1 ? "" : "s");
    if (duel)
        text_append(text, sizeof text, "; two runs: A %s, B %s", duel->names[0], duel->names[1]);
    words_say(words, 2, "%s.", text);
}

static void tell_about(const Screen *screen, Words *words)
{
    const Settings *settings = screen_settings(screen);
    Asked asked[ASKED_MAX];
    const int n_asked = settings_asked(settings, asked);
    char question[ABOUT_MAX], text[400] = "", tried[160];
    pane_question_text(screen, question);
    const bool ends = *settings->title && strchr(".!?", settings->title[strlen(settings->title) - 1]);
    words_say(words, 2, "%s%s%s%s", settings->title, ends ? "" : ".", *question ? " " : "", question);
    for (int i = 0; i < n_asked; i++) {
        char name[64], value[ROW_TEXT_MAX];
        text_append(text, sizeof text, "%s", i ? ", " : "");
        if (asked[i].parameter) {
            parameter_name_alone(asked[i].parameter, name, sizeof name);
            text_append(text, sizeof text, "%s (%s)", name, asked[i].parameter->key);
            continue;
        }
        settings_row_place_show(settings, &asked[i].place, name, value);
        text_append(text, sizeof text, "%s (%s)", name, value);
    }
    if (n_asked > 0)
        words_say(words, 2, "It asks about %s.", text);
    if (screen_question(screen, tried, sizeof tried))
        words_say(words, 2, "t tries %s.", tried);
}

static void tell_number(const Screen *screen, Words *words)
{
    char digits[NUMBER_DIGITS_MAX], about[NUMBER_WORDS_MAX];
    for (int i = 0; i < (screen_second_run(screen) ? 2 : 1); i++) {
        const Screen one = screen_second_run(screen) ? screen_of_side(screen, i ? SIDE_B : SIDE_A) : *screen;
        const RunNumber *number = run_number_about(experiment_settings(one.experiment));
        const char *run = !screen_second_run(screen) ? "" : i ? " of B" : " of A";
        const bool known = screen_number(&one, digits, about);
        if (known)
            words_say(words, 2, "The number%s: %s %s.", run, digits, about);
        else
            words_say(words, 2, "The number%s (%s%s%s) is %s.", run, number->unit, *number->unit ? " " : "",
                      number->label, *digits == '?' ? "hidden" : "not known yet");
    }
}

/* A line for each heading of parameters that is of it and for each row; what does nothing is left out. */
static void tell_setup(const Screen *screen, Words *words)
{
    static const char *const groups[] = {"Supports", "Notch", "Load", "Motion", NULL};
    const Settings *settings = screen_settings(screen);
    char text[400] = "", value[LIST_MAX];
    for (int i = 0; i < n_parameters; i++) {
        const Parameter *one = &parameters[i];
        const char *const next = i + 1 < n_parameters ? parameters[i + 1].group : "";
        const bool is_of_setup =
            text_place_in(one->group, groups) >= 0 || strcmp(one->key, "bar.supports") == 0;
        if (is_of_setup && parameter_applies_to(settings, one)) {
            settings_show(settings, one, value);
            if (*value && (one->type != PARAMETER_REAL || settings_number(settings, one) != 0))
                text_append(text, sizeof text, "%s %s %s", *text ? "," : "", one->label, value);
        }
        if (*text && strcmp(one->group, next) != 0) {
            words_say(words, 2, "%s:%s.", one->group, text);
            text[0] = '\0';
        }
    }
    for (int kind = 0; kind < ROW_KINDS; kind++)
        for (int row = 0; settings_have_rows(settings, kind) && row < settings->rows[kind].count; row++) {
            const char *const name = settings->rows[kind].rows[row].name;
            char values[ROW_TEXT_MAX];
            settings_row_show(settings, kind, row, values);
            words_say(words, 2, "%c%s%s%s (%s): %s.", row_kinds[kind].one[0] - 'a' + 'A',
                      row_kinds[kind].one + 1, *name ? " " : "", name, row_kinds[kind].form, values);
        }
}

static void tell_why(const Screen *screen, Words *words)
{
    const Settings *settings = screen_settings(screen);
    const int mode = settings_start(settings)->mode;
    ModeOnMesh on_mesh;
    words_say(words, 2, "%s", *settings->about ? settings->about : "The scenario says nothing of itself.");
    if (!screen_shows_exact(screen) || !screen_shows_predicted(screen) || mode > dispersion_modes(settings) ||
        !dispersion_mode(settings, mode, &on_mesh) || !isfinite(on_mesh.predicted))
        return;
    char text[400] = "";
    for (int i = 0; i < on_mesh.n_factors; i++)
        text_append(text, sizeof text, "%s %s %s", i ? " times" : "", on_mesh.factors[i].name,
                    text_rounded(on_mesh.factors[i].value, DIGITS).text);
    words_say(words, 2, "Mode %d oscillates on this mesh at %s of the exact frequency:%s.", mode,
              text_rounded(on_mesh.predicted / on_mesh.exact, DIGITS).text, text);
}

static void tell_focus(const Screen *screen, Words *words)
{
    static const char *const panes[] = {"the parameters", "the body", "", "", "the stage", "the inspector"};
    const View *view = screen_view_in(screen, screen->panes.focus);
    if (view)
        words_say(words, 2, "Keys go to: the view %s.", view->word);
    else
        words_say(words, 2, "Keys go to: %s.",
                  screen->lesson->open && screen->panes.focus == PANE_PARAMETERS
                      ? "the lesson"
                      : panes[screen->panes.focus]);
}

static void tell_parameter(const Screen *screen, Words *words)
{
    const Settings *settings = screen_settings(screen);
    ParameterRow row;
    if (!screen_chosen_row(screen, &row))
        return;
    const int kind = row.place.kind;
    char name[64], values[ROW_TEXT_MAX];
    if (row.is_row && row.place.value) {
        settings_row_place_show(settings, &row.place, name, values);
        words_say(words, 2, "%s is %s; the arrows change it, Enter edits it.", name, values);
    } else if (row.is_row && row.place.row == ROW_NEW)
        words_say(words, 2, "A new %s (%s): Enter adds one.", row_kinds[kind].one, row_kinds[kind].form);
    else if (row.is_row) {
        settings_row_show(settings, kind, row.place.row, values);
        words_say(words, 2, "Row %s %s (%s): %s; Enter edits it, p moves it%s.", row_kinds[kind].one,
                  settings->rows[kind].rows[row.place.row].name, row_kinds[kind].form, values,
                  row_kinds[kind].usual ? "" : ", C copies, D deletes");
    } else if (row.derived >= 0) {
        Derived derived[DERIVED_MAX];
        experiment_derived(screen->experiment, derived);
        words_say(words, 2, "%s: %s %s; it follows from the parameters.", derived[row.derived].label,
                  text_rounded(derived[row.derived].value, DIGITS).text, derived[row.derived].unit);
    }
    if (!row.parameter)
        return;
    char value[LIST_MAX], range[160];
    settings_show(settings, row.parameter, value);
    parameter_range(row.parameter, settings->problem, range, sizeof range);
    words_say(words, 2, "Parameter %s (%s): %s; allowed: %s.", row.parameter->label, row.parameter->key,
              *value ? value : "-", range);
}

/* "50 particles, 34 nodes.", then what the table has of the chosen one. */
static void tell_body(const Screen *screen, Words *words)
{
    const Simulation *sim = screen_simulation(screen);
    const int set = screen->chosen.is_node && sim->n_sets > 1;
    const size_t wanted = set ? screen->chosen.node : screen->chosen.particle;
    const size_t index = wanted < sim->counts[set] ? wanted : sim->counts[set] - 1;
    char text[1200] = "";
    for (int i = 0; i < sim->n_sets; i++)
        text_append(text, sizeof text, "%s%zu %s", i ? ", " : "", sim->counts[i], sim->sets[i].plural);
    text_append(text, sizeof text, ". Chosen is %s %zu:", sim->sets[set].name, index);
    for (int i = 0; i < sim->n_fields; i++) {
        const Field *field = &sim->fields[i];
        double number = NAN;
        if (field->set != set || !field->in_table)
            continue;
        sim->method->field(sim, i, index, 1, &number);
        text_append(text, sizeof text, " %s %s%s,", field->quantity.label, text_rounded(number, DIGITS).text,
                    screen_unit_text(screen, field).text);
    }
    text[strlen(text) - 1] = '.';
    words_say(words, 2, "%s", text);
}

void tell_view(const Screen *screen, const View *view, Words *words)
{
    const char *variant = view_variant_word(view, screen, view_variant(view, screen));
    const char *missing = view_missing(view, screen);
    Picture picture;
    if (missing) {
        words_say(words, 2, "View %s: %s.", view->word, missing);
        return;
    }
    words_say(words, 2, "View %s%s%s:", view->word, variant ? " " : "", variant ? variant : "");
    view_describe(view, screen, WORDS_WIDTH, PICTURE_ROWS, &picture);
    tell_picture(&picture, view->has_time_axis ? screen->time.cursor : NAN, words);
    words->lost |= picture.plot.lost;
    picture_close(&picture);
}

void tell_part(const Screen *screen, TellPart part, Words *words)
{
    static void (*const told[TELL_COUNT])(const Screen *, Words *) = {
        [TELL_ABOUT] = tell_about, [TELL_NUMBER] = tell_number,       [TELL_SETUP] = tell_setup,
        [TELL_WHY] = tell_why,     [TELL_WHERE] = tell_where,         [TELL_FOCUS] = tell_focus,
        [TELL_BODY] = tell_body,   [TELL_PARAMETER] = tell_parameter,
    };
    static const struct {
        void (*draw)(const Screen *, Area);
        int rows;
        bool numbered;
    } drawn[TELL_COUNT] = {
        [TELL_LESSON] = {pane_lesson, TALL, false},
        [TELL_STAGE] = {pane_box, PICTURE_ROWS, true},
        [TELL_PARAMETERS] = {pane_parameters, PARAMETER_ROWS_MAX, false},
        [TELL_HELP] = {help_draw, HELP_ROWS, false},
    };
    if (told[part])
        told[part](screen, words);
    else if (part == TELL_UPPER || part == TELL_LOWER)
        tell_view(screen, part == TELL_UPPER ? screen->views.upper : screen->views.lower, words);
    else if (part == TELL_INSPECTOR && screen->panes.inspecting)
        tell_view(screen, &view_inspector, words);
    else if (drawn[part].draw && (part != TELL_LESSON || screen->lesson->open)) {
        Screen plain = *screen;
        Canvas canvas = {.width = 0};
        const bool numbered = drawn[part].numbered;
        const Rect all = {0, 0, WORDS_WIDTH - (numbered ? 3 : 0), drawn[part].rows};
        plain.look = (ScreenLook){.glyphs = GLYPHS_ASCII};
        words->lost |= !canvas_open(&canvas, all.width, all.height, NULL);
        if (canvas.cells) {
            drawn[part].draw(&plain, (Area){&canvas, all, GLYPHS_ASCII});
            canvas_to_ascii(&canvas, true);
            words_canvas(words, &canvas, numbered);
        }
        canvas_close(&canvas);
    }
}

bool tell_named(const Screen *screen, const char *word, Words *words)
{
    const View *view = view_named(word);
    for (int part = 0; !*word && part < TELL_PARTS; part++)
        tell_part(screen, (TellPart)part, words);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(word, names[i].word) == 0) {
            tell_part(screen, names[i].part, words);
            return true;
        }
    if (view)
        tell_view(screen, view, words);
    return view || !*word;
}

const char *tell_word(int i)
{
    return i < (int)(sizeof names / sizeof *names) ? names[i].word : NULL;
}

void tell_names(char *out, size_t size)
{
    view_names(out, size);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        text_append(out, size, ", %s", names[i].word);
}

void tell_prompt(const Screen *screen, Words *words)
{
    const Prompt *prompt = screen->prompt;
    const FieldEdit *edit = &screen->parameters->edit;
    if (!prompt->open && edit->open && edit->problem[0])
        words_say(words, 2, "Refused: %s", edit->problem);
    if (!prompt->open && edit->open)
        words_say(words, 2, "The next line is its value; Esc leaves it.");
    if (!prompt->open)
        return;
    words_say(words, 2, "Asked: %s", prompt->question);
    if (prompt->yes_no)
        words_say(words, 2, "Answer y or n.");
    else if (prompt->text[0])
        words_say(words, 2, "The next line is the answer; Esc leaves it; an empty line takes: %s",
                  prompt->text);
    else
        words_say(words, 2, "The next line is the answer; Esc leaves it.");
    if (prompt->problem[0])
        words_say(words, 2, "Refused: %s", prompt->problem);
    else if (prompt->hint[0])
        words_say(words, 2, "%s", prompt->hint);
}
