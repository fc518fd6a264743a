/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The diagnosis of somebody's own code in front of a screen that goes on answering (answers/diagnose.h). */
#include "lab/diagnosing.h"

#include "answers/diagnose.h"
#include "lab/laboratory.h"
#include "views/view.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Waiting {
    Laboratory *lab;
    const Diagnosis *found;
} Waiting;

static bool wait_for_it(double share, void *context)
{
    Waiting *waiting = context;
    (void)share; /* of one run; how many it takes nobody knows */
    return laboratory_work(waiting->lab, "trying other codes, %ld so far   ^C stops", waiting->found->tried);
}

/* Their curve in the place of what lay over the plots. */
static void lay_over(Laboratory *lab, DiagnoseTable *table)
{
    Overlay theirs;
    if (!diagnose_overlay(table, &theirs))
        return;
    const char *curve = view_time_curve(&lab->screen);
    if (!overlay_choose(&theirs, "time", NULL, curve, "", NULL) &&
        !overlay_choose(&theirs, "time", table->columns[0].name, curve, "", NULL)) {
        overlay_close(&theirs);
        return;
    }
    overlay_close(&lab->overlay);
    lab->overlay = theirs;
    lab->screen.overlay = &lab->overlay;
}

/* Takes the word behind the file's name away. */
static bool take_pairs(char *path)
{
    char *word = strrchr(path, ' ');
    if (!word || strcmp(word, " pairs") != 0)
        return false;
    *word = '\0';
    return true;
}

bool diagnosing_answer(Laboratory *lab, const char *words)
{
    char path[NAME_MAX_BYTES];
    const Settings settings = *experiment_base(laboratory_run(lab));
    Status status = {STATUS_DONE, ""};
    snprintf(path, sizeof path, "%s", words + strspn(words, " "));
    Diagnosis *found = calloc(1, sizeof *found);
    Waiting waiting = {lab, found};
    const DiagnoseTask task = {.settings = &settings,
                               .threads = lab->options.threads > 0 ? lab->options.threads : 1,
                               .pairs = take_pairs(path),
                               .cancel = {wait_for_it, &waiting}};
    DiagnoseTable *table = calloc(1, sizeof *table);
    player_pause(lab);
    const bool sound = *path ? ((table && found) || status_fail(&status, "out of memory")) &&
                                   diagnose_read(table, path, &settings, NULL, &status) &&
                                   diagnose(&task, table, found, &status)
                             : status_refuse(&status, "a file is wanted: diagnose FILE.csv");
    if (sound) {
        diagnosis_sum_up(found, table, lab->diagnosis, sizeof lab->diagnosis);
        lay_over(lab, table);
        laboratory_say(lab, MESSAGE_INFO, "%s", lab->diagnosis);
    }
    if (table)
        diagnose_close(table);
    free(table);
    free(found);
    return sound || prompt_refuse(&lab->prompting, status.text);
}
