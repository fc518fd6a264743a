#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The manual pages: without a warning, in step with the program, and their examples work.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
# a page made in the build tree counts, one of the tarball otherwise
man=$MATVIB_BUILDDIR/man
test -e "$man/matvib.1" || man=$MATVIB_SRCDIR/man

pages="matvib.1 matvib.5 matvib-screen.7 matvib-commands.7 matvib-equations.7 matvib-checks.7"

plain() { sed 's/\\-/-/g; s/\\e/\\/g; s/\\(aq/'"'"'/g; s/\\(ha/^/g' "$1"; }
examples() { awk '/^\.EE/ { on = 0; print "" } on { print } /^\.EX/ { on = 1 }' "$1.plain"; }
quiet() { test ! -s "$1" || { cat "$1" && false; }; }

if command -v groff >/dev/null 2>&1; then
	for page in $pages; do
		groff -ww -K utf8 -man -Tutf8 "$man/$page" >"$page.txt" 2>warnings
		result "$page is formatted without a warning" quiet warnings
	done
	result "matvib.1 is read in twenty minutes" test "$(wc -w <matvib.1.txt)" -le 4500
fi
if command -v mandoc >/dev/null 2>&1; then
	for page in $pages; do
		mandoc -T lint -W warning "$man/$page" >warnings 2>&1
		result "and mandoc finds no fault in $page" quiet warnings
	done
fi

for page in $pages; do
	plain "$man/$page" >"$page.plain"
done

# problems and methods are those of the program
printf '[scenario]\nproblem = x\n' >x.ini
problems=$("$MATVIB" show x.ini 2>&1 | sed 's/.*(\(.*\)).*/\1/')
result "the problems" sh -c 'grep -q -F -x ".B scenario.problem = $1"' - "$problems" <<END
$(plain "$MATVIB_SRCDIR/man/matvib.5.in")
END
both=$(echo "$problems" | tr -d '|' | tr ' ' '\n' | while read -r word; do
	"$MATVIB" params "$word" 2>/dev/null | sed -n '1s/^\([a-z-]*\) (mpm | pd).*/\1/p'
done | tr '\n' ' ')
result "those that both methods solve" test "$both" = "bar simply-supported-beam moving-cantilever "

# a bond's stiffness, what it bears and what it makes of a wave, of both influences
sed 's/\\ / /g' matvib.5.plain >formulas
for formula in 'c = 2E/(A delta^2)' 'c1 = E/(dx^2 sum over m of (1 - m dx/delta) w_m m)' 'w_m (1 - m dx/delta) (delta/dx)^2/(2 sum' \
	'c = 9 E / (\(*p \(*d^3)' 'c1 = 36 E / (\(*p \(*d^3)' 's0 = sqrt(4 \(*p G0 / (9 E \(*d))' 's0 = sqrt(5 \(*p G0 / (9 E \(*d))'; do
	result "matvib.5 has $formula" grep -q -F -e "$formula" formulas
done
"$MATVIB" params notched-beam >params
result "params has s0 of both" grep -q 's0 = sqrt(4 pi G0/(9 E delta)), conical influence 5 pi' params

# every command that stands in an example runs, in the order of the page
PATH=$(dirname "$MATVIB"):$PATH
for page in matvib.1 matvib-commands.7; do
	examples "$page" | grep '^[a-z]' >"$page.examples"
	result "$page has examples" test "$(wc -l <"$page.examples")" -ge 3
done
cat matvib.1.examples matvib-commands.7.examples >commands
while read -r line; do
	result "$line" sh -c "$line"
done <commands

# what else the pages and the README tell to type: beams for a few steps, sweeps for a few steps, the laboratory without keys.
# Some lines need what an earlier one wrote.
short() {
	case $1 in
	*" sweep supported-beam"*) echo "$1" | sed "s/--end 2e-3/--end 1e-4/" ;;
	*" figure "*" --at "*) echo "$1" | sed 's/notched-beam/notched-beam-coarse/; s/--at [^ ]*/--at 2e-5,4e-5/' ;;
	*" figure supported-beam"* | *" figure moving-cantilever"*)
		echo "$1 --end 1e-4" | sed 's/ supported-beam / supported-beam-coarse /; s/ moving-cantilever / moving-cantilever-coarse /'
		;;
	*" diagnose mode5 own.csv") echo "matvib run mode5 --end 1 --series own.csv --force --quiet && $1" ;;
	*" diagnose mode5 *.csv"*) echo "rm -f marks.csv && $1" ;; # of one folder, whose codes are right
	*" diagnose mode5 */own.csv"*) echo "mkdir -p ada && cp own.csv ada && $1 --force" ;;
	*" sound supported-beam-coarse"*) echo "$1 --end 1e-3" ;;
	*" run supported-beam"* | *" run notched-beam"*) echo "$1 --steps 10" | sed 's/ notched-beam / notched-beam-coarse /' ;;
	*" movie notched-beam-coarse"*) echo "$1 --to 2e-5" ;;
	*" verify") echo "$1 M-fig3" ;;
	"matvib run"* | "matvib movie"* | "matvib sound"* | "matvib fit"* | "matvib diagnose"* | "matvib figure"* | "matvib verify"* | "matvib sweep"*) echo "$1" ;;
	"matvib grade"*) echo "$1" ;;
	"matvib lesson homework-late") echo "printf ':goto 1\nq\n' | $1 --name Ada --plain" ;; # who asks is no pipe
	"matvib lesson "*" --record "*) echo "echo key . | $1 --script -" ;;
	"matvib list"* | "matvib params"* | "matvib show"*) echo "$1" ;;
	*" --plain") echo "$1 </dev/null" ;;
	*" --last") echo "mkdir -p ../state/matvib && cp a.session ../state/matvib/last.session && $1 --script - </dev/null" ;;
	*) echo "$1 --script - </dev/null" ;;
	esac
}
typed() { # FILE OF COMMANDS
	mkdir "in-$1"
	while read -r line; do
		result "$line" sh -c "cd in-$1 && $(short "$line")"
	done <"$1"
}
longer() { # PAGE: the commands between .nf and .fi
	awk '/^\.nf/ { on = 1; next } /^\.fi/ { on = 0 } on' "$1.plain" | sed -e ':a' -e '/\\$/N; s/\\\n *//; ta' | grep '^matvib '
}
longer matvib.1 >tutorial
longer matvib-commands.7 >commands
longer matvib-checks.7 >checks
result "matvib.1 has a tutorial" test "$(wc -l <tutorial)" -ge 3
result "matvib-commands.7 has longer examples" test "$(wc -l <commands)" -ge 7
told() { # FILE: the commands of a document
	sed -n 's/^    build\/\(matvib .*\)/\1/p' "$MATVIB_SRCDIR/$1" | sed 's/   *.*//'
}
told README.md >readme
told doc/guide.md >guide
result "the README has commands" test "$(wc -l <readme)" -ge 6
result "the guide has commands" test "$(wc -l <guide)" -ge 18
result "matvib-checks.7 has commands" test "$(wc -l <checks)" -ge 15
typed tutorial
typed commands
typed readme
typed guide
# these are of whole runs
if [ -n "$MATVIB_WIDE" ]; then
	typed checks
	# when bonds broke first, and how many have in the end
	broken() {
		awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "broken_bonds") c = i; next }
			$c > 0 && !first { first = $1 } { step = $1; last = $c } END { print first, step, last }' "in-checks/$1.csv"
	}
	broke() { test "$(broken "$1")" = "$2"; }
	result "bonds break as in PDMATLAB2D" broke octave "24 160 1480"
	result "and on its own plate" broke ornl "94 641 6236"
	result "and in LAMMPS" broke plate "92 641 6192"
fi

# every scenario that stands in an example reads back
examples matvib.5 | awk '/^\[scenario\]/ { n++ } n { print > ("example" n ".ini") }'
result "matvib.5 has examples" test -s example3.ini
for file in example*.ini; do
	result "$file of matvib.5" "$MATVIB" show "$file"
done

"$MATVIB" params >params
# knows PAGE WHAT: each of the sorted `names` stands in bold at the begin of a line of the page
knows() {
	sed -n 's/^.fB\([^\\]*\).fR.*/\1/p' "$1.plain" | sort -u >bold
	result "$1 knows every $2:$(comm -23 names bold | sed 's/^/ /' | tr -d '\n')" \
		sh -c 'test -s names && test -z "$(comm -23 names bold)"'
}
"$MATVIB" params | sed -n 's/^  \([a-z_]*\.[a-z_]*\) = .*/\1/p' | sort -u >names
knows matvib.5 parameter
"$MATVIB" list | cut -d' ' -f1 | sort -u >names
knows matvib.1 scenario
printf 'zebra\n' | "$MATVIB" --script - 2>&1 | sed -n 's/.*instruction: zebra (\(.*\))/\1/p' | tr -s '| ' '\n\n' | sort -u >names
knows matvib-screen.7 'instruction of a script'
"$MATVIB" --help | sed -n 's/^  matvib \([a-z]*\) .*/\1/p' | sort >names
sed -n 's/^\.SS matvib \([a-z]*\).*/\1/p' matvib.1.plain | sort >headings
result "matvib.1 has every command" sh -c 'test -s names && diff names headings'
if command -v mandoc >/dev/null 2>&1 && { command -v pandoc || command -v lowdown; } >/dev/null 2>&1; then
	result "the documents as HTML" "$MATVIB_SRCDIR/tools/html" "$MATVIB_SRCDIR" html "$MATVIB_BUILDDIR"/man/matvib.1
	for page in html/README.html html/doc/*.html; do
		grep -o 'href="[^"#]*' "$page" | sed 's/^href="//' | grep -v -e '^https\{0,1\}:' -e '^mailto:' |
			while read -r link; do test -e "$(dirname "$page")/$link" || echo "$link"; done >broken
		result "links of $page$(sed 's/^/ /' broken | tr -d '\n')" test ! -s broken
	done
else
	skip "the documents as HTML" "no mandoc, or neither pandoc nor lowdown"
fi
echo "1..$number"
