/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the words of a drawing stand: beside their things and on their arrows, none over another. What finds
 * no room is shortened, then left out, by one order for cells and paper: things, arrows, the numbers of
 * things, what is to spare. */
#ifndef PICTURE_PLACES_H
#define PICTURE_PLACES_H

#include "picture/picture.h"

enum { PLACES_MAX = 320 };

typedef struct Places Places;

/* A back end fills the first members, in its own unit, from the upper left corner of the drawing. */
struct Places {
    const Picture *picture;
    double width, height;
    double row; /* height of a line of words */
    double gap; /* between the middle of a thing and the words beside it */
    bool whole; /* columns and rows are whole numbers */
    double (*columns)(const Places *, const char *text);
    void (*write)(const Places *, double left, double top, const char *text, Style); /* NULL: only tried */
    const void *back_end;                                                            /* its own */

    struct PlaceTaken {
        double left, top, right, bottom;
    } taken[PLACES_MAX];
    int n_taken;
};

/* In that unit; across and down. */
double places_across(const Places *, double x);
double places_down(const Places *, double y);

void places_write(Places *);

#endif
