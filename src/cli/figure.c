/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib figure SCENARIO --view NAME --output FILE`: runs without a screen, then draws what a view of the
 * laboratory shows, at the end or at several times, on one page. */
#include "picture/paper/figure_file.h"
#include "scenario/parameters.h"
#include "answers/convergence.h"
#include "scenario/concern_output.h"
#include "scenario/settings.h"
#include "cli/cli.h"
#include "cli/options.h"
#include "export/export.h"
#include "base/output.h"
#include "views/view.h"
#include "run/playback.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>

enum { HISTORY = 64 << 20 };

/* The part of the bar that some work takes, which begins at `behind`. */
typedef struct Part {
    double behind, part;
    Progress *progress;
} Part;

static bool show_part(double share, void *context)
{
    const Part *part = context;
    return progress_show(part->behind + part->part * share, part->progress);
}

static bool work_off(Experiment *experiment, double behind, double part, Progress *progress, Status *status)
{
    Part shown = {behind, part, progress};
    return experiment_work_off(experiment, (Cancel){show_part, &shown}, status);
}

/* Goes from one time to the next and takes each down. */
static bool take_frames(Figure *figure, Experiment *experiment, Screen *screen, const View *view,
                        const Frames *frames, Progress *progress, Status *status)
{
    const int count = (int)frames->count;
    const double last = (double)(frames->steps[count - 1] > 0 ? frames->steps[count - 1] : 1);
    bool sound = true;
    for (int i = 0; i < count && sound; i++) {
        const long step = frames->steps[i];
        const double here = (double)(i > 0 ? frames->steps[i - 1] : 0) / last;
        const double there = (double)step / last;
        experiment_seek(experiment, step, 0);
        sound = work_off(experiment, here, there - here, progress, status);
        sound = sound && figure_add(figure, screen, view, count, status);
    }
    return sound;
}

static bool draw_frames(Experiment *experiment, Screen *screen, const View *view, const Frames *frames,
                        const Options *options, Progress *progress, Status *status)
{
    Figure figure;
    figure_open(&figure, options->size[0], options->size[1]);
    figure.bare = options->bare;
    bool sound = take_frames(&figure, experiment, screen, view, frames, progress, status), differ = false;
    /* Pictures of one page are compared, so displacements are enlarged alike: once more with a factor that
     * suits all, where each would have its own. */
    const double least = sound ? figure_enlargement(&figure, &differ) : 1;
    if (differ) {
        Settings settings = *experiment_settings(experiment);
        snprintf(settings_edit_view(&settings)->exaggeration, sizeof settings_view(&settings)->exaggeration,
                 "%.6g", least);
        figure_close(&figure);
        figure_open(&figure, options->size[0], options->size[1]);
        figure.bare = options->bare;
        sound = experiment_edit(experiment, &settings, status) &&
                take_frames(&figure, experiment, screen, view, frames, progress, status);
    }
    sound = sound && (progress_show(1, progress) || status_fail(status, "interrupted")) &&
            figure_write(&figure, ASKER_COMMAND_LINE, options->output, options->force, status);
    figure_close(&figure);
    return sound;
}

/* The settings of all runs behind, each another run than the first and than the others. */
static bool all_others(const OptionList *against, const Settings *settings, Settings *others, Status *status)
{
    for (int i = 0; i < against->count; i++) {
        const char *text = against->texts[i], *equals = strchr(text, '=');
        char key[KEY_MAX];
        Status why = {STATUS_DONE, ""};
        others[i] = *settings;
        if (!equals || equals == text || equals - text >= KEY_MAX)
            return status_refuse(status, "--against: \"%.80s\" sets nothing (KEY=VALUE)", text);
        snprintf(key, sizeof key, "%.*s", (int)(equals - text), text);
        if (!settings_change(&others[i], key, equals + 1, &why))
            return status_refuse(status, "--against: %s", why.text);
        if (settings_same(settings, &others[i]))
            return status_refuse(status, "--against: %.80s is what the run has already", text);
        for (int k = 0; k < i; k++)
            if (settings_same(&others[k], &others[i]))
                return status_refuse(status, "--against: %.80s is given twice (once)", text);
    }
    return true;
}

/* The steps of the pictures; their number depends on the time step, so those of another run are others. What
 * shows the start needs no run. */
static bool plan(Frames *frames, const Screen *screen, const View *view, const Settings *settings,
                 Status *status)
{
    const Experiment *experiment = screen->experiment;
    frames_free(frames);
    if (!frames_plan(frames, settings, experiment_simulation(experiment)->dt,
                     experiment_last_step(experiment), status))
        return false;
    if (view->shows_start && view->shows_start(screen, view_variant(view, screen))) {
        frames->count = 1;
        frames->steps[0] = 0;
    }
    return true;
}

/* All points of the study that the view shows. */
static bool refine(Convergence *convergence, const Screen *screen, const View *view, Progress *progress,
                   Status *status)
{
    const Settings *settings = experiment_settings(screen->experiment);
    const ConvergenceStudy *study = view_study(view, screen);
    if (!study)
        return true;
    convergence_begin(convergence, settings);
    const Cancel cancel = {progress_show, progress};
    while (convergence_lacks(convergence, settings, study))
        if (!convergence_next(convergence, study, cancel, status))
            return false;
    return true;
}

/* Whether the file can hold what the view shows at the start, before any run. What has nothing to show yet is
 * judged when it is written. */
static bool suits(const Options *options, const Screen *screen, const View *view, Status *status)
{
    Status why = {STATUS_DONE, ""};
    Figure figure;
    figure_open(&figure, options->size[0], options->size[1]);
    const bool sound = view_study(view, screen) || !figure_add(&figure, screen, view, 1, &why) ||
                       figure_suits(&figure, options->output, status);
    figure_close(&figure);
    return sound;
}

static bool draw(const Options *options, const Settings *settings, const Settings *others,
                 Experiment *experiment, Screen *screen, Progress *progress, Status *status)
{
    static const Playback running = {.state = STATE_RUNNING}; /* nothing is chosen by hand */
    Frames frames = {0};
    const View *view = NULL;
    screen->playback = &running;
    screen_read_view(screen, settings_view(settings));
    bool sound =
        figure_view(screen, options->view, &view, status) && plan(&frames, screen, view, settings, status);
    if (sound && frames.count > FIGURE_PANELS_MAX)
        sound = status_refuse(status, "a page has room for %d pictures, not %zu", FIGURE_PANELS_MAX,
                              frames.count);
    sound = sound && suits(options, screen, view, status);
    if (sound && options->against.count > 0 && frames.count > 1)
        sound = status_refuse(status, "--against: is for one picture, not for several times");
    if (sound && options->against.count > 0) {
        /* The other runs first, of which the experiment is the first one; their curves stay behind those of
         * the run itself, where there are several as pinned ones. */
        const int n_others = options->against.count;
        const double part = 1.0 / (n_others + 1);
        experiment_seek(experiment, frames.steps[0], 0);
        sound = work_off(experiment, 0, part, progress, status);
        for (int i = 0; i < n_others && sound; i++)
            sound = (n_others == 1 || experiment_pin(experiment, status)) &&
                    experiment_rerun(experiment, i + 1 < n_others ? &others[i + 1] : settings, status) &&
                    work_off(experiment, (i + 1) * part, part, progress, status);
        sound = sound && plan(&frames, screen, view, settings, status);
    }
    if (sound) {
        if (!settings_view(settings)->window[0])
            screen->time.window =
                experiment_simulation(screen->experiment)->dt * (double)frames.steps[frames.count - 1];
        Convergence convergence = {.n_studies = 0};
        screen->convergence = &convergence;
        sound = refine(&convergence, screen, view, progress, status) &&
                draw_frames(experiment, screen, view, &frames, options, progress, status);
        screen->convergence = NULL;
    }
    frames_free(&frames);
    return sound;
}

int cli_figure(Options *options, Status *status)
{
    Settings settings, others[OPTION_LIST_MAX];
    if (!options_load(options, options->words[0], &settings, status))
        return (int)status->code;
    /* pictures of a crack are compared with each other, so displacements are not enlarged unless asked for */
    if (settings.problem->concerns & CONCERN_NOTCH && !settings_view(&settings)->exaggeration[0])
        strcpy(settings_edit_view(&settings)->exaggeration, "1");
    others[0] = settings;
    bool sound = true;
    if (!options->list && !options->view)
        sound = status_refuse(status, "figure: --view NAME is missing (--list prints the names)");
    else if (!options->list && !options->output)
        sound = status_refuse(status, "figure: --output FILE is missing (FILE.svg, .pdf, .png, .tex or .gp)");
    else if (!options->list)
        sound = figure_allowed(options->output, status) &&
                output_may_begin(options->output, ASKER_COMMAND_LINE, options->force, status) &&
                all_others(&options->against, &settings, others, status);
    if (!sound)
        return (int)status->code;
    Progress progress;
    progress_begin(&progress, options->quiet);
    settings.cancel = (Cancel){progress_show, &progress};
    for (int i = 0; i < OPTION_LIST_MAX; i++)
        others[i].cancel = settings.cancel;
    Screen screen;
    screen_default(&screen);
    screen.scenario = options->words[0];
    Experiment *experiment =
        experiment_create(&others[0], HISTORY, progress_threads(options->threads), status);
    screen.experiment = experiment;
    if (experiment)
        screen.chosen.particle = selection_middle(experiment_simulation(experiment));
    if (experiment && options->list)
        figure_names(&screen, stdout);
    else
        sound = experiment && draw(options, &settings, others, experiment, &screen, &progress, status);
    progress_end(&progress);
    experiment_destroy(experiment);
    if (sound && !options->list && !options->quiet)
        printf("wrote %s\n", options->output);
    return progress_result(sound, status);
}
