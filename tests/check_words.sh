#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The documents: turns of phrase that are not to be used (doc/words.md), links between files, the README's length, and that
# the teacher's guide has every lesson.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
cd "$MATVIB_SRCDIR" || exit 1

turns='\b(anew|whoever|as far as they go|is no (number|factor|name|scenario|problem|view|figure)|stands? (in|beside|there|under)|what of (a|it|the))\b'
grep -rnE "$turns" src man/*.in data README.md CONTRIBUTING.md >"$scratch/turns"
result "at most ten turns that doc/words.md replaces ($(wc -l <"$scratch/turns"))" test "$(wc -l <"$scratch/turns")" -le 10
result "the README has at most 140 lines" test "$(wc -l <README.md)" -le 140

# every relative link of a document leads to a file
for file in README.md CONTRIBUTING.md doc/*.md; do
	grep -o '](\([^)]*\))' "$file" | sed 's/^](//; s/)$//; s/#.*//' | grep -v -e '^https\{0,1\}:' -e '^mailto:' -e '^$' |
		while read -r link; do test -e "$(dirname "$file")/$link" || echo "$link"; done >"$scratch/broken"
	result "links of $file$(sed 's/^/ /' "$scratch/broken" | tr -d '\n')" test ! -s "$scratch/broken"
done

email=$(sed -n 's/^email=//p' release.conf)
for file in README.md CITATION.cff codemeta.json $(test ! -d debian || echo debian/control); do
	result "$file has the address of release.conf" grep -q -F "$email" "$file"
done

for lesson in data/lessons/*.lesson; do
	name=$(basename "$lesson" .lesson)
	result "doc/teaching.md has an objective of $name" grep -q "^| \`$name\` | .* | .* | [0-9]* |$" doc/teaching.md
done
echo "1..$number"
