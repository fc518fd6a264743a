#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# matvib movie as people type it: scenario, session and script, what a film holds, bytes that repeat, refusals.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
subcommand=movie

pictures() { grep -c '^<g transform="translate(' "$1"; } # of an SVG
events() { grep -c '^\[' "$1"; }                         # of a recording
has_words() { grep -q -F -e ">$2<" "$1"; }
is_last() { # the strip stands at its last picture by itself
	shift_by=$(sed -n 's/^<g id="strip" transform="translate(-\([0-9]*\) 0)">$/\1/p' "$1")
	test "$shift_by" -eq $((($(pictures "$1") - 1) * 640))
}
ends_at() { tail -n 1 "$1" | grep -q "^\[$2, "; }

# --- a run ---
expect "a run as an animated picture" 0 mode5 --end 2 --output a.svg
result "says what it wrote" says out '^wrote a.svg$'
result "nothing on stderr" lines err 0
if command -v xmllint >/dev/null 2>&1; then
	result "it is well-formed" xmllint --noout a.svg
else
	skip "it is well-formed" "no xmllint"
fi
result "words are words" has_words a.svg "displacement x10^-3"
result "the last time is in it" grep -q 't 2.00' a.svg
result "and one on the way" grep -q 't 1.0' a.svg
result "more than ten pictures" test "$(pictures a.svg)" -gt 10
result "as many steps of the animation" test "$(grep -c 'translateX' a.svg)" -eq "$(pictures a.svg)"
result "without animation the last is seen" is_last a.svg
# a browser that folds blanks says less than is written
if command -v chromium >/dev/null 2>&1; then
	{
		cat a.svg
		echo '<script>document.title = [...document.querySelectorAll("text")].every(
			text => text.getNumberOfChars() === text.textContent.length) ? "all blanks" : "blanks folded"</script>'
	} >a.html
	result "Chromium draws all of its blanks" sh -c "timeout 100 chromium --headless --no-sandbox --disable-gpu --user-data-dir=chromium \
		--dump-dom 'file://$scratch/a.html' 2>/dev/null | grep -q '<title>all blanks'"
else
	skip "Chromium draws all of its blanks" "no Chromium"
fi
expect "the same again" 0 mode5 --end 2 --output b.svg
result "has the same bytes" cmp a.svg b.svg
expect "in a plain locale" 0 mode5 --end 2 --output c.cast
LC_ALL=C "$MATVIB" movie mode5 --end 2 --output d.cast >out 2>err
result "a recording has the same bytes too" cmp c.cast d.cast
expect "on a large light screen" 0 mode5 --end 1 --size 132x43 --theme light --output e.svg
result "has its size" grep -q 'width="1056" height="731"' e.svg

# the map of a crack has the room to itself, and as much of it at the end as at the beginning
expect "a crack" 0 notched-beam-coarse --set pd.spacing=2e-3 --end 1.5e-5 --output crack.svg
result "has its number" has_words crack.svg "mm of crack so far"
result "and no table beside it" test "$(grep -c 'modulus' crack.svg)" -eq 0
expect "a crack on the full sheet" 0 notched-beam-coarse --set pd.spacing=2e-3 --end 1.5e-5 --sheet full --output full.svg
result "has the table where it is asked for" test "$(grep -c 'modulus' full.svg)" -gt 0

# --- its length ---
expect "at the laboratory's speed" 0 mode5 --end 2 --output f.cast
expect "twice as fast" 0 mode5 --end 2 --speed 2 --output g.cast
seconds() { tail -n 1 "$1" | sed 's/^\[\([0-9.]*\),.*/\1/'; }
result "takes half as long, but for the last picture" awk "BEGIN { d = ($(seconds f.cast) - 2) - 2 * ($(seconds g.cast) - 2); exit !(d < .2 && d > -.2) }"
expect "with fewer pictures" 0 mode5 --end 2 --fps 2 --output h.cast
result "has fewer" test "$(events h.cast)" -lt $(($(events f.cast) / 4))
expect "a part of it" 0 mode5 --end 2 --from 1 --to 1.5 --output i.svg
result "does not have what was before" test "$(grep -c 't 0\.[0-9]' i.svg)" -eq 0
result "nor what came after" test "$(grep -c 't 1\.[6-9]' i.svg)" -eq 0
result "but has what was between" grep -q 't 1.2' i.svg

# --- a script and a session ---
printf 'key Space\nwait 60\nkey ]\n' >keys.script
expect "a script" 0 keys.script --end 2 --output k.cast
expect "without long waits" 0 keys.script --end 2 --idle 1 --output l.cast
result "is a minute shorter" awk "BEGIN { d = $(seconds k.cast) - $(seconds l.cast); exit !(d > 55 && d < 62) }"
expect "at twice the speed" 0 keys.script --end 2 --idle 1 --speed 2 --output n.cast
result "a wait is cut to the same" awk "BEGIN { d = $(seconds l.cast) - $(seconds n.cast); exit !(d >= 0 && d < 0.5) }"
"$MATVIB" mode1 --paused --script keys.script --record a.session >out 2>err
expect "a session" 0 a.session --output m.cast
result "has its scenario" grep -q mode1 m.cast
expect "with the keys of a script" 0 mode10 --script keys.script --output n.svg
result "has both" grep -q mode10 n.svg

printf 'key x\ntype stolen\nkey Enter\nkey w\ntype stolen.ini\nkey Enter\nwait 1\n' >writes.script
expect "keys that would write" 0 writes.script --end 2 --output o.cast
result "write nothing while they are filmed" test -z "$(find . -name 'stolen*')"

# --- GIF, where it was built in ---
"$MATVIB" movie mode5 --end 1 --output a.gif >out 2>err
if grep -q 'built without' err; then
	skip "a GIF" "built without giflib"
	skip "has the same bytes again" "built without giflib"
	skip "a GIF on a disk that is full" "built without giflib"
	skip "has a reason" "built without giflib"
else
	result "a GIF" test "$(head -c 6 a.gif)" = GIF89a
	"$MATVIB" movie mode5 --end 1 --output b.gif >out 2>err
	result "has the same bytes again" cmp a.gif b.gif
	(ulimit -f 8 && exec "$MATVIB" movie mode5 --end 3 --output full.gif) >out 2>err
	result "a GIF on a disk that is full" test $? -eq 1 -a -z "$(find . -name 'full.gif*')"
	result "has a reason" says err '^matvib: the film: File too large$'
fi

# --- refusals ---
refuse "no film" "movie: --output FILE is missing (FILE.cast, .svg or .gif)" mode5
refuse "an unknown kind" "a.mov: a film's name ends in .cast (asciinema), .svg (animated) or .gif" mode5 --output a.mov
refuse "a file that exists" "a.svg: exists (--force replaces it)" mode5 --output a.svg
refuse "a rate that is none" "--fps: not a number from 0.1 to 100: 0" mode5 --fps 0 --output z.svg
refuse "a part that ends before it begins" "--from: 2 comes after --to: 1" mode5 --from 2 --to 1 --output z.svg
refuse "a part that does not come" "there is nothing to be seen from time 50 to 60 (--from, --to)" mode5 --end 2 --from 50 --to 60 --output z.svg
# before it begins: a picture a tenth of the run's time, of which there are so many in fact
refuse "more pictures than a film has" \
	"the film would have about 1000000 pictures (at most 36000: --to 2000, or --speed 100)" mode5 --end 1e5 --output z.cast
expect "a short one" 0 mode5 --end 20 --output p.cast
result "has as many of them as it should" test $((($(events p.cast) - 200) * ($(events p.cast) - 200))) -le 16
refuse "a session with parameters" "a.session: a session has its own scenario and parameters" a.session --end 2 --output z.svg
refuse "a scenario that is none" "nothing: no such scenario or file (see: matvib list)" nothing --output z.svg
mkdir folder
"$MATVIB" movie folder --output z.svg >out 2>err
result "a folder is none" test $? -eq 2
result "nothing is left behind" test ! -e z.svg
result "and no remains" test -z "$(find . -name '*.part*')"

# a signal ends it, and takes the file back
"$MATVIB" movie notched-beam --output long.cast >out 2>err &
child=$!
soon works $child 50
kill -TERM $child
ends $child
result "a signal ends it" test $? -eq 143
result "without a file" test -z "$(find . -name 'long*')"

echo "1..$number"
