/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether a beam that is being built is still wanted; every part of the building asks. */
#include "methods/bonds/plane/bonds_internal.h"

/* Asks the caller that waits for the beam whether it is still wanted, and remembers a no for all threads. */
bool beam_go_on(Beam *beam, double share, Status *status)
{
    if (!beam->given_up)
        beam->given_up = !patience_lasts(&beam->def.patience, share);
    return !beam->given_up || status_fail(status, "the building of the beam was cancelled");
}
