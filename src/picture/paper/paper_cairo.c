/* SPDX-License-Identifier: GPL-3.0-or-later */
/* PDF and PNG through cairo. */
#include "picture/paper/cairo_calls.h"
#include "picture/paper/paper.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#ifdef HAVE_CAIRO

#include <math.h>
#include <dlfcn.h>
#include <stddef.h>

#define DOTS_PER_POINT (300.0 / 72) /* of a PNG: what a printer makes of it */

typedef struct CairoPaper {
    Paper paper;
    cairo_surface_t *surface;
    cairo_t *cairo;
    bool image;
} CairoPaper;

static cairo_t *cairo_of(Paper *paper)
{
    return ((CairoPaper *)paper)->cairo;
}

static void set_colour(cairo_t *cairo, Colour colour)
{
    CAIRO(set_source_rgb)
    (cairo, (colour >> 16 & 0xff) / 255.0, (colour >> 8 & 0xff) / 255.0, (colour & 0xff) / 255.0);
}

static void trace(cairo_t *cairo, const double *points, size_t count)
{
    CAIRO(new_path)(cairo);
    for (size_t i = 0; i < count; i++)
        CAIRO(line_to)(cairo, points[2 * i], points[2 * i + 1]);
}

static void stroke(cairo_t *cairo, const Pencil *pencil)
{
    int n_dashes = 0;
    while (n_dashes < 4 && pencil->dashes[n_dashes] > 0)
        n_dashes++;
    set_colour(cairo, pencil->colour);
    CAIRO(set_line_width)(cairo, pencil->width);
    CAIRO(set_line_cap)(cairo, pencil->round ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
    CAIRO(set_line_join)(cairo, CAIRO_LINE_JOIN_ROUND);
    CAIRO(set_dash)(cairo, pencil->dashes, n_dashes, 0);
    CAIRO(stroke)(cairo);
}

static void draw_line(Paper *paper, const double *points, size_t count, const Pencil *pencil)
{
    trace(cairo_of(paper), points, count);
    stroke(cairo_of(paper), pencil);
}

static void draw_fill(Paper *paper, const double *points, size_t count, Colour colour)
{
    cairo_t *cairo = cairo_of(paper);
    trace(cairo, points, count);
    CAIRO(close_path)(cairo);
    set_colour(cairo, colour);
    CAIRO(fill)(cairo);
}

static void draw_disc(Paper *paper, double x, double y, double radius, Colour colour, const Pencil *edge)
{
    cairo_t *cairo = cairo_of(paper);
    CAIRO(new_path)(cairo);
    CAIRO(arc)(cairo, x, y, radius, 0, 2 * M_PI);
    set_colour(cairo, colour);
    if (!edge) {
        CAIRO(fill)(cairo);
        return;
    }
    CAIRO(fill_preserve)(cairo);
    stroke(cairo, edge);
}

static void draw_text(Paper *paper, double x, double y, const char *text, const Type *type)
{
    cairo_t *cairo = cairo_of(paper);
    cairo_text_extents_t extents;
    CAIRO(select_font_face)
    (cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
     type->bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    CAIRO(set_font_size)(cairo, type->size);
    set_colour(cairo, type->colour);
    CAIRO(text_extents)(cairo_of(paper), text, &extents);
    const double width = extents.x_advance;
    CAIRO(save)(cairo);
    CAIRO(translate)(cairo, x, y);
    if (type->upwards)
        CAIRO(rotate)(cairo, -M_PI / 2);
    const double left = type->align == ALIGN_LEFT ? 0 : type->align == ALIGN_CENTRE ? -width / 2 : -width;
    CAIRO(move_to)(cairo, left, 0);
    CAIRO(show_text)(cairo, text);
    CAIRO(restore)(cairo);
}

static void draw_clip(Paper *paper, const Box *box)
{
    cairo_t *cairo = cairo_of(paper);
    CAIRO(reset_clip)(cairo);
    if (!box)
        return;
    CAIRO(rectangle)(cairo, box->x, box->y, box->width, box->height);
    CAIRO(clip)(cairo);
}

static void turn_page(Paper *paper)
{
    CAIRO(show_page)(cairo_of(paper));
}

static cairo_status_t write_bytes(void *stream, const unsigned char *bytes, unsigned length)
{
    return fwrite(bytes, 1, length, stream) == length ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

static bool finish(Paper *paper, Status *status)
{
    CairoPaper *page = (CairoPaper *)paper;
    cairo_status_t result = CAIRO(status)(page->cairo);
    CAIRO(destroy)(page->cairo);
    if (result == CAIRO_STATUS_SUCCESS && page->image)
        result = CAIRO(surface_write_to_png_stream)(page->surface, write_bytes, paper->stream);
    CAIRO(surface_finish)(page->surface);
    if (result == CAIRO_STATUS_SUCCESS)
        result = CAIRO(surface_status)(page->surface);
    CAIRO(surface_destroy)(page->surface);
    free(page);
    if (result == CAIRO_STATUS_WRITE_ERROR)
        return status_fail(status, "the figure could not be written: %s", strerror(errno));
    return result == CAIRO_STATUS_SUCCESS ||
           status_fail(status, "the figure could not be drawn: %s", CAIRO(status_to_string)(result));
}

static const PaperKind cairo_kind = {draw_line, draw_fill, draw_disc, draw_text,
                                     draw_clip, turn_page, finish};

static Paper *open_paper(FILE *stream, cairo_surface_t *surface, bool image, Status *status)
{
    CairoPaper *page = calloc(1, sizeof *page);
    const cairo_status_t result = CAIRO(surface_status)(surface);
    if (!page || result != CAIRO_STATUS_SUCCESS) {
        status_fail(status, "no figure can be drawn: %s",
                    CAIRO(status_to_string)(page ? result : CAIRO_STATUS_NO_MEMORY));
        CAIRO(surface_destroy)(surface);
        free(page);
        return NULL;
    }
    *page = (CairoPaper){{&cairo_kind, stream}, surface, CAIRO(create)(surface), image};
    return &page->paper;
}

Paper *paper_pdf(FILE *stream, double width, double height, const char *title, Status *status)
{
    if (!cairo_load(status))
        return NULL;
    cairo_surface_t *surface = CAIRO(pdf_surface_create_for_stream)(write_bytes, stream, width, height);
    CAIRO(pdf_surface_set_metadata)(surface, CAIRO_PDF_METADATA_TITLE, title);
    /* the same figure gives the same bytes on every day */
    CAIRO(pdf_surface_set_metadata)(surface, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
    return open_paper(stream, surface, false, status);
}

Paper *paper_png(FILE *stream, double width, double height, Status *status)
{
    if (!cairo_load(status))
        return NULL;
    cairo_surface_t *surface = CAIRO(image_surface_create)(
        CAIRO_FORMAT_RGB24, (int)ceil(width * DOTS_PER_POINT), (int)ceil(height * DOTS_PER_POINT));
    Paper *paper = open_paper(stream, surface, true, status);
    if (!paper)
        return NULL;
    cairo_font_options_t *options = CAIRO(font_options_create)();
    CAIRO(font_options_set_antialias)(options, CAIRO_ANTIALIAS_GRAY);
    CAIRO(font_options_set_hint_style)(options, CAIRO_HINT_STYLE_NONE);
    CAIRO(font_options_set_hint_metrics)(options, CAIRO_HINT_METRICS_OFF);
    CAIRO(set_font_options)(cairo_of(paper), options);
    CAIRO(font_options_destroy)(options);
    CAIRO(scale)(cairo_of(paper), DOTS_PER_POINT, DOTS_PER_POINT);
    set_colour(cairo_of(paper), 0xffffff);
    CAIRO(paint)(cairo_of(paper));
    return paper;
}

CairoCalls cairo_calls;

bool cairo_load(Status *status)
{
    static bool loaded;
    void *library = loaded ? NULL : dlopen("libcairo.so.2", RTLD_NOW | RTLD_LOCAL);
    if (!loaded && !library)
        return status_fail(status,
                           "PDF, PNG and GIF need cairo (Debian package libcairo2; an SVG needs nothing): %s",
                           dlerror());
    if (loaded)
        return true;
    loaded = true;
#define CAIRO_FIND(name)                                                                                     \
    loaded = (*(void **)&cairo_calls.name = dlsym(library, "cairo_" #name)) != NULL && loaded;
    CAIRO_CALLS(CAIRO_FIND)
#undef CAIRO_FIND
    return loaded || status_fail(status, "libcairo.so.2 of this machine is too old for figures");
}

#else

Paper *paper_pdf(FILE *stream, double width, double height, const char *title, Status *status)
{
    (void)title;
    return paper_png(stream, width, height, status);
}

Paper *paper_png(FILE *stream, double width, double height, Status *status)
{
    (void)stream, (void)width, (void)height;
    cairo_load(status);
    return NULL;
}

bool cairo_load(Status *status)
{
    return status_refuse(
        status, "PDF and PNG need cairo, which this program was built without (an SVG needs nothing; "
                "Debian package libcairo2-dev)");
}

#endif
