# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Two interface targets carry all flags: hgrid_flags for everything we compile, hgrid_warnings for our own sources only.
add_library(hgrid_flags INTERFACE)
target_compile_features(hgrid_flags INTERFACE cxx_std_17)
# Includes of our own files are written from the root.
target_include_directories(hgrid_flags INTERFACE ${PROJECT_SOURCE_DIR})
# Contraction of a*b+c into one rounding depends on the machine; pairs must not. Nor may they depend on flags of a
# project around this one: what -ffast-math switches on goes off again, part by part. src/base/arithmetic.hpp refuses
# what is left.
set(HGRID_TRUE_ARITHMETIC -fno-unsafe-math-optimizations -fno-finite-math-only -fno-associative-math
                          -fno-reciprocal-math -fsigned-zeros -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "IntelLLVM")
  list(PREPEND HGRID_TRUE_ARITHMETIC -fp-model=precise) # fast by default
endif()
target_compile_options(hgrid_flags INTERFACE "$<$<COMPILE_LANGUAGE:C,CXX>:${HGRID_TRUE_ARITHMETIC}>")
# A library linked with -ffast-math would have subnormal numbers flushed to zero in the whole of its host.
set(HGRID_TRUE_LINK -fno-fast-math -fno-unsafe-math-optimizations)
string(TOUPPER "${CMAKE_BUILD_TYPE}" HGRID_UPPER_TYPE)
if("${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${HGRID_UPPER_TYPE}} ${CMAKE_SHARED_LINKER_FLAGS}" MATCHES "-Ofast")
  list(APPEND HGRID_TRUE_LINK -O3) # nothing but another -O takes that back
endif()
target_link_options(hgrid_flags INTERFACE ${HGRID_TRUE_LINK})
# The x87 unit computes with 64 bits: 32-bit x86 is compiled for SSE2, which all processors since 2001 have.
if(CMAKE_SIZEOF_VOID_P EQUAL 4 AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(i[3-6]86|x86|x86_64|amd64|AMD64)$")
  target_compile_options(hgrid_flags INTERFACE $<$<COMPILE_LANGUAGE:C,CXX>:-msse2> $<$<COMPILE_LANGUAGE:C,CXX>:-mfpmath=sse>)
endif()
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
            # printf of mingw-w64 knows %zu, gcc's check of its formats does not.
            $<$<AND:$<BOOL:${MINGW}>,$<COMPILE_LANGUAGE:C,CXX>>:-Wno-format>
            $<$<AND:$<BOOL:${MINGW}>,$<COMPILE_LANGUAGE:C,CXX>>:-Wno-format-extra-args>
            $<$<AND:$<BOOL:${HGRID_WERROR}>,$<COMPILE_LANGUAGE:C,CXX>>:-Werror>)
