#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Every test that docs/robustness.md names as `folder/file: word` is there: the file holds the word.
# names.sh PAGE TESTS_DIR
set -euo pipefail
page=$1 tests=$2
names=$(grep -oE '`[a-z0-9_/]+/[a-z0-9_]+: [A-Za-z0-9_]+`' <(tr '\n' ' ' <"$page") | tr -d '`' | sort -u)
count=0 status=0
while IFS=': ' read -r file word; do
  count=$((count + 1))
  if ! grep -qw -- "$word" "$tests/$file".*; then
    echo "$page names $file: $word, which is not there"
    status=1
  fi
done <<<"$names"
echo "$count tests named"
((count > 50)) || { echo "too few names: is the page still written as this script expects?" && status=1; }
exit "$status"
