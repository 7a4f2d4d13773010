#!/bin/sh
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# A program prints what a file holds, which tutorials show: prints.sh FILE COMMAND...
set -eu
expected=$1
shift
"$@" | diff -u "$expected" -
