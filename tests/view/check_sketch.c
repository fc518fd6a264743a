/* A sketch holds what a view shows, in the view's own numbers: strokes against the record, words against the
 * heading and the legend. */
#include "suite.h"
#include "view/scene.h"

#include <math.h>
#include <string.h>

/* In place: the screen points into its scene. */
static void open_scene(Scene *scene, const char *words)
{
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scene_open(scene, words, &status), "%s: %s", words, status.text);
}

static const Stroke *stroke_of(const Sketch *sketch, Style style)
{
    for (int i = 0; i < sketch->plot.n_strokes; i++)
        if (sketch->plot.strokes[i].style == style)
            return &sketch->plot.strokes[i];
    return NULL;
}

static bool has_key(const Sketch *sketch, const char *name)
{
    for (int i = 0; i < sketch->n_keys; i++)
        if (strcmp(sketch->keys[i].name, name) == 0)
            return true;
    return false;
}

START_TEST(curve_over_time_is_the_record)
{
    Scene scene;
    open_scene(&scene, "mode1 80x24 900");
    const Record *record = experiment_record(scene.screen.experiment);
    scene.screen.window = 10;
    Sketch sketch;
    screen_sketch(&scene.screen, 2, 84, 25, &sketch);
    ck_assert(sketch.has_axes);
    ck_assert_str_eq(sketch.x_name, "t");
    ck_assert(strncmp(sketch.heading, "v_cm", 4) == 0);
    ck_assert(has_key(&sketch, "measured") && has_key(&sketch, "exact") && has_key(&sketch, "predicted"));
    const Stroke *measured = stroke_of(&sketch, STYLE_MEASURED);
    ck_assert_ptr_nonnull(measured);
    /* 901 rows are fewer than what paper can tell apart: every one is a point of the line */
    ck_assert_uint_eq(measured->count, 901);
    for (size_t i = 0; i < measured->count; i++) {
        const double *row = record_row(record, i), *point = sketch.plot.points + 2 * (measured->first + i);
        ck_assert_double_eq(point[0], row[1]);
        ck_assert_double_eq(point[1], row[2]);
    }
    ck_assert_int_gt(sketch.n_notes, 0);
    ck_assert_ptr_nonnull(strstr(sketch.notes[0].text, "w measured"));
    sketch_close(&sketch);
    scene_close(&scene);
}
END_TEST

START_TEST(profile_is_the_field)
{
    Scene scene;
    open_scene(&scene, "mode5 80x24 300");
    const Simulation *sim = experiment_simulation(scene.screen.experiment);
    Sketch sketch;
    screen_sketch(&scene.screen, 1, 84, 25, &sketch);
    const Stroke *measured = stroke_of(&sketch, STYLE_MEASURED);
    ck_assert_ptr_nonnull(measured);
    ck_assert_uint_eq(measured->count, sim->counts[0]);
    const int field = simulation_find_field(sim, 0, "u");
    for (size_t i = 0; i < measured->count; i++) {
        double value;
        sim->method->field(sim, field, i, 1, &value);
        ck_assert_double_eq(sketch.plot.points[2 * (measured->first + i) + 1], value);
    }
    sketch_close(&sketch);
    scene_close(&scene);
}
END_TEST

START_TEST(particles_are_marks_in_coordinates)
{
    Scene scene;
    open_scene(&scene, "mode5 80x24 0");
    const Simulation *sim = experiment_simulation(scene.screen.experiment);
    Sketch sketch;
    screen_sketch(&scene.screen, 4, 84, 25, &sketch);
    ck_assert_uint_gt(sketch.n_marks, 0);
    const int field = simulation_find_field(sim, 0, "x");
    for (size_t i = 0; i < sketch.n_marks; i++) {
        bool found = false;
        for (size_t p = 0; p < sim->counts[0] && !found; p++) {
            double x;
            sim->method->field(sim, field, p, 1, &x);
            found = x == sketch.marks[i].x;
        }
        ck_assert_msg(found, "no particle lies at %g", sketch.marks[i].x);
    }
    sketch_close(&sketch);
    scene_close(&scene);
}
END_TEST

START_TEST(earlier_run_has_its_letter_and_its_words)
{
    Scene scene;
    open_scene(&scene, "mode5 80x24 900 ghost mesh.cell_size=0.5");
    Sketch sketch;
    screen_sketch(&scene.screen, 2, 84, 25, &sketch);
    bool letter = false, words = false;
    for (size_t i = 0; i < sketch.n_marks; i++)
        letter |= sketch.marks[i].glyph == 'a';
    for (int i = 0; i < sketch.n_keys; i++)
        words |= sketch.keys[i].letter == 'a' && strstr(sketch.keys[i].name, "cell size") != NULL;
    ck_assert_msg(letter && words, "letter %d, words %d, last key \"%s\"", letter, words,
                  sketch.n_keys ? sketch.keys[sketch.n_keys - 1].name : "");
    sketch_close(&sketch);
    scene_close(&scene);
}
END_TEST

START_TEST(map_is_the_nodes)
{
    Scene scene;
    open_scene(&scene, "notched-beam-coarse 80x24 30 variant 4");
    const Simulation *sim = experiment_simulation(scene.screen.experiment);
    Sketch sketch;
    screen_sketch(&scene.screen, 8, 84, 25, &sketch);
    const SketchMap *map = sketch.map;
    ck_assert_ptr_nonnull(map);
    ck_assert_uint_eq((size_t)map->nx * (size_t)map->ny, sim->counts[0]);
    const int damage = simulation_find_field(sim, 0, "damage");
    for (size_t i = 0; i < sim->counts[0]; i++) {
        double value, x, u;
        sim->method->field(sim, damage, i, 1, &value);
        sim->method->field(sim, sim->position[0], i, 1, &x);
        sim->method->field(sim, sim->displacement[0], i, 1, &u);
        ck_assert_double_eq(map->value[i], value);
        ck_assert_double_eq_tol(map->x[i], 1e3 * (x + map->enlarged * u), 1e-9);
    }
    ck_assert_int_gt(sketch.plot.n_strokes, 0); /* the notch at least */
    sketch_close(&sketch);
    scene_close(&scene);
}
END_TEST

START_TEST(view_without_a_picture_says_why)
{
    Scene scene;
    open_scene(&scene, "mode1 80x24 0");
    Sketch sketch;
    screen_sketch(&scene.screen, 6, 84, 25, &sketch);
    ck_assert(!sketch.has_axes);
    ck_assert_int_gt(sketch.n_notes, 0);
    ck_assert_ptr_nonnull(strstr(sketch.notes[0].text, "needs more time"));
    sketch_close(&sketch);
    scene_close(&scene);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *cases = tcase_create("sketch");
    tcase_add_test(cases, curve_over_time_is_the_record);
    tcase_add_test(cases, profile_is_the_field);
    tcase_add_test(cases, particles_are_marks_in_coordinates);
    tcase_add_test(cases, earlier_run_has_its_letter_and_its_words);
    tcase_add_test(cases, map_is_the_nodes);
    tcase_add_test(cases, view_without_a_picture_says_why);
    suite_add_tcase(suite, cases);
}
