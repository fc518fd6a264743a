#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What is added touches as few files as CONTRIBUTING.md says: of each kind of thing the one that the fewest files name,
# its own among them, is named by so many. What more of them name has users, which an addition need not have.
cd "${MATVIB_SRCDIR:-..}" || exit 1
number=0
# count KIND FUNCTION: the least number of files in the lines "NAME FILE" that the function prints
count() {
	number=$((number + 1))
	said=$(sed -nE "s/^\* \*\*$1\*\* \((one|two|three) files?[,)].*/\1/p" CONTRIBUTING.md)
	is=$($2 | sort -u | awk '
		{ files[$1]++ }
		END {
			for (name in files) if (!least || files[name] < least) least = files[name]
			split("one two three", words)
			print least in words ? words[least] : "in vain, " least + 0
		}')
	if [ "$is" = "$said" ]; then
		echo "ok $number - $1: $is"
	else
		echo "not ok $number - $1: $is, where CONTRIBUTING.md says ${said:-nothing}"
	fi
}
# named BEFORE BEHIND: each name that comes in, with the files of the program that name it with these around it
named() {
	while read -r name; do
		grep -rlE "$1$name$2" src | sed "s|^|$name |"
	done
}
# listed FILE...: each with itself and, where it is in there, the list of what is built and shipped
listed() {
	for file; do
		echo "$file $file"
		! grep -qF "$file" Makefile.am || echo "$file Makefile.am"
	done
}

# a member of a concern, and its row
parameters() {
	sed -nE 's/.*AT\([a-z_0-9]+\.([a-z_0-9]+)\).*/\1/p' src/scenario/parameter_rows.inc | sort -u | while read -r member; do
		echo "$member src/scenario/parameter_rows.inc"
		grep -lE "[ *]$member(\[[A-Z_]+\])?[,;]" src/scenario/concern_*.h | sed "s|^|$member |"
	done
}
problems() {
	sed -nE 's/^const Problem problem_([a-z_]+).*/\1/p' src/problems/*.c | while read -r name; do
		echo "$name" | named '(PROBLEM\(|^const Problem problem_)' '\>'
		echo "$name Makefile.am"
	done
}
views() {
	sed -nE 's/^ +VIEW\(([a-z_]+)\).*/\1/p' src/views/view_list.c | while read -r name; do
		echo "$name" | named '(VIEW\(|\<view_)' '\>'
		echo "$name Makefile.am"
	done
}
commands() {
	sed -nE 's/^COMMAND(_BY)?\([A-Z_0-9]+, (command_[a-z_0-9]+),.*/\2/p' src/help/command_rows.inc | sort -u | named '\<' '\>'
}
mistakes() {
	sed -nE 's/^MISTAKE\("([a-z_0-9]+)".*/\1/p' src/methods/mpm/mistake_rows.inc src/methods/mpm/bodies_mistake_rows.inc \
		src/methods/bonds/plane/bonds_mistake_rows.inc |
		named '"' '"'
}
scenarios() { listed data/scenarios/*.ini; }
lessons() { listed data/lessons/*.lesson; }
claims() {
	sed -nE 's/^\[([A-Za-z0-9-]+)\].*/\1/p' data/verify/*.claims | while read -r name; do
		grep -lF "[$name]" data/verify/*.claims | sed "s|^|$name |"
	done
}

count "a parameter" parameters
count "a problem" problems
count "a view of the laboratory" views
count "a command of the laboratory" commands
count "a mistake" mistakes
count "a scenario" scenarios
count "a lesson" lessons
count "a claim of \`verify\`" claims
echo "1..$number"
