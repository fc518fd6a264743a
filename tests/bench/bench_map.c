/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a frame of a map costs: drawing alone, of large built-in beams, a plate and discs, every variant, at
 * two sizes of the screen; then seen from near, and the inspector. A frame is at most 33 ms long.
 *
 * Usage: bench_map [SCENARIO [STEPS [COLOUR]]] */
#include "scenario/parameters.h"
#include "methods/bonds/cracks/fronts.h"
#include "views/map/map.h"
#include "views/view.h"
#include "views/scene.h"
#include "panes/screen.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

/* Of this process alone: others may want the machine too. */
static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* The least of several rounds, since the machine may have other work. */
static double measure(Scene *scene, const char *name)
{
    enum { ROUNDS = 5, FRAMES = 10 };
    double least = INFINITY;
    screen_draw(&scene->screen, &scene->canvas);
    for (int round = 0; round < ROUNDS; round++) {
        const double begin = now();
        for (int i = 0; i < FRAMES; i++)
            screen_draw(&scene->screen, &scene->canvas);
        least = fmin(least, (now() - begin) / FRAMES);
    }
    printf("  %-16s %6.2f ms of a core a frame\n", name, 1e3 * least);
    return least;
}

/* Every colouring that the run has; `only`: that one, NULL: all. */
static void measure_colours(Scene *scene, const char *only)
{
    const Simulation *sim = experiment_simulation(scene->screen.experiment);
    const char *word;
    double most = 0;
    for (int number = 0; (word = parameter_colour_words[map_variant(sim, number)]); number++) {
        if (only && strcmp(word, only) != 0)
            continue;
        view_choose_variant(view_of_map(), &scene->screen, number);
        most = fmax(most, measure(scene, word));
    }
    const double nodes = simulation_has(sim, HAS_BODIES) ? 5000 : 64000;
    printf("  %-16s %6.2f ms of a core a frame for %.0f nodes (aim: below 3)\n", "the dearest",
           1e3 * most * nodes / (double)sim->counts[0], nodes);
}

/* What each new state of a plate costs where its cracks are followed. */
static void measure_fronts(const Simulation *sim)
{
    enum { ROUNDS = 10 };
    CrackFronts fronts = {.count = 0};
    double least = INFINITY;
    bool known = false;
    for (int round = 0; round < ROUNDS; round++) {
        crack_fronts_free(&fronts);
        const double begin = now();
        known = crack_fronts_update(&fronts, sim);
        least = fmin(least, now() - begin);
    }
    crack_fronts_free(&fronts);
    if (known)
        printf("  %-16s %6.2f ms of a core a frame\n", "cracks followed", 1e3 * least);
}

static int bench(const char *scenario, const char *steps, const char *only)
{
    static const char *const sizes[] = {"80x24", "200x60"};
    for (int size = 0; size < 2; size++) {
        char words[200];
        snprintf(words, sizeof words, "%s %s %s upper 8 focus 2 zoom running", scenario, sizes[size], steps);
        Scene scene;
        Status status = {STATUS_DONE, ""};
        if (!scene_open(&scene, words, &status)) {
            fprintf(stderr, "bench_map: %s\n", status.text);
            return 1;
        }
        printf("map of %s (%zu nodes) at %s\n", scenario,
               experiment_simulation(scene.screen.experiment)->counts[0], sizes[size]);
        measure_colours(&scene, only);
        measure_fronts(experiment_simulation(scene.screen.experiment));
        if (!only) {
            view_choose_variant(view_of_map(), &scene.screen, 0);
            scene.screen.look.colours = 0;
            measure(&scene, "dots");
            scene.screen.eye.magnified = 64;
            measure(&scene, "bonds as lines");
        }
        scene_close(&scene);
    }
    return 0;
}

int main(int count, char **arguments)
{
    const char *steps = count > 2 ? arguments[2] : "1", *only = count > 3 ? arguments[3] : NULL;
    if (count > 1)
        return bench(arguments[1], steps, only);
    return bench("notched-beam", "1", NULL) || bench("branching", "400", NULL) ||
           bench("supported-beam-mpm", "1", NULL) ||
           bench("two-discs", "1 mesh.cell_size=0.0142857142857142857", NULL);
}
