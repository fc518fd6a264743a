/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The box at the bottom. Of a duel: its readout, but within a time step. Running: a caption. At the end: the
 * summary. Paused: the stage box, pane_stage.c. */
#include "panes/panes.h"
#include "scenario/settings.h"
#include "views/inspector/inspector.h"
#include "views/view.h"
#include "answers/summary.h"
#include "views/plots/plots.h"
#include "base/math/functions.h"
#include "lessons/lesson_shown.h"
#include "run/playback.h"
#include "answers/comparison.h"
#include "scenario/parameters.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* --- caption while running ------------------------------------------------------------------------ */

/* A hint stands until its command was used, then the next one comes. */
static void hint_of(const Screen *screen, char *out, size_t size)
{
    char pictures[96], gloss[160], tried[120], question[200] = "";
    snprintf(pictures, sizeof pictures, "%d shows the energies, %d the fields; again: the next.",
             view_energies.digit, view_profile.digit);
    /* "v_cm: velocity of the centre of mass": what the run is judged by, "" if nothing is. */
    int n;
    const Column *columns = experiment_columns(screen->experiment, &n);
    const int column = experiment_column(screen->experiment, experiment_readout(screen->experiment)->column);
    gloss[0] = '\0';
    if (column >= 0)
        snprintf(gloss, sizeof gloss, "%s: %s", columns[column].quantity.label,
                 columns[column].quantity.meaning);
    if (screen_question(screen, tried, sizeof tried))
        snprintf(question, sizeof question, "t tries %s, which this scenario asks about.", tried);
    const struct {
        CommandId id;
        const char *text;
    } hints[] = {
        {gloss[0] ? COMMAND_RUN_PAUSE : COMMAND_NONE, gloss},
        {COMMAND_STAGE_FORWARD, "Space pauses; ] goes through one time step."},
        {COMMAND_RIGHT, "Left and Right change the marked parameter."},
        {COMMAND_INSPECT, "i, when paused, looks inside one particle."},
        {COMMAND_REFERENCES, "e hides the answers: let the class guess."},
        {command_of_digit(view_energies.digit), pictures},
        {question[0] ? COMMAND_QUESTION : COMMAND_NONE, question},
        {COMMAND_SHEET, "f shows one picture and the number it is about."},
        {COMMAND_EXPORT, "x writes this run as CSV."},
        {COMMAND_HELP, "? explains the keys and what is solved."},
    };
    const size_t n_hints = sizeof hints / sizeof *hints;
    size_t i = 0;
    for (; i < n_hints; i++) {
        const bool right = hints[i].id == COMMAND_RIGHT &&
                           (screen->lesson->open || command_set_has(screen->used, COMMAND_LEFT));
        const bool nothing = hints[i].id == COMMAND_INSPECT && !inspector_find(screen);
        if (command_find(hints[i].id) && !command_set_has(screen->used, hints[i].id) && !right && !nothing)
            break;
    }
    snprintf(out, size, "%s", i < n_hints ? hints[i].text : "");
}

/* "Solid measured, dotted exact (continuum)" as the plots over time draw them; in brief without what stands
 * in brackets. A bit for each style of line that is drawn. */
static unsigned line_words(const Screen *screen, bool brief, char *out, size_t size)
{
    static const char *const words[] = {
        [LINE_SOLID] = "solid", [LINE_DOTTED] = "dotted", [LINE_DASHED] = "dashed"};
    const bool ascii = screen->look.glyphs == GLYPHS_ASCII;
    unsigned drawn = 0;
    int n;
    const Column *columns = experiment_columns(screen->experiment, &n);
    snprintf(out, size, "%s measured", ascii ? "*" : "Solid");
    for (int i = 0; i < n; i++) {
        const PictureKey legend = time_plot_key(columns, i);
        const char letter[] = {legend.ascii, '\0'};
        if (columns[i].kind == COLUMN_MEASURED || columns[i].of < 0 || !time_plot_shows(screen, &columns[i]))
            continue;
        drawn |= 1u << legend.line;
        if (strstr(out, legend.name))
            continue;
        /* " (continuum)" behind the word "exact", and so on; beam theories have names of their own. */
        text_append(out, size, ", %s %s%s", ascii ? letter : words[legend.line], legend.name,
                    brief ? ""
                          : (strcmp(legend.name, "exact") == 0       ? " (continuum)"
                             : strcmp(legend.name, "predicted") == 0 ? " (this mesh)"
                                                                     : ""));
    }
    return drawn;
}

/* Takes the sentences with a word out of a text. */
static void drop_sentences(char *text, const char *word)
{
    char *to = text;
    for (char *from = text, *next; *from; from = next) {
        for (next = from; *next && !(strchr(".?!", *next) && (next[1] == ' ' || !next[1]));)
            next++;
        while (*next && (strchr(".?!", *next) || *next == ' '))
            next++;
        const size_t length = (size_t)(next - from);
        const char *found = strstr(from, word);
        if (found && found < next)
            continue;
        memmove(to, from, length);
        to += length;
    }
    *to = '\0';
}

/* " 4200 steps/s, about 9 s left ": known after the first frames, for pace and machine as they are, up to
 * where it stops. In brief the time alone. */
static void rate_text(const Screen *screen, bool brief, char *out, size_t size)
{
    const Experiment *experiment = screen->experiment;
    const double rate = screen->playback->rate * FRAMES_PER_SECOND;
    const long last = experiment_last_step(experiment), stop = screen->playback->until_step;
    const long left = (stop >= 0 && stop < last ? stop : last) - experiment_step(experiment);
    out[0] = '\0';
    if (!screen_is_running(screen) || !(rate > 0) || left < 1)
        return;
    const double seconds = (double)left / rate;
    const double grain = math_pow(10, floor(math_log10(rate)) - 1); /* two digits: the third would dance */
    snprintf(out, size,
             brief       ? " "
             : rate < 10 ? " %.1f steps/s, "
                         : " %.0f steps/s, ",
             round(rate / grain) * grain);
    if (seconds < 100)
        text_append(out, size, "about %.0f s left ", fmax(1, seconds));
    else
        text_append(out, size, "about %.0f min left ", ceil(seconds / 60));
}

/* What happened last or, as long as nothing has, what is advised; false: neither. */
static bool news_of(const Screen *screen, char *out, size_t size, Style *style)
{
    int count;
    const Event *events = experiment_events(screen->experiment, &count);
    while (count > 0 && events[count - 1].step > experiment_step(screen->experiment))
        count--; /* what is still to come, or to come again */
    *style = count > 0 ? STYLE_NORMAL : STYLE_WARNING;
    if (count > 0) {
        const double time = screen_simulation(screen)->dt * (double)events[count - 1].step;
        snprintf(out, size, "%s: %s", screen_time_text(screen, time).text, events[count - 1].text);
    } else {
        snprintf(out, size, "%s", experiment_advice(screen->experiment));
    }
    return out[0] != '\0';
}

static void draw_caption(const Screen *screen, Area area)
{
    const int width = area.rect.width - 2, rows = area.rect.height;
    char lines[256], news[512], hint[160];
    const unsigned drawn = line_words(screen, false, lines, sizeof lines);
    if (5 + glyphs_columns(lines) > area.rect.width)
        line_words(screen, true, lines, sizeof lines);
    const bool in_heading =
        title_has_headline(screen, area.canvas->width) && 5 + glyphs_columns(lines) <= area.rect.width;
    /* The heading says what the run is about, where the title line has no room; else what the lines are. */
    const Settings *settings = screen_settings(screen);
    const char *title = settings->title[0] ? settings->title : settings->problem->title;
    const char *heading = in_heading ? lines : title;
    char rate[64];
    area_rule(area, heading, STYLE_HEADING);
    rate_text(screen, false, rate, sizeof rate);
    if (5 + glyphs_columns(heading) + glyphs_columns(rate) + 2 > area.rect.width)
        rate_text(screen, true, rate, sizeof rate);
    if (5 + glyphs_columns(heading) + glyphs_columns(rate) + 2 <= area.rect.width)
        area_text_right(area, area.rect.width - 1, 0, rate, STYLE_FAINT);
    int last = rows - 1, y = 1;
    Style style;
    const bool has_news = news_of(screen, news, sizeof news, &style);
    const int needed = has_news ? area_paragraph_lines(width, news) : 0;
    if (!screen->lesson->open && last > y && needed < last) { /* what happens comes whole before any hint */
        hint_of(screen, hint, sizeof hint);
        const int begin = area_text(area, 1, last, hint, STYLE_FAINT);
        /* what else there is, for who has not asked for it yet */
        const bool lessons = !command_set_has(screen->used, COMMAND_LESSONS);
        const char *offer = command_set_has(screen->used, COMMAND_OPEN)
                                ? (lessons ? "New here?  T lessons" : "")
                                : (lessons ? "New here?  T lessons  o scenarios" : "New here?  o scenarios");
        if ((hint[0] ? 1 + begin : 0) + 2 + glyphs_columns(offer) < area.rect.width)
            area_text_right(area, area.rect.width - 1, last, offer, STYLE_NORMAL);
        last--;
    }
    if (!in_heading && last - needed >= y)
        y += area_paragraph(area, 1, y, width, last - needed - y + 1, lines, STYLE_NORMAL);
    if (has_news && last >= y) { /* from below */
        const int top = last - needed + 1 > y ? last - needed + 1 : y;
        last -= area_paragraph(area, 1, top, width, last - top + 1, news, style);
    }
    char about[ABOUT_MAX];
    /* What a scenario says of itself, but nothing of lines that are not drawn: their answer may be hidden. */
    memcpy(about, settings->about, ABOUT_MAX);
    if (!(drawn >> LINE_DOTTED & 1))
        drop_sentences(about, "otted");
    if (!(drawn >> LINE_DASHED & 1))
        drop_sentences(about, "ashed");
    /* the whole sentences that fit; the help has all of it */
    size_t end = strlen(about);
    while (end > 0 && area_paragraph_lines(width, about) > last - y + 1) {
        do
            end--;
        while (end > 0 && !(strchr(".?!", about[end - 1]) && about[end] == ' '));
        about[end] = '\0';
    }
    if (about[0])
        area_paragraph(area, 1, y, width, last - y + 1, about, STYLE_NORMAL);
}

/* --- tables of runs ----------------------------------------------------------------------------------- */

enum { LABEL_LEAST = 12, VALUE_LEAST = 7, GROUPS_MAX = 3 };

/* How wide the table of these rows is: the widest label and the widest value of each run. */
static void measure(const Comparison *rows, int count, int *label, int values[2])
{
    *label = LABEL_LEAST;
    values[0] = values[1] = VALUE_LEAST;
    for (int i = 0; i < count; i++) {
        *label = glyphs_columns(rows[i].label) > *label ? glyphs_columns(rows[i].label) : *label;
        for (int run = 0; run < 2; run++)
            if (glyphs_columns(rows[i].values[run]) > values[run])
                values[run] = glyphs_columns(rows[i].values[run]);
    }
}

/* "A usf", "B usl"; false: there is no room for it. */
static bool name_values(Comparison *row, const int values[2])
{
    for (int run = 0; run < 2; run++)
        if (glyphs_columns(row->values[run]) + 2 > values[run])
            return false;
    for (int run = 0; run < 2; run++) {
        char value[COMPARISON_TEXT_MAX];
        memcpy(value, row->values[run], sizeof value);
        snprintf(row->values[run], sizeof row->values[run], "%c %.*s", "AB"[run], COMPARISON_TEXT_MAX - 3,
                 value);
    }
    return true;
}

/* The readout of a duel. */
static void draw_duel(const Screen *screen, Area area)
{
    Comparison rows[COMPARISONS_MAX];
    /* What may be shown: no theory where a class is to guess. */
    const int all = comparison_of_duel(screen->duel, rows);
    int count = 0, label, values[2];
    for (int i = 0; i < all; i++)
        if (rows[i].kind == COLUMN_MEASURED || (rows[i].kind == COLUMN_EXACT && screen_shows_exact(screen)) ||
            (rows[i].kind == COLUMN_PREDICTED && screen_shows_predicted(screen)))
            rows[count++] = rows[i];
    const int height = area.rect.height - 1;
    enum { LETTERS = 16 }; /* of the last columns */
    const Style styles[2] = {STYLE_MEASURED, STYLE_SECOND};
    const Settings *settings = screen_settings(screen);
    /* the scenario's title asks what the duel is to answer */
    const char *heading = settings->title[0] ? settings->title : settings->problem->title;
    if (5 + glyphs_columns(heading) + LETTERS >= area.rect.width)
        heading = "Duel";
    measure(rows, count, &label, values);
    const int width = 1 + label + 1 + values[0] + 1 + values[1] + 1;
    int groups = area.rect.width / width;
    groups = groups > GROUPS_MAX ? GROUPS_MAX : groups < 1 ? 1 : groups;
    const bool own_row = count <= groups * (height - 1);
    if (!own_row && (count < 1 || !name_values(&rows[0], values)))
        heading = "Duel";
    area_rule(area, heading, screen->panes.focus == PANE_BOX ? STYLE_FOCUS : STYLE_HEADING);
    if (height < 1)
        return;
    const int each = height - own_row;
    if (count > groups * each)
        count = groups * each;
    const int used = (count + each - 1) / each, end = area.rect.x + 4 + glyphs_columns(heading);
    for (int i = 0; i < used; i++) {
        const int first = i * each, here = count - first < each ? count - first : each;
        const Area group = area_part(area, i * (area.rect.width / used), 0, width, area.rect.height);
        measure(rows + first, here, &label, values);
        const int ends[2] = {label + 1 + values[0], label + 1 + values[0] + 1 + values[1]};
        /* A and B head their columns; where the words of the heading reach so far the first values do. */
        for (int run = 0; run < 2; run++) {
            const char letter[] = {' ', "AB"[run], ' ', '\0'};
            if (own_row || group.rect.x + ends[0] > end + 1)
                area_text_right(group, ends[run] + 2, own_row, letter, styles[run]);
        }
        for (int y = 0; y < here; y++) {
            const int row = 1 + own_row + y;
            area_text(group, 1, row, rows[first + y].label, STYLE_NORMAL);
            for (int run = 0; run < 2; run++)
                area_text_right(group, ends[run] + 1, row, rows[first + y].values[run], styles[run]);
        }
    }
}

enum { NAME_COLUMNS = 26, VALUE_COLUMNS = 12 };

/* On top of the box. Returns its rows; 0: there are too few runs, or it has no room. */
static int draw_runs(const Screen *screen, Area area)
{
    ShownRun runs[RUNS_MAX];
    const int rows = pane_runs_rows(screen), n_runs = runs_of(screen, runs);
    const Readout *now = runs[n_runs - 1].readout;
    if (rows == 0 || area.rect.height < rows)
        return 0;
    const bool predicted = screen_shows_predicted(screen), exact = screen_shows_exact(screen);
    const double unit = now->is_period ? 1e-3 : 1; /* periods are given in ms */
    area_rule(area, "Runs in one picture", screen->panes.focus == PANE_BOX ? STYLE_FOCUS : STYLE_HEADING);
    /* In the rule above the rows, a space on each side. */
    const char *headings[] = {now->is_period ? "T meas, ms" : "ω measured", "predicted",
                              screen_problem(screen)->answer, "off"};
    int x = 1 + NAME_COLUMNS;
    for (int i = 0; i < 4; i++) {
        if ((i == 1 && !predicted) || (i >= 2 && !exact))
            continue;
        x += VALUE_COLUMNS;
        area_blank(area, x - glyphs_columns(headings[i]) - 1, x + 1, 0, STYLE_NORMAL);
        area_text_right(area, x, 0, headings[i], STYLE_NORMAL);
    }
    for (int i = 0; i < n_runs; i++) {
        /* "a cell size 1"; of the present run what differs from an earlier one. */
        char name[RUN_WORD_MAX + 4], word[RUN_WORD_MAX];
        snprintf(word, sizeof word, "%s", runs[i].word);
        if (runs[i].ghost < 0)
            for (int j = 0; j < n_runs && runs[j].ghost >= 0; j++)
                if (!settings_same(runs[i].settings, runs[j].settings))
                    settings_name(runs[i].settings, runs[j].settings, word, sizeof word);
        snprintf(name, sizeof name, "%c %s", runs[i].ghost >= 0 ? runs[i].letter : ' ', word);
        const int y = 1 + i;
        area_text(area_part(area, 1, y, NAME_COLUMNS, 1), 0, 0, name, runs[i].style);
        const Readout *readout = runs[i].readout;
        char text[32];
        double values[4];
        int count = 0;
        x = 1 + NAME_COLUMNS;
        values[count++] = readout->measured_known ? readout->measured / unit : NAN;
        if (predicted)
            values[count++] = readout->predicted_known ? readout->predicted / unit : NAN;
        if (exact)
            values[count++] = readout->exact_known ? readout->exact / unit : NAN;
        for (int k = 0; k < count; k++) {
            x += VALUE_COLUMNS;
            const NumberText number =
                k == 0 ? readout_text(readout, values[0] < 1 ? 5 : 4) : text_rounded(values[k], 5);
            area_text_right(area, x, y, isfinite(values[k]) ? number.text : "-", runs[i].style);
        }
        const double off = readout->is_period ? readout->error_period : readout->error_frequency;
        if (exact && readout->measured_known && readout->exact_known) {
            snprintf(text, sizeof text, "%+.*f %%", readout_error_decimals(readout, 2), off);
            area_text_right(area, x + VALUE_COLUMNS, y, text, runs[i].style);
        }
    }
    return rows;
}

/* --- summary, and the box ------------------------------------------------------------------------- */

static void draw_summary(const Screen *screen, Area area)
{
    const bool failed = screen->playback->state == STATE_FAILED;
    const RunSummary *summary = screen->summary;
    const Readout *readout = experiment_readout(screen->experiment);
    const int rows = area.rect.height;
    area_rule(area, failed ? "The run stopped" : "The run is complete", failed ? STYLE_ERROR : STYLE_HEADING);
    int y = 1;
    Status status = {STATUS_DONE, ""};
    if (experiment_failed(screen->experiment, &status) && y < rows)
        y += area_paragraph(area, 1, y, area.rect.width - 2, 2, status.text, STYLE_ERROR);
    char text[200];
    snprintf(text, sizeof text, "%ld steps to %s", experiment_step(screen->experiment),
             screen_time_text(screen, experiment_time(screen->experiment)).text);
    char energy[SUMMARY_MAX] = "";
    if (summary)
        summary_energy_text(summary, energy);
    text_append(text, sizeof text, "%s%s", *energy ? "  " : "", energy);
    const int width = area.rect.width - 2;
    y += area_phrases(area, 1, y, width, rows - y, text, STYLE_NORMAL);
    if (readout->moving && readout->measured_known && y < rows) {
        const double unit = readout->is_period ? 1e-3 : 1;
        const int decimals = readout_error_decimals(readout, 3);
        const char *tail = readout->is_period ? " ms" : "";
        const bool wrong = settings_mistake(screen_settings(screen)) != NULL;
        snprintf(text, sizeof text, "%s%s measured %s", readout->is_period ? "period" : "frequency ω",
                 wrong ? " with a mistake" : "", readout_text(readout, 5).text);
        if (readout->predicted_known && screen_shows_predicted(screen))
            text_append(text, sizeof text, wrong ? "  predicted (right code) %.5f" : "  predicted %.5f",
                        readout->predicted / unit);
        if (readout->exact_known && screen_shows_exact(screen))
            text_append(text, sizeof text, "  %s %.5f%s  %+.*f %%", screen_problem(screen)->answer,
                        readout->exact / unit, tail, decimals,
                        readout->is_period ? readout->error_period : readout->error_frequency);
        y += area_phrases(area, 1, y, width, rows - y, text, STYLE_NORMAL);
    }
    char found[SUMMARY_MAX] = "";
    if (summary)
        findings_text(summary->findings, summary->n_findings, screen_shows_exact(screen), found,
                      sizeof found);
    if (*found && y < rows)
        y += area_phrases(area, 1, y, width, rows - y, found, STYLE_NORMAL);
    char crack[SUMMARY_MAX] = "", *line = crack;
    if (summary)
        summary_crack_text(summary, "µs", crack);
    for (char *end; y < rows && (end = strchr(line, '\n')); line = end + 1) {
        *end = '\0';
        y += area_phrases(area, 1, y, width, rows - y, line, STYLE_NORMAL);
    }
    area_phrases(area, 1, y, width, rows - y,
                 "Space runs it again, x writes it as CSV.  T lessons, o other scenarios, ? what is solved.",
                 STYLE_NORMAL);
}

enum { BOX_LEAST = 4 }; /* rows in which there is more to be said than a heading */

bool screen_shows_diagnosis(const Screen *screen, int width, int height)
{
    const Rect box = screen_pane(screen, width, height, PANE_BOX);
    return screen->diagnosis[0] && !screen_is_inside(screen) &&
           box.height - pane_runs_rows(screen) >= BOX_LEAST;
}

void pane_box(const Screen *screen, Area area)
{
    const bool between = !screen_is_inside(screen);
    const int table = between ? draw_runs(screen, area) : 0; /* the ghosts are named in it */
    area = area_part(area, 0, table, area.rect.width, area.rect.height - table);
    if (table > 0 && area.rect.height < BOX_LEAST)
        return;
    if (screen->diagnosis[0] && between) {
        /* It stays until the series beside it goes. */
        area_rule(area, "Your code beside the right one   :overlay takes it away", STYLE_HEADING);
        area_paragraph(area, 1, 1, area.rect.width - 2, area.rect.height - 1, screen->diagnosis,
                       STYLE_NORMAL);
    } else if (screen_second_run(screen) && between)
        draw_duel(screen, area);
    else if (screen_is_running(screen) || screen->playback->state == STATE_COMPUTING)
        draw_caption(screen, area);
    else if ((screen->playback->state == STATE_ENDED || screen->playback->state == STATE_FAILED) &&
             experiment_stage(screen->experiment) == 0)
        draw_summary(screen, area);
    else
        pane_stage(screen, area);
    if (table > 0 || area.rect.height <= 0)
        return;
    /* The ghosts, in the longest free piece of the box's upper edge. */
    enum { RULE = 0x2500, LEAST = 6 };
    const Canvas *canvas = area.canvas;
    int begin = 0, columns = 0;
    for (int x = 0, run = 0; x < area.rect.width; x++) {
        const Cell *cell = &canvas->cells[area.rect.y * canvas->width + area.rect.x + x];
        run = cell->glyph == RULE ? run + 1 : 0;
        if (run > columns)
            columns = run, begin = x + 1 - run;
    }
    char text[160];
    runs_ghost_names(screen, columns - 4, text, sizeof text);
    if (columns >= LEAST && text[0]) {
        const int end = begin + columns - 1, width = glyphs_columns(text);
        area_text_right(area, end, 0, " ", STYLE_FRAME);
        area_text_right(area, end - 1, 0, text, STYLE_NORMAL);
        area_text_right(area, end - 1 - width, 0, " ", STYLE_FRAME);
    }
}
