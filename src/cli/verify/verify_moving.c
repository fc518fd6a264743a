/* Paper P, figures 6 and 7: the axially moving cantilever against the modal equations. */
#include "cli/verify/verify_checks.h"
#include "cli/verify/verify_stories.h"
#include "cli/verify/verify_trace.h"
#include "physics/pd_plane/beam.h"
#include "theory/beam.h"

#include <math.h>
#include <stdlib.h>

enum { TIPS = 5, ZEROS = 3 };

/* The tip over time, and what the modal equations say of it. */
struct MovingStory {
    double end; /* s */
    size_t count;
    double spacing;
    double *displacement, *velocity; /* of the probe */
    MovingCantilever *reference;
};

typedef struct MovingStory MovingStory;

void moving_story_free(MovingStory *story)
{
    if (!story)
        return;
    free(story->displacement), free(story->velocity);
    moving_cantilever_free(story->reference);
    free(story);
}

static bool run_story(MovingStory *story, const BeamDef *def, Status *status)
{
    Simulation *sim = beam_create(def, status);
    if (!sim)
        return false;
    /* rows half a microsecond apart */
    long every = (long)fmax(1, floor(0.5e-6 / sim->dt));
    long steps = ((long)ceil(story->end / sim->dt) / every + 1) * every;
    Trace trace;
    bool sound = trace_take(&trace, sim, steps, every, status);
    if (sound) {
        story->count = trace.count, story->spacing = trace.spacing;
        story->displacement = trace_column(&trace, "u_probe");
        story->velocity = trace_column(&trace, "v_probe");
        if (!story->displacement || !story->velocity)
            sound = status_fail(status, STATUS_FAILED, "not enough memory");
    }
    trace_free(&trace);
    simulation_destroy(sim);
    return sound;
}

static MovingStory *moving_story(const Verify *verify, Clamp clamp, Status *status)
{
    MovingStory *story = calloc(1, sizeof *story);
    if (!story) {
        status_fail(status, STATUS_FAILED, "not enough memory");
        return NULL;
    }
    BeamDef def = beam_default(BEAM_MOVING_CANTILEVER);
    def.clamp = clamp, def.threads = verify->threads;
    /* as the reference solver: the velocity's thickness modes, though not the tip, depend a little on it */
    def.dt = 4e-8;
    story->end = verify->full ? 5e-3 : 1e-3;
    def.end = story->end + 1e-5;
    BeamTheory beam = {def.length, def.height, def.youngs_modulus, def.density, def.amplitude};
    story->reference = moving_cantilever_solve(&beam, def.speed, def.end, status);
    if (!story->reference || !run_story(story, &def, status)) {
        moving_story_free(story);
        return NULL;
    }
    return story;
}

/* The story with the full clamp, run by the first who asks. */
static MovingStory *full_clamp(Verify *verify, Status *status)
{
    if (!verify->moving)
        verify->moving = moving_story(verify, CLAMP_FULL, status);
    return verify->moving;
}

static double at_time(const MovingStory *story, const double *values, double t)
{
    double place = fmin(t / story->spacing, (double)story->count - 1.000001);
    size_t k = (size_t)place;
    return values[k] + (place - (double)k) * (values[k + 1] - values[k]);
}

/* The zero of a series nearest to a time; NAN: there is none within a tenth of it. */
static double zero_near(const MovingStory *story, const double *values, double t)
{
    double best = NAN;
    for (size_t k = 1; k < story->count; k++) {
        double before = values[k - 1], after = values[k];
        if ((before < 0) == (after < 0))
            continue;
        double here = story->spacing * ((double)(k - 1) + before / (before - after));
        if (fabs(here - t) < 0.1 * t && (isnan(best) || fabs(here - t) < fabs(best - t)))
            best = here;
    }
    return best;
}

/* Percent: root of the sum of squares of the difference, over that of the reference. */
static double distance(const double *values, const double *reference, size_t first, size_t last)
{
    double left = 0, whole = 0;
    for (size_t k = first; k < last; k++) {
        left += (values[k] - reference[k]) * (values[k] - reference[k]);
        whole += reference[k] * reference[k];
    }
    return 100 * sqrt(left / whole);
}

/* The reference at the story's times: the tip's displacement, or its velocity. */
static double *reference_values(const MovingStory *story, double (*value)(const MovingCantilever *, double))
{
    double *values = malloc(story->count * sizeof *values);
    for (size_t k = 0; values && k < story->count; k++)
        values[k] = value(story->reference, (double)k * story->spacing);
    return values;
}

static void show_tips(Verify *verify, const MovingStory *story)
{
    static const double tips[TIPS] = {-4.644, -2.112, 6.653, 2.557, -5.643};
    for (int i = 0; i < TIPS && (i + 1) * 1e-3 <= story->end * 1.001; i++) {
        double t = (i + 1) * 1e-3;
        char what[40];
        snprintf(what, sizeof what, "tip at %d ms, um", i + 1);
        verify_row(verify, &(VerifyRow){what,
                                        "agrees",
                                        1e6 * moving_cantilever_tip(story->reference, t),
                                        1e6 * at_time(story, story->displacement, t),
                                        3,
                                        1,
                                        {within(tips[i], 0.0015)}});
    }
}

/* Zeros of the tip, and how many times the modal equations' they are. */
static void show_zeros(Verify *verify, const MovingStory *story, const double *reference)
{
    static const struct {
        double time, ratio;
    } zeros[ZEROS] = {{0.6249e-3, 0.9976}, {2.1919e-3, 0.9982}, {4.2915e-3, 0.9974}};
    for (int i = 0; i < ZEROS && zeros[i].time < story->end; i++) {
        double expected = zero_near(story, reference, zeros[i].time);
        double measured = zero_near(story, story->displacement, zeros[i].time);
        char what[40];
        snprintf(what, sizeof what, "zero %d, ms", i + 1);
        verify_row(verify, &(VerifyRow){what,
                                        "agrees",
                                        1e3 * expected,
                                        1e3 * measured,
                                        4,
                                        1,
                                        {within(1e3 * zeros[i].ratio * expected, 1e3 * 1e-4 * expected)}});
    }
}

static bool show_guide(Verify *verify, Status *status)
{
    MovingStory *guide = moving_story(verify, CLAMP_GUIDE, status);
    double *reference = guide ? reference_values(guide, moving_cantilever_tip) : NULL;
    double off = reference ? distance(guide->displacement, reference, 0, guide->count) : NAN;
    free(reference);
    moving_story_free(guide);
    if (!guide)
        return false;
    verify_row(verify, &(VerifyRow){"only guided, L2, %", NULL, NAN, off, 1, 1, {within(24, 0.51)}});
    verify_note(verify, "Guided (uy = 0 alone, the paper's words) the root rotates inside the channel.");
    return true;
}

bool verify_moving_tip(Verify *verify, Status *status)
{
    const MovingStory *story = full_clamp(verify, status);
    if (!story)
        return false;
    double *reference = reference_values(story, moving_cantilever_tip);
    if (!reference)
        return status_fail(status, STATUS_FAILED, "not enough memory");
    verify_head(verify, "full clamp");
    show_tips(verify, story);
    show_zeros(verify, story, reference);
    double off = distance(story->displacement, reference, 0, story->count);
    free(reference);
    if (!verify->full)
        return true;
    verify_row(verify, &(VerifyRow){"relative L2 to 5 ms, %", "agrees", 0, off, 2, 1, {within(1.25, 0.01)}});
    return show_guide(verify, status);
}

/* --- figure 7 ------------------------------------------------------------------------------------ */

/* A centred mean over 0.1 ms. */
static double *smooth(const MovingStory *story, const double *values, size_t half)
{
    double *out = calloc(story->count, sizeof *out);
    for (size_t k = half; out && k + half < story->count; k++) {
        for (size_t j = k - half; j <= k + half; j++)
            out[k] += values[j];
        out[k] /= (double)(2 * half + 1);
    }
    return out;
}

/* Largest |value| over an interval. */
static double largest(const MovingStory *story, const double *values, double first, double last)
{
    double most = 0;
    for (size_t k = (size_t)(first / story->spacing); k < story->count && (double)k * story->spacing <= last;
         k++)
        most = fmax(most, fabs(values[k]));
    return most;
}

bool verify_moving_velocity(Verify *verify, Status *status)
{
    const MovingStory *story = full_clamp(verify, status);
    if (!story)
        return false;
    size_t half = (size_t)lround(0.05e-3 / story->spacing);
    double *reference = reference_values(story, moving_cantilever_tip_velocity);
    double *filtered = smooth(story, story->velocity, half);
    bool sound = reference && filtered;
    if (sound) {
        double raw = distance(story->velocity, reference, 0, story->count);
        double after = distance(filtered, reference, half, story->count - half);
        const VerifyRow rows[] = {
            {"raw, relative L2, %", "high freq.", NAN, raw, 1, 1, {within(39, 0.51)}},
            {"0.1 ms mean, L2, %", NULL, NAN, after, 1, 1, {{0, 6.5}}},
            {"1000 max v, 0 to 2 ms",
             "larger",
             1e3 * largest(story, reference, 0, 2e-3),
             1e3 * largest(story, filtered, 0, 2e-3),
             2,
             0,
             {{0, 0}}},
            {"1000 max v, 3 to 5 ms",
             "smaller",
             1e3 * largest(story, reference, 3e-3, 5e-3),
             1e3 * largest(story, filtered, 3e-3, 5e-3),
             2,
             0,
             {{0, 0}}},
        };
        verify_head(verify, "full clamp");
        for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
            verify_row(verify, &rows[i]);
    } else
        status_fail(status, STATUS_FAILED, "not enough memory");
    free(reference), free(filtered);
    return sound;
}
