# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# HGRID_RUNTIME_LIBRARIES: what whoever links the static library must add to what a C program has, as the compiler tells
# it: a shared library brings this along, and a project in C or Fortran has no C++ linker to add it.
set(HGRID_RUNTIME_LIBRARIES ${CMAKE_CXX_IMPLICIT_LINK_LIBRARIES})
list(REMOVE_ITEM HGRID_RUNTIME_LIBRARIES ${CMAKE_C_IMPLICIT_LINK_LIBRARIES} "")
list(REMOVE_DUPLICATES HGRID_RUNTIME_LIBRARIES)
if(HGRID_THREADS)
  set(THREADS_PREFER_PTHREAD_FLAG ON)
  find_package(Threads REQUIRED)
  # Empty where threads are part of the C library. The target is unknown to projects that only know Fortran.
  list(APPEND HGRID_RUNTIME_LIBRARIES ${CMAKE_THREAD_LIBS_INIT})
endif()
