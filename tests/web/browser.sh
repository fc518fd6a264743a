#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# browser.js where there is a Chromium or a Firefox; MATVIB_BROWSER and MATVIB_FIREFOX name others, empty: none.
MATVIB_BROWSER=${MATVIB_BROWSER-$(command -v chromium)}
MATVIB_FIREFOX=${MATVIB_FIREFOX-$(command -v firefox-esr)}
export MATVIB_BROWSER MATVIB_FIREFOX
exec node "$MATVIB_SRCDIR/tests/web/browser.js" "$@"
