/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The map of a beam, the drawing and the family inspector: what they show is where and what the simulation
 * says, read from the cells as a reader would. */
#include "views/view.h"
#include "scenario/concern_output.h"
#include "scenario/concern_loads.h"
#include "scenario/settings.h"
#include "views/inspector/inspector.h"
#include "suite.h"
#include "picture/cells/cells.h"
#include "views/map/map.h"
#include "views/scene.h"
#include "panes/screen.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void open_scene(Scene *scene, const char *words)
{
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scene_open(scene, words, &status), "%s: %s", words, status.text);
}

/* A row of the screen as text with one byte a column. */
static void row_text(const Scene *scene, int y, char *out)
{
    const Canvas *canvas = &scene->canvas;
    for (int x = 0; x < canvas->width; x++) {
        const uint32_t glyph = canvas->cells[y * canvas->width + x].glyph;
        out[x] = (char)(glyph >= ' ' && glyph < 0x7f ? glyph : glyph ? '?' : ' ');
    }
    out[canvas->width] = '\0';
}

/* The first row that holds a text; NULL: none does. */
static const char *find_row(const Scene *scene, const char *wanted, char *out)
{
    for (int y = 0; y < scene->canvas.height; y++) {
        row_text(scene, y, out);
        const char *found = strstr(out, wanted);
        if (found)
            return found;
    }
    return NULL;
}

/* The map in a part of the screen. */
typedef struct Seen {
    Picture picture;
    Map map;
    const PictureMap *drawn;
    Rect rect;
} Seen;

static void see(Seen *seen, const Scene *scene, Rect rect)
{
    seen->rect = rect;
    cells_open(&seen->picture, rect.width + 2, rect.height + 2, GLYPHS_BRAILLE);
    ck_assert(map_open(&seen->map, &scene->screen, &seen->picture));
    seen->drawn = seen->picture.map;
}

static void see_no_more(Seen *seen)
{
    map_close(&seen->map);
    picture_close(&seen->picture);
}

static void node_place(const Seen *seen, size_t node, double *column, double *row)
{
    cells_place(seen->drawn, seen->rect, seen->drawn->x[node], seen->drawn->y[node], column, row);
}

/* --- the map ---------------------------------------------------------------------------------------- */

/* A place on the map and the node under it belong together, whatever is magnified or moved. */
START_TEST(a_node_is_found_where_it_is_drawn)
{
    static const char *const scenes[] = {
        "supported-beam-coarse 80x24 700 upper 8",
        "moving-cantilever-coarse 80x24 2000 upper 8",
        "notched-beam-coarse 132x43 300 upper 8 focus 2 zoom magnified 64 at 0.3,0.3",
        "two-discs 80x24 150 upper 8",
    };
    Scene scene;
    open_scene(&scene, scenes[_i]);
    const Rect pane = screen_pane(&scene.screen, scene.canvas.width, scene.canvas.height, PANE_UPPER);
    Seen map;
    see(&map, &scene, (Rect){pane.x + 1, pane.y + 1, pane.width - 2, pane.height - 2});
    int seen = 0;
    for (size_t node = 0; node < map.map.body.count; node++) {
        double column, row, back_column, back_row;
        node_place(&map, node, &column, &row);
        if (column < 0 || row < 0 || column >= map.rect.width || row >= map.rect.height)
            continue;
        ck_assert(screen_click_view(&scene.screen, scene.canvas.width, scene.canvas.height,
                                    map.rect.x + (int)column, map.rect.y + (int)row));
        node_place(&map, scene.screen.chosen.particle, &back_column, &back_row);
        ck_assert_double_le(fabs(back_column - column), 1);
        ck_assert_double_le(fabs(back_row - row), 1);
        seen++;
    }
    ck_assert_int_gt(seen, 5);
    see_no_more(&map);
    scene_close(&scene);
}
END_TEST

/* Lengths are to scale, two columns for a row, and displacements drawn by the stated factor. */
START_TEST(factors_are_those_that_are_stated)
{
    char row[256], wanted[64];
    Scene scene;
    open_scene(&scene, "notched-beam-coarse 132x43 250 upper 8 focus 2 zoom view.exaggeration=40");
    ck_assert_ptr_nonnull(find_row(&scene, "u x 40", row));
    Seen map;
    see(&map, &scene, (Rect){1, 2, 130, 39});
    ck_assert_double_eq(map.drawn->enlarged, 40);
    double x[2], y[2];
    const size_t nx = (size_t)map.map.body.nx, a = 50 * nx + 10, b = a + 20;
    node_place(&map, a, &x[0], &y[0]);
    node_place(&map, b, &x[1], &y[1]);
    const double columns =
        (20 * map.map.body.spacing + 40 * (map.map.ux[b] - map.map.ux[a])) * map.drawn->scale[0];
    const double rows = -40 * (map.map.uy[b] - map.map.uy[a]) * map.drawn->scale[0] / 2;
    ck_assert_double_eq_tol(x[1] - x[0], columns, 1e-9);
    ck_assert_double_eq_tol(y[1] - y[0], rows, 1e-9);
    see_no_more(&map);
    scene_close(&scene);
    /* a slender beam is stretched, and that is said */
    open_scene(&scene, "moving-cantilever-coarse 80x24 500 upper 8");
    const Rect pane = screen_pane(&scene.screen, 80, 24, PANE_UPPER);
    see(&map, &scene, (Rect){pane.x + 1, pane.y + 1, pane.width - 2, pane.height - 2});
    ck_assert_double_gt(map.picture.stretch, 1);
    ck_assert_double_eq_tol(map.drawn->scale[1], map.picture.stretch * map.drawn->scale[0] / 2,
                            1e-9 * map.drawn->scale[1]);
    snprintf(wanted, sizeof wanted, "height x %.0f", map.picture.stretch);
    ck_assert_ptr_nonnull(find_row(&scene, wanted, row));
    see_no_more(&map);
    scene_close(&scene);
}
END_TEST

/* It goes with its displacement, however much that is enlarged. */
START_TEST(what_is_magnified_stays_in_the_middle)
{
    Scene scene;
    open_scene(&scene, "supported-beam-coarse 80x24 700 upper 8 focus 2 zoom magnified 8 at 0.5,0.5");
    Seen map;
    see(&map, &scene, (Rect){1, 2, 78, 20});
    const size_t nx = (size_t)map.map.body.nx, node = (size_t)map.map.body.ny / 2 * nx + nx / 2;
    ck_assert_double_gt(fabs(map.drawn->enlarged * map.map.uy[node] * map.drawn->scale[1]), 3);
    double column, row;
    node_place(&map, node, &column, &row);
    ck_assert_double_eq_tol(column, 39, map.map.body.spacing * map.drawn->scale[0]);
    ck_assert_double_eq_tol(row, 10, map.map.body.spacing * map.drawn->scale[1]);
    see_no_more(&map);
    scene_close(&scene);
}
END_TEST

/* The ramp holds all values, its ends are round, and that of a signed field is even. */
START_TEST(ramps_hold_their_values)
{
    Scene scene;
    open_scene(&scene, "notched-beam-coarse 80x24 800 upper 8");
    for (int variant = 0; variant < MAP_COLOURINGS; variant++) {
        Seen map;
        see(&map, &scene, (Rect){26, 1, 54, 8});
        if (!map_colour(&map.map, (MapVariant)variant)) { /* bonds have no stress */
            ck_assert(variant == MAP_BODY || variant >= MAP_SXX);
            see_no_more(&map);
            continue;
        }
        ck_assert_double_lt(map.drawn->low, map.drawn->high);
        if (map.map.colouring->is_signed)
            ck_assert_double_eq(map.drawn->low, -map.drawn->high);
        const double digits = map.drawn->high / pow(10, floor(log10(map.drawn->high)) - 1);
        ck_assert_double_eq_tol(digits, round(digits), 1e-6);
        for (size_t i = 0; i < map.map.body.count; i++) {
            ck_assert_double_ge(map.drawn->value[i], map.drawn->low - 1e-12);
            if (!map.drawn->open_ended)
                ck_assert_double_le(map.drawn->value[i], map.drawn->high * (1 + 1e-12));
        }
        size_t beyond = 0;
        for (size_t i = 0; i < map.map.body.count; i++)
            beyond += map.drawn->value[i] > map.drawn->high;
        ck_assert_uint_le(beyond, map.map.body.count / 100);
        see_no_more(&map);
    }
    scene_close(&scene);
}
END_TEST

/* Cells of a style among the nine about a place of the body. */
static int lines_near(const Scene *scene, const Seen *map, double x, double y, Style style)
{
    double place[2], column, row;
    map_body_place(&map->map, x, y, place);
    cells_place(map->drawn, map->rect, place[0], place[1], &column, &row);
    int count = 0;
    for (int i = -1; i <= 1; i++)
        for (int k = -1; k <= 1; k++) {
            const int at = map->rect.x + (int)floor(column) + i, down = map->rect.y + (int)floor(row) + k;
            count += at >= 0 && down >= 0 && at < scene->canvas.width && down < scene->canvas.height &&
                     scene->canvas.cells[down * scene->canvas.width + at].style == style;
        }
    return count;
}

/* The notch moved: notch and path of the run before stay on the map, faint, beside those of the present one.
 */
START_TEST(the_crack_before_stays)
{
    Scene scene;
    open_scene(&scene, "notched-beam-coarse 80x24 1400 upper 8 none pd.spacing=2e-3 pd.horizon=6.5e-3 "
                       "load.stress=1.8e8 ghost notch.position=0.085");
    const Rect whole = {0, 0, 80, 24};
    canvas_clear(&scene.canvas);
    Seen map;
    see(&map, &scene, whole);
    ck_assert(map_colour(&map.map, MAP_UY));
    map_add_lines(&map.map);
    cells_map_body(&map.picture, (Area){&scene.canvas, whole, GLYPHS_BRAILLE}, 0);
    const Ghost *ghost = &experiment_ghosts(scene.screen.experiment)[0];
    ShownRun runs[RUNS_MAX];
    ck_assert_int_eq(map_cracks_before(&map.map, runs), 1);
    const CrackLine *crack = &ghost->crack;
    ck_assert_uint_gt(crack->count, 10);
    for (size_t i = 0; i < crack->count; i++)
        ck_assert_msg(lines_near(&scene, &map, crack->x[i], crack->y[i], STYLE_FAINT) > 0 ||
                          lines_near(&scene, &map, crack->x[i], crack->y[i], STYLE_CHANGED) > 0,
                      "nothing at %g, %g", crack->x[i], crack->y[i]);
    const size_t half = crack->count / 2; /* there it is well to the left of the present one */
    ck_assert_int_gt(lines_near(&scene, &map, crack->x[half], crack->y[half], STYLE_FAINT), 0);
    ck_assert_double_gt(crack->x[half], 0.065);
    ck_assert_int_gt(lines_near(&scene, &map, 0.065, 0.01, STYLE_FAINT), 0);
    ck_assert_int_gt(lines_near(&scene, &map, 0.085, 0.01, STYLE_HEADING), 0);
    ck_assert_int_eq(lines_near(&scene, &map, 0.065, 0.01, STYLE_HEADING), 0);
    ck_assert_int_gt(lines_near(&scene, &map, 0.09, 0.025, STYLE_CHANGED), 0);
    ck_assert_double_eq(settings_notch(ghost->settings)->position, 0.065);
    see_no_more(&map);
    scene_close(&scene);
    open_scene(&scene, "notched-beam-coarse 80x24 5 upper 8 none ghost notch.position=0.085");
    see(&map, &scene, whole);
    ck_assert_int_eq(map_cracks_before(&map.map, runs), 0); /* it had not begun */
    see_no_more(&map);
    scene_close(&scene);
}
END_TEST

/* So do the cuts and cracks of a plate: dashed, the cut that was moved and the crack that grew from it. */
START_TEST(the_cracks_of_a_plate_stay)
{
    Scene scene;
    open_scene(&scene, "pulled-plate 80x24 300 upper 8 none pd.spacing=1e-3 pd.horizon=4e-3 "
                       "ghost cuts.edge.y1=8e-3");
    const Rect whole = {0, 0, 80, 24};
    canvas_clear(&scene.canvas);
    Seen map;
    ShownRun runs[RUNS_MAX];
    see(&map, &scene, whole);
    ck_assert(map_colour(&map.map, MAP_UY));
    map_add_lines(&map.map);
    cells_map_body(&map.picture, (Area){&scene.canvas, whole, GLYPHS_BRAILLE}, 0);
    ck_assert_int_eq(map_cracks_before(&map.map, runs), 1);
    const CrackLine *crack = runs[0].crack;
    size_t tip = 0;
    for (size_t i = 0; i < crack->count; i++)
        tip = crack->x[i] > crack->x[tip] ? i : tip;
    ck_assert_double_gt(crack->x[tip], 0.055);
    ck_assert_double_eq_tol(crack->y[tip], 0.02, 2e-3);
    ck_assert_int_gt(lines_near(&scene, &map, crack->x[tip] - 2e-3, crack->y[tip], STYLE_FAINT), 0);
    ck_assert_int_gt(lines_near(&scene, &map, 0.045, 0.02, STYLE_FAINT), 0);
    ck_assert_int_gt(lines_near(&scene, &map, 0.045, 0.0092, STYLE_HEADING), 0);
    see_no_more(&map);
    scene_close(&scene);
}
END_TEST

/* The share of the family falls towards the surface, to a half and less on it. */
START_TEST(the_skin_lacks_neighbours)
{
    Scene scene;
    open_scene(&scene, "supported-beam-coarse 80x24 0 upper 8");
    Seen map;
    see(&map, &scene, (Rect){26, 1, 54, 8});
    ck_assert(map_colour(&map.map, MAP_FAMILY));
    const size_t nx = (size_t)map.map.body.nx, middle = nx / 2;
    ck_assert_double_eq(map.drawn->value[(size_t)(map.map.body.ny / 2) * nx + middle], 1);
    ck_assert_double_eq_tol(map.drawn->value[middle], 28.0 / 48.0, 1e-12); /* of 48 neighbours 28 are left */
    see_no_more(&map);
    scene_close(&scene);
}
END_TEST

/* Cells with ink between two columns of a row of cells. */
static int ink(const Scene *scene, int from, int to, int y)
{
    int count = 0;
    for (int x = from; x < to; x++)
        count += scene->canvas.cells[y * scene->canvas.width + x].glyph > ' ';
    return count;
}

/* Near enough, whole bonds are lines; where the notch has cut them there is none but the notch's own. */
START_TEST(broken_bonds_are_missing)
{
    char row[256];
    Scene scene;
    open_scene(&scene, "notched-beam-coarse 80x24 0 upper 8 focus 2 zoom magnified 64 at 0.30952,0.1");
    ck_assert_ptr_nonnull(find_row(&scene, "lines: whole bonds", row));
    Seen map;
    see(&map, &scene, (Rect){1, 2, 78, 20});
    ck_assert(map.drawn->is_near);
    /* the notch stands in the middle: left and right of it, as wide as a spacing, is the gap */
    const int half = (int)(map.map.body.spacing * map.drawn->scale[0] / 2) - 2, middle = 1 + 39;
    ck_assert_int_gt(half, 2);
    const int spacing = 2 * (half + 2);
    for (int y = 3; y < 20; y++) {
        ck_assert_int_le(ink(&scene, middle - half, middle + half, y), 1);
        ck_assert_int_ge(ink(&scene, middle + half + 2, middle + half + 2 + spacing, y), 1);
    }
    see_no_more(&map);
    scene_close(&scene);
}
END_TEST

/* A word of view.colour is taken where the simulation has what it stands for, and chooses that variant. */
START_TEST(every_colour_word_is_known)
{
    static const char *const runs[] = {"supported-beam-coarse 80x24 0 upper 8",
                                       "supported-beam-mpm-coarse 80x24 0 upper 8",
                                       "two-discs 80x24 0 upper 8"};
    static const int expected[] = {11, 10, 13};
    for (int run = 0; run < 3; run++) {
        Scene scene;
        Status status = {STATUS_DONE, ""};
        open_scene(&scene, runs[run]);
        Settings settings = *experiment_settings(scene.screen.experiment);
        int found = 0, taken = 0;
        for (int i = 0; parameter_colour_words[i]; i++) {
            if (!settings_set(&settings, "view.colour", parameter_colour_words[i], &status)) {
                ck_assert_ptr_nonnull(strstr(status.text, "uy | ux | velocity | energy | "));
                continue;
            }
            taken++;
            screen_read_view(&scene.screen, settings_view(&settings));
            const int variant = view_variant(view_of_map(), &scene.screen);
            found += strcmp(view_variant_word(view_of_map(), &scene.screen, variant),
                            parameter_colour_words[i]) == 0;
        }
        ck_assert_int_eq(found, expected[run]);
        ck_assert_int_eq(taken, found); /* what there is not is refused, and nothing else is */
        ck_assert_int_eq(view_variants(view_of_map(), &scene.screen), found);
        ck_assert(!settings_set(&settings, "view.colour", "mauve", &status));
        ck_assert_ptr_nonnull(strstr(status.text, "uy | ux | velocity"));
        scene_close(&scene);
    }
}
END_TEST

/* The bending stress of a beam bent upwards: pulled above, pressed below, none in the middle. */
START_TEST(bending_stress_is_seen)
{
    Scene scene;
    open_scene(&scene, "supported-beam-mpm-coarse 80x24 0 upper 8");
    Seen map;
    see(&map, &scene, (Rect){26, 1, 54, 8});
    ck_assert(map_colour(&map.map, MAP_SXX));
    const size_t nx = (size_t)map.map.body.nx, ny = (size_t)map.map.body.ny;
    for (size_t j = 0; j < ny; j++) {
        const double share = map.drawn->value[j * nx + nx / 2] / map.drawn->value[nx / 2];
        ck_assert_double_eq_tol(share, 1 - 2 * (double)j / (double)(ny - 1), 0.3);
    }
    ck_assert_double_lt(map.drawn->value[nx / 2], -1e5);
    see_no_more(&map);
    scene_close(&scene);
}
END_TEST

/* --- the inspector ---------------------------------------------------------------------------------- */

/* The two numbers behind a name; and half a unit of the last digit of each. */
static void read_forces(const Scene *scene, const char *name, double out[2], double half[2])
{
    char row[256], digits[2][32];
    const char *found = find_row(scene, name, row);
    ck_assert_msg(found != NULL, "no row %s", name);
    ck_assert_int_eq(sscanf(found + strlen(name), "%31s %31s", digits[0], digits[1]), 2);
    for (int d = 0; d < 2; d++) {
        const char *point = strchr(digits[d], '.');
        out[d] = strtod(digits[d], NULL);
        half[d] = 0.5 * pow(10, point ? -(double)strlen(point + 1) : 0);
    }
}

/* What is printed adds up to what is printed, at every stage, and that is the force of the node. */
START_TEST(the_forces_add_up)
{
    static const int nodes[] = {14596 /* under the load */, 3640 /* at the notch */, 7455};
    char words[200], row[256];
    snprintf(words, sizeof words, "notched-beam-coarse 80x24 %d inspect focus 5 stage %d",
             suite_wide() ? 950 : 150, _i);
    Scene scene;
    open_scene(&scene, words);
    for (int n = 0; n < 3; n++) {
        if (!suite_wide() && n != _i % 3)
            continue;
        scene.screen.chosen.particle = (size_t)nodes[n];
        screen_draw(&scene.screen, &scene.canvas);
        double sides[3][2], all[2], load[2] = {0, 0}, f[2], half[2], last[2];
        read_forces(&scene, "bonds to the left", sides[0], half);
        read_forces(&scene, "bonds up and down", sides[1], half);
        read_forces(&scene, "bonds to the right", sides[2], half);
        read_forces(&scene, "all its bonds", all, half);
        const bool old = find_row(&scene, "f, of the last step", row) != NULL;
        const bool whole = find_row(&scene, "f of the node", row) != NULL;
        ck_assert_int_eq(old, _i == 2 || _i == 3);
        ck_assert_int_eq(whole, _i < 2 || _i > 4);
        read_forces(&scene,
                    old     ? "f, of the last step"
                    : whole ? "f of the node"
                            : "f, without the load",
                    f, last);
        if (whole)
            read_forces(&scene, "load on the node", load, (double[2]){0});
        for (int d = 0; d < 2; d++) {
            ck_assert_double_lt(fabs(sides[0][d] + sides[1][d] + sides[2][d] - all[d]), half[d] * (1 + 1e-9));
            if (!old)
                ck_assert_double_lt(fabs(all[d] + load[d] - f[d]), last[d]);
        }
        /* the node under the load feels it */
        if (whole)
            ck_assert_int_eq(load[1] < 0, n == 0);
        const char *power = find_row(&scene, "x10^", row);
        const char *names[] = {"fx", "fy"};
        int exponents[2];
        ck_assert_int_eq(sscanf(power, "x10^%d x10^%d", &exponents[0], &exponents[1]), 2);
        const Simulation *sim = experiment_simulation(scene.screen.experiment);
        for (int d = 0; d < 2; d++) {
            const int field = simulation_find_field(sim, 0, names[d]);
            const double unit = pow(10, exponents[d]), now = simulation_value(sim, field, (size_t)nodes[n]);
            ck_assert_double_le(fabs(f[d] - now / unit), last[d] * (1 + 1e-6));
        }
    }
    scene_close(&scene);
}
END_TEST

/* Weight is a load too, and so are the tractions on a plate. */
START_TEST(every_load_is_one)
{
    static const char *const scenes[] = {"hanging-beam 80x24 20 inspect focus 5 particle 900",
                                         "pulled-plate 80x24 20 inspect focus 5 particle 15950"};
    Scene scene;
    double all[2], load[2], f[2], half[2];
    open_scene(&scene, scenes[_i]);
    read_forces(&scene, "all its bonds", all, half);
    read_forces(&scene, "load on the node", load, half);
    read_forces(&scene, "f of the node", f, half);
    ck_assert_double_lt(fabs(all[1] + load[1] - f[1]), 3 * half[1]);
    ck_assert_double_gt(fabs(load[1]), 100 * half[1]);
    scene_close(&scene);
}
END_TEST

/* The number of percent that the reader sees is the largest stretch that the method knows. */
START_TEST(the_most_stretched_bond_is_named)
{
    char row[256];
    Scene scene;
    open_scene(&scene, "notched-beam-coarse 80x24 300 inspect focus 5 particle 3640");
    const Simulation *sim = experiment_simulation(scene.screen.experiment);
    double stretch = 0, percent = 0, said = 0;
    sim->method->field(sim, simulation_find_field(sim, 0, "stretch"), 3640, 1, &stretch);
    const char *found = find_row(&scene, "s = ", row);
    ck_assert_int_eq(sscanf(found, "s = %lf = %lf", &said, &percent), 2);
    ck_assert_double_eq_tol(said, stretch, 1e-3 * stretch);
    ck_assert_double_eq_tol(percent, 100 * stretch / 0.00085, 0.06);
    ck_assert_ptr_nonnull(find_row(&scene, "holds: below s0", row));
    scene_close(&scene);
    open_scene(&scene, "supported-beam-coarse 80x24 100 inspect focus 5");
    ck_assert_ptr_nonnull(find_row(&scene, "bonds never break here", row));
    scene_close(&scene);
    /* in a protected zone bonds are stretched beyond s0 and hold all the same */
    open_scene(&scene, "notched-beam-coarse 80x24 300 inspect focus 5 pd.critical_stretch=1e-4");
    sim = experiment_simulation(scene.screen.experiment);
    const int stretched = simulation_find_field(sim, 0, "stretch");
    size_t node = 0;
    for (stretch = 0; node < sim->counts[0] && stretch <= 1e-4; node++)
        sim->method->field(sim, stretched, node, 1, &stretch);
    ck_assert_uint_lt(node, sim->counts[0]);
    scene.screen.chosen.particle = node - 1;
    screen_draw(&scene.screen, &scene.canvas);
    ck_assert_ptr_nonnull(find_row(&scene, "holds: protected, near load or support", row));
    scene_close(&scene);
}
END_TEST

/* In the step in which the first bond breaks its node says so, with the other end and the stretch that broke
 * it: that of the two ends as they lie. A step before nothing is said of it, a step later only when it was.
 */
START_TEST(the_bond_that_breaks_is_named)
{
    enum { FIRST = 732 };
    char row[256];
    Scene scene;
    open_scene(&scene, "notched-beam-coarse 80x24 732 inspect focus 5");
    const long found = inspector_broken_node(&scene.screen, FIRST);
    ck_assert_int_ge(found, 0);
    scene.screen.chosen.particle = (size_t)found;
    screen_draw(&scene.screen, &scene.canvas);
    size_t ends[2] = {0, 0};
    double said = 0, percent = 0, critical = 0, at[2][2];
    ck_assert_int_eq(sscanf(find_row(&scene, "bond ", row), "bond %zu-%zu breaks", &ends[0], &ends[1]), 2);
    ck_assert_uint_eq(ends[0], (size_t)found);
    ck_assert_int_eq(
        sscanf(find_row(&scene, "s = ", row), "s = %lf = %lf %% of s0 = %lf", &said, &percent, &critical), 3);
    const Simulation *sim = experiment_simulation(scene.screen.experiment);
    double rest[2];
    for (int d = 0; d < 2; d++) {
        for (int end = 0; end < 2; end++)
            sim->method->field(sim, sim->position[d], ends[end], 1, &at[end][d]);
        rest[d] = at[1][d] - at[0][d];
        for (int end = 0; end < 2; end++) {
            double moved;
            sim->method->field(sim, sim->displacement[d], ends[end], 1, &moved);
            at[end][d] += moved;
        }
    }
    const double length = hypot(rest[0], rest[1]);
    const double stretch = hypot(at[1][0] - at[0][0], at[1][1] - at[0][1]) / length - 1;
    ck_assert_double_eq_tol(said, stretch, 1e-3 * stretch);
    ck_assert_double_eq(critical, 0.00085);
    ck_assert_double_ge(stretch, critical);
    ck_assert_double_eq_tol(percent, 100 * stretch / critical, 0.06);
    scene_close(&scene);
    snprintf(row, sizeof row, "notched-beam-coarse 80x24 731 inspect focus 5 particle %ld", found);
    open_scene(&scene, row);
    ck_assert_ptr_null(find_row(&scene, "breaks in this step", row));
    scene_close(&scene);
    snprintf(row, sizeof row, "notched-beam-coarse 80x24 733 inspect focus 5 particle %ld", found);
    open_scene(&scene, row);
    ck_assert_ptr_nonnull(find_row(&scene, "broke in step 732", row));
    scene_close(&scene);
}
END_TEST

/* A node at the notch has lost the bonds that cross it, and says so. */
START_TEST(the_notch_is_told_from_the_crack)
{
    char row[256];
    Scene scene;
    open_scene(&scene, "notched-beam-coarse 80x24 0 inspect focus 5 particle 2164"); /* row 10, left of it */
    ck_assert_ptr_nonnull(find_row(&scene, "48 bonds, 20 cut by the notch", row));
    int cut = 0, broken = 0;
    int top = 0;
    for (row_text(&scene, top, row); !strstr(row, "20 cut"); row_text(&scene, ++top, row))
        ;
    for (int y = top + 1; y <= top + 9; y++) {
        row_text(&scene, y, row);
        for (int x = 0; x < 37; x++) {
            cut += row[x] == '|';
            broken += row[x] == 'x';
        }
    }
    ck_assert_int_eq(cut, 20);
    ck_assert_int_eq(broken, 0);
    scene_close(&scene);
}
END_TEST

START_TEST(arrows_go_from_node_to_node)
{
    Scene scene;
    open_scene(&scene, "supported-beam-coarse 80x24 0 inspect focus 5 particle 1100"); /* nx 200, ny 10 */
    Screen *screen = &scene.screen;
    ck_assert(inspector_move(screen, 1, 0, 1));
    ck_assert_uint_eq(screen->chosen.particle, 1101);
    ck_assert(inspector_move(screen, 0, -1, 1)); /* up */
    ck_assert_uint_eq(screen->chosen.particle, 1301);
    ck_assert(inspector_move(screen, 0, 1, 10)); /* beyond the lowest row */
    ck_assert_uint_eq(screen->chosen.particle, 101);
    ck_assert(inspector_move(screen, -1, 0, 500));
    ck_assert_uint_eq(screen->chosen.particle, 0);
    scene_close(&scene);
}
END_TEST

/* --- the drawing ------------------------------------------------------------------------------------ */

START_TEST(the_drawing_has_its_dimensions)
{
    static const char *const wanted[] = {" 210 mm ", " 65 mm ",        " 105 mm ", " 17.5 mm ",
                                         " 70 mm ",  "60 MPa on 3 mm", "200 mm"};
    char row[256];
    Scene scene;
    open_scene(&scene, "notched-beam-coarse 80x24 0 upper 8 variant 10 focus 2 zoom");
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++)
        ck_assert_msg(find_row(&scene, wanted[i], row) != NULL, "no %s", wanted[i]);
    scene_close(&scene);
}
END_TEST

/* In few rows lengths are left out from the end, and nothing lies below the last row. */
START_TEST(a_drawing_keeps_to_its_rows)
{
    Scene scene;
    int before = 0;
    open_scene(&scene, "notched-beam-coarse 80x24 0 upper 8 variant 10");
    for (int rows = 4; rows <= 24; rows++) {
        Picture picture;
        int lengths = 0;
        bool notch = false;
        cells_open(&picture, 80, rows, GLYPHS_BRAILLE);
        map_drawing(&scene.screen, &picture);
        for (size_t i = 0; i < picture.plot.n_points; i++)
            ck_assert_double_ge(picture.plot.points[2 * i + 1], -(rows - 1) - 0.25);
        for (int i = 0; i < picture.n_labels; i++) {
            lengths += picture.labels[i].side == 0;
            notch |= strcmp(picture.labels[i].text, "65 mm") == 0;
        }
        /* three of the beam, one of the notch's place, one above and below the beam, the heading */
        ck_assert_int_eq(picture.has_axes, rows >= 7);
        ck_assert(picture.has_axes ? notch : picture.n_notes == 1);
        ck_assert_int_ge(lengths, before);
        before = lengths;
        picture_close(&picture);
    }
    ck_assert_int_eq(before, 4);
    scene_close(&scene);
}
END_TEST

/* Displacements may be drawn so large that the load leaves the picture, at any of its edges. */
START_TEST(what_is_drawn_far_too_large_stays_in_the_picture)
{
    for (int power = 2; power < 14; power++) {
        char words[160], row[256];
        Scene scene;
        snprintf(words, sizeof words, "notched-beam-coarse 80x24 2 upper 8 variant 4 view.exaggeration=1e%d",
                 power);
        open_scene(&scene, words);
        ck_assert_msg(find_row(&scene, " MPa x 0.", row), "1e%d times: no load in the picture", power);
        scene_close(&scene);
    }
}
END_TEST

/* Colours need no letters beside them, where colours are few they are what there is to see. */
START_TEST(letters_are_for_few_colours)
{
    static const char *const words[] = {"supported-beam-coarse 80x24 700 upper 8",
                                        "supported-beam-coarse 80x24 700 upper 8 ascii plain"};
    for (int few = 0; few < 2; few++) {
        int letters = 0, cells = 0;
        Scene scene;
        open_scene(&scene, words[few]);
        scene.screen.look.colours = few ? 0 : 256;
        screen_draw(&scene.screen, &scene.canvas);
        for (int i = 0; i < scene.canvas.width * scene.canvas.height; i++) {
            const Cell *cell = &scene.canvas.cells[i];
            if (cell->style < STYLE_RAMP_0 || cell->style >= STYLE_RAMP_0 + RAMP_STEPS)
                continue;
            letters += cell->glyph < 0x7f;
            cells++;
        }
        ck_assert_int_gt(cells, 30);
        ck_assert_msg(few ? letters == cells : letters == 0, "%d letters in %d cells: %s", letters, cells,
                      words[few]);
        scene_close(&scene);
    }
}
END_TEST

/* A disc of particles is as high as it is wide, counted in dots, and is not hidden by the other body or the
 * grid.
 */
START_TEST(a_disc_is_round)
{
    static const char *const words[] = {"two-discs 80x24 0 bare upper 8", "two-discs 132x43 0 bare upper 8",
                                        "two-discs 132x43 0 upper 8"};
    Scene scene;
    open_scene(&scene, words[_i]);
    const Rect pane = screen_pane(&scene.screen, scene.canvas.width, scene.canvas.height, PANE_UPPER);
    int low[2] = {INT_MAX, INT_MAX}, high[2] = {0, 0}, dots = 0;
    for (int i = 0; i < scene.canvas.width * scene.canvas.height; i++) {
        const Cell *cell = &scene.canvas.cells[i];
        if (i % scene.canvas.width >= pane.x + pane.width || cell->style != (unsigned)picture_kind_style(0) ||
            cell->glyph < 0x2800 || cell->glyph > 0x28ff)
            continue;
        for (int y = 0; y < 4; y++)
            for (int x = 0; x < 2; x++) {
                const int place[2] = {2 * (i % scene.canvas.width) + x, 4 * (i / scene.canvas.width) + y};
                if (!((cell->glyph - 0x2800) & glyph_dot(x, y)))
                    continue;
                dots++;
                for (int d = 0; d < 2; d++) {
                    low[d] = place[d] < low[d] ? place[d] : low[d];
                    high[d] = place[d] > high[d] ? place[d] : high[d];
                }
            }
    }
    const int wide = high[0] - low[0] + 1, tall = high[1] - low[1] + 1;
    ck_assert_int_gt(wide, _i == 2 ? 30 : 15);
    ck_assert_int_le(abs(wide - tall), 2);
    /* no square, and not a ring: particles that are seen apart leave gaps */
    ck_assert_double_lt(dots, 0.88 * wide * tall);
    ck_assert_double_gt(dots, 0.45 * wide * tall);
    scene_close(&scene);
}
END_TEST

/* Its arrow is in the picture, and no particle is under it; it is left out rather. */
START_TEST(gravity_hides_nothing)
{
    static const char *const words[] = {"bouncing-disc 80x24 300 upper 8", "falling-beam 80x24 100 upper 8",
                                        "roll-or-slide 80x24 900 upper 8"};
    static const int sizes[][2] = {{20, 14}, {24, 10}, {36, 12}, {52, 8}, {90, 30}};
    Scene scene;
    open_scene(&scene, words[_i]);
    int drawn = 0;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        Seen seen;
        see(&seen, &scene, (Rect){1, 1, sizes[i][0], sizes[i][1]});
        map_add_box(&seen.map);
        for (int a = 0; a < seen.picture.n_arrows; a++, drawn++) {
            const PictureArrow *arrow = &seen.picture.arrows[a];
            const double middle[2] = {(arrow->from[0] + arrow->to[0]) / 2,
                                      (arrow->from[1] + arrow->to[1]) / 2};
            ck_assert(picture_in_sight(&seen.picture, arrow->from[0], arrow->from[1], 0));
            ck_assert(picture_in_sight(&seen.picture, arrow->to[0], arrow->to[1], 0));
            const double *size = seen.map.body.size;
            ck_assert_msg(middle[0] > 0 &&
                              (middle[0] > size[0] || middle[0] < size[0] - .4 / seen.drawn->scale[0]),
                          "on a wall: %g", middle[0]);
            for (size_t k = 0; k < seen.map.body.count; k++)
                ck_assert_msg(fabs(seen.drawn->x[k] - middle[0]) * seen.drawn->scale[0] > 0.5 ||
                                  fabs(seen.drawn->y[k] - middle[1]) * seen.drawn->scale[1] > 1.5,
                              "%d columns: over particle %zu", sizes[i][0], k);
        }
        see_no_more(&seen);
    }
    ck_assert_int_ge(drawn, 3);
    scene_close(&scene);
}
END_TEST

/* What is behind the colours of the row below a map: the last number, its power of ten and its unit. */
static void scale_end(const Scene *scene, int columns, char *out)
{
    enum { ROWS = 20 };
    Seen seen;
    Scene drawn = {.scenario = ""};
    Status status = {STATUS_DONE, ""};
    ck_assert(canvas_open(&drawn.canvas, columns, ROWS, &status));
    see(&seen, scene, (Rect){1, 1, columns - 2, ROWS - 2});
    ck_assert(map_colour(&seen.map, MAP_MISES));
    cells_map(&seen.picture,
              (Area){.canvas = &drawn.canvas, .rect = {0, 0, columns, ROWS}, .glyphs = GLYPHS_BRAILLE},
              STYLE_HEADING, 256);
    int end = columns;
    while (end > 0 && drawn.canvas.cells[(ROWS - 1) * columns + end - 1].style < STYLE_RAMP_0)
        end--;
    char row[200];
    row_text(&drawn, ROWS - 1, row);
    snprintf(out, sizeof row, "%s", row + end);
    char *after = strstr(out, "  ");
    if (after)
        *after = '\0';
    const size_t length = strlen(out);
    if (length > 0 && out[length - 1] == ' ')
        out[length - 1] = '\0';
    see_no_more(&seen);
    canvas_close(&drawn.canvas);
}

/* In a narrow pane what is left out of the scale is not its last number or its power of ten. */
START_TEST(a_narrow_scale_tells_its_power)
{
    Scene scene;
    char wide[200], narrow[200];
    open_scene(&scene, "falling-beam 80x24 400 bare upper 8 variant 8");
    scale_end(&scene, 70, wide);
    ck_assert_msg(strstr(wide, "x10^"), "\"%s\"", wide);
    for (int columns = 20; columns < 70; columns++) {
        scale_end(&scene, columns, narrow);
        ck_assert_msg(strcmp(wide, narrow) == 0, "%d columns: \"%s\", not \"%s\"", columns, narrow, wide);
    }
    scene_close(&scene);
}
END_TEST

/* In the description of a map each body has the style that its name has below it. */
START_TEST(bodies_are_described_in_their_colours)
{
    Scene scene;
    open_scene(&scene, "two-discs 80x24 0 bare upper 8");
    scene.canvas.vectored = true;
    screen_draw(&scene.screen, &scene.canvas);
    const char *map = scene.canvas.vectors ? strstr(scene.canvas.vectors, ";M") : NULL;
    ck_assert_ptr_nonnull(map);
    int seen[2] = {0, 0};
    for (map = strchr(map, ' ') + 1; *map && *map != ';'; map++) {
        if (*map == '.' || (*map >= '0' && *map <= '9'))
            continue;
        const bool second = *map == '@' + (int)picture_kind_style(1);
        ck_assert_int_eq(*map, '@' + (int)picture_kind_style(second));
        seen[second]++;
    }
    ck_assert_int_gt(seen[0], 3);
    ck_assert_int_gt(seen[1], 3);
    scene_close(&scene);
}
END_TEST

/* Without colours two bodies differ in ink, and each has the sign of its name. */
START_TEST(bodies_differ_without_colours)
{
    static const char *const words[] = {"two-discs 80x24 0 bare upper 8 plain",
                                        "two-discs 80x24 0 bare upper 8 plain block",
                                        "two-discs 80x24 0 bare upper 8 plain ascii"};
    Scene scene;
    open_scene(&scene, words[_i]);
    uint32_t named[2] = {0, 0};
    int same[2] = {0, 0}, other[2] = {0, 0};
    for (int i = scene.canvas.width * scene.canvas.height - 1; i >= 0; i--) {
        const Cell *cell = &scene.canvas.cells[i];
        for (int body = 0; body < 2; body++) {
            if (cell->style != (unsigned)picture_kind_style(body) || cell->back || i < 2 * scene.canvas.width)
                continue;
            if (!named[body] && cell[1].glyph == ' ' && cell[2].glyph > ' ' && cell[2].glyph < 0x7f)
                named[body] = cell->glyph;
            else if (named[body])
                (cell->glyph == named[body] ? same : other)[body]++;
        }
    }
    ck_assert_uint_ne(named[0], named[1]);
    for (int body = 0; body < 2; body++)
        ck_assert_msg(same[body] >= 3, "body %d: %d of %d cells have the sign U+%04x", body, same[body],
                      same[body] + other[body], (unsigned)named[body]);
    scene_close(&scene);
}
END_TEST

/* Of particles seen apart those of more stress have more dots where no colour tells it. */
START_TEST(stress_is_ink_without_colours)
{
    Scene scene;
    open_scene(&scene, "colliding-rings 132x43 300 plain bare upper 8 variant 8");
    int dots[2] = {0, 0}, cells[2] = {0, 0};
    const Rect map = screen_pane(&scene.screen, scene.canvas.width, scene.canvas.height, PANE_UPPER);
    for (int i = 0; i < scene.canvas.width * (map.y + map.height - 1); i++) {
        const Cell *cell = &scene.canvas.cells[i];
        const int step = cell->style - STYLE_RAMP_0;
        if (step < 0 || cell->glyph < 0x2800 || cell->glyph > 0x28ff)
            continue;
        const bool high = step >= RAMP_STEPS / 2;
        cells[high]++;
        dots[high] += __builtin_popcount(cell->glyph & 0xff);
    }
    ck_assert_int_gt(cells[0], 5);
    ck_assert_int_gt(cells[1], 5);
    ck_assert_double_lt((double)dots[0] / cells[0], 0.7 * dots[1] / cells[1]);
    scene_close(&scene);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *map = tcase_create("map");
    tcase_add_loop_test(map, a_node_is_found_where_it_is_drawn, 0, 4);
    tcase_add_test(map, factors_are_those_that_are_stated);
    tcase_add_test(map, what_is_drawn_far_too_large_stays_in_the_picture);
    tcase_add_test(map, what_is_magnified_stays_in_the_middle);
    tcase_add_test(map, a_drawing_keeps_to_its_rows);
    tcase_add_test(map, ramps_hold_their_values);
    tcase_add_test(map, the_crack_before_stays);
    tcase_add_test(map, the_cracks_of_a_plate_stay);
    tcase_add_test(map, letters_are_for_few_colours);
    tcase_add_test(map, the_skin_lacks_neighbours);
    tcase_add_test(map, broken_bonds_are_missing);
    tcase_add_test(map, every_colour_word_is_known);
    tcase_add_test(map, bending_stress_is_seen);
    tcase_add_test(map, the_drawing_has_its_dimensions);
    tcase_add_loop_test(map, a_disc_is_round, 0, 3);
    tcase_add_loop_test(map, gravity_hides_nothing, 0, 3);
    tcase_add_test(map, a_narrow_scale_tells_its_power);
    tcase_add_test(map, bodies_are_described_in_their_colours);
    tcase_add_loop_test(map, bodies_differ_without_colours, 0, 3);
    tcase_add_test(map, stress_is_ink_without_colours);
    suite_add_tcase(suite, map);
    TCase *family = tcase_create("family");
    tcase_add_loop_test(family, the_forces_add_up, 0, 7);
    tcase_add_loop_test(family, every_load_is_one, 0, 2);
    tcase_add_test(family, the_most_stretched_bond_is_named);
    if (suite_wide()) /* 700 steps of a beam */
        tcase_add_test(family, the_bond_that_breaks_is_named);
    tcase_add_test(family, the_notch_is_told_from_the_crack);
    tcase_add_test(family, arrows_go_from_node_to_node);
    suite_add_tcase(suite, family);
}
