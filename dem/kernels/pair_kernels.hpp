// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The tables of pair kernels: for each kind of boundary one kernel per set of law effects.
#pragma once

#include "dem/effects/built_effects.hpp"
#include "dem/kernels/pair_kernel.hpp"

#include <array>
#include <utility>

namespace dem {

// The kernel of a set of law effects at one kind of boundary; null if it is not built. Defined in a file each, so that
// they compile side by side.
template <int D, class Real>
PairKernel<D, Real> pair_kernel_open(EffectSet law);
template <int D, class Real>
PairKernel<D, Real> pair_kernel_periodic(EffectSet law);
template <int D, class Real>
PairKernel<D, Real> pair_kernel_sheared(EffectSet law);

template <EffectSet E, int D, class Real>
constexpr PairKernel<D, Real> pair_kernel_or_null() {
  if constexpr (is_possible(E) && is_built<Real>(E)) {
    return &pair_forces<E, D, Real>;
  } else {
    return nullptr;
  }
}

template <EffectSet boundary, int D, class Real, EffectSet... laws>
PairKernel<D, Real> pick_pair_kernel(EffectSet law, std::integer_sequence<EffectSet, laws...>) {
  static constexpr std::array<PairKernel<D, Real>, sizeof...(laws)> kTable = {
      pair_kernel_or_null<boundary | laws, D, Real>()...};
  return kTable[law];
}

template <EffectSet boundary, int D, class Real>
PairKernel<D, Real> pair_kernel_at(EffectSet law) {
  return pick_pair_kernel<boundary, D, Real>(law, std::make_integer_sequence<EffectSet, kLawEffects + 1>());
}

}  // namespace dem
