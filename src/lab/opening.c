/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Opening the laboratory and other scenarios in it: what a run is begun with, and at which pace. */
#include "scenario/concern_output.h"
#include "lab/commands/commands.h"
#include "base/visible.h"
#include "scenario/scenario.h"
#include "views/view.h"

#include <math.h>
#include <stdio.h>
#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

void opening_begin(Laboratory *lab, Experiment *experiment)
{
    Screen *screen = &lab->screen;
    Experiment *before = laboratory_run(lab);
    duel_open(&lab->player.duel, experiment, lab->options.history, lab->options.threads);
    /* only now, when nothing shows it any more */
    experiment_destroy(before);
    screen->experiment = experiment;
    lab->player.pace_automatic = true;
    /* what could be undone, and what was found, was of another run */
    lab->editing.n_undo = lab->editing.n_redo = 0;
    lab->diagnosis[0] = '\0';
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
    const ViewSettings *view = settings_view(laboratory_settings(lab));
    double pace;
    views_open(screen, view);
    if (sscanf(view->pace, "%lf", &pace) == 1 && pace > 0) {
        lab->player.playback.pace = pace;
        lab->player.pace_automatic = false;
    }
    screen_read_view(screen, view);
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
    command_second_open(lab);
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

static bool show_building(double share, void *context)
{
    Laboratory *lab = context;
    double now = lab->host.now(lab->host.context);
    if (share <= 0)
        lab->work_since = now;
    if (!lab->given_up && now < lab->work_since + QUIET_SECONDS)
        return true;
    /* before there is a screen the terminal hands on ^C alone */
    return laboratory_work(lab, "building the run: %d %%   %s cancels", (int)(100 * share),
                           laboratory_run(lab) ? "Esc" : "^C");
}

Experiment *opening_experiment(Laboratory *lab, const Settings *settings, Status *status)
{
    Settings shown = *settings;
    shown.cancel = (Cancel){show_building, lab};
    return experiment_create(&shown, lab->options.history, lab->options.threads, status);
}

Asker laboratory_user(const Laboratory *lab)
{
    /* a film is recognised by its content, and a file like a session may hold the keys of a script */
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
        (view_check(&settings, scenario_builtin(name) ? &settings : NULL, status) ||
         (scenario_blame(name, NULL, 0, status), false))) {
        /* checked before, for this may take long */
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

void opening_tell_coarse(Laboratory *lab)
{
    if (!lab->message.text[0])
        laboratory_tell(lab, "coarse form of %s; :full opens the whole", scenario_whole(lab->scenario));
}

bool opening_answer(Laboratory *lab, const char *text, Status *status)
{
    const char *form = scenario_on_screen(text);
    if (!text[0])
        return true;
    if (!open_scenario(lab, form, status))
        return false;
    if (form != text)
        opening_tell_coarse(lab);
    return true;
}

bool opening_whole(Laboratory *lab, const char *text, Status *status)
{
    const char *whole = text[0] ? text : scenario_whole(lab->scenario);
    if (!whole)
        return status_refuse(status, "this is not a coarse form (full SCENARIO opens one at full size)");
    return open_scenario(lab, whole, status);
}

/* Opening a scenario: from a list with titles, that shrinks to what is typed, or by a path. */

static void offer(ScenarioList *list, const char *name, const char *title)
{
    if (list->count == SCENARIOS_MAX || strlen(name) >= SCENARIO_NAME_MAX)
        return;
    snprintf(list->entries[list->count].name, SCENARIO_NAME_MAX, "%s", name);
    snprintf(list->entries[list->count].title, TITLE_MAX, "%s", title);
    list->count++;
}

static bool choose_by_key(Laboratory *lab, const char *key)
{
    static const struct {
        const char *key;
        int rows;
    } moves[] = {{"Up", -1}, {"Down", 1}, {"PageUp", -8}, {"PageDown", 8}};
    Prompting *prompting = &lab->prompting;
    ScenarioList *list = &prompting->scenarios;
    size_t i = 0;
    while (i < sizeof moves / sizeof *moves && strcmp(key, moves[i].key) != 0)
        i++;
    if (i == sizeof moves / sizeof *moves)
        return false;
    if (list->n_shown == 0)
        return true;
    /* A first key moves from the open one, so that the way to the next is short, but what was searched for
     * begins at its top, or its end. */
    const int rows = moves[i].rows, next = list->open + rows;
    const bool from_open =
        prompting->shown.text[0] == '\0' && list->open >= 0 && next >= 0 && next < list->n_shown;
    const int from = list->chosen >= 0 ? list->chosen
                     : from_open       ? list->open
                     : rows > 0        ? -1
                                       : list->n_shown;
    const int to = from + rows;
    list->chosen = to < 0 ? 0 : to < list->n_shown ? to : list->n_shown - 1;
    prompt_fill(prompting, list->entries[list->shown[list->chosen]].name); /* typing begins a new search */
    prompting->shown.hint[0] = '\0';
    return true;
}

/* What is shown: whatever holds the text in its name or its title. */
static void narrow_to_text(Laboratory *lab, const char *key)
{
    ScenarioList *list = &lab->prompting.scenarios;
    const char *text = lab->prompting.shown.text;
    (void)key;
    list->n_shown = 0;
    list->chosen = list->open = -1;
    for (int i = 0; i < list->count; i++)
        if (strcasestr(list->entries[i].name, text) || strcasestr(list->entries[i].title, text)) {
            if (strcmp(list->entries[i].name, lab->scenario) == 0)
                list->open = list->n_shown;
            list->shown[list->n_shown++] = i;
        }
}

/* What was typed is a name or a path; where it is neither, the first scenario left in the list is meant. */
static bool answer_scenario(Laboratory *lab, const char *text, Status *status)
{
    const ScenarioList *list = &lab->prompting.scenarios;
    if (text[0] && list->n_shown > 0 && !scenario_builtin(text) && access(text, F_OK) != 0)
        text = list->entries[list->shown[0]].name;
    return opening_answer(lab, text, status);
}

static const Typing typing = {.key = choose_by_key, .offer = complete_scenarios, .typed = narrow_to_text};

void opening_ask(Laboratory *lab)
{
    ScenarioList *list = &lab->prompting.scenarios;
    list->count = 0;
    for (const BuiltinScenario *builtin = builtin_scenarios; builtin->name; builtin++) {
        char title[TITLE_MAX];
        offer(list, builtin->name, scenario_title(builtin, title) ? title : "");
    }
    struct dirent **names;
    Settings *settings = malloc(sizeof *settings);
    const int count = settings ? scandir(".", &names, NULL, complete_by_name) : -1;
    for (int i = 0; i < count; i++) {
        /* A file of the folder that can be opened; not the ones beside tables, which are many. */
        struct stat file;
        Status ignored = {STATUS_DONE, ""};
        const char *name = names[i]->d_name;
        const size_t length = strlen(name);
        const bool named = length >= 5 && strcmp(name + length - 4, ".ini") == 0 &&
                           !(length > 8 && strcmp(name + length - 8, ".csv.ini") == 0);
        if (named && stat(name, &file) == 0 && S_ISREG(file.st_mode) &&
            scenario_load(name, settings, &ignored))
            offer(list, name, settings->title);
        free(names[i]);
    }
    if (count >= 0)
        free(names);
    free(settings);
    prompt_ask(lab, answer_scenario, &typing, "", "open scenario or file");
    lab->prompting.shown.scenarios = list;
    narrow_to_text(lab, NULL);
}
