// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which vectors of numbers the machine has: kernels that use them are compiled for each width and chosen when a
// simulation is made.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__)
#define DEM_HAS_VECTORS
#define DEM_AVX2 __attribute__((target("avx2,popcnt")))
#define DEM_AVX512 __attribute__((target("avx512f,avx512vl,avx512dq,avx2,popcnt")))
#endif

namespace dem {

enum class Vectors { kPlain, kAvx2, kAvx512 };

// The widest that this machine has and HGRID_ISA allows.
Vectors usable_vectors();

}  // namespace dem
