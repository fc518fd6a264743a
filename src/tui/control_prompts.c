/* Questions at the foot of the screen, and what becomes of the answers. */
#include "tui/control.h"

#include "base/text.h"
#include "lab/scenario.h"
#include "tui/line_edit.h"

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
    vsnprintf(prompt->question, sizeof prompt->question, format, arguments);
    va_end(arguments);
    snprintf(prompt->text, sizeof prompt->text, "%s", text);
    prompt->cursor = text_columns(prompt->text);
    lab->answer = answer;
    lab->fresh = true;
}

void close_prompt(Laboratory *lab)
{
    lab->screen.prompt = (Prompt){.open = false};
}

static bool refuse(Laboratory *lab, const char *why)
{
    snprintf(lab->screen.prompt.problem, sizeof lab->screen.prompt.problem, "%.319s", why);
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

/* --- completion of the command line ------------------------------------------------------------------ */

/* Cuts `common` to what it shares with another candidate for the completion of `start`. */
static void share(const char *start, const char *candidate, char *common, size_t size, int *found)
{
    if (strncmp(candidate, start, strlen(start)) != 0)
        return;
    if ((*found)++ == 0) {
        snprintf(common, size, "%s", candidate);
        return;
    }
    size_t same = 0;
    while (common[same] && common[same] == candidate[same])
        same++;
    common[same] = '\0';
}

/* Completes a command's name or a parameter's key as far as it is certain. */
static void complete(Laboratory *lab)
{
    Prompt *prompt = &lab->screen.prompt;
    char common[KEY_MAX + 1] = "";
    int found = 0;
    for (int i = 0; i < n_commands; i++)
        share(prompt->text, commands[i].name, common, sizeof common, &found);
    for (int i = 0; i < n_parameters; i++)
        if (parameter_applies(&parameters[i], experiment_settings(lab->screen.experiment)->problem))
            share(prompt->text, parameters[i].key, common, sizeof common, &found);
    if (found == 0)
        return;
    snprintf(prompt->text, sizeof prompt->text, "%s%s", common,
             found == 1 && parameter_find(common) ? "=" : "");
    prompt->cursor = text_columns(prompt->text);
}

void prompt_key(Laboratory *lab, const Key *key)
{
    Prompt *prompt = &lab->screen.prompt;
    const char *name = key->name;
    if (strcmp(name, "Esc") == 0 || strcmp(name, "F10") == 0) {
        close_prompt(lab);
    } else if (prompt->yes_no) {
        if (strcmp(name, "y") == 0 || strcmp(name, "Y") == 0 || strcmp(name, "Enter") == 0)
            submit(lab, "yes");
        else if (strcmp(name, "n") == 0 || strcmp(name, "N") == 0 || strcmp(name, "q") == 0)
            close_prompt(lab);
    } else if (strcmp(name, "Enter") == 0) {
        char text[sizeof prompt->text];
        memcpy(text, prompt->text, sizeof text);
        submit(lab, text);
    } else if (strcmp(name, "Tab") == 0 && lab->answer == answer_line) {
        complete(lab);
        lab->fresh = false;
    } else if (line_key(prompt->text, sizeof prompt->text, &prompt->cursor, name, lab->fresh)) {
        lab->fresh = false;
        prompt->problem[0] = '\0';
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
        if (time > (double)last * dt && time <= experiment_settings(lab->screen.experiment)->end * (1 + 1e-9))
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

bool answer_open(Laboratory *lab, const char *text)
{
    Status status = {STATUS_DONE, ""};
    if (!text[0])
        return true;
    return open_scenario(lab, text, &status) || refuse(lab, status.text);
}

/* The scenario as it was opened and edited, to its own end; not only what has been computed of it. */
static bool write_scenario(Laboratory *lab, const char *name)
{
    const Experiment *experiment = lab->screen.experiment;
    Status status = {STATUS_DONE, ""};
    Settings settings;
    experiment_scenario(experiment, true, &settings);
    settings.end = experiment_settings(experiment)->end;
    settings.beam.dt = experiment_settings(experiment)->beam.dt;
    FILE *file = fopen(name, "w");
    bool sound = file && scenario_write(file, &settings, NULL, &status);
    if (file && fclose(file) != 0)
        sound = false;
    if (!sound)
        say(lab, MESSAGE_ERROR, "%s", status.text[0] ? status.text : "the scenario could not be written");
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
    if (!text[0])
        return refuse(lab, "a file name is wanted");
    if (access(text, F_OK) != 0)
        return write_scenario(lab, text);
    snprintf(lab->export_name, sizeof lab->export_name, "%s", text);
    ask(lab, answer_replace_scenario, true, "", "%.60s exists: replace it?", text);
    return true;
}

/* A command's name, KEY=VALUE, or a time. */
bool answer_line(Laboratory *lab, const char *text)
{
    while (*text == ' ' || *text == ':')
        text++;
    const Command *command = command_by_name(text);
    const char *equals = strchr(text, '=');
    double time;
    if (!*text)
        return true;
    if (command) {
        laboratory_command(lab, command->id);
        return true;
    }
    if (!equals)
        return text[0] == '#' || text_to_double(text, &time)
                   ? answer_go_to(lab, text)
                   : refuse(lab, "a command's name (Tab completes), KEY=VALUE, or a time");
    if (strncmp(text, "set ", 4) == 0)
        text += 4;
    Settings settings = *experiment_settings(lab->screen.experiment);
    Status status = {STATUS_DONE, ""};
    char key[KEY_MAX];
    int length = (int)(equals - text);
    while (length > 0 && text[length - 1] == ' ')
        length--;
    snprintf(key, sizeof key, "%.*s", length, text);
    if (!settings_set(&settings, key, equals + 1 + strspn(equals + 1, " "), &status) ||
        !change_settings(lab, &settings, experiment_edit, &status))
        return refuse(lab, status.text);
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
