/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The laboratory: what the user does to a Screen. Keys come in as names, pictures go out as a Canvas; they
 * are the same for a terminal and for a script. */
#ifndef LAB_SESSION_LABORATORY_MAIN_H
#define LAB_SESSION_LABORATORY_MAIN_H

#include "base/status.h"
#include "scenario/assignment.h"

#include <stdbool.h>
#include <stddef.h>

/* The words of the command line that concern the laboratory. */
typedef struct LaboratoryOptions {
    const Settings *settings; /* resolved: scenario and --set */
    const char *scenario;     /* name or path as the user gave it, for the title line */
    bool is_coarse;           /* the coarse form of what was named */
    const char *lesson;       /* opened at once, or laboratory_all_lessons; NULL: none */
    const char *student;      /* whose homework it is: variants are drawn from the name; NULL: nobody's */
    const char *student_id;   /* by which a teacher's tables know that student; NULL: not given */
    const int *reached; /* per lesson of the program (LESSONS_MAX), pages turned to so far; NULL: none */
    bool first_start;   /* nothing is known of the user yet: the first lesson is offered */
    bool paused;        /* open paused */
    /* What it opens on, one of parameter_sheet_words; lessons begin on the plain one. NULL: nothing was said
     * of sheets, as when there was one alone: the full one, for lessons too */
    const char *sheet;
    bool keeps_sheet;   /* which sheet the user turns to is known at the next start */
    const char *glyphs; /* "auto", "braille", "block", "ascii"; NULL: auto */
    const char *theme;  /* "auto", "light", "dark"; NULL: auto */
    bool no_mouse;
    const char *record; /* the session is kept in this file; NULL: only as the last one */
    /* This session is done again, and settings, scenario, paused are its own; NULL: none */
    const char *replay;
    bool last;      /* replay the last session; `replay` is NULL */
    bool fast;      /* replay as fast as it can */
    bool force;     /* `record` may be replaced */
    size_t history; /* bytes for keyframes; 0: the default */
    int threads;    /* 0: one */
    /* Keys from this file ("-": standard input), screens to standard output; NULL: a terminal */
    const char *script;
    bool plain;            /* words in lines from standard input to standard output, no screen */
    int width, height;     /* with a script; 0: 80x24 */
    struct Camera *camera; /* films the script, the session or, without either, the run; NULL: none */
} LaboratoryOptions;

/* In place of a name: the list of lessons. */
extern const char laboratory_all_lessons[];

/* Opens the laboratory and returns when the user leaves it. The result is the exit status: 0, 128 + n after
 * signal n, otherwise that of the status, whose text main prints. The terminal is restored in every case. */
int laboratory_main(const LaboratoryOptions *, Status *);

#endif
