#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# matvib --plain from a pipe: the first lesson and the lecture on the bar as whole conversations, the same
# every time and on each machine that has the same numbers; bounds and refusals.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
golden=$MATVIB_SRCDIR/tests/golden/plain
XDG_STATE_HOME=$scratch/state
export XDG_STATE_HOME

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

printf '%s\n' ']' i ':figure inspector.svg' | "$MATVIB" mode1 --plain --paused >out
result "what the inspector shows is drawn on paper" says inspector.svg '>0\.50000<'

printf '%s\n' 'until t 1' x '' | "$MATVIB" mode1 --plain >out
result "an empty line takes what a question proposes" test -s mode1-series.csv
printf 'until end\n' | "$MATVIB" moving-cantilever-coarse --steps 30 --plain >out
result "a long phrase is broken and not cut" sh -c 'grep -q "nearly all of it feed motion" out && ! grep -q "~" out'
printf 'until break\nmore\n' | "$MATVIB" notched-beam-coarse --plain >out
result "a map says where the crack is" says out 'crack tip: x 65 mm'
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
