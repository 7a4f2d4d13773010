// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Batches of contacts in plain code, for any effects on images and any numbers.
#include "dem/kernels/contact_batch.hpp"

#include "dem/effects/choice.hpp"
#include "dem/kernels/vector_batch.hpp"

#include <cmath>

namespace dem {
namespace {

// Distances and unit vectors from the separations that stand in their places. Centres that coincide are pushed apart
// along x.
template <class Real>
void normalize_batch(ContactBatch<Real> &batch) {
  for (size_t p = 0; p < batch.count; p++) {
    Real *x = batch.normal[0], *y = batch.normal[1], *z = batch.normal[2];
    const Real distance = std::sqrt(x[p] * x[p] + y[p] * y[p] + z[p] * z[p]);
    const bool apart = distance > 0;
    const Real inverse = apart ? 1 / distance : Real(0);
    x[p] = apart ? x[p] * inverse : Real(1);
    y[p] *= inverse;
    z[p] *= inverse;
    batch.distance[p] = distance;
  }
}

template <EffectSet E, int D, class Real>
size_t fill(const BatchTask<D, Real> &task, size_t next, size_t last, ContactBatch<Real> &batch) {
  size_t count = 0;
  for (; next < last && count < ContactBatch<Real>::kMost; next++) {
    const Row<Real> &a = task.places[task.pairs[next].a], &b = task.places[task.pairs[next].b];
    Vec<D, Real> separation = b.template vector<D>() - a.template vector<D>();
    [[maybe_unused]] const Real image_speed = task.boundary->template nearest<E>(separation);
    const Real touching = a.numbers[3] + b.numbers[3], reach = touching + task.range;
    const Real x = separation[0], y = separation[1], z = D == 3 ? separation[D - 1] : Real(0);
    // No branch: what does not touch is written over by the next.
    batch.place[count] = static_cast<uint32_t>(next);
    batch.normal[0][count] = x;
    batch.normal[1][count] = y;
    batch.normal[2][count] = z;
    batch.touching[count] = touching;
    if constexpr (has(E, kShear)) batch.image_speed[count] = image_speed;
    count += x * x + y * y + z * z < reach * reach ? 1 : 0;
  }
  batch.count = count;
  normalize_batch(batch);
  return next;
}

}  // namespace

template <int D, class Real>
BatchFiller<D, Real> find_batch_filler(EffectSet effects) {
  const BatchFiller<D, Real> wide = find_vector_filler<D, Real>(effects);
  if (wide != nullptr) return wide;
  return choose<kImageEffects, Real>(effects, [](auto set) { return &fill<decltype(set)::value, D, Real>; });
}

template BatchFiller<2, double> find_batch_filler(EffectSet);
template BatchFiller<3, double> find_batch_filler(EffectSet);
template BatchFiller<2, float> find_batch_filler(EffectSet);
template BatchFiller<3, float> find_batch_filler(EffectSet);

}  // namespace dem
