# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# HGRID_INSTRUCTION_SETS: those that the kernels are compiled for, the plainest first. HGRID_X86 or HGRID_ARM64 where the
# processor has words of 64 bits; all others have the plain kernels.
set(HGRID_X86 OFF)
set(HGRID_ARM64 OFF)
set(HGRID_INSTRUCTION_SETS scalar)
if(CMAKE_SIZEOF_VOID_P EQUAL 8)
  # Linux says x86_64, FreeBSD amd64, Windows AMD64.
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|amd64|AMD64)$")
    set(HGRID_X86 ON)
    list(APPEND HGRID_INSTRUCTION_SETS sse2 avx2 avx512)
  elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64|ARM64)$")
    set(HGRID_ARM64 ON)
    list(APPEND HGRID_INSTRUCTION_SETS neon)
  endif()
endif()
