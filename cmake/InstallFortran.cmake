# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Install rules of the built Fortran library. Module files fit one compiler only: their folder carries its name and version.
set(HGRID_FORTRAN_COMPILER ${CMAKE_Fortran_COMPILER_ID}-${CMAKE_Fortran_COMPILER_VERSION})
set(HGRID_FORTRAN_MODULE_DIR
    ${CMAKE_INSTALL_INCLUDEDIR}/hgrid/${HGRID_FORTRAN_COMPILER}
    CACHE STRING "Where the files of Fortran modules go, relative to the prefix or absolute")
set(HGRID_FORTRAN_INCLUDEDIR ${HGRID_FORTRAN_MODULE_DIR})

set_target_properties(hgrid_fortran PROPERTIES EXPORT_NAME fortran INSTALL_RPATH "$ORIGIN")
target_include_directories(hgrid_fortran INTERFACE $<INSTALL_INTERFACE:${HGRID_FORTRAN_INCLUDEDIR}>)
hgrid_install_library(hgrid_fortran hgridFortranTargets fortran)
install(EXPORT hgridFortranTargets NAMESPACE hgrid:: DESTINATION ${HGRID_PACKAGE_DIR})

if(TARGET hgrid_mpi_fortran)
  hgrid_install_library(hgrid_mpi_fortran hgridMpiFortranTargets mpi)
  install(EXPORT hgridMpiFortranTargets NAMESPACE hgrid:: DESTINATION ${HGRID_PACKAGE_DIR} COMPONENT mpi_development)
endif()

get_target_property(hgrid_module_dir hgrid_fortran Fortran_MODULE_DIRECTORY)
install(DIRECTORY ${hgrid_module_dir}/
        DESTINATION ${HGRID_FORTRAN_INCLUDEDIR}
        FILES_MATCHING
        PATTERN "*.mod"
        PATTERN "hgrid_mpi*" EXCLUDE)
if(TARGET hgrid_mpi_fortran)
  install(DIRECTORY ${hgrid_module_dir}/
          DESTINATION ${HGRID_FORTRAN_INCLUDEDIR}
          COMPONENT mpi_development
          FILES_MATCHING PATTERN "hgrid_mpi*.mod")
endif()
