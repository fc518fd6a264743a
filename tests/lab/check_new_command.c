/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A command that the program does not know: a row and the function that it names, as CONTRIBUTING says. The
 * two tables here take the place of src/help/command_list.c and src/lab/commands/command_table.c
 * when this program is linked; nothing else is replaced, so whatever knows the command has found it there. */
#include "suite.h"
#include "lab/tui_case.h"

#include "lab/commands/commands.h"

#include <string.h>

#define SAYS "somebody greets you"

static int greeted; /* how often */

static void greet(Laboratory *lab)
{
    greeted++;
    laboratory_say(lab, MESSAGE_INFO, SAYS);
}

#define GREET ((CommandId)COMMAND_COUNT) /* that of the row behind the last one */

#define COMMAND(id, function, ...) {COMMAND_##id, __VA_ARGS__},
#define DIGIT(n)                   {COMMAND_VIEW_##n, "view-" #n, #n, "Views", NULL, NULL, BY_LESSON},
const Command commands[] = {
#include "help/command_rows.inc"
    {GREET, "greet", "@", "Program", "greet", "says that somebody is there", BY_LESSON},
};
#undef COMMAND
#undef DIGIT
const int n_commands = sizeof commands / sizeof *commands;

#define COMMAND(id, function, ...)        {COMMAND_##id, function, NULL, 0},
#define COMMAND_BY(id, function, by, ...) {COMMAND_##id, NULL, function, by},
#define DIGIT(n)
const CommandFunction command_functions[] = {
#include "help/command_rows.inc"
    {GREET, greet, NULL, 0},
};
#undef COMMAND
#undef DIGIT
const int n_command_functions = sizeof command_functions / sizeof *command_functions;

/* --- what finds it ---------------------------------------------------------------------------------- */

static void type(Bench *bench, const char *line)
{
    press(bench, ":");
    for (const char *at = line; *at; at++)
        press(bench, *at == ' ' ? "Space" : (const char[]){*at, '\0'});
}

START_TEST(its_key_carries_it_out)
{
    Bench *bench = open_bench("mode1", true);
    ck_assert(laboratory_can(GREET));
    ck_assert(!command_set_has(bench->lab.screen.used, GREET));
    press(bench, "@");
    ck_assert(shows(bench, SAYS));
    ck_assert(command_set_has(bench->lab.screen.used, GREET));
    close_bench(bench);
}
END_TEST

START_TEST(the_line_takes_and_completes_its_name)
{
    Bench *bench = open_bench("mode1", true);
    type(bench, "gree");
    press_all(bench, "Tab");
    ck_assert_str_eq(bench->lab.screen.prompt->text, "greet");
    press(bench, "Enter");
    ck_assert(shows(bench, SAYS));
    type(bench, "gret");
    press(bench, "Enter");
    ck_assert(shows(bench, "did you mean greet?"));
    close_bench(bench);
}
END_TEST

START_TEST(the_help_tells_of_it)
{
    Bench *bench = open_bench("mode1", true);
    bench->height = 200;
    press(bench, "?");
    ck_assert(shows(bench, "says that somebody is there"));
    close_bench(bench);
}
END_TEST

START_TEST(a_lesson_may_ask_for_it_and_wait_for_it)
{
    static const char text[] = "@title Greeting\n@page One\n@do greet\nPress @.\n@until command greet\n";
    char folder[64];
    enter_folder(folder);
    FILE *file = fopen("my.lesson", "w");
    ck_assert_ptr_nonnull(file);
    fputs(text, file);
    fclose(file);
    Bench *bench = open_bench("mode1", true);
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(lesson_play_open(&bench->lab, "my.lesson", &status), "%s", status.text);
    lesson_play_continue(&bench->lab);
    ck_assert_int_eq(greeted, 1);              /* the page's own text stands in place of the message */
    ck_assert(!bench->lab.screen.lesson->met); /* that it was the lesson's does not count */
    press(bench, "@");
    ck_assert(bench->lab.screen.lesson->met);
    close_bench(bench);
    leave_folder(folder);
}
END_TEST

START_TEST(every_command_has_a_key)
{
    for (int i = 0; i < n_commands; i++)
        ck_assert_msg(commands[i].keys && *commands[i].keys,
                      "%s has no key: its row in src/help/command_rows.inc names one behind the name",
                      commands[i].name);
}
END_TEST

void add_cases(Suite *suite)
{
    suite_fork();
    TCase *added = tcase_create("new command");
    tcase_add_test(added, every_command_has_a_key);
    tcase_add_test(added, its_key_carries_it_out);
    tcase_add_test(added, the_line_takes_and_completes_its_name);
    tcase_add_test(added, the_help_tells_of_it);
    tcase_add_test(added, a_lesson_may_ask_for_it_and_wait_for_it);
    suite_add_tcase(suite, added);
}
