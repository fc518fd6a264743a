#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The documents: turns of phrase that are not to be used (doc/words.md), links between files, the README's length, and that
# the teacher's guide has every lesson's objective, prerequisites and minutes as its file says them.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
cd "$MATVIB_SRCDIR" || exit 1

turns='\b(anew|whoever|as far as they go|is no (number|factor|name|scenario|problem|view|figure)|stands? (in|beside|there|under|its|their|the)|what of (a|it|the))\b'
grep -rniE "$turns" src man/*.in data web/*.js web/*.html tools README.md CONTRIBUTING.md >"$scratch/turns"
# what people read says where a thing is without that verb; it may stand for another, or still
grep -rniE '\bstands?\b' man/*.in data README.md NEWS CONTRIBUTING.md doc/*.md | grep -viE '\bstands? (for|still)\b' >>"$scratch/turns"
result "no turn that doc/words.md replaces ($(wc -l <"$scratch/turns"))" test ! -s "$scratch/turns"
result "the README has at most 140 lines" test "$(wc -l <README.md)" -le 140

# every relative link of a document leads to a file
for file in README.md CONTRIBUTING.md doc/*.md; do
	grep -o '](\([^)]*\))' "$file" | sed 's/^](//; s/)$//; s/#.*//' | grep -v -e '^https\{0,1\}:' -e '^mailto:' -e '^$' |
		while read -r link; do test -e "$(dirname "$file")/$link" || echo "$link"; done >"$scratch/broken"
	result "links of $file$(sed 's/^/ /' "$scratch/broken" | tr -d '\n')" test ! -s "$scratch/broken"
done

# version, date and addresses are those of release.conf
named="README.md NEWS $(echo man/*.in) CITATION.cff codemeta.json data/org.example.matvib.metainfo.xml
	$(test ! -d debian || echo debian/changelog debian/control debian/copyright debian/watch)"
mkdir "$scratch/named" && tar -chf - release.conf $named | tar -xf - -C "$scratch/named"
result "make addresses has been run" sh -c "tools/addresses '$scratch/named' && for file in $(echo $named); do diff \$file '$scratch/named/'\$file || exit 1; done"
sed 's/@.*/@host.test/; s/^date=.*/date=2030-01-02/; s/^tag=.*/tag=/; s|//[^/]*|//host.test|' release.conf >"$scratch/named/release.conf"
tools/addresses "$scratch/named"
for file in $(echo $named | sed 's/ NEWS / /'); do
	result "$file: no other address is left" sh -c "grep -q 'host.test\|2030-01-02' '$scratch/named/$file' && ! grep '@example\|//example\|2026-11-23' '$scratch/named/$file'"
done

# NEWS, the package and the software catalogues name the same versions, and NEWS the numbers of mistakes that there are
sed -n 's/^matvib \([0-9][^ ]*\)$/\1/p' NEWS >"$scratch/versions"
result "NEWS names two versions or more" test "$(wc -l <"$scratch/versions")" -ge 2
test ! -d debian ||
	result "debian/changelog names those of NEWS" sh -c "sed -n 's/^matvib (\([^)]*\)-1).*/\1/p' debian/changelog | diff '$scratch/versions' -"
result "the metainfo names those of NEWS" sh -c "sed -n 's/.*<release version=\"\([^\"]*\).*/\1/p' data/*.metainfo.xml | diff '$scratch/versions' -"
mistakes() { "$MATVIB" params bar | sed -n "s/^  $1\.mistake .*one of \([0-9]*\):.*/\1/p"; }
result "NEWS counts the mistakes" grep -q ": $(mistakes mpm) mistakes of the bar .* and $(mistakes pd) of bonds;" NEWS

if command -v codespell >/dev/null 2>&1; then
	result "no word is misspelt" codespell -L "$(tr '\n' ',' <tests/words)" src man/*.in data README.md NEWS CONTRIBUTING.md doc tools python
else
	skip "no word is misspelt" "no codespell"
fi
# British spelling (doc/words.md): prose without code, literals, names in capitals and short words
prose() {
	sed -E 's/`[^`]*`/ /g; s/\]\([^)]*\)/ /g; s/"[^"]*"/ /g' README.md NEWS CONTRIBUTING.md doc/*.md
	sed -E '/^\.(nf|EX|de)/,/^\.(fi|EE|\.)/d; /^\.\\"/d; /^\.(TH|B|BI|BR|ft) /d; s/\\f[BI][^\\]*\\f[RP]/ /g; s/\\\(..//g' man/*.in
	sed '/^@\(do\|until\|keys\|set\|key\|goal\)/d' data/lessons/*.lesson
	sed -n 's/^\(about\|title\) = //p; /^    /p' data/scenarios/*.ini
}
if echo colour | hunspell -d en_GB -l >"$scratch/unknown" 2>&1 && ! test -s "$scratch/unknown"; then
	prose | hunspell -d en_GB -p /dev/null -l | sed "s/'s$//" | grep -vE "[A-Z].*[A-Z]|[^A-Za-z']|^.{1,3}$" |
		LC_ALL=C sort -u | LC_ALL=C comm -23 - tests/spelling >"$scratch/unknown"
	result "every word is in the dictionary or in tests/spelling:$(sed 's/^/ /' "$scratch/unknown" | tr -d '\n')" test ! -s "$scratch/unknown"
else
	skip "every word is in the dictionary or in tests/spelling" "no hunspell with en_GB"
fi

tr -d '`' <doc/teaching.md >"$scratch/teaching"
for lesson in data/lessons/*.lesson; do
	name=$(basename "$lesson" .lesson)
	row=$(sed -n 's/^@objective //p' "$lesson")" | $(sed -n 's/^@prerequisites //p' "$lesson" | grep . || echo none) | $(sed -n 's/^@minutes //p' "$lesson")"
	result "doc/teaching.md: $name | $row" grep -qFx "| $name | $row |" "$scratch/teaching"
done
echo "1..$number"
