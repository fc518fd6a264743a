#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Tables as courses write them (make.py) get the verdict of the list at first try, none wrongly named and no wrong code
# acquitted; so do some of codes drawn at random (drawn): bars, beams, plates by bonds and cells. Every third
# and some, and all with MATVIB_WIDE.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
list=$scratch/list
cat "$MATVIB_SRCDIR/tests/foreign/list" "$MATVIB_SRCDIR/tests/foreign/drawn" | grep -v '^#' |
	awk -v every=${MATVIB_WIDE:+1} '(NR + 1) % (every ? every : 3) == 0 || /^(021|drawn-(3[23]|4[26789]|5[0678]))\.csv/' >"$list"
tables=$(wc -l <"$list")
cut -d'|' -f4 "$list" | sort -u >settings
while read -r scenario sets; do
	wanted=$scenario${sets:+ $sets}
	# shellcheck disable=SC2046
	set -- $(awk -F'|' -v wanted="$wanted" -v folder="$MATVIB_SRCDIR/tests/foreign/files" '$4 == wanted { print folder "/" $1 }' "$list")
	# shellcheck disable=SC2086
	"$MATVIB" diagnose "$scenario" "$@" $sets --output judged.csv --force --quiet >said 2>>errors
	cat judged.csv
done <settings >all.csv
awk -F'|' 'NR == FNR { verdict[$1] = $2; what[$1] = $3; next }
	{ n = split($0, cell, ","); file = cell[1]; sub(/.*\//, "", file) }
	file in verdict {
		got = cell[2]; seen++
		line = $0; sub(/^[^,]*,[^,]*,/, "", line) # scheme,digits,mistake,stage; a scheme may be quoted
		scheme = line; if (sub(/^"/, "", scheme)) sub(/".*/, "", scheme); else sub(/,.*/, "", scheme)
		ids = line; sub(/^("[^"]*"|[^,]*),[^,]*,/, "", ids); sub(/,[^,]*$/, "", ids); ids = " " ids " "
		named = got == "mistake" || got == "one of"
		right = got == "right" || got == "right but"
		good = verdict[file] == "mistake" ? named && index(ids, " " what[file] " ") > 0 : got == verdict[file] && scheme == what[file]
		if (good) { count++; next }
		print "# " file ": " got ids ", not " verdict[file] " " what[file]
		if (right && verdict[file] == "mistake") acquitted++
		else if (named) misnamed++
	}
	END { print seen + 0, count + 0, misnamed + 0, acquitted + 0 }' "$list" all.csv >counts
grep '^#' counts
read -r seen good misnamed acquitted <<END
$(tail -n 1 counts)
END
result "the corpus has tables" test "$tables" -ge 40
result "all tables of the corpus are read" test "$seen" -eq "$tables"
result "of $tables tables $good are judged rightly" test "$good" -eq "$tables"
result "none has a wrong name" test "$misnamed" -eq 0
result "no wrong code is acquitted" test "$acquitted" -eq 0
echo "1..$number"
