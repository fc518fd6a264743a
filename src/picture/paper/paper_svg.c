/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SVG: words stay text, so that they can be searched, restyled and read aloud. */
#include "picture/paper/paper.h"

#include "base/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct SvgPaper {
    Paper paper;
    int clips; /* so far: each has a name */
    bool clipped;
    Box box; /* if so, to this */
} SvgPaper;

#define FAMILY "DejaVu Sans, Verdana, Helvetica, Arial, sans-serif"

/* A hundredth of a point is finer than any printer. Trailing zeros are left out. */
static void put_number(FILE *stream, double value)
{
    char text[32];
    snprintf(text, sizeof text, "%.2f", value);
    char *end = text + strlen(text);
    while (end[-1] == '0')
        *--end = '\0';
    if (end[-1] == '.')
        *--end = '\0';
    fputs(strcmp(text, "-0") == 0 ? "0" : text, stream);
}

static void put_attribute(FILE *stream, const char *name, double value)
{
    fprintf(stream, " %s=\"", name);
    put_number(stream, value);
    fputc('"', stream);
}

static void put_pair(FILE *stream, double x, double y)
{
    put_number(stream, x);
    fputc(',', stream);
    put_number(stream, y);
}

static void put_points(FILE *stream, const double *points, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        fputs(i > 0 ? " " : " points=\"", stream);
        put_pair(stream, points[2 * i], points[2 * i + 1]);
    }
    fputc('"', stream);
}

static void put_pencil(FILE *stream, const Pencil *pencil)
{
    fprintf(stream, " stroke=\"#%06x\"", pencil->colour);
    put_attribute(stream, "stroke-width", pencil->width);
    if (pencil->round)
        fputs(" stroke-linecap=\"round\"", stream);
    for (int i = 0; i < 4 && pencil->dashes[i] > 0; i++) {
        fputs(i > 0 ? " " : " stroke-dasharray=\"", stream);
        put_number(stream, pencil->dashes[i]);
    }
    fputs(pencil->dashes[0] > 0 ? "\"" : "", stream);
}

/* Whether something that is clipped reaches out of the box, by more than is written. */
static bool reaches_out(const SvgPaper *svg, const double *points, size_t count)
{
    const double near = 0.005;
    bool outside = false;
    for (size_t i = 0; i < count; i++) {
        const double x = points[2 * i] - svg->box.x, y = points[2 * i + 1] - svg->box.y;
        outside |= x < -near || y < -near || x > svg->box.width + near || y > svg->box.height + near;
    }
    return svg->clipped && outside;
}

static void put_clip(const Paper *paper, const double *points, size_t count)
{
    const SvgPaper *svg = (const SvgPaper *)paper;
    if (reaches_out(svg, points, count))
        fprintf(paper->stream, " clip-path=\"url(#c%d)\"", svg->clips);
}

static void put_line(Paper *paper, const double *points, size_t count, const Pencil *pencil)
{
    fputs("<polyline fill=\"none\" stroke-linejoin=\"round\"", paper->stream);
    put_pencil(paper->stream, pencil);
    put_points(paper->stream, points, count);
    fputs("/>\n", paper->stream);
}

/* The part of a piece of a line, x0, y0, x1, y1, that lies in the box (Liang and Barsky); false: none. */
static bool cut(const Box *box, const double *piece, double out[4])
{
    double from = 0, to = 1;
    for (int axis = 0; axis < 2; axis++) {
        const double start = piece[axis], way = piece[2 + axis] - start;
        const double low = axis == 0 ? box->x : box->y, high = low + (axis == 0 ? box->width : box->height);
        if (way == 0 && (start < low || start > high))
            return false;
        if (way == 0)
            continue;
        const double at_low = (low - start) / way, at_high = (high - start) / way;
        from = fmax(from, fmin(at_low, at_high));
        to = fmin(to, fmax(at_low, at_high));
    }
    for (int axis = 0; axis < 2; axis++) {
        const double way = piece[2 + axis] - piece[axis];
        out[axis] = from > 0 ? piece[axis] + from * way : piece[axis];
        out[2 + axis] = to < 1 ? piece[axis] + to * way : piece[2 + axis];
    }
    return from < to;
}

/* Lines are cut here: not every program that reads SVG draws what has a clip path. */
static void svg_line(Paper *paper, const double *points, size_t count, const Pencil *pencil)
{
    const SvgPaper *svg = (const SvgPaper *)paper;
    if (!reaches_out(svg, points, count)) {
        put_line(paper, points, count, pencil);
        return;
    }
    size_t first = 0; /* of the pieces that lie inside wholly */
    for (size_t i = 0; i + 1 < count; i++) {
        double inside[4];
        if (!reaches_out(svg, points + 2 * i, 2))
            continue;
        if (i > first)
            put_line(paper, points + 2 * first, i - first + 1, pencil);
        if (cut(&svg->box, points + 2 * i, inside))
            put_line(paper, inside, 2, pencil);
        first = i + 1;
    }
    if (first + 1 < count)
        put_line(paper, points + 2 * first, count - first, pencil);
}

static void svg_fill(Paper *paper, const double *points, size_t count, Colour colour)
{
    fprintf(paper->stream, "<polygon fill=\"#%06x\"", colour);
    put_clip(paper, points, count);
    put_points(paper->stream, points, count);
    fputs("/>\n", paper->stream);
}

static void svg_disc(Paper *paper, double x, double y, double radius, Colour colour, const Pencil *edge)
{
    fprintf(paper->stream, "<circle fill=\"#%06x\"", colour);
    put_clip(paper, (const double[]){x, y}, 1);
    put_attribute(paper->stream, "cx", x);
    put_attribute(paper->stream, "cy", y);
    put_attribute(paper->stream, "r", radius);
    if (edge)
        put_pencil(paper->stream, edge);
    fputs("/>\n", paper->stream);
}

static void svg_text(Paper *paper, double x, double y, const char *text, const Type *type)
{
    static const char *const anchors[] = {"start", "middle", "end"};
    FILE *stream = paper->stream;
    fputs("<text", stream);
    if (type->upwards) {
        fputs(" transform=\"translate(", stream);
        put_pair(stream, x, y);
        fputs(") rotate(-90)\"", stream);
    } else {
        put_attribute(stream, "x", x);
        put_attribute(stream, "y", y);
    }
    put_attribute(stream, "font-size", type->size);
    fprintf(stream, " fill=\"#%06x\"", type->colour);
    if (type->bold)
        fputs(" font-weight=\"bold\"", stream);
    if (type->align != ALIGN_LEFT)
        fprintf(stream, " text-anchor=\"%s\"", anchors[type->align]);
    fputc('>', stream);
    text_put_xml(stream, text);
    fputs("</text>\n", stream);
}

static void svg_clip(Paper *paper, const Box *box)
{
    SvgPaper *svg = (SvgPaper *)paper;
    svg->clipped = box != NULL;
    if (!box)
        return;
    svg->box = *box;
    fprintf(paper->stream, "<clipPath id=\"c%d\"><rect", ++svg->clips);
    put_attribute(paper->stream, "x", box->x);
    put_attribute(paper->stream, "y", box->y);
    put_attribute(paper->stream, "width", box->width);
    put_attribute(paper->stream, "height", box->height);
    fputs("/></clipPath>\n", paper->stream);
}

static bool svg_finish(Paper *paper, Status *status)
{
    (void)status;
    fputs("</svg>\n", paper->stream);
    free(paper);
    return true; /* whether it was written, its file knows */
}

static const PaperKind svg_kind = {svg_line, svg_fill, svg_disc, svg_text, svg_clip, NULL, svg_finish};

Paper *paper_svg(FILE *stream, double width, double height, const char *title, Status *status)
{
    SvgPaper *svg = calloc(1, sizeof *svg);
    if (!svg) {
        status_fail(status, "not enough memory for a figure");
        return NULL;
    }
    svg->paper = (Paper){&svg_kind, stream};
    fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
          "stroke=\"none\" font-family=\"" FAMILY "\" width=\"",
          stream);
    put_number(stream, width * 25.4 / 72);
    fputs("mm\" height=\"", stream);
    put_number(stream, height * 25.4 / 72);
    fputs("mm\" viewBox=\"0 0 ", stream);
    put_number(stream, width);
    fputc(' ', stream);
    put_number(stream, height);
    fputs("\">\n<title>", stream);
    text_put_xml(stream, title);
    fputs("</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n", stream);
    return &svg->paper;
}
