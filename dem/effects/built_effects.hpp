// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which sets of effects this build has kernels for.
#pragma once

#include "dem/base/error.hpp"
#include "dem/effects/effects.hpp"

#include <type_traits>

namespace dem {

// DEM_ELASTIC_ONLY builds linear elastic contacts in a box of walls and nothing else: what the full program is compared
// with to show that an effect which is off costs nothing. States in float are there to measure their accuracy.
template <class Real>
constexpr bool is_built(EffectSet set) {
#ifdef DEM_ELASTIC_ONLY
  return set == 0 || set == kWalls;
#else
  if (std::is_same_v<Real, float>) return (set & ~(kDissipation | kHertz | kPeriodic | kWalls | kGravity)) == 0;
  return is_possible(set & kPairEffects);
#endif
}

[[noreturn]] inline void refuse_unbuilt(EffectSet set) {
  throw Error("this build has no kernel for the effects together: " + names_of(set));
}

}  // namespace dem
