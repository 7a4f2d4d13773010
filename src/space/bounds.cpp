// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/space/bounds.hpp"

#include "src/base/extremes.hpp"
#include "src/base/parallel.hpp"

#include <algorithm>

namespace hg {
namespace {

// The same whatever the number of threads.
double sum_of_radii(const ParticleStore &store, int threads) {
  const size_t count = store.slots();
  const size_t tasks = parts_of(count);
  double parts[kMostParts];
  parallel_for(threads, tasks, [&](size_t task, int) {
    const size_t first = count * task / tasks, last = count * (task + 1) / tasks;
    parts[task] = sum_of(store.radii() + first, last - first);
  });
  double sum = 0;
  for (size_t task = 0; task < tasks; task++) sum += parts[task];
  return sum;
}

}  // namespace

Bounds bounds_of(const ParticleStore &store, const Domain &domain, int threads) {
  Bounds bounds;
  const size_t count = store.slots();
  if (count == 0) return bounds;
  const Survey &all = store.survey();
  bounds.max_radius = all.radius.greatest;
  // Not the outermost surfaces, which one giant may set, but the outermost centres and a mean particle around them.
  const double mean_diameter = 2 * (sum_of_radii(store, threads) / static_cast<double>(count));
  for (int k = 0; k < domain.dimension; k++) {
    const Extremes &axis = all.axis[k];
    bounds.min[k] = domain.periodic[k] ? 0 : axis.least;
    bounds.max[k] = domain.periodic[k] ? domain.length[k] : axis.greatest;
    bounds.width[k] = domain.length[k] > 0 ? domain.length[k] : axis.greatest - axis.least + mean_diameter;
  }
  return bounds;
}

}  // namespace hg
