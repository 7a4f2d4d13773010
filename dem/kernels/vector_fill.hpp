// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Batches of contacts with vectors, one source for all widths: who includes this has a class Lanes with the operations,
// and DEM_LANES, which says for which machine to compile. Each number comes from the same operations in the same order
// as in plain code, none of them fused, so that its bits are the same.
#pragma once

#include "dem/effects/choice.hpp"
#include "dem/kernels/contact_batch.hpp"

namespace dem {
namespace {

using Number = Lanes::Number;

// As Boundary::nearest.
template <int D>
DEM_LANES inline Number nearest(const Boundary<D, double> &boundary, int axis, Number separation) {
  const Number whole = Lanes::set(0x1.8p52);
  const Number cells = Lanes::mul(separation, Lanes::set(boundary.inverse_period[axis]));
  const Number crossed = Lanes::sub(Lanes::add(cells, whole), whole);
  return Lanes::sub(separation, Lanes::mul(Lanes::set(boundary.period[axis]), crossed));
}

// x_b - x_a, y_b - y_a, z_b - z_a and r_b + r_a: rows are subtracted, then turned into columns.
DEM_LANES inline void columns(const Row<double> *places, const hg_pair *pairs, Number &x, Number &y, Number &z,
                              Number &touching) {
  const __m256d minus = _mm256_setr_pd(-0.0, -0.0, -0.0, 0.0);
  __m256d rows[Lanes::kCount];
  for (size_t k = 0; k < Lanes::kCount; k++) {
    const __m256d a = _mm256_load_pd(places[pairs[k].a].numbers), b = _mm256_load_pd(places[pairs[k].b].numbers);
    rows[k] = _mm256_add_pd(b, _mm256_xor_pd(a, minus));
  }
  Lanes::turn(rows, x, y, z, touching);
}

DEM_LANES inline Number squared(Number x, Number y, Number z) {
  return Lanes::add(Lanes::add(Lanes::mul(x, x), Lanes::mul(y, y)), Lanes::mul(z, z));
}

// Distances and unit vectors from the separations that stand in their places.
DEM_LANES inline void normalize_batch(ContactBatch<double> &batch) {
  const Number zero = Lanes::set(0), one = Lanes::set(1);
  for (size_t p = 0; p < batch.count; p += Lanes::kCount) {
    const Number x = Lanes::load(batch.normal[0] + p), y = Lanes::load(batch.normal[1] + p);
    const Number z = Lanes::load(batch.normal[2] + p);
    const Number distance = Lanes::sqrt(squared(x, y, z));
    const Lanes::Truth apart = Lanes::less(zero, distance);
    const Number inverse = Lanes::either(apart, Lanes::div(one, distance), zero);
    Lanes::store(batch.normal[0] + p, Lanes::either(apart, Lanes::mul(x, inverse), one));
    Lanes::store(batch.normal[1] + p, Lanes::mul(y, inverse));
    Lanes::store(batch.normal[2] + p, Lanes::mul(z, inverse));
    Lanes::store(batch.distance + p, distance);
  }
}

template <EffectSet E, int D>
DEM_ENTRY size_t fill(const BatchTask<D, double> &task, size_t next, size_t last, ContactBatch<double> &batch) {
  constexpr size_t kLanes = Lanes::kCount;
  const Number range = Lanes::set(task.range);
  size_t count = 0;
  for (; next < last && count < ContactBatch<double>::kMost; next += kLanes) {
    hg_pair end[kLanes];  // the last few and what fills them up
    const hg_pair *pairs = task.pairs + next;
    unsigned there = (1u << kLanes) - 1;
    if (last - next < kLanes) {
      for (size_t k = 0; k < kLanes; k++) end[k] = task.pairs[next + k < last ? next + k : next];
      pairs = end;
      there = (1u << (last - next)) - 1;
    }
    Number x, y, z, touching;
    columns(task.places, pairs, x, y, z, touching);
    if constexpr (has(E, kPeriodic)) {
      x = nearest(*task.boundary, 0, x);
      y = nearest(*task.boundary, 1, y);
      if constexpr (D == 3) z = nearest(*task.boundary, 2, z);
    }
    const Number reach = Lanes::add(touching, range);
    const unsigned hit = there & Lanes::bits(Lanes::less(squared(x, y, z), Lanes::mul(reach, reach)));
    Lanes::pack_places(hit, next, batch.place + count);
    Lanes::pack(hit, x, batch.normal[0] + count);
    Lanes::pack(hit, y, batch.normal[1] + count);
    Lanes::pack(hit, z, batch.normal[2] + count);
    Lanes::pack(hit, touching, batch.touching + count);
    count += static_cast<size_t>(__builtin_popcount(hit));
  }
  batch.count = count;
  normalize_batch(batch);
  return next < last ? next : last;
}

// Images that slide are for plain code.
template <int D>
BatchFiller<D, double> filler_of(EffectSet effects) {
  if (has(effects, kShear)) return nullptr;
  return choose<kPeriodic, double>(effects, [](auto set) { return &fill<decltype(set)::value, D>; });
}

}  // namespace
}  // namespace dem
