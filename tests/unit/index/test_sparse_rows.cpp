// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// SparseRows against brute force: clusters far apart, several levels one after the other.
#include "src/index/sparse_rows.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/domains.hpp"
#include "tests/unit/stores.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace {

using namespace hgtest;
using hg::ParticleStore;
using hg::SparseLevel;
using hg::SparseRows;

// The particles of one level, in the order that the rows gave them.
struct Level {
  SparseLevel rows;
  std::vector<uint32_t> slots;
};

struct Box {
  double low[3], high[3];
};

class Scene {
 public:
  Scene(uint64_t seed, hg::Memory &memory)
      : rng_(seed),
        dimension_(rng_.integer(2, 3)),
        scale_(std::pow(10, rng_.chance(0.3) ? rng_.uniform(-300, 300) : 0)),
        store_(make_store(memory, open_space(dimension_))),
        sparse_(memory) {}

  void check() {
    for (int build = 0; build < 2; build++) {
      make_particles();
      add_levels();
      for (const Level &level : levels_) {
        check_order(level);
        for (int k = 0; k < 20; k++) check_box(level, any_box());
        check_box(level, everywhere());
        check_after(level);
      }
      if (build == 0) {
        store_.clear();
        sparse_.clear();
        levels_.clear();
      }
    }
  }

 private:
  const double *center(uint32_t slot) const { return store_.center(slot); }

  // Tight clusters at wildly different distances, some particles at one place, some on row borders.
  double place(double cluster) {
    if (rng_.chance(0.1)) return cluster;
    if (rng_.chance(0.2)) return cluster + scale_ * std::floor(rng_.uniform(-3, 3));
    return cluster + scale_ * rng_.uniform(-3, 3);
  }

  void make_particles() {
    std::vector<double> centers, radii;
    const int clusters = rng_.integer(1, 5);
    for (int c = 0; c < clusters; c++) {
      double at[3];
      const double far = rng_.chance(0.5) ? 1 : std::pow(10, rng_.uniform(0, 300));
      for (double &x : at) {
        x = scale_ * 10 * rng_.uniform(-1, 1);
        if (far * std::fabs(x) < 1e300) x *= far;
      }
      const int count = rng_.integer(1, 60);
      for (int i = 0; i < count; i++) {
        for (int axis = 0; axis < dimension_; axis++) centers.push_back(place(at[axis]));
        radii.push_back(0.5 * scale_);
      }
    }
    store_.insert(radii.size(), centers.data(), radii.data());
  }

  // Sparse levels with dense ones between them, which take numbers but no rows.
  void add_levels() {
    const int count = rng_.integer(1, 4);
    std::vector<std::vector<uint32_t>> members(static_cast<size_t>(count));
    for (size_t slot = 0; slot < store_.slots(); slot++) {
      members[rng_.below(members.size())].push_back(static_cast<uint32_t>(slot));
    }
    uint32_t begin = 0;
    for (std::vector<uint32_t> &slots : members) {
      begin += rng_.chance(0.5) ? static_cast<uint32_t>(rng_.below(100)) : 0;
      if (slots.empty()) continue;
      const double origin[3] = {0, rng_.chance(0.5) ? 0 : scale_ * rng_.uniform(), 0};
      const auto size = static_cast<uint32_t>(slots.size());
      const double width = scale_ * std::pow(2, rng_.integer(0, 3));
      const SparseLevel rows =
          sparse_.add_level(store_, open_space(dimension_), origin, width, slots.data(), begin, size);
      levels_.push_back({rows, slots});
      begin += size;
    }
  }

  void check_order(const Level &level) {
    std::vector<uint32_t> sorted = level.slots;
    std::sort(sorted.begin(), sorted.end());
    require(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end(), "a slot is in a level twice");
    require(level.rows.end - level.rows.begin == level.slots.size(), "a level of %zu holds %u", level.slots.size(),
            level.rows.end - level.rows.begin);
  }

  Box any_box() {
    const double *at = center(static_cast<uint32_t>(rng_.below(store_.slots())));
    const double reach = scale_ * (rng_.chance(0.2) ? 0 : rng_.uniform(0, 4));
    Box box{};
    for (int axis = 0; axis < dimension_; axis++) {
      box.low[axis] = at[axis] - reach;
      box.high[axis] = at[axis] + reach;
    }
    return box;
  }
  Box everywhere() const {
    Box box{};
    for (int axis = 0; axis < dimension_; axis++) {
      box.low[axis] = -std::numeric_limits<double>::infinity();
      box.high[axis] = std::numeric_limits<double>::infinity();
    }
    return box;
  }

  bool inside(const Box &box, uint32_t slot) const {
    bool in = true;
    for (int axis = 0; axis < dimension_; axis++)
      in = in && center(slot)[axis] >= box.low[axis] && center(slot)[axis] <= box.high[axis];
    return in;
  }

  // Every particle in the box is visited, none twice, and none whose x is outside.
  void check_box(const Level &level, const Box &box) {
    std::vector<int> visits(level.slots.size(), 0);
    const auto note = [&](uint32_t begin, uint32_t end) {
      require(begin < end && begin >= level.rows.begin && end <= level.rows.end, "run [%u, %u) of level [%u, %u)",
              begin, end, level.rows.begin, level.rows.end);
      for (uint32_t i = begin; i < end; i++) visits[i - level.rows.begin]++;
      return true;
    };
    require(sparse_.visit_box(level.rows, dimension_, box.low, box.high, note), "a visit that goes on was stopped");
    for (size_t i = 0; i < visits.size(); i++) {
      const double x = center(level.slots[i])[0];
      require(visits[i] <= 1, "particle %zu is visited %d times", i, visits[i]);
      require(visits[i] == 1 || !inside(box, level.slots[i]), "particle %zu is missed", i);
      require(visits[i] == 0 || (x >= box.low[0] && x <= box.high[0]), "particle %zu is outside", i);
    }
    size_t runs = 0;
    const bool all = sparse_.visit_box(level.rows, dimension_, box.low, box.high, [&](uint32_t, uint32_t) {
      runs++;
      return false;
    });
    require(runs <= 1 && all == (runs == 0), "a stopped visit made %zu runs", runs);
  }

  // Pairs of a level nearer than half a row width per axis: each is met once, from its earlier particle.
  void check_after(const Level &level) {
    const double reach = level.rows.width * rng_.uniform();
    const uint32_t begin = level.rows.begin, end = level.rows.end;
    const uint32_t start = begin + static_cast<uint32_t>(rng_.below(end - begin));
    SparseRows::Place place = sparse_.place_of(level.rows, start);
    for (uint32_t i = start; i < end; i++) {
      if (rng_.chance(0.1)) continue;  // particles may be left out
      const double *at = center(level.slots[i - begin]);
      Box box{};
      for (int axis = 0; axis < dimension_; axis++) {
        box.low[axis] = at[axis] - reach;
        box.high[axis] = at[axis] + reach;
      }
      std::vector<int> visits(level.slots.size(), 0);
      sparse_.visit_after(level.rows, dimension_, i, place, box.low, box.high, [&](uint32_t first, uint32_t last) {
        require(first > i && first < last && last <= end, "run [%u, %u) after %u", first, last, i);
        for (uint32_t j = first; j < last; j++) visits[j - begin]++;
        return true;
      });
      for (uint32_t j = i + 1; j < end; j++) {
        require(visits[j - begin] <= 1, "pair (%u, %u) is met %d times", i, j, visits[j - begin]);
        require(visits[j - begin] == 1 || !inside(box, level.slots[j - begin]), "pair (%u, %u) is missed", i, j);
      }
    }
  }

  Rng rng_;
  int dimension_;
  double scale_;
  ParticleStore store_;
  SparseRows sparse_;
  std::vector<Level> levels_;
};

void check_scene(uint64_t seed) {
  hg::Memory memory(hg::system_allocator());
  Scene(seed, memory).check();
}

void clusters_far_apart(void **) { assert_true(sweep(300, check_scene)); }

// Row numbers never go down with the position, and never overflow.
void check_rows(uint64_t seed) {
  Rng rng(seed);
  SparseLevel level;
  level.width = std::ldexp(1.0, rng.integer(-1074, 1000));
  level.origin[1] = rng.chance(0.5) ? 0 : rng.uniform(-1e9, 1e9);
  std::vector<double> at = {-1.7e308, -1, 0, 5e-324, 1, 1.7e308, -HUGE_VAL, HUGE_VAL};
  for (int k = 0; k < 50; k++) at.push_back(std::ldexp(rng.uniform(-1, 1), rng.integer(-1000, 1020)));
  std::sort(at.begin(), at.end());
  for (size_t k = 1; k < at.size(); k++) {
    require(level.row_of(1, at[k - 1]) <= level.row_of(1, at[k]), "rows go down from %a to %a", at[k - 1], at[k]);
  }
  const int64_t last = int64_t{1} << 62;
  require(level.row_of(1, HUGE_VAL) <= last && level.row_of(1, -HUGE_VAL) >= -last, "rows beyond 2^62");
}

void rows_are_monotone(void **) { assert_true(sweep(1000, check_rows)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(clusters_far_apart), cmocka_unit_test(rows_are_monotone)};
  return cmocka_run_group_tests_name("sparse_rows", tests, nullptr, nullptr);
}
