# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# cmake -DSOURCE=... -DHEADER=... -P commit.cmake: writes the commit that is built into a header, at every build, and
# touches the header only when it changes.
execute_process(
  COMMAND git -C ${SOURCE} describe --always --abbrev=12 --dirty=+ --exclude=*
  OUTPUT_VARIABLE commit
  OUTPUT_STRIP_TRAILING_WHITESPACE
  ERROR_QUIET
  RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  set(commit "unknown")
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#define HGRID_BENCH_COMMIT \"@commit@\"\n" @ONLY)
