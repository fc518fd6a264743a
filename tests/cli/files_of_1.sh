#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What matvib 1.0.0 wrote still opens: scenarios, the .ini beside a series, sessions, recordings of homework. The files
# in tests/files-of-1 are its own, as they came.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
files=$MATVIB_SRCDIR/tests/files-of-1
export XDG_STATE_HOME="$scratch/state"

for file in "$files"/*.ini; do
	expect "${file##*/} runs" 0 run "$file" --steps 2 --quiet
	result "  and nothing is said" test ! -s err
	expect "  it is shown" 0 show "$file"
	cp out again.ini
	expect "  and that opens too" 0 run again.ini --steps 2 --quiet
done
# what a key of 1.0.0 meant is what it means
expect "a share of the blend is read" 0 show "$files/series.csv.ini"
result "as it stood there" says out '^mass_blend = auto'
expect "changes in mid-run are" 0 show "$files/bar.ini"
result "as they stood there" says out '^2 = load.body_force=0.01'
# a series had all columns, where its head has their names
expect "a series with what the grid has of the energy" 0 run "$files/series.csv.ini" --steps 2 --series - --quiet
result "has it again" says out ',kinetic,kinetic_grid,kinetic_null,strain,'
sed '/^# kinetic_/d' "$files/series.csv.ini" >without.ini
expect "one without" 0 run without.ini --steps 2 --series - --quiet
result "stays without" says out ',kinetic,strain,'

# replayed NAME TEXT: it comes to where it was left, with a warning in one line
replayed() {
	printf 'expect %s\n' "$2" >there.script
	"$MATVIB" --replay "$files/$1.session" --script there.script 2>err
}
result "a session of the bar is done again" replayed bar "step 31"
result "with a warning" says err 'bar.session: of matvib 1: digits may differ$'
result "in one line" lines err 1
result "a session of a beam is done again" replayed beam "step 228"
result "with the warning" says err 'beam.session: of matvib 1: digits may differ$'
printf 'key .\n' >one.script
"$MATVIB" mode1 --paused --script one.script --record today.session
expect "one of today" 0 --replay today.session --script one.script
result "needs none" test ! -s err
result "for it says of what program it is" says today.session "^version 0000000000000000 $("$MATVIB" --version | cut -d' ' -f2)\$"

subcommand=grade
expect "homework of 1.0.0 is marked" 0 "$files/own.lesson" "$files/own.session" --output marks.csv
result "nothing is said" test ! -s err
result "its marks are those of 1.0.0" test "$(cut -d, -f2,3,5,6 marks.csv)" = "exercise,value,mark,tries
1 Frequency,-4.2391,1,1
2 Choose,this,1,1"
result "and its remark says so" test "$(grep -c ',of matvib 1.0.0: digits may differ$' marks.csv)" -eq 2
expect "so is what it brought along, which has changed since" 0 homework-energy "$files/homework-energy.session" --output energy.csv
result "with the remark" says energy.csv '^Ada Lovelace,1 Stress last,-85.2379,.*,"of matvib 1.0.0, where this lesson asked otherwise: a 0 may have been right"$'
expect "of another lesson it is not" 1 homework-late "$files/homework-energy.session" --output other.csv
result "and that is said" says other.csv 'foreign: it is of another lesson, or of another text of this one'
sed 's/within 2 %/within 3 %/' "$files/own.lesson" >changed.lesson
expect "nor of a text that was changed" 1 changed.lesson "$files/own.session" --output changed.csv
result "which is said too" says changed.csv 'foreign: it is of another lesson, or of another text of this one'
echo "1..$number"
