/* What several panes share: headings with legends, texts of numbers and times. */
#include "view/panes/panes.h"
#include "view/draw/sketch.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

Experiment *screen_second_run(const Screen *screen)
{
    return screen->duel ? screen->duel->b : NULL;
}

bool screen_is_shared(const Screen *screen)
{
    return screen_second_run(screen) && screen->side == SIDE_BOTH;
}

Screen screen_of_side(const Screen *screen, DuelSide side)
{
    Screen one = *screen;
    one.side = side;
    one.experiment = side == SIDE_B ? screen->duel->b : screen->duel->a;
    return one;
}

Experiment *screen_clock_run(const Screen *screen)
{
    return screen_second_run(screen) ? screen->duel->a : screen->experiment;
}

bool screen_shows_exact(const Screen *screen)
{
    return screen->views.references == SHOW_ALL || screen->views.references == SHOW_EXACT;
}

bool screen_shows_predicted(const Screen *screen)
{
    return screen->views.references == SHOW_ALL || screen->views.references == SHOW_PREDICTED;
}

bool screen_is_focused(const Screen *screen, PaneId pane)
{
    return screen->panes.focus == pane;
}

bool screen_is_rewound(const Screen *screen)
{
    return experiment_newest(screen->experiment) > experiment_step(screen->experiment);
}

double axis_enlargement(double reach, double room)
{
    if (!(reach > 0))
        return 1;
    /* a coarse step: a scale that changes is worse than one that is a little small */
    double factor = room / axis_step_up(reach);
    return factor < 1 ? 1 : axis_step_down(factor);
}

/* A sketch takes the whole legend. */
static int sketch_legend(Sketch *sketch, const Legend *legend, int n_legend)
{
    for (int i = 0; i < n_legend; i++) {
        SketchKey key = {.line = legend[i].line, .style = legend[i].style};
        snprintf(key.name, sizeof key.name, "%s", legend[i].name);
        if (legend[i].key && legend[i].key[0] && legend[i].key[1] == ':')
            key.letter = legend[i].key[0];
        sketch_key(sketch, &key);
    }
    return n_legend;
}

static int legend_room(Area area)
{
    enum { NO_LIMIT = 10000 };
    return area.canvas->sketch ? NO_LIMIT : area.rect.width;
}

int legend_draw(Area area, int x, int y, const Legend *legend, int n_legend)
{
    if (area.canvas->sketch)
        return sketch_legend(area.canvas->sketch, legend, n_legend);
    for (int i = 0; i < n_legend; i++) {
        const int columns = 3 + glyphs_columns(legend[i].name);
        if (x + columns + 1 > area.rect.width)
            return i;
        for (int k = -1; k <= columns + 1; k++)
            area_put(area, x + k, y, ' ', STYLE_FRAME);
        const char *key =
            legend[i].key ? legend[i].key : plot_key(legend[i].line, legend[i].letter, area.glyphs);
        area_text(area, x, y, key, legend[i].style);
        area_text(area, x + 3, y, legend[i].name, STYLE_NORMAL);
        x += columns + 2;
    }
    return n_legend;
}

const char *legend_short_name(const char *name)
{
    static const char *const words[][2] = {
        {"predicted", "pred"},
        {"measured", "meas"},
        {"displacement", "displ."},
        {"measured, middle row", "meas"},
        {"% error, sqrt scale", "error of w, %"},
        {"force, N/m^6", "f, N/m^6"},
    };
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(name, words[i][0]) == 0)
            return words[i][1];
    return strncmp(name, "filtered ", 9) == 0 ? "filt" : name;
}

enum { NAME_KINDS = 3 };

/* How an entry is named where room is short, by what gives way first; NULL: it is not of that kind. */
static const char *shorter_name(const Legend *entry, int kind)
{
    const bool ghost = entry->key && entry->key[0] && entry->key[1] == ':';
    const bool run = (entry->name[0] == 'A' || entry->name[0] == 'B') && entry->name[1] == ' ';
    switch (kind) {
    case 0:
        return !run ? NULL : entry->name[0] == 'A' ? "A" : "B";
    case 1:
        return legend_short_name(entry->name);
    default:
        return ghost ? "" : NULL; /* its letter has to do */
    }
}

static int legend_columns(const Legend *legend, int n_legend)
{
    int columns = -1; /* after the last one there is no gap */
    for (int i = 0; i < n_legend; i++)
        columns += glyphs_columns(legend[i].name) + 5;
    return columns;
}

/* One kind of names after the other gives way until the whole legend has room: so many kinds. */
static void shorten_legend(int room, int kinds, Legend *legend, int n_legend)
{
    for (int kind = 0; kind < kinds; kind++)
        for (int i = 0, columns = legend_columns(legend, n_legend); i < n_legend && columns > room; i++) {
            const char *name = shorter_name(&legend[i], kind);
            columns -= name ? glyphs_columns(legend[i].name) - glyphs_columns(name) : 0;
            legend[i].name = name ? name : legend[i].name;
        }
}

/* The solid line of the one run that there is goes without saying. */
static int leave_out_measured(Legend *legend, int n_legend)
{
    for (int i = 0; i < n_legend; i++)
        if (strcmp(legend[i].name, legend_short_name("measured")) == 0) {
            memmove(&legend[i], &legend[i + 1], (size_t)(n_legend - i - 1) * sizeof *legend);
            return n_legend - 1;
        }
    return n_legend;
}

int heading_draw(Area area, Style heading, const char *name, const char *scale, const Legend *legend,
                 int n_legend)
{
    enum { SHORT_NAME = 1, NO_MEASURED, LETTERS_ONLY }; /* what gives way, one after the other */
    char text[160];
    Legend shown[LEGENDS_MAX];
    n_legend = n_legend < LEGENDS_MAX ? n_legend : LEGENDS_MAX;
    int n_shown = 0, x = 0;
    for (int pass = 0; pass <= LETTERS_ONLY; pass++) {
        const char *title = pass >= SHORT_NAME ? legend_short_name(name) : name;
        snprintf(text, sizeof text, "%s%s%s", title, !scale[0] ? "" : scale[0] == 'x' ? " " : ", ", scale);
        x = 4 + glyphs_columns(text) + 1;
        const int room = legend_room(area) - x;
        memcpy(shown, legend, (size_t)n_legend * sizeof *legend);
        shorten_legend(room, NAME_KINDS - 1, shown, n_legend);
        n_shown = pass >= NO_MEASURED ? leave_out_measured(shown, n_legend) : n_legend;
        shorten_legend(room, pass >= LETTERS_ONLY ? NAME_KINDS : 0, shown, n_shown);
        if (legend_columns(shown, n_shown) <= room)
            break;
    }
    area_rule(area, 0, text, heading);
    return legend_draw(area, x, 0, shown, n_shown) + n_legend - n_shown;
}

bool heading_hint(const Screen *screen, Area area, int begin, int end, const char *hint)
{
    char text[96];
    screen_plain_text(screen, hint, text, sizeof text);
    if (begin + glyphs_columns(text) >= end)
        return false;
    area_text_right(area, end, 0, text, STYLE_FAINT);
    return true;
}

double simulation_value(const Simulation *sim, int field, size_t index)
{
    double value = NAN;
    if (field >= 0)
        sim->method->field(sim, field, index, 1, &value);
    return value;
}

void text_fitted(double value, int digits, int width, char out[NUMBER_TEXT_MAX])
{
    do
        text_rounded(out, value, digits);
    while ((int)strlen(out) > width && --digits > 0);
}

const Problem *screen_problem(const Screen *screen)
{
    return experiment_settings(screen->experiment)->problem;
}

void text_factor(double factor, char out[NUMBER_TEXT_MAX])
{
    if (factor >= 1 && factor < 1e7)
        snprintf(out, NUMBER_TEXT_MAX, "%.0f", factor);
    else
        text_rounded(out, factor, 2);
}

void screen_time_text(const Screen *screen, double time, char *out, size_t size)
{
    const Problem *facts = screen_problem(screen);
    const double unit = facts->shown_time, dt = experiment_simulation(screen->experiment)->dt / unit;
    int decimals = dt > 0 ? (int)ceil(-log10(dt) - 1e-9) : 2;
    decimals = decimals < 0 ? 0 : decimals > 6 ? 6 : decimals;
    snprintf(out, size, "t %.*f%s", decimals, time / unit, facts->shown_time_unit);
}

int screen_column(const Screen *screen, const char *name)
{
    int count;
    const Column *columns = experiment_columns(screen->experiment, &count);
    for (int i = 0; i < count; i++)
        if (strcmp(columns[i].quantity.name, name) == 0)
            return i;
    return -1;
}

double screen_derived(const Screen *screen, const char *name)
{
    Derived derived[DERIVED_MAX];
    const int count = experiment_derived(screen->experiment, derived);
    for (int i = 0; i < count; i++)
        if (strcmp(derived[i].name, name) == 0)
            return derived[i].value;
    return NAN;
}

int screen_box_stage(const Screen *screen, bool *done)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    int stage = experiment_stage(screen->experiment);
    *done = true;
    if (stage > 0)
        return stage - 1;
    if (experiment_before(screen->experiment))
        return sim->n_stages - 1;
    *done = false;
    return 0;
}

void text_append(char *out, size_t size, const char *format, ...)
{
    const size_t used = strlen(out);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(out + used, size - used, format, arguments);
    va_end(arguments);
}

bool text_next_word(const char **text, char *out, size_t size)
{
    *text += strspn(*text, " ");
    size_t length = strcspn(*text, " ");
    if (length == 0)
        return false;
    snprintf(out, size, "%.*s", (int)length, *text);
    *text += length;
    return true;
}

/* How many of the names only this set has. */
static int own_names(const Simulation *sim, const char *words, int set)
{
    char word[64];
    int count = 0;
    while (text_next_word(&words, word, sizeof word))
        count += simulation_find_field(sim, set, word) >= 0 && simulation_find_field(sim, 1 - set, word) < 0;
    return count;
}

int stage_flow_target(const Simulation *sim, const Stage *stage)
{
    if (!simulation_has(sim, HAS_MESH))
        return 0;
    const int particles = own_names(sim, stage->writes, 0), nodes = own_names(sim, stage->writes, 1);
    if (particles != nodes)
        return nodes > particles;
    /* only shared names: what it reads of the one it writes to the other */
    return own_names(sim, stage->reads, 0) > 0;
}

Flow stage_flow(const Simulation *sim, const Stage *stage)
{
    if (!simulation_has(sim, HAS_MESH))
        return FLOW_NONE;
    if (strcmp(stage->id, "forget") == 0)
        return FLOW_FORGET;
    const int target = stage_flow_target(sim, stage);
    if (own_names(sim, stage->reads, 1 - target) == 0)
        return FLOW_NONE;
    return target == 1 ? FLOW_TO_NODES : FLOW_TO_PARTICLES;
}

int stage_flow_field(const Simulation *sim, int set, const char *name)
{
    return set < sim->n_sets ? simulation_find_field(sim, set, name) : -1;
}

static double reach_of(Experiment *experiment, int field, const double *now, size_t count)
{
    enum { TIMES = 24, PLACES = 8 };
    const Simulation *sim = experiment_simulation(experiment);
    const References *refs = experiment_references(experiment);
    const Readout *readout = experiment_readout(experiment);
    const char *name = sim->fields[field].quantity.name;
    double reach = 0, length = 0;
    for (size_t i = 0; i < count; i++)
        reach = fmax(reach, fabs(now[i]));
    if (count > 0)
        sim->method->field(sim, sim->position[0], count - 1, 1, &length);
    double span = experiment_settings(experiment)->time.end;
    if (readout->moving && readout->exact_known && readout->exact > 0 && !readout->drifting)
        span = readout->is_period ? readout->exact : 2 * M_PI / readout->exact;
    for (int i = 0; i <= TIMES; i++)
        for (int k = 1; k <= PLACES; k++) {
            double value = fabs(references_profile(refs, name, length * k / PLACES, span * i / TIMES));
            if (isfinite(value))
                reach = fmax(reach, value);
        }
    return isfinite(reach) ? reach : 0;
}

/* Two runs are compared by one scale. */
double screen_field_reach(const Screen *screen, int field, const double *now, size_t count)
{
    double reach = reach_of(screen->experiment, field, now, count);
    Experiment *second = screen_second_run(screen);
    if (!second)
        return reach;
    Experiment *other = screen->experiment == second ? screen->duel->a : second;
    const Simulation *sim = experiment_simulation(other);
    const char *name = experiment_simulation(screen->experiment)->fields[field].quantity.name;
    const int same = simulation_find_field(sim, 0, name);
    const size_t others = sim->counts[0];
    double *values = same >= 0 ? malloc((others + 1) * sizeof *values) : NULL;
    if (values) {
        sim->method->field(sim, same, 0, others, values);
        reach = fmax(reach, reach_of(other, same, values, others));
    }
    free(values);
    return reach;
}

void screen_plain_text(const Screen *screen, const char *text, char *out, size_t size)
{
    static const char *const spellings[][2] = {
        {"→", "->"},  {"←", "<-"}, {"Δ", "d"},   {"ε", "e"},    {"σ", "s"},   {"ρ", "rho"},
        {"φ", "phi"}, {"ξ", "xi"}, {"η", "eta"}, {"μ", "mu"},   {"α", "a"},   {"Σ", "sum"},
        {"×", "x"},   {"′", "'"},  {"↑", "Up"},  {"↓", "Down"}, {"½", "1/2"}, {"²", "^2"},
        {"³", "^3"},  {"−", "-"},  {"≥", ">="},  {"…", "..."},
    };
    enum { SPELLINGS = sizeof spellings / sizeof *spellings };
    size_t used = 0;
    while (*text != '\0') {
        const char *word = NULL;
        size_t taken = 1;
        for (int i = 0; !word && screen->look.glyphs == GLYPHS_ASCII && i < SPELLINGS; i++)
            if (strncmp(text, spellings[i][0], strlen(spellings[i][0])) == 0) {
                word = spellings[i][1];
                taken = strlen(spellings[i][0]);
            }
        const char *from = word ? word : text;
        const size_t length = word ? strlen(word) : 1;
        if (used + length >= size)
            break;
        memcpy(out + used, from, length);
        used += length;
        text += taken;
    }
    out[used] = '\0';
}

void screen_unit_text(const Screen *screen, const Field *field, char *out, size_t size)
{
    const char *unit = field->quantity.unit;
    const bool none = !screen_problem(screen)->si || strcmp(unit, "1") == 0;
    snprintf(out, size, "%s%s", none ? "" : " ", none ? "" : unit);
}
