/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The film as a GIF, through giflib, its letters through cairo. Each picture is the rectangle of cells that
 * changed, with a table of colours of its own: the colours of the cells and, at the edges of letters, two
 * steps between ink and paper. */
#include "film/film.h"

#if defined HAVE_CAIRO && defined HAVE_GIF

#include "picture/paper/cairo_calls.h"
#include "terminal/grid.h"

#include <errno.h>
#include <gif_lib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CELL_WIDTH = 8, CELL_HEIGHT = 17, BASELINE = 13, FONT = 13, COLOURS = 256, LEVELS = 4 };

struct Film {
    GifFileType *gif;
    FILE *stream;
    int why; /* errno of a write that failed; 0: none did */
    FilmLook look;
    cairo_surface_t *surface; /* a cell, or the two of a wide character: how much of each pixel is ink */
    cairo_t *cairo;
    Cell *cells;           /* the picture before */
    unsigned char *pixels; /* numbers of colours */
    unsigned colours[COLOURS];
    int n_colours;
    /* The picture that stands; it is written when it is known until when. */
    struct {
        int x, y, width, height; /* pixels */
        double seconds;
        bool any;
    } waiting;
};

static int write_bytes(GifFileType *gif, const GifByteType *bytes, int count)
{
    Film *film = gif->UserData;
    errno = 0;
    const size_t written = fwrite(bytes, 1, (size_t)count, film->stream);
    if (written < (size_t)count && film->why == 0)
        film->why = errno;
    return (int)written;
}

static bool fails(const Film *film, Status *status)
{
    const char *why = film->why ? strerror(film->why) : film->gif ? GifErrorString(film->gif->Error) : NULL;
    return status_fail(status, "the film: %s", why ? why : "it cannot be written");
}

/* --- pixels -------------------------------------------------------------------------------------- */

static int distance(unsigned a, unsigned b)
{
    int sum = 0;
    for (int shift = 0; shift <= 16; shift += 8) {
        const int difference = (int)(a >> shift & 0xff) - (int)(b >> shift & 0xff);
        sum += difference * difference;
    }
    return sum;
}

/* The number of a colour, or of the nearest one once the table is full. */
static unsigned char number_of(Film *film, unsigned colour)
{
    int nearest = 0;
    for (int i = 0; i < film->n_colours; i++) {
        if (film->colours[i] == colour)
            return (unsigned char)i;
        if (distance(film->colours[i], colour) < distance(film->colours[nearest], colour))
            nearest = i;
    }
    if (film->n_colours == COLOURS)
        return (unsigned char)nearest;
    film->colours[film->n_colours] = colour;
    return (unsigned char)film->n_colours++;
}

/* `level` of LEVELS - 1 parts ink. */
static unsigned blend(unsigned ink, unsigned paper, int level)
{
    unsigned colour = 0;
    for (int shift = 0; shift <= 16; shift += 8) {
        const int a = (int)(paper >> shift & 0xff), b = (int)(ink >> shift & 0xff);
        colour |= (unsigned)(a + (b - a) * level / (LEVELS - 1)) << shift;
    }
    return colour;
}

/* Fonts often lack braille, and draw blocks with gaps. */
static bool draw_shape(cairo_t *cairo, uint32_t glyph)
{
    static const int column[8] = {0, 0, 0, 1, 1, 1, 0, 1}, row[8] = {0, 1, 2, 0, 1, 2, 3, 3};
    if (glyph >= 0x2800 && glyph <= 0x28ff) {
        for (int dot = 0; dot < 8; dot++)
            if (glyph >> dot & 1)
                CAIRO(rectangle)(cairo, 1 + 4 * column[dot], 1 + 4 * row[dot], 2, 2);
    } else if (glyph == 0x2580) {
        CAIRO(rectangle)(cairo, 0, 0, CELL_WIDTH, (CELL_HEIGHT + 1) / 2);
    } else if (glyph == 0x2584) {
        CAIRO(rectangle)(cairo, 0, (CELL_HEIGHT + 1) / 2, CELL_WIDTH, CELL_HEIGHT / 2);
    } else if (glyph == 0x2588) {
        CAIRO(rectangle)(cairo, 0, 0, CELL_WIDTH, CELL_HEIGHT);
    } else
        return false;
    CAIRO(fill)(cairo);
    return true;
}

static void draw_cell(Film *film, int x, int y, const Cell *cell)
{
    const Look look = theme_look(256, film->look.light, cell->style, cell->back);
    const bool reversed = look.attributes & LOOK_REVERSE;
    const unsigned ink = film_ink(look.foreground, film->look.light);
    const unsigned paper = film_paper(look.background, film->look.light);
    unsigned char numbers[LEVELS];
    for (int level = 0; level < LEVELS; level++)
        numbers[level] = number_of(film, blend(reversed ? paper : ink, reversed ? ink : paper, level));
    const uint32_t glyph = cell->glyph ? cell->glyph : ' ';
    char text[5] = "";
    CAIRO(set_operator)(film->cairo, CAIRO_OPERATOR_CLEAR);
    CAIRO(paint)(film->cairo);
    CAIRO(set_operator)(film->cairo, CAIRO_OPERATOR_OVER);
    if (!draw_shape(film->cairo, glyph)) {
        glyph_put(text, glyph);
        CAIRO(select_font_face)
        (film->cairo, "monospace", CAIRO_FONT_SLANT_NORMAL,
         look.attributes & LOOK_BOLD ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
        CAIRO(move_to)(film->cairo, 0, BASELINE);
        CAIRO(show_text)(film->cairo, text);
    }
    if (look.attributes & LOOK_UNDERLINE) {
        CAIRO(rectangle)(film->cairo, 0, BASELINE + 2, 2 * CELL_WIDTH, 1);
        CAIRO(fill)(film->cairo);
    }
    CAIRO(surface_flush)(film->surface);
    const unsigned char *covered = CAIRO(image_surface_get_data)(film->surface);
    const int stride = CAIRO(image_surface_get_stride)(film->surface);
    const int width = CELL_WIDTH * (x + 1 < film->look.width && glyph_columns(cell->glyph) == 2 ? 2 : 1);
    for (int j = 0; j < CELL_HEIGHT; j++)
        for (int i = 0; i < width; i++) {
            const size_t at = (size_t)(y * CELL_HEIGHT + j) * (size_t)film->look.width * CELL_WIDTH +
                              (size_t)(x * CELL_WIDTH + i);
            film->pixels[at] = numbers[(covered[j * stride + i] * (LEVELS - 1) + 127) / 255];
        }
}

/* --- pictures ------------------------------------------------------------------------------------ */

/* The picture that waits stands until `seconds`. Times are rounded where they are, so that they do not drift.
 */
static bool write_waiting(Film *film, double seconds, Status *status)
{
    if (!film->waiting.any)
        return true;
    const long delay = lround(100 * seconds) - lround(100 * film->waiting.seconds);
    const GraphicsControlBlock block = {DISPOSE_DO_NOT, false, (int)(delay > 65535 ? 65535 : delay),
                                        NO_TRANSPARENT_COLOR};
    GifByteType bytes[4];
    EGifGCBToExtension(&block, bytes);
    GifColorType colours[COLOURS];
    for (int i = 0; i < COLOURS; i++) {
        const unsigned colour = i < film->n_colours ? film->colours[i] : 0;
        colours[i] = (GifColorType){(GifByteType)(colour >> 16), (GifByteType)(colour >> 8 & 0xff),
                                    (GifByteType)(colour & 0xff)};
    }
    ColorMapObject *map = GifMakeMapObject(COLOURS, colours);
    bool sound = map && EGifPutExtension(film->gif, GRAPHICS_EXT_FUNC_CODE, 4, bytes) == GIF_OK &&
                 EGifPutImageDesc(film->gif, film->waiting.x, film->waiting.y, film->waiting.width,
                                  film->waiting.height, false, map) == GIF_OK;
    GifFreeMapObject(map);
    const size_t stride = (size_t)film->look.width * CELL_WIDTH;
    for (int j = 0; sound && j < film->waiting.height; j++)
        sound = EGifPutLine(film->gif,
                            film->pixels + (size_t)(film->waiting.y + j) * stride + (size_t)film->waiting.x,
                            film->waiting.width) == GIF_OK;
    return sound || fails(film, status);
}

static bool add_to_gif(Film *film, const Canvas *canvas, double seconds, Status *status)
{
    if (!write_waiting(film, seconds, status))
        return false;
    int left = film->look.width, right = -1, top = film->look.height, bottom = -1;
    for (int y = 0; y < film->look.height; y++)
        for (int x = 0; x < film->look.width; x++) {
            const Cell cell = x < canvas->width && y < canvas->height ? canvas->cells[y * canvas->width + x]
                                                                      : (Cell){.glyph = ' '};
            Cell *before = &film->cells[y * film->look.width + x];
            if (film->waiting.any && memcmp(&cell, before, sizeof cell) == 0)
                continue;
            *before = cell;
            if (cell.glyph == CELL_FOLLOWS)
                continue;
            draw_cell(film, x, y, &cell);
            const int end = x + (glyph_columns(cell.glyph) == 2 && x + 1 < film->look.width);
            left = x < left ? x : left;
            right = end > right ? end : right;
            top = y < top ? y : top;
            bottom = y;
        }
    if (right < 0) /* the cursor alone */
        left = right = top = bottom = 0;
    film->waiting.x = left * CELL_WIDTH;
    film->waiting.y = top * CELL_HEIGHT;
    film->waiting.width = (right - left + 1) * CELL_WIDTH;
    film->waiting.height = (bottom - top + 1) * CELL_HEIGHT;
    film->waiting.seconds = seconds;
    film->waiting.any = true;
    return true;
}

static bool end_gif(Film *film, double seconds, Status *status)
{
    int error = 0;
    if (!write_waiting(film, seconds, status))
        return false;
    const int result = EGifCloseFile(film->gif, &error);
    film->gif = NULL;
    return result == GIF_OK || fails(film, status);
}

/* --- opening and closing ------------------------------------------------------------------------- */

static void close_gif(Film *film)
{
    int error;
    if (film->gif)
        EGifCloseFile(film->gif, &error);
    if (film->cairo)
        CAIRO(destroy)(film->cairo);
    if (film->surface)
        CAIRO(surface_destroy)(film->surface);
    free(film->cells);
    free(film->pixels);
    free(film);
}

static Film *open_gif(FILE *stream, const FilmLook *look, Status *status)
{
    int error = 0;
    const size_t cells = (size_t)look->width * (size_t)look->height;
    if (!cairo_load(status))
        return NULL;
    Film *film = calloc(1, sizeof *film);
    if (film) {
        film->look = *look;
        film->stream = stream;
        film->cells = calloc(cells, sizeof *film->cells);
        film->pixels = calloc(cells, (size_t)CELL_WIDTH * CELL_HEIGHT);
        film->surface = CAIRO(image_surface_create)(CAIRO_FORMAT_A8, 2 * CELL_WIDTH, CELL_HEIGHT);
        film->cairo = CAIRO(create)(film->surface);
        film->gif = EGifOpen(film, write_bytes, &error);
    }
    if (!film || !film->cells || !film->pixels || !film->gif ||
        CAIRO(status)(film->cairo) != CAIRO_STATUS_SUCCESS) {
        status_fail(status, "out of memory");
        if (film)
            close_gif(film);
        return NULL;
    }
    CAIRO(set_font_size)(film->cairo, FONT);
    /* It is played again and again, as browsers do it since Netscape's. */
    static const GifByteType for_ever[3] = {1, 0, 0};
    EGifSetGifVersion(film->gif, true);
    if (!(EGifPutScreenDesc(film->gif, film->look.width * CELL_WIDTH, film->look.height * CELL_HEIGHT, 8, 0,
                            NULL) == GIF_OK &&
          EGifPutExtensionLeader(film->gif, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
          EGifPutExtensionBlock(film->gif, 11, "NETSCAPE2.0") == GIF_OK &&
          EGifPutExtensionBlock(film->gif, 3, for_ever) == GIF_OK &&
          EGifPutExtensionTrailer(film->gif) == GIF_OK)) {
        fails(film, status);
        close_gif(film);
        return NULL;
    }
    return film;
}

const FilmFormat film_gif = {".gif", 10, open_gif, add_to_gif, end_gif, close_gif};

#else

static Film *open_gif(FILE *stream, const FilmLook *look, Status *status)
{
    (void)stream;
    (void)look;
    status_refuse(status, "this matvib was built without giflib or cairo: no .gif, but .svg and "
                          ".cast");
    return NULL;
}

const FilmFormat film_gif = {".gif", 10, open_gif, NULL, NULL, NULL};

#endif
