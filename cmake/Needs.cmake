# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# What the parts need that have their own option. The library itself needs nothing but its compiler.
if(HGRID_BUILD_FORTRAN STREQUAL "AUTO")
  include(CheckLanguage)
  check_language(Fortran)
  if(NOT CMAKE_Fortran_COMPILER)
    hgrid_missing(HGRID_BUILD_FORTRAN "no Fortran compiler was found")
  endif()
endif()
if(HGRID_BUILD_FORTRAN)
  enable_language(Fortran)
endif()
hgrid_require(HGRID_BUILD_APP CLI11 Eigen3 pugixml ZLIB pkg-config:tomlplusplus pkg-config:gmpxx)
if(HGRID_BUILD_BENCH AND NOT HGRID_BUILD_APP)
  hgrid_missing(HGRID_BUILD_BENCH "the command hgrid, of which they are made, is not built")
endif()
hgrid_require(HGRID_BUILD_TESTS pkg-config:cmocka pkg-config:gmpxx)
