/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of options and its reader (options.h). A row says which commands have the option, what its
 * value may be and which member it fills; --help, manual and completion print the rows. Then SCENARIO,
 * --set and the short forms (--end, --steps ...) are turned into one list of overrides for the scenario
 * reader. */
#include "cli/options.h"

#include "scenario/settings.h"
#include "base/input.h"
#include "base/threads.h"
#include "base/text.h"
#include "views/view.h"
#include "scenario/parameters.h"
#include "scenario/scenario_lines.h"
#include "lab/session/script.h"
#include "lessons/lesson.h"
#include "help/command.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static const char *const dialects[] = {"comma", "semicolon", NULL};
static const char *const vtk_data[] = {"text", "raw", NULL};
#define WORD(name) #name,
static const char *const languages[] = {TEMPLATE_LANGUAGES(WORD) NULL};
static const char *const glyph_sets[] = {"auto", "braille", "block", "ascii", NULL};
static const char *const themes[] = {"auto", "light", "dark", NULL};

#define AT(member)    .offset = offsetof(Options, member)
#define LETTER(c)     .letter = (c)
#define ONE_OF(names) .kind = OPTION_WORD, .words = names

const Option options_table[] = {
    {"--set", "KEY=VALUE", " open show run figure movie sound fit diagnose sweep ",
     "a value instead of the scenario's; may be repeated", OPTION_OVERRIDE, AT(overrides)},
    {"--end", "T", " open show run figure movie sound fit sweep ", "the run ends at time T", OPTION_OVERRIDE,
     AT(overrides), .key = "time.end"},
    {"--steps", "N", " open show run figure movie sound fit sweep ", "the run ends after N steps",
     OPTION_COUNT, AT(steps)},
    {"--vary", "KEY=VALUES", " sweep ",
     "a run for each value, KEY=A,B,C or KEY=LO:HI:N; given twice: the product", OPTION_AXIS, AT(axes)},
    {"--with", "KEY=VALUES", " sweep ", "changes value by value together with the --vary before it",
     OPTION_AXIS, AT(axes)},
    {"--view", "NAME", " figure ", "what is drawn, as in profile or profile:stress; --list prints the names",
     OPTION_TEXT, AT(view)},
    {"--against", "KEY=VALUE", " figure ", "draws the run with this value behind; up to four times",
     OPTION_LIST, AT(against)},
    {"--output", "FILE", " figure ", "the figure: FILE.svg, .pdf, .png, .tex or .gp", OPTION_TEXT, AT(output),
     LETTER('o')},
    {"--output", "FILE", " sweep ", "where the table goes", OPTION_TEXT, AT(output), LETTER('o')},
    {"--output", "FILE", " movie ", "the film: FILE.cast (asciinema), FILE.svg (animated) or FILE.gif",
     OPTION_TEXT, AT(output), LETTER('o')},
    {"--data", "FILE", " fit ", "the measured series: a CSV file with a column of times", OPTION_INPUT,
     AT(data)},
    {"--vary", "KEY,...", " fit ", "the parameters that are sought, from the scenario's values on",
     OPTION_TEXT, AT(sought)},
    {"--column", "NAME", " fit ", "the column of the series that was measured (the first that FILE has too)",
     OPTION_TEXT, AT(column)},
    {"--output", "FILE", " fit ", "a table: time, datum, fitted, residual", OPTION_TEXT, AT(output),
     LETTER('o')},
    {"--figure", "FILE", " fit ", "a picture of both: FILE.svg, .pdf, .png, .tex or .gp", OPTION_TEXT,
     AT(figure)},
    {"--map", "THEIRS=OURS,...", " diagnose ",
     "columns whose names say nothing, by name or number; --map 1=time,2=v_cm*0.001 turns mm into m",
     OPTION_TEXT, AT(map)},
    {"--pairs", NULL, " diagnose ",
     "tries two mistakes at once on beams too, where no one thing explains the numbers; it takes longer",
     OPTION_FLAG, AT(pairs)},
    {"--time", "SECONDS", " diagnose ", "tries no more codes after so many seconds of a file", OPTION_TEXT,
     AT(time_bound)},
    {"--template", "LANGUAGE", " diagnose ",
     "prints the lines that write a good file: python, matlab, fortran, julia", AT(template),
     ONE_OF(languages)},
    {"--output", "FILE", " diagnose ", "a table with a row for each file: FILE.csv", OPTION_TEXT, AT(output),
     LETTER('o')},
    {"--json", NULL, " diagnose ", "the same rows on standard output, as JSON", OPTION_FLAG, AT(json)},
    {"--json", NULL, " run fit verify ",
     "the summary as one JSON object of quantities {name, value, unit} on standard output", OPTION_FLAG,
     AT(json)},
    {"--name", "NAME", " lesson ", "whose homework it is: the exercises' variants are drawn from it",
     OPTION_TEXT, AT(name)},
    {"--id", "ID", " lesson ", "the student's number or address, by which tables of marks are joined",
     OPTION_TEXT, AT(id)},
    {"--key", NULL, " grade ", "prints the right answers of LESSON, and judges its exercises", OPTION_FLAG,
     AT(key)},
    {"--name", "NAME", " grade ", "with --key: those of that student", OPTION_TEXT, AT(name)},
    {"--handout", "FILE", " lesson ", "the questions on paper: FILE.pdf", OPTION_TEXT, AT(handout)},
    {"--print", NULL, " lesson ", "prints the text of NAME, to begin one of your own with", OPTION_FLAG,
     AT(print)},
    {"--output", "FILE", " grade ", "where the table of marks goes (standard output)", OPTION_TEXT,
     AT(output), LETTER('o')},
    {"--moodle", "FILE", " grade ", "writes a table with a row for each student, as Moodle imports it",
     OPTION_TEXT, AT(moodle)},
    {"--roster", "FILE", " grade ",
     "reads the list of the class (CSV with names and ID numbers): who handed in nothing has a row too",
     OPTION_INPUT, AT(roster)},
    {"--bom", NULL, " grade ", "begins tables with the mark by which spreadsheets know UTF-8", OPTION_FLAG,
     AT(bom)},
    {"--sheet", "FILE", " grade ", "a page for each session: FILE.pdf", OPTION_TEXT, AT(sheet)},
    {"--limit", "S", " grade ", "a session that takes longer than S seconds gets no marks (300)",
     OPTION_NUMBER, AT(limit), .range = {1, 1e6}},
    {"--output", "FILE", " sound ", "the sound: FILE.wav", OPTION_TEXT, AT(output), LETTER('o')},
    {"--seconds", "S", " sound ", "how long it is to be heard (6)", OPTION_NUMBER, AT(seconds),
     .range = {0.1, 600}},
    {"--pitch", "HZ", " sound ", "pitch of the exact tone (its own where it can be heard, else 440)",
     OPTION_NUMBER, AT(pitch), .range = {20, 10000}},
    {"--fps", "N", " movie ", "pictures in a second, at most (30 for .cast, else 10)", OPTION_NUMBER, AT(fps),
     .range = {0.1, 100}},
    {"--speed", "X", " movie ", "so many times as fast as the laboratory (1)", OPTION_NUMBER, AT(speed),
     .range = {1e-3, 1e6}},
    {"--from", "T", " movie ", "filmed from time T of the run on (0)", OPTION_NUMBER, AT(from),
     .range = {0, 1e300}},
    {"--to", "T", " movie ", "filmed up to time T of the run (its end)", OPTION_NUMBER, AT(to),
     .range = {0, 1e300}},
    {"--idle", "S", " movie ", "nothing stands still for longer than S seconds", OPTION_NUMBER, AT(idle),
     .range = {0, 1e6}},
    {"--every", "N", " run ", "a row of the series every N steps (1)", OPTION_OVERRIDE,
     .key = "output.every"},
    {"--columns", "NAME,...", " run ",
     "writes these columns of the series and fields of the tables; all: every one", OPTION_OVERRIDE,
     .key = "output.columns"},
    {"--series", "FILE", " run ", "writes the series: one row for each recorded step", OPTION_TEXT,
     AT(outputs.series), LETTER('o')},
    {"--particles", "FILE", " run ", "writes the table of particles", OPTION_TEXT, AT(outputs.particles)},
    {"--nodes", "FILE", " run ", "writes the table of the grid's nodes (bar)", OPTION_TEXT,
     AT(outputs.nodes)},
    {"--bonds", "FILE", " run ", "writes the table of bonds (beams)", OPTION_TEXT, AT(outputs.bonds)},
    {"--stages", "FROM:TO", " run ",
     "tables after each stage of these steps (the first is 1), with all fields, in place of those at times",
     OPTION_TEXT, AT(stages)},
    {"--vtk", "FILE", " run ", "writes points for ParaView", OPTION_TEXT, AT(outputs.vtk)},
    {"--vtk-data", "D", " run ", "numbers of --vtk as text, or raw: a third of the size, and read faster",
     AT(vtk_data), ONE_OF(vtk_data)},
    {"--frames", "N", " run ", "tables at N times from 0 to the end, not at the last step alone",
     OPTION_OVERRIDE, AT(overrides), .key = "output.frames", .clears = "output.at"},
    {"--at", "T,T,...", " run ", "tables at these times", OPTION_OVERRIDE, AT(overrides), .key = "output.at",
     .clears = "output.frames"},
    {"--frames", "N", " figure ", "pictures at N times from 0 to the end", OPTION_OVERRIDE, AT(overrides),
     .key = "output.frames", .clears = "output.at"},
    {"--at", "T,T,...", " figure ", "pictures at these times on one page, not at the end alone",
     OPTION_OVERRIDE, AT(overrides), .key = "output.at", .clears = "output.frames"},
    {"--dialect", "D", " run sweep grade ", "comma, or semicolon with a decimal comma, for spreadsheets",
     AT(dialect), ONE_OF(dialects)},
    {"--force", NULL, " run figure movie sound fit diagnose sweep grade open lesson ",
     "replaces files that matvib wrote (pictures: any of the kind), never an input", OPTION_FLAG, AT(force)},
    {"--quiet", NULL, " run figure movie sound fit diagnose sweep grade ", "neither progress nor summary",
     OPTION_FLAG, AT(quiet), LETTER('q')},
    {"--threads", "N", " open lesson run figure movie sound fit diagnose sweep grade ",
     "threads to compute with; the numbers do not depend on it", OPTION_COUNT, AT(threads),
     .most = THREADS_MAX},
    {"--full", NULL, " verify ", "everything, however long it takes", OPTION_FLAG, AT(full)},
    {"--list", NULL, " verify figure lesson ", "prints the names", OPTION_FLAG, AT(list)},
    {"--paused", NULL, " open movie ", "opens paused at t = 0", OPTION_FLAG, AT(paused)},
    {"--plain", NULL, " open lesson ", "words in lines, no screen: for screen readers, logs and pipes",
     OPTION_FLAG, AT(plain)},
    {"--glyphs", "G", " open lesson movie ", "characters of the plots: auto, braille, block, ascii",
     AT(glyphs), ONE_OF(glyph_sets)},
    {"--theme", "T", " open lesson movie ", "background: auto, light, dark", AT(theme), ONE_OF(themes)},
    {"--sheet", "S", " open lesson movie ", "how much there is on the screen: plain or full (as it was left)",
     AT(screen_sheet), .kind = OPTION_WORD, .words = parameter_sheet_words},
    {"--no-mouse", NULL, " open lesson ", "leaves the mouse to the terminal", OPTION_FLAG, AT(no_mouse)},
    {"--history", "SIZE", " open lesson ", "memory for stepping back (256M)", OPTION_BYTES, AT(history)},
    {"--record", "FILE", " open lesson ",
     "keeps the session in FILE: the scenario, and every key with its step", OPTION_TEXT, AT(record)},
    {"--replay", "FILE", " open ", "does a session again to the same bits; any key takes over", OPTION_INPUT,
     AT(replay)},
    {"--last", NULL, " open ", "opens the last session again where it was left", OPTION_FLAG, AT(last)},
    {"--fast", NULL, " open ", "with --replay: as fast as it can, not at the pace of then", OPTION_FLAG,
     AT(fast)},
    {"--script", "FILE", " open lesson movie ",
     "keys from FILE (- is standard input), screens to standard output", OPTION_INPUT, AT(script)},
    {"--bare", NULL, " figure ", "curves and axes alone fill the page: no title, legend, results, parameters",
     OPTION_FLAG, AT(bare)},
    {"--size", "WxH", " figure ", "width and height of the page in mm (160 wide, as high as it takes)",
     OPTION_SIZE, AT(size), .most = 9999},
    {"--size", "WxH", " open lesson movie ", "size of the screens of a script (80x24)", OPTION_SIZE, AT(size),
     .most = SCRIPT_CELLS_MAX},
};

const int n_options = (int)(sizeof options_table / sizeof *options_table);

/* --- one argument --------------------------------------------------------------------------------- */

static bool is_among(const char *command, const char *list)
{
    char word[32];
    snprintf(word, sizeof word, " %s ", command);
    return strstr(list, word) != NULL;
}

static bool takes(const Option *option, const char *command)
{
    return is_among(command, option->commands);
}

static bool read_bytes(const char *text, size_t *bytes)
{
    char number[32];
    size_t n = strspn(text, "0123456789");
    static const char units[] = "kMGT";
    const char *unit = text[n] ? strchr(units, text[n]) : units - 1;
    long count;
    if (n == 0 || n >= sizeof number || !unit || (text[n] && text[n + 1]))
        return false;
    memcpy(number, text, n);
    number[n] = '\0';
    int shift = text[n] ? 10 * (int)(unit - units + 1) : 0;
    if (!text_to_long(number, &count) || count <= 0 || (uint64_t)count > (UINT64_MAX >> shift) ||
        ((uint64_t)count << shift) > SIZE_MAX)
        return false;
    *bytes = (size_t)((uint64_t)count << shift);
    return true;
}

static bool add_override(Options *options, const char *origin, const char *key, const char *value,
                         Status *status)
{
    if (options->n_overrides == OVERRIDES_MAX)
        return status_refuse(status, "%s: too many values (at most %d)", origin, OVERRIDES_MAX);
    options->overrides[options->n_overrides++] = (Override){origin, key, value};
    return true;
}

static bool take_override(const Option *option, const char *value, Options *options, Status *status)
{
    const char *key = option->key;
    if (!key) {
        const char *equals = strchr(value, '=');
        if (!equals || equals == value || equals - value >= KEY_MAX)
            return status_refuse(status, "--set: \"%.80s\" sets nothing (KEY=VALUE)", value);
        if (options->n_overrides == OVERRIDES_MAX)
            return status_refuse(status, "--set: too many values (at most %d)", OVERRIDES_MAX);
        char *kept = options->keys[options->n_overrides];
        memcpy(kept, value, (size_t)(equals - value));
        kept[equals - value] = '\0';
        key = kept;
        value = equals + 1;
    }
    /* either replaces the scenario's other one; both on the command line are an error */
    for (int i = 0; option->clears && i < options->n_overrides; i++) {
        const Override *other = &options->overrides[i];
        if (strcmp(other->key, option->clears) == 0 && *other->value)
            return status_refuse(status, "%s: %s is given too (one of them)", option->name,
                                 strcmp(other->origin, "--set") == 0 ? other->key : other->origin);
    }
    if (option->clears && !add_override(options, option->name, option->clears, "", status))
        return false;
    return add_override(options, option->name, key, value, status);
}

static bool take(const Option *option, const char *value, Options *options, Status *status)
{
    void *member = (char *)options + option->offset;
    char allowed[128] = "";
    switch (option->kind) {
    case OPTION_FLAG:
        *(bool *)member = true;
        return true;
    case OPTION_TEXT:
    case OPTION_INPUT:
        if (!*value)
            return status_refuse(status, "%s: is empty (%s)", option->name, option->argument);
        *(const char **)member = value;
        return option->kind != OPTION_INPUT || input_note(value, status);
    case OPTION_COUNT:
        if (!text_to_long(value, (long *)member) || *(long *)member < 1)
            return status_refuse(status, "%s: %.60s is not allowed (a whole number, 1 or more)", option->name,
                                 value);
        return (option->most == 0 || *(long *)member <= option->most) ||
               status_refuse(status, "%s: %ld are too many (1 to %d)", option->name, *(long *)member,
                             option->most);
    case OPTION_NUMBER:
        return (text_to_double(value, member) && *(double *)member >= option->range[0] &&
                *(double *)member <= option->range[1]) ||
               status_refuse(status, "%s: not a number from %g to %g: %.60s", option->name, option->range[0],
                             option->range[1], value);
    case OPTION_BYTES:
        return read_bytes(value, member) ||
               status_refuse(status, "%s: %.60s is not a size (such as 64M or 2G)", option->name, value);
    case OPTION_SIZE:
        return text_to_size(value, 1, option->most, member) ||
               status_refuse(status, "%s: %.60s is not a size (such as 80x24; at most %d each)", option->name,
                             value, option->most);
    case OPTION_WORD:
        for (int i = 0; option->words[i]; i++) {
            if (strcmp(option->words[i], value) == 0) {
                *(const char **)member = value;
                return true;
            }
            text_or(allowed, sizeof allowed, option->words[i]);
        }
        return status_refuse(status, "%s: %.60s is not a choice (%s)", option->name, value, allowed);
    case OPTION_OVERRIDE:
        return take_override(option, value, options, status);
    case OPTION_LIST: {
        OptionList *list = member;
        if (list->count == OPTION_LIST_MAX)
            return status_refuse(status, "%s: too many (at most %d)", option->name, OPTION_LIST_MAX);
        list->texts[list->count++] = value;
        return true;
    }
    case OPTION_AXIS:
        if (options->n_axes == AXES_MAX)
            return status_refuse(status, "%s: too many keys to vary (at most %d)", option->name, AXES_MAX);
        options->axes[options->n_axes++] = (SweepAxis){option->name, value};
        return true;
    }
    return false;
}

/* --- the whole line ------------------------------------------------------------------------------- */

/* Options that went or stand elsewhere now. */
static const struct {
    const char *commands, *name, *now;
} moved[] = {
    {" lesson ", "--key", "matvib grade --key LESSON"},
    {" grade ", "--students", "--moodle FILE now, which writes; --roster FILE reads the list of the class"},
    {" sweep ", "--jobs", "--threads N now, which shares the runs out too"},
    {" sweep ", "--plan", "gone (a shell loop over matvib run SCENARIO --set KEY=VALUE does it)"},
    {" command ", "export-lammps", "gone (what agreed with LAMMPS, and how, is in matvib-checks(7))"},
    {" run sweep fit ", "--crate",
     "gone (FILE.csv.ini beside a table says what it holds and makes it again)"},
};

bool options_stand(const char *command, const char *name, Status *status)
{
    for (size_t i = 0; i < sizeof moved / sizeof *moved; i++)
        if (is_among(command, moved[i].commands) && strcmp(moved[i].name, name) == 0)
            return status_refuse(status, "%s: is %s", name, moved[i].now);
    return true;
}

static bool unknown(const char *command, const char *name, Status *status)
{
    if (!options_stand(command, name, status))
        return false;
    Nearest nearest = nearest_begin(name);
    for (int i = 0; i < n_options; i++)
        if (takes(&options_table[i], command))
            nearest_offer(&nearest, options_table[i].name);
    bool open = strcmp(command, "open") == 0;
    if (nearest.word)
        return status_refuse(status, "%.60s: unknown option (did you mean %s?)", name, nearest.word);
    return status_refuse(status, "%.60s: unknown option (see: matvib %s%s--help)", name, open ? "" : command,
                         open ? "" : " ");
}

/* An option with its value, which may be in the same argument: behind '=', or right behind a letter. Moves
 * *at on. */
static bool take_option(const char *command, int count, char **arguments, int *at, Options *options,
                        Status *status)
{
    char name[64];
    const char *argument = arguments[*at], *equals = strchr(argument, '=');
    const bool is_letter = argument[1] != '-';
    const size_t length = is_letter ? 2 : equals ? (size_t)(equals - argument) : strlen(argument);
    snprintf(name, sizeof name, "%.*s", (int)length, argument);
    const Option *option = NULL;
    for (const Option *row = options_table; row < options_table + n_options && !option; row++)
        if ((is_letter ? row->letter == argument[1] : strcmp(row->name, name) == 0) && takes(row, command))
            option = row;
    if (!option)
        return unknown(command, is_letter ? argument : name, status);
    const char *value = !argument[strlen(name)] ? NULL : argument + length + !is_letter;
    if (!option->argument && value)
        return status_refuse(status, "%s: takes no value", name);
    if (option->argument && !value) {
        if (*at + 1 == count)
            return status_refuse(status, "%s: has no value (%s)", name, option->argument);
        value = arguments[++*at];
    }
    return take(option, value, options, status);
}

bool options_asks_help(const char *argument)
{
    return strcmp(argument, "--help") == 0 || strcmp(argument, "-h") == 0;
}

bool options_parse(const char *command, int count, char **arguments, Options *options, Status *status)
{
    *options = (Options){.arguments = arguments,
                         .n_arguments = count,
                         .seconds = 6,
                         .speed = 1,
                         .idle = INFINITY,
                         .to = INFINITY};
    bool only_words = false;
    for (int at = 0; at < count; at++) {
        const char *argument = arguments[at];
        if (!only_words && strcmp(argument, "--") == 0) {
            only_words = true;
        } else if (!only_words && argument[0] == '-' && argument[1]) {
            if (!take_option(command, count, arguments, &at, options, status))
                return false;
        } else if (options->n_words < WORDS_MAX) {
            options->words[options->n_words++] = argument;
            /* Each word may be a file that is read; a name of the program is none. */
            if (!(scenario_builtin(argument) || lesson_builtin(argument) || input_note(argument, status)))
                return false;
        } else {
            return status_refuse(status, "%.60s: too many arguments (at most %d)", argument, WORDS_MAX);
        }
    }
    options->outputs.force = options->force;
    options->outputs.asker = ASKER_COMMAND_LINE;
    options->outputs.vtk_data =
        options->vtk_data && strcmp(options->vtk_data, "raw") == 0 ? VTK_RAW : VTK_TEXT;
    options->outputs.dialect =
        options->dialect && strcmp(options->dialect, "semicolon") == 0 ? DIALECT_SEMICOLON : DIALECT_COMMA;
    return true;
}

bool options_words(const Options *options, int least, int most, const char *expected, Status *status)
{
    if (options->n_words < least)
        return status_refuse(status, "%s is missing (see: matvib --help)", expected);
    if (options->n_words > most)
        return status_refuse(status, "%.60s: is one argument too many (%s)", options->words[most],
                             most > 0 ? expected : "none");
    return true;
}

int options_count(const char *command)
{
    int count = 0;
    for (int i = 0; i < n_options; i++)
        count += takes(&options_table[i], command);
    return count;
}

void options_print(const char *command)
{
    for (int i = 0; i < n_options; i++) {
        const Option *option = &options_table[i];
        char name[40], letter[8] = "";
        if (option->letter)
            snprintf(letter, sizeof letter, "-%c, ", option->letter);
        snprintf(name, sizeof name, "%s%s%s%s", letter, option->name, option->argument ? " " : "",
                 option->argument ? option->argument : "");
        if (takes(option, command))
            printf("  %-18s %s\n", name, option->help);
    }
}

/* --- the settings --------------------------------------------------------------------------------- */

static bool load_run(const Options *options, const char *scenario, Settings *settings, Status *status)
{
    Override overrides[OVERRIDES_MAX + 2];
    int count = options->n_overrides;
    memcpy(overrides, options->overrides, (size_t)count * sizeof *overrides);
    if (options->steps == 0)
        return scenario_load_with(scenario, overrides, count, settings, status);
    for (int i = 0; i < count; i++)
        if (strcmp(overrides[i].key, "time.end") == 0)
            return status_refuse(status, "--steps: %s says when the run ends (one of them)",
                                 strcmp(overrides[i].origin, "--set") == 0 ? "--set time.end" : "--end");
    /* the step does not depend on the end, so an end that nothing can object to comes first */
    char end[NUMBER_TEXT_MAX] = "1e-50";
    double dt;
    overrides[count] = (Override){"--steps", "time.end", end};
    overrides[count + 1] = (Override){"--steps", "output.at", ""};
    if (!scenario_load_with(scenario, overrides, count + 2, settings, status)) {
        /* what is wrong without it is not said of --steps */
        Status without = {STATUS_DONE, ""};
        if (!scenario_load_with(scenario, overrides, count, settings, &without) && status)
            *status = without;
        return false;
    }
    if (!problem_time_step(settings, &dt, status)) {
        options_blame(options, scenario, status);
        return false;
    }
    text_shortest(end, (double)options->steps * dt);
    return scenario_load_with(scenario, overrides, count + 1, settings, status);
}

bool options_load(const Options *options, const char *scenario, Settings *settings, Status *status)
{
    if (strcmp(scenario, input_standard_name) == 0 && !input_take_standard(SCENARIO_BYTES_MAX, status))
        return false;
    if (!load_run(options, scenario, settings, status))
        return false;
    /* which views there are no scenario file knows; those of a built-in one are there */
    Settings own;
    const bool known = scenario_builtin(scenario) && scenario_load(scenario, &own, status);
    if (view_check(settings, known ? &own : NULL, status))
        return true;
    options_blame(options, scenario, status);
    return false;
}

void options_blame(const Options *options, const char *scenario, Status *status)
{
    if (status->code == STATUS_USAGE)
        scenario_blame(scenario, options->overrides, options->n_overrides, status);
}
