/* `matvib run SCENARIO`: from the start to the end without a screen, tables written on the way. */
#include "cli/cli.h"
#include "cli/options.h"
#include "lab/export.h"
#include "lab/summary.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

/* A signal asks the run to end; it takes back its temporary files, and the exit status tells which it was. */
static volatile sig_atomic_t ended_by;

static void end_run(int signal_number)
{
    ended_by = signal_number;
}

static void listen_to_signals(void)
{
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction action = {.sa_handler = end_run}, old;
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++)
        if (sigaction(signals[i], NULL, &old) == 0 && old.sa_handler != SIG_IGN)
            sigaction(signals[i], &action, NULL);
}

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

typedef struct Bar {
    bool visible;
    double began, shown;
} Bar;

static void draw_bar(const Bar *bar, double share, double now)
{
    enum { WIDTH = 40 };
    int full = (int)(share * WIDTH);
    char line[WIDTH + 1];
    for (int i = 0; i < WIDTH; i++)
        line[i] = i < full ? '#' : '.';
    line[WIDTH] = '\0';
    double left = share > 0 ? (now - bar->began) * (1 - share) / share : 0;
    fprintf(stderr, "\r[%s] %3.0f %%  %.0f s left \033[K", line, floor(100 * share), ceil(left));
}

static bool show_progress(double share, void *context)
{
    Bar *bar = context;
    double now = bar->visible ? seconds() : 0;
    /* a run that takes no time needs no bar */
    if (bar->visible && now - bar->began > 0.5 && now - bar->shown > 0.1) {
        draw_bar(bar, share, now);
        bar->shown = now;
    }
    return ended_by == 0;
}

static void wipe_bar(const Bar *bar)
{
    if (bar->shown > 0)
        fputs("\r\033[K", stderr);
}

static bool writes_to_standard_output(const Outputs *outputs)
{
    const char *const names[] = {outputs->series, outputs->particles, outputs->nodes, outputs->bonds};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (names[i] && strcmp(names[i], "-") == 0)
            return true;
    return false;
}

static void tell_files(FILE *to, const Outputs *outputs)
{
    const char *const names[] = {outputs->series, outputs->particles, outputs->nodes, outputs->bonds,
                                 outputs->vtk};
    int told = 0;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (names[i] && strcmp(names[i], "-") != 0)
            fprintf(to, "%s%s", told++ ? ", " : "wrote ", names[i]);
    if (told)
        fputc('\n', to);
}

static void tell(const Options *options, const Settings *settings, const RunSummary *summary, double took)
{
    FILE *to = writes_to_standard_output(&options->outputs) ? stderr : stdout;
    char text[SUMMARY_MAX];
    summary_text(summary, settings, text);
    if (*settings->title)
        fprintf(to, "%s\n", settings->title);
    fprintf(to, "%swall time %.3g s\n", text, took);
    tell_files(to, &options->outputs);
}

int cli_run(int count, char **arguments, Status *status)
{
    Options options;
    Settings settings;
    if (!options_parse("run", count, arguments, &options, status) ||
        !options_words(&options, 1, 1, "SCENARIO", status) ||
        !options_load(&options, options.words[0], &settings, status))
        return (int)status->code;
    long cores = sysconf(_SC_NPROCESSORS_ONLN);
    int threads = (int)(options.threads > 0 ? options.threads : cores > 0 ? cores : 1);
    listen_to_signals();
    Bar bar = {.visible = !options.quiet && isatty(STDERR_FILENO), .began = seconds()};
    RunSummary summary;
    bool done = export_run(&settings, &options.outputs, threads, show_progress, &bar, &summary, status);
    wipe_bar(&bar);
    if (ended_by != 0 && !done && !summary.failed)
        return 128 + (int)ended_by;
    if ((done || summary.failed) && !options.quiet)
        tell(&options, &settings, &summary, seconds() - bar.began);
    return done ? STATUS_DONE : (int)status->code;
}
