/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The formats of films. */
#include "film/film.h"

#include <string.h>

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
