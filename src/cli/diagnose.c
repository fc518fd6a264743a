/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib diagnose SCENARIO FILE...`: which mistake, scheme or value made the numbers of somebody's own code.
 * One file is reported at length, many by a line each; the threads of a pool take one file after the other.
 */
#include "answers/diagnose/diagnose.h"
#include "base/output.h"
#include "base/text.h"
#include "base/visible.h"
#include "cli/cli.h"
#include "cli/options.h"
#include "export/export.h"
#include "scenario/settings.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct File {
    const char *path;
    DiagnoseTable table;
    Diagnosis found;
    Status failure; /* why it cannot be judged */
} File;

typedef struct Files {
    const Options *options;
    const Settings *settings;
    File *files;
    int count;
    double seconds; /* of each; 0: no bound */
} Files;

/* On any thread. */
static void judge(void *owner, int index, int threads, Cancel cancel)
{
    const Files *all = owner;
    const DiagnoseTask task = {.settings = all->settings,
                               .threads = threads,
                               .pairs = all->options->pairs,
                               .seconds = all->seconds,
                               .cancel = cancel};
    File *file = &all->files[index];
    if (diagnose_read(&file->table, file->path, all->settings, all->options->map, &file->failure))
        diagnose(&task, &file->table, &file->found, &file->failure);
}

/* --- what is said ----------------------------------------------------------------------------------- */

enum { CELL_MAX = 400 };

/* What is reported of a file, and whether it is a number (or true, false); the first are the table's columns.
 */
#define CELLS_OF(CELL)                                                                                       \
    CELL(NAME, "name", false)                                                                                \
    CELL(VERDICT, "verdict", false)                                                                          \
    CELL(SCHEME, "scheme", false)                                                                            \
    CELL(DIGITS, "digits", true)                                                                             \
    CELL(MISTAKE, "mistake", false)                                                                          \
    CELL(STAGE, "stage", false)                                                                              \
    CELL(READ_AS, "read_as", false)                                                                          \
    CELL(ROWS, "rows", true)                                                                                 \
    CELL(AGREED, "rows_agreed", true)                                                                        \
    CELL(STEP, "step", true)                                                                                 \
    CELL(AFTER, "after_stage", false)                                                                        \
    CELL(THING, "thing", false)                                                                              \
    CELL(COLUMN, "column", false)                                                                            \
    CELL(YOURS, "yours", true)                                                                               \
    CELL(RIGHT, "right", true)                                                                               \
    CELL(RATIO, "ratio", true)                                                                               \
    CELL(RATIO_IS, "ratio_is", false)                                                                        \
    CELL(TIME_UP, "time_up", true)                                                                           \
    CELL(ERROR, "error", false)
#define ID(id, name, is_number)  CELL_##id,
#define ROW(id, name, is_number) {name, is_number},

enum { CELLS_OF(ID) CELLS, TABLE_CELLS = CELL_READ_AS };

static const struct {
    const char *name;
    bool is_number;
} columns[CELLS] = {CELLS_OF(ROW)};

static void put_number(char cell[CELL_MAX], double value)
{
    if (isfinite(value))
        text_shortest(cell, value);
}

/* The verdict, which codes explain the file, and where it departs first, as cells. */
static void fill(const File *file, char cells[CELLS][CELL_MAX])
{
    const Diagnosis *found = &file->found;
    const Departure *departure = &found->departure;
    const Explanation *first = &found->explanations[0];
    const bool named = found->verdict == DIAGNOSE_EXPLAINED;
    memset(cells, 0, (size_t)CELLS * CELL_MAX);
    visible_text(cells[CELL_NAME], CELL_MAX, file->path);
    text_append(cells[CELL_ERROR], CELL_MAX, "%s", file->failure.text);
    if (file->failure.code != STATUS_DONE) {
        text_append(cells[CELL_VERDICT], CELL_MAX, "unread");
        return;
    }
    text_append(cells[CELL_VERDICT], CELL_MAX, "%s", diagnose_words[found->word]);
    diagnosis_read_as(&file->table, cells[CELL_READ_AS], CELL_MAX);
    text_append(cells[CELL_TIME_UP], CELL_MAX, "%s", found->time_up ? "true" : "false");
    text_append(cells[CELL_ROWS], CELL_MAX, "%zu", found->rows);
    if (found->verdict == DIAGNOSE_COPIED || found->verdict == DIAGNOSE_MUTE)
        return;
    text_append(cells[CELL_SCHEME], CELL_MAX, "%s", found->scheme);
    text_append(cells[CELL_DIGITS], CELL_MAX, "%d", named ? first->digits : found->digits);
    text_append(cells[CELL_AGREED], CELL_MAX, "%zu", found->agreed);
    for (int i = 0; i < found->n_explanations && i < DIAGNOSE_NAMED_MAX && named; i++)
        text_append(cells[CELL_MISTAKE], CELL_MAX, "%s%s", i > 0 ? " " : "", found->explanations[i].id);
    if (found->verdict == DIAGNOSE_RIGHT || !departure->is)
        return;
    text_append(cells[CELL_STAGE], CELL_MAX, "%s",
                named && *first->stage ? first->stage
                : departure->stage > 0 ? departure->stage_id
                                       : "");
    put_number(cells[CELL_STEP], (double)departure->step);
    text_append(cells[CELL_AFTER], CELL_MAX, "%s", departure->stage > 0 ? departure->stage_id : "");
    if (file->table.set >= 0)
        text_append(cells[CELL_THING], CELL_MAX, "%s %zu", file->table.thing, departure->thing);
    text_append(cells[CELL_COLUMN], CELL_MAX, "%s", file->table.as.columns[departure->column].name);
    put_number(cells[CELL_YOURS], departure->theirs);
    put_number(cells[CELL_RIGHT], departure->ours);
    put_number(cells[CELL_RATIO], departure->theirs / departure->ours);
    text_append(cells[CELL_RATIO_IS], CELL_MAX, "%s", departure->factors);
}

static void tell_json(const Files *all)
{
    char cells[CELLS][CELL_MAX];
    puts("[");
    for (int i = 0; i < all->count; i++) {
        fill(&all->files[i], cells);
        fputs("  {\"name\": ", stdout);
        text_put_json(stdout, cells[CELL_NAME], strlen(cells[CELL_NAME]));
        for (int c = 1; c < CELLS; c++)
            if (c == CELL_MISTAKE) {
                /* Words as a list. */
                const char *words = cells[c];
                char word[CELL_MAX];
                fprintf(stdout, ", \"%s\": [", columns[c].name);
                for (bool first = true; text_next_word(&words, word, sizeof word); first = false) {
                    fputs(first ? "" : ", ", stdout);
                    text_put_json(stdout, word, strlen(word));
                }
                fputs("]", stdout);
            } else {
                const char *cell = cells[c];
                fprintf(stdout, ", \"%s\": ", columns[c].name);
                if (!*cell)
                    fputs("null", stdout);
                else if (columns[c].is_number)
                    fputs(cell, stdout);
                else
                    text_put_json(stdout, cell, strlen(cell));
            }
        puts(i + 1 < all->count ? "}," : "}");
    }
    puts("]");
}

static bool write_table(const Files *all, Status *status)
{
    const Options *options = all->options;
    OutputFile file;
    char cells[CELLS][CELL_MAX];
    if (!output_open(&file, ASKER_COMMAND_LINE, options->output, options->force, status))
        return false;
    const char *row[TABLE_CELLS];
    for (int c = 0; c < TABLE_CELLS; c++)
        row[c] = columns[c].name;
    csv_words(file.stream, options->outputs.dialect, row, TABLE_CELLS);
    for (int i = 0; i < all->count; i++) {
        fill(&all->files[i], cells);
        for (int c = 0; c < TABLE_CELLS; c++)
            row[c] = cells[c];
        csv_words(file.stream, options->outputs.dialect, row, TABLE_CELLS);
    }
    return output_end(&file, true, status);
}

/* One that cannot be read is an error; of many it is one at the end. */
static bool tell(const Files *all, Status *status)
{
    char scenario[1000] = "", file[1000] = ""; /* as a shell reads them */
    const Options *options = all->options;
    int unread = 0;
    text_append_shell(scenario, sizeof scenario, options->words[0]);
    for (int i = 0; i < options->n_overrides; i++) {
        char word[VALUE_MAX + KEY_MAX] = "";
        text_append(word, sizeof word, "%s=%s", options->overrides[i].key, options->overrides[i].value);
        text_append(scenario, sizeof scenario, " --set ");
        text_append_shell(scenario, sizeof scenario, word);
    }
    text_append_shell(file, sizeof file, all->files[0].path);
    text_append(file, sizeof file, options->map ? " --map " : "");
    if (options->map)
        text_append_shell(file, sizeof file, options->map);
    for (int i = 0; i < all->count; i++)
        unread += all->files[i].failure.code != STATUS_DONE;
    if (all->count == 1 && unread > 0) {
        *status = all->files[0].failure;
        return false;
    }
    if (options->json)
        tell_json(all);
    else if (all->count == 1)
        diagnosis_tell(&all->files[0].found, &all->files[0].table, scenario, file, stdout);
    else {
        char cells[CELLS][CELL_MAX];
        int wide = 4;
        for (int i = 0; i < all->count; i++)
            wide = (int)fmax(wide, fmin(48, (double)strlen(all->files[i].path)));
        visible_print(stdout, "%-*s %-9s %6s  %-10s %s\n", wide, "name", "verdict", "digits", "scheme",
                      "mistake, stage");
        for (int i = 0; i < all->count; i++) {
            fill(&all->files[i], cells);
            visible_print(stdout, "%-*s %-9s %6s  %-10s %s%s%s\n", wide, cells[CELL_NAME],
                          cells[CELL_VERDICT], cells[CELL_DIGITS], cells[CELL_SCHEME],
                          *cells[CELL_ERROR] ? cells[CELL_ERROR] : cells[CELL_MISTAKE],
                          *cells[CELL_STAGE] && *cells[CELL_MISTAKE] ? ", " : "", cells[CELL_STAGE]);
        }
    }
    if (options->output && !write_table(all, status))
        return false;
    if (options->output && !options->json)
        visible_print(stdout, "wrote %s\n", options->output);
    return unread == 0 || status_refuse(status, "%d of %d files cannot be judged", unread, all->count);
}

/* --- the lines that write a file --------------------------------------------------------------------- */

static const char python[] =
    "# a row for t = 0 and one after each step, with all digits; arrays over particles\n"
    "out = open('own.csv', 'w')\n"
    "out.write('step,time,v_cm,kinetic,strain\\n')\n"
    "def record(step):\n"
    "    v_cm = sum(m * v) / sum(m)\n"
    "    kinetic = sum(0.5 * m * v**2)\n"
    "    strain = sum(0.5 * s**2 / E * m / rho)\n"
    "    out.write('%d,%.17g,%.17g,%.17g,%.17g\\n' % (step, step * dt, v_cm, kinetic, strain))\n"
    "record(0)     # before the loop\n"
    "record(step)  # at the end of step 1, 2, ...\n";

static const char matlab[] =
    "% a row for t = 0 and one after each step, with all digits; vectors over particles\n"
    "out = fopen('own.csv', 'w');\n"
    "fprintf(out, 'step,time,v_cm,kinetic,strain\\n');\n"
    "record = @(step, m, v, s, rho) fprintf(out, '%d,%.17g,%.17g,%.17g,%.17g\\n', ...\n"
    "    step, step * dt, sum(m .* v) / sum(m), sum(0.5 * m .* v.^2), ...\n"
    "    sum(0.5 * s.^2 / E .* m ./ rho));\n"
    "record(0, m, v, s, rho);     % before the loop\n"
    "record(step, m, v, s, rho);  % at the end of step 1, 2, ...\n"
    "fclose(out);\n";

static const char fortran[] =
    "! a row for t = 0 and one after each step, with all digits; arrays over particles\n"
    "open(10, file='own.csv')\n"
    "write(10, '(a)') 'step,time,v_cm,kinetic,strain'\n"
    "call record(0)     ! before the loop\n"
    "call record(step)  ! at the end of step 1, 2, ...\n"
    "contains\n"
    "subroutine record(n)\n"
    "  integer, intent(in) :: n\n"
    "  write(10, '(i0,4(\",\",es24.16e3))') n, n*dt, sum(m*v)/sum(m), &\n"
    "    sum(0.5d0*m*v**2), sum(0.5d0*s**2/E*m/rho)\n"
    "end subroutine\n";

static const char julia[] =
    "# a row for t = 0 and one after each step, with all digits; vectors over particles\n"
    "out = open(\"own.csv\", \"w\")\n"
    "println(out, \"step,time,v_cm,kinetic,strain\")\n"
    "function record(step)\n"
    "    v_cm = sum(m .* v) / sum(m)\n"
    "    kinetic = sum(0.5 .* m .* v.^2)\n"
    "    strain = sum(0.5 .* s.^2 ./ E .* m ./ rho)\n"
    "    println(out, join((step, step * dt, v_cm, kinetic, strain), \",\"))\n"
    "end\n"
    "record(0)     # before the loop\n"
    "record(step)  # at the end of step 1, 2, ...; close(out) after the last\n";

#define TEMPLATE(language) {#language, language},
static const struct {
    const char *language, *lines;
} templates[] = {TEMPLATE_LANGUAGES(TEMPLATE)};

/* --- the command ------------------------------------------------------------------------------------ */

int cli_diagnose(Options *options, Status *status)
{
    Settings settings;
    double seconds = 0;
    if (options->template) {
        for (size_t i = 0; i < sizeof templates / sizeof *templates; i++)
            if (strcmp(templates[i].language, options->template) == 0)
                fputs(templates[i].lines, stdout);
        return STATUS_DONE;
    }
    if (options->time_bound && !(text_to_double(options->time_bound, &seconds) && seconds > 0))
        status_refuse(status, "--time: not a number of seconds above 0: %.60s", options->time_bound);
    if (status->code != STATUS_DONE || !options_words(options, 2, WORDS_MAX, "SCENARIO FILE", status) ||
        !options_load(options, options->words[0], &settings, status) ||
        !(!options->output || output_may_begin(options->output, ASKER_COMMAND_LINE, options->force, status)))
        return (int)status->code;
    const int files = options->n_words - 1;
    Files all = {.options = options,
                 .settings = &settings,
                 .files = calloc((size_t)files, sizeof *all.files),
                 .count = files,
                 .seconds = seconds};
    for (int i = 0; i < files && all.files; i++)
        all.files[i].path = options->words[i + 1];
    const bool sound = (all.files || status_fail(status, "out of memory")) &&
                       cli_each(files, options->threads, options->quiet, judge, &all, status) &&
                       tell(&all, status);
    int judged = STATUS_DONE; /* the worst: a file that is not right is a check that failed */
    for (int i = 0; i < files && sound; i++)
        if (all.files[i].found.word > WORD_RIGHT_BUT)
            judged = STATUS_FAILED;
    for (int i = 0; i < files && all.files; i++)
        diagnose_close(&all.files[i].table);
    free(all.files);
    return sound && judged != 0 ? judged : progress_result(sound, status);
}
