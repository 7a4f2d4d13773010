// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// From a set of effects that a scene asks for to the function that was compiled for it.
#pragma once

#include "dem/base/error.hpp"
#include "dem/effects/table.hpp"

#include <type_traits>
#include <utility>

namespace dem {

// DEM_ELASTIC_ONLY builds linear elastic contacts in a box of walls and nothing else: what the full program is compared
// with to show that an effect which is off costs nothing.
template <class Real>
constexpr bool is_built(EffectSet set) {
#ifdef DEM_ELASTIC_ONLY
  return set == 0 || set == kWalls;
#else
  return std::is_same_v<Real, double> || (set & ~effects_with(kInFloat)) == 0;
#endif
}

constexpr EffectSet subset_count(EffectSet set) {
  EffectSet count = 1;
  for (; set != 0; set &= set - 1) count *= 2;
  return count;
}

// The bits of `number`, spread over those of the set.
constexpr EffectSet subset(EffectSet set, EffectSet number) {
  EffectSet result = 0;
  for (; set != 0; set &= set - 1, number >>= 1) {
    if ((number & 1u) != 0) result |= set & ~(set - 1);
  }
  return result;
}

template <EffectSet mask, class Real, class Make, EffectSet... numbers>
auto choose_among(EffectSet wanted, Make make, std::integer_sequence<EffectSet, numbers...>) {
  decltype(make(std::integral_constant<EffectSet, 0>())) function = nullptr;
  const auto try_set = [&](auto set) {
    constexpr EffectSet kSet = decltype(set)::value;
    if constexpr (is_possible(kSet, mask) && is_built<Real>(kSet)) {
      if (kSet == wanted) function = make(set);
    }
  };
  (try_set(std::integral_constant<EffectSet, subset(mask, numbers)>()), ...);
  return function;
}

// make(set), a pointer to the function for a set that is a std::integral_constant, of those of the effects that `mask`
// has. Throws Error if this build has none.
template <EffectSet mask, class Real, class Make>
auto choose(EffectSet effects, Make make) {
  const EffectSet wanted = effects & mask;
  const auto function =
      choose_among<mask, Real>(wanted, make, std::make_integer_sequence<EffectSet, subset_count(mask)>());
  if (function == nullptr) throw Error("this build has no kernel for the effects together: " + names_of(wanted));
  return function;
}

}  // namespace dem
