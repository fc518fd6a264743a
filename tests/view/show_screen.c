/* Draws one screen to standard output, to look at what the code does:
 *
 *     show_screen SCENARIO WxH STEPS [key=value]... [word]...
 *
 * words: running, ended, help N, upper N, lower N, variant N, focus N, stage N, back N, ascii, block, zoom,
 * styles, none, exact, node, set KEY=VALUE */
#include "lab/scenario.h"
#include "view/screen.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int fail(const Status *status)
{
    fprintf(stderr, "show_screen: %s\n", status->text);
    return 1;
}

int main(int argc, char **argv)
{
    Status status = {STATUS_DONE, ""};
    Settings settings;
    int width = 80, height = 24, stages = 0;
    long back = 0;
    bool styles = false;
    if (argc < 4 || sscanf(argv[2], "%dx%d", &width, &height) != 2) {
        fprintf(stderr, "usage: show_screen SCENARIO WxH STEPS [words]\n");
        return 2;
    }
    if (!scenario_load(argv[1], &settings, &status))
        return fail(&status);
    Screen screen;
    screen_default(&screen);
    screen.scenario = argv[1];
    screen.selected = 1;
    for (int i = 4; i < argc; i++) {
        const char *word = argv[i], *number = i + 1 < argc ? argv[i + 1] : "0";
        char *equals = strchr(argv[i], '=');
        if (equals) {
            *equals = '\0';
            if (!settings_set(&settings, word, equals + 1, &status))
                return fail(&status);
        } else if (strcmp(word, "running") == 0) {
            screen.state = STATE_RUNNING;
            screen.pace = 10;
        } else if (strcmp(word, "ended") == 0) {
            screen.state = STATE_ENDED;
        } else if (strcmp(word, "help") == 0) {
            screen.help = true;
            screen.help_page = atoi(number);
        } else if (strcmp(word, "scroll") == 0) {
            screen.help_scroll = atoi(number);
        } else if (strcmp(word, "upper") == 0) {
            screen.upper = atoi(number);
        } else if (strcmp(word, "lower") == 0) {
            screen.lower = atoi(number);
        } else if (strcmp(word, "variant") == 0) {
            for (int v = 0; v < 10; v++)
                screen.variant[v] = atoi(number);
        } else if (strcmp(word, "focus") == 0) {
            screen.focus = (PaneId)atoi(number);
        } else if (strcmp(word, "select") == 0) {
            screen.selected = atoi(number);
        } else if (strcmp(word, "stage") == 0) {
            stages = atoi(number);
        } else if (strcmp(word, "back") == 0) {
            back = atol(number);
        } else if (strcmp(word, "ascii") == 0) {
            screen.glyphs = GLYPHS_ASCII;
        } else if (strcmp(word, "block") == 0) {
            screen.glyphs = GLYPHS_BLOCK;
        } else if (strcmp(word, "zoom") == 0) {
            screen.zoomed = true;
        } else if (strcmp(word, "styles") == 0) {
            styles = true;
        } else if (strcmp(word, "none") == 0) {
            screen.references = SHOW_NONE;
        } else if (strcmp(word, "node") == 0) {
            screen.node_chosen = true;
        } else if (strcmp(word, "window") == 0) {
            screen.window = atof(number);
        } else if (strcmp(word, "cursor") == 0) {
            screen.cursor_time = atof(number);
        }
    }
    screen.experiment = experiment_create(&settings, 64 << 20, 1, &status);
    if (!screen.experiment)
        return fail(&status);
    const Simulation *sim = experiment_simulation(screen.experiment);
    screen.particle = sim->counts[0] / 2;
    screen.node = sim->n_sets > 1 ? sim->counts[1] / 2 : 0;
    if (!experiment_advance(screen.experiment, atol(argv[3]), &status)) {
        fprintf(stderr, "show_screen: %s\n", status.text);
        screen.state = STATE_FAILED;
    }
    if (back > 0) {
        experiment_seek(screen.experiment, experiment_step(screen.experiment) - back, 0);
        while (experiment_pending(screen.experiment, NULL) &&
               experiment_work(screen.experiment, 1000, &status))
            ;
    }
    for (int i = 0; i < stages; i++)
        if (!experiment_next_stage(screen.experiment, &status))
            return fail(&status);
    Canvas canvas = {0};
    if (!canvas_open(&canvas, width, height, &status))
        return fail(&status);
    screen_draw(&screen, &canvas);
    char *text = styles ? canvas_dump_styles(&canvas) : canvas_dump(&canvas);
    if (text)
        fputs(text, stdout);
    free(text);
    canvas_close(&canvas);
    experiment_destroy(screen.experiment);
    return 0;
}
