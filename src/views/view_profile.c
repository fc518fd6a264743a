/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A field of the particles along the bar, or the middle of a beam, with the exact curve behind. */
#include "views/plots/plots.h"
#include "scenario/concern_body.h"
#include "scenario/concern_time.h"
#include "views/view.h"
#include "run/duel.h"
#include "base/text.h"
#include "lessons/lesson_shown.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *word_of(const Screen *screen, int variant)
{
    return profile_field(screen_simulation(screen), variant);
}

/* A run's part of the picture: what is now, of a ghost what was last on screen. */
typedef struct Curve {
    const ShownRun *run;
    Profile taken; /* of a run that goes on */
    const Profile *profile;
    const double *values;
} Curve;

/* False: this run has nothing to show here. */
static bool open_curve(Curve *curve, const ShownRun *run, const char *field)
{
    *curve = (Curve){.run = run, .profile = run->profile};
    if (run->experiment) {
        profile_take(&curve->taken, experiment_simulation(run->experiment), field);
        curve->profile = &curve->taken;
    }
    curve->values = curve->profile->count > 0 ? profile_values(curve->profile, field) : NULL;
    return curve->values != NULL;
}

/* How far the exact answer reaches over the run, so that the axis keeps still; 0: not known. */
static double exact_reach(const ShownRun *run, const char *field, const double *x, size_t count, double base)
{
    enum { TIMES = 24, PLACES = 12 };
    const References *refs = experiment_references(run->experiment);
    const Readout *readout = run->readout;
    const double span = readout->nominal_period > 0 && !readout->drifting ? readout->nominal_period
                                                                          : settings_time(run->settings)->end;
    double reach = 0;
    for (int i = 0; count > 0 && i <= TIMES; i++)
        for (int k = 0; k <= PLACES; k++) {
            double place = x[(count - 1) * (size_t)k / PLACES];
            double value = references_profile(refs, field, place, span * i / TIMES) - base;
            reach = fabs(value) > reach ? fabs(value) : reach;
        }
    return reach;
}

static Axis value_axis(const Screen *screen, const Simulation *sim, const char *field, const Curve *curves,
                       int n_curves)
{
    double reach = 0, base = 0;
    if (strcmp(field, "damage") == 0)
        return axis_make(0, 1);
    if (strcmp(field, "density") == 0 && simulation_has(sim, HAS_LINE))
        base = settings_material(screen_settings(screen))->density;
    for (int k = 0; k < n_curves; k++) {
        const Profile *profile = curves[k].profile;
        if (!curves[k].run->experiment)
            continue;
        reach = fmax(reach, exact_reach(curves[k].run, field, profile->x, profile->count, base));
        for (size_t i = 0; i < profile->count; i++)
            if (isfinite(curves[k].values[i]) && fabs(curves[k].values[i] - base) > reach)
                reach = fabs(curves[k].values[i] - base);
    }
    double least = base, highest = base;
    overlay_widen(screen, field, true, &least, &highest);
    reach = fmax(reach, fmax(base - least, highest - base));
    /* A displacement so much smaller than the body is long is nothing yet, not a curve to be looked at. */
    const Profile *profile = curves[n_curves - 1].profile;
    const double rounding = 1e-15;
    bool moves = false;
    for (int d = 0; d < SIMULATION_DIMENSIONS_MAX; d++)
        moves |=
            sim->displacement[d] >= 0 && strcmp(sim->fields[sim->displacement[d]].quantity.name, field) == 0;
    reach = fmax(reach, moves ? rounding * fabs(profile->x[profile->count - 1] - profile->x[0]) : 0);
    if (base != 0) {
        double end = reach > 0 ? axis_round_up(reach * 1.02) : 0.01 * base;
        return axis_make(base - end, base + end);
    }
    return axis_symmetric(reach);
}

/* All particles of the runs that go on, with half a distance at their end. */
static Axis place_axis(const Curve *curves, int n_curves)
{
    double from = INFINITY, to = -INFINITY, margin = 0;
    for (int k = 0; k < n_curves; k++) {
        const Profile *profile = curves[k].profile;
        double low = INFINITY, high = -INFINITY;
        if (!curves[k].run->experiment)
            continue;
        for (size_t i = 0; i < profile->count; i++) {
            low = fmin(low, profile->x[i]);
            high = fmax(high, profile->x[i]);
        }
        margin = fmax(margin, (high - low) / (double)profile->count);
        from = fmin(from, low);
        to = fmax(to, high);
    }
    if (from > 0 && from < 2 * margin)
        from = 0;
    return axis_make(from, to + margin);
}

static void add_exact(const Experiment *experiment, Picture *picture, const char *field, const Profile *row)
{
    const References *refs = experiment_references(experiment);
    const double time = experiment_time(experiment);
    const double from = row->x[0], to = row->x[row->count - 1], margin = (to - from) / (double)row->count / 2;
    plot_begin(&picture->plot, STROKE_LINE, pen_exact);
    for (int i = 0; i <= picture->dots; i++) {
        double x = from - margin + (to - from + 2 * margin) * i / picture->dots;
        plot_point(&picture->plot, x, references_profile(refs, field, x, time));
    }
}

/* The run's letter at the end of its curve, and some on it. */
static void add_letters(Picture *picture, const Curve *curve)
{
    const Profile *profile = curve->profile;
    runs_letter(picture, curve->run, profile->x[profile->count - 1], curve->values[profile->count - 1],
                MARK_PLACE);
    for (int m = 0; m < RUN_MARKS; m++) {
        const double place = runs_mark(curve->run, &picture->plot.x, m);
        size_t i = 0;
        while (i < profile->count && profile->x[i] < place)
            i++;
        if (i > 0 && i < profile->count)
            runs_letter(picture, curve->run, profile->x[i], curve->values[i], MARK_AGAIN);
    }
}

static void add_keys(const Screen *screen, Picture *picture, const Curve *curves, int n_curves, bool exact)
{
    ShownRun runs[RUNS_MAX];
    for (int i = n_curves - 1; i >= 0; i--) { /* the present run first */
        runs[i] = *curves[i].run;
        if (runs[i].experiment && !runs[i].letter &&
            simulation_has(experiment_simulation(runs[i].experiment), HAS_PLANE))
            text_append(runs[i].word, sizeof runs[i].word, ", middle row");
        if (runs[i].ghost >= 0) {
            /* What a ghost's letter stands for: its moment where it is not the present, and what differs. */
            const double dt = screen_simulation(screen)->dt;
            char word[RUN_WORD_MAX];
            if (fabs(runs[i].profile->time - experiment_time(screen->experiment)) >= 0.51 * dt) {
                snprintf(word, sizeof word, "%s", runs[i].word);
                snprintf(runs[i].word, sizeof runs[i].word, "at %s, %.*s",
                         screen_time_text(screen, runs[i].profile->time).text, RUN_WORD_MAX - 54, word);
            }
        } else if (runs[i].shown)
            picture_key(picture, runs_key(&runs[i]));
    }
    if (exact)
        picture_name(picture, pen_exact, screen_problem(screen)->answer);
    runs_add_keys(picture, runs, n_curves);
}

static void close_curves(Curve *curves, int n_curves)
{
    for (int i = 0; i < n_curves; i++)
        profile_close(&curves[i].taken);
}

/* At t = 0 nothing has moved yet: what there is to see of a bar is the velocity. */
static int variant_shown(const Screen *screen, int variant)
{
    const Experiment *clock = screen_clock_run(screen);
    const bool at_start = experiment_step(clock) == 0 && experiment_stage(clock) == 0;
    return variant == 0 && at_start && !screen_is_running(screen) && screen_has(screen, HAS_LINE) ? 1
                                                                                                  : variant;
}

static const char *curve(const Screen *screen)
{
    const int variant = view_variant(&view_profile, screen);
    const char *name = profile_field(screen_simulation(screen), variant_shown(screen, variant));
    return name ? name : "";
}

static void describe(const Screen *screen, int variant, Picture *picture)
{
    const Simulation *sim = screen_simulation(screen);
    const char *name = profile_field(sim, variant_shown(screen, variant));
    ShownRun runs[RUNS_MAX];
    Curve curves[RUNS_MAX];
    int n_runs = runs_of(screen, runs), n_curves = 0;
    for (int i = 0; i < n_runs && name; i++)
        if (open_curve(&curves[n_curves], &runs[i], name))
            n_curves++;
    if (n_curves == 0 || !curves[n_curves - 1].run->experiment) {
        picture_heading(picture, "profile");
        close_curves(curves, n_curves);
        return;
    }
    const Profile *present = curves[n_curves - 1].profile;
    const Quantity *quantity = &sim->fields[simulation_find_field(sim, 0, name)].quantity;
    /* beside the common motion of the body; a foreign series has that in it */
    const bool carried =
        fabs(sim->common_speed) > 0 && (quantity == &sim->fields[sim->displacement[0]].quantity ||
                                        quantity == &sim->fields[sim->velocity[0]].quantity);
    char label[64];
    snprintf(label, sizeof label, "%s%s", quantity->label,
             !carried                                              ? ""
             : quantity == &sim->fields[sim->velocity[0]].quantity ? " - v0"
                                                                   : " - v0 t");
    picture->compares = true;
    picture_axes(picture, place_axis(curves, n_curves), "x", sim->fields[sim->position[0]].quantity.unit,
                 value_axis(screen, sim, name, curves, n_curves), label, quantity->unit);
    const bool exact =
        screen_shows_exact(screen) &&
        isfinite(references_profile(experiment_references(screen->experiment), name,
                                    present->x[present->count / 2], experiment_time(screen->experiment)));
    add_keys(screen, picture, curves, n_curves, exact);
    if (exact)
        add_exact(screen->experiment, picture, name, present);
    if (exact && screen_is_shared(screen) && !screen->duel->same_exact && n_curves > 1)
        add_exact(screen->duel->b, picture, name, curves[n_curves - 2].profile);
    for (int k = 0; k < n_curves; k++) {
        if (!curves[k].run->shown)
            continue;
        runs_begin(picture, curves[k].run);
        for (size_t i = 0; i < curves[k].profile->count; i++)
            plot_point(&picture->plot, curves[k].profile->x[i], curves[k].values[i]);
        /* Particles that lie well apart are seen one by one. */
        const Profile *profile = curves[k].profile;
        const ShownRun *run = curves[k].run;
        const int places = picture->dots / 4 > picture->across ? picture->dots / 4 : picture->across;
        const bool apart = run->experiment && 2 * profile->count <= (size_t)places;
        for (size_t i = 0; i < profile->count && apart; i++)
            picture_add_mark(picture, (PictureMark){profile->x[i], curves[k].values[i],
                                                    run->line == LINE_DASHED ? 0x25cb : 0x25cf, run->style,
                                                    .ascii = run->letter == 'B' ? 'x' : 'o'});
        add_letters(picture, &curves[k]);
    }
    if (!carried)
        overlay_add(screen, picture, name, true);
    /* On the page of a lesson this is the one picture: at its end what the run comes to stands below it. */
    if (screen->lesson->lesson && screen_is_plain(screen) && screen_shows_exact(screen) &&
        experiment_at_end(screen->experiment))
        runs_note_findings(screen, picture);
    close_curves(curves, n_curves);
}

const View view_profile = {
    .word = "profile",
    .help = "along the bar or beam: displacement; again: velocity and other fields",
    .digit = 1,
    .home = PANE_UPPER,
    .opens = OPENS_ALWAYS,
    .describe = describe,
    .variant_word = word_of,
    .curve = curve,
};
