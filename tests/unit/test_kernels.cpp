// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The search kernels against brute force on integers, where floats are weakest: at the far end of the frame, in the
// smallest cells. Every instruction set that this machine runs must give the pairs of the scalar one, in its order.
#include "src/kernels/kernel_set.hpp"
#include "src/space/level_cells.hpp"
#include "tests/unit/checks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace {

using namespace hgtest;
using hg::CellTable;
using hg::KernelSet;
using hg::kPadding;
using hg::PairSink;
using hg::PointArrays;

// Two positions that were floored, wrapped and shifted across the box are at most this many quanta farther from or
// nearer to each other than they should be, in any rounding mode (docs/theory/exactness.md).
constexpr double kQuantisation = 6.08;

using Pair = std::pair<uint32_t, uint32_t>;

struct Points {
  std::vector<int32_t> x[3];
  std::vector<float> radius;
  std::vector<uint32_t> slot;
  size_t count = 0;

  void add(const int32_t *at, float r, uint32_t s) {
    for (int k = 0; k < 3; k++) x[k].push_back(at[k]);
    radius.push_back(r);
    slot.push_back(s);
    count++;
  }
  PointArrays arrays() const { return {x[0].data(), x[1].data(), x[2].data(), radius.data(), slot.data(), nullptr}; }
  void pad() {
    for (auto &axis : x) axis.resize(count + kPadding);
    slot.resize(count + kPadding);
    radius.resize(count + kPadding);
  }
};

// What a kernel reports, and which pairs it asked about.
struct Found {
  std::vector<Pair> pairs, asked;
  int64_t undecided = 0;
  bool operator==(const Found &other) const {
    return pairs == other.pairs && asked == other.asked && undecided == other.undecided;
  }
};

struct Sink : PairSink {
  Found found;
  std::vector<hg_pair> room = std::vector<hg_pair>(hg::kMaxPiece + kPadding);
  std::vector<double> numbers = std::vector<double>(3 << 16);  // fetched ahead by slot, never used
  bool open_where_written = true;
  size_t stop_at = SIZE_MAX;

  Sink() : PairSink{} {
    next = room.data();
    limit = room.data() + room.size();
    band_constant = hg::kBandConstant;
    make_room = [](PairSink *sink, size_t count) {
      auto *self = static_cast<Sink *>(sink);
      self->settle(sink);
      self->take();
      return self->found.pairs.size() < self->stop_at && count <= self->room.size();
    };
    settle = [](PairSink *sink) {
      auto *self = static_cast<Sink *>(sink);
      for (uint32_t k = 0; k < sink->open_count; k++) {
        const hg::OpenPair &pair = sink->open[k];
        const Pair asked(std::min(pair.slot_a, pair.slot_b), std::max(pair.slot_a, pair.slot_b));
        const Pair written(static_cast<uint32_t>(pair.at->a), static_cast<uint32_t>(pair.at->b));
        self->open_where_written = self->open_where_written && pair.at < sink->next && asked == written;
        self->found.asked.push_back(asked);
      }
      sink->undecided_count += sink->open_count;
      sink->open_count = 0;
    };
    centers = radii = numbers.data();
  }
  void take() {
    for (const hg_pair *p = room.data(); p != next; p++) {
      found.pairs.emplace_back(static_cast<uint32_t>(p->a), static_cast<uint32_t>(p->b));
    }
    next = room.data();
    found.undecided = undecided_count;
  }
};

std::vector<const KernelSet *> kernel_sets() {
  std::vector<const KernelSet *> sets = {&hg::kScalarKernels};
#if defined(__x86_64__)
  sets.push_back(&hg::kSse2Kernels);
  if (__builtin_cpu_supports("avx2") != 0) sets.push_back(&hg::kAvx2Kernels);
  if (__builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
      __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0) {
    sets.push_back(&hg::kAvx512Kernels);
  }
#elif defined(__aarch64__)
  sets.push_back(&hg::kNeonKernels);
#endif
  return sets;
}

class Scene {
 public:
  explicit Scene(uint64_t seed) : rng_(seed), dimension_(rng_.integer(2, 3)), max_range_(rng_.chance(0.5)) {
    lay();
    make_cluster();
    fill_table();
  }

  void check_own_level() {
    compare_sets([&](const KernelSet &set, Sink &sink) {
      return kernel(set).own_level(particles_.arrays(), 0, count(particles_), table_, &sink);
    });
    for (size_t i = 0; i < particles_.count; i++) {
      for (size_t j = i + 1; j < particles_.count; j++) judge(particles_, i, j);
    }
    require_nothing_else();
  }

  // Points of coarser levels and periodic images, which may lie outside the frame.
  void check_cross_level() {
    Points points;
    make_points(points);
    compare_sets([&](const KernelSet &set, Sink &sink) {
      return kernel(set).cross_level(points.arrays(), 0, count(points), table_, particles_.arrays(), &sink);
    });
    for (size_t i = 0; i < points.count; i++) {
      for (size_t j = 0; j < particles_.count; j++) judge(points, i, j);
    }
    require_nothing_else();
  }

  void check_stopping() {
    Sink sink;
    sink.stop_at = 0;
    const bool done = kernel(hg::kScalarKernels).own_level(particles_.arrays(), 0, count(particles_), table_, &sink);
    sink.settle(&sink);
    sink.take();
    require(done || !sink.found.pairs.empty(), "stopped without cause");
    require(sink.found.pairs.size() <= hg::kMaxPiece + kPadding, "went on after being stopped");
  }

 private:
  static uint32_t count(const Points &points) { return static_cast<uint32_t>(points.count); }
  const hg::SearchKernel &kernel(const KernelSet &set) const { return set.search[dimension_ - 2][max_range_ ? 1 : 0]; }

  void lay() {
    const bool thin = rng_.chance(0.5);
    for (int k = 0; k < dimension_; k++) frame_.extent[k] = std::pow(2, rng_.uniform(thin ? 0 : 29, 30));
    frame_.extent[rng_.integer(0, dimension_ - 1)] = rng_.uniform(0x1p29, 0x1p30);
    reach_ = std::pow(2, rng_.uniform(-3, thin ? 29 : 27));
    const double particles = std::pow(2, rng_.uniform(4, 19));
    table_ = hg::lay_cells(frame_, dimension_, reach_, static_cast<size_t>(particles)).table;
  }

  int32_t within(int axis, double x) const {
    const double most = std::min(axis < dimension_ ? frame_.extent[axis] : 0, 0x1p30 - 1);
    return static_cast<int32_t>(std::clamp(x, 0.0, most));
  }
  float radius() {
    const double most = max_range_ ? reach_ : 0.5 * reach_;
    return static_cast<float>(rng_.chance(0.5) ? most : most * rng_.uniform());
  }

  // Dense enough that many pairs nearly touch, most often at an end of the frame.
  void make_cluster() {
    double center[3];
    const double spread = (reach_ + 3000) * rng_.uniform(0.5, 4);
    for (int k = 0; k < 3; k++) {
      const double extent = k < dimension_ ? frame_.extent[k] : 0;
      center[k] = rng_.chance(0.5) ? extent : (rng_.chance(0.3) ? 0 : extent * rng_.uniform());
      // Where rows meet, all neighbours of a row are needed.
      if (rng_.chance(0.5)) center[k] = std::rint(center[k] / table_.width[k]) * static_cast<double>(table_.width[k]);
    }
    const int n = rng_.integer(1, 150);
    for (int i = 0; i < n; i++) {
      int32_t at[3];
      for (int k = 0; k < 3; k++) at[k] = within(k, center[k] + spread * rng_.uniform(-1, 1));
      if (i > 0 && rng_.chance(0.6)) put_near(particles_, rng_.below(particles_.count), at);
      particles_.add(at, radius(), static_cast<uint32_t>(i));
    }
  }

  // A place about one reach from particle i, in any direction; along an axis now and then.
  void put_near(const Points &points, size_t i, int32_t *at) {
    double u[3] = {0, 0, 0}, norm = 0;
    const int only = rng_.chance(0.4) ? rng_.integer(0, dimension_ - 1) : -1;
    for (int k = 0; k < dimension_; k++) {
      u[k] = only < 0 ? rng_.uniform(-1, 1) : (k == only ? (rng_.chance(0.5) ? 1 : -1) : 0);
      norm += u[k] * u[k];
    }
    if (norm == 0) return;
    const double d = reach_ * (1 + rng_.uniform(-1, 1) * 1e-7) + rng_.uniform(-10, 10);
    for (int k = 0; k < 3; k++) at[k] = within(k, points.x[k][i] + d * u[k] / std::sqrt(norm));
  }

  void make_points(Points &points) {
    const double size = std::pow(2, rng_.uniform(0, 12));
    for (int i = 0; i < 40; i++) {
      const float r = radius() * static_cast<float>(size);
      const size_t partner = rng_.below(particles_.count);
      const double near = static_cast<double>(max_range_ ? r : r + particles_.radius[partner]);
      int32_t at[3] = {0, 0, 0};
      const int axis = rng_.integer(0, dimension_ - 1);
      const double side = rng_.chance(0.5) ? 1 : -1;
      for (int k = 0; k < dimension_; k++) {
        const double shift = k == axis ? side * near + rng_.uniform(-5, 5) : 0.01 * near * rng_.uniform(-1, 1);
        at[k] = static_cast<int32_t>(std::clamp(particles_.x[k][partner] + shift, -0x1p30, 0x1p31 - 1));
      }
      points.add(at, std::min(r, 0x1p30f), 1000 + static_cast<uint32_t>(i));
    }
    points.pad();
  }

  // The map from coordinates to cells, as kernel.hpp states it: floats, clamped to the table.
  int32_t cell_of(int axis, int32_t x) const {
    const float last = static_cast<float>(table_.count[axis]) - 0.5f;
    return static_cast<int32_t>(std::min(std::max(static_cast<float>(x) * table_.inverse_width[axis], 0.0f), last));
  }

  void fill_table() {
    const size_t n = particles_.count;
    std::vector<std::pair<size_t, size_t>> order(n);
    for (size_t i = 0; i < n; i++) {
      const auto y = static_cast<size_t>(cell_of(1, particles_.x[1][i]));
      const auto z = static_cast<size_t>(cell_of(2, particles_.x[2][i]));
      const size_t row = z * static_cast<size_t>(table_.count[1]) + y;
      order[i] = {row * static_cast<size_t>(table_.count[0]) + static_cast<size_t>(cell_of(0, particles_.x[0][i])), i};
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

  template <class Run>
  void compare_sets(Run &&run) {
    bool first = true;
    for (const KernelSet *set : kernel_sets()) {
      Sink sink;
      require(run(*set, sink), "%s: stopped", set->name);
      sink.settle(&sink);
      sink.take();
      require(sink.open_where_written, "an open pair is not where the kernel says it wrote it");
      if (first) found_ = sink.found;
      require(sink.found == found_, "%s: %zu pairs instead of the scalar kernel's %zu, or another order", set->name,
              sink.found.pairs.size(), found_.pairs.size());
      first = false;
    }
    std::sort(found_.pairs.begin(), found_.pairs.end());
    std::sort(found_.asked.begin(), found_.asked.end());
    require(std::adjacent_find(found_.pairs.begin(), found_.pairs.end()) == found_.pairs.end(), "a pair came twice");
    require(found_.undecided == static_cast<int64_t>(found_.asked.size()), "undecided pairs are miscounted");
    expected_ = 0;
  }

  // Pair (i of points, j of the particles): must it be found, may it be, may it be found unasked?
  void judge(const Points &points, size_t i, size_t j) {
    long double d2 = 0;
    for (int k = 0; k < dimension_; k++) {
      const long double d = static_cast<long double>(points.x[k][i]) - static_cast<long double>(particles_.x[k][j]);
      d2 += d * d;
    }
    const long double ri = static_cast<long double>(points.radius[i]);
    const long double rj = static_cast<long double>(particles_.radius[j]);
    const long double R = max_range_ ? std::max(ri, rj) : ri + rj, d = std::sqrt(d2);
    const long double band =
        R * (static_cast<long double>(hg::kBandLinear) + static_cast<long double>(hg::kBandSquare) * R) +
        static_cast<long double>(hg::kBandConstant);
    const Pair pair(std::min(points.slot[i], particles_.slot[j]), std::max(points.slot[i], particles_.slot[j]));
    const bool found = std::binary_search(found_.pairs.begin(), found_.pairs.end(), pair);
    const bool asked = std::binary_search(found_.asked.begin(), found_.asked.end(), pair);
    expected_ += found ? 1 : 0;
    require(found || d >= R + static_cast<long double>(kQuantisation),
            "missed: distance %.9Lg, reach %.9Lg quanta, cells of %g", d, R, static_cast<double>(table_.width[1]));
    require(!found || d2 < (R * R + band) * (1 + 0x1p-20L), "too far: distance %.9Lg, reach %.9Lg quanta", d, R);
    require(!found || asked || d <= R - static_cast<long double>(kQuantisation) || R == 0,
            "not asked about: distance %.9Lg, reach %.9Lg quanta", d, R);
  }
  void require_nothing_else() {
    require(expected_ == found_.pairs.size(), "%zu pairs, of which %zu exist", found_.pairs.size(), expected_);
  }

  Rng rng_;
  int dimension_;
  bool max_range_;
  hg::FixedPoint frame_;
  double reach_ = 0;
  CellTable table_{};
  std::vector<uint32_t> cell_begin_;
  Points particles_;
  Found found_;
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
  return cmocka_run_group_tests_name("kernels", tests, nullptr, nullptr);
}
