#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A release made twice, in two build folders of other names and depths, is the same bytes: tarball, static program, package, page
# (where Emscripten and the page's sources are here), notes and checksums. For check-long: it builds six to eight times.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
unset MAKEFLAGS MAKELEVEL MFLAGS
page=

command -v emcc >/dev/null && ls "${MATVIB_WEB_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/matvib-web}"/*.tar.gz >/dev/null 2>&1 && page=web
released() ( # FOLDER
	mkdir -p "$1" && cd "$1" && "$MATVIB_SRCDIR/configure" --quiet && make -s -j2 $page && make -s -j2 release
)
result "a release is made" released "$scratch/one"
result "and in another folder" released "$scratch/two/deeper"
one=$scratch/one/release other=$scratch/two/deeper/release
result "it has a tarball and notes" sh -c "ls '$one'/matvib-*.tar.gz '$one/NOTES'"
test ! -d "$MATVIB_SRCDIR/debian" || ! command -v dh >/dev/null 2>&1 || result "and a package" sh -c "ls '$one'/*.deb"
test -z "$page" || result "and the page" test -s "$one/matvib.html"
result "the same files" sh -c "ls '$one' >names && ls '$other' | diff names -"
for file in "$one"/*; do
	result "$(basename "$file"): the same bytes" cmp "$file" "$other/$(basename "$file")"
done
result "the checksums are theirs" env -C "$one" sha256sum --check --strict SHA256SUMS
echo "1..$number"
