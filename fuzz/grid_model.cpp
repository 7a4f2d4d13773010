// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The list behind the fuzzer of the C interface.
#include "fuzz/grid_model.hpp"

#include "fuzz/expect.hpp"
#include "oracle/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace fuzz {
namespace {

using oracle::Pairs;
using oracle::Sphere;

constexpr double kFloatExtra = 0x1p-47;  // docs/theory/exactness.md, section 9

bool is_periodic(const hg_grid_def &def) { return def.periodic[0] + def.periodic[1] + def.periodic[2] > 0; }

double length_of(const hg_grid_def &def, int axis) { return def.box_max[axis] - def.box_min[axis]; }

// Edges and tilts of like lengths, far from the ends of the doubles.
bool has_sane_box(const hg_grid_def &def) {
  double least = 1e100, greatest = 1e-100;
  for (int k = 0; k < def.dimension; k++) {
    if (def.periodic[k] == 0) continue;
    least = std::fmin(least, length_of(def, k));
    greatest = std::fmax(greatest, length_of(def, k));
  }
  for (const double tilt : def.tilt) greatest = std::fmax(greatest, std::fabs(tilt) / 256);
  return least > 1e-100 && greatest < 1e100 && greatest < 1000 * least && def.margin < 1000 * least;
}

// Whether a place is so many cells away, or is taken there on the way to the cell, that it may be refused.
bool is_far_away(const hg_grid_def &def, const double *center) {
  double cells[3] = {0, 0, 0};
  for (int k = def.dimension - 1; k >= 0; k--) {
    if (def.periodic[k] == 0) continue;
    double size = std::fabs(center[k] - def.box_min[k]);
    if (k == 1) size += cells[2] * std::fabs(def.tilt[2]);
    if (k == 0) size += cells[1] * std::fabs(def.tilt[0]) + cells[2] * std::fabs(def.tilt[1]);
    cells[k] = size / length_of(def, k) + 1;
    if (cells[k] > 0x1p18) return true;
  }
  return false;
}

}  // namespace

GridModel::GridModel(const hg_grid_def &def) : def_(def), next_id_(def.index_base) {
  particles_.dimension = def.dimension;
}

bool GridModel::may_hold(const hg_grid_def &def, const particles::ParticleSet &particles) {
  for (const double x : particles.centers) {
    if (!std::isfinite(x)) return false;
  }
  for (const double r : particles.radii) {
    if (!std::isfinite(r) || r < 0) return false;
  }
  return def.images == HG_ALL_IMAGES || !has_sane_box(def) || !oracle::can_meet_twice(def, particles);
}

// Of periodic boxes only those that no rounding and no limit comes near to.
bool GridModel::must_hold(const hg_grid_def &def, const particles::ParticleSet &particles) {
  if (!may_hold(def, particles) || def.level_rule == HG_LEVELS_USER || def.margin > 1e300) return false;
  if (!std::all_of(particles.radii.begin(), particles.radii.end(), [](double r) { return r < 1e300; })) return false;
  if (!is_periodic(def)) return true;
  if (!has_sane_box(def) || def.images == HG_ALL_IMAGES) return false;
  for (size_t row = 0; row < particles.count(); row++) {
    if (is_far_away(def, particles.center(row))) return false;
  }
  return true;
}

particles::ParticleSet GridModel::particles_and(const particles::ParticleSet &more) const {
  particles::ParticleSet all = particles_;
  for (size_t row = 0; row < more.count(); row++) all.add(more.center(row), more.radii[row]);
  return all;
}

void GridModel::insert(const particles::ParticleSet &particles) {
  for (size_t row = 0; row < particles.count(); row++) {
    particles_.add(particles.center(row), particles.radii[row]);
    ids_.push_back(next_id_++);
  }
  company_.members.resize(ids_.size());
}

void GridModel::set(const particles::ParticleSet &particles) {
  company_.set_count(particles.count());
  const hgtest::Company kept = company_;
  clear();
  insert(particles);
  company_ = kept;
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
  std::vector<bool> kept;
  for (size_t row = 0; row < ids_.size(); row++) {
    kept.push_back(!std::binary_search(gone.begin(), gone.end(), ids_[row]));
    if (!kept[row]) continue;
    left.add(particles_.center(row), particles_.radii[row]);
    left_ids.push_back(ids_[row]);
  }
  particles_ = left;
  ids_ = left_ids;
  company_.keep(kept);
  return true;
}

void GridModel::clear() {
  particles_.centers.clear();
  particles_.radii.clear();
  ids_.clear();
  next_id_ = def_.index_base;
  company_.members.clear();
}

size_t GridModel::row_of(int32_t id) const {
  return static_cast<size_t>(std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin());
}

// HG_DOUBLE is bound to its expression where squares are normal numbers and no image is in doubt.
GridModel::Promise GridModel::promise(const particles::ParticleSet &particles) const {
  if (def_.accuracy == HG_EXACT) return Promise::kExact;
  if (def_.accuracy == HG_FLOAT) return Promise::kFloat;
  if (is_periodic(def_)) return Promise::kSane;
  for (const double r : particles.radii) {
    const double reach = r + def_.margin;
    const bool points_may_meet = def_.touching != 0 && (reach == 0 || reach > 1e140);
    if (points_may_meet || (reach != 0 && reach < 1e-140)) return Promise::kSane;
  }
  return Promise::kDouble;
}

// Images in reach, and those that the search for them looks at, grow with the volume of the reach.
bool GridModel::can_check(const particles::ParticleSet &particles) const {
  if (particles.count() == 0 || !is_periodic(def_)) return true;
  if (def_.images == HG_NEAREST_IMAGE && def_.tilt[0] == 0 && def_.tilt[1] == 0 && def_.tilt[2] == 0) return true;
  const double reach = 2 * *std::max_element(particles.radii.begin(), particles.radii.end()) + def_.margin;
  double images = 1;
  for (int k = 0; k < def_.dimension; k++) {
    if (def_.periodic[k] != 0) images *= 1 + 2 * reach / length_of(def_, k);
  }
  return images * static_cast<double>(particles.count() * particles.count()) < 1e5;
}

Pairs GridModel::expected_pairs(oracle::Rule *rule) const {
  Pairs expected = oracle::all_pairs(def_, particles_, ids_, rule);
  const auto is_none = [&](const hg_pair &pair) { return !company_.may_pair(row_of(pair.a), row_of(pair.b)); };
  expected.erase(std::remove_if(expected.begin(), expected.end(), is_none), expected.end());
  return expected;
}

void GridModel::check_pairs(Pairs pairs) const {
  std::sort(pairs.begin(), pairs.end(), oracle::pair_less);
  const bool all_images = def_.images == HG_ALL_IMAGES;
  expect(all_images || std::adjacent_find(pairs.begin(), pairs.end(), oracle::pair_equal) == pairs.end(),
         "a pair comes twice");
  for (const hg_pair &pair : pairs) {
    expect(pair.a < pair.b || (all_images && pair.a == pair.b), "a pair is not a < b");
    expect(std::binary_search(ids_.begin(), ids_.end(), pair.a), "a pair has an unknown a");
    expect(std::binary_search(ids_.begin(), ids_.end(), pair.b), "a pair has an unknown b");
    expect(company_.may_pair(row_of(pair.a), row_of(pair.b)), "a pair of groups or of a body that has none");
  }
  const Promise held = promise(particles_);
  if (held == Promise::kSane || !can_check(particles_)) return;
  const Pairs expected = expected_pairs(held == Promise::kDouble ? oracle::double_interact : oracle::exact_interact);
  const oracle::Difference wrong = oracle::difference(expected, pairs);
  expect(wrong.missing.empty(), "a pair is missing");
  for (const hg_pair &pair : wrong.extra) {
    expect(held == Promise::kFloat, "a pair is wrong");
    const size_t a = row_of(pair.a), b = row_of(pair.b);
    const Sphere first = {particles_.center(a), particles_.radii[a]},
                 other = {particles_.center(b), particles_.radii[b]};
    const double gap = oracle::relative_gap(def_, first, other, oracle::nearer_images(pairs, pair));
    expect(gap <= kFloatExtra, "an extra pair of HG_FLOAT is too far apart");
  }
}

void GridModel::check_row(const std::vector<int32_t> &ids) const {
  expect(std::is_sorted(ids.begin(), ids.end()), "ids of a row do not ascend");
  expect(std::adjacent_find(ids.begin(), ids.end()) == ids.end(), "an id of a row comes twice");
  expect(std::includes(ids_.begin(), ids_.end(), ids.begin(), ids.end()), "a row has an unknown particle");
  for (const int32_t id : ids) expect(!company_.is_absent(row_of(id)), "a row has an absent particle");
}

void GridModel::check_box(const double *low, const double *high, const std::vector<int32_t> &ids) const {
  check_row(ids);
  for (size_t row = 0; row < ids_.size(); row++) {
    if (company_.is_absent(row)) continue;
    const bool found = std::binary_search(ids.begin(), ids.end(), ids_[row]);
    const bool wanted = oracle::box_meets(def_, low, high, {particles_.center(row), particles_.radii[row]});
    expect(found == wanted, found ? "a box meets a particle too many" : "a box misses a particle");
  }
}

// Where distances are normal numbers and few images are in reach.
void GridModel::check_triangle(const double *corners, const std::vector<int32_t> &ids) const {
  check_row(ids);
  for (size_t row = 0; row < ids_.size(); row++) {
    if (company_.is_absent(row)) continue;
    const Sphere particle = {particles_.center(row), particles_.radii[row]};
    const double reach = particle.radius + def_.margin;
    double largest = 0, images = 1;
    for (int k = 0; k < 9; k++) largest = std::fmax(largest, std::fabs(corners[k]));
    for (int k = 0; k < 3; k++) largest = std::fmax(largest, std::fabs(particle.center[k]));
    const double tolerance = 0x1p-40 * (reach + largest);
    for (int k = 0; k < 3; k++) {
      const auto [low, high] = std::minmax({corners[k], corners[3 + k], corners[6 + k]});
      if (def_.periodic[k] != 0) images *= 2 + (high - low + 2 * (reach + tolerance)) / length_of(def_, k);
    }
    if (!(images < 100 && largest < 1e150 && reach < 1e150 && reach + largest > 1e-290)) continue;
    const oracle::Meeting truth = oracle::triangle_meeting(def_, corners, particle, tolerance);
    const bool found = std::binary_search(ids.begin(), ids.end(), ids_[row]);
    expect(found || truth < oracle::Meeting::kTouching || (truth == oracle::Meeting::kTouching && def_.touching == 0),
           "a triangle misses a particle");
    expect(!found || truth != oracle::Meeting::kNone, "a triangle meets a particle too many");
  }
}

void GridModel::check_sphere(const Sphere &sphere, const int32_t *ids, size_t count) const {
  check_row({ids, ids + count});
  particles::ParticleSet with_sphere = particles_;
  with_sphere.add(sphere.center, sphere.radius);
  const Promise held = promise(with_sphere);
  if (held == Promise::kSane || held == Promise::kFloat || !can_check(with_sphere)) return;
  for (size_t row = 0; row < ids_.size(); row++) {
    if (company_.is_absent(row)) continue;
    const Sphere particle = {particles_.center(row), particles_.radii[row]};
    const bool found = std::binary_search(ids, ids + count, ids_[row]);
    const bool wanted = oracle::meets(def_, sphere, particle,
                                      held == Promise::kDouble ? oracle::double_interact : oracle::exact_interact);
    expect(found == wanted, found ? "a sphere meets a particle too many" : "a sphere misses a particle");
  }
}

}  // namespace fuzz
