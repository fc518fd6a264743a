/* The inspector of methods with particles and a grid: the chosen particle or node, the shape functions that
 * link it to the others, and what they give each other, stage by stage, with sums that a pencil can check. */
#include "view/panes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    LINKS_MAX = 64,
    BLOCK_COLUMNS_MAX = 10,
    INDEX_WIDTH = 9,
    FACTOR_WIDTH_MAX = 12,
    PRODUCT_WIDTH = 12,
    HEAD_ROWS = 3 /* of a block: what it is, fields, formulas */
};

/* The thing that is inspected. */
typedef struct Subject {
    const Simulation *sim;
    int set;
    size_t index;
    Link links[LINKS_MAX];
    size_t n_links;
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
    const char *note;
} Block;

static Subject subject_of(const Screen *screen)
{
    Subject subject = {.sim = experiment_simulation(screen->experiment), .set = screen->node_chosen};
    const size_t chosen = subject.set ? screen->node : screen->particle;
    const size_t count = subject.sim->counts[subject.set];
    subject.index = chosen < count ? chosen : count - 1;
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
        for (int f = 0; f < n_factors && next_word(&rest, word, sizeof word); f++) {
            value *= factors[f];
            const int at = product ? -1 : column_named(block, word);
            if (at >= 2) /* the first two are the shape functions */
                block->columns[at].values[i] = factors[f];
        }
        if (column >= 0)
            block->columns[column].values[i] = n_factors > 0 ? value : 0;
    }
}

/* Fills what a stage passes on in one direction; false: nothing. */
static bool make_block(Block *block, const Subject *subject, int stage, bool takes, bool ascii, int width)
{
    const Simulation *sim = subject->sim;
    *block = (Block){.stage = stage, .takes = takes};
    const int n = column_named(block, "N"), slope = column_named(block, ascii ? "N'" : "N′");
    for (size_t i = 0; i < subject->n_links; i++) {
        block->columns[n].values[i] = subject->links[i].weight;
        block->columns[slope].values[i] = subject->links[i].gradient;
    }
    bool any = false;
    for (int pass = 0; pass < 2; pass++)
        for (int e = 0; e < sim->n_exchanges; e++) {
            const Exchange *exchange = &sim->exchanges[e];
            double factors[EXCHANGE_FACTORS_MAX];
            if (strcmp(exchange->stage, sim->stages[stage].id) != 0 ||
                (takes ? exchange->to : exchange->from) != subject->set || subject->n_links == 0 ||
                exchange_factors(subject, e, 0, factors) == 0)
                continue;
            add_exchange(block, subject, e, ascii ? exchange->ascii : exchange->factors, pass == 1);
            block->note = exchange->note ? exchange->note : block->note;
            any = true;
        }
    int products = 0;
    for (int i = 0; i < block->n_columns; i++)
        products += block->columns[i].exchange >= 0;
    if (block->n_columns > products)
        block->factor_width =
            (width - INDEX_WIDTH - products * PRODUCT_WIDTH) / (block->n_columns - products);
    if (block->factor_width > FACTOR_WIDTH_MAX)
        block->factor_width = FACTOR_WIDTH_MAX;
    return any;
}

/* --- a column that adds up ------------------------------------------------------------------------ */

/* How a column of products is written: times 10^exponent, with so many decimals, that the printed terms give
 * the printed sum. */
typedef struct Writing {
    int exponent;
    int decimals, sum_decimals;
} Writing;

static double rounded(double value, int decimals)
{
    char text[64];
    snprintf(text, sizeof text, "%.*f", decimals, value);
    double back = 0;
    sscanf(text, "%lf", &back);
    return back == 0 ? 0 : back;
}

/* Whether the terms as printed are the gain as printed, and base and gain the sum. */
static bool adds_up(const double *terms, size_t n, double base, double gain, double scale, Writing writing)
{
    const double half = 0.5 * pow(10, -writing.sum_decimals) * (1 + 1e-9);
    const double said = rounded(gain * scale, writing.sum_decimals);
    double total = 0;
    for (size_t i = 0; i < n; i++)
        total += rounded(terms[i] * scale, writing.decimals);
    return fabs(total - said) < half && fabs(rounded(base * scale, writing.sum_decimals) + said -
                                             rounded((base + gain) * scale, writing.sum_decimals)) < half;
}

enum { NUMBER_COLUMNS = PRODUCT_WIDTH - 1, DIGITS = 5 };

/* The columns that a number takes before its decimals: sign, digits, point. */
static int columns_before(double value)
{
    const double size = fabs(value);
    return (value < 0) + (size < 10 ? 1 : (int)floor(log10(size)) + 1) + 1;
}

static int larger(int a, int b)
{
    return a > b ? a : b;
}

/* `gain` is the sum of the terms; with a base it is the gain that must be readable. */
static Writing writing_of(const double *terms, size_t n, double base, double gain)
{
    const double sum = base + gain;
    double most = fmax(fabs(base), fabs(sum));
    for (size_t i = 0; i < n; i++)
        most = fmax(most, fabs(terms[i]));
    Writing writing = {0, DIGITS, DIGITS};
    if (!(most > 0))
        return (Writing){0, 0, 0};
    const int magnitude = (int)floor(log10(most));
    if (magnitude < -3 || magnitude > 3)
        writing.exponent = 3 * (int)floor(magnitude / 3.0);
    const double scale = pow(10, -writing.exponent);
    int before = larger(columns_before(base * scale), columns_before(sum * scale));
    before = larger(before, columns_before(gain * scale));
    for (size_t i = 0; i < n; i++)
        before = larger(before, columns_before(terms[i] * scale));
    const int room = NUMBER_COLUMNS - before;
    const double least = fabs(gain) > 0 ? fabs(gain) : most;
    int wanted = DIGITS - 1 - (int)floor(log10(least * scale));
    wanted = wanted < room ? wanted : room;
    for (int sum_decimals = wanted; sum_decimals >= 0; sum_decimals--)
        for (int decimals = sum_decimals; decimals <= room; decimals++) {
            writing.decimals = decimals;
            writing.sum_decimals = sum_decimals;
            if (adds_up(terms, n, base, gain, scale, writing))
                return writing;
        }
    return writing;
}

static void write_number(Area area, int end, int y, double value, Writing writing, int decimals, Style style)
{
    char text[64];
    const double scaled = value * pow(10, -writing.exponent);
    snprintf(text, sizeof text, "%.*f", decimals, rounded(scaled, decimals));
    /* the points stand under each other */
    int shift = writing.decimals - decimals;
    shift += decimals == 0 && writing.decimals > 0;
    area_text_right(area, end - shift, y, text, style);
}

/* --- drawing -------------------------------------------------------------------------------------- */

static double field_value(const Simulation *sim, int field, size_t index)
{
    double value = NAN;
    sim->method->field(sim, field, index, 1, &value);
    return value;
}

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

static void draw_block_head(const Subject *subject, Area area, const Block *block, int *y)
{
    const Simulation *sim = subject->sim;
    const Set *other = &sim->sets[1 - subject->set], *own = &sim->sets[subject->set];
    const bool to_come = sim->stage <= block->stage && sim->stage == 0;
    char text[200];
    snprintf(text, sizeof text, "%sstage %d, %s: what ", to_come ? "next, " : "", block->stage + 1,
             sim->stages[block->stage].name);
    if (block->takes)
        append(text, sizeof text, "its %s give to this %s", other->plural, own->name);
    else
        append(text, sizeof text, "this %s gives to its %s", own->name, other->plural);
    if (block->note)
        append(text, sizeof text, "  (%s)", block->note);
    area_phrases(area, 1, *y, area.rect.width - 2, 1, text, STYLE_HEADING);
    area_text_right(area, INDEX_WIDTH - 1, *y + 2, other->name, STYLE_HEADING);
    for (int c = 0; c < block->n_columns; c++) {
        const BlockColumn *column = &block->columns[c];
        area_text_right(area, column_end(block, c), *y + 2, column->name, STYLE_HEADING);
        if (column->exchange < 0)
            continue;
        const Exchange *exchange = &sim->exchanges[column->exchange];
        const int field = stage_field(sim, exchange->to, exchange->field);
        const char *label = sim->fields[field].quantity.label;
        const int end = column_end(block, c), columns = text_columns(label);
        /* over the factors there is room */
        area_text_right(area_part(area, end - larger(columns, PRODUCT_WIDTH - 1), *y + 1, area.rect.width, 1),
                        larger(columns, PRODUCT_WIDTH - 1), 0, label, STYLE_HEADING);
    }
    *y += HEAD_ROWS;
}

/* The rows under a product column: its sum, and the field that it makes. */
static void draw_total(const Subject *subject, Area area, const Block *block, int c, int y, Writing writing,
                       double base, bool known)
{
    const Simulation *sim = subject->sim;
    const BlockColumn *column = &block->columns[c];
    const Exchange *exchange = &sim->exchanges[column->exchange];
    const int end = column_end(block, c), field = stage_field(sim, exchange->to, exchange->field);
    const double sum = sum_of(column, 0, subject->n_links);
    write_number(area, end, y, sum, writing, writing.sum_decimals, STYLE_CHANGED);
    if (!block->takes || !known)
        return;
    const double now = field_value(sim, field, subject->index);
    if (exchange->adds)
        write_number(area, end, y + 1, base, writing, writing.sum_decimals, STYLE_NORMAL);
    write_number(area, end, y + 1 + exchange->adds, now, writing, writing.sum_decimals, STYLE_CHANGED);
}

static int draw_block(const Screen *screen, const Subject *subject, Area area, const Block *block, int y)
{
    const Simulation *sim = subject->sim;
    const bool sums = block->takes || subject->set == 0;
    const bool just_done = sim->stage == block->stage + 1;
    bool adds = false;
    for (int c = 0; c < block->n_columns; c++)
        if (block->columns[c].exchange >= 0)
            adds |= sim->exchanges[block->columns[c].exchange].adds && block->takes;
    const int totals = sums + (block->takes && just_done ? 1 + adds : 0);
    draw_block_head(subject, area, block, &y);
    int room = area.rect.height - y - totals;
    const size_t all = subject->n_links;
    const size_t shown = all <= (size_t)(room > 0 ? room : 0) ? all : room > 1 ? (size_t)room - 1 : 0;
    for (size_t i = 0; i < shown; i++) {
        char text[NUMBER_TEXT_MAX];
        snprintf(text, sizeof text, "%zu", subject->links[i].index);
        area_text_right(area, INDEX_WIDTH - 1, y + (int)i, text, STYLE_NORMAL);
    }
    int row = y + (int)shown;
    if (shown < all)
        area_print(area, 1, row++, STYLE_FAINT, "%zu more", all - shown);
    if (sums)
        area_text_right(area, INDEX_WIDTH - 1, row, "sum", STYLE_HEADING);
    if (totals > 1) {
        char text[32];
        snprintf(text, sizeof text, "%s %zu", sim->sets[subject->set].name, subject->index);
        if (adds)
            area_text(area, 1, row + 1, "it had", STYLE_HEADING);
        area_text(area, 1, row + 1 + adds, "it has", STYLE_HEADING);
    }
    for (int c = 0; c < block->n_columns; c++) {
        const BlockColumn *column = &block->columns[c];
        const int end = column_end(block, c);
        if (column->exchange < 0) {
            char text[NUMBER_TEXT_MAX];
            for (size_t i = 0; i < shown; i++) {
                number_text(column->values[i], 6, block->factor_width - 1, text);
                area_text_right(area, end, y + (int)i, text, STYLE_NORMAL);
            }
            continue;
        }
        const Exchange *exchange = &sim->exchanges[column->exchange];
        double terms[LINKS_MAX + 1], base = 0;
        memcpy(terms, column->values, sizeof column->values);
        size_t n_terms = shown;
        if (shown < all)
            terms[n_terms++] = sum_of(column, shown, all);
        const int field = stage_field(sim, exchange->to, exchange->field);
        bool known = totals > 1;
        if (known && exchange->adds)
            known = experiment_field_before(screen->experiment, field, subject->index, 1, &base);
        const double sum = sum_of(column, 0, all);
        const Writing writing = writing_of(terms, n_terms, base, sum);
        for (size_t i = 0; i < n_terms; i++)
            write_number(area, end, y + (int)i, terms[i], writing, writing.decimals,
                         i < shown ? STYLE_NORMAL : STYLE_FAINT);
        if (sums)
            draw_total(subject, area, block, c, row, writing, base, known);
        if (writing.exponent != 0)
            area_print(area, end + 1, row, STYLE_FAINT, "x10^%d", writing.exponent);
    }
    return row + totals;
}

static int block_rows(const Subject *subject, const Block *block)
{
    return HEAD_ROWS + (int)subject->n_links + 1 +
           (block->takes && subject->sim->stage == block->stage + 1 ? 2 : 0);
}

/* "particle 25 in cell 12", "node 13, held by a support". */
static void draw_subject(const Screen *screen, const Subject *subject, Area area)
{
    const Simulation *sim = subject->sim;
    char text[128], number[NUMBER_TEXT_MAX];
    const int x = stage_field(sim, subject->set, "x"), cell = stage_field(sim, subject->set, "cell");
    const int fixed = stage_field(sim, subject->set, "fixed");
    number_text(field_value(sim, x, subject->index), 6, 10, number);
    snprintf(text, sizeof text, "%s %zu at x = %s", sim->sets[subject->set].name, subject->index, number);
    if (cell >= 0)
        append(text, sizeof text, ", in cell %.0f", field_value(sim, cell, subject->index));
    if (fixed >= 0 && field_value(sim, fixed, subject->index) > 0)
        append(text, sizeof text, ", held by a support");
    area_rule(area, 0, text, is_focused(screen, PANE_INSPECTOR) ? STYLE_FOCUS : STYLE_HEADING);
    static const char hint[] = " ← → next  ↑ ↓ node or particle  i closes ";
    if (5 + text_columns(text) + text_columns(hint) + 2 <= area.rect.width)
        area_text_right(area, area.rect.width - 1, 0, hint, STYLE_FAINT);
}

void pane_mesh_inspector(const Screen *screen, Area area)
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
    for (int pass = 0; pass < 2; pass++)
        for (int stage = latest; stage >= 0; stage--)
            for (int takes = 1; takes >= 0; takes--) {
                const bool first = stage == latest || takes || subject.set == 0;
                Block block;
                if (first != (pass == 0) || !make_block(&block, &subject, stage, takes,
                                                        screen->glyphs == GLYPHS_ASCII, area.rect.width))
                    continue;
                if (y == 1)
                    y = draw_block(screen, &subject, area, &block, y);
                else if (y + 1 + block_rows(&subject, &block) <= area.rect.height)
                    y = draw_block(screen, &subject, area, &block, y + 1);
            }
}
