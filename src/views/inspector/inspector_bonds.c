/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The inspectors of bonds: of a bar each bond of the chosen node with what its force is made of; of beams the
 * node's family with stretches as shares of the critical one, and the forces by the side on which they pull.
 */
#include "views/inspector/inspector.h"
#include "base/text.h"
#include "panes/screen.h"
#include "scenario/concern_bonds.h"
#include "scenario/settings.h"
#include "views/map/map.h"
#include "base/math/functions.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* What makes the node's force as far as this step has come: into columns that add, with these loads. */
static void add_totals(const Simulation *sim, size_t node, const char *const *fields, const double *loads,
                       PictureTable *table)
{
    const int bonds = simulation_find_stage(sim, "bonds"), drift = simulation_find_stage(sim, "drift");
    const bool is_old = sim->stage > drift && sim->stage <= bonds; /* the force is still the last step's */
    const bool just_bonds = sim->stage == bonds + 1, just_load = sim->stage == bonds + 2;
    const Style plain = STYLE_HEADING, changed = STYLE_CHANGED;
    for (int c = 0, k = 0; c < table->n_columns; c++)
        if (table->columns[c].adds) {
            table->columns[c].base = is_old || just_bonds ? NAN : loads[k];
            table->columns[c].result = simulation_named(sim, 0, fields[k++], node);
        }
    table->totals[TOTAL_SUM] = (struct TableTotals){"all its bonds", just_bonds ? changed : plain};
    table->totals[TOTAL_BASE] = (struct TableTotals){is_old || just_bonds ? NULL : "load on the node",
                                                     just_load ? changed : STYLE_NORMAL};
    table->totals[TOTAL_RESULT] = (struct TableTotals){is_old       ? "f, of the last step"
                                                       : just_bonds ? "f, without the load"
                                                                    : "f of the node",
                                                       just_bonds || just_load ? changed : plain};
}

static void describe(const Screen *screen, Picture *picture)
{
    const Simulation *sim = screen_simulation(screen);
    Link links[TABLE_ROWS_MAX];
    const size_t chosen = screen->chosen.particle, last = sim->counts[0] - 1;
    const size_t node = chosen < last ? chosen : last;
    const size_t found = sim->method->links(sim, 0, node, links, TABLE_ROWS_MAX);
    const size_t count = found < TABLE_ROWS_MAX ? found : TABLE_ROWS_MAX;
    static const char *const told[][2] = {
        {"u", "u"}, {"v", "v"}, {"stress", "stress"}, {"strain", "strain"}, {"g", "surface_factor"}};
    char text[160] = "";
    picture_heading(picture, "%snode %zu at X = %s: %zu bonds", screen_second_run(screen) ? "A: " : "", node,
                    text_fitted(simulation_named(sim, 0, "x0", node), 6, 12).text, count);
    snprintf(picture->hints[0], sizeof picture->hints[0], " ← → next node  i closes ");
    for (size_t i = 0; i < sizeof told / sizeof *told; i++)
        if (simulation_find_field(sim, 0, told[i][1]) >= 0)
            text_append(text, sizeof text, "%s%s = %s", *text ? "  " : "", told[i][0],
                        text_fitted(simulation_named(sim, 0, told[i][1], node), 5, 11).text);
    picture_note(picture, STYLE_NORMAL, "%s", text);
    picture_note(picture, STYLE_FAINT,
                 "f = Σ (c G w V) s n  n: towards the other end  w: share of its cell within reach");
    PictureTable *table = picture_table(picture);
    if (!table)
        return;
    static const char *const names[] = {"ξ", "stretch s", "c G w V", "force on it"};
    enum { LENGTH, STRETCH, STIFFNESS, FORCE, COLUMNS };
    const double load = sim->method->load_on(sim, node, 0);
    table->count = count;
    table->n_columns = COLUMNS;
    table->what = "bond to";
    table->more = "longer ones";
    for (int c = 0; c < COLUMNS; c++) {
        table->columns[c] = (TableColumn){.adds = c == FORCE, .stays = c != FORCE, .in = 1u << FORCE};
        snprintf(table->columns[c].name, sizeof table->columns[c].name, "%s", names[c]);
    }
    for (size_t i = 0; i < count; i++) {
        const Link *link = &links[i];
        struct TableRow *row = &table->rows[i];
        snprintf(row->name, sizeof row->name, "%s%zu", link_mirror(link), link->index);
        row->rank = abs((int)lround(link->apart[0] / sim->spacing)); /* the longest are summed up first */
        row->thing = (PictureThing){0, link->index};
        table->columns[LENGTH].values[i] = link->apart[0];
        table->columns[STRETCH].values[i] = link->stretch;
        table->columns[STIFFNESS].values[i] = link->stiffness;
        table->columns[FORCE].values[i] = simulation_exchange(sim, 0, node, link).product;
    }
    add_totals(sim, node, (const char *const[]){"force"}, &load, table);
    table->columns[FORCE].style =
        sim->stage == simulation_find_stage(sim, "bonds") + 1 ? STYLE_CHANGED : STYLE_NORMAL;
}

static void move_on(Screen *screen, int x, int y, int page)
{
    screen->chosen.is_node = false;
    if (x != 0 || page > 1)
        selection_next(&screen->chosen, screen_simulation(screen), x != 0 ? x : y, (size_t)page);
}

const Inspector inspector_bonds = {.needs = HAS_BONDS | HAS_LINE, .describe = describe, .move = move_on};

/* --- beams and plates ------------------------------------------------------------------------------- */

enum { FAMILY_LINKS = 256 };

typedef struct Family {
    const Simulation *sim;
    const Settings *settings;
    double s0; /* the critical stretch */
    Body body;
    size_t node;
    int i, j, reach;
    Link links[FAMILY_LINKS];
    int count, broken, cut; /* broken in the run; cut by the notch before it */
    int most;               /* the link of the most stretched whole bond; -1: none */
    int last;               /* of the one that broke last, the notch's left out; -1: none */
} Family;

/* Columns (d 0) or rows from the node to the other end. */
static int steps_to(const Family *family, const Link *link, int d)
{
    return (int)lround(link->apart[d] / family->body.spacing);
}

static bool family_of(Family *family, const Screen *screen)
{
    const Simulation *sim = screen_simulation(screen);
    *family = (Family){.sim = sim, .settings = screen_settings(screen), .most = -1, .last = -1};
    if (!body_of(sim, &family->body) || sim->counts[0] == 0)
        return false;
    family->s0 = settings_bonds(family->settings)->critical_stretch;
    family->node = screen->chosen.particle < sim->counts[0] ? screen->chosen.particle : sim->counts[0] - 1;
    family->i = (int)(family->node % (size_t)family->body.nx);
    family->j = (int)(family->node / (size_t)family->body.nx);
    const Link *const links = family->links;
    const size_t count = sim->method->links(sim, 0, family->node, family->links, FAMILY_LINKS);
    family->count = (int)(count < FAMILY_LINKS ? count : FAMILY_LINKS);
    for (int k = 0; k < family->count; k++) {
        const bool cut = links[k].broken && links[k].broken_at == 0;
        for (int d = 0; d < 2; d++)
            family->reach = (int)fmax(family->reach, abs(steps_to(family, &links[k], d)));
        family->cut += cut;
        family->broken += links[k].broken && !cut;
        if (links[k].broken && !cut &&
            (family->last < 0 || links[k].broken_at > links[family->last].broken_at))
            family->last = k;
        if (!links[k].broken && (family->most < 0 || links[k].stretch > links[family->most].stretch))
            family->most = k;
    }
    return family->reach <= AROUND_MAX;
}

static void describe_around(const Family *family, PictureAround *around)
{
    const int reach = around->reach = family->reach;
    const double s0 = family->s0;
    double most = 0;
    for (int k = 0; k < family->count; k++)
        most = fmax(most, family->links[k].broken ? 0 : fabs(family->links[k].stretch));
    /* stretches are numbers of two or three digits: in percent of s0, or of a power of ten */
    const int exponent = most > 0 ? (int)floor(math_log10(most)) - 1 : 0;
    const double scale = s0 > 0 ? 100 / s0 : math_pow(10, -exponent);
    snprintf(around->meaning, sizeof around->meaning, s0 > 0 ? "%% of s0" : "s x10^%d", exponent);
    const double farthest = lattice_reach(family->settings) / family->body.spacing;
    const struct AroundPlace none = {.sign = 0x00b7, .style = STYLE_FAINT, .thing.set = -1};
    /* who is missing: beyond a surface there is no node */
    for (int q = -reach; q <= reach; q++)
        for (int p = -reach; p <= reach; p++) {
            const bool inside = family->i + p >= 0 && family->i + p < family->body.nx && family->j + q >= 0 &&
                                family->j + q < family->body.ny;
            around->places[reach + q][reach + p] = none;
            around->places[reach + q][reach + p].is_there = !inside && math_hypot(p, q) <= farthest;
        }
    for (int k = 0; k < family->count; k++) {
        const Link *link = &family->links[k];
        around->places[reach + steps_to(family, link, 1)][reach + steps_to(family, link, 0)] =
            (struct AroundPlace){.is_there = true,
                                 .value = link->stretch * scale,
                                 .sign = !link->broken          ? 0
                                         : link->broken_at == 0 ? '|'
                                                                : 'x',
                                 .style = link->broken        ? STYLE_WARNING
                                          : k == family->most ? STYLE_CHANGED
                                                              : STYLE_NORMAL,
                                 .thing = {0, link->index}};
    }
    around->places[reach][reach] = (struct AroundPlace){
        .is_there = true, .sign = 0x25a0, .style = STYLE_SECOND, .thing = {0, family->node}};
    text_append(around->meaning, sizeof around->meaning, "%s",
                family->broken + family->cut ? "  x broken  | notch" : "");
}

/* --- single bonds ----------------------------------------------------------------------------------- */

/* "s = 0.0003878 = 45.6 % of s0 = 0.00085" */
static void note_stretch(const Family *family, const Link *link, Picture *picture)
{
    picture_note(picture, STYLE_CHANGED, family->s0 > 0 ? "s = %s = %s %% of s0 = %s" : "s = %s",
                 text_fitted(link->stretch, 4, 12).text,
                 text_fitted(family->s0 > 0 ? 100 * link->stretch / family->s0 : 0, 4, 8).text,
                 text_fitted(family->s0, 4, 12).text);
}

static const char *why_it_holds(const Family *family, const Link *link)
{
    if (family->s0 <= 0)
        return "holds: bonds never break here (s0 = 0)";
    if (link->stretch < family->s0)
        return "holds: below s0";
    if (simulation_named(family->sim, 0, "protected", family->node) > 0 ||
        simulation_named(family->sim, 0, "protected", link->index) > 0)
        return "holds: protected, near load or support";
    return "breaks in the next stage of bond forces";
}

static void describe_forces(const Family *family, PictureTable *table)
{
    static const char *const sides[] = {"bonds to the left", "bonds up and down", "bonds to the right"};
    static const char *const names[] = {"fx", "fy"};
    const Simulation *sim = family->sim;
    double loads[2];
    table->what = "forces on it, N/m³";
    table->count = sizeof sides / sizeof *sides;
    table->n_columns = 2;
    for (size_t i = 0; i < table->count; i++)
        snprintf(table->rows[i].name, sizeof table->rows[i].name, "%s", sides[i]);
    for (int d = 0; d < 2; d++) {
        TableColumn *column = &table->columns[d];
        loads[d] = sim->method->load_on(sim, family->node, d);
        *column = (TableColumn){.adds = true};
        snprintf(column->name, sizeof column->name, "%s", names[d]);
        for (const Link *link = family->links; link < family->links + family->count; link++)
            column->values[1 + (link->apart[0] > 0) - (link->apart[0] < 0)] +=
                simulation_exchange(sim, d, family->node, link).product;
    }
    add_totals(family->sim, family->node, names, loads, table);
}

/* --- the whole ---------------------------------------------------------------------------------------- */

static void family_describe(const Screen *screen, Picture *picture)
{
    Family family;
    picture->kind = PICTURE_TABLES;
    if (!family_of(&family, screen)) {
        picture_heading(picture, "no family to be drawn");
        return;
    }
    const Simulation *sim = family.sim;
    char lost[64] = "";
    const Body *body = &family.body;
    /* the notch's bonds were cut before the run, the others broke in it */
    if (family.cut)
        text_append(lost, sizeof lost, ", %d cut by the notch", family.cut);
    if (family.broken)
        text_append(lost, sizeof lost, ", %d broken", family.broken);
    picture_heading(picture, "node %zu at %.6g, %.6g mm: %d bonds%s", family.node,
                    1e3 * (body->first[0] + family.i * body->spacing),
                    1e3 * (body->first[1] + family.j * body->spacing), family.count, lost);
    snprintf(picture->brief, sizeof picture->brief, "node %zu: %d bonds%s", family.node, family.count, lost);
    snprintf(picture->hints[1], sizeof picture->hints[1], " ← → ↑ ↓ next node  i closes ");
    picture->tables_first = screen->panes.zoomed;
    snprintf(picture->turn_hint, sizeof picture->turn_hint,
             picture->tables_first ? " z family " : " z forces ");
    if (family.last >= 0) {
        /* The bond that broke last; in the step in which it did with the stretch. Enter goes there. */
        const Link *link = &family.links[family.last];
        const bool now = link->broken_at == sim->step + (sim->stage > 0);
        snprintf(picture->hints[0], sizeof picture->hints[0],
                 " ← → ↑ ↓ next node  Enter last break  i closes ");
        picture_note(picture, STYLE_WARNING,
                     now ? "bond %zu-%zu breaks in this step:" : "bond %zu-%zu broke in step %ld",
                     family.node, link->index, link->broken_at);
        picture->step = link->broken_at;
        if (now)
            note_stretch(&family, link, picture);
    }
    const Link *most = family.most >= 0 ? &family.links[family.most] : NULL; /* that is whole */
    if (most) {
        picture_note(picture, STYLE_HEADING, "most stretched: to node %zu", most->index);
        note_stretch(&family, most, picture);
        picture_note(picture, STYLE_NORMAL, "%s", why_it_holds(&family, most));
    } else
        picture_note(picture, STYLE_WARNING, "no bond of it is whole");
    PictureAround *around = picture_around(picture);
    if (around)
        describe_around(&family, around);
    PictureTable *forces = picture_table(picture);
    if (forces)
        describe_forces(&family, forces);
    picture_note(picture, STYLE_FAINT, "next: %s",
                 sim->stages[sim->stage < sim->n_stages ? sim->stage : 0].name)
        ->spare = true;
}

/* Bonds are asked for by the thousand: there are more of them than one would keep. */
long inspector_broken_node(const Screen *screen, long step)
{
    enum { BONDS = 1, AT_ONCE = 4096 };
    const Simulation *sim = screen_simulation(screen);
    const int when = simulation_find_field(sim, BONDS, "broken_at"),
              end = simulation_find_field(sim, BONDS, "i");
    Body body;
    double value[AT_ONCE];
    if (!body_of(sim, &body) || when < 0 || end < 0)
        return -1;
    for (size_t first = 0; first < sim->counts[BONDS]; first += AT_ONCE) {
        const size_t left = sim->counts[BONDS] - first, count = left < AT_ONCE ? left : AT_ONCE;
        sim->method->field(sim, when, first, count, value);
        for (size_t k = 0; k < count; k++)
            if (value[k] == (double)step) {
                sim->method->field(sim, end, first + k, 1, value);
                return (long)value[0];
            }
    }
    return -1;
}

static void family_move(Screen *screen, int x, int y, int page)
{
    Body body;
    if (!body_of(screen_simulation(screen), &body))
        return;
    int i = (int)(screen->chosen.particle % (size_t)body.nx) + x * page,
        j = (int)(screen->chosen.particle / (size_t)body.nx);
    j -= y * page; /* row 0 lies below */
    i = i < 0 ? 0 : i >= body.nx ? body.nx - 1 : i;
    j = j < 0 ? 0 : j >= body.ny ? body.ny - 1 : j;
    screen->chosen.particle = (size_t)j * (size_t)body.nx + (size_t)i;
    screen->chosen.is_node = false;
    screen->eye.centre[0] = (i + 0.5) / body.nx;
    screen->eye.centre[1] = (j + 0.5) / body.ny;
}

const Inspector inspector_family = {
    .needs = HAS_BONDS | HAS_PLANE, .describe = family_describe, .move = family_move};
