/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Everything that a scenario holds: plain values, filled by the parameter table (parameters.h) and by the
 * scenario reader (scenario.h), read by everyone. A copy by assignment is a whole copy.
 *
 * The values of parameters stand by concern in concern_*.h, each read through its own function:
 * settings_mesh() of concern_cells.h. Here they are room of a size that does not change, so that a new member
 * is compiled again by those who read its concern and not by those who copy settings or pass them on. */
#ifndef SCENARIO_SETTINGS_H
#define SCENARIO_SETTINGS_H

#include "base/cancel.h"
#include "scenario/assignment.h"
#include "scenario/rows/rows.h"

#include <stddef.h>

struct Settings {
    char title[TITLE_MAX]; /* one line, UTF-8 */
    char about[ABOUT_MAX];
    const Problem *problem;
    MethodKind method;

    union {
        max_align_t aligned;
        unsigned char room[4096];
    } values;                /* settings_values.h says what they are */
    RowList rows[ROW_KINDS]; /* of a plate: by RowKinds */

    bool concealed; /* its mistake is made, but not shown: "?" */

    Cancel cancel; /* asked while the simulation and its references are being made */

    char question[KEY_MAX]; /* what `t` toggles */
    Assignment duel[DUEL_MAX];
    int n_duel;
    Change changes[CHANGES_MAX]; /* ascending in step */
    int n_changes;
};

/* The words of a scenario file for MethodKind, ended by NULL. */
extern const char *const settings_method_words[];

/* A word of a choice in a file that is not to show the mistake: four hexadecimal digits of its hash. */
enum { CIPHER_MAX = 5 };
void parameter_cipher(const char *word, char out[CIPHER_MAX]);

#endif
