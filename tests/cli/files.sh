#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Outputs of all commands and what is there already: --force replaces what matvib wrote, never what it did not write,
# and never a file that is read, by whatever name, side files and numbered frames included.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
printf 'leak:libfontconfig\nleak:libcairo\n' >"$scratch/.leaks"
LSAN_OPTIONS="suppressions=$scratch/.leaks:print_suppressions=0${LSAN_OPTIONS:+:$LSAN_OPTIONS}"
export LSAN_OPTIONS

printf 'key n\n' >two.script
"$MATVIB" lesson homework-late --name Ada --record ada.session --script two.script >out
"$MATVIB" run mode5 --end 20 --series data.csv --quiet
"$MATVIB" show mode1 --steps 20 >own.ini
printf '@title Own\n@about For the test\n@page Words\n@ask Why?\n@words\n' >own.lesson
printf 'name;ID\nAda;17\n' >foreign

told() { test "$got" -eq 2 && echo "matvib: $1" | cmp - err; } # LINE: the status is 2, and this is all that is said
try() { "$MATVIB" "$@" >out 2>err; got=$?; }

# own FILE ARGUMENTS...: written, refused, replaced with --force; a foreign one is not
own() {
	file=$1
	shift
	try "$@"
	if grep -q 'was built without\|need cairo' err; then
		skip "$file" "$(head -n 1 err)"
		return
	fi
	result "$file is written" test "$got" -eq 0 -a -s "$file"
	try "$@"
	result "is not replaced" told "$file: exists (--force replaces it)"
	try "$@" --force
	result "but with --force" test "$got" -eq 0
	: >"$file"
	try "$@" --force
	result "or where it is empty" test "$got" -eq 0 -a -s "$file"
	cp foreign "$file"
	try "$@"
	result "a foreign one is not" told "$file: exists and was not written by matvib (choose another name)"
	beside "$file" "$@"
	rm -f "$file" "$file.ini"
}
# beside FILE ARGUMENTS...: a foreign file of that name is not replaced by them, with --force either
beside() {
	file=$1
	shift
	cp foreign "$file"
	try "$@" --force
	result "a foreign $file is not replaced with --force" told "$file: exists and was not written by matvib (choose another name)"
	result "and is what it was" cmp foreign "$file"
	rm -f "$file"
}
own a.csv run own.ini --quiet --series a.csv
own semi.csv run own.ini --quiet --series semi.csv --dialect semicolon
own p.csv run own.ini --quiet --particles p.csv
own n.csv run own.ini --quiet --nodes n.csv --stages 1:2
own b.csv run supported-beam-coarse --steps 2 --quiet --bonds b.csv
own v.vtu run own.ini --quiet --vtk v
beside v-0001.vtu run own.ini --quiet --frames 2 --vtk v
beside v.pvd run own.ini --quiet --frames 2 --vtk v
beside a.csv.ini run own.ini --quiet --series a.csv
for ending in svg pdf png; do
	own "f.$ending" figure own.ini --view energies --quiet --output "f.$ending"
done
for ending in cast svg gif; do
	own "m.$ending" movie own.ini --quiet --output "m.$ending"
done
own s.wav sound mode5 --end 20 --quiet --seconds 1 --output s.wav
own fit.csv fit mode5 --data data.csv --vary bar.youngs_modulus --quiet --output fit.csv
own fit.svg fit mode5 --data data.csv --vary bar.youngs_modulus --quiet --figure fit.svg
own d.csv diagnose mode5 data.csv --quiet --output d.csv
own w.csv sweep own.ini --vary initial.mode=1,2 --quiet --output w.csv
own g.csv grade homework-late ada.session --quiet --output g.csv
own m.csv grade homework-late ada.session --quiet --output /dev/null --moodle m.csv --bom
own g.pdf grade homework-late ada.session --quiet --output /dev/null --sheet g.pdf
own h.pdf lesson homework-late --handout h.pdf
own r.session own.ini --script two.script --record r.session

# spared NAME FILE ARGUMENTS...: what is read is not written, as FILE or whatever else it is called there
spared() {
	kept=$1 file=$2
	shift 2
	cp "$kept" before
	try "$@" --force
	result "$*: refused" told "$file: the output would overwrite an input"
	result "$kept is what it was" cmp before "$kept"
}
ln -s own.ini link.ini
mkdir inside && cp own.ini v-0001.vtu && cp own.ini x.svg && cp own.ini x.cast && cp own.ini x.wav
"$MATVIB" run mode5 --end 20 --series data.svg --quiet
for option in series particles nodes; do
	spared own.ini own.ini run own.ini --quiet --$option own
done
spared own.ini own.ini run own.ini --quiet --series own.ini
spared own.ini link.ini run own.ini --quiet --series link.ini
spared own.ini own.ini run link.ini --quiet --series own
spared own.ini ./own.ini run inside/../own.ini --quiet --particles ./own.ini
spared v-0001.vtu v-0001.vtu run v-0001.vtu --quiet --frames 2 --vtk v
spared own.ini own.ini sweep own.ini --vary initial.mode=1,2 --quiet --output own
spared x.svg x.svg figure x.svg --view energies --quiet --output x.svg
spared x.cast x.cast movie x.cast --quiet --output x.cast
spared x.wav x.wav sound x.wav --quiet --output x.wav
spared data.csv data.csv fit mode5 --data data.csv --vary bar.density --quiet --output data.csv
spared data.svg data.svg fit mode5 --data data.svg --vary bar.density --quiet --figure data.svg
spared data.csv data.csv diagnose mode5 data.csv --quiet --output data.csv
spared ada.session ada.session grade homework-late ada.session --quiet --output ada.session
spared own.lesson own.lesson grade own.lesson ada.session --quiet --moodle own.lesson
for read in own.ini two.script; do
	spared $read $read own.ini --script two.script --record $read
done
spared own.lesson own.lesson lesson own.lesson --script two.script --record own.lesson
spared ada.session ada.session --replay ada.session --script two.script --record ada.session
# a scenario that a lesson opens is known only when it has been read
mkdir class && "$MATVIB" show mode1 >class/short.ini && cp class/short.ini before
printf '@title Own\n@about For the test\n@page Words\n@do open short.ini\nText.\n' >class/own.lesson
try lesson class/own.lesson --script two.script --record class/short.ini --force
result "nor by a lesson's" cmp before class/short.ini
echo "1..$number"
