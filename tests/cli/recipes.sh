#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The recipes of the manual do with other programs what they promise; those of programs that are missing are skipped.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
HOME=$scratch
export HOME
PATH=$(dirname "$MATVIB"):$PATH

# The block of the manual behind the comment `recipe: NAME`, as a script.
recipe() {
	sed 's/\\-/-/g; s/\\e/\\/g; s/\\(aq/'"'"'/g; s/\\&//g' "$MATVIB_SRCDIR/man/matvib-commands.7.in" |
		awk -v name="$1" '/^\.\\"/ { on = $0 ~ "recipe: " name "$"; next } /^\.fi/ { on = 0 } on && !/^\./ { print }'
}
# w as the summary of the run has it, to two in a thousand: zero crossings are counted in whole steps
measured() { awk -v w="$1" '$1 == "w" { d = $2 / w - 1; found = d * d < 4e-6 } END { exit !found }' log; }

recipe series >series.sh
result "the manual has the series" test -s series.sh
result "the series is written" sh series.sh
w=$(sed -n 's/^frequency *measured *\([0-9.]*\).*/\1/p' .printed)
result "its frequency is told" test -n "$w"

python=
for python in "${PYTHON:-python3}" /usr/bin/python3 ''; do
	"$python" -c 'import pandas' 2>/dev/null && break
done
if [ -n "$python" ]; then
	mkdir bin && ln -s "$(command -v "$python")" bin/python3
	recipe pandas >pandas.sh
	PATH=$scratch/bin:$PATH sh pandas.sh >log 2>&1
	result "pandas finds the frequency" measured "$w"
else
	skip "pandas finds the frequency" "no pandas here"
fi

if command -v gnuplot >/dev/null 2>&1; then
	recipe gnuplot >gnuplot.sh
	sh gnuplot.sh >log 2>&1
	result "gnuplot draws without a word" test ! -s log
	result "a picture with both curves" test "$(grep -c '<path stroke' mode5.svg)" -ge 2
	result "that are named" grep -q '>measured<' mode5.svg
else
	skip "gnuplot draws" "no gnuplot here"
fi

if command -v octave >/dev/null 2>&1; then
	recipe octave >octave.sh
	sh octave.sh >log 2>&1
	result "Octave finds the frequency" measured "$w"
else
	skip "Octave finds the frequency" "no Octave here"
fi

if command -v soffice >/dev/null 2>&1; then
	recipe libreoffice >libreoffice.sh
	sh libreoffice.sh >log 2>&1
	result "LibreOffice writes a sheet" test -s mode5.ods
	soffice --headless --convert-to csv:"Text - txt - csv (StarCalc)":44,34,76,1 --outdir back mode5.ods >log 2>&1
	rows=$(wc -l <mode5.csv)
	result "with every row" test "$(wc -l <back/mode5.csv)" -eq "$rows"
	result "whose cells are numbers" awk -F, 'NR == 2 { ok = $1 == 0 && $3 + 0 > 0.001 } END { exit !ok }' back/mode5.csv
else
	skip "LibreOffice writes a sheet" "no LibreOffice here"
fi
echo "1..$number"
