/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a frame of a beam's map costs: drawing alone, the largest built-in beam, every variant, at two sizes
 * of the screen; then seen from near, and the inspector. A frame is at most 33 ms long.
 *
 * Usage: bench_map [SCENARIO [STEPS]] */
#include "view/views/view.h"
#include "lab/settings/parameters.h"
#include "view/scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

/* Of this process alone: others may want the machine too. */
static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void measure(Scene *scene, const char *name)
{
    enum { FRAMES = 30 };
    screen_draw(&scene->screen, &scene->canvas);
    const double begin = now();
    for (int i = 0; i < FRAMES; i++)
        screen_draw(&scene->screen, &scene->canvas);
    printf("  %-16s %6.2f ms of a core a frame\n", name, 1e3 * (now() - begin) / FRAMES);
}

int main(int count, char **arguments)
{
    static const char *const sizes[] = {"80x24", "200x60"};
    const char *scenario = count > 1 ? arguments[1] : "notched-beam", *steps = count > 2 ? arguments[2] : "1";
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
        for (int variant = 0; parameter_colour_words[variant]; variant++) {
            view_choose_variant(view_of_map(), &scene.screen, variant);
            measure(&scene, parameter_colour_words[variant]);
        }
        view_choose_variant(view_of_map(), &scene.screen, 4);
        scene.screen.look.colours = 0;
        measure(&scene, "dots");
        scene.screen.eye.magnified = 64;
        measure(&scene, "bonds as lines");
        scene_close(&scene);
    }
    return 0;
}
