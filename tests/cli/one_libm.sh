#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The same bytes whatever the C library's elementary functions return and whichever of its variants for the
# processor it takes: series, particles and summary of runs, beside those of a library that errs by a bit
# everywhere (other_libm.c) and of glibc without fused operations. MATVIB_LONG: 2,000 steps of every scenario, each
# alone; else a few steps of some, both at once.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"

other=$MATVIB_BUILDDIR/tests/cli/other_libm.so
plain=glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2

# tables FOLDER [NAME=VALUE]...: with these in the environment
tables() {
	mkdir "$1" && cd "$1" || return 1
	shift
	env "$@" "$MATVIB" run "$scenario" --steps "$steps" --every "$every" --series series.csv --particles particles.csv \
		>said 2>&1
	sed '/^wall time/d' said >summary
	rm said
	cd ..
}
same() { # SCENARIO OTHER...: the tables of a plain run and of others
	scenario=$1 all_same=true
	shift
	tables usual
	for changed; do
		# shellcheck disable=SC2086 # several variables
		tables other $changed
		diff -rq usual other || all_same=false
		rm -r other
	done
	test -s usual/series.csv || all_same=false
	rm -r usual
	$all_same
}

if [ ! -e "$other" ]; then
	skip "the same bytes with another C library" "no library is loaded before others here"
	echo "1..$number"
	exit 0
fi
if [ -n "$MATVIB_LONG" ]; then
	steps=2000 every=100
	for file in "$MATVIB_SRCDIR"/data/scenarios/*.ini; do
		name=$(basename "$file" .ini)
		result "$name: the same bytes with another C library" same "$name" LD_PRELOAD="$other" GLIBC_TUNABLES=$plain
	done
else
	steps=20 every=1
	for name in mode1 mode5-peridynamics moving-cantilever-coarse supported-beam-mpm-coarse pulse one-particle column two-materials; do
		result "$name: the same bytes with another C library" same "$name" "LD_PRELOAD=$other GLIBC_TUNABLES=$plain"
	done
fi
echo "1..$number"
