/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is shown inside a time step adds up: every sum of the stage box is worked out again from the digits
 * that are printed, and so are the columns of the inspector; the results are the fields of the run. */
#include "methods/mpm/mpm.h"
#include "scenario/settings.h"
#include "methods/bonds/plane/bonds_plane.h"
#include "scenario/scenario.h"
#include "suite.h"
#include "sums.h"
#include "views/scene.h"
#include "panes/screen.h"
#include "run/duel.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- the sums of the stages ------------------------------------------------------------------------ */

static double field_now(const Simulation *sim, int set, const char *name, size_t index)
{
    const int field = simulation_find_field(sim, set, name);
    ck_assert_msg(field >= 0, "%s", name);
    double value;
    sim->method->field(sim, field, index, 1, &value);
    return value;
}

/* Fields that labels of the sums stand for; an index may follow ("p13" is the momentum of node 13). */
static const struct {
    const char *label;
    int set;
    const char *field;
    bool numbered;
} told[] = {
    {"m", 1, "mass", true},       {"v", 1, "velocity", true}, {"f_int", 1, "f_int", false},
    {"f_ext", 1, "f_ext", false}, {"f", 1, "f", false},       {"v", 0, "v", false},
    {"x", 0, "x", false},         {"u", 0, "u", false},       {"Δε", 0, "strain_increment", false},
    {"σ", 0, "stress", false},    {"ρ", 0, "density", false}, {"C", 0, "affine", false},
    {"ux", 0, "ux", false},       {"uy", 0, "uy", false},     {"vx", 0, "vx", false},
    {"vy", 0, "vy", false},       {"fx", 0, "fx", false},     {"fy", 0, "fy", false},
    {"φ", 0, "damage", false},    {"fx", 1, "fx", false},     {"fy", 1, "fy", false},
    {"vx", 1, "vx", false},       {"vy", 1, "vy", false},     {"m", 1, "mass", false},
    {"px", 1, "px", false},       {"py", 1, "py", false},     {"Δεxx", 0, "exx", false},
    {"Δεyy", 0, "eyy", false},    {"Δγxy", 0, "gxy", false},  {"σxx", 0, "sxx", false},
    {"σyy", 0, "syy", false},     {"σxy", 0, "sxy", false},
};

/* The result is the value of the field. Returns whether the label names one. */
static bool expect_field(const Simulation *sim, int set, size_t index, const PrintedSum *sum,
                         const char *line)
{
    for (size_t i = 0; i < sizeof told / sizeof *told; i++) {
        const size_t length = strlen(told[i].label);
        char number[24];
        snprintf(number, sizeof number, "%zu", index);
        const bool here = strncmp(sum->label, told[i].label, length) == 0 &&
                          strcmp(sum->label + length, told[i].numbered ? number : "") == 0;
        if (!here || told[i].set != set || simulation_find_field(sim, set, told[i].field) < 0)
            continue;
        const double value = field_now(sim, set, told[i].field, index);
        /* a result may be rounded to fewer digits than it is printed with: trailing zeros are not printed */
        ck_assert_msg(fabs(value - sum->result) <= sum->last * (1 + 1e-6) + 1e-12 * fabs(value),
                      "%s\n%s %zu is %.9g", line, told[i].field, index, value);
        return true;
    }
    return false;
}

typedef struct Tally {
    long sums, fields, coarse;
} Tally;

static bool is_beam_of_cells(const Simulation *sim)
{
    return sim->dimensions == 2 && strcmp(sim->method->name, "mpm") == 0;
}

static void expect_sums(const Simulation *sim, int set, size_t index, const char *text, Tally *tally)
{
    /* nothing happens to the particles of a beam of cells while the nodes are integrated */
    ck_assert(*text || (set == 0 && is_beam_of_cells(sim)));
    ck_assert(!*text || text[strlen(text) - 1] == '\n');
    for (const char *line = text; *line != '\0'; line = strchr(line, '\n') + 1) {
        PrintedSum sum;
        if (!read_sum(line, &sum))
            continue;
        ck_assert_msg(fabs(sum.value - sum.result) <= sum.last * (1 + 1e-5), "%s%s %zu: it comes to %.9g",
                      line, sim->sets[set].name, index, sum.value);
        tally->sums++;
        /* of a sum that cancels what is left is nothing beside its terms */
        if (sum.result == 0)
            ck_assert_msg(fabs(sum.value) <= 1e-3 * sum.largest, "%sit comes to %g", line, sum.value);
        tally->coarse += sum.result != 0 && fabs(sum.value - sum.result) > 0.006 * fabs(sum.result);
        tally->fields += expect_field(sim, set, index, &sum, line);
    }
}

static void expect_all_sums(Experiment *experiment, size_t stride, Tally *tally)
{
    static const int terms[] = {0, 3};
    const Simulation *sim = experiment_simulation(experiment);
    const int sets = sim->dimensions == 1 || is_beam_of_cells(sim) ? 2 : 1;
    Status status;
    for (int stage = 0; stage < sim->n_stages; stage++) {
        ck_assert(experiment_next_stage(experiment, &status));
        for (int set = 0; set < sets; set++)
            for (size_t index = 0; index < sim->counts[set]; index += stride)
                for (size_t t = 0; t < sizeof terms / sizeof *terms; t++) {
                    char text[8192];
                    sim->method->explain(sim, stage, set, index, experiment_before(experiment), terms[t],
                                         text, sizeof text);
                    expect_sums(sim, set, index, text, tally);
                }
    }
}

static Experiment *experiment_with(const char *scenario, const char *const *keys, long steps)
{
    Settings settings;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scenario_load(scenario, &settings, &status), "%s", status.text);
    for (; *keys; keys += 2)
        ck_assert_msg(settings_set(&settings, keys[0], keys[1], &status), "%s", status.text);
    Experiment *experiment = experiment_create(&settings, 64 << 20, 1, &status);
    ck_assert_msg(experiment != NULL, "%s", status.text);
    ck_assert(experiment_advance(experiment, steps, &status));
    return experiment;
}

static const char *const algorithms[] = {"usf", "usl", "musl"};
static const char *const shapes[] = {"hat", "gimp", "bspline2", "bspline3"};
static const char *const transfers[][2] = {{"flip", "1"}, {"flip", "0.95"}, {"flip", "0"}, {"apic", "1"}};
enum { BAR_VARIANTS = 3 * 4 * 4 };

START_TEST(sums_of_a_bar_add_up)
{
    if (!suite_wide() && (_i % 3 + _i / 3 % 4 + _i / 12) % 3 != 0)
        return; /* each algorithm with each shape and each transfer, but not all three crossed */
    const char *const *transfer = transfers[_i / 12];
    const bool loaded = _i % 2;
    const char *keys[] = {"mpm.algorithm",
                          algorithms[_i % 3],
                          "mpm.shape",
                          shapes[_i / 3 % 4],
                          "mpm.transfer",
                          transfer[0],
                          "mpm.flip_fraction",
                          transfer[1],
                          "load.body_force",
                          loaded ? "1e-3" : "0",
                          "load.traction",
                          loaded ? "1e-2" : "0",
                          "bar2.joint",
                          loaded ? "12" : "0",
                          "bar2.density",
                          "4",
                          NULL};
    Experiment *experiment = experiment_with("mode5", keys, 137);
    Tally tally = {0};
    expect_all_sums(experiment, 1, &tally);
    ck_assert_int_gt(tally.sums, 1000);
    ck_assert_int_gt(tally.fields, 500);
    /* hardly any has less than two good digits: where a sum all but cancels */
    ck_assert_msg(tally.coarse * 50 < tally.sums, "%ld of %ld", tally.coarse, tally.sums);
    experiment_destroy(experiment);
}
END_TEST

START_TEST(sums_of_a_wrong_bar_add_up)
{
    const char *mistake = mpm_mistake_words[_i + 1];
    const char *keys[] = {"mesh.particles_per_cell",
                          "3",
                          "bar.length",
                          "10",
                          "mesh.cell_size",
                          "0.5",
                          "load.body_force",
                          "1e-3",
                          "mpm.algorithm",
                          strncmp(mistake, "keep_grid_", 10) == 0 ? "musl" : "usf",
                          "mpm.mistake",
                          mistake,
                          NULL};
    Experiment *experiment = experiment_with("mode5", keys, _i % 2 ? 37 : 0);
    Tally tally = {0};
    expect_all_sums(experiment, 1, &tally);
    ck_assert_int_gt(tally.sums, 1000);
    ck_assert_int_gt(tally.fields, 500);
    experiment_destroy(experiment);
}
END_TEST

/* At some nodes or particles of a beam after so many steps. */
static void expect_sums_of(const char *scenario, const char *const *keys, long steps, long least)
{
    Experiment *experiment = experiment_with(scenario, keys, steps);
    Tally tally = {0};
    expect_all_sums(experiment, 37, &tally);
    ck_assert_int_gt(tally.sums, least);
    ck_assert_int_gt(tally.fields, least * 3 / 4);
    experiment_destroy(experiment);
}

START_TEST(sums_of_a_beam_add_up)
{
    static const char *const scenarios[] = {"supported-beam-coarse", "moving-cantilever-coarse",
                                            "notched-beam-coarse"};
    static const char *const none[] = {NULL};
    expect_sums_of(scenarios[_i], none, _i == 2 ? 1100 : 60, 400);
}
END_TEST

/* A beam of cells: each algorithm, with hats and with domains, on a mesh that rests and on one that moves. */
START_TEST(sums_of_a_beam_of_cells_add_up)
{
    const char *keys[] = {"mpm.algorithm", algorithms[_i % 3], "mpm.shape", shapes[_i % 2], NULL};
    expect_sums_of(_i % 2 ? "supported-beam-mpm-coarse" : "moving-cantilever-mpm-coarse", keys, 60, 400);
}
END_TEST

START_TEST(sums_of_a_wrong_beam_add_up)
{
    const char *keys[] = {"pd.mistake", beam_mistake_words[_i + 1], NULL};
    expect_sums_of("supported-beam-coarse", keys, 3, 200);
}
END_TEST

START_TEST(a_wrong_sum_is_seen)
{
    PrintedSum sum;
    ck_assert(read_sum("p13 = 0.5 × (0.2 × -0.3 - 0.1 (2 more)) = -0.08 kg", &sum));
    ck_assert_str_eq(sum.label, "p13");
    ck_assert_double_eq_tol(sum.value, -0.08, 1e-15);
    ck_assert_double_eq_tol(sum.last, 0.005, 1e-15);
    ck_assert(read_sum("N: 0.25 to 12 + 0.7 to 13 = 1.00", &sum) && fabs(sum.value - sum.result) > sum.last);
    ck_assert(read_sum("x = 12 + 2e-3 × 4 = 1.2008e1", &sum));
    ck_assert_double_eq_tol(sum.last, 0.5e-3, 1e-15);
    ck_assert(!read_sum("free: nothing holds this node", &sum));
}
END_TEST

/* --- the columns of the inspector -------------------------------------------------------------------- */

typedef struct Lines {
    char *text, *line[64];
    int count;
} Lines;

static Lines lines_of(const Canvas *canvas)
{
    Lines lines = {.text = canvas_dump(canvas)};
    ck_assert_ptr_nonnull(lines.text);
    for (char *line = lines.text; *line != '\0' && lines.count < 64;) {
        lines.line[lines.count++] = line;
        line += strcspn(line, "\n");
        if (*line == '\n')
            *line++ = '\0';
    }
    return lines;
}

/* The last `count` numbers of a line, in their order; false: there are fewer. */
static bool last_numbers(const char *line, int count, double numbers[], double last[])
{
    char copy[512], *words[64];
    int n = 0;
    snprintf(copy, sizeof copy, "%s", line);
    for (char *word = strtok(copy, " "); word && n < 64; word = strtok(NULL, " "))
        words[n++] = word;
    if (n < count)
        return false;
    for (int i = 0; i < count; i++) {
        char *end;
        const char *word = words[n - count + i];
        numbers[i] = strtod(word, &end);
        if (end == word)
            return false;
        const char *point = strchr(word, '.');
        last[i] = 0.5 * pow(10, -(point ? (double)strlen(point + 1) : 0));
    }
    return true;
}

/* How many products the block has whose heads stand in this line of formulas: those of more than one word. */
static int products_of(const char *heads)
{
    static const char *const formulas[] = {"m N",     "m v N",  "m w N",  "-N′ σ V", "N load",
                                           "Δt N′ v", "Δt N a", "N gain", "N v",     "Δt N v"};
    int count = 0;
    for (size_t i = 0; i < sizeof formulas / sizeof *formulas; i++)
        for (const char *at = heads; (at = strstr(at, formulas[i])); at++) {
            const char *end = at + strlen(formulas[i]);
            /* a formula of its own: two spaces before it, the end or two spaces behind */
            count += at >= heads + 2 && at[-1] == ' ' && at[-2] == ' ' &&
                     (*end == '\0' || strncmp(end, "  ", 2) == 0);
        }
    return count;
}

/* Each block of the screen: rows, "sum", "it had", "it has". Returns the columns that were worked out. */
static int expect_columns(const Scene *scene, const char *words)
{
    Lines lines = lines_of(&scene->canvas);
    int worked = 0;
    for (int sum = 0; sum < lines.count; sum++) {
        const char *word = lines.line[sum] + strspn(lines.line[sum], " ");
        if (strncmp(word, "sum ", 4) != 0)
            continue;
        int head = sum;
        while (head > 0 && !strstr(lines.line[head], "  N  "))
            head--;
        const int count = products_of(lines.line[head]);
        ck_assert_msg(count > 0, "%s: %s", words, lines.line[head]);
        double total[8] = {0}, numbers[8], last[8], said[8], had[8] = {0}, has[8];
        for (int row = head + 1; row < sum; row++)
            if (last_numbers(lines.line[row], count, numbers, last))
                for (int i = 0; i < count; i++)
                    total[i] += numbers[i];
        ck_assert(last_numbers(lines.line[sum], count, said, last));
        for (int i = 0; i < count; i++) {
            ck_assert_msg(fabs(total[i] - said[i]) <= last[i] * (1 + 1e-6),
                          "%s: column %d comes to %.9g:\n%s", words, i, total[i], lines.line[sum]);
            worked++;
        }
        int row = sum + 1;
        const bool adds = row < lines.count && strstr(lines.line[row], "it had");
        if (adds)
            ck_assert(last_numbers(lines.line[row++], count, had, last));
        if (row < lines.count && strstr(lines.line[row], "it has")) {
            ck_assert(last_numbers(lines.line[row], count, has, last));
            for (int i = 0; i < count; i++)
                ck_assert_msg(fabs(had[i] + said[i] - has[i]) <= last[i] * (1 + 1e-6), "%s: %s", words,
                              lines.line[row]);
        }
    }
    free(lines.text);
    return worked;
}

START_TEST(columns_of_the_inspector_add_up)
{
    int worked = 0;
    static const char *const sizes[] = {"80x24", "132x43"};
    for (int stage = 0; stage <= 7; stage++)
        for (int node = 0; node < 2; node++)
            for (int size = 0; size < 2; size++) {
                char words[256];
                if (!suite_wide() && (stage + node + size + _i) % 2 != 0)
                    continue;
                snprintf(words, sizeof words,
                         "mode5 %s 137 stage %d inspect mpm.algorithm=%s mpm.shape=%s load.body_force=%s%s",
                         sizes[size], stage, algorithms[_i % 3], shapes[_i / 3], _i % 2 ? "1e-3" : "0",
                         node ? " node" : "");
                Scene scene;
                Status status = {STATUS_DONE, ""};
                ck_assert_msg(scene_open(&scene, words, &status), "%s", status.text);
                worked += expect_columns(&scene, words);
                scene_close(&scene);
            }
    ck_assert_int_gt(worked, (suite_wide() ? 20 : 8));
}
END_TEST

/* The rows from the head of the table to "all its bonds", then the load, then the force of the node. */
static int expect_bonds(const Scene *scene, const char *words)
{
    Lines lines = lines_of(&scene->canvas);
    int row = 0, bonds = 0;
    double total = 0, number, half, all, load = 0, force, unit = 1;
    while (row < lines.count && !strstr(lines.line[row], "force on it"))
        row++;
    const char *scale = row > 0 ? strstr(lines.line[row - 1], "x10^") : NULL;
    if (scale)
        unit = pow(10, strtod(scale + 4, NULL));
    for (row++; row < lines.count && !strstr(lines.line[row], "all its bonds"); row++)
        if (last_numbers(lines.line[row], 1, &number, &half))
            total += number, bonds++;
    ck_assert_msg(row < lines.count, "%s", words);
    ck_assert(last_numbers(lines.line[row++], 1, &all, &half));
    ck_assert_msg(fabs(total - all) <= half * (1 + 1e-6), "%s: %.9g, not %.9g", words, total, all);
    if (strstr(lines.line[row], "load on the node"))
        ck_assert(last_numbers(lines.line[row++], 1, &load, &half));
    ck_assert(last_numbers(lines.line[row], 1, &force, &half));
    if (!strstr(lines.line[row], "of the last step")) {
        ck_assert_msg(fabs(all + load - force) <= half * (1 + 1e-6), "%s: %s", words, lines.line[row]);
        const double now = field_now(experiment_simulation(scene->screen.experiment), 0, "force",
                                     scene->screen.chosen.particle);
        ck_assert_msg(fabs(now - force * unit) <= half * unit * (1 + 1e-6), "%s: %.9g", words, now);
    }
    free(lines.text);
    return bonds;
}

START_TEST(forces_of_bonds_add_up)
{
    static const char *const sizes[] = {"80x24", "132x43 pd.horizon=6", "80x24 pd.horizon=2.5 zoom",
                                        "60x18 pd.horizon=5"};
    for (size_t size = 0; size < 4; size++) {
        char words[256];
        const int wide = (int)strcspn(sizes[size], " ");
        snprintf(words, sizeof words, "mode5-peridynamics %.*s 137%s inspect focus 5 load.body_force=%s",
                 wide, sizes[size], sizes[size] + wide, _i ? "1e-3" : "0");
        Scene scene;
        Status status = {STATUS_DONE, ""};
        ck_assert_msg(scene_open(&scene, words, &status), "%s", status.text);
        for (int stage = 0; stage <= 5; stage++) {
            ck_assert_msg(stage == 0 || duel_next_stage(&scene.duel, &status), "%s", status.text);
            for (size_t particle = 0; particle < 50; particle += 7) {
                scene.screen.chosen.particle = particle;
                char where[320];
                snprintf(where, sizeof where, "%s, stage %d, node %zu", words, stage, particle);
                screen_draw(&scene.screen, &scene.canvas);
                ck_assert_int_ge(expect_bonds(&scene, where), 3); /* at the free end */
            }
        }
        scene_close(&scene);
    }
}
END_TEST

/* --- nothing is cut ---------------------------------------------------------------------------------- */

static const char *const everything[] = {
    "mode1",
    "mode1 mpm.algorithm=usl",
    "mode5 mpm.algorithm=musl mpm.shape=gimp",
    "mode1 mpm.shape=bspline2",
    "mode1 mpm.shape=bspline3 mpm.transfer=apic",
    "gravity",
    "pull mpm.flip_fraction=0.9",
    "mode1 mesh.particles_per_cell=6",
    "supported-beam-coarse",
    "moving-cantilever-coarse",
    "notched-beam-coarse",
};

/* No line of the box ends in an ellipsis, and in ASCII no arrow is left half: one run, stage by stage, drawn
 * in all sizes. */
START_TEST(no_box_is_cut)
{
    static const int sizes[][2] = {{80, 24}, {132, 43}};
    char words[256];
    const int name = (int)strcspn(everything[_i], " ");
    snprintf(words, sizeof words, "%.*s 80x24 60 %s", name, everything[_i], everything[_i] + name);
    Scene scene;
    Screen *screen = &scene.screen;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scene_open(&scene, words, &status), "%s", status.text);
    for (int stage = 0; stage <= 7; stage++) {
        ck_assert_msg(stage == 0 || duel_next_stage(&scene.duel, &status), "%s", status.text);
        for (int kind = 0; kind < 8; kind++) {
            if (!suite_wide() && (kind + stage + _i) % 4 != 0)
                continue;
            const int width = sizes[kind / 4][0], height = sizes[kind / 4][1];
            screen->chosen.is_node = kind & 1;
            screen->look.glyphs = kind & 2 ? GLYPHS_ASCII : GLYPHS_BRAILLE;
            ck_assert(canvas_open(&scene.canvas, width, height, &status));
            screen_draw(screen, &scene.canvas);
            const Rect box = screen_pane(screen, width, height, PANE_BOX);
            ck_assert_msg(stage == 0 || box.height > 0, "%s: no box in stage %d", words, stage);
            Lines lines = lines_of(&scene.canvas);
            for (int y = box.y; y < box.y + box.height && y < lines.count; y++)
                ck_assert_msg(!strstr(lines.line[y], "…") && !strchr(lines.line[y], '~'),
                              "%s, stage %d, kind %d:\n%s", words, stage, kind, lines.line[y]);
            free(lines.text);
        }
    }
    scene_close(&scene);
}
END_TEST

/* At 80x24 the box of bodies in contact has the equation of each stage and the end of all its sums, on both
 * sheets, of a particle and of a node that both bodies share; at 60x18 there is a box. */
START_TEST(the_box_of_bodies_is_whole)
{
    Scene scene;
    Status status = {STATUS_DONE, ""};
    Screen *screen = &scene.screen;
    ck_assert_msg(scene_open(&scene, _i ? "two-discs 80x24 185 bare" : "two-discs 80x24 185", &status), "%s",
                  status.text);
    const Simulation *sim = experiment_simulation(screen->experiment);
    screen->chosen.node =
        14 * 29 + 14; /* of the left disc at (0.5, 0.5), four nodes around a box of 20 cells */
    for (int stage = 0; stage < sim->n_stages; stage++) {
        ck_assert_msg(duel_next_stage(&scene.duel, &status), "%s", status.text);
        for (int set = 0; set < 2; set++) {
            char text[4096], all[8192] = "";
            screen->chosen.is_node = set == 1;
            ck_assert(canvas_open(&scene.canvas, 80, 24, &status));
            screen_draw(screen, &scene.canvas);
            const Rect box = screen_pane(screen, 80, 24, PANE_BOX);
            Lines lines = lines_of(&scene.canvas);
            for (int y = box.y; y < box.y + box.height; y++)
                snprintf(all + strlen(all), sizeof all - strlen(all), "%s\n", lines.line[y]);
            free(lines.text);
            snprintf(text, sizeof text, "%.12s", sim->stages[stage].equation);
            ck_assert_msg(strstr(all, text), "stage %d, set %d: no %s in\n%s", stage + 1, set, text, all);
            sim->method->explain(sim, stage, set, set ? screen->chosen.node : screen->chosen.particle,
                                 experiment_before(screen->experiment), 2, text, sizeof text);
            text[strlen(text) - 1] = '\0';
            char *last = strrchr(text, '\n') ? strrchr(text, '\n') + 1 : text;
            last[strcspn(last, ":=")] = '\0';
            ck_assert_msg(strstr(all, last), "stage %d, set %d: no %s in\n%s", stage + 1, set, last, all);
            ck_assert(canvas_open(&scene.canvas, 60, 18, &status));
            screen_draw(screen, &scene.canvas);
            ck_assert_int_eq(screen_pane(screen, 60, 18, PANE_BOX).height, _i ? 7 : 0);
        }
    }
    scene_close(&scene);
}
END_TEST

/* --- the list of stages ------------------------------------------------------------------------------ */

static int line_with(const char *words, const char *text)
{
    Scene scene;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scene_open(&scene, words, &status), "%s", status.text);
    Lines lines = lines_of(&scene.canvas);
    int found = -1;
    for (int i = 0; i < lines.count; i++)
        if (strstr(lines.line[i], text))
            found = i;
    free(lines.text);
    scene_close(&scene);
    return found;
}

/* Switching USF and USL moves "strain and stress". */
START_TEST(strain_moves_in_the_list)
{
    static const char *const screens[] = {"mode1 100x30 400", "mode1 132x43 400",
                                          "mode1 80x24 400 focus 4 zoom"};
    for (size_t i = 0; i < 3; i++) {
        char words[128];
        snprintf(words, sizeof words, "%s stage 3", screens[i]);
        const int usf = line_with(words, "> 3 strain and stress");
        ck_assert_msg(usf > 0, "%s", words);
        snprintf(words, sizeof words, "%s stage 6 mpm.algorithm=usl", screens[i]);
        ck_assert_int_eq(line_with(words, "> 6 strain and stress"), usf + 3);
        snprintf(words, sizeof words, "%s stage 7 mpm.algorithm=musl", screens[i]);
        ck_assert_int_eq(line_with(words, "> 7 strain and stress"), usf + 4);
        ck_assert_int_eq(line_with(words, "  8 reset the grid"), usf + 5);
    }
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *sums = tcase_create("sums");
    tcase_add_test(sums, a_wrong_sum_is_seen);
    tcase_add_loop_test(sums, sums_of_a_bar_add_up, 0, BAR_VARIANTS);
    tcase_add_loop_test(sums, sums_of_a_wrong_bar_add_up, 0, 25);
    tcase_add_loop_test(sums, sums_of_a_beam_add_up, 0, 3);
    tcase_add_loop_test(sums, sums_of_a_beam_of_cells_add_up, 0, 6);
    tcase_add_loop_test(sums, sums_of_a_wrong_beam_add_up, 0, 11);
    tcase_add_loop_test(sums, columns_of_the_inspector_add_up, 0, 12);
    tcase_add_loop_test(sums, forces_of_bonds_add_up, 0, 2);
    tcase_add_loop_test(sums, no_box_is_cut, 0, sizeof everything / sizeof *everything);
    tcase_add_loop_test(sums, the_box_of_bodies_is_whole, 0, 2);
    tcase_add_test(sums, strain_moves_in_the_list);
    suite_add_tcase(suite, sums);
}
