# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Which Python the module is built for, and where that Python looks for modules.

# Sets `python` to an interpreter that has numpy and C headers: Python3_EXECUTABLE if it is set, else the first python3
# on the path, else the system's. The first on the path is often a version manager's without numpy. If none will do,
# `missing` says what the first one lacks.
function(hgrid_choose_python python missing)
  if(Python3_EXECUTABLE)
    set(candidates "${Python3_EXECUTABLE}")
  else()
    find_program(HGRID_PYTHON_ON_PATH NAMES python3 python)
    mark_as_advanced(HGRID_PYTHON_ON_PATH)
    set(candidates ${HGRID_PYTHON_ON_PATH} /usr/bin/python3)
  endif()
  set(modules "'numpy'")
  if(SKBUILD)
    set(modules "") # pip brings it with the package (pyproject.toml)
  endif()
  string(
    CONCAT probe
           "import importlib.util, os, sys, sysconfig\n"
           "header = os.path.join(sysconfig.get_path('include'), 'Python.h')\n"
           "lacks = [name for name in [${modules}] if importlib.util.find_spec(name) is None]\n"
           "lacks += [] if os.path.exists(header) else [header]\n"
           "lacks += [] if sys.version_info >= (3, 8) else ['version 3.8']\n"
           "print(' and '.join(lacks))\n")
  set(first_lack "no python3 was found")
  foreach(candidate IN LISTS candidates)
    execute_process(
      COMMAND "${candidate}" -c "${probe}"
      RESULT_VARIABLE failed
      OUTPUT_VARIABLE lacks
      OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(NOT failed AND lacks STREQUAL "")
      set(${python} "${candidate}" PARENT_SCOPE)
      set(${missing} "" PARENT_SCOPE)
      return()
    endif()
    if(failed)
      set(lacks "anything that runs")
    endif()
    if(first_lack STREQUAL "no python3 was found")
      set(first_lack "${candidate} lacks ${lacks}")
    endif()
  endforeach()
  set(${missing} "${first_lack}" PARENT_SCOPE)
endfunction()

# Sets `dir` to the folder below the install prefix, relative to it, in which `python` looks for modules by itself
# (Debian: lib/python3/dist-packages for /usr, lib/python3.X/dist-packages for /usr/local); if there is none,
# lib/python3.X/site-packages.
function(hgrid_default_python_dir python dir)
  string(
    CONCAT probe
           "import os, sys\n"
           "known = [p for p in sys.path if p.endswith('-packages')]\n"
           "below = [os.path.relpath(p, sys.argv[1]).replace(os.sep, '/') for p in known]\n"
           "own = 'lib/python%d.%d/site-packages' % sys.version_info[:2]\n"
           "print(next((p for p in below if p.startswith('lib')), own))\n")
  execute_process(
    COMMAND "${python}" -I -c "${probe}" "${CMAKE_INSTALL_PREFIX}"
    OUTPUT_VARIABLE found
    OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(${dir} "${found}" PARENT_SCOPE)
endfunction()
