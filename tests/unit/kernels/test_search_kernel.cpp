// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The search kernels against brute force on integers, where floats are weakest: at the far end of the space, in the
// smallest cells. Every instruction set that this machine runs must give the pairs of the scalar one, in its order.
#include "src/space/level_cells.hpp"
#include "tests/unit/kernels/kernel_sets.hpp"
#include "tests/unit/kernels/plain_test.hpp"
#include "tests/unit/kernels/recorder.hpp"
#include "tests/unit/plain_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace {

using namespace hgtest;
using hg::CellTable;
using hg::KernelSet;
using hg::kPadding;
using hg::PointArrays;

struct Points {
  std::array<std::vector<int32_t>, 3> x;
  std::vector<float> radius;
  std::vector<uint32_t> slot;
  std::vector<hg::Image> image;  // none: no point is an image
  uint32_t count = 0;

  void add(const int32_t *at, float r, uint32_t s) {
    for (int axis = 0; axis < 3; axis++) x[axis].push_back(at[axis]);
    radius.push_back(r);
    slot.push_back(s);
    count++;
  }
  hg::Point point(size_t i) const { return {x[0][i], x[1][i], x[2][i], radius[i]}; }
  PointArrays arrays() const {
    return {x[0].data(), x[1].data(), x[2].data(), radius.data(), slot.data(), image.empty() ? nullptr : image.data()};
  }
  void pad() {
    for (auto &column : x) column.resize(count + kPadding);
    slot.resize(count + kPadding);
    radius.resize(count + kPadding);
  }
};

constexpr uint32_t kFirstPoint = 1000;  // slot of the first point that is not a particle of the level

class Scene {
 public:
  explicit Scene(uint64_t seed)
      : rng_(seed), dimension_(rng_.integer(2, 3)), interaction_(rng_.chance(0.5) ? HG_CONTACT : HG_MAX_RANGE) {
    lay();
    make_cluster();
    fill_table();
  }

  void check_own_level() {
    const auto run = [&](const KernelSet &set, hg::PairStream *stream) {
      return kernel(set).own_level(particles_.arrays(), 0, particles_.count, table_, stream);
    };
    search(run);
    for (size_t i = 0; i < particles_.count; i++) {
      for (size_t j = i + 1; j < particles_.count; j++) check_pair(particles_, i, j);
    }
    require_nothing_else();
    check_decisions(run);
  }

  // Points of coarser levels and periodic images, which may lie outside the particles' bounds.
  void check_cross_level() {
    Points points;
    make_points(points);
    const auto run = [&](const KernelSet &set, hg::PairStream *stream) {
      return kernel(set).cross_level(points.arrays(), 0, points.count, table_, particles_.arrays(), stream);
    };
    const Sent sent = search(run);
    for (size_t k = 0; k < sent.asked.size(); k++) {
      const auto point = static_cast<size_t>(sent.asked[k].a) - kFirstPoint;
      require(point < points.count && sent.images[k] == points.image[point], "another image is asked about");
    }
    for (size_t i = 0; i < points.count; i++) {
      for (size_t j = 0; j < particles_.count; j++) check_pair(points, i, j);
    }
    require_nothing_else();
    check_decisions(run);
  }

  void check_stopping() {
    RecorderRules rules;
    rules.rooms = 0;
    Recorder recorder(rules);
    const bool done =
        kernel(hg::kScalarKernels).own_level(particles_.arrays(), 0, particles_.count, table_, recorder.stream());
    const Sent sent = recorder.finish();
    require(done || !sent.pairs.empty(), "stopped without cause");
    require(sent.pairs.size() <= hg::kMaxPiece + kPadding, "went on after being stopped");
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
    points.pad();
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
    cell_begin_.assign(cells + 1 + kPadding, static_cast<uint32_t>(n));
    size_t next = 0;
    for (size_t i = 0; i < n; i++) {
      for (; next <= order[i].first; next++) cell_begin_[next] = static_cast<uint32_t>(i);
    }
    table_.cell_begin = cell_begin_.data();
    particles_.pad();
  }

  // The same from all sets: the pairs, their order and what is left undecided.
  template <class Run>
  Sent run_all(const RecorderRules &rules, Run &&run) {
    Sent first;
    for (const KernelSet *set : kernel_sets()) {
      Recorder recorder(rules);
      require(run(*set, recorder.stream()), "%s: stopped", set->name);
      const Sent sent = recorder.finish();
      if (set == &hg::kScalarKernels) first = sent;
      require(sent == first, "%s: %zu pairs instead of the scalar kernel's %zu, or another order", set->name,
              sent.pairs.size(), first.pairs.size());
    }
    return first;
  }

  template <class Run>
  Sent search(Run &&run) {
    Sent sent = run_all({}, run);
    found_ = sorted(sent.pairs.data(), sent.pairs.size());
    asked_.clear();
    for (const hg_pair &pair : sent.asked) asked_.push_back(ordered(pair.a, pair.b));
    std::sort(asked_.begin(), asked_.end(), pair_less);
    require(std::adjacent_find(found_.begin(), found_.end(), pair_equal) == found_.end(), "a pair came twice");
    expected_ = 0;
    return sent;
  }

  // With everything undecided, what a judge takes out is gone, and the other pairs stay in their order.
  template <class Run>
  void check_decisions(Run &&run) {
    RecorderRules rules;
    rules.band_constant = std::numeric_limits<float>::infinity();
    const Sent all = run_all(rules, run);
    require(all.asked.size() == all.pairs.size() && static_cast<int64_t>(all.pairs.size()) == all.candidates,
            "%zu of %lld candidates are undecided", all.asked.size(), static_cast<long long>(all.candidates));
    rules.id_offset = 1;
    rules.interact = [](const hg::UndecidedPair &pair) { return (pair.a * 7 + pair.b) % 3 != 0; };
    Pairs kept;
    for (size_t k = 0; k < all.pairs.size(); k++) {
      const auto a = static_cast<uint32_t>(all.asked[k].a), b = static_cast<uint32_t>(all.asked[k].b);
      if ((a * 7 + b) % 3 != 0) kept.push_back({all.pairs[k].a + 1, all.pairs[k].b + 1});
    }
    require_pairs("decided", run_all(rules, run).pairs, kept);
  }

  static hg_pair ordered(int32_t a, int32_t b) { return a < b ? hg_pair{a, b} : hg_pair{b, a}; }

  // Pair (i of points, j of the particles): is what the kernels say about it true?
  void check_pair(const Points &points, size_t i, size_t j) {
    const hg_pair pair = ordered(static_cast<int32_t>(points.slot[i]), static_cast<int32_t>(particles_.slot[j]));
    const bool found = std::binary_search(found_.begin(), found_.end(), pair, pair_less);
    const bool asked = std::binary_search(asked_.begin(), asked_.end(), pair, pair_less);
    const hg::Point a = points.point(i), b = particles_.point(j);
    const Verdict verdict = plain_test(a, b, interaction_, hg::kBandConstant);
    expected_ += found ? 1 : 0;
    require(!found || verdict.possible, "found against the fast test");
    require(!found || asked == !verdict.sure, "asked about a sure pair, or not about another");
    require_truthful(a, b, interaction_, {found, found && !asked});
  }
  void require_nothing_else() {
    require(expected_ == found_.size(), "%zu pairs, of which %zu exist", found_.size(), expected_);
  }

  Rng rng_;
  int dimension_;
  int32_t interaction_;
  hg::FixedPoint map_;
  double reach_ = 0;
  CellTable table_{};
  std::vector<uint32_t> cell_begin_;
  Points particles_;
  Pairs found_, asked_;
  size_t expected_ = 0;
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
