/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is typed and chosen: the rows of the parameter pane, and what the key line has in place of keys, a
 * question or a message. */
#ifndef PANES_ENTRY_H
#define PANES_ENTRY_H

#include "scenario/assignment.h"
#include "scenario/parameters.h"
#include "scenario/rows/rows.h"

#include <stdbool.h>

typedef struct Screen Screen; /* panes/screen.h */

enum { ROW_NEW = -1 };

/* One row of the parameter pane. */
typedef struct ParameterRow {
    const char *heading;        /* a heading, or NULL */
    const Parameter *parameter; /* an editable row, or NULL */
    int derived;                /* index of a read-only row, or -1 */
    bool is_row;                /* a row of a plate (scenario/rows/rows.h) */
    RowPlace place;             /* which one, or ROW_NEW: the place for one more; or one value of it */
} ParameterRow;

enum { PARAMETER_ROWS_MAX = 192 };

/* Typing a value into the selected parameter. */
typedef struct FieldEdit {
    bool open;
    char text[LIST_MAX];
    int cursor;        /* in characters */
    char problem[160]; /* why the last entry was refused */
} FieldEdit;

/* A row of a plate (scenario/rows/rows.h) that is being moved on the map. */
enum { ROW_FIRST_END, ROW_SECOND_END, ROW_BOTH_ENDS, ROW_ENDS };

typedef struct RowsShown {
    bool placing;
    int kind, row;         /* which one */
    int end;               /* which of its ends the arrows move */
    const Settings *draft; /* while it is moved: with the row where it is now */
} RowsShown;

typedef struct ParametersShown {
    RowsShown rows;
    int selected;    /* row */
    char filter[32]; /* parameters whose label or key holds it */
    FieldEdit edit;
} ParametersShown;

/* The rows of the pane, for drawing and for moving in it. Returns how many. */
int screen_parameter_rows(const Screen *, ParameterRow rows[PARAMETER_ROWS_MAX]);

/* The row that is chosen; false: there is none. */
bool screen_chosen_row(const Screen *, ParameterRow *);

/* Whether a row of a plate, or the place for a new one, is chosen among them. */
bool screen_selected_row(const Screen *, RowPlace *);

/* The settings whose rows the map shows: while one is moved those with it where it is now. Which row is
 * chosen in the parameter pane, if that has the focus; else kind -1. */
const Settings *screen_rows_shown(const Screen *, int *kind, int *row);

/* The row that the arrows are to change: that of this parameter or, where it has none, the first one. */
int screen_row_of(const Screen *, const Parameter *);

/* --- the key line --------------------------------------------------------------------------------- */

typedef enum MessageKind { MESSAGE_NONE, MESSAGE_INFO, MESSAGE_WARNING, MESSAGE_ERROR } MessageKind;

typedef struct Message {
    MessageKind kind;
    char text[512];
} Message;

enum { SCENARIOS_MAX = 96, SCENARIO_NAME_MAX = 64 };

/* Scenarios to choose from while a name is asked for: those whose name or title holds what was typed. */
typedef struct ScenarioList {
    struct {
        char name[SCENARIO_NAME_MAX];
        char title[TITLE_MAX];
    } entries[SCENARIOS_MAX];
    int count;
    int shown[SCENARIOS_MAX]; /* indices of entries */
    int n_shown;
    int chosen; /* of those shown; -1: none */
    int open;   /* of those shown, the one that is on screen; -1: none */
} ScenarioList;

/* A line that asks for text, or for yes or no. */
typedef struct Prompt {
    bool open;
    bool yes_no;
    bool wants_y; /* of yes and no: Enter means no */
    char question[96];
    char text[256];
    int cursor;                    /* in characters */
    char problem[320];             /* why the last answer was refused; "" at first */
    char hint[320];                /* what may be answered; shown as long as nothing was refused */
    const ScenarioList *scenarios; /* above the line; NULL: none */
} Prompt;

#endif
