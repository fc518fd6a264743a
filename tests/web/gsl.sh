#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# web/gsl-files has each file of GSL that the program needs, so that the page links: what the linker takes of the libraries here.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
libraries=$(for name in gsl gslcblas; do ${CC:-cc} -print-file-name=lib$name.a; done)
nm -D --undefined-only "$MATVIB" 2>/dev/null | grep -o 'gsl_.*' >called
if ! test -s called || echo "$libraries" | grep -qv /; then
	skip "files of GSL in the page" "no nm, or no library of GSL to read"
else
	# a member's definitions and needs; libtool numbers those of one name; coerce.c is for processors of another kind
	for library in $libraries; do nm "$library" 2>/dev/null; done | awk '
		NR == FNR { wanted[++last] = $1; next }
		/^[^ ]*\.o:$/ { files[++n] = $1; sub(/^lt[0-9]+-/, "", files[n]); sub(/\.o:$/, ".c", files[n]) }
		NF == 3 && $2 ~ /[TDRBVW]/ && !($3 in where) { where[$3] = n }
		NF == 2 && $1 == "U" { needs[n] = needs[n] " " $2 }
		END {
			for (i = 1; i <= last; i++) {
				if (!(wanted[i] in where) || taken[member = where[wanted[i]]]++) continue
				print files[member]
				count = split(needs[member], more, " ")
				for (j = 1; j <= count; j++) wanted[++last] = more[j]
			}
		}' called - | grep -vx coerce.c | sort >needed
	sed 's,.*/,,' "$MATVIB_SRCDIR/web/gsl-files" | sort >listed
	comm -23 needed listed >out
	result "files of GSL are seen" test "$(wc -l <needed)" -gt 100
	result "and the page has each" test ! -s out
fi
echo "1..$number"
