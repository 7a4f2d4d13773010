# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Runs PROGRAM with the argument WAY, which must end it with exit code 1 and MESSAGE on standard error.

execute_process(COMMAND ${PROGRAM} ${WAY} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE error)
if(NOT result STREQUAL 1)
  message(FATAL_ERROR "${WAY}: exit code is ${result}, not 1\n${output}${error}")
endif()
if(output MATCHES "reached the end")
  message(FATAL_ERROR "${WAY}: the program went on after the error")
endif()
string(FIND "${error}" "${MESSAGE}" position)
if(position EQUAL -1)
  message(FATAL_ERROR "${WAY}: standard error lacks '${MESSAGE}':\n${error}")
endif()
