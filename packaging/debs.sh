#!/bin/sh
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Builds the Debian packages of the last commit and lets lintian look at them: debs.sh OUT_DIR
# Needs what `Build-Depends` of packaging/debian/control names (apt-get build-dep), dpkg-dev and lintian.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
if [ $# -ne 1 ]; then
  sed -n '4,5s/^# //p' "$0" >&2
  exit 2
fi
mkdir -p "$1"
out=$(cd "$1" && pwd)

version=$(sed -n '1s/.*(\(.*\)-.*/\1/p' "$root/packaging/debian/changelog")
name=libhgrid-$version
rm -rf "${out:?}/$name"
git -C "$root" archive --prefix="$name/" HEAD | gzip -n9 >"$out/libhgrid_$version.orig.tar.gz"
tar -C "$out" -xzf "$out/libhgrid_$version.orig.tar.gz"
cd "$out/$name"
cp -R packaging/debian debian
dpkg-buildpackage --no-sign
lintian --version
# No report in Debian asks for these packages.
lintian --fail-on error,warning --tag-display-limit 0 --suppress-tags initial-upload-closes-no-bugs \
  ../libhgrid_*.changes
ls -l ../*.deb
