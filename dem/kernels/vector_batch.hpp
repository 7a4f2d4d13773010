// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Batches of contacts with vectors of doubles, on machines that have them.
#pragma once

#include "dem/base/vectors.hpp"
#include "dem/kernels/contact_batch.hpp"

#include <type_traits>

namespace dem {

// Null for effects on images that are left to plain code. Each width is compiled in a file of its own.
template <int D>
BatchFiller<D, double> filler_by_four(EffectSet effects);
template <int D>
BatchFiller<D, double> filler_by_eight(EffectSet effects);

template <int D, class Real>
BatchFiller<D, Real> find_vector_filler([[maybe_unused]] EffectSet effects) {
#ifdef DEM_HAS_VECTORS
  if constexpr (std::is_same_v<Real, double>) {
    if (usable_vectors() == Vectors::kAvx512) return filler_by_eight<D>(effects);
    if (usable_vectors() == Vectors::kAvx2) return filler_by_four<D>(effects);
  }
#endif
  return nullptr;
}

}  // namespace dem
