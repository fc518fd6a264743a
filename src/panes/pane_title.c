/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The title line: what is shown, where in time, in what state. */
#include "panes/panes.h"
#include "scenario/concern_cells.h"
#include "scenario/settings.h"
#include "lessons/lesson_shown.h"
#include "run/playback.h"
#include "run/duel.h"

#include <stdio.h>
#include <string.h>

/* "MPM USF hat", of a duel "A USF  B USL": the method and the choices that make the difference. */
static void method_words_of(const Screen *screen, char *out, size_t size)
{
    static const char *const keys[] = {"mpm.algorithm", "mpm.shape", "mpm.transfer"};
    const Settings *settings = screen_settings(screen);
    if (screen_second_run(screen)) {
        snprintf(out, size, "A %s  B %s", screen->duel->names[0], screen->duel->names[1]);
        return;
    }
    snprintf(out, size, "%s", parameter_method_titles[settings->method]);
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        const Parameter *parameter = parameter_find(keys[i]);
        if (!parameter || !parameter_applies_to(settings, parameter))
            continue;
        char value[LIST_MAX];
        settings_spell(settings, parameter, value);
        if (i == 2 && strcmp(value, "FLIP") == 0)
            continue; /* the usual one goes without saying */
        text_append(out, size, " %s", value);
    }
    const char *mistake = settings_mistake(settings);
    text_append(out, size, "%s%s", mistake ? " with " : "", mistake ? mistake : "");
}

static void pace_text(double pace, char *out, size_t size)
{
    if (pace > 2.0 / 3 || pace <= 0) /* from here on the other form would say x1/1 */
        snprintf(out, size, "x%.0f", pace);
    else
        snprintf(out, size, "x1/%.0f", 1 / pace);
}

/* The state in full or, where room is short, in as few words as possible. */
static void state_text(const Screen *screen, bool brief, char *out, size_t size)
{
    char pace[24];
    const char *running = screen->playback->looping ? "LOOP" : "RUNNING";
    long back = experiment_newest(screen->experiment) - experiment_step(screen->experiment);
    const Playback *playback = screen->playback;
    if (playback->state == STATE_RUNNING) {
        pace_text(playback->pace, pace, sizeof pace);
        if (playback->at_limit && playback->rate > 0) {
            pace_text(playback->rate, pace, sizeof pace);
            strcat(pace, " max");
        }
        const bool named = !brief || !playback->at_limit;
        snprintf(out, size, "%s%s%s", named ? running : "", named ? " " : "", pace);
        if (playback->until[0] && !brief)
            text_append(out, size, " to %s", playback->until);
    } else if (playback->state == STATE_COMPUTING)
        snprintf(out, size, "computing %3.0f %%", 100 * playback->work_share);
    else if (playback->state != STATE_PAUSED)
        snprintf(out, size, "%s", playback->state == STATE_ENDED ? "END" : "STOPPED");
    else if (playback->slow)
        snprintf(out, size, brief ? "SLOW" : "SLOW MOTION");
    else if (back > 0)
        snprintf(out, size, brief ? "PAUSED -%ld" : "PAUSED -%ld step%s", back, back == 1 ? "" : "s");
    else
        snprintf(out, size, "PAUSED");
}

/* The time with so many decimals less than the step has, but with two at least where it has them. */
static void screen_shorter_time(const Screen *screen, int less, char *out, size_t size)
{
    const double time = experiment_time(screen->experiment);
    snprintf(out, size, "%s", screen_time_text(screen, time).text);
    const char *point = strchr(out, '.');
    const int decimals = point ? (int)strspn(point + 1, "0123456789") : 0, least = decimals - less;
    const Problem *facts = screen_problem(screen);
    if (decimals > 2)
        snprintf(out, size, "t %.*f%s", least > 2 ? least : 2, time / facts->shown_time,
                 facts->shown_time_unit);
}

enum { BAR_CELLS = 10 };

/* What the title gives up, one after the other, where there is no room. What the run is about stands first;
 * the method's words are shown by the parameters too, the scenario's name is not. */
typedef struct TitleForm {
    bool headline, brief, name, words; /* brief: of the state */
    int fewer;                         /* decimals of the time that are left out */
    bool close, no_stage, no_step;
} TitleForm;

typedef struct Title {
    char text[256], state[64];
    bool has_headline;
    bool bar; /* of work under way, beside the state */
    int end;  /* columns that the text may have */
} Title;

/* False: so much has no room, or would hide where the run stands. */
static bool fill_title(const Screen *screen, const TitleForm *form, int width, Title *title)
{
    char time[48], words[2 * DUEL_NAME_MAX + 8], blend[LIST_MAX + 4] = "", value[LIST_MAX];
    const Settings *settings = screen_settings(screen);
    method_words_of(screen, words, sizeof words);
    /* "mu 0.5" where masses are not lumped; of a duel the runs' names say what differs */
    const Parameter *mixed = parameter_find("mpm.mass_blend");
    if (!screen_second_run(screen) && mixed && parameter_applies_to(settings, mixed) &&
        settings_transfer(settings)->mass_blend != mixed->neutral) {
        settings_spell(settings, mixed, value);
        snprintf(blend, sizeof blend, " mu %s", value);
    }
    const char *name = screen->scenario ? screen->scenario : "", *slash = strrchr(name, '/');
    name = slash && slash[1] ? slash + 1 : name;
    const Simulation *sim = screen_simulation(screen);
    const int stage = experiment_stage(screen->experiment);
    const bool running = screen_is_running(screen), duel = screen_second_run(screen) != NULL;
    const bool plain = screen_is_plain(screen);
    if (!plain && ((!form->brief && form->fewer > 0 && !running) || (form->no_stage && stage > 0) ||
                   (form->no_step && !running)))
        return false;
    /* which run is which comes before the scenario's name */
    if (form->headline && form->name != form->words && duel != form->words)
        return false;
    const char *gap = form->close ? " " : "  ";
    char *out = title->text;
    const size_t size = sizeof title->text;
    state_text(screen, form->brief, title->state, sizeof title->state);
    title->bar = screen->playback->state == STATE_COMPUTING && !form->brief;
    title->end = width - 1 - glyphs_columns(title->state) - 1 - (title->bar ? BAR_CELLS + 1 : 0);
    title->has_headline = form->headline;
    screen_shorter_time(screen, form->fewer, time, sizeof time);
    /* a page that sets something to a value of the student's own no longer shows what the scenario asks */
    const LessonShown *shown = screen->lesson;
    bool own = false;
    for (int v = 0; shown->lesson && v < shown->lesson->n_variants; v++)
        own |= shown->lesson->variants[v].page == shown->page;
    const char *headline = !own && settings->title[0] ? settings->title : settings->problem->title;
    snprintf(out, size, " %s%s", form->headline ? headline : "", form->headline ? gap : "");
    if (form->headline && !form->close)
        text_append(out, size, " ");
    if (form->name)
        text_append(out, size, "%s%s", name, gap);
    if (form->words)
        text_append(out, size, "%s%s%s", words, blend, gap);
    else if (form->name && *blend)
        text_append(out, size, "%s%s", blend + 1, gap);
    if (form->name && !form->close)
        text_append(out, size, " ");
    text_append(out, size, "%s", time);
    if (!form->no_step)
        text_append(out, size, "%sstep %ld", gap, experiment_step(screen->experiment));
    if (!form->no_stage)
        text_append(out, size, "%sstage %d/%d", gap, stage, sim->n_stages);
    return glyphs_columns(out) <= title->end;
}

static Title title_of(const Screen *screen, int width)
{
    static const TitleForm forms[] = {
        {true, false, true, true, 0, false, false, false},
        {true, false, true, true, 0, false, true, false},
        {true, false, true, false, 0, false, false, false},
        {true, false, true, false, 0, false, true, false},
        {true, false, true, false, 2, false, true, false},
        {true, false, false, true, 0, false, false, false},
        {true, false, false, true, 0, false, true, false},
        {true, false, false, false, 0, false, false, false},
        {true, false, false, false, 0, false, true, false},
        {true, false, false, false, 2, true, true, false},
        {true, true, false, false, 2, true, false, false},
        /* the word for a run that goes on is worth more than what stands still in it */
        {false, false, true, true, 0, false, false, false},
        {false, false, true, true, 2, false, false, false},
        {false, false, true, true, 2, true, false, false},
        {false, false, true, true, 4, true, true, false},
        {false, true, true, true, 0, false, false, false},
        {false, true, true, true, 2, false, false, false},
        {false, true, true, true, 2, true, false, false},
        {false, true, true, true, 4, true, false, false},
        /* between two steps, and while they run, the time says where we are */
        {false, true, true, true, 4, true, true, false},
        {false, true, true, true, 4, true, true, true},
        {false, true, true, false, 4, true, false, false},
        {false, true, false, false, 4, false, false, false},
        {false, true, false, false, 4, true, false, false},
    };
    /* the plain sheet says what the run is about, and when */
    static const TitleForm plain_forms[] = {
        {true, false, false, true, 0, false, true, true},  {true, false, false, false, 0, false, true, true},
        {true, false, false, false, 2, false, true, true}, {true, true, false, false, 4, true, true, true},
        {false, true, true, true, 4, true, true, true},    {false, true, false, false, 4, true, true, true},
    };
    Title title = {.has_headline = false};
    const bool plain = screen_is_plain(screen);
    const TitleForm *form = plain ? plain_forms : forms;
    const size_t count = plain ? sizeof plain_forms / sizeof *form : sizeof forms / sizeof *form;
    for (size_t i = 0; i < count; i++)
        if (fill_title(screen, &form[i], width, &title))
            return title;
    char time[48];
    screen_shorter_time(screen, 4, time, sizeof time);
    snprintf(title.text, sizeof title.text, " %s", time);
    return title;
}

bool title_has_headline(const Screen *screen, int width)
{
    return title_of(screen, width).has_headline;
}

void pane_title(const Screen *screen, Area area)
{
    const int width = area.rect.width;
    const Title title = title_of(screen, width);
    area_blank(area, 0, width, 0, STYLE_TITLE);
    int right = width - 1;
    if (title.bar) {
        int full = (int)(screen->playback->work_share * BAR_CELLS + 0.5);
        for (int i = 0; i < BAR_CELLS; i++)
            area_put(area, right - BAR_CELLS + i, 0, i < full ? 0x2588 : 0x2591, STYLE_TITLE);
        right -= BAR_CELLS + 1;
    }
    area_text_right(area, right, 0, title.state, STYLE_TITLE);
    area_text_whole(area, 0, 0, title.end, title.text, STYLE_TITLE);
}
