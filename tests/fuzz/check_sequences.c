/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands with sensible arguments, in any order: what nobody would think of trying, played as scripts.
 *
 *     MATVIB_SEQUENCES=N  so many sequences       MATVIB_SEED=N  the first one's number; each has the next
 *
 * Each sequence is a script, played in a child process that ends by itself with status 0, or has failed:
 * crashed, leaked, hung. The script that failed is made as short as it goes, printed, and kept as
 * sequence-SEED.script for `matvib mode1 --paused --script`. */
#include "lessons/lesson.h"
#include "scenario/settings.h"
#include "scenario/parameters.h"
#include "scenario/scenario.h"
#include "lab/session/script.h"
#include "help/command.h"

#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <locale.h>
#include <math.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum {
    ACTIONS_MAX = 60,
    TEXT_BYTES = 256,
    SECONDS_A_LINE = 20,
    SECONDS_A_SEQUENCE = 600,
    SECONDS_TO_SHRINK = 20
};

/* One or more lines of a script that belong together. */
typedef struct Action {
    char text[TEXT_BYTES];
} Action;

typedef struct Sequence {
    Action actions[ACTIONS_MAX];
    int count;
} Sequence;

/* Of the children, for the parent to read. */
static struct Seen {
    long lines;
    double longest; /* processor seconds that one line took */
    char slowest[TEXT_BYTES];
} * seen;

/* --- what is drawn -------------------------------------------------------------------------------- */

static uint64_t state;

static uint64_t next_random(void)
{
    state += 0x9e3779b97f4a7c15u;
    uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static int below(int count)
{
    return (int)(next_random() % (uint64_t)count);
}

#define PICK(table) ((table)[below((int)(sizeof(table) / sizeof *(table)))])

static const char *any_scenario(void)
{
    int count = 0;
    while (builtin_scenarios[count].name)
        count++;
    return builtin_scenarios[below(count)].name;
}

static const char *any_lesson(void)
{
    int count = 0;
    while (builtin_lessons[count].name)
        count++;
    return builtin_lessons[below(count)].name;
}

/* A value: mostly one that a person might try, else one at its limit or beyond it. */
static void any_value(const Parameter *parameter, char *out, size_t size)
{
    static const char *const odd[] = {"0",     "-1",          "-0",   "1e-6",  "1e6",  "1e-300",
                                      "1e300", "nan",         "inf",  "",      "auto", "1e9",
                                      "1e-9",  "99999999999", "0x10", "1e-12", "1e12", "one two"};
    static const char *const texts[] = {"2:0.1", "1,2", "3:0.05,5:0.01", "1", "0", "-", "1e-5,2e-5", "0.5"};
    static const double factors[] = {0.25, 0.5, 0.9, 1, 1.1, 2, 3, 5, -1};
    const int kind = below(100);
    if (kind < 15)
        snprintf(out, size, "%s", PICK(odd));
    else if (parameter->choices)
        snprintf(out, size, "%s",
                 parameter->choices[below(parameter_in(parameter, &problem_supported_beam).n_choices)]);
    else if (parameter->type == PARAMETER_TEXT)
        snprintf(out, size, "%s", PICK(texts));
    else if (kind < 25)
        snprintf(out, size, "%.17g", below(2) ? parameter->least : parameter->most);
    else if (kind < 30)
        snprintf(out, size, "%.17g", below(2) ? parameter->least - 1 : parameter->most + 1);
    else if (parameter->type == PARAMETER_INTEGER)
        snprintf(out, size, "%g", parameter->least + below(12));
    else {
        /* about the default of a problem that has it */
        double about = NAN;
        int n_problems = 0;
        while (problems[n_problems])
            n_problems++;
        for (int tries = 0; tries < 32 && isnan(about); tries++) {
            const Problem *problem = problems[below(n_problems)];
            if (parameter_applies(parameter, problem))
                about = parameter_in(parameter, problem).usual;
        }
        snprintf(out, size, "%.6g", (about == 0 || isnan(about) ? 1 : about) * PICK(factors));
    }
}

static void any_setting(char *out, size_t size)
{
    const Parameter *parameter = &parameters[below(n_parameters)];
    char value[64];
    /* those that are live change a run under way, and are tried more often */
    for (int tries = 0; tries < 2 && !parameter->live; tries++)
        parameter = &parameters[below(n_parameters)];
    any_value(parameter, value, sizeof value);
    snprintf(out, size, "%s=%s", parameter->key, value);
}

/* What is typed behind `:`. */
static void any_line(char *out, size_t size)
{
    static const char *const files[] = {"a.ini", "b.ini", "a-series.csv.ini", "sub/a.ini"};
    static const char *const figures[] = {"a.svg", "b.pdf", "c.png", "none.xyz"};
    static const char *const overlays[] = {"", " a-series.csv", " a-series.csv time v_cm",
                                           " b-series.csv 1 3", " a.ini"};
    static const char *const times[] = {"0", "0.5", "2", "1e-5", "1e-4", "-1", "1e9", "nan"};
    static const char *const stops[] = {
        "",      "t 0.5",    "t 1e9",          "#40",         "#9999999", "end",
        "event", "crossing", "first crossing", "first break", "break",    "t x"};
    static const char *const plots[] = {"",       "x",        "v",      "stress",
                                        "v_cm",   "energy",   "total",  "particle 3",
                                        "v none", "node 2 v", "node 3", "particle 0 v"};
    const int kind = below(100);
    char setting[160], other[160];
    any_setting(setting, sizeof setting);
    any_setting(other, sizeof other);
    if (kind < 42)
        snprintf(out, size, "%s", setting);
    else if (kind < 50)
        snprintf(out, size, "#%d", below(4) ? below(60) : below(3000));
    else if (kind < 53)
        snprintf(out, size, "goto %s", PICK(times));
    else if (kind < 59)
        snprintf(out, size, "open %s", any_scenario());
    else if (kind < 65)
        snprintf(out, size, below(3) ? "duel %s" : "duel %s %s", setting, other);
    else if (kind < 71)
        snprintf(out, size, below(3) ? "show %d" : "show %d %d", 1 + below(9), 1 + below(6));
    else if (kind < 73)
        snprintf(out, size, "references %s", parameter_reference_words[below(4)]);
    else if (kind < 75)
        snprintf(out, size, "particle %d", below(3) ? below(60) : below(100000));
    else if (kind < 77)
        snprintf(out, size, "lesson %s", any_lesson());
    else if (kind < 79)
        snprintf(out, size, "export %s", below(2) ? "a" : "b");
    else if (kind < 81)
        snprintf(out, size, "figure %s", PICK(figures));
    else if (kind < 83)
        snprintf(out, size, "write %s", PICK(files));
    else if (kind < 85)
        snprintf(out, size, "open %s", PICK(files));
    else if (kind < 87)
        snprintf(out, size, "overlay%s", PICK(overlays));
    else if (kind < 89)
        snprintf(out, size, "until %s", PICK(stops));
    else if (kind < 90)
        snprintf(out, size, "event %d", below(20) - 1);
    else if (kind < 92)
        snprintf(out, size, "loop %s %s", below(4) ? PICK(times) : "", PICK(times));
    else if (kind < 94)
        snprintf(out, size, "plot %s", PICK(plots));
    else if (kind < 95)
        snprintf(out, size, "node %d", below(3) ? below(60) : below(100000));
    else {
        const Command *command = &commands[below(n_commands)];
        while (command->id == COMMAND_QUIT || command->id == COMMAND_INTERRUPT)
            command = &commands[below(n_commands)];
        snprintf(out, size, "%s", command->name);
    }
}

/* One key of each command but those that leave the laboratory. */
static void any_key(char *out, size_t size)
{
    const Command *command = &commands[below(n_commands)];
    while (command->id == COMMAND_QUIT || command->id == COMMAND_INTERRUPT)
        command = &commands[below(n_commands)];
    char key[COMMAND_KEY_MAX];
    command_first_key(command, key);
    snprintf(out, size, "%s", key);
}

static void any_action(Action *action)
{
    static const char *const moves[] = {
        ".",         ". . . . .", "> >",         ", ,",       "< <",       "] ] ]", "[ [",
        "0",         "$",         "Space",       "u",         "u u u",     "^R",    "^R ^R",
        "t",         "t t",       "d",           "c",         "m",         "'",     "r",
        "i",         "i Right",   "i Left Left", "e e",       "1 1",       "2 2",   "3 3",
        "4",         "5",         "6 6",         "7 7",       "8 8",       "9",     "L",
        "z",         "Z",         "N N",         "n n",       "a",         "T",     "PageDown",
        "Enter",     "Tab",       "S-Tab",       "Up Up",     "Down Down", "Left",  "Right",
        "Esc Esc",   "y",         "Space Space", "PageUp",    "T Enter",   "Home",  "End",
        "x a Enter", "w b Enter", "o b Enter",   "/ v Enter", "g 1 Enter", "Esc"};
    char line[200];
    const int kind = below(100);
    if (kind < 45) {
        any_line(line, sizeof line);
        snprintf(action->text, sizeof action->text, "type :%s\nkey Enter\n", line);
        if (below(4) == 0)
            snprintf(action->text, sizeof action->text, "key Esc Esc\ntype :%s\nkey Enter%s\n", line,
                     below(2) ? " y" : "");
    } else if (kind < 78) {
        snprintf(action->text, sizeof action->text, "key %s\n", PICK(moves));
    } else if (kind < 86) {
        any_key(line, sizeof line);
        snprintf(action->text, sizeof action->text, "key %s\n", line);
    } else if (kind < 93) {
        snprintf(action->text, sizeof action->text, "wait %g\n", below(4) ? 0.1 : 1.0);
    } else if (kind < 97) {
        const bool small = below(6) == 0;
        snprintf(action->text, sizeof action->text, "size %dx%d\n", small ? 1 + below(40) : 40 + below(161),
                 small ? 1 + below(12) : 12 + below(49));
    } else {
        snprintf(action->text, sizeof action->text, "click %d %d\n", below(100), below(40));
    }
}

static void draw_sequence(uint64_t seed, Sequence *sequence)
{
    state = seed;
    sequence->count = 8 + below(ACTIONS_MAX - 8);
    for (int i = 0; i < sequence->count; i++)
        any_action(&sequence->actions[i]);
    /* half of them in another scenario than the first */
    if (below(2))
        snprintf(sequence->actions[0].text, sizeof sequence->actions[0].text, "type :open %s\nkey Enter\n",
                 any_scenario());
}

static void write_sequence(const Sequence *sequence, FILE *out)
{
    fprintf(out, "rate 500\ncancel-after 0.5\n");
    for (int i = 0; i < sequence->count; i++)
        fputs(sequence->actions[i].text, out);
}

/* --- playing -------------------------------------------------------------------------------------- */

static double processor_seconds(void)
{
    struct timespec at;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &at);
    return (double)at.tv_sec + 1e-9 * (double)at.tv_nsec;
}

/* A script that is handed out line by line, so that each one's time is known. */
typedef struct Lines {
    const char *text, *at, *last;
    double begun;
} Lines;

static ssize_t read_line(void *cookie, char *buffer, size_t size)
{
    Lines *lines = cookie;
    const double now = processor_seconds();
    const struct itimerval limit = {{0, 0}, {SECONDS_A_LINE, 0}};
    if (lines->last && now - lines->begun > seen->longest) {
        seen->longest = now - lines->begun;
        snprintf(seen->slowest, sizeof seen->slowest, "%.*s", (int)strcspn(lines->last, "\n"), lines->last);
    }
    lines->begun = now;
    lines->last = lines->at;
    seen->lines += *lines->at != '\0';
    size_t length = strcspn(lines->at, "\n");
    length += lines->at[length] == '\n';
    length = length < size ? length : size;
    memcpy(buffer, lines->at, length);
    lines->at += length;
    setitimer(ITIMER_PROF, &limit, NULL);
    return (ssize_t)length;
}

/* In the child. */
static _Noreturn void play(const char *script)
{
    static Settings settings;
    Status status = {STATUS_DONE, ""};
    const LaboratoryOptions options = {
        .settings = &settings, .scenario = "mode1", .paused = true, .history = 16 << 20};
    Lines lines = {.text = script, .at = script};
    FILE *file = fopencookie(&lines, "r", (cookie_io_functions_t){.read = read_line});
    alarm(SECONDS_A_SEQUENCE);
    if (!file || !scenario_load("mode1", &settings, &status))
        exit(3);
    Session *recording = session_begin(&options, &status);
    if (!recording)
        exit(3);
    const int result = script_play(file, "sequence", &options, NULL, recording, &status);
    if (result != 0)
        fprintf(stderr, "%s\n", status.text);
    session_free(recording);
    fclose(file);
    exit(result);
}

static int remove_one(const char *path, const struct stat *info, int flag, struct FTW *where)
{
    (void)info, (void)flag, (void)where;
    return remove(path);
}

/* 0: all is well; else what waitpid() said. What the child printed goes to `log`. */
static int run(const Sequence *sequence, const char *log)
{
    char *script = NULL, folder[] = "/tmp/matvib-sequence-XXXXXX";
    size_t size;
    FILE *text = open_memstream(&script, &size);
    if (!text || !mkdtemp(folder))
        exit(EXIT_FAILURE);
    write_sequence(sequence, text);
    fclose(text);
    fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        /* nothing is read or written but in there */
        const int out = open(log, O_WRONLY | O_CREAT | O_TRUNC, 0600);
        if (out < 0 || chdir(folder) != 0 || dup2(out, 1) < 0 || dup2(out, 2) < 0)
            _exit(3);
        setenv("XDG_STATE_HOME", folder, 1);
        setenv("HOME", folder, 1);
        play(script);
    }
    int result = -1;
    while (child > 0 && waitpid(child, &result, 0) < 0 && errno == EINTR)
        ;
    nftw(folder, remove_one, 16, FTW_DEPTH | FTW_PHYS);
    free(script);
    return result;
}

/* Drops whatever the failure does not need, in ever smaller pieces. */
static void shrink(Sequence *sequence, int failure, const char *log)
{
    const time_t begun = time(NULL);
    for (int piece = sequence->count / 2; piece > 0; piece = piece > 1 ? piece / 2 : 0)
        for (int at = 0; at + piece <= sequence->count && time(NULL) - begun < SECONDS_TO_SHRINK;) {
            Sequence shorter = *sequence;
            shorter.count -= piece;
            memmove(&shorter.actions[at], &shorter.actions[at + piece],
                    (size_t)(shorter.count - at) * sizeof shorter.actions[0]);
            if (run(&shorter, log) == failure)
                *sequence = shorter;
            else
                at += piece;
        }
}

static void tell_failure(uint64_t seed, Sequence *sequence, int failure)
{
    char log[64], name[64];
    snprintf(log, sizeof log, "/tmp/matvib-sequence-%ld.log", (long)getpid());
    if (WIFSIGNALED(failure))
        printf("# sequence %llu: %s\n", (unsigned long long)seed,
               WTERMSIG(failure) == SIGPROF ? "one line takes too long" : strsignal(WTERMSIG(failure)));
    else
        printf("# sequence %llu: exit status %d\n", (unsigned long long)seed, WEXITSTATUS(failure));
    shrink(sequence, failure, log);
    run(sequence, log);
    snprintf(name, sizeof name, "sequence-%llu.script", (unsigned long long)seed);
    FILE *script = fopen(name, "w"), *said = fopen(log, "r");
    if (script) {
        write_sequence(sequence, script);
        fclose(script);
    }
    printf("# matvib mode1 --paused --script %s, with this in it:\n", name);
    write_sequence(sequence, stdout);
    char *line = NULL;
    size_t room = 0;
    for (int i = 0; said && i < 60 && getline(&line, &room, said) >= 0; i++)
        printf("# %s", line);
    free(line);
    if (said)
        fclose(said);
    remove(log);
}

/* A run that asks for too much memory should hear so, not fill the machine. */
#ifdef MATVIB_SANITIZERS
const char *__asan_default_options(void);
const char *__lsan_default_suppressions(void);

const char *__asan_default_options(void)
{
    return "allocator_may_return_null=1:max_allocation_size_mb=4000:hard_rss_limit_mb=4000";
}

const char *__lsan_default_suppressions(void)
{
    return "leak:libfontconfig";
}

static void limit_memory(void)
{
}
#else
static void limit_memory(void)
{
    const struct rlimit most = {(rlim_t)4 << 30, (rlim_t)4 << 30};
    setrlimit(RLIMIT_AS, &most);
}
#endif

int main(void)
{
    const char *wanted = getenv("MATVIB_SEQUENCES"), *first = getenv("MATVIB_SEED");
    const long count = wanted ? atol(wanted) : getenv("MATVIB_WIDE") ? 20 : 5;
    const uint64_t seed = first ? strtoull(first, NULL, 10) : 1;
    long failed = 0;
    char log[64];
    snprintf(log, sizeof log, "/tmp/matvib-sequence-%ld.log", (long)getpid());
    seen = mmap(NULL, sizeof *seen, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (seen == MAP_FAILED)
        return EXIT_FAILURE;
    setlocale(LC_ALL, "C.UTF-8");
    setlocale(LC_NUMERIC, "C");
    limit_memory();
    printf("1..1\n");
    for (long i = 0; i < count; i++) {
        static Sequence sequence;
        draw_sequence(seed + (uint64_t)i, &sequence);
        const int failure = run(&sequence, log);
        if (failure != 0) {
            failed++;
            tell_failure(seed + (uint64_t)i, &sequence, failure);
            fflush(stdout);
        }
    }
    remove(log);
    printf("# %ld sequences from %llu, %ld lines; the longest took %.2f s: %s\n", count,
           (unsigned long long)seed, seen->lines, seen->longest, seen->slowest);
    printf("%s 1 - commands in any order\n", failed ? "not ok" : "ok");
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
