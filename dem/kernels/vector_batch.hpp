// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Batches of contacts with vectors of eight doubles, where the machine has them.
#pragma once

#include "dem/kernels/contact_batch.hpp"

#include <type_traits>

namespace dem {

// Null where this machine has no such vectors, or HGRID_ISA names narrower ones. Without shear.
template <int D>
BatchFiller<D, double> find_double_filler(EffectSet effects);

template <int D, class Real>
BatchFiller<D, Real> find_vector_filler(EffectSet effects) {
  if constexpr (std::is_same_v<Real, double>) {
    return find_double_filler<D>(effects);
  } else {
    return nullptr;
  }
}

}  // namespace dem
