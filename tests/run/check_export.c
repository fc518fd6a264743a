/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs as files: what they hold, that they repeat, that they are written whole or not at all. */
#include "answers/summary.h"
#include "scenario/concern_body.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_output.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "export/export.h"
#include "run/lab_case.h"
#include "scenario/scenario.h"
#include "suite.h"

#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[64];

static void make_folder(void)
{
    strcpy(folder, "/tmp/check_export.XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(folder));
}

static int count_files(void)
{
    int count = 0;
    DIR *opened = opendir(folder);
    for (struct dirent *entry; (entry = readdir(opened));)
        count += entry->d_name[0] != '.';
    closedir(opened);
    return count;
}

static void remove_folder(void)
{
    DIR *opened = opendir(folder);
    for (struct dirent *entry; (entry = readdir(opened));)
        if (entry->d_name[0] != '.') {
            char name[512];
            snprintf(name, sizeof name, "%s/%s", folder, entry->d_name);
            unlink(name);
        }
    closedir(opened);
    rmdir(folder);
}

static const char *in_folder(const char *name)
{
    static char names[8][128];
    static int next;
    char *out = names[next++ % 8];
    snprintf(out, sizeof names[0], "%s/%s", folder, name);
    return out;
}

/* A whole file; free() it. */
static char *contents(const char *name)
{
    char *text = NULL;
    size_t size = 0;
    FILE *file = fopen(name, "r");
    ck_assert_msg(file != NULL, "no file %s", name);
    ck_assert_int_ge(getdelim(&text, &size, '\0', file), 0);
    fclose(file);
    return text;
}

static void expect_same_files(const char *a, const char *b)
{
    char *one = contents(a), *other = contents(b);
    ck_assert_msg(strcmp(one, other) == 0, "%s and %s differ", a, b);
    free(one);
    free(other);
}

static void expect_header(const char *name, const char *header)
{
    char *text = contents(name);
    text[strcspn(text, "\n")] = '\0';
    ck_assert_str_eq(text, header);
    free(text);
}

static long count_lines(const char *name)
{
    char *text = contents(name);
    long lines = 0;
    for (const char *c = text; *c; c++)
        lines += *c == '\n';
    free(text);
    return lines;
}

/* Every cell of every line is a number. */
static void expect_numbers(const char *name, char separator)
{
    char *text = contents(name), *line = strchr(text, '\n') + 1;
    long columns = 1, bad = 0;
    for (const char *c = text; *c != '\n'; c++)
        columns += *c == separator;
    while (*line) {
        for (long i = 0; i < columns; i++) {
            char *end;
            strtod(line, &end);
            if (separator == ';' && *end == ',')
                strtod(end + 1, &end);
            bad += end == line || *end != (i + 1 < columns ? separator : '\n');
            line = end + 1;
        }
    }
    ck_assert_int_eq(bad, 0);
    free(text);
}

static void run(const Settings *settings, const Outputs *outputs, RunSummary *summary)
{
    Status status = {0};
    ck_assert_msg(export_run(settings, outputs, 1, NULL, NULL, summary, &status), "%s", status.text);
}

static Settings read_back(const char *name)
{
    Settings settings;
    Status status = {0};
    FILE *stream = fopen(name, "r"); /* not noted as an input, which no output may overwrite */
    ck_assert_ptr_nonnull(stream);
    ck_assert_msg(scenario_read(stream, name, &settings, &status), "%s", status.text);
    fclose(stream);
    return settings;
}

START_TEST(columns_are_those_of_the_contract)
{
    RunSummary summary;
    Settings settings = bar_settings(1, 1);
    Outputs outputs = {.asker = ASKER_COMMAND_LINE,
                       .series = in_folder("s.csv"),
                       .particles = in_folder("p.csv"),
                       .nodes = in_folder("n.csv")};
    run(&settings, &outputs, &summary);
    expect_header(outputs.series, "step,time,v_cm,v_cm_exact,v_cm_predicted,x_cm,kinetic,strain,work,total");
    expect_header(outputs.particles, "step,time,particle,x0,x,u,v,stress,strain,density,mass");
    expect_header(outputs.nodes, "step,time,node,x,mass,momentum,velocity,f_int,f_ext,f");
    ck_assert_int_eq(count_lines(outputs.series), 102);
    ck_assert_int_eq(count_lines(outputs.particles), 51);
    ck_assert_int_eq(count_lines(outputs.nodes), 31);
    expect_numbers(outputs.series, ',');
    expect_numbers(outputs.nodes, ',');
    ck_assert_int_eq(summary.steps, 100);
    ck_assert_int_eq(summary.rows, 101);

    outputs.force = true;
    set(&settings, "mpm.algorithm", "usl");
    run(&settings, &outputs, &summary);
    expect_header(outputs.series, "step,time,v_cm,v_cm_exact,x_cm,kinetic,strain,work,total");

    static const struct {
        const Problem *problem;
        const char *columns;
    } beams[] = {
        {&problem_supported_beam, "step,time,u_probe,v_probe,u_euler,v_euler,u_timoshenko,v_timoshenko,"
                                  "kinetic,strain,work,dissipated,total,broken_bonds"},
        {&problem_moving_cantilever, "step,time,u_probe,v_probe,length,u_modal,v_modal,v_filtered,"
                                     "kinetic,strain,work,dissipated,total,broken_bonds"},
        {&problem_notched_beam, "step,time,u_probe,v_probe,crack_x,crack_y,crack_length,crack_speed,"
                                "kinetic,strain,work,dissipated,total,broken_bonds"},
    };
    for (size_t i = 0; i < sizeof beams / sizeof *beams; i++) {
        settings = beam_settings(beams[i].problem, 2e-6);
        Outputs all = {.asker = ASKER_COMMAND_LINE,
                       .series = in_folder("s.csv"),
                       .particles = in_folder("p.csv"),
                       .bonds = in_folder("b.csv"),
                       .force = true};
        run(&settings, &all, NULL);
        expect_header(all.series, beams[i].columns);
        expect_header(all.particles,
                      "step,time,particle,x0,y0,ux,uy,vx,vy,damage,surface_factor,strain_energy");
        expect_header(all.bonds, "step,time,i,j,x_i,y_i,x_j,y_j,stretch,broken,broken_at");
        expect_numbers(all.series, ',');
        expect_numbers(all.bonds, ',');
    }
}
END_TEST

/* What no row has unless somebody asks. */
static bool costs(const char *column)
{
    static const char *const names[] = {"kinetic_grid", "kinetic_null", "x_cm_rate",  "momentum",  "reaction",
                                        "momentum_x",   "momentum_y",   "reaction_x", "reaction_y"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++)
        if (strcmp(column, names[k]) == 0)
            return true;
    return false;
}

/* The columns of a file that are asked for, at the bits that any other choice gives. */
START_TEST(columns_are_written_that_are_asked_for)
{
    static const struct {
        const char *asked, *header;
    } cases[] = {
        {"all", "step,time,v_cm,v_cm_exact,v_cm_predicted,x_cm,x_cm_rate,kinetic,kinetic_grid,kinetic_null,"
                "strain,work,total,momentum,reaction"},
        {"kinetic_null,v_cm", "step,time,v_cm,kinetic_null"},
        {"total, step", "step,time,total"},
    };
    Settings settings = bar_settings(5, 1);
    Outputs outputs = {.asker = ASKER_COMMAND_LINE, .series = in_folder("s.csv"), .force = true};
    Outputs again = {.asker = ASKER_COMMAND_LINE, .series = in_folder("t.csv"), .force = true};
    double last[3][16];
    for (int i = 0; i < 3; i++) {
        set(&settings, "output.columns", cases[i].asked);
        run(&settings, &outputs, NULL);
        expect_header(outputs.series, cases[i].header);
        expect_numbers(outputs.series, ',');
        char *text = contents(outputs.series);
        text[strlen(text) - 1] = '\0';
        char *at = strrchr(text, '\n') + 1;
        for (int k = 0; *at; k++, at += *at == ',')
            last[i][k] = strtod(at, &at);
        free(text);
        const Settings beside = read_back(in_folder("s.csv.ini"));
        ck_assert_str_eq(settings_output(&beside)->columns, cases[i].asked);
        run(&beside, &again, NULL);
        expect_same_files(outputs.series, again.series);
    }
    ck_assert_double_eq(last[1][2], last[0][2]);
    ck_assert_double_eq(last[1][3], last[0][9]);
    ck_assert_double_eq(last[2][2], last[0][12]);
    Status status = {0};
    set(&settings, "output.columns", "v_cm,u_probe");
    ck_assert(!export_run(&settings, &outputs, 1, NULL, NULL, NULL, &status));
    ck_assert_int_eq(status.code, STATUS_USAGE);
    ck_assert_ptr_nonnull(
        strstr(status.text, "output.columns: u_probe is not a column of the series (all, step, "));
}
END_TEST

START_TEST(rows_are_those_of_the_laboratory)
{
    static const Problem *const some[] = {&problem_bar, &problem_moving_cantilever, &problem_notched_beam};
    for (size_t p = 0; p < sizeof some / sizeof *some; p++) {
        Settings settings = some[p] == &problem_bar ? bar_settings(5, 3) : beam_settings(some[p], 3e-5);
        settings_edit_output(&settings)->every = 7;
        Outputs outputs = {.asker = ASKER_COMMAND_LINE, .series = in_folder("s.csv"), .force = true};
        run(&settings, &outputs, NULL);
        Experiment *experiment = open_experiment(&settings, 1 << 20);
        ck_assert(experiment_advance(experiment, 1000000, NULL));
        const Record *record = experiment_record(experiment);
        int n_columns;
        const Column *columns = experiment_columns(experiment, &n_columns);
        char *text = contents(outputs.series), *at = strchr(text, '\n') + 1;
        long differing = 0, rows = 0, last = experiment_last_step(experiment);
        while (*at) {
            long step = rows * 7 < last ? rows * 7 : last;
            const double *row = record_of_step(record, step);
            ck_assert_ptr_nonnull(row);
            for (int i = 0; i < record->n_columns; i++)
                if (!costs(columns[i].quantity.name)) {
                    differing += strtod(at, &at) != row[i];
                    at++;
                }
            rows++;
        }
        ck_assert_int_eq(differing, 0);
        ck_assert_int_eq(rows, (last + 6) / 7 + 1);
        free(text);
        experiment_destroy(experiment);
    }
}
END_TEST

/* What stands beside a run that failed says so in one line more than what stands beside its repetition, which
 * ends before. */
static void expect_same_scenarios(const char *a, const char *b, bool failed)
{
    char *one = contents(a), *other = contents(b);
    char *reason = strstr(one, "# the run stopped: ");
    ck_assert_msg((reason != NULL) == failed, "%s tells%s of a failure", a, reason ? "" : " nothing");
    ck_assert_ptr_null(strstr(other, "# the run stopped: "));
    if (reason) {
        char *next = strchr(reason, '\n') + 1;
        memmove(reason, next, strlen(next) + 1);
    }
    ck_assert_msg(strcmp(one, other) == 0, "%s and %s differ", a, b);
    free(one);
    free(other);
}

/* Runs, runs again what stands beside, compares all. */
static void expect_repeats(const Settings *settings, bool may_fail)
{
    bool bar = settings->problem == &problem_bar;
    Outputs first = {.asker = ASKER_COMMAND_LINE,
                     .series = in_folder("a.csv"),
                     .particles = in_folder("ap.csv"),
                     .force = true};
    Outputs again = {.asker = ASKER_COMMAND_LINE,
                     .series = in_folder("b.csv"),
                     .particles = in_folder("bp.csv"),
                     .force = true};
    first.nodes = bar ? in_folder("an.csv") : NULL;
    again.nodes = bar ? in_folder("bn.csv") : NULL;
    Status status = {0};
    RunSummary summary;
    bool sound = export_run(settings, &first, 1, NULL, NULL, &summary, &status);
    ck_assert_msg(sound != may_fail, "%s", status.text);
    Settings beside = read_back(in_folder("a.csv.ini"));
    ck_assert_double_eq(settings_time(&beside)->end, summary.time);
    run(&beside, &again, NULL);
    expect_same_files(first.series, again.series);
    expect_same_files(first.particles, again.particles);
    expect_same_scenarios(in_folder("a.csv.ini"), in_folder("b.csv.ini"), may_fail);
    expect_same_scenarios(in_folder("ap.csv.ini"), in_folder("bp.csv.ini"), may_fail);
    if (bar)
        expect_same_files(first.nodes, again.nodes);
}

/* What can be typed is within bounds; what is made of it may still be beyond all numbers some day. */
START_TEST(no_infinite_number_is_written)
{
    Settings settings = beam_settings(&problem_supported_beam, 1e-11);
    settings_edit_geometry(&settings)->thickness = 1e308;
    set(&settings, "beam.youngs_modulus", "71e20");
    const Outputs outputs[] = {
        {.asker = ASKER_COMMAND_LINE, .series = in_folder("inf.csv")},
        {.asker = ASKER_COMMAND_LINE, .particles = in_folder("inf.csv")},
    };
    Status status = {0};
    ck_assert(!export_run(&settings, &outputs[_i], 1, NULL, NULL, NULL, &status));
    ck_assert_msg(strstr(status.text, _i ? "strain_energy in step" : "in step") &&
                      strstr(status.text, "is too large for a number"),
                  "%s", status.text);
}
END_TEST

START_TEST(what_stands_beside_repeats_the_run)
{
    /* the sanitizers look at each access: fewer steps of the beams, past the same changes */
    const double share = suite_sanitized() ? 0.25 : 1;
    Settings settings = bar_settings(5, 3.1415926);
    expect_repeats(&settings, false);
    settings_edit_output(&settings)->every = 10;
    settings_edit_output(&settings)->frames = 5;
    expect_repeats(&settings, false);
    settings_edit_output(&settings)->frames = 0;
    strcpy(settings_edit_output(&settings)->at, "0,0.5,1.23456,3");
    settings.n_changes = 2;
    settings.changes[0] = (Change){100, {"mpm.algorithm", "musl"}};
    settings.changes[1] = (Change){150, {"mpm.transfer", "apic"}};
    expect_repeats(&settings, false);
    settings = beam_settings(&problem_supported_beam, share * 2e-5);
    settings_edit_output(&settings)->frames = 3;
    expect_repeats(&settings, false);
    settings = beam_settings(&problem_moving_cantilever, share * 1.5e-4);
    settings_edit_output(&settings)->every = 13;
    expect_repeats(&settings, false);
    settings = beam_settings(&problem_notched_beam, share * 4e-5);
    settings.n_changes = 1;
    settings.changes[0] = (Change){suite_sanitized() ? 12 : 50, {"load.stress", "240000000"}};
    expect_repeats(&settings, false);
}
END_TEST

/* A bar that leaves its mesh after a while. */
static Settings failing_settings(void)
{
    Settings settings = bar_settings(0, 10);
    set(&settings, "bar.supports", "free-free");
    set(&settings, "initial.velocity", "1");
    set(&settings, "mesh.padding", "1");
    return settings;
}

START_TEST(a_failed_run_is_written_up_to_there)
{
    Settings settings = failing_settings();
    Outputs outputs = {
        .asker = ASKER_COMMAND_LINE, .series = in_folder("s.csv"), .particles = in_folder("p.csv")};
    RunSummary summary;
    Status status = {0};
    ck_assert(!export_run(&settings, &outputs, 1, NULL, NULL, &summary, &status));
    ck_assert_int_eq(status.code, STATUS_FAILED);
    ck_assert(summary.failed);
    ck_assert_int_gt(summary.steps, 50);
    ck_assert_int_eq(count_lines(outputs.series), summary.steps + 2);
    ck_assert_int_eq(count_lines(outputs.particles), 51);
    expect_repeats(&settings, true);
    settings_edit_output(&settings)->every = 1000;
    expect_repeats(&settings, true);
    settings_edit_output(&settings)->frames = 20;
    expect_repeats(&settings, true);
}
END_TEST

START_TEST(frames_are_the_nearest_steps)
{
    Settings settings = bar_settings(1, 1);
    Outputs outputs = {.asker = ASKER_COMMAND_LINE, .particles = in_folder("p.csv"), .force = true};
    settings_edit_output(&settings)->frames = 4;
    run(&settings, &outputs, NULL);
    char *text = contents(outputs.particles);
    static const char *const starts[] = {"\n0,0,0,", "\n33,0.33,0,", "\n67,0.67,0,", "\n100,1,49,"};
    for (size_t i = 0; i < sizeof starts / sizeof *starts; i++)
        ck_assert_msg(strstr(text, starts[i]) != NULL, "no frame %s", starts[i]);
    ck_assert_int_eq(count_lines(outputs.particles), 201);
    free(text);
    settings_edit_output(&settings)->frames = 1;
    run(&settings, &outputs, NULL);
    ck_assert_int_eq(count_lines(outputs.particles), 51);
    /* the last step is the last, though the time lies nearer to another */
    Frames frames = {0};
    strcpy(settings_edit_output(&settings)->at, "0.5, 1.006");
    ck_assert(frames_plan(&frames, &settings, 0.01, 100, NULL));
    ck_assert_uint_eq(frames.count, 2);
    ck_assert_int_eq(frames.steps[0], 50);
    ck_assert_int_eq(frames.steps[1], 100);
    frames_free(&frames);
}
END_TEST

START_TEST(spreadsheets_get_a_decimal_comma)
{
    Settings settings = bar_settings(1, 1);
    Outputs comma = {.asker = ASKER_COMMAND_LINE, .series = in_folder("c.csv")};
    Outputs semicolon = {
        .asker = ASKER_COMMAND_LINE, .series = in_folder("s.csv"), .dialect = DIALECT_SEMICOLON};
    run(&settings, &comma, NULL);
    run(&settings, &semicolon, NULL);
    expect_numbers(semicolon.series, ';');
    char *one = contents(comma.series), *other = contents(semicolon.series);
    for (char *c = other; *c; c++)
        *c = (char)(*c == ',' ? '.' : *c == ';' ? ',' : *c);
    ck_assert(strcmp(one, other) == 0);
    free(one);
    free(other);
}
END_TEST

static void expect_refused(const Settings *settings, const Outputs *outputs, StatusCode code,
                           const char *word)
{
    Status status = {0};
    ck_assert(!export_run(settings, outputs, 1, NULL, NULL, NULL, &status));
    ck_assert_int_eq(status.code, code);
    ck_assert_msg(strstr(status.text, word) != NULL, "%s", status.text);
}

START_TEST(files_are_written_whole_or_not_at_all)
{
    Settings settings = bar_settings(1, 1);
    Outputs outputs = {
        .asker = ASKER_COMMAND_LINE, .series = in_folder("s.csv"), .particles = in_folder("p.csv")};
    FILE *old = fopen(outputs.particles, "w");
    fputs("old", old);
    fclose(old);
    expect_refused(&settings, &outputs, STATUS_USAGE, "p.csv: exists");
    ck_assert_int_eq(count_files(), 1);
    unlink(outputs.particles);

    /* what stands beside may be in the way as well */
    old = fopen(in_folder("s.csv.ini"), "w");
    fclose(old);
    expect_refused(&settings, &outputs, STATUS_USAGE, "s.csv.ini: exists");
    unlink(in_folder("s.csv.ini"));

    Outputs same = {.asker = ASKER_COMMAND_LINE,
                    .series = in_folder("s.csv"),
                    .nodes = in_folder("../"),
                    .particles = NULL};
    char other[256];
    snprintf(other, sizeof other, "%s/./s.csv", folder);
    same.nodes = other;
    expect_refused(&settings, &same, STATUS_USAGE, "same file");
    same.nodes = in_folder("s.csv.ini");
    expect_refused(&settings, &same, STATUS_USAGE, "same file");
    same = (Outputs){.asker = ASKER_COMMAND_LINE, .series = "-", .nodes = "-"};
    expect_refused(&settings, &same, STATUS_USAGE, "standard output");
    same = (Outputs){.asker = ASKER_COMMAND_LINE, .series = in_folder("none/s.csv")};
    expect_refused(&settings, &same, STATUS_USAGE, "none/s.csv: there is no folder");
    same = (Outputs){.asker = ASKER_COMMAND_LINE, .series = folder};
    expect_refused(&settings, &same, STATUS_USAGE, "folder");
    same = (Outputs){.asker = ASKER_COMMAND_LINE, .bonds = in_folder("b.csv")};
    expect_refused(&settings, &same, STATUS_USAGE, "--bonds");
    ck_assert_int_eq(count_files(), 0);

    /* a device that is full: nothing takes its place, nothing else is left behind */
    same = (Outputs){
        .asker = ASKER_COMMAND_LINE, .series = "/dev/full", .particles = in_folder("p.csv"), .force = true};
    expect_refused(&settings, &same, STATUS_FAILED, "/dev/full");
    ck_assert_int_eq(count_files(), 0);
    struct stat what;
    ck_assert(stat("/dev/full", &what) == 0 && S_ISCHR(what.st_mode));
}
END_TEST

static bool stop_soon(double share, void *context)
{
    int *calls = context;
    ck_assert(share >= 0 && share <= 1);
    return ++*calls < 5;
}

START_TEST(an_interrupted_run_leaves_nothing)
{
    Settings settings = bar_settings(1, 100);
    settings_edit_output(&settings)->frames = 100;
    Outputs outputs = {.asker = ASKER_COMMAND_LINE,
                       .series = in_folder("s.csv"),
                       .particles = in_folder("p.csv"),
                       .vtk = in_folder("v.pvd")};
    int calls = 0;
    Status status = {0};
    ck_assert(!export_run(&settings, &outputs, 1, stop_soon, &calls, NULL, &status));
    ck_assert_int_eq(calls, 5);
    ck_assert_int_eq(count_files(), 0);
}
END_TEST

START_TEST(paraview_gets_a_collection)
{
    Settings settings = beam_settings(&problem_supported_beam, 2e-6);
    Outputs outputs = {.asker = ASKER_COMMAND_LINE, .vtk = in_folder("v.pvd")};
    settings_edit_output(&settings)->frames = 3;
    run(&settings, &outputs, NULL);
    ck_assert_int_eq(count_files(), 4);
    char *collection = contents(outputs.vtk), *frame = contents(in_folder("v-0002.vtu"));
    ck_assert_ptr_nonnull(strstr(collection, "timestep=\"0\" part=\"0\" file=\"v-0000.vtu\""));
    ck_assert_ptr_nonnull(strstr(collection, "file=\"v-0002.vtu\""));
    ck_assert_ptr_nonnull(strstr(frame, "Name=\"displacement\" NumberOfComponents=\"3\""));
    ck_assert_ptr_nonnull(strstr(frame, "Name=\"velocity\""));
    ck_assert_ptr_nonnull(strstr(frame, "Name=\"damage\""));
    ck_assert_ptr_nonnull(strstr(frame, "</VTKFile>"));
    free(collection);
    free(frame);
    outputs.vtk = in_folder("a<b\"c&d.pvd"); /* signs of XML */
    run(&settings, &outputs, NULL);
    collection = contents(outputs.vtk);
    ck_assert_ptr_nonnull(strstr(collection, "file=\"a&lt;b&quot;c&amp;d-0002.vtu\"/>"));
    free(collection);
    settings_edit_output(&settings)->frames = 0;
    outputs.vtk = in_folder("one");
    run(&settings, &outputs, NULL);
    ck_assert_int_eq(count_files(), 9);
    free(contents(in_folder("one.vtu")));
}
END_TEST

/* The file whole, with its length: raw data hold zero bytes. */
static char *all_bytes(const char *name, size_t *length)
{
    FILE *file = fopen(name, "rb");
    ck_assert_ptr_nonnull(file);
    ck_assert_int_eq(fseek(file, 0, SEEK_END), 0);
    *length = (size_t)ftell(file);
    rewind(file);
    char *bytes = calloc(1, *length + 1);
    ck_assert_uint_eq(fread(bytes, 1, *length, file), *length);
    fclose(file);
    return bytes;
}

/* The number k of an array of numbers in text. */
static double number_in_text(const char *frame, const char *name, size_t k)
{
    char head[80], *at;
    snprintf(head, sizeof head, "Name=\"%s\"", name);
    ck_assert_ptr_nonnull(at = strstr(frame, head));
    at = strchr(at, '>') + 1;
    for (; k > 0; k--)
        strtod(at, &at);
    return strtod(at, NULL);
}

/* The same of raw data: each array has its size in bytes before its numbers. */
static double raw_number(const char *frame, const char *name, size_t k, uint64_t wanted_bytes)
{
    char head[80], *at;
    uint64_t offset, bytes;
    double number;
    snprintf(head, sizeof head, "Name=\"%s\"", name);
    ck_assert_ptr_nonnull(at = strstr(frame, head));
    ck_assert_ptr_nonnull(at = strstr(at, "offset=\""));
    offset = strtoull(at + 8, NULL, 10);
    ck_assert_ptr_nonnull(at = strstr(frame, "<AppendedData encoding=\"raw\">"));
    at = strchr(at, '_') + 1 + offset;
    memcpy(&bytes, at, sizeof bytes);
    ck_assert_uint_eq(bytes, wanted_bytes);
    memcpy(&number, at + sizeof bytes + k * sizeof number, sizeof number);
    return number;
}

START_TEST(raw_data_are_those_of_the_text)
{
    Settings settings = beam_settings(&problem_supported_beam, 2e-6);
    Outputs outputs = {.asker = ASKER_COMMAND_LINE, .vtk = in_folder("text.vtu")};
    size_t length;
    run(&settings, &outputs, NULL);
    char *text = contents(outputs.vtk);
    outputs.vtk = in_folder("raw.vtu");
    outputs.vtk_data = VTK_RAW;
    run(&settings, &outputs, NULL);
    char *raw = all_bytes(outputs.vtk, &length), *at;
    ck_assert_ptr_nonnull(at = strstr(text, "NumberOfPoints=\""));
    const size_t count = strtoul(at + 16, NULL, 10);
    for (size_t k = 0; k < 3 * count; k++) {
        ck_assert_double_eq(raw_number(raw, "position", k, 24 * count), number_in_text(text, "position", k));
        ck_assert_double_eq(raw_number(raw, "velocity", k, 24 * count), number_in_text(text, "velocity", k));
    }
    for (size_t k = 0; k < count; k++)
        ck_assert_double_eq(raw_number(raw, "strain_energy", k, 8 * count),
                            number_in_text(text, "strain_energy", k));
    ck_assert_str_eq(raw + length - 27, "</AppendedData>\n</VTKFile>\n");
    free(raw);
    free(text);
}
END_TEST

/* Whatever the time step and wherever the run ends, what loses nothing is told to lose nothing. */
START_TEST(the_ripple_is_no_loss)
{
    static const double courants[] = {0.1, 0.5, 1, 1.5}, ends[] = {1, 20.3};
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 2; k++) {
            Settings settings = bar_settings(5, ends[k]);
            RunSummary summary;
            settings_edit_time(&settings)->courant = courants[i];
            settings_edit_start(&settings)->velocity = 1e-6;
            run(&settings, &(Outputs){0}, &summary);
            ck_assert_int_eq(summary.energy_measure, ENERGY_INVARIANT);
            ck_assert_double_eq_tol(summary.energy_change, 0, 1e-3);
            /* without an invariant by the mean of the last whole period */
            settings_edit_transfer(&settings)->transfer = MPM_APIC;
            settings_edit_start(&settings)->mode = 1;
            settings_edit_time(&settings)->courant = courants[i] / 2;
            run(&settings, &(Outputs){0}, &summary);
            ck_assert_int_eq(summary.energy_measure, k == 0 ? ENERGY_TENTH : ENERGY_PERIOD);
        }
}
END_TEST

START_TEST(what_has_decayed_is_told_so)
{
    Settings settings = bar_settings(10, 100);
    RunSummary summary;
    settings_edit_transfer(&settings)->algorithm = MPM_USL; /* decays and is measured */
    run(&settings, &(Outputs){0}, &summary);
    ck_assert_double_eq_tol(summary.readout.measured / summary.readout.predicted, 1, 3e-5);
    ck_assert_double_eq_tol(summary.readout.measured, summary.readout.predicted, summary.readout.uncertainty);
    ck_assert_double_lt(summary.energy_change, -90);
    settings_edit_transfer(&settings)->algorithm = MPM_USF;
    ck_assert(settings_set(&settings, "mpm.mistake", "stress_not_added", NULL));
    run(&settings, &(Outputs){0}, &summary);
    ck_assert(summary.readout.moving && !summary.readout.measured_known);
    ck_assert_str_eq(summary.readout.unmeasured, "the motion has decayed: nothing to measure");
    ck_assert_double_lt(summary.energy_change, -90);
    settings_edit_time(&settings)->end = 0.1;
    run(&settings, &(Outputs){0}, &summary);
    ck_assert_str_eq(summary.readout.unmeasured, "too short a run to measure it");
}
END_TEST

START_TEST(a_summary_tells_what_a_run_came_to)
{
    Settings settings = bar_settings(5, 20);
    RunSummary summary;
    Outputs none = {0};
    run(&settings, &none, &summary);
    ck_assert(summary.readout.measured_known && summary.readout.predicted_known);
    ck_assert_double_eq_tol(summary.readout.error_frequency, -4.239, 2e-3);
    ck_assert_int_eq(summary.energy_measure, ENERGY_INVARIANT);
    ck_assert_double_eq_tol(summary.energy_change, 0, 0.1);
    ck_assert_double_eq_tol(summary.readout.late, 0.763, 2e-3);
    settings_edit_start(&settings)->velocity = 0;
    run(&settings, &none, &summary);
    ck_assert(!summary.readout.moving);
    ck_assert_int_eq(summary.energy_measure, ENERGY_NOT_KNOWN);
}
END_TEST

/* Rate and frequency of a damped beam, as an independent program has them: the rate half of alpha. */
START_TEST(damping_is_told_as_a_rate)
{
    const double alpha = 1451.9169931853621;
    Settings settings;
    ck_assert(scenario_load("supported-beam-coarse", &settings, NULL));
    RunSummary summary;
    settings_edit_damping(&settings)->rate = alpha;
    settings_edit_time(&settings)->step = 1e-7;
    settings_edit_time(&settings)->end = 3e-3;
    run(&settings, &(Outputs){0}, &summary);
    const Readout *readout = &summary.readout;
    ck_assert_double_eq_tol(readout->decay_exact, alpha / 2, 1e-9);
    ck_assert_double_eq_tol(readout->decay_measured / (alpha / 2), 1 - 5.5e-5, 1e-3);
    ck_assert_double_eq_tol(readout->measured / readout->predicted, 1, 2e-5);
    char text[SUMMARY_MAX], wanted[200];
    summary_text(&summary, &settings, text);
    snprintf(wanted, sizeof wanted,
             "\ndecay  measured %.7g  theory 725.9585  1/s, half the damping\nfrequency  ",
             readout->decay_measured);
    ck_assert_msg(strstr(text, wanted) != NULL, "%s", text);
    settings_edit_damping(&settings)->rate = 0;
    settings_edit_time(&settings)->end = 1e-4;
    run(&settings, &(Outputs){0}, &summary);
    ck_assert(isnan(summary.readout.decay_exact) && isnan(summary.readout.decay_measured));
}
END_TEST

START_TEST(a_zero_keeps_its_sign)
{
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    csv_row(stream, DIALECT_COMMA, (double[]){-0.0, 0, -3, -0.5, 1e15, -1e-7}, 6);
    fclose(stream);
    ck_assert_str_eq(text, "-0,0,-3,-0.5,1e15,-1e-7\n");
    free(text);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("export");
    tcase_add_checked_fixture(tcase, make_folder, remove_folder);
    tcase_add_test(tcase, columns_are_those_of_the_contract);
    tcase_add_test(tcase, columns_are_written_that_are_asked_for);
    tcase_add_test(tcase, rows_are_those_of_the_laboratory);
    tcase_add_loop_test(tcase, no_infinite_number_is_written, 0, 2);
    tcase_add_test(tcase, what_stands_beside_repeats_the_run);
    tcase_add_test(tcase, a_failed_run_is_written_up_to_there);
    tcase_add_test(tcase, frames_are_the_nearest_steps);
    tcase_add_test(tcase, spreadsheets_get_a_decimal_comma);
    tcase_add_test(tcase, files_are_written_whole_or_not_at_all);
    tcase_add_test(tcase, an_interrupted_run_leaves_nothing);
    tcase_add_test(tcase, paraview_gets_a_collection);
    tcase_add_test(tcase, raw_data_are_those_of_the_text);
    tcase_add_test(tcase, a_summary_tells_what_a_run_came_to);
    if (suite_wide()) /* a whole beam */
        tcase_add_test(tcase, damping_is_told_as_a_rate);
    tcase_add_test(tcase, the_ripple_is_no_loss);
    tcase_add_test(tcase, what_has_decayed_is_told_so);
    tcase_add_test(tcase, a_zero_keeps_its_sign);
    suite_add_tcase(suite, tcase);
}
