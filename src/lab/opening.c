/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Opening the laboratory and other scenarios in it: what a run is begun with, and at which pace. */
#include "lab/opening.h"
#include "lab/laboratory.h"
#include "panes/screen.h"
#include "scenario/concern_output.h"
#include "scenario/settings.h"
#include "lab/commands/commands.h"
#include "lab/second_run.h"
#include "base/visible.h"
#include "scenario/scenario.h"
#include "views/view.h"

#include <math.h>
#include <stdio.h>

static void read_view(Laboratory *lab)
{
    const ViewSettings *view = settings_view(experiment_settings(laboratory_run(lab)));
    Screen *screen = &lab->screen;
    double value;
    views_open(screen, view);
    if (sscanf(view->pace, "%lf", &value) == 1 && value > 0) {
        lab->player.playback.pace = value;
        lab->player.pace_automatic = false;
    }
    screen_read_view(screen, view);
}

static size_t history_size(const Laboratory *lab)
{
    return lab->options.history ? lab->options.history : (size_t)256 << 20;
}

static int threads_of(const Laboratory *lab)
{
    return lab->options.threads > 0 ? lab->options.threads : 1;
}

void opening_begin(Laboratory *lab, Experiment *experiment)
{
    Screen *screen = &lab->screen;
    Experiment *before = laboratory_run(lab);
    duel_open(&lab->player.duel, experiment, history_size(lab), threads_of(lab));
    /* only now, when nothing shows it any more */
    experiment_destroy(before);
    screen->experiment = experiment;
    lab->player.pace_automatic = true;
    /* what could be undone was of another run */
    lab->editing.n_undo = lab->editing.n_redo = 0;
    lab->editing.changed = false;
    lab->editing.anchor_step = screen->log.event = -1;
    lab->player.bookmarks.count = screen->log.first = 0;
    lab->player.owed = 0;
    player_forget_rates(&lab->player);
    lab->player.frames_in_time = 0;
    lab->player.playback.at_limit = false;
    screen->summary = NULL;
    screen->time.cursor = NAN;
    if (screen->panes.inspecting && screen->panes.focus == PANE_INSPECTOR)
        screen->panes.focus = screen->panes.before_inspector;
    screen->panes.inspecting = false;
    const Simulation *simulation = experiment_simulation(experiment);
    screen->chosen.particle = selection_middle(simulation);
    screen->chosen.is_node = false;
    screen->chosen.node = simulation->n_sets > 1 ? simulation->counts[1] / 2 : 0;
    player_choose_pace(&lab->player);
    /* after what was chosen for it: what the scenario says itself goes before */
    read_view(lab);
    screen->duel = &lab->player.duel;
    screen->convergence = &lab->refining.convergence;
    lab->player.second_ended = false;
    lab->parameters.selected = screen_row_of(screen, NULL);
    if (screen_is_plain(screen))
        screen->panes.last_plot = view_pane_of_number(screen);
    lab->player.resume = lab->player.playback.state = STATE_RUNNING;
    player_stop_at(lab, &(Stop){.kind = STOP_NEVER});
    player_loop(lab, &(Stretch){.on = false});
    lab->player.playback.slow = false;
    laboratory_say(lab, MESSAGE_NONE, "%s", "");
    second_run_open(lab);
    const char *advice = experiment_advice(laboratory_run(lab));
    /* what the second run had to say is there already, and goes before */
    if (advice && !lab->message.text[0])
        laboratory_say(lab, MESSAGE_WARNING, "%s", advice);
}

void opening_name(Laboratory *lab, const char *name)
{
    visible_text(lab->scenario, sizeof lab->scenario, name ? name : "");
    lab->screen.scenario = lab->scenario;
}

/* Building that takes no longer is not reported. */
#define BUILDING_SECONDS 0.15

static bool show_building(double share, void *context)
{
    Laboratory *lab = context;
    double now = lab->host.now(lab->host.context);
    if (share <= 0)
        lab->built_at = now;
    if (!lab->given_up && now < lab->built_at + BUILDING_SECONDS)
        return true;
    /* before there is a screen the terminal hands on ^C alone */
    return laboratory_work(lab, "building the run: %d %%   %s gives up", (int)(100 * share),
                           laboratory_run(lab) ? "Esc" : "^C");
}

void opening_show_progress(Laboratory *lab, Settings *settings)
{
    settings->cancel = (Cancel){show_building, lab};
}

Experiment *opening_experiment(const Laboratory *lab, const Settings *settings, Status *status)
{
    return experiment_create(settings, history_size(lab), threads_of(lab), status);
}

Asker laboratory_user(const Laboratory *lab)
{
    /* what is filmed is told by its content, and a file that looks like a session may hold a script's keys */
    if (lab->options.camera)
        return ASKER_REPLAY;
    return lab->options.script ? ASKER_SCRIPT : ASKER_KEYBOARD;
}

/* Another scenario in the place of this one. False: the status says why, and this one stays. */
static bool open_scenario(Laboratory *lab, const char *name, Status *status)
{
    Settings settings;
    Experiment *experiment = NULL;
    if (scenario_load(name, &settings, status) &&
        (view_check(settings_view(&settings), status) || (scenario_blame(name, NULL, 0, status), false))) {
        /* checked before, for this may take long */
        opening_show_progress(lab, &settings);
        experiment = opening_experiment(lab, &settings, status);
        if (!experiment)
            scenario_blame(name, NULL, 0, status);
    }
    if (experiment) {
        Screen fresh;
        screen_default(&fresh);
        lab->screen.views.n_variants = 0;
        lab->parameters.filter[0] = '\0';
        /* a stretch of the old run's time would show nothing of this one */
        lab->screen.time.window = fresh.time.window;
        lab->screen.views.references = fresh.views.references;
        command_map_whole(&lab->screen);
        opening_name(lab, name);
        opening_begin(lab, experiment);
    }
    return experiment != NULL;
}

static bool open_or_refuse(Laboratory *lab, const char *name)
{
    Status status = {STATUS_DONE, ""};
    return open_scenario(lab, name, &status) || prompt_refuse(&lab->prompting, status.text);
}

void opening_tell_coarse(Laboratory *lab)
{
    if (!lab->message.text[0])
        laboratory_say(lab, MESSAGE_INFO, "coarse form of %s; :full opens the whole",
                       scenario_whole(lab->scenario));
}

bool opening_answer(Laboratory *lab, const char *text)
{
    const char *form = scenario_on_screen(text);
    if (!text[0])
        return true;
    const bool opened = open_or_refuse(lab, form);
    if (opened && form != text)
        opening_tell_coarse(lab);
    return opened;
}

bool opening_whole(Laboratory *lab, const char *text)
{
    const char *whole = text[0] ? text : scenario_whole(lab->scenario);
    if (!whole)
        return prompt_refuse(&lab->prompting,
                             "this is no coarse form (full SCENARIO opens one at full size)");
    return open_or_refuse(lab, whole);
}
