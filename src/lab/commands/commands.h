/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions of the command table, a file for each kind; private to src/lab. */
#ifndef LAB_COMMANDS_COMMANDS_H
#define LAB_COMMANDS_COMMANDS_H

#include "lab/laboratory.h"

typedef struct CommandFunction {
    CommandId id;
    void (*run)(Laboratory *);
    void (*run_by)(Laboratory *, int by); /* in place of it */
    int by;
} CommandFunction;

/* One for each row of the command table. */
extern const CommandFunction command_functions[];
extern const int n_command_functions;

#define COMMAND(id, function, ...)        void function(Laboratory *);
#define COMMAND_BY(id, function, by, ...) void function(Laboratory *, int);
#define DIGIT(n)
#include "help/command_rows.inc"

#include <stdbool.h>
#undef COMMAND
#undef DIGIT

/* time_commands.c: they answer the `:` line. */
bool command_answer_go_to(Laboratory *, const char *text, Status *);
bool command_answer_until(Laboratory *, const char *text, Status *);
bool command_answer_event(Laboratory *, const char *text, Status *);
bool command_answer_magnify(Laboratory *, const char *text, Status *);
bool command_answer_loop(Laboratory *, const char *text, Status *);

/* move_commands.c */
void command_close_inspector(Screen *);
void command_zoom_out(Screen *);
bool command_close_top(Laboratory *); /* what lies on top; false: there is nothing */

/* view_commands.c */
void command_show_view(Laboratory *, const View *);
void command_show_digit(Laboratory *, int digit); /* the view that has this key */

void command_show_sheet(Laboratory *, Sheet); /* kept from start to start, but beside a lesson */

/* The map of a beam. */
void command_map_whole(Screen *); /* ends it */
void command_map_magnify(Screen *, int direction);
bool command_map_is_focused(const Screen *);
void command_map_enlarge(Laboratory *, int direction); /* displacements; 0: automatic */

/* A second run beside the first. */

void command_second_open(Laboratory *); /* of a scenario that has keys for one */

/* Begins with the scenario's keys, or ends; asks where there are no keys. */
void command_second_toggle(Laboratory *);
bool command_second_answer(Laboratory *, const char *words, Status *); /* "KEY=VALUE ..." */

#endif
