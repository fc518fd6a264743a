/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The runs of a picture: earlier ones as ghosts with letters, then the present one, or both of a duel; and a
 * foreign series over them: which view it belongs to, its stroke, marks and part of the axes. */
#include "views/plots/plots.h"

#include "run/duel.h"
#include "base/text.h"
#include "run/overlay.h"
#include "picture/picture.h"

#include <math.h>
#include <stdio.h>

static ShownRun present_run(const Experiment *experiment)
{
    ShownRun run = {
        .word = "measured",
        .line = LINE_SOLID,
        .style = STYLE_MEASURED,
        .rank = RANK_MEASURED,
        .mark = '*',
        .shown = true,
        .settings = experiment_settings(experiment),
        .record = experiment_record(experiment),
        .readout = experiment_readout(experiment),
        .experiment = experiment,
        .ghost = -1,
    };
    run.columns = experiment_columns(experiment, &run.n_columns);
    return run;
}

/* Of a duel: B dashed over A's solid line; where it has a picture of its own it is solid there. */
static ShownRun duel_run(const Screen *screen, int which)
{
    const Duel *duel = screen->duel;
    ShownRun run = present_run(which == 0 ? duel->a : duel->b);
    run.letter = "AB"[which];
    run.shown = screen->side == SIDE_BOTH || (screen->side == SIDE_B) == (which == 1);
    snprintf(run.word, sizeof run.word, "%c %s", run.letter, duel->names[which]);
    if (which == 1) {
        run.style = STYLE_SECOND;
        run.mark = 'x';
    }
    if (which == 1 && screen->side == SIDE_BOTH) {
        run.line = LINE_DASHED;
        run.rank = RANK_SECOND;
    }
    return run;
}

int runs_of(const Screen *screen, ShownRun runs[RUNS_MAX])
{
    const Ghost *ghosts = experiment_ghosts(screen_clock_run(screen));
    int count = 0;
    for (int i = 0; i < GHOSTS_MAX && screen->side != SIDE_B; i++) {
        const Ghost *ghost = &ghosts[i];
        if (!ghost->used)
            continue;
        ShownRun *run = &runs[count++];
        *run = (ShownRun){
            .letter = ghost->letter,
            .line = LINE_SOLID,
            /* what is not pinned goes with the next change: it is faint, and takes no colour */
            .style = ghost->pinned ? (Style)(STYLE_GHOST_A + i) : STYLE_FAINT,
            .rank = RANK_GHOST,
            .mark = ':',
            .shown = true,
            .settings = ghost->settings,
            .record = &ghost->record,
            .columns = ghost->columns,
            .n_columns = ghost->n_columns,
            .readout = &ghost->readout,
            .ghost = i,
            .profile = &ghost->profile,
            .crack = &ghost->crack,
        };
        snprintf(run->word, sizeof run->word, "%s", ghost->legend);
        snprintf(run->key, sizeof run->key, "%c:", ghost->letter);
    }
    if (screen_second_run(screen)) {
        runs[count++] = duel_run(screen, screen->side == SIDE_B ? 0 : 1);
        runs[count++] = duel_run(screen, screen->side == SIDE_B ? 1 : 0);
    } else
        runs[count++] = present_run(screen->experiment);
    return count;
}

int runs_column(const ShownRun *run, const char *name)
{
    return references_column(run->columns, run->n_columns, name);
}

int runs_with(ShownRun *runs, int n_runs, const char *column)
{
    int count = 0;
    for (int i = 0; i < n_runs; i++)
        if (runs_column(&runs[i], column) >= 0)
            runs[count++] = runs[i];
    return count;
}

void runs_begin(Picture *picture, const ShownRun *run)
{
    plot_begin(&picture->plot, STROKE_LINE, (Pen){run->line, run->mark, run->style, run->rank, 0});
}

PictureKey runs_key(const ShownRun *run)
{
    return (PictureKey){run->line, run->mark, run->style, run->word, (uint32_t)run->key[0], 0};
}

void runs_letter(Picture *picture, const ShownRun *run, double x, double y, MarkKind kind)
{
    if (run->letter)
        picture_add_mark(picture, (PictureMark){x, y, (uint32_t)run->letter, run->style, .kind = kind});
}

double runs_mark(const ShownRun *run, const Axis *x, int k)
{
    if (run->ghost < 0 || run->style == STYLE_FAINT)
        return NAN;
    /* each a little farther on: letters of curves that lie on each other stand side by side */
    const double share = (k + (run->ghost + 0.5) / GHOSTS_MAX) / RUN_MARKS;
    return x->low + share * (x->high - x->low);
}

void runs_add_ghosts(Picture *picture, const ShownRun *runs, int n_runs, const char *column)
{
    for (int i = 0; i < n_runs; i++) {
        if (runs[i].ghost < 0 || !runs[i].shown)
            continue;
        runs_begin(picture, &runs[i]);
        time_plot_curve(picture, &(TimeCurve){runs[i].record, runs_column(&runs[i], column), NULL, NULL});
    }
}

void runs_letter_over_time(Picture *picture, const ShownRun *run, int column)
{
    const Record *record = run->record;
    if (record->count == 0)
        return;
    const double *row = record_row(record, record_find(record, picture->plot.x.high));
    runs_letter(picture, run, row[1], row[column], MARK_PLACE);
    for (int k = 0; k < RUN_MARKS; k++) {
        const double time = runs_mark(run, &picture->plot.x, k);
        const double *here = record_row(record, record_find(record, time));
        /* none beyond the end of the curve */
        if (time < row[1])
            runs_letter(picture, run, here[1], here[column], MARK_AGAIN);
    }
}

void runs_add_letters(Picture *picture, const ShownRun *runs, int n_runs, const char *column)
{
    for (int i = 0; i < n_runs; i++)
        if (runs[i].shown)
            runs_letter_over_time(picture, &runs[i], runs_column(&runs[i], column));
}

void runs_add_keys(Picture *picture, const ShownRun *runs, int n_runs)
{
    for (int i = 0; i < n_runs; i++)
        if (runs[i].ghost >= 0 && runs[i].shown)
            picture_key(picture, runs_key(&runs[i]));
}

void runs_ghost_names(const Screen *screen, int columns, char *out, size_t size)
{
    ShownRun runs[RUNS_MAX];
    const int n_runs = runs_of(screen, runs);
    out[0] = '\0';
    for (int i = 0; i < n_runs; i++) {
        char name[RUN_WORD_MAX + sizeof runs[i].key + 3];
        snprintf(name, sizeof name, "%s%s %s", out[0] ? "  " : "", runs[i].key, runs[i].word);
        if (runs[i].ghost >= 0 && glyphs_columns(out) + glyphs_columns(name) <= columns)
            text_append(out, size, "%s", name);
    }
}

void runs_findings_text(const Screen *screen, const Finding *findings, int count, char *out, size_t size)
{
    char text[READOUT_TEXT], brief[READOUT_TEXT];
    findings_text(findings, count, screen_shows_exact(screen), text, sizeof text);
    findings_text(findings, count, false, brief, sizeof brief);
    snprintf(out, size, LONG_SHORT("%s", "%s"), text, brief);
}

int runs_note_findings(const Screen *screen, Picture *picture)
{
    Finding findings[FINDINGS_MAX];
    char text[2 * READOUT_TEXT];
    const int count =
        references_findings(experiment_references(screen->experiment), screen_simulation(screen), findings);
    for (int i = 0; i < count; i++) {
        runs_findings_text(screen, &findings[i], 1, text, sizeof text);
        picture_note(picture, STYLE_NORMAL, "%s", text)->flows = true;
    }
    return count;
}

/* --- a foreign series ------------------------------------------------------------------------------ */

enum { MARK_EVERY = 6 }; /* cells between the marks of a curve that is dense */

static const OverlayColumn *column_of(const Overlay *overlay, const char *curve, bool along)
{
    const int column = overlay ? overlay_column_for(overlay, curve, along) : -1;
    return column >= 0 ? &overlay->columns[column] : NULL;
}

void overlay_widen(const Screen *screen, const char *curve, bool along, double *least, double *most)
{
    const OverlayColumn *column = column_of(screen->overlay, curve, along);
    if (!column || isnan(column->least))
        return;
    *least = fmin(*least, column->least);
    *most = fmax(*most, column->largest);
}

typedef struct Samples {
    const double *x, *y;
} Samples;

static double sample(const void *context, size_t index, double *x)
{
    const Samples *samples = context;
    *x = samples->x[index];
    return samples->y[index];
}

/* Few values have a mark each; of many one now and then, to be seen where the run's curve covers them. */
void overlay_add(const Screen *screen, Picture *picture, const char *curve, bool along)
{
    const OverlayColumn *column = column_of(screen->overlay, curve, along);
    const Overlay *overlay = screen->overlay;
    const Axis *axis = &picture->plot.x;
    const int width = picture->across;
    if (!column)
        return;
    const double *x = overlay->columns[overlay->x].values;
    const Samples samples = {x, column->values};
    /* The rows that lie on the axis of x. */
    size_t first = overlay_find(overlay, axis->low), end = overlay_find(overlay, axis->high);
    end = end == overlay->count ? 0 : end + 1;
    first = first == overlay->count ? 0 : first;
    while (first < end && x[first] < axis->low)
        first++;
    plot_begin(&picture->plot, STROKE_DOTS, (Pen){LINE_SOLID, '+', STYLE_THIRD, RANK_SECOND, 0});
    plot_curve(&picture->plot, sample, &samples, first, end, picture->dots);
    picture_key(picture, (PictureKey){LINE_SOLID, '+', STYLE_THIRD, overlay->file, '+', 0});
    const bool few = end - first <= (size_t)width / 2;
    const size_t marks = few ? end - first : ((size_t)width + MARK_EVERY - 1) / MARK_EVERY;
    for (size_t i = 0; i < marks; i++) {
        const double share = ((double)(i * MARK_EVERY) + 0.5) / width;
        const size_t row =
            few ? first + i : overlay_find(overlay, axis->low + (axis->high - axis->low) * share);
        if (row >= first && row < end)
            picture_add_mark(picture,
                             (PictureMark){x[row], column->values[row], '+', STYLE_THIRD, .kind = MARK_DOT});
    }
}

double overlay_value(const Screen *screen, const char *curve, bool along, double x)
{
    const OverlayColumn *column = column_of(screen->overlay, curve, along);
    if (!column)
        return NAN;
    const Overlay *overlay = screen->overlay;
    const double *places = overlay->columns[overlay->x].values;
    size_t row = overlay_find(overlay, x);
    if (row == overlay->count || (x > places[row] && row + 1 == overlay->count))
        return NAN;
    if (x > places[row] && places[row + 1] - x < x - places[row])
        row++;
    return column->values[row];
}
