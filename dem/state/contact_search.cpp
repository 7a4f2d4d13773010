// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The pairs that may touch soon, from the library.
#include "dem/state/contact_search.hpp"

#include <algorithm>
#include <vector>

namespace dem {
double usable_skin(const Setup &setup, double slack) {
  double skin = setup.skin;
  double largest[2]{};  // of two different particles
  visit_particles(setup, [&](const ParticleArrays &particles, size_t i) {
    const double radius = particles.radii[i];
    skin = std::min(skin, 2 * radius);
    largest[1] = std::max(largest[1], std::min(largest[0], radius));
    largest[0] = std::max(largest[0], radius);
  });
  const double growth = has(setup.effects, kGrowth) ? std::max(1.0, 1 + setup.growth_rate * setup.growth_end) : 1;
  const double widest = growth * (largest[0] + largest[1]) + contact_range(setup) + slack;
  for (int axis = 0; axis < setup.dimension; axis++) {
    if (!setup.periodic[axis]) continue;
    const double length = setup.box_max[axis] - setup.box_min[axis];
    skin = std::min(skin, length / 2 - widest - slack);
  }
  return std::max(0.0, skin);
}

hg_grid_def contact_grid_def(const Setup &setup, double margin) {
  hg_grid_def def = hg_default_grid_def();
  def.dimension = setup.dimension;
  def.thread_count = setup.threads;
  def.pair_order = HG_ORDER_ID;
  def.accuracy = HG_FLOAT;
  def.level_count = setup.level_count;
  def.margin = margin;
  for (int axis = 0; axis < setup.dimension; axis++) {
    def.box_min[axis] = setup.box_min[axis];
    def.box_max[axis] = setup.box_max[axis];
    def.periodic[axis] = setup.periodic[axis] ? 1 : 0;
  }
  return def;
}

ContactSearch::ContactSearch(const Setup &setup, double slack)
    : skin_(usable_skin(setup, slack)),
      def_(contact_grid_def(setup, contact_range(setup) + skin_ + slack)),
      grid_(def_),
      count_(setup.count()),
      sheared_(has(setup.effects, kShear)) {
  grid_.insert(count_, setup.centers.data(), setup.radii.data());
}

PairView ContactSearch::find(size_t count, const hg_array *centers, const hg_array *radius, double offset) {
  if (sheared_) {
    const double tilt[3] = {offset, 0, 0};
    grid_.set_box(def_.box_min, def_.box_max, tilt);
  }
  if (count == count_) {
    grid_.move_arrays(count, centers, radius);
  } else {
    grid_.set_arrays(count, centers, radius);
    count_ = count;
  }
  return grid_.query_pairs();
}

hgrid::Rows ContactSearch::near_triangles(const std::vector<double> &corners) const {
  return grid_.query_triangles(corners.size() / 9, corners.data());
}

}  // namespace dem
