/* Questions at the foot of the screen, and what becomes of the answers. */
#include "tui/control/control.h"

#include "base/text.h"
#include "base/visible.h"
#include "lab/export/output_file.h"
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
}

void fill_prompt(Laboratory *lab, const char *text)
{
    Prompt *prompt = &lab->screen.prompt;
    snprintf(prompt->text, sizeof prompt->text, "%s", text);
    prompt->cursor = text_columns(prompt->text);
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
    Answer answer = lab->answer;
    close_prompt(lab);
    if (answer(lab, text))
        return;
    snprintf(asked.problem, sizeof asked.problem, "%s", lab->screen.prompt.problem);
    lab->screen.prompt = asked;
    lab->answer = answer;
}

void prompt_key(Laboratory *lab, const Key *key)
{
    Prompt *prompt = &lab->screen.prompt;
    const char *name = key->name;
    if (strcmp(name, "Tab") != 0)
        lab->tabbed = 0;
    if (prompt->yes_no && lab->answer == answer_quit &&
        (strcmp(name, "q") == 0 || strcmp(name, "F10") == 0)) {
        refuse(lab, "y leaves, n stays"); /* neither is certain, and what follows should be no commands */
    } else if (strcmp(name, "Esc") == 0 || strcmp(name, "F10") == 0) {
        close_prompt(lab);
    } else if (lab->answer == answer_line && prompt->problem[0] && strcmp(name, ":") == 0) {
        fill_prompt(lab, ""); /* who saw the refusal as a message begins the next line */
    } else if (prompt->yes_no) {
        if (strcmp(name, "y") == 0 || strcmp(name, "Y") == 0 || strcmp(name, "Enter") == 0)
            submit(lab, "yes");
        else if (strcmp(name, "n") == 0 || strcmp(name, "N") == 0 || strcmp(name, "q") == 0)
            close_prompt(lab);
    } else if (strcmp(name, "Enter") == 0) {
        char text[sizeof prompt->text];
        memcpy(text, prompt->text, sizeof text);
        submit(lab, text);
    } else if (strcmp(name, "Tab") == 0) {
        complete_prompt(lab);
        narrow_scenarios(lab);
    } else if (choose_scenario(lab, name)) {
        /* its name is the answer now */
    } else if (lab->answer == answer_line && (strcmp(name, "Up") == 0 || strcmp(name, "Down") == 0)) {
        recall_line(lab, name[0] == 'U' ? -1 : 1);
    } else if (lab->answer == answer_duel && (strcmp(name, "Up") == 0 || strcmp(name, "Down") == 0)) {
        suggest_duel(lab, name[0] == 'U' ? -1 : 1);
    } else if (line_key(prompt->text, sizeof prompt->text, &prompt->cursor, name, lab->fresh)) {
        lab->fresh = false;
        prompt->problem[0] = '\0';
        narrow_scenarios(lab);
        if (lab->answer == answer_line)
            prompt->hint[0] = '\0';
    }
}

/* --- answers ---------------------------------------------------------------------------------------- */

bool answer_go_to(Laboratory *lab, const char *text)
{
    long step = 0;
    double time = 0, dt = experiment_simulation(lab->screen.experiment)->dt;
    long last = experiment_last_step(lab->screen.experiment);
    if (text[0] == '#') {
        if (!text_to_long(text + 1, &step))
            return refuse(lab, "after # comes the number of a step, as in #1000");
    } else if (text_to_double(text, &time)) {
        step = time / dt > (double)last ? last + 1 : time < 0 ? -1 : lround(time / dt);
        if (time > (double)last * dt &&
            time <= experiment_settings(lab->screen.experiment)->time.end * (1 + 1e-9))
            step = last;
    } else
        return refuse(lab, "a time, as in 12.5, or a step, as in #1000");
    if (step < 0 || step > last) {
        char end[NUMBER_TEXT_MAX], why[120];
        text_rounded(end, (double)last * dt, 6);
        snprintf(why, sizeof why, "the run goes from 0 to %s (#0 to #%ld)", end, last);
        return refuse(lab, why);
    }
    pause_run(lab);
    seek(lab, step, 0);
    return true;
}

bool may_write(Laboratory *lab, const char *name)
{
    if (lab->replaying)
        say(lab, MESSAGE_INFO, "a session is done again: %s is not written", name);
    return !lab->replaying;
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
    bool sound = output_open(&file, name, true, &status) &&
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
    ask(lab, answer_replace_scenario, true, "", "%.60s exists: replace it?", text);
    return true;
}

bool answer_filter(Laboratory *lab, const char *text)
{
    ParameterRow rows[PARAMETER_ROWS_MAX];
    snprintf(lab->screen.filter, sizeof lab->screen.filter, "%.31s", text);
    int count = screen_parameter_rows(&lab->screen, rows);
    lab->screen.selected = 0;
    while (lab->screen.selected < count && !rows[lab->screen.selected].parameter)
        lab->screen.selected++;
    if (lab->screen.selected < count)
        return true;
    lab->screen.filter[0] = '\0';
    lab->screen.selected = 0;
    move_selection(lab, 1);
    return refuse(lab, "no parameter has that in its name");
}

bool answer_quit(Laboratory *lab, const char *text)
{
    (void)text;
    lab->closed = true;
    return true;
}
