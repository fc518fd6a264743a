/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parameters changed by the user: chosen, nudged and edited in their pane, undone and done again. */
#ifndef LAB_EDIT_H
#define LAB_EDIT_H

#include "run/duel.h"
#include "terminal/keys.h"
#include "panes/entry.h"
#include "panes/screen.h"

typedef struct Laboratory Laboratory;

enum { UNDO_MAX = 32 };

typedef struct Editing {
    Settings *undo, *redo; /* values at t = 0 and changes in mid-run; UNDO_MAX each, the newest last */
    Settings *draft;       /* of a row that is being moved */
    int n_undo, n_redo;
    bool changed;                           /* since the last export: quitting asks */
    double anchor_time;                     /* the time that edits in a row come back to, */
    long anchor_step;                       /* and the step that it was at the last of them; -1: none */
    bool (*accept)(Laboratory *, Status *); /* takes what is in the open field; false: refused */
    bool fresh; /* the text in the field is the old value or one that was refused: a first character replaces
                   it */
} Editing;

/* The parameter in the chosen row; NULL: it has none. */
const Parameter *edit_selected(const Screen *);
void edit_move(Laboratory *, int rows); /* the choice */

void edit_nudge(Laboratory *, int direction, bool fine);
void edit_begin(Laboratory *); /* opens the field; of a choice: takes the next one */
/* Opens it with the text that is in it. `fresh`: a first character replaces that. */
void edit_open_field(Laboratory *, bool (*accept)(Laboratory *, Status *), bool fresh);
void edit_key(Laboratory *, const Key *);
bool edit_answer_filter(Laboratory *, const char *text, Status *);

/* New parameters, undoable. False: refused, the status says why. */
bool edit_change(Laboratory *, const Settings *, DuelChange, Status *);

/* duel_change(), not undoable; the chosen parameter stays chosen, and the particle is the one nearest to
 * where the chosen one was at first. */
bool edit_change_runs(Laboratory *, const Settings *, DuelChange, Status *);
void edit_changed(Laboratory *); /* what follows from it */

/* The rows of a plate (scenario/rows/rows.h) changed by the user: added, copied, deleted, edited as text
 * in the parameter pane, and moved on the map, by the arrows or the mouse. Every change is undone like that
 * of a parameter; a row that is being moved is a draft until Enter. */

/* Enter in the pane: a new row is put on the map, another one opens as the field "NAME = VALUES", or one
 * value that is asked about. */
void row_edit_begin(Laboratory *);

/* An arrow: the next value of the chosen parameter, or of a row's that is asked about. */
void row_edit_nudge(Laboratory *, int direction, bool fine);

/* "NAME VALUES", "NAME none" or "NAME = VALUES" for a kind. False: the status says why. */
bool row_edit_line(Laboratory *, const char *words, int kind, Status *);

/* Commands: a new row or a copy is put on the map; the chosen one goes, or is moved. */
void row_edit_add(Laboratory *);
void row_edit_copy(Laboratory *);
void row_edit_delete(Laboratory *);
void row_edit_move(Laboratory *);

/* A key while a row is moved: true, it meant that. */
bool row_edit_key(Laboratory *, const char *key);

/* The mouse at a place of the screen while a row is moved: its end comes there. */
void row_edit_point(Laboratory *, int x, int y);

#endif
