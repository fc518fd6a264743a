/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Questions at the foot of the screen, and what becomes of the answers. */
#include "lab/laboratory.h"

#include "base/visible.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const Typing prompt_yes_no = {.yes_no = true}, prompt_retyped = {.retyped = true};

void prompt_ask(Laboratory *lab, Answer answer, const Typing *typing, const char *text, const char *format,
                ...)
{
    Prompting *prompting = &lab->prompting;
    Prompt *prompt = &prompting->shown;
    va_list arguments;
    *prompt = (Prompt){.open = true, .yes_no = typing && typing->yes_no};
    va_start(arguments, format);
    visible_format(prompt->question, sizeof prompt->question, format, arguments);
    va_end(arguments);
    prompt_fill(prompting, text);
    prompting->answer = answer;
    prompting->typing = typing;
}

/* A long name loses its first folders: names differ at their end. */
void prompt_ask_replace(Laboratory *lab, Answer answer, const char *name)
{
    enum { COLUMNS = 56 };
    const char *end = name;
    for (int more = glyphs_columns(name) - COLUMNS; more > 0; more--)
        glyph_next(&end);
    prompt_ask(lab, answer, &prompt_yes_no, "", "%s%s exists: replace?", end > name ? "..." : "", end);
    lab->prompting.shown.wants_y = true;
}

void prompt_fill(Prompting *prompting, const char *text)
{
    Prompt *prompt = &prompting->shown;
    snprintf(prompt->text, sizeof prompt->text, "%s", text);
    prompt->cursor = glyphs_count(prompt->text);
    prompt->problem[0] = '\0';
    prompting->fresh = true;
}

void prompt_close(Prompting *prompting)
{
    prompting->shown = (Prompt){.open = false};
}

/* The answer function may open the next prompt, so this one is closed before and put back if it refused. */
static void submit(Laboratory *lab, const char *text)
{
    Prompting *prompting = &lab->prompting;
    Prompt asked = prompting->shown;
    const Answer answer = prompting->answer;
    const Typing *typing = prompting->typing;
    Status status = {STATUS_DONE, ""};
    prompt_close(prompting);
    if (answer(lab, text, &status))
        return;
    visible_text(asked.problem, sizeof asked.problem, status.text);
    prompting->shown = asked;
    prompting->answer = answer;
    prompting->typing = typing;
    prompting->fresh = typing && typing->retyped;
}

void prompt_key(Laboratory *lab, const Key *key)
{
    Prompting *prompting = &lab->prompting;
    Prompt *prompt = &prompting->shown;
    const Typing *typing = prompting->typing;
    const char *name = key->name;
    bool changed = false;
    if (strcmp(name, "Tab") != 0)
        prompting->tabbed = 0;
    if (typing && typing->key && typing->key(lab, name)) {
        /* it meant something to this question alone */
    } else if (strcmp(name, "Esc") == 0 || strcmp(name, "F10") == 0) {
        prompt_close(prompting);
    } else if (prompt->yes_no) {
        const bool enter = strcmp(name, "Enter") == 0;
        if (strcmp(name, "y") == 0 || strcmp(name, "Y") == 0 || (enter && !prompt->wants_y))
            submit(lab, "yes");
        else if (strcmp(name, "n") == 0 || strcmp(name, "N") == 0 || strcmp(name, "q") == 0 || enter)
            prompt_close(prompting);
    } else if (strcmp(name, "Enter") == 0) {
        char text[sizeof prompt->text];
        memcpy(text, prompt->text, sizeof text);
        submit(lab, text);
    } else if (strcmp(name, "Tab") == 0) {
        complete_tab(lab);
        changed = true;
    } else if (prompt_edit_line(prompt->text, sizeof prompt->text, &prompt->cursor, name, prompting->fresh)) {
        prompting->fresh = false;
        prompt->problem[0] = '\0';
        changed = true;
    }
    if (changed && typing && typing->typed)
        typing->typed(lab, name);
}

/* The keys of a one-line editor, with those of Emacs. The cursor counts characters, the text is bytes. */

/* The byte at which a character begins. */
static size_t offset(const char *text, int character)
{
    const char *at = text;
    while (character-- > 0 && glyph_next(&at))
        continue;
    return (size_t)(at - text);
}

/* Removes the characters [first, last). */
static void cut(char *text, int first, int last)
{
    size_t from = offset(text, first), to = offset(text, last);
    memmove(text + from, text + to, strlen(text + to) + 1);
}

bool prompt_edit_line(char *text, size_t size, int *cursor, const char *key, bool fresh)
{
    bool printing = (key[0] && !key[1]) || ((unsigned char)key[0] >= 0x80 && glyphs_count(key) == 1);
    int count = glyphs_count(text);
    if (strcmp(key, "Space") == 0) {
        key = " ";
        printing = true;
    }
    if (printing) {
        if (fresh) {
            text[0] = '\0';
            *cursor = 0;
        }
        const size_t length = strlen(text), more = strlen(key), at = offset(text, *cursor);
        if (length + more < size) {
            memmove(text + at + more, text + at, length - at + 1);
            memcpy(text + at, key, more);
            ++*cursor;
        }
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
