/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The whole screen as cells of a canvas, and what lies where on it: for the focus, for keys that scroll and
 * for the mouse. */
#ifndef PANES_SCREEN_PLACES_H
#define PANES_SCREEN_PLACES_H

#include "help/command.h"
#include "panes/screen.h"
#include "picture/canvas.h"

/* Draws everything. Below 40x12 a message. Never fails: what has no room is left out by a fixed order. */
void screen_draw(const Screen *, Canvas *);

/* Where a pane lies at this size; width 0: it is not shown. */
Rect screen_pane(const Screen *, int width, int height, PaneId);

/* Whether all panes of the sheet have room; on a smaller screen only the focused one, or the two plots, are
 * seen. */
bool screen_is_whole(const Screen *, int width, int height);

/* The command under column x of the key line; COMMAND_NONE: none. */
CommandId screen_key_command(const Screen *, int width, int x);

/* In the plot panes and the strip: a click on something that a view shows, and so many lines of the wheel.
 * False: nothing of a view lies there. */
bool screen_click_view(Screen *, int width, int height, int x, int y);
bool screen_scroll_view(Screen *, int width, int height, int x, int y, int by);

/* The row of the parameter pane at a place of the screen; -1: none. */
int screen_parameter_at(const Screen *, int width, int height, int x, int y);

/* How far the text of a lesson can be scrolled at this size; 0: all is seen. */
int screen_lesson_most(const Screen *, int width, int height);

/* Lessons in the list, and the one in a cell of it; -1: none. */
int screen_lesson_count(void);
int screen_lesson_at(const Screen *, int width, int height, int x, int y);

/* How many pages the help has, and how far the open one can be scrolled. */
int help_pages(const Screen *);
int help_most(const Screen *, int width, int height);

/* Finds the next line with these words, in any case, behind the last one found, through all pages and around.
 * False: there is none, and `at` stays as it is. */
bool help_search(const Screen *, int width, const char *words, HelpShown *at);

/* The step of a bookmark in the run as it is now. */
long screen_bookmark_step(const Screen *, int index);

/* The step that lies under a cell of the timeline; -1: the cell is not on it. */
long screen_timeline_step(const Screen *, int width, int height, int x, int y);

/* The step of the place of the timeline that is nearest to a column, in whatever row the mouse is. */
long screen_timeline_nearest(const Screen *, int width, int height, int x);

/* The place of the body, m, that is drawn in a cell of the screen as long as nothing has moved. False: no map
 * is drawn there. */
bool view_map_place(const Screen *, int width, int height, int x, int y, double place[2]);

/* The factor by which the beam's map draws displacements; 0: it is not shown. */
double view_map_enlargement(const Screen *, int width, int height);

#endif
