/* The table of checks, and what the command line says of it. */
#include "cli/verify/verify.h"
#include "base/text.h"
#include "base/threads.h"
#include "cli/options.h"
#include "cli/verify/verify_checks.h"
#include "cli/verify/verify_stories.h"

#include <string.h>

typedef struct Check {
    const char *name;
    const char *title;
    bool (*run)(Verify *verify, Status *status);
    bool full_only;
    const char *left_out; /* what a run without --full leaves out; NULL: nothing */
} Check;

static const Check checks[] = {
    {"M-fig2", "mode 1 of the bar: v_cm as in figure 2", verify_mode1, false, NULL},
    {"M-fig3", "mode 5 of the bar: v_cm as in figure 3", verify_mode5, false, NULL},
    {"M-fig4", "mode 10 of the bar: v_cm as in figure 4", verify_mode10, false, NULL},
    {"M-cell", "half the cell size", verify_cell_size, false, NULL},
    {"M-particles", "1, 4 and 6 particles per cell", verify_particles, false, NULL},
    {"M-dt", "half the time step", verify_time_step, false, NULL},
    {"M-usl", "energy left with stress updated first or last", verify_energy_left, false, NULL},
    {"M-hidden", "kinetic energy that the grid cannot see (USF)", verify_hidden_energy, false, NULL},
    {"M-crossing", "particles that cross cells: energy left at t = 100", verify_crossing, false, NULL},
    {"M-load", "body force and traction (eq. 11), from rest", verify_loads, false, NULL},
    {"M-limits", "stability limits, by bisection", verify_limits, true, "all"},
    {"P-bar", "the bar by peridynamics: the dispersion of its lattice", verify_rod, false, NULL},
    {"P-surface", "surface correction and bonds of the lattice", verify_surface, false, NULL},
    {"P-step", "the critical time step", verify_critical_step, false,
     "the four finer horizons, the notched beam"},
    {"P-table1", "period of the supported beam, as in table 1", verify_table1, false,
     "the four finer horizons"},
    {"P-fig3", "displacement of the midpoint, as in figure 3", verify_midpoint, false,
     "the spacing of .25 mm (.5 mm instead)"},
    {"P-fig4", "velocity of the midpoint, as in figure 4", verify_midpoint_velocity, false, NULL},
    {"P-fig6", "tip of the moving cantilever, as in figure 6", verify_moving_tip, false,
     "1 to 5 ms, and the clamp that only guides"},
    {"P-fig7", "velocity of its tip, as in figure 7", verify_moving_velocity, true, "all"},
    {"P-fig9", "times of the crack, as in figure 9", verify_crack_times, false, NULL},
    {"P-fig10", "path of the crack, as in figure 10", verify_crack_path, false, NULL},
};

enum { CHECKS = sizeof checks / sizeof *checks };

const char *verify_name(int index)
{
    return index < CHECKS ? checks[index].name : NULL;
}

/* --- the command line ---------------------------------------------------------------------------- */

typedef struct Request {
    bool full, list;
    bool named; /* some names were given: only these */
    bool wanted[CHECKS];
} Request;

static int find_check(const char *name)
{
    for (int i = 0; i < CHECKS; i++)
        if (strcmp(checks[i].name, name) == 0)
            return i;
    return -1;
}

static bool unknown_name(const char *name, Status *status)
{
    int nearest = 0;
    for (int i = 1; i < CHECKS; i++)
        if (text_distance(name, checks[i].name) < text_distance(name, checks[nearest].name))
            nearest = i;
    return status_fail(status, STATUS_USAGE,
                       "verify: unknown name \"%s\" (the nearest is %s; --list tells all)", name,
                       checks[nearest].name);
}

static bool read_request(int count, char **arguments, Request *request, Status *status)
{
    Options options;
    *request = (Request){0};
    if (!options_parse("verify", count, arguments, &options, status))
        return false;
    request->full = options.full;
    request->list = options.list;
    for (int i = 0; i < options.n_words; i++) {
        int check = find_check(options.words[i]);
        if (check < 0)
            return unknown_name(options.words[i], status);
        request->named = request->wanted[check] = true;
    }
    return true;
}

/* --- running ------------------------------------------------------------------------------------- */

static void list_checks(FILE *out)
{
    for (int i = 0; i < CHECKS; i++)
        fprintf(out, "%-12s %s%s\n", checks[i].name, checks[i].title, checks[i].full_only ? " (--full)" : "");
}

static bool is_wanted(const Request *request, int i)
{
    return request->named ? request->wanted[i] : request->full || !checks[i].full_only;
}

static void run_check(Verify *verify, const Check *check)
{
    fprintf(verify->out, "%s  %s\n", check->name, check->title);
    Status status = {0};
    if (!check->run(verify, &status)) {
        verify->missed++;
        verify_note(verify, "MISSED: %s", status.text);
    }
    fputc('\n', verify->out);
    fflush(verify->out);
}

/* What a run without --full did not do, so that nobody takes it for the whole. */
static void tell_what_was_left_out(const Request *request, FILE *out)
{
    bool first = true;
    for (int i = 0; i < CHECKS; i++) {
        /* a check that was asked for by name runs although it belongs to --full */
        bool ran = is_wanted(request, i);
        if (request->full || !checks[i].left_out || (request->named && !request->wanted[i]) ||
            (ran && checks[i].full_only))
            continue;
        if (first)
            fputs("Left out without --full:\n", out);
        first = false;
        fprintf(out, "  %-12s %s\n", checks[i].name, checks[i].left_out);
    }
}

int verify_main(int count, char **arguments, FILE *out, Status *status)
{
    Request request;
    if (!read_request(count, arguments, &request, status))
        return STATUS_USAGE;
    if (request.list) {
        list_checks(out);
        return STATUS_DONE;
    }
    Verify verify = {.out = out, .full = request.full, .threads = threads_default(false)};
    for (int i = 0; i < CHECKS && !ferror(out); i++) /* nobody runs for hours for a pipe that is closed */
        if (is_wanted(&request, i))
            run_check(&verify, &checks[i]);
    tell_what_was_left_out(&request, out);
    moving_story_free(verify.moving);
    crack_story_free(verify.crack);
    return verify_end(&verify, status);
}
