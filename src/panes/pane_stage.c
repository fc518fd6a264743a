/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stage box: the stage just done (or, between steps, the next one), its equation, the sums of the chosen
 * particle or node with their numbers, and where there is room its sentence, the state of the thing, and the
 * list of all stages. */
#include "panes/panes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { LIST_WIDTH = 26, LEAST_BODY = 4, SUMS_MAX = 8192, FIELDS_TEXT_MAX = 64 };

/* What the box speaks of. */
typedef struct Subject {
    const Screen *screen;
    const Simulation *sim;
    int stage;
    bool done;
    int set;
    size_t index;
} Subject;

/* --- numbers of a thing --------------------------------------------------------------------------- */

/* "particle 25  stress 0.41517 → 0.41152 ...": on as many lines as it takes; without an area only counted. */
static int draw_fields(const Subject *subject, const Area *area, int width, int y, const int *fields,
                       int count)
{
    char name[64];
    snprintf(name, sizeof name, "%s %zu", subject->sim->sets[subject->set].name, subject->index);
    int x = glyphs_columns(name), line = 0;
    if (area)
        area_text(*area, 0, y, name, STYLE_HEADING);
    for (int i = 0; i < count; i++) {
        const int field = fields[i];
        const Field *row = &subject->sim->fields[field];
        /* its label, its unit and, where the stage changed it, what it was */
        char label[80], was[NUMBER_TEXT_MAX + 16] = "", arrow[4];
        double value = NAN, before;
        subject->sim->method->field(subject->sim, field, subject->index, 1, &value);
        snprintf(label, sizeof label, "%s ", row->quantity.label);
        const ScreenText unit = screen_unit_text(subject->screen, row);
        glyphs_plain(subject->screen->look.glyphs, "→", arrow, sizeof arrow);
        const bool changed =
            subject->done &&
            experiment_field_before(subject->screen->experiment, field, subject->index, 1, &before) &&
            before != value && !(isnan(before) && isnan(value));
        NumberText now = text_fitted(value, 5, 12);
        /* both with at least so many digits, or as many more as it takes to distinguish them */
        for (int digits = 5; changed && digits <= 9; digits++) {
            const NumberText old = text_fitted(before, digits, 16);
            now = text_fitted(value, digits, 16);
            snprintf(was, sizeof was, "%s %s ", old.text, arrow);
            if (strcmp(old.text, now.text) != 0)
                break;
        }
        const int columns = glyphs_columns(label) + glyphs_columns(was) + glyphs_columns(now.text) +
                            glyphs_columns(unit.text);
        if (x + 2 + columns > width) {
            line++;
            x = 0;
        }
        x += 2;
        if (area) {
            int at = x + area_text(*area, x, y + line, label, STYLE_FAINT);
            at += area_text(*area, at, y + line, was, STYLE_NORMAL);
            at += area_text(*area, at, y + line, now.text, changed ? STYLE_CHANGED : STYLE_NORMAL);
            area_text(*area, at, y + line, unit.text, STYLE_FAINT);
        }
        x += columns;
    }
    return line + 1;
}

static void add_field(int fields[], int *count, int field)
{
    for (int i = 0; i < *count; i++)
        if (fields[i] == field)
            return;
    if (field >= 0 && *count < FIELDS_TEXT_MAX)
        fields[(*count)++] = field;
}

/* --- the sums ------------------------------------------------------------------------------------- */

/* One line of a sum; on the last one of a sum its result is marked. */
static void draw_line(Area area, int y, const char *text, size_t length, bool last)
{
    char line[512];
    size_t used = 0;
    for (size_t i = 0; i < length && used + 1 < sizeof line; i++) {
        const bool held = strncmp(text + i, "\u00a0", 2) == 0; /* a no-break space has done its work */
        line[used++] = held ? ' ' : text[i];
        i += held;
    }
    line[used] = '\0';
    char *result = last ? strrchr(line, '=') : NULL;
    if (!result) {
        area_text(area, 0, y, line, STYLE_NORMAL);
        return;
    }
    const char first = result[1];
    result[1] = '\0';
    const int x = area_text(area, 0, y, line, STYLE_NORMAL);
    result[1] = first;
    area_text(area, x, y, result + 1, STYLE_CHANGED);
}

/* Lines of sums, each ended by '\n', broken where they must be, and drawn on an area; returns how many. */
static int sums_on(const Area *area, int width, int y, const char *sums)
{
    int used = 0;
    while (*sums != '\0') {
        const char *rest;
        const size_t length = glyphs_line(sums, width, &rest);
        if (area && y + used < area->rect.height)
            draw_line(*area, y + used, sums, length, rest[-1] == '\n');
        used++;
        sums = rest;
    }
    return used;
}

/* Puts each line behind the one before where both have room in one row. */
static void join_lines(char *sums, int width)
{
    int used = 0; /* columns of the row so far */
    for (char *line = sums, *end; *line; line = end + 1) {
        end = line + strcspn(line, "\n");
        const char kept = *end;
        *end = '\0';
        const int columns = glyphs_columns(line);
        *end = kept;
        if (line > sums && used + 3 + columns <= width) {
            memmove(line + 2, line, strlen(line) + 1);
            memcpy(line - 1, "   ", 3);
            end += 2;
            used += 3 + columns;
        } else
            used = columns;
        if (!kept)
            return;
    }
}

/* The sums with as many terms as there are rows for, or else in lines that share rows. Returns the rows. */
static int choose_sums(const Subject *subject, int width, int rows, char sums[SUMS_MAX])
{
    static const int terms[] = {0, 24, 16, 12, 8, 6, 5, 4, 3, 2};
    enum { CHOICES = sizeof terms / sizeof *terms };
    const Simulation *sim = subject->sim;
    int lines = rows + 1;
    sums[0] = '\0';
    if (!subject->done || !sim->method->explain)
        return 0;
    for (int i = 0; i < 2 * CHOICES && lines > rows; i++) {
        char text[SUMS_MAX / 2]; /* joined it is longer */
        sim->method->explain(sim, subject->stage, subject->set, subject->index,
                             experiment_before(subject->screen->experiment), terms[i % CHOICES], text,
                             sizeof text);
        glyphs_plain(subject->screen->look.glyphs, text, sums, SUMS_MAX);
        if (i >= CHOICES)
            join_lines(sums, width);
        lines = sums_on(NULL, width, 0, sums);
    }
    return lines;
}

/* "B: ..." on each line: what B has of the same thing then, the last lines that have room. Returns the rows.
 */
static int other_sums(const Subject *subject, int width, int room, char sums[SUMS_MAX])
{
    enum { TERMS = 4 };
    const Experiment *second = screen_second_run(subject->screen);
    char text[SUMS_MAX], plain[SUMS_MAX];
    sums[0] = '\0';
    if (!subject->done || !second ||
        !experiment_explain_beside(second, subject->screen->experiment, subject->stage, subject->set,
                                   subject->index, TERMS, text, sizeof text))
        return 0;
    glyphs_plain(subject->screen->look.glyphs, text, plain, sizeof plain);
    for (const char *line = plain; *line; line += strcspn(line, "\n") + 1)
        text_append(sums, SUMS_MAX, "B: %.*s\n", (int)strcspn(line, "\n"), line);
    int rows;
    while ((rows = sums_on(NULL, width, 0, sums)) > room) {
        const char *next = sums + strcspn(sums, "\n") + 1;
        memmove(sums, next, strlen(next) + 1);
    }
    return rows;
}

/* --- the box -------------------------------------------------------------------------------------- */

/* What a wrong code has in an equation, over the paragraph of so many lines as it was drawn: from mark to
 * mark, also where a line was broken between them. */
static void mark_what_differs(const Subject *subject, Area area, int lines, const char *equation)
{
    const bool ascii = subject->screen->look.glyphs == GLYPHS_ASCII;
    const char *open = ascii ? STAGE_WRONG_OPEN_ASCII : STAGE_WRONG_OPEN;
    const char *close = ascii ? STAGE_WRONG_CLOSE_ASCII : STAGE_WRONG_CLOSE;
    bool wrong = false;
    for (int y = 0; y < lines && *equation; y++) {
        char line[512], part[512];
        const char *rest;
        const size_t length = glyphs_line(equation, area.rect.width, &rest);
        snprintf(line, sizeof line, "%.*s", (int)length, equation);
        for (char *at = line; *at;) {
            char *from = wrong ? at : strstr(at, open);
            if (!from)
                break;
            char *to = strstr(wrong ? from : from + strlen(open), close);
            wrong = to == NULL; /* it goes on in the next line */
            to = to ? to + strlen(close) : line + strlen(line);
            snprintf(part, sizeof part, "%.*s", (int)(to - from), from);
            const char kept = *from;
            *from = '\0';
            const int x = glyphs_columns(line);
            *from = kept;
            area_text(area, x, y, part, STYLE_ERROR);
            at = to;
        }
        equation = rest;
    }
}

/* In the order of need: the sums, the equation, the sentence, the state. Drawn in the order of reading. */
static void draw_body(const Subject *subject, Area area)
{
    const Stage *stage = &subject->sim->stages[subject->stage];
    const int width = area.rect.width, rows = area.rect.height;
    char sums[SUMS_MAX], equation[512];
    glyphs_plain(subject->screen->look.glyphs, stage->equation, equation, sizeof equation);
    int sum_rows = choose_sums(subject, width, rows - 1, sums);
    const bool beside = screen_second_run(subject->screen) != NULL; /* a line for B at least */
    if (sum_rows + area_paragraph_lines(width, equation) + beside >
        rows) /* its first line says what the sums are of */
        equation[strcspn(equation, "\n")] = '\0';
    int room = rows - sum_rows - area_paragraph_lines(width, equation);
    if (room < 0) {
        equation[0] = '\0';
        room = rows - sum_rows;
    }
    char others[SUMS_MAX];
    const int other_rows = other_sums(subject, width, room, others);
    room -= other_rows;
    /* The fields that the stage names of the subject's set; once it is done those of its table too. */
    int fields[FIELDS_TEXT_MAX], n_fields = 0;
    const char *words = subject->done ? stage->writes : stage->reads;
    const bool named = !subject->done || subject->set == flow_target(subject->sim, stage);
    for (char word[64]; named && text_next_word(&words, word, sizeof word);)
        add_field(fields, &n_fields, simulation_find_field(subject->sim, subject->set, word));
    for (int i = 0; subject->done && i < subject->sim->n_fields; i++)
        if (subject->sim->fields[i].set == subject->set && subject->sim->fields[i].in_table)
            add_field(fields, &n_fields, i);
    const int sentence_rows = area_paragraph_lines(width, stage->sentence);
    int field_rows =
        subject->done || n_fields > 0 ? draw_fields(subject, NULL, width, 0, fields, n_fields) : 0;
    /* of a stage that is still to come its fields are needed more than its sentence */
    if (!subject->done && field_rows <= room)
        room -= field_rows;
    else if (!subject->done)
        field_rows = 0;
    const bool sentence = room >= sentence_rows;
    room -= sentence ? sentence_rows : 0;
    if (subject->done && field_rows > room)
        field_rows = 0;

    int y = equation[0] ? area_paragraph(area, 0, 0, width, rows, equation, STYLE_NORMAL) : 0;
    mark_what_differs(subject, area, y, equation);
    if (sentence)
        y += area_paragraph(area, 0, y, width, rows - y, stage->sentence, STYLE_FAINT);
    y += sums_on(&area, width, y, sums);
    if (other_rows > 0)
        y += sums_on(&area, width, y, others);
    if (field_rows > 0)
        draw_fields(subject, &area, width, y, fields, n_fields);
}

/* All stages, a pointer at the one that the box speaks of; where there is room, each with what it does. */
static void draw_list(const Subject *subject, Area area)
{
    const Simulation *sim = subject->sim;
    for (int i = 0; i < sim->n_stages; i++) {
        const bool here = i == subject->stage;
        const Style style = here ? STYLE_SELECTED : i < subject->stage ? STYLE_NORMAL : STYLE_FAINT;
        area_print(area, 1, i, style, "%s%d %s", here ? "> " : "  ", i + 1, sim->stages[i].name);
        char line[512];
        glyphs_plain(subject->screen->look.glyphs, sim->stages[i].equation, line, sizeof line);
        line[strcspn(line, "\n")] = '\0';
        const char *gap = strstr(line, "  ");
        Area rest = area_part(area, LIST_WIDTH + 2, i, area.rect.width, 1);
        if (glyphs_columns(line) <= rest.rect.width || (gap && gap - line <= rest.rect.width))
            area_phrases(rest, 0, 0, rest.rect.width, 1, line, STYLE_FAINT);
    }
}

/* "stress, strain, density": the labels of fields, each once. */
static void labels_of(const Simulation *sim, const char *words, char *out, size_t size)
{
    char word[64];
    out[0] = '\0';
    while (text_next_word(&words, word, sizeof word)) {
        int field = -1;
        for (int set = 0; field < 0 && set < sim->n_sets; set++)
            field = simulation_find_field(sim, set, word);
        text_append(out, size, "%s%s", *out ? ", " : "",
                    field >= 0 ? sim->fields[field].quantity.label : word);
    }
}

void pane_stage(const Screen *screen, Area area)
{
    const Simulation *sim = screen_simulation(screen);
    Subject subject = {.screen = screen, .sim = sim};
    subject.stage = screen_box_stage(screen, &subject.done);
    subject.set = screen->chosen.is_node && simulation_has(sim, HAS_MESH);
    const size_t chosen = subject.set ? screen->chosen.node : screen->chosen.particle,
                 count = sim->counts[subject.set];
    subject.index = chosen < count ? chosen : count - 1;
    const Stage *stage = &sim->stages[subject.stage];
    char text[128], reads[256], writes[256], flow[600], plain[600];
    const bool both = screen_second_run(screen) != NULL;
    snprintf(text, sizeof text, "%s%s %d of %d: %s", both ? "A: " : "",
             !subject.done ? both ? "next, stage" : "Next: stage"
             : both        ? "stage"
                           : "Stage",
             subject.stage + 1, sim->n_stages, stage->name);
    area_rule(area, text, screen->panes.focus == PANE_BOX ? STYLE_FOCUS : STYLE_HEADING);
    const int heading = 5 + glyphs_columns(text), source = glyphs_columns(stage->source) + 2;
    if (heading + source + 2 <= area.rect.width) {
        snprintf(text, sizeof text, " %s ", stage->source);
        area_text_right(area, area.rect.width - 1, 0, text, STYLE_FAINT);
    }
    labels_of(sim, stage->reads, reads, sizeof reads);
    labels_of(sim, stage->writes, writes, sizeof writes);
    snprintf(flow, sizeof flow, " %s → %s ", reads, writes);
    glyphs_plain(screen->look.glyphs, flow, plain, sizeof plain);
    if (heading + 1 + glyphs_columns(plain) + source + 2 <= area.rect.width)
        area_text(area, heading + 1, 0, plain, STYLE_FAINT);
    Area body = area_part(area, 0, 1, area.rect.width, area.rect.height - 1);
    const bool zoomed = screen->panes.zoomed && screen->panes.focus == PANE_BOX;
    const int stages = sim->n_stages, width = body.rect.width;
    if (width >= 100 && body.rect.height >= stages) {
        draw_list(&subject, area_part(body, 0, 0, LIST_WIDTH, body.rect.height));
        for (int y = 0; y < body.rect.height; y++)
            area_put(body, LIST_WIDTH, y, 0x2502, STYLE_FRAME);
        body = area_part(body, LIST_WIDTH + 1, 0, width, body.rect.height);
    } else if (zoomed && body.rect.height >= stages + 1 + LEAST_BODY) {
        /* above the sums, which need the whole width */
        draw_list(&subject, area_part(body, 0, 0, width, stages));
        area_rule(area_part(body, 0, stages, width, 1), "", STYLE_FRAME);
        body = area_part(body, 0, stages + 1, width, body.rect.height);
    }
    draw_body(&subject, area_part(body, 1, 0, body.rect.width - 2, body.rect.height));
}
