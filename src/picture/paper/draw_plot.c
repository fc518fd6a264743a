/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A picture with axes on paper: frame, ticks, strokes cut at the frame, marks, labels and legend. */
#include "picture/paper/paper.h"
#include "picture/places.h"

#include "base/math/functions.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define TICK    3.0   /* length of a tick */
#define GAP     3.0   /* between a tick and its label */
#define DENSE   3.0   /* points of a curve in one point of the page from which it is drawn thinner */
#define NOISE   100.0 /* times that a curve goes up and down for its way across: then it fills an area */
#define BETWEEN 6.0   /* least distance of two labels beside each other */

#define SMALL 250.0 /* a plot narrower than this has smaller marks */
#define NEAR  0.05  /* share of the axis within which nodes share a sign */

enum {
    SIGN_SUPPORT = 0x25b2,
    SIGN_LOAD = 0x25bc,
    SIGN_ROLLER = 0x25cb,
    SIGN_DOT = 0x25cf, /* a probe, the tip of a crack */
    SIGN_PROBE = '+',  /* of a plate */
    SIGN_NODE = 0x253c,
    SIGN_PLACE = 0xb7,
    SIGN_GIVEN = 0x25c6, /* of a mesh; one that takes or gives */
    SIGN_LEFT = 0x2190   /* then up, right, down: loads of a plate */
};                       /* as on the screen; else it is a letter */

typedef struct Frame {
    Paper *paper;
    const Picture *picture;
    Box box; /* of the curves */
} Frame;

/* --- places ---------------------------------------------------------------------------------------- */

static double x_of(const Frame *frame, double value)
{
    return frame->box.x + axis_share(&frame->picture->plot.x, value) * frame->box.width;
}

static double y_of(const Frame *frame, double value)
{
    return frame->box.y + (1 - axis_share(&frame->picture->plot.y, value)) * frame->box.height;
}

static double range_of(const Axis *axis)
{
    return axis->high - axis->low;
}

/* What lies far outside is cut off: a file has room for a few digits. */
static double bounded(double place, double low, double size)
{
    return fmin(fmax(place, low - 4 * size), low + 5 * size);
}

/* --- axes ------------------------------------------------------------------------------------------ */

static void straight(Paper *paper, double x0, double y0, double x1, double y1, Colour colour, double width)
{
    const double points[] = {x0, y0, x1, y1};
    paper->kind->line(paper, points, 2, &(Pencil){.colour = colour, .width = width});
}

static void tick_label(const Axis *axis, double tick, char *out, size_t size)
{
    char text[TICK_TEXT_MAX];
    axis_label(axis, tick, text);
    if (axis->scale == SCALE_LOG) /* powers of ten, all in one way */
        snprintf(text, sizeof text, "1e%ld", lround(math_log10(tick)));
    ink_words(text, out, size);
}

static void draw_grid(const Frame *frame)
{
    const Plot *plot = &frame->picture->plot;
    const Box *box = &frame->box;
    double ticks[TICKS_MAX];
    int count = axis_ticks(&plot->x, ticks);
    for (int i = 0; i < count; i++)
        straight(frame->paper, x_of(frame, ticks[i]), box->y, x_of(frame, ticks[i]), box->y + box->height,
                 GRID, 0.4);
    count = axis_ticks(&plot->y, ticks);
    for (int i = 0; i < count; i++)
        straight(frame->paper, box->x, y_of(frame, ticks[i]), box->x + box->width, y_of(frame, ticks[i]),
                 GRID, 0.4);
    if (plot->y.low < 0 && plot->y.high > 0)
        straight(frame->paper, box->x, y_of(frame, 0), box->x + box->width, y_of(frame, 0), 0x9a9a9a, 0.5);
}

static void draw_axes(const Frame *frame, double left)
{
    const Picture *picture = frame->picture;
    const Box *box = &frame->box;
    Paper *paper = frame->paper;
    const double right = box->x + box->width, bottom = box->y + box->height;
    Type type = {.size = SIZE_TICKS, .align = ALIGN_RIGHT};
    double ticks[TICKS_MAX], used = -INFINITY;
    char text[PICTURE_TEXT_MAX];
    int count = axis_ticks(&picture->plot.y, ticks);
    for (int i = 0; i < count; i++) {
        const double y = y_of(frame, ticks[i]);
        straight(paper, box->x - TICK, y, box->x, y, BLACK, 0.6);
        tick_label(&picture->plot.y, ticks[i], text, sizeof text);
        paper->kind->text(paper, box->x - TICK - GAP, y + 0.36 * SIZE_TICKS, text, &type);
    }
    type.align = ALIGN_CENTRE;
    count = axis_ticks(&picture->plot.x, ticks);
    for (int i = 0; i < count; i++) {
        const double x = x_of(frame, ticks[i]);
        straight(paper, x, bottom, x, bottom + TICK, BLACK, 0.6);
        tick_label(&picture->plot.x, ticks[i], text, sizeof text);
        const double half = draw_words_width(text, &type) / 2;
        if (x - half < used)
            continue;
        used = x + half + BETWEEN;
        paper->kind->text(paper, x, bottom + TICK + SIZE_TICKS, text, &type);
    }
    const double corners[] = {box->x, box->y, box->x, bottom, right, bottom, right, box->y, box->x, box->y};
    paper->kind->line(paper, corners, 5, &(Pencil){.colour = BLACK, .width = 0.6});

    Type name = {.size = SIZE_WORDS, .align = ALIGN_CENTRE};
    draw_words(paper, box->x + box->width / 2, bottom + TICK + SIZE_TICKS + 11, picture->x_name, &name);
    if (picture->map) { /* whose heading stands at its colours */
        char scale[TICK_TEXT_MAX];
        axis_scale_text(&picture->plot.y, picture->unit, scale);
        axis_name(picture->name, scale, text, sizeof text);
    } else
        snprintf(text, sizeof text, "%s", picture->heading);
    name.upwards = true;
    name.size = fmin(SIZE_WORDS, SIZE_WORDS * box->height / draw_words_width(text, &name));
    draw_words(paper, left + SIZE_WORDS, box->y + box->height / 2, text, &name);
}

/* --- strokes --------------------------------------------------------------------------------------- */

/* The letter of an earlier run is known by the legend: ghosts among the strokes come in the same order. */
Pencil draw_pencil(const Picture *picture, int index)
{
    const Stroke *strokes = picture->plot.strokes;
    char letter = 0;
    int earlier = 0;
    for (int i = 0; i < index; i++)
        earlier += strokes[i].rank == RANK_GHOST && ink_is_ghost(strokes[i].style);
    for (int i = 0; i < picture->n_keys && !letter; i++)
        if (picture_run_of(&picture->keys[i]) && ink_is_ghost(picture->keys[i].style) && earlier-- == 0)
            letter = picture_run_of(&picture->keys[i]);
    return ink_pencil(strokes[index].style, strokes[index].line, letter);
}

static void draw_stroke(const Frame *frame, int index, bool noise, double *places)
{
    const Stroke *stroke = &frame->picture->plot.strokes[index];
    const double *points = frame->picture->plot.points + 2 * stroke->first;
    const Box *box = &frame->box;
    Paper *paper = frame->paper;
    Pencil pencil = draw_pencil(frame->picture, index);
    if (noise)
        pencil.colour = ink_pale(pencil.colour);
    if ((double)stroke->count > DENSE * box->width)
        pencil.width *= noise ? 0.5 : 0.7;
    if (stroke->wall) {
        /* Just outside the body, with a lip at its end. */
        const double row = stroke->wall / frame->picture->map->scale[1];
        for (size_t j = 1; j < stroke->count; j++) {
            const double *from = points + 2 * j - 2, *to = points + 2 * j;
            const double x = x_of(frame, to[0]), y = y_of(frame, to[1] + 0.3 * row);
            const double corners[] = {x_of(frame, from[0]), y, x, y, x, y_of(frame, to[1] + 0.9 * row)};
            if (!isnan(from[0]) && !isnan(to[0]))
                paper->kind->line(paper, corners, 3, &pencil);
        }
    } else if (stroke->kind == STROKE_LINE) {
        size_t count = 0;
        for (size_t i = 0; i <= stroke->count; i++) {
            if (i < stroke->count && isfinite(points[2 * i]) && isfinite(points[2 * i + 1])) {
                places[2 * count] = bounded(x_of(frame, points[2 * i]), box->x, box->width);
                places[2 * count + 1] = bounded(y_of(frame, points[2 * i + 1]), box->y, box->height);
                count++;
                continue;
            }
            if (count > 1)
                paper->kind->line(paper, places, count, &pencil);
            count = 0;
        }
    } else if (stroke->kind == STROKE_BAND) {
        /* Lower edge there and upper edge back. */
        const size_t pairs = stroke->count / 2;
        for (size_t i = 0; i < 2 * pairs; i++) {
            const size_t at = i % 2 == 0 ? i / 2 : 2 * pairs - 1 - i / 2;
            places[2 * at] = bounded(x_of(frame, points[2 * i]), box->x, box->width);
            places[2 * at + 1] = bounded(y_of(frame, points[2 * i + 1]), box->y, box->height);
        }
        if (pairs >= 2) {
            paper->kind->fill(paper, places, 2 * pairs, ink_fill(stroke->style, stroke->fill));
            paper->kind->line(paper, places + 2 * pairs, pairs,
                              &(Pencil){.colour = ink_of(stroke->style), .width = 0.5});
        }
    } else
        for (size_t k = 0; k < stroke->count; k++)
            paper->kind->disc(paper, x_of(frame, points[2 * k]), y_of(frame, points[2 * k + 1]), 1.2,
                              pencil.colour, NULL);
}

/* By rank, noise below all; a broken line lies over a whole one, which shows between its dashes. */
static void draw_strokes(const Frame *frame)
{
    const Plot *plot = &frame->picture->plot;
    double *places = malloc((plot->n_points + 1) * 2 * sizeof *places);
    bool noise[STROKES_MAX];
    if (!places)
        return;
    for (int i = 0; i < plot->n_strokes; i++) {
        /* A curve so fast that it fills an area would hide all others: it lies behind them, and paler. */
        const Stroke *stroke = &plot->strokes[i];
        const double *points = frame->picture->plot.points + 2 * stroke->first;
        double way = 0;
        for (size_t j = 1; j < stroke->count && stroke->kind == STROKE_LINE; j++) {
            const double up = fabs(y_of(frame, points[2 * j + 1]) - y_of(frame, points[2 * j - 1]));
            way += isfinite(up) ? fmin(up, frame->box.height) : 0;
        }
        noise[i] = way > NOISE * frame->box.width;
    }
    frame->paper->kind->clip(frame->paper, &frame->box);
    const Picture *picture = frame->picture;
    const Box *box = &frame->box;
    for (size_t i = 0; i < picture->n_marks; i++) {
        const PictureMark *mark = &picture->marks[i];
        const double x = x_of(frame, mark->x);
        if (mark->kind != MARK_RULE)
            continue;
        straight(frame->paper, x, box->y, x, box->y + box->height, ink_of(mark->style), 0.5);
        if (mark->word && mark->word[1])
            draw_words(frame->paper, x + GAP, box->y + SIZE_TICKS + 1, mark->word,
                       &(Type){.size = SIZE_TICKS, .colour = ink_of(mark->style)});
    }
    for (int broken = 0; broken <= 1; broken++)
        for (int rank = RANK_BAND - 1; rank <= RANK_MARK; rank++)
            for (int i = 0; i < plot->n_strokes; i++)
                if (plot->strokes[i].count > 0 && !plot->strokes[i].coarse &&
                    broken == (frame->picture->plot.strokes[i].kind == STROKE_LINE &&
                               draw_pencil(frame->picture, i).dashes[0] > 0) &&
                    rank == (noise[i] ? RANK_BAND - 1 : plot->strokes[i].rank))
                    draw_stroke(frame, i, noise[i], places);
    frame->paper->kind->clip(frame->paper, NULL);
    free(places);
}

/* --- marks ----------------------------------------------------------------------------------------- */

/* Its middle is the place. */
static void draw_arrow(const Frame *frame, uint32_t glyph, double x, double y, double size)
{
    static const double ways[][2] = {{-1, 0}, {0, -1}, {1, 0}, {0, 1}};
    const double *way = ways[glyph - SIGN_LEFT], half = 4.5 * size, wide = 2.2 * size;
    const double neck_x = x + 0.1 * half * way[0], neck_y = y + 0.1 * half * way[1];
    const double shaft[] = {x - half * way[0], y - half * way[1], neck_x, neck_y};
    const double head[] = {x + half * way[0],      y + half * way[1],      neck_x + wide * way[1],
                           neck_y + wide * way[0], neck_x - wide * way[1], neck_y - wide * way[0]};
    frame->paper->kind->line(frame->paper, shaft, 2, &(Pencil){.colour = BLACK, .width = 1.1 * size});
    frame->paper->kind->fill(frame->paper, head, 3, BLACK);
}

/* Of a node of a mesh: where it is, or what it has as a bar beside it. */
static void draw_node(const Frame *frame, const PictureMark *mark, double x, double y, double size)
{
    const double half = (mark->glyph == SIGN_PLACE ? 1 : 2.5) * size, right = x + 4 * size * mark->side[0];
    const double bar[] = {right - size, y,
                          right + size, y,
                          right + size, y - 8 * size * mark->share,
                          right - size, y - 8 * size * mark->share};
    const double rhomb[] = {x - half, y, x, y - half, x + half, y, x, y + half};
    if (mark->kind == MARK_BAR)
        frame->paper->kind->fill(frame->paper, bar, 4, ink_of(mark->style));
    else if (mark->glyph == SIGN_GIVEN)
        frame->paper->kind->fill(frame->paper, rhomb, 4, ink_of(mark->style));
    else {
        straight(frame->paper, x - half, y, x + half, y, ink_of(mark->style), 0.6);
        straight(frame->paper, x, y - half, x, y + half, ink_of(mark->style), 0.6);
    }
}

static size_t draw_signs(const Frame *frame, size_t first)
{
    const Picture *picture = frame->picture;
    const PictureMark *begin = &picture->marks[first];
    const uint32_t glyph = begin->glyph;
    const bool spreads = glyph == SIGN_SUPPORT || glyph == SIGN_ROLLER || glyph == SIGN_LOAD;
    double sum_x = 0, sum_y = 0;
    size_t end = first;
    if (begin->kind == MARK_CHOSEN)
        return first + 1;
    /* an arrow is as long as a column of the screen is wide */
    const bool beside = begin->kind == MARK_BESIDE;
    const PictureMap *map = picture->map;
    const double right = beside ? 0.9 * begin->side[0] / (map ? map->scale[0] : 1) : 0,
                 up = beside ? 0.5 * begin->side[1] / (map ? map->scale[1] : 1) : 0;
    do {
        sum_x += x_of(frame, picture->marks[end].x + right);
        sum_y += y_of(frame, picture->marks[end].y + up);
        end++;
        if (begin->half > 0) {
            /* How wide a load is that stands a row above its place. */
            const double y = y_of(frame, begin->y + 1), x = x_of(frame, begin->x);
            straight(frame->paper, x_of(frame, begin->x - begin->half), y,
                     x_of(frame, begin->x + begin->half), y, BLACK, 1.1);
            straight(frame->paper, x, y, x, y_of(frame, begin->y + 0.5), BLACK, 1.1);
        }
        /* Supports, and loads, of nodes beside each other are one sign; others mean a place each. */
    } while (spreads && end < picture->n_marks && picture->marks[end].glyph == glyph &&
             fabs(begin->x - picture->marks[end].x) <= NEAR * range_of(&picture->plot.x));
    /* Supports hang below their place, loads of beams stand above it. */
    const double x = sum_x / (double)(end - first);
    const double y = sum_y / (double)(end - first);
    const double size = frame->box.width < SMALL ? 0.7 : 1;
    const double away = size * (glyph == SIGN_LOAD ? -6 : 6), half = 3.2 * size;
    const double corners[] = {x, y, x - half, y + away, x + half, y + away};
    if (glyph == SIGN_DOT)
        frame->paper->kind->disc(frame->paper, x, y, 2.4 * size, ink_of(begin->style), NULL);
    else if (glyph == SIGN_ROLLER)
        frame->paper->kind->disc(frame->paper, x, y + 2.8 * size, 2.6 * size, WHITE,
                                 &(Pencil){.colour = BLACK, .width = 0.9 * size});
    else if (glyph == SIGN_SUPPORT || glyph == SIGN_LOAD)
        frame->paper->kind->fill(frame->paper, corners, 3, BLACK);
    else if (glyph >= SIGN_LEFT && glyph < SIGN_LEFT + 4)
        draw_arrow(frame, glyph, x, y, size);
    else if (glyph == SIGN_PROBE) {
        const double arm = 4 * size, across[] = {x - arm, y, x + arm, y},
                     upright[] = {x, y - arm, x, y + arm};
        const Pencil pencil = {.colour = ink_of(STYLE_MEASURED), .width = 1.6 * size};
        frame->paper->kind->line(frame->paper, across, 2, &pencil);
        frame->paper->kind->line(frame->paper, upright, 2, &pencil);
    } else if (begin->kind == MARK_BAR || glyph == SIGN_NODE || glyph == SIGN_PLACE || glyph == SIGN_GIVEN)
        draw_node(frame, begin, x, y, size);
    else {
        /* A letter on white, so that it is read on any colour. */
        const char text[2] = {(char)begin->glyph, '\0'};
        const Type type = {
            .size = SIZE_TICKS, .bold = true, .align = ALIGN_CENTRE, .colour = ink_of(begin->style)};
        frame->paper->kind->disc(frame->paper, x, y, 4.2 * size, WHITE,
                                 &(Pencil){.colour = type.colour, .width = 0.7 * size});
        frame->paper->kind->text(frame->paper, x, y + 2.7, text, &type);
    }
    return end;
}

/* Dots, rings and letters of a plot; a letter is beside its place, several at one place in a row. */
static void draw_marks(const Frame *frame)
{
    const Picture *picture = frame->picture;
    const Box *box = &frame->box;
    double before_x = NAN, before_y = NAN, shift = 0;
    const double size = box->width < SMALL ? 0.6 : 1;
    for (size_t i = 0; i < picture->n_marks; i++) {
        const PictureMark *mark = &picture->marks[i];
        const double x = x_of(frame, mark->x), y = y_of(frame, mark->y);
        const Colour colour = ink_of(mark->style);
        if (mark->kind != MARK_PLACE || !(x >= box->x - 0.1 && x <= box->x + box->width + 0.1 &&
                                          y >= box->y - 0.1 && y <= box->y + box->height + 0.1))
            continue; /* a rule lies behind the curves, and curves have dashes of their own */
        if (mark->glyph == 0x25cf) {
            frame->paper->kind->disc(frame->paper, x, y, mark->style == STYLE_CHANGED ? 2.4 : 1.7 * size,
                                     colour, NULL);
        } else if (mark->glyph == 0x25cb || mark->glyph == 'o') {
            frame->paper->kind->disc(frame->paper, x, y, 1.6 * size, WHITE,
                                     &(Pencil){.colour = colour, .width = 0.8});
        } else if (mark->glyph == 0x25a0) {
            const double half = 2.4 * size, corners[] = {x - half, y - half, x + half, y - half,
                                                         x + half, y + half, x - half, y + half};
            frame->paper->kind->fill(frame->paper, corners, 4, colour);
        }
        const bool is_letter = mark->glyph < 0x80 && mark->glyph != 'o';
        const char letter = is_letter ? (char)mark->glyph : mark->letter;
        if (letter) {
            shift = fabs(x - before_x) < 4 && fabs(y - before_y) < 4 ? shift + 6 : 0;
            before_x = x;
            before_y = y;
            const char text[2] = {letter, '\0'};
            const Type type = {.size = SIZE_TICKS, .bold = true, .colour = ink_of(mark->style)};
            frame->paper->kind->text(frame->paper, x + shift + 3, y + 2.5, text, &type);
        }
    }
}

/* Of the usual size or, where a drawing had to shrink, as small as it takes: a row of it has the height 1. */
static void draw_label(const Frame *frame, const PictureLabel *label)
{
    const double row = frame->box.height / range_of(&frame->picture->plot.y);
    const Type type = {.size = fmin(SIZE_WORDS, 0.8 * row),
                       .colour = ink_of(label->style),
                       .align = label->side < 0    ? ALIGN_RIGHT
                                : label->side == 0 ? ALIGN_CENTRE
                                                   : ALIGN_LEFT};
    /* of a body: beside the sign that stands on its place */
    const bool beside = frame->picture->map;
    const double x = x_of(frame, label->x) + (beside ? 8 : 0), y = y_of(frame, label->y) - (beside ? 4 : 0);
    if (label->side == 0) {
        const double half = draw_words_width(label->text, &type) / 2 + 2, up = type.size / 2;
        const double patch[] = {x - half, y - up, x + half, y - up, x + half, y + up, x - half, y + up};
        frame->paper->kind->fill(frame->paper, patch, 4, WHITE);
    }
    draw_words(frame->paper, x, y + 0.36 * type.size, label->text, &type);
}

/* --- a drawing --------------------------------------------------------------------------------------- */

static double columns_of(const Places *places, const char *text)
{
    return draw_words_width(text, &(Type){.size = places->row / LINE_HEIGHT});
}

/* On white, which breaks the lines below. */
static void write_words(const Places *places, double left, double top, const char *text, Style style)
{
    const Frame *frame = places->back_end;
    const Type type = {.size = places->row / LINE_HEIGHT, .colour = ink_of(style)};
    const double x = frame->box.x + left, y = frame->box.y + top, right = x + draw_words_width(text, &type);
    const double patch[] = {x - 1, y, right + 1, y, right + 1, y + places->row, x - 1, y + places->row};
    frame->paper->kind->fill(frame->paper, patch, 4, WHITE);
    draw_words(frame->paper, x, y + 0.8 * places->row, text, &type);
}

static void draw_head(const Frame *frame, const PictureArrow *arrow)
{
    const double x = x_of(frame, arrow->to[0]), y = y_of(frame, arrow->to[1]);
    const double across = x - x_of(frame, arrow->from[0]), down = y - y_of(frame, arrow->from[1]);
    const double length = math_hypot(across, down), head = 6;
    if (!(length > head)) /* a stroke is all there is room for */
        return;
    const double way[] = {head * across / length, head * down / length};
    const double corners[] = {x,
                              y,
                              x - way[0] + 0.4 * way[1],
                              y - way[1] - 0.4 * way[0],
                              x - way[0] - 0.4 * way[1],
                              y - way[1] + 0.4 * way[0]};
    frame->paper->kind->fill(frame->paper, corners, 3, ink_of(arrow->style));
}

/* --- the whole --------------------------------------------------------------------------------------- */

/* The box of the curves within one that has their axes too. */
static Box inner_box(const Picture *picture, Box box)
{
    double ticks[TICKS_MAX], widest = 0;
    if (picture->bare)
        return box;
    const int count = axis_ticks(&picture->plot.y, ticks);
    for (int i = 0; i < count; i++) {
        char text[64];
        tick_label(&picture->plot.y, ticks[i], text, sizeof text);
        widest = fmax(widest, draw_words_width(text, &(Type){.size = SIZE_TICKS}));
    }
    const double left = SIZE_WORDS + 5 + widest + GAP + TICK, right = 12, above = 4,
                 below = TICK + SIZE_TICKS + 14;
    return (Box){box.x + left, box.y + above, box.width - left - right, box.height - above - below};
}

double draw_plot_height(const Picture *picture, double width)
{
    if (picture->stretch <= 0)
        return 0;
    const Box inner = inner_box(picture, (Box){0, 0, width, 0}); /* its height is missing: below 0 */
    return inner.width / range_of(&picture->plot.x) * picture->stretch * range_of(&picture->plot.y) -
           inner.height;
}

static void draw_body(const Frame *frame)
{
    const Plot *plot = &frame->picture->plot;
    const Place place = {
        .scale_x = frame->box.width / range_of(&plot->x),
        .scale_y = -frame->box.height / range_of(&plot->y),
        .x0 = x_of(frame, 0),
        .y0 = y_of(frame, 0),
        .seen = frame->box,
    };
    frame->paper->kind->clip(frame->paper, &frame->box);
    draw_heat(frame->paper, frame->picture->map, &place);
    frame->paper->kind->clip(frame->paper, NULL);
}

void draw_plot(Paper *paper, const Picture *picture, Box box)
{
    if (picture->kind == PICTURE_TABLES) {
        draw_tables(paper, picture, box);
        return;
    }
    Frame frame = {paper, picture, inner_box(picture, box)};
    if (frame.box.width < 20 || frame.box.height < 10)
        return;
    const bool of_body = picture->stretch > 0; /* its marks are signs */
    if (picture->kind == PICTURE_DRAWING) {
        draw_strokes(&frame);
        const double row = frame.box.height / range_of(&frame.picture->plot.y);
        Places places = {.picture = picture,
                         .width = frame.box.width,
                         .height = frame.box.height,
                         .row = LINE_HEIGHT * fmin(SIZE_WORDS, row / LINE_HEIGHT),
                         .gap = 6,
                         .columns = columns_of,
                         .write = write_words,
                         .back_end = &frame};
        for (int i = 0; i < frame.picture->n_arrows; i++)
            draw_head(&frame, &frame.picture->arrows[i]);
        draw_marks(&frame);
        places_write(&places);
        return;
    }
    if (of_body) {
        /* A map or drawing keeps its scale: the box shrinks one way. */
        const double x = range_of(&picture->plot.x), y = picture->stretch * range_of(&picture->plot.y);
        const double scale = fmin(frame.box.width / x, frame.box.height / y);
        frame.box.width = scale * x;
        frame.box.height = scale * y;
    } else
        draw_grid(&frame);
    const bool is_near = picture->map && picture->map->is_near; /* bonds lie under their nodes */
    if (picture->map && !is_near)
        draw_body(&frame);
    draw_strokes(&frame);
    if (is_near)
        draw_body(&frame);
    if (!picture->bare)
        draw_axes(&frame, box.x);
    if (!of_body)
        draw_marks(&frame);
    for (size_t i = 0; of_body && i < picture->n_marks;)
        i = draw_signs(&frame, i);
    for (int i = 0; picture->map && i < picture->n_arrows; i++) {
        const PictureArrow *arrow = &picture->arrows[i];
        straight(paper, x_of(&frame, arrow->from[0]), y_of(&frame, arrow->from[1]),
                 x_of(&frame, arrow->to[0]), y_of(&frame, arrow->to[1]), ink_of(arrow->style), 1);
        draw_head(&frame, arrow);
    }
    for (int i = 0; i < picture->n_labels; i++)
        draw_label(&frame, &picture->labels[i]);
}
