// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The list behind the fuzzer of the C interface.
#include "fuzz/grid_model.hpp"

#include "fuzz/expect.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace fuzz {
namespace {

using oracle::Pairs;
using oracle::Sphere;

constexpr double kFloatExtra = 0x1p-47;  // docs/theory/exactness.md, section 9

}  // namespace

GridModel::GridModel(const hg_grid_def &def) : def_(def), next_id_(def.index_base) {
  particles_.dimension = def.dimension;
}

bool GridModel::may_take(const particles::ParticleSet &particles) const {
  for (const double x : particles.centers) {
    if (!std::isfinite(x)) return false;
  }
  for (const double r : particles.radii) {
    if (!std::isfinite(r) || r < 0) return false;
  }
  return true;
}

bool GridModel::must_take(const particles::ParticleSet &particles) const {
  if (!may_take(particles) || def_.level_rule == HG_LEVELS_USER || def_.margin > 1e300) return false;
  for (int k = 0; k < def_.dimension; k++) {
    if (def_.periodic[k] != 0) return false;
  }
  return std::all_of(particles.radii.begin(), particles.radii.end(), [](double r) { return r < 1e300; });
}

void GridModel::insert(const particles::ParticleSet &particles) {
  for (size_t row = 0; row < particles.count(); row++) {
    particles_.add(particles.center(row), particles.radii[row]);
    ids_.push_back(next_id_++);
  }
}

void GridModel::move(const std::vector<double> &centers, const std::vector<double> *radii) {
  particles_.centers = centers;
  if (radii != nullptr) particles_.radii = *radii;
}

bool GridModel::remove(const std::vector<int32_t> &ids) {
  std::vector<int32_t> gone = ids;
  std::sort(gone.begin(), gone.end());
  if (std::adjacent_find(gone.begin(), gone.end()) != gone.end()) return false;
  if (!std::includes(ids_.begin(), ids_.end(), gone.begin(), gone.end())) return false;
  particles::ParticleSet left;
  left.dimension = particles_.dimension;
  std::vector<int32_t> left_ids;
  for (size_t row = 0; row < ids_.size(); row++) {
    if (std::binary_search(gone.begin(), gone.end(), ids_[row])) continue;
    left.add(particles_.center(row), particles_.radii[row]);
    left_ids.push_back(ids_[row]);
  }
  particles_ = left;
  ids_ = left_ids;
  return true;
}

void GridModel::clear() {
  particles_.centers.clear();
  particles_.radii.clear();
  ids_.clear();
  next_id_ = def_.index_base;
}

size_t GridModel::row_of(int32_t id) const {
  return static_cast<size_t>(std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin());
}

// HG_DOUBLE is bound to its expression where squares are normal numbers and no image is in doubt.
GridModel::Promise GridModel::promise(const particles::ParticleSet &particles) const {
  if (def_.accuracy == HG_EXACT) return Promise::kExact;
  if (def_.accuracy == HG_FLOAT) return Promise::kFloat;
  for (int k = 0; k < def_.dimension; k++) {
    if (def_.periodic[k] != 0) return Promise::kSane;
  }
  for (const double r : particles.radii) {
    const double reach = r + def_.margin;
    if (reach != 0 && reach < 1e-140) return Promise::kSane;
  }
  return Promise::kDouble;
}

void GridModel::check_pairs(Pairs pairs) const {
  std::sort(pairs.begin(), pairs.end(), oracle::pair_less);
  expect(std::adjacent_find(pairs.begin(), pairs.end(), oracle::pair_equal) == pairs.end(), "a pair comes twice");
  for (const hg_pair &pair : pairs) {
    expect(pair.a < pair.b, "a pair is not a < b");
    expect(std::binary_search(ids_.begin(), ids_.end(), pair.a), "a pair has an unknown a");
    expect(std::binary_search(ids_.begin(), ids_.end(), pair.b), "a pair has an unknown b");
  }
  const Promise held = promise(particles_);
  if (held == Promise::kSane) return;
  const bool plain = held == Promise::kDouble;
  const Pairs expected =
      oracle::all_pairs(def_, particles_, ids_, plain ? oracle::double_interact : oracle::exact_interact);
  const oracle::Difference wrong = oracle::difference(expected, pairs);
  expect(wrong.missing.empty(), "a pair is missing");
  for (const hg_pair &pair : wrong.extra) {
    expect(held == Promise::kFloat, "a pair is wrong");
    const size_t a = row_of(pair.a), b = row_of(pair.b);
    const Sphere first = {particles_.center(a), particles_.radii[a]},
                 other = {particles_.center(b), particles_.radii[b]};
    expect(oracle::relative_gap(def_, first, other) <= kFloatExtra, "an extra pair of HG_FLOAT is too far apart");
  }
}

void GridModel::check_sphere(const Sphere &sphere, const int32_t *ids, size_t count) const {
  expect(std::is_sorted(ids, ids + count), "ids of a sphere do not ascend");
  expect(std::adjacent_find(ids, ids + count) == ids + count, "an id of a sphere comes twice");
  expect(std::includes(ids_.begin(), ids_.end(), ids, ids + count), "a sphere meets an unknown particle");
  particles::ParticleSet with_sphere = particles_;
  with_sphere.add(sphere.center, sphere.radius);
  const Promise held = promise(with_sphere);
  if (held == Promise::kSane || held == Promise::kFloat) return;
  for (size_t row = 0; row < ids_.size(); row++) {
    const Sphere particle = {particles_.center(row), particles_.radii[row]};
    const bool found = std::binary_search(ids, ids + count, ids_[row]);
    const bool wanted = held == Promise::kDouble ? oracle::double_interact(def_, sphere, particle)
                                                 : oracle::exact_interact(def_, sphere, particle);
    expect(found == wanted, found ? "a sphere meets a particle too many" : "a sphere misses a particle");
  }
}

}  // namespace fuzz
