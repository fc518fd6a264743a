#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# make install into a folder: all there, nothing else, and it works from anywhere.
# shellcheck source=tests/common.sh
. "$MATVIB_SRCDIR/tests/common.sh"

# its own make: not the flags of the one that runs the tests
install() {
	env -u MAKEFLAGS -u MAKELEVEL -u MFLAGS make -s -C "$MATVIB_BUILDDIR" "$1" DESTDIR="$scratch/root" prefix=/usr
}
result "make install" install install
cd "$scratch/root/usr" || exit 1
cat >"$scratch/wanted" <<'END'
./bin/matvib
./share/bash-completion/completions/matvib
./share/doc/matvib/CONTRIBUTING.md
./share/doc/matvib/COPYING
./share/doc/matvib/NEWS
./share/doc/matvib/README.md
./share/doc/matvib/doc/building.md
./share/doc/matvib/doc/discs.svg
./share/doc/matvib/doc/guide.md
./share/doc/matvib/doc/page.md
./share/doc/matvib/doc/teaching.md
./share/doc/matvib/doc/words.md
./share/fish/vendor_completions.d/matvib.fish
./share/man/man1/matvib.1
./share/man/man5/matvib.5
./share/man/man7/matvib-checks.7
./share/man/man7/matvib-commands.7
./share/man/man7/matvib-equations.7
./share/man/man7/matvib-screen.7
./share/matvib/python/matvib.ipynb
./share/matvib/python/matvib.py
./share/metainfo/org.example.matvib.metainfo.xml
./share/zsh/site-functions/_matvib
END
find . -type f | LC_ALL=C sort >"$scratch/found"
result "these files and no others" diff "$scratch/wanted" "$scratch/found"
cd / && result "the program runs from anywhere" "$scratch/root/usr/bin/matvib" run mode1 --steps 10 --quiet
version=$("$scratch/root/usr/bin/matvib" --version | sed 's/matvib //;q')
result "the manual is of this version" grep -q "$version" "$scratch/root/usr/share/man/man1/matvib.1"
result "NEWS begins with it" grep -q -x "matvib $version" "$scratch/root/usr/share/doc/matvib/NEWS"
# the package is no part of the tarball, as Debian asks
test ! -e "$MATVIB_SRCDIR/debian" || result "so does the Debian package" grep -q "^matvib ($version-" "$MATVIB_SRCDIR/debian/changelog"
for file in CITATION.cff codemeta.json; do
	result "so does $file" grep -q -F "$version" "$MATVIB_SRCDIR/$file"
done
# releases stand there newest first
released=$(sed -n 's/.*"dateModified": "\(.*\)".*/\1/p' "$MATVIB_SRCDIR/codemeta.json")
newest=$(sed -n '/<release /{s/^ *//p;q;}' "$MATVIB_SRCDIR/data/org.example.matvib.metainfo.xml")
result "the newest release of software centres is this one" test "$newest" = "<release version=\"$version\" date=\"$released\"/>"
if python3 -c 'import yaml' 2>/dev/null; then
	result "the papers about it are read by machines" env -C "$MATVIB_SRCDIR" python3 -c '
import json, sys, yaml
cff, meta = yaml.safe_load(open("CITATION.cff")), json.load(open("codemeta.json"))
assert cff["cff-version"] == "1.2.0" and cff["message"] and cff["title"] and cff["authors"]
assert all(r["type"] and r["title"] and r["authors"] for r in cff["references"])
assert cff["license"] in meta["license"] and str(cff["date-released"]) == meta["dateModified"] and cff["version"] == meta["version"]
assert [a["name"] for a in cff["authors"]] == [a["name"] for a in meta["author"]]
'
else
	skip "the papers about it are read by machines" "no yaml for Python"
fi
if command -v appstreamcli >/dev/null 2>&1; then
	result "software centres can read of it" appstreamcli validate --no-net "$MATVIB_SRCDIR/data/org.example.matvib.metainfo.xml"
else
	skip "software centres can read of it" "no appstreamcli"
fi
missing=$(cd "$MATVIB_SRCDIR" && find src tests tools \( -name '*.[ch]' -o -name '*.inc' -o -name '*.sh' \) -exec grep -L 'SPDX-License-Identifier: GPL-3.0-or-later' {} +)
result "each source file tells its licence: $missing" test -z "$missing"
result "make uninstall" install uninstall
result "leaves nothing" test -z "$(find "$scratch/root" -type f)"

compile_commands() {
	env -u MAKEFLAGS -u MAKELEVEL -u MFLAGS make -s -C "$MATVIB_BUILDDIR" compile_commands.json
}
depends=$(cat "$MATVIB_BUILDDIR"/src/cli/*.d | cksum)
result "make compile_commands.json" compile_commands
result "leaves what make knows of dependencies" test "$depends" = "$(cat "$MATVIB_BUILDDIR"/src/cli/*.d | cksum)"
(cd "$MATVIB_SRCDIR" && find src -name '*.c' ! -name '*_web.c') | LC_ALL=C sort >"$scratch/wanted"
sed -n 's|.*"file": ".*/\(src/[^"]*\)",$|\1|p' "$MATVIB_BUILDDIR/compile_commands.json" | LC_ALL=C sort -u >"$scratch/found"
result "says how each source is compiled" test -z "$(LC_ALL=C comm -23 "$scratch/wanted" "$scratch/found")"
command=$(sed -n '/bond_kernels/{n;s/^ "command": "\(.*\)"}.*/\1/p;q;}' "$MATVIB_BUILDDIR/compile_commands.json" | sed 's/\\\(["\\]\)/\1/g')
result "by a command that works" sh -c "cd '$MATVIB_BUILDDIR' && $command -fsyntax-only"
echo "1..$number"
