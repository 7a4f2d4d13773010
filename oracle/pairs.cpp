// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/pairs.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace oracle {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Sphere sphere_of(const particles::ParticleSet &particles, size_t row) {
  return {particles.center(row), particles.radii[row]};
}

std::vector<int32_t> ids_from(int32_t first, size_t count) {
  std::vector<int32_t> ids(count);
  std::iota(ids.begin(), ids.end(), first);
  return ids;
}

struct Extent {
  double low, high;
  size_t row;
};

// Partners have |dx| <= r_i + r_j + margin for either interaction, so their extents, each with half the margin,
// overlap. The two steps outwards make up for the two roundings.
Extent extent_of(const hg_grid_def &def, const Sphere &sphere, size_t row) {
  const double x = sphere.center[0];
  const double half = std::nextafter(sphere.radius + 0.5 * def.margin, kInfinity);
  return {std::nextafter(x - half, -kInfinity), std::nextafter(x + half, kInfinity), row};
}

// The first row that a row can be a pair with: with HG_ALL_IMAGES that may be itself.
size_t first_partner(const hg_grid_def &def, size_t row) { return def.images == HG_ALL_IMAGES ? row : row + 1; }

// The pair as often as it is one. A sphere has each of its images twice, at opposite shifts, and itself.
void add_pair(Pairs &pairs, const hg_grid_def &def, const particles::ParticleSet &particles,
              const std::vector<int32_t> &ids, size_t a, size_t b, Rule *rule) {
  const int found = rule(def, sphere_of(particles, a), sphere_of(particles, b));
  pairs.insert(pairs.end(), static_cast<size_t>(a == b ? found / 2 : found), {ids[a], ids[b]});
}

}  // namespace

Pairs all_pairs(const hg_grid_def &def, const particles::ParticleSet &particles, const std::vector<int32_t> &ids,
                Rule *rule) {
  Pairs pairs;
  for (size_t i = 0; i < particles.count(); i++) {
    for (size_t j = first_partner(def, i); j < particles.count(); j++) {
      add_pair(pairs, def, particles, ids, i, j, rule);
    }
  }
  return pairs;
}

Pairs all_pairs(const hg_grid_def &def, const particles::ParticleSet &particles, Rule *rule) {
  return all_pairs(def, particles, ids_from(def.index_base, particles.count()), rule);
}

Pairs swept_pairs(const hg_grid_def &def, const particles::ParticleSet &particles, Rule *rule) {
  if (def.periodic[0] != 0) throw std::invalid_argument("a sweep along x needs an open x axis");
  std::vector<Extent> extents;
  for (size_t row = 0; row < particles.count(); row++) {
    extents.push_back(extent_of(def, sphere_of(particles, row), row));
  }
  std::sort(extents.begin(), extents.end(), [](const Extent &a, const Extent &b) { return a.low < b.low; });
  const std::vector<int32_t> ids = ids_from(def.index_base, particles.count());
  Pairs pairs;
  for (size_t i = 0; i < extents.size(); i++) {
    for (size_t j = first_partner(def, i); j < extents.size() && extents[j].low <= extents[i].high; j++) {
      const auto [a, b] = std::minmax(extents[i].row, extents[j].row);
      add_pair(pairs, def, particles, ids, a, b, rule);
    }
  }
  std::sort(pairs.begin(), pairs.end(), pair_less);
  return pairs;
}

// Of a sphere larger than the cell the nearest image alone is looked at, of the many that it meets.
bool meets(const hg_grid_def &def, const Sphere &sphere, const Sphere &particle, Rule *rule) {
  hg_grid_def nearest = def;
  nearest.images = HG_NEAREST_IMAGE;
  return rule(nearest, sphere, particle) > 0 || (def.images == HG_ALL_IMAGES && rule(def, sphere, particle) > 0);
}

std::vector<int32_t> all_in_sphere(const hg_grid_def &def, const particles::ParticleSet &particles,
                                   const Sphere &sphere, Rule *rule) {
  std::vector<int32_t> ids;
  for (size_t i = 0; i < particles.count(); i++) {
    if (meets(def, sphere, sphere_of(particles, i), rule)) ids.push_back(static_cast<int32_t>(i) + def.index_base);
  }
  return ids;
}

// A sphere twice as large as the two together meets images of itself. That is certain beyond the longest that a
// shortest vector can be for the volume of the cell (Hermite), which keeps the number of images small.
bool can_meet_twice(const hg_grid_def &def, const particles::ParticleSet &particles) {
  if (particles.count() < 2) return false;
  std::vector<double> radii = particles.radii;
  std::partial_sort(radii.begin(), radii.begin() + 2, radii.end(), std::greater<>());
  double logarithm = 0;  // of the volume
  int axes = 0;
  for (int axis = 0; axis < def.dimension; axis++) {
    if (def.periodic[axis] == 0) continue;
    logarithm += std::log(def.box_max[axis] - def.box_min[axis]);
    axes++;
  }
  if (axes == 0) return false;
  const double sum = def.interaction == HG_MAX_RANGE ? radii[0] : radii[0] + radii[1];
  if (std::log(2 * (sum + def.margin)) > logarithm / axes + 0.2) return true;
  hg_grid_def twice = def;
  twice.images = HG_ALL_IMAGES;
  twice.touching = 0;
  twice.margin = 2 * def.margin;
  const double anywhere[3] = {0, 0, 0};
  return exact_interact(twice, {anywhere, 2 * radii[0]}, {anywhere, 2 * radii[1]}) > 1;
}

Difference difference(const Pairs &truth, Pairs found) {
  std::sort(found.begin(), found.end(), pair_less);
  Difference result;
  std::set_difference(truth.begin(), truth.end(), found.begin(), found.end(), std::back_inserter(result.missing),
                      pair_less);
  std::set_difference(found.begin(), found.end(), truth.begin(), truth.end(), std::back_inserter(result.extra),
                      pair_less);
  return result;
}

size_t nearer_images(const Pairs &found, const hg_pair &pair) {
  const auto [first, last] = std::equal_range(found.begin(), found.end(), pair, pair_less);
  const auto times = static_cast<size_t>(last - first);
  return pair.a == pair.b ? 2 * times - 1 : times - 1;
}

}  // namespace oracle
