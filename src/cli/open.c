/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib [SCENARIO]` and `matvib lesson [NAME]`: the laboratory with the options of the command line. */
#include "base/input.h"
#include "base/threads.h"
#include "cli/cli.h"
#include "cli/homework.h"
#include "lab/session/laboratory_main.h"
#include "scenario/parameters.h"
#include "scenario/settings.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* The settings that the laboratory opens with: of the coarse form, where the scenario has one for the screen
 * and no option makes both the same by choosing the size itself. */
static bool load_for_screen(const Options *options, const char **scenario, Settings *settings, Status *status)
{
    Settings coarse;
    Status ignored = {0};
    const char *form = scenario_on_screen(*scenario);
    if (!options_load(options, *scenario, settings, status))
        return false;
    if (form != *scenario && options_load(options, form, &coarse, &ignored) &&
        !settings_same(settings, &coarse)) {
        *settings = coarse;
        *scenario = form;
    }
    return true;
}

/* What cannot go together: standard input has one use, and a session brings its own run. */
static bool go_together(const Options *options, const char *word, Status *status)
{
    const bool again = options->replay || options->last;
    if (again && (options->n_words > 0 || options->n_overrides > 0 || options->steps > 0 || options->paused))
        return status_refuse(status, "%s: a session has its own scenario and parameters",
                             options->last ? "--last" : "--replay");
    if (options->plain && (again || options->script))
        return status_refuse(status, "--plain: lines come from standard input (leave %s out)",
                             again ? "the session" : "--script");
    const bool keys_elsewhere = options->script && strcmp(options->script, input_standard_name) != 0;
    return !word || strcmp(word, input_standard_name) != 0 || keys_elsewhere ||
           status_refuse(status, "-: keys come from standard input (matvib run - reads a scenario there)");
}

/* `lesson`: NULL where none is opened; `named`: what the scenario was called. */
static int enter(const Options *options, const char *named, const char *lesson, const HomeworkFile *homework,
                 Status *status)
{
    Settings settings;
    const char *scenario = named;
    if (!load_for_screen(options, &scenario, &settings, status))
        return (int)status->code;
    const int result = laboratory_main(
        &(LaboratoryOptions){
            .settings = &settings,
            .scenario = scenario,
            .is_coarse = scenario != named,
            .lesson = lesson,
            .student = *homework->student ? homework->student : NULL,
            .student_id = *homework->id ? homework->id : NULL,
            .paused = options->paused || lesson,
            .glyphs = options->glyphs,
            .theme = options->theme,
            .sheet = options->screen_sheet,
            .no_mouse = options->no_mouse,
            .history = options->history,
            .threads = options->threads > 0 ? (int)options->threads : threads_default(!options->script),
            .script = options->script,
            .plain = options->plain,
            .record = *homework->file ? homework->file : options->record,
            .replay = options->replay,
            .last = options->last,
            .fast = options->fast,
            .force = options->force,
            .width = options->size[0],
            .height = options->size[1],
        },
        status);
    if (result != STATUS_DONE && status)
        options_blame(options, scenario, status);
    return result;
}

int cli_open(Options *options, Status *status)
{
    const char *word = options->n_words > 0 ? options->words[0] : NULL;
    const char *scenario = word ? word : scenario_unnamed;
    if (!go_together(options, word, status) || !options_words(options, 0, 1, "[SCENARIO]", status))
        return (int)status->code;
    return enter(options, scenario, NULL, &(HomeworkFile){.file = ""}, status);
}

int cli_lesson(Options *options, Status *status)
{
    HomeworkFile homework;
    const char *word = options->n_words > 0 ? options->words[0] : NULL;
    if (options->list)
        return cli_list_lessons();
    if (options->print)
        return cli_lesson_print(word, status);
    if (!homework_begin(options, word, &homework, status))
        return (int)status->code;
    if (options->handout)
        return cli_lesson_handout(options, homework.student, status);
    if (!go_together(options, NULL, status))
        return (int)status->code;
    const int result =
        enter(options, scenario_unnamed, word ? word : laboratory_all_lessons, &homework, status);
    if (result == STATUS_DONE && *homework.file && access(homework.file, F_OK) == 0)
        printf("Hand in this file: %s\n", homework.file);
    return result;
}
