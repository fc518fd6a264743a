/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The duel: a second run beside the first one. */
#include "lab/second_run.h"
#include "lab/laboratory.h"
#include "scenario/settings.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static bool begin(Laboratory *lab, const Assignment *keys, int n_keys, Status *status)
{
    const bool sound = duel_start(&lab->player.duel, keys, n_keys, status);
    if (!sound)
        return false;
    player_forget_rates(&lab->player);
    lab->screen.time.cursor = NAN;
    lab->screen.summary = NULL;
    player_settle(lab);
    return true;
}

void second_run_open(Laboratory *lab)
{
    const Settings *settings = experiment_settings(laboratory_run(lab));
    Status status = {STATUS_DONE, ""};
    if (settings->n_duel > 0 && !begin(lab, settings->duel, settings->n_duel, &status))
        laboratory_say(lab, MESSAGE_WARNING, "no duel: %s", status.text);
}

bool second_run_answer(Laboratory *lab, const char *words)
{
    Assignment keys[DUEL_MAX];
    Status status = {STATUS_DONE, ""};
    const int n_keys = duel_read_keys(words, keys, &status);
    for (int i = 0; i < n_keys; i++) {
        const Assignment typed = keys[i];
        if (!settings_resolve_key(experiment_settings(laboratory_run(lab)), typed.key, keys[i].key, &status))
            return prompt_refuse(&lab->prompting, status.text);
    }
    if (n_keys == 0)
        return prompt_refuse(&lab->prompting, "KEY=VALUE is wanted, as in mpm.algorithm=usl; Tab completes");
    return (n_keys > 0 && begin(lab, keys, n_keys, &status)) || prompt_refuse(&lab->prompting, status.text);
}

static void suggest(Laboratory *lab, int direction)
{
    const int to = lab->prompting.suggestion + direction;
    Assignment keys[DUEL_MAX];
    if (to < 0 || duel_suggest(experiment_settings(laboratory_run(lab)), to, keys) == 0)
        return;
    lab->prompting.suggestion = to;
    char text[sizeof lab->prompting.shown.text];
    duel_write_keys(keys, 1, text, sizeof text);
    prompt_fill(&lab->prompting, text);
}

static bool duel_key(Laboratory *lab, const char *key)
{
    const bool up = strcmp(key, "Up") == 0;
    if (up || strcmp(key, "Down") == 0)
        suggest(lab, up ? -1 : 1);
    return up || strcmp(key, "Down") == 0;
}

static const Typing typing = {.key = duel_key, .offer = complete_assignments};

void second_run_toggle(Laboratory *lab)
{
    Duel *duel = &lab->player.duel;
    const Settings *settings = experiment_settings(laboratory_run(lab));
    Assignment keys[DUEL_MAX];
    char text[sizeof lab->prompting.shown.text];
    if (duel->b) {
        duel_end(duel);
        player_forget_rates(&lab->player);
        player_settle(lab);
        laboratory_say(lab, MESSAGE_INFO, "the duel is over: the curve of B stays until the next change");
        return;
    }
    if (settings->n_duel > 0) {
        second_run_open(lab);
        return;
    }
    /* the keys of the last duel are proposed again, else the question of the scenario */
    lab->prompting.suggestion = duel->n_keys > 0 ? -1 : 0;
    const int n_keys = duel->n_keys > 0 ? duel->n_keys : duel_suggest(settings, 0, keys);
    duel_write_keys(duel->n_keys > 0 ? duel->keys : keys, n_keys, text, sizeof text);
    prompt_ask(&lab->prompting, second_run_answer, false, text, "in B is");
    lab->prompting.typing = &typing;
    snprintf(lab->prompting.shown.hint, sizeof lab->prompting.shown.hint,
             "in what the second run differs; Down offers others, Tab completes, Enter begins the duel");
}
