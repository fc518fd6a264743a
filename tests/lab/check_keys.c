/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bytes become the keys that were meant, whatever terminal sent them, and nothing that was not meant. */
#include "suite.h"
#include "help/command.h"
#include "lab/prompt/prompt.h"
#include "terminal/keys.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static size_t add_keys(char *out, size_t size, size_t length, KeyReader *reader, double now)
{
    Key key;
    while (keys_next(reader, &key) || keys_silence(reader, now, &key)) {
        ck_assert(key.name[0] != '\0' && strlen(key.name) < KEY_NAME_MAX);
        length += (size_t)snprintf(out + length, size - length, "%s%s", length ? " " : "", key.name);
    }
    return length;
}

/* The names of all keys that these bytes are, separated by spaces: all at once, and a long silence behind. */
static const char *decode_bytes(const char *bytes, size_t count)
{
    static char out[4096];
    KeyReader reader;
    out[0] = '\0';
    keys_open(&reader, NULL);
    keys_feed(&reader, bytes, count, 0);
    add_keys(out, sizeof out, 0, &reader, 60);
    return out;
}

static void expect(const char *bytes, const char *names)
{
    ck_assert_msg(strcmp(decode_bytes(bytes, strlen(bytes)), names) == 0, "Esc%s: '%s', not '%s'", bytes + 1,
                  decode_bytes(bytes, strlen(bytes)), names);
}

START_TEST(printing_characters_name_themselves)
{
    expect("q?:1~", "q ? : 1 ~");
    expect(" a", "Space a");
    expect("Ωé", "Ω é");
    expect("⠿🙂", "⠿ 🙂");
}
END_TEST

START_TEST(controls_have_names)
{
    expect("\r\n\t\x7f\x08", "Enter Enter Tab Backspace Backspace");
    expect("\x03\x0c\x1a\x12", "^C ^L ^Z ^R");
    ck_assert_str_eq(decode_bytes("\0", 1), "^@");
}
END_TEST

/* What terminals send for the keys that the laboratory uses, with the keypad modes that it switches on. */
static const struct {
    const char *terminal;
    const char *arrows, *home_end, *pages, *f1_f10, *back_tab, *delete, *backspace, *mouse;
} terminals[] = {
    {"xterm, Windows Terminal, most others", "\033OA\033OB\033OC\033OD", "\033OH\033OF", "\033[5~\033[6~",
     "\033OP\033[21~", "\033[Z", "\033[3~", "\x7f", "\033[<0;3;2M\033[<0;3;2m"},
    {"xterm without the keypad's mode", "\033[A\033[B\033[C\033[D", "\033[H\033[F", "\033[5~\033[6~",
     "\033OP\033[21~", "\033[Z", "\033[3~", "\x7f", "\033[<0;3;2M\033[<0;3;2m"},
    {"PuTTY", "\033OA\033OB\033OC\033OD", "\033[1~\033[4~", "\033[5~\033[6~", "\033[11~\033[21~", "\033[Z",
     "\033[3~", "\x7f", "\033[<0;3;2M\033[<0;3;2m"},
    {"PuTTY, function keys as the Linux console", "\033OA\033OB\033OC\033OD", "\033[1~\033[4~",
     "\033[5~\033[6~", "\033[[A\033[21~", "\033[Z", "\033[3~", "\x08", "\033[<0;3;2M\033[<0;3;2m"},
    {"macOS Terminal", "\033OA\033OB\033OC\033OD", "\033OH\033OF", "\033[5~\033[6~", "\033OP\033[21~",
     "\033[Z", "\033[3~", "\x7f", "\033[<0;3;2M\033[<0;3;2m"},
    {"Linux console", "\033[A\033[B\033[C\033[D", "\033[1~\033[4~", "\033[5~\033[6~", "\033[[A\033[21~",
     "\033\t", "\033[3~", "\x7f", NULL},
    {"screen", "\033OA\033OB\033OC\033OD", "\033[1~\033[4~", "\033[5~\033[6~", "\033OP\033[21~", "\033[Z",
     "\033[3~", "\x7f", "\033[<0;3;2M\033[<0;3;2m"},
    {"tmux", "\033OA\033OB\033OC\033OD", "\033[1~\033[4~", "\033[5~\033[6~", "\033OP\033[21~", "\033[Z",
     "\033[3~", "\x7f", "\033[<0;3;2M\033[<0;3;2m"},
    {"rxvt", "\033OA\033OB\033OC\033OD", "\033[7~\033[8~", "\033[5~\033[6~", "\033[11~\033[21~", "\033[Z",
     "\033[3~", "\x7f", "\033[<0;3;2M\033[<0;3;2m"},
};

START_TEST(named_keys_of_many_terminals)
{
    for (size_t i = 0; i < sizeof terminals / sizeof *terminals; i++) {
        expect(terminals[i].arrows, "Up Down Right Left");
        expect(terminals[i].home_end, "Home End");
        expect(terminals[i].pages, "PageUp PageDown");
        expect(terminals[i].f1_f10, "F1 F10");
        expect(terminals[i].back_tab, "S-Tab");
        expect(terminals[i].delete, "Delete");
        expect(terminals[i].backspace, "Backspace");
        if (terminals[i].mouse)
            expect(terminals[i].mouse, "Click");
    }
    expect("\033[2~", "Insert");
    expect("\033OP\033OS\033[15~\033[24~", "F1 F4 F5 F12");
    expect("\033[[E", "F5");
}
END_TEST

/* PuTTY sends these with NumLock as well. */
START_TEST(the_keypad_means_what_is_printed_on_it)
{
    expect("\033Op\033Oq\033Oy\033On", "0 1 9 .");
    expect("\033Ok\033Om\033Oj\033Oo\033OX", "+ - * / =");
    expect("\033OM", "Enter");
    expect("\033Oz", "");
}
END_TEST

START_TEST(modifiers_are_told)
{
    expect("\033[1;5C", "C-Right");
    expect("\033[1;2A", "S-Up");
    expect("\033[3;3~", "M-Delete");
    expect("\033[7$\033[7^", "S-Home C-Home");
    expect("\033x", "M-x");
    expect("\033b\033f", "M-b M-f"); /* macOS Terminal's Option with Left and Right */
    expect("\033\033[A", "M-Up");
}
END_TEST

START_TEST(escape_stands_alone_after_silence)
{
    expect("\033", "Esc");
    expect("\033\033", "Esc Esc");
    expect("\033\033\033[A", "Esc M-Up");
}
END_TEST

START_TEST(what_is_pasted_is_no_key)
{
    expect("\033[200~r m\r\033[201~q", "P-r P-Space P-m P-Enter q");
    expect("\033[200~\xce\xa9q\xce\033[201~q", "P-Ω P-q q");
    /* what terminals and controls say inside means nothing */
    expect("\033[200~\033[A\001\033[20\033[201~q", "q");
    expect("\033[200~\033[200;1m1\033OPx\033x\033\033[201~q", "P-1 P-x q");
    expect("\033[200~\033[<0;3;2M\033[201~q", "q");
    ck_assert(keys_known("P-q") && keys_known("P-Space") && keys_known("P-Ω") && keys_known("P"));
    ck_assert(!keys_known("P-nonsense"));
    ck_assert_str_eq(keys_pasted("P-Enter"), "Enter");
    ck_assert_ptr_null(keys_pasted("P"));
}
END_TEST

/* As a slow line brings them: byte by byte, `escape` seconds behind Esc and `gap` behind others, looked for
 * every 10 ms. */
static const char *decode_torn(const char *escdelay, const char *bytes, double escape, double gap)
{
    static char out[4096];
    KeyReader reader;
    double now = 0;
    size_t length = 0;
    out[0] = '\0';
    keys_open(&reader, escdelay);
    for (; *bytes; bytes++) {
        keys_feed(&reader, bytes, 1, now);
        const double next = now + (*bytes == '\033' ? escape : gap);
        for (; now < next - 0.005; now += 0.01)
            length = add_keys(out, sizeof out, length, &reader, now);
    }
    add_keys(out, sizeof out, length, &reader, now + 60);
    return out;
}

START_TEST(a_torn_sequence_is_still_one_key)
{
    static const char *const sequences[][2] = {
        {"\033[A\033[B\033OC\033[D", "Up Down Right Left"},
        {"\033[3~q", "Delete q"},
        {"\033[1;5C\033[7$", "C-Right S-Home"},
        {"\033[[A\033OP\033[15~", "F1 F1 F5"},
        {"\033\033[A", "M-Up"},
        {"\033x", "M-x"},
        {"\033[<0;12;5Mq", "Click q"},
        {"\033[M +%q", "Click q"},
        {"\033[I\033[O\033[99~q", "q"},
        {"\033]11;rgb:0/0/0\033\\q", "q"},
        {"\033[200~d\033[201~q", "P-d q"},
        {"\xe2\xa0\xbfq", "⠿ q"},
    };
    static const double escapes[] = {.01, .03, .08}, gaps[] = {.01, .03, .1, .3};
    for (size_t i = 0; i < sizeof sequences / sizeof *sequences; i++)
        for (size_t j = 0; j < sizeof escapes / sizeof *escapes; j++)
            for (size_t k = 0; k < sizeof gaps / sizeof *gaps; k++)
                ck_assert_str_eq(decode_torn(NULL, sequences[i][0], escapes[j], gaps[k]), sequences[i][1]);
}
END_TEST

/* ESCDELAY says how slow the line is, where it is a number of milliseconds. */
START_TEST(escape_waits_as_long_as_told)
{
    static const struct {
        const char *escdelay;
        double waits;
    } delays[] = {{NULL, .1}, {"", .1},     {"soon", .1}, {"99999999999999999999", .1},
                  {"-5", .1}, {"25", .025}, {"1000", 1},  {"0", 0}};
    for (size_t i = 0; i < sizeof delays / sizeof *delays; i++) {
        KeyReader reader;
        Key key;
        keys_open(&reader, delays[i].escdelay);
        ck_assert(isinf(keys_due(&reader)));
        keys_feed(&reader, "\033", 1, 5);
        ck_assert(!keys_next(&reader, &key));
        ck_assert_double_eq(keys_due(&reader), 5 + delays[i].waits);
        ck_assert(!keys_silence(&reader, 5 + .99 * delays[i].waits, &key) || delays[i].waits == 0);
        ck_assert(delays[i].waits == 0 || keys_silence(&reader, 5 + 1.01 * delays[i].waits, &key));
        ck_assert_str_eq(key.name, "Esc");
        ck_assert(isinf(keys_due(&reader)));
    }
    ck_assert_str_eq(decode_torn("1000", "\033[A", .9, .9), "Up");
    ck_assert_str_eq(decode_torn("3000", "\033[A", 2.9, 2.9), "Up");
}
END_TEST

static const struct {
    const char *beginning;
    double silence, most; /* s */
    long bytes;
} unfinished[] = {
    {"\033[1;", 1, 5, 70}, {"\033]2;title", 1, 5, 5000},  {"\033P", 1, 5, 5000}, {"\033_", 1, 5, 5000},
    {"\xe2\xa0", 1, 5, 5}, {"\033[200~", 5, 10, 2200000}, {"\033O", 1, 5, 140},  {"\033[M", 1, 5, 5},
};

/* What is cut short is waited for on a slow line, but not for ever: nor where bytes go on coming. */
START_TEST(what_is_cut_short_ends)
{
    KeyReader reader;
    Key key;
    const char *beginning = unfinished[_i].beginning;
    keys_open(&reader, NULL);
    keys_feed(&reader, beginning, strlen(beginning), 0);
    ck_assert(!keys_next(&reader, &key) && !keys_silence(&reader, .9 * unfinished[_i].silence, &key));
    ck_assert(isfinite(keys_due(&reader)));
    ck_assert(!keys_silence(&reader, 1.1 * unfinished[_i].silence, &key) && isinf(keys_due(&reader)));
    keys_feed(&reader, "5", 1, 10);
    ck_assert(keys_next(&reader, &key));
    ck_assert_str_eq(key.name, "5");
    /* a byte every 100 ms */
    double now = 20;
    keys_feed(&reader, beginning, strlen(beginning), now);
    do {
        ck_assert(!keys_next(&reader, &key) || strcmp(key.name, "P-5") == 0);
        now += 0.1;
        ck_assert_double_lt(now - 20, 1.05 * unfinished[_i].most);
        ck_assert(!keys_silence(&reader, now, &key));
        keys_feed(&reader, "5", 1, now);
    } while (isfinite(keys_due(&reader)) && !(keys_next(&reader, &key) && strcmp(key.name, "5") == 0));
    /* all at once */
    keys_open(&reader, NULL);
    keys_feed(&reader, beginning, strlen(beginning), 0);
    key.name[0] = '\0';
    for (long i = 0; strcmp(key.name, "5") != 0; i++) {
        ck_assert_int_lt(i, unfinished[_i].bytes);
        if (!keys_next(&reader, &key))
            keys_feed(&reader, "5", 1, 0);
    }
}
END_TEST

START_TEST(control_c_ends_what_is_cut_short)
{
    char bytes[64];
    for (int more = 0; more < 2; more++) {
        snprintf(bytes, sizeof bytes, "%s%s\003", unfinished[_i].beginning, more ? "555" : "");
        const char *names = decode_bytes(bytes, strlen(bytes));
        ck_assert_msg(strlen(names) >= 2 && strcmp(names + strlen(names) - 2, "^C") == 0, "%s", names);
    }
    KeyReader reader;
    Key key;
    keys_open(&reader, NULL);
    keys_feed(&reader, bytes, strlen(bytes), 0);
    while (keys_next(&reader, &key))
        continue;
    keys_feed(&reader, "q", 1, 0);
    ck_assert(keys_next(&reader, &key));
    ck_assert_str_eq(key.name, "q");
}
END_TEST

/* No rest of a paste becomes commands because a ^C stood in it. */
START_TEST(control_c_drops_what_came_with_it)
{
    expect("\033[200~one\003quit\r", "P-o P-n P-e ^C");
    expect("\033Pone\003quit\r", "^C");
    expect("\033\003q", "^C q");
}
END_TEST

START_TEST(a_report_swallows_no_escape)
{
    expect("\033\033[0nq", "Esc q"); /* the status of a terminal that has drawn a picture */
    expect("\033\033\033[0n", "Esc Esc");
    expect("\033\033[?2026;2$y", "Esc");
    expect("\033\033[<0;12;5M", "Esc Click");
    expect("\033\033[<35;12;5M", "Esc"); /* the mouse moved */
    expect("\033\033[A", "M-Up");
}
END_TEST

START_TEST(what_is_not_known_is_swallowed_whole)
{
    expect("\033[Iq\033[Oq", "q q"); /* focus in and out */
    expect("\033[99~q", "q");        /* a key that nobody has */
    expect("\033[1;2;3;4;5;6;7;8;9xq", "q");
    expect("\033[99999999999999999999~q", "q");
    expect("\033[?1;2cq", "q");                     /* the terminal says what it is */
    expect("\033[24;80Rq", "q");                    /* where the cursor is */
    expect("\033[?2026;2$yq", "q");                 /* what modes it has */
    expect("\033]11;rgb:0000/0000/0000\007q", "q"); /* its colour */
    expect("\033]11;rgb:0000/0000/0000\033\\q", "q");
    expect("\033P1$r0m\033\\q", "q");
    expect("\033[32;12;5Mq", "q"); /* rxvt's */
    expect("\033[27;5;65~q", "q"); /* xterm's modifyOtherKeys */
    expect("\033[97;5uq", "q");
    expect("\033[", ""); /* cut short */
    expect("\033[1;", "");
    expect("\033O", "");
    expect("\033]2;title", "");
}
END_TEST

START_TEST(a_cut_sequence_does_not_eat_the_next_key)
{
    expect("\033[9;\033[A", "Up");
    expect("\033[\r", "Enter");
    expect("\033[12\x03", "^C");
}
END_TEST

START_TEST(bad_utf8_is_dropped)
{
    expect("\xc3q", "q");
    expect("\xff\xfeq", "q");
    expect("\x80\xbfq", "q");
    expect("\xe2\xa0\033[A", "Up");
}
END_TEST

static void expect_place(const char *bytes, const char *name, int x, int y)
{
    KeyReader reader;
    Key key;
    keys_open(&reader, NULL);
    keys_feed(&reader, bytes, strlen(bytes), 0);
    ck_assert(keys_next(&reader, &key));
    ck_assert_str_eq(key.name, name);
    ck_assert_int_eq(key.x, x);
    ck_assert_int_eq(key.y, y);
}

START_TEST(mouse_reports_carry_a_place)
{
    expect_place("\033[<0;12;5M", "Click", 11, 4);
    expect_place("\033[<32;300;5M", "Drag", 299, 4);
    expect_place("\033[<4;12;5M", "Click", 11, 4); /* with Shift */
    expect_place("\033[M +%q", "Click", 10, 4);    /* of before SGR */
    expect("\033[M +%q", "Click q");
    expect("\033[M#+%q", "q"); /* released */
    expect("\033[<64;1;1M\033[<65;1;1M", "WheelUp WheelDown");
    expect("\033[<0;1;1M\033[<32;2;1M\033[<32;3;1M\033[<0;3;1m\033[<35;4;1M", "Click Drag Drag");
    expect("\033[<2;1;1M\033[<34;2;1M\033[<2;2;1m", ""); /* the other button */
    expect("\033[<35;1;1M\033[<0;0;0M", "");             /* moved; nowhere */
}
END_TEST

/* Whatever comes, a key has a name of sane length and silence leads back to the ground. */
START_TEST(noise_leads_nowhere)
{
    uint64_t random = 88172645463325252u;
    KeyReader reader;
    Key key;
    char out[4096];
    keys_open(&reader, NULL);
    for (int round = 0; round < 600; round++) {
        char noise[200];
        for (size_t i = 0; i < sizeof noise; i++) {
            random ^= random << 13, random ^= random >> 7, random ^= random << 17;
            noise[i] = (char)(random >> 20);
            if ((random >> 40) % 4 == 0)
                noise[i] = "\033[O<;~M0123]P\\\007"[(random >> 44) % 15];
        }
        keys_feed(&reader, noise, sizeof noise, 100 * round);
        add_keys(out, sizeof out, 0, &reader, 100 * round + 60);
        keys_feed(&reader, "q", 1, 100 * round + 70);
        ck_assert(keys_next(&reader, &key));
        ck_assert_str_eq(key.name, "q");
    }
}
END_TEST

/* Keys separated by spaces, on "12.5" with the cursor at its end. */
static void expect_line(const char *keys, bool fresh, const char *text, int cursor)
{
    char line[16] = "12.5", list[64];
    int at = 4;
    snprintf(list, sizeof list, "%s", keys);
    for (char *key = strtok(list, " "); key; key = strtok(NULL, " ")) {
        prompt_edit_line(line, sizeof line, &at, key, fresh);
        fresh = false;
    }
    ck_assert_str_eq(line, text);
    ck_assert_int_eq(at, cursor);
}

START_TEST(a_line_can_be_edited)
{
    expect_line("7", true, "7", 1);
    expect_line("7", false, "12.57", 5);
    expect_line("Left 7", true, "12.75", 4);
    expect_line("Backspace Backspace", true, "12", 2);
    expect_line("Home Delete", true, "2.5", 0);
    expect_line("^U 3", true, "3", 1);
    expect_line("Left ^K", true, "12.", 3);
    expect_line("Left Left Left Left Left x", true, "x12.5", 1);
    expect_line("Ω Space é", true, "Ω é", 3);
    expect_line("Ω é Left Backspace", true, "é", 0);
    expect_line("a Space b c ^W", true, "a ", 2);
    /* a line that is full takes no more, and never half a character */
    expect_line("1 2 3 4 5 6 7 8 9 0 1 2 3 4 Ω 5 6", true, "123456789012345", 15);
}
END_TEST

START_TEST(named_keys_are_no_text)
{
    char line[16] = "1";
    int at = 1;
    ck_assert(!prompt_edit_line(line, sizeof line, &at, "F1", false));
    ck_assert(!prompt_edit_line(line, sizeof line, &at, "M-x", false));
    ck_assert(!prompt_edit_line(line, sizeof line, &at, "Up", false));
    ck_assert_str_eq(line, "1");
}
END_TEST

/* Each command has a bit of its own. */
START_TEST(commands_used_are_told_apart)
{
    CommandSet set = {.words = {0}};
    for (int i = 0; i < n_commands; i++) {
        ck_assert_msg(!command_set_has(&set, commands[i].id), "%s", commands[i].name);
        command_set_add(&set, commands[i].id);
        ck_assert(command_set_has(&set, commands[i].id));
    }
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("keys");
    tcase_add_test(tcase, commands_used_are_told_apart);
    tcase_add_test(tcase, printing_characters_name_themselves);
    tcase_add_test(tcase, controls_have_names);
    tcase_add_test(tcase, named_keys_of_many_terminals);
    tcase_add_test(tcase, the_keypad_means_what_is_printed_on_it);
    tcase_add_test(tcase, modifiers_are_told);
    tcase_add_test(tcase, escape_stands_alone_after_silence);
    tcase_add_test(tcase, what_is_pasted_is_no_key);
    tcase_add_test(tcase, a_report_swallows_no_escape);
    tcase_add_test(tcase, what_is_not_known_is_swallowed_whole);
    tcase_add_test(tcase, a_cut_sequence_does_not_eat_the_next_key);
    tcase_add_test(tcase, bad_utf8_is_dropped);
    tcase_add_test(tcase, mouse_reports_carry_a_place);
    tcase_add_test(tcase, a_torn_sequence_is_still_one_key);
    tcase_add_test(tcase, escape_waits_as_long_as_told);
    tcase_add_loop_test(tcase, what_is_cut_short_ends, 0, (int)(sizeof unfinished / sizeof *unfinished));
    tcase_add_loop_test(tcase, control_c_ends_what_is_cut_short, 0,
                        (int)(sizeof unfinished / sizeof *unfinished));
    tcase_add_test(tcase, control_c_drops_what_came_with_it);
    tcase_add_test(tcase, noise_leads_nowhere);
    tcase_add_test(tcase, a_line_can_be_edited);
    tcase_add_test(tcase, named_keys_are_no_text);
    suite_add_tcase(suite, tcase);
}
