/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command line behind `:`: commands by name, KEY=VALUE, a time, and verbs that take arguments. */
#include "panes/panes.h"
#include "scenario/concern_output.h"
#include "scenario/scenario.h"
#include "scenario/rows/rows.h"
#include "lab/commands/commands.h"
#include "picture/words/tell.h"
#include "views/view.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* --- verbs ------------------------------------------------------------------------------------------ */

/* Whether so many bytes mean a key, or several. */
static bool means_key(const Laboratory *lab, const char *words, size_t length)
{
    char called[KEY_MAX], key[KEY_MAX];
    snprintf(called, sizeof called, "%.*s", (int)length, words);
    return length < sizeof called && (!settings_resolve_key(laboratory_settings(lab), called, key, NULL) ||
                                      parameter_find(key) || parameter_text_find(key));
}

/* The bytes of the key before a value: all before '=', which may be a label's words, or else as many words
 * as are a key, or else the first. */
static size_t key_length(const Laboratory *lab, const char *words)
{
    const size_t first = strcspn(words, " =");
    size_t length = strcspn(words, "="), most = first;
    while (length > 0 && words[length - 1] == ' ')
        length--;
    if (strchr(words, '=') && means_key(lab, words, length))
        return length;
    for (const char *space = strchr(words, ' '); space; space = strchr(space + 1, ' '))
        if (means_key(lab, words, (size_t)(space - words)))
            most = (size_t)(space - words);
    return most;
}

/* "KEY = VALUE" and, behind `set`, also "KEY VALUE"; the key by its end or by its label too. */
static bool set(Laboratory *lab, const char *words, Status *status)
{
    char called[KEY_MAX], key[KEY_MAX];
    const size_t length = key_length(lab, words);
    const char *value = words + length + strspn(words + length, " ");
    if (*value == '=')
        value += 1 + strspn(value + 1, " ");
    if (length == 0 || length >= sizeof called || !*value)
        return status_refuse(status, "a key and a value are expected, as in set initial.mode 5");
    snprintf(called, sizeof called, "%.*s", (int)length, words);
    Settings settings = *laboratory_settings(lab);
    return settings_resolve_key(&settings, called, key, status) &&
           settings_change(&settings, key, value, status) &&
           view_check(&settings, laboratory_settings(lab), status) &&
           edit_change(lab, &settings, experiment_edit, status);
}

/* The next word, or what stands between quotes; false: there is none. */
static bool take_word(const char **words, char *out, size_t size)
{
    *words += strspn(*words, " ");
    const bool quoted = **words == '"';
    *words += quoted;
    const size_t length = strcspn(*words, quoted ? "\"" : " ");
    snprintf(out, size, "%.*s", (int)length, *words);
    *words += length;
    *words += quoted && **words == '"';
    return length > 0;
}

static bool reading(double share, void *context)
{
    Laboratory *lab = context;
    laboratory_tell(lab, "reading %d %%   ^C cancels", (int)(100 * share));
    return laboratory_go_on(lab);
}

static void drop_overlay(Laboratory *lab)
{
    overlay_close(&lab->overlay);
    lab->screen.overlay = NULL;
    lab->diagnosis[0] = '\0';
}

static bool overlay(Laboratory *lab, const char *words, Status *status)
{
    char path[NAME_MAX_BYTES], x[OVERLAY_NAME_MAX], y[OVERLAY_NAME_MAX];
    Screen *screen = &lab->screen;
    Overlay read;
    if (!take_word(&words, path, sizeof path)) {
        laboratory_tell(lab, screen->overlay ? "%s is taken away" : "no series lies over the plots",
                        lab->overlay.file);
        drop_overlay(lab);
        return true;
    }
    const bool x_given = take_word(&words, x, sizeof x), y_given = take_word(&words, y, sizeof y);
    if (!overlay_load(&read, path, reading, lab, status))
        return false;
    if (!overlay_choose(&read, x_given ? x : NULL, y_given ? y : NULL, view_curve(screen, true),
                        view_curve(screen, false), status)) {
        overlay_close(&read);
        return false;
    }
    drop_overlay(lab);
    lab->overlay = read;
    screen->overlay = &lab->overlay;
    const double *place = read.columns[read.x].values;
    laboratory_tell(lab, "%s: %zu rows, %s from %s to %s; :overlay alone takes it away", read.file,
                    read.count, read.along ? "x" : "t", text_rounded(read.count ? place[0] : NAN, 5).text,
                    text_rounded(read.count ? place[read.count - 1] : NAN, 5).text);
    return true;
}

/* By its number, from 1 on, or by its word; 0: it is neither. */
static int variant_of(const View *view, const Screen *screen, const char *which)
{
    long number;
    if (text_to_long(which, &number))
        return number > 0 && number <= view_variants(view, screen) ? (int)number : 0;
    return view_variant_named(view, screen, which) + 1;
}

static bool show(Laboratory *lab, const char *words, Status *status)
{
    char word[32] = "", which[32] = "", known[160];
    int first = 0, second = 0;
    const bool sound = sscanf(words, "%31s%n", word, &first) == 1 &&
                       (!words[first] || sscanf(words + first, "%31s%n", which, &second) == 1) &&
                       !words[first + second];
    const View *view = view_named(word);
    const int variant = !view || !which[0] ? 1 : variant_of(view, &lab->screen, which);
    view_names(known, sizeof known);
    if (!sound || !view)
        return status_refuse(
            status, "a view is expected (%s), and its variant, as in show probe angle or show 1 2", known);
    if (view_missing(view, &lab->screen))
        return status_refuse(status, "%s", view_missing(view, &lab->screen));
    if (variant < 1)
        return status_refuse(status, "%s has no variant %s (1 to %d)", word, which,
                             view_variants(view, &lab->screen));
    command_show_view(lab, view);
    view_choose_variant(view, &lab->screen, variant - 1);
    return true;
}

/* In words, by who shows them as lines, or else as far as the key line has room. */
static bool tell(Laboratory *lab, const char *words, Status *status)
{
    Words told = {.text = NULL};
    char known[256];
    tell_names(known, sizeof known);
    if (!tell_named(&lab->screen, words, &told))
        return status_refuse(status, "tell what? (%s)", known);
    for (char *end = told.text; end && !lab->host.tell && (end = strchr(end, '\n'));)
        *end = ' ';
    if (told.text && lab->host.tell)
        lab->host.tell(lab->host.context, told.text);
    else
        laboratory_tell(lab, "%s", told.text ? told.text : "nothing to describe");
    words_close(&told);
    return true;
}

static bool references(Laboratory *lab, const char *words, Status *status)
{
    const int which = text_place_in(words, parameter_reference_words);
    if (which >= 0)
        lab->screen.views.references = (ReferencesShown)which;
    return which >= 0 || status_refuse(status, "which reference curves? (all | exact | predicted | none)");
}

static bool sheet(Laboratory *lab, const char *words, Status *status)
{
    const int which = text_place_in(words, parameter_sheet_words);
    if (which >= 0)
        command_show_sheet(lab, (Sheet)which);
    else if (!*words)
        command_sheet(lab);
    return which >= 0 || !*words || status_refuse(status, "which sheet? (plain | full)");
}

/* Which of one of the simulation's sets: particles, nodes. */
static bool choose(Laboratory *lab, const char *words, int set, Status *status)
{
    static const char *const what[] = {"particle", "node"};
    const Simulation *sim = laboratory_simulation(lab);
    const long count = set < sim->n_sets ? (long)sim->counts[set] : 0;
    long number;
    if (!text_to_long(words, &number) || number < 0 || number >= count)
        return status_refuse(status, count > 0 ? "which %s? (0 to %ld)" : "there is no %s in this run",
                             what[set], count - 1);
    *(set ? &lab->screen.chosen.node : &lab->screen.chosen.particle) = (size_t)number;
    lab->screen.chosen.is_node = set > 0;
    return true;
}

static bool help_on(Laboratory *lab, const char *words, Status *status)
{
    const Command *command = *words ? command_by_name(words) : command_find(COMMAND_HELP);
    const LineVerb *verb = line_verb_find(words, strlen(words));
    const Parameter *parameter = parameter_find(words);
    const View *view = view_named(words);
    char title[TITLE_MAX];
    if (!*words || strcmp(words, "all") == 0)
        lab->carry_out(lab, COMMAND_HELP);
    else if (verb)
        laboratory_tell(lab, "%s %s: %s", verb->name, verb->arguments, verb->help);
    else if (view)
        laboratory_tell(lab, "%s: %s", view->word, view->help);
    else if (command) {
        char key[COMMAND_KEY_MAX];
        command_first_key(command, key);
        laboratory_tell(lab, "%s (%s): %s", command->name, key, pane_command_help(command));
    } else if (parameter)
        laboratory_tell(lab, "%s: %s", parameter->key, parameter->help);
    else if (scenario_builtin(words) && scenario_title(scenario_builtin(words), title))
        laboratory_tell(lab, "%s: %s", words, title);
    else
        return status_refuse(
            status, "help on what? (a command, a word after :, a view, a parameter or a scenario; all)");
    return true;
}

/* Its column is shown in the probe view. */
static bool plot(Laboratory *lab, const char *words, Status *status)
{
    Screen *screen = &lab->screen;
    Settings settings = *laboratory_settings(lab);
    char thing[FOLLOW_TEXT_MAX], *follow = settings_edit_output(&settings)->follow;
    /* "particle 12 velocity" of "velocity", where that is a field of the chosen thing */
    const Simulation *sim = laboratory_simulation(lab);
    const bool node = screen->chosen.is_node && sim->n_sets > 1;
    size_t word = strcspn(words, " ");
    for (int set = 0; set < sim->n_sets; set++)
        if (strlen(sim->sets[set].name) == word && strncmp(words, sim->sets[set].name, word) == 0)
            word = 0;
    if (word == 0)
        snprintf(thing, sizeof thing, "%.63s", words);
    else
        snprintf(thing, sizeof thing, "%s %zu %.30s", sim->sets[node].name,
                 node ? screen->chosen.node : screen->chosen.particle, words);
    if (!*words)
        memset(follow, 0, sizeof settings_output(&settings)->follow);
    else if (!text_list_add(follow, sizeof settings_output(&settings)->follow, thing))
        return status_refuse(status, "too many things are followed: plot alone ends them");
    if (!edit_change(lab, &settings, experiment_edit, status))
        return false;
    const View *view = view_named("probe");
    if (!*words) {
        view_choose_variant(view, screen, 0);
        laboratory_tell(lab, "nothing is followed any more");
        return true;
    }
    command_show_view(lab, view);
    sim = laboratory_simulation(lab);
    view_choose_variant(view, screen, variant_of(view, screen, sim->series[sim->n_series - 1].name) - 1);
    return true;
}

#define LINE(id, function, ...)        [LINE_##id] = {function, NULL, 0},
#define LINE_BY(id, function, by, ...) [LINE_##id] = {NULL, function, by},
static const struct {
    Answer run;
    bool (*run_by)(Laboratory *, const char *words, int by, Status *); /* in place of it */
    int by;
} verbs[LINE_COUNT] = {
#include "help/line_rows.inc"
};
#undef LINE

/* --- the line --------------------------------------------------------------------------------------- */

static bool answer_line(Laboratory *lab, const char *text, Status *status)
{
    text += strspn(text, " :");
    char line[sizeof lab->prompting.shown.text];
    snprintf(line, sizeof line, "%s", text);
    for (size_t end = strlen(line); end > 0 && line[end - 1] == ' ';)
        line[--end] = '\0';
    if (!*line)
        return true;
    LineHistory *past = &lab->prompting.past;
    if (past->count == 0 || strcmp(past->lines[past->count - 1], line) != 0) {
        if (past->count == LINE_HISTORY_MAX)
            memmove(past->lines[0], past->lines[1], (size_t)--past->count * sizeof past->lines[0]);
        snprintf(past->lines[past->count++], sizeof past->lines[0], "%s", line);
    }
    return line_run(lab, line, status);
}

/* An unknown first word, with the nearest one that there is; or a command with more behind it. */
static bool refuse_word(const Laboratory *lab, const char *line, const char *words, Status *status)
{
    char word[64];
    snprintf(word, sizeof word, "%.*s", (int)strcspn(line, " "), line);
    const FixedKey *fixed = fixed_key_find(laboratory_settings(lab), word);
    if (fixed) {
        char text[sizeof lab->prompting.shown.problem];
        fixed_key_text(fixed, text, sizeof text);
        return status_refuse(status, "%s", text);
    }
    double time;
    if (command_by_name(word)) {
        const bool place = text_to_double(*words == '#' ? words + 1 : words, &time);
        return status_refuse(status,
                             place ? "%s takes no argument; :%.20s goes to %s%.20s" : "%s takes no argument",
                             word, words, *words == '#' ? "step " : "t = ", words + (*words == '#'));
    }
    Nearest near = nearest_begin(word);
    for (int i = 0; i < n_line_verbs; i++)
        nearest_offer(&near, line_verbs[i].name);
    for (int i = 0; i < n_commands; i++)
        nearest_offer(&near, commands[i].name);
    const char *nearest = near.word;
    return status_refuse(status,
                         "%s: unknown%s%s%s: a command (Tab completes), KEY=VALUE or a time is expected",
                         word, nearest ? " (did you mean " : "", nearest ? nearest : "", nearest ? "?)" : "");
}

bool line_run(Laboratory *lab, const char *text, Status *status)
{
    const LineMeaning line = line_meaning(text);
    switch (line.kind) {
    case LINE_VERB: {
        const LineVerbId id = line.verb->id;
        return verbs[id].run ? verbs[id].run(lab, line.words, status)
                             : verbs[id].run_by(lab, line.words, verbs[id].by, status);
    }
    case LINE_COMMAND:
        lab->carry_out(lab, line.command->id);
        return true;
    case LINE_ASSIGNMENT:
        return set(lab, text, status);
    case LINE_PLACE:
        return command_answer_go_to(lab, text, status);
    case LINE_UNKNOWN:
        break;
    }
    return refuse_word(lab, text, line.words, status);
}

/* --- the question ----------------------------------------------------------------------------------- */

static bool line_key_of(Laboratory *lab, const char *key)
{
    const bool up = strcmp(key, "Up") == 0;
    if (!up && strcmp(key, "Down") != 0)
        return false;
    LineHistory *past = &lab->prompting.past;
    Prompt *prompt = &lab->prompting.shown;
    const int to = past->at + (up ? -1 : 1);
    if (to < 0 || to > past->count)
        return true;
    if (past->at == past->count)
        memcpy(past->unfinished, prompt->text, sizeof past->unfinished);
    past->at = to;
    memcpy(prompt->text, to == past->count ? past->unfinished : past->lines[to], sizeof prompt->text);
    prompt->cursor = glyphs_count(prompt->text);
    prompt->problem[0] = prompt->hint[0] = '\0';
    lab->prompting.fresh = false;
    return true;
}

/* What Tab has just shown stays until the next character. */
static void forget_hint(Laboratory *lab, const char *key)
{
    if (strcmp(key, "Tab") != 0)
        lab->prompting.shown.hint[0] = '\0';
}

static const Typing typing = {.key = line_key_of, .offer = complete_line, .typed = forget_hint};

void line_ask(Laboratory *lab)
{
    lab->prompting.past.at = lab->prompting.past.count;
    prompt_ask(lab, answer_line, &typing, "", ":");
}
