/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A film of the laboratory: pictures of its screen, each with the second at which it appears, as one file.
 *
 * A format is a row of `film_formats` and a file of its own. Pictures arrive in their order, whole, and only
 * where something has changed; what they are made of is the canvas, so the same run gives the same film. */
#ifndef FILM_FILM_H
#define FILM_FILM_H

#include "base/cancel.h"
#include "base/status.h"
#include "picture/canvas.h"

#include <stdbool.h>
#include <stdio.h>

enum { FILM_PICTURES_MAX = 36000 }; /* of one film */

typedef struct FilmLook {
    int width, height; /* cells */
    bool light;        /* ground */
    const char *title;
} FilmLook;

typedef struct Film Film;

typedef struct FilmFormat {
    const char *ending; /* of the file's name: ".svg" */
    double fps;         /* pictures a second at most, if nothing is asked for */
    /* Begins a film on `stream`. NULL: the status says why. */
    Film *(*open)(FILE *stream, const FilmLook *, Status *);
    /* A picture that stands from `seconds` on. */
    bool (*add)(Film *, const Canvas *, double seconds, Status *);
    /* The last one stands until `seconds`; the stream stays open. */
    bool (*end)(Film *, double seconds, Status *);
    void (*close)(Film *); /* frees */
} FilmFormat;

extern const FilmFormat film_cast, film_svg, film_gif;

/* The format that a file's name asks for; NULL: there is none, and the status names those there are. */
const FilmFormat *film_format(const char *name, Status *);

/* A colour of a terminal's 256 as 0xRRGGBB; LOOK_DEFAULT is the ground's own, as ink or as paper. */
unsigned film_ink(int colour, bool light);
unsigned film_paper(int colour, bool light);

/* --- the camera ----------------------------------------------------------------------------------- */

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
