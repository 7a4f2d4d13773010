#!/bin/sh
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Installs Debian packages in a clean root and runs the consumers of debian/tests there, as root: debs_try.sh DEBS_DIR
# DEBS_DIR is what debs.sh has filled. Needs mmdebstrap and autopkgtest, and a mirror of Debian.
set -eu
if [ $# -ne 1 ]; then
  sed -n '4,5s/^# //p' "$0" >&2
  exit 2
fi
debs=$(cd "$1" && pwd)
suite=${SUITE:-bookworm}

# A bare Debian, fetched once and unpacked anew each time: what the packages need must be what they say.
clean=$debs/root
umount "$clean/proc" 2>/dev/null || true
rm -rf --one-file-system "$clean"
mkdir "$clean"
[ -e "$debs/$suite.tar" ] || mmdebstrap --variant=apt --quiet "$suite" "$debs/$suite.tar"
tar -C "$clean" -xf "$debs/$suite.tar"
mount -t proc proc "$clean/proc" # the command finds its scenes by it
trap 'umount "$clean/proc"' EXIT
status=0
autopkgtest --apt-upgrade --output-dir="$debs/tried" "$debs"/*.deb "$debs"/libhgrid_*.dsc -- chroot "$clean" || status=$?
# 2: passed, some tests left out; here none may be.
exit "$status"
