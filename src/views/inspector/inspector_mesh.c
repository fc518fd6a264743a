/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The inspector of methods with particles and a grid: the chosen particle or node, the shape functions that
 * link it to the others, and what they give each other, stage by stage, with sums that a pencil can check. */
#include "views/inspector/inspector.h"
#include "base/text.h"
#include "panes/screen.h"
#include "views/view.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The thing that is inspected. */
typedef struct Subject {
    const Screen *screen;
    const Simulation *sim;
    int set;
    size_t index;
    Link links[TABLE_ROWS_MAX];
    size_t n_links;
    int shapes; /* columns of shape functions: N and its slope, or its two slopes in the plane */

    /* what one stage passes between it and its links */
    PictureTable *table;
    int stage;
    bool takes; /* the subject is the receiver */
} Subject;

static Subject subject_of(const Screen *screen)
{
    Subject subject = {.screen = screen, .sim = screen_simulation(screen), .set = screen->chosen.is_node};
    const size_t chosen = subject.set ? screen->chosen.node : screen->chosen.particle;
    const size_t count = subject.sim->counts[subject.set];
    subject.index = chosen < count ? chosen : count - 1;
    subject.shapes = simulation_has_map(subject.sim) ? 3 : 2;
    subject.n_links =
        subject.sim->method->links(subject.sim, subject.set, subject.index, subject.links, TABLE_ROWS_MAX);
    return subject;
}

/* --- what a stage passes on -------------------------------------------------------------------------- */

static ExchangeTerm term_of(const Subject *subject, int exchange, size_t link)
{
    return simulation_exchange(subject->sim, exchange, subject->index, &subject->links[link]);
}

static bool is_passed(const Subject *subject, int exchange)
{
    const Exchange *passed = &subject->sim->exchanges[exchange];
    return strcmp(passed->stage, subject->sim->stages[subject->stage].id) == 0 &&
           (subject->takes ? passed->to : passed->from) == subject->set && subject->n_links > 0 &&
           term_of(subject, exchange, 0).count > 0;
}

/* From here on it is about this stage and this way of passing. */
static bool passes_any(Subject *subject, int stage, bool takes)
{
    bool any = false;
    subject->stage = stage;
    subject->takes = takes;
    for (int e = 0; e < subject->sim->n_exchanges; e++)
        any |= is_passed(subject, e);
    return any;
}

static TableColumn *add_column(PictureTable *table, const char *name)
{
    if (table->n_columns == TABLE_COLUMNS_MAX)
        return NULL;
    TableColumn *column = &table->columns[table->n_columns++];
    snprintf(column->name, sizeof column->name, "%s", name);
    return column;
}

/* NULL: there is none. A slope counts as the slope's column whatever its sign. */
static TableColumn *factor_named(PictureTable *table, const char *name)
{
    const char *plain = name[0] == '-' ? name + 1 : name;
    for (int i = 0; i < table->n_columns; i++)
        if (!table->columns[i].adds && strcmp(table->columns[i].name, plain) == 0)
            return &table->columns[i];
    return NULL;
}

static void add_factors(const Subject *subject, int exchange)
{
    PictureTable *table = subject->table;
    const Exchange *passed = &subject->sim->exchanges[exchange];
    for (size_t i = 0; i < subject->n_links; i++) {
        const ExchangeTerm term = term_of(subject, exchange, i);
        const char *words = passed->factors;
        char word[32];
        for (int f = 0; f < term.count && text_next_word(&words, word, sizeof word); f++) {
            TableColumn *factor = factor_named(table, word);
            factor = factor ? factor : add_column(table, word);
            if (factor && !factor->stays)
                factor->values[i] = term.factors[f];
        }
    }
    if (passed->note && !strstr(table->notes, passed->note))
        text_append(table->notes, sizeof table->notes, "%s%s", *table->notes ? ", " : "", passed->note);
}

static void add_product(const Subject *subject, int exchange)
{
    PictureTable *table = subject->table;
    const Exchange *passed = &subject->sim->exchanges[exchange];
    const unsigned bit = 1u << table->n_columns;
    const int field = simulation_find_field(subject->sim, passed->to, passed->field);
    const char *words = passed->factors;
    char word[32];
    TableColumn *column = add_column(table, words);
    if (!column)
        return;
    column->adds = true;
    for (size_t i = 0; i < subject->n_links; i++)
        column->values[i] = term_of(subject, exchange, i).product;
    while (text_next_word(&words, word, sizeof word))
        if (factor_named(table, word))
            factor_named(table, word)->in |= bit;
    column->label = subject->sim->fields[field].quantity.label;
    column->brief = passed->field;
    /* What the field was before the stage, where that is added to, and what it is right after it. Of what is
     * given there is no sum at the giver; later stages may have changed what this one left. */
    double before = NAN;
    bool known = subject->takes && subject->sim->stage == subject->stage + 1;
    if (known && passed->adds)
        known = experiment_field_before(subject->screen->experiment, field, subject->index, 1, &before);
    column->base = known ? before : NAN;
    column->result = known ? simulation_value(subject->sim, field, subject->index) : NAN;
}

/* The stage and the way that passes_any() was asked for last. */
static void describe_block(Subject *subject, Picture *picture)
{
    PictureTable *table = subject->table = picture_table(picture);
    const Simulation *sim = subject->sim;
    const int other = 1 - subject->set, stage = subject->stage;
    const bool takes = subject->takes;
    if (!table)
        return;
    /* What is given to whom, in full or in short. */
    const char *next = sim->stage == 0 ? "next, " : "", *own = sim->sets[subject->set].name;
    const char *giver = takes ? sim->sets[other].plural : own, *taker = takes ? own : sim->sets[other].plural;
    snprintf(table->brief, sizeof table->brief, "%sstage %d: %s to %s", next, stage + 1, giver, taker);
    snprintf(table->title, sizeof table->title,
             takes ? "%sstage %d, %s: what its %s give to this %s"
                   : "%sstage %d, %s: what this %s gives to its %s",
             next, stage + 1, sim->stages[stage].name, giver, taker);
    table->what = sim->sets[other].name;
    table->of_directions = subject->shapes == 3;
    table->count = subject->n_links;
    for (size_t i = 0; i < table->count; i++) {
        table->rows[i].thing = (PictureThing){other, subject->links[i].index};
        snprintf(table->rows[i].name, sizeof table->rows[i].name, "%zu", subject->links[i].index);
    }
    static const char *const names[2][3] = {{"N", "N′"}, {"N", "N,x", "N,y"}};
    for (int s = 0; s < subject->shapes; s++) {
        TableColumn *column = add_column(table, names[subject->shapes == 3][s]);
        column->stays = true;
        for (size_t i = 0; i < subject->n_links; i++)
            column->values[i] = s == 0 ? subject->links[i].weight : subject->links[i].gradient[s - 1];
    }
    /* factors stand once, before all products that they are part of: these are read from left to right */
    for (int e = 0; e < sim->n_exchanges; e++)
        if (is_passed(subject, e))
            add_factors(subject, e);
    for (int e = 0; e < sim->n_exchanges; e++)
        if (is_passed(subject, e))
            add_product(subject, e);
    bool adds = false;
    for (int c = 0; c < table->n_columns; c++)
        adds |= table->columns[c].adds && !isnan(table->columns[c].base);
    table->totals[TOTAL_SUM] = (struct TableTotals){takes || subject->set == 0 ? "sum" : NULL, STYLE_CHANGED};
    table->totals[TOTAL_BASE] = (struct TableTotals){adds ? "it had" : NULL, STYLE_NORMAL};
    table->totals[TOTAL_RESULT] =
        (struct TableTotals){takes && sim->stage == stage + 1 ? "it has" : NULL, STYLE_CHANGED};
}

/* --- the whole ----------------------------------------------------------------------------------------- */

static void describe_masses(const Subject *subject, Picture *picture)
{
    MassRow row;
    PictureTable *table =
        inspector_mass_row(subject->sim, subject->set, subject->index, &row) ? picture_table(picture) : NULL;
    if (!table)
        return;
    table->what = subject->sim->sets[subject->set].name;
    table->count = row.count;
    table->own = subject->index - row.first;
    table->n_columns = 1;
    table->totals[TOTAL_SUM] = (struct TableTotals){"sum", STYLE_CHANGED};
    TableColumn *column = &table->columns[0];
    column->adds = true;
    column->base = column->result = NAN;
    snprintf(column->name, sizeof column->name, "M(%zu)", subject->index);
    for (size_t i = 0; i < row.count; i++) {
        column->values[i] = row.masses[i];
        table->rows[i].thing = (PictureThing){subject->set, row.first + i};
        snprintf(table->rows[i].name, sizeof table->rows[i].name, "%zu", row.first + i);
    }
}

static double named(const Subject *subject, const char *field)
{
    return simulation_named(subject->sim, subject->set, field, subject->index);
}

/* The latest stage (between steps what the first will do), then the subject's parts, then the rest. */
static void describe(const Screen *screen, Picture *picture)
{
    Subject subject = subject_of(screen);
    const Simulation *sim = subject.sim;
    const int latest = sim->stage > 0 ? sim->stage - 1 : 0;
    picture->kind = PICTURE_TABLES;
    /* "particle 25 at x = 12.5, in cell 12", "node 13 at x = 13, held by a support" */
    char text[96];
    const double cell = named(&subject, "cell");
    const char *held = named(&subject, "fixed") > 0 ? ", held by a support" : "";
    snprintf(text, sizeof text, "%s%s %zu at x = %s", screen_second_run(screen) ? "A: " : "",
             sim->sets[subject.set].name, subject.index, text_fitted(named(&subject, "x"), 6, 10).text);
    if (subject.shapes == 3)
        text_append(text, sizeof text, ", y = %s", text_fitted(named(&subject, "y"), 6, 10).text);
    snprintf(picture->brief, sizeof picture->brief, "%.70s%s", text, held);
    if (!isnan(cell))
        text_append(text, sizeof text, ", in cell %.0f", cell);
    picture_heading(picture, "%s%s", text, held);
    snprintf(picture->hints[0], sizeof picture->hints[0], " ← → next  ↑ ↓ node or particle  i closes ");
    snprintf(picture->hints[1], sizeof picture->hints[1], " ← → next  ↑ node  i closes ");
    if (subject.n_links == 0)
        picture_note(picture, STYLE_NORMAL, "no particle is near: this node is empty");
    else if (sim->stage > 0 && !passes_any(&subject, latest, true) && !passes_any(&subject, latest, false))
        picture_note(
            picture, STYLE_NORMAL,
            LONG_SHORT("stage %d, %s: no particle-node exchange", "stage %d: no exchange") "; before that:",
            sim->stage, sim->stages[latest].name, sim->stage);
    for (int pass = 0; pass < 2; pass++)
        for (int stage = latest; stage >= 0; stage--)
            for (int takes = 1; takes >= 0; takes--) {
                /* what a node gives to particles at an earlier stage says least: it stands at the end */
                const bool first = stage == latest || takes || subject.set == 0;
                if (first != (pass == 0) || !passes_any(&subject, stage, takes))
                    continue;
                describe_block(&subject, picture);
                if (picture->n_tables == 1)
                    describe_masses(&subject, picture);
            }
}

/* Left and right: the next thing; up: the node that the particle shares most with, down: the particle. */
static void move_on(Screen *screen, int x, int y, int page)
{
    const Subject subject = subject_of(screen);
    if (x != 0 || page > 1) {
        selection_next(&screen->chosen, subject.sim, x != 0 ? x : y, (size_t)page);
        return;
    }
    /* nodes stand above particles: there is nothing further up or down */
    if ((y < 0) == screen->chosen.is_node)
        return;
    size_t nearest = 0;
    for (size_t i = 1; i < subject.n_links; i++)
        if (subject.links[i].weight > subject.links[nearest].weight)
            nearest = i;
    if (subject.n_links > 0)
        *(subject.set ? &screen->chosen.particle : &screen->chosen.node) = subject.links[nearest].index;
    screen->chosen.is_node = y < 0;
}

const Inspector inspector_mesh = {.needs = HAS_MESH, .describe = describe, .move = move_on};

/* A node's row of the mass matrix, where masses are not lumped: what it shares with the nodes beside it. */

/* M is symmetric: M(i, i - d) is given with node i - d. False: there is no such matrix, or not yet. */
bool inspector_mass_row(const Simulation *sim, int set, size_t node, MassRow *row)
{
    static const char *const names[MASSES_BESIDE_MAX + 1] = {"mass_0", "mass_1", "mass_2", "mass_3"};
    size_t reach = 0;
    while (reach < MASSES_BESIDE_MAX && simulation_find_field(sim, set, names[reach + 1]) >= 0)
        reach++;
    if (!(simulation_named(sim, set, names[0], node) > 0))
        return false;
    row->first = node > reach ? node - reach : 0;
    row->count = 0;
    for (size_t j = row->first; j <= node + reach && j < sim->counts[set]; j++) {
        const size_t apart = j > node ? j - node : node - j;
        row->masses[row->count++] = simulation_named(sim, set, names[apart], j < node ? j : node);
    }
    return true;
}

/* --- which inspector a simulation has: the first that fits --------------------------------------------- */

static const Inspector *const inspectors[] = {&inspector_mesh, &inspector_bonds, &inspector_family};

const Inspector *inspector_find(const Screen *screen)
{
    const Simulation *sim = screen_simulation(screen);
    for (size_t i = 0; i < sizeof inspectors / sizeof *inspectors; i++)
        if (simulation_has(sim, inspectors[i]->needs))
            return inspectors[i];
    return NULL;
}

bool inspector_move(Screen *screen, int x, int y, int page)
{
    const Inspector *inspector = inspector_find(screen);
    if (inspector)
        inspector->move(screen, x, y, page);
    return inspector != NULL;
}

static void describe_any(const Screen *screen, int variant, Picture *picture)
{
    (void)variant;
    if (inspector_find(screen))
        inspector_find(screen)->describe(screen, picture);
}

const View view_inspector = {
    .word = "inspector",
    .describe = describe_any,
    .duel = DUEL_TOGETHER,
    .is_list = true,
};
