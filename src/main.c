/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Arguments in, exit status out: the only place that prints an error or exits. */
#include "base/input.h"
#include "base/threads.h"
#include "scenario/settings.h"
#include "base/visible.h"
#include "cli/cli.h"
#include "cli/homework.h"
#include "cli/options.h"
#include "scenario/parameters.h"
#include "lab/session/laboratory_main.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* "rnu mode1" is no scenario but a slip of the fingers, or a command that this version has not. */
static bool is_slip(const char *word, Status *status)
{
    if (scenario_builtin(word) || strcmp(word, input_standard_name) == 0 || access(word, F_OK) == 0 ||
        errno != ENOENT)
        return false;
    const char *nearest = cli_nearest(word);
    if (nearest && !cli_find(nearest))
        return false; /* a scenario is meant, and its reader says which */
    if (nearest)
        status_fail(status, STATUS_USAGE, "%.60s: no such command, scenario or file (did you mean %s?)", word,
                    nearest);
    else
        status_fail(status, STATUS_USAGE, "%.60s: no such command, scenario or file (see: matvib --help)",
                    word);
    return true;
}

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

/* No command word, or `lesson`: the laboratory. */
static int open_laboratory(bool for_lesson, int count, char **arguments, Status *status)
{
    Options options;
    Settings settings;
    if (!options_parse(for_lesson ? "lesson" : "open", count, arguments, &options, status) ||
        (for_lesson && !options_words(&options, 0, 1, "[NAME]", status)))
        return (int)status->code;
    if (options.help) {
        cli_print_help(NULL);
        return STATUS_DONE;
    }
    if (options.list)
        return cli_list_lessons();
    const char *word = options.n_words > 0 ? options.words[0] : NULL;
    if (options.print)
        return cli_lesson_print(word, status);
    HomeworkFile homework;
    if (!homework_begin(&options, for_lesson ? word : NULL, &homework, status))
        return (int)status->code;
    if (options.handout)
        return cli_lesson_handout(&options, homework.student, status);
    bool again = options.replay || options.last;
    if (again && (options.n_words > 0 || options.n_overrides > 0 || options.steps > 0 || options.paused)) {
        status_fail(status, STATUS_USAGE, "%s: a session has its own scenario and parameters",
                    options.last ? "--last" : "--replay");
        return (int)status->code;
    }
    if (options.plain && (again || options.script)) {
        status_fail(status, STATUS_USAGE, "--plain: lines come from standard input (leave %s out)",
                    again ? "the session" : "--script");
        return (int)status->code;
    }
    if (word && strcmp(word, input_standard_name) == 0 &&
        !(options.script && strcmp(options.script, word) != 0)) {
        status_fail(status, STATUS_USAGE,
                    "-: keys come from standard input (matvib run - reads a scenario there)");
        return (int)status->code;
    }
    const char *const named = word && !for_lesson ? word : scenario_unnamed;
    const char *scenario = named;
    const char *lesson = !for_lesson ? NULL : word ? word : laboratory_all_lessons;
    if (is_slip(scenario, status) || !options_words(&options, 0, 1, "[SCENARIO]", status) ||
        !load_for_screen(&options, &scenario, &settings, status))
        return (int)status->code;
    const char *recording = *homework.file ? homework.file : options.record;
    const int result = laboratory_main(
        &(LaboratoryOptions){
            .settings = &settings,
            .scenario = scenario,
            .is_coarse = scenario != named,
            .lesson = lesson,
            .student = *homework.student ? homework.student : NULL,
            .student_id = *homework.id ? homework.id : NULL,
            .paused = options.paused || for_lesson,
            .glyphs = options.glyphs,
            .theme = options.theme,
            .sheet = options.screen_sheet,
            .no_mouse = options.no_mouse,
            .history = options.history,
            .threads = options.threads > 0 ? (int)options.threads : threads_default(!options.script),
            .script = options.script,
            .plain = options.plain,
            .record = recording,
            .replay = options.replay,
            .last = options.last,
            .fast = options.fast,
            .force = options.force,
            .width = options.size[0],
            .height = options.size[1],
        },
        status);
    if (result != STATUS_DONE && status)
        options_blame(&options, scenario, status);
    if (result == STATUS_DONE && *homework.file && access(homework.file, F_OK) == 0)
        printf("Hand in this file: %s\n", homework.file);
    return result;
}

static bool asks_for_help(int count, char **arguments)
{
    for (int i = 0; i < count && strcmp(arguments[i], "--") != 0; i++)
        if (options_asks_help(arguments[i]))
            return true;
    return false;
}

static int run(int count, char **arguments, Status *status)
{
    if (count > 0 && (strcmp(arguments[0], "--version") == 0 || strcmp(arguments[0], "-V") == 0)) {
        puts("matvib " PACKAGE_VERSION);
        return STATUS_DONE;
    }
    const CliCommand *command = count > 0 ? cli_find(arguments[0]) : NULL;
    if (!command)
        return open_laboratory(false, count, arguments, status);
    if (asks_for_help(count - 1, arguments + 1)) {
        cli_print_help(command);
        return STATUS_DONE;
    }
    if (!command->run)
        return open_laboratory(true, count - 1, arguments + 1, status);
    return command->run(count - 1, arguments + 1, status);
}

/* Of a write that failed a while ago stdio knows that it failed but no longer why; who tries once more is
 * told. What stands there is broken already. */
static const char *why_not_written(void)
{
    return write(STDOUT_FILENO, "\n", 1) < 0 ? strerror(errno) : "not all of it was written";
}

/* Whether all of standard output has arrived; if not, the status says why. */
static bool close_output(Status *status)
{
    const bool lost = ferror(stdout) != 0;
    const char *why = fflush(stdout) != 0 ? strerror(errno) : lost ? why_not_written() : NULL;
    if (fclose(stdout) != 0 && !why)
        why = strerror(errno);
    return !why || status_fail(status, STATUS_FAILED, "standard output: %s", why);
}

int main(int count, char **arguments)
{
    Status status = {0}, output = {0};
    signal(SIGPIPE, SIG_IGN); /* a closed pipe is a failed write, said in one line */
    signal(SIGXFSZ, SIG_IGN); /* so is a file that grows beyond ulimit -f */
    int result = run(count - 1, arguments + 1, &status);
    const bool complete = close_output(&output);
    if (!complete && result == STATUS_DONE) {
        status = output;
        result = STATUS_FAILED;
    }
    if (result != STATUS_DONE && *status.text)
        visible_print(stderr, "matvib: %s\n", status.text);
    return result;
}
