/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A film of the laboratory: pictures of its screen, each with the second at which it appears, as one file.
 *
 * A format is a row of `film_formats` and a file of its own. Pictures arrive in their order, whole, and only
 * where something has changed; what they are made of is the canvas, so the same run gives the same film. */
#ifndef FILM_FILM_H
#define FILM_FILM_H

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

#endif
