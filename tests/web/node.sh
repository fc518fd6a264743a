#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The program of the page, in Node and without a page: it writes the same bytes as the native one. Run by
# `make check-web`. MATVIB_LONG: 2,000 steps of every scenario, else a few.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"

steps=40
test -z "${MATVIB_LONG-}" || steps=2000
paged() {
	node "$MATVIB_SRCDIR/web/node.js" "$MATVIB_BUILDDIR/web-work/program" "$@" </dev/null
}
# both NAME ARGUMENTS...: what is printed and written, in folders of their own
both() {
	rm -rf page native && mkdir page native
	test ! -e one.session || { cp one.session page && cp one.session native; }
	result_of() { "$@" >said 2>../said-beside; echo "status $?" >>said; sed -i '/^wall time/d; /threads/d' said; }
	(cd page && result_of paged "$@")
	(cd native && result_of "$MATVIB" "$@")
	grep -q '^status' native/said && diff -r page native
}

result "the host wakes a program for what it waits for" node "$MATVIB_SRCDIR/tests/web/host.js" "$MATVIB_SRCDIR/web/host.js"
for scenario in $("$MATVIB" list | cut -d' ' -f1); do
	result "$scenario: tables and summary" both run "$scenario" --steps $steps --series series.csv --particles particles.csv
done
# but for what its runs took
swept() {
	both sweep mode5 --vary mesh.cell_size=0.5,1 --steps 20 --quiet --output table.csv
	for side in page native; do
		awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) wall = $i == "wall" ? i : wall } { $wall = ""; print }' $side/table.csv >$side.rows
	done
	test "$(wc -l <page.rows)" -eq 3 && cmp page.rows native.rows
}
result "a sweep" swept
result "a figure" both figure mode5 --steps 50 --output figure.svg
# keys at random, kept natively and done again by both
for seed in 1 2 3 4; do
	awk -v seed=$seed 'BEGIN {
		srand(seed)
		n = split("Space . , ] [ Left Right Up Down Tab Enter Esc + - 1 2 3 4 5 d i Z u", keys, " ")
		for (i = 0; i < 60; i++) print "key " keys[int(1 + n * rand())]
	}' >keys.script
	"$MATVIB" mode1 --script keys.script --record random-$seed --force >/dev/null 2>&1
done
for session in "$MATVIB_SRCDIR"/tests/fuzz/corpus/recording/* random-*; do
	cp "$session" one.session
	result "the session ${session##*/} done again: the same pictures" both movie one.session --output film.svg
done
"$MATVIB" verify >native.out 2>&1
paged verify >page.out 2>&1
result "verify: everything is reproduced" test $? -eq 0
tail -n 1 native.out >native.last
tail -n 1 page.out >page.last
result "verify: the same counts" cmp native.last page.last
echo "1..$number"
