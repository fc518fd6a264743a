/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The inspector of methods with particles and a grid: the chosen particle or node, the shape functions that
 * link it to the others, and what they give each other, stage by stage, with sums that a pencil can check. */
#include "views/inspector/inspector.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    LINKS_MAX = 64,
    BLOCK_COLUMNS_MAX = 10,
    INDEX_WIDTH = 9,
    FACTOR_WIDTH_MAX = 12,
    PRODUCT_WIDTH = 12,
    FACTOR_WIDTH_LEAST = 6,
    MASSES_FROM = 9,     /* rows, for a node's row of the mass matrix below */
    LEAST_FOR_CELL = 60, /* columns; on fewer the cell is left out of the heading */
    HEAD_ROWS = 3 /* of a block: what it is, fields, formulas; and a row of scales where there are any */
};

/* The thing that is inspected. */
typedef struct Subject {
    const Simulation *sim;
    int set;
    size_t index;
    Link links[LINKS_MAX];
    size_t n_links;
    int shapes; /* columns of shape functions: N and its slope, or its two slopes in the plane */
} Subject;

/* One column of a block: a factor, or the product of an exchange. */
typedef struct BlockColumn {
    char name[32];
    int exchange; /* of a product; -1: a factor */
    double values[LINKS_MAX];
} BlockColumn;

/* What one stage passes between the subject and its links. */
typedef struct Block {
    int stage;
    bool takes; /* the subject is the receiver */
    BlockColumn columns[BLOCK_COLUMNS_MAX];
    int n_columns;
    int factor_width;
    char notes[100]; /* what factors stand for */
} Block;

static Subject subject_of(const Screen *screen)
{
    Subject subject = {.sim = experiment_simulation(screen->experiment), .set = screen->chosen.is_node};
    const size_t chosen = subject.set ? screen->chosen.node : screen->chosen.particle;
    const size_t count = subject.sim->counts[subject.set];
    subject.index = chosen < count ? chosen : count - 1;
    subject.shapes = simulation_has(subject.sim, HAS_PLANE) ? 3 : 2;
    subject.n_links =
        subject.sim->method->links(subject.sim, subject.set, subject.index, subject.links, LINKS_MAX);
    return subject;
}

/* --- what a block holds --------------------------------------------------------------------------- */

/* The column of that name, made if there is none; -1: there is no room. A slope counts as the slope's column
 * whatever its sign. */
static int column_named(Block *block, const char *name)
{
    for (int i = 0; i < block->n_columns; i++)
        if (block->columns[i].exchange < 0 &&
            strcmp(block->columns[i].name, name[0] == '-' ? name + 1 : name) == 0)
            return i;
    if (block->n_columns == BLOCK_COLUMNS_MAX)
        return -1;
    BlockColumn *column = &block->columns[block->n_columns];
    *column = (BlockColumn){.exchange = -1};
    snprintf(column->name, sizeof column->name, "%s", name);
    return block->n_columns++;
}

static int exchange_factors(const Subject *subject, int exchange, size_t link,
                            double factors[EXCHANGE_FACTORS_MAX])
{
    const size_t other = subject->links[link].index;
    const bool takes = subject->sim->exchanges[exchange].to == subject->set;
    return subject->sim->method->exchange(subject->sim, exchange, takes ? other : subject->index,
                                          takes ? subject->index : other, factors);
}

/* Adds an exchange's factors or, with `product`, what they come to. */
static void add_exchange(Block *block, const Subject *subject, int exchange, const char *words, bool product)
{
    double factors[EXCHANGE_FACTORS_MAX];
    int column = -1;
    if (product && block->n_columns < BLOCK_COLUMNS_MAX) {
        column = block->n_columns++;
        block->columns[column] = (BlockColumn){.exchange = exchange};
        snprintf(block->columns[column].name, sizeof block->columns[column].name, "%s", words);
    }
    for (size_t i = 0; i < subject->n_links; i++) {
        const int n_factors = exchange_factors(subject, exchange, i, factors);
        const char *rest = words;
        char word[32];
        double value = 1;
        for (int f = 0; f < n_factors && text_next_word(&rest, word, sizeof word); f++) {
            value *= factors[f];
            const int at = product ? -1 : column_named(block, word);
            if (at >= subject->shapes) /* the first ones are the shape functions */
                block->columns[at].values[i] = factors[f];
        }
        if (column >= 0)
            block->columns[column].values[i] = n_factors > 0 ? value : 0;
    }
}

/* A block of all exchanges of the stage, or of one alone; false: nothing is exchanged. */
static bool fill_block(Block *block, const Subject *subject, int stage, bool takes, bool ascii, int only)
{
    const Simulation *sim = subject->sim;
    *block = (Block){.stage = stage, .takes = takes};
    static const char *const in_plane[] = {"N", "N,x", "N,y"};
    const char *const on_line[] = {"N", ascii ? "N'" : "N′"};
    for (int s = 0; s < subject->shapes; s++) {
        BlockColumn *column =
            &block->columns[column_named(block, subject->shapes == 3 ? in_plane[s] : on_line[s])];
        for (size_t i = 0; i < subject->n_links; i++)
            column->values[i] = s == 0 ? subject->links[i].weight : subject->links[i].gradient[s - 1];
    }
    bool any = false;
    for (int pass = 0; pass < 2; pass++)
        for (int e = 0; e < sim->n_exchanges; e++) {
            const Exchange *exchange = &sim->exchanges[e];
            if (only >= 0 && e != only)
                continue;
            double factors[EXCHANGE_FACTORS_MAX];
            if (strcmp(exchange->stage, sim->stages[stage].id) != 0 ||
                (takes ? exchange->to : exchange->from) != subject->set || subject->n_links == 0 ||
                exchange_factors(subject, e, 0, factors) == 0)
                continue;
            add_exchange(block, subject, e, ascii ? exchange->ascii : exchange->factors, pass == 1);
            if (exchange->note && !strstr(block->notes, exchange->note))
                text_append(block->notes, sizeof block->notes, "%s%s", *block->notes ? ", " : "",
                            exchange->note);
            any = true;
        }
    return any;
}

static void share_width(Block *block, int width)
{
    int products = 0;
    for (int i = 0; i < block->n_columns; i++)
        products += block->columns[i].exchange >= 0;
    const int factors = block->n_columns - products;
    block->factor_width = factors > 0 ? (width - INDEX_WIDTH - products * PRODUCT_WIDTH) / factors : 0;
    if (block->factor_width > FACTOR_WIDTH_MAX)
        block->factor_width = FACTOR_WIDTH_MAX;
}

/* Shape functions that the products do not hold. */
static void drop_unused(Block *block, int shapes)
{
    for (int i = shapes - 1; i >= 0; i--) {
        bool used = false;
        for (int c = shapes; c < block->n_columns; c++) {
            const char *words = block->columns[c].exchange >= 0 ? block->columns[c].name : "";
            char word[32];
            while (text_next_word(&words, word, sizeof word))
                used |= strcmp(word[0] == '-' ? word + 1 : word, block->columns[i].name) == 0;
        }
        if (!used)
            memmove(&block->columns[i], &block->columns[i + 1],
                    (size_t)(--block->n_columns - i) * sizeof block->columns[0]);
    }
}

/* All columns but N and the products. */
static void drop_factors(Block *block)
{
    int kept = 1;
    for (int c = 1; c < block->n_columns; c++)
        if (block->columns[c].exchange >= 0)
            block->columns[kept++] = block->columns[c];
    block->n_columns = kept;
}

/* Fills what a stage passes on in one direction; false: nothing. Where there is no room for all the products,
 * the one with most factors stands alone. */
static bool make_block(Block *block, const Subject *subject, int stage, bool takes, bool ascii, int width)
{
    if (!fill_block(block, subject, stage, takes, ascii, -1))
        return false;
    share_width(block, width);
    if (block->factor_width >= FACTOR_WIDTH_LEAST)
        return true;
    /* in the plane all directions come before the factors */
    if (subject->shapes == 3) {
        drop_factors(block);
        share_width(block, width);
        if (block->factor_width >= FACTOR_WIDTH_LEAST)
            return true;
    }
    const BlockColumn *longest = NULL;
    for (int c = 0; c < block->n_columns; c++)
        if (block->columns[c].exchange >= 0 &&
            (!longest || glyphs_columns(block->columns[c].name) > glyphs_columns(longest->name)))
            longest = &block->columns[c];
    if (!longest)
        return true;
    fill_block(block, subject, stage, takes, ascii, longest->exchange);
    share_width(block, width);
    if (block->factor_width < FACTOR_WIDTH_LEAST)
        drop_unused(block, subject->shapes);
    share_width(block, width);
    return true;
}

/* --- drawing -------------------------------------------------------------------------------------- */

static double sum_of(const BlockColumn *column, size_t first, size_t end)
{
    double sum = 0;
    for (size_t i = first; i < end; i++)
        sum += column->values[i];
    return sum;
}

/* Where the columns of a block end. */
static int column_end(const Block *block, int column)
{
    int end = INDEX_WIDTH;
    for (int i = 0; i <= column; i++)
        end += block->columns[i].exchange < 0 ? block->factor_width : PRODUCT_WIDTH;
    return end - 1;
}

static const Exchange *exchange_of(const Subject *subject, const BlockColumn *column)
{
    return &subject->sim->exchanges[column->exchange];
}

static bool just_done(const Subject *subject, const Block *block)
{
    return subject->sim->stage == block->stage + 1;
}

/* What the field of a product column was before the stage; 0 where the products make it anew. False: not
 * known. */
static bool base_of(const Experiment *experiment, const Subject *subject, const Block *block,
                    const BlockColumn *column, double *base)
{
    const Exchange *exchange = exchange_of(subject, column);
    *base = 0;
    if (!block->takes || !just_done(subject, block))
        return false;
    return !exchange->adds ||
           experiment_field_before(experiment,
                                   simulation_find_field(subject->sim, exchange->to, exchange->field),
                                   subject->index, 1, base);
}

/* The rows of a block: the links that are written one by one, then one for the others, then the sums. */
typedef struct Plan {
    size_t shown, all;
    bool scaled; /* a product column has a power of ten in its head */
    bool adds;   /* a product is added to what was there: "it had" */
    int totals;
    Writing writings[BLOCK_COLUMNS_MAX];
    double bases[BLOCK_COLUMNS_MAX];
    bool known[BLOCK_COLUMNS_MAX];
} Plan;

static double terms_of(const BlockColumn *column, const Plan *plan, double terms[LINKS_MAX + 1],
                       size_t *count)
{
    memcpy(terms, column->values, sizeof column->values);
    *count = plan->shown;
    if (plan->shown < plan->all)
        terms[(*count)++] = sum_of(column, plan->shown, plan->all);
    return sum_of(column, 0, plan->all);
}

static Plan plan_of(const Experiment *experiment, const Subject *subject, const Block *block, int rows)
{
    Plan plan = {.all = subject->n_links, .shown = subject->n_links};
    double terms[LINKS_MAX + 1];
    size_t count;
    for (int pass = 0; pass < 2; pass++) {
        for (int c = 0; c < block->n_columns; c++) {
            const BlockColumn *column = &block->columns[c];
            if (column->exchange < 0)
                continue;
            plan.known[c] = base_of(experiment, subject, block, column, &plan.bases[c]);
            plan.adds |= plan.known[c] && exchange_of(subject, column)->adds;
            const double sum = terms_of(column, &plan, terms, &count);
            plan.writings[c] = writing_of(terms, count, plan.bases[c], sum, PRODUCT_WIDTH - 1);
            plan.scaled |= plan.writings[c].exponent != 0;
        }
        plan.totals = block->takes ? 1 + just_done(subject, block) + plan.adds : subject->set == 0;
        const int room = rows - HEAD_ROWS - plan.scaled - plan.totals;
        if ((int)plan.all <= room)
            break;
        plan.shown = room > 1 ? (size_t)room - 1 : 0;
    }
    return plan;
}

static int block_rows(const Plan *plan)
{
    return HEAD_ROWS + plan->scaled + (int)plan->shown + (plan->shown < plan->all) + plan->totals;
}

/* What is given to whom, in full or in short. */
static void title_of(const Subject *subject, const Block *block, bool in_full, char out[200])
{
    const Simulation *sim = subject->sim;
    const Set *other = &sim->sets[1 - subject->set], *own = &sim->sets[subject->set];
    const char *next = sim->stage == 0 ? "next, " : "";
    if (!in_full)
        snprintf(out, 200, "%sstage %d: %s to %s", next, block->stage + 1,
                 block->takes ? other->plural : own->name, block->takes ? own->name : other->plural);
    else if (block->takes)
        snprintf(out, 200, "%sstage %d, %s: what its %s give to this %s", next, block->stage + 1,
                 sim->stages[block->stage].name, other->plural, own->name);
    else
        snprintf(out, 200, "%sstage %d, %s: what this %s gives to its %s", next, block->stage + 1,
                 sim->stages[block->stage].name, own->name, other->plural);
}

/* Names the columns; returns where the first label above them begins. */
static int draw_columns_head(const Subject *subject, Area area, const Block *block, const Plan *plan, int y)
{
    const Simulation *sim = subject->sim;
    const int formulas = y + 1 + plan->scaled;
    int begin = area.rect.width;
    char text[16];
    area_text_right(area, INDEX_WIDTH - 1, formulas, sim->sets[1 - subject->set].name, STYLE_HEADING);
    bool beside_factors = true; /* where a long label has room */
    for (int c = 0; c < block->n_columns; c++) {
        const BlockColumn *column = &block->columns[c];
        const int end = column_end(block, c);
        area_text_right(area, end, formulas, column->name, STYLE_HEADING);
        if (column->exchange < 0)
            continue;
        const Exchange *exchange = exchange_of(subject, column);
        const char *label =
            sim->fields[simulation_find_field(sim, exchange->to, exchange->field)].quantity.label;
        if (!beside_factors && glyphs_columns(label) >= PRODUCT_WIDTH)
            label = exchange->field;
        area_text_right(area, end, y, label, STYLE_HEADING);
        begin = beside_factors ? end - glyphs_columns(label) : begin;
        beside_factors = false;
        snprintf(text, sizeof text, "x10^%d", plan->writings[c].exponent);
        if (plan->writings[c].exponent != 0)
            area_text_right(area, end, y + 1, text, STYLE_HEADING);
    }
    return begin;
}

/* What factors stand for stands before the labels or, where there is no room for all of it, behind a short
 * title. */
static void draw_head(const Subject *subject, Area area, const Block *block, const Plan *plan, int y)
{
    char title[200];
    const int width = area.rect.width, notes = glyphs_columns(block->notes);
    const bool before = 1 + notes < draw_columns_head(subject, area, block, plan, y + 1);
    title_of(subject, block, true, title);
    if (1 + glyphs_columns(title) > width || !before)
        title_of(subject, block, false, title);
    const int end = 1 + area_text(area, 1, y, title, STYLE_HEADING) + 2;
    if (before)
        area_text(area, 1, y + 1, block->notes, STYLE_FAINT);
    else if (end + notes < width)
        area_text(area, end, y, block->notes, STYLE_FAINT);
}

/* The rows under a product column: its sum and, right after the stage, the field that it makes. */
static void draw_totals(const Subject *subject, Area area, const Block *block, const Plan *plan, int c, int y)
{
    const BlockColumn *column = &block->columns[c];
    const Exchange *exchange = exchange_of(subject, column);
    const Writing writing = plan->writings[c];
    const int end = column_end(block, c),
              field = simulation_find_field(subject->sim, exchange->to, exchange->field);
    const bool based = plan->bases[c] != 0;
    inspector_write(area, end, y++, sum_of(column, 0, plan->all), writing,
                    based ? writing.decimals : writing.sum_decimals, STYLE_CHANGED);
    if (!plan->known[c])
        return;
    if (exchange->adds)
        inspector_write(area, end, y, plan->bases[c], writing,
                        based ? writing.decimals : writing.sum_decimals, STYLE_NORMAL);
    y += plan->adds;
    inspector_write(area, end, y, simulation_value(subject->sim, field, subject->index), writing,
                    writing.sum_decimals, STYLE_CHANGED);
}

static void draw_block(const Subject *subject, Area area, const Block *block, const Plan *plan, int y)
{
    draw_head(subject, area, block, plan, y);
    y += HEAD_ROWS + plan->scaled;
    const int totals = y + (int)plan->shown + (plan->shown < plan->all);
    for (size_t i = 0; i < plan->shown; i++) {
        char text[NUMBER_TEXT_MAX];
        snprintf(text, sizeof text, "%zu", subject->links[i].index);
        area_text_right(area, INDEX_WIDTH - 1, y + (int)i, text, STYLE_NORMAL);
    }
    if (plan->shown < plan->all)
        area_print(area, 1, totals - 1, STYLE_FAINT, "%zu more", plan->all - plan->shown);
    if (plan->totals > 0)
        area_text_right(area, INDEX_WIDTH - 1, totals, "sum", STYLE_HEADING);
    if (plan->totals > 1 && plan->adds)
        area_text_right(area, INDEX_WIDTH - 1, totals + 1, "it had", STYLE_HEADING);
    if (plan->totals > 1)
        area_text_right(area, INDEX_WIDTH - 1, totals + 1 + plan->adds, "it has", STYLE_HEADING);
    for (int c = 0; c < block->n_columns; c++) {
        const BlockColumn *column = &block->columns[c];
        const int end = column_end(block, c);
        if (column->exchange < 0) {
            char text[NUMBER_TEXT_MAX];
            const Format format = format_of(column->values, plan->shown, 6, block->factor_width - 1);
            for (size_t i = 0; i < plan->shown; i++) {
                format_number(column->values[i], format, text);
                area_text_right(area, end, y + (int)i, text, STYLE_NORMAL);
            }
            continue;
        }
        double terms[LINKS_MAX + 1];
        size_t count;
        terms_of(column, plan, terms, &count);
        for (size_t i = 0; i < count; i++)
            inspector_write(area, end, y + (int)i, terms[i], plan->writings[c], plan->writings[c].decimals,
                            i < plan->shown ? STYLE_NORMAL : STYLE_FAINT);
        if (plan->totals > 0)
            draw_totals(subject, area, block, plan, c, totals);
    }
}

/* "particle 25 in cell 12", "node 13, held by a support". */
static void draw_subject(const Screen *screen, const Subject *subject, Area area)
{
    const Simulation *sim = subject->sim;
    char text[128], number[NUMBER_TEXT_MAX];
    const int x = simulation_find_field(sim, subject->set, "x"),
              cell = simulation_find_field(sim, subject->set, "cell");
    const int fixed = simulation_find_field(sim, subject->set, "fixed");
    text_fitted(simulation_value(sim, x, subject->index), 6, 10, number);
    snprintf(text, sizeof text, "%s%s %zu at x = %s", screen_second_run(screen) ? "A: " : "",
             sim->sets[subject->set].name, subject->index, number);
    if (subject->shapes == 3) {
        text_fitted(simulation_value(sim, simulation_find_field(sim, subject->set, "y"), subject->index), 6,
                    10, number);
        text_append(text, sizeof text, ", y = %s", number);
    }
    if (cell >= 0 && area.rect.width >= LEAST_FOR_CELL)
        text_append(text, sizeof text, ", in cell %.0f", simulation_value(sim, cell, subject->index));
    if (fixed >= 0 && simulation_value(sim, fixed, subject->index) > 0)
        text_append(text, sizeof text, ", held by a support");
    area_rule(area, 0, text, screen_is_focused(screen, PANE_INSPECTOR) ? STYLE_FOCUS : STYLE_HEADING);
    const int begin = 5 + glyphs_columns(text), end = area.rect.width - 1;
    if (!heading_hint(area, begin, end, " ← → next  ↑ ↓ node or particle  i closes "))
        heading_hint(area, begin, end, " ← → next  ↑ node  i closes ");
}

/* Whether a stage passes anything between the subject and its links. */
static bool passes_on(const Subject *subject, int stage)
{
    Block block;
    return make_block(&block, subject, stage, true, false, INDEX_WIDTH) ||
           make_block(&block, subject, stage, false, false, INDEX_WIDTH);
}

static void draw(const Screen *screen, Area area)
{
    const Subject subject = subject_of(screen);
    const Simulation *sim = subject.sim;
    draw_subject(screen, &subject, area);
    if (subject.n_links == 0) {
        area_text(area, 1, 1, "no particle is near: this node is empty", STYLE_NORMAL);
        return;
    }
    /* The latest stage first (between steps what the first stage will do), then what the subject is made of,
     * then what else is still at hand, as far as there is room for a whole one. */
    const int latest = sim->stage > 0 ? sim->stage - 1 : 0;
    int y = 1;
    if (sim->stage > 0 && !passes_on(&subject, latest))
        y += area_print(area, 1, y, STYLE_NORMAL,
                        "stage %d, %s: nothing is passed on; before that:", sim->stage,
                        sim->stages[latest].name) > 0;
    MassRow masses;
    const bool weighs =
        area.rect.height >= MASSES_FROM && inspector_mass_row(sim, subject.set, subject.index, &masses);
    const int height = area.rect.height - (weighs ? MASSES_ROWS : 0); /* of the blocks */
    bool drawn = false;
    for (int pass = 0; pass < 2; pass++)
        for (int stage = latest; stage >= 0; stage--)
            for (int takes = 1; takes >= 0; takes--) {
                const bool first = stage == latest || takes || subject.set == 0;
                Block block;
                if (first != (pass == 0) || !make_block(&block, &subject, stage, takes,
                                                        screen->look.glyphs == GLYPHS_ASCII, area.rect.width))
                    continue;
                const int begin = y > 1 ? y + 1 : y;
                const Plan plan = plan_of(screen->experiment, &subject, &block, height - begin);
                if (begin > 1 && ((drawn && plan.shown < plan.all) || begin + block_rows(&plan) > height))
                    continue;
                draw_block(&subject, area, &block, &plan, begin);
                y = begin + block_rows(&plan);
                drawn = true;
            }
    if (weighs)
        inspector_draw_masses(&masses, sim->sets[subject.set].name, subject.index, area,
                              y < height ? y + 1 : height);
}

/* Left and right: the next thing; up: the node that the particle shares most with, down: the particle. */
static void move_on(Screen *screen, int x, int y, int page)
{
    const Subject subject = subject_of(screen);
    const size_t count = subject.sim->counts[subject.set];
    if (x != 0 || page > 1) {
        const long to = (long)subject.index + (x != 0 ? x : y) * (long)page;
        *(subject.set ? &screen->chosen.node : &screen->chosen.particle) = to < 0             ? 0
                                                                           : to < (long)count ? (size_t)to
                                                                                              : count - 1;
        return;
    }
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

const Inspector inspector_mesh = {.needs = HAS_MESH, .draw = draw, .move = move_on};
