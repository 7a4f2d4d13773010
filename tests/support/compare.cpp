// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Comparisons of what a grid returns with what it must.
#include "tests/support/compare.hpp"

#include <algorithm>
#include <cstdio>
#include <iterator>

namespace hgtest {
namespace {

// Extra pairs of HG_FLOAT may be this much farther apart than their reach, relative to it.
constexpr double kFloatExtra = 1e-3;

std::string first_of(const Pairs &pairs) {
  if (pairs.empty()) return "none";
  return std::to_string(pairs.size()) + ", first (" + std::to_string(pairs[0].a) + ", " + std::to_string(pairs[0].b) +
         ")";
}

}  // namespace

void require(bool condition, const std::string &what) {
  if (!condition) throw Failure(what);
}

void require_same(const char *what, const Pairs &got, const Pairs &expected) {
  if (std::equal(got.begin(), got.end(), expected.begin(), expected.end(), pair_equal)) return;
  const oracle::Difference wrong = oracle::difference(expected, got);
  throw Failure(std::string(what) + ": " + std::to_string(got.size()) + " pairs, expected " +
                std::to_string(expected.size()) + "; missing: " + first_of(wrong.missing) +
                "; too many: " + first_of(wrong.extra));
}

void require_same(const char *what, const std::vector<int32_t> &got, const std::vector<int32_t> &expected) {
  if (got == expected) return;
  const auto at = std::mismatch(got.begin(), got.end(), expected.begin(), expected.end());
  throw Failure(std::string(what) + ": " + std::to_string(got.size()) + " ids, expected " +
                std::to_string(expected.size()) + "; they differ from entry " +
                std::to_string(std::distance(got.begin(), at.first)));
}

void require_rows(const std::string &what, const hgrid::Rows &got, const std::vector<std::vector<int32_t>> &expected) {
  require(got.size() == expected.size(), what + ": the number of rows is wrong");
  for (size_t k = 0; k < got.size(); k++) {
    require_same((what + ", row " + std::to_string(k)).c_str(), list_of(got[k]), expected[k]);
  }
}

void set_box(const Grid &grid, const hg_grid_def &def) {
  hgrid::check(hg_set_box(grid.get(), def.box_min, def.box_max, def.tilt));
}

Pairs pairs_of(const Grid &grid) {
  const hgrid::View<hg_pair> pairs = grid.query_pairs();
  return Pairs(pairs.begin(), pairs.end());
}

Pairs sorted(Pairs pairs) {
  std::sort(pairs.begin(), pairs.end(), pair_less);
  return pairs;
}

Pairs sorted_pairs_of(const Grid &grid) { return sorted(pairs_of(grid)); }

Pairs pairs_of_rows(const Grid &grid, int32_t list) {
  const size_t count = static_cast<size_t>(grid.get_stats().particle_count);
  const hgrid::Rows rows = grid.query_neighbors(list);
  require(rows.offsets[0] == 0 && rows.size() == count, "offsets do not start at 0, or do not fit the particles");
  Pairs pairs;
  for (size_t row = 0; row < count; row++) {
    const hgrid::View<int32_t> ids = rows[row];
    require(std::is_sorted(ids.begin(), ids.end()), "a row does not ascend");
    for (const int32_t neighbor : ids) pairs.push_back({static_cast<int32_t>(row), neighbor});
  }
  std::vector<int32_t> offsets(count + 1), ids(pairs.size());
  require(grid.copy_neighbors(list, ids.size(), offsets.data(), ids.data()) == ids.size() &&
              std::equal(offsets.begin(), offsets.end(), rows.offsets.begin(), rows.offsets.end()) &&
              std::equal(ids.begin(), ids.end(), rows.ids.begin(), rows.ids.end()),
          "copied rows differ from those lent");
  return pairs;
}

void require_superset(const std::string &what, const hg_grid_def &def, const Particles &particles, const Pairs &got,
                      const Pairs &expected) {
  const Pairs ascending = sorted(got);
  const bool all_images = def.images == HG_ALL_IMAGES;
  for (size_t k = 0; k < ascending.size(); k++) {
    require(ascending[k].a < ascending[k].b || (all_images && ascending[k].a == ascending[k].b),
            what + ": a pair is not a < b");
    require(k == 0 || all_images || pair_less(ascending[k - 1], ascending[k]), what + ": a pair comes twice");
  }
  const oracle::Difference wrong = oracle::difference(expected, got);
  require(wrong.missing.empty(), what + ": HG_FLOAT misses " + first_of(wrong.missing));
  const auto sphere = [&](int32_t id) {
    const size_t row = static_cast<size_t>(id - def.index_base);
    return Sphere{particles.center(row), particles.radii[row]};
  };
  for (const hg_pair &extra : wrong.extra) {
    const double gap = relative_gap(def, sphere(extra.a), sphere(extra.b), oracle::nearer_images(ascending, extra));
    require(gap <= kFloatExtra, what + ": extra pair at relative distance " + std::to_string(gap));
  }
}

void require_exact(const std::string &what, const hg_grid_def &def, const Particles &particles) {
  require_same(what.c_str(), sorted_pairs_of(make_grid(def, particles)), all_pairs(def, particles, exact_interact));
}

}  // namespace hgtest
