/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A figure as the source of another program, to be changed there: a picture of pgfplots for LaTeX (.tex), or
 * a script of gnuplot (.gp). Both have the curves as numbers with their colours and dashes, axes and legend.
 * A coordinate is the value over the axis's power of ten, which the name of the axis has; on an axis by roots
 * it is axis_place(), with the ticks of the page. */
#include "base/text.h"
#include "picture/paper/figure_file.h"
#include "picture/paper/paper.h"

#include <math.h>
#include <string.h>

static double place_on(const Axis *axis, double value)
{
    return axis->scale == SCALE_LINEAR ? value / axis_power_of_ten(axis->exponent)
           : axis->scale == SCALE_ROOT ? axis_place(axis, value)
                                       : value;
}

/* How an entry of the legend is shown: as a band, a dot or a piece of line. */
static StrokeKind kind_of(const PictureKey *key)
{
    return key->sign == SIGN_BAND                  ? STROKE_BAND
           : key->sign >= 0x80 || key->sign == '+' ? STROKE_DOTS
                                                   : STROKE_LINE;
}

/* The signs of marks, as pgfplots and gnuplot have them; the last is none. */
static const struct Sign {
    uint32_t glyph;
    const char *tex;
    int gnuplot;
} signs[] = {{0x25cf, "*", 7}, {0x25cb, "o", 6}, {'o', "o", 6}, {0x25a0, "square*", 5}, {0, "none", 0}};

static const struct Sign *sign_of(uint32_t glyph)
{
    const struct Sign *sign = signs;
    while (sign->glyph && sign->glyph != glyph)
        sign++;
    return sign;
}

/* Of an entry of the legend: dots without a sign of their own are discs. */
static const struct Sign *sign_of_key(const PictureKey *key)
{
    const struct Sign *sign = sign_of(key->sign);
    return sign->glyph ? sign : signs;
}

/* The word at a rule; the letter of an event explains itself in the laboratory alone. */
static const char *word_of(const PictureMark *mark)
{
    return mark->word && mark->word[0] && mark->word[1] ? mark->word : "";
}

/* The letter beside a mark, or in its place; 0: none. */
static char letter_of(const PictureMark *mark)
{
    return mark->glyph < 0x80 && mark->glyph != 'o' ? (char)mark->glyph : mark->letter;
}

/* --- pgfplots ------------------------------------------------------------------------------------------ */

/* Letters of other alphabets become words, powers of ten formulas. */
static void tex_words(FILE *out, const char *utf8)
{
    char plain[2 * PICTURE_TEXT_MAX];
    text_to_ascii(utf8, plain, sizeof plain);
    for (const char *at = plain; *at; at++)
        if (strncmp(at, "x10^", 4) == 0 && (at == plain || at[-1] == ' ')) {
            const int digits = (int)strspn(at + 4, "-0123456789");
            fprintf(out, "$\\times 10^{%.*s}$", digits, at + 4);
            at += 3 + digits;
        } else if (strchr("\\~^", *at))
            fprintf(out, "\\text%s{}", *at == '\\' ? "backslash" : *at == '~' ? "asciitilde" : "asciicircum");
        else if (strchr("|<>", *at))
            fprintf(out, "\\text%s{}", *at == '|' ? "bar" : *at == '<' ? "less" : "greater");
        else
            fprintf(out, strchr("#$%&_{}", *at) ? "\\%c" : "%c", *at);
}

static void tex_colour(FILE *out, const char *of, Colour colour)
{
    fprintf(out, "%s={rgb,255:red,%u;green,%u;blue,%u}", of, colour >> 16, colour >> 8 & 0xff, colour & 0xff);
}

static void tex_pencil(FILE *out, const Pencil *pencil)
{
    tex_colour(out, "color", pencil->colour);
    fprintf(out, ", line width=%gpt%s", pencil->width, pencil->round ? ", line cap=round" : "");
    for (int i = 0; i < 4 && pencil->dashes[i] > 0; i++)
        fprintf(out, "%s%s %gpt", i > 0 ? " " : ", dash pattern=", i % 2 ? "off" : "on", pencil->dashes[i]);
}

static void tex_axis(FILE *out, const Picture *picture, int which)
{
    const Axis *axis = which ? &picture->plot.y : &picture->plot.x;
    const char letter = which ? 'y' : 'x';
    char text[TICK_TEXT_MAX];
    double ticks[TICKS_MAX];
    fprintf(out, "%clabel={", letter);
    tex_words(out, which ? picture->heading : picture->x_name);
    fprintf(out, "}, %cmin=%.9g, %cmax=%.9g,\n", letter, place_on(axis, axis->low), letter,
            place_on(axis, axis->high));
    if (axis->scale == SCALE_LOG)
        fprintf(out, "%cmode=log,\n", letter);
    const int count = axis->scale == SCALE_ROOT ? axis_ticks(axis, ticks) : 0;
    for (int i = 0; i < count; i++)
        fprintf(out, "%s%.9g", i > 0 ? "," : which ? "ytick={" : "xtick={", place_on(axis, ticks[i]));
    for (int i = 0; i < count; i++) {
        axis_label(axis, ticks[i], text);
        fprintf(out, "%s%s", i > 0 ? "," : which ? "}, yticklabels={" : "}, xticklabels={", text);
    }
    fputs(count > 0 ? "},\n" : "", out);
}

static void tex_place(FILE *out, const Plot *plot, const double *place)
{
    const double x = place_on(&plot->x, place[0]), y = place_on(&plot->y, place[1]);
    if (isfinite(x) && isfinite(y))
        fprintf(out, "(%.9g,%.9g)\n", x, y);
    else
        fputs("(nan,nan)\n", out);
}

static void tex_stroke(FILE *out, const Picture *picture, int index)
{
    const Plot *plot = &picture->plot;
    const Stroke *stroke = &plot->strokes[index];
    const double *points = plot->points + 2 * stroke->first;
    const Pencil pencil = draw_pencil(picture, index);
    fputs("\\addplot[forget plot, ", out);
    if (stroke->kind == STROKE_BAND)
        tex_colour(out, "draw=none, fill", ink_fill(stroke->style, stroke->fill));
    else
        tex_pencil(out, &pencil);
    fputs(stroke->kind == STROKE_DOTS ? ", only marks, mark=*, mark size=0.8pt] coordinates {\n"
                                      : ", no marks] coordinates {\n",
          out);
    const size_t apart = stroke->kind == STROKE_BAND ? 2 : 1;
    for (size_t i = 0; i < stroke->count; i += apart)
        tex_place(out, plot, points + 2 * i);
    for (size_t i = stroke->kind == STROKE_BAND ? stroke->count / 2 : 0; i-- > 0;) /* back above it */
        tex_place(out, plot, points + 2 * (2 * i + 1));
    fputs(stroke->kind == STROKE_BAND ? "} -- cycle;\n" : "};\n", out);
}

static void tex_mark(FILE *out, const Picture *picture, const PictureMark *mark)
{
    const double x = place_on(&picture->plot.x, mark->x), y = place_on(&picture->plot.y, mark->y);
    if (mark->kind == MARK_RULE) {
        fputs("\\draw[line width=0.5pt, ", out);
        tex_colour(out, "color", ink_of(mark->style));
        fprintf(out, "] (axis cs:%.9g,\\pgfkeysvalueof{/pgfplots/ymin}) -- (axis cs:%.9g,", x, x);
        fputs("\\pgfkeysvalueof{/pgfplots/ymax}) node[below right] {", out);
        tex_words(out, word_of(mark));
        fputs("};\n", out);
        return;
    }
    if (mark->kind != MARK_PLACE)
        return;
    fputs("\\addplot[forget plot, only marks, ", out);
    tex_colour(out, "color", ink_of(mark->style));
    fprintf(out, ", mark=%s] coordinates {(%.9g,%.9g)}", sign_of(mark->glyph)->tex, x, y);
    if (letter_of(mark))
        fprintf(out, " node[right, font=\\footnotesize] {%c}", letter_of(mark));
    fputs(";\n", out);
}

void figure_write_tex(FILE *out, const Figure *figure, int columns)
{
    fprintf(out, "%% matvib " PACKAGE_VERSION "\n%% %s\n%% %s\n", figure->title, figure->parameters);
    fputs("% \\input it; the preamble needs \\usepackage{pgfplots}, \\pgfplotsset{compat=1.16} and\n"
          "% \\usepgfplotslibrary{groupplots}\n\\begin{tikzpicture}\n",
          out);
    fprintf(out,
            "\\begin{groupplot}[group style={group size=%d by %d, horizontal sep=2cm, vertical sep=2cm},\n",
            columns, (figure->count + columns - 1) / columns);
    fprintf(out,
            "width=%gmm, height=%gmm, scale only axis, unbounded coords=jump, legend pos=outer north east]\n",
            0.6 * figure->width / columns, 0.36 * figure->width / columns);
    for (int panel = 0; panel < figure->count; panel++) {
        const Picture *picture = &figure->panels[panel]->picture;
        fputs("\\nextgroupplot[title={", out);
        tex_words(out, figure->bare ? "" : figure->panels[panel]->caption);
        fputs("},\n", out);
        for (int axis = 0; axis < 2; axis++)
            tex_axis(out, picture, axis);
        fputs("]\n", out);
        for (int i = 0; i < picture->plot.n_strokes; i++)
            tex_stroke(out, picture, i);
        for (size_t i = 0; i < picture->n_marks; i++)
            tex_mark(out, picture, &picture->marks[i]);
        /* once, beside the first row */
        const bool has_legend =
            !figure->bare && panel == (columns < figure->count ? columns : figure->count) - 1;
        for (int i = 0; has_legend && i < picture->n_keys; i++) {
            const PictureKey *key = &picture->keys[i];
            static const char *const images[] = {[STROKE_LINE] = "no marks, ",
                                                 [STROKE_DOTS] = "only marks, ",
                                                 [STROKE_BAND] = "area legend, "};
            const Pencil pencil = ink_pencil(key->style, key->line, picture_run_of(key));
            fprintf(out, "\\addlegendimage{%s", images[kind_of(key)]);
            if (kind_of(key) == STROKE_DOTS)
                fprintf(out, "mark=%s, ", sign_of_key(key)->tex);
            if (kind_of(key) == STROKE_BAND)
                tex_colour(out, "fill", ink_fill(key->style, key->fill));
            else
                tex_pencil(out, &pencil);
            fputs("}\n\\addlegendentry{", out);
            tex_words(out, key->name);
            fputs("}\n", out);
        }
    }
    fputs("\\end{groupplot}\n\\end{tikzpicture}\n", out);
}

/* --- gnuplot ------------------------------------------------------------------------------------------- */

/* In single quotes, which are doubled in it. */
static void gnuplot_words(FILE *out, const char *text)
{
    fputc('\'', out);
    for (; *text; text++)
        fputs(*text == '\'' ? "''" : (const char[]){*text, '\0'}, out);
    fputc('\'', out);
}

static void gnuplot_mark(FILE *out, const Picture *picture, const PictureMark *mark)
{
    const double x = place_on(&picture->plot.x, mark->x), y = place_on(&picture->plot.y, mark->y);
    if (mark->kind == MARK_RULE) {
        fprintf(out, "set arrow from %.9g, graph 0 to %.9g, graph 1 nohead lc rgb '#%06x' lw 0.5\nset label ",
                x, x, ink_of(mark->style));
        gnuplot_words(out, word_of(mark));
        fprintf(out, " at %.9g, graph 0.95 offset 0.5,0\n", x);
    } else if (mark->kind == MARK_PLACE) {
        fprintf(out, "set label '%.1s' at %.9g,%.9g offset 0.7,0", (const char[]){letter_of(mark), '\0'}, x,
                y);
        if (sign_of(mark->glyph)->gnuplot)
            fprintf(out, " point pt %d lc rgb '#%06x'", sign_of(mark->glyph)->gnuplot, ink_of(mark->style));
        fputc('\n', out);
    }
}

/* As what a curve or an entry of the legend is drawn. */
static void gnuplot_look(FILE *out, StrokeKind kind, const char *dots, const Pencil *pencil, Colour fill)
{
    static const char *const drawn[] = {
        [STROKE_LINE] = "with lines", [STROKE_DOTS] = "with points", [STROKE_BAND] = "with filledcurves"};
    fprintf(out, "%s%s", drawn[kind], kind == STROKE_DOTS ? dots : "");
    if (kind == STROKE_BAND)
        fprintf(out, " fc rgb '#%06x'", fill);
    else {
        fprintf(out, " lc rgb '#%06x' lw %g", pencil->colour, pencil->width);
        for (int i = 0; i < 4 && pencil->dashes[i] > 0; i++) /* a dash of no length is not drawn there */
            fprintf(out, "%s%g", i > 0 ? "," : " dt (", fmax(pencil->dashes[i], 1));
        fputs(pencil->dashes[0] > 0 ? ")" : "", out);
    }
    fputs(", \\\n  ", out);
}

static void gnuplot_plot(FILE *out, const Picture *picture, int panel, bool bare)
{
    fputs("plot ", out);
    for (int i = 0; i < picture->plot.n_strokes; i++) {
        const Stroke *stroke = &picture->plot.strokes[i];
        const Pencil pencil = draw_pencil(picture, i);
        fprintf(out, "$p%ds%d notitle ", panel, i);
        gnuplot_look(out, stroke->kind, " pt 7 ps 0.4", &pencil, ink_fill(stroke->style, stroke->fill));
    }
    for (int i = 0; !bare && i < picture->n_keys; i++) {
        const PictureKey *key = &picture->keys[i];
        const Pencil pencil = ink_pencil(key->style, key->line, picture_run_of(key));
        char dots[16];
        fputs("NaN title ", out);
        gnuplot_words(out, key->name);
        snprintf(dots, sizeof dots, " pt %d", sign_of_key(key)->gnuplot);
        fputc(' ', out);
        gnuplot_look(out, kind_of(key), dots, &pencil, ink_fill(key->style, key->fill));
    }
    fputs("NaN notitle\n", out);
}

void figure_write_gnuplot(FILE *out, const Figure *figure, int columns)
{
    fprintf(out,
            "# matvib " PACKAGE_VERSION
            "\n# %s\n# %s\n# gnuplot -p FILE shows it; set terminal and set output before it write a file\n",
            figure->title, figure->parameters);
    fputs("set encoding utf8\nset termoption noenhanced\nset key outside\n", out);
    for (int panel = 0; panel < figure->count; panel++)
        for (int i = 0; i < figure->panels[panel]->picture.plot.n_strokes; i++) {
            /* The points of a stroke: x y, of a band x low high; an empty line breaks it. */
            const Plot *plot = &figure->panels[panel]->picture.plot;
            const Stroke *stroke = &plot->strokes[i];
            const size_t apart = stroke->kind == STROKE_BAND ? 2 : 1;
            fprintf(out, "$p%ds%d << END\n", panel, i);
            for (size_t k = 0; k + apart <= stroke->count; k += apart) {
                const double *point = plot->points + 2 * (stroke->first + k);
                const double x = place_on(&plot->x, point[0]), y = place_on(&plot->y, point[1]);
                if (isfinite(x) && isfinite(y))
                    fprintf(out, "%.9g %.9g", x, y);
                if (isfinite(x) && isfinite(y) && apart == 2)
                    fprintf(out, " %.9g", place_on(&plot->y, point[3]));
                fputc('\n', out);
            }
            fputs("END\n", out);
        }
    if (figure->count > 1)
        fprintf(out, "set multiplot layout %d,%d\n", (figure->count + columns - 1) / columns, columns);
    for (int panel = 0; panel < figure->count; panel++) {
        const Picture *picture = &figure->panels[panel]->picture;
        fputs("unset label\nunset arrow\nset title ", out);
        gnuplot_words(out, figure->bare ? "" : figure->panels[panel]->caption);
        fputc('\n', out);
        for (int which = 0; which < 2; which++) {
            const Axis *axis = which ? &picture->plot.y : &picture->plot.x;
            const char letter = which ? 'y' : 'x';
            char text[TICK_TEXT_MAX];
            double ticks[TICKS_MAX];
            fprintf(out, "%sset logscale %c\nset %clabel ", axis->scale == SCALE_LOG ? "" : "un", letter,
                    letter);
            gnuplot_words(out, which ? picture->heading : picture->x_name);
            fprintf(out, "\nset %crange [%.9g:%.9g]\nset %ctics ", letter, place_on(axis, axis->low),
                    place_on(axis, axis->high), letter);
            const int count = axis->scale == SCALE_ROOT ? axis_ticks(axis, ticks) : 0;
            fputs(count > 0 ? "(" : "autofreq\n", out);
            for (int i = 0; i < count; i++) {
                axis_label(axis, ticks[i], text);
                fprintf(out, "'%s' %.9g%s", text, place_on(axis, ticks[i]), i + 1 < count ? ", " : ")\n");
            }
        }
        for (size_t i = 0; i < picture->n_marks; i++)
            gnuplot_mark(out, picture, &picture->marks[i]);
        gnuplot_plot(out, picture, panel, figure->bare);
    }
    fputs(figure->count > 1 ? "unset multiplot\n" : "", out);
}
