#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# matvib figure as people type it: words and numbers of a page, kinds of files, bytes that repeat, refusals.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
subcommand=figure
# the libraries below cairo keep what they know of fonts to the end
printf 'leak:libfontconfig\nleak:libcairo\n' >"$scratch/.leaks"
LSAN_OPTIONS="suppressions=$scratch/.leaks:print_suppressions=0${LSAN_OPTIONS:+:$LSAN_OPTIONS}"
export LSAN_OPTIONS

# the words of an SVG, one text a line
words() { sed -n 's/^<text[^>]*>\(.*\)<\/text>$/\1/p' "$1"; }
has_word() { words "$1" | grep -q -F -x -e "$2"; }
begins() { test "$(head -c "$2" "$1")" = "$3"; }
larger() { test "$(wc -c <"$1")" -gt "$2"; }

# --- a plot ---
expect "the fifth mode over time" 0 mode5 --end 5 --view probe --output a.svg
result "says what it wrote" says out '^wrote a.svg$'
result "nothing on stderr" lines err 0
if command -v xmllint >/dev/null 2>&1; then
	result "it is well-formed" xmllint --noout a.svg
else
	skip "it is well-formed" "no xmllint"
fi
result "its title" has_word a.svg "Why is mode 5 late?"
result "the name of its upright axis" has_word a.svg "v"
result "with its index" has_word a.svg "cm"
result "and its power of ten" has_word a.svg " ×10⁻³"
result "that of the other" has_word a.svg "t"
for key in measured exact predicted; do
	result "the legend: $key" has_word a.svg $key
done
result "a number at a tick" has_word a.svg "−5"
result "a parameter" says a.svg '>particles/cell 2,<'
result "what is measured" says a.svg '>ω measured 5.415'

# the curve is the record: two rows fix where the page has its axes, all others must lie there
"$MATVIB" run mode5 --end 5 --series s.csv --quiet >out 2>err
compare() {
	sed -n 's/^<polyline.*stroke="#3d9ad6".* points="\([^"]*\)".*/\1/p' a.svg |
		awk '{ n = split($0, p, " "); if (n > most) { most = n; best = $0 } } END { print best }' | tr ' ' '\n' >curve
	tail -n +2 s.csv | cut -d , -f 2,3 >rows
	test "$(wc -l <curve)" -eq "$(wc -l <rows)" || return 1
	paste -d , curve rows | awk -F , '
		{ X[NR] = $1; Y[NR] = $2; t[NR] = $3; v[NR] = $4 }
		END {
			low = 1; high = 1
			for (i = 1; i <= NR; i++) { if (v[i] < v[low]) low = i; if (v[i] > v[high]) high = i }
			a = (X[NR] - X[1]) / (t[NR] - t[1]); b = (Y[high] - Y[low]) / (v[high] - v[low])
			for (i = 1; i <= NR; i++) {
				dx = X[i] - X[1] - a * (t[i] - t[1]); dy = Y[i] - Y[low] - b * (v[i] - v[low])
				if (dx * dx > .0009 || dy * dy > .0009) { print "row", i, dx, dy > "err"; bad = 1 }
			}
			exit bad || a <= 0 || b >= 0
		}'
}
result "every row lies where it should, to a hundredth of a point" compare

refuse "a page that is too small" 'probe: nothing to draw: the page is too small for it (at least 30x30 mm)' \
	mode1 --view probe --size 1x1 --end 1 --output small.svg
expect "signs of XML" 0 mode5 --end 5 --view probe --output xml.svg --set 'scenario.title=a<b>&"c'
result "are written as it wants them" says xml.svg '<title>.*a&lt;b&gt;&amp;&quot;c.*</title>'
result "everywhere" test -z "$(grep -F -e 'a<b' xml.svg)"
expect "it repeats" 0 mode5 --end 5 --view probe --output b.svg --quiet
result "the same bytes" cmp -s a.svg b.svg
result "quiet" lines out 0

# --- several times, another run, a size ---
expect "a profile at four times" 0 mode5 --view profile:stress --at 1,2,3,4 --output four.svg
for time in 1 2 3 4; do
	result "at $time" has_word four.svg "t = $time"
done
result "with one legend" test "$(words four.svg | grep -c -x measured)" -eq 1
expect "a run behind" 0 mode5 --end 3 --view probe --against mesh.cell_size=0.5 --output behind.svg
result "is named by what it was" has_word behind.svg "a: cell size 0.5"
expect "two runs behind" 0 mode5 --end 3 --view energies --against mesh.cell_size=1/2 --against mesh.cell_size=0.25 \
	--output three.svg
result "the first is named" has_word three.svg "a: cell size 0.5"
result "the second is named" has_word three.svg "b: cell size 0.25"
expect "the same run twice behind" 2 mode5 --view probe --against mesh.cell_size=0.5 --against mesh.cell_size=1/2 --output x.svg
expect "five runs behind" 2 mode5 --view probe --against initial.mode=1 --against initial.mode=2 --against initial.mode=3 \
	--against initial.mode=4 --against initial.mode=6 --output x.svg
expect "a size in millimetres" 0 mode1 --end 5 --view energies --size 100x70 --output small.svg
result "is kept" says small.svg '<svg.* width="100mm" height="70mm"'
result "and parameters give way to the curves, results do not" sh -c 'grep -q lumping small.svg && ! grep -q particles/cell small.svg'
refuse "a page that is too low" 'low.svg: 30 mm are too low for this page (at least 57, or a wider one)' \
	mode1 --end 5 --view energies --size 30x30 --output low.svg

# --- bare ---
expect "curves and axes alone" 0 mode5 --end 5 --view probe --bare --output bare.svg
result "have their numbers" has_word bare.svg "−5"
result "no title" sh -c '! grep -q ">Why is mode 5 late?</text>" bare.svg'
result "no legend, parameters or results" sh -c '! grep -q -e ">measured<" -e "particles/cell" -e "ω measured" bare.svg'
# the frame of the axes: left of it are digits, the rest of the page is the picture
frame() {
	grep -o 'points="[^"]*"' bare.svg | tr -d 'a-z="' | tr ' ' '\n' | awk -F , '
		NF == 2 { if (!n++ || $1 > most) most = $1; if (n == 1 || $1 < least) least = $1 }
		END { exit !(least < 35 && most > 160 / 25.4 * 72 - 16) }'
}
result "the curve fills the page" frame
expect "several" 0 mode5 --end 5 --view profile --frames 2 --bare --output bare.svg --force
result "have their times" says bare.svg '>t = 5<'

# --- maps ---
expect "a cracked beam at three times" 0 notched-beam-coarse --set pd.spacing=2e-3 --set pd.horizon=8e-3 --view beam:damage --at 1e-4,1.8e-4,2.6e-4 --output crack.svg
if command -v xmllint >/dev/null 2>&1; then
	result "it is well-formed too" xmllint --noout crack.svg
else
	skip "it is well-formed too" "no xmllint"
fi
result "its colours are told once" test "$(words crack.svg | grep -c '^damage: ')" -eq 1
for time in 0.1 0.18 0.26; do
	result "at $time ms" has_word crack.svg "t = $time ms"
done
colours() { grep -o '<polygon fill="#[0-9a-f]*"' "$1" | sort -u | wc -l; }
result "damage has many colours" test "$(colours crack.svg)" -gt 60

expect "a beam in the colour of its scenario" 0 notched-beam-coarse --view beam --end 1e-5 --output own.svg
result "which is the energy density" says own.svg '>strain energy density'
expect "or in one that is named" 0 notched-beam-coarse --view beam:uy --end 1e-5 --output named.svg
result "which is uy" sh -c '! grep -q ">strain energy density" named.svg && grep -q ">displacement across the beam" named.svg'

sed 's/^colour = .*/colour = mises/' "$MATVIB_SRCDIR/data/scenarios/notched-beam-coarse.ini" >mises.ini
expect "a colour that the method has not" 2 mises.ini --view beam --output x.svg
result "is refused by file, line, key and what there is" says err \
	'^matvib: mises.ini:[0-9]*: view.colour: mises is not allowed (uy | ux | velocity | energy | damage | family |'
expect "what has no colours" 2 mode5 --set view.colour=uy --view probe --output x.svg
result "is told so" says err '^matvib: --set: view.colour: uy is not allowed (it is of beams and plates)$'

# a plate tells its rows; each sign of its map is one
set -- branching-coarse --view beam:damage --at 4e-5
expect "a plate" 0 "$@" --output plate.svg
result "its foot names its cut" says plate.svg 'cuts: notch 0 50% 50% 50%'
result "its loads" says plate.svg 'loads: top top 0% 100% 0 1.2'
result "and its probe" says plate.svg 'probe: 50% 100%'
result "two tips, two dots" test "$(grep -c '<circle.* fill="#d55e00"' plate.svg)" -eq 2
expect "a plate that is pressed" 0 "$@" --set loads.top.sy=-12e6 --set loads.bottom.sy=12e6 --output pressed.svg
heads() { grep '<polygon fill="#000000"' "$1"; }
result "arrows point where the load does" sh -c 'test "$1" != "$2"' - "$(heads plate.svg)" "$(heads pressed.svg)"

expect "errors of both signs" 0 supported-beam-coarse --view convergence --output both.svg
result "have a disc and a ring each in the legend" sh -c 'test "$(grep -c "<circle .*cy=\"32.81\"" both.svg)" -eq 2 && test "$(grep -c "<circle fill=\"#ffffff\"" both.svg)" -eq 2'
expect "the struck plate" 0 kalthoff-coarse --view beam:damage --end 1e-6 --output struck.svg
result "is drawn as it is, for it comes apart" sh -c "! grep -q \">u × \" struck.svg"
expect "the period of a beam without bonds" 0 supported-beam-mpm-coarse --view dispersion --end 1e-6 --output period.svg
result "depends on its cells" has_word period.svg "cell size, mm"
expect "one that was measured" 0 supported-beam-mpm-coarse --set beam.length=25mm --view dispersion --end 1e-4 --output period.svg --force
result "has no size but the one asked for" sh -c 'grep -q "its real size alone +0.00 %<" period.svg && ! grep -qw nan period.svg'

# the drawing is of the start, so the long run of the fine lattice is not made
expect "a beam with its dimensions" 0 notched-beam --view beam:drawing --output drawing.svg
for label in "210 mm" "65 mm" probe "60 MPa on 3 mm" "to scale" "t = 0 ms"; do
	result "with $label" has_word drawing.svg "$label"
done
result "and no axes" sh -c '! grep -q ">x, mm<" drawing.svg'
sed 's/^colour = .*/colour = drawing/' "$MATVIB_SRCDIR/data/scenarios/notched-beam.ini" >drawn.ini
expect "that of a scenario" 0 drawn.ini --view beam --output drawn.svg
result "is the same" cmp -s drawing.svg drawn.svg

# --- the other kinds ---
if "$MATVIB" figure mode1 --end 1 --view profile --output p.pdf >out 2>err; then
	result "a PDF" begins p.pdf 5 %PDF-
	result "is not empty" larger p.pdf 3000
	"$MATVIB" figure mode1 --end 1 --view profile --output q.pdf >out 2>err
	result "and repeats" cmp -s p.pdf q.pdf
	expect "a PNG" 0 mode1 --end 1 --view profile --output p.png
	result "is one" sh -c 'test "$(od -An -N8 -tx1 p.png | tr -d " \n")" = 89504e470d0a1a0a'
	result "1890 dots wide" sh -c 'test "$(od -An -j16 -N4 -tx1 p.png | tr -d " \n")" = 00000762'
	result "and not one colour" larger p.png 20000
	"$MATVIB" figure mode1 --end 1 --view profile --output q.png >out 2>err
	result "and repeats too" cmp -s p.png q.png
else
	result "without cairo a PDF is refused in one line" lines err 1
	result "which says what is missing" says err '^matvib: .*cairo'
	for name in "is not empty" "and repeats" "a PNG" "is one" "1890 dots wide" "and not one colour" "and repeats too"; do
		skip "$name" "built without cairo"
	done
fi

# --- the commands of the manual know their views ---
sed 's/\\-/-/g' "$MATVIB_SRCDIR/man/matvib.1.in" "$MATVIB_SRCDIR/man/matvib-commands.7.in" | sed -n 's/^matvib figure \([^ ]*\).*--view \([^ ]*\).*/\1 \2/p' >documented
result "the papers' figures are in the manual, and one of its tutorial" lines documented 9
while read -r scenario view; do
	"$MATVIB" figure "$scenario" --list >out 2>err
	result "$scenario has $view" grep -q "^$view\(:.*\)*$" out
done <documented

# --- what leaves the box is cut, not clipped ---
expect "a curve that falls below its axis" 0 mode5 --end 20 --view spectrum:fast --output cut.svg
result "has no clip path" sh -c '! grep -q "clip-path=" cut.svg'
lowest=$(sed -n 's/^<clipPath.* y="\([0-9.]*\)".* height="\([0-9.]*\)".*/\1 \2/p' cut.svg | awk '{ print $1 + $2 + 3 }')
result "and nothing below the ticks" sh -c "test -n '$lowest' && sed -n 's/^<polyline.* points=\"\(.*\)\".*/\1/p' cut.svg |
    tr ' ' '\n' | awk -F, '\$2 > $lowest + 0.02 { exit 1 }'"

# --- names and refusals ---
expect "the names" 0 notched-beam-coarse --list
result "of a map" says out '^beam:damage$'
result "of what a bar has not" sh -c '! grep -q shapes:slopes out'
expect "a view that is not there" 2 mode1 --view beam --output x.svg
result "in one line with all names" says err '^matvib: beam: no such view here (profile:u|v|stress'
expect "a kind that is none" 2 mode1 --view probe --output x.gif
result "says what is one" says err '^matvib: x.gif: not a figure file (FILE.svg, .pdf, .png, .tex or .gp)$'

# --- the source of other programs ---
# how many points a file's first curve has, and the last of them
points() { awk '/coordinates \{|<< END/ { n = 0; on = 1; next } on && /^\};|^END/ { print n, last; exit } on { n++; last = $0 }' "$1"; }
expect "curves for LaTeX" 0 mode5 --end 1 --view probe --output curves.tex
expect "curves for gnuplot" 0 mode5 --end 1 --view probe --output curves.gp
result "have the same points" sh -c "test '$(points curves.tex | tr -d '()' | tr , ' ')' = '$(points curves.gp)'"
"$MATVIB" run mode5 --end 1 --series curve.csv --quiet
result "which are those of the run" sh -c "test \"$(points curves.gp | awk '{ printf "%.6g %.6g", $2, $3 }')\" = \
    \"$(awk -F, '!/^#/ && !/^t/ { t = $2; v = $3 } END { printf "%.6g %.6g", t, 1000 * v }' curve.csv)\""
result "a legend" sh -c 'grep -q "^.addlegendentry{predicted}$" curves.tex && grep -q "title .predicted. with lines" curves.gp'
result "the power of ten is a formula" grep -q '^ylabel={v._cm $.times 10^{-3}$}' curves.tex
result "and braces in pairs" awk '{ n += gsub(/[{]/, "{") - gsub(/[}]/, "}") } END { exit n != 0 }' curves.tex
expect "bands, two times and letters" 0 two-discs --end 0.5 --at 0.1,0.5 --view energies --output bands.gp
expect "an axis by roots" 0 mode5 --end 30 --view dispersion --output roots.gp
if command -v gnuplot >/dev/null 2>&1; then
	for script in curves bands roots; do
		result "gnuplot draws $script.gp without a word" sh -c \
			"(echo 'set terminal svg; set output \"$script.svg\"'; cat $script.gp) | gnuplot >log 2>&1 && test ! -s log && test -s $script.svg"
	done
else
	skip "gnuplot draws curves, bands and roots" "no gnuplot here"
fi
expect "its own source may be replaced" 0 mode5 --end 1 --view probe --output curves.tex --force
expect "of both kinds" 0 mode5 --end 1 --view probe --output curves.gp --force
# before the run, which would be long
expect "no curves" 2 two-discs --end 1000 --view beam:mises --output map.tex
result "says so" says err "^matvib: [a-z.]*tex: the view has no curves, which .tex and .gp need (.svg, .pdf or .png)$"
result "and no file" test ! -e map.tex

cp a.svg c.svg
expect "an existing file is refused" 2 mode1 --view probe --output a.svg
result "and left alone" cmp -s a.svg c.svg
expect "unless it may be replaced" 0 mode1 --end 5 --view probe --output a.svg --force
result "then it is another" sh -c '! cmp -s a.svg c.svg'
expect "no view" 2 mode1 --output x.svg
expect "no file" 2 mode1 --view probe
expect "a folder that is not there" 2 notched-beam --view probe --output none/x.svg
expect "bodies have no spectrum" 1 two-discs --end 0.1 --view spectrum --output x.svg
result "and it says so" says err '^matvib: spectrum: nothing to draw: There is no frequency to look for here\.$'
expect "nothing to draw" 1 mode1 --end 0.1 --view spectrum --output x.svg
result "says why" says err 'needs more time'
expect "another run that is the same" 2 mode1 --view probe --against initial.mode=1 --output x.svg
expect "another run that cannot be" 2 mode1 --view probe --against initial.mode=-1 --output x.svg
result "names option and key" says err '^matvib: --against: initial.mode: '
expect "more times than a page has room for" 2 mode1 --view profile --frames 60 --output x.svg

# --- interrupted: the building, the run, and after it
interrupt() { # NAME HUNDREDTHS-OF-A-SECOND-OF-WORK ARGUMENTS...
	what=$1 work=$2
	shift 2
	"$MATVIB" figure "$@" --output x.svg >out 2>err &
	soon works $! "$work"
	kill -TERM $!
	ends $!
	result "interrupted $what: its status" test $? -eq 143
	result "no file" test ! -e x.svg
}
interrupt "while it builds" 20 supported-beam --set beam.length=2 --view probe
result "it says what was given up" says err '^matvib: .*cancelled$'
interrupt "while it runs" 20 mode5 --end 1e8 --view probe
result "it says so" says err '^matvib: .*\(interrupted\|cancelled\)$'
result "nothing was left behind" sh -c 'test -z "$(ls x.* *.part 2>/dev/null)"'
# cairo and the twenty libraries that it brings are mapped when a figure asks for them
if command -v ldd >/dev/null 2>&1 && ldd "$MATVIB" >out 2>&1; then
	result "a start maps no cairo" sh -c '! grep cairo out'
else
	skip "a start maps no cairo" "no ldd"
fi
echo "1..$number"
