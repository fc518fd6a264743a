/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command line of verify: which checks there are, and which of them run. */
#include "cli/verify/verify.h"
#include "base/text.h"
#include "base/threads.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "cli/verify/verify_runner.h"

#include <string.h>

const char *verify_name(int index)
{
    return verify_checks[index].name;
}

/* --- the command line ---------------------------------------------------------------------------- */

static int rows_to_run(const VerifyCheck *check, bool full)
{
    int count = 0;
    for (int i = 0; i < check->n_rows; i++)
        count += full || !check->rows[i].full;
    return count;
}

static bool is_known(const char *name, Status *status)
{
    const VerifyCheck *nearest = verify_checks;
    for (const VerifyCheck *check = verify_checks; check->name; check++) {
        if (strcmp(check->name, name) == 0)
            return true;
        if (text_distance(name, check->name) < text_distance(name, nearest->name))
            nearest = check;
    }
    return status_refuse(status, "verify: unknown name \"%s\" (the nearest is %s; --list tells all)", name,
                         nearest->name);
}

static bool is_named(const Options *options, const VerifyCheck *check)
{
    for (int i = 0; i < options->n_words; i++)
        if (strcmp(options->words[i], check->name) == 0)
            return true;
    return false;
}

/* Whether a check is to be run, and whether with the rows of --full. */
static bool is_wanted(const Options *options, const VerifyCheck *check)
{
    return options->n_words ? is_named(options, check) : options->full || rows_to_run(check, false) > 0;
}

static bool is_whole(const Options *options, const VerifyCheck *check)
{
    return options->full || (is_named(options, check) && rows_to_run(check, false) == 0);
}

/* --- running ------------------------------------------------------------------------------------- */

int verify_main(int count, char **arguments, FILE *out, Status *status)
{
    Options options;
    if (!options_parse("verify", count, arguments, &options, status))
        return STATUS_USAGE;
    for (int i = 0; i < options.n_words; i++)
        if (!is_known(options.words[i], status))
            return STATUS_USAGE;
    if (options.list) {
        for (const VerifyCheck *check = verify_checks; check->name; check++)
            fprintf(out, "%-12s %s%s\n", check->name, check->title,
                    rows_to_run(check, false) ? "" : " (--full)");
        return STATUS_DONE;
    }
    Progress progress;
    progress_begin(&progress, false);
    Quantities json = {.out = out};
    if (options.json) {
        json = quantities_open(out, "verify");
        quantities_begin(&json, "quantities");
    }
    Verify verify = {.json = options.json ? &json : NULL,
                     .out = out,
                     .threads = threads_default(false),
                     .progress = &progress};
    for (const VerifyCheck *check = verify_checks; check->name; check++)
        verify.to_do += is_wanted(&options, check) ? rows_to_run(check, is_whole(&options, check)) : 0;
    /* none for a pipe that is closed */
    for (const VerifyCheck *check = verify_checks; check->name && !ferror(out) && !progress_signal(); check++)
        if (is_wanted(&options, check))
            verify_check_run(&verify, check, is_whole(&options, check));
    if (!options.full && !options.json && !progress_signal()) {
        /* What a run without --full did not do, so that it is not taken for the whole. */
        bool first = true;
        for (const VerifyCheck *check = verify_checks; check->name; check++) {
            int left_out = check->n_rows - rows_to_run(check, false);
            /* a check that was asked for by name runs although it belongs to --full */
            if (left_out == 0 ||
                (options.n_words && (!is_named(&options, check) || left_out == check->n_rows)))
                continue;
            if (first)
                fputs("Left out without --full:\n", out);
            first = false;
            fprintf(out, "  %-12s %d of %d rows\n", check->name, left_out, check->n_rows);
        }
    }
    return verify_end(&verify, status);
}
