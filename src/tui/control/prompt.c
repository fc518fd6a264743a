/* Questions at the foot of the screen, and what becomes of the answers. */
#include "tui/control/laboratory.h"

#include "base/text.h"
#include "base/visible.h"
#include "base/output.h"
#include "lab/settings/scenario.h"
#include "tui/control/line_edit.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

void ask(Laboratory *lab, Answer answer, bool yes_no, const char *text, const char *format, ...)
{
    Prompt *prompt = &lab->screen.prompt;
    va_list arguments;
    *prompt = (Prompt){.open = true, .yes_no = yes_no};
    va_start(arguments, format);
    char question[sizeof prompt->question];
    vsnprintf(question, sizeof question, format, arguments);
    va_end(arguments);
    text_visible(prompt->question, sizeof prompt->question, question);
    fill_prompt(lab, text);
    lab->answer = answer;
    lab->typing = NULL;
}

/* Long names differ at their end, where their folders are left. */
void ask_replace(Laboratory *lab, Answer answer, const char *name)
{
    enum { COLUMNS = 56 };
    const char *end = name;
    for (int more = text_columns(name) - COLUMNS; more > 0; more--)
        utf8_next(&end);
    ask(lab, answer, true, "", "%s%s exists: replace?", end > name ? "..." : "", end);
    lab->screen.prompt.wants_y = true;
}

void fill_prompt(Laboratory *lab, const char *text)
{
    Prompt *prompt = &lab->screen.prompt;
    snprintf(prompt->text, sizeof prompt->text, "%s", text);
    prompt->cursor = text_characters(prompt->text);
    prompt->problem[0] = '\0';
    lab->fresh = true;
}

void close_prompt(Laboratory *lab)
{
    lab->screen.prompt = (Prompt){.open = false};
}

bool refuse(Laboratory *lab, const char *why)
{
    text_visible(lab->screen.prompt.problem, sizeof lab->screen.prompt.problem, why);
    return false;
}

/* The answer function may open the next prompt, so this one is closed before and put back if it refused. */
static void submit(Laboratory *lab, const char *text)
{
    Prompt asked = lab->screen.prompt;
    const Answer answer = lab->answer;
    const Typing *typing = lab->typing;
    close_prompt(lab);
    if (answer(lab, text))
        return;
    snprintf(asked.problem, sizeof asked.problem, "%s", lab->screen.prompt.problem);
    lab->screen.prompt = asked;
    lab->answer = answer;
    lab->typing = typing;
}

static void text_changed(Laboratory *lab, const char *key)
{
    if (lab->typing && lab->typing->typed)
        lab->typing->typed(lab, key);
}

void prompt_key(Laboratory *lab, const Key *key)
{
    Prompt *prompt = &lab->screen.prompt;
    const char *name = key->name;
    if (strcmp(name, "Tab") != 0)
        lab->tabbed = 0;
    if (lab->typing && lab->typing->key && lab->typing->key(lab, name)) {
        /* it meant something to this question alone */
    } else if (strcmp(name, "Esc") == 0 || strcmp(name, "F10") == 0) {
        close_prompt(lab);
    } else if (prompt->yes_no) {
        const bool enter = strcmp(name, "Enter") == 0;
        if (strcmp(name, "y") == 0 || strcmp(name, "Y") == 0 || (enter && !prompt->wants_y))
            submit(lab, "yes");
        else if (strcmp(name, "n") == 0 || strcmp(name, "N") == 0 || strcmp(name, "q") == 0 || enter)
            close_prompt(lab);
    } else if (strcmp(name, "Enter") == 0) {
        char text[sizeof prompt->text];
        memcpy(text, prompt->text, sizeof text);
        submit(lab, text);
    } else if (strcmp(name, "Tab") == 0) {
        complete_prompt(lab);
        text_changed(lab, name);
    } else if (line_key(prompt->text, sizeof prompt->text, &prompt->cursor, name, lab->fresh)) {
        lab->fresh = false;
        prompt->problem[0] = '\0';
        text_changed(lab, name);
    }
}

/* --- answers ---------------------------------------------------------------------------------------- */

bool may_write(Laboratory *lab, const char *name)
{
    Status status = {STATUS_DONE, ""};
    if (output_allowed(lab->asker, name, &status))
        return true;
    say(lab, MESSAGE_INFO, "%s", status.text);
    return false;
}

bool name_can_be(Laboratory *lab, const char *name)
{
    Status status = {STATUS_DONE, ""};
    return output_may_begin(name, true, &status) || refuse(lab, status.text);
}

/* The scenario as it was opened and edited, to its own end; not only what has been computed of it. */
static bool write_scenario(Laboratory *lab, const char *name)
{
    const Experiment *experiment = lab->screen.experiment;
    Status status = {STATUS_DONE, ""};
    Settings settings;
    experiment_scenario(experiment, true, &settings);
    settings.time.end = experiment_settings(experiment)->time.end;
    settings.time.step = experiment_settings(experiment)->time.step;
    if (lab->duel.b) { /* opens as what is on screen */
        memcpy(settings.duel, lab->duel.keys, sizeof settings.duel);
        settings.n_duel = lab->duel.n_keys;
    }
    OutputFile file = {0};
    if (!may_write(lab, name))
        return true;
    bool sound = output_open(&file, lab->asker, name, true, &status) &&
                 scenario_write(file.stream, &settings, NULL, &status) && output_finish(&file, &status) &&
                 output_commit(&file, &status);
    output_close(&file);
    if (!sound)
        say(lab, MESSAGE_ERROR, "%s", status.text);
    else
        say(lab, MESSAGE_INFO, "wrote %s; open it with: matvib %s", name, name);
    return true;
}

static bool answer_replace_scenario(Laboratory *lab, const char *text)
{
    (void)text;
    return write_scenario(lab, lab->export_name);
}

bool answer_write(Laboratory *lab, const char *text)
{
    if (!text[0] || output_is_standard(text))
        return refuse(lab, "a file name is wanted");
    if (!name_can_be(lab, text))
        return false;
    if (access(text, F_OK) != 0 || output_is_direct(text))
        return write_scenario(lab, text);
    snprintf(lab->export_name, sizeof lab->export_name, "%s", text);
    ask_replace(lab, answer_replace_scenario, text);
    return true;
}
