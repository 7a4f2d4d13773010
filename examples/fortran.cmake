# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# The Fortran examples. Each is one file that also builds alone:
#   gfortran minimal.f90 $(pkg-config --cflags --libs hgrid-fortran)

function(hgrid_add_fortran_example source)
  cmake_path(GET source STEM name)
  set(target example_fortran_${name})
  add_executable(${target} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/${source})
  set_target_properties(${target} PROPERTIES Fortran_MODULE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/${name})
  target_link_libraries(${target} PRIVATE hgrid::fortran hgrid_flags)
  add_test(NAME ${target} COMMAND ${target} ${ARGN})
  set_tests_properties(${target} PROPERTIES LABELS example TIMEOUT 60)
endfunction()

hgrid_add_fortran_example(minimal.f90)
set_tests_properties(example_fortran_minimal PROPERTIES PASS_REGULAR_EXPRESSION "^1 meets 2\n2 meets 3\n$")

# A row of nine spheres in odd columns: each overlaps the next one and touches the one after that.
set(row "# a comment\nid,r,z,y,kind,x\n")
foreach(k RANGE 1 9)
  string(APPEND row "${k},1.0,-5e-1,2,glass,${k}\n")
endforeach()
file(CONFIGURE OUTPUT row.csv CONTENT "${row}" @ONLY)
hgrid_add_fortran_example(contacts.f90 row.csv)
set_tests_properties(example_fortran_contacts PROPERTIES PASS_REGULAR_EXPRESSION "^particles 9\ncontacts 8\n")

# The numbers are those of a comparison of all pairs in Python's fractions.
hgrid_add_fortran_example(legacy.f)
set_tests_properties(
  example_fortran_legacy PROPERTIES PASS_REGULAR_EXPRESSION
                                    "step 1: 810 contacts, sum of overlaps 148.2559.*step 5: 730 contacts, sum of overlaps 237.8192")
