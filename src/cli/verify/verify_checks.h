/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The checks of a verification, by subject: each a table of rows under a name. */
#ifndef CLI_VERIFY_CHECKS_H
#define CLI_VERIFY_CHECKS_H

#include "cli/verify/verify_row.h"

typedef struct VerifyCheck {
    const char *name;
    const char *title;
    const VerifyRow *rows; /* the first names a scenario */
    int n_rows;
    const char *note; /* printed under them; NULL: nothing */
} VerifyCheck;

#define VERIFY_ROWS(rows) rows, (int)(sizeof(rows) / sizeof *(rows))

/* Each ends with a NULL name. */
extern const VerifyCheck verify_bar_checks[];   /* the bar: verify_bar.c */
extern const VerifyCheck verify_field_checks[]; /* tests of the field on the bar: verify_field.c */
extern const VerifyCheck verify_beam_checks[];  /* beams that vibrate: verify_beam.c */
extern const VerifyCheck verify_plane_checks[]; /* the same by cells: verify_plane.c */
extern const VerifyCheck verify_crack_checks[]; /* the notched beam: verify_crack.c */
extern const VerifyCheck verify_plate_checks[]; /* plates: verify_plates.c */

#endif
