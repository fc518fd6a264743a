/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether work that cannot be cut into frames is to go on; a file of its own, for whatever works so needs it,
 * and frames need all of that. */
#include "lab/laboratory.h"
#include "lab/session/session.h"

bool laboratory_go_on(Laboratory *lab)
{
    if (lab->given_up || lab->host.go_on(lab->host.context))
        return !lab->given_up;
    lab->given_up = true;
    if (lab->recording)
        session_note_stop(lab->recording, lab);
    return false;
}
