/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib movie SCENARIO|SESSION|SCRIPT --output FILE`: the laboratory without a terminal, filmed. */
#include "cli/cli.h"
#include "scenario/settings.h"
#include "cli/options.h"
#include "base/input.h"
#include "base/output.h"
#include "base/visible.h"
#include "lab/session/laboratory_main.h"
#include "lab/session/script.h"
#include "panes/screen.h"
#include "problems/problem.h"
#include "scenario/parameters.h"
#include "film/film.h"

#include <errno.h>
#include <string.h>

enum { SOURCE_BYTES_MAX = 200000000, LINE_BYTES_MAX = 4096, TITLE_BYTES = 256 };

typedef enum Source { SOURCE_WRONG, SOURCE_SCENARIO, SOURCE_SESSION, SOURCE_SCRIPT } Source;

/* The first line that is not a comment says what a file is: sessions begin with their scenario, scripts with
 * an instruction. */
static Source source_of(const char *word, Status *status)
{
    Status ignored = {0};
    if (scenario_builtin(word))
        return SOURCE_SCENARIO;
    FILE *file = input_open(word, SOURCE_BYTES_MAX, status);
    if (!file) /* scenarios have their own words about a name that is none */
        return errno == ENOENT ? SOURCE_SCENARIO : SOURCE_WRONG;
    InputLines lines = {.stream = file, .name = word};
    char line[LINE_BYTES_MAX + 1] = "";
    while (input_line(&lines, line, sizeof line, &ignored) == INPUT_LINE && (!*line || *line == '#'))
        continue;
    fclose(file);
    const size_t length = strcspn(line, " ");
    for (const ScriptInstruction *row = script_instructions; row->name; row++)
        if (strlen(row->name) == length && strncmp(line, row->name, length) == 0)
            return SOURCE_SCRIPT;
    return strncmp(line, "scenario ", 9) == 0 ? SOURCE_SESSION : SOURCE_SCENARIO;
}

/* The screen of a session is as large as its largest. */
static bool read_session(const char *file, int size[2], Status *status)
{
    Session *session = session_read(file, status);
    if (!session)
        return false;
    const SessionEvent *event;
    for (size_t i = 0; (event = session_event(session, i)); i++)
        if (event->width <= SCRIPT_CELLS_MAX && event->height <= SCRIPT_CELLS_MAX) {
            size[0] = event->width > size[0] ? event->width : size[0];
            size[1] = event->height > size[1] ? event->height : size[1];
        }
    session_free(session);
    return true;
}

static int film(const Options *options, LaboratoryOptions *laboratory, Camera *camera, Status *status)
{
    OutputFile file;
    Progress progress;
    if (!output_open(&file, ASKER_COMMAND_LINE, options->output, options->force, status))
        return (int)status->code;
    progress_begin(&progress, options->quiet);
    camera->stream = file.stream;
    camera->cancel = (Cancel){progress_show, &progress};
    char title[TITLE_BYTES]; /* players show it */
    visible_text(title, sizeof title, laboratory->scenario);
    camera->look.title = title;
    camera->look.width = laboratory->width = laboratory->width > 0 ? laboratory->width : 80;
    camera->look.height = laboratory->height = laboratory->height > 0 ? laboratory->height : 24;
    laboratory->camera = camera;
    int result = laboratory_main(laboratory, status);
    progress_end(&progress);
    if (result == STATUS_DONE &&
        !(output_sound(&file, status) && output_finish(&file, status) && output_commit(&file, status)))
        result = (int)status->code;
    camera_close(camera); /* it may still end the film: before its file goes */
    output_close(&file);
    return progress_signal() ? progress_result(false, status) : result;
}

int cli_movie(Options *options, Status *status)
{
    Settings settings;
    Camera camera = {
        .speed = options->speed, .idle = options->idle, .from = options->from, .to = options->to};
    if (!options->output)
        return progress_result(
            status_refuse(status, "movie: --output FILE is missing (FILE.cast, .svg or .gif)"), status);
    const char *word = options->words[0];
    const Source source = source_of(word, status);
    if (source == SOURCE_WRONG || !(camera.format = film_format(options->output, status)) ||
        (camera.from > camera.to &&
         !status_refuse(status, "--from: %g comes after --to: %g", camera.from, camera.to)) ||
        !output_may_begin(options->output, ASKER_COMMAND_LINE, options->force, status))
        return (int)status->code;
    *status = (Status){0};
    if (source == SOURCE_SESSION && (options->n_overrides > 0 || options->steps > 0 || options->script))
        return progress_result(
            status_refuse(status, "%.200s: a session has its own scenario and parameters", word), status);
    if (source == SOURCE_SCRIPT && options->script)
        return progress_result(status_refuse(status, "--script: %.200s is a script already", word), status);
    if (source == SOURCE_SESSION && options->size[0] == 0 && !read_session(word, options->size, status))
        return (int)status->code;
    const char *scenario = source == SOURCE_SCENARIO ? word : scenario_unnamed;
    if (!options_load(options, scenario, &settings, status))
        return (int)status->code;
    camera.fps = options->fps > 0 ? options->fps : camera.format->fps;
    /* Of a body that cracks the map is the film: it takes the room of the plain sheet, where nothing that
     * comes up in the run makes it smaller. */
    const bool plain =
        source == SOURCE_SCENARIO && settings.problem->concerns & (CONCERN_NOTCH | CONCERN_PLATE);
    LaboratoryOptions laboratory = {
        .settings = &settings,
        .scenario = scenario,
        .replay = source == SOURCE_SESSION ? word : NULL,
        .script = source == SOURCE_SCRIPT ? word : options->script,
        .paused = options->paused,
        .glyphs = options->glyphs ? options->glyphs : "braille",
        .sheet = options->screen_sheet ? options->screen_sheet
                 : plain               ? parameter_sheet_words[SHEET_PLAIN]
                                       : NULL,
        .theme = options->theme,
        .threads = progress_threads(options->threads),
        .width = options->size[0],
        .height = options->size[1],
    };
    camera.look.light = options->theme && strcmp(options->theme, "light") == 0;
    const int result = film(options, &laboratory, &camera, status);
    if (result == STATUS_DONE && !options->quiet)
        printf("wrote %s\n", options->output);
    return result;
}
