# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Options that may be AUTO: ON is a wish, which fails where something is missing; AUTO, the default, takes what is there,
# and the summary at the end of configuring says what was not.

# hgrid_option(<name> <text> <default>)
macro(hgrid_option name text default)
  # A variable of the project around this one wins, as with option().
  if(NOT DEFINED ${name} OR DEFINED CACHE{${name}})
    set(${name} ${default} CACHE STRING "${text}: ON, OFF, or AUTO, if what it needs is there")
    set_property(CACHE ${name} PROPERTY STRINGS AUTO ON OFF)
  endif()
endmacro()

# hgrid_missing(<name> <what is missing>): an error if the option is ON; if it is AUTO, it is OFF from here on.
macro(hgrid_missing name what)
  if(NOT ${name} STREQUAL "AUTO")
    message(FATAL_ERROR "${name} is ${${name}}, but ${what} (${name}=AUTO: only where it can be had)")
  endif()
  set(${name} OFF)
  set_property(GLOBAL PROPERTY ${name}_MISSING "${what}")
endmacro()

# hgrid_require(<name> <package>...): each package as find_package knows it, or pkg-config:MODULE.
macro(hgrid_require name)
  if(${name})
    set(hgrid_absent "")
    foreach(hgrid_package ${ARGN})
      if(hgrid_package MATCHES "^pkg-config:(.*)")
        set(hgrid_package ${CMAKE_MATCH_1})
        find_package(PkgConfig QUIET)
        if(PKG_CONFIG_FOUND)
          pkg_check_modules(HGRID_${hgrid_package} QUIET ${hgrid_package})
        endif()
        set(hgrid_found ${HGRID_${hgrid_package}_FOUND})
      else()
        find_package(${hgrid_package} QUIET)
        set(hgrid_found ${${hgrid_package}_FOUND})
      endif()
      if(NOT hgrid_found)
        list(APPEND hgrid_absent ${hgrid_package})
      endif()
    endforeach()
    if(hgrid_absent)
      list(JOIN hgrid_absent ", " hgrid_absent)
      hgrid_missing(${name} "not found: ${hgrid_absent}")
    endif()
  endif()
endmacro()
