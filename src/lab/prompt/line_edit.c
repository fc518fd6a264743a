/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The keys of a one-line editor, those of Emacs among them. The cursor counts characters, the text is bytes.
 */
#include "lab/prompt/line_edit.h"

#include <string.h>

static bool continues(char byte)
{
    return ((unsigned char)byte & 0xc0) == 0x80;
}

static int characters(const char *text)
{
    int count = 0;
    for (; *text; text++)
        count += !continues(*text);
    return count;
}

/* The byte at which a character begins. */
static size_t offset(const char *text, int character)
{
    size_t at = 0;
    while (character > 0 && text[at]) {
        do
            at++;
        while (continues(text[at]));
        character--;
    }
    return at;
}

static void insert(char *text, size_t size, int *cursor, const char *what)
{
    size_t length = strlen(text), more = strlen(what), at = offset(text, *cursor);
    if (length + more >= size)
        return;
    memmove(text + at + more, text + at, length - at + 1);
    memcpy(text + at, what, more);
    ++*cursor;
}

/* Removes the characters [first, last). */
static void cut(char *text, int first, int last)
{
    size_t from = offset(text, first), to = offset(text, last);
    memmove(text + from, text + to, strlen(text + to) + 1);
}

bool line_edit_key(char *text, size_t size, int *cursor, const char *key, bool fresh)
{
    bool printing = (key[0] && !key[1]) || ((unsigned char)key[0] >= 0x80 && characters(key) == 1);
    int count = characters(text);
    if (strcmp(key, "Space") == 0) {
        key = " ";
        printing = true;
    }
    if (printing) {
        if (fresh) {
            text[0] = '\0';
            *cursor = 0;
        }
        insert(text, size, cursor, key);
    } else if (strcmp(key, "Backspace") == 0) {
        if (*cursor > 0) {
            cut(text, *cursor - 1, *cursor);
            --*cursor;
        }
    } else if (strcmp(key, "Delete") == 0 || strcmp(key, "^D") == 0) {
        cut(text, *cursor, *cursor + 1);
    } else if (strcmp(key, "Left") == 0 || strcmp(key, "^B") == 0) {
        *cursor -= *cursor > 0;
    } else if (strcmp(key, "Right") == 0 || strcmp(key, "^F") == 0) {
        *cursor += *cursor < count;
    } else if (strcmp(key, "Home") == 0 || strcmp(key, "^A") == 0) {
        *cursor = 0;
    } else if (strcmp(key, "End") == 0 || strcmp(key, "^E") == 0) {
        *cursor = count;
    } else if (strcmp(key, "^U") == 0) {
        cut(text, 0, *cursor);
        *cursor = 0;
    } else if (strcmp(key, "^K") == 0) {
        cut(text, *cursor, count);
    } else if (strcmp(key, "^W") == 0) {
        int first = *cursor;
        while (first > 0 && text[offset(text, first - 1)] == ' ')
            first--;
        while (first > 0 && text[offset(text, first - 1)] != ' ')
            first--;
        cut(text, first, *cursor);
        *cursor = first;
    } else
        return false;
    return true;
}
