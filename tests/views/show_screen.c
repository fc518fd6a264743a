/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Draws one screen to standard output, to look at what the code does; words as in scene.h. */
#include "views/scene.h"
#include "picture/canvas.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(int argc, char **argv)
{
    char words[512] = "";
    for (int i = 1; i < argc; i++) {
        strncat(words, argv[i], sizeof words - strlen(words) - 2);
        strcat(words, " ");
    }
    Scene scene;
    Status status = {STATUS_DONE, ""};
    bool good = scene_open(&scene, words, &status);
    if (good) {
        char *text = scene.styles ? canvas_dump_styles(&scene.canvas) : canvas_dump(&scene.canvas);
        fputs(text ? text : "", stdout);
        free(text);
    }
    if (status.text[0])
        fprintf(stderr, "show_screen: %s\n", status.text);
    scene_close(&scene);
    return good ? 0 : 1;
}
