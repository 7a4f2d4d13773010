// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/particles/bounds.hpp"

#include "src/base/parallel.hpp"
#include "src/base/reductions.hpp"

namespace hg {
namespace {

double sum_of_radii(const Participants &particles, int threads) {
  const size_t count = particles.count();
  const size_t tasks = parts_of(count);
  double parts[kMostParts];
  parallel_for(threads, tasks, [&](size_t task, int) {
    const size_t first = count * task / tasks, last = count * (task + 1) / tasks;
    parts[task] = sum_of(particles.radii() + first, last - first);
  });
  double sum = 0;
  for (size_t task = 0; task < tasks; task++) sum += parts[task];
  return sum;
}

}  // namespace

Bounds spread_of(const Participants &particles, const Domain &domain) {
  Bounds bounds;
  if (particles.count() == 0) return bounds;
  bounds.max_radius = particles.summary().radius.greatest;
  for (int axis = 0; axis < domain.dimension; axis++) {
    const Interval &centers = particles.summary().center[axis];
    bounds.min[axis] = domain.periodic[axis] ? 0 : centers.least;
    bounds.max[axis] = domain.periodic[axis] ? domain.length[axis] : centers.greatest;
  }
  return bounds;
}

Bounds bounds_of(const Participants &particles, const Domain &domain, int threads) {
  Bounds bounds = spread_of(particles, domain);
  const size_t count = particles.count();
  if (count == 0) return bounds;
  // Not the outermost surfaces, which one giant may set, but the outermost centres and a mean particle around them.
  const double mean_diameter = 2 * (sum_of_radii(particles, threads) / static_cast<double>(count));
  for (int axis = 0; axis < domain.dimension; axis++) {
    const Interval &centers = particles.summary().center[axis];
    bounds.width[axis] =
        domain.length[axis] > 0 ? domain.length[axis] : centers.greatest - centers.least + mean_diameter;
  }
  return bounds;
}

}  // namespace hg
