# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# What the modules of scripting languages have in common (bindings/swig).

# hgrid_require_swig(<option> <language>): leaves the folder where the module cannot be made.
macro(hgrid_require_swig option language)
  if(HGRID_SANITIZE)
    hgrid_missing(${option} "a plain interpreter cannot load a library with sanitizers")
    return()
  endif()
  find_package(SWIG 4.0 COMPONENTS ${language} QUIET)
  if(NOT SWIG_FOUND)
    hgrid_missing(${option} "SWIG >= 4.0 was not found")
    return()
  endif()
  include(UseSWIG)
endmacro()

# hgrid_describe_to_swig(<interface file> <module name>)
function(hgrid_describe_to_swig file module)
  set_source_files_properties(
    ${file} PROPERTIES SWIG_MODULE_NAME ${module} USE_TARGET_INCLUDE_DIRECTORIES ON USE_SWIG_DEPENDENCIES ON)
  if(CMAKE_SIZEOF_VOID_P EQUAL 8 AND UNIX AND NOT APPLE)
    # There int64_t is long, which SWIG has to be told.
    set_source_files_properties(${file} PROPERTIES COMPILE_DEFINITIONS SWIGWORDSIZE64)
  endif()
endfunction()

# hgrid_script_module(<target> <folder> <component> <library>): links the library, which the installed module finds from
# its folder, relative to the prefix; loaded into a host, it leaves its arithmetic alone (cmake/Flags.cmake).
function(hgrid_script_module target folder component library)
  target_link_libraries(${target} PRIVATE ${library})
  target_compile_options(${target} PRIVATE ${HGRID_TRUE_ARITHMETIC})
  target_link_options(${target} PRIVATE ${HGRID_TRUE_LINK})
  set_target_properties(${target} PROPERTIES C_VISIBILITY_PRESET hidden)
  if(NOT HGRID_INSTALL)
    return()
  endif()
  if(APPLE)
    set(here "@loader_path")
  else()
    set(here "$ORIGIN")
  endif()
  if(IS_ABSOLUTE "${folder}" OR IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
    set(runtime_path "${CMAKE_INSTALL_FULL_LIBDIR}")
  else()
    file(RELATIVE_PATH to_library "/prefix/${folder}" "/prefix/${CMAKE_INSTALL_LIBDIR}")
    set(runtime_path "${here}/${to_library}")
  endif()
  get_target_property(type ${library} TYPE)
  if(type STREQUAL "SHARED_LIBRARY")
    set_target_properties(${target} PROPERTIES INSTALL_RPATH "${runtime_path}")
  endif()
  install(TARGETS ${target} LIBRARY DESTINATION "${folder}" COMPONENT ${component})
endfunction()
