/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands that set runs beside each other, undo and redo. */
#include "lab/commands/commands.h"
#include "scenario/settings.h"

#include <stdio.h>

/* In a duel the other answer is on screen already: skips to one that is not. */
static bool is_second(const Laboratory *lab, const Settings *settings, const Parameter *parameter)
{
    const Experiment *second = lab->player.duel.b;
    return second &&
           settings_number(settings, parameter) == settings_number(experiment_settings(second), parameter);
}

/* Another run beside this one: what the scenario asks about holds from t = 0 on. */
void command_question(Laboratory *lab)
{
    Settings settings = *experiment_settings(laboratory_run(lab));
    const Settings before = settings;
    const Parameter *parameter = settings_question(&settings);
    Status status = {STATUS_DONE, ""};
    if (!parameter || !settings_answer_otherwise(&settings, parameter))
        laboratory_say(lab, MESSAGE_INFO, "this scenario asks no question");
    else if (is_second(lab, &settings, parameter) &&
             (!settings_nudge(&settings, parameter, 1, false) || settings_same(&before, &settings)))
        laboratory_say(lab, MESSAGE_INFO, "both answers are on screen already; d ends the duel");
    else if (!edit_change(lab, &settings, experiment_rerun, &status))
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
    else if (lab->message.kind == MESSAGE_NONE) {
        /* "cell size 1 -> 0.5, from t = 0 on; a: before" */
        const Experiment *experiment = laboratory_run(lab);
        const Ghost *ghosts = experiment_ghosts(experiment);
        char from[LIST_MAX], to[LIST_MAX], ghost[24] = "";
        settings_show(&before, parameter, from);
        settings_show(experiment_settings(experiment), parameter, to);
        for (int i = 0; i < GHOSTS_MAX; i++)
            if (ghosts[i].used && !ghosts[i].pinned)
                snprintf(ghost, sizeof ghost, "; %c: before", ghosts[i].letter);
        laboratory_say(lab, MESSAGE_INFO, "%s%s %.60s -> %.60s, from t = 0 on%s",
                       lab->player.duel.b ? "A: " : "", parameter->label, from, to, ghost);
    }
}

static int pinned(const Experiment *experiment)
{
    const Ghost *ghosts = experiment_ghosts(experiment);
    int count = 0;
    for (int i = 0; i < GHOSTS_MAX; i++)
        count += ghosts[i].used && ghosts[i].pinned;
    return count;
}

void command_pin(Laboratory *lab)
{
    Status status = {STATUS_DONE, ""};
    int had = pinned(laboratory_run(lab));
    if (!experiment_pin(laboratory_run(lab), &status))
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
    else if (pinned(laboratory_run(lab)) > had)
        laboratory_say(lab, MESSAGE_INFO, "these curves stay as a ghost; c again takes them away");
    else
        laboratory_say(lab, MESSAGE_INFO, "the ghost of these curves is gone");
}

static void swap_settings(Laboratory *lab, Settings *from, int *n_from, Settings *to, int *n_to,
                          const char *none, const char *done)
{
    Status status = {STATUS_DONE, ""};
    if (*n_from == 0) {
        laboratory_say(lab, MESSAGE_INFO, "%s", none);
        return;
    }
    Settings old = *experiment_settings(laboratory_run(lab));
    if (!edit_change_runs(lab, &from[*n_from - 1], experiment_replace, &status)) {
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
        return;
    }
    char change[160];
    settings_name_change(&old, experiment_settings(laboratory_run(lab)), change, sizeof change);
    to[(*n_to)++] = old;
    --*n_from;
    edit_changed(lab);
    player_tell_duel_over(lab, &status);
    if (lab->message.kind == MESSAGE_NONE)
        laboratory_say(lab, MESSAGE_INFO, "%s: %s", done, change);
}

void command_undo(Laboratory *lab)
{
    swap_settings(lab, lab->editing.undo, &lab->editing.n_undo, lab->editing.redo, &lab->editing.n_redo,
                  "nothing to undo", "undone");
}

void command_redo(Laboratory *lab)
{
    swap_settings(lab, lab->editing.redo, &lab->editing.n_redo, lab->editing.undo, &lab->editing.n_undo,
                  "nothing to redo", "done again");
}
