/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rows of a plate (scenario/rows/rows.h) changed by the user: added, copied, deleted, edited as text
 * in the parameter pane, and moved on the map, by the arrows or the mouse. Every change is undone like that
 * of a parameter; a row that is being moved is a draft until Enter. */
#ifndef LAB_ROW_EDIT_H
#define LAB_ROW_EDIT_H

#include "lab/laboratory.h"

/* Enter in the pane: a new row is put on the map, another one opens as the field "NAME = VALUES", or one
 * value that is asked about. */
void row_edit_begin(Laboratory *);

/* An arrow: the next value of the chosen parameter, or of a row's that is asked about. */
void row_edit_nudge(Laboratory *, int direction, bool fine);

/* "NAME VALUES", "NAME none" or "NAME = VALUES" for a kind. False: the status says why. */
bool row_edit_line(Laboratory *, int kind, const char *words, Status *);

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
