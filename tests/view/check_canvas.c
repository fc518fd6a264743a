/* A canvas keeps what is put on it, inside its bounds; commands are found by name and key. */
#include "suite.h"
#include "view/draw/canvas.h"
#include "view/panes/commands.h"

#include <stdlib.h>
#include <string.h>

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
    canvas_to_ascii(&canvas);
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
    ck_assert_int_eq(text_columns("Δε ≈ 1"), 6);
    canvas_close(&canvas);
}
END_TEST

START_TEST(scalars_survive_utf8)
{
    const uint32_t glyphs[] = {'A', 0x7f, 0xb2, 0x7ff, 0x800, 0x2800, 0xffff, 0x10000, 0x10ffff};
    for (size_t i = 0; i < sizeof glyphs / sizeof *glyphs; i++) {
        char bytes[5] = "";
        const char *here = bytes;
        size_t length = utf8_put(bytes, glyphs[i]);
        ck_assert_uint_eq(utf8_next(&here), glyphs[i]);
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
        ck_assert_msg(text_columns(command->brief) <= 8, "%s: %s", command->name, command->brief);
        ck_assert_msg(text_columns(command->help) <= 84, "%s: help is long", command->name);
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
    tcase_add_test(canvas, scalars_survive_utf8);
    suite_add_tcase(suite, canvas);
    TCase *table = tcase_create("commands");
    tcase_add_test(table, commands_are_unambiguous);
    suite_add_tcase(suite, table);
}
