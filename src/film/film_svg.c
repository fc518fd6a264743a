/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The film as one animated SVG: the pictures stand side by side on a strip that moves behind the frame, by a
 * rule of CSS. Who does not follow the rule sees the last picture, for that is where the strip stands by
 * itself. A row of cells that stays from one picture to the next is written once.
 *
 * Words stay words. Solid blocks and braille, which fonts draw with gaps or not at all, are drawn. */
#include "film/film.h"

#include "base/text.h"
#include "terminal/grid.h"

#include <stdlib.h>
#include <string.h>

enum { CELL_WIDTH = 8, CELL_HEIGHT = 17, BASELINE = 13, FONT = 13 }; /* pixels */

typedef struct Row {
    Cell *cells; /* as it stands now; `width` of them */
    long number; /* of its definition; 0: none yet */
} Row;

struct Film {
    FILE *stream;
    FilmLook look;
    Row *rows;
    Cell *cells;
    long definitions;
    double *times; /* at which the pictures appear, and below each the numbers of its rows */
    long *numbers; /* count x height */
    long count, room;
};

static void put_rectangle(const Film *film, double x, double y, double width, double height, unsigned colour)
{
    fprintf(film->stream, "<rect x=\"%g\" y=\"%g\" width=\"%g\" height=\"%g\" fill=\"#%06x\"/>", x, y, width,
            height, colour);
}

typedef enum Kind { KIND_WORDS, KIND_BLOCK, KIND_DOTS } Kind;

/* Blocks fill their cell from the top, from the middle, or whole; braille has the bits of its dots. */
static Kind kind_of(uint32_t glyph)
{
    if (glyph == 0x2580 || glyph == 0x2584 || glyph == 0x2588)
        return KIND_BLOCK;
    return glyph >= 0x2800 && glyph <= 0x28ff ? KIND_DOTS : KIND_WORDS;
}

static bool is_blank(const Cell *cell)
{
    return cell->glyph == ' ' || cell->glyph == 0;
}

static bool alike(const Cell *a, const Cell *b)
{
    const Kind kind = kind_of(a->glyph);
    return a->style == b->style && a->back == b->back && kind == kind_of(b->glyph) &&
           (kind != KIND_BLOCK || a->glyph == b->glyph);
}

/* A stretch of cells that look alike, from column x on. */
static void put_stretch(const Film *film, const Cell *cells, int x, int count)
{
    Look look = theme_look(256, film->look.light, cells->style, cells->back);
    unsigned ink = film_ink(look.foreground, film->look.light);
    unsigned paper = film_paper(look.background, film->look.light);
    bool papered = look.background != LOOK_DEFAULT;
    if (look.attributes & LOOK_REVERSE) {
        const unsigned swapped = ink;
        ink = paper;
        paper = swapped;
        papered = true;
    }
    if (papered)
        put_rectangle(film, x * CELL_WIDTH, 0, count * CELL_WIDTH, CELL_HEIGHT, paper);
    if (kind_of(cells->glyph) == KIND_BLOCK) {
        const uint32_t glyph = cells->glyph;
        const double from = glyph == 0x2584 ? CELL_HEIGHT / 2.0 : 0;
        const double to = glyph == 0x2580 ? CELL_HEIGHT / 2.0 : CELL_HEIGHT;
        put_rectangle(film, x * CELL_WIDTH, from, count * CELL_WIDTH, to - from, ink);
    } else if (kind_of(cells->glyph) == KIND_DOTS) {
        /* Each dot is a line without length, of which the round ends are left. */
        static const int column[8] = {0, 0, 0, 1, 1, 1, 0, 1}, row[8] = {0, 1, 2, 0, 1, 2, 3, 3};
        fprintf(film->stream, "<path stroke-width=\"2\" stroke-linecap=\"round\" stroke=\"#%06x\" d=\"", ink);
        for (int i = 0; i < count; i++)
            for (int dot = 0; dot < 8; dot++)
                if (cells[i].glyph >> dot & 1)
                    fprintf(film->stream, "M%d %dh0", (x + i) * CELL_WIDTH + 2 + 4 * column[dot],
                            2 + 4 * row[dot]);
        fputs("\"/>", film->stream);
    } else {
        while (count > 0 && is_blank(cells))
            cells++, x++, count--;
        while (count > 0 && is_blank(&cells[count - 1]))
            count--;
        if (count > 0) {
            FILE *stream = film->stream;
            fprintf(stream, "<text x=\"%d\" y=\"%d\" textLength=\"%d\" fill=\"#%06x\"", x * CELL_WIDTH,
                    BASELINE, count * CELL_WIDTH, ink);
            if (look.attributes & LOOK_BOLD)
                fputs(" font-weight=\"bold\"", stream);
            if (look.attributes & LOOK_UNDERLINE)
                fputs(" text-decoration=\"underline\"", stream);
            fputc('>', stream);
            for (int i = 0; i < count; i++) {
                char bytes[5] = "";
                if (cells[i].glyph != CELL_FOLLOWS) {
                    glyph_put(bytes, is_blank(&cells[i]) ? ' ' : cells[i].glyph);
                    text_put_xml(stream, bytes);
                }
            }
            fputs("</text>", stream);
        }
    }
}

static Film *open_svg(FILE *stream, const FilmLook *look, Status *status)
{
    const size_t width = (size_t)look->width, height = (size_t)look->height;
    Film *film = calloc(1, sizeof *film);
    if (film) {
        *film = (Film){.stream = stream, .look = *look};
        film->rows = calloc(height, sizeof *film->rows);
        film->cells = calloc(width * (height + 1), sizeof *film->cells);
    }
    if (!film || !film->rows || !film->cells) {
        status_fail(status, "out of memory");
        if (film)
            film_svg.close(film);
        return NULL;
    }
    for (size_t y = 0; y < height; y++)
        film->rows[y].cells = film->cells + y * width;
    fprintf(
        stream,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\" "
        "font-family=\"DejaVu Sans Mono, Menlo, Consolas, monospace\" font-size=\"%d\" "
        "xml:space=\"preserve\">\n"
        /* of each text: browsers have a rule of their own for it, which what it inherits does not change */
        "<style>text{white-space:pre}</style>\n<title>",
        look->width * CELL_WIDTH, look->height * CELL_HEIGHT, look->width * CELL_WIDTH,
        look->height * CELL_HEIGHT, FONT);
    text_put_xml(stream, look->title);
    fputs("</title>\n", stream);
    put_rectangle(film, 0, 0, look->width * CELL_WIDTH, look->height * CELL_HEIGHT,
                  film_paper(LOOK_DEFAULT, look->light));
    fputc('\n', stream);
    return film;
}

static bool add_to_svg(Film *film, const Canvas *canvas, double seconds, Status *status)
{
    const int width = film->look.width, height = film->look.height;
    const size_t bytes = (size_t)width * sizeof(Cell);
    Cell *cells = film->cells + (size_t)height * (size_t)width; /* one row more */
    if (film->count == film->room) {
        const long room = 2 * film->room + 64;
        double *times = realloc(film->times, (size_t)room * sizeof *times);
        film->times = times ? times : film->times;
        long *numbers = realloc(film->numbers, (size_t)room * (size_t)height * sizeof *numbers);
        film->numbers = numbers ? numbers : film->numbers;
        if (!times || !numbers)
            return status_fail(status, "out of memory");
        film->room = room;
    }
    for (int y = 0; y < height; y++) {
        Row *row = &film->rows[y];
        /* What a picture has of row y; nothing beyond its edge. */
        for (int x = 0; x < width; x++)
            cells[x] = x < canvas->width && y < canvas->height ? canvas->cells[y * canvas->width + x]
                                                               : (Cell){.glyph = ' '};
        if (row->number == 0 || memcmp(cells, row->cells, bytes) != 0) {
            memcpy(row->cells, cells, bytes);
            row->number = ++film->definitions;
            fprintf(film->stream, "<defs><g id=\"r%ld\">", row->number);
            for (int x = 0, end; x < width; x = end) {
                for (end = x + 1; end < width && alike(&cells[x], &cells[end]);)
                    end++;
                put_stretch(film, &cells[x], x, end - x);
            }
            fputs("</g></defs>\n", film->stream);
        }
        film->numbers[film->count * height + y] = row->number;
    }
    film->times[film->count++] = seconds;
    return true;
}

static bool end_svg(Film *film, double seconds, Status *status)
{
    (void)status;
    FILE *stream = film->stream;
    const long step = (long)film->look.width * CELL_WIDTH;
    fprintf(stream,
            "<style>#strip{animation:film %.3fs step-end infinite}\n"
            "@media (prefers-reduced-motion:reduce){#strip{animation:none}}\n@keyframes film{",
            seconds);
    for (long i = 0; i < film->count; i++)
        fprintf(stream, "%.4f%%{transform:translateX(-%ldpx)}\n", 100 * film->times[i] / seconds, i * step);
    fprintf(stream, "}</style>\n<g id=\"strip\" transform=\"translate(-%ld 0)\">\n",
            (film->count - 1) * step);
    for (long i = 0; i < film->count; i++) {
        fprintf(stream, "<g transform=\"translate(%ld 0)\">", i * step);
        for (int y = 0; y < film->look.height; y++)
            fprintf(stream, "<use href=\"#r%ld\" y=\"%d\"/>", film->numbers[i * film->look.height + y],
                    y * CELL_HEIGHT);
        fputs("</g>\n", stream);
    }
    fputs("</g>\n</svg>\n", stream);
    return true;
}

static void close_svg(Film *film)
{
    free(film->rows);
    free(film->cells);
    free(film->times);
    free(film->numbers);
    free(film);
}

const FilmFormat film_svg = {".svg", 10, open_svg, add_to_svg, end_svg, close_svg};

/* What a terminal's colours are outside of one. */

/* xterm's palette: 16 named colours, a cube of six levels each way, 24 greys. */
static unsigned palette(int colour)
{
    static const unsigned named[16] = {0x000000, 0xcd0000, 0x00cd00, 0xcdcd00, 0x0000ee, 0xcd00cd,
                                       0x00cdcd, 0xe5e5e5, 0x7f7f7f, 0xff0000, 0x00ff00, 0xffff00,
                                       0x5c5cff, 0xff00ff, 0x00ffff, 0xffffff};
    static const unsigned levels[6] = {0, 95, 135, 175, 215, 255};
    if (colour < 16)
        return named[colour];
    if (colour >= 232) {
        const unsigned grey = 8 + 10 * (unsigned)(colour - 232);
        return grey << 16 | grey << 8 | grey;
    }
    const int place = colour - 16;
    return levels[place / 36] << 16 | levels[place / 6 % 6] << 8 | levels[place % 6];
}

unsigned film_ink(int colour, bool light)
{
    return colour != LOOK_DEFAULT ? palette(colour) : light ? 0x202020 : 0xd8d8d8;
}

unsigned film_paper(int colour, bool light)
{
    return colour != LOOK_DEFAULT ? palette(colour) : light ? 0xffffff : 0x141618;
}
