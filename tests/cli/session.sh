#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# --record and --replay: the same bits again; --last; what is not a session is refused.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"

refused() { # LINE ARGUMENTS...
	wanted="matvib: $1"
	shift
	"$MATVIB" "$@" --script empty 2>&1 | grep -q -x -F -e "$wanted" || { "$MATVIB" "$@" --script empty && false; }
}
: >empty
printf 'key Esc x\ntype again\nkey Enter\nexpect wrote\n' >export.script

# session NAME SCENARIO: plays a lesson with runs, stages, changes in mid-run, a rewind and a text
session() {
	"$MATVIB" "$2" --paused --script play.script --record "$1.session" --size 100x30
}
for scenario in mode5 crossing supported-beam-mpm-coarse ${MATVIB_WIDE:+notched-beam-coarse}; do
	key=mpm.algorithm value=musl
	[ $scenario = notched-beam-coarse ] && key=pd.critical_stretch value=0.0007
	cat >play.script <<END
rate 3000
key Space
wait 1.5
key Space ] ] ] , Space
wait 0.5
key + Space :
type set $key $value
key Enter Space
wait 0.4
click 60 20
key < Space
wait 0.2
key Space x
type first
key Enter
expect wrote
END
	rm -f again-* first-*
	result "$scenario: a session is recorded" session $scenario $scenario
	result "$scenario: it is done again" "$MATVIB" --replay $scenario.session --script export.script
	result "$scenario: nothing of it was written again" test "$(ls first-*.csv again-*.csv | wc -l)" -ge 4
	for file in first-*; do
		result "$scenario: ${file#first-} is the same" cmp "$file" "again-${file#first-}"
	done
	[ $scenario = mode5 ] && sed 's/^at [^ ]* [^ ]*/at/' mode5.session >keys
	[ $scenario = mode5 ] && "$MATVIB" --replay mode5.session --script empty --record second.session &&
		sed 's/^at [^ ]* [^ ]*/at/' second.session >keys.again
done
grep '^at' keys >a && grep '^at' keys.again >b
result "a replay can be recorded: the same keys" cmp a b

result "a session is not overwritten" refused 'mode5.session: exists (--force replaces it)' mode1 --record mode5.session
"$MATVIB" show mode1 2>/dev/null | sed -n '/^\[scenario\]/,$p' >first.ini
result "a scenario is not a session" refused \
	'first.ini:1: unknown line: [scenario] (scenario NAME | paused | first | sheet WORD | lesson NAME | student NAME | version HASH PROGRAM | reached NAME PAGE | "| ..." | at ... | stop ... | end ... | check HASH)' --replay first.ini
sed 's/^\(version [0-9a-f]*\) .*/\1 1.0.0/' mode5.session >old.session
result "another version's is refused by it" refused "old.session: is of matvib 1.0.0 (this is $("$MATVIB" --version | sed 's/matvib //;q'), which replays its own sessions only)" --replay old.session
sed '/^|/s/.*/| nothing that is known/' old.session >older.session
result "whatever else it holds" refused "older.session: is of matvib 1.0.0 (this is $("$MATVIB" --version | sed 's/matvib //;q'), which replays its own sessions only)" --replay older.session
result "nor is nothing" refused 'empty: is not a session (its scenario is missing)' --replay empty
sed 's/^at .*Space$/at x 1 80x24 Space/' mode5.session >broken.session
line=$(grep -n '^at x' broken.session | head -n 1 | cut -d: -f1)
result "a place that is none" refused \
	"broken.session:$line: not a place of a session (at STEP[/STAGE] SECONDS WIDTHxHEIGHT KEY [X Y])" --replay broken.session
for place in '0 1e19 80x24' '0 -1 80x24' '99999999999999999999 1 80x24' '0 1 99999999999x1' '0 1 80x24x' '0 1 80x10001' '-1 1 80x24'; do
	{
		grep '^[s|p]' mode5.session
		echo "at $place Space"
	} >bounds.session
	line=$(wc -l <bounds.session)
	result "nor is $place" refused \
		"bounds.session:$line: not a place of a session (at STEP[/STAGE] SECONDS WIDTHxHEIGHT KEY [X Y])" --replay bounds.session
done
{
	grep '^[s|p]' mode5.session
	printf 'at 0 0 80x24 \302\233\n'
} >c1.session
result "nor a control character" refused "c1.session:$(wc -l <c1.session): is not text in UTF-8" --replay c1.session
head -c 1000000 /dev/zero | tr '\0' a >endless.session
result "a line has an end" refused 'endless.session:1: the line is too long (at most 1100 bytes)' --replay endless.session
mkfifo pipe.session
result "a pipe is not a session" refused 'pipe.session: is a pipe or a device (a file is expected)' --replay pipe.session
result "nor is a folder" refused '.: cannot be read: Is a directory' --replay .
# the computer stopped in the middle of a line
sed '/^end/d' mode5.session >open.session
printf 'at 99999999999999999999999' >>open.session
result "a line that was cut is dropped" "$MATVIB" --replay open.session --script empty

# a session that is done again writes nothing, and leaves no question open whose answer would be the next key
cat >writes.script <<'END'
key Space
wait 0.1
key Space w
type w.ini
key Enter x
type newest
key Enter
key Esc x
type w
key Enter
key :
type figure w.svg
key Enter w
type old.ini
key Enter y w
type old.ini
END
: >old.ini
"$MATVIB" mode1 --paused --script writes.script --record writes.session >/dev/null
result "keys wrote files" test -s w.ini -a -s w-series.csv -a -s w.svg -a -s old.ini
rm -f w.* w-*
echo mine >old.ini
printf 'key Enter y Enter\n' >enter.script
result "a session that writes is done again" "$MATVIB" --replay writes.session --script enter.script
result "but writes nothing" sh -c 'test -z "$(ls | grep -E "^w[.-]")" && test "$(cat old.ini)" = mine'
printf 'reject write scenario\nkey w\ntype own.ini\nkey Enter\nexpect wrote own.ini\n' >own.script
result "what it asked is closed, and the user may write" "$MATVIB" --replay writes.session --script own.script

# a key that came while a loop jumped back, or at a place that its run can never reach
printf 'key :\ntype loop 1e-6 3e-6\nkey Enter\nwait 0.3\nkey Esc\nwait 0.3\nkey 1\n' >loop.script
"$MATVIB" supported-beam-mpm-coarse --script loop.script --record loop.session >/dev/null
echo 'expect step 26 ' >there.script
result "Esc came in the jump of a loop" grep -q '^at ~26 .* Esc$' loop.session
result "which is done again" timeout -s KILL 60 "$MATVIB" --replay loop.session --script there.script
result "and filmed" timeout -s KILL 60 "$MATVIB" movie loop.session --output loop.gif
sed '/ Esc$/d' loop.session | sed 's/^at 26 /at 40 /' >beyond.session
result "a place beyond the loop is gone to" timeout -s KILL 60 "$MATVIB" --replay beyond.session --script empty
# a film of a run that takes long ends when it is told to
{
	grep '^[s|pv]' loop.session | sed 's/^| end = .*/| end = 10/'
	printf 'at 0 0 80x24 Space\nat 10000000 0 80x24 1\n'
} >long.session
"$MATVIB" movie long.session --output long.gif >out 2>err &
filming=$!
soon sh -c 'ls long.gif.* >/dev/null 2>&1'
soon works $filming 30
kill -TERM $filming
ends $filming
result "SIGTERM ends a film" test $? -eq 143

# a recording is in its file as it comes; a crash leaves it
mkfifo keys.pipe
"$MATVIB" mode1 --paused --script - --record crash.session <keys.pipe >/dev/null 2>&1 &
crashed=$!
exec 3>keys.pipe
printf 'key . . ,\n' >&3
keys_kept() { test "$(grep -c '^at' crash.session 2>/dev/null)" = 3; }
soon keys_kept
kill -KILL $crashed
wait $crashed 2>/dev/null
exec 3>&-
result "a crash leaves every key" test "$(grep -c '^at' crash.session)" -eq 3
echo 'expect step 1 ' >one.script
result "and they are done again" "$MATVIB" --replay crash.session --script one.script

# a lesson writes nothing either, and is refused when it is read
printf '@title A\n@page One\n@do write .bash_aliases\n' >bad.lesson
result "a lesson that writes is refused" refused \
	'bad.lesson:3: @do: write: a lesson may not (it changes the laboratory only)' lesson bad.lesson
result "and has written nothing" test ! -e .bash_aliases
result "a name with control characters is none for a recording" refused \
	'a\x1b[2Jb: not a file name (UTF-8 without control characters)' mode1 --record "$(printf 'a\033[2Jb')"
sed 's/^| cell_size.*/| cell_size = -1/' mode5.session >wrong.session
"$MATVIB" --replay wrong.session --script empty 2>message
result "its scenario is judged" grep -q 'wrong.session (scenario):[0-9]*: mesh.cell_size:' message
result "a session has its own parameters" refused '--replay: a session has its own scenario and parameters' --replay mode5.session --set mesh.cell_size=2
result "a folder that is not there is told at once" refused 'none/x.session: there is no folder none' mode1 --record none/x.session
result "no last session as yet" refused "--last: no session has been kept ($scratch/state/matvib/last.session)" --last

# a session knows how far one had come when it was recorded; what was reached since is not taken back
mkdir -p state/matvib
echo 'key . T' >lesson.script
"$MATVIB" lesson late --script lesson.script --record early.session
result "how far one came is kept" test "$(cat state/matvib/lessons)" = "late 1"
result "for the user alone" test "$(ls -ld state/matvib | cut -c1-10)" = drwx------
printf 'late 5\ncrack 3\n' >state/matvib/lessons
printf 'key T Enter\nwait 0.1\nkey T\n' >again.script
"$MATVIB" --replay early.session --script again.script
result "and never taken back" grep -q -x 'late 5' state/matvib/lessons
result "of no lesson" grep -q -x 'crack 3' state/matvib/lessons
echo "1..$number"
