/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One cell from near: the terms on its arrows are those of the written sums, they add up to what the receiver
 * has, and cells, paper and words have the same. */
#include "picture/cells/cells.h"
#include "picture/paper/figure_file.h"
#include "picture/words/tell.h"
#include "suite.h"
#include "views/scene.h"
#include "views/view.h"
#include "panes/screen.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Drawing {
    Scene scene;
    Screen *screen;
    const Simulation *sim;
    Picture picture;
    char sums[8192]; /* of the box */
} Drawing;

static void describe_again(Drawing *drawing)
{
    const Screen *screen = drawing->screen;
    const int set = screen->chosen.is_node;
    view_describe(view_named("cell"), screen, 84, 25, &drawing->picture);
    drawing->sums[0] = '\0';
    if (drawing->sim->stage > 0 && drawing->sim->method->explain)
        drawing->sim->method->explain(
            drawing->sim, drawing->sim->stage - 1, set, set ? screen->chosen.node : screen->chosen.particle,
            experiment_before(screen->experiment), 0, drawing->sums, sizeof drawing->sums);
}

static void open_drawing(Drawing *drawing, const char *words)
{
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scene_open(&drawing->scene, words, &status), "%s: %s", words, status.text);
    drawing->screen = &drawing->scene.screen;
    drawing->sim = experiment_simulation(drawing->screen->experiment);
    describe_again(drawing);
}

static void close_drawing(Drawing *drawing)
{
    picture_close(&drawing->picture);
    scene_close(&drawing->scene);
}

/* Arrows between nodes and particles; the others lie along the grid. */
static bool passes(const PictureArrow *arrow)
{
    return arrow->text[0][0] != '\0';
}

static int count_passing(const Picture *picture)
{
    int count = 0;
    for (int i = 0; i < picture->n_arrows; i++)
        count += passes(&picture->arrows[i]);
    return count;
}

static int count_bands(const Picture *picture)
{
    int count = 0;
    for (int i = 0; i < picture->plot.n_strokes; i++)
        count += picture->plot.strokes[i].kind == STROKE_BAND;
    return count;
}

static const char *label_of(const Picture *picture, const char *thing, size_t index)
{
    char begin[32];
    snprintf(begin, sizeof begin, "%zu", index);
    const size_t length = strlen(begin);
    for (int i = 0; i < picture->n_labels; i++) {
        const char *text = picture->labels[i].text;
        if (picture->labels[i].thing && strcmp(picture->labels[i].thing, thing) == 0 &&
            strncmp(text, begin, length) == 0 && (text[length] == '\0' || text[length] == '\n'))
            return text;
    }
    return NULL;
}

/* Every term of the chosen particle is a number of the sums that the box writes. */
START_TEST(terms_are_those_of_the_box)
{
    static const char *const words[] = {"mode1 80x24 3 stage 1", "mode5 80x24 700 stage 1",
                                        "mode5 80x24 700 stage 4", "mode5 80x24 700 stage 1 mpm.shape=gimp",
                                        "mode5 80x24 700 stage 1 mpm.shape=bspline3"};
    for (size_t k = 0; k < sizeof words / sizeof *words; k++) {
        Drawing drawing;
        open_drawing(&drawing, words[k]);
        ck_assert_int_ge(count_passing(&drawing.picture), 2);
        for (int i = 0; i < drawing.picture.n_arrows; i++) {
            const PictureArrow *arrow = &drawing.picture.arrows[i];
            const char *number = arrow->brief[0];
            if (passes(arrow) && fabs(strtod(number, NULL)) > 0)
                ck_assert_msg(strstr(drawing.sums, number + (*number == '-')), "%s: %s is not in %s",
                              words[k], number, drawing.sums);
        }
        close_drawing(&drawing);
    }
}
END_TEST

/* What arrives at a node adds up to what stands there, as it is printed; with many particles too. */
START_TEST(terms_add_up_at_the_node)
{
    static const char *const words[] = {"mode5 80x24 700 stage 1 node", "mode5 80x24 700 stage 4 node",
                                        "mode5 80x24 700 stage 1 node mesh.particles_per_cell=8",
                                        "mode5 80x24 700 stage 1 node mpm.shape=bspline2"};
    for (size_t k = 0; k < sizeof words / sizeof *words; k++) {
        Drawing drawing;
        open_drawing(&drawing, words[k]);
        const bool forces = strstr(words[k], "stage 4") != NULL;
        const size_t node = drawing.screen->chosen.node;
        double sum = 0;
        for (int i = 0; i < drawing.picture.n_arrows; i++) {
            if (!passes(&drawing.picture.arrows[i]))
                continue;
            sum += strtod(drawing.picture.arrows[i].brief[0], NULL);
        }
        for (int i = 0; i < drawing.picture.n_labels; i++) {
            char *more = strstr(drawing.picture.labels[i].text, " more: ");
            if (more)
                sum += strtod(strrchr(strtok(more, ","), ' '), NULL);
        }
        const double whole = simulation_value(
            drawing.sim, simulation_find_field(drawing.sim, 1, forces ? "f_int" : "momentum"), node);
        ck_assert_msg(fabs(sum - whole) < 1e-4 * fabs(whole) + 1e-9, "%s: %g is not %g", words[k], sum,
                      whole);
        close_drawing(&drawing);
    }
}
END_TEST

/* From particles to nodes in the stages that give, back in those that take; a support's change is told. */
START_TEST(arrows_point_where_it_flows)
{
    static const struct {
        int stage, passing;
        bool up;
    } stages[] = {{1, 2, true}, {2, 0, true}, {3, 2, false}, {4, 2, true}, {5, 0, true}, {6, 2, false}};
    for (size_t k = 0; k < sizeof stages / sizeof *stages; k++) {
        char words[64];
        snprintf(words, sizeof words, "mode1 80x24 3 stage %d", stages[k].stage);
        Drawing drawing;
        open_drawing(&drawing, words);
        ck_assert_int_eq(count_passing(&drawing.picture), stages[k].passing);
        for (int i = 0; i < drawing.picture.n_arrows; i++) {
            const PictureArrow *arrow = &drawing.picture.arrows[i];
            if (passes(arrow))
                ck_assert((arrow->to[1] > arrow->from[1]) == stages[k].up);
        }
        close_drawing(&drawing);
    }
    Drawing drawing;
    open_drawing(&drawing, "mode1 80x24 3 stage 2 particle 0");
    ck_assert_ptr_nonnull(strstr(label_of(&drawing.picture, "node", 0), "→0"));
    close_drawing(&drawing);
}
END_TEST

/* The last stage resets the grid: nothing passes, and the nodes hold neither mass nor momentum. */
START_TEST(nodes_of_a_reset_grid_are_empty)
{
    Drawing drawing;
    open_drawing(&drawing, "mode1 80x24 3 stage 6");
    ck_assert_int_ge(count_bands(&drawing.picture), 4);
    close_drawing(&drawing);
    open_drawing(&drawing, "mode1 80x24 3 stage 7");
    ck_assert_int_eq(drawing.picture.n_arrows, 0);
    ck_assert_int_eq(count_bands(&drawing.picture), 0);
    close_drawing(&drawing);
}
END_TEST

static double sum_of_arrows(const Picture *picture)
{
    double sum = 0;
    for (int i = 0; i < picture->n_arrows; i++)
        if (passes(&picture->arrows[i]))
            sum += strtod(picture->arrows[i].brief[0], NULL);
    return sum;
}

/* Where masses are shared, M v = p at the node, as it is printed; its row adds up to what lumping gives it.
 */
START_TEST(row_of_masses_adds_up)
{
    static const char *const shapes[] = {"hat", "gimp", "bspline2", "bspline3"};
    for (size_t k = 0; k < sizeof shapes / sizeof *shapes; k++)
        for (int masses = 0; masses <= 1; masses++) {
            char words[128];
            snprintf(words, sizeof words,
                     "mode5 80x24 700 stage 2 node mpm.mass_blend=0.5 mpm.shape=%s variant %d", shapes[k],
                     masses);
            Drawing drawing;
            open_drawing(&drawing, words);
            const size_t node = drawing.screen->chosen.node;
            const Picture *picture = &drawing.picture;
            const double momentum =
                simulation_value(drawing.sim, simulation_find_field(drawing.sim, 1, "momentum"), node);
            const double mass =
                simulation_value(drawing.sim, simulation_find_field(drawing.sim, 1, "mass"), node);
            double sum = 0;
            for (int i = 0; i < picture->n_labels; i++) {
                const char *share = strstr(picture->labels[i].text, "\nM ");
                sum += share ? strtod(share + 3, NULL) : 0;
            }
            ck_assert_msg(fabs(sum - mass) < 5e-5, "%s: %g is not %g", words, sum, mass); /* five digits */
            if (!masses)
                ck_assert_msg(fabs(sum_of_arrows(picture) - momentum) < 1e-4 * fabs(momentum), "%s", words);
            else
                ck_assert_int_eq(count_passing(picture), 0);
            close_drawing(&drawing);
        }
    Drawing drawing;
    open_drawing(&drawing, "mode5 80x24 700 stage 1 node variant 1");
    ck_assert_ptr_nonnull(strstr(label_of(&drawing.picture, "node", drawing.screen->chosen.node), "\nM "));
    close_drawing(&drawing);
}
END_TEST

/* Every term stands on the screen at 60x18, in any letters, and in words. */
START_TEST(screen_and_words_have_the_terms)
{
    static const char *const looks[] = {"", " ascii", " block"};
    for (size_t k = 0; k < sizeof looks / sizeof *looks; k++) {
        char words[96];
        Drawing drawing;
        snprintf(words, sizeof words, "mode1 60x18 3 stage 1 upper cell focus 2%s", looks[k]);
        open_drawing(&drawing, words);
        char *dump = canvas_dump(&drawing.scene.canvas);
        Words told = {.text = NULL};
        tell_view(drawing.screen, view_named("cell"), &told);
        for (int i = 0; i < drawing.picture.n_arrows; i++)
            if (passes(&drawing.picture.arrows[i])) {
                const char *number = drawing.picture.arrows[i].brief[0];
                ck_assert_msg(strstr(dump, number), "%s: %s is not in\n%s", words, number, dump);
                ck_assert_msg(strstr(told.text, number), "%s: %s is not in\n%s", words, number, told.text);
            }
        free(dump);
        words_close(&told);
        close_drawing(&drawing);
    }
}
END_TEST

START_TEST(paper_has_the_terms)
{
    Drawing drawing;
    Figure figure;
    Status status = {STATUS_DONE, ""};
    open_drawing(&drawing, "mode1 80x24 3 stage 4");
    figure_open(&figure, 0, 0);
    ck_assert(figure_add(&figure, drawing.screen, view_named("cell"), 1, &status));
    ck_assert_msg(figure_write(&figure, ASKER_COMMAND_LINE, "check_cell.svg", true, &status), "%s",
                  status.text);
    figure_close(&figure);
    static char text[1 << 18];
    FILE *stream = fopen("check_cell.svg", "r");
    ck_assert_ptr_nonnull(stream);
    text[fread(text, 1, sizeof text - 1, stream)] = '\0';
    fclose(stream);
    remove("check_cell.svg");
    for (int i = 0; i < drawing.picture.n_arrows; i++)
        if (passes(&drawing.picture.arrows[i])) {
            const char *number = drawing.picture.arrows[i].brief[0];
            ck_assert_msg(strstr(text, number + (*number == '-')), "%s is not drawn", number);
        }
    ck_assert_ptr_nonnull(strstr(text, "node 12"));
    close_drawing(&drawing);
}
END_TEST

/* The factors of the strongest bond are its pull, which the box has first; those of a family
 * that are told one by one are the strongest, and with the others add up to the node's force. */
START_TEST(bonds_are_those_of_the_box)
{
    static const char *const words[] = {"mode5-peridynamics 80x24 200 stage 4",
                                        "supported-beam-coarse 80x24 100 stage 4",
                                        "supported-beam-coarse 80x24 100 stage 4 pd.influence=conical"};
    for (size_t k = 0; k < sizeof words / sizeof *words; k++) {
        Drawing drawing;
        open_drawing(&drawing, words[k]);
        const Picture *picture = &drawing.picture;
        const char *product = NULL;
        bool named = false;
        for (int i = 0; i < picture->n_labels; i++) {
            product =
                strncmp(picture->labels[i].text, "c G w V s = ", 12) == 0 ? picture->labels[i].text : product;
            named |= strncmp(picture->labels[i].text, "micromodulus c ", 15) == 0;
        }
        ck_assert_ptr_nonnull(product);
        ck_assert_msg(named, "%s: the factors have no words", words[k]);
        double factors = 1;
        for (const char *at = product + 12; at;
             at = strstr(at, "× ") ? strstr(at, "× ") + strlen("× ") : NULL)
            factors *= strtod(at, NULL);
        const char *pull = strstr(product, " = ") + 3;
        pull = strstr(pull, " = ") + 3;
        ck_assert_msg(fabs(factors - strtod(pull, NULL)) < 2e-4 * fabs(factors), "%s: %g: %s", words[k],
                      factors, product);
        const bool plane = k > 0;
        const char *to = strstr(picture->name, " to ");
        char strongest[48];
        ck_assert_ptr_nonnull(to);
        snprintf(strongest, sizeof strongest, "%.*s: c G w V s = ", (int)strcspn(to + 1, ","), to + 1);
        ck_assert_msg(strstr(drawing.sums, strongest), "%s is not in %s", strongest, drawing.sums);
        char number[32];
        snprintf(number, sizeof number, "= %.*s", (int)strcspn(pull, " "), pull);
        ck_assert_msg(strstr(drawing.sums, number), "%s is not in %s", number, drawing.sums);
        view_choose_variant(view_named("cell"), drawing.screen, 1);
        picture_close(&drawing.picture);
        describe_again(&drawing);
        double before = INFINITY;
        int told = 0;
        for (int i = 0; i < picture->n_labels; i++) {
            const char *text = picture->labels[i].text, *value = strstr(text, "  ");
            if (!value || text[1] != ' ')
                continue;
            ck_assert(fabs(strtod(value, NULL)) <= before);
            before = fabs(strtod(value, NULL));
            told++;
        }
        ck_assert_int_ge(told, plane ? 8 : 6);
        close_drawing(&drawing);
    }
}
END_TEST

/* In the plane the shares of a particle's nodes add up to all of it. */
START_TEST(shares_in_the_plane_add_up)
{
    static const char *const words[] = {"moving-cantilever-hat-coarse 80x24 10 particle 1575",
                                        "moving-cantilever-mpm 80x24 0 particle 1575"};
    for (size_t k = 0; k < sizeof words / sizeof *words; k++) {
        Drawing drawing;
        open_drawing(&drawing, words[k]);
        double sum = 0;
        int nodes = 0;
        for (int i = 0; i < drawing.picture.n_labels; i++) {
            const char *share = strstr(drawing.picture.labels[i].text, "\nN ");
            sum += share ? strtod(share + 3, NULL) : 0;
            nodes += share != NULL;
        }
        ck_assert_msg(fabs(sum - 1) < 1e-4, "%s: %g", words[k], sum);
        ck_assert_int_ge(nodes, 4);
        ck_assert_int_eq(drawing.picture.n_arrows, nodes);
        close_drawing(&drawing);
    }
}
END_TEST

/* In the plane an arrow has the product of the factors that the method gives for the pair, in every exchange
 * of the stage, the strongest first; with the rest they add up to all that passes. */
START_TEST(terms_in_the_plane_are_the_methods)
{
    static const struct {
        const char *words;
        int flows;
    } cases[] = {{"supported-beam-mpm-coarse 80x24 100 stage 1 upper cell", 3},
                 {"supported-beam-mpm-coarse 80x24 100 stage 3 upper cell", 3},
                 {"supported-beam-mpm-coarse 80x24 100 stage 4 upper cell", 2},
                 {"supported-beam-mpm-coarse 80x24 100 stage 6 upper cell mpm.algorithm=musl", 4},
                 {"moving-cantilever-mpm 80x24 10 stage 3 upper cell particle 1575", 3}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        Drawing drawing;
        open_drawing(&drawing, cases[k].words);
        const Simulation *sim = drawing.sim;
        const Picture *picture = &drawing.picture;
        const size_t particle = drawing.screen->chosen.particle;
        char *dump = canvas_dump(&drawing.scene.canvas);
        Link links[32];
        const size_t n_links = sim->method->links(sim, 0, particle, links, 32);
        int flows = 0;
        ck_assert_int_eq(picture->n_arrows, (int)n_links);
        for (int e = 0; e < sim->n_exchanges; e++) {
            const Exchange *exchange = &sim->exchanges[e];
            if (strcmp(exchange->stage, sim->stages[sim->stage - 1].id) != 0)
                continue;
            double terms[32], whole = 0, size = 0, sum = 0, before = INFINITY;
            flows++;
            for (size_t i = 0; i < n_links; i++) {
                const ExchangeTerm term = simulation_exchange(sim, e, particle, &links[i]);
                terms[i] = term.product;
                ck_assert_int_gt(term.count, 0);
                whole += terms[i];
                size = fmax(size, fabs(terms[i]));
            }
            for (int a = 0; a < picture->n_arrows; a++) {
                const PictureArrow *arrow = &picture->arrows[a];
                size_t i = 0;
                const char *node = strstr(arrow->told, "node ");
                while (node && i + 1 < n_links && links[i].index != strtoul(node + 5, NULL, 10))
                    i++;
                for (int f = 0; passes(arrow) && f < PICTURE_ARROW_LINES; f++) {
                    const size_t length = strlen(exchange->factors);
                    if (strncmp(arrow->text[f], exchange->factors, length) != 0 ||
                        arrow->text[f][length] != ' ')
                        continue;
                    const double term = strtod(arrow->brief[f], NULL);
                    ck_assert_msg(fabs(term - terms[i]) <= 1e-4 * size, "%s: %s is not %g", cases[k].words,
                                  arrow->text[f], terms[i]);
                    ck_assert(f > 0 || fabs(term) <= before + 1e-4 * size);
                    before = f > 0 ? before : fabs(term);
                    sum += term;
                    ck_assert_msg(f > 0 || a > 0 || strstr(dump, arrow->brief[0]), "%s is not in\n%s",
                                  arrow->brief[0], dump);
                }
            }
            for (int i = 0; i < picture->n_labels; i++) {
                const char *more = strstr(picture->labels[i].text, " more: ");
                more = more ? strstr(more, exchange->factors) : NULL;
                sum += more ? strtod(more + strlen(exchange->factors), NULL) : 0;
            }
            ck_assert_msg(fabs(sum - whole) <= 2e-4 * size, "%s, %s: %g is not %g", cases[k].words,
                          exchange->factors, sum, whole);
        }
        ck_assert_int_eq(flows, cases[k].flows);
        free(dump);
        close_drawing(&drawing);
    }
}
END_TEST

/* At nodes that two bodies share: the normal has length 1, and what one body gives is what its momentum has
 * lost and that of the other has gained. */
START_TEST(contact_is_drawn)
{
    Drawing drawing;
    open_drawing(&drawing, "two-discs 132x43 190 stage 2 upper cell particle 191");
    const Picture *picture = &drawing.picture;
    const Experiment *experiment = drawing.screen->experiment;
    int shared = 0, given = 0, normals = 0, velocities = 0, keys = 0;
    for (int i = 0; i < picture->n_labels; i++) {
        const char *text = picture->labels[i].text, *bar = strstr(text, " | "),
                   *gives = strstr(text, "gives ");
        if (!bar)
            continue;
        const size_t node[2] = {strtoul(text, NULL, 10), strtoul(bar + 3, NULL, 10)};
        double n[2], impulse[2] = {0, 0}, most = 1e-30;
        shared++;
        ck_assert_int_eq(sscanf(strstr(text, "\nn ") + 3, "%lf %lf", &n[0], &n[1]), 2);
        ck_assert_double_eq_tol(n[0] * n[0] + n[1] * n[1], 1, 1e-2);
        given += sscanf(gives + 6, "%lf %lf", &impulse[0], &impulse[1]) == 2;
        for (int k = 0; k < 2; k++)
            for (int d = 0; d < 2; d++) {
                double before;
                const int field = simulation_find_field(drawing.sim, 1, d ? "py" : "px");
                const double now = simulation_value(drawing.sim, field, node[k]);
                ck_assert(experiment_field_before(experiment, field, node[k], 1, &before));
                most = fmax(most, fabs(now) + fabs(before));
                ck_assert_double_eq_tol(now - before, k ? impulse[d] : -impulse[d], 1e-3 * most);
            }
    }
    for (int a = 0; a < picture->n_arrows; a++) {
        normals += strstr(picture->arrows[a].told, ": n ") != NULL;
        velocities += strstr(picture->arrows[a].told, ": v ") != NULL;
    }
    for (int k = 0; k < picture->n_keys; k++)
        keys += strcmp(picture->keys[k].name, "left") == 0 || strcmp(picture->keys[k].name, "right") == 0;
    ck_assert_int_gt(given, 0);
    ck_assert_int_gt(shared, 1);
    ck_assert_int_eq(normals, 1); /* of the node with most of the particle */
    ck_assert_int_eq(velocities, 2);
    ck_assert_ptr_nonnull(strstr(drawing.sums, "right: v = ("));
    ck_assert_int_eq(keys, 2);
    close_drawing(&drawing);
}
END_TEST

/* No word is over a bar: the columns of bars are the same with the words as without them. */
START_TEST(words_leave_bars_free)
{
    static const char *const words[] = {
        "mode1 80x24 3 stage 1 upper cell focus 2 zoom", "mode1 60x18 3 stage 2 upper cell focus 2",
        "mode5 80x24 700 stage 1 node upper cell", "mode5 80x24 700 stage 1 mpm.shape=bspline3 upper cell"};
    static const int widths[] = {84, 44};
    enum { ROWS = 25 };
    for (size_t k = 0; k < 2 * sizeof words / sizeof *words; k++) {
        const int width = widths[k % 2];
        Drawing drawing;
        Canvas with = {0}, without = {0};
        Status status = {STATUS_DONE, ""};
        int bars = 0;
        open_drawing(&drawing, words[k / 2]);
        Picture *picture = &drawing.picture;
        picture_close(picture);
        view_describe(view_named("cell"), drawing.screen, width, ROWS, picture);
        ck_assert(canvas_open(&with, width, ROWS, &status) && canvas_open(&without, width, ROWS, &status));
        cells_draw(picture, (Area){&with, {0, 0, width, ROWS}, GLYPHS_BRAILLE}, STYLE_NORMAL, 256);
        picture->n_labels = 0;
        cells_draw(picture, (Area){&without, {0, 0, width, ROWS}, GLYPHS_BRAILLE}, STYLE_NORMAL, 256);
        for (int i = 0; i < width * ROWS; i++)
            if (without.cells[i].style == STYLE_SECOND || without.cells[i].style == STYLE_PREDICTED) {
                ck_assert_uint_eq(with.cells[i].glyph, without.cells[i].glyph);
                bars++;
            }
        ck_assert_int_gt(bars, 2);
        canvas_close(&with);
        canvas_close(&without);
        close_drawing(&drawing);
    }
}
END_TEST

START_TEST(mouse_chooses_what_is_drawn)
{
    Drawing drawing;
    open_drawing(&drawing, "mode1 60x18 3 stage 1 upper cell focus 2");
    const Rect rect = screen_pane(drawing.screen, 60, 18, PANE_UPPER);
    bool seen[2] = {false, false};
    for (int y = rect.y; y < rect.y + rect.height; y++)
        for (int x = rect.x; x < rect.x + rect.width; x++) {
            ck_assert(screen_click_view(drawing.screen, 60, 18, x, y) || y == rect.y);
            seen[drawing.screen->chosen.is_node] = true;
        }
    ck_assert(seen[0] && seen[1]);
    const size_t first = drawing.screen->chosen.particle;
    ck_assert(screen_click_view(drawing.screen, 60, 18, rect.x, rect.y + rect.height - 2));
    ck_assert(!drawing.screen->chosen.is_node && drawing.screen->chosen.particle < first);
    ck_assert(!screen_click_view(drawing.screen, 60, 18, 3, 0));
    close_drawing(&drawing);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *cases = tcase_create("cell");
    tcase_add_test(cases, terms_are_those_of_the_box);
    tcase_add_test(cases, terms_add_up_at_the_node);
    tcase_add_test(cases, arrows_point_where_it_flows);
    tcase_add_test(cases, nodes_of_a_reset_grid_are_empty);
    tcase_add_test(cases, row_of_masses_adds_up);
    tcase_add_test(cases, screen_and_words_have_the_terms);
    tcase_add_test(cases, paper_has_the_terms);
    tcase_add_test(cases, bonds_are_those_of_the_box);
    tcase_add_test(cases, shares_in_the_plane_add_up);
    tcase_add_test(cases, terms_in_the_plane_are_the_methods);
    tcase_add_test(cases, contact_is_drawn);
    tcase_add_test(cases, words_leave_bars_free);
    tcase_add_test(cases, mouse_chooses_what_is_drawn);
    suite_add_tcase(suite, cases);
}
