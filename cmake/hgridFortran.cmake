# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Included by hgridConfig.cmake: makes hgrid::fortran, the library as it was built if this project's compiler can read
# its module files, else one compiled from the installed sources as a part of this project.

# Sets hgrid_FORTRAN_MODULES_FIT: whether the compiler takes the module files that are installed.
function(hgrid_try_modules)
  set(hgrid_FORTRAN_MODULES_FIT OFF CACHE INTERNAL "")
  if(HGRID_FORTRAN_FROM_SOURCE OR NOT EXISTS "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/hgridFortranTargets.cmake")
    return()
  endif()
  # Nothing is linked: the libraries are not known yet.
  set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
  set(work "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/hgrid_modules")
  # Modules of another version, left over in a folder, do not compile: 1 / 0.
  string(REPLACE "." ", " version "${hgrid_VERSION}")
  file(WRITE "${work}/uses.f90"
       "subroutine uses(grid)\nuse hgrid\ntype(hg_grid) :: grid\n"
       "integer, parameter :: own(3) = [HG_VERSION_MAJOR, HG_VERSION_MINOR, HG_VERSION_PATCH]\n"
       "integer, parameter :: same = 1 / merge(1, 0, all(own == [${version}]))\n"
       "if (same == 1) call grid%clear()\nend\n")
  try_compile(hgrid_FORTRAN_MODULES_FIT "${work}/build" SOURCES "${work}/uses.f90"
              CMAKE_FLAGS "-DINCLUDE_DIRECTORIES=${hgrid_FORTRAN_MODULES}")
endfunction()

function(hgrid_add_fortran_from_source)
  message(STATUS "hgrid: the Fortran module is compiled from its sources for ${CMAKE_Fortran_COMPILER_ID}; "
                 "${hgrid_FORTRAN_MODULES} holds no modules of version ${hgrid_VERSION} that it reads")
  list(TRANSFORM hgrid_FORTRAN_SOURCES PREPEND "${hgrid_FORTRAN_SOURCE_DIR}/")
  add_library(hgrid_fortran_from_source STATIC EXCLUDE_FROM_ALL ${hgrid_FORTRAN_SOURCES})
  set(modules "${CMAKE_CURRENT_BINARY_DIR}/hgrid_fortran_from_source")
  set_target_properties(hgrid_fortran_from_source PROPERTIES Fortran_MODULE_DIRECTORY "${modules}"
                                                             POSITION_INDEPENDENT_CODE ON)
  target_include_directories(hgrid_fortran_from_source PUBLIC "${modules}")
  target_link_libraries(hgrid_fortran_from_source PUBLIC hgrid::hgrid)
  add_library(hgrid::fortran ALIAS hgrid_fortran_from_source)
endfunction()

if(NOT TARGET hgrid::fortran)
  hgrid_try_modules()
  if(hgrid_FORTRAN_MODULES_FIT)
    include("${CMAKE_CURRENT_LIST_DIR}/hgridFortranTargets.cmake")
  else()
    hgrid_add_fortran_from_source()
  endif()
endif()
