/* The help: keys by group, what the curves mean, and what is solved, with every equation and every slip of
 * the papers. */
#include "view/panes.h"

#include <stdio.h>
#include <string.h>

enum { TEXT_MAX = 24000, LINES_MAX = 400 };

/* Lines of text with a style each. Too many: the last ones are left out. */
typedef struct Sheet {
    char text[TEXT_MAX];
    size_t used;
    struct {
        size_t at;
        Style style;
    } lines[LINES_MAX];
    int count;
} Sheet;

static void put_line(Sheet *sheet, Style style, const char *text)
{
    size_t length = strlen(text) + 1;
    if (sheet->count == LINES_MAX || sheet->used + length > TEXT_MAX)
        return;
    memcpy(sheet->text + sheet->used, text, length);
    sheet->lines[sheet->count].at = sheet->used;
    sheet->lines[sheet->count++].style = style;
    sheet->used += length;
}

/* A paragraph, broken into lines of `width` columns, further ones indented like the first. */
static void put_text(Sheet *sheet, Style style, int width, int indent, const char *text)
{
    const int least = indent + 8;
    width = width > least ? width : least;
    while (*text) {
        char line[512];
        const char *here = text, *space = NULL;
        for (int columns = indent; *here && *here != '\n'; columns++) {
            if (*here == ' ')
                space = here;
            if (columns >= width) {
                here = space && space > text ? space : here;
                break;
            }
            utf8_next(&here);
        }
        snprintf(line, sizeof line, "%*s%.*s", indent, "", (int)(here - text), text);
        put_line(sheet, style, line);
        text = *here == ' ' || *here == '\n' ? here + 1 : here;
    }
}

/* --- keys ----------------------------------------------------------------------------------------- */

static void write_verbs(Sheet *sheet, int width)
{
    put_line(sheet, STYLE_NORMAL, "");
    put_line(sheet, STYLE_HEADING, "Behind :");
    for (int i = 0; i < n_line_verbs; i++) {
        char line[256];
        snprintf(line, sizeof line, "  %s %s", line_verbs[i].name, line_verbs[i].arguments);
        put_line(sheet, STYLE_NORMAL, line);
        put_text(sheet, STYLE_NORMAL, width, 13 < width / 3 ? 13 : 4, line_verbs[i].help);
    }
}

static void write_keys(Sheet *sheet, int width)
{
    const char *group = "";
    for (int i = 0; i < n_commands; i++) {
        if (strcmp(commands[i].group, group) != 0) {
            if (*group)
                put_line(sheet, STYLE_NORMAL, "");
            put_line(sheet, STYLE_HEADING, group = commands[i].group);
        }
        char line[256];
        snprintf(line, sizeof line, "  %-10s %s", commands[i].keys, commands[i].help);
        if (text_columns(line) <= width) {
            put_line(sheet, STYLE_NORMAL, line);
            continue;
        }
        snprintf(line, sizeof line, "  %s", commands[i].keys);
        put_line(sheet, STYLE_NORMAL, line);
        put_text(sheet, STYLE_NORMAL, width, 13 < width / 3 ? 13 : 4, commands[i].help);
    }
    write_verbs(sheet, width);
}

/* --- curves --------------------------------------------------------------------------------------- */

static void write_curves(Sheet *sheet, int width, bool bar)
{
    static const struct {
        const char *word, *meaning;
    } words[] = {
        {"measured",
         "what this run does: solid. In a time plot each column shows the least and the largest of "
         "its rows, so no peak is lost."},
        {"predicted",
         "what theory says this mesh and this time step must do: dashed. It holds the error of the "
         "method, worked out beforehand."},
        {"exact",
         "the continuum without mesh and time step: dotted. Where two beam theories are known both are "
         "drawn, by name."},
        {"faint",
         "curves of an earlier run: the one before the last edit, or pinned ones with their letter."},
    };
    static const struct {
        const char *word, *meaning;
    } bar_words[] = {
        {"w",
         "the frequency in radians per time, by least squares of cosine, sine and offset. T is the period: "
         "its error has the other sign."},
        {"late",
         "by how many periods the run is behind the exact answer now: a small error of frequency grows "
         "into a large lag."},
        {"v_cm",
         "the velocity of the centre of mass. Its amplitude may fall while the energy is still there: "
         "it then sits in particle velocities that cancel within a cell."},
        {"hidden",
         "the part of the kinetic energy that the grid cannot see: what is left when the particles are "
         "mapped to the nodes and back. The share below the energies is the mean over what the plot shows."},
        {"ripple",
         "velocities and stresses are known half a step apart, so their sum ripples by about half of "
         "w times the time step. It is no loss: E* takes velocity and stress where they belong together, and "
         "does not ripple. What E* loses is lost."},
        {"K and F",
         "view 5, the two reasons for the error of w. K: the masses are lumped on the nodes. F: what is left "
         "of a wave that goes from the particles to the nodes and back. Its axis goes by square roots, so "
         "that an error that grows like the square of n is a straight line."},
    };
    static const struct {
        const char *word, *meaning;
    } beam_words[] = {
        {"probe", "the mid-point of a supported beam, the tip of a cantilever."},
        {"Euler", "Euler-Bernoulli: plane sections stay at right angles. Timoshenko adds shear and rotation: "
                  "what a two-dimensional body should give."},
        {"T",
         "the period, by least squares. The lattice makes the beam a little thinner and shorter than asked "
         "for: predicted is Timoshenko's period of the beam as it lies."},
        {"zeros",
         "the same period from the zeros of the swing alone: where the two differ the record is short "
         "or no pure sine."},
        {"modal",
         "the moving cantilever by its first bending modes on the growing length. Filtered: the end of "
         "the straight line through the last 0.1 ms, which has no thickness modes."},
        {"~L^1/2", "how far a swing reaches as the beam grows slowly: the displacement as the root of its "
                   "length, the velocity as L^-3/2, for energy over frequency is kept."},
        {"section", "view 1, the last: the displacement along the beam through its height at the chosen "
                    "particle. On the line -y duy/dx sections stay plane and upright."},
        {"force",
         "view 4: what a bond answers to its stretch s, and s0 where it breaks. Nodes stand where their "
         "most stretched bond is; heights are logarithms of how many."},
        {"G0",
         "the energy that a crack should cost for its area, and s0 follow from each other: edit either. "
         "View 3, again: what the crack has cost so far."},
        {"residual",
         "kinetic + strain + dissipated energy less the work of the load: 0 but for the time step."},
        {"height", "view 6: the predicted lines are rows of the lattice that ring against each other through "
                   "the beam's height."},
        {"damage",
         "the share of a node's bonds that is broken. A crack right through reads 0.4 to 0.5, not 1."},
        {"horizon",
         "view 5: the period over the reach of the bonds, with the two beam theories. Each earlier run with "
         "another horizon leaves its dot."},
    };
    static const struct {
        const char *word, *meaning;
    } last_words[] = {
        {"timeline", "under the plots, from 0 to the end of the run: the line is what has been computed, the "
                     "dot is where "
                     "we are. x: a particle crossed into another cell; b: bonds broke; E: the energy left "
                     "its range; c: a "
                     "parameter was changed; !: the run stopped."},
        {"spectrum",
         "view 6: how large each sine in the record is. A record of the length t shows no line finer than "
         "2 pi/t: a longer one is sharper."},
    };
    put_line(sheet, STYLE_HEADING, "What the curves mean");
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        put_line(sheet, STYLE_FOCUS, words[i].word);
        put_text(sheet, STYLE_NORMAL, width, 4, words[i].meaning);
    }
    put_line(sheet, STYLE_NORMAL, "");
    const size_t count = bar ? sizeof bar_words / sizeof *bar_words : sizeof beam_words / sizeof *beam_words;
    for (size_t i = 0; i < count; i++) {
        put_line(sheet, STYLE_FOCUS, bar ? bar_words[i].word : beam_words[i].word);
        put_text(sheet, STYLE_NORMAL, width, 4, bar ? bar_words[i].meaning : beam_words[i].meaning);
    }
    put_line(sheet, STYLE_NORMAL, "");
    for (size_t i = 0; i < sizeof last_words / sizeof *last_words; i++) {
        put_line(sheet, STYLE_FOCUS, last_words[i].word);
        put_text(sheet, STYLE_NORMAL, width, 4, last_words[i].meaning);
    }
}

/* --- what is solved ------------------------------------------------------------------------------- */

typedef struct Passage {
    bool heading;
    const char *text, *ascii; /* ascii NULL: the text is */
} Passage;

static const Passage bar_before[] = {
    {true, "What is solved: axial vibration of a bar", NULL},
    {false, "Momentum and Hooke's law along a line, small strains:", NULL},
    {false, "ρ dv/dt = dσ/dx + ρ b      dσ/dt = E dv/dx", "rho dv/dt = ds/dx + rho b      ds/dt = E dv/dx"},
    {false, "Weak form, with a test function w that vanishes where the bar is held:", NULL},
    {false, "∫ w ρ dv/dt dx = -∫ w′ σ dx + ∫ w ρ b dx + w t at the ends",
     "int w rho dv/dt dx = -int w' s dx + int w rho b dx + w t at the ends"},
    {false, "The integrals become sums over particles of mass m and volume m/ρ.",
     "The integrals become sums over particles of mass m and volume m/rho."},
    {true, "The exact answer", NULL},
    {false, "v = A φ(x) cos ωt    u = A/ω φ(x) sin ωt    ω = β c,  c = √(E/ρ)",
     "v = A f(x) cos wt    u = A/w f(x) sin wt    w = beta c,  c = sqrt(E/rho)"},
    {false,
     "φ = sin βx if the left end is held, cos βx if it is free; β = (2n-1)π/2L with one free end, nπ/L "
     "with two equal ends. Several modes add up.",
     "f = sin(beta x) if the left end is held, cos(beta x) if it is free; beta = (2n-1) pi/2L with one free "
     "end, "
     "n pi/L with two equal ends. Several modes add up."},
    {true, "One time step", NULL},
};

static const Passage bar_after[] = {
    {true, "What this mesh makes of a wave (hat, uGIMP)", NULL},
    {false, "ω² = (c/Δx)² F K    K = 4 sin²(βΔx/2)\nF = 1 - (1/3 + 1/(6P²))(1 - cos βΔx)",
     "w^2 = (c/dx)^2 F K    K = 4 sin^2(beta dx/2)\nF = 1 - (1/3 + 1/(6P^2))(1 - cos(beta dx))"},
    {false,
     "K is the usual dispersion of linear elements; F, what particle to node to particle leaves of a wave, "
     "is the larger part of the error. P: particles per cell.",
     NULL},
    {true, "Slips of the paper, and what is done instead", NULL},
    {false,
     "eqs. 5, 6: as printed they are no tensor expressions. In one dimension the strain increment is "
     "Δt Σ N′v without the 1/2, and the vorticity increment is 0: a line cannot spin.",
     "eqs. 5, 6: as printed they are no tensor expressions. In one dimension the strain increment is dt sum "
     "N'v "
     "without the 1/2, and the vorticity increment is 0: a line cannot spin."},
    {false, "eq. 7: the density is the particle's.", NULL},
    {false, "eq. 9: a stray t.", NULL},
    {false, "eqs. 14, 15: they start from the particle's own velocity and place.", NULL},
    {false, "eq. 17: L is a length. \"In elements\" is true only where a cell has the size 1.", NULL},
    {false, "A particle gives to two nodes here, to four in two dimensions, to eight in three.", NULL},
};

static const Passage beam_before[] = {
    {true, "What is solved: a beam of points that pull at each other", NULL},
    {false, "ρ d²u/dt² = Σ c G w s V (ξ+η)/|ξ+η| + b      s = (|ξ+η| - |ξ|)/|ξ|",
     "rho d2u/dt2 = sum c G w s V (xi+eta)/|xi+eta| + b      s = (|xi+eta| - |xi|)/|xi|"},
    {false,
     "The sum runs over the family: all points nearer than the horizon δ. ξ is where the other lies at "
     "first, η how far the two have moved apart; c = 6E/(πδ³(1-ν)) with ν = 1/3, the only value that "
     "this theory has in two dimensions.",
     "The sum runs over the family: all points nearer than the horizon delta. xi is where the other lies at "
     "first, "
     "eta how far the two have moved apart; c = 6E/(pi delta^3 (1-nu)) with nu = 1/3, the only value that "
     "this "
     "theory has in two dimensions."},
    {false,
     "w counts a point at the edge of the horizon by the part of its area inside (partial volume). "
     "G makes up for what bonds near a surface lack (surface correction).",
     NULL},
    {false, "A bond breaks for ever at the critical stretch: s₀ = √(4πG₀/(9Eδ)).",
     "A bond breaks for ever at the critical stretch: s0 = sqrt(4 pi G0/(9 E delta))."},
    {true, "One time step (velocity Verlet)", NULL},
};

static const Passage beam_after[] = {
    {true, "The right answers", NULL},
    {false, "Euler-Bernoulli: T = 2L²/π / √(Eh²/12ρ). Timoshenko: the same with shear and rotation, κ = 5/6.",
     "Euler-Bernoulli: T = 2L^2/pi / sqrt(E h^2/(12 rho)). Timoshenko: the same with shear and rotation, "
     "kappa = 5/6."},
    {false,
     "Moving cantilever: bending modes of the length outside the channel, L(t) = L0 + v0 t; its amplitude "
     "grows and it swings ever more slowly.",
     NULL},
    {true, "Slips of the paper, and what is done instead", NULL},
    {false, "Before eq. 9: \"Eq. (5)\" means eq. 8.", NULL},
    {false, "ν = .33 of the notched beam is 1/3.", "nu = .33 of the notched beam is 1/3."},
    {false, "Velocity Verlet and central differences give the same positions.", NULL},
    {false, "The time step of 1e-8 s is far below the critical one; periods do not depend on it.", NULL},
    {false,
     "Table 1 is not monotone because a beam of floor(h/dx) layers is up to 4 % thinner and the supports "
     "lie a spacing nearer: see real height and real span.",
     NULL},
};

static void write_passages(Sheet *sheet, int width, bool ascii, const Passage *passages, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const char *text = ascii && passages[i].ascii ? passages[i].ascii : passages[i].text;
        if (passages[i].heading && sheet->count > 0)
            put_line(sheet, STYLE_NORMAL, "");
        if (passages[i].heading)
            put_text(sheet, STYLE_HEADING, width, 0, text);
        else
            put_text(sheet, STYLE_NORMAL, width, 2, text);
    }
}

static void write_solved(Sheet *sheet, const Screen *screen, int width, bool bar)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    const bool ascii = screen->glyphs == GLYPHS_ASCII;
    if (bar)
        write_passages(sheet, width, ascii, bar_before, sizeof bar_before / sizeof *bar_before);
    else
        write_passages(sheet, width, ascii, beam_before, sizeof beam_before / sizeof *beam_before);
    for (int i = 0; i < sim->n_stages; i++) {
        const Stage *stage = &sim->stages[i];
        char line[160];
        snprintf(line, sizeof line, "%d %s   (%s)", i + 1, stage->name, stage->source);
        put_text(sheet, STYLE_FOCUS, width, 2, line);
        put_text(sheet, STYLE_NORMAL, width, 4, ascii ? stage->ascii : stage->equation);
        put_text(sheet, STYLE_FAINT, width, 4, stage->sentence);
    }
    if (bar)
        write_passages(sheet, width, ascii, bar_after, sizeof bar_after / sizeof *bar_after);
    else
        write_passages(sheet, width, ascii, beam_after, sizeof beam_after / sizeof *beam_after);
}

static int page_of(const Screen *screen)
{
    return screen->help_page < 0 ? 0 : screen->help_page >= HELP_PAGES ? HELP_PAGES - 1 : screen->help_page;
}

/* The lines of the page that is open, for a screen of this width. */
static void write_page(Sheet *sheet, const Screen *screen, int screen_width)
{
    const int width = screen_width - 2 < 100 ? screen_width - 2 : 100, page = page_of(screen);
    const bool bar = experiment_settings(screen->experiment)->problem == PROBLEM_BAR;
    sheet->used = 0;
    sheet->count = 0;
    if (page == 0)
        write_keys(sheet, width);
    else if (page == 1)
        write_curves(sheet, width, bar);
    else
        write_solved(sheet, screen, width, bar);
}

int screen_help_pages(void)
{
    return HELP_PAGES;
}

int screen_help_most(const Screen *screen, int width, int height)
{
    Sheet sheet;
    if (layout_make(screen, width, height).kind == LAYOUT_TOO_SMALL)
        return 0; /* nothing of it is shown, and its lines need some width */
    write_page(&sheet, screen, width);
    const int room = height - 3; /* without title, heading and bar */
    return sheet.count > room ? sheet.count - room : 0;
}

void pane_help(const Screen *screen, Area area)
{
    static const char *const names[HELP_PAGES] = {"keys", "the curves", "what is solved"};
    const int page = page_of(screen), room = area.rect.height - 1;
    Sheet sheet;
    write_page(&sheet, screen, area.rect.width);

    int first = screen->help_scroll;
    if (first > sheet.count - room)
        first = sheet.count - room;
    if (first < 0)
        first = 0;
    char heading[96];
    snprintf(heading, sizeof heading, "Help %d of %d: %s", page + 1, HELP_PAGES, names[page]);
    area_rule(area, 0, heading, STYLE_FOCUS);
    if (sheet.count > room) {
        snprintf(heading, sizeof heading, " lines %d-%d of %d ", first + 1,
                 first + room < sheet.count ? first + room : sheet.count, sheet.count);
        if (text_columns(heading) + 30 < area.rect.width)
            area_text_right(area, area.rect.width - 2, 0, heading, STYLE_FAINT);
    }
    for (int y = 0; y < room && first + y < sheet.count; y++)
        area_text(area, 1, 1 + y, sheet.text + sheet.lines[first + y].at, sheet.lines[first + y].style);
}
