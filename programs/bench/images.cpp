// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Images to one side of each axis only, and the one rule that keeps each pair once.
#include "programs/bench/images.hpp"

#include "programs/measure/timing.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace bench {
namespace {

// Of reach and edge: what rounding of wrapped and moved places may take.
constexpr double kSlack = 1e-12;

double edge_of(const particles::ParticleSet &set, int axis) { return set.box_max[axis] - set.box_min[axis]; }

double wrapped(const particles::ParticleSet &set, int axis, double x) {
  const double edge = edge_of(set, axis);
  if (set.periodic[axis] == 0 || (x >= set.box_min[axis] && x < set.box_max[axis])) return x;
  return x - edge * std::floor((x - set.box_min[axis]) / edge);
}

}  // namespace

bool is_periodic(const particles::ParticleSet &set) {
  return std::any_of(std::begin(set.periodic), std::end(set.periodic), [](int flag) { return flag != 0; });
}

Images::Images(const particles::ParticleSet &set)
    : set_(&set), largest_radius_(set.radii.empty() ? 0 : *std::max_element(set.radii.begin(), set.radii.end())) {
  all_.dimension = set.dimension;
  refresh();
}

uint32_t Images::axes_near_low_side(const double *center, double radius) const {
  uint32_t axes = 0;
  for (int axis = 0; axis < set_->dimension; axis++) {
    const double reach = (radius + largest_radius_) * (1 + kSlack) + kSlack * edge_of(*set_, axis);
    if (set_->periodic[axis] != 0 && center[axis] - set_->box_min[axis] <= reach) axes |= 1u << axis;
  }
  return axes;
}

void Images::refresh() {
  all_.centers.clear();
  all_.radii.clear();
  origins_.clear();
  double place[3];
  for (size_t i = 0; i < set_->count(); i++) {
    for (int axis = 0; axis < set_->dimension; axis++) place[axis] = wrapped(*set_, axis, set_->center(i)[axis]);
    all_.add(place, set_->radii[i]);
    origins_.push_back({static_cast<int32_t>(i), 0});
  }
  for (size_t i = 0; i < set_->count(); i++) {
    const uint32_t axes = axes_near_low_side(all_.center(i), set_->radii[i]);
    for (uint32_t shifts = 1; shifts <= axes; shifts++) {
      if ((shifts & ~axes) != 0) continue;
      for (int axis = 0; axis < set_->dimension; axis++) {
        const bool moves = (shifts >> axis & 1u) != 0;
        place[axis] = all_.center(i)[axis] + (moves ? edge_of(*set_, axis) : 0);
      }
      all_.add(place, set_->radii[i]);
      origins_.push_back({static_cast<int32_t>(i), shifts});
    }
  }
}

// The nearest images of two particles differ, along each axis, by a move of the one, of the other or of none. So of all
// pairs in `all` that stand for them just one moves no axis of both.
void Images::fold(PairView found, std::vector<hg_pair> &pairs) const {
  pairs.clear();
  for (const hg_pair &pair : found) {
    const Origin &a = origins_[static_cast<size_t>(pair.a)], &b = origins_[static_cast<size_t>(pair.b)];
    if ((a.shifts & b.shifts) != 0) continue;
    pairs.push_back({std::min(a.particle, b.particle), std::max(a.particle, b.particle)});
  }
}

Contestant with_images(Contestant contestant) {
  contestant.accuracy = Accuracy::kRounded;
  contestant.prepare = [prepare = std::move(contestant.prepare)](const particles::ParticleSet &set) {
    auto images = std::make_shared<Images>(set);
    const Search inner = prepare(images->all());
    Search search;
    if (!inner.run) return search;
    auto list = std::make_shared<std::vector<hg_pair>>();
    search.details = inner.details;
    search.run = [images, inner, list](PairView &pairs) {
      PairView found;
      double seconds = measure::seconds_of([&] { images->refresh(); });
      seconds += inner.run(found);
      seconds += measure::seconds_of([&] { images->fold(found, *list); });
      pairs = {list->data(), list->size()};
      return seconds;
    };
    return search;
  };
  return contestant;
}

}  // namespace bench
