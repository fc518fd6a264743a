/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Opening a scenario: from a list with titles, that shrinks to what is typed, or by a path. */
#include "lab/prompt/scenario_prompt.h"
#include "lab/laboratory.h"
#include "scenario/settings.h"
#include "lab/opening.h"
#include "scenario/scenario.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool offer(ScenarioList *list, const char *name, const char *title)
{
    if (list->count == SCENARIOS_MAX || strlen(name) >= SCENARIO_NAME_MAX)
        return false;
    snprintf(list->entries[list->count].name, SCENARIO_NAME_MAX, "%s", name);
    snprintf(list->entries[list->count].title, TITLE_MAX, "%s", title);
    list->count++;
    return true;
}

/* A file of the folder that can be opened; not the ones beside tables, which are many. */
static void offer_file(ScenarioList *list, const char *name, Settings *settings)
{
    struct stat file;
    Status status = {STATUS_DONE, ""};
    const size_t length = strlen(name);
    if (length < 5 || strcmp(name + length - 4, ".ini") != 0 ||
        (length > 8 && strcmp(name + length - 8, ".csv.ini") == 0))
        return;
    if (stat(name, &file) == 0 && S_ISREG(file.st_mode) && scenario_load(name, settings, &status))
        offer(list, name, settings->title);
}

static int by_name(const struct dirent **a, const struct dirent **b)
{
    return strcmp((*a)->d_name, (*b)->d_name);
}

/* What is shown: whatever holds the text in its name or its title. */
static void narrow(ScenarioList *list, const char *text, const char *open)
{
    list->n_shown = 0;
    list->chosen = list->open = -1;
    for (int i = 0; i < list->count; i++)
        if (strcasestr(list->entries[i].name, text) || strcasestr(list->entries[i].title, text)) {
            if (strcmp(list->entries[i].name, open) == 0)
                list->open = list->n_shown;
            list->shown[list->n_shown++] = i;
        }
}

static void choose(Prompting *prompting, int chosen)
{
    ScenarioList *list = &prompting->scenarios;
    if (list->n_shown == 0)
        return;
    list->chosen = chosen < 0 ? 0 : chosen < list->n_shown ? chosen : list->n_shown - 1;
    prompt_fill(prompting, list->entries[list->shown[list->chosen]].name); /* typing begins a new search */
    prompting->shown.hint[0] = '\0';
}

/* The row that a first key moves from: the open one, so that the way to the next is short, but what was
 * searched for begins at its top, or its end. */
static int where_to_begin(const Prompting *prompting, int rows)
{
    const ScenarioList *list = &prompting->scenarios;
    const bool searched = prompting->shown.text[0] != '\0';
    if (list->chosen >= 0)
        return list->chosen;
    if (!searched && list->open >= 0 && list->open + rows >= 0 && list->open + rows < list->n_shown)
        return list->open;
    return rows > 0 ? -1 : list->n_shown;
}

static bool choose_by_key(Laboratory *lab, const char *key)
{
    static const struct {
        const char *key;
        int rows;
    } moves[] = {{"Up", -1}, {"Down", 1}, {"PageUp", -8}, {"PageDown", 8}};
    const ScenarioList *list = lab->prompting.shown.scenarios;
    for (size_t i = 0; list && i < sizeof moves / sizeof *moves; i++)
        if (strcmp(key, moves[i].key) == 0) {
            choose(&lab->prompting, where_to_begin(&lab->prompting, moves[i].rows) + moves[i].rows);
            return true;
        }
    return false;
}

static void narrow_to_text(Laboratory *lab, const char *key)
{
    (void)key;
    narrow(&lab->prompting.scenarios, lab->prompting.shown.text, lab->scenario);
}

/* What was typed is a name or a path; where it is neither, the first scenario left in the list is meant. */
static bool answer_scenario(Laboratory *lab, const char *text)
{
    const ScenarioList *list = &lab->prompting.scenarios;
    if (text[0] && list->n_shown > 0 && !scenario_builtin(text) && access(text, F_OK) != 0)
        text = list->entries[list->shown[0]].name;
    return opening_answer(lab, text);
}

static const Typing typing = {.key = choose_by_key, .offer = complete_scenarios, .typed = narrow_to_text};

void scenario_prompt_ask(Laboratory *lab)
{
    ScenarioList *list = &lab->prompting.scenarios;
    list->count = 0;
    for (const BuiltinScenario *builtin = builtin_scenarios; builtin->name; builtin++) {
        char title[TITLE_MAX];
        offer(list, builtin->name, scenario_title(builtin, title) ? title : "");
    }
    struct dirent **names;
    Settings *settings = malloc(sizeof *settings);
    const int count = settings ? scandir(".", &names, NULL, by_name) : -1;
    for (int i = 0; i < count; i++) {
        offer_file(list, names[i]->d_name, settings);
        free(names[i]);
    }
    if (count >= 0)
        free(names);
    free(settings);
    narrow(list, "", lab->scenario);
    prompt_ask(&lab->prompting, answer_scenario, false, "", "open scenario or file");
    lab->prompting.shown.scenarios = list;
    lab->prompting.typing = &typing;
}
