/* Paper P, figures 9 and 10: the crack of the beam with an offset notch. */
#include "cli/verify/verify_checks.h"
#include "cli/verify/verify_stories.h"
#include "physics/pd_plane/beam.h"
#include "physics/pd_plane/crack.h"

#include <math.h>
#include <stdlib.h>

enum { PATH = 6, ANGLES = 3 };

/* Where a reference solver saw the tip (microseconds, mm). */
static const struct {
    double time, x, y;
} path[PATH] = {{104, 66.8, 22.8}, {136, 74.3, 36.8},  {168, 85.8, 51.8},
                {200, 94.8, 59.8}, {232, 100.3, 65.3}, {248, 100.8, 66.3}};

/* Heights above the notch's end (mm) and the angles over them (degrees). */
static const struct {
    double height, angle;
} angles[ANGLES] = {{10, 26}, {20, 29}, {38, 35}};

/* What was seen of the crack until 300 us. */
struct CrackStory {
    double x[PATH], y[PATH]; /* the tip at the times above, mm */
    double angle[ANGLES];
    double through; /* the first time at which the tip is 66 mm high, us; NAN: never */
    Crack last;
    double balance; /* |kinetic + strain + dissipated - work| over the work, largest after 10 us, percent */
};

typedef struct CrackStory CrackStory;

void crack_story_free(CrackStory *story)
{
    free(story);
}

/* The series that the story needs, and the row they are in. */
typedef struct Watch {
    int total, work;
    double *row;
} Watch;

static void watch_energy(CrackStory *story, Simulation *sim, const Watch *watch)
{
    simulation_row(sim, watch->row);
    double work = watch->row[watch->work];
    if (work > 0 && simulation_time(sim) > 10e-6)
        story->balance = fmax(story->balance, 100 * fabs(watch->row[watch->total] - work) / work);
}

/* One microsecond at a time. */
static bool follow(CrackStory *story, Simulation *sim, const Watch *watch, Status *status)
{
    const long per_microsecond = lround(1e-6 / sim->dt);
    for (int microsecond = 1; microsecond <= 300; microsecond++) {
        if (!simulation_steps(sim, per_microsecond, NULL, NULL, status))
            return false;
        if (!crack_measure(sim, &story->last))
            return status_fail(status, STATUS_FAILED, "the notched beam has no crack to measure");
        for (int i = 0; i < PATH; i++)
            if (lround(path[i].time) == microsecond)
                story->x[i] = 1e3 * story->last.x, story->y[i] = 1e3 * story->last.y;
        if (isnan(story->through) && story->last.y >= 66e-3)
            story->through = microsecond;
        if (microsecond % 10 == 0)
            watch_energy(story, sim, watch);
    }
    for (int i = 0; i < ANGLES; i++)
        story->angle[i] = crack_angle(sim, 1e-3 * angles[i].height);
    return true;
}

static CrackStory *crack_story(Verify *verify, Status *status)
{
    if (verify->crack)
        return verify->crack;
    BeamDef def = beam_default(BEAM_NOTCHED);
    def.threads = verify->threads;
    Simulation *sim = beam_create(&def, status);
    if (!sim)
        return NULL;
    CrackStory *story = calloc(1, sizeof *story);
    Watch watch = {.total = simulation_find_series(sim, "total"),
                   .work = simulation_find_series(sim, "work"),
                   .row = calloc((size_t)sim->n_series, sizeof *watch.row)};
    if (!story || !watch.row)
        status_fail(status, STATUS_FAILED, "not enough memory");
    else {
        story->through = NAN;
        if (follow(story, sim, &watch, status))
            verify->crack = story;
    }
    free(watch.row);
    simulation_destroy(sim);
    if (!verify->crack)
        crack_story_free(story);
    return verify->crack;
}

bool verify_crack_times(Verify *verify, Status *status)
{
    const CrackStory *story = crack_story(verify, status);
    if (!story)
        return false;
    const VerifyRow rows[] = {
        {"first break, us", "90", NAN, 1e6 * story->last.first_break, 1, 1, {within(73.4, 2)}},
        {"twentieth break, us", "90", NAN, 1e6 * story->last.twentieth_break, 1, 1, {within(82.8, 2)}},
        {"66 mm high at, us", "250", NAN, story->through, 0, 1, {{235, 256}}},
        {"bonds broken at 300 us", NULL, NAN, (double)story->last.broken, 0, 1, {within(6941, 69.41)}},
        {"cut by the notch", NULL, NAN, (double)story->last.notch, 0, 1, {{1378, 1378}}},
        {"energy off the work, %", NULL, 0, story->balance, 3, 1, {{0, 1}}},
    };
    verify_head(verify, NULL);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        verify_row(verify, &rows[i]);
    return true;
}

bool verify_crack_path(Verify *verify, Status *status)
{
    const CrackStory *story = crack_story(verify, status);
    if (!story)
        return false;
    verify_head(verify, NULL);
    for (int i = 0; i < ANGLES; i++) {
        char what[40];
        snprintf(what, sizeof what, "degrees over %.0f mm", angles[i].height);
        verify_row(verify, &(VerifyRow){what,
                                        i < 2 ? "about 30" : "curves",
                                        NAN,
                                        story->angle[i],
                                        1,
                                        1,
                                        {within(angles[i].angle, 3)}});
    }
    for (int i = 0; i < PATH; i++) {
        char what[40];
        snprintf(what, sizeof what, "tip at %.0f us: x, mm", path[i].time);
        verify_row(verify, &(VerifyRow){what, NULL, NAN, story->x[i], 1, 1, {within(path[i].x, 1)}});
        snprintf(what, sizeof what, "tip at %.0f us: y, mm", path[i].time);
        verify_row(verify, &(VerifyRow){what, NULL, NAN, story->y[i], 1, 1, {within(path[i].y, 1)}});
    }
    return true;
}
