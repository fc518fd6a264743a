/* The functions of the command table, a file for each kind; private to src/tui. */
#ifndef TUI_COMMANDS_H
#define TUI_COMMANDS_H

#include "tui/control/laboratory.h"

/* time_commands.c */
void command_run_or_pause(Laboratory *);
void command_step_forward(Laboratory *);
void command_step_back(Laboratory *);
void command_step_forward_ten(Laboratory *);
void command_step_back_ten(Laboratory *);
void command_stage_forward(Laboratory *);
void command_stage_back(Laboratory *);
void command_faster(Laboratory *);
void command_slower(Laboratory *);
void command_to_start(Laboratory *);
void command_to_newest(Laboratory *);
void command_go_to(Laboratory *);
bool command_answer_go_to(Laboratory *, const char *text);
void command_restart(Laboratory *);
void command_bookmark(Laboratory *);
void command_jump(Laboratory *);

/* move_commands.c */
void command_next_pane(Laboratory *);
void command_previous_pane(Laboratory *);
void command_up(Laboratory *);
void command_down(Laboratory *);
void command_left(Laboratory *);
void command_right(Laboratory *);
void command_page_up(Laboratory *);
void command_page_down(Laboratory *);
void command_enter(Laboratory *);
void command_close_inspector(Screen *);
void command_inspect(Laboratory *);
bool command_close_top(Laboratory *); /* what lies on top; false: there is nothing */
void command_cancel(Laboratory *);

/* view_commands.c */
void command_show_view(Laboratory *, const View *);
void command_show_digit(Laboratory *, int digit); /* the view that has this key */
void command_zoom(Laboratory *);
void command_lecture(Laboratory *);
void command_narrower(Laboratory *);
void command_wider(Laboratory *);
void command_automatic(Laboratory *);
void command_cycle_references(Laboratory *);
void command_cycle_glyphs(Laboratory *);

/* compare_commands.c */
void command_question(Laboratory *);
void command_pin(Laboratory *);
void command_undo(Laboratory *);
void command_redo(Laboratory *);

/* map_commands.c: the map of a beam. */
void command_map_zoom(Laboratory *); /* begins to magnify it, or ends that */
void command_map_whole(Screen *);    /* ends it */
void command_map_magnify(Screen *, int direction);
void command_map_pan(Screen *, int x, int y);
bool command_map_is_focused(const Screen *);
void command_map_enlarge(Laboratory *, int direction); /* displacements; 0: automatic */

#endif
