# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Install rules of the Fortran library. Module files fit one compiler only: their folder carries its name and version.
set(HGRID_FORTRAN_COMPILER ${CMAKE_Fortran_COMPILER_ID}-${CMAKE_Fortran_COMPILER_VERSION})
set(HGRID_FORTRAN_INCLUDEDIR ${CMAKE_INSTALL_INCLUDEDIR}/hgrid/${HGRID_FORTRAN_COMPILER})

set_target_properties(hgrid_fortran PROPERTIES EXPORT_NAME fortran INSTALL_RPATH "$ORIGIN")
target_include_directories(hgrid_fortran INTERFACE $<INSTALL_INTERFACE:${HGRID_FORTRAN_INCLUDEDIR}>)
install(TARGETS hgrid_fortran EXPORT hgridFortranTargets)
install(EXPORT hgridFortranTargets NAMESPACE hgrid:: DESTINATION ${HGRID_PACKAGE_DIR})

get_target_property(hgrid_module_dir hgrid_fortran Fortran_MODULE_DIRECTORY)
install(DIRECTORY ${hgrid_module_dir}/ DESTINATION ${HGRID_FORTRAN_INCLUDEDIR} FILES_MATCHING PATTERN "*.mod")

# Users of another compiler build the module from its source.
get_target_property(hgrid_source_dir hgrid_fortran SOURCE_DIR)
install(DIRECTORY ${hgrid_source_dir}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/hgrid/fortran FILES_MATCHING
        PATTERN "*.f90" PATTERN "*.inc")
