/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Room for the words of a drawing (places.h). */
#include "picture/places.h"

#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static double snapped(const Places *places, double place)
{
    return places->whole ? floor(place) : place;
}

/* In cells where marks and strokes have it. */
double places_across(const Places *places, double x)
{
    const int column = places->whole ? axis_column(&places->picture->plot.x, x, (int)places->width) : -1;
    return column >= 0 ? column : snapped(places, axis_share(&places->picture->plot.x, x) * places->width);
}

double places_down(const Places *places, double y)
{
    const int row = places->whole ? axis_row(&places->picture->plot.y, y, (int)places->height) : -1;
    return row >= 0 ? row : snapped(places, (1 - axis_share(&places->picture->plot.y, y)) * places->height);
}

static bool is_free(const Places *places, double left, double top, double right, double bottom)
{
    if (left < 0 || top < 0 || right > places->width || bottom > places->height ||
        places->n_taken == PLACES_MAX)
        return false;
    for (int i = 0; i < places->n_taken; i++)
        if (left < places->taken[i].right && right > places->taken[i].left && top < places->taken[i].bottom &&
            bottom > places->taken[i].top)
            return false;
    return true;
}

static void take(Places *places, double left, double top, double right, double bottom)
{
    if (places->n_taken < PLACES_MAX)
        places->taken[places->n_taken++] = (struct PlaceTaken){left, top, right, bottom};
}

/* --- labels ----------------------------------------------------------------------------------------- */

/* It ends at `most` at the latest, with air on both sides, so that two words stay two. */
static bool write_beside(Places *places, const PictureLabel *label, double across, double top,
                         const char *line, double most)
{
    const double columns = places->columns(places, line), air = places->gap / 2;
    const double beside = label->side > 0   ? across + places->gap
                          : label->side < 0 ? across + (places->whole ? 1 : 0) - places->gap - columns
                                            : snapped(places, across - (columns - 1) / 2);
    const double left = fmin(beside, most - columns);
    if (!is_free(places, left, top, left + columns, top + places->row))
        return false;
    take(places, left - air, top, left + columns + air, top + places->row);
    places->write(places, left, top, line, label->style);
    return true;
}

/* Its first line, or what stands below it, as far as there is room: that need not begin beside its thing. */
static void write_label(Places *places, const PictureLabel *label, bool below)
{
    char lines[sizeof label->text], named[sizeof label->text + 32], *rest;
    const double across = places_across(places, label->x);
    double top = fmax(0, places_down(places, label->y) - (places->whole ? 0 : places->row / 2));
    snprintf(lines, sizeof lines, "%s", label->text);
    char *line = strtok_r(lines, "\n", &rest);
    snprintf(named, sizeof named, "%s %s", label->thing ? label->thing : "", line ? line : "");
    if (line && !below && !(label->says_thing && write_beside(places, label, across, top, named, INFINITY)))
        write_beside(places, label, across, top, line, INFINITY);
    while (below && (line = strtok_r(NULL, "\n", &rest)) &&
           write_beside(places, label, across, top + places->row, line, places->width))
        top += places->row;
}

/* --- arrows ----------------------------------------------------------------------------------------- */

/* Some lines, in full or in brief, about a place of the arrow. */
static bool write_on(Places *places, const PictureArrow *arrow, double share, int lines, bool brief)
{
    const double x = arrow->from[0] + share * (arrow->to[0] - arrow->from[0]);
    const double y = arrow->from[1] + share * (arrow->to[1] - arrow->from[1]);
    const double middle = places_across(places, x), half_row = places->whole ? 0 : places->row / 2;
    const double top = places_down(places, y) - half_row - (lines - 1) * half_row;
    double left[PICTURE_ARROW_LINES], columns[PICTURE_ARROW_LINES], low = INFINITY, high = -INFINITY;
    for (int i = 0; i < lines; i++) {
        columns[i] = places->columns(places, brief ? arrow->brief[i] : arrow->text[i]);
        left[i] = snapped(places, middle - (columns[i] - 1) / 2);
        low = fmin(low, left[i]);
        high = fmax(high, left[i] + columns[i]);
    }
    if (!is_free(places, low, top, high, top + lines * places->row))
        return false;
    for (int i = 0; i < lines && places->write; i++)
        places->write(places, left[i], top + i * places->row, brief ? arrow->brief[i] : arrow->text[i],
                      arrow->style);
    take(places, low - places->gap / 2, top, high + places->gap / 2, top + lines * places->row);
    return true;
}

/* With all its lines or some, in full or, where that is needed or must be, in brief; false: nowhere. */
static bool write_arrow(Places *places, const PictureArrow *arrow, bool shorter)
{
    static const double away[] = {0, 0.1, -0.1, 0.2, -0.2, 0.3, -0.3};
    int most = 0;
    while (most < PICTURE_ARROW_LINES && arrow->text[most][0])
        most++;
    for (int brief = shorter; brief <= 1; brief++)
        for (int lines = most; lines > 0; lines--)
            for (size_t i = 0; i < sizeof away / sizeof *away; i++) {
                const double share = arrow->place + away[i];
                if (share > 0.05 && share < 0.95 && write_on(places, arrow, share, lines, brief))
                    return true;
            }
    return most == 0;
}

/* So many find room, the first in full and the others in brief or not. */
static int write_arrows(Places *places, bool brief)
{
    const Picture *picture = places->picture;
    int written = 0;
    bool first = true;
    for (int i = 0; i < picture->n_arrows; i++)
        if (picture->arrows[i].side == 0) {
            written += write_arrow(places, &picture->arrows[i], brief && !first);
            first = false;
        }
    return written;
}

/* Beside its thing, the first as a bare number: drawings of many arrows name in their heading what it is. */
static void write_side_words(Places *places, bool below)
{
    const Picture *picture = places->picture;
    for (int i = 0; i < picture->n_arrows; i++) {
        const PictureArrow *arrow = &picture->arrows[i];
        PictureLabel label = {
            .x = arrow->at[0], .y = arrow->at[1], .side = arrow->side, .style = arrow->style};
        if (arrow->side == 0)
            continue;
        snprintf(label.text, sizeof label.text, "%s", arrow->brief[0]);
        for (int line = 1; line < PICTURE_ARROW_LINES && arrow->text[line][0]; line++)
            text_append(label.text, sizeof label.text, "\n%s", arrow->text[line]);
        write_label(places, &label, below);
    }
}

/* --- the whole -------------------------------------------------------------------------------------- */

static void write_labels(Places *places, bool spare, bool below)
{
    const Picture *picture = places->picture;
    for (int i = 0; i < picture->n_labels; i++)
        if (picture->labels[i].spare == spare)
            write_label(places, &picture->labels[i], below);
}

void places_write(Places *places)
{
    const Picture *picture = places->picture;
    const double half = places->whole ? 0 : places->gap / 2, size = places->whole ? 1 : 0;
    for (size_t i = 0; i < picture->n_marks; i++) {
        const PictureMark *mark = &picture->marks[i];
        const double x = places_across(places, mark->x), y = places_down(places, mark->y);
        if (mark->kind == MARK_PLACE)
            take(places, x - half, y - half, x + half + size, y + half + size);
    }
    for (int i = 0; i < picture->plot.n_strokes; i++) { /* bars */
        const Stroke *stroke = &picture->plot.strokes[i];
        if (stroke->kind != STROKE_BAND || stroke->count == 0)
            continue;
        const double *points = picture->plot.points + 2 * stroke->first;
        double low[2] = {points[0], points[1]}, high[2] = {points[0], points[1]};
        for (size_t k = 1; k < stroke->count; k++)
            for (int d = 0; d < 2; d++) {
                low[d] = fmin(low[d], points[2 * k + (size_t)d]);
                high[d] = fmax(high[d], points[2 * k + (size_t)d]);
            }
        take(places, places_across(places, low[0]), places_down(places, high[1]),
             places_across(places, high[0]) + size, places_down(places, low[1]) + size);
    }
    for (int i = 0; i < picture->n_arrows && places->whole; i++) {
        const double x = places_across(places, picture->arrows[i].to[0]);
        const double y = places_down(places, picture->arrows[i].to[1]);
        take(places, x, y, x + size, y + size);
    }
    write_labels(places, false, false);
    write_side_words(places, false);
    /* Where in full one of them has no room, the first one says what the numbers of the others are. */
    Places tried = *places;
    tried.write = NULL;
    const int in_full = write_arrows(&tried, false);
    tried.n_taken = places->n_taken;
    write_arrows(places, write_arrows(&tried, true) > in_full);
    write_side_words(places, true);
    write_labels(places, false, true);
    write_labels(places, true, false);
    write_labels(places, true, true);
}
