/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A screen from words, for tests that compare pictures and for looking at them:
 *
 *     SCENARIO WxH STEPS [key=value]... [word]...
 *
 * words: duel (of the scenario, or with what differs behind it: duel mesh.cell_size=0.5), running, ended,
 * computing, ascii, block, eight and plain (colours), bare (the plain sheet), zoom, lecture, none, exact,
 * node, inspect, edit, ghost (an edit behind), refined (all points of the convergence that is shown), and
 * with a number: help, scroll, upper, lower, variant, focus, select, stage, back, window, cursor, particle,
 * magnified, at (x,y in shares of a beam).
 */
#ifndef TESTS_VIEW_SCENE_H
#define TESTS_VIEW_SCENE_H

#include "answers/convergence.h"
#include "answers/run_summary.h"
#include "help/command.h"
#include "lessons/lesson_shown.h"
#include "panes/entry.h"
#include "panes/screen.h"
#include "run/duel.h"
#include "run/playback.h"
#include "picture/canvas.h"

typedef struct Scene {
    Screen screen;
    Duel duel; /* behind screen.duel, and so the others behind its pointers */
    ParametersShown parameters;
    HelpShown help;
    Playback playback;
    Bookmarks bookmarks;
    LessonShown lesson;
    Prompt prompt;
    Message message;
    CommandSet used;
    RunSummary summary;
    Canvas canvas;
    char scenario[64];
    Convergence convergence;
    bool refined; /* with all points of the study that the lower view shows */
    bool styles;  /* show styles, not glyphs */
} Scene;

/* Builds, advances and draws. False: the status says why; close it all the same. */
bool scene_open(Scene *, const char *words, Status *);
void scene_close(Scene *);

#endif
