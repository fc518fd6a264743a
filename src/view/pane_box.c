/* The box at the bottom. Paused: the stage just done, its equation, what it read and wrote, the numbers of
 * the chosen particle and its nodes, the sum written out. Running: a caption. At the end: the summary. */
#include "base/text.h"
#include "view/panes.h"
#include "lab/summary.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { STAGE_LIST_WIDTH = 26, NODES_MAX = 8 };

/* --- caption while running ------------------------------------------------------------------------ */

/* A hint stands until its command was used, then the next one comes. */
static const char *hint_of(const Screen *screen)
{
    static const struct {
        CommandId id;
        const char *text;
    } hints[] = {
        {COMMAND_RUN_PAUSE, "Space pauses; then ] goes through the stages of one time step."},
        {COMMAND_RIGHT, "Left and Right change the marked parameter; the old curve stays behind, faint."},
        {COMMAND_REFERENCES, "e takes the exact and the predicted curve away: let the class guess first."},
        {COMMAND_VIEW_3, "3 shows the energies, 1 the fields along it; again: the next one."},
        {COMMAND_QUESTION, "t toggles what this scenario asks about."},
        {COMMAND_EXPORT, "x writes this run as CSV."},
        {COMMAND_HELP, "? explains the keys and what is solved."},
    };
    for (size_t i = 0; i < sizeof hints / sizeof *hints; i++) {
        const bool right = hints[i].id == COMMAND_RIGHT && screen->used & (1ull << COMMAND_LEFT);
        if (command_find(hints[i].id) && !(screen->used & (1ull << hints[i].id)) && !right)
            return hints[i].text;
    }
    return "";
}

static void line_words(const Screen *screen, char *out, size_t size)
{
    const bool ascii = screen->glyphs == GLYPHS_ASCII;
    int n;
    const Column *columns = experiment_columns(screen->experiment, &n);
    bool predicted = false, exact = false;
    for (int i = 0; i < n; i++) {
        predicted |= columns[i].kind == COLUMN_PREDICTED;
        exact |= columns[i].kind == COLUMN_EXACT;
    }
    const bool bar = experiment_settings(screen->experiment)->problem == PROBLEM_BAR;
    snprintf(out, size, "%s measured.", ascii ? "*" : "Solid:");
    if (predicted && shows_predicted(screen))
        append(out, size, "  %s predicted (this mesh).", ascii ? "-" : "Dashed:");
    if (exact && shows_exact(screen))
        append(out, size, "  %s",
               !bar    ? "Broken lines: beam theory."
               : ascii ? ". exact (continuum)."
                       : "Dotted: exact (continuum).");
}

/* Cuts a text to the whole sentences that fit: a caption never stops in mid-sentence. */
static void keep_sentences(char *text, int width, int rows)
{
    size_t end = strlen(text);
    while (end > 0 && paragraph_lines(width, text) > rows) {
        do
            end--;
        while (end > 0 && !(strchr(".?!", text[end - 1]) && text[end] == ' '));
        text[end] = '\0';
    }
}

/* " 4200 steps/s, about 9 s to the end ": known after the first frames, for pace and machine as they are. */
static void rate_text(const Screen *screen, char *out, size_t size)
{
    const Experiment *experiment = screen->experiment;
    const double rate = screen->rate * FRAMES_PER_SECOND;
    const long left = experiment_last_step(experiment) - experiment_step(experiment);
    char number[NUMBER_TEXT_MAX];
    out[0] = '\0';
    if (screen->state != STATE_RUNNING || !(rate > 0) || left < 1)
        return;
    const double seconds = (double)left / rate;
    text_rounded(number, rate, rate < 1000 ? 2 : 3);
    snprintf(out, size, " %s steps/s, ", number);
    if (seconds < 1)
        append(out, size, "less than 1 s to the end ");
    else if (seconds < 100)
        append(out, size, "about %.0f s to the end ", seconds);
    else
        append(out, size, "about %.0f min to the end ", ceil(seconds / 60));
}

static void draw_caption(const Screen *screen, Area area)
{
    const Settings *settings = experiment_settings(screen->experiment);
    const Simulation *sim = experiment_simulation(screen->experiment);
    const int width = area.rect.width - 2, rows = area.rect.height;
    const char *title = settings->title[0] ? settings->title : problem_title(settings->problem);
    area_rule(area, 0, title, STYLE_HEADING);
    char rate[64];
    rate_text(screen, rate, sizeof rate);
    if (5 + text_columns(title) + text_columns(rate) + 2 <= area.rect.width)
        area_text_right(area, area.rect.width - 1, 0, rate, STYLE_FAINT);

    int last = rows - 1, y = 1;
    char text[256];
    const char *hint = hint_of(screen);
    if (hint[0] && last > y)
        area_text(area, 1, last--, hint, STYLE_FAINT);
    int count;
    const Event *events = experiment_events(screen->experiment, &count);
    if (count > 0 && last > y) {
        char time[48];
        time_text(screen, sim->dt * (double)events[count - 1].step, time, sizeof time);
        snprintf(text, sizeof text, "%s: %s", time, events[count - 1].text);
        area_text(area, 1, last--, text, STYLE_NORMAL);
    } else if (experiment_advice(screen->experiment)[0] && last > y) {
        area_text(area, 1, last--, experiment_advice(screen->experiment), STYLE_WARNING);
    }
    line_words(screen, text, sizeof text);
    area_text(area, 1, y++, text, STYLE_NORMAL);
    char about[ABOUT_MAX];
    memcpy(about, settings->about, sizeof about);
    keep_sentences(about, width, last - y + 1);
    if (about[0])
        area_paragraph(area, 1, y, width, last - y + 1, about, STYLE_NORMAL);
}

/* --- summary -------------------------------------------------------------------------------------- */

static void draw_summary(const Screen *screen, Area area)
{
    const bool failed = screen->state == STATE_FAILED;
    const RunSummary *summary = &screen->summary;
    const Readout *readout = experiment_readout(screen->experiment);
    const int rows = area.rect.height;
    area_rule(area, 0, failed ? "The run stopped" : "The run is complete",
              failed ? STYLE_ERROR : STYLE_HEADING);
    int y = 1;
    Status status = {STATUS_DONE, ""};
    if (experiment_failed(screen->experiment, &status) && y < rows)
        y += area_paragraph(area, 1, y, area.rect.width - 2, 2, status.text, STYLE_ERROR);
    char time[48], number[NUMBER_TEXT_MAX], text[200];
    time_text(screen, experiment_time(screen->experiment), time, sizeof time);
    snprintf(text, sizeof text, "%ld steps to %s", experiment_step(screen->experiment), time);
    if (screen->summary_known && isfinite(summary->energy_drift)) {
        number_text(summary->energy_drift, 3, 10, number);
        append(text, sizeof text, "  energy %s%s %%%s", summary->energy_drift > 0 ? "+" : "", number,
               *summary_drift_base(summary) ? summary_drift_base(summary) : " against the start");
    }
    const int width = area.rect.width - 2;
    y += area_phrases(area, 1, y, width, rows - y, text, STYLE_NORMAL);
    if (readout->moving && readout->measured_known && y < rows) {
        const double unit = readout->is_period ? 1e-3 : 1;
        const char *tail = readout->is_period ? " ms" : "";
        snprintf(text, sizeof text, "%s measured %.5f", readout->is_period ? "period" : "frequency w",
                 readout->measured / unit);
        if (readout->predicted_known && shows_predicted(screen))
            append(text, sizeof text, "  predicted %.5f", readout->predicted / unit);
        if (readout->exact_known && shows_exact(screen))
            append(text, sizeof text, "  exact %.5f%s  %+.3f %%", readout->exact / unit, tail,
                   readout->is_period ? readout->error_period : readout->error_frequency);
        y += area_phrases(area, 1, y, width, rows - y, text, STYLE_NORMAL);
    }
    char crack[SUMMARY_MAX] = "", *line = crack;
    if (screen->summary_known)
        summary_crack_text(summary, crack);
    for (char *end; y < rows && (end = strchr(line, '\n')); line = end + 1) {
        *end = '\0';
        y += area_phrases(area, 1, y, width, rows - y, line, STYLE_NORMAL);
    }
    area_paragraph(area, 1, y, width, rows - y,
                   "Space runs it again, x writes it as CSV, ? explains what is solved.", STYLE_FAINT);
}

/* --- the stage box -------------------------------------------------------------------------------- */

static double field_at(const Simulation *sim, int field, size_t index)
{
    double value = NAN;
    sim->method->field(sim, field, index, 1, &value);
    return value;
}

/* Two values as texts of at most six digits, or as many more as it takes to tell them apart. */
static void pair_text(int least, double before, double now, char was[NUMBER_TEXT_MAX],
                      char is[NUMBER_TEXT_MAX])
{
    for (int digits = least; digits <= 9; digits++) {
        number_text(before, digits, 16, was);
        number_text(now, digits, 16, is);
        if (strcmp(was, is) != 0)
            return;
    }
}

/* "node 8  momentum 0 -> 0.25  velocity 0 -> 0.5": what a stage wrote into one thing, or what it read of it.
 * Returns the columns used. */
static int draw_numbers(const Screen *screen, Area area, int x, int y, int set, size_t index,
                        const char *words, bool written)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    char word[64], text[96];
    const int begin = x, digits = area.rect.width < 60 ? 4 : 5;
    snprintf(text, sizeof text, "%s %zu", sim->sets[set].name, index);
    x += area_text(area, x, y, text, STYLE_HEADING);
    while (next_word(&words, word, sizeof word)) {
        int field = stage_field(sim, set, word);
        if (field < 0)
            continue;
        const double value = field_at(sim, field, index);
        double before;
        char now[NUMBER_TEXT_MAX], was[NUMBER_TEXT_MAX];
        const bool known = written && experiment_field_before(screen->experiment, field, index, 1, &before);
        const bool changed = known && before != value && !(isnan(before) && isnan(value));
        number_text(value, digits, 12, now);
        if (changed)
            pair_text(digits, before, value, was, now);
        int columns = 2 + text_columns(word) + 1 + text_columns(now) + (changed ? text_columns(was) + 3 : 0);
        if (x + columns > area.rect.width)
            continue;
        x += 2;
        x += area_text(area, x, y, word, STYLE_FAINT) + 1;
        if (changed) {
            x += area_text(area, x, y, was, STYLE_NORMAL);
            x += area_text(area, x, y, " → ", STYLE_FAINT);
        }
        x += area_text(area, x, y, now, changed ? STYLE_CHANGED : STYLE_NORMAL);
    }
    return x - begin;
}

static void draw_stage_list(const Screen *screen, Area area, int current)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    for (int i = 0; i < sim->n_stages; i++) {
        area_print(area, 1, i,
                   i == current  ? STYLE_SELECTED
                   : i < current ? STYLE_NORMAL
                                 : STYLE_FAINT,
                   "%s%d %s", i == current ? "> " : "  ", i + 1, sim->stages[i].name);
    }
}

/* The nodes of the chosen particle, side by side as far as there is room. */
static void draw_nodes(const Screen *screen, Area area, int y, const char *words, bool written)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    Link links[NODES_MAX];
    size_t count = sim->method->links ? sim->method->links(sim, 0, screen->particle, links, NODES_MAX) : 0;
    count = count < NODES_MAX ? count : NODES_MAX;
    /* two nodes share the line; of more, the others are in the strip and in the table */
    const int share = area.rect.width / 2;
    for (size_t i = 0; i < count && i < 2; i++) {
        Area half = area_part(area, i == 0 ? 0 : share, 0, i == 0 ? share - 2 : share, area.rect.height);
        draw_numbers(screen, half, 0, y, 1, links[i].index, words, written);
    }
}

/* What the box holds, in the order of need: the equation, the sum with its numbers, what the stage wrote,
 * what it read from the other side, the sentence. Drawn from the top in the order of reading. */
static void draw_stage_body(const Screen *screen, Area area, int current, bool done)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    const Stage *stage = &sim->stages[current];
    const int width = area.rect.width, rows = area.rect.height;
    const bool node = screen->node_chosen && has_mesh(sim) && screen->node < sim->counts[1];
    const int set = node ? 1 : 0, target = stage_target(sim, stage);
    const size_t index = node ? screen->node : screen->particle < sim->counts[0] ? screen->particle : 0;
    const Flow flow = stage_flow(sim, stage);

    const char *equation = screen->glyphs == GLYPHS_ASCII ? stage->ascii : stage->equation;
    char sum[512] = "";
    if (done && sim->method->explain)
        sim->method->explain(sim, current, set, index, experiment_before(screen->experiment), sum,
                             sizeof sum);
    int room = rows - paragraph_lines(width, equation);
    int sum_lines = paragraph_lines(width, sum);
    /* a sum that is whole tells more than the numbers beside it */
    if (sum_lines > room)
        sum_lines = room > 1 ? room - 1 : room > 0 ? room : 0;
    room -= sum_lines;
    const bool written = done && room > 0 && (!node || target == 1);
    room -= written;
    const bool source = room > 0 && !node && (!done || flow == FLOW_TO_NODES || flow == FLOW_TO_PARTICLES);
    room -= source;
    const bool sentence = room >= paragraph_lines(width, stage->sentence);

    int y = area_paragraph(area, 0, 0, width, rows, equation, STYLE_NORMAL);
    if (sentence)
        y += area_paragraph(area, 0, y, width, rows - y, stage->sentence, STYLE_FAINT);
    const bool source_nodes = done ? flow == FLOW_TO_PARTICLES : flow == FLOW_NONE && target == 1;
    if (source && source_nodes)
        draw_nodes(screen, area, y++, stage->reads, false);
    else if (source)
        draw_numbers(screen, area, 0, y++, 0, index, stage->reads, false);
    if (written && node)
        draw_numbers(screen, area, 0, y++, 1, index, stage->writes, true);
    else if (written && target == 1)
        draw_nodes(screen, area, y++, stage->writes, true);
    else if (written)
        draw_numbers(screen, area, 0, y++, 0, index, stage->writes, true);
    area_paragraph(area, 0, y, width, sum_lines < rows - y ? sum_lines : rows - y, sum, STYLE_NORMAL);
}

static void draw_stage(const Screen *screen, Area area)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    bool done;
    const int current = box_stage(screen, &done);
    const Stage *stage = &sim->stages[current];
    char text[512];
    snprintf(text, sizeof text, done ? "Stage %d of %d: %s" : "Next: stage %d of %d: %s", current + 1,
             sim->n_stages, stage->name);
    area_rule(area, 0, text, is_focused(screen, PANE_BOX) ? STYLE_FOCUS : STYLE_HEADING);
    const int heading = 5 + text_columns(text);
    const int source = text_columns(stage->source) + 2;
    if (heading + source + 2 <= area.rect.width) {
        snprintf(text, sizeof text, " %s ", stage->source);
        area_text_right(area, area.rect.width - 1, 0, text, STYLE_FAINT);
    }
    snprintf(text, sizeof text, " %s → %s ", stage->reads, stage->writes);
    if (heading + 1 + text_columns(text) + source + 2 <= area.rect.width)
        area_text(area, heading + 1, 0, text, STYLE_FAINT);

    Area body = area_part(area, 0, 1, area.rect.width, area.rect.height - 1);
    if (body.rect.height >= sim->n_stages && area.rect.width >= 100) {
        draw_stage_list(screen, area_part(body, 0, 0, STAGE_LIST_WIDTH, body.rect.height),
                        done ? current : current - 1);
        for (int y = 0; y < body.rect.height; y++)
            area_put(body, STAGE_LIST_WIDTH, y, 0x2502, STYLE_FRAME);
        body = area_part(body, STAGE_LIST_WIDTH + 1, 0, body.rect.width, body.rect.height);
    }
    draw_stage_body(screen, area_part(body, 1, 0, body.rect.width - 2, body.rect.height), current, done);
}

void pane_box(const Screen *screen, Area area)
{
    if (screen->state == STATE_RUNNING || screen->state == STATE_COMPUTING)
        draw_caption(screen, area);
    else if ((screen->state == STATE_ENDED || screen->state == STATE_FAILED) &&
             experiment_stage(screen->experiment) == 0)
        draw_summary(screen, area);
    else
        draw_stage(screen, area);
}
