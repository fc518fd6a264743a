/* The run as files, asked for with x. The files are those of `matvib run`, by the same function. */
#include "tui/control.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { EXPORTS = 3, PATH_BYTES = NAME_MAX_BYTES + 32 };

static const char *const suffixes[EXPORTS] = {"-series.csv", "-particles.csv", "-nodes.csv"};

static bool has_set(const Laboratory *lab, const char *name)
{
    const Simulation *simulation = experiment_simulation(lab->screen.experiment);
    for (int i = 0; i < simulation->n_sets; i++)
        if (strcmp(simulation->sets[i].name, name) == 0)
            return true;
    return false;
}

/* The files of an export; a table that this method has not is left empty. */
static void file_names(const Laboratory *lab, const char *name, char paths[EXPORTS][PATH_BYTES])
{
    for (int i = 0; i < EXPORTS; i++)
        snprintf(paths[i], PATH_BYTES, "%.255s%s", name, suffixes[i]);
    if (!has_set(lab, "node"))
        paths[2][0] = '\0';
}

/* The first of these files that exists; "" if none does. */
static void find_existing(const Laboratory *lab, const char *name, char found[PATH_BYTES + 4])
{
    char paths[EXPORTS][PATH_BYTES];
    file_names(lab, name, paths);
    for (int i = 0; i < EXPORTS; i++)
        for (int beside = 0; beside < 2 && paths[i][0]; beside++) {
            snprintf(found, PATH_BYTES + 4, "%.*s%s", PATH_BYTES - 1, paths[i], beside ? ".ini" : "");
            if (access(found, F_OK) == 0)
                return;
        }
    found[0] = '\0';
}

/* The scenario's name without folder and ending, and a number if files of that name are there already. */
static void default_name(const Laboratory *lab, char name[NAME_MAX_BYTES])
{
    char base[NAME_MAX_BYTES], found[PATH_BYTES + 4];
    const char *slash = strrchr(lab->scenario, '/');
    snprintf(base, sizeof base, "%.200s", slash ? slash + 1 : lab->scenario);
    char *dot = strrchr(base, '.');
    if (dot && dot > base)
        *dot = '\0';
    if (!base[0])
        strcpy(base, "run");
    snprintf(name, NAME_MAX_BYTES, "%s", base);
    for (int i = 2; i < 1000; i++) {
        find_existing(lab, name, found);
        if (!found[0])
            return;
        snprintf(name, NAME_MAX_BYTES, "%.200s-%d", base, i);
    }
}

static bool show_progress(double share, void *context)
{
    Laboratory *lab = context;
    say(lab, MESSAGE_INFO, "exporting %d %%   ^C cancels", (int)(100 * share));
    return lab->host.go_on(lab->host.context);
}

static void write_export(Laboratory *lab, bool force)
{
    char paths[EXPORTS][PATH_BYTES];
    Settings *settings = malloc(sizeof *settings);
    if (!settings) {
        say(lab, MESSAGE_ERROR, "out of memory");
        return;
    }
    file_names(lab, lab->export_name, paths);
    experiment_scenario(lab->screen.experiment, lab->export_newest, settings);
    Outputs outputs = {
        .series = paths[0], .particles = paths[1], .nodes = paths[2][0] ? paths[2] : NULL, .force = force};
    RunSummary summary;
    Status status = {STATUS_DONE, ""};
    bool sound = export_run(settings, &outputs, lab->options.threads > 0 ? lab->options.threads : 1,
                            show_progress, lab, &summary, &status);
    free(settings);
    if (!sound && !summary.failed) {
        say(lab, MESSAGE_ERROR, "%s", status.text);
        return;
    }
    lab->changed = false;
    say(lab, sound ? MESSAGE_INFO : MESSAGE_WARNING, "wrote %s (%ld rows), particles%s, each with its .ini",
        paths[0], summary.rows, outputs.nodes ? ", nodes" : "");
}

static bool answer_replace(Laboratory *lab, const char *text)
{
    (void)text;
    write_export(lab, true);
    return true;
}

static bool answer_export(Laboratory *lab, const char *text)
{
    char found[PATH_BYTES + 4];
    size_t length = strlen(text);
    if (length > 4 && strcmp(text + length - 4, ".csv") == 0)
        length -= 4;
    if (length == 0) {
        snprintf(lab->screen.prompt.problem, sizeof lab->screen.prompt.problem, "a name is wanted");
        return false;
    }
    snprintf(lab->export_name, sizeof lab->export_name, "%.*s", (int)length, text);
    find_existing(lab, lab->export_name, found);
    if (found[0])
        ask(lab, answer_replace, true, "", "%.60s exists: replace?", found);
    else
        write_export(lab, false);
    return true;
}

static void ask_name(Laboratory *lab)
{
    char name[NAME_MAX_BYTES];
    default_name(lab, name);
    ask(lab, answer_export, false, name, "export as (NAME-series.csv, ...)");
}

static bool answer_which(Laboratory *lab, const char *text)
{
    lab->export_newest = strcmp(text, "newest") == 0;
    if (!lab->export_newest && strcmp(text, "here") != 0) {
        snprintf(lab->screen.prompt.problem, sizeof lab->screen.prompt.problem, "here or newest");
        return false;
    }
    ask_name(lab);
    return true;
}

void ask_export(Laboratory *lab)
{
    Experiment *experiment = lab->screen.experiment;
    pause_run(lab);
    if (lab->screen.state == STATE_COMPUTING) {
        say(lab, MESSAGE_INFO, "wait until the run has come to its time, or cancel with Esc");
        return;
    }
    lab->export_newest = true;
    if (experiment_newest(experiment) == 0)
        say(lab, MESSAGE_INFO, "nothing has been computed yet: Space runs");
    else if (experiment_step(experiment) < experiment_newest(experiment))
        ask(lab, answer_which, false, "newest", "export to here or to the newest time?");
    else
        ask_name(lab);
}
