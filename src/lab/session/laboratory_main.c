/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From the words of the command line to a laboratory on its host, with the session that is kept of it. */

#include "lab/laboratory.h"
#include "terminal/terminal.h"
#include "lab/session/script.h"
#include "lab/session/session.h"
#include "lab/session/state_file.h"
#include "plain/plain.h"
#include "scenario/parameters.h"

#include <locale.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *const last_session = "last.session";

/* The session that is to be done again, if one is; its scenario takes the place of that of the options. */
static bool open_replay(LaboratoryOptions *options, Session **replay, Status *status)
{
    char *last = options->last ? state_file(last_session) : NULL;
    const char *file = options->last ? last : options->replay;
    bool sound = true;
    if (options->last && (!last || access(last, F_OK) != 0))
        sound = status_refuse(status, "--last: no session has been kept (%s)",
                              last ? last : "there is no home folder");
    else if (file) {
        *replay = session_read(file, status);
        sound = *replay != NULL;
    }
    if (sound && *replay) {
        session_options(*replay, options);
        options->fast |= options->last;
    }
    free(last);
    return sound;
}

static bool open_recording(const LaboratoryOptions *options, Session **recording, Status *status)
{
    if (options->record && !output_may_begin(options->record, ASKER_COMMAND_LINE, options->force, status))
        return false;
    *recording = session_begin(options, status);
    if (*recording && options->record)
        session_record(*recording, options->record, options->force);
    return *recording != NULL;
}

/* Whether the locale that the environment names has the characters of UTF-8. */
static bool names_utf8(void)
{
    static const char *const variables[] = {"LC_ALL", "LC_CTYPE", "LANG"};
    const char *name = NULL;
    for (size_t i = 0; i < sizeof variables / sizeof *variables && (!name || !*name); i++)
        name = getenv(variables[i]);
    return name && (strcasestr(name, "utf-8") || strcasestr(name, "utf8"));
}

int laboratory_main(const LaboratoryOptions *given, Status *status)
{
    LaboratoryOptions options = *given;
    Session *replay = NULL, *recording = NULL;
    Status ignored = {0};
    int result = STATUS_DONE, reached[LESSONS_MAX] = {0};
    /* nobody sits there: keys come from a file */
    const bool unattended = options.script || options.camera || (options.plain && !isatty(STDIN_FILENO));
    char *last = unattended ? NULL : state_file(last_session);
    /* a script gives the same screens always; a homework is each student's own, from its first page on */
    if (!unattended && !(options.student && *options.student))
        state_file_read_lessons(reached);
    options.reached = reached;
    options.first_start = last && access(last, F_OK) != 0; /* never of a script */
    options.keeps_sheet = !unattended && !options.plain;
    if (options.keeps_sheet && !options.sheet)
        options.sheet = state_file_word(state_file_sheet, parameter_sheet_words);
    if (options.keeps_sheet && !options.sheet)
        options.sheet = parameter_sheet_words[SHEET_PLAIN];
    /* names, widths and the character set are the user's; numbers have a point everywhere */
    const bool installed = setlocale(LC_ALL, "") != NULL;
    /* a film has the characters of UTF-8, whatever the terminal has that asked for it; so has a locale that
     * is named (ssh hands names on) but not installed here */
    if ((options.camera || (!installed && names_utf8())) && !setlocale(LC_CTYPE, "C.UTF-8"))
        setlocale(LC_CTYPE, "en_US.UTF-8");
    setlocale(LC_NUMERIC, "C");
    if (!open_replay(&options, &replay, status) || !open_recording(&options, &recording, status)) {
        result = (int)status->code;
    } else {
        result = options.plain ? plain_play(stdin, "standard input", stdout, &options, recording, status)
                 : options.script || options.camera ? script_run(&options, replay, recording, status)
                                                    : loop_run(&options, replay, recording, status);
        const bool any = session_has_keys(recording);
        if (any && !session_finish(recording, status) && result == STATUS_DONE)
            result = (int)status->code;
        if (any && last) { /* that this one cannot be kept is not a failure */
            output_make_own_folders(ASKER_COMMAND_LINE, last);
            output_remove_remains(last);
            session_keep(recording, last, &ignored);
        }
    }
    free(last);
    session_free(replay);
    session_free(recording);
    return result;
}
