/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "views/scene.h"
#include "views/view.h"
#include "panes/screen.h"
#include "scenario/settings.h"
#include "scenario/scenario.h"
#include "answers/summary.h"
#include "run/playback.h"
#include "run/duel.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Plan {
    Settings settings;
    int width, height;
    long steps, stages, back, particle;
    int points;            /* of a study; 0: all */
    int variant;           /* of all views */
    char ghost[VALUE_MAX]; /* key=value of an edit after the steps */
    char duel[VALUE_MAX];  /* key=value of the second run; "": those of the scenario */
    bool duels;
} Plan;

/* A word that takes no number; false: it is none. */
static bool simple_word(Scene *scene, const char *word)
{
    Screen *screen = &scene->screen;
    if (strcmp(word, "running") == 0)
        scene->playback.state = STATE_RUNNING, scene->playback.pace = 10;
    else if (strcmp(word, "ended") == 0)
        scene->playback.state = STATE_ENDED;
    else if (strcmp(word, "computing") == 0)
        scene->playback.state = STATE_COMPUTING, scene->playback.work_share = 0.42;
    else if (strcmp(word, "ascii") == 0)
        screen->look.glyphs = GLYPHS_ASCII;
    else if (strcmp(word, "block") == 0)
        screen->look.glyphs = GLYPHS_BLOCK;
    else if (strcmp(word, "lecture") == 0)
        screen->panes.lecture = true;
    else if (strcmp(word, "bare") == 0)
        screen->panes.sheet = SHEET_PLAIN, scene->parameters.selected = 0;
    else if (strcmp(word, "zoom") == 0)
        screen->panes.zoomed = true;
    else if (strcmp(word, "none") == 0)
        screen->views.references = SHOW_NONE;
    else if (strcmp(word, "exact") == 0)
        screen->views.references = SHOW_EXACT;
    else if (strcmp(word, "inspect") == 0)
        screen->panes.inspecting = true, screen->panes.focus = PANE_INSPECTOR;
    else if (strcmp(word, "refined") == 0)
        scene->refined = true;
    else if (strcmp(word, "node") == 0)
        screen->chosen.is_node = true;
    else if (strcmp(word, "styles") == 0)
        scene->styles = true;
    else if (strcmp(word, "eight") == 0)
        screen->look.colours = 8;
    else if (strcmp(word, "plain") == 0)
        screen->look.colours = 0;
    else if (strcmp(word, "edit") == 0) {
        scene->parameters.edit.open = true;
        strcpy(scene->parameters.edit.text, "12.5");
        scene->parameters.edit.cursor = 4;
    } else
        return false;
    return true;
}

static bool number_word(Scene *scene, Plan *plan, const char *word, const char *number)
{
    Screen *screen = &scene->screen;
    if (strcmp(word, "help") == 0)
        scene->help.open = true, scene->help.page = atoi(number);
    else if (strcmp(word, "points") == 0) /* of a study, the first ones */
        scene->refined = true, plan->points = atoi(number);
    else if (strcmp(word, "scroll") == 0)
        scene->help.scroll = atoi(number);
    else if (strcmp(word, "upper") == 0)
        screen->views.upper = view_named(number);
    else if (strcmp(word, "lower") == 0)
        screen->views.lower = view_named(number);
    else if (strcmp(word, "variant") == 0)
        plan->variant = atoi(number);
    else if (strcmp(word, "focus") == 0)
        screen->panes.focus = (PaneId)atoi(number);
    else if (strcmp(word, "select") == 0)
        scene->parameters.selected = atoi(number);
    else if (strcmp(word, "stage") == 0)
        plan->stages = atol(number);
    else if (strcmp(word, "back") == 0)
        plan->back = atol(number);
    else if (strcmp(word, "particle") == 0)
        plan->particle = atol(number);
    else if (strcmp(word, "window") == 0)
        screen->time.window = atof(number);
    else if (strcmp(word, "cursor") == 0)
        screen->time.cursor = atof(number);
    else if (strcmp(word, "magnified") == 0)
        screen->eye.magnified = atof(number);
    else if (strcmp(word, "at") == 0)
        sscanf(number, "%lf,%lf", &screen->eye.centre[0], &screen->eye.centre[1]);
    else if (strcmp(word, "ghost") == 0)
        snprintf(plan->ghost, sizeof plan->ghost, "%s", number);
    else
        return false;
    return true;
}

static bool assign(Settings *settings, char *word, Status *status)
{
    char *equals = strchr(word, '=');
    *equals = '\0';
    return (settings_row_is_key(settings, word) ? settings_row_key_set : settings_set)(settings, word,
                                                                                       equals + 1, status);
}

static bool read_words(Scene *scene, Plan *plan, const char *words, Status *status)
{
    char copy[512], *rest = copy;
    snprintf(copy, sizeof copy, "%s", words);
    const char *scenario = strtok_r(rest, " ", &rest), *size = strtok_r(rest, " ", &rest);
    const char *steps = strtok_r(rest, " ", &rest);
    if (!scenario || !size || !steps || sscanf(size, "%dx%d", &plan->width, &plan->height) != 2)
        return status_refuse(status, "a scene is SCENARIO WxH STEPS [words]");
    snprintf(scene->scenario, sizeof scene->scenario, "%s", scenario);
    plan->steps = atol(steps);
    if (!scenario_load(scenario, &plan->settings, status))
        return false;
    for (char *word; (word = strtok_r(rest, " ", &rest));) {
        if (simple_word(scene, word))
            continue;
        if (strcmp(word, "duel") == 0) {
            plan->duels = true;
            continue;
        }
        if (strchr(word, '=') && plan->duels && !plan->duel[0]) {
            snprintf(plan->duel, sizeof plan->duel, "%s", word);
            continue;
        }
        if (strchr(word, '=')) {
            if (!assign(&plan->settings, word, status))
                return false;
            continue;
        }
        const char *number = strtok_r(rest, " ", &rest);
        if (!number || !number_word(scene, plan, word, number))
            return status_refuse(status, "%s: not a word of a scene", word);
    }
    return true;
}

static bool work_off(Duel *duel, Status *status)
{
    while (duel_pending(duel, NULL))
        if (!duel_work(duel, (Effort){.steps = 100000}, &(bool){false}, status))
            return false;
    return true;
}

static bool begin_duel(Scene *scene, const Plan *plan, Status *status)
{
    Assignment keys[DUEL_MAX];
    int n_keys = plan->settings.n_duel;
    memcpy(keys, plan->settings.duel, sizeof keys);
    if (plan->duel[0])
        n_keys = duel_read_keys(plan->duel, keys, status);
    return n_keys > 0 && duel_start(&scene->duel, keys, n_keys, status) && work_off(&scene->duel, status);
}

static bool play(Scene *scene, Plan *plan, Status *status)
{
    Screen *screen = &scene->screen;
    Experiment *experiment = experiment_create(&plan->settings, 64 << 20, 1, status);
    screen->experiment = experiment;
    if (!experiment)
        return false;
    const Simulation *sim = experiment_simulation(experiment);
    screen->chosen.particle = plan->particle >= 0 ? (size_t)plan->particle : selection_middle(sim);
    screen->chosen.node = sim->n_sets > 1 ? sim->counts[1] / 2 : 0;
    Duel *duel = &scene->duel;
    duel_open(duel, experiment, 64 << 20, 1);
    screen->duel = duel;
    for (int i = 0; i < n_views && plan->variant > 0; i++)
        view_choose_variant(views[i], screen, plan->variant);
    if (plan->duels && !begin_duel(scene, plan, status))
        return false;
    if (!duel_advance(duel, (Effort){.steps = plan->steps}, &(bool){false}, status))
        scene->playback.state = STATE_FAILED;
    experiment_rest(experiment);
    if (duel->b)
        experiment_rest(duel->b);
    if (plan->ghost[0]) {
        Settings edited = *experiment_settings(experiment);
        if (!assign(&edited, plan->ghost, status) || !duel_change(duel, &edited, experiment_edit, status) ||
            !work_off(duel, status))
            return false;
    }
    if (plan->back > 0) {
        duel_seek(duel, experiment_step(experiment) - plan->back, 0);
        if (!work_off(duel, status))
            return false;
    }
    for (long i = 0; i < plan->stages; i++)
        if (!duel_next_stage(duel, status))
            return false;
    return true;
}

static bool refine(Scene *scene, const Plan *plan, Status *status)
{
    const Settings *settings = experiment_settings(scene->screen.experiment);
    const ConvergenceStudy *study = view_study(scene->screen.views.lower, &scene->screen);
    const Cancel forever = {NULL, NULL};
    scene->screen.convergence = &scene->convergence;
    convergence_begin(&scene->convergence, settings);
    for (int i = 0; study && convergence_lacks(&scene->convergence, settings, study); i++)
        if (plan->points > 0 && i == plan->points)
            break;
        else if (!convergence_next(&scene->convergence, study, forever, status))
            return false;
    return true;
}

bool scene_open(Scene *scene, const char *words, Status *status)
{
    *scene = (Scene){.scenario = ""};
    Plan plan = {.particle = -1};
    screen_default(&scene->screen);
    scene->playback = *scene->screen.playback;
    scene->screen.playback = &scene->playback;
    scene->screen.parameters = &scene->parameters;
    scene->screen.help = &scene->help;
    scene->screen.bookmarks = &scene->bookmarks;
    scene->screen.lesson = &scene->lesson;
    scene->screen.prompt = &scene->prompt;
    scene->screen.message = &scene->message;
    scene->screen.used = &scene->used;
    scene->screen.scenario = scene->scenario;
    scene->parameters.selected = 1;
    if (!read_words(scene, &plan, words, status) || !play(scene, &plan, status) ||
        !canvas_open(&scene->canvas, plan.width, plan.height, status))
        return false;
    if (scene->playback.state == STATE_ENDED) {
        summary_of(scene->screen.experiment, &scene->summary);
        scene->screen.summary = &scene->summary;
    }
    if (screen_is_plain(&scene->screen) && scene->screen.panes.last_plot == PANE_LOWER)
        scene->screen.panes.last_plot = view_pane_of_number(&scene->screen);
    if (!scene->duel.b)
        scene->screen.duel = NULL; /* a scene without one may be copied */
    if (scene->refined && !refine(scene, &plan, status))
        return false;
    screen_draw(&scene->screen, &scene->canvas);
    return true;
}

void scene_close(Scene *scene)
{
    duel_close(&scene->duel);
    experiment_destroy(scene->duel.a);
    scene->screen.experiment = scene->duel.a = NULL;
    canvas_close(&scene->canvas);
}
