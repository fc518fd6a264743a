/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files from outside, opened and read line by line: whatever reads a user's file goes through here. Opening
 * never waits and never takes anything but a file: a pipe, a device or a folder is an error. A line and a
 * file have a size beyond which they are refused, so that a wrong file fills no memory. */
#ifndef BASE_INPUT_H
#define BASE_INPUT_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Opens a file of at most `most` bytes to be read, from its beginning. NULL: the status says why, with exit
 * status 2, and errno is that of the system (ENOENT: there is no such file), 0 where the file itself is
 * refused. */
FILE *input_open(const char *name, long most, Status *);

/* Every file that was opened, and what is noted as one that will be: no output takes its place (output.h).
 * `real`: as output_real_name() has it. False of input_note(): no memory. */
bool input_note(const char *name, Status *);
bool input_is_read(const char *real);

/* What stands for standard input in place of a file's name, "-", for input_open() once all that it holds (so
 * many bytes at most) was taken: only who starts the program may ask for that, for reading it may wait. */
extern const char input_standard_name[];
bool input_take_standard(long most, Status *);

/* Opens a text of the program itself in the same way. NULL: no memory. */
FILE *input_text(const char *text, const char *name, Status *);

/* Where reading of lines stands; begins as {.stream = ..., .name = ...}. */
typedef struct InputLines {
    FILE *stream;
    const char *name; /* for errors */
    long number;      /* of the last line, from 1 on */
    bool cut;         /* it ended with the file and not with a line end */
} InputLines;

typedef enum InputGot { INPUT_WRONG /* a refusal's result */, INPUT_LINE, INPUT_END } InputGot;

/* Reads the next line without its end (LF or CR LF), the first without a mark of UTF-8 (BOM). INPUT_WRONG: it
 * is longer than size - 1 bytes, holds a zero byte or cannot be read; the status says so as "NAME:NUMBER:
 * ...". */
InputGot input_line(InputLines *, char *line, size_t size, Status *);

#endif
