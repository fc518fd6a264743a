/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The display list behind a figure: it grows as a view draws, and without memory something is left out. */
#include "picture/picture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void picture_open(Picture *picture)
{
    *picture = (Picture){0};
}

void picture_close(Picture *picture)
{
    plot_close(&picture->plot);
    free(picture->marks);
    free(picture->map);
    *picture = (Picture){0};
}

void picture_heading(Picture *picture, const char *text)
{
    snprintf(picture->heading, sizeof picture->heading, "%s", text);
}

void picture_axes(Picture *picture, const Axis *x, const Axis *y, const char *x_name)
{
    picture->has_axes = true;
    picture->plot.x = *x;
    picture->plot.y = *y;
    snprintf(picture->x_name, sizeof picture->x_name, "%s", x_name);
}

void picture_plot(Picture *picture, const Plot *plot)
{
    picture->plot.lost |= plot->lost;
    for (int i = 0; i < plot->n_strokes; i++) {
        const Stroke *stroke = &plot->strokes[i];
        if (picture->plot.n_strokes == STROKES_MAX)
            return;
        plot_begin(&picture->plot, stroke->kind, stroke->line, stroke->style, stroke->rank, stroke->letter);
        picture->plot.strokes[picture->plot.n_strokes - 1].fill = stroke->fill;
        for (size_t k = 0; k < stroke->count; k++)
            plot_point(&picture->plot, plot->points[2 * (stroke->first + k)],
                       plot->points[2 * (stroke->first + k) + 1]);
    }
}

PictureMap *picture_map(Picture *picture, int nx, int ny)
{
    const size_t count = (size_t)nx * (size_t)ny;
    PictureMap *map = malloc(sizeof *map + 3 * count * sizeof(double));
    if (!map)
        return NULL;
    double *numbers = (double *)(map + 1);
    *map = (PictureMap){.nx = nx, .ny = ny, .x = numbers, .y = numbers + count, .value = numbers + 2 * count};
    free(picture->map);
    return picture->map = map;
}

void picture_mark(Picture *picture, double x, double y, uint32_t glyph, Style style)
{
    if (picture->n_marks == picture->marks_room) {
        const size_t room = picture->marks_room ? 2 * picture->marks_room : 64;
        PictureMark *marks = realloc(picture->marks, room * sizeof *marks);
        if (!marks) {
            picture->plot.lost = true;
            return;
        }
        picture->marks = marks;
        picture->marks_room = room;
    }
    picture->marks[picture->n_marks++] = (PictureMark){x, y, glyph, style};
}

void picture_rule(Picture *picture, double x, Style style)
{
    picture_mark(picture, x, picture->plot.y.low, PICTURE_RULE, style);
}

void picture_label(Picture *picture, const PictureLabel *label)
{
    if (picture->n_labels < PICTURE_LABELS_MAX)
        picture->labels[picture->n_labels++] = *label;
}

void picture_key(Picture *picture, const PictureKey *key)
{
    if (picture->n_keys < PICTURE_KEYS_MAX)
        picture->keys[picture->n_keys++] = *key;
}

void picture_note(Picture *picture, const char *text, bool faint)
{
    if (picture->n_notes == PICTURE_NOTES_MAX || text[strspn(text, " ")] == '\0')
        return;
    PictureNote *note = &picture->notes[picture->n_notes++];
    note->faint = faint;
    snprintf(note->text, sizeof note->text, "%s", text);
}
