/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sets paragraphs line by line on the pages of a PDF (leaflet.h). */
#include "picture/paper/leaflet.h"

#include "picture/paper/cairo_calls.h"
#include "picture/paper/paper.h"

#include <stdarg.h>
#include <string.h>
#include <strings.h>

/* A4, points. */
#define PAGE_WIDTH  595.0
#define PAGE_HEIGHT 842.0
#define MARGIN      64.0
#define INK_RULE    0x9f9f9fu

enum { PARAGRAPH_MAX = 4200 };

static const struct {
    double size, above; /* points; above: of a paragraph, in sizes */
    bool bold;
    Colour colour;
} looks[] = {[LEAFLET_TITLE] = {16, 0, true, BLACK},
             [LEAFLET_HEADING] = {11, 1.2, true, BLACK},
             [LEAFLET_TEXT] = {10, 0.5, false, BLACK},
             [LEAFLET_SMALL] = {8.5, 0.4, false, GREY}};

bool leaflet_allowed(const char *file, Asker asker, bool force, Status *status)
{
    const char *dot = strrchr(file, '.');
    if (!dot || strcasecmp(dot, ".pdf") != 0)
        return status_refuse(status, "%.200s: not a file of pages (FILE.pdf)", file);
    return cairo_load(status) && output_may_begin(file, asker, force, status);
}

bool leaflet_open(Leaflet *leaflet, Asker asker, const char *file, bool force, const char *title,
                  Status *status)
{
    *leaflet = (Leaflet){.y = MARGIN};
    if (!output_open(&leaflet->file, asker, file, force, status))
        return false;
    leaflet->paper = paper_pdf(leaflet->file.stream, PAGE_WIDTH, PAGE_HEIGHT, title, status);
    return leaflet->paper != NULL;
}

void leaflet_page(Leaflet *leaflet)
{
    if (leaflet->used)
        leaflet->paper->kind->page(leaflet->paper);
    leaflet->used = false;
    leaflet->y = MARGIN;
}

/* Moves down for a line; where it has no room, to the next page. */
static void go_down(Leaflet *leaflet, double height)
{
    if (leaflet->y + height > PAGE_HEIGHT - MARGIN)
        leaflet_page(leaflet);
    leaflet->y += height;
    leaflet->used = true;
}

/* How many bytes of a text go into a line: up to a space or, of a longer word, as many as have room. */
static size_t line_length(const char *text, const Type *type)
{
    char line[FIGURE_WORDS_MAX];
    size_t fits = 0, at_space = 0;
    while (text[fits] && fits + 4 < sizeof line) {
        size_t next = fits + 1;
        while (((unsigned char)text[next] & 0xc0) == 0x80)
            next++;
        memcpy(line, text, next);
        line[next] = '\0';
        if (fits > 0 && draw_words_width(line, type) > PAGE_WIDTH - 2 * MARGIN)
            return at_space > 0 ? at_space : fits;
        if (text[fits] == ' ')
            at_space = fits;
        fits = next;
    }
    return fits;
}

void leaflet_line(Leaflet *leaflet, LeafletStyle style, const char *format, ...)
{
    char text[PARAGRAPH_MAX], line[FIGURE_WORDS_MAX];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    const Type type = {.size = looks[style].size, .bold = looks[style].bold, .colour = looks[style].colour};
    if (leaflet->used)
        leaflet->y += looks[style].above * type.size;
    for (const char *rest = text; *rest; rest += strspn(rest, " ")) {
        const size_t length = line_length(rest, &type);
        memcpy(line, rest, length);
        line[length] = '\0';
        go_down(leaflet, LINE_HEIGHT * type.size);
        leaflet->paper->kind->text(leaflet->paper, MARGIN, leaflet->y, line, &type);
        rest += length;
    }
}

void leaflet_lines(Leaflet *leaflet, int count)
{
    const double height = 24;
    for (int i = 0; i < count; i++) {
        go_down(leaflet, height);
        const double ends[] = {MARGIN, leaflet->y, PAGE_WIDTH - MARGIN, leaflet->y};
        leaflet->paper->kind->line(leaflet->paper, ends, 2, &(Pencil){.colour = INK_RULE, .width = 0.5});
    }
}

bool leaflet_finish(Leaflet *leaflet, Status *status)
{
    Paper *paper = leaflet->paper;
    leaflet->paper = NULL;
    return paper->kind->finish(paper, status) && output_finish(&leaflet->file, status) &&
           output_commit(&leaflet->file, status);
}

void leaflet_close(Leaflet *leaflet)
{
    Status ignored = {0};
    if (leaflet->paper)
        leaflet->paper->kind->finish(leaflet->paper, &ignored);
    leaflet->paper = NULL;
    output_close(&leaflet->file);
}
