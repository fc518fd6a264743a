/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The formats of films; the camera, which says what becomes of pictures and when; and the plainest format. */
#include "film/film.h"

#include "base/text.h"
#include "terminal/grid.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- formats -------------------------------------------------------------------------------------- */

static const FilmFormat *const formats[] = {&film_cast, &film_svg, &film_gif, NULL};

const FilmFormat *film_format(const char *name, Status *status)
{
    const size_t length = strlen(name);
    for (int i = 0; formats[i]; i++) {
        const size_t tail = strlen(formats[i]->ending);
        if (length > tail && strcmp(name + length - tail, formats[i]->ending) == 0)
            return formats[i];
    }
    status_refuse(status, "%.200s: a film's name ends in .cast (asciinema), .svg (animated) or .gif", name);
    return NULL;
}

/* --- the camera ----------------------------------------------------------------------------------- */

static bool same_picture(const Canvas *a, const Canvas *b)
{
    const size_t cells = (size_t)a->width * (size_t)a->height;
    return a->width == b->width && a->height == b->height && a->cursor_x == b->cursor_x &&
           a->cursor_y == b->cursor_y && memcmp(a->cells, b->cells, cells * sizeof *a->cells) == 0;
}

/* Seconds of the film since the last picture. */
static double since_last(const Camera *camera, double seconds)
{
    return fmin((seconds - camera->taken_at) / camera->speed, camera->idle);
}

bool camera_goes_on(const Camera *camera)
{
    return !cancel_requested(&camera->cancel, camera->share);
}

bool camera_look(Camera *camera, const Canvas *canvas, const CameraMoment *moment, Status *status)
{
    const double seconds = moment->seconds;
    camera->share = moment->share;
    if (!camera_goes_on(camera))
        return status_fail(status, "interrupted");
    if (moment->time < camera->from || moment->time > camera->to) {
        camera->paused = true;
        return true;
    }
    if (camera->paused)
        camera->taken_at = seconds; /* what was left out takes no time */
    camera->paused = false;
    Canvas *last = &camera->last;
    const bool first = camera->count == 0;
    const double passed = first ? 0 : since_last(camera, seconds);
    if (!first && !moment->must && passed < (1 - 1e-9) / camera->fps)
        return true;
    if (!first && same_picture(canvas, last))
        return true;
    if (camera->count >= FILM_PICTURES_MAX)
        return status_refuse(status,
                             "the film has more than %d pictures (a part of it: --from, --to; fewer: --fps; "
                             "faster: --speed)",
                             FILM_PICTURES_MAX);
    if (first)
        camera->film = camera->format->open(camera->stream, &camera->look, status);
    if (!camera->film)
        return false;
    camera->shown_at += passed;
    camera->taken_at = seconds;
    camera->count++;
    if ((last->width != canvas->width || last->height != canvas->height || !last->cells) &&
        !canvas_open(last, canvas->width, canvas->height, status))
        return false;
    memcpy(last->cells, canvas->cells,
           (size_t)canvas->width * (size_t)canvas->height * sizeof *canvas->cells);
    last->cursor_x = canvas->cursor_x;
    last->cursor_y = canvas->cursor_y;
    return camera->format->add(camera->film, canvas, camera->shown_at, status);
}

bool camera_end(Camera *camera, double seconds, Status *status)
{
    if (camera->count == 0)
        return status_refuse(status, "there is nothing to be seen from time %g to %g (--from, --to)",
                             camera->from, camera->to);
    const double stood = camera->paused ? 0 : since_last(camera, seconds);
    return camera->format->end(camera->film, camera->shown_at + fmax(stood, CAMERA_LAST_SECONDS), status);
}

void camera_close(Camera *camera)
{
    if (camera->film)
        camera->format->close(camera->film);
    camera->film = NULL;
    canvas_close(&camera->last);
}

/* --- asciinema ------------------------------------------------------------------------------------ */

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
