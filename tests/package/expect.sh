# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the package tests: what a consumer program must print.

# Runs a program and compares its output with the version and the two contacts, counted from FIRST_ID.
# expect_contacts FIRST_ID PROGRAM...
expect_contacts() {
  first=$1
  shift
  expected=$(printf 'hgrid %s\n%d %d\n%d %d' "$EXPECTED_VERSION" "$first" $((first + 1)) $((first + 1)) $((first + 2)))
  printed=$("$@")
  if [ "$printed" != "$expected" ]; then
    printf '%s printed\n%s\ninstead of\n%s\n' "$*" "$printed" "$expected"
    exit 1
  fi
}
