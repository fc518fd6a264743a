#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# browser.js where there is a Chromium; MATVIB_BROWSER names another one.
MATVIB_BROWSER=${MATVIB_BROWSER-$(command -v chromium)}
export MATVIB_BROWSER
if [ -z "$MATVIB_BROWSER" ]; then
	echo "ok 1 - the page in a browser # SKIP chromium is not installed"
	echo "1..1"
	exit 0
fi
exec node "$MATVIB_SRCDIR/tests/web/browser.js" "$@"
