/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the views of the errors, the spectrum and the timeline show is where theory and the run say: read from
 * the grid alone, by the labels of its axes, as a reader would. */
#include "scenario/scenario.h"
#include "scenario/parameters.h"
#include "scenario/settings.h"
#include "answers/dispersion_curves.h"
#include "suite.h"
#include "panes/screen.h"
#include "views/view.h"
#include "run/playback.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct Show {
    Screen screen;
    Experiment *experiment; /* behind screen.experiment */
    Canvas canvas;
    Status status;
} Show;

static void work(Show *show)
{
    while (experiment_pending(show->screen.experiment, NULL))
        ck_assert(experiment_work(show->experiment, (Effort){.steps = 1000}, &(bool){false}, &show->status));
}

static void open_settings(Show *show, const char *scenario, const Settings *settings, long steps)
{
    screen_default(&show->screen);
    show->screen.scenario = scenario;
    show->experiment = experiment_create(settings, 64 << 20, 1, &show->status);
    show->screen.experiment = show->experiment;
    ck_assert_msg(show->screen.experiment != NULL, "%s", show->status.text);
    ck_assert(experiment_advance(show->experiment, steps, &show->status));
}

static void open_show(Show *show, const char *scenario, long steps)
{
    Settings settings;
    *show = (Show){.status = {STATUS_DONE, ""}};
    ck_assert_msg(scenario_load(scenario, &settings, &show->status), "%s", show->status.text);
    open_settings(show, scenario, &settings, steps);
}

static void close_show(Show *show)
{
    canvas_close(&show->canvas);
    experiment_destroy(show->experiment);
}

static void draw(Show *show, int width, int height)
{
    ck_assert(canvas_open(&show->canvas, width, height, &show->status));
    screen_draw(&show->screen, &show->canvas);
}

static const Cell *cell(const Show *show, int x, int y)
{
    return &show->canvas.cells[y * show->canvas.width + x];
}

/* A row as text, one byte a column; what is not ASCII is a '?'. */
static void row_text(const Show *show, int y, char *out)
{
    for (int x = 0; x < show->canvas.width; x++) {
        uint32_t glyph = cell(show, x, y)->glyph;
        out[x] = (char)(glyph == 0 ? ' ' : glyph < 0x80 ? glyph : '?');
    }
    out[show->canvas.width] = '\0';
}

/* Where a label of the axis at the left stands, in the zoomed pane: its row. */
static int row_of(const Show *show, const char *label)
{
    char text[400];
    for (int y = 0; y < show->canvas.height; y++) {
        row_text(show, y, text);
        char number[16];
        if (cell(show, 6, y)->glyph == 0x2524 && sscanf(text, "%15s", number) == 1 &&
            strncmp(number, label, strlen(label)) == 0 && number[strlen(label)] == '?')
            return y;
    }
    ck_abort_msg("no label %s at the left", label);
    return -1;
}

/* The middle of a label below the plot. */
static double column_of(const Show *show, const char *label)
{
    char text[400], wanted[20];
    snprintf(wanted, sizeof wanted, " %s ", label);
    for (int y = show->canvas.height - 1; y > 0; y--) {
        row_text(show, y, text);
        const char *found = strstr(text, wanted);
        if (found && strspn(text, " 0123456789.") > 20)
            return (double)(found - text) + 1 + ((double)strlen(label) - 1) / 2;
    }
    ck_abort_msg("no label %s below", label);
    return -1;
}

static bool has_style(const Show *show, double column, double row, Style style)
{
    for (int y = (int)floor(row); y <= (int)ceil(row); y++)
        for (int x = (int)floor(column); x <= (int)ceil(column); x++)
            for (int dy = -1; dy <= 1; dy++)
                if (cell(show, x, y + dy)->style == style)
                    return true;
    return false;
}

/* --- the modes of a mesh -------------------------------------------------------------------------- */

START_TEST(factors_make_the_error)
{
    static const struct {
        int number;
        double percent;
    } known[] = {{1, -.053}, {5, -4.239}, {10, -17.710}};
    Settings settings;
    Status status = {STATUS_DONE, ""};
    ck_assert(scenario_load("mode1", &settings, &status));
    ck_assert_int_eq(dispersion_modes(&settings), 25);
    for (int i = 0; i < 3; i++) {
        ModeOnMesh mode;
        ck_assert(dispersion_mode(&settings, known[i].number, &mode));
        const double percent = 100 * (mode.predicted / mode.exact - 1);
        ck_assert_msg(fabs(percent - known[i].percent) < 6e-4, "mode %d: %g %%", known[i].number, percent);
        ck_assert_int_eq(mode.n_factors, 3);
        ck_assert_double_eq_tol(mode.factors[0].value * mode.factors[1].value * mode.factors[2].value,
                                mode.predicted / mode.exact, 1e-13);
        /* the lumped mesh alone explains little of it */
        const double theta = (2 * known[i].number - 1) * M_PI / 50;
        ck_assert_double_eq_tol(mode.factors[0].value, 2 * sin(theta / 2) / theta, 1e-12);
        ck_assert(mode.factors[1].value < mode.factors[0].value);
    }
    ModeOnMesh mode;
    ck_assert(!dispersion_mode(&settings, 0, &mode));
    ck_assert(!dispersion_mode(&settings, 26, &mode));
    /* a lattice has a mode for each node; far from the ends mode 5 is 1.65 % too low, time adds 0.01 % */
    ck_assert(scenario_load("mode5-peridynamics", &settings, &status));
    ck_assert_int_eq(dispersion_modes(&settings), 50);
    ck_assert(dispersion_mode(&settings, 5, &mode));
    ck_assert_int_eq(mode.n_factors, 2);
    ck_assert_double_eq_tol(100 * (mode.factors[0].value - 1), -1.6490, 6e-5);
    ck_assert_double_eq_tol(mode.factors[0].value * mode.factors[1].value, mode.predicted / mode.exact,
                            1e-13);
    ck_assert(scenario_load("supported-beam", &settings, &status));
    ck_assert_int_eq(dispersion_modes(&settings), 0);
}
END_TEST

/* The curve goes through -4.24 % at mode 5 and -17.7 % at mode 10; a run's dot lies on it. */
START_TEST(predicted_curve_is_where_theory_says)
{
    static const struct {
        const char *scenario;
        double mode, percent;
    } cases[] = {{"mode5", 5, 4.239}, {"mode10", 10, 17.710}};
    for (int i = 0; i < 2; i++) {
        Show show;
        open_show(&show, cases[i].scenario, 2000);
        show.screen.views.lower = view_named("dispersion");
        show.screen.panes.focus = PANE_LOWER;
        show.screen.panes.zoomed = true;
        show.screen.views.references = SHOW_PREDICTED;
        draw(&show, 100, 30);
        const int zero = row_of(&show, "0"), twenty = row_of(&show, "-20");
        const double grain = (twenty - zero) / sqrt(20);
        const double five = column_of(&show, "5"), fifteen = column_of(&show, "15");
        for (int k = 0; k < 2; k++) {
            const double column = five + (cases[k].mode - 5) * (fifteen - five) / 10;
            const double row = zero + grain * sqrt(cases[k].percent);
            ck_assert_msg(has_style(&show, column, row, STYLE_PREDICTED) || k == i, "%s: no curve at %g, %g",
                          cases[i].scenario, column, row);
            if (k == i)
                ck_assert_msg(has_style(&show, column, row, STYLE_MEASURED), "%s: no dot at %g, %g",
                              cases[i].scenario, column, row);
        }
        close_show(&show);
    }
}
END_TEST

/* An edit leaves a dot of the earlier run, with its letter beside it, a space between. */
START_TEST(earlier_runs_leave_a_dot)
{
    Show show;
    open_show(&show, "mode5", 1000);
    Settings settings = *experiment_settings(show.screen.experiment);
    ck_assert(settings_set(&settings, "initial.mode", "10", &show.status));
    ck_assert(experiment_edit(show.experiment, &settings, &show.status));
    work(&show);
    show.screen.views.lower = view_named("dispersion");
    show.screen.panes.focus = PANE_LOWER;
    show.screen.panes.zoomed = true;
    draw(&show, 100, 30);
    const int zero = row_of(&show, "0"), twenty = row_of(&show, "-20");
    const double five = column_of(&show, "5"), row = zero + (twenty - zero) * sqrt(4.24 / 20);
    bool found = false;
    for (int y = (int)row; y <= (int)row + 1; y++)
        for (int x = (int)five - 1; x <= (int)five + 1; x++)
            found |= cell(&show, x, y)->glyph == 0x25cb && cell(&show, x + 2, y)->glyph == 'a';
    ck_assert_msg(found, "no dot with its letter near %g, %g", five, row);
    close_show(&show);
}
END_TEST

/* --- the spectrum --------------------------------------------------------------------------------- */

static void fill(Record *record, long rows, double dt, double frequency, double amplitude)
{
    record_open(record, 3, 1, (size_t)64 << 20);
    for (long step = 0; step < rows; step++) {
        const double time = (double)step * dt;
        ck_assert(
            record_append(record, (double[]){(double)step, time, 7 + amplitude * sin(frequency * time)}));
    }
}

/* The line of a sine stands in its bin with its amplitude, also where means of rows are taken and where only
 * the newest are looked at; rows that come in ones and twos do not change what is shown. */
START_TEST(spectrum_of_a_sine)
{
    static const struct {
        long rows;
        SpectrumSpan span;
        size_t bins;
    } cases[] = {{2048, SPECTRUM_SLOW, 1025},
                 {2048, SPECTRUM_FAST, 1025},
                 {10240, SPECTRUM_SLOW, 2561},
                 {40960, SPECTRUM_SLOW, 2561},
                 {40960, SPECTRUM_FAST, 8193}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const double dt = 0.01, frequency = 2 * M_PI * 40 / (dt * 2048), amplitude = 3;
        Record record;
        Spectrum spectrum = {0};
        fill(&record, cases[i].rows, dt, frequency, amplitude);
        ck_assert(spectrum_of(&record, 2, cases[i].span, &spectrum));
        ck_assert_msg(spectrum.count == cases[i].bins, "case %zu: %zu bins", i, spectrum.count);
        size_t peak = 1;
        for (size_t k = 2; k < spectrum.count; k++)
            peak = spectrum.amplitudes[k] > spectrum.amplitudes[peak] ? k : peak;
        ck_assert_msg(fabs((double)peak * spectrum.step - frequency) < 0.01 * spectrum.step,
                      "case %zu: bin %zu", i, peak);
        ck_assert_double_eq_tol(spectrum.amplitudes[peak], amplitude, 0.001 * amplitude);
        const double *before = spectrum.amplitudes;
        const double next[] = {(double)cases[i].rows, (double)cases[i].rows * dt, 7};
        ck_assert(record_append(&record, next));
        ck_assert(spectrum_of(&record, 2, cases[i].span, &spectrum));
        ck_assert(spectrum.amplitudes == before);
        record_cut(&record, 20);
        ck_assert(!spectrum_of(&record, 2, cases[i].span, &spectrum));
        spectrum_close(&spectrum);
        record_close(&record);
    }
}
END_TEST

/* The highest bin of a run is that of its fitted frequency, or its neighbour. */
START_TEST(spectrum_peaks_at_the_fit)
{
    static const char *const scenarios[] = {"mode1", "mode5", "mode10"};
    for (int i = 0; i < 3; i++) {
        Show show;
        open_show(&show, scenarios[i], 4000);
        Experiment *experiment = show.experiment;
        const Readout *readout = experiment_readout(experiment);
        const Spectrum *spectrum = experiment_spectrum(experiment, 2, SPECTRUM_SLOW);
        ck_assert(spectrum != NULL && readout->measured_known);
        size_t peak = 1;
        for (size_t k = 2; k < spectrum->count; k++)
            peak = spectrum->amplitudes[k] > spectrum->amplitudes[peak] ? k : peak;
        ck_assert_msg(fabs((double)peak * spectrum->step - readout->measured) <= spectrum->step,
                      "%s: %g, fit %g", scenarios[i], (double)peak * spectrum->step, readout->measured);
        close_show(&show);
    }
}
END_TEST

/* On screen the peak is the highest point of the measured curve, and the predicted line runs through it. */
START_TEST(spectrum_on_screen)
{
    Show show;
    open_show(&show, "mode5", 100);
    show.screen.views.lower = view_named("spectrum");
    show.screen.panes.focus = PANE_LOWER;
    show.screen.panes.zoomed = true;
    draw(&show, 100, 30);
    char text[400];
    row_text(&show, 2, text);
    ck_assert_msg(strstr(text, "needs more time") != NULL, "%s", text);
    ck_assert(experiment_advance(show.experiment, 3900, &show.status));
    draw(&show, 100, 30);
    const double four = column_of(&show, "4"), eight = column_of(&show, "8"), grain = (eight - four) / 4;
    const double bin = 2 * M_PI / 40 * grain;
    double predicted = -1, peak = -1;
    for (int x = 7; x < 100; x++)
        if (cell(&show, x, 2)->style == STYLE_PREDICTED)
            predicted = x;
    for (int y = 2; y < 27 && peak < 0; y++)
        for (int x = 7; x < 100; x++)
            if (cell(&show, x, y)->style == STYLE_MEASURED)
                peak = x;
    ck_assert_msg(fabs(predicted - (four + 1.4152 * grain)) <= 1, "predicted at column %g", predicted);
    ck_assert_msg(fabs(peak - (four + 1.4152 * grain)) <= bin + 1, "peak at column %g", peak);
    row_text(&show, 28, text);
    double place;
    ck_assert_msg(sscanf(text, " peak at %lf", &place) == 1 && fabs(place - 5.4152) < 0.02, "%s", text);
    close_show(&show);
}
END_TEST

/* --- the timeline --------------------------------------------------------------------------------- */

static bool find_timeline(const Show *show, int *y, int *first, int *last)
{
    char text[400];
    for (*y = 0; *y < show->canvas.height; ++*y) {
        row_text(show, *y, text);
        *first = *last = -1;
        for (int x = 0; x < show->canvas.width; x++)
            if (screen_timeline_step(&show->screen, show->canvas.width, show->canvas.height, x, *y) >= 0) {
                *first = *first < 0 ? x : *first;
                *last = x;
            }
        if (*first >= 0)
            return strstr(text, "t 0") != NULL;
    }
    return false;
}

/* Where there is no row to spare it comes with the first step back; elsewhere it is always there. */
START_TEST(timeline_comes_when_rewound)
{
    Show show;
    int y, first, last;
    open_show(&show, "mode5", 1000);
    draw(&show, 80, 24);
    ck_assert(!find_timeline(&show, &y, &first, &last));
    draw(&show, 100, 30);
    ck_assert(find_timeline(&show, &y, &first, &last));
    experiment_seek(show.experiment, 999, 0);
    work(&show);
    draw(&show, 80, 24);
    ck_assert(find_timeline(&show, &y, &first, &last));
    show.screen.panes.zoomed = true;
    draw(&show, 80, 24);
    ck_assert(!find_timeline(&show, &y, &first, &last));
    close_show(&show);
}
END_TEST

/* The dot, the end of what is computed and the marks stand at their share of the whole run. */
START_TEST(timeline_marks_places)
{
    Show show;
    int y, first, last, count;
    open_show(&show, "crossing", 4000);
    Experiment *experiment = show.experiment;
    experiment_seek(experiment, 2500, 0);
    work(&show);
    draw(&show, 132, 43);
    ck_assert(find_timeline(&show, &y, &first, &last));
    const double end = (double)experiment_last_step(experiment), cells = last - first;
    ck_assert_int_eq(cell(&show, first + (int)floor(2500 / end * cells + 0.5), y)->glyph, 0x25cf);
    ck_assert_int_eq(cell(&show, first + (int)floor(4000 / end * cells + 0.5), y)->glyph, 0x2524);
    ck_assert_int_eq(cell(&show, last, y)->glyph, 0x00b7);
    const Event *events = experiment_events(experiment, &count);
    ck_assert_int_gt(count, 0);
    int crossings = 0;
    for (int i = 0; i < count; i++)
        if (events[i].kind == EVENT_CROSSING) {
            const uint32_t glyph =
                cell(&show, first + (int)floor((double)events[i].step / end * cells + 0.5), y)->glyph;
            ck_assert_msg(glyph == 'x' || glyph == 'E' || glyph == 0x25cf, "U+%04X at step %ld", glyph,
                          events[i].step);
            crossings++;
        }
    ck_assert_int_gt(crossings, 0);
    char legend[256];
    row_text(&show, y + 1, legend);
    ck_assert_ptr_nonnull(strstr(legend, "here"));
    ck_assert_ptr_nonnull(strstr(legend, "crossing"));
    ck_assert_ptr_nonnull(strstr(legend, "energy"));
    ck_assert_ptr_null(strstr(legend, "bookmark"));
    const Bookmarks bookmarks = {.places = {{.time = experiment_time(experiment) / 2}}, .count = 1};
    show.screen.bookmarks = &bookmarks;
    draw(&show, 132, 43);
    row_text(&show, y + 1, legend);
    ck_assert_ptr_nonnull(strstr(legend, "bookmark"));
    ck_assert_int_eq(cell(&show, first + (int)floor(1250 / end * cells + 0.5), y)->glyph, 'm');
    ck_assert_int_eq(screen_timeline_step(&show.screen, 132, 43, first, y), 0);
    ck_assert_int_eq(screen_timeline_step(&show.screen, 132, 43, last, y), (long)end);
    ck_assert_int_eq(screen_timeline_step(&show.screen, 132, 43, first, y + 1), -1);
    close_show(&show);
}
END_TEST

/* --- the strip ------------------------------------------------------------------------------------ */

/* A bar that fits as a whole is shown as a whole, wall and all, whichever particle is chosen. */
START_TEST(strip_shows_the_whole_bar)
{
    Show show;
    open_show(&show, "mode1", 0);
    for (size_t p = 0; p < 50; p++) {
        show.screen.chosen.particle = p;
        draw(&show, 80, 24);
        ck_assert_msg(cell(&show, 1, 1)->glyph == 0x2592, "no wall with particle %zu chosen", p);
    }
    close_show(&show);
}
END_TEST

/* Domains that stretch end where x and stretch say, to half a column; particles without have none. */
START_TEST(strip_shows_domains_as_they_are)
{
    enum { PER_CELL = 3, LEFT = 3, ROW = 4 };
    Show show;
    open_show(&show, "crossing", 0);
    Settings settings = *experiment_settings(show.screen.experiment);
    experiment_destroy(show.experiment);
    ck_assert(settings_set(&settings, "mpm.shape", "cpdi", &show.status));
    ck_assert(settings_set(&settings, "initial.velocity", "3", &show.status));
    ck_assert(settings_set(&settings, "mesh.padding", "40", &show.status));
    show.screen.experiment = show.experiment = experiment_create(&settings, 64 << 20, 1, &show.status);
    ck_assert(show.screen.experiment && experiment_advance(show.experiment, 220, &show.status));
    draw(&show, 132, 43);
    const Simulation *sim = experiment_simulation(show.screen.experiment);
    const int x = simulation_find_field(sim, 0, "x"), stretch = simulation_find_field(sim, 0, "stretch");
    int seen = 0;
    for (size_t p = 0; p < 50; p++)
        for (int side = -1; side <= 1; side += 2) {
            const double end = simulation_value(sim, x, p) + side * 0.25 * simulation_value(sim, stretch, p),
                         place = PER_CELL * end;
            if (place < 0 || place >= 26 * PER_CELL || (p > 0 && p == show.screen.chosen.particle))
                continue;
            const uint32_t dots = place - floor(place) < 0.5 ? 0x47 : 0xb8;
            const uint32_t glyph = cell(&show, LEFT - 1 + (int)place, ROW)->glyph;
            ck_assert_msg(glyph == 0x25cf || (glyph >= 0x2800 && ((glyph - 0x2800) & dots) == dots),
                          "particle %zu, side %d: %x at %g", p, side, glyph, place);
            seen += glyph != 0x25cf;
        }
    ck_assert_int_gt(seen, 60);
    close_show(&show);
    open_show(&show, "crossing", 220);
    draw(&show, 132, 43);
    for (int column = 0; column < 26 * PER_CELL; column++) {
        const uint32_t glyph = cell(&show, LEFT - 1 + column, ROW)->glyph;
        ck_assert_msg(glyph < 0x2800 || (glyph & 0x41) == 0, "an end of a domain in column %d", column);
    }
    close_show(&show);
}
END_TEST

/* Each of two cracks has its letter where its curve ends and in the legend. */
START_TEST(cracks_are_told_apart_by_letters)
{
    static const char *const sets[][2] = {
        {"pd.spacing", "2e-3"}, {"pd.horizon", "8e-3"}, {"time.step", "4e-7"}, {"pd.critical_energy", "20"}};
    Show show = {.status = {STATUS_DONE, ""}};
    Settings settings;
    ck_assert(scenario_load("two-cracks", &settings, &show.status));
    for (size_t i = 0; i < sizeof sets / sizeof *sets; i++)
        ck_assert_msg(settings_set(&settings, sets[i][0], sets[i][1], &show.status), "%s", show.status.text);
    open_settings(&show, "two-cracks", &settings, 100);
    show.screen.views.lower = view_named("cracks");
    view_choose_variant(show.screen.views.lower, &show.screen, 1);
    draw(&show, 132, 43);
    const Rect pane = screen_pane(&show.screen, 132, 43, PANE_LOWER);
    char text[200];
    row_text(&show, pane.y, text);
    ck_assert_msg(strstr(text, "a left") && strstr(text, "b right"), "%s", text);
    int found[2] = {0, 0};
    for (int y = pane.y + 1; y < pane.y + pane.height - 3; y++)
        for (int x = pane.x + 8; x < pane.x + pane.width; x++)
            for (int which = 0; which < 2; which++)
                found[which] += cell(&show, x, y)->glyph == (uint32_t)('a' + which) &&
                                cell(&show, x, y)->style == STYLE_MEASURED;
    ck_assert_msg(found[0] == 1 && found[1] == 1, "%d a, %d b", found[0], found[1]);
    close_show(&show);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *timeline = tcase_create("timeline");
    tcase_add_test(timeline, timeline_comes_when_rewound);
    tcase_add_test(timeline, timeline_marks_places);
    suite_add_tcase(suite, timeline);
    TCase *strip = tcase_create("strip");
    tcase_add_test(strip, strip_shows_the_whole_bar);
    tcase_add_test(strip, strip_shows_domains_as_they_are);
    suite_add_tcase(suite, strip);
    TCase *spectrum = tcase_create("spectrum");
    tcase_add_test(spectrum, spectrum_of_a_sine);
    tcase_add_test(spectrum, spectrum_peaks_at_the_fit);
    tcase_add_test(spectrum, spectrum_on_screen);
    suite_add_tcase(suite, spectrum);
    TCase *dispersion = tcase_create("dispersion");
    tcase_add_test(dispersion, factors_make_the_error);
    tcase_add_test(dispersion, predicted_curve_is_where_theory_says);
    tcase_add_test(dispersion, earlier_runs_leave_a_dot);
    suite_add_tcase(suite, dispersion);
    TCase *cracks = tcase_create("cracks");
    tcase_add_test(cracks, cracks_are_told_apart_by_letters);
    suite_add_tcase(suite, cracks);
}
