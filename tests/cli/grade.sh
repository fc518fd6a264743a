#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Homework from both sides: a student does it and records a session; the teacher marks sessions that are right,
# wrong, missing, cut, foreign, damaged, edited or hostile, has a key and a handout. Marks come from what keys do.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
subcommand=grade
printf 'leak:libfontconfig\nleak:libcairo\n' >"$scratch/.leaks"
LSAN_OPTIONS="suppressions=$scratch/.leaks:print_suppressions=0${LSAN_OPTIONS:+:$LSAN_OPTIONS}"
export LSAN_OPTIONS

cat >own.lesson <<'END'
@title Own homework
@about For the test
@page Frequency
@do open mode5
@do set time.end 20
@variant initial.mode from 3 to 12
Mode {initial.mode}.
@ask Its error, in percent?
@answer error within 2 %
@page Better
@do open mode5
@do set time.end 20
@field mesh.cell_size
@goal abs(error) < 2 % and cells <= 60 and time.end >= was time.end
@solve set mesh.cell_size 0.5
Below 2 %.
@page Choose
@do open mode5
@ask Which?
@right this
@choice that
@page Words
@ask Why, in your words?
@words
END

# the right number of page 1 for a name
key_of() { "$MATVIB" grade --key own.lesson --name "$1" | sed -n 's/^   \([-0-9.e]*\) within .*/\1/p'; }
# student NAME FILE: does what play.script says
student() { "$MATVIB" lesson own.lesson --name "$1" --record "$2" --script play.script; }
# row FILE SESSION PAGE: what stands in the table for it: value, right answer, mark, tries
row() { grep -e ",$2,[^,]*\$" "$1" | sed -n "s/^[^,]*,$3 [^,]*,//p" | cut -d, -f1-4; }
row_is() { test "$(row "$1" "$2" "$3")" = "$4"; }
remark_is() { grep -q -x -e "$3,,,,,,,$2,$4" "$1"; } # FILE SESSION NAME REMARK
marks() { cut -d, -f2,5,6 "$1" | sort; }
holds() { grep "$2" "$1" | grep -q "$3"; } # FILE LINE PATTERN: a line of the file has it

# --- the key ---
"$MATVIB" grade --key own.lesson --name "Ada Lovelace" >key 2>err
result "the key has a title and a name" says key '^Own homework   for Ada Lovelace$'
result "and the variant" says key '^  initial.mode = [0-9]*$'
result "the right choice" says key '^   this$'
result "a way to the goal" says key '^   one way: set mesh.cell_size 0.5 '
ada=$(key_of "Ada Lovelace")
mode=$(sed -n 's/^  initial.mode = //p' key)
"$MATVIB" run mode5 --end 20 --set initial.mode="$mode" >run.out
near() { awk -v key="$ada" '/^error/ { d = $3 - key; found = d < .01 && d > -.01 } END { exit !found }' run.out; }
result "its number is what a run says" near
other=
for name in "Emmy Noether" "Sofia K." "Max" "Lise" "Ida" "Karl"; do
	test "$(key_of "$name")" = "$ada" || other=$name
done
result "another name has another" test -n "$other"
result "and the same name the same" test "$(key_of '  Ada   Lovelace ')" = "$ada"

# --- sessions ---
cat >play.script <<END
wait 1
expect Mode $mode.
key Enter
type 1e9
key Enter
expect Not 1e9. Try again.
key Enter
type $ada
key Enter
expect Right:
key n b
wait 1
key Enter
type 5
key Enter
expect Not 5.
key n
wait 1
reject Done.
key :
type set mesh.cell_size 0.5
key Enter
key Space
wait 15
expect Done.
key n
wait 1
expect 1 or 2: your first answer counts
key 1 n
wait 1
key Enter
type =HYPERLINK("x")
key Enter
expect Kept for the teacher.
END
result "all right" student "Ada Lovelace" right.session
cat >play.script <<'END'
wait 1
key Enter
type 7,5
key Enter
key n
wait 1
key :
type set mesh.particles_per_cell 4
key Enter
key Space
wait 30
expect within 2 %. Met: cells, end.
key n
wait 1
key 2 b n 1
expect Your first answer counts: that.
END
result "all wrong" student "Emmy Noether" wrong.session
printf 'wait 1\nkey n n\n' >play.script
result "nothing done" student "-Max" missing.session
printf 'wait 1\nkey Enter\ntype four\nkey Enter\nexpect a number is expected\nkey Esc\n' >play.script
result "a word is no number" student Max word.session
cat >play.script <<'END'
wait 1
key n
wait 1
key :
type goto 10
key Enter
key :
type set mpm.flip_fraction 0.5
key Enter
key Space
wait 30
expect Not yet: a value was changed on
END
result "what was changed on the way meets no goal" student Max changed.session

expect "three sessions" 0 own.lesson right.session wrong.session missing.session --output marks.csv
result "nothing else is said" test ! -s out -a ! -s err
result "the table has a head" test "$(head -n 1 marks.csv)" = "name,exercise,value,right_answer,mark,tries,time,session,remark"
result "and four rows a session" lines marks.csv 13
result "the number is right, at the second try, and stays so" row_is marks.csv right.session 1 "$ada,$ada,1,2"
result "the goal is reached at once" row_is marks.csv right.session 2 "cell size 0.5,\"error within 2 %; cells at most 60; end at least 20\",1,1"
result "the choice is right" row_is marks.csv right.session 3 "this,this,1,1"
result "words have no mark, and are no formula" says marks.csv "^Ada Lovelace,4 Words,\"'=HYPERLINK(\"\"x\"\")\",,,1,"
result "a wrong number" holds marks.csv '^Emmy Noether,1 ' '^Emmy Noether,1 Frequency,7.5,-[0-9.]*,0,1,'
result "a goal that is missed" holds marks.csv '^Emmy Noether,2 ' ',0,1,[0-9]*,wrong.session,'
result "of a choice the first answer counts" row_is marks.csv wrong.session 3 "that,this,0,2"
result "what is missing" row_is marks.csv missing.session 1 ",,0,0"
result "a name is no formula" says marks.csv "^'-Max,"
result "an answer has its time in the session" sh -c "grep '^Ada Lovelace,2 ' marks.csv | cut -d, -f7 | awk '{ exit !(\$1 >= 1 && \$1 <= 40) }'"
refuse "the table is not overwritten" "marks.csv: exists (--force replaces it)" own.lesson right.session --output marks.csv
for threads in 1 2; do
	expect "$threads threads" 0 own.lesson right.session wrong.session missing.session --threads $threads --output "t$threads.csv"
done
result "the same marks at any number of threads" cmp t1.csv t2.csv
result "and the same again" cmp t1.csv marks.csv
expect "for a spreadsheet with a decimal comma" 0 own.lesson right.session --dialect semicolon
result "it has semicolons and commas" says out "^Ada Lovelace;1 Frequency;$(echo "$ada" | tr . ,);"

# --- a row for each student ---
cat >points.lesson <<'END'
@title Points
@about For the test
@page Number
@do open mode5
@do set time.end 20
@ask Its Courant number?
@answer time.courant within 1 %
@points 2.5
@page Choose
@do open mode5
@ask Which?
@right this
@choice that
@page Words
@ask Why?
@words
@points 4
END
# does NAME ID FILE: what play.script says
does() { "$MATVIB" lesson points.lesson --name "$1" ${2:+--id "$2"} --record "$3" --script play.script; }
printf 'wait 1\nkey Enter\ntype .1\nkey Enter\nexpect Right:\nkey n\nwait 1\nkey 2\n' >play.script
result "a first session" does "Zoë Ångström" 17 zoe-1.session
printf 'wait 1\nkey Enter\ntype 7\nkey Enter\nkey n\nwait 1\nkey 1\nkey n\nwait 1\nkey Enter\ntype so\nkey Enter\n' >play.script
result "a second one, without the ID" does "Zoë Ångström" "" zoe-2.session
printf 'wait 1\nkey Enter\ntype 77\nkey Enter\nkey n\nwait 1\nkey 1\nkey n\nwait 1\nkey Enter\ntype no\nkey Enter\n' >play.script
result "another of that name" does "Zoë Ångström" 18 zoe-3.session
printf 'wait 1\nkey n\n' >play.script
result "one who does nothing" does Bo bo@example.org bo.session
sed '/^end/d' bo.session | sed 's/^student .*/student Cut/' >cut-1.session
expect "a table of students" 1 points.lesson zoe-1.session zoe-2.session zoe-3.session bo.session cut-1.session \
	--output rows.csv --moodle students.csv --dialect semicolon --bom
result "rows and students begin with the mark of UTF-8" \
	test "$(head -qc 3 rows.csv students.csv | od -An -tx1 | tr -d ' \n')" = efbbbfefbbbf
tail -n +2 students.csv >students
cat >students.right <<'END'
17;Zoë Ångström;2,5;7,5;1 Number: right; 2 Choose: not right; 3 Words: to be read;4;2;
18;Zoë Ångström;1;7,5;1 Number: not right; 2 Choose: right; 3 Words: to be read;4;1;
bo@example.org;Bo;0;7,5;1 Number: no answer; 2 Choose: no answer; 3 Words: no answer;0;1;
bo@example.org;Cut;;7,5;;0;0;cut off: the end is missing
END
tr -d '"' <students >students.plain
result "the best of each exercise, a choice's first answer, weights, IDs" diff students.right students.plain
expect "for Moodle" 0 points.lesson bo.session --moodle moodle.csv --output /dev/null
result "its columns" test "$(head -n 1 moodle.csv)" = \
	"ID number,Full name,Grade,Maximum grade,Feedback comments,To read,Sessions,Remark"
refuse "it is not overwritten" "moodle.csv: exists (--force replaces it)" points.lesson bo.session --moodle moodle.csv
refuse "nor both tables in one" "$(pwd -P)/m.csv: two outputs cannot be the same file" points.lesson bo.session --output m.csv --moodle ./m.csv
refuse "what was the list's name is told" "--students: is --moodle FILE now, which writes; --roster FILE reads the list of the class" \
	points.lesson bo.session --students moodle.csv
# the list of the class, as Moodle exports it: who handed in nothing has a row
printf '\357\273\277First name,Surname,"ID number","Email address"\r\nKarl,Missing,19,karl@example.org\r\n"Zo\303\253",\303\205ngstr\303\266m,17,z@example.org\r\n\r\nBo,Other,bo@example.org,\r\n' >class.csv
expect "with the list of the class" 0 points.lesson zoe-1.session zoe-3.session bo.session --roster class.csv --moodle listed.csv --output listed.rows
cut -d, -f1-3,7,8 listed.csv | tail -n +2 | tr -d '"' >listed
cat >listed.right <<'END'
19,Karl Missing,,0,missing
17,Zoë Ångström,2.5,1,
bo@example.org,Bo Other,0,1,
18,Zoë Ångström,1,1,not in the list of the class
END
result "each has a row, in the list's order, by ID where the name is another" diff listed.right listed
result "one with an address" does "Zoe" Z@example.org address.session
expect "who has it in the list" 0 points.lesson address.session --roster class.csv --moodle address.csv --output /dev/null
result "is that student" says address.csv '^17,Zoë Ångström,.*,1,$'
result "who is missing has one among the marks" says listed.rows '^Karl Missing,,,,,,,,missing$'
result "the list is read and stays" grep -q Karl class.csv
printf 'sep=;\nName;Group\nKarl;A\n' >names.csv
expect "names alone" 0 points.lesson bo.session --roster names.csv
result "will do" says out '^Karl,,,,,,,,missing$'
printf 'Group,Points\nA,3\n' >none.csv
refuse "no names" "none.csv:1: no column of names in the head (Full name, or First name and Surname; ID number where there is one)" \
	points.lesson bo.session --roster none.csv
printf 'Full name,ID number\n"Karl,7\n' >open.csv
refuse "a quote that stays open" "open.csv:2: a quote is not closed" points.lesson bo.session --roster open.csv
printf 'Full name,ID number\nKarl,7\n Karl ,7\n' >twice.csv
refuse "one twice" "twice.csv:3: Karl: listed twice (give each an ID number)" points.lesson bo.session --roster twice.csv
refuse "the list is no output" "class.csv: the output would overwrite an input" points.lesson bo.session --roster class.csv --moodle class.csv --force
refuse "nor a list that is given as one" "class.csv: exists and was not written by matvib (choose another name)" points.lesson bo.session --moodle class.csv --force

# --- what gets no mark ---
edited() { sed "$2" "$1" >"$3"; }
# sealed FILE TO: with the check that its lines have, as somebody who knows how would calculate it (FNV-1a by
# digits of 16 bits, the lowest first)
cat >seal.awk <<'END'
function exclusive_or(a, b,    r, p) {
	r = 0
	for (p = 1; a > 0 || b > 0; p *= 2) {
		if (a % 2 != b % 2) r += p
		a = int(a / 2); b = int(b / 2)
	}
	return r
}
BEGIN { for (i = 1; i < 256; i++) code[sprintf("%c", i)] = i; split("8997 33826 40164 52210", h, " ") }
function byte(c,    i, low, out) {
	low = h[1] % 256
	h[1] = h[1] - low + exclusive_or(low, c)
	# times 2^40 + 435
	out[1] = h[1] * 435; out[2] = h[2] * 435
	out[3] = h[3] * 435 + h[1] * 256; out[4] = h[4] * 435 + h[2] * 256
	for (i = 1; i <= 4; i++) {
		if (i < 4) out[i + 1] += int(out[i] / 65536)
		h[i] = out[i] % 65536
	}
}
/^check / { next }
{ print; line = $0 "\n"; for (k = 1; k <= length(line); k++) byte(code[substr(line, k, 1)]) }
END { printf "check %04x%04x%04x%04x\n", h[4], h[3], h[2], h[1] }
END
sealed() { LC_ALL=C awk -f seal.awk "$1" >"$2"; }
sealed right.session same.session
result "the test knows how a session is sealed" cmp right.session same.session

edited right.session 's/^student .*/student Emmy Noether/' stolen.session
edited right.session '/^at/{/ 1$/d}' less.session
edited right.session '/^end/d' cut.session
edited right.session '/^end/,$d' stopped.session
edited right.session '/^student/d' nameless.session
edited right.session 's/^version [0-9a-f]*/version 0123456789abcdef/' text.session
edited right.session 's/^\(version [0-9a-f]*\).*/\1 0.1/' program.session
edited right.session '/^version/d' free.session
version=$("$MATVIB" --version | sed 's/matvib //;q')
edited right.session 's/^end .*/end nowhere/' broken.session
head -c 120 right.session >half.session
head -c 3000 /dev/urandom >noise.session
: >empty.session
mkfifo pipe.session
printf 'key . .\n' >two.script
"$MATVIB" mode1 --record run.session --script two.script >/dev/null
"$MATVIB" lesson late --name Ada --record late.session --script two.script >/dev/null
# of one computer for many: each begins at the first page, and a script gives the same screens always
printf 'screen a\nkey n n\nwait 1\nkey n n\n' >four.script
for one in Ada Max Ada; do XDG_STATE_HOME=$scratch/shared "$MATVIB" lesson late --name $one --script four.script; done >shared.out
"$MATVIB" lesson late --script four.script >>shared.out
result "a lesson begins for each at its first page" test "$(grep -c '  1/' shared.out)" -eq 4
expect "what gets no mark" 1 own.lesson stolen.session less.session cut.session stopped.session nameless.session \
	text.session program.session free.session broken.session half.session noise.session empty.session none.session \
	pipe.session . run.session late.session right.session --output bad.csv
result "it is said how many" says err '^matvib: 17 of 18 sessions have no marks (see the remarks)$'
result "each has its row" lines bad.csv 22
result "a changed name" remark_is bad.csv stolen.session "Emmy Noether" "edited: checksum mismatch"
result "a key less" remark_is bad.csv less.session "Ada Lovelace" "edited: checksum mismatch"
result "no end" remark_is bad.csv cut.session "Ada Lovelace" "cut off: the end is missing"
result "no end and no check" remark_is bad.csv stopped.session "Ada Lovelace" "cut off: the end is missing"
result "no name" remark_is bad.csv nameless.session "" "foreign: no student name (matvib lesson NAME --name)"
result "another text" remark_is bad.csv text.session "Ada Lovelace" '"foreign: the session of another lesson, or of another version of this one"'
result "another version" remark_is bad.csv program.session "Ada Lovelace" "foreign: it is of another version of matvib (this is $version)"
result "of no version" remark_is bad.csv free.session "" "damaged: free.session: is not a session of matvib $version (it names no version)"
result "a broken line" says bad.csv '^,,,,,,,broken.session,damaged: broken.session:[0-9]*: not a place of a session (end STEP'
for file in half noise empty none pipe; do
	result "$file" says bad.csv "^,,,,,,,$file.session,\"*damaged: $file.session"
done
result "a folder" says bad.csv '^,,,,,,,.,damaged: .: cannot be read: Is a directory$'
result "the session of a run" remark_is bad.csv run.session "" "foreign: not the session of a lesson"
result "another lesson" remark_is bad.csv late.session "Ada" '"foreign: the session of another lesson, or of another version of this one"'
result "the good one among them has its marks" row_is bad.csv right.session 1 "$ada,$ada,1,2"

# sessions whose scenario cannot be read, as those of a version to come: a row for each, and nothing stays behind
mkdir unread && cp "$MATVIB_SRCDIR"/tests/fuzz/corpus/recording/cut-?.session right.session unread/
expect "what cannot be read among a class" 1 own.lesson unread/*.session --output unread/marks.csv
result "it is said how many" says err '^matvib: 3 of 4 sessions have no marks (see the remarks)$'
for file in 1 2 3; do
	result "number $file has a remark" says unread/marks.csv ",unread/cut-$file.session,\"*damaged: unread/cut-$file.session"
done
result "no file stays half" test "$(find unread -name '*.part' | wc -l)" -eq 0

# sealed anew: what the keys do is the defence
edited right.session "s/^student .*/student $other/" other.raw
sealed other.raw other.session
expect "stolen, and sealed anew" 0 own.lesson other.session --output stolen.csv
result "is wrong, for the name has another number" row_is stolen.csv other.session 1 "5,$(key_of "$other"),0,3"
cp right.session again.session
expect "the same twice, and under two names" 0 own.lesson right.session again.session other.session changed.session --output twins.csv
remark_of() { grep ",$1," "${2-twins.csv}" | sed 's/.*,//' | sort -u; }
result "the first is told of the second" test "$(remark_of right.session)" = "the same recording as again.session"
result "and the second of the first" test "$(remark_of again.session)" = "the same recording as right.session"
result "the third of its keys" test "$(remark_of other.session)" = "the same keys as right.session"
result "one of its own of nothing" test -z "$(remark_of changed.session)"
LC_ALL=C awk '/^at|^end/ { $3 = $3 + 1.5 "00"; $4 = "132x43" } { print }' right.session | sed "s/^student .*/student $other/" >resized.raw
sealed resized.raw resized.session
expect "copied on another screen, at other times" 0 own.lesson right.session resized.session --output resized.csv
result "is told" test "$(remark_of resized.session resized.csv)" = "the same keys as right.session"
expect "the one of the same keys before that of the same lines" 0 own.lesson other.session right.session again.session --output three.csv
result "the whole one is told" test "$(remark_of right.session three.csv)" = "the same recording as again.session"
edited right.session 's/^scenario .*/scenario other/;s/^| cell_size.*/| cell_size = 5/' scenario.raw
sealed scenario.raw scenario.session
expect "another scenario at the start, sealed anew" 0 own.lesson scenario.session --output scenario.csv
{
	head -n 1 marks.csv
	grep ,right.session, marks.csv
} >right.csv
result "changes no mark" test "$(marks scenario.csv)" = "$(marks right.csv)"
edited right.session 's/^at \([~0-9]*\) /at 19999999999 /' far.raw
sealed far.raw far.session
expect "keys from beyond the end" 0 own.lesson far.session --output far.csv
result "change no number" row_is far.csv far.session 1 "$ada,$ada,1,2"

# hostile: it writes nothing, and does not last
cat >play.script <<'END'
wait 1
key w
type spill.ini
key Enter
END
result "a session that writes" student Eve writes.session
result "has written" test -s spill.ini
rm -f spill*
rm -rf state
expect "is marked" 0 own.lesson writes.session --output w.csv
result "and writes nothing" test ! -e spill.ini
"$MATVIB" grade late late.session >out 2>err
result "the student's progress is not the teacher's" test ! -e state
cat >play.script <<'END'
wait 1
key :
type set time.courant 1e-9
key Enter
END
result "a session with many steps" student Eve long.raw
edited long.raw 's/^end .*/end 900000000 1.000 80x24/' longer.raw
sealed longer.raw long.session
expect "takes for ever" 1 own.lesson long.session --limit 1 --output long.csv
result "and gets no mark" remark_is long.csv long.session Eve "it takes too long to replay"
{
	sed '/^at/,$d' right.session
	yes 'at 0 0.000 1000x1000 h' | head -n 6000
	echo 'end 0 0.000 80x24'
} >many.raw
sealed many.raw many.session
expect "6000 keys on a large screen" 1 own.lesson many.session --limit 1 --output many.csv
result "get no mark" remark_is many.csv many.session "Ada Lovelace" "it takes too long to replay"

# --- the lesson's text, and the scenarios that it opens, which lie beside it ---
mkdir -p class
"$MATVIB" show mode5 | sed 's/^end = .*/end = 20/' >class/short.ini
sed 's/^@do open mode5/@do open short.ini/' own.lesson >class/own.lesson
printf 'wait 1\nkey Enter\ntype 5\nkey Enter\nexpect Not 5\n' >play.script
result "a scenario beside the lesson is found" "$MATVIB" lesson class/own.lesson --name Ida --record ida.session --script play.script
expect "and marked" 0 class/own.lesson ida.session --output ida.csv
result "with its number" holds ida.csv '^Ida,1 ' '^Ida,1 Frequency,5,-[0-9.]*,0,1,'
cp class/own.lesson commented
{ echo '# a word to teachers' && cat commented; } >class/own.lesson
edited class/short.ini 's/^end = 20/end = 20 # not long/' commented
{ echo '# no more' && cat commented; } >class/short.ini
expect "a comment changes nothing" 0 class/own.lesson ida.session --output ida2.csv
result "at all" cmp ida.csv ida2.csv
edited commented 's/^end = 20/end = 21/' class/short.ini
expect "another scenario does" 1 class/own.lesson ida.session --output ida3.csv
result "and is told" says ida3.csv 'foreign: the session of another lesson, or of another version of this one'
rm class/short.ini
refuse "a scenario that is missing" "class/own.lesson: class/short.ini: cannot be read: No such file or directory" class/own.lesson ida.session

# --- paper ---
if "$MATVIB" lesson own.lesson --handout probe.pdf >out 2>err; then
	result "a handout" test "$(head -c 5 probe.pdf)" = %PDF-
	"$MATVIB" lesson own.lesson --handout ada.pdf --name "Ada Lovelace" >out
	result "says that it was written" says out '^wrote ada.pdf$'
	"$MATVIB" lesson own.lesson --handout ada2.pdf --name "Ada Lovelace" >out
	result "the same bytes again" cmp ada.pdf ada2.pdf
	"$MATVIB" lesson own.lesson --handout ada.pdf >out 2>err
	result "it is not overwritten" says err '^matvib: ada.pdf: exists (--force replaces it)$'
	"$MATVIB" lesson own.lesson --handout ada.svg >out 2>err
	result "it is a PDF" says err '^matvib: ada.svg: not a file of pages (FILE.pdf)$'
	expect "a page for each" 1 own.lesson right.session cut.session --sheet sheet.pdf --output sheet.csv
	if command -v pdftotext >/dev/null 2>&1; then
		pdftotext -layout ada.pdf ada.txt
		result "with the name" says ada.txt 'Name: Ada Lovelace'
		result "her variant" says ada.txt "Mode $mode\\."
		result "the choices" says ada.txt '^ *1 *this$'
		result "and no answer" sh -c '! grep "cell_size 0.5" ada.txt'
		pdftotext -layout sheet.pdf sheet.txt
		result "the sheet has what was right" says sheet.txt '3 of 3 right'
		result "and why there are no marks" says sheet.txt 'No marks: cut off: the end is missing\.'
		result "two pages" test "$(tr -cd '\f' <sheet.txt | wc -c)" -eq 2
	else
		skip "the words of the pages" "no pdftotext"
	fi
else
	result "without cairo it is said" says err 'need cairo'
fi

# --- what ships: as a student does it and the teacher marks it ---
# solve: a script that does the right thing on each page, from the key
solve() {
	awk 'FNR == NR {
		if (sub(/^@page /, "")) { page++; choices = 0 }
		if (sub(/^@choice /, "") || sub(/^@right /, "")) { choices++; sub(/ if [a-z.]* is .*/, ""); choice[page, $0] = choices }
		next }
	/^[0-9]+ / { page = $1; for (; at < page - 1; at++) print "key n\nwait 2" }
	(page, substr($0, 4)) in choice { print "key " choice[page, substr($0, 4)] "\nwait 2" }
	/^   .* within .*\(/ { print "key Enter\ntype " $1 "\nkey Enter\nexpect Right:" }
	/^   one way: / { sub(/^   one way: /, ""); sub(/   \(.*/, ""); n = split($0, way, "; ")
		for (i = 1; i <= n; i++) print "key :\ntype " way[i] "\nkey Enter\nwait 1"
		print "key Space\nwait 15\nexpect Done." }
	/^   to be read/ { print "key Enter\ntype because\nkey Enter" }' "$MATVIB_SRCDIR/data/lessons/$1.lesson" key
}
# homework-crack takes as long as all the rest: with MATVIB_LONG alone
for lesson in late mistake roll ${MATVIB_WIDE:+energy} ${MATVIB_LONG:+crack}; do
	"$MATVIB" grade --key homework-$lesson --name "Ada Lovelace" >key 2>err
	result "homework-$lesson: a key" lines err 0
	{
		echo 'wait 2'
		solve homework-$lesson
	} >play.script
	result "homework-$lesson: all is done as the key says" "$MATVIB" lesson homework-$lesson --name "Ada Lovelace" \
		--script play.script --record homework-$lesson.session
	expect "homework-$lesson is marked" 0 homework-$lesson homework-$lesson.session --output $lesson.csv --threads 1
	wanted=$(grep -c -e ' within .*(' -e '^   one way' -e '^key [1-4]$' key play.script | awk -F: '{ sum += $2 } END { print sum }')
	result "homework-$lesson: every number, goal and choice is right" test "$(grep -c ',1,1,[0-9]*,[^,]*,$' $lesson.csv)" -ge "$wanted"
done

# --- a student without options ---
# begins TEXT: what stands on standard output of a lesson that is begun by lines and left again
begins() { printf ':goto 1\nq\n' | "$MATVIB" lesson "$1" --name "$2" --plain >out 2>err; }
mkdir -p hand && cp own.lesson hand
cd hand || exit 1
result "a name is all it takes" begins own.lesson " ../Zoë  O'Hara/"
result "the file to hand in is named" test "$(tail -n 1 out)" = "Hand in this file: own-Zoë-O-Hara.session"
result "and is there" test -s own-Zoë-O-Hara.session
cp own-Zoë-O-Hara.session before
result "once more" begins ../own.lesson "Zoë O'Hara"
result "is another file" test "$(tail -n 1 out)" = "Hand in this file: own-Zoë-O-Hara-2.session"
result "and the first is as it was" cmp before own-Zoë-O-Hara.session
result "and again" begins own.lesson "Zoë O'Hara"
result "the next" test -s own-Zoë-O-Hara-3.session
"$MATVIB" grade own.lesson own-Zoë-O-Hara.session >out 2>err
result "it is marked" says out "^\.\./Zoë O'Hara/,1 Frequency,,,0,0,,own-"
result "a name without letters" begins own.lesson "?!"
result "leaves the lesson's" test -s own.session
"$MATVIB" lesson own.lesson --name Ada --script /dev/null >out 2>err
result "a script keeps nothing by itself" test ! -e own-Ada.session
cd ..
mkdir gone
printf 'q\n' | (cd gone && rmdir ../gone && "$MATVIB" lesson late --name Ada --plain) >out 2>err
result "a folder that takes no file is told" says err '^matvib: late-Ada.session: '
result "before the first page" test ! -s out
"$MATVIB" lesson homework-late --print >out 2>err
result "a lesson of the program is printed" cmp out "$MATVIB_SRCDIR/data/lessons/homework-late.lesson"
{
	printf '\357\273\277'
	cat own.lesson
} >bom.lesson
"$MATVIB" grade --key bom.lesson >out 2>err
result "a lesson from Windows begins with a mark" lines err 0
expect "which is no other text" 0 bom.lesson right.session

# --- names of files ---
cp cut.session "$(printf 'x\033[31mred\nline')"
expect "a name that acts" 1 own.lesson "$(printf 'x\033[31mred\nline')"
result "is written out" says out 'x\\x1b\[31mred\\x0aline'
result "and breaks no line" lines out 2
refuse "table and pages in one file" "$(pwd -P)/m.pdf: two outputs cannot be the same file" own.lesson right.session --output m.pdf --sheet ./m.pdf
refuse "over a session" "right.session: the output would overwrite an input" own.lesson right.session --output right.session --force

# --- goals ---
cat >goal.lesson <<'END'
@title A goal
@about For the test
@page Better
@do open mode5
@do set time.end 20
@field mesh.cell_size
@goal abs(error) < 2 %
@solve set mesh.cell_size 0.5
Below 2 %.
END
cat >play.script <<'END'
wait 1
key :
type initial.mode=1
key Enter
key Space
wait 15
reject Done.
expect Not yet: initial.mode was changed
END
result "another run meets no goal" "$MATVIB" lesson goal.lesson --name "Lise" --script play.script

# --- refusals ---
refuse "no lesson" "LESSON SESSION... is missing (see: matvib --help)"
refuse "no session" "LESSON SESSION... is missing (see: matvib --help)" own.lesson
refuse "no such lesson" "latte: no such lesson or file (did you mean late?)" latte right.session
refuse "no limit" "--limit: not a number from 1 to 1e+06: soon" own.lesson right.session --limit soon
refuse "no folder for the table" "none/m.csv: there is no folder none" own.lesson right.session --output none/m.csv
refuse "a name without a key" "--name: goes with --key" own.lesson right.session --name Ada
refuse "a limit for a key" "--limit: does not go with --key" --key own.lesson --limit 5
refuse "a table for a key" "--output: does not go with --key" --key own.lesson --output key.csv
refuse "a key of one lesson" "right.session: is one argument too many (LESSON)" --key own.lesson right.session
subcommand=lesson
refuse "the key is the teacher's" "--key: is matvib grade --key LESSON" own.lesson --key
refuse "a handout of which lesson" "--handout: which lesson? (matvib lesson NAME --handout FILE.pdf)" --handout a.pdf
refuse "a lesson of one's own is no sample" "--print: own.lesson: is not a lesson of the program (matvib lesson --list)" own.lesson --print
refuse "a print of which lesson" "--print: which lesson? (matvib lesson NAME --print)" --print
refuse "an ID of nobody" "--id: goes with --name" own.lesson --id 17
refuse "an empty name" "--name: the name is empty" own.lesson --name " "
refuse "a name that acts" '--name: \x1b[2J: is not a name (UTF-8 without control characters)' own.lesson --name "$(printf '\033[2J')"
sed 's/^@solve.*/@solve set mesh.cell_size 2.5/' own.lesson >stuck.lesson
"$MATVIB" grade --key stuck.lesson >out 2>err
result "a way that leads elsewhere is told" says err '^matvib: page 2: its own way misses the goal: Not yet: error [0-9.]* %, must be within 2 %'
sed 's/^@variant.*/@variant mesh.cell_size from 0.61 to 0.62/;s/{initial.mode}/m/' own.lesson >odd.lesson
"$MATVIB" grade --key odd.lesson >out 2>err
result "a variant that the scenario cannot have is told" says err '^matvib: page 1: set mesh.cell_size 0.6'
# judged LINES: what a key says of a lesson whose first page ends so
judged() {
	printf '@title x\n@page y\n@do open mode5\n@do set time.end 20\n%b\n' "$1" >judged.lesson
	"$MATVIB" grade --key judged.lesson >out 2>err
}
judged '@do set mpm.algorithm musl\n@ask a\n@answer energy_change within 0.1'
result "a tolerance that takes 0 is refused" says err '^matvib: page 1: its tolerance takes 0 too, which anybody may guess (right is '
judged '@do set mpm.algorithm musl\n@ask a\n@answer 100 + energy_change within 1 %'
result "or what it is at the start" says err '^matvib: page 1: its tolerance takes 100 too, which it is at the start (right is '
judged '@variant initial.mode from 3 to 12\n@ask a\n@answer error within 60 %'
result "or another student's answer" says err '^matvib: page 1: its tolerance takes -[0-9.]* too, the answer for initial.mode = '
judged '@variant initial.mode from 3 to 12\n@ask a\n@answer steps within 1 %'
result "an answer that no variant changes too" says err 'page 1: its tolerance takes 2000 too, the answer for initial.mode = '
judged '@goal abs(error) < 50 %\n@solve set mesh.cell_size 0.5'
result "and a goal that is fulfilled already" says err '^matvib: page 1: its run fulfils the goal as it is$'
sed 's/^@answer error/@answer crack_start/' own.lesson >unknown.lesson
"$MATVIB" grade --key unknown.lesson >out 2>err
result "an answer that the run does not have is told" says err '^matvib: page 1: what is right is not known of its run$'
echo "1..$number"
