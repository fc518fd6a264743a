/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The host of plain words: lines become keys, and what they changed is printed. */
#include "plain/plain.h"
#include "scenario/settings.h"
#include "scenario/rows/rows.h"
#include "base/input.h"
#include "base/signals.h"
#include "base/visible.h"
#include "base/wait.h"
#include "lab/session/session.h"
#include "panes/screen.h"

#include <limits.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#include <wchar.h>

#define PROGRESS_SECONDS 5.0 /* of the wall, between two words about work that takes long */

/* Everything has room on such a screen. */
enum { WIDTH = 132, HEIGHT = 43, PLAIN_LINE_MAX = 4096, HELP_LINES = 15 };

enum { PAGE_LINES = 10 }; /* printed of a page of a lesson which is entered */

static double now(void *context)
{
    return ((const Plain *)context)->time;
}

static void worked(void *context, long steps)
{
    (void)context;
    (void)steps;
}

/* --- what is printed ----------------------------------------------------------------------------------- */

/* In the encoding of the locale, with a question mark for what it does not have. */
static void put(Plain *plain, const char *text)
{
    for (const char *at = text; *at;) {
        char bytes[MB_LEN_MAX];
        mbstate_t state = {0};
        const uint32_t glyph = glyph_next(&at);
        const size_t count = glyph < 0x80 ? (size_t)-1 : wcrtomb(bytes, (wchar_t)glyph, &state);
        plain->lines += glyph == '\n';
        if (count != (size_t)-1)
            fwrite(bytes, 1, count, plain->out);
        else
            fputc(glyph < 0x80 ? (int)glyph : '?', plain->out);
    }
    plain->said = true;
}

static void put_words(Plain *plain, Words *words)
{
    if (words->text)
        put(plain, words->text);
    words_close(words);
}

static void say(Plain *plain, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void say(Plain *plain, const char *format, ...)
{
    Words words = {.text = NULL};
    char text[2048];
    va_list values;
    va_start(values, format);
    vsnprintf(text, sizeof text, format, values);
    va_end(values);
    words_say(&words, 2, "%s", text);
    put_words(plain, &words);
}

static void tell_alone(Plain *plain, TellPart part)
{
    Words words = {.text = NULL};
    tell_part(&plain->lab.screen, part, &words);
    put_words(plain, &words);
}

static void tell_asked(void *context, const char *text)
{
    put(context, text);
}

/* Work that takes long is reported now and then to the user; false: it is cancelled. Signals may come in
 * the meantime (in a page only then). */
static bool go_on(void *context)
{
    Plain *plain = context;
    if (plain->talks)
        wait_for(NULL, 0, &(const struct timespec){0, 0}, NULL);
    if (plain->talks && clock_seconds() > plain->told_at + PROGRESS_SECONDS) {
        plain->told_at = clock_seconds();
        if (plain->lab.message.text[0])
            say(plain, "%s", plain->lab.message.text);
        else if (laboratory_run(&plain->lab))
            tell_alone(plain, TELL_WHERE);
        fflush(plain->out);
    }
    return signals_ended_by() == 0;
}

static void forget_told(void *context)
{
    Plain *plain = context;
    for (int part = 0; part < TELL_PARTS; part++)
        words_close(&plain->last[part]);
}

static void suspend(void *context)
{
    Plain *plain = context;
    if (plain->talks)
        raise(SIGTSTP);
    else
        say(plain, "There is no shell to go back to: the lines come from a file.");
}

static bool is_page(const Plain *plain)
{
    return plain->lab.play.shown.open && plain->lab.play.shown.lesson;
}

/* Whether a part of the screen is printed now: not what changes with every step, but for a stage. */
static bool is_due(const Plain *plain, TellPart part, bool first, bool still, bool moved_far)
{
    const Screen *screen = &plain->lab.screen;
    const bool rests = screen->playback->state == STATE_ENDED || screen->playback->state == STATE_FAILED;
    /* beside a page of a lesson, which is what is read, they wait for `more` */
    const bool page = is_page(plain);
    if (page && (part == TELL_ABOUT || part == TELL_NUMBER || part == TELL_SETUP || part == TELL_UPPER ||
                 part == TELL_LOWER || part == TELL_BODY || part == TELL_PARAMETER))
        return false;
    if (plain->turned && (part == TELL_FOCUS || part == TELL_STAGE || part == TELL_INSPECTOR))
        return false;
    if (page && part == TELL_FOCUS)
        return plain->page;
    if (part == TELL_STAGE)
        return experiment_stage(laboratory_run(&plain->lab)) > 0 || (rests && !page) ||
               (first && !screen->lesson->open);
    if (part == TELL_SETUP)
        return first;
    if (part == TELL_NUMBER)
        return moved_far || first;
    if (part == TELL_UPPER || part == TELL_LOWER) /* curves wait for `more`, unless others are asked for */
        return still && !first;
    if (part == TELL_BODY) /* within a step the stage describes the chosen one */
        return still && !first && experiment_stage(laboratory_run(&plain->lab)) == 0;
    if (part == TELL_FOCUS || part == TELL_PARAMETER)
        return !first;
    return true;
}

static bool has_line(const char *text, const char *line, size_t length)
{
    for (const char *at = text; at && *at; at = strchr(at, '\n') + 1) /* each line has an end: words.c */
        if (strncmp(at, line, length) == 0)
            return true;
    return false;
}

static size_t heading_bytes(const char *text)
{
    return strcspn(text, "\n") + 1;
}

static bool is_same_page(const char *text, const char *before)
{
    return *text && strncmp(before, text, heading_bytes(text)) == 0;
}

/* Of a page that is still open only the lines that are new. One of a lesson that is entered is printed in
 * PAGE_LINES, with what was said before it; the rest of it waits for `more`. */
static void tell_page(Plain *plain, const char *text, const char *before)
{
    const LessonShown *shown = &plain->lab.play.shown;
    const bool same = is_same_page(text, before);
    bool waits = false;
    for (const char *line = text; *line;) {
        const size_t length = heading_bytes(line);
        Words words = {.text = NULL};
        waits |= plain->turned && plain->lines + (line[length] != '\0') >= PAGE_LINES;
        if (!same || !has_line(before, line, length))
            words_say(waits ? &plain->rest : &words, 2, "%.*s", (int)length - 1, line);
        put_words(plain, &words);
        line += length;
    }
    if (waits)
        say(plain, shown->lesson->pages[shown->page].n_choices > 0 && shown->answer < 0
                       ? "more prints the rest, with the choices."
                       : "more prints the rest.");
}

static int count_lines(const char *text)
{
    int lines = 0;
    for (; *text; text++)
        lines += *text == '\n';
    return lines;
}

/* Each part that has changed since it was last printed. */
static void tell_changes(Plain *plain)
{
    const Screen *screen = &plain->lab.screen;
    const Experiment *experiment = laboratory_run(&plain->lab);
    const long step = experiment_step(experiment), stage = experiment_stage(experiment);
    const bool still = step == plain->step && stage == plain->stage;
    const bool moved_far = still || labs(step - plain->step) > 1;
    const bool was_told = plain->last[TELL_WHERE].text != NULL;
    plain->turned = false;
    for (int part = 0; part < TELL_PARTS; part++) {
        Words words = {.text = NULL};
        tell_part(screen, (TellPart)part, &words);
        const char *text = words.text ? words.text : "", *before = plain->last[part].text;
        const bool is_news = strcmp(text, before ? before : "") != 0;
        if (part == TELL_LESSON &&
            (plain->turned = is_page(plain) && !is_same_page(text, before ? before : "")))
            words_close(&plain->rest);
        const bool fits =
            part != TELL_WHERE || !plain->turned || plain->lines + count_lines(text) <= PAGE_LINES;
        if (is_news && fits && is_due(plain, (TellPart)part, !was_told, still, moved_far) &&
            (was_told || part != TELL_STAGE || !before))
            part == TELL_LESSON || part == TELL_ABOUT ? tell_page(plain, text, before ? before : "")
                                                      : put(plain, text);
        if (words.lost)
            say(plain, "Memory was short: something is left out.");
        words_close(&plain->last[part]);
        plain->last[part] = words;
    }
    plain->step = step;
    plain->stage = stage;
    plain->page = is_page(plain);
}

/* As it was given; of a concealed mistake only that there is one. */
static void show_value(const Settings *settings, const Parameter *parameter, char out[LIST_MAX])
{
    settings_get(settings, parameter, out);
    if (*out == '?')
        out[1] = '\0';
    if (!*out)
        strcpy(out, "-");
}

/* Parameters of the same run that have another value now. */
static void tell_edits(Plain *plain)
{
    const Experiment *experiment = laboratory_run(&plain->lab);
    const Settings *settings = experiment_settings(experiment);
    for (int i = 0; i < n_parameters && experiment == plain->of; i++) {
        char was[LIST_MAX], is[LIST_MAX];
        if (!parameter_applies_to(settings, &parameters[i]) ||
            !parameter_applies_to(&plain->settings, &parameters[i]) ||
            !settings_differ(&plain->settings, settings, &parameters[i]))
            continue;
        show_value(&plain->settings, &parameters[i], was);
        show_value(settings, &parameters[i], is);
        say(plain, "%s (%s): %s, before: %s.", parameters[i].label, parameters[i].key, is, was);
    }
    char about[64], was[ROW_TEXT_MAX], is[ROW_TEXT_MAX];
    const bool both = experiment == plain->of && settings->problem == plain->settings.problem;
    RowDifference row;
    for (int i = 0; both && settings_rows_difference(settings, &plain->settings, i, &row); i++) {
        row_difference_show(&row, about, is, was);
        say(plain, "%s: %s, before: %s.", about, is, was);
    }
    plain->of = experiment;
    plain->settings = *settings;
}

static void tell_message(Plain *plain)
{
    Message *message = &plain->lab.message;
    if (message->kind != MESSAGE_NONE)
        say(plain, "%s", message->text);
    message->kind = MESSAGE_NONE;
}

static void tell_question(Plain *plain)
{
    Words words = {.text = NULL};
    tell_prompt(&plain->lab.screen, &words);
    put_words(plain, &words);
}

/* --- keys ---------------------------------------------------------------------------------------------- */

static void press(Plain *plain, const char *name)
{
    Key key = {.x = -1, .y = -1};
    if (plain->lab.closed)
        return;
    snprintf(key.name, sizeof key.name, "%.15s", name);
    laboratory_key(&plain->lab, &key);
}

/* Presses the first character of a text, and returns what is behind it. */
static const char *press_character(Plain *plain, const char *text)
{
    char name[KEY_NAME_MAX];
    text = keys_of_text(text, name);
    press(plain, name);
    return text;
}

static void type(Plain *plain, const char *text)
{
    while (*text)
        text = press_character(plain, text);
}

/* ^C of somebody who sits there meant the work, not the program. */
static void forget_interrupt(const Plain *plain)
{
    if (plain->talks && signals_ended_by() == SIGINT)
        signals_forget();
}

/* The clock of a run by lines goes on by frames; of somebody who sits there it is that of the wall. */
static void pass_time(Plain *plain)
{
    const double at = clock_seconds();
    plain->time += plain->talks ? at - plain->seen_at : FRAME_SECONDS;
    plain->seen_at = at;
}

/* Frames until nothing is under way: a run to where it stops, a stretch of time once, slow motion through one
 * time step. */
static void let_it_work(Plain *plain)
{
    Laboratory *lab = &plain->lab;
    const long begun = experiment_step(laboratory_run(lab));
    double before = experiment_time(laboratory_run(lab));
    long stage = experiment_stage(laboratory_run(lab));
    bool came_back = false;
    plain->told_at = clock_seconds();
    while (laboratory_active(lab)) {
        pass_time(plain);
        laboratory_frame(lab, plain->time);
        const Experiment *experiment = laboratory_run(lab);
        came_back |= experiment_time(experiment) < before && lab->player.playback.looping;
        before = experiment_time(experiment);
        if (lab->player.playback.slow && experiment_stage(experiment) != stage)
            tell_changes(plain);
        stage = experiment_stage(experiment);
        if (!go_on(plain)) {
            forget_interrupt(plain);
            if (lab->play.arriving || laboratory_active(lab)) /* else ^C would mean the program */
                /* not Space on the way to where a page of a lesson begins, for which keys wait */
                press(plain,
                      (lab->player.playback.state == STATE_RUNNING && !lab->play.arriving) ? "Space" : "^C");
            return;
        }
        if ((came_back && lab->player.playback.state == STATE_RUNNING) ||
            (lab->player.playback.slow && experiment_step(experiment) != begun))
            press(plain, "Space");
    }
}

/* --- lines --------------------------------------------------------------------------------------------- */

/* In place of what is in the question or the field. */
static void answer(Plain *plain, const char *line)
{
    const Prompt *prompt = &plain->lab.prompting.shown;
    if (line[0] && line[1] && keys_known(line)) {
        press(plain, line); /* Esc, Down, Tab, ... */
    } else if (prompt->open && prompt->yes_no) {
        *line ? (void)press_character(plain, line) : press(plain, "Enter");
    } else {
        if (*line) {
            press(plain, "End");
            press(plain, "^U");
            type(plain, line);
        }
        press(plain, "Enter");
    }
}

static void take(Plain *plain, const char *line)
{
    const Screen *screen = &plain->lab.screen;
    const Experiment *before = laboratory_run(&plain->lab);
    if (screen->help->open)
        press(plain, "Esc");
    if (screen->prompt->open || screen->parameters->edit.open)
        answer(plain, line);
    else if (!*line)
        press(plain, "Enter");
    else if (keys_known(line) && strcmp(line, ":") != 0)
        press(plain, line);
    else {
        /* Behind `:`; what is refused is reported and leaves no question open. */
        const Prompt *prompt = &plain->lab.prompting.shown;
        if (strlen(line) >= sizeof prompt->text) {
            say(plain, "The line is too long for a command.");
        } else if (plain->lab.parameters.rows.placing) {
            say(plain,
                "A row is being moved: Left, Right, Up and Down do it, Tab takes its other end, Enter takes "
                "it, Esc drops it.");
        } else {
            press(plain, ":");
            type(plain, line);
            press(plain, "Enter");
            if (prompt->open && prompt->problem[0]) {
                say(plain, "%s", prompt->problem);
                press(plain, "Esc");
            }
        }
    }
    /* what is opened by hand waits to be looked at */
    if (laboratory_run(&plain->lab) != before && screen->playback->state == STATE_RUNNING &&
        !screen->lesson->lesson)
        press(plain, "Space");
}

/* The help is printed from its beginning, or whole, and closed again by the next line. */
static void tell_help(Plain *plain)
{
    Words words = {.text = NULL};
    const Screen *screen = &plain->lab.screen;
    int *page = &plain->lab.help.page;
    const int open = *page;
    if (!plain->all_help) {
        *page = 0;
        tell_part(screen, TELL_HELP, &words);
        *page = open;
        /* So much of the help as a screen has: its first lines, up to a whole one. */
        char *end = words.text;
        for (int lines = 0; end && *end && lines < HELP_LINES; lines++) {
            end = strchr(end, '\n');
            end += end != NULL;
        }
        if (end)
            *end = '\0';
        put_words(plain, &words);
        say(plain, "help all prints all keys and commands, help WORD one of them, a view or a parameter.");
        return;
    }
    for (*page = 0; *page < help_pages(screen); ++*page)
        tell_part(screen, TELL_HELP, &words);
    *page = open;
    put_words(plain, &words);
}

static void tell_more(Plain *plain)
{
    const Screen *screen = &plain->lab.screen;
    const bool page = is_page(plain);
    const struct {
        TellPart part;
        bool told;
    } parts[] = {
        {TELL_WHERE, page},
        {TELL_FOCUS, page && screen->panes.focus != PANE_PARAMETERS},
        {TELL_STAGE, page && experiment_stage(laboratory_run(&plain->lab)) > 0},
        {TELL_INSPECTOR, page},
        {TELL_BODY, true},
        {TELL_UPPER, true},
        {TELL_LOWER, true},
    };
    put_words(plain, &plain->rest); /* and is empty */
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        if (parts[i].told)
            tell_alone(plain, parts[i].part);
}

static bool draw(Plain *plain, Status *status)
{
    return laboratory_draw(&plain->lab, &plain->canvas, WIDTH, HEIGHT) ||
           status_fail(status, "out of memory");
}

bool plain_line(Plain *plain, const char *typed, Status *status)
{
    char line[PLAIN_LINE_MAX + 1];
    snprintf(line, sizeof line, "%s", typed);
    for (char *tab = line; (tab = strchr(tab, '\t'));)
        *tab = ' ';
    if (plain->echo)
        say(plain, "> %s", line);
    plain->said = false;
    plain->lines = 0;
    const bool is_answer = plain->lab.prompting.shown.open || plain->lab.parameters.edit.open;
    const char *const word = line + (*line == ':');
    if (!is_answer && (strcmp(word, "more") == 0 || strcmp(word, "why") == 0)) {
        *word == 'm' ? tell_more(plain) : tell_alone(plain, TELL_WHY);
        fflush(plain->out);
        return true;
    }
    plain->all_help = strcmp(line, "help all") == 0 || strcmp(line, ":help all") == 0;
    if (plain->talks)
        pass_time(plain);
    if (visible_is_clean(line))
        take(plain, line);
    else
        say(plain, "This line is not text in UTF-8, or holds characters that cannot be seen.");
    forget_interrupt(plain);
    tell_message(plain); /* it would not outlast the work */
    let_it_work(plain);
    if (!draw(plain, status))
        return false;
    tell_message(plain);
    tell_edits(plain);
    if (plain->lab.help.open)
        tell_help(plain);
    tell_changes(plain);
    tell_question(plain);
    if (!plain->said)
        say(plain, plain->lab.closed ? "Left." : "Done.");
    fflush(plain->out);
    forget_interrupt(plain); /* one more ^C while this was told meant the work too */
    return true;
}

/* --- from beginning to end ----------------------------------------------------------------------------- */

bool plain_open(Plain *plain, const LaboratoryOptions *options, FILE *out, Status *status)
{
    const Host host = {now, worked, go_on, forget_told, suspend, plain, NULL, tell_asked};
    LaboratoryOptions how = *options;
    how.paused = true;
    *plain = (Plain){.out = out, .seen_at = clock_seconds()};
    if (!laboratory_open(&plain->lab, &how, &host, status))
        return false;
    plain->lab.screen.look.glyphs = GLYPHS_ASCII;
    plain->lab.utf8 = false;
    say(plain,
        "matvib in plain words. A line is a key by its name (] is a stage, . a step, Space a run) or a "
        "command: until end, show energies, initial.mode=3, tell stage. more describes the curves, why "
        "explains the number, tell alone repeats all, help lists all, quit leaves.");
    plain->lines = 0;
    let_it_work(plain);
    if (!draw(plain, status)) {
        plain_close(plain);
        return false;
    }
    tell_message(plain);
    tell_edits(plain);
    tell_changes(plain);
    tell_question(plain);
    fflush(out);
    return true;
}

void plain_close(Plain *plain)
{
    forget_told(plain);
    words_close(&plain->rest);
    laboratory_close(&plain->lab);
    canvas_close(&plain->canvas);
}

static bool read_lines(Plain *plain, FILE *in, const char *name, Status *status)
{
    InputLines lines = {.stream = in, .name = name};
    char line[PLAIN_LINE_MAX + 1];
    InputGot got = INPUT_LINE;
    while (!plain->lab.closed && signals_ended_by() == 0) {
        if (plain->talks) {
            struct pollfd keyboard = {.fd = fileno(in), .events = POLLIN};
            fputs("> ", plain->out);
            fflush(plain->out);
            if (wait_for(&keyboard, 1, NULL, NULL) < 0)
                continue; /* a signal; a line comes whole, so none waits in the stream */
        }
        if ((got = input_line(&lines, line, sizeof line, status)) != INPUT_LINE)
            break;
        for (size_t end = strlen(line); end > 0 && line[end - 1] == ' ';)
            line[--end] = '\0';
        if (!plain_line(plain, line + strspn(line, " "), status))
            return false;
    }
    return got != INPUT_WRONG;
}

int plain_play(FILE *in, const char *name, FILE *out, const LaboratoryOptions *options, Session *recording,
               Status *status)
{
    Plain *plain = calloc(1, sizeof *plain);
    signals_catch();
    bool sound = plain || status_fail(status, "out of memory");
    if (sound && (sound = plain_open(plain, options, out, status))) {
        plain->echo = !isatty(fileno(in));
        plain->talks = !plain->echo;
        plain->lab.recording = recording;
        session_note_start(recording, &plain->lab);
        sound = read_lines(plain, in, name, status);
        session_note(recording, &plain->lab, (SessionEvent){.is_end = true, .key = {.x = -1}});
        plain_close(plain);
    }
    free(plain);
    const int ended_by = signals_ended_by();
    if (ended_by && status)
        *status = (Status){STATUS_DONE, ""}; /* that reading was interrupted needs no word */
    signals_release();
    return ended_by ? 128 + ended_by : sound ? STATUS_DONE : (int)status->code;
}
