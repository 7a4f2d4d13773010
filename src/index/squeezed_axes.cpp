// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/index/squeezed_axes.hpp"

#include <algorithm>

namespace hg {

Bounds SqueezedAxes::squeeze(const Participants &particles, const Domain &domain, double gap) {
  const size_t count = particles.count();
  const auto dimension = static_cast<size_t>(domain.dimension);
  centers_.require_room(count * dimension);
  Bounds bounds;
  for (int axis = 0; axis < domain.dimension; axis++) {
    if (domain.periodic[axis]) {
      const auto a = static_cast<size_t>(axis);
      for (size_t slot = 0; slot < count; slot++) centers_[slot * dimension + a] = particles.center(slot)[a];
      bounds.max[axis] = domain.length[axis];
    } else {
      bounds.max[axis] = squeeze_axis(particles, axis, dimension, gap);
    }
  }
  in_use_ = true;
  return bounds;
}

// Returns the extent. Within a bin no gap is long, so that runs are runs of bins.
double SqueezedAxes::squeeze_axis(const Participants &particles, int axis, size_t dimension, double gap) {
  const size_t count = particles.count();
  const auto a = static_cast<size_t>(axis);
  bins_.begin(gap, count);
  for (size_t slot = 0; slot < count; slot += AxisBins::kTogether) {
    double x[AxisBins::kTogether];
    const size_t here = std::min(count - slot, AxisBins::kTogether);
    for (size_t i = 0; i < here; i++) x[i] = particles.center(slot + i)[a];
    bins_.add(slot, x, here);
  }
  bins_.sort();

  Buffer<Run> &runs = runs_[axis];
  bin_run_.require_room(bins_.count());
  size_t run = 0;
  double before = 0, extent = 0;
  for (size_t n = 0; n < bins_.count(); n++) {
    const uint32_t bin = bins_.sorted(n);
    const double x = bins_.least(bin);
    // Halves, as the difference may overflow.
    if (n == 0 || 0.5 * x - 0.5 * before > 0.5 * gap) {
      runs.grow(run + 1);
      runs[run++] = {x, n == 0 ? 0 : extent + gap};
    }
    const Run &here = bin_run_[bin] = runs[run - 1];
    before = bins_.greatest(bin);
    extent = here.squeezed_begin + (before - here.begin);
  }
  run_count_[axis] = run;
  for (size_t slot = 0; slot < count; slot++) {
    const Run &here = bin_run_[bins_.bin_of(slot)];
    centers_[slot * dimension + a] = here.squeezed_begin + (particles.center(slot)[a] - here.begin);
  }
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
