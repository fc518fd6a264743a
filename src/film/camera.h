/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The camera in front of the laboratory: which pictures of it become a film, and when each appears. */
#ifndef FILM_CAMERA_H
#define FILM_CAMERA_H

#include "base/cancel.h"
#include "film/film.h"

#define CAMERA_LAST_SECONDS 2.0 /* for that long the last picture stands */

typedef struct Camera {
    /* Given by who films. */
    const FilmFormat *format;
    FILE *stream;
    FilmLook look;   /* its width and height are those of the largest picture that can come */
    double fps;      /* pictures a second at most */
    double speed;    /* seconds of the laboratory in a second of the film */
    double idle;     /* nothing stands still for longer, seconds of the film */
    double from, to; /* time of the run between which is filmed */
    Cancel cancel;   /* told the share of the run that is done */

    /* Kept between pictures. */
    Film *film;
    Canvas last;     /* the picture that stands now */
    double taken_at; /* when it was taken, by the laboratory's clock */
    double shown_at; /* where in the film it appeared */
    long count;      /* pictures so far */
    double share;    /* of the run */
    bool paused;     /* the run is outside `from` to `to` */
} Camera;

typedef struct CameraMoment {
    double seconds; /* by the laboratory's clock */
    double time;    /* of the run */
    double share;   /* of the run that is done */
    bool must;      /* the picture may not be left out, whether it is due or not */
} CameraMoment;

/* Looks at the laboratory's screen: a picture is taken where one is due and differs from the last. */
bool camera_look(Camera *, const Canvas *, const CameraMoment *, Status *);

/* False: the user does not want to wait any more. */
bool camera_goes_on(const Camera *);

/* The film is complete. False too if there is no picture in it. */
bool camera_end(Camera *, double seconds, Status *);

void camera_close(Camera *);

#endif
