// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/particles/bounds.hpp"

#include "src/base/parallel.hpp"
#include "src/base/reductions.hpp"

namespace hg {
namespace {

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

Bounds spread_of(const ParticleStore &store, const Domain &domain) {
  Bounds bounds;
  if (store.slots() == 0) return bounds;
  bounds.max_radius = store.summary().radius.greatest;
  for (int axis = 0; axis < domain.dimension; axis++) {
    const Interval &centers = store.summary().center[axis];
    bounds.min[axis] = domain.periodic[axis] ? 0 : centers.least;
    bounds.max[axis] = domain.periodic[axis] ? domain.length[axis] : centers.greatest;
  }
  return bounds;
}

Bounds bounds_of(const ParticleStore &store, const Domain &domain, int threads) {
  Bounds bounds = spread_of(store, domain);
  const size_t count = store.slots();
  if (count == 0) return bounds;
  // Not the outermost surfaces, which one giant may set, but the outermost centres and a mean particle around them.
  const double mean_diameter = 2 * (sum_of_radii(store, threads) / static_cast<double>(count));
  for (int axis = 0; axis < domain.dimension; axis++) {
    const Interval &centers = store.summary().center[axis];
    bounds.width[axis] =
        domain.length[axis] > 0 ? domain.length[axis] : centers.greatest - centers.least + mean_diameter;
  }
  return bounds;
}

}  // namespace hg
