/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Keys and values of a scenario as texts, and the names of what settings.h and problems/problem.h hold:
 * enough for a header that passes settings on. Who reads a value of them includes settings.h. */
#ifndef SCENARIO_ASSIGNMENT_H
#define SCENARIO_ASSIGNMENT_H

typedef struct Settings Settings;         /* scenario/settings.h */
typedef struct Problem Problem;           /* problems/problem.h */
typedef struct ViewSettings ViewSettings; /* scenario/concern_output.h */

typedef enum MethodKind { METHOD_MPM, METHOD_PD } MethodKind;
enum { METHODS = METHOD_PD + 1 };

enum {
    TITLE_MAX = 80, /* bytes, with the final zero; so the others */
    ABOUT_MAX = 1024,
    LIST_MAX = 256,  /* overtones, times of frames; a row */
    KEY_MAX = 40,    /* "pd.surface_correction" */
    VALUE_MAX = 64,  /* the text of a value */
    DUEL_MAX = 8,    /* keys in which the second run of a duel differs */
    CHANGES_MAX = 64 /* changes of live parameters in mid-run */
};

typedef struct Assignment {
    char key[KEY_MAX];
    char value[VALUE_MAX];
} Assignment;

/* "from this step on, key = value" */
typedef struct Change {
    long step;
    Assignment to;
} Change;

#endif
