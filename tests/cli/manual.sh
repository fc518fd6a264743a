#!/bin/sh
# The manual pages: without a warning, in step with the program, and their examples work.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
# a page made in the build tree counts, one of the tarball otherwise
man=$MATVIB_SRCDIR/man

plain() { sed 's/\\-/-/g; s/\\e/\\/g; s/\\(aq/'"'"'/g; s/\\(ha/^/g' "$1"; }
examples() { plain "$1" | awk '/^\.EE/ { on = 0; print "" } on { print } /^\.EX/ { on = 1 }'; }
quiet() { test ! -s "$1" || { cat "$1" && false; }; }

if command -v groff >/dev/null 2>&1; then
	for page in matvib.1 matvib.5; do
		groff -ww -K utf8 -man -Tutf8 "$man/$page" >page.txt 2>warnings
		result "$page is formatted without a warning" quiet warnings
	done
fi

# every command that stands in an example runs, in the order of the page
PATH=$(dirname "$MATVIB"):$PATH
examples "$man/matvib.1" | grep '^[a-z]' >commands
result "matvib.1 has examples" test "$(wc -l <commands)" -ge 4
while read -r line; do
	result "$line" sh -c "$line"
done <commands

# every scenario that stands in an example reads back
examples "$man/matvib.5" | awk '/^\[scenario\]/ { n++ } n { print > ("example" n ".ini") }'
result "matvib.5 has examples" test -s example3.ini
for file in example*.ini; do
	result "$file of matvib.5" "$MATVIB" show "$file"
done

"$MATVIB" params >params
missing=
for key in $(sed -n 's/^  \([a-z_]*\.[a-z_]*\) = .*/\1/p' params | sort -u); do
	plain "$man/matvib.5" | grep -q "^.fB$key.fR" || missing="$missing $key"
done
result "matvib.5 knows every parameter:$missing" test -z "$missing"
missing=
for name in $("$MATVIB" list | cut -d' ' -f1); do
	plain "$man/matvib.1" | grep -q "^.fB$name.fR\$" || missing="$missing $name"
done
result "matvib.1 knows every scenario:$missing" test -z "$missing"
printf 'zebra\n' | "$MATVIB" --script - 2>&1 | sed -n 's/.*instruction: zebra (\(.*\))/\1/p' | tr -d '|' >known
missing=
for word in $(cat known); do
	plain "$man/matvib.1" | grep -q "^.fB$word.fR" || missing="$missing $word"
done
result "matvib.1 knows every instruction of a script:$missing" test -s known -a -z "$missing"
echo "1..$number"
