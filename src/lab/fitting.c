/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Work of seconds in front of a screen that goes on answering: a fit of the run on screen to the overlay (the
 * search of answers/fit_search.h), and a diagnosis. */
#include "lab/laboratory.h"

#include "base/text.h"
#include "answers/fit_search.h"
#include "scenario/parameters.h"
#include "views/view.h"
#include "answers/diagnose/diagnose.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Waiting {
    Laboratory *lab;
    const FitTask *task;
    long asked;
} Waiting;

static bool wait_for_fit(double share, void *context)
{
    Waiting *waiting = context;
    (void)share; /* of one run; how many it takes nobody knows */
    return laboratory_work(waiting->lab, "fitting %d parameter%s to %zu data, %ld blocks of steps   ^C stops",
                           waiting->task->n_keys, waiting->task->n_keys == 1 ? "" : "s", waiting->task->count,
                           ++waiting->asked);
}

static bool solve(Laboratory *lab, FitTask *task, Settings *settings, Status *status)
{
    FitResult result = {0};
    Waiting waiting = {lab, task, 0};
    task->cancel = (Cancel){wait_for_fit, &waiting};
    bool sound = fit_solve(task, &result, status);
    for (int i = 0; i < task->n_keys && sound; i++)
        fit_put(settings, task->keys[i], result.values[i]);
    sound = sound && edit_change(lab, settings, experiment_replace, status);
    if (sound) {
        /* "bar.density 1.02 +- 0.01, ...; residuals 3e-3, before 2e-2: noise; correlation 0.4" */
        char text[sizeof lab->message.text] = "fitted:";
        for (int i = 0; i < task->n_keys; i++)
            text_append(text, sizeof text, "%s %s %s +- %s", i ? "," : "", task->keys[i],
                        text_rounded(result.values[i], 6).text,
                        text_rounded(result.noise.half_widths[i], 2).text);
        text_append(text, sizeof text, " (95 %%); residuals %s, before %s: %s",
                    text_rounded(result.rms, 3).text, text_rounded(result.rms_before, 3).text,
                    fit_verdict(&result));
        for (int i = 1; i < task->n_keys; i++)
            for (int j = 0; j < i; j++)
                text_append(text, sizeof text, "%s %.2f", i + j == 1 ? "; correlation" : ",",
                            result.noise.correlations[i][j]);
        laboratory_tell(lab, "%s; u: as before", text);
    }
    fit_free(&result);
    return sound;
}

bool fitting_answer(Laboratory *lab, const char *words, Status *status)
{
    Settings settings = *experiment_base(laboratory_run(lab)), begun = settings;
    FitTask task = {.settings = &begun, .threads = lab->options.threads};
    FitData data = {.times = NULL};
    char list[sizeof lab->prompting.shown.text], keys[FIT_KEYS_MAX][KEY_MAX];
    int y = -1;
    snprintf(list, sizeof list, "%s", words);
    if (!lab->screen.overlay || lab->overlay.along)
        return status_refuse(status, "load a series over time first: overlay FILE.csv");
    /* The series of the run that is compared: the one on screen, or else the first that the overlay has. */
    const Simulation *sim = laboratory_simulation(lab);
    const char *shown = view_curve(&lab->screen, true);
    y = overlay_column_for(&lab->overlay, shown, false);
    if (y >= 0 && simulation_find_series(sim, shown) >= 0)
        task.column = shown;
    for (int i = 0; !task.column && i < sim->n_series; i++)
        if ((y = overlay_column_for(&lab->overlay, sim->series[i].name, false)) >= 0)
            task.column = sim->series[i].name;
    if (!task.column)
        return status_refuse(status, "the overlay has no column of this run's series");
    char column[OVERLAY_NAME_MAX];
    snprintf(column, sizeof column, "%s", task.column); /* the run on screen goes, and its names with it */
    task.column = column;
    player_pause(lab);
    bool sound = fit_data_keys(list, &task, status);
    for (int i = 0; i < task.n_keys && sound; i++) {
        sound = settings_resolve_key(&settings, task.keys[i], keys[i], status);
        task.keys[i] = keys[i];
    }
    sound = sound && fit_data_take(&data, &lab->overlay, y, status) && fit_data_end(&data, &begun, status);
    task.times = data.times;
    task.values = data.values;
    task.count = data.count;
    sound = sound && solve(lab, &task, &settings, status);
    fit_data_free(&data);
    return sound;
}

/* The diagnosis of somebody's own code in front of a screen that goes on answering (diagnose.h). */

typedef struct Diagnosing {
    Laboratory *lab;
    const Diagnosis *found;
} Diagnosing;

static bool wait_for_it(double share, void *context)
{
    Diagnosing *waiting = context;
    (void)share; /* of one run; how many it takes nobody knows */
    return laboratory_work(waiting->lab, "trying other codes, %ld so far   ^C stops", waiting->found->tried);
}

bool fitting_diagnose(Laboratory *lab, const char *words, Status *status)
{
    char path[NAME_MAX_BYTES];
    const Settings settings = *experiment_base(laboratory_run(lab));
    snprintf(path, sizeof path, "%s", words + strspn(words, " "));
    char *word = strrchr(path, ' ');
    const bool pairs = word && strcmp(word, " pairs") == 0;
    if (pairs)
        *word = '\0';
    Diagnosis *found = calloc(1, sizeof *found);
    Diagnosing waiting = {lab, found};
    const DiagnoseTask task = {.settings = &settings,
                               .threads = lab->options.threads,
                               .pairs = pairs,
                               .cancel = {wait_for_it, &waiting}};
    DiagnoseTable *table = calloc(1, sizeof *table);
    player_pause(lab);
    const bool sound = *path ? ((table && found) || status_fail(status, "out of memory")) &&
                                   diagnose_read(table, path, &settings, NULL, status) &&
                                   diagnose(&task, table, found, status)
                             : status_refuse(status, "a file is expected: diagnose FILE.csv");
    if (sound) {
        diagnosis_sum_up(found, table, lab->diagnosis, sizeof lab->diagnosis);
        /* Their curve in the place of what lay over the plots. */
        const char *curve = view_curve(&lab->screen, true);
        Overlay theirs;
        const bool any = diagnose_overlay(table, &theirs);
        if (any && (overlay_choose(&theirs, "time", NULL, curve, "", NULL) ||
                    overlay_choose(&theirs, "time", table->as.columns[0].name, curve, "", NULL))) {
            overlay_close(&lab->overlay);
            lab->overlay = theirs;
            lab->screen.overlay = &lab->overlay;
        } else if (any)
            overlay_close(&theirs);
        if (!screen_shows_diagnosis(&lab->screen, lab->width, lab->height))
            laboratory_tell(lab, "%s", lab->diagnosis);
    }
    if (table)
        diagnose_close(table);
    free(table);
    free(found);
    return sound;
}
