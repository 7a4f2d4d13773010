// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The search kernels against brute force on integers, where floats are weakest: at the far end of the space, in the
// smallest cells. Every instruction set that this machine runs must give the pairs of the scalar one, in its order.
#include "src/space/level_cells.hpp"
#include "tests/unit/kernels/search_check.hpp"
#include "tests/unit/plain_cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace {

using namespace hgtest;
using hg::CellTable;
using hg::kCellPadding;
using hg::KernelSet;

constexpr uint32_t kFirstPoint = 1000;  // slot of the first point that is not a particle of the level

class Scene {
 public:
  explicit Scene(uint64_t seed)
      : rng_(seed),
        dimension_(rng_.integer(2, 3)),
        interaction_(rng_.chance(0.5) ? HG_CONTACT : HG_MAX_RANGE),
        check_(interaction_) {
    lay();
    make_cluster();
    fill_table();
    if (rng_.chance(0.5)) give_bodies(particles_);
  }

  void check_own_level() {
    const auto run = [&](const KernelSet &set, hg::PairStream *stream) {
      return kernel(set).own_level(particles_.arrays(), 0, particles_.count, table_, stream);
    };
    check_.search(run);
    for (size_t i = 0; i < particles_.count; i++) {
      for (size_t j = i + 1; j < particles_.count; j++) check_.check_pair(particles_, i, particles_, j);
    }
    check_.require_nothing_else();
    check_.check_decisions(run);
  }

  // Points of coarser levels and periodic images, which may lie outside the particles' bounds.
  void check_cross_level() {
    Points points;
    make_points(points);
    const auto run = [&](const KernelSet &set, hg::PairStream *stream) {
      return kernel(set).cross_level(points.arrays(), 0, points.count, table_, particles_.arrays(), stream);
    };
    const Sent sent = check_.search(run);
    SearchCheck::require_images(sent, points, kFirstPoint);
    for (size_t i = 0; i < points.count; i++) {
      for (size_t j = 0; j < particles_.count; j++) check_.check_pair(points, i, particles_, j);
    }
    check_.require_nothing_else();
    check_.check_decisions(run);
  }

  void check_stopping() {
    SearchCheck::check_stopping([&](const KernelSet &set, hg::PairStream *stream) {
      return kernel(set).own_level(particles_.arrays(), 0, particles_.count, table_, stream);
    });
  }

 private:
  const hg::SearchKernel &kernel(const KernelSet &set) const { return set.search[dimension_ - 2][interaction_]; }

  void lay() {
    const bool thin = rng_.chance(0.5);
    for (int axis = 0; axis < dimension_; axis++) map_.extent[axis] = std::pow(2, rng_.uniform(thin ? 0 : 29, 30));
    map_.extent[rng_.integer(0, dimension_ - 1)] = rng_.uniform(0x1p29, 0x1p30);
    reach_ = std::pow(2, rng_.uniform(-3, thin ? 29 : 27));
    const double particles = std::pow(2, rng_.uniform(4, 19));
    table_ = hg::lay_cells(map_, dimension_, reach_, static_cast<size_t>(particles)).table;
  }

  int32_t within(int axis, double x) const {
    const double most = std::min(axis < dimension_ ? map_.extent[axis] : 0, 0x1p30 - 1);
    return static_cast<int32_t>(std::clamp(x, 0.0, most));
  }
  float radius() {
    const double most = interaction_ == HG_CONTACT ? 0.5 * reach_ : reach_;
    return static_cast<float>(rng_.chance(0.5) ? most : most * rng_.uniform());
  }

  // Dense enough that many pairs nearly touch, most often at an end of space.
  void make_cluster() {
    double center[3];
    const double spread = (reach_ + 3000) * rng_.uniform(0.5, 4);
    for (int axis = 0; axis < 3; axis++) {
      const double extent = axis < dimension_ ? map_.extent[axis] : 0;
      center[axis] = rng_.chance(0.5) ? extent : (rng_.chance(0.3) ? 0 : extent * rng_.uniform());
      // Where rows meet, all neighbours of a row are needed.
      if (rng_.chance(0.5))
        center[axis] = std::rint(center[axis] / table_.width[axis]) * static_cast<double>(table_.width[axis]);
    }
    const int n = rng_.integer(1, 150);
    for (int i = 0; i < n; i++) {
      int32_t at[3];
      for (int axis = 0; axis < 3; axis++) at[axis] = within(axis, center[axis] + spread * rng_.uniform(-1, 1));
      if (i > 0 && rng_.chance(0.6)) put_near(particles_, rng_.below(particles_.count), at);
      particles_.add(at, radius(), static_cast<uint32_t>(i));
    }
  }

  // A place about one reach from particle i, in any direction; along an axis now and then.
  void put_near(const Points &points, size_t i, int32_t *at) {
    double u[3] = {0, 0, 0}, norm = 0;
    const int only = rng_.chance(0.4) ? rng_.integer(0, dimension_ - 1) : -1;
    for (int axis = 0; axis < dimension_; axis++) {
      u[axis] = only < 0 ? rng_.uniform(-1, 1) : (axis == only ? (rng_.chance(0.5) ? 1 : -1) : 0);
      norm += u[axis] * u[axis];
    }
    if (norm == 0) return;
    const double d = reach_ * (1 + rng_.uniform(-1, 1) * 1e-7) + rng_.uniform(-10, 10);
    for (int axis = 0; axis < 3; axis++) at[axis] = within(axis, points.x[axis][i] + d * u[axis] / std::sqrt(norm));
  }

  void make_points(Points &points) {
    const double size = std::pow(2, rng_.uniform(0, 12));
    for (int i = 0; i < 40; i++) {
      const float r = radius() * static_cast<float>(size);
      const size_t partner = rng_.below(particles_.count);
      const double near = static_cast<double>(interaction_ == HG_CONTACT ? r + particles_.radius[partner] : r);
      int32_t at[3] = {0, 0, 0};
      const int towards = rng_.integer(0, dimension_ - 1);
      const double side = rng_.chance(0.5) ? 1 : -1;
      for (int axis = 0; axis < dimension_; axis++) {
        const double shift = axis == towards ? side * near + rng_.uniform(-5, 5) : 0.01 * near * rng_.uniform(-1, 1);
        at[axis] = static_cast<int32_t>(std::clamp(particles_.x[axis][partner] + shift, -0x1p30, 0x1p31 - 1));
      }
      points.add(at, std::min(r, 0x1p30f), kFirstPoint + static_cast<uint32_t>(i));
      points.image.push_back(static_cast<hg::Image>(rng_.below(hg::kImages)));
    }
    if (!particles_.body.empty()) give_bodies(points);
    points.pad();
  }

  void give_bodies(Points &points) {
    for (uint32_t i = 0; i < points.count; i++) points.body.push_back(rng_.integer(-1, 3));
    points.body.resize(points.count + hg::kPadding);
  }

  void fill_table() {
    const size_t n = particles_.count;
    std::vector<std::pair<size_t, size_t>> order(n);
    for (size_t i = 0; i < n; i++) {
      size_t cell = 0;
      for (int axis = 2; axis >= 0; axis--) {
        cell = cell * static_cast<size_t>(table_.count[axis]) + plain_cell(table_, axis, particles_.x[axis][i]);
      }
      order[i] = {cell, i};
    }
    std::sort(order.begin(), order.end());
    Points sorted;
    for (const auto &[cell, i] : order) {
      const int32_t at[3] = {particles_.x[0][i], particles_.x[1][i], particles_.x[2][i]};
      sorted.add(at, particles_.radius[i], static_cast<uint32_t>(sorted.count));
      table_.largest_radius = std::max(table_.largest_radius, particles_.radius[i]);
    }
    particles_ = sorted;
    size_t cells = 1;
    for (int32_t c : table_.count) cells *= static_cast<size_t>(c);
    cell_begin_.assign(cells + 1 + kCellPadding, static_cast<uint32_t>(n));
    size_t next = 0;
    for (size_t i = 0; i < n; i++) {
      for (; next <= order[i].first; next++) cell_begin_[next] = static_cast<uint32_t>(i);
    }
    table_.cell_begin = cell_begin_.data();
    particles_.pad();
  }

  Rng rng_;
  int dimension_;
  int32_t interaction_;
  hg::FixedPoint map_;
  double reach_ = 0;
  CellTable table_{};
  std::vector<uint32_t> cell_begin_;
  SearchCheck check_;
  Points particles_;
};

void own_level(void **) {
  assert_true(sweep(600, [](uint64_t seed) { Scene(seed).check_own_level(); }));
}
void cross_level(void **) {
  assert_true(sweep(600, [](uint64_t seed) { Scene(seed).check_cross_level(); }));
}
void stopping(void **) {
  assert_true(sweep(50, [](uint64_t seed) { Scene(seed).check_stopping(); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(own_level), cmocka_unit_test(cross_level), cmocka_unit_test(stopping)};
  return cmocka_run_group_tests_name("search_kernel", tests, nullptr, nullptr);
}
