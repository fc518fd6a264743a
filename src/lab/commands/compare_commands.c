/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands that set runs beside each other, undo and redo. */
#include "lab/commands/commands.h"
#include "scenario/changes.h"

#include <stdio.h>
#include <math.h>
#include <string.h>

/* Another run beside this one: what the scenario asks about holds from t = 0 on. */
void command_question(Laboratory *lab)
{
    Settings settings = *laboratory_settings(lab);
    const Settings before = settings;
    const Parameter *parameter = settings_question(&settings);
    const Experiment *second = lab->player.duel.b;
    Status status = {STATUS_DONE, ""};
    if (!parameter || !settings_answer_otherwise(&settings, parameter))
        laboratory_tell(lab, "this scenario asks no question");
    /* in a duel the other answer is on screen already: on to one that is not */
    else if (second &&
             settings_number(&settings, parameter) ==
                 settings_number(experiment_settings(second), parameter) &&
             (!settings_nudge(&settings, parameter, 1, false, NULL) || settings_same(&before, &settings)))
        laboratory_tell(lab, "both answers are on screen already; d ends the duel");
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
        laboratory_tell(lab, "%s%s %.60s -> %.60s, from t = 0 on%s", lab->player.duel.b ? "A: " : "",
                        parameter->label, from, to, ghost);
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
        laboratory_tell(lab, "these curves stay as a ghost; c again takes them away");
    else
        laboratory_tell(lab, "the ghost of these curves is gone");
}

/* Back (by -1) or forth through what has been changed. */
void command_undo(Laboratory *lab, int by)
{
    const bool back = by < 0;
    Editing *editing = &lab->editing;
    Settings *from = back ? editing->undo : editing->redo, *to = back ? editing->redo : editing->undo;
    int *n_from = back ? &editing->n_undo : &editing->n_redo,
        *n_to = back ? &editing->n_redo : &editing->n_undo;
    Status status = {STATUS_DONE, ""};
    if (*n_from == 0) {
        laboratory_tell(lab, "nothing to %s", back ? "undo" : "redo");
        return;
    }
    const Settings old = *experiment_base(laboratory_run(lab));
    Settings before, after;
    changes_in_force(&old, player_place(lab).step, &before);
    if (!edit_change_runs(lab, &from[*n_from - 1], experiment_replace, &status)) {
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
        return;
    }
    char change[160];
    changes_in_force(experiment_base(laboratory_run(lab)), player_place(lab).step, &after);
    settings_name_change(&before, &after, change, sizeof change);
    to[(*n_to)++] = old;
    --*n_from;
    edit_changed(lab);
    player_tell_duel_over(lab, &status);
    if (lab->message.kind == MESSAGE_NONE)
        laboratory_tell(lab, "%s: %s", back ? "undone" : "redone", change);
}

/* The duel: a second run beside the first one. */

static bool begin(Laboratory *lab, const Assignment *keys, int n_keys, Status *status)
{
    if (!duel_start(&lab->player.duel, keys, n_keys, status))
        return false;
    player_forget_rates(&lab->player);
    lab->screen.time.cursor = NAN;
    lab->screen.summary = NULL;
    player_settle(lab);
    return true;
}

void command_second_open(Laboratory *lab)
{
    const Settings *settings = laboratory_settings(lab);
    Status status = {STATUS_DONE, ""};
    if (settings->n_duel > 0 && !begin(lab, settings->duel, settings->n_duel, &status))
        laboratory_say(lab, MESSAGE_WARNING, "no duel: %s", status.text);
}

bool command_second_answer(Laboratory *lab, const char *words, Status *status)
{
    Assignment keys[DUEL_MAX];
    const int n_keys = duel_read_keys(words, keys, status);
    for (int i = 0; i < n_keys; i++) {
        const Assignment typed = keys[i];
        if (!settings_resolve_key(laboratory_settings(lab), typed.key, keys[i].key, status))
            return false;
    }
    if (n_keys == 0)
        return status_refuse(status, "KEY=VALUE is expected, as in mpm.algorithm=usl; Tab completes");
    return n_keys > 0 && begin(lab, keys, n_keys, status);
}

static bool duel_key(Laboratory *lab, const char *key)
{
    const bool up = strcmp(key, "Up") == 0;
    const int to = lab->prompting.suggestion + (up ? -1 : 1);
    Assignment keys[DUEL_MAX];
    char text[sizeof lab->prompting.shown.text];
    if (!up && strcmp(key, "Down") != 0)
        return false;
    if (to >= 0 && duel_suggest(laboratory_settings(lab), to, keys) > 0) {
        lab->prompting.suggestion = to;
        duel_write_keys(keys, 1, text, sizeof text);
        prompt_fill(&lab->prompting, text);
    }
    return true;
}

static const Typing typing = {.key = duel_key, .offer = complete_assignments};

void command_second_toggle(Laboratory *lab)
{
    Duel *duel = &lab->player.duel;
    const Settings *settings = laboratory_settings(lab);
    Assignment keys[DUEL_MAX];
    char text[sizeof lab->prompting.shown.text];
    if (duel->b) {
        duel_end(duel);
        player_forget_rates(&lab->player);
        player_settle(lab);
        laboratory_tell(lab, "the duel is over: the curve of B stays until the next change");
        return;
    }
    if (settings->n_duel > 0) {
        command_second_open(lab);
        return;
    }
    /* the keys of the last duel are proposed again, else the question of the scenario */
    lab->prompting.suggestion = duel->n_keys > 0 ? -1 : 0;
    const int n_keys = duel->n_keys > 0 ? duel->n_keys : duel_suggest(settings, 0, keys);
    duel_write_keys(duel->n_keys > 0 ? duel->keys : keys, n_keys, text, sizeof text);
    prompt_ask(lab, command_second_answer, &typing, text, "in B is");
    snprintf(lab->prompting.shown.hint, sizeof lab->prompting.shown.hint,
             "in what the second run differs; Down offers others, Tab completes, Enter begins the duel");
}
