#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The laboratory where the system describes no terminals; and `make static`, if it was made: one file that needs
# nothing, in an empty root. Skipped where neither may be tried.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
static=$MATVIB_BUILDDIR/matvib-static
unset TERMINFO TERMINFO_DIRS
HOME=$scratch
export HOME

# what stands in the program is what its source says
if command -v tic >/dev/null 2>&1 && command -v infocmp >/dev/null 2>&1; then
	tic -x -o "$scratch/compiled" "$MATVIB_SRCDIR/data/terminfo/fallback.ti"
	for compiled in matvib-256 matvib-8; do
		described=$(awk -v name="\"$compiled\"" '/^{/ { on = index($0, name); next } on { gsub(/[ ",}]/, ""); printf "%s", $0 }' \
			"$MATVIB_SRCDIR/src/terminal/fallback.inc")
		TERMINFO=$described infocmp -1 -x "$compiled" 2>/dev/null | grep -v '^#' >is
		infocmp -A "$scratch/compiled" -1 -x "$compiled" | grep -v '^#' >wanted
		result "$compiled has a source" test -s wanted
		result "$compiled is what its source says" diff wanted is
	done
else
	skip "the compiled terminals" "no tic"
fi

# open NAME TERM COMMAND...: a terminal on which the laboratory is opened and left by q; what it drew is in `drawn`
open() {
	opened=$1
	: >drawn
	(soon says drawn 'v_cm' && printf q && soon says typescript 'COMMAND_EXIT_CODE\|Script done') |
		TERM=$2 timeout 600 script -qfec "$3" typescript >drawn 2>&1
	got=$?
	tr -c '[:print:]\n' ' ' <drawn >out
	result "$opened: left in peace" test "$got" -eq 0
	result "$opened: the plot is there" says drawn 'v_cm'
}

# shellcheck disable=SC2016 # it is for the shell inside
hidden='mount -t tmpfs none /usr/share/terminfo; for d in /lib/terminfo /etc/terminfo; do test ! -d $d || mount -t tmpfs none $d; done'
if ! command -v script >/dev/null 2>&1; then
	skip "terminals without descriptions" "no script(1)"
elif ! unshare -rm sh -c "$hidden" 2>/dev/null; then
	skip "terminals without descriptions" "no name spaces"
else
	for term in xterm-256color linux nobody-knows; do
		open "$term without a description" "$term" "unshare -rm sh -c '$hidden; exec $MATVIB mode1 --paused'"
	done
	open "xterm with one" xterm "$MATVIB mode1 --paused"
	result "is drawn as what it is" sh -c '! grep -q "not known here" drawn'
fi

root=$scratch/root
mkdir "$root"
if [ ! -x "$static" ]; then
	skip "one file to hand out" "not made: make static"
elif ! cp "$static" "$root/matvib" || ! unshare -r chroot "$root" /matvib --version >/dev/null 2>&1; then
	skip "one file to hand out" "no other root"
else
	result "no shared libraries" sh -c "! ldd '$static' 2>/dev/null | grep -q '=>'"
	unshare -r chroot "$root" /matvib run mode5 --steps 200 --series - >series 2>err
	result "it runs in an empty root" test $? -eq 0
	"$MATVIB" run mode5 --steps 200 --series - >wanted 2>err
	result "to the same bytes" cmp wanted series
	unshare -r chroot "$root" /matvib figure mode1 --view probe --end 1 --output a.svg --quiet
	result "it draws" test -s "$root/a.svg"
	unshare -r chroot "$root" /matvib figure mode1 --view probe --end 1 --output a.pdf >out 2>&1
	result "or says why it does not" says out 'PDF and PNG need cairo'
	echo tell | unshare -r chroot "$root" /matvib mode1 --plain >words
	result "it talks" says words '^View probe'
	if command -v script >/dev/null 2>&1; then
		open "one file, no terminfo" xterm-256color "unshare -r chroot $root /matvib mode1 --paused"
		for folder in /lib/terminfo /usr/share/terminfo; do
			test ! -f $folder/x/xterm || { mkdir -p "$root$folder/x" && cp $folder/x/xterm "$root$folder/x"; }
		done
		open "one file, terminfo" xterm "unshare -r chroot $root /matvib mode1 --paused"
		result "which it takes" sh -c '! grep -q "not known here" drawn'
	fi
fi

echo "1..$number"
