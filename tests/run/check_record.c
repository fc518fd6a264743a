/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/record.h"
#include "suite.h"

#include <stdlib.h>

enum { COLUMNS = 4 };

static void append(Record *record, long step)
{
    double row[COLUMNS] = {(double)step, 0.5 * (double)step, (double)(step * step), -1};
    ck_assert(record_append(record, row));
}

static void fill(Record *record, long from, long to)
{
    for (long step = from; step <= to; step++)
        append(record, step);
}

/* First and last row are there, the others stand at equal distances, and what they hold is theirs. */
static void expect_rows(const Record *record, long last)
{
    ck_assert_uint_gt(record->count, 0);
    for (size_t i = 0; i < record->count; i++) {
        const double *row = record_row(record, i);
        bool loose = i + 1 == record->count && record->loose_last;
        long step = loose ? last : (long)i * record->spacing;
        ck_assert_double_eq(row[0], (double)step);
        ck_assert_double_eq(row[2], (double)(step * step));
    }
    ck_assert_double_eq(record_row(record, record->count - 1)[0], (double)last);
}

START_TEST(every_row_is_kept_within_the_budget)
{
    Record record;
    record_open(&record, COLUMNS, 1, 1000 * COLUMNS * sizeof(double));
    fill(&record, 0, 999);
    ck_assert_uint_eq(record.count, 1000);
    ck_assert(!record.thinned);
    expect_rows(&record, 999);
    record_close(&record);
}
END_TEST

START_TEST(rows_are_thinned_beyond_it)
{
    Record record;
    record_open(&record, COLUMNS, 1, 64 * COLUMNS * sizeof(double));
    for (long step = 0; step <= 10000; step++) {
        append(&record, step);
        ck_assert_uint_le(record.count, 64);
        expect_rows(&record, step);
    }
    ck_assert(record.thinned);
    ck_assert_int_eq(record.spacing, 256);
    record_close(&record);
    /* by halves, no more than need be */
    record_open(&record, COLUMNS, 1, 64 * COLUMNS * sizeof(double));
    fill(&record, 0, 100);
    ck_assert_int_eq(record.spacing, 2);
    record_close(&record);
}
END_TEST

START_TEST(only_every_nth_step_is_due)
{
    Record record;
    record_open(&record, COLUMNS, 10, 1 << 20);
    fill(&record, 0, 47);
    expect_rows(&record, 47);
    ck_assert_uint_eq(record.count, 6);
    ck_assert(record.loose_last);
    fill(&record, 48, 50);
    ck_assert(!record.loose_last);
    ck_assert_uint_eq(record.count, 6);
    record_close(&record);
}
END_TEST

START_TEST(a_cut_record_goes_on)
{
    Record record;
    record_open(&record, COLUMNS, 1, 64 * COLUMNS * sizeof(double));
    fill(&record, 0, 1000);
    long spacing = record.spacing;
    record_cut(&record, 3 * spacing);
    expect_rows(&record, 3 * spacing);
    record_cut(&record, 2 * spacing + 1);
    ck_assert_uint_eq(record.count, 3);
    fill(&record, 2 * spacing + 1, 1000);
    expect_rows(&record, 1000);
    record_cut(&record, 2000);
    expect_rows(&record, 1000);
    record_close(&record);
}
END_TEST

START_TEST(rows_are_found_by_time_and_step)
{
    Record record;
    record_open(&record, COLUMNS, 1, 64 * COLUMNS * sizeof(double));
    ck_assert_uint_eq(record_find(&record, 1), 0);
    fill(&record, 0, 301);
    ck_assert_uint_eq(record_find(&record, -1), 0);
    ck_assert_uint_eq(record_find(&record, 0), 0);
    ck_assert_uint_eq(record_find(&record, 1e9), record.count - 1);
    for (long step = 0; step <= 301; step++) {
        const double *row = record_row(&record, record_find(&record, 0.5 * (double)step));
        ck_assert_double_le(row[0], (double)step);
        ck_assert(row[0] > (double)(step - record.spacing));
        const double *exact = record_of_step(&record, step);
        bool kept = step % record.spacing == 0 || step == 301;
        ck_assert(kept == (exact != NULL));
        if (exact)
            ck_assert_double_eq(exact[0], (double)step);
    }
    ck_assert_ptr_null(record_of_step(&record, 302));
    ck_assert_ptr_null(record_of_step(&record, -1));
    record_close(&record);
}
END_TEST

START_TEST(a_copy_is_apart)
{
    Record record, copy;
    record_open(&record, COLUMNS, 1, 64 * COLUMNS * sizeof(double));
    fill(&record, 0, 40);
    ck_assert(record_copy(&copy, &record));
    fill(&record, 41, 50);
    expect_rows(&copy, 40);
    ck_assert_uint_eq(copy.count, 41);
    record_close(&copy);
    record_close(&record);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("record");
    tcase_add_test(tcase, every_row_is_kept_within_the_budget);
    tcase_add_test(tcase, rows_are_thinned_beyond_it);
    tcase_add_test(tcase, only_every_nth_step_is_due);
    tcase_add_test(tcase, a_cut_record_goes_on);
    tcase_add_test(tcase, rows_are_found_by_time_and_step);
    tcase_add_test(tcase, a_copy_is_apart);
    suite_add_tcase(suite, tcase);
}
