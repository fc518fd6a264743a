#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Completion: what bash offers for a line, in step with the program, and fish the same; zsh only reads the file.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
folder=$MATVIB_BUILDDIR/completion
test -e "$folder/matvib" || folder=$MATVIB_SRCDIR/completion
touch mine.ini

# shellcheck disable=SC1091
. "$folder/matvib"
offered() {
	COMP_LINE=$1 COMP_POINT=${#1}
	COMPREPLY=()
	_matvib
	printf '%s\n' "${COMPREPLY[@]}"
}
offers() { # LINE WORD
	offered "$1" | grep -q -x -F -e "$2" || { offered "$1" && false; }
}
offers_no() { ! offers "$@"; }
offers_only() {
	test "$(offered "$1" | tr '\n' ' ')" = "$2 " || { offered "$1" && false; }
}

result "a command" offers 'matvib ver' verify
result "a scenario to open" offers 'matvib notched' notched-beam
result "a file too" offers 'matvib run mi' mine.ini
result "no command behind a command" offers_no 'matvib run ver' verify
result "an option of the laboratory" offers 'matvib mode5 --pa' --paused
result "not one of another command" offers_no 'matvib run mode5 --' --paused
result "the choices of an option" offers_only 'matvib mode5 --glyphs br' braille
result "the choices behind its sign" offers_only 'matvib mode5 --glyphs=as' ascii
result "a key" offers_only 'matvib run mode5 --set mesh.cell' mesh.cell_size=
result "the values of a key" offers_only 'matvib run mode5 --set mpm.algorithm=us' "usf usl"
result "keys of a sweep" offers 'matvib sweep mode5 --vary mpm.sha' mpm.shape=
result "a problem" offers_only 'matvib params simply' simply-supported-beam
result "a name of verify" offers_only 'matvib verify P-table' P-table1
result "nothing for a number" offers_only 'matvib run mode5 --every ' ''
cd / && COMP_WORDBREAKS=' ' result "the whole word where the sign parts none" \
	offers_only 'matvib run mode5 --set mpm.algorithm=mu' mpm.algorithm=musl
cd "$scratch" || exit 1

for command in $("$MATVIB" --help | awk '/^  matvib/ && $2 !~ /^\[/ { print $2 }'); do
	result "$command is offered" offers 'matvib ' "$command"
	"$MATVIB" "$command" --help | grep -o -e '^  \(-., \)*--[a-z-]*' | sed 's|.*--|--|' | sort -u >known
	offered "matvib $command --" | grep -v -x -e --help | sort -u >seen
	result "options of $command" diff known seen
done
if command -v zsh >/dev/null 2>&1; then
	result "zsh can read its file" zsh -n "$folder/_matvib"
fi
if command -v fish >/dev/null 2>&1; then
	by_fish() { # LINE WORDS: what it offers, and nothing else
		offered=$(HOME=$scratch fish --no-config -c "source '$folder/matvib.fish'; complete -C '$1'" | tr '\n' ' ')
		test "$offered" = "$2 " || { echo "$offered" && false; }
	}
	result "fish: a command" by_fish 'matvib ver' verify
	result "fish: the choices of an option" by_fish 'matvib mode5 --glyphs br' braille
	result "fish: the choices behind its sign" by_fish 'matvib mode5 --glyphs=as' --glyphs=ascii
	result "fish: a key" by_fish 'matvib run mode5 --set mesh.cell' mesh.cell_size=
	result "fish: the values of a key" by_fish 'matvib run mode5 --set mpm.algorithm=us' 'mpm.algorithm=usf mpm.algorithm=usl'
	result "fish: an option of a command" by_fish 'matvib mode5 --pau' --paused
	result "fish: a file too" by_fish 'matvib run mine' mine.ini
fi
echo "1..$number"
