# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# HGRID_THREADS: the OpenMP target, or empty for a library that works on the calling thread alone.
set(HGRID_THREADS "")
if(HGRID_OPENMP AND HGRID_SANITIZE MATCHES "thread")
  # gcc's OpenMP runtime is not built for the thread sanitizer, which then reports its barriers as races.
  message(STATUS "hgrid: without OpenMP under the thread sanitizer")
elseif(HGRID_OPENMP)
  find_package(OpenMP QUIET COMPONENTS CXX)
  if(OpenMP_CXX_FOUND)
    set(HGRID_THREADS OpenMP::OpenMP_CXX)
  else()
    message(STATUS "hgrid: no OpenMP found, the library will work on one thread")
  endif()
endif()
