// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// One sphere, not a particle, against ranges of particles: the fast test for queries of single places. One source for
// all instruction sets: V wraps the vectors of one of them, Rule says when particles interact.
//
// Everything here is in an unnamed namespace: each instruction set compiles its own copy, none may leak into another.
#pragma once

#include "src/exact/fast_test.hpp"
#include "src/kernels/kernel_set.hpp"

namespace hg {
namespace {

// Those of the hits just written whose lane is not sure get their mark.
__attribute__((noinline)) inline void mark_unsure(uint32_t *hits, uint32_t found, uint32_t unsure) {
  for (; unsure != 0; unsure &= unsure - 1) {
    hits[__builtin_popcount(found & ((unsure & -unsure) - 1u))] |= kUnsureHit;
  }
}

template <class V, int D, class Rule>
size_t find_hits(const SpherePoint &sphere, const PointArrays &particles, uint32_t begin, uint32_t end,
                 uint32_t *hits) {
  using F = typename V::Float;
  using I = typename V::Int;
  const I x = V::set(sphere.at.x), y = V::set(sphere.at.y), z = V::set(D == 3 ? sphere.at.z : 0);
  const F radius = V::set(sphere.at.radius), band_constant = V::set(kBandConstant);
  const I limit = V::set(static_cast<int32_t>(end));
  uint32_t *next = hits;
  for (uint32_t j = begin; j < end; j += V::kLanes) {
    const F dx = V::to_float(V::sub(x, V::load(particles.x + j)));
    const F dy = V::to_float(V::sub(y, V::load(particles.y + j)));
    F d2 = V::add(V::mul(dx, dx), V::mul(dy, dy));
    if constexpr (D == 3) {
      const F dz = V::to_float(V::sub(z, V::load(particles.z + j)));
      d2 = V::add(d2, V::mul(dz, dz));
    }
    const auto verdict = fast_test<V>(d2, Rule::template base<V>(radius, V::load(particles.radius + j)), band_constant);
    const I index = V::add(V::set(static_cast<int32_t>(j)), V::iota());
    const auto found = V::both(V::less(verdict.t, verdict.band), V::greater(limit, index));
    const uint32_t bits = V::bits(found), unsure = sphere.may_be_sure ? bits & ~verdict.sure() : bits;
    V::compress(next, index, found);
    if (__builtin_expect(unsure != 0, 0)) mark_unsure(next, bits, unsure);
    next += V::count(found);
  }
  return static_cast<size_t>(next - hits);
}

}  // namespace
}  // namespace hg
