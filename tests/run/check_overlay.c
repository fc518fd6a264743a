/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Foreign tables: every dialect reads to the same numbers, what is no table is refused with file and line. */
#include "run/overlay.h"
#include "suite.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static bool read_bytes(Overlay *overlay, const char *bytes, size_t size, Status *status)
{
    FILE *stream = tmpfile();
    ck_assert_ptr_nonnull(stream);
    ck_assert_uint_eq(fwrite(bytes, 1, size, stream), size);
    rewind(stream);
    *status = (Status){STATUS_DONE, ""};
    const bool sound = overlay_read(overlay, stream, "dir/student.csv", NULL, NULL, NULL, status);
    fclose(stream);
    return sound;
}

static bool read_text(Overlay *overlay, const char *text, Status *status)
{
    return read_bytes(overlay, text, strlen(text), status);
}

/* --- dialects ------------------------------------------------------------------------------------- */

static const char *const same_tables[] = {
    "time,v_cm\n0,0.5\n0.25,-1.5\n1e1,2\n",
    "time,v_cm\r\n0,0.5\r\n0.25,-1.5\r\n1e1,2\r\n",
    "time,v_cm\r0,0.5\r0.25,-1.5\r1e1,2\r",
    "time,v_cm\n0,0.5\n0.25,-1.5\n1e1,2",
    "\xef\xbb\xbftime;v_cm\r\n0;0,5\r\n0,25;-1,5\r\n1e1;2\r\n",
    "time;v_cm\n0;0.5\n0.25;-1.5\n1e1;2\n",
    "time\tv_cm\n0\t0,5\n0.25\t-1.5\n1e1\t2\n",
    "# measured in May\n\n \"time\" ; \"v_cm\" \n0; \"0,5\"\n\n0,25;-1,5 \n# end\n 1e1 ;2\n;\n",
    "V_cm;Time\n0,5;0\n-1,5;0,25\n2;10\n",
    "v_cm,time\n-1.5,0.25\n7,\n7,NaN\n2,10\n0.5,0\n",
    "time,\"v_cm\"\n0,.5\n+2.5E-1,-15e-1\n10,2e0\n",
};

START_TEST(every_dialect_reads_to_the_same)
{
    Overlay overlay;
    Status status;
    ck_assert_msg(read_text(&overlay, same_tables[_i], &status), "%s", status.text);
    ck_assert_msg(overlay_choose(&overlay, NULL, NULL, "v_cm", "u", &status), "%s", status.text);
    static const double x[] = {0, 0.25, 10}, y[] = {0.5, -1.5, 2};
    const int column = overlay_column_for(&overlay, "v_cm", false);
    ck_assert_int_ge(column, 0);
    ck_assert_uint_eq(overlay.count, 3);
    ck_assert(!overlay.along);
    ck_assert_str_eq(overlay.file, "student.csv");
    for (int i = 0; i < 3; i++) {
        ck_assert_double_eq(overlay.columns[overlay.x].values[i], x[i]);
        ck_assert_double_eq(overlay.columns[column].values[i], y[i]);
    }
    ck_assert_double_eq(overlay.columns[column].least, -1.5);
    ck_assert_int_eq(overlay_column_for(&overlay, "x_cm", false), -1);
    ck_assert_int_eq(overlay_column_for(&overlay, "v_cm", true), -1);
    overlay_close(&overlay);
}
END_TEST

START_TEST(a_table_without_names_goes_by_numbers)
{
    Overlay overlay;
    Status status;
    ck_assert(read_text(&overlay, "0;1,5;3\n1;2,5;\n2;3,5;5\n", &status));
    ck_assert(!overlay_choose(&overlay, NULL, NULL, "v_cm", "u", &status));
    ck_assert_ptr_nonnull(strstr(status.text, "which of its 3 columns?"));
    ck_assert(overlay_choose(&overlay, NULL, "3", "v_cm", "u", &status));
    ck_assert_int_eq(overlay_column_for(&overlay, "v_cm", false), 2);
    ck_assert_int_eq(overlay_column_for(&overlay, "total", false), -1); /* it was given to v_cm */
    ck_assert(isnan(overlay.columns[2].values[1]));
    ck_assert_double_eq(overlay.columns[2].largest, 5);
    ck_assert(overlay_choose(&overlay, "2", "1", "v_cm", "u", &status));
    ck_assert_int_eq(overlay.x, 1);
    ck_assert(!overlay_choose(&overlay, "4", "1", "v_cm", "u", &status));
    ck_assert_str_eq(status.text, "student.csv:1: no column 4 (1 to 3)");
    overlay_close(&overlay);
    ck_assert(read_text(&overlay, "0,1\n1,2\n", &status)); /* of two columns the other one is meant */
    ck_assert(overlay_choose(&overlay, NULL, NULL, "v_cm", "u", &status));
    ck_assert_int_eq(overlay_column_for(&overlay, "v_cm", false), 1);
    overlay_close(&overlay);
}
END_TEST

/* How exactly numbers are written; a power without end is no number of places. */
START_TEST(digits_are_counted_as_written)
{
    static const char *const text = "t,a,b,c,d\n0,0.0120,1.5e3,0e-99999999999,0e4294967295\n";
    static const struct {
        int digits, places;
    } wanted[] = {{0, 0}, {3, 4}, {2, -2}, {0, 400}, {0, -400}};
    Overlay overlay;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(read_text(&overlay, text, &status), "%s", status.text);
    for (int i = 1; i < overlay.n_columns; i++) {
        ck_assert_int_eq(overlay.columns[i].digits, wanted[i].digits);
        ck_assert_int_eq(overlay.columns[i].places, wanted[i].places);
    }
    overlay_close(&overlay);
}
END_TEST

/* Double precision as Fortran writes it, and what Windows and C print where nothing finite comes out. */
START_TEST(numbers_of_other_programs)
{
    static const char *const none[] = {"-nan(ind)", "1.#INF", "-1.#IND00", "1.#QNAN",
                                       "Infinity",  "-inf",   "NaN"};
    Overlay overlay;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(read_text(&overlay, "Zeit;v_cm\n1,0D+00;-4,85d-05\n", &status), "%s", status.text);
    ck_assert(overlay_choose(&overlay, NULL, NULL, "v_cm", "u", &status));
    ck_assert_int_eq(overlay.x, 0);
    ck_assert_double_eq(overlay.columns[0].values[0], 1);
    ck_assert_double_eq(overlay.columns[1].values[0], -4.85e-5);
    ck_assert_int_eq(overlay.columns[1].digits, 3);
    ck_assert_int_eq(overlay.columns[1].places, 7);
    overlay_close(&overlay);
    for (size_t i = 0; i < sizeof none / sizeof *none; i++) {
        char text[64];
        snprintf(text, sizeof text, "t,v_cm\n0,1\n1,%s\n", none[i]);
        ck_assert_msg(read_text(&overlay, text, &status), "%s", status.text);
        ck_assert(isnan(overlay.columns[1].values[1]));
        overlay_close(&overlay);
    }
    ck_assert(!read_text(&overlay, "t,v_cm\n0,1\n1,DD\n", &status));
    ck_assert(!read_text(&overlay, "t,v_cm\n0,1\n1,1d2d3\n", &status));
}
END_TEST

START_TEST(x_makes_it_a_profile)
{
    Overlay overlay;
    Status status;
    ck_assert(read_text(&overlay, "time,x0,u\n5,2,1\n5,1,3\n", &status));
    ck_assert(overlay_choose(&overlay, NULL, NULL, "v_cm", "u", &status));
    ck_assert(overlay.along);
    ck_assert_int_eq(overlay_column_for(&overlay, "u", true), 2);
    ck_assert_int_eq(overlay_column_for(&overlay, "u", false), -1);
    ck_assert_double_eq(overlay.columns[2].values[0], 3); /* in the order of x0 */
    ck_assert(overlay_choose(&overlay, "time", "u", "v_cm", "u", &status));
    ck_assert(!overlay.along);
    ck_assert(!overlay_choose(&overlay, "place", NULL, "v_cm", "u", &status));
    ck_assert_str_eq(status.text, "student.csv:1: no column place (time, x0, u, or 1 to 3)");
    overlay_close(&overlay);
}
END_TEST

START_TEST(rows_are_found_by_x)
{
    Overlay overlay;
    Status status;
    ck_assert(read_text(&overlay, "t,a\n1,1\n2,2\n2,3\n4,4\n", &status));
    ck_assert(overlay_choose(&overlay, NULL, NULL, "v_cm", "u", &status));
    ck_assert_uint_eq(overlay_find(&overlay, 0.5), overlay.count);
    ck_assert_uint_eq(overlay_find(&overlay, 1), 0);
    ck_assert_uint_eq(overlay_find(&overlay, 2), 2);
    ck_assert_uint_eq(overlay_find(&overlay, 3.9), 2);
    ck_assert_uint_eq(overlay_find(&overlay, 99), 3);
    overlay_close(&overlay);
}
END_TEST

/* --- what is refused ------------------------------------------------------------------------------ */

static const struct {
    const char *text, *why;
} bad_tables[] = {
    {"", "dir/student.csv:1: holds no numbers"},
    {"\n\n# nothing\n", "dir/student.csv:4: holds no numbers"},
    {"time,v_cm\n", "dir/student.csv:2: holds names but no numbers"},
    {"time\n1\n", "dir/student.csv:1: one column only"},
    {"time,v_cm\n0,1\n1,x\n", "dir/student.csv:3: column 2, v_cm: 'x' is not a number"},
    {"time;v_cm\ns;m/s\n0;1\n", "dir/student.csv:2: column 1, time: 's' is not a number"},
    {"0,1\n1,0x10\n", "dir/student.csv:2: column 2: '0x10' is not a number"},
    {"0,1\n1,info\n", "dir/student.csv:2: column 2: 'info' is not a number"},
    {"0,1\r\n1\r\n", "dir/student.csv:2: 1 value in a table of 2 columns"},
    {"0,1\n1,2,3\n", "dir/student.csv:2: 3 values in a table of 2 columns"},
    {"0;1\n1;1.000,5\n", "dir/student.csv:2: column 2: '1.000,5' is not a number"},
    {"a,\"b\n1,2\n", "dir/student.csv:1: a quoted cell is not closed"},
    {"a,\"b\" c\n1,2\n", "dir/student.csv:1: there is text after a quoted cell"},
    {"a,b\n1,\x01\n", "dir/student.csv:2: holds bytes that are not text"},
    {"\xff\xfet", "dir/student.csv:1: is UTF-16 text"},
};

START_TEST(bad_tables_get_a_line)
{
    Overlay overlay;
    Status status;
    ck_assert(!read_text(&overlay, bad_tables[_i].text, &status));
    ck_assert_msg(strncmp(status.text, bad_tables[_i].why, strlen(bad_tables[_i].why)) == 0, "%s",
                  status.text);
    ck_assert_int_eq(status.code, STATUS_USAGE);
    ck_assert_ptr_null(overlay.columns);
    ck_assert_uint_eq(overlay.count, 0);
}
END_TEST

START_TEST(what_is_no_file_is_refused)
{
    Overlay overlay;
    Status status;
    ck_assert(!overlay_load(&overlay, "/nowhere/at-all.csv", NULL, NULL, &status));
    ck_assert_str_eq(status.text, "/nowhere/at-all.csv: cannot be read: No such file or directory");
    ck_assert(!overlay_load(&overlay, "/", NULL, NULL, &status));
    ck_assert_str_eq(status.text, "/: cannot be read: Is a directory");
    ck_assert(!overlay_load(&overlay, "/dev/zero", NULL, NULL, &status));
    char zero[] = "a,b\n1,2\0,3\n", wide[2 * OVERLAY_COLUMNS_MAX + 4], *longest;
    ck_assert(!read_bytes(&overlay, zero, sizeof zero - 1, &status));
    ck_assert_ptr_nonnull(strstr(status.text, ":2: holds bytes"));
    memset(wide, ',', sizeof wide - 1);
    wide[0] = '1', wide[sizeof wide - 1] = '\0';
    ck_assert(!read_text(&overlay, wide, &status));
    ck_assert_ptr_nonnull(strstr(status.text, ":1: too many columns"));
    longest = malloc(OVERLAY_LINE_MAX + 1);
    ck_assert_ptr_nonnull(longest);
    memset(longest, '1', OVERLAY_LINE_MAX);
    longest[1] = ',', longest[OVERLAY_LINE_MAX] = '\0';
    ck_assert(!read_text(&overlay, longest, &status));
    ck_assert_ptr_nonnull(strstr(status.text, ":1: the line is too long"));
    free(longest);
}
END_TEST

/* --- sizes ---------------------------------------------------------------------------------------- */

typedef struct Cancel {
    int calls, most;
    double share;
} Cancel;

static bool wait_for(double share, void *context)
{
    Cancel *cancel = context;
    ck_assert_double_ge(share, cancel->share);
    ck_assert_double_le(share, 1);
    cancel->share = share;
    return ++cancel->calls < cancel->most;
}

START_TEST(a_million_rows_are_fine_and_can_be_given_up)
{
    enum { ROWS = 1000000 };
    char path[] = "/tmp/matvib-overlay-XXXXXX";
    FILE *file = fdopen(mkstemp(path), "w");
    ck_assert_ptr_nonnull(file);
    fputs("time;v_cm\n", file);
    for (int i = ROWS - 1; i >= 0; i--)
        fprintf(file, "%d,%03d;%d\n", i / 1000, i % 1000, i == 777777 ? 1000 : i % 7);
    fclose(file);
    Overlay overlay;
    Status status = {STATUS_DONE, ""};
    Cancel cancel = {.most = 1000};
    ck_assert_msg(overlay_load(&overlay, path, wait_for, &cancel, &status), "%s", status.text);
    ck_assert_int_gt(cancel.calls, 20);
    ck_assert_double_gt(cancel.share, 0.9);
    ck_assert(overlay_choose(&overlay, NULL, NULL, "v_cm", "u", &status));
    ck_assert_uint_eq(overlay.count, ROWS);
    for (int i = 0; i < ROWS; i++)
        ck_assert_double_eq(overlay.columns[0].values[i], i / 1000.0);
    ck_assert_double_eq(overlay.columns[1].values[777777], 1000);
    ck_assert_double_eq(overlay.columns[1].largest, 1000);
    overlay_close(&overlay);
    cancel = (Cancel){.most = 3};
    ck_assert(!overlay_load(&overlay, path, wait_for, &cancel, &status));
    ck_assert_ptr_nonnull(strstr(status.text, "not read to its end"));
    unlink(path);
}
END_TEST

/* Damaged tables are read or refused with a line, and nothing else happens. */
START_TEST(damaged_tables_do_no_harm)
{
    uint64_t random = 0x2545f4914f6cdd1du;
    static const char bytes[] = "0123456789.,;\t\n\r\" #eE+-naxt\0\xff\xef";
    const size_t n_tables = sizeof same_tables / sizeof *same_tables;
    for (int turn = 0; turn < 20000; turn++) {
        char text[256];
        const char *from = same_tables[turn % (int)n_tables];
        size_t size = strlen(from);
        memcpy(text, from, size);
        for (int k = 0; k < 1 + turn % 5; k++) {
            random ^= random << 13, random ^= random >> 7, random ^= random << 17;
            text[random % size] = bytes[(random >> 32) % (sizeof bytes - 1)];
        }
        Overlay overlay;
        Status status;
        if (!read_bytes(&overlay, text, size, &status)) {
            ck_assert_msg(strncmp(status.text, "dir/student.csv:", 16) == 0, "%s", status.text);
            continue;
        }
        ck_assert_uint_gt(overlay.count, 0);
        if (overlay_choose(&overlay, NULL, "2", "v_cm", "u", &status))
            for (size_t i = 1; i < overlay.count; i++)
                ck_assert_double_ge(overlay.columns[overlay.x].values[i],
                                    overlay.columns[overlay.x].values[i - 1]);
        overlay_close(&overlay);
    }
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("overlay");
    tcase_add_loop_test(tcase, every_dialect_reads_to_the_same, 0,
                        (int)(sizeof same_tables / sizeof *same_tables));
    tcase_add_test(tcase, digits_are_counted_as_written);
    tcase_add_test(tcase, numbers_of_other_programs);
    tcase_add_test(tcase, a_table_without_names_goes_by_numbers);
    tcase_add_test(tcase, x_makes_it_a_profile);
    tcase_add_test(tcase, rows_are_found_by_x);
    tcase_add_loop_test(tcase, bad_tables_get_a_line, 0, (int)(sizeof bad_tables / sizeof *bad_tables));
    tcase_add_test(tcase, what_is_no_file_is_refused);
    tcase_add_test(tcase, a_million_rows_are_fine_and_can_be_given_up);
    tcase_add_test(tcase, damaged_tables_do_no_harm);
    suite_add_tcase(suite, tcase);
}
