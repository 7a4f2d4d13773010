// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bounds.hpp"

#include "extremes.hpp"
#include "parallel.hpp"

#include <algorithm>

namespace hg {
namespace {

// One for each task. Tasks are so many at most, whatever the number of particles, and do not depend on the threads.
constexpr size_t kMaxTasks = 64;
constexpr size_t kLeastTask = 16384;

struct Part {
  Extremes axis[3] = {};
  Extremes radius = {};
  double radius_sum = 0;
};

Part look_at(const ParticleStore &store, int dimension, size_t first, size_t count) {
  Part part;
  if (dimension == 2) {
    column_extremes<2>(store.center(first), count, part.axis);
  } else {
    column_extremes<3>(store.center(first), count, part.axis);
  }
  column_extremes<1>(store.radii() + first, count, &part.radius);
  part.radius_sum = sum_of(store.radii() + first, count);
  return part;
}

}  // namespace

Bounds bounds_of(const ParticleStore &store, const Domain &domain, int threads) {
  Bounds bounds;
  const size_t count = store.slots();
  if (count == 0) return bounds;
  const size_t tasks = std::clamp<size_t>(count / kLeastTask, 1, kMaxTasks);
  Part parts[kMaxTasks];
  parallel_for(threads, tasks, [&](size_t task, int) {
    const size_t first = count * task / tasks, last = count * (task + 1) / tasks;
    parts[task] = look_at(store, domain.dimension, first, last - first);
  });
  Part all = parts[0];
  for (size_t task = 1; task < tasks; task++) {
    for (int k = 0; k < domain.dimension; k++) {
      all.axis[k].least = std::min(all.axis[k].least, parts[task].axis[k].least);
      all.axis[k].greatest = std::max(all.axis[k].greatest, parts[task].axis[k].greatest);
    }
    all.radius.greatest = std::max(all.radius.greatest, parts[task].radius.greatest);
    all.radius_sum += parts[task].radius_sum;
  }
  bounds.max_radius = all.radius.greatest;
  // Not the outermost surfaces, which one giant may set, but the outermost centres and a mean particle around them.
  const double mean_diameter = 2 * (all.radius_sum / static_cast<double>(count));
  for (int k = 0; k < domain.dimension; k++) {
    const Extremes &axis = all.axis[k];
    bounds.min[k] = domain.periodic[k] ? 0 : axis.least;
    bounds.max[k] = domain.periodic[k] ? domain.length[k] : axis.greatest;
    bounds.width[k] = domain.length[k] > 0 ? domain.length[k] : axis.greatest - axis.least + mean_diameter;
  }
  return bounds;
}

}  // namespace hg
