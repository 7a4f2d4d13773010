// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Particles thrown class by class, from the largest radii down, against a grid that holds the larger classes.
#include "packing/placement.hpp"

#include "packing/grid_def.hpp"
#include "packing/relaxation.hpp"
#include "particles/error.hpp"
#include "particles/insert.hpp"

#include <algorithm>
#include <numeric>

namespace packing {
namespace {

// Radii within this factor are one class: particles that may be thrown onto each other.
constexpr double kClassRatio = 2.5;
// Dense packings leave at least a few per cent of the volume free; so many misses in a row mean there is no room.
constexpr int kMostThrows = 10000;
constexpr int kClassSweeps = 20;

// A centre in the box, no nearer to a wall than `radius`.
void throw_center(const Box &box, double radius, Random &random, double *center) {
  for (int axis = 0; axis < box.dimension(); axis++) {
    const double low = box.is_periodic(axis) ? 0 : radius;
    const double high = box.is_periodic(axis) ? box.edge(axis) : box.edge(axis) - radius;
    center[axis] = box.keep(axis, low + random.uniform() * (high - low), radius);
  }
}

// The members' centres are thrown and they join `placed`, whose centres `larger` holds.
void place_class(const Box &box, Random &random, hgrid::Grid &larger, const std::vector<double> &radii,
                 particles::ParticleSet &placed) {
  const size_t d = static_cast<size_t>(placed.dimension);
  for (const double radius : radii) {
    double center[3];
    int throws = 0;
    do {
      if (++throws > kMostThrows) throw particles::Error("no room left for a particle: lower the density");
      throw_center(box, radius, random, center);
    } while (!larger.query_sphere(center, 0).empty());
    placed.centers.insert(placed.centers.end(), center, center + d);
    placed.radii.push_back(radius);
  }
}

}  // namespace

void place_at_random(const Box &box, Random &random, particles::ParticleSet &set) {
  set.centers.assign(set.count() * static_cast<size_t>(box.dimension()), 0.0);
  std::vector<size_t> order(set.count());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(), [&set](size_t a, size_t b) { return set.radii[a] > set.radii[b]; });

  particles::ParticleSet placed = box.empty_set();
  const hg_grid_def def = grid_def(box);
  for (auto first = order.begin(); first != order.end();) {
    const double smallest = set.radii[*first] / kClassRatio;
    const auto last = std::find_if(first, order.end(), [&](size_t i) { return set.radii[i] < smallest; });
    std::vector<double> radii;
    for (auto i = first; i != last; i++) radii.push_back(set.radii[*i]);
    hgrid::Grid larger(def);
    particles::insert(placed, larger);
    place_class(box, random, larger, radii, placed);
    if (last != order.end()) relax(box, kClassSweeps, nullptr, placed);
    first = last;
  }
  const size_t d = static_cast<size_t>(box.dimension());
  for (size_t k = 0; k < order.size(); k++) {
    std::copy_n(&placed.centers[k * d], d, &set.centers[order[k] * d]);
  }
}

}  // namespace packing
