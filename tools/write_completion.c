/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Completion of the command line: write_completion bash | zsh | fish > FILE. What can be completed comes from
 * the program's own tables, so that no shell knows an option that the program does not.
 *
 * All files begin with the same functions, which answer from the tables; the rest is each shell's own way of
 * asking them. */
#include "cli/cli.h"
#include "cli/options.h"
#include "cli/verify/verify.h"
#include "lessons/lesson.h"
#include "scenario/parameters.h"

#include <stdio.h>
#include <string.h>

/* --- the tables as functions that a shell reads ---------------------------------------------------- */

static bool fish; /* a syntax of its own; bash and zsh share one */

/* A function of its arguments, or one without. */
static void begin_choice(const char *name, const char *arguments, const char *sh)
{
    printf(fish ? "function %s # %s\n    switch \"$argv\"\n" : "%s() { # %s\n", name, arguments);
    if (!fish)
        printf("    case %s in\n", sh);
}

static void begin_case(const char *of, const char *and)
{
    printf(fish ? "    case '%s%s%s'\n        echo '" : "    '%s%s%s') echo '", of, *and? " " : "", and);
}

static void end_case(void)
{
    puts(fish ? "'" : "' ;;");
}

static void end_choice(void)
{
    puts(fish ? "    end\nend\n" : "    esac\n}\n");
}

static void begin_words(const char *name)
{
    printf(fish ? "function %s\n    echo '" : "%s() { echo '", name);
}

static void end_words(void)
{
    puts(fish ? "'\nend\n" : "'; }\n");
}

static const char *command_name(int i) /* the laboratory is "open"; NULL: there are no more */
{
    return i == 0 ? "open" : cli_commands[i - 1].name;
}

static bool takes(const Option *option, const char *command)
{
    char word[32];
    snprintf(word, sizeof word, " %s ", command);
    return strstr(option->commands, word) != NULL;
}

static void write_options(void)
{
    begin_choice("_matvib_options", "COMMAND", "$1");
    for (int c = 0; command_name(c); c++) {
        begin_case(command_name(c), "");
        for (int i = 0; i < n_options; i++)
            if (takes(&options_table[i], command_name(c)))
                printf("%s ", options_table[i].name);
        fputs("--help", stdout);
        end_case();
    }
    end_choice();
}

/* What stands behind an option: a list of words, or one of @file, @folder, @key, @none. */
static void write_argument(const Option *option)
{
    if (option->words)
        for (int i = 0; option->words[i]; i++)
            printf("%s%s", i ? " " : "", option->words[i]);
    else if (strncmp(option->argument, "KEY=", 4) == 0)
        fputs("@key", stdout);
    else if (strcmp(option->argument, "FILE") == 0)
        fputs("@file", stdout);
    else if (strcmp(option->argument, "DIR") == 0)
        fputs("@folder", stdout);
    else
        fputs("@none", stdout);
}

static void write_arguments(void)
{
    begin_choice("_matvib_argument", "COMMAND OPTION: nothing where the option has no argument", "\"$1 $2\"");
    for (int c = 0; command_name(c); c++)
        for (int i = 0; i < n_options; i++)
            if (takes(&options_table[i], command_name(c)) && options_table[i].argument) {
                begin_case(command_name(c), options_table[i].name);
                write_argument(&options_table[i]);
                end_case();
            }
    end_choice();
}

enum { IN_LINE = 6 }; /* names in a line of a long list */

/* The words of a command that are not options. */
static void write_words(void)
{
    begin_words("_matvib_scenarios");
    for (int i = 0; builtin_scenarios[i].name; i++)
        printf("%s%s", !i ? "" : i % IN_LINE ? " " : "\n    ", builtin_scenarios[i].name);
    end_words();
    begin_choice("_matvib_words", "COMMAND", "$1");
    for (int c = 0; command_name(c); c++) {
        const char *synopsis = c ? cli_commands[c - 1].synopsis : "SCENARIO";
        begin_case(command_name(c), "");
        if (strcmp(synopsis, "SCENARIO") == 0 || strstr(synopsis, "SCENARIO]"))
            printf("%s'\"$(_matvib_scenarios)\"'", strstr(synopsis, "COMMAND") ? "" : "@file ");
        if (strstr(synopsis, "[COMMAND")) {
            for (int i = 1; command_name(i); i++)
                printf(" %s", command_name(i));
        } else if (strstr(synopsis, "[PROBLEM")) {
            for (int i = 0; problems[i]; i++)
                printf(" %s", problems[i]->word);
        } else if (strcmp(command_name(c), "verify") == 0) {
            for (int i = 0; verify_name(i); i++)
                printf("%s%s", i ? " " : "", verify_name(i));
        } else if (strcmp(command_name(c), "lesson") == 0 || strcmp(command_name(c), "grade") == 0) {
            fputs("@file", stdout);
            for (int i = 0; builtin_lessons[i].name; i++)
                printf(" %s", builtin_lessons[i].name);
        }
        end_case();
    }
    end_choice();
}

static void write_keys(void)
{
    begin_words("_matvib_keys");
    for (int i = 0; i < n_parameters; i++)
        printf("%s%s", !i ? "" : i % IN_LINE ? " " : "\n    ", parameters[i].key);
    end_words();
    begin_choice("_matvib_values", "KEY", "$1");
    for (int i = 0; i < n_parameters; i++) {
        const Parameter *parameter = &parameters[i];
        if (parameter->type != PARAMETER_CHOICE && parameter->type != PARAMETER_FLAG && !parameter->automatic)
            continue;
        begin_case(parameter->key, "");
        for (int k = 0; parameter->type == PARAMETER_CHOICE && parameter->choices[k]; k++)
            printf("%s%s", k ? " " : "", parameter->choices[k]);
        if (parameter->type == PARAMETER_FLAG)
            fputs("yes no", stdout);
        if (parameter->automatic)
            fputs(parameter->automatic, stdout);
        end_case();
    }
    end_choice();
}

static void write_commands(void)
{
    begin_words("_matvib_commands");
    for (const CliCommand *command = cli_commands; command->name; command++)
        printf("%s ", command->name);
    fputs("--version", stdout);
    end_words();
}

/* --- each shell's own ----------------------------------------------------------------------------- */

static const char bash_part[] =
    "_matvib() {\n"
    "    # The line as typed: COMP_WORDS cuts KEY=VALUE at the sign.\n"
    "    local words current= previous= command=open kind strip=\n"
    "    read -ra words <<<\"${COMP_LINE:0:COMP_POINT}\"\n"
    "    [[ ${COMP_LINE:0:COMP_POINT} == *' ' ]] && words+=('')\n"
    "    local last=$((${#words[@]} - 1))\n"
    "    current=${words[last]} previous=${words[last - 1]}\n"
    "    [[ $last -gt 1 && \" $(_matvib_commands) \" == *\" ${words[1]} \"* ]] && command=${words[1]}\n"
    "    if [[ $current == --*=* ]]; then\n"
    "        previous=${current%%=*} strip=$previous= current=${current#*=}\n"
    "    fi\n"
    "    kind=$(_matvib_argument \"$command\" \"$previous\")\n"
    "    if [[ -z $kind && $current == -* ]]; then\n"
    "        kind=$(_matvib_options \"$command\")\n"
    "    elif [[ -z $kind ]]; then\n"
    "        kind=$(_matvib_words \"$command\")\n"
    "        [[ $last -eq 1 ]] && kind=\"$kind $(_matvib_commands)\"\n"
    "    fi\n"
    "    COMPREPLY=()\n"
    "    if [[ $kind == @key && $current == *=* ]]; then\n"
    "        strip=$strip${current%%=*}=\n"
    "        COMPREPLY=($(compgen -W \"$(_matvib_values \"${current%%=*}\")\" -- \"${current#*=}\"))\n"
    "    elif [[ $kind == @key ]]; then\n"
    "        compopt -o nospace 2>/dev/null\n"
    "        COMPREPLY=($(compgen -S = -W \"$(_matvib_keys)\" -- \"$current\"))\n"
    "    elif [[ $kind == @folder ]]; then\n"
    "        compopt -o filenames 2>/dev/null\n"
    "        mapfile -t COMPREPLY < <(compgen -d -- \"$current\")\n"
    "    elif [[ $kind != @none ]]; then\n"
    "        COMPREPLY=($(compgen -W \"${kind#@file}\" -- \"$current\"))\n"
    "        if [[ $kind == @file* ]]; then\n"
    "            local files\n"
    "            compopt -o filenames 2>/dev/null\n"
    "            mapfile -t files < <(compgen -f -- \"$current\")\n"
    "            COMPREPLY+=(\"${files[@]}\")\n"
    "        fi\n"
    "    fi\n"
    "    # where the sign parts words, bash replaces what follows it alone\n"
    "    if [[ -n $strip && $COMP_WORDBREAKS != *=* ]]; then\n"
    "        COMPREPLY=(\"${COMPREPLY[@]/#/$strip}\")\n"
    "    fi\n"
    "}\n"
    "complete -F _matvib matvib\n";

static const char zsh_part[] =
    "_matvib() {\n"
    "    local current=${words[CURRENT]} previous=${words[CURRENT-1]} command=open kind\n"
    "    if (( CURRENT > 2 )) && [[ \" $(_matvib_commands) \" == *\" ${words[2]} \"* ]]; then\n"
    "        command=${words[2]}\n"
    "    fi\n"
    "    if [[ $current == --*=* ]]; then\n"
    "        previous=${current%%=*}\n"
    "        current=${current#*=}\n"
    "        compset -P 1 '*='\n"
    "    fi\n"
    "    kind=$(_matvib_argument \"$command\" \"$previous\")\n"
    "    if [[ -z $kind && $current == -* ]]; then\n"
    "        kind=$(_matvib_options \"$command\")\n"
    "    elif [[ -z $kind ]]; then\n"
    "        kind=$(_matvib_words \"$command\")\n"
    "        (( CURRENT == 2 )) && kind=\"$kind $(_matvib_commands)\"\n"
    "    fi\n"
    "    if [[ $kind == @key && $current == *=* ]]; then\n"
    "        local key=${current%%=*}\n"
    "        compset -P 1 '*='\n"
    "        compadd -- ${=$(_matvib_values \"$key\")}\n"
    "    elif [[ $kind == @key ]]; then\n"
    "        compadd -S = -- ${=$(_matvib_keys)}\n"
    "    elif [[ $kind == @folder ]]; then\n"
    "        _files -/\n"
    "    elif [[ $kind != @none ]]; then\n"
    "        compadd -- ${=${kind#@file}}\n"
    "        [[ $kind == @file* ]] && _files\n"
    "    fi\n"
    "    return 0\n"
    "}\n"
    "_matvib \"$@\"\n";

static const char fish_part[] =
    "function _matvib\n"
    "    set -l words (commandline -opc)\n"
    "    set -l current (commandline -ct)\n"
    "    set -l previous $words[-1]\n"
    "    set -l command open\n"
    "    set -l strip\n"
    "    if test (count $words) -gt 1; and contains -- $words[2] (_matvib_commands | string split -n ' ')\n"
    "        set command $words[2]\n"
    "    end\n"
    "    if string match -q -- '--*=*' $current\n"
    "        set -l parts (string split -m 1 = -- $current)\n"
    "        set previous $parts[1]\n"
    "        set strip $previous=\n"
    "        set current $parts[2]\n"
    "    end\n"
    "    set -l kind (_matvib_argument $command $previous | string split -n ' ')\n"
    "    if test -z \"$kind\"; and string match -q -- '-*' $current\n"
    "        set kind (_matvib_options $command | string split -n ' ')\n"
    "    else if test -z \"$kind\"\n"
    "        set kind (_matvib_words $command | string split -n ' ')\n"
    "        if test (count $words) -eq 1\n"
    "            set -a kind (_matvib_commands | string split -n ' ')\n"
    "        end\n"
    "    end\n"
    "    if test \"$kind[1]\" = @key; and string match -q -- '*=*' $current\n"
    "        set -l key (string split -m 1 = -- $current)[1]\n"
    "        printf '%s\\n' \"$strip$key=\"(_matvib_values $key | string split -n ' ')\n"
    "    else if test \"$kind[1]\" = @key\n"
    "        printf '%s\\n' \"$strip\"(_matvib_keys | string split -n ' ')=\n"
    "    else if test \"$kind[1]\" = @folder\n"
    "        __fish_complete_directories $current\n"
    "    else if test \"$kind[1]\" != @none\n"
    "        printf '%s\\n' \"$strip\"(string match -v @file -- $kind)\n"
    "        contains -- @file $kind; and __fish_complete_path $current\n"
    "    end\n"
    "end\n"
    "complete -c matvib -f -a '(_matvib)'\n";

int main(int count, char **arguments)
{
    static const struct {
        const char *shell, *first, *part;
    } shells[] = {{"bash", "", bash_part}, {"zsh", "#compdef matvib\n", zsh_part}, {"fish", "", fish_part}};
    int s = 0;
    while (s < 3 && (count != 2 || strcmp(arguments[1], shells[s].shell) != 0))
        s++;
    if (s == 3) {
        fputs("usage: write_completion bash | zsh | fish\n", stderr);
        return 2;
    }
    fish = s == 2;
    printf("%s# Completion of matvib for %s, made from the program's tables.\n\n", shells[s].first,
           arguments[1]);
    write_commands();
    write_options();
    write_arguments();
    write_words();
    write_keys();
    fputs(shells[s].part, stdout);
    return ferror(stdout) || fflush(stdout) != 0;
}
