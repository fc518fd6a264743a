#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds as others do them: without optimisation, by each compiler, with warnings as errors; of a checkout that may not be written, in
# a folder whose name has blanks and letters; on a bare Debian. For check-long: each builds the program. What cannot be tried
# here is skipped.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"
unset MAKEFLAGS MAKELEVEL MFLAGS
trap 'chmod -R u+w "$scratch"; rm -rf "$scratch"' EXIT

built() ( # SOURCE FOLDER OPTION...
	source=$1
	mkdir -p "$2" && cd "$2" && shift 2 && "$source/configure" --quiet "$@" && make -s -j2 all &&
		./matvib run mode1 --steps 10 --quiet
)
for compiler in gcc clang; do
	if command -v $compiler >/dev/null 2>&1; then
		result "$compiler -O0 warns of nothing" built "$MATVIB_SRCDIR" "$scratch/$compiler" --enable-werror CC=$compiler CFLAGS=-O0
	else
		skip "$compiler -O0 warns of nothing" "no $compiler"
	fi
done

if ! git -C "$MATVIB_SRCDIR" rev-parse --git-dir >/dev/null 2>&1 || ! command -v autoreconf >/dev/null 2>&1; then
	skip "a checkout that may not be written" "no checkout, or no autoconf"
else
	checkout="$scratch/a checkout in Zürich"
	git clone -q "$MATVIB_SRCDIR" "$checkout" && (cd "$checkout" && mkdir -p build build-aux && autoreconf --install) >log 2>&1
	chmod -R a-w "$checkout" && chmod u+w "$checkout/build"
	# root may write all the same
	others() { (cd "$checkout" && find . -path ./build -prune -o -type f -newer configure -print) | LC_ALL=C sort; }
	others >before
	result "a checkout that may not be written is built" built .. "$checkout/build" CFLAGS=-O0
	others >after
	result "and nothing is written into it" diff before after
fi

# bare: no sudo, no ps, nothing but what bootstrap installs; processes and terminals as a container has them, in mounts that end
# with it. Of another mirror than debootstrap's own: MATVIB_MIRROR=URL
bare() {
	# shellcheck disable=SC2016 # it is for the shell inside
	unshare --mount sh -c 'mount -t proc proc "$0/proc" && mount -t devpts -o newinstance,ptmxmode=0666 devpts "$0/dev/pts" && exec chroot "$0" "$@"' \
		"$scratch/bare" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root ${http_proxy:+"http_proxy=$http_proxy"} "$@"
}
if [ "$(id -u)" != 0 ] || ! command -v debootstrap >/dev/null 2>&1 || [ -z "${MATVIB_DEBIAN-}" ] ||
	! git -C "$MATVIB_SRCDIR" rev-parse --git-dir >/dev/null 2>&1; then
	skip "a bare Debian" "needs root, debootstrap, a checkout and MATVIB_DEBIAN=SUITE, e.g. stable, with a network (and MATVIB_MIRROR)"
else
	result "a bare Debian is unpacked" debootstrap --variant=minbase "$MATVIB_DEBIAN" "$scratch/bare" ${MATVIB_MIRROR:+"$MATVIB_MIRROR"}
	mkdir "$scratch/bare/matvib" && (cd "$MATVIB_SRCDIR" && git archive HEAD) | tar -xf - -C "$scratch/bare/matvib"
	result "bootstrap and make check" bare sh -c "cd /matvib && ./bootstrap && make -C build check"
fi
echo "1..$number"
