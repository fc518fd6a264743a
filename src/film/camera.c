/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "film/camera.h"

#include <math.h>
#include <string.h>

static bool same_picture(const Canvas *a, const Canvas *b)
{
    const size_t cells = (size_t)a->width * (size_t)a->height;
    return a->width == b->width && a->height == b->height && a->cursor_x == b->cursor_x &&
           a->cursor_y == b->cursor_y && memcmp(a->cells, b->cells, cells * sizeof *a->cells) == 0;
}

static bool keep(Camera *camera, const Canvas *canvas, Status *status)
{
    Canvas *last = &camera->last;
    if ((last->width != canvas->width || last->height != canvas->height || !last->cells) &&
        !canvas_open(last, canvas->width, canvas->height, status))
        return false;
    memcpy(last->cells, canvas->cells,
           (size_t)canvas->width * (size_t)canvas->height * sizeof *canvas->cells);
    last->cursor_x = canvas->cursor_x;
    last->cursor_y = canvas->cursor_y;
    return true;
}

/* Seconds of the film since the last picture. */
static double since_last(const Camera *camera, double seconds)
{
    return fmin((seconds - camera->taken_at) / camera->speed, camera->idle);
}

static bool begin(Camera *camera, Status *status)
{
    camera->film = camera->format->open(camera->stream, &camera->look, status);
    return camera->film != NULL;
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
    const bool first = camera->count == 0;
    const double passed = first ? 0 : since_last(camera, seconds);
    if (!first && !moment->must && passed < (1 - 1e-9) / camera->fps)
        return true;
    if (!first && same_picture(canvas, &camera->last))
        return true;
    if (camera->count >= FILM_PICTURES_MAX)
        return status_refuse(status,
                             "the film has more than %d pictures (a part of it: --from, --to; fewer: --fps; "
                             "faster: --speed)",
                             FILM_PICTURES_MAX);
    if (first && !begin(camera, status))
        return false;
    camera->shown_at += passed;
    camera->taken_at = seconds;
    camera->count++;
    return keep(camera, canvas, status) &&
           camera->format->add(camera->film, canvas, camera->shown_at, status);
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
