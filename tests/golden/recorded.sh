#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# The hashes in the tree are those of sets that the oracle has just decided again.
# recorded.sh GOLDEN HASHES
set -euo pipefail
diff -u "$2" <("$1" --record) || {
  echo "hashes differ; if the order of pairs was changed on purpose: golden --record > tests/golden/hashes.txt"
  exit 1
}
