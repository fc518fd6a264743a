/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The run as files, asked for with x. The files are those of `matvib run`, by the same function. */
#include "lab/laboratory.h"
#include "scenario/concern_output.h"
#include "export/export.h"
#include "base/text.h"
#include "picture/paper/figure_file.h"
#include "views/view.h"
#include "scenario/concern_time.h"
#include "scenario/scenario.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { EXPORTS = 3, PATH_BYTES = NAME_MAX_BYTES + 32, SPREADSHEET_ROWS = 1048576 };

static const char *const suffixes[EXPORTS] = {"-series.csv", "-particles.csv", "-nodes.csv"};

/* The runs that are written: of a duel both. NULL: there are no more. */
static const Experiment *run_of(const Duel *duel, int run)
{
    return run == 0 ? duel->a : run == 1 ? duel->b : NULL;
}

/* The files of a run of an export; a table that its method has not is left empty. */
static void file_names(const Duel *duel, int run, const char *name, char paths[EXPORTS][PATH_BYTES])
{
    for (int i = 0; i < EXPORTS; i++)
        snprintf(paths[i], PATH_BYTES, "%.255s%s%s", name, run == 0 ? "" : "-b", suffixes[i]);
    if (!simulation_has(experiment_simulation(run_of(duel, run)), HAS_MESH))
        paths[2][0] = '\0';
}

/* The first of these files that exists; "" if none does. */
static void find_existing(const Duel *duel, const char *name, char found[PATH_BYTES + 4])
{
    char paths[EXPORTS][PATH_BYTES];
    for (int run = 0; run_of(duel, run); run++) {
        file_names(duel, run, name, paths);
        for (int i = 0; i < EXPORTS; i++)
            for (int beside = 0; beside < 2 && paths[i][0]; beside++) {
                snprintf(found, PATH_BYTES + 4, "%.*s%s", PATH_BYTES - 1, paths[i], beside ? ".ini" : "");
                if (access(found, F_OK) == 0)
                    return;
            }
    }
    found[0] = '\0';
}

static bool show_progress(double share, void *context)
{
    return laboratory_work(context, "exporting %d %%   ^C cancels", (int)(100 * share));
}

/* What is named, if who asks may write a file; if not, that is said. */
static void write_named(Laboratory *lab, bool force)
{
    Status status = {STATUS_DONE, ""};
    if (output_allowed(lab->asker, lab->exporting.name, &status))
        lab->exporting.write(lab, force);
    else
        laboratory_tell(lab, "%s", status.text);
}

static bool answer_replace(Laboratory *lab, const char *text, Status *status)
{
    (void)text;
    (void)status;
    write_named(lab, true);
    return true;
}

/* Writes what is named, or asks first where `existing` would be replaced; "": nothing would. */
static bool write_or_ask(Laboratory *lab, void (*write)(Laboratory *, bool force), const char *existing)
{
    lab->exporting.write = write;
    if (*existing)
        prompt_ask_replace(lab, answer_replace, existing);
    else
        write_named(lab, false);
    return true;
}

/* The stages of a step of a run that is looked into; 0: it stands between steps, or is written to its end. */
static int stages_of(const Laboratory *lab, int run)
{
    return lab->exporting.newest ? 0 : experiment_stage(run_of(&lab->player.duel, run));
}

/* One run. False: it could not be written, which has been said. */
static bool write_run(Laboratory *lab, int run, bool force, RunSummary *summary)
{
    char paths[EXPORTS][PATH_BYTES];
    Settings *settings = malloc(sizeof *settings);
    if (!settings) {
        laboratory_say(lab, MESSAGE_ERROR, "out of memory");
        return false;
    }
    file_names(&lab->player.duel, run, lab->exporting.name, paths);
    experiment_scenario(run_of(&lab->player.duel, run), lab->exporting.newest, settings);
    Outputs outputs = {.series = paths[0],
                       .particles = paths[1],
                       .nodes = paths[2][0] ? paths[2] : NULL,
                       .asker = lab->asker,
                       .force = force};
    Status status = {STATUS_DONE, ""};
    if (stages_of(lab, run) > 0) {
        const Experiment *experiment = run_of(&lab->player.duel, run);
        outputs.stages[0] = outputs.stages[1] = experiment_step(experiment) + 1;
        outputs.stage = stages_of(lab, run);
        problem_end_at(settings, experiment_simulation(experiment)->dt, outputs.stages[0]);
    }
    bool sound = export_run(settings, &outputs, lab->options.threads, show_progress, lab, summary, &status);
    free(settings);
    if (!sound && !summary->failed)
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
    return sound || summary->failed;
}

static void write_export(Laboratory *lab, bool force)
{
    char paths[EXPORTS][PATH_BYTES];
    RunSummary first, other = {0};
    const Experiment *second = lab->player.duel.b;
    const bool both =
        second && (lab->exporting.newest ? experiment_newest(second) > 0
                                         : experiment_step(second) > 0 || stages_of(lab, 1) > 0);
    if (!write_run(lab, 0, force, &first) || (both && !write_run(lab, 1, force, &other)))
        return;
    if (stages_of(lab, 0) == 0) /* else the run itself is not written */
        lab->editing.changed = false;
    file_names(&lab->player.duel, 0, lab->exporting.name, paths);
    char *whole = realpath(paths[0], NULL);
    char beside[PATH_BYTES + 64] = "";
    if (both) {
        char others[EXPORTS][PATH_BYTES];
        file_names(&lab->player.duel, 1, lab->exporting.name, others);
        const char *slash = strrchr(others[0], '/');
        snprintf(beside, sizeof beside, "; of B likewise %s (%ld rows)", slash ? slash + 1 : others[0],
                 other.rows);
    }
    laboratory_say(lab, first.failed || other.failed ? MESSAGE_WARNING : MESSAGE_INFO,
                   "wrote %s%s (%ld rows), particles%s%s, each with its .ini%s", both ? "A: " : "",
                   whole ? whole : paths[0], first.rows, paths[2][0] ? ", nodes" : "",
                   stages_of(lab, 0) > 0 ? " after this stage" : "", beside);
    free(whole);
}

static bool export_named(Laboratory *lab, const char *text, Status *status)
{
    char found[PATH_BYTES + 4], name[NAME_MAX_BYTES], paths[EXPORTS][PATH_BYTES];
    size_t length = strlen(text);
    if (figure_is_name(text))
        return exporting_figure(lab, text, status);
    if (length > 4 && strcmp(text + length - 4, ".csv") == 0)
        length -= 4;
    if (length == 0)
        return status_refuse(status, "a name is expected");
    snprintf(name, sizeof name, "%.*s", (int)length, text); /* the text may be the name already */
    memcpy(lab->exporting.name, name, sizeof name);
    file_names(&lab->player.duel, 0, name, paths);
    if (!output_may_begin(paths[0], lab->asker, true, status))
        return false;
    find_existing(&lab->player.duel, lab->exporting.name, found);
    return write_or_ask(lab, write_export, found);
}

/* Proposes the scenario's name without folder and ending, and a number if files of that name are there
 * already; says how much it will be. */
static void ask_name(Laboratory *lab)
{
    enum { SAMPLES = 200 };
    char name[NAME_MAX_BYTES], base[NAME_MAX_BYTES], found[PATH_BYTES + 4];
    const Experiment *experiment = laboratory_run(lab);
    const Record *record = experiment_record(experiment);
    /* one row every so many steps, the first and the last always */
    const long every = settings_output(experiment_settings(experiment))->every;
    const long last = lab->exporting.newest ? experiment_newest(experiment) : experiment_step(experiment);
    const long rows = last / every + 1 + (last % every != 0);
    int count;
    const Column *columns = experiment_columns(experiment, &count);
    size_t sampled = 0;
    double bytes = 0;
    for (size_t i = 0; i < record->count; i += 1 + record->count / SAMPLES, sampled++)
        for (int k = 0; k < record->n_columns; k++) {
            char number[NUMBER_TEXT_MAX];
            if (export_writes(experiment_settings(experiment), experiment_simulation(experiment), k,
                              columns[k].quantity.name))
                bytes += (double)text_shortest(number, record_row(record, i)[k]) + 1;
        }
    const double megabytes = sampled ? bytes / (double)sampled * (double)rows / 1e6 : 0;
    const char *slash = strrchr(lab->scenario, '/');
    snprintf(base, sizeof base, "%.200s", slash ? slash + 1 : lab->scenario);
    char *dot = strrchr(base, '.');
    if (dot && dot > base)
        *dot = '\0';
    if (!base[0])
        strcpy(base, "run");
    snprintf(name, sizeof name, "%s", base);
    find_existing(&lab->player.duel, name, found);
    for (int i = 2; found[0] && i < 1000; i++) {
        snprintf(name, sizeof name, "%.200s-%d", base, i);
        find_existing(&lab->player.duel, name, found);
    }
    prompt_ask(lab, export_named, &prompt_retyped, name, "export %ld row%s, %.*f MB, as", rows,
               rows == 1 ? "" : "s",
               megabytes < 0.1  ? 3
               : megabytes < 10 ? 1
                                : 0,
               megabytes);
    Prompt *prompt = &lab->prompting.shown;
    snprintf(
        prompt->hint, sizeof prompt->hint,
        "writes NAME-series.csv and its tables%s; NAME.svg, .pdf, .png, .tex or .gp: a figure of the view",
        lab->player.duel.b ? ", those of B as NAME-b-series.csv" : "");
    const long thinner = 1 + (rows - 1) / (SPREADSHEET_ROWS - 1); /* one row is the heading */
    if (thinner > 1)
        snprintf(prompt->hint, sizeof prompt->hint,
                 "more rows than a spreadsheet takes (%d with the heading): output.every=%ld would fit",
                 SPREADSHEET_ROWS, thinner * every);
}

static bool answer_which(Laboratory *lab, const char *text, Status *status)
{
    lab->exporting.newest = strcmp(text, "newest") == 0;
    if (!lab->exporting.newest && strcmp(text, "here") != 0)
        return status_refuse(status, "here or newest");
    if (lab->exporting.name[0])
        return export_named(lab, lab->exporting.name, status);
    ask_name(lab);
    return true;
}

static const char nothing_computed[] = "nothing has been computed yet: Esc, then Space runs";
static const char computing[] = "wait until the run has come to its time, or cancel with Esc";

/* Who types a name without looking up types it into a question, where it does nothing. */
static bool answer_in_vain(Laboratory *lab, const char *text, Status *status)
{
    (void)text;
    return status_refuse(status, "%s",
                         lab->player.playback.state == STATE_COMPUTING ? computing : nothing_computed);
}

static void refuse(Laboratory *lab, const char *why)
{
    Prompt *prompt = &lab->prompting.shown;
    prompt_ask(lab, answer_in_vain, NULL, "", "export as");
    snprintf(prompt->hint, sizeof prompt->hint, "%s", why);
}

bool exporting_ask(Laboratory *lab, const char *name, Status *status)
{
    Experiment *experiment = laboratory_run(lab);
    player_pause(lab);
    if (lab->player.playback.state == STATE_COMPUTING) {
        refuse(lab, computing);
        return true;
    }
    const bool inside = experiment_stage(experiment) > 0; /* then this stage is exported */
    lab->exporting.newest = !inside;
    snprintf(lab->exporting.name, sizeof lab->exporting.name, "%s", name);
    if (!inside && experiment_newest(experiment) == 0)
        refuse(lab, nothing_computed);
    else if (!inside && experiment_step(experiment) < experiment_newest(experiment))
        prompt_ask(lab, answer_which, NULL, "newest", "export to here or to the newest time?");
    else if (name[0])
        return export_named(lab, name, status);
    else
        ask_name(lab);
    return true;
}

/* A view as a figure for paper: `:figure [VIEW] FILE`, or x and a name that ends in .svg, .pdf, .png, .tex or
 * .gp; without its word the focused one. */

static void write_figure(Laboratory *lab, bool force)
{
    const Screen *screen = &lab->screen;
    const View *view = lab->exporting.view;
    Status status = {STATUS_DONE, ""};
    Figure figure;
    if (!laboratory_work(lab, "drawing %s", lab->exporting.name)) { /* a large map takes a moment */
        laboratory_tell(lab, "cancelled");
        return;
    }
    figure_open(&figure, 0, 0);
    const bool sound = figure_add(&figure, screen, view, 1, &status) &&
                       figure_write(&figure, lab->asker, lab->exporting.name, force, &status);
    figure_close(&figure);
    if (!sound) {
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
        return;
    }
    char *whole = realpath(lab->exporting.name, NULL);
    laboratory_tell(lab, "wrote %s: the view %s", whole ? whole : lab->exporting.name, view->word);
    free(whole);
}

bool exporting_figure(Laboratory *lab, const char *words, Status *status)
{
    const Screen *screen = &lab->screen;
    /* the view that the first word names, where a file stands behind it */
    const size_t length = strcspn(words, " ");
    char word[32] = "";
    if (length < sizeof word)
        snprintf(word, sizeof word, "%.*s", (int)length, words);
    const View *view = words[length] ? view_named(word) : NULL;
    const char *file = view ? words + length + strspn(words + length, " ") : words;
    if (!view && screen->panes.inspecting && screen->panes.focus == PANE_INSPECTOR)
        view = &view_inspector;
    else if (!view) /* where no plot has the focus it is the lower one, as for the cursor */
        view = screen->panes.focus == PANE_UPPER ? screen->views.upper : screen->views.lower;
    if (!*file)
        return status_refuse(status, "a file is expected: FILE.svg, .pdf, .png, .tex or .gp");
    if (!figure_allowed(file, status) || !output_may_begin(file, lab->asker, true, status))
        return false;
    if (view_missing(view, screen))
        return status_refuse(status, "%s", view_missing(view, screen));
    player_pause(lab);
    if (lab->player.playback.state == STATE_COMPUTING)
        return status_refuse(status, "wait until the run has come to its time, or cancel with Esc");
    if (!view_is_on_paper(view, screen) ||
        (view->variant_word && !view->variant_word(screen, view_variant(view, screen))))
        return status_refuse(status, "this view makes no figure: name another, as in figure probe probe.svg");
    char name[NAME_MAX_BYTES];
    snprintf(name, sizeof name, "%s", file); /* the text may be the name already */
    snprintf(lab->exporting.name, sizeof lab->exporting.name, "%s", name);
    lab->exporting.view = view;
    return write_or_ask(lab, write_figure, access(name, F_OK) == 0 ? name : "");
}

/* The scenario as it was opened and edited, to its own end; not only what has been computed of it. */
static void write_scenario(Laboratory *lab, bool force)
{
    const char *name = lab->exporting.name;
    const Experiment *experiment = laboratory_run(lab);
    Status status = {STATUS_DONE, ""};
    Settings settings;
    experiment_scenario(experiment, true, &settings);
    settings_edit_time(&settings)->end = settings_time(experiment_settings(experiment))->end;
    settings_edit_time(&settings)->step = settings_time(experiment_settings(experiment))->step;
    if (lab->player.duel.b) { /* opens as what is on screen */
        memcpy(settings.duel, lab->player.duel.keys, sizeof settings.duel);
        settings.n_duel = lab->player.duel.n_keys;
    }
    OutputFile file = {0};
    (void)force; /* what is a device is there always */
    const bool sound = output_open(&file, lab->asker, name, true, &status) &&
                       scenario_write(file.stream, &settings, NULL, &status);
    if (!output_end(&file, sound, &status))
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
    else {
        char word[sizeof lab->message.text] = "";
        text_append_shell(word, sizeof word, name);
        laboratory_tell(lab, "wrote %s; open it with: matvib %s", name, word);
    }
}

bool exporting_scenario(Laboratory *lab, const char *text, Status *status)
{
    if (!text[0] || output_is_standard(text))
        return status_refuse(status, "a file name is expected");
    if (!output_may_begin(text, lab->asker, true, status))
        return false;
    snprintf(lab->exporting.name, sizeof lab->exporting.name, "%s", text);
    return write_or_ask(lab, write_scenario, access(text, F_OK) == 0 && !output_is_direct(text) ? text : "");
}

static const Typing file_typing = {.offer = complete_files, .retyped = true};

void exporting_scenario_ask(Laboratory *lab)
{
    char name[NAME_MAX_BYTES];
    snprintf(name, sizeof name, "%.200s%s", lab->scenario, strchr(lab->scenario, '.') ? "" : ".ini");
    prompt_ask(lab, exporting_scenario, &file_typing, name, "write scenario to");
}
