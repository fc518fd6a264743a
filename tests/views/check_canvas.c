/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A canvas keeps what is put on it, inside its bounds; commands are found by name and key. */
#include "panes/panes.h"
#include "suite.h"
#include "picture/canvas.h"
#include "help/command.h"

#include <locale.h>
#include <stdlib.h>
#include <string.h>
#include <wchar.h>

static Canvas open_canvas(int width, int height)
{
    Canvas canvas = {0};
    ck_assert(canvas_open(&canvas, width, height, NULL));
    return canvas;
}

static void expect_dump(Canvas *canvas, const char *text)
{
    char *dump = canvas_dump(canvas);
    ck_assert_str_eq(dump, text);
    free(dump);
}

START_TEST(text_is_cut_with_an_ellipsis)
{
    Canvas canvas = open_canvas(8, 3);
    ck_assert_int_eq(canvas_text(&canvas, 0, 0, 4, "σ ← 1 + 2", STYLE_NORMAL), 4);
    ck_assert_int_eq(canvas_text(&canvas, 1, 1, 4, "abcd", STYLE_HEADING), 4);
    ck_assert_int_eq(canvas_text(&canvas, 6, 2, 9, "xyz", STYLE_NORMAL), 3);
    expect_dump(&canvas, "σ ←…\n abcd\n      xy\n");
    char *styles = canvas_dump_styles(&canvas);
    ck_assert_str_eq(styles, "........\n.HHHH...\n........\n");
    free(styles);
    canvas_to_ascii(&canvas, false);
    expect_dump(&canvas, "s <~\n abcd\n      xy\n");
    canvas_close(&canvas);
}
END_TEST

START_TEST(outside_nothing_happens)
{
    Canvas canvas = open_canvas(2, 2);
    for (int y = -3; y < 5; y++)
        for (int x = -3; x < 5; x++)
            canvas_put(&canvas, x, y, x < 0 || y < 0 || x > 1 || y > 1 ? 'X' : '.', STYLE_NORMAL);
    expect_dump(&canvas, "..\n..\n");
    ck_assert(canvas_open(&canvas, 3, 1, NULL));
    expect_dump(&canvas, "\n");
    canvas_close(&canvas);
}
END_TEST

START_TEST(bad_bytes_become_question_marks)
{
    Canvas canvas = open_canvas(12, 1);
    canvas_text(&canvas, 0, 0, 12, "a\xff\xc3(\xe2\x82z\x80\x1b[", STYLE_NORMAL);
    expect_dump(&canvas, "a?"
                         "?(?z? [\n");
    ck_assert_int_eq(glyphs_columns("Δε ≈ 1"), 6);
    canvas_close(&canvas);
}
END_TEST

/* Whatever reaches a cell, no terminal sees a byte of it that it would obey. */
START_TEST(no_control_reaches_a_cell)
{
    Canvas canvas = open_canvas(3, 1);
    for (uint32_t glyph = 1; glyph < 0x110000; glyph++) {
        char text[5] = "";
        glyph_put(text, glyph);
        canvas_put(&canvas, 0, 0, glyph, STYLE_NORMAL);
        canvas_text(&canvas, 1, 0, 1, text, STYLE_NORMAL);
        for (int x = 0; x < 2; x++) {
            const uint32_t shown = canvas.cells[x].glyph;
            const bool acts = shown < ' ' || (shown >= 0x7f && shown < 0xa0) ||
                              (shown >= 0xd800 && shown < 0xe000) || shown > CELL_FOLLOWS;
            ck_assert_msg(!acts, "U+%04X", glyph);
        }
    }
    canvas_close(&canvas);
}
END_TEST

/* What takes a cell or two here does so for the C library, or is unknown to it; what goes on top of another
 * character or has no width takes part in no row. */
START_TEST(every_cell_is_measured)
{
    ck_assert_ptr_nonnull(setlocale(LC_CTYPE, "C.UTF-8"));
    for (uint32_t glyph = 1; glyph < 0x110000; glyph++) {
        const int here = glyph_columns(glyph), there = wcwidth((wchar_t)glyph);
        if (here > 0 && there >= 0)
            ck_assert_msg(here == there, "U+%04X: %d, not %d", glyph, here, there);
        if (there == 0 || glyph < ' ')
            ck_assert_msg(here == 0, "U+%04X", glyph);
    }
    for (uint32_t glyph = 0x2500; glyph < 0x2900; glyph++) /* lines, blocks, braille */
        ck_assert(glyph_columns(glyph) == 1 || (glyph >= 0x25fd && glyph < 0x27c0));
}
END_TEST

START_TEST(wide_characters_keep_their_two_cells)
{
    Canvas canvas = open_canvas(6, 2);
    ck_assert_int_eq(glyphs_columns("梁x"), 3);
    ck_assert_int_eq(canvas_text(&canvas, 0, 0, 6, "梁の振", STYLE_NORMAL), 6);
    expect_dump(&canvas, "梁の振\n\n");
    canvas_put(&canvas, 1, 0, '!', STYLE_NORMAL); /* the second half */
    canvas_put(&canvas, 4, 0, '!', STYLE_NORMAL); /* the first */
    expect_dump(&canvas, " !の!\n\n");
    canvas_put(&canvas, 1, 0, 0x6881, STYLE_NORMAL); /* over one and a half */
    expect_dump(&canvas, " 梁 !\n\n");
    canvas_clear(&canvas);
    canvas_put(&canvas, 5, 0, 0x6881, STYLE_NORMAL); /* no room, and not in the next row */
    expect_dump(&canvas, "     ?\n\n");
    canvas_clear(&canvas);
    ck_assert_int_eq(canvas_text(&canvas, 0, 0, 4, "梁の振", STYLE_NORMAL), 3);
    ck_assert_int_eq(canvas_text(&canvas, 0, 1, 4, "a梁の", STYLE_NORMAL), 4);
    expect_dump(&canvas, "梁…\na梁…\n");
    canvas_clear(&canvas);
    ck_assert_int_eq(canvas_text(&canvas, 0, 0, 6, "e\xcc\x81x", STYLE_NORMAL), 3);
    expect_dump(&canvas, "e?x\n\n");
    canvas_close(&canvas);
}
END_TEST

START_TEST(scalars_survive_utf8)
{
    const uint32_t glyphs[] = {'A', 0x7f, 0xb2, 0x7ff, 0x800, 0x2800, 0xffff, 0x10000, 0x10ffff};
    for (size_t i = 0; i < sizeof glyphs / sizeof *glyphs; i++) {
        char bytes[5] = "";
        const char *here = bytes;
        size_t length = glyph_put(bytes, glyphs[i]);
        ck_assert_uint_eq(glyph_next(&here), glyphs[i]);
        ck_assert_ptr_eq(here, bytes + length);
    }
}
END_TEST

START_TEST(commands_are_unambiguous)
{
    for (int i = 0; i < n_commands; i++) {
        const Command *command = &commands[i];
        ck_assert_ptr_eq(command_find(command->id), command);
        ck_assert_ptr_eq(command_by_name(command->name), command);
        ck_assert_msg(glyphs_columns(pane_command_brief(command)) <= 8, "%s: %s", command->name,
                      pane_command_brief(command));
        ck_assert_msg(glyphs_columns(pane_command_help(command)) <= 84, "%s: help is long", command->name);
        char keys[64];
        ck_assert_uint_lt(strlen(command->keys), sizeof keys);
        strcpy(keys, command->keys);
        for (char *key = strtok(keys, " "); key; key = strtok(NULL, " "))
            ck_assert_msg(command_by_key(key) == command, "key %s belongs to two commands", key);
    }
    ck_assert_ptr_null(command_by_key(""));
    ck_assert_ptr_null(command_by_key(" "));
    ck_assert_ptr_null(command_by_key("] s"));
    ck_assert_ptr_null(command_by_name("no such"));
    ck_assert_ptr_eq(command_by_key("s"), command_find(COMMAND_STAGE_FORWARD));
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *canvas = tcase_create("canvas");
    tcase_add_test(canvas, text_is_cut_with_an_ellipsis);
    tcase_add_test(canvas, outside_nothing_happens);
    tcase_add_test(canvas, bad_bytes_become_question_marks);
    tcase_add_test(canvas, no_control_reaches_a_cell);
    tcase_add_test(canvas, every_cell_is_measured);
    tcase_add_test(canvas, wide_characters_keep_their_two_cells);
    tcase_add_test(canvas, scalars_survive_utf8);
    suite_add_tcase(suite, canvas);
    TCase *table = tcase_create("commands");
    tcase_add_test(table, commands_are_unambiguous);
    suite_add_tcase(suite, table);
}
