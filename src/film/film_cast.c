/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The film as a recording for asciinema, version 2: a line that describes it, then a line for each picture,
 * [seconds, "o", "bytes for the terminal"]. The bytes are those that ncurses would send to an xterm. */
#include "film/film.h"

#include "base/text.h"
#include "terminal/grid.h"

#include <stdlib.h>
#include <string.h>

static const char term[] = "xterm-256color";

struct Film {
    FILE *stream;
    Grid grid;
    int width, height; /* of the picture before */
};

static Film *open_cast(FILE *stream, const FilmLook *look, Status *status)
{
    const char *stand_in;
    Film *film = calloc(1, sizeof *film);
    if (!film)
        status_fail(status, "out of memory");
    if (!film || !grid_open(&film->grid, term, false, &stand_in, status)) {
        free(film);
        return NULL;
    }
    film->stream = stream;
    film->grid.colours = 256;
    film->grid.light = look->light;
    film->grid.utf8 = true;
    fprintf(stream, "{\"version\": 2, \"width\": %d, \"height\": %d, \"title\": ", look->width, look->height);
    text_put_json(stream, look->title, strlen(look->title));
    fprintf(stream, ", \"env\": {\"TERM\": \"%s\"}}\n", term);
    return film;
}

static bool add_to_cast(Film *film, const Canvas *canvas, double seconds, Status *status)
{
    Grid *grid = &film->grid;
    if (film->width != canvas->width || film->height != canvas->height) {
        grid_resize(grid, canvas->width, canvas->height);
        if (film->width > 0)
            fprintf(film->stream, "[%.3f, \"r\", \"%dx%d\"]\n", seconds, canvas->width, canvas->height);
        film->width = canvas->width;
        film->height = canvas->height;
    }
    grid_show(grid, canvas);
    if (grid->why_lost)
        return status_fail(status, "a picture of the recording could not be drawn: %s",
                           strerror(grid->why_lost));
    size_t count;
    const char *bytes = grid_bytes(&film->grid, &count);
    fprintf(film->stream, "[%.3f, \"o\", ", seconds);
    text_put_json(film->stream, bytes, count);
    fputs("]\n", film->stream);
    grid_sent(&film->grid, count);
    return true;
}

static bool end_cast(Film *film, double seconds, Status *status)
{
    (void)status;
    fprintf(film->stream, "[%.3f, \"o\", \"\"]\n", seconds);
    return true;
}

static void close_cast(Film *film)
{
    grid_close(&film->grid);
    free(film);
}

const FilmFormat film_cast = {".cast", 30, open_cast, add_to_cast, end_cast, close_cast};
