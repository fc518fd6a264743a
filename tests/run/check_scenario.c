/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scenario files: what is read, what is refused and how that is said, what is written reads back. */
#include "scenario/scenario.h"
#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_output.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "scenario/parameters.h"
#include "suite.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool read_bytes(const char *text, size_t size, Settings *settings, Status *status)
{
    FILE *stream = fmemopen((void *)text, size, "r");
    bool good = scenario_read(stream, "f.ini", settings, status);
    fclose(stream);
    return good;
}

static Settings read_text(const char *text)
{
    Settings settings;
    Status status;
    ck_assert_msg(read_bytes(text, strlen(text), &settings, &status), "%s", status.text);
    return settings;
}

static char *write_text(const Settings *settings, const char *comment)
{
    char *text;
    size_t size;
    Status status;
    FILE *stream = open_memstream(&text, &size);
    ck_assert_msg(scenario_write(stream, settings, comment, &status), "%s", status.text);
    fclose(stream);
    return text;
}

static void expect_round_trip(const Settings *settings)
{
    char *text = write_text(settings, "one\n\ntwo");
    Settings again = read_text(text);
    ck_assert_msg(memcmp(settings, &again, sizeof again) == 0, "%s", text);
    char *rewritten = write_text(&again, "one\n\ntwo");
    ck_assert_str_eq(text, rewritten);
    free(text);
    free(rewritten);
}

START_TEST(builtins_are_sound_and_read_back)
{
    for (const BuiltinScenario *builtin = builtin_scenarios; builtin->name; builtin++) {
        Settings settings;
        Status status;
        ck_assert_msg(scenario_load(builtin->name, &settings, &status), "%s", status.text);
        char title[TITLE_MAX];
        ck_assert(scenario_title(builtin, title));
        ck_assert_msg(*title && strlen(title) <= 45 && strlen(settings.about) > 100, "%s", builtin->name);
        expect_round_trip(&settings);
    }
}
END_TEST

START_TEST(a_file_is_read)
{
    Settings s = read_text("\xef\xbb\xbf# head\r\n[mesh]\r\ncell_size=0.5 ; half\r\n\r\n[scenario]\r\n"
                           "about = one\r\n   two # not this\r\n\tt = 3\r\ntitle\t= A#1;b  # c\r\n"
                           "[output]\nat = 1,2,\n  3\n[changes]\n20 = mpm.algorithm=usl\n"
                           "10 = load.traction = 1e-3\n10 = mpm.algorithm = musl");
    ck_assert(settings_mesh(&s)->cell_size == 0.5);
    ck_assert_str_eq(s.about, "one two t = 3");
    ck_assert_str_eq(s.title, "A#1;b");
    ck_assert_str_eq(settings_output(&s)->at, "1,2,3");
    ck_assert_int_eq(s.n_changes, 3);
    ck_assert_int_eq(s.changes[0].step, 10);
    ck_assert_str_eq(s.changes[0].to.key, "load.traction");
    ck_assert_str_eq(s.changes[1].to.key, "mpm.algorithm");
    ck_assert_str_eq(s.changes[2].to.value, "usl");
    expect_round_trip(&s);
    s = read_text("[time]\nend=1e-3\n[scenario]\nproblem=notched-beam\n[pd]\ncritical_energy=30\n");
    ck_assert(s.problem == &problem_notched_beam && settings_bonds(&s)->energy_given &&
              settings_bonds(&s)->critical_energy == 30 && settings_time(&s)->end == 1e-3);
    expect_round_trip(&s);
}
END_TEST

START_TEST(every_text_reads_back_or_is_refused)
{
    static const struct {
        const char *text;
        bool kept;
    } titles[] = {
        {"plain", true},
        {"a;b#c", true},
        {"a = b", true},
        {"[x]", true},
        {"\xc3\xa9t\xc3\xa9", true},
        {"a ; b", false},
        {"# start", false},
        {" lead", false},
        {"trail ", false},
    };
    Settings s = read_text("[scenario]\nproblem = bar\n");
    for (size_t i = 0; i < sizeof titles / sizeof *titles; i++) {
        strcpy(s.title, titles[i].text);
        char sink[8192];
        FILE *stream = fmemopen(sink, sizeof sink, "w");
        Status status;
        bool good = scenario_write(stream, &s, NULL, &status);
        fclose(stream);
        ck_assert_msg(good == titles[i].kept, "\"%s\"", titles[i].text);
        memset(s.title, 0, sizeof s.title);
        if (!good)
            continue;
        strcpy(s.title, titles[i].text);
        expect_round_trip(&s);
        memset(s.title, 0, sizeof s.title);
    }
    char long_text[ABOUT_MAX] = "";
    while (strlen(long_text) < ABOUT_MAX - 20)
        strcat(long_text, "mode = 3 so  end = 2; ");
    long_text[strlen(long_text) - 1] = '\0';
    strcpy(s.about, long_text);
    for (int i = 0; i < 40; i++)
        sprintf(settings_edit_output(&s)->at + strlen(settings_output(&s)->at), "%s%d.5", i ? "," : "", i);
    expect_round_trip(&s);
}
END_TEST

START_TEST(overrides_stand_above_the_file)
{
    Override sets[] = {{"--set", "mesh.cell_size", "0.5"}, {"--end", "time.end", "7"}};
    Settings settings;
    Status status;
    ck_assert_msg(scenario_load_with("mode5", sets, 2, &settings, &status), "%s", status.text);
    ck_assert(settings_mesh(&settings)->cell_size == 0.5 && settings_time(&settings)->end == 7 &&
              settings_start(&settings)->mode == 5);
    sets[0].value = "0.7";
    ck_assert(!scenario_load_with("mode5", sets, 2, &settings, &status));
    ck_assert_msg(strncmp(status.text, "--set: mesh.cell_size: the length", 33) == 0, "%s", status.text);
    /* the file's end would need a longer channel; the override makes it sound */
    Override shorter[] = {{"--set", "motion.channel", "0.02"}, {"--end", "time.end", "1e-3"}};
    ck_assert(scenario_load_with("moving-cantilever", shorter, 2, &settings, NULL));
    ck_assert(!scenario_load_with("moving-cantilever", shorter, 1, &settings, &status));
    Override handles[] = {{"--set", "pd.critical_energy", "30"}, {"--set", "pd.critical_stretch", "0.001"}};
    ck_assert(scenario_load_with("notched-beam", handles, 1, &settings, NULL) &&
              settings_bonds(&settings)->energy_given);
    ck_assert(!scenario_load_with("notched-beam", handles, 2, &settings, &status));
    /* of several values of a row the one that is wrong, and no line that is merely named */
    Override rows[] = {{"--set 1", "cuts.edge.x0", "7"}, {"--set 2", "cuts.edge.y1", "0.01"}};
    ck_assert(!scenario_load_with("pulled-plate", rows, 2, &settings, &status));
    ck_assert_str_eq(status.text, "--set 1: cuts.edge: x0 = 7 is off the plate (0 to plate.length = 0.1)");
    rows[0] = (Override){"--probe", "probe.x", "1"};
    ck_assert(!scenario_load_with("pulled-plate", rows, 1, &settings, &status));
    ck_assert_str_eq(status.text, "--probe: probe.x = 1 is off the plate (0 to plate.length = 0.1)");
    rows[0] = (Override){"--from", "cuts.edge.x0", "0.05"};
    rows[1] = (Override){"--end", "time.end", "1e-5"};
    ck_assert(!scenario_load_with("pulled-plate", rows, 2, &settings, &status));
    ck_assert_str_eq(status.text, "--from: cuts.edge: has no length (two places: X0 Y0 X1 Y1)");
    ck_assert(!scenario_load("mode11", &settings, &status));
    ck_assert_str_eq(status.text, "mode11: no such scenario or file (did you mean mode1?)");
    ck_assert(!scenario_load("/", &settings, &status));
    ck_assert_str_eq(status.text, "/: cannot be read: Is a directory");
    ck_assert_int_eq(status.code, STATUS_USAGE);
}
END_TEST

#define BAR     "[scenario]\nproblem = bar\n"
#define NOTCHED "[scenario]\nproblem = notched-beam\n"
#define X10     "xxxxxxxxxx"
#define X100    X10 X10 X10 X10 X10 X10 X10 X10 X10 X10

/* Kinds of damage and the line that each is answered with. */
static const struct {
    const char *text, *message;
} damages[] = {
    {"", "f.ini:1: holds no scenario (at least [scenario] and a key)"},
    {"# nothing\n\n", "f.ini:1: holds no scenario (at least [scenario] and a key)"},
    {"[scenario]\n", "f.ini:1: holds no scenario (at least [scenario] and a key)"},
    {"problem = bar\n", "f.ini:1: problem: is before any section (begin with [scenario])"},
    {"[scenario]\nproblem = beem\n",
     "f.ini:2: scenario.problem: beem is not a choice (bar | simply-supported-beam | moving-cantilever | "
     "notched-beam | plate | one-particle | hanging-column | bodies)"},
    {"[scenario]\nproblem =\n",
     "f.ini:2: scenario.problem:  is not a choice (bar | simply-supported-beam | moving-cantilever | "
     "notched-beam | plate | one-particle | hanging-column | bodies)"},
    {BAR "method = fem\n", "f.ini:3: scenario.method: fem is not a choice (mpm | pd)"},
    {"[scenario]\nproblem = notched-beam\nmethod = mpm\n",
     "f.ini:3: scenario.method: mpm cannot solve problem notched-beam: by it nothing breaks (pd)"},
    {BAR "method = pd\n[mpm]\nalgorithm = usl\n",
     "f.ini:5: mpm.algorithm: is not a parameter of method pd (only of mpm)"},
    {BAR "[pd]\nhorizon = 2\n", "f.ini:4: pd.horizon: is not a parameter of method mpm (only of pd)"},
    {BAR "method = pd\n[pd]\nspacing = 0.7\n",
     "f.ini:5: pd.spacing: the length 25 is 35.7143 spacings of 0.7 (a whole number, at most 2000000)"},
    {BAR "method = pd\n[pd]\nsurface_correction = volume\n",
     "f.ini:5: pd.surface_correction: volume is for beams (none | energy)"},
    {BAR "method = pd\n[pd]\ncritical_stretch = 0.1\n",
     "f.ini:5: pd.critical_stretch: is not a parameter of problem bar (only of simply-supported-beam, "
     "moving-cantilever, notched-beam, plate)"},
    {BAR "[duel]\nscenario.method = pd\npd.horizon = 0.2\n",
     "f.ini:5: duel: pd.horizon: 0.2 is below the spacing (at least pd.spacing = 0.5)"},
    {BAR "\n[mseh]\n", "f.ini:4: [mseh]: unknown section (did you mean [mesh]?)"},
    {BAR "[zebra]\n[mesh]\n", "f.ini:3: [zebra]: unknown section (see: man 5 matvib)"},
    {BAR "[]\n", "f.ini:3: []: unknown section (see: man 5 matvib)"},
    {BAR "[mesh\n", "f.ini:3: a section's line must be its name in brackets (such as [mesh])"},
    {BAR "[mesh] cell_size = 1\n", "f.ini:3: a section's line must be its name in brackets (such as [mesh])"},
    {BAR "[mesh]\ncell_size\n",
     "f.ini:4: this is not a line of a scenario ([SECTION], KEY = VALUE or # comment)"},
    {BAR "[mesh]\ncell_size: 1\n",
     "f.ini:4: this is not a line of a scenario ([SECTION], KEY = VALUE or # comment)"},
    {BAR "[mesh]\n= 1\n", "f.ini:4: this is not a line of a scenario ([SECTION], KEY = VALUE or # comment)"},
    {BAR "[mesh]\ncell size = 1\n",
     "f.ini:4: this is not a line of a scenario ([SECTION], KEY = VALUE or # comment)"},
    {BAR "[mesh]\n\xd0\xba = 1\n",
     "f.ini:4: this is not a line of a scenario ([SECTION], KEY = VALUE or # comment)"},
    {BAR "[mesh]\ncell_size =\n", "f.ini:4: mesh.cell_size: has no value (> 0)"},
    {BAR "[mesh]\ncell_size = ; 1\n", "f.ini:4: mesh.cell_size: has no value (> 0)"},
    {BAR "[mesh]\ncell_size =#1\n",
     "f.ini:4: cell_size: the value begins like a comment (a space before # or ; makes it one)"},
    {BAR "[mesh]\ncell_size = 1 2\n", "f.ini:4: mesh.cell_size: 1 2 is not a number (> 0)"},
    {BAR "[mesh]\ncell_size = 0,5\n", "f.ini:4: mesh.cell_size: 0,5 is not a number (> 0)"},
    {BAR "[mesh]\ncell_size = 0x1p3\n",
     "f.ini:4: mesh.cell_size: 0x1p3 cannot be read: no unit x1p3 here (> 0)"},
    {BAR "[mesh]\ncell_size = inf\n", "f.ini:4: mesh.cell_size: inf is not a number (> 0)"},
    {BAR "[mesh]\ncell_size = 1e999\n", "f.ini:4: mesh.cell_size: 1e999 is not a number (> 0)"},
    {BAR "[mesh]\ncell_size = -1\n", "f.ini:4: mesh.cell_size: -1 is out of range (> 0)"},
    {BAR "[mesh]\npadding = 1e9\n", "f.ini:4: mesh.padding: 1e9 is out of range (0 to 1000000)"},
    {BAR "[mesh]\nparticles_per_cell = 2.5\n",
     "f.ini:4: mesh.particles_per_cell: 2.5 is not a whole number (1 to 8)"},
    {BAR "[mesh]\ncell_size = 1\n\ncell_size = 2\n",
     "f.ini:6: mesh.cell_size: is given twice (first in line 4)"},
    {BAR "[mesh]\ncell_size = 1\n[time]\nend = 5\n[mesh]\ncell_size = 1\n",
     "f.ini:8: mesh.cell_size: is given twice (first in line 4)"},
    {BAR "[mesh]\n  cell_size = 0.5\n", "f.ini:4: cell_size: is indented (keys begin in the first column)"},
    {BAR "about = one\n  mode = 5\n", "f.ini:4: mode: is indented (keys begin in the first column)"},
    {BAR "[mesh]\ncell_size = 1\n  0\n",
     "f.ini:5: the indented line continues nothing (only scenario.about, initial.overtones and output.at go "
     "on in the next line)"},
    {BAR " [mesh]\n",
     "f.ini:3: the indented line continues nothing (only scenario.about, initial.overtones and output.at go "
     "on in the next line)"},
    {BAR "title = " X100 X100 "\n", "f.ini:3: the line is too long (at most 190 bytes)"},
    {BAR "title = " X100 "\n", "f.ini:3: scenario.title: is 100 bytes long (at most 79)"},
    {BAR "# " X100 X100 X100 X100 X100 X100 X100 X100 X100 X100 "\n",
     "f.ini:3: the line is too long (at most 1000 bytes)"},
    {BAR "title = caf\xe9\n", "f.ini:3: bytes that are not text (UTF-8 without control characters)"},
    {BAR "# caf\xe9\n", "f.ini:3: bytes that are not text (UTF-8 without control characters)"},
    {BAR "title = \x1b[2J\n", "f.ini:3: bytes that are not text (UTF-8 without control characters)"},
    {"[scenario]\rproblem = bar\r", "f.ini:1: bytes that are not text (UTF-8 without control characters)"},
    {BAR "[mesh]\ncellsize = 1\n", "f.ini:4: mesh.cellsize: unknown key (did you mean mesh.cell_size?)"},
    {BAR "[bar]\ncell_size = 1\n", "f.ini:4: bar.cell_size: unknown key (did you mean mesh.cell_size?)"},
    {BAR "[mesh]\nzebra = 1\n", "f.ini:4: mesh.zebra: unknown key (see: matvib params bar)"},
    {BAR "[mesh]\n" X100 " = 1\n",
     "f.ini:4: xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx: unknown key (no key is that "
     "long)"},
    {BAR "[notch]\ndepth = 0.1\n",
     "f.ini:4: notch.depth: is not a parameter of problem bar (only of notched-beam)"},
    {BAR "[mpm]\nalgorithm = USF\n", "f.ini:4: mpm.algorithm: USF is not a choice (usf | usl | musl)"},
    {BAR "[mesh]\ncell_size = 0.7\n",
     "f.ini:4: mesh.cell_size: the length 25 must be a whole number of cells, not 35.71428571"},
    {BAR "[time]\nend = 1\n[bar]\nlength = 25.5\n",
     "f.ini:6: mesh.cell_size: the length 25.5 must be a whole number of cells, not 25.5"},
    {BAR "[initial]\nmode = 0\n",
     "f.ini:4: initial.mode: 0 is rigid motion, which a held bar has not (1 or more, or bar.supports = "
     "free-free)"},
    {BAR "[initial]\nmode = 51\n",
     "f.ini:4: initial.mode: 51 is finer than the particles can show (at most 50, their number)"},
    {BAR "[initial]\novertones = 3-0.1\n",
     "f.ini:4: initial.overtones: \"3-0.1\" cannot be read (mode:velocity,... such as 3:0.03,7:0.01)"},
    {BAR "[output]\nat = 3,2\n", "f.ini:4: output.at: 2 does not come after 3 (ascending)"},
    {BAR "[output]\nat = 1\nframes = 3\n", "f.ini:4: output.at: output.frames is given too (one of them)"},
    {BAR "[output]\nevery = 0\n", "f.ini:4: output.every: 0 is out of range (1 to 1000000000)"},
    {BAR "[question]\nkey = bar.length\n", "f.ini:4: question.key: bar.length cannot be toggled (a key of "
                                           "problem bar that has choices, or a size)"},
    {BAR "[duel]\nmpm.algorithm = usx\n",
     "f.ini:4: duel: mpm.algorithm: usx is not a choice (usf | usl | musl)"},
    {BAR "[duel]\nmpm.algoritm = usl\n",
     "f.ini:4: duel: mpm.algoritm: unknown key (did you mean mpm.algorithm?)"},
    {BAR "[time]\nend=1\n[duel]\nmesh.cell_size = 0.7\n[view]\nupper=1\n",
     "f.ini:6: duel: mesh.cell_size: the length 25 must be a whole number of cells, not 35.71428571"},
    {BAR "[changes]\nsoon = mpm.algorithm=usl\n",
     "f.ini:4: changes.soon: is not a step (STEP = KEY=VALUE, STEP >= 0)"},
    {BAR "[changes]\n-5 = mpm.algorithm=usl\n",
     "f.ini:4: changes.-5: is not a step (STEP = KEY=VALUE, STEP >= 0)"},
    {BAR "[changes]\n5 = usl\n", "f.ini:4: changes.5: \"usl\" changes nothing (STEP = KEY=VALUE)"},
    {BAR "[changes]\n5 = mesh.cell_size=0.5\n",
     "f.ini:4: changes.5: mesh.cell_size: cannot change in mid-run (see: matvib params bar, marked live)"},
    {BAR "[changes]\n5 = mpm.algorithm=usx\n",
     "f.ini:4: changes.5: mpm.algorithm: usx is not a choice (usf | usl | musl)"},
    {BAR "[changes]\n5 = mpm.algorithm=usl\n5 = mpm.algorithm = usf\n",
     "f.ini:5: changes.5: is given twice (first in line 4)"},
    {NOTCHED "[pd]\ncritical_stretch = 0.001\ncritical_energy = 30\n",
     "f.ini:5: pd.critical_energy: pd.critical_stretch is given in line 4 and says the same (one of them)"},
    {NOTCHED "[pd]\nhorizon = 1e-4\n",
     "f.ini:4: pd.horizon: 0.0001 is below the spacing (at least pd.spacing = 0.0005)"},
    {NOTCHED "[pd]\nspacing = 3e-3\n",
     "f.ini:4: pd.horizon: 0.002 is below the spacing (at least pd.spacing = 0.003)"},
    {NOTCHED "[notch]\nposition = 0.3\n",
     "f.ini:4: notch.position: 0.3 is outside the beam (between 0 and beam.length = 0.21)"},
    {NOTCHED "[load]\nposition = 0.21\n",
     "f.ini:4: load.position: the load from 0.2085 to 0.2115 is off the beam (0 to beam.length = 0.21)"},
    {NOTCHED "[supports]\nright = 0.3\n",
     "f.ini:4: supports.right: 0.3 is off the beam (at most beam.length = 0.21)"},
    {NOTCHED "[supports]\npinned = 1\n", "f.ini:4: supports.pinned: 1 is not a choice (no | yes)"},
    {"[scenario]\nproblem = moving-cantilever\n[time]\nend = 0.01\n",
     "f.ini:4: motion.channel: 0.055 is too short for time.end (more than motion.speed * time.end = 0.1)"},
};

START_TEST(damage_is_answered_with_one_line)
{
    Settings settings, before;
    memset(&settings, 7, sizeof settings);
    before = settings;
    Status status = {0};
    const char *text = damages[_i].text;
    ck_assert_msg(!read_bytes(*text ? text : "\n", *text ? strlen(text) : 1, &settings, &status),
                  "accepted: %s", text);
    ck_assert_str_eq(status.text, damages[_i].message);
    ck_assert_int_eq(status.code, STATUS_USAGE);
    ck_assert_msg(memcmp(&settings, &before, sizeof before) == 0, "the settings were touched");
}
END_TEST

START_TEST(damage_that_no_string_can_hold)
{
    Settings settings;
    Status status;
    static const char nul[] = "[scenario]\nproblem = b\0ar\n";
    ck_assert(!read_bytes(nul, sizeof nul - 1, &settings, &status));
    ck_assert_str_eq(status.text, "f.ini:2: holds a zero byte (text is expected)");
    size_t lines = 6000;
    char *many = malloc(2 * lines + 1);
    for (size_t i = 0; i < lines; i++)
        memcpy(many + 2 * i, "#\n", 2);
    ck_assert(!read_bytes(many, 2 * lines, &settings, &status));
    ck_assert_str_eq(status.text, "f.ini:5001: too many lines for a scenario (at most 5000)");
    free(many);
}
END_TEST

/* A file cut anywhere is read or refused, never worse; so is one with any byte replaced. */
START_TEST(mutilated_files_do_no_harm)
{
    const char *text = builtin_scenarios[5].text;
    size_t size = strlen(text);
    char *copy = malloc(size);
    int refused = 0;
    for (size_t i = 1; i < size; i++) {
        Settings settings;
        Status status = {0};
        memcpy(copy, text, size);
        refused += !read_bytes(copy, i, &settings, &status);
        for (unsigned k = 0; k < 6; k++) {
            copy[i] = "\0\n[= \xff"[k];
            if (!read_bytes(copy, size, &settings, &status)) {
                refused++;
                ck_assert(strncmp(status.text, "f.ini:", 6) == 0);
            }
        }
    }
    ck_assert_int_gt(refused, 1000);
    free(copy);
}
END_TEST

typedef struct Taken {
    char keys[8][40], values[8][256];
    Override overrides[8];
    int count;
} Taken;

static void take(void *context, const char *key, const char *value)
{
    Taken *taken = context;
    ck_assert_int_lt(taken->count, 8);
    const int n = taken->count++;
    snprintf(taken->keys[n], sizeof taken->keys[n], "%s", key);
    snprintf(taken->values[n], sizeof taken->values[n], "%s", value);
    taken->overrides[n] = (Override){"--set", taken->keys[n], taken->values[n]};
}

/* A scenario with some values changed is the same again by what is told of it. */
START_TEST(what_was_changed_is_told)
{
    static const struct {
        const char *scenario;
        const char *changes[3][2]; /* ended by NULL */
        int count;
    } cases[] = {{"mode5", {{NULL}}, 0},
                 {"mode5", {{"mesh.cell_size", "0.5"}, {"mpm.algorithm", "musl"}}, 2},
                 {"mode5", {{"scenario.method", "pd"}, {"initial.mode", "3"}}, 2},
                 {"notched-beam-coarse", {{"pd.critical_energy", "50"}}, 1},
                 {"branching-coarse", {{"cuts.notch", "none"}, {"cuts.other", "0 0.02 0.05 0.02"}}, 2},
                 {"branching-coarse", {{"probe.x", "0.03"}, {"probe.y", "0.01"}}, 2},
                 {"two-discs", {{"contact.gap", "0.3"}, {"contact.friction", "0.2"}}, 2}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Settings changed, again;
        Status status = {0};
        Override overrides[3];
        int count = 0;
        for (; count < 3 && cases[i].changes[count][0]; count++)
            overrides[count] = (Override){"--set", cases[i].changes[count][0], cases[i].changes[count][1]};
        ck_assert_msg(scenario_load_with(cases[i].scenario, overrides, count, &changed, &status), "%s",
                      status.text);
        Taken taken = {.count = 0};
        ck_assert(scenario_assignments(cases[i].scenario, &changed, take, &taken));
        ck_assert_msg(taken.count == cases[i].count, "%s: %d", cases[i].scenario, taken.count);
        ck_assert_msg(scenario_load_with(cases[i].scenario, taken.overrides, taken.count, &again, &status),
                      "%s", status.text);
        ck_assert(settings_same(&changed, &again));
    }
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *good = tcase_create("read and write");
    tcase_add_test(good, builtins_are_sound_and_read_back);
    tcase_add_test(good, a_file_is_read);
    tcase_add_test(good, every_text_reads_back_or_is_refused);
    tcase_add_test(good, overrides_stand_above_the_file);
    tcase_add_test(good, what_was_changed_is_told);
    suite_add_tcase(suite, good);
    TCase *bad = tcase_create("damage");
    tcase_add_loop_test(bad, damage_is_answered_with_one_line, 0, (int)(sizeof damages / sizeof *damages));
    tcase_add_test(bad, damage_that_no_string_can_hold);
    tcase_add_test(bad, mutilated_files_do_no_harm);
    suite_add_tcase(suite, bad);
}
