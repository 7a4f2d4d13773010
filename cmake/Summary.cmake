# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# What will be built, said at the end of configuring; and why the rest will not.

# hgrid_tell(<what> <option> <text if it is built>)
function(hgrid_tell what option text)
  get_property(missing GLOBAL PROPERTY ${option}_MISSING)
  if(missing)
    set(text "no: ${missing}")
  elseif(NOT ${option})
    set(text "no (${option})")
  endif()
  string(SUBSTRING "${what}                  " 0 18 what)
  message(STATUS "  ${what} ${text}")
endfunction()

get_target_property(type hgrid TYPE)
string(REPLACE "_LIBRARY" "" type ${type})
string(TOLOWER ${type} type)
list(JOIN HGRID_INSTRUCTION_SETS " " sets)
message(STATUS "hgrid ${PROJECT_VERSION}, ${type}, ${CMAKE_BUILD_TYPE}, ${CMAKE_CXX_COMPILER_ID} "
               "${CMAKE_CXX_COMPILER_VERSION}, ${CMAKE_SYSTEM_PROCESSOR}: ${sets}")
hgrid_tell("threads" HGRID_THREADS "yes")
hgrid_tell("Fortran" HGRID_BUILD_FORTRAN "${CMAKE_Fortran_COMPILER_ID} ${CMAKE_Fortran_COMPILER_VERSION}")
hgrid_tell("FORTRAN 77" HGRID_BUILD_F77 "yes")
hgrid_tell("Python" HGRID_BUILD_PYTHON "yes")
hgrid_tell("Lua" HGRID_BUILD_LUA "yes")
hgrid_tell("Octave" HGRID_BUILD_OCTAVE "yes")
hgrid_tell("MPI" HGRID_BUILD_MPI "yes")
hgrid_tell("command hgrid" HGRID_BUILD_APP "yes")
hgrid_tell("benchmarks" HGRID_BUILD_BENCH "yes")
hgrid_tell("tests" HGRID_BUILD_TESTS "yes")
hgrid_tell("manual" HGRID_BUILD_DOCS "yes")
