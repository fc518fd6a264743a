/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What follows from settings: derived numbers and advice as lines of text, for `show` and `params`. */
#ifndef CLI_DERIVED_H
#define CLI_DERIVED_H

#include "base/status.h"
#include "scenario/assignment.h"

#include <stddef.h>

enum { DERIVED_TEXT_MAX = 4096 };

/* "dt = 0.01 time", a line each, then the advice if there is any. The simulation is built for it. */
bool derived_text(const Settings *settings, char *out, size_t size, Status *status);

#endif
