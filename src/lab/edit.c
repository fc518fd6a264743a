/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parameter pane: choosing, nudging and editing in place. */
#include "lab/laboratory.h"
#include "scenario/concern_time.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const Parameter *edit_selected(const Screen *screen)
{
    ParameterRow row;
    return screen_chosen_row(screen, &row) ? row.parameter : NULL;
}

void edit_move(Laboratory *lab, int by)
{
    ParameterRow rows[PARAMETER_ROWS_MAX];
    int count = screen_parameter_rows(&lab->screen, rows);
    int direction = by < 0 ? -1 : 1, at = lab->parameters.selected, last = at;
    for (int left = by * direction; left > 0;) {
        at += direction;
        if (at < 0 || at >= count)
            break;
        if (rows[at].heading)
            continue;
        last = at;
        left--;
    }
    lab->parameters.selected = last < 0 ? 0 : last >= count && count > 0 ? count - 1 : last;
}

bool edit_answer_filter(Laboratory *lab, const char *text, Status *status)
{
    ParameterRow rows[PARAMETER_ROWS_MAX];
    snprintf(lab->parameters.filter, sizeof lab->parameters.filter, "%.31s", text);
    int count = screen_parameter_rows(&lab->screen, rows);
    lab->parameters.selected = 0;
    while (lab->parameters.selected < count && !rows[lab->parameters.selected].parameter &&
           !rows[lab->parameters.selected].is_row)
        lab->parameters.selected++;
    if (lab->parameters.selected < count)
        return true;
    lab->parameters.filter[0] = '\0';
    lab->parameters.selected = 0;
    edit_move(lab, 1);
    return status_refuse(status, "no parameter has that in its name");
}

/* A run that begins again seeks the time that the first of these edits found on screen. */
static void return_to_time(Laboratory *lab)
{
    Experiment *experiment = laboratory_run(lab);
    if (experiment_pending(experiment, NULL)) {
        const double step = round(lab->editing.anchor_time / experiment_simulation(experiment)->dt);
        const long last = experiment_last_step(experiment);
        lab->editing.anchor_step = step < (double)last ? (long)step : last;
        duel_seek(&lab->player.duel, lab->editing.anchor_step, 0);
    } else
        lab->editing.anchor_step = experiment_step(experiment);
}

void edit_changed(Laboratory *lab)
{
    lab->editing.changed = true;
    /* it described the run as it was */
    lab->screen.summary = NULL;
    player_forget_rates(&lab->player); /* a step may take longer now */
    laboratory_say(lab, MESSAGE_NONE, "%s", "");
    if (lab->player.pace_automatic)
        lesson_entry_choose_pace(lab);
    player_settle(lab);
    const char *advice = experiment_advice(laboratory_run(lab));
    if (advice && *advice)
        laboratory_say(lab, MESSAGE_WARNING, "%s", advice);
}

/* Where a particle was at first; 0 in a direction that there is not. */
static void place_of(const Simulation *sim, size_t particle, double place[SIMULATION_DIMENSIONS_MAX])
{
    for (int d = 0; d < SIMULATION_DIMENSIONS_MAX; d++)
        if (sim->position[d] >= 0)
            sim->method->field(sim, sim->position[d], particle, 1, &place[d]);
}

bool edit_change_runs(Laboratory *lab, const Settings *settings, DuelChange verb, Status *status)
{
    size_t *chosen = &lab->screen.chosen.particle;
    const Simulation *sim = laboratory_simulation(lab);
    const size_t before = sim->counts[0];
    const Parameter *parameter = edit_selected(&lab->screen);
    double place[SIMULATION_DIMENSIONS_MAX] = {0};
    if (*chosen < before)
        place_of(sim, *chosen, place);
    if (!duel_change(&lab->player.duel, settings, verb, status))
        return false;
    if (parameter) /* another method has other parameters above it */
        lab->parameters.selected = screen_row_of(&lab->screen, parameter);
    sim = laboratory_simulation(lab);
    if (*chosen >= before || sim->counts[0] == before)
        return true;
    /* another spacing numbers them again: the one that was looked at is the one that lies nearest */
    double least = INFINITY;
    *chosen = 0;
    for (size_t i = 0; i < sim->counts[0]; i++) {
        double here[SIMULATION_DIMENSIONS_MAX] = {0}, square = 0;
        place_of(sim, i, here);
        for (int d = 0; d < SIMULATION_DIMENSIONS_MAX; d++)
            square += (here[d] - place[d]) * (here[d] - place[d]);
        if (square < least)
            least = square, *chosen = i;
    }
    return true;
}

bool edit_change(Laboratory *lab, const Settings *settings, DuelChange verb, Status *status)
{
    Editing *editing = &lab->editing;
    const Settings old = *experiment_base(laboratory_run(lab));
    const bool same = settings_same(laboratory_settings(lab), settings);
    const bool unchanged = same && settings_output_same(laboratory_settings(lab), settings);
    const long step = player_place(lab).step;
    /* the time on screen is a multiple of the time step; edits of the step in a row would make it wander */
    if (step != editing->anchor_step)
        editing->anchor_time = (double)step * laboratory_simulation(lab)->dt;
    /* a run that was at its end comes back to its end, which may lie a part of a step later */
    if (step >= experiment_last_step(laboratory_run(lab)) &&
        settings_time(settings)->end == settings_time(&old)->end)
        editing->anchor_time = 2 * settings_time(&old)->end;
    Status said = {STATUS_DONE, ""};
    if (!edit_change_runs(lab, settings, verb, &said))
        return status_take(status, &said);
    if (same && experiment_pending(laboratory_run(lab), NULL)) {
        return_to_time(lab); /* the same run with another column */
        player_settle(lab);
    }
    if (unchanged)
        return true;
    if (!same)
        return_to_time(lab);
    if (editing->n_undo == UNDO_MAX) /* the oldest change makes room */
        memmove(editing->undo, editing->undo + 1, (size_t)--editing->n_undo * sizeof *editing->undo);
    editing->undo[editing->n_undo++] = old;
    editing->n_redo = 0;
    if (!same) {
        edit_changed(lab);
        player_tell_duel_over(lab, &said);
    }
    return true;
}

/* The parameter, or the value of rows, that is chosen; false: there is none. */
static bool chosen_value(const Laboratory *lab, ParameterRow *row)
{
    return screen_chosen_row(&lab->screen, row) && (row->parameter || (row->is_row && row->place.value));
}

void edit_nudge(Laboratory *lab, int direction, bool fine)
{
    ParameterRow row;
    Settings settings = *laboratory_settings(lab);
    Status status = {STATUS_DONE, ""};
    if (!chosen_value(lab, &row))
        return;
    const Parameter *parameter = row.parameter;
    if (parameter ? settings_nudge(&settings, parameter, direction, fine, &status)
                  : settings_row_nudge(&settings, &row.place, direction, fine)) {
        if (!edit_change(lab, &settings, experiment_edit, &status))
            laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
    } else if (!parameter) {
        const RowKind *kind = &row_kinds[row.place.kind];
        laboratory_tell(lab, "%s of a %s: there is no next one", kind->columns[row.place.value - 1].word,
                        kind->one);
    } else if (status.text[0]) {
        laboratory_tell(lab, "%s", status.text);
    } else {
        /* a key that did nothing at the end of a range would seem broken */
        char range[96] = "Enter edits it";
        if (parameter->nudge != NUDGE_NONE)
            parameter_range(parameter, settings.problem, range, sizeof range);
        laboratory_tell(lab, "%s: %s", parameter->label, range);
    }
}

static bool accept_value(Laboratory *lab, Status *status)
{
    ParameterRow row;
    Settings settings = *laboratory_settings(lab);
    const char *text = lab->parameters.edit.text;
    return !chosen_value(lab, &row) ||
           ((row.parameter ? settings_change(&settings, row.parameter->key, text, status)
                           : settings_row_place_set(&settings, &row.place, text, status)) &&
            edit_change(lab, &settings, experiment_edit, status));
}

void edit_begin(Laboratory *lab)
{
    ParameterRow row;
    char *text = lab->parameters.edit.text;
    const Settings *settings = laboratory_settings(lab);
    if (!chosen_value(lab, &row))
        return;
    /* a few words are sooner gone through than typed */
    if (row.parameter && row.parameter->choices) {
        edit_nudge(lab, 1, false);
        return;
    }
    if (row.parameter)
        settings_get(settings, row.parameter, text);
    else
        text_shortest(text, settings_row_value(settings, row.place.kind, row.place.row, row.place.value - 1));
    edit_open_field(lab, accept_value, true);
}

void edit_open_field(Laboratory *lab, bool (*accept)(Laboratory *, Status *), bool fresh)
{
    FieldEdit *edit = &lab->parameters.edit;
    edit->cursor = glyphs_count(edit->text);
    edit->problem[0] = '\0';
    edit->open = true;
    lab->editing.fresh = fresh;
    lab->editing.accept = accept;
}

/* True: taken, the editor is closed. */
static bool accept_edit(Laboratory *lab)
{
    FieldEdit *edit = &lab->parameters.edit;
    Status status = {STATUS_DONE, ""};
    edit->open = !lab->editing.accept(lab, &status);
    if (edit->open) {
        snprintf(edit->problem, sizeof edit->problem, "%.159s", status.text);
        lab->editing.fresh = !strchr(edit->text, ' '); /* one value gives way to another, a row is mended */
    }
    return !edit->open;
}

void edit_key(Laboratory *lab, const Key *key)
{
    /* a value that is refused keeps its field open, whichever key was to leave it */
    const char *name = key->name;
    const bool up = strcmp(name, "Up") == 0 || strcmp(name, "S-Tab") == 0;
    if (strcmp(name, "Enter") == 0)
        accept_edit(lab);
    else if (strcmp(name, "Esc") == 0 || strcmp(name, "F10") == 0)
        lab->parameters.edit.open = false;
    else if (up || strcmp(name, "Down") == 0 || strcmp(name, "Tab") == 0) {
        if (accept_edit(lab))
            edit_move(lab, up ? -1 : 1);
    } else if (prompt_edit_line(lab->parameters.edit.text, sizeof lab->parameters.edit.text,
                                &lab->parameters.edit.cursor, name, lab->editing.fresh)) {
        lab->editing.fresh = false;
        lab->parameters.edit.problem[0] = '\0';
    }
}
