#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The tour of CONTRIBUTING.md goes through rooms that are there: each `function()` that it names is defined in the
# `src/...` file that it names next; each folder says in one line what it is for; and a comment names files that are there.
cd "${MATVIB_SRCDIR:-..}" || exit 1
grep -q '^## A tour' CONTRIBUTING.md || exit 1
number=0
steps=$(sed -n '/^## A tour/,/^## Where/p' CONTRIBUTING.md | tr '\n' ' ' | grep -oE '`[a-z_]+\(\)`[^`]*`src/[^`]*`' |
	sed -E 's/`([a-z_]+)\(\)`[^`]*`([^`]*)`/\1 \2/')
while read -r name file; do
	number=$((number + 1))
	if grep -qE "^[a-zA-Z][^;]*[ *]$name\(" "$file" 2>/dev/null; then
		echo "ok $number - $name stands in $file"
	else
		echo "not ok $number - $name stands in $file"
	fi
done <<END
$steps
END
if [ "$number" -gt 15 ]; then
	echo "ok $((number + 1)) - a key and a step are followed"
else
	echo "not ok $((number + 1)) - a key and a step are followed ($number places)"
fi
found=$(find src -name '*.[ch]' | sed 's/\/[^/]*$//' | sort -u | while read -r folder; do
	test -s "$folder/README" && test "$(wc -l <"$folder/README")" -eq 1 || echo "$folder"
done)
if [ -z "$found" ]; then
	echo "ok $((number + 2)) - each folder says in a line what it is for"
else
	echo "not ok $((number + 2)) - each folder says in a line what it is for: $(echo "$found" | tr "\n" " ")"
fi
gone=$({ find src tests tools -type f; echo --; find src tests -name '*.[ch]' -o -name '*.inc'; } | awk '
	/^--$/ { reading = 1; next }
	!reading { do have[$0]; while (sub(/^[^\/]*\//, "")); next }
	{ inside = 0
	for (row = 1; (getline line <$0) > 0; row++) {
		for (text = ""; line != "";) {
			at = index(line, inside ? "*/" : "/*")
			if (inside) text = text " " (at ? substr(line, 1, at - 1) : line)
			if (!at) break
			line = substr(line, at + 2); inside = !inside }
		while (match(text, /[A-Za-z0-9_][A-Za-z0-9_\/.-]*\.(c|h|inc|sh|py|awk)([^A-Za-z0-9_]|$)/)) {
			name = substr(text, RSTART, RLENGTH); text = substr(text, RSTART + RLENGTH)
			sub(/[^a-z]$/, "", name)
			if (!(name in have) && name !~ /NAME/) print $0 ":" row ":" name } }
	close($0) }')
if [ -z "$gone" ]; then
	echo "ok $((number + 3)) - comments name files that are there"
else
	echo "not ok $((number + 3)) - comments name files that are there: $(echo "$gone" | tr "\n" " ")"
fi
echo "1..$((number + 3))"
