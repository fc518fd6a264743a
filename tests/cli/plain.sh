#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# matvib --plain from a pipe: the first lesson and the lecture on the bar as whole conversations, the same
# every time and on each machine that has the same numbers; bounds and refusals.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
golden=$MATVIB_SRCDIR/tests/golden/plain

# talk NAME ARGUMENTS...: a conversation that is kept; MATVIB_REGENERATE=1 keeps it anew
talk() {
	talk=$1
	shift
	"$MATVIB" "$@" --plain <"$golden/$talk.lines" >out 2>err
	got=$?
	test -z "$MATVIB_REGENERATE" || cp out "$golden/$talk.words"
	result "$talk: status 0" test "$got" -eq 0
	result "$talk: word for word" diff "$golden/$talk.words" out
	result "$talk: nothing but plain characters" sh -c '! LC_ALL=C grep -q "[^ -~]" out'
	result "$talk: no line over 72" sh -c '! grep -q ".\{73\}" out'
	result "$talk: nothing on standard error" test ! -s err
}
talk one-step lesson one-step
talk lecture-bar mode5
talk inspect-mesh mode5 --set mpm.mass_blend=auto --paused
talk inspect-family notched-beam-coarse --paused
talk touch two-discs --paused

printf '%s\n' ']' i ':figure inspector.svg' | "$MATVIB" mode1 --plain --paused >out
result "what the inspector shows is drawn on paper" says inspector.svg '>0\.50000<'

printf '%s\n' 'until t 1' x '' | "$MATVIB" mode1 --plain >out
result "an empty line takes what a question proposes" test -s mode1-series.csv
printf 'until end\n' | "$MATVIB" moving-cantilever-coarse --steps 30 --plain >out
result "a long phrase is broken and not cut" sh -c 'grep -q "nearly all of it feed motion" out && ! grep -q "~" out'
printf 'until break\nmore\n' | "$MATVIB" notched-beam-coarse --plain >out
result "a map says where the crack is" says out 'crack tip: x 65 mm'
# agree ARGUMENTS...: in the window from a to b, zeros of the measured and of the exact curve part by 2 L (b - a)/b where
# the run is L periods behind at b, but for one zero at each end; prints "lag" if it says L at all
agree() {
	printf 'until end\ntell probe\n' | "$MATVIB" "$@" --plain | tr '\n' ' ' | sed 's/.*> tell probe//; s/  */ /g' >told
	awk 'function zeros(text) { return text ~ /crosses zero once/ ? 1 : match(text, /crosses zero [0-9]+/) ? substr(text, RSTART + 13, RLENGTH - 13) + 0 : 0 }
		{
			n = split($0, curves, /\. /)
			for (i = 1; i <= n; i++) {
				if (curves[i] ~ /^measured: from t /) { m = zeros(curves[i]); seen++ }
				if (curves[i] ~ /^exact: from t /) { e = zeros(curves[i]); seen++ }
			}
			match($0, /measured: from t [^ ]+ to [^ :]+/); split(substr($0, RSTART, RLENGTH), w, " ")
			if (seen != 2) exit 2
			if (!match($0, /[0-9.]+ periods (behind|ahead)/)) exit 0
			split(substr($0, RSTART, RLENGTH), l, " ")
			print "lag"
			off = e - m - 2 * (l[3] == "behind" ? l[1] : -l[1]) * (w[6] - w[4]) / w[6]
			exit off > 2 || off < -2
		}' told
}
agreed() {
	name=$1
	shift
	agree "$@" >says
	result "$name: zeros and lag agree" test $? -eq 0
}
agreed "a box with an offset" mode5 --set mpm.shape=gimp --set initial.mode=8 --set initial.offset=.4
result "and it says how far behind" test -s says
for mistake in volume_of_cell mass_for_volume; do
	agreed "$mistake" mode5 --set "mpm.mistake=$mistake" --set bar.density=2 --end 13.1
	result "and it says how far ahead" test -s says
done
agreed "what has decayed" mode5 --set initial.mode=8 --set mesh.cell_size=0.5 --set mpm.algorithm=usl --set mpm.flip_fraction=0.5 --end 13.1
result "has no lag" test ! -s says
agreed "what goes on in the null space" mode5 --set initial.mode=10 --set bar.length=18 --set mpm.mistake=mass_for_volume --set initial.velocity=0.5 --set time.courant=0.05 --end 13.1

"$MATVIB" mode1 --plain </dev/null >out
result "it ends with its input" test $? -eq 0
result "and has told what there is" says out '^The number'
printf '%5000s\n' x | "$MATVIB" mode1 --plain >out 2>err
result "a line without end is refused" test $? -eq 2
result "with a word" says err 'standard input:1: the line is too long (at most 4096 bytes)'
printf '%300s\nstep\n' x | tr ' ' x | "$MATVIB" mode1 --plain >out 2>err
result "one that is no command is told, and the next one done" says out 'step 1 of 10000'
printf 'a\000b\n' | "$MATVIB" mode1 --plain >out 2>err
result "a zero byte is refused" test $? -eq 2
printf 'step\n' | "$MATVIB" mode1 --plain --record s.session >out
result "a session is kept" test -s s.session

# letters are those of the locale's encoding
cat >letters.lesson <<'END'
@title Schwingung für Zoë
@about Ein Versuch
@page Größe
@do open mode1
Übung: die Dauer ist ∆t = 0,5 s, ein Wort ohne jede Lücke: ääääääääääääääääääääääääääääääääääääääääääääääääääääääääääääääääääääääääääääääää, und 波.
END
echo step | "$MATVIB" lesson letters.lesson --plain >out
result "letters are written" says out 'Größe'
result "wide ones too" says out '波\.'
result "of a title, a rule goes and the letters stay" says out 'Schwingung für Zoë  *1/1'
result "no line of them is wider" sh -c '! grep -q ".\{73\}" out'
printf '%80s\n' '' | sed 's/ /ä/g' | "$MATVIB" mode1 --plain >out
result "a line is broken by columns" says out '^  ä\{70\}$'
LC_ALL=C "$MATVIB" lesson letters.lesson --plain </dev/null >out
result "where the encoding has none there are marks" says out 'Gr??e'
result "and nothing else" sh -c '! LC_ALL=C grep -q "[^ -~]" out'
refuse "a session to be done again" "--plain: lines come from standard input (leave the session out)" --plain --replay s.session
refuse "a script too" "--plain: lines come from standard input (leave --script out)" --plain --script x

echo "1..$number"
