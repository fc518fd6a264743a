/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A picture holds what a view shows, in the view's own numbers: strokes against the record, words against the
 * heading and the legend. */
#include "views/view.h"
#include "suite.h"
#include "views/scene.h"

#include <math.h>
#include <string.h>

/* A scene, and what one of its views draws. */
typedef struct Drawing {
    Scene scene;
    const Simulation *sim;
    Picture picture;
} Drawing;

/* In place: the screen points into its scene. `window` is that of plots over time; 0: as the scene has it. */
static void open_drawing(Drawing *drawing, const char *words, const char *view, double window)
{
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scene_open(&drawing->scene, words, &status), "%s: %s", words, status.text);
    drawing->sim = experiment_simulation(drawing->scene.screen.experiment);
    if (window > 0)
        drawing->scene.screen.time.window = window;
    view_describe(view_named(view), &drawing->scene.screen, 84, 25, &drawing->picture);
}

static void close_drawing(Drawing *drawing)
{
    picture_close(&drawing->picture);
    scene_close(&drawing->scene);
}

static double field_of(const Drawing *drawing, int field, size_t i)
{
    double value;
    drawing->sim->method->field(drawing->sim, field, i, 1, &value);
    return value;
}

static const Stroke *stroke_of(const Picture *picture, Style style)
{
    for (int i = 0; i < picture->plot.n_strokes; i++)
        if (picture->plot.strokes[i].style == style)
            return &picture->plot.strokes[i];
    return NULL;
}

static bool has_key(const Picture *picture, const char *name)
{
    for (int i = 0; i < picture->n_keys; i++)
        if (strcmp(picture->keys[i].name, name) == 0)
            return true;
    return false;
}

START_TEST(curve_over_time_is_the_record)
{
    Drawing drawing;
    open_drawing(&drawing, "mode1 80x24 900", "probe", 10);
    const Picture *picture = &drawing.picture;
    const Record *record = experiment_record(drawing.scene.screen.experiment);
    ck_assert(picture->has_axes);
    ck_assert_str_eq(picture->x_name, "t");
    ck_assert(strncmp(picture->heading, "v_cm", 4) == 0);
    ck_assert(has_key(picture, "measured") && has_key(picture, "exact") && has_key(picture, "predicted"));
    const Stroke *measured = stroke_of(picture, STYLE_MEASURED);
    ck_assert_ptr_nonnull(measured);
    /* 901 rows are fewer than what paper can tell apart: every one is a point of the line */
    ck_assert_uint_eq(measured->count, 901);
    for (size_t i = 0; i < measured->count; i++) {
        const double *row = record_row(record, i), *point = picture->plot.points + 2 * (measured->first + i);
        ck_assert_double_eq(point[0], row[1]);
        ck_assert_double_eq(point[1], row[2]);
    }
    ck_assert_int_gt(picture->n_notes, 0);
    ck_assert_ptr_nonnull(strstr(picture->notes[0].text, "ω measured"));
    close_drawing(&drawing);
}
END_TEST

START_TEST(profile_is_the_field)
{
    Drawing drawing;
    open_drawing(&drawing, "mode5 80x24 300", "profile", 0);
    const Picture *picture = &drawing.picture;
    const Stroke *measured = stroke_of(picture, STYLE_MEASURED);
    ck_assert_ptr_nonnull(measured);
    ck_assert_uint_eq(measured->count, drawing.sim->counts[0]);
    const int field = simulation_find_field(drawing.sim, 0, "u");
    for (size_t i = 0; i < measured->count; i++) {
        const double value = field_of(&drawing, field, i);
        ck_assert_double_eq(picture->plot.points[2 * (measured->first + i) + 1], value);
    }
    close_drawing(&drawing);
}
END_TEST

START_TEST(particles_are_marks_in_coordinates)
{
    Drawing drawing;
    open_drawing(&drawing, "mode5 80x24 0", "shapes", 0);
    const Picture *picture = &drawing.picture;
    ck_assert_uint_gt(picture->n_marks, 0);
    const int field = simulation_find_field(drawing.sim, 0, "x");
    for (size_t i = 0; i < picture->n_marks; i++) {
        bool found = false;
        for (size_t p = 0; p < drawing.sim->counts[0] && !found; p++)
            found = field_of(&drawing, field, p) == picture->marks[i].x;
        ck_assert_msg(found, "no particle lies at %g", picture->marks[i].x);
    }
    close_drawing(&drawing);
}
END_TEST

START_TEST(earlier_run_has_its_letter_and_its_words)
{
    Drawing drawing;
    open_drawing(&drawing, "mode5 80x24 900 ghost mesh.cell_size=0.5", "probe", 0);
    const Picture *picture = &drawing.picture;
    bool letter = false, words = false;
    for (size_t i = 0; i < picture->n_marks; i++)
        letter |= picture->marks[i].glyph == 'a';
    for (int i = 0; i < picture->n_keys; i++)
        words |= picture->keys[i].sign == 'a' && strstr(picture->keys[i].name, "cell size") != NULL;
    ck_assert_msg(letter && words, "letter %d, words %d, last key \"%s\"", letter, words,
                  picture->n_keys ? picture->keys[picture->n_keys - 1].name : "");
    close_drawing(&drawing);
}
END_TEST

START_TEST(map_is_the_nodes)
{
    Drawing drawing;
    open_drawing(&drawing, "notched-beam-coarse 80x24 30 variant 4", "beam", 0);
    const Picture *picture = &drawing.picture;
    const PictureMap *map = picture->map;
    ck_assert_ptr_nonnull(map);
    ck_assert_uint_eq((size_t)map->nx * (size_t)map->ny, drawing.sim->counts[0]);
    const int damage = simulation_find_field(drawing.sim, 0, "damage");
    for (size_t i = 0; i < drawing.sim->counts[0]; i++) {
        const double x = field_of(&drawing, drawing.sim->position[0], i);
        const double u = field_of(&drawing, drawing.sim->displacement[0], i);
        ck_assert_double_eq(map->value[i], field_of(&drawing, damage, i));
        ck_assert_double_eq_tol(map->x[i], x + map->enlarged * u, 1e-12);
    }
    ck_assert_int_gt(picture->plot.n_strokes, 0); /* the notch at least */
    close_drawing(&drawing);
}
END_TEST

/* On paper the crack before is dashed, from the foot of the notch that was, and has its letter and words. */
START_TEST(the_crack_before_is_on_paper)
{
    Drawing drawing;
    open_drawing(&drawing,
                 "notched-beam-coarse 80x24 1400 none variant 4 pd.spacing=2e-3 pd.horizon=6.5e-3 "
                 "load.stress=1.8e8 ghost notch.position=0.085",
                 "beam", 0);
    const Picture *picture = &drawing.picture;
    const Stroke *before = stroke_of(picture, STYLE_FAINT);
    ck_assert_ptr_nonnull(before);
    ck_assert_int_eq(before->line, LINE_DASHED);
    ck_assert_double_eq_tol(picture->plot.points[2 * before->first], 65e-3, 2e-3);
    ck_assert_double_le(picture->plot.points[2 * before->first + 1], 0); /* bent by the load */
    int keys = 0;
    for (int i = 0; i < picture->n_keys; i++)
        keys += picture->keys[i].sign == 'a' && picture->keys[i].line == LINE_DASHED &&
                strstr(picture->keys[i].name, "crack, ") && strstr(picture->keys[i].name, "position");
    ck_assert_int_eq(keys, 1);
    close_drawing(&drawing);
}
END_TEST

/* The plot of the path keeps that of the run before, from the foot of its notch on, in sight. */
START_TEST(the_path_before_is_in_its_plot)
{
    Drawing drawing;
    open_drawing(&drawing,
                 "notched-beam-coarse 80x24 1400 none pd.spacing=2e-3 pd.horizon=6.5e-3 "
                 "variant 1 load.stress=1.8e8 ghost notch.position=0.14",
                 "probe", 0);
    const Picture *picture = &drawing.picture;
    const Stroke *before = NULL;
    for (int i = 0; i < picture->plot.n_strokes; i++)
        if (picture->plot.points[2 * picture->plot.strokes[i].first] == 0.065)
            before = &picture->plot.strokes[i];
    ck_assert_ptr_nonnull(before);
    ck_assert_uint_gt(before->count, 10);
    ck_assert_double_eq(picture->plot.points[2 * before->first + 1], 0);
    ck_assert_double_gt(picture->plot.points[2 * (before->first + before->count - 1) + 1], 0.03);
    ck_assert_double_lt(picture->plot.x.low, 0.065);
    close_drawing(&drawing);
}
END_TEST

/* The paper's figure of the notched beam: 210 by 70 mm to scale, the notch at 65 mm and a quarter of the
 * height, the same at any time. */
START_TEST(drawing_is_to_scale)
{
    Drawing drawing;
    open_drawing(&drawing, "notched-beam-coarse 80x24 3 variant 10", "beam", 0);
    const Picture *picture = &drawing.picture;
    ck_assert(picture->has_axes && picture->bare);
    ck_assert_str_eq(picture->time, "t 0.0000 ms");
    const double *box = picture->plot.points; /* its first corners: upper left, upper right, lower right */
    const double length = box[2] - box[0], height = box[3] - box[5];
    ck_assert_double_eq_tol(length / (picture->stretch * height), 3, 1e-9);
    const Stroke *notch = stroke_of(picture, STYLE_HEADING);
    ck_assert_ptr_nonnull(notch);
    const double *ends = picture->plot.points + 2 * notch->first;
    ck_assert_double_eq_tol((ends[0] - box[0]) / length, 65 / 210.0, 1e-9);
    ck_assert_double_eq_tol((ends[3] - ends[1]) / height, 0.25, 1e-9);
    static const char *const lengths[] = {"70 mm", "17.5 mm", "65 mm", "105 mm", "200 mm", "210 mm"};
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        int found = 0;
        for (int k = 0; k < picture->n_labels; k++)
            found += strcmp(picture->labels[k].text, lengths[i]) == 0;
        ck_assert_msg(found == 1, "%s", lengths[i]);
    }
    close_drawing(&drawing);
}
END_TEST

START_TEST(view_without_a_picture_says_why)
{
    Drawing drawing;
    open_drawing(&drawing, "mode1 80x24 0", "spectrum", 0);
    const Picture *picture = &drawing.picture;
    ck_assert(!picture->has_axes);
    ck_assert_int_gt(picture->n_notes, 0);
    ck_assert_ptr_nonnull(strstr(picture->notes[0].text, "needs more time"));
    close_drawing(&drawing);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *cases = tcase_create("picture");
    tcase_add_test(cases, curve_over_time_is_the_record);
    tcase_add_test(cases, profile_is_the_field);
    tcase_add_test(cases, particles_are_marks_in_coordinates);
    tcase_add_test(cases, earlier_run_has_its_letter_and_its_words);
    tcase_add_test(cases, map_is_the_nodes);
    if (!suite_sanitized()) /* whole cracks */
        tcase_add_test(cases, the_crack_before_is_on_paper);
    if (!suite_sanitized())
        tcase_add_test(cases, the_path_before_is_in_its_plot);
    tcase_add_test(cases, drawing_is_to_scale);
    tcase_add_test(cases, view_without_a_picture_says_why);
    suite_add_tcase(suite, cases);
}
