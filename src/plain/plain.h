/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The laboratory by lines: a line in is a key or what stands behind `:`, what it changed on the screen comes
 * out in words (picture/words/tell.h). The same laboratory, with a clock that only frames move: the same
 * lines give the same words, always. For screen readers, slow links, logs and pipes.
 *
 *     ]            a key by its name: a character, Space, Enter, Esc, Up, ...; an empty line is Enter
 *     show probe   anything else: a command by name, KEY=VALUE, a time (12.5), a word with its arguments
 *     :5           the same where it could be a key too
 *     more         the body and the curves; beside a page of a lesson, which is printed in ten lines, also
 * its rest, the stage and the inspector, which wait for it
 *
 * While a question or a field is open the line is its answer. A run goes on to where it stops, or to its
 * end, before the next line is read; on a terminal ^C pauses it. */
#ifndef PLAIN_PLAIN_H
#define PLAIN_PLAIN_H

#include "lab/laboratory.h"
#include "picture/words/tell.h"

#include <stdio.h>

typedef struct Plain {
    Laboratory lab;
    Canvas canvas; /* drawn on as everywhere: what panes can show decides what some keys do */
    FILE *out;
    double time;    /* virtual, unless somebody sits there */
    double seen_at; /* on the wall: so far it has gone on */
    bool echo;      /* input is not a terminal: each line is repeated before what it did */
    bool all_help;  /* not the beginning alone is asked for */
    bool talks;     /* progress of long work is reported */
    double told_at;
    Words last[TELL_PARTS]; /* what was printed of each */
    long step, stage;       /* where that was */
    bool page;              /* beside a page of a lesson */
    bool turned;            /* to another page, by this line */
    int lines;              /* printed for this line so far */
    Words rest;             /* of the page, which waits for `more` */
    const Experiment *of;   /* of which run, with which values */
    Settings settings;
    bool said; /* the line had an answer */
} Plain;

/* Tells what there is at first. False: the status says why; nothing is left open. */
bool plain_open(Plain *, const LaboratoryOptions *, FILE *out, Status *);
void plain_close(Plain *);

/* One line, without its end, and what it does. False: the picture has no memory. */
bool plain_line(Plain *, const char *line, Status *);

/* Lines of a stream until it ends or the laboratory is left. The result is the exit status. */
int plain_play(FILE *in, const char *name, FILE *out, const LaboratoryOptions *, Session *recording,
               Status *);

#endif
