# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# hgrid_add_test(<name> LABEL <label> SOURCES <file>... [LIBRARIES <target>...] [TIMEOUT <seconds>])
#
# One cmocka program: it sees what a user of the library sees, the public headers and the library, and is registered
# with ctest under its own name. Sanitizers make the searches several times slower, hence the long default time-out.
function(hgrid_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LABEL;TIMEOUT" "SOURCES;LIBRARIES")
  if(NOT arg_LABEL OR NOT arg_SOURCES OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "hgrid_add_test(${name}): LABEL and SOURCES are needed, unknown: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif()
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE hgrid_flags hgrid_warnings hgrid::hgrid ${arg_LIBRARIES} PkgConfig::CMOCKA)
  set_target_properties(${name} PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS ${arg_LABEL} TIMEOUT ${arg_TIMEOUT})
endfunction()

# hgrid_add_instruction_sets(<test> <label> <target> [<argument>...]): the program again as <test>.<set> with each
# instruction set that this kind of machine can have; without a choice the library takes the best one.
function(hgrid_add_instruction_sets test label target)
  foreach(set ${HGRID_INSTRUCTION_SETS})
    add_test(NAME ${test}.${set} COMMAND ${target} ${ARGN})
    set_tests_properties(
      ${test}.${set}
      PROPERTIES LABELS ${label}
                 TIMEOUT 300
                 ENVIRONMENT HGRID_ISA=${set}
                 SKIP_REGULAR_EXPRESSION "this machine cannot run it")
  endforeach()
endfunction()
