/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whole screens: compared with pictures that were looked at, and with what every screen must keep to.
 *
 * The pictures are tests/golden/view/NAME.txt. After a change that is meant, write them anew and look at the
 * difference:
 *
 *     make -C build tests/views/check_screen &&
 *     MATVIB_REGENERATE=1 MATVIB_SRCDIR=. build/tests/views/check_screen all && git diff */
#include "picture/cells/cells.h"
#include "suite.h"
#include "panes/panes.h"
#include "views/inspector/inspector.h"
#include "views/scene.h"
#include "views/view.h"
#include "panes/entry.h"
#include "run/playback.h"
#include "help/command.h"
#include "panes/screen.h"
#include "answers/summary.h"

#include <ctype.h>
#include <locale.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wchar.h>

/* --- pictures ------------------------------------------------------------------------------------- */

typedef struct Screenshot {
    const char *name, *words;
} Screenshot;

static const Screenshot pictures[] = {
    {"first", "mode1 80x24 0 running"},
    {"start-paused", "mode1 80x24 0"},
    {"running", "mode5 80x24 1234 running"},
    {"running-block", "mode5 80x24 1234 running block"},
    {"running-ascii", "mode5 80x24 1234 running ascii"},
    {"map", "mode5 80x24 1234 stage 1"},
    {"strain", "mode5 80x24 1234 stage 3"},
    {"forces-ascii", "mode5 80x24 1234 stage 4 ascii"},
    {"update-node", "mode5 80x24 1234 stage 6 node"},
    {"inspect-node", "mode5 80x24 1234 inspect node stage 4"},
    {"inspect-gravity", "gravity 132x43 600 mpm.shape=gimp inspect node stage 4 ascii"},
    {"stage-list", "mode5 80x24 1234 focus 4 zoom stage 6 mpm.algorithm=usl"},
    {"musl-gimp", "mode5 80x24 400 mpm.algorithm=musl mpm.shape=gimp stage 6"},
    {"rewound", "mode5 80x24 1234 back 40"},
    {"ghost", "mode5 80x24 600 ghost mesh.cell_size=0.5"},
    {"ended", "mode5 80x24 10000 ended"},
    {"no-references", "mode5 80x24 800 none running"},
    {"editing", "mode5 80x24 800 edit select 7"},
    {"cursor", "mode5 80x24 800 focus 3 cursor 6.5"},
    {"energies-shapes", "mode10 80x24 3000 upper 4 lower 3"},
    {"slopes-work", "gravity 80x24 600 upper 4 lower 3 variant 1"},
    {"tables-log", "crossing 80x24 900 upper 7 lower 9 stage 3"},
    {"velocity", "mode10 80x24 500 variant 1"},
    {"wide", "mode5 120x40 1234 stage 5"},
    {"large", "mode5 132x43 1234 stage 3"},
    {"large-block", "mode10 132x43 2000 running block"},
    {"large-ascii", "mode10 132x43 2000 stage 2 ascii"},
    {"status-line", "mode5 80x23 1234 stage 3"},
    {"fewest-rows", "supported-beam-coarse 80x20 500 stage 4 ascii"},
    {"small", "mode5 79x23 1234 focus 3"},
    {"smaller", "mode5 60x18 1234 focus 2 running"},
    {"smaller-block", "mode5 60x18 1234 focus 0 block"},
    {"smallest", "mode5 40x12 1234 focus 3"},
    {"smallest-stage", "mode5 40x12 1234 focus 4 stage 3"},
    {"smallest-strip", "mode5 40x12 1234 focus 1 stage 1"},
    {"smallest-inspector", "mode5 40x12 100 inspect focus 5 stage 3"},
    {"smallest-family", "supported-beam-coarse 40x12 20 inspect focus 5"},
    {"smaller-forces", "supported-beam-coarse 60x18 20 inspect focus 5 zoom"},
    {"smallest-help", "mode5 40x12 0 help 2"},
    {"too-small", "mode5 20x5 100"},
    {"help-curves", "mode5 80x24 10 help 1"},
    {"help-solved", "mode5 80x66 10 help 2"},
    {"help-solved-ascii", "mode5 80x66 10 help 2 ascii"},
    {"cell-map", "mode1 80x24 3 stage 1 upper cell focus 2 zoom"},
    {"cell-node-ascii", "mode1 80x24 3 stage 4 node upper cell focus 2 zoom ascii"},
    {"cell-strain", "mode1 60x18 3 stage 3 upper cell focus 2"},
    {"cell-support", "mode1 60x18 3 stage 2 particle 0 upper cell focus 2 block plain"},
    {"cell-update", "mode5 132x43 700 stage 6 upper cell"},
    {"cell-forgotten", "mode1 60x18 3 stage 7 upper cell focus 2"},
    {"cell-running", "mode1 60x18 400 running upper cell focus 2"},
    {"cell-spline", "mode5 80x24 700 stage 1 mpm.shape=bspline3 upper cell focus 2 zoom"},
    {"cell-many", "mode5 80x24 700 stage 1 node mesh.particles_per_cell=8 upper cell focus 2 zoom"},
    {"cell-row",
     "mode5 80x24 700 stage 2 node mpm.mass_blend=0.5 mpm.shape=bspline2 upper cell focus 2 zoom"},
    {"cell-masses", "mode5 60x18 0 stage 1 node mpm.mass_blend=0.05 upper cell focus 2 variant 1"},
    {"cell-lumped", "mode5 60x18 0 stage 1 upper cell focus 2 variant 1 ascii"},
    {"cell-bond", "mode5-peridynamics 80x24 200 stage 4 upper cell focus 2 zoom"},
    {"cell-bond-ascii", "supported-beam-coarse 60x18 100 stage 4 upper cell focus 2 ascii"},
    {"cell-family", "supported-beam-coarse 80x24 100 stage 4 upper cell focus 2 zoom variant 1"},
    {"cell-plane", "moving-cantilever-hat-coarse 80x24 10 upper cell focus 2 zoom particle 1575"},
    {"cell-plane-over",
     "moving-cantilever-hat-coarse 80x24 21 upper cell focus 2 zoom stage 7 particle 1575"},
    {"cell-plane-gimp", "moving-cantilever-mpm 60x18 0 upper cell focus 2 particle 1575 ascii"},
    {"one-particle", "one-particle 80x24 1500"},
    {"waves-plane", "supported-beam-coarse 132x43 100 lower 5 variant 1 pd.influence=conical"},
    {"waves-shear-ascii", "supported-beam-coarse 80x24 100 lower 5 variant 2 ascii"},
    {"waves-line", "mode5-peridynamics 80x24 200 lower 5 variant 2"},
    {"hanging", "hanging-beam 132x43 5000"},
    {"pulse", "pulse 80x24 1000 running"},
    {"two-materials", "two-materials 132x43 1500"},
    {"column", "column 80x24 20000 running"},
    {"late-cure", "late-cure 80x24 1310 duel"},
    {"blend-node", "mode5 132x43 300 mpm.mass_blend=auto inspect node stage 2"},
    {"blend-dispersion", "mode5 132x43 300 mpm.mass_blend=auto lower 5 variant 2"},
    {"fmpm-stage", "mode5 132x43 300 mpm.transfer=fmpm mpm.fmpm_order=4 stage 2"},
    {"fmpm", "mode5 80x24 1000 mpm.transfer=fmpm running"},
    {"cpdi", "mode1 80x24 400 mpm.shape=cpdi initial.velocity=3 mesh.padding=8 upper 4 focus 1 zoom"},
    {"beam", "supported-beam-coarse 80x24 2000 running"},
    {"beam-stage", "supported-beam-coarse 132x43 500 stage 4"},
    {"cantilever", "moving-cantilever-coarse 80x24 800 lower 2 variant 1"},
    {"notched", "notched-beam-coarse 80x24 900"},
    {"crack",
     "notched-beam-coarse 80x24 2400 upper 3 lower 2 pd.spacing=2e-3 pd.horizon=6.5e-3 load.stress=9e7"},
    {"crack-law", "notched-beam-coarse 80x24 2000 upper 4 lower 3 variant 1 running pd.spacing=2e-3 "
                  "pd.horizon=6.5e-3 load.stress=9e7"},
    {"crack-path-ascii", "notched-beam-coarse 80x24 2400 lower 2 variant 1 ascii pd.spacing=2e-3 "
                         "pd.horizon=6.5e-3 load.stress=9e7"},
    {"mesh-gives", "supported-beam-mpm-coarse 80x24 100 zoom focus 2 upper beam magnified 16 stage 1"},
    {"mesh-takes",
     "supported-beam-mpm-coarse 132x43 100 upper beam magnified 16 stage 3 at 0.33,0.9 particle 1172"},
    {"mesh-forgotten",
     "supported-beam-mpm-coarse 80x24 101 zoom focus 2 upper beam magnified 16 stage 7 ascii"},
    {"mesh-rides",
     "moving-cantilever-hat-coarse 60x18 900 mesh.velocity=10 zoom focus 2 upper beam magnified 32 stage 4 "
     "at 0.355,0.5 particle 560"},
    {"travel-ux", "moving-cantilever-mpm-coarse 60x18 1740 zoom focus 2 upper beam variant 1"},
    {"travel-profile", "moving-cantilever-mpm-coarse 60x18 1740 zoom focus 2 upper profile variant 2"},
    {"travel-velocity", "moving-cantilever-coarse 60x18 1740 zoom focus 2 upper profile variant 3"},
    {"inspect-plane", "moving-cantilever-mpm-coarse 60x18 100 stage 3 inspect particle 560"},
    {"mesh-drawn", "moving-cantilever-mpm-coarse 80x24 800 zoom focus 2 upper beam magnified 16 stage 1 at "
                   "0.9,0.5 particle 560"},
    {"help-plane", "supported-beam-mpm-coarse 80x24 0 help 2"},
    {"help-plane-words", "supported-beam-mpm-coarse 132x43 0 help 1"},
    {"section-shear",
     "supported-beam-mpm-coarse 80x24 3800 zoom focus 2 upper section variant 2 particle 690"},
    {"section-moving", "moving-cantilever-mpm-coarse 132x43 800 upper section variant 1 particle 900"},
    {"section", "supported-beam-coarse 80x24 8000 upper 4 lower section particle 1050"},
    {"dispersion", "mode5 80x24 2000 lower 5"},
    {"dispersion-ghost", "mode10 80x24 2000 lower 5 ghost mesh.cell_size=0.5"},
    {"dispersion-zoomed", "mode10 100x30 2000 lower 5 focus 3 zoom"},
    {"dispersion-ascii", "mode5 80x24 2000 lower 5 ascii"},
    {"dispersion-near", "mode5-fine 100x30 1000 lower 5 variant 1"},
    {"dispersion-cubic", "mode5 80x24 1000 lower 5 mpm.shape=bspline3"},
    {"study-beside", "supported-beam-mpm-coarse 80x50 0 lower convergence refined variant 1"},
    {"convergence", "supported-beam-coarse 80x24 8400 lower 5"},
    {"study-cells", "mode5 80x24 0 lower convergence refined"},
    {"study-cells-large", "mode5 132x43 0 lower convergence refined focus 3 zoom"},
    {"study-horizon", "supported-beam-coarse 80x24 0 lower convergence refined focus 3 zoom"},
    {"study-uncorrected",
     "supported-beam-coarse 80x24 0 pd.surface_correction=none lower convergence refined focus 3 zoom"},
    {"study-nodes-ascii",
     "supported-beam-coarse 60x18 0 lower convergence refined variant 1 ascii focus 3 zoom"},
    {"study-particles", "supported-beam-mpm-coarse 80x24 0 lower convergence refined variant 1 focus 3 zoom"},
    {"study-begun", "supported-beam-mpm-coarse 80x24 0 lower convergence points 4 variant 1 focus 3 zoom"},
    {"study-methods", "supported-beam-mpm-coarse 132x43 0 lower convergence refined variant 2 focus 3 zoom"},
    {"study-table", "supported-beam-coarse 132x43 0 lower convergence refined variant 2 focus 3 zoom"},
    {"study-bodies", "spinning-disc 80x24 0 time.end=6 lower convergence refined focus 3 zoom"},
    {"study-waits", "supported-beam-coarse 80x24 20 lower convergence running"},
    {"study-none", "notched-beam-coarse 80x24 0 lower convergence"},
    {"crack-speed", "notched-beam-coarse 80x24 2400 lower 2 variant 3 pd.spacing=2e-3 pd.horizon=6.5e-3 "
                    "load.stress=9e7"},
    {"crack-cost", "notched-beam-coarse 80x24 2400 lower 3 variant 2 pd.spacing=2e-3 pd.horizon=6.5e-3 "
                   "load.stress=9e7"},
    {"crack-cost-early", "notched-beam-coarse 80x24 20 lower 3 variant 2"},
    {"spectrum", "mode5 80x24 2000 lower 6"},
    {"spectrum-block", "mode5 80x24 2000 lower 6 block"},
    {"spectrum-overtone", "mode1 100x30 4000 lower 6 initial.velocity=0.03 initial.overtones=3:0.02"},
    {"spectrum-logarithmic", "mode5 100x30 2000 lower 6 variant 1"},
    {"spectrum-too-early", "mode1 80x24 500 lower 6"},
    {"spectrum-beam", "supported-beam-coarse 132x43 3000 lower 6"},
    {"lattice-stage", "mode5-peridynamics 80x24 1234 stage 4 particle 1"},
    {"lattice-large", "mode5-peridynamics 132x43 1234 lower 5 stage 3 bar.supports=fixed-fixed"},
    {"lattice-law-ascii",
     "mode5-peridynamics 80x24 2000 running lower 4 ascii pd.spacing=0.1 pd.horizon=0.3"},
    {"lattice-hhb",
     "mode5-peridynamics 80x24 10 stage 4 particle 25 pd.volume_correction=hhb pd.horizon=1.4"},
    {"lattice-solved", "mode5-peridynamics 80x66 10 help 2"},
    {"timeline", "crossing 100x30 2000 back 700"},
    {"timeline-ascii", "crossing 80x24 900 back 100 ascii"},
    {"beam-map", "supported-beam-coarse 80x24 2000 upper 8 running"},
    {"beam-map-large", "supported-beam-coarse 132x43 600 upper 8 focus 2 zoom variant 2 stage 2"},
    {"cantilever-map-ascii", "moving-cantilever-coarse 80x24 1500 upper 8 ascii"},
    {"notched-map-ascii", "notched-beam-coarse 80x24 1300 upper 8 focus 2 zoom variant 4 ascii"},
    {"discs", "two-discs 80x24 190 bare upper 8"},
    {"discs-ascii", "two-discs 80x24 190 bare upper 8 ascii"},
    {"discs-plain", "two-discs-off-centre 132x43 120 bare upper 8 plain"},
    {"discs-velocities", "two-discs 80x24 100 bare upper 8 variant 10"},
    {"discs-velocities-ascii", "roll-or-slide 80x24 300 bare upper 8 variant 10 ascii plain"},
    {"discs-contact", "two-discs 80x24 185 stage 2 bare upper cell focus 2"},
    {"discs-small", "two-discs 60x18 185 stage 2 bare upper 8"},
    {"discs-stress", "two-discs 80x24 220 upper 8 variant 8"},
    {"discs-inspect", "two-discs 80x24 191 stage 3 inspect particle 208"},
    {"speed-one-way", "roll-or-slide 80x24 800 bare upper 2 variant 5"},
    {"weight-energies", "roll-or-slide 80x24 300 upper 4 lower 3"},
    {"falling-narrow", "falling-beam 80x24 400 bare upper 8 variant 8"},
    {"incline-block", "roll-or-slide 80x24 150 bare upper 8 block"},
    {"duel", "energy 80x24 3000 duel running"},
    {"duel-energies-ascii", "energy 80x24 3000 duel lower 3 upper 6 ascii"},
    {"duel-stage", "crossing 80x24 300 duel stage 3"},
    {"duel-beside", "crossing 80x24 300 duel stage 4"},
    {"duel-wide", "crossing 132x43 3500 duel running"},
    {"duel-beam", "supported-beam-coarse 120x30 900 duel pd.surface_correction=none upper 8 lower 2"},
    {"duel-notched", "notched-beam-coarse 80x24 900 duel pd.critical_stretch=0.0008 upper 8"},
    {"notched-map", "notched-beam-coarse 80x24 1500 upper 8 variant 4 running"},
    {"notched-map-large", "notched-beam-coarse 132x43 1500 upper 8 focus 2 zoom variant 4"},
    {"beam-map-dots", "supported-beam-coarse 80x24 2000 upper 8 focus 2 zoom eight"},
    {"beam-map-block", "supported-beam-coarse 132x43 2000 upper 8 focus 2 zoom variant 6 block eight"},
    {"cantilever-map-large", "moving-cantilever-coarse 132x43 2000 upper 8 focus 2 zoom running"},
    {"notched-near",
     "notched-beam-coarse 80x24 1300 upper 8 focus 2 zoom variant 4 magnified 16 at 0.34,0.35"},
    {"notched-near-ascii",
     "notched-beam-coarse 80x24 1300 upper 8 focus 2 zoom variant 4 magnified 16 at 0.34,0.4 ascii"},
    {"cantilever-energies", "moving-cantilever-coarse 80x24 4000 lower 3"},
    {"bonds", "mode5-peridynamics 80x24 300 load.body_force=0.01 inspect focus 5 stage 4 particle 1"},
    {"family-hhb", "supported-beam-coarse 80x24 20 inspect focus 5 particle 1801 pd.volume_correction=hhb"},
    {"family", "notched-beam-coarse 80x24 1300 upper 8 variant 4 inspect focus 5 particle 6367 stage 5"},
    {"family-large-ascii",
     "notched-beam-coarse 132x43 1300 upper 8 variant 4 inspect focus 5 particle 5947 ascii"},
    {"drawing-notched", "notched-beam-coarse 80x24 0 upper 8 variant 10 focus 2 zoom"},
    {"drawing-cantilever-ascii", "moving-cantilever-coarse 60x18 0 upper 8 focus 2 zoom variant 10 ascii"},
    {"plain", "mode5 80x24 1234 running bare"},
    {"plain-ascii", "mode5 80x24 1234 running bare ascii"},
    {"plain-small", "mode5 60x18 1234 bare"},
    {"plain-large", "mode5 132x43 1234 running bare"},
    {"plain-stage", "mode5 80x24 1234 stage 3 bare"},
    {"plain-early", "supported-beam-coarse 80x24 2000 bare"},
    {"plain-duel", "late-cure 80x24 1310 duel bare"},
    {"plain-crack", "notched-beam-coarse 80x24 1677 upper beam bare"},
    {"stacked", "mode5 58x55 1234 bare"},
    {"stacked-crack", "notched-beam-coarse 58x55 1677 upper beam bare"},
    {"stacked-low", "mode5 40x20 100 bare"},
    {"beside", "mode5 93x16 1234 bare"},
    {"beside-crack", "notched-beam-coarse 93x12 1677 upper beam bare"},
    {"beside-discs", "two-discs 93x14 200 bare upper 8"},
    {"plain-plate", "branching-coarse 60x18 200 upper beam bare"},
    {"lecture", "mode5 80x24 1310 running lecture"},
    {"lecture-stage-large", "mode5 132x43 1310 stage 3 lecture focus 2"},
    {"drawing-plate", "branching-coarse 80x24 0 upper 8 focus 2 zoom variant 10"},
    {"drawing-plate-struck", "kalthoff-coarse 60x18 0 upper 8 focus 2 zoom variant 10"},
    {"drawing-beam", "supported-beam-coarse 132x43 0 upper 8 focus 2 zoom variant 10"},
};

static void compare(const Screenshot *picture, const Canvas *canvas)
{
    char path[128], *text = canvas_dump(canvas);
    ck_assert_ptr_nonnull(text);
    snprintf(path, sizeof path, "tests/golden/view/%s.txt", picture->name);
    suite_compare(path, text, picture->words);
    free(text);
}

/* --- what every screen keeps to ------------------------------------------------------------------- */

/* Every glyph is one column wide; with ASCII glyphs it is ASCII. */
static void expect_plain_glyphs(const Canvas *canvas, Glyphs glyphs, const char *what)
{
    for (int i = 0; i < canvas->width * canvas->height; i++) {
        uint32_t glyph = canvas->cells[i].glyph;
        if (glyph < ' ' || wcwidth((wchar_t)glyph) != 1)
            ck_abort_msg("%s: glyph U+%04X", what, glyph);
        if (glyphs == GLYPHS_ASCII && glyph > 0x7e)
            ck_abort_msg("%s: U+%04X is no ASCII", what, glyph);
        if (canvas->cells[i].style >= STYLE_COUNT)
            ck_abort_msg("%s: style %d", what, canvas->cells[i].style);
    }
}

/* An ellipsis may cut words, never a number. */
static void expect_whole_numbers(const Canvas *canvas, const char *what)
{
    for (int y = 0; y < canvas->height; y++)
        for (int x = 1; x < canvas->width; x++) {
            const Cell *cell = &canvas->cells[y * canvas->width + x];
            const uint32_t before = cell[-1].glyph;
            if (cell->glyph == 0x2026 && before < 0x80 && (isdigit((int)before) || before == '.')) {
                char *text = canvas_dump(canvas);
                ck_abort_msg("%s: a number is cut in row %d:\n%s", what, y, text);
            }
        }
}

/* Pictures that take long, and of which another one shows nearly the same: where everything is requested. */
static const char *const long_ones[] = {
    "study-methods",        "study-uncorrected",  "study-nodes-ascii",   "notched-near-ascii",
    "notched-map-large",    "family-large-ascii", "cantilever-energies", "duel-notched",
    "cantilever-map-ascii", "notched-near",       "notched-map-ascii",   "convergence",
    "notched-map",          "crack-speed",        "crack-path-ascii",    "study-table"};
static int wanted[sizeof pictures / sizeof *pictures];

static bool takes_long(const Screenshot *picture)
{
    for (size_t i = 0; i < sizeof long_ones / sizeof *long_ones; i++)
        if (strcmp(picture->name, long_ones[i]) == 0)
            return true;
    return false;
}

/* It looks as it did, and in other sizes and glyphs it keeps to the rules. */
START_TEST(screens_look_as_they_did)
{
    const Screenshot *picture = &pictures[wanted[_i]];
    Scene scene;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scene_open(&scene, picture->words, &status), "%s", status.text);
    Screen *screen = &scene.screen;
    Canvas *canvas = &scene.canvas;
    compare(picture, canvas);
    static const int sizes[][2] = {{80, 24}, {120, 40}, {79, 23}, {132, 43}, {100, 30},
                                   {60, 18}, {40, 12},  {20, 5},  {200, 60}, {1, 1},
                                   {80, 23}, {300, 12}, {80, 20}, {80, 21},  {80, 19}};
    for (int i = 0; i < (int)(sizeof sizes / sizeof *sizes); i++)
        for (int glyphs = 0; glyphs < GLYPHS_COUNT; glyphs++)
            for (int focus = 0; focus < PANE_COUNT; focus++) {
                if (!suite_long() && ((i > 0 && !suite_wide() && (i + _i) % 15 != 0) ||
                                      (i + _i + focus) % GLYPHS_COUNT != glyphs))
                    continue;
                screen->look.glyphs = (Glyphs)glyphs;
                screen->panes.focus = (PaneId)focus;
                ck_assert(canvas_open(canvas, sizes[i][0], sizes[i][1], NULL));
                screen_draw(screen, canvas);
                expect_plain_glyphs(canvas, screen->look.glyphs, picture->words);
                expect_whole_numbers(canvas, picture->words);
                ck_assert(canvas->cursor_x < canvas->width && canvas->cursor_y < canvas->height);
            }
    scene_close(&scene);
}
END_TEST

/* --- panes keep to their places ------------------------------------------------------------------- */

typedef void Draw(const Screen *, Area);

static void draw_strip(const Screen *screen, Area area)
{
    pane_view(&view_strip, screen, area, false);
}

START_TEST(nothing_leaves_its_pane)
{
    static Draw *const draws[] = {pane_title, pane_keys,   pane_parameters, draw_strip,   pane_box,
                                  help_draw,  pane_number, pane_asked,      pane_question};
    const int panes = (int)(sizeof draws / sizeof *draws), drawings = panes + n_views;
    static const char *const words[] = {"mode5 80x24 700 stage 3", "mode5 80x24 700 running",
                                        "notched-beam-coarse 80x24 30 stage 5", "crossing 80x24 900 ended"};
    enum { WIDTH = 160, HEIGHT = 50, MARK = 0x2603 };
    Scene scene;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scene_open(&scene, words[_i], &status), "%s", status.text);
    ck_assert(canvas_open(&scene.canvas, WIDTH, HEIGHT, NULL));
    uint64_t state = 31;
    for (int trial = 0; trial < (suite_wide() ? 1200 : 300); trial++) {
        for (int i = 0; i < WIDTH * HEIGHT; i++)
            scene.canvas.cells[i].glyph = MARK;
        state ^= state << 13, state ^= state >> 7, state ^= state << 17;
        Rect rect = {(int)(state % 20), (int)(state >> 8) % 10, 1 + (int)(state >> 20) % 130,
                     1 + (int)(state >> 32) % 38};
        rect.y = abs(rect.y), rect.width = abs(rect.width), rect.height = abs(rect.height);
        Area area = {&scene.canvas, rect, (Glyphs)(trial % GLYPHS_COUNT)};
        scene.screen.look.glyphs = area.glyphs;
        const int drawing = trial % drawings;
        if (drawing < panes)
            draws[drawing](&scene.screen, area);
        else
            pane_view(views[drawing - panes], &scene.screen, area, trial % 2);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                bool inside =
                    x >= rect.x && x < rect.x + rect.width && y >= rect.y && y < rect.y + rect.height;
                if (!inside && scene.canvas.cells[y * WIDTH + x].glyph != MARK)
                    ck_abort_msg("drawing %d in %dx%d at %d,%d leaves it at %d,%d", drawing, rect.width,
                                 rect.height, rect.x, rect.y, x, y);
            }
    }
    scene_close(&scene);
}
END_TEST

START_TEST(panes_do_not_overlap)
{
    Scene scene;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scene_open(&scene, "mode1 80x24 0", &status), "%s", status.text);
    for (int width = 40; width < 240; width += suite_wide() ? 3 : 11)
        for (int height = 12; height < 80; height++)
            for (int turn = 0; turn < 6; turn++) {
                scene.screen.panes.zoomed = turn == 1;
                scene.screen.panes.sheet = turn < 2 ? SHEET_FULL : SHEET_PLAIN;
                scene.screen.panes.lecture = turn >= 4;
                scene.lesson.open = turn == 3 || turn == 5;
                Layout layout = layout_make(&scene.screen, width, height);
                char taken[240][80] = {0};
                Rect all[PANE_COUNT + SIDES_MAX + 4];
                int count = 0;
                for (int i = 0; i < PANE_COUNT; i++)
                    all[count++] = layout.panes[i];
                for (int i = 0; i < SIDES_MAX; i++)
                    all[count++] = layout.sides[i];
                all[count++] = layout.title, all[count++] = layout.keys;
                all[count++] = layout.number, all[count++] = layout.question;
                for (int i = 0; i < count; i++)
                    for (int y = all[i].y; y < all[i].y + all[i].height; y++)
                        for (int x = all[i].x; x < all[i].x + all[i].width; x++) {
                            if (x < 0 || y < 0 || x >= width || y >= height || taken[x][y])
                                ck_abort_msg("%dx%d: overlap at %d,%d", width, height, x, y);
                            taken[x][y] = 1;
                        }
                if (!screen_is_plain(&scene.screen))
                    ck_assert_int_eq(layout.panes[PANE_UPPER].width > 0, layout.kind == LAYOUT_FULL);
            }
    scene_close(&scene);
}
END_TEST

START_TEST(labels_stand_apart)
{
    Canvas canvas = {0};
    ck_assert(canvas_open(&canvas, 160, 20, NULL));
    uint64_t state = 77;
    for (int trial = 0; trial < (suite_wide() ? 20000 : 4000); trial++) {
        state ^= state << 13, state ^= state >> 7, state ^= state << 17;
        double scale = pow(10, (double)(state % 18) - 9),
               low = ((double)(state >> 8 & 0xff) / 128 - 1) * scale;
        double high = low + scale * (0.02 + (double)(state >> 16 & 0xff) / 100);
        int width = 16 + (int)(state >> 24 & 0x7f), height = 3 + (int)(state >> 32 & 0xf);
        Axis x = axis_with_ticks(axis_make(low, high), width / 9),
             y = axis_with_ticks(axis_make(low, high), 1 + height / 2);
        canvas_clear(&canvas);
        axes_draw((Area){&canvas, {0, 0, width, height}, GLYPHS_BRAILLE}, &x, &y, "x", GUTTER);
        /* each word of the last row is a whole label */
        double ticks[TICKS_MAX];
        int count = axis_ticks(&x, ticks);
        char row[200] = "", *rest = row;
        for (int i = 0; i < width; i++)
            row[i] = (char)canvas.cells[(height - 1) * canvas.width + i].glyph;
        for (char *word; (word = strtok_r(rest, " ", &rest));) {
            bool known = strcmp(word, "x") == 0;
            for (int i = 0; i < count && !known; i++) {
                char text[TICK_TEXT_MAX];
                axis_label(&x, ticks[i], text);
                known = strcmp(text, word) == 0;
            }
            ck_assert_msg(known, "\"%s\" is no label of %g..%g in %d columns", word, low, high, width);
        }
    }
    canvas_close(&canvas);
}
END_TEST

START_TEST(any_state_can_be_drawn)
{
    static const char *const scenarios[] = {"mode5 80x24 40 stage 2", "supported-beam-coarse 80x24 3 stage 4",
                                            "pull 80x24 100"};
    Scene scene;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scene_open(&scene, scenarios[_i], &status), "%s", status.text);
    uint64_t state = 5;
#define DRAW(most)                                                                                           \
    (state ^= state << 13, state ^= state >> 7, state ^= state << 17, (int)(state % (uint64_t)(most)))
    for (int trial = 0; trial < (suite_wide() ? 1500 : 300); trial++) {
        Screen *screen = &scene.screen;
        screen->look.glyphs = (Glyphs)DRAW(GLYPHS_COUNT);
        scene.playback.state = (RunState)DRAW(STATE_FAILED + 1);
        scene.playback.pace = DRAW(3) ? DRAW(1000) : 0.125;
        scene.playback.rate = DRAW(100000);
        scene.playback.at_limit = DRAW(2);
        scene.playback.work_share = DRAW(101) / 100.0;
        screen->panes.focus = (PaneId)DRAW(PANE_COUNT);
        screen->panes.zoomed = DRAW(3) == 0;
        screen->panes.sheet = (Sheet)DRAW(2);
        screen->panes.lecture = DRAW(4) == 0;
        screen->views.upper = views[DRAW(n_views)];
        screen->views.lower = views[DRAW(n_views)];
        for (int v = 0; v < n_views; v++)
            view_choose_variant(views[v], screen, DRAW(9));
        screen->views.references = (ReferencesShown)DRAW(SHOW_COUNT);
        scene.parameters.selected = DRAW(60) - 2;
        scene.parameters.edit.open = DRAW(4) == 0;
        strcpy(scene.parameters.edit.text, DRAW(2) ? "3:0.03,7:0.01,9:0.005,11:0.001,13:0.01" : "");
        scene.parameters.edit.cursor = DRAW(40);
        strcpy(scene.parameters.filter, DRAW(4) ? "" : "den");
        screen->chosen.particle = (size_t)DRAW(3000);
        screen->chosen.node = (size_t)DRAW(100);
        screen->chosen.is_node = DRAW(2);
        screen->panes.inspecting = inspector_find(screen) && DRAW(3) == 0;
        screen->log.event = DRAW(100) - 1;
        screen->log.first = DRAW(100);
        screen->chosen.table_column = DRAW(40);
        screen->time.window = DRAW(2) ? 0 : DRAW(100) / 7.0;
        screen->time.cursor = DRAW(2) ? NAN : DRAW(100) / 33.0;
        scene.prompt.open = DRAW(6) == 0;
        scene.prompt.yes_no = DRAW(2);
        strcpy(scene.prompt.question, "write the run as");
        strcpy(scene.prompt.text, "a-rather-long-name-of-a-file-in-some-folder/mode5.csv");
        scene.prompt.cursor = DRAW(60);
        strcpy(scene.prompt.problem, DRAW(2) ? "" : "it exists already");
        scene.message.kind = (MessageKind)DRAW(4);
        strcpy(scene.message.text, "a message that says something");
        scene.help.open = DRAW(6) == 0;
        scene.help.page = DRAW(5) - 1;
        scene.help.scroll = DRAW(200) - 5;
        scene.used.words[0] = state;
        screen->summary = DRAW(2) ? &scene.summary : NULL;
        int width = 1 + DRAW(180), height = 1 + DRAW(60);
        ck_assert(canvas_open(&scene.canvas, width, height, NULL));
        screen_draw(screen, &scene.canvas);
        expect_plain_glyphs(&scene.canvas, screen->look.glyphs, "random state");
        for (int x = -1; x <= width; x++)
            screen_key_command(screen, width, x);
    }
#undef DRAW
    scene_close(&scene);
}
END_TEST

START_TEST(the_bar_can_be_clicked)
{
    Scene scene;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scene_open(&scene, "mode1 80x24 0 focus 3", &status), "%s", status.text);
    char *text = canvas_dump(&scene.canvas), *last = text;
    for (char *line = text; *line; line = strchr(line, '\n') + 1)
        last = line;
    ck_assert_int_eq(screen_key_command(&scene.screen, 80, (int)(strstr(last, "Space") - last)),
                     COMMAND_RUN_PAUSE);
    ck_assert_int_eq(screen_key_command(&scene.screen, 80, (int)(strstr(last, "quit") - last)), COMMAND_QUIT);
    ck_assert_int_eq(screen_key_command(&scene.screen, 80, 0), COMMAND_NONE);
    free(text);
    scene_close(&scene);
}
END_TEST

START_TEST(the_help_holds_every_command)
{
    Scene scene;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scene_open(&scene, "mode1 120x200 0 help 0", &status), "%s", status.text);
    char *text = canvas_dump(&scene.canvas);
    for (int i = 0; i < n_commands; i++) {
        ck_assert_msg(strstr(text, pane_command_help(&commands[i])) != NULL, "%s is not in the help",
                      commands[i].name);
        ck_assert_msg(strstr(text, commands[i].keys) != NULL, "the keys %s are not", commands[i].keys);
    }
    free(text);
    scene_close(&scene);
}
END_TEST

void add_cases(Suite *suite)
{
    setlocale(LC_CTYPE, "C.UTF-8");
    int count = 0;
    for (int i = 0; i < (int)(sizeof pictures / sizeof *pictures); i++)
        if (suite_wide() || !takes_long(&pictures[i]))
            wanted[count++] = i;
    TCase *golden = tcase_create("pictures");
    tcase_add_loop_test(golden, screens_look_as_they_did, 0, count);
    suite_add_tcase(suite, golden);
    TCase *sound = tcase_create("sound");
    tcase_add_loop_test(sound, nothing_leaves_its_pane, 0, 4);
    tcase_add_test(sound, panes_do_not_overlap);
    tcase_add_test(sound, labels_stand_apart);
    tcase_add_loop_test(sound, any_state_can_be_drawn, 0, 3);
    tcase_add_test(sound, the_bar_can_be_clicked);
    tcase_add_test(sound, the_help_holds_every_command);
    suite_add_tcase(suite, sound);
}
