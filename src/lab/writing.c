/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writing the scenario as a file, and what every answer that names a file is asked first. */
#include "lab/writing.h"
#include "lab/laboratory.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "base/output.h"
#include "base/text.h"
#include "scenario/scenario.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

bool writing_allowed(Laboratory *lab, const char *name)
{
    Status status = {STATUS_DONE, ""};
    if (output_allowed(lab->asker, name, &status))
        return true;
    laboratory_say(lab, MESSAGE_INFO, "%s", status.text);
    return false;
}

bool writing_name_fits(Laboratory *lab, const char *name)
{
    Status status = {STATUS_DONE, ""};
    return output_may_begin(name, lab->asker, true, &status) || prompt_refuse(&lab->prompting, status.text);
}

/* The scenario as it was opened and edited, to its own end; not only what has been computed of it. */
static bool write_scenario(Laboratory *lab, const char *name)
{
    const Experiment *experiment = laboratory_run(lab);
    Status status = {STATUS_DONE, ""};
    Settings settings;
    experiment_scenario(experiment, true, &settings);
    settings_edit_time(&settings)->end = settings_time(experiment_settings(experiment))->end;
    settings_edit_time(&settings)->step = settings_time(experiment_settings(experiment))->step;
    if (lab->player.duel.b) { /* opens as what is on screen */
        memcpy(settings.duel, lab->player.duel.keys, sizeof settings.duel);
        settings.n_duel = lab->player.duel.n_keys;
    }
    OutputFile file = {0};
    if (!writing_allowed(lab, name))
        return true;
    const bool sound = output_open(&file, lab->asker, name, true, &status) &&
                       scenario_write(file.stream, &settings, NULL, &status);
    if (!output_end(&file, sound, &status))
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
    else {
        char word[sizeof lab->message.text] = "";
        text_append_shell(word, sizeof word, name);
        laboratory_say(lab, MESSAGE_INFO, "wrote %s; open it with: matvib %s", name, word);
    }
    return true;
}

static bool answer_replace_scenario(Laboratory *lab, const char *text)
{
    (void)text;
    return write_scenario(lab, lab->exporting.name);
}

bool writing_answer(Laboratory *lab, const char *text)
{
    if (!text[0] || output_is_standard(text))
        return prompt_refuse(&lab->prompting, "a file name is wanted");
    if (!writing_name_fits(lab, text))
        return false;
    if (access(text, F_OK) != 0 || output_is_direct(text))
        return write_scenario(lab, text);
    snprintf(lab->exporting.name, sizeof lab->exporting.name, "%s", text);
    prompt_ask_replace(&lab->prompting, answer_replace_scenario, text);
    return true;
}

static const Typing file_typing = {.offer = complete_files, .retyped = true};

void writing_ask(Laboratory *lab)
{
    char name[NAME_MAX_BYTES];
    snprintf(name, sizeof name, "%.200s%s", lab->scenario, strchr(lab->scenario, '.') ? "" : ".ini");
    prompt_ask(&lab->prompting, writing_answer, false, name, "write scenario to");
    lab->prompting.typing = &file_typing;
}
