# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Install rules of the library, its headers, the Fortran module, the CMake package and the pkg-config files.
# Nothing that is installed knows the prefix: the whole tree may be moved. Folders may be absolute, as Nix has them; then
# what lies there stays there.
#
# Components, for those who install or pack parts: runtime (the libraries of C and FORTRAN 77), fortran, mpi (theirs),
# development and mpi_development (what compiling needs; the former is the default, see CMakeLists.txt), command and
# mpi_command, python, docs.
include(CMakePackageConfigHelpers)

# hgrid_install_library(<target> <export> <component>): the bare name of a shared library is for the linker only.
function(hgrid_install_library target export component)
  set(development development)
  if(component STREQUAL "mpi")
    set(development mpi_development)
  endif()
  install(TARGETS ${target} EXPORT ${export}
          RUNTIME COMPONENT ${component}
          LIBRARY COMPONENT ${component} NAMELINK_COMPONENT ${development}
          ARCHIVE COMPONENT ${development})
endfunction()

set(HGRID_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/hgrid)
set(HGRID_PKGCONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

hgrid_install_library(hgrid hgridTargets runtime)
if(TARGET hgrid_f77)
  hgrid_install_library(hgrid_f77 hgridTargets runtime)
endif()
install(FILES include/hgrid/hgrid.h include/hgrid/base.h include/hgrid/types.h include/hgrid/grid.h
              include/hgrid/history.h include/hgrid/hgrid.hpp ${PROJECT_BINARY_DIR}/include/hgrid/version.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/hgrid)
install(FILES LICENSE CITATION.cff DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/hgrid COMPONENT docs)
install(EXPORT hgridTargets NAMESPACE hgrid:: DESTINATION ${HGRID_PACKAGE_DIR})

if(TARGET hgrid_mpi)
  hgrid_install_library(hgrid_mpi hgridMpiTargets mpi)
  install(FILES mpi/include/hgrid/mpi.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/hgrid COMPONENT mpi_development)
  install(EXPORT hgridMpiTargets NAMESPACE hgrid:: DESTINATION ${HGRID_PACKAGE_DIR} COMPONENT mpi_development)
endif()

if(TARGET hgrid_fortran)
  include(cmake/InstallFortran.cmake)
else()
  set(HGRID_FORTRAN_INCLUDEDIR ${CMAKE_INSTALL_INCLUDEDIR}/hgrid)
endif()
# Other Fortran compilers build the module from its sources: CMake by itself (hgridFortran.cmake), others from one file
# that includes them all.
set(HGRID_FORTRAN_SOURCEDIR ${CMAKE_INSTALL_DATADIR}/hgrid/fortran)
include(bindings/fortran/sources.cmake)
list(TRANSFORM HGRID_FORTRAN_SOURCES REPLACE "(.+)" "include '\\1'" OUTPUT_VARIABLE HGRID_FORTRAN_INCLUDES)
list(JOIN HGRID_FORTRAN_INCLUDES "\n" HGRID_FORTRAN_INCLUDES)
configure_file(cmake/hgrid_all.f90.in cmake/hgrid_all.f90 @ONLY)
list(TRANSFORM HGRID_FORTRAN_SOURCES PREPEND bindings/fortran/ OUTPUT_VARIABLE HGRID_FORTRAN_FILES)
if(TARGET hgrid_mpi)
  install(FILES bindings/fortran/hgrid_mpi_c.f90 bindings/fortran/hgrid_mpi_particles.f90 bindings/fortran/hgrid_mpi.f90
          DESTINATION ${HGRID_FORTRAN_SOURCEDIR}
          COMPONENT mpi_development)
endif()
install(FILES ${HGRID_FORTRAN_FILES} ${PROJECT_BINARY_DIR}/cmake/hgrid_all.f90
        DESTINATION ${HGRID_FORTRAN_SOURCEDIR})

get_target_property(HGRID_LIBRARY_TYPE hgrid TYPE)
# For pkg-config: names become -lNAME, paths stay.
list(TRANSFORM HGRID_RUNTIME_LIBRARIES PREPEND -l REGEX "^[^/-]" OUTPUT_VARIABLE HGRID_RUNTIME_LIBS)
if(HGRID_THREADS AND UNIX AND NOT "-pthread" IN_LIST HGRID_RUNTIME_LIBS)
  list(APPEND HGRID_RUNTIME_LIBS -pthread)
endif()
list(JOIN HGRID_RUNTIME_LIBS " " HGRID_RUNTIME_LIBS)
set(HGRID_PC_THREADS no)
if(HGRID_THREADS)
  set(HGRID_PC_THREADS yes)
endif()
list(JOIN HGRID_INSTRUCTION_SETS " " HGRID_PC_INSTRUCTION_SETS)
configure_package_config_file(
  cmake/hgridConfig.cmake.in cmake/hgridConfig.cmake
  INSTALL_DESTINATION ${HGRID_PACKAGE_DIR}
  PATH_VARS HGRID_FORTRAN_INCLUDEDIR HGRID_FORTRAN_SOURCEDIR
  NO_SET_AND_CHECK_MACRO)
# Below 1.0 a new minor version may change the interface.
set(compatible SameMajorVersion)
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(compatible SameMinorVersion)
endif()
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cmake/hgridConfigVersion.cmake COMPATIBILITY ${compatible})
install(FILES ${PROJECT_BINARY_DIR}/cmake/hgridConfig.cmake ${PROJECT_BINARY_DIR}/cmake/hgridConfigVersion.cmake
              cmake/hgridFortran.cmake
        DESTINATION ${HGRID_PACKAGE_DIR})

if(HGRID_LIBRARY_TYPE STREQUAL "STATIC_LIBRARY")
  set(HGRID_PC_LIBS "-lhgrid ${HGRID_RUNTIME_LIBS}")
  set(HGRID_PC_PRIVATE_LIBS "")
  set(HGRID_PC_CFLAGS "-DHGRID_STATIC")
else()
  set(HGRID_PC_LIBS "-lhgrid")
  set(HGRID_PC_PRIVATE_LIBS "${HGRID_RUNTIME_LIBS}")
  set(HGRID_PC_CFLAGS "")
endif()
# Paths in files of pkg-config follow the file if the tree is moved, unless they are absolute.
if(IS_ABSOLUTE "${HGRID_PKGCONFIG_DIR}")
  set(HGRID_PC_PREFIX "${CMAKE_INSTALL_PREFIX}")
else()
  file(RELATIVE_PATH HGRID_PC_PREFIX /prefix/${HGRID_PKGCONFIG_DIR} /prefix)
  string(REGEX REPLACE "/$" "" HGRID_PC_PREFIX "\${pcfiledir}/${HGRID_PC_PREFIX}")
endif()
foreach(pair IN ITEMS LIBDIR:CMAKE_INSTALL_LIBDIR INCLUDEDIR:CMAKE_INSTALL_INCLUDEDIR
                      MODULEDIR:HGRID_FORTRAN_INCLUDEDIR SOURCEDIR:HGRID_FORTRAN_SOURCEDIR)
  string(REGEX MATCH "(.*):(.*)" pair ${pair})
  set(HGRID_PC_${CMAKE_MATCH_1} "${${CMAKE_MATCH_2}}")
  if(NOT IS_ABSOLUTE "${HGRID_PC_${CMAKE_MATCH_1}}")
    string(PREPEND HGRID_PC_${CMAKE_MATCH_1} "\${prefix}/")
  endif()
endforeach()
set(HGRID_PC_FILES hgrid)
if(TARGET hgrid_mpi)
  get_target_property(HGRID_PC_MPI_LIBRARY hgrid_mpi OUTPUT_NAME)
  if(TARGET hgrid_mpi_fortran)
    get_target_property(HGRID_PC_MPI_FORTRAN_LIBRARY hgrid_mpi_fortran OUTPUT_NAME)
  endif()
  if(HGRID_MPI_FLAVOUR)
    set(HGRID_PC_MPI_FLAVOUR -${HGRID_MPI_FLAVOUR})
  endif()
  # The MPI that the library was built with: another one has other types.
  find_package(MPI REQUIRED COMPONENTS C)
  list(TRANSFORM MPI_C_INCLUDE_DIRS PREPEND -I OUTPUT_VARIABLE HGRID_PC_MPI_CFLAGS)
  list(JOIN HGRID_PC_MPI_CFLAGS " " HGRID_PC_MPI_CFLAGS)
  list(JOIN MPI_C_LIBRARIES " " HGRID_PC_MPI_LIBS)
  if(HGRID_LIBRARY_TYPE STREQUAL "STATIC_LIBRARY" AND HGRID_ZOLTAN_FITS)
    string(PREPEND HGRID_PC_MPI_LIBS "${HGRID_ZOLTAN_LIBRARY} ")
  endif()
endif()
foreach(layer IN ITEMS fortran f77 mpi mpi-fortran)
  string(REPLACE "-" "_" target hgrid_${layer})
  if(TARGET ${target})
    list(APPEND HGRID_PC_FILES hgrid-${layer})
  endif()
endforeach()
foreach(file IN LISTS HGRID_PC_FILES)
  set(name ${file})
  set(component development)
  if(file MATCHES "mpi")
    string(APPEND name "${HGRID_PC_MPI_FLAVOUR}")
    set(component mpi_development)
  endif()
  configure_file(cmake/${file}.pc.in cmake/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/cmake/${name}.pc
          DESTINATION ${HGRID_PKGCONFIG_DIR}
          COMPONENT ${component})
endforeach()
