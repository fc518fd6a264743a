/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cairo, mapped when the first figure or film asks for it: it brings twenty other libraries. CAIRO(name) is
 * the function cairo_name, once cairo_load() has returned true. */
#ifndef PICTURE_PAPER_CAIRO_CALLS_H
#define PICTURE_PAPER_CAIRO_CALLS_H

#include "base/status.h"

#ifdef HAVE_CAIRO

#include <cairo-pdf.h>
#include <cairo.h>

/* clang-format off */
#define CAIRO_CALLS(X) \
    X(arc) X(clip) X(close_path) X(create) X(destroy) X(fill) X(fill_preserve) X(font_options_create) \
    X(font_options_destroy) X(font_options_set_antialias) X(font_options_set_hint_metrics) \
    X(font_options_set_hint_style) X(image_surface_create) X(image_surface_get_data) \
    X(image_surface_get_stride) X(line_to) X(move_to) X(new_path) X(paint) \
    X(pdf_surface_create_for_stream) X(pdf_surface_set_metadata) X(rectangle) X(reset_clip) X(restore) \
    X(rotate) X(save) X(scale) X(select_font_face) X(set_dash) X(set_font_options) X(set_font_size) \
    X(set_line_cap) X(set_line_join) X(set_line_width) X(set_operator) X(set_source_rgb) X(show_page) \
    X(show_text) X(status) X(status_to_string) X(stroke) X(surface_destroy) X(surface_finish) \
    X(surface_flush) X(surface_status) X(surface_write_to_png_stream) X(text_extents) X(translate)
/* clang-format on */

typedef struct CairoCalls {
#define CAIRO_MEMBER(name) __typeof__(cairo_##name) *name;
    CAIRO_CALLS(CAIRO_MEMBER)
#undef CAIRO_MEMBER
} CairoCalls;

extern CairoCalls cairo_calls;
#define CAIRO(name) cairo_calls.name

#endif

/* False: the program was built without it, or it is not on this machine. */
bool cairo_load(Status *);

#endif
