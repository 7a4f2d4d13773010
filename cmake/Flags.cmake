# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Two interface targets carry all flags: hgrid_flags for everything we compile, hgrid_warnings for our own sources only.
add_library(hgrid_flags INTERFACE)
target_compile_features(hgrid_flags INTERFACE cxx_std_17)
# Includes of our own files are written from the root.
target_include_directories(hgrid_flags INTERFACE ${PROJECT_SOURCE_DIR})
# Contraction of a*b+c into one rounding depends on the machine; pairs must not.
target_compile_options(hgrid_flags INTERFACE $<$<COMPILE_LANGUAGE:C,CXX>:-ffp-contract=off>)
if(HGRID_SANITIZE)
  target_compile_options(hgrid_flags INTERFACE -fsanitize=${HGRID_SANITIZE} -fno-omit-frame-pointer -g)
  target_link_options(hgrid_flags INTERFACE -fsanitize=${HGRID_SANITIZE})
endif()
if(HGRID_BUILD_FUZZERS)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "HGRID_BUILD_FUZZERS needs clang, the compiler is ${CMAKE_CXX_COMPILER_ID}")
  endif()
  target_compile_options(hgrid_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

add_library(hgrid_warnings INTERFACE)
target_compile_options(
  hgrid_warnings
  INTERFACE $<$<COMPILE_LANGUAGE:C,CXX>:-Wall -Wextra -Wshadow -Wpedantic>
            $<$<COMPILE_LANGUAGE:C>:-Wstrict-prototypes>
            $<$<AND:$<BOOL:${HGRID_WERROR}>,$<COMPILE_LANGUAGE:C,CXX>>:-Werror>)
