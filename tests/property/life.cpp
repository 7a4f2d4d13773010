// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/property/life.hpp"

#include "tests/property/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace hgtest {
namespace {

constexpr size_t kMostPairwise = 2000;  // beyond, pairs are swept for along x where that axis is open

// A part of the skin, so that stored candidates last for some steps, or of a particle.
double longest_step(const Scene &scene) {
  const double mean = mean_radius(scene.particles);
  return 0.1 * (scene.def.skin > 0 ? std::min(scene.def.skin, mean) : mean);
}

// What a deformation does with the box.
enum class Change { kBreathe, kStretch, kShear, kRamp, kFlip, kShift, kOther };
constexpr int kChangeCount = static_cast<int>(Change::kOther) + 1;

}  // namespace

bool has_far_particles(const hg_grid_def &def, const Particles &particles) {
  for (size_t i = 0; i < particles.count(); i++) {
    const double *x = particles.center(i);
    double cells[3] = {0, 0, 0};
    for (int k = def.dimension - 1; k >= 0; k--) {
      if (def.periodic[k] == 0) continue;
      const double tilted = k == 0   ? std::fabs(cells[1] * def.tilt[0]) + std::fabs(cells[2] * def.tilt[1])
                            : k == 1 ? std::fabs(cells[2] * def.tilt[2])
                                     : 0;
      cells[k] = (std::fabs(x[k] - def.box_min[k]) + tilted) / (def.box_max[k] - def.box_min[k]) + 1;
      if (cells[k] > 0x1p18) return true;
    }
  }
  return false;
}

double mean_radius(const Particles &particles) {
  const double sum = std::accumulate(particles.radii.begin(), particles.radii.end(), 0.0);
  return particles.count() == 0 ? 0 : sum / static_cast<double>(particles.count());
}

Life::Life(uint64_t seed, Scene scene, double box_changes, double company_changes)
    : rng_(seed),
      scene_(std::move(scene)),
      box_changes_(box_changes),
      company_changes_(company_changes),
      step_(longest_step(scene_)),
      live_(scene_.particles),
      ids_(live_.count()),
      next_id_(scene_.def.index_base + static_cast<int32_t>(live_.count())),
      company_(live_.count()),
      rule_(scene_.def.accuracy == HG_DOUBLE ? double_interact : exact_interact),
      grid_(make_grid(scene_.def, live_)) {
  std::iota(ids_.begin(), ids_.end(), scene_.def.index_base);
}

void Life::run(int steps) {
  const double calm = rng_.uniform();  // candidates of a skin last while particles only move
  compare();
  for (int step = 0; step < steps; step++) {
    if (rng_.chance(box_changes_)) change_box();
    if (rng_.chance(company_changes_)) change_company(rng_, company_, grid_);
    switch (rng_.chance(calm) ? 10 : rng_.below(11)) {
      case 0:
      case 1:
        insert();
        break;
      case 2:
        remove();
        break;
      case 3:
        if (rng_.chance(0.2)) clear();
        break;
      case 4:
        grid_.build();
        break;
      case 5:
        set();
        break;
      default:
        move();
    }
    if (rng_.chance(0.7)) compare();
  }
  compare();
}

template <class Call>
bool Life::take(const char *what, const hg_grid_def &def, const Particles &particles, Call call) {
  if (has_far_particles(def, particles)) return false;
  const bool fits = def.images == HG_ALL_IMAGES || !can_meet_twice(def, particles);
  const hg_status status = status_of(call);
  require(status == (fits ? HG_OK : HG_ERR_ARGUMENT),
          scene_.name + ": " + what + " gives " + std::to_string(status) + ", " + hg_last_error());
  return fits;
}

void Life::insert() {
  const Particles &pool = scene_.particles;
  Particles grown = live_, batch;
  batch.dimension = pool.dimension;
  const int most = live_.count() < pool.count() ? 40 : 8;
  for (int k = pool.count() == 0 ? 0 : rng_.integer(0, most); k > 0; k--) {
    batch.add(pool.center(any_of_pool()), pool.radii[any_of_pool()]);
    grown.add(batch.center(batch.count() - 1), batch.radii.back());
  }
  const auto call = [&] { grid_.insert(batch.count(), batch.centers.data(), batch.radii.data()); };
  if (!take("insert", scene_.def, grown, call)) return;
  live_ = grown;
  while (ids_.size() < live_.count()) ids_.push_back(next_id_++);
  company_.members.resize(live_.count());
}

// As many as before, or others.
void Life::set() {
  const Particles &pool = scene_.particles;
  Particles next = live_;
  if (rng_.chance(0.7)) {
    next.centers.clear();
    next.radii.clear();
    const size_t count = rng_.chance(0.5) ? live_.count() : rng_.below(pool.count() + 1);
    for (size_t i = 0; i < count && pool.count() > 0; i++) {
      next.add(pool.center(any_of_pool()), pool.radii[any_of_pool()]);
    }
  }
  const auto call = [&] { grid_.set(next.count(), next.centers.data(), next.radii.data()); };
  if (!take("set", scene_.def, next, call)) return;
  company_.set_count(next.count());
  live_ = next;
  ids_.resize(live_.count());
  std::iota(ids_.begin(), ids_.end(), scene_.def.index_base);
  next_id_ = scene_.def.index_base + static_cast<int32_t>(live_.count());
}

// Small steps, jumps, whole cells, or new radii as well.
void Life::move() {
  const Particles &pool = scene_.particles;
  const bool jump = rng_.chance(0.15), far = rng_.chance(0.1), shrink = rng_.chance(0.1), radii = rng_.chance(0.1);
  const auto dimension = static_cast<size_t>(live_.dimension);
  Particles moved = live_;
  for (size_t i = 0; i < moved.count(); i++) {
    double *x = &moved.centers[i * dimension];
    if (jump) std::copy_n(pool.center(any_of_pool()), dimension, x);
    for (size_t k = 0; k < dimension; k++) x[k] += rng_.uniform(-step_, step_);
    if (far && rng_.chance(0.2)) {
      const double n[3] = {1.0 * rng_.integer(-2, 2), 1.0 * rng_.integer(-2, 2), 1.0 * rng_.integer(-2, 2)};
      move_by_cells(scene_.def, n, x);
    }
    if (shrink) moved.radii[i] *= rng_.uniform(0.9, 1);
    if (radii) moved.radii[i] = pool.radii[any_of_pool()];
  }
  const double *new_radii = shrink || radii ? moved.radii.data() : nullptr;
  const auto call = [&] { grid_.move(moved.count(), moved.centers.data(), new_radii); };
  if (take("move", scene_.def, moved, call)) live_ = moved;
}

void Life::remove() {
  std::vector<int32_t> gone, left_ids;
  const double share = rng_.chance(0.1) ? 1 : rng_.uniform(0, 0.5);
  Particles left;
  left.dimension = live_.dimension;
  std::vector<bool> kept;
  for (size_t i = 0; i < live_.count(); i++) {
    kept.push_back(!rng_.chance(share));
    if (!kept[i]) {
      gone.insert(gone.begin() + static_cast<ptrdiff_t>(rng_.below(gone.size() + 1)), ids_[i]);
    } else {
      left.add(live_.center(i), live_.radii[i]);
      left_ids.push_back(ids_[i]);
    }
  }
  grid_.remove(gone.size(), gone.data());
  live_ = left;
  ids_ = left_ids;
  company_.keep(kept);
}

void Life::clear() {
  grid_.clear();
  live_.centers.clear();
  live_.radii.clear();
  ids_.clear();
  next_id_ = scene_.def.index_base;
  company_.members.clear();
}

hg_grid_def Life::changed_box() {
  hg_grid_def def = scene_.def;
  const auto change = static_cast<Change>(rng_.below(kChangeCount));
  // Mostly so small that places at the far face move by a part of the skin: by up to ten steps.
  const double longest = std::max({length(0), length(1), length(2)});
  const double share = rng_.chance(0.8) ? rng_.uniform(0, 10) * step_ / longest : 0.1;
  for (int k = 0; k < def.dimension; k++) {
    if (def.periodic[k] == 0) continue;
    if (change == Change::kBreathe) def.box_max[k] += share * length(k);
    if (change == Change::kStretch) def.box_max[k] += rng_.uniform(-share, share) * length(k);
    if (change == Change::kShift) {
      const double shift = rng_.uniform(-1, 1) * length(k);
      def.box_min[k] += shift;
      def.box_max[k] += shift;
    }
    const double least = length(k) > largest_reach(def, live_) ? -0.3 : 0;  // images grow with its cube
    if (change == Change::kOther) def.box_max[k] += rng_.uniform(least, 0.5) * length(k);
  }
  constexpr int kAxes[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  for (int k = 0; k < (def.dimension == 2 ? 1 : 3); k++) {
    if (def.periodic[kAxes[k][0]] + def.periodic[kAxes[k][1]] != 2) continue;
    const double along = length(kAxes[k][0]);
    if (change == Change::kShear) def.tilt[k] += rng_.uniform(-share, share) * along;
    if (change == Change::kRamp) def.tilt[k] += share * along;
    if (change == Change::kFlip) def.tilt[k] -= std::nearbyint(def.tilt[k] / along) * along;
    if (change == Change::kOther) def.tilt[k] = rng_.uniform(-1, 1) * along;
  }
  return def;
}

void Life::change_box() {
  const hg_grid_def def = changed_box();
  for (int k = 0; k < def.dimension; k++) {
    if (def.periodic[k] != 0 && !(def.box_min[k] < def.box_max[k])) return;  // shorter than what it was to lose
  }
  if (take("set_box", def, live_, [&] { set_box(grid_, def); })) scene_.def = def;
}

Pairs Life::meeting_pairs() const {
  if (live_.count() <= kMostPairwise || scene_.def.periodic[0] != 0) {
    return all_pairs(scene_.def, live_, ids_, rule_);
  }
  Pairs pairs = swept_pairs(scene_.def, live_, rule_);
  const auto id_of = [&](int32_t row) { return ids_[static_cast<size_t>(row - scene_.def.index_base)]; };
  for (hg_pair &pair : pairs) pair = {id_of(pair.a), id_of(pair.b)};
  return pairs;
}

size_t Life::row_of(int32_t id) const {
  return static_cast<size_t>(std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin());
}

Pairs Life::expected_pairs() const {
  Pairs pairs = meeting_pairs();
  const auto is_none = [&](const hg_pair &pair) { return !company_.may_pair(row_of(pair.a), row_of(pair.b)); };
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), is_none), pairs.end());
  return pairs;
}

void Life::require_answer(const char *what, const Pairs &got, const Pairs &expected) {
  require_same((scene_.name + ", " + what).c_str(), got, expected);
  compared_++;
}

void Life::compare() {
  const Pairs expected = expected_pairs();
  const Pairs found = pairs_of(grid_);
  require_answer("pairs", scene_.def.pair_order == HG_ORDER_ID ? found : sorted(found), expected);
  require(grid_.get_stats().particle_count == static_cast<int64_t>(live_.count()), "wrong number of live particles");
  if (rng_.chance(0.3)) compare_visit(expected);
  if (rng_.chance(0.3)) compare_rows(expected);
  if (rng_.chance(0.3)) compare_spheres();
  if (rng_.chance(0.3)) compare_shapes();
}

void Life::compare_visit(const Pairs &expected) {
  Pairs visited;
  grid_.visit_pairs([&](hgrid::View<hg_pair> batch) { visited.insert(visited.end(), batch.begin(), batch.end()); });
  require_answer("visit", sorted(visited), expected);
}

void Life::compare_rows(const Pairs &expected) {
  const int32_t list = rng_.integer(HG_HALF, HG_FULL);
  Pairs rows = pairs_of_rows(grid_, list), wanted = expected;
  for (hg_pair &row : rows) row.a = ids_[static_cast<size_t>(row.a)];
  for (const hg_pair &pair : expected) {
    if (list == HG_FULL) wanted.push_back({pair.b, pair.a});
  }
  require_answer("rows", rows, sorted(wanted));
}

// Some that lie where a particle does, or beside it.
void Life::compare_spheres() {
  if (live_.count() == 0) return;
  Particles spheres;
  spheres.dimension = live_.dimension;
  std::vector<std::vector<int32_t>> expected(1 + rng_.below(3));
  for (std::vector<int32_t> &row : expected) {
    double center[3] = {0, 0, 0};
    std::copy_n(live_.center(rng_.below(live_.count())), live_.dimension, center);
    double radius = live_.radii[rng_.below(live_.count())];
    if (rng_.chance(0.5)) {
      const double reach = largest_reach(scene_.def, live_);
      for (double &x : center) x += rng_.uniform(-0.5, 0.5) * reach;
      radius = rng_.uniform() * reach;
    }
    spheres.add(center, radius);
    for (const int32_t id : all_in_sphere(scene_.def, live_, {center, radius}, rule_)) {
      const auto live = static_cast<size_t>(id - scene_.def.index_base);
      if (!company_.is_absent(live)) row.push_back(ids_[live]);
    }
  }
  require_same((scene_.name + ", sphere").c_str(), list_of(grid_.query_sphere(spheres.center(0), spheres.radii[0])),
               expected[0]);
  require_rows(scene_.name + ", spheres",
               grid_.query_spheres(spheres.count(), spheres.centers.data(), spheres.radii.data()), expected);
  compared_++;
}

// Rational numbers take their time.
void Life::compare_shapes() {
  constexpr size_t kMostShaped = 300;
  const double *tilt = scene_.def.tilt;
  if (live_.count() == 0 || live_.count() > kMostShaped || tilt[0] != 0 || tilt[1] != 0 || tilt[2] != 0) return;
  Particles present;
  present.dimension = live_.dimension;
  std::vector<int32_t> ids;
  for (size_t row = 0; row < live_.count(); row++) {
    if (company_.is_absent(row)) continue;
    present.add(live_.center(row), live_.radii[row]);
    ids.push_back(ids_[row]);
  }
  if (ids.empty()) return;
  const Population among{scene_.name, scene_.def, present, ids, grid_};
  check_boxes(rng_, among);
  check_triangles(rng_, among);
  compared_++;
}

}  // namespace hgtest
