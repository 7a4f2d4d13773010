// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/index/squeezed_axes.hpp"

#include "src/base/ordered_bits.hpp"
#include "src/base/radix_sort.hpp"

#include <algorithm>

namespace hg {
namespace {

// Unsigned numbers in the order of the doubles; -0.0 comes before 0.0.
uint64_t ascending_bits(double x) {
  const uint64_t bits = bits_of(x);
  return bits ^ (bits >> 63 != 0 ? ~uint64_t{0} : uint64_t{1} << 63);
}

}  // namespace

Bounds SqueezedAxes::squeeze(const ParticleStore &store, const Domain &domain, double gap) {
  const size_t count = store.slots();
  const auto dimension = static_cast<size_t>(domain.dimension);
  centers_.require_room(count * dimension);
  sorted_.require_room(count);
  other_.require_room(count);
  Bounds bounds;
  for (int axis = 0; axis < domain.dimension; axis++) {
    if (domain.periodic[axis]) {
      const auto a = static_cast<size_t>(axis);
      for (size_t slot = 0; slot < count; slot++) centers_[slot * dimension + a] = store.center(slot)[a];
      bounds.max[axis] = domain.length[axis];
    } else {
      bounds.max[axis] = squeeze_axis(store, axis, dimension, gap);
    }
  }
  in_use_ = true;
  return bounds;
}

// Returns the extent.
double SqueezedAxes::squeeze_axis(const ParticleStore &store, int axis, size_t dimension, double gap) {
  const size_t count = store.slots();
  const auto a = static_cast<size_t>(axis);
  for (size_t slot = 0; slot < count; slot++) {
    sorted_[slot] = {ascending_bits(store.center(slot)[a]), static_cast<uint32_t>(slot)};
  }
  const Key *keys = radix_sort(sorted_.data(), other_.data(), count, 64, [](const Key &key) { return key.bits; });

  Buffer<Run> &runs = runs_[axis];
  size_t run = 0;
  double before = 0, extent = 0;
  for (size_t i = 0; i < count; i++) {
    const double x = store.center(keys[i].slot)[a];
    // Halves, as the difference may overflow.
    if (i == 0 || 0.5 * x - 0.5 * before > 0.5 * gap) {
      runs.grow(run + 1);
      runs[run++] = {x, i == 0 ? 0 : extent + gap};
    }
    const Run &here = runs[run - 1];
    extent = here.squeezed_begin + (x - here.begin);
    centers_[keys[i].slot * dimension + a] = extent;
    before = x;
  }
  run_count_[axis] = run;
  return extent;
}

double SqueezedAxes::position(int axis, double x) const {
  const Run *first = runs_[axis].data(), *end = first + run_count_[axis];
  const Run *after = std::upper_bound(first, end, x, [](double value, const Run &run) { return value < run.begin; });
  const Run &run = after == first ? *first : after[-1];
  const double squeezed = run.squeezed_begin + (x - run.begin);
  return after == end ? squeezed : std::min(squeezed, after->squeezed_begin);
}

}  // namespace hg
