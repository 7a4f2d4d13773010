// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The pairs of each step, from the library.
#include "dem/state/contact_search.hpp"

#include "dem/base/error.hpp"
#include "dem/effects/contact_law.hpp"

#include <algorithm>

namespace dem {
namespace {

bool by_id(const hg_pair &p, const hg_pair &q) { return p.a < q.a || (p.a == q.a && p.b < q.b); }

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
  // The library knows images at fixed places only. Under shear those along y move: y is open to it, and the pairs
  // across are asked for one by one.
  if (has(setup.effects, kShear)) def.periodic[1] = 0;
  return def;
}

}  // namespace

ContactSearch::ContactSearch(const Setup &setup)
    : grid_(grid_def(setup)),
      dimension_(static_cast<size_t>(setup.dimension)),
      count_(setup.count()),
      sheared_(has(setup.effects, kShear)),
      margin_(contact_range(setup)) {
  grid_.insert(count_, setup.centers.data(), setup.radii.data());
  if (!sheared_) return;
  low_ = setup.box_min[1];
  high_ = setup.box_max[1];
  radii_ = setup.radii;
  const double reach = 2 * *std::max_element(radii_.begin(), radii_.end()) + margin_;
  if (high_ - low_ < 2 * reach) {
    throw Error("the box is " + text(high_ - low_) + " high: under shear it needs twice the largest reach, " +
                text(2 * reach));
  }
}

PairView ContactSearch::find(const double *centers, const double *radii, double offset) {
  grid_.move(count_, centers, radii);
  const PairView pairs = grid_.query_pairs();
  if (!sheared_) return pairs;
  if (radii != nullptr) radii_.assign(radii, radii + count_);
  pairs_.assign(pairs.begin(), pairs.end());
  add_pairs_across(centers, offset);
  return {pairs_.data(), pairs_.size()};
}

// A particle near the upper face meets those near the lower one where its image below is.
void ContactSearch::add_pairs_across(const double *centers, double offset) {
  const double reach = *std::max_element(radii_.begin(), radii_.end()) + margin_;
  const size_t within = pairs_.size();
  for (size_t i = 0; i < count_; i++) {
    const double *center = centers + i * dimension_;
    if (center[1] + radii_[i] + reach < high_) continue;
    double image[3] = {center[0] - offset, center[1] - (high_ - low_), dimension_ == 3 ? center[2] : 0};
    for (const int32_t id : grid_.query_sphere(image, radii_[i])) {
      pairs_.push_back({std::min(id, static_cast<int32_t>(i)), std::max(id, static_cast<int32_t>(i))});
    }
  }
  const auto middle = pairs_.begin() + static_cast<ptrdiff_t>(within);
  std::sort(middle, pairs_.end(), by_id);
  std::inplace_merge(pairs_.begin(), middle, pairs_.end(), by_id);
}

}  // namespace dem
