/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Questions at the foot of the screen, and what becomes of the answers. */
#include "lab/laboratory.h"

#include "base/visible.h"
#include "lab/prompt/line_edit.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void prompt_ask(Prompting *prompting, Answer answer, bool yes_no, const char *text, const char *format, ...)
{
    Prompt *prompt = &prompting->shown;
    va_list arguments;
    *prompt = (Prompt){.open = true, .yes_no = yes_no};
    va_start(arguments, format);
    char question[sizeof prompt->question];
    vsnprintf(question, sizeof question, format, arguments);
    va_end(arguments);
    visible_text(prompt->question, sizeof prompt->question, question);
    prompt_fill(prompting, text);
    prompting->answer = answer;
    prompting->typing = NULL;
}

/* A long name loses its first folders: names differ at their end. */
void prompt_ask_replace(Prompting *prompting, Answer answer, const char *name)
{
    enum { COLUMNS = 56 };
    const char *end = name;
    for (int more = glyphs_columns(name) - COLUMNS; more > 0; more--)
        glyph_next(&end);
    prompt_ask(prompting, answer, true, "", "%s%s exists: replace?", end > name ? "..." : "", end);
    prompting->shown.wants_y = true;
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

bool prompt_refuse(Prompting *prompting, const char *why)
{
    visible_text(prompting->shown.problem, sizeof prompting->shown.problem, why);
    return false;
}

/* The answer function may open the next prompt, so this one is closed before and put back if it refused. */
static void submit(Laboratory *lab, const char *text)
{
    Prompting *prompting = &lab->prompting;
    Prompt asked = prompting->shown;
    const Answer answer = prompting->answer;
    const Typing *typing = prompting->typing;
    prompt_close(prompting);
    if (answer(lab, text))
        return;
    snprintf(asked.problem, sizeof asked.problem, "%s", prompting->shown.problem);
    prompting->shown = asked;
    prompting->answer = answer;
    prompting->typing = typing;
    prompting->fresh = typing && typing->retyped;
}

static void text_changed(Laboratory *lab, const char *key)
{
    if (lab->prompting.typing && lab->prompting.typing->typed)
        lab->prompting.typing->typed(lab, key);
}

void prompt_key(Laboratory *lab, const Key *key)
{
    Prompting *prompting = &lab->prompting;
    Prompt *prompt = &prompting->shown;
    const char *name = key->name;
    if (strcmp(name, "Tab") != 0)
        prompting->tabbed = 0;
    if (prompting->typing && prompting->typing->key && prompting->typing->key(lab, name)) {
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
        text_changed(lab, name);
    } else if (line_edit_key(prompt->text, sizeof prompt->text, &prompt->cursor, name, prompting->fresh)) {
        prompting->fresh = false;
        prompt->problem[0] = '\0';
        text_changed(lab, name);
    }
}
