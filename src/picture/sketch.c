/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The display list behind a figure: it grows as a view draws, and without memory something is left out. */
#include "picture/sketch.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void sketch_open(Sketch *sketch)
{
    *sketch = (Sketch){0};
}

void sketch_close(Sketch *sketch)
{
    plot_close(&sketch->plot);
    free(sketch->marks);
    free(sketch->map);
    *sketch = (Sketch){0};
}

void sketch_heading(Sketch *sketch, const char *text)
{
    snprintf(sketch->heading, sizeof sketch->heading, "%s", text);
}

void sketch_axes(Sketch *sketch, const Axis *x, const Axis *y, const char *x_name)
{
    sketch->has_axes = true;
    sketch->plot.x = *x;
    sketch->plot.y = *y;
    snprintf(sketch->x_name, sizeof sketch->x_name, "%s", x_name);
}

void sketch_plot(Sketch *sketch, const Plot *plot)
{
    sketch->plot.lost |= plot->lost;
    for (int i = 0; i < plot->n_strokes; i++) {
        const Stroke *stroke = &plot->strokes[i];
        if (sketch->plot.n_strokes == STROKES_MAX)
            return;
        plot_begin(&sketch->plot, stroke->kind, stroke->line, stroke->style, stroke->rank, stroke->letter);
        sketch->plot.strokes[sketch->plot.n_strokes - 1].fill = stroke->fill;
        for (size_t k = 0; k < stroke->count; k++)
            plot_point(&sketch->plot, plot->points[2 * (stroke->first + k)],
                       plot->points[2 * (stroke->first + k) + 1]);
    }
}

SketchMap *sketch_map(Sketch *sketch, int nx, int ny)
{
    const size_t count = (size_t)nx * (size_t)ny;
    SketchMap *map = malloc(sizeof *map + 3 * count * sizeof(double));
    if (!map)
        return NULL;
    double *numbers = (double *)(map + 1);
    *map = (SketchMap){.nx = nx, .ny = ny, .x = numbers, .y = numbers + count, .value = numbers + 2 * count};
    free(sketch->map);
    return sketch->map = map;
}

void sketch_mark(Sketch *sketch, double x, double y, uint32_t glyph, Style style)
{
    if (sketch->n_marks == sketch->marks_room) {
        const size_t room = sketch->marks_room ? 2 * sketch->marks_room : 64;
        SketchMark *marks = realloc(sketch->marks, room * sizeof *marks);
        if (!marks) {
            sketch->plot.lost = true;
            return;
        }
        sketch->marks = marks;
        sketch->marks_room = room;
    }
    sketch->marks[sketch->n_marks++] = (SketchMark){x, y, glyph, style};
}

void sketch_rule(Sketch *sketch, double x, Style style)
{
    sketch_mark(sketch, x, sketch->plot.y.low, SKETCH_RULE, style);
}

void sketch_label(Sketch *sketch, const SketchLabel *label)
{
    if (sketch->n_labels < SKETCH_LABELS_MAX)
        sketch->labels[sketch->n_labels++] = *label;
}

void sketch_key(Sketch *sketch, const SketchKey *key)
{
    if (sketch->n_keys < SKETCH_KEYS_MAX)
        sketch->keys[sketch->n_keys++] = *key;
}

void sketch_note(Sketch *sketch, const char *text, bool faint)
{
    if (sketch->n_notes == SKETCH_NOTES_MAX || text[strspn(text, " ")] == '\0')
        return;
    SketchNote *note = &sketch->notes[sketch->n_notes++];
    note->faint = faint;
    snprintf(note->text, sizeof note->text, "%s", text);
}
