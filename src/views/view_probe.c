/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is measured at the probe over time, with reference curves, earlier runs and the readout. */
#include "views/plots/plots.h"
#include "scenario/parameters.h"
#include "run/overlay.h"
#include "scenario/concern_time.h"
#include "views/view.h"
#include "run/duel.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The column of a variant: what is measured, without energies. What a beam that breaks is looked at for comes
 * first, then a crack's pictures, of which *picture says which it is, -1: a column; where bonds never break
 * there is nothing to count. */
static int probe_column(const Screen *screen, int variant, int *picture)
{
    static const char *const energies[] = {"kinetic", "kinetic_grid", "strain",    "work",     "dissipated",
                                           "damped",  "total",        "potential", "friction", NULL};
    int n, count = 0, found[COLUMNS_MAX];
    const Column *columns = experiment_columns(screen->experiment, &n);
    const int pictures = crack_variants(screen);
    const bool cracks = pictures > 0, breaks = screen_has(screen, HAS_BREAKING);
    const int broken = experiment_column(screen->experiment, "broken_bonds"),
              speed = experiment_column(screen->experiment, "crack_speed");
    if (cracks && broken >= 0)
        found[count++] = broken;
    for (int i = 2; i < n; i++) {
        const bool has_picture =
            cracks && (i == broken || i == speed); /* the first one, and one of a crack's */
        if (columns[i].kind == COLUMN_MEASURED && columns[i].of < 0 && !has_picture &&
            text_place_in(columns[i].quantity.name, energies) < 0 && (i != broken || breaks))
            found[count++] = i;
    }
    *picture = variant > 0 && variant <= pictures ? variant - 1 : -1;
    if (variant > pictures)
        variant -= pictures;
    return variant < count ? found[variant] : -1;
}

static const char *word_of(const Screen *screen, int variant)
{
    int n, picture;
    const int column = probe_column(screen, variant, &picture);
    if (picture >= 0)
        return crack_variant_word(picture);
    return column >= 0 ? experiment_columns(screen->experiment, &n)[column].quantity.name : NULL;
}

static const char *curve(const Screen *screen)
{
    int n, picture;
    const Column *columns = experiment_columns(screen->experiment, &n);
    const int column = probe_column(screen, view_variant(&view_probe, screen), &picture);
    return column >= 0 ? columns[column].quantity.name : "";
}

static bool has_envelope(const Screen *screen, const char *name)
{
    return screen_shows_exact(screen) &&
           isfinite(references_envelope(experiment_references(screen->experiment), name, 0));
}

/* What a run measures, or a reference for it. */
typedef struct Line {
    const ShownRun *run;
    int column;
    PictureKey key;
    int rank;
    bool own; /* measured: the run's letter stands at its end */
} Line;

enum { REFERENCES_MAX = 6, LINES_MAX = 2 * (REFERENCES_MAX + 1) };

/* Adds those of a run that goes on. Two runs share a picture without the curves that only tell of one: each
 * has its smoothed curve, where there is one, and the exact one stands for both where it is the same. */
static int add_lines(const Screen *screen, const ShownRun *run, const char *name, Line *lines, int count)
{
    const bool shared = screen_is_shared(screen);
    const bool doubled = shared && run->experiment != screen->experiment && screen->duel->same_exact;
    const int column = runs_column(run, name), most = count + 1 + REFERENCES_MAX;
    Line *own = &lines[count++];
    *own = (Line){run, column, runs_key(run), run->rank, true};
    for (int i = 2; i < run->n_columns && count < most; i++) {
        const ColumnKind kind = run->columns[i].kind;
        Line line = {run, i, {0}, kind == COLUMN_EXACT ? RANK_EXACT : RANK_PREDICTED, false};
        if (run->columns[i].of != column)
            continue;
        const bool shown = time_plot_shows(screen, &run->columns[i]);
        line.key = time_plot_key(run->columns, i);
        if (kind == COLUMN_MEASURED) {
            line.rank = RANK_SECOND;
            own->rank = RANK_BAND; /* the raw one lies below */
        }
        if (shared && kind == COLUMN_MEASURED)
            *own = (Line){run, i, own->key, run->rank, true};
        else if (shown && !(shared && kind == COLUMN_PREDICTED) && !(doubled && kind == COLUMN_EXACT))
            lines[count++] = line;
    }
    return count;
}

/* "a period keeps 68.4 %, predicted 68.4 %" of the energy, where it does not keep all of it. */
static void append_kept(const Readout *readout, bool predicted, char out[READOUT_TEXT])
{
    const bool measured = isfinite(readout->kept_measured);
    if (!(readout->kept_predicted < READOUT_UNDAMPED) || !(measured || predicted))
        return;
    text_append(out, READOUT_TEXT, "%s" LONG_SHORT("a period keeps", "kept"), out[0] ? "  " : "");
    if (measured)
        text_append(out, READOUT_TEXT, " %.3g %%", 100 * readout->kept_measured);
    if (predicted)
        text_append(out, READOUT_TEXT, "%s " LONG_SHORT("predicted", "pred") " %.3g %%", measured ? "," : "",
                    100 * readout->kept_predicted);
}

/* What the run is judged by. */
static void frequency_lines(const Screen *screen, char first[READOUT_TEXT], char second[READOUT_TEXT])
{
    const Readout *readout = experiment_readout(screen->experiment);
    if (beam_lines(screen, first, second)) {
        append_kept(readout, screen_shows_predicted(screen), second);
        return;
    }
    const bool exact = readout->exact_known && screen_shows_exact(screen);
    const bool predicted = readout->predicted_known && screen_shows_predicted(screen);
    /* what comes to rest, or never moved, is judged by what it has come to */
    if (!readout->moving) {
        Finding findings[FINDINGS_MAX];
        const int n = references_findings(experiment_references(screen->experiment),
                                          screen_simulation(screen), findings);
        runs_findings_text(screen, findings, n, first, READOUT_TEXT);
        if (n == 0 && !readout->unjudged)
            snprintf(first, READOUT_TEXT, "nothing vibrates: no frequency to measure");
        return;
    }
    const bool wrong = settings_mistake(screen_settings(screen)) != NULL;
    /* while rows come in the fit is a little behind them, see experiment_rest() */
    const bool about = screen_is_running(screen) && experiment_is_flowing(screen->experiment);
    if (readout->measured_known)
        text_append(first, READOUT_TEXT, "ω%s %s%s",
                    wrong ? LONG_SHORT(" wrong code", "") : LONG_SHORT(" measured", ""), about ? "~" : "",
                    readout_text(readout, about ? 3 : 4).text);
    else if (readout->unaccounted)
        text_append(first, READOUT_TEXT, LONG_SHORT("ω: not known with", "ω ?") " %s", readout->unaccounted);
    else if (experiment_at_end(screen->experiment)) {
        text_append(first, READOUT_TEXT, "ω none");
        text_append(second, READOUT_TEXT, "%s", readout->unmeasured);
    } else
        text_append(first, READOUT_TEXT, "ω " LONG_SHORT("measuring", "..."));
    if (predicted)
        text_append(first, READOUT_TEXT, LONG_SHORT(" ", "") " %s %.4f",
                    wrong ? LONG_SHORT("right code", "right") : LONG_SHORT("predicted", "pred"),
                    readout->predicted);
    if (exact)
        text_append(first, READOUT_TEXT, LONG_SHORT(" ", "") " exact %.4f", readout->exact);
    if (readout->measured_known && exact) {
        const int decimals = readout_error_decimals(readout, about ? 1 : 2);
        const bool dies = readout->kept_predicted < READOUT_UNDAMPED;
        char late[80] = "", period[160];
        if (isfinite(readout->late))
            snprintf(late, sizeof late,
                     dies ? "  %.2f periods %s" : "  %.2f " LONG_SHORT("periods", "T") " %s",
                     fabs(readout->late), readout->late < 0 ? "ahead" : "behind");
        snprintf(period, sizeof period, "  T %+.*f %%%s", decimals, readout->error_period, late);
        /* of a decaying motion the decay is given, if there is no room for all */
        text_append(second, READOUT_TEXT, dies ? "ω %+.*f %%" LONG_SHORT("%s", "") : "ω %+.*f %%%s", decimals,
                    readout->error_frequency, period);
        if (predicted && readout->overlap < READOUT_PURE)
            text_append(second, READOUT_TEXT,
                        LONG_SHORT("  mixture of modes, overlap %.3f", "  mixture %.2f"), readout->overlap,
                        readout->overlap);
    }
    append_kept(readout, predicted, second);
}

/* The values of every curve at the cursor: with so many digits, and in short words if wanted. */
static void cursor_line(const Screen *screen, const Line *lines, int n_lines, const char *curve, int digits,
                        bool brief, char out[160])
{
    char letter[2] = "";
    out[0] = '\0';
    for (int i = 0; i < n_lines; i++) {
        const Record *record = lines[i].run->record;
        if (record->count == 0)
            return;
        const double *row = record_row(record, record_find(record, screen->time.cursor));
        if (i == 0)
            snprintf(out, 160, "%s", screen_time_text(screen, row[1]).text);
        /* a reference that is not known there has no value; what is measured says even so that it has none */
        if (i > 0 && !isfinite(row[lines[i].column]))
            continue;
        letter[0] = lines[i].run->letter;
        const char *name = lines[i].own && letter[0] ? letter : lines[i].key.name;
        text_append(out, 160, "  %s %s", brief ? legend_short_name(name) : name,
                    text_fitted(row[lines[i].column], digits, 12).text);
    }
    const double foreign = overlay_value(screen, curve, false, screen->time.cursor);
    if (isfinite(foreign))
        text_append(out, 160, "  %s %s", brief ? "file" : screen->overlay->file,
                    text_fitted(foreign, digits, 12).text);
}

static void note_readout(const Screen *screen, Picture *picture, const Line *lines, int n_lines,
                         const char *curve)
{
    char first[READOUT_TEXT] = "", second[READOUT_TEXT] = "";
    const bool cursor = isfinite(screen->time.cursor);
    if (cursor) {
        /* Every value is seen: with fewer digits and shorter words, else on two lines. */
        enum { MOST = 5, LEAST = 3 };
        char text[160], brief[160];
        int digits = MOST;
        cursor_line(screen, lines, n_lines, curve, MOST, false, text);
        do
            cursor_line(screen, lines, n_lines, curve, digits, true, brief);
        while (glyphs_columns(brief) > picture->columns - 2 && --digits >= LEAST);
        picture_note(picture, STYLE_SELECTED, LONG_SHORT("%s", "%s"), text, brief)->rows =
            digits <= LEAST ? 2 : 1;
    } else if (strcmp(experiment_readout(screen->experiment)->column, curve) != 0 &&
               !screen_problem(screen)->si)
        return;
    /* One line for each run of a duel: what matters most first. */
    for (int run = 0; run < 2 && screen_is_shared(screen) && !cursor; run++) {
        const Screen one = screen_of_side(screen, run == 0 ? SIDE_A : SIDE_B);
        frequency_lines(&one, first, second);
        picture_note(picture, STYLE_NORMAL, "%c %s%s%s", "AB"[run], first, second[0] ? "  " : "", second);
    }
    if (screen_is_shared(screen) ||
        (!cursor && !experiment_readout(screen->experiment)->moving && runs_note_findings(screen, picture)))
        return;
    frequency_lines(screen, first, second);
    picture_note(picture, STYLE_NORMAL, "%s", first);
    if (!cursor)
        picture_note(picture, STYLE_NORMAL, "%s", second)->joins = true;
}

/* The axis of the values of these runs, over all that they have, foreign series and references will be. */
static Axis value_axis(const Screen *screen, const ShownRun *runs, int n_runs, const Quantity *quantity)
{
    double reach = 0, low = INFINITY, high = -INFINITY; /* what the axis has to hold */
    bool oscillates = false;                            /* around zero; what only grows has its own range */
    for (int i = n_runs - 1; i >= 0; i--)
        if (runs[i].experiment) {
            const int column = runs_column(&runs[i], quantity->name);
            const Record *record = runs[i].record;
            Screen one = *screen;
            double least[COLUMNS_MAX], most[COLUMNS_MAX];
            bool asked = false;
            /* a range is asked for of a screen, and each run of a duel has its own */
            one.experiment = runs[i].experiment;
            reach = fmax(reach, time_plot_reach(record, column));
            for (int j = 2; j < runs[i].n_columns; j++) {
                if (runs[i].columns[j].of != column)
                    continue;
                if (!asked)
                    time_plot_range_to_come(&one, least, most);
                asked = oscillates = true;
                if (runs[i].columns[j].kind != COLUMN_MEASURED) {
                    reach = fmax(reach, fmax(-least[j], most[j]));
                    low = fmin(low, least[j]);
                    high = fmax(high, most[j]);
                }
            }
            for (size_t j = 0; j < record->count; j += time_plot_stride(record)) {
                const double value = record_row(record, j)[column];
                low = value < low ? value : low;
                high = value > high ? value : high;
            }
        }
    double foreign[2] = {0, 0};
    overlay_widen(screen, quantity->name, false, &low, &high);
    overlay_widen(screen, quantity->name, false, &foreign[0], &foreign[1]);
    reach = fmax(reach, fmax(-foreign[0], foreign[1]));
    if (has_envelope(screen, quantity->name)) {
        const double end = settings_time(screen_settings(screen))->end;
        const References *refs = experiment_references(screen->experiment);
        reach = fmax(reach, fmax(references_envelope(refs, quantity->name, 0),
                                 references_envelope(refs, quantity->name, end)));
    }
    if (strcmp(quantity->unit, "1") == 0) /* of things */
        return axis_count(high);
    /* what oscillates to one side of zero, a place, is seen about its own middle; what is conserved is not
     * magnified, nor are errors of rounding below zero */
    const double below = -0.1 * high;
    const bool aside = low > below && high > (1 + 1e-9) * low;
    if ((oscillates && !aside) || low < below)
        return axis_symmetric(reach);
    return axis_around(fabs(low) < 1e-9 * high ? 0 : low, high);
}

static void describe(const Screen *screen, int variant, Picture *picture)
{
    int n, of_crack;
    const Column *columns = experiment_columns(screen->experiment, &n);
    const int column = probe_column(screen, variant, &of_crack);
    if (of_crack >= 0) {
        crack_describe(screen, of_crack, picture);
        return;
    }
    if (column < 0) {
        picture_heading(picture, "over time");
        return;
    }
    const Quantity *quantity = &columns[column].quantity;
    ShownRun runs[RUNS_MAX];
    const int n_runs = runs_with(runs, runs_of(screen, runs), quantity->name);
    Line lines[LINES_MAX];
    int n_lines = 0, n_ghosts = 0;
    for (int i = n_runs - 1; i >= 0; i--) {
        n_ghosts += runs[i].ghost >= 0;
        if (runs[i].experiment && runs[i].shown)
            n_lines = add_lines(screen, &runs[i], quantity->name, lines, n_lines);
    }
    picture->compares = true;
    time_plot_axes(screen, picture, value_axis(screen, runs, n_runs, quantity), quantity->label,
                   quantity->unit);
    for (int own = 1; own >= 0; own--)
        for (int i = 0; i < n_lines; i++)
            if (lines[i].own == own)
                picture_key(picture, lines[i].key);
    runs_add_keys(picture, runs, n_runs);
    runs_add_ghosts(picture, runs, n_runs, quantity->name);
    for (int i = 0; i < n_lines; i++) {
        const PictureKey *key = &lines[i].key;
        plot_begin(&picture->plot, STROKE_LINE, (Pen){key->line, key->ascii, key->style, lines[i].rank, 0});
        time_plot_curve(picture, &(TimeCurve){lines[i].run->record, lines[i].column, NULL, NULL});
    }
    overlay_add(screen, picture, quantity->name, false);
    /* How far a beam that grows would oscillate by its lengthening alone. */
    enum { PIECES = 24 }; /* single dots, which no curve is drawn with */
    const References *refs = experiment_references(screen->experiment);
    Plot *plot = &picture->plot;
    if (has_envelope(screen, quantity->name)) {
        picture_key(picture, (PictureKey){LINE_DOTTED, ',', STYLE_FAINT,
                                          quantity->name[0] == 'u' ? "~L^1/2" : "~L^-3/2", SIGN_DOTS, 0});
        for (int sign = -1; sign <= 1; sign += 2) {
            plot_begin(plot, STROKE_DOTS, (Pen){LINE_DOTTED, ',', STYLE_FAINT, RANK_GHOST, 0});
            for (int i = 0; i <= PIECES; i++) {
                const double t = plot->x.low + (plot->x.high - plot->x.low) * i / PIECES;
                plot_point(plot, t, sign * references_envelope(refs, quantity->name, t));
            }
        }
    }
    runs_add_letters(picture, runs, n_ghosts, quantity->name); /* they come first */
    for (int i = 0; i < n_lines; i++)
        if (lines[i].own)
            runs_letter_over_time(picture, lines[i].run, lines[i].column);
    note_readout(screen, picture, lines, n_lines, quantity->name);
}

const View view_probe = {
    .word = "probe",
    .brief = "v_cm",
    .help = "the probe over time; again: its velocity, length, a crack's path and angle",
    .digit = 2,
    .home = PANE_LOWER,
    .opens = OPENS_ALWAYS,
    .describe = describe,
    .variant_word = word_of,
    .has_time_axis = true,
    .curve = curve,
};
