/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Editing one line of UTF-8 text; shared by fields and prompts. */
#ifndef LAB_PROMPT_LINE_EDIT_H
#define LAB_PROMPT_LINE_EDIT_H

#include <stdbool.h>
#include <stddef.h>

/* Applies a key to a text of at most size - 1 bytes; the cursor counts characters. `fresh`: the first
 * printing character replaces the whole text. False: not a key of an editor. */
bool line_edit_key(char *text, size_t size, int *cursor, const char *key, bool fresh);

#endif
