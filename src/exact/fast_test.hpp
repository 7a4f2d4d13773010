// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The test of single precision that decides nearly all pairs, on fixed-point coordinates (space/fixed_point.hpp). It is
// sure or silent: docs/theory/exactness.md, section 5, proves the bounds. V wraps the vectors of an instruction set;
// everything is in an unnamed namespace, as each instruction set compiles its own copy and none may leak into another.
#pragma once

#include <cfloat>
#include <cstdint>

static_assert(FLT_EVAL_METHOD == 0, "extended precision would make pairs depend on the compiler");

namespace hg {

// |t - (d^2 - R^2)| < R * (kBandLinear + kBandSquare * R) + kBandConstant wherever the sign of t could be wrong.
inline constexpr float kBandLinear = 13.0f;
inline constexpr float kBandSquare = 0x1p-19f;
inline constexpr float kBandConstant = 40.0f;

namespace {

// t = d^2 - R^2 in float: below -band the pair surely interacts, from band on surely not.
template <class V>
struct FastTest {
  typename V::Float t, band;

  uint32_t possible() const { return V::bits(V::less(t, band)); }
  uint32_t sure() const { return V::bits(V::less(V::add(t, band), V::set(0.0f))); }
};

// `band_constant`: kBandConstant, or infinity to have nothing rejected and nothing sure.
template <class V>
FastTest<V> fast_test(typename V::Float distance2, typename V::Float reach, typename V::Float band_constant) {
  const auto t = V::sub(distance2, V::mul(reach, reach));
  const auto slope = V::add(V::mul(reach, V::set(kBandSquare)), V::set(kBandLinear));
  return {t, V::add(V::mul(reach, slope), band_constant)};
}

}  // namespace
}  // namespace hg
