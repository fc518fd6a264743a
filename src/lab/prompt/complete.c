/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tab in a question: what was typed is completed as far as is certain, else what there is is shown. */
#include "lab/laboratory.h"
#include "base/text.h"
#include "base/visible.h"
#include "scenario/scenario.h"
#include "picture/words/tell.h"
#include "views/view.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

struct Completion {
    const char *start; /* what is there */
    char common[sizeof((Prompt *)0)->text];
    char list[sizeof((Prompt *)0)->hint];
    char tail[2]; /* follows if there is one candidate only */
    int found;
    int skipped; /* candidates that have been shown before */
    int listed;
    bool more; /* the list has no room for the others */
};

/* "  (Tab: 12 more)" stands behind a list that is not the last part. */
enum { TAIL_ROOM = 24 };

static void offer(Completion *completion, const char *candidate, const char *tail)
{
    if (strncmp(candidate, completion->start, strlen(completion->start)) != 0)
        return;
    const size_t used = strlen(completion->list);
    completion->more |= used + strlen(candidate) + TAIL_ROOM >= sizeof completion->list;
    if (completion->found >= completion->skipped && !completion->more) {
        text_append(completion->list, sizeof completion->list, "%s%s", used ? "  " : "", candidate);
        completion->listed++;
    }
    if (completion->found++ == 0) {
        snprintf(completion->common, sizeof completion->common, "%s", candidate);
        snprintf(completion->tail, sizeof completion->tail, "%s", tail);
        return;
    }
    size_t same = 0;
    while (completion->common[same] && completion->common[same] == candidate[same])
        same++;
    completion->common[same] = '\0';
}

static bool begins(const char *text, const char *start)
{
    return strncasecmp(text, start, strlen(start)) == 0;
}

/* Keys that are written out in full where something else of them was typed: the beginning of the key's name
 * without its section, of a later word of it, or of its label; several are only shown. */
static void offer_meant(Completion *completion, const Laboratory *lab, const char *tail)
{
    const char *typed = completion->start;
    for (int i = 0; *typed && i < n_parameters; i++) {
        if (!parameter_applies_to(laboratory_settings(lab), &parameters[i]))
            continue;
        bool meant = begins(parameters[i].label, typed);
        for (const char *at = parameters[i].key; (at = strpbrk(at, "._")) && !meant;)
            meant = begins(++at, typed);
        completion->start = "";
        if (meant)
            offer(completion, parameters[i].key, tail);
    }
    completion->start = typed;
    if (completion->found > 1)
        completion->common[0] = '\0';
}

static void offer_keys(Completion *completion, const Laboratory *lab, const char *tail)
{
    for (int i = 0; i < n_parameters; i++)
        if (parameter_applies_to(laboratory_settings(lab), &parameters[i]))
            offer(completion, parameters[i].key, tail);
    if (completion->found == 0)
        offer_meant(completion, lab, tail);
}

/* The words that a parameter may be; of a number, in the hint, what is allowed. */
static void offer_values(Completion *completion, const Settings *settings, const char *key, size_t length)
{
    char name[KEY_MAX], whole[KEY_MAX];
    const Problem *problem = settings->problem;
    snprintf(name, sizeof name, "%.*s", (int)length, key);
    const Parameter *parameter =
        settings_resolve_key(settings, name, whole, NULL) ? parameter_find(whole) : NULL;
    if (!parameter)
        return;
    const Parameter row = parameter_in(parameter, problem);
    for (int i = 0; i < row.n_choices; i++)
        offer(completion, row.choices[i], "");
    if (row.automatic && *completion->start)
        offer(completion, row.automatic, "");
    if (completion->found == 0) {
        char range[96];
        parameter_range(parameter, problem, range, sizeof range);
        snprintf(completion->list, sizeof completion->list, "%s: %s", range, row.help);
    }
}

int complete_by_name(const struct dirent **a, const struct dirent **b)
{
    return strcmp((*a)->d_name, (*b)->d_name);
}

/* By name; with `tables` those of CSV first. */
static void offer_files(Completion *completion, bool tables)
{
    const char *slash = strrchr(completion->start, '/');
    const size_t folder = slash ? (size_t)(slash - completion->start) + 1 : 0;
    char path[512];
    snprintf(path, sizeof path, "%.*s", (int)folder, completion->start);
    struct dirent **entries;
    const int count = scandir(folder ? path : ".", &entries, NULL, complete_by_name);
    for (int i = 0; i < 2 * count; i++) {
        const char *name = entries[i % count]->d_name;
        const size_t length = strlen(name);
        const bool is_table = length > 4 && strcmp(name + length - 4, ".csv") == 0;
        struct stat file;
        if ((name[0] == '.' && completion->start[folder] != '.') || (i < count) != (tables && is_table) ||
            !visible_is_clean(name))
            continue;
        snprintf(path, sizeof path, "%.*s%s", (int)folder, completion->start, name);
        if (strlen(path) + 2 < sizeof path && stat(path, &file) == 0 && S_ISDIR(file.st_mode))
            strcat(path, "/");
        offer(completion, path, "");
    }
    for (int i = 0; i < count; i++)
        free(entries[i]);
    if (count >= 0)
        free(entries);
}

void complete_files(Completion *completion, const Laboratory *lab)
{
    (void)lab;
    offer_files(completion, false);
}

void complete_scenarios(Completion *completion, const Laboratory *lab)
{
    (void)lab;
    for (const BuiltinScenario *builtin = builtin_scenarios; builtin->name; builtin++)
        offer(completion, builtin->name, "");
    if (*completion->start)
        offer_files(completion, false);
}

/* Words; nothing typed as yet: each with its digit, and what it is. */
static void offer_views(Completion *completion, const Screen *screen)
{
    const bool typed = *completion->start != '\0';
    for (int i = 0; i < n_views; i++) {
        if (view_missing(views[i], screen))
            continue;
        if (typed)
            offer(completion, views[i]->word, "");
        else
            text_append(completion->list, sizeof completion->list, "%s%.0d%s%s",
                        completion->list[0] ? "   " : "", views[i]->digit, views[i]->digit ? " " : "",
                        views[i]->word);
    }
}

/* KEY=VALUE ...: the last of them. */
void complete_assignments(Completion *completion, const Laboratory *lab)
{
    const char *space = strrchr(completion->start, ' ');
    const char *word = space ? space + 1 : completion->start;
    const size_t key = strcspn(word, "=");
    completion->start = word;
    if (!word[key]) {
        offer_keys(completion, lab, "=");
        return;
    }
    completion->start = word + key + 1;
    offer_values(completion, laboratory_settings(lab), word, key);
}

/* The fields of particles or nodes, behind a number; first the kinds of things. */
static void offer_fields(Completion *completion, const Simulation *sim)
{
    const char *words = completion->start, *number = strchr(words, ' ');
    const char *field = number ? strchr(number + 1, ' ') : NULL;
    for (int set = 0; set < sim->n_sets; set++) {
        const char *name = sim->sets[set].name;
        if (!number)
            offer(completion, name, " ");
        for (int i = 0; field && i < sim->n_fields; i++) {
            completion->start = field + 1;
            if (sim->fields[i].set == set && strncmp(words, name, (size_t)(number - words)) == 0)
                offer(completion, sim->fields[i].quantity.name, "");
        }
    }
}

static void offer_words(Completion *completion, const char *const *words)
{
    for (; *words; words++)
        offer(completion, *words, "");
}

/* A key, or its value behind a space or "=". */
static void offer_setting(Completion *completion, const Laboratory *lab)
{
    const char *words = completion->start;
    const size_t key = strcspn(words, " =");
    if (!words[key]) {
        offer_keys(completion, lab, " ");
        return;
    }
    if (!strchr(words, '='))
        offer_meant(completion, lab, "="); /* the words of a label */
    if (completion->found > 0)
        return;
    completion->start = words + key + strspn(words + key, " =");
    offer_values(completion, laboratory_settings(lab), words, key);
}

/* The words after a verb; `start` is what stands behind it. */
static void offer_arguments(Completion *completion, const Laboratory *lab, LineArgument kind)
{
    const char *words = completion->start;
    switch (kind) {
    case ARGUMENT_KEY:
        offer_setting(completion, lab);
        break;
    case ARGUMENT_KEY_LIST:
        completion->start = strrchr(words, ',') ? strrchr(words, ',') + 1 : words;
        completion->start += strspn(completion->start, " ");
        offer_keys(completion, lab, "");
        break;
    case ARGUMENT_KEYS:
        complete_assignments(completion, lab);
        break;
    case ARGUMENT_SCENARIO:
        complete_scenarios(completion, lab);
        break;
    case ARGUMENT_FILE:
    case ARGUMENT_SERIES:
        offer_files(completion, kind == ARGUMENT_SERIES);
        break;
    case ARGUMENT_VIEW:
        offer_views(completion, &lab->screen);
        break;
    case ARGUMENT_TELL:
        if (*words)
            offer_views(completion, &lab->screen);
        for (int i = 0; tell_word(i); i++)
            offer(completion, tell_word(i), "");
        break;
    case ARGUMENT_FIGURE:
        if (!strchr(words, ' '))
            offer_views(completion, &lab->screen);
        completion->start = strchr(words, ' ') ? strchr(words, ' ') + 1 : words;
        if (completion->found == 0)
            offer_files(completion, false);
        break;
    case ARGUMENT_REFERENCES:
        offer_words(completion, parameter_reference_words);
        break;
    case ARGUMENT_SHEET:
        offer_words(completion, parameter_sheet_words);
        break;
    case ARGUMENT_LESSON:
        for (const BuiltinLesson *lesson = builtin_lessons; lesson->name; lesson++)
            offer(completion, lesson->name, "");
        break;
    case ARGUMENT_STOP:
        completion->start += strncmp(words, "first ", 6) == 0 ? 6 : 0;
        offer_words(completion, stop_event_words);
        for (int i = 0; completion->start == words && i < 3; i++)
            offer(completion, (const char *const[]){"t ", "end", "first "}[i], "");
        break;
    case ARGUMENT_FIELD:
        offer_fields(completion, laboratory_simulation(lab));
        break;
    case ARGUMENT_OTHER:
        break;
    }
}

void complete_line(Completion *completion, const Laboratory *lab)
{
    const char *line = completion->start;
    const size_t word = strcspn(line, " =");
    const LineVerb *verb = line[word] == ' ' ? line_verb_find(line, word) : NULL;
    if (verb) {
        completion->start = line + word + strspn(line + word, " ");
        offer_arguments(completion, lab, verb->argument);
    } else if (line[word]) {
        offer_arguments(completion, lab, ARGUMENT_KEY);
    } else {
        for (int i = 0; i < n_line_verbs; i++)
            offer(completion, line_verbs[i].name, " ");
        for (int i = 0; i < n_commands; i++)
            if (!line_verb_find(commands[i].name, strlen(commands[i].name)))
                offer(completion, commands[i].name, "");
        offer_keys(completion, lab, "=");
    }
}

void complete_tab(Laboratory *lab)
{
    Prompt *prompt = &lab->prompting.shown;
    Completion completion = {.start = prompt->text, .skipped = lab->prompting.tabbed};
    if (!lab->prompting.typing || !lab->prompting.typing->offer)
        return;
    lab->prompting.typing->offer(&completion, lab);
    const size_t before = (size_t)(completion.start - prompt->text), had = strlen(completion.start);
    const bool further = completion.found == 1 || strlen(completion.common) > had;
    prompt->problem[0] = prompt->hint[0] = '\0';
    lab->prompting.fresh = false;
    if (!further && prompt->scenarios && prompt->scenarios->n_shown > 0)
        return; /* they are there, with their titles */
    lab->prompting.tabbed = 0;
    if (!further) {
        const int shown = completion.skipped + completion.listed;
        snprintf(prompt->hint, sizeof prompt->hint, "%s", completion.list[0] ? completion.list : "no match");
        if (completion.more) {
            text_append(prompt->hint, sizeof prompt->hint, "  (Tab: %d more)", completion.found - shown);
            lab->prompting.tabbed = shown;
        }
    } else if (before + strlen(completion.common) + 2 < sizeof prompt->text) {
        snprintf(prompt->text + before, sizeof prompt->text - before, "%s%s", completion.common,
                 completion.found == 1 ? completion.tail : "");
        prompt->cursor = glyphs_count(prompt->text);
        const BuiltinScenario *scenario = completion.found == 1 ? scenario_builtin(completion.common) : NULL;
        char title[TITLE_MAX];
        if (scenario && !prompt->scenarios && scenario_title(scenario, title))
            snprintf(prompt->hint, sizeof prompt->hint, "%s", title);
    }
}
