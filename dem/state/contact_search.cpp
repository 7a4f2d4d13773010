// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The pairs of each step, from the library.
#include "dem/state/contact_search.hpp"

#include "dem/effects/contact_law.hpp"

namespace dem {
namespace {

hg_grid_def grid_def(const Setup &setup) {
  hg_grid_def def = hg_default_grid_def();
  def.dimension = setup.dimension;
  def.thread_count = setup.threads;
  def.pair_order = HG_ORDER_ID;
  def.level_count = setup.level_count;
  def.skin = setup.skin;
  def.margin = contact_range(setup);
  for (int axis = 0; axis < setup.dimension; axis++) {
    def.box_min[axis] = setup.box_min[axis];
    def.box_max[axis] = setup.box_max[axis];
    def.periodic[axis] = setup.periodic[axis] ? 1 : 0;
  }
  return def;
}

}  // namespace

ContactSearch::ContactSearch(const Setup &setup)
    : def_(grid_def(setup)), grid_(def_), count_(setup.count()), sheared_(has(setup.effects, kShear)) {
  grid_.insert(count_, setup.centers.data(), setup.radii.data());
}

PairView ContactSearch::find(const double *centers, const double *radii, double offset) {
  if (sheared_) {
    const double tilt[3] = {offset, 0, 0};
    grid_.set_box(def_.box_min, def_.box_max, tilt);
  }
  grid_.move(count_, centers, radii);
  return grid_.query_pairs();
}

}  // namespace dem
