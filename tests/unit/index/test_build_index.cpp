// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The built index: every particle once, on its level, in its cell, at its place.
#include "src/index/build_index.hpp"
#include "src/particles/bounds.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/domains.hpp"
#include "tests/unit/exact_place.hpp"
#include "tests/unit/plain_cells.hpp"
#include "tests/unit/stores.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace hgtest;
using hg::Domain;
using hg::Index;
using hg::IndexLevel;

class Scene {
 public:
  Scene(uint64_t seed, hg::Memory &memory)
      : rng_(seed),
        domain_(any_domain()),
        interaction_(any_interaction()),
        index_(memory, domain_, interaction_),
        scratch_(memory),
        store_(make_store(memory, domain_, interaction_)) {}

  // Twice, as buffers are used again.
  void check() {
    for (int build = 0; build < 2; build++) {
      store_.clear();
      insert();
      bounds_ = hg::bounds_of(store_, domain_, 1);
      plan_ = any_plan();
      if (store_.slots() > 0) {
        index_.map = hg::FixedPoint::over(bounds_, domain_, interaction_.diameter(bounds_.max_radius));
      }
      hg::build_index(index_, scratch_, store_, plan_, rng_.integer(1, 4));
      check_levels();
      check_radii();
      if (index_.chunked) continue;  // unit/index/test_chunk_rows.cpp
      check_places();
      for (int h = 0; h < index_.level_count; h++) check_cells(index_.levels[h]);
    }
  }

 private:
  Domain any_domain() {
    Domain d;
    d.dimension = rng_.integer(2, 3);
    // Far from the origin, at a power of two, where numbers below the box are finer than those in it.
    const double far = rng_.chance(0.3) ? std::ldexp(rng_.chance(0.5) ? 1 : -1, rng_.integer(10, 45)) : 0;
    for (int axis = 0; axis < d.dimension; axis++) {
      const double low = far != 0 ? far : rng_.uniform(-10, 10);
      set_box(d, axis, low, low + (far != 0 ? 1 : rng_.uniform(1, 2)), rng_.chance(0.4));
    }
    return d;
  }

  hg::Interaction any_interaction() {
    return {rng_.chance(0.5) ? HG_CONTACT : HG_MAX_RANGE, rng_.chance(0.5) ? 0 : 0.01};
  }

  void insert() {
    const size_t count = rng_.chance(0.05) ? 0 : 1 + rng_.below(rng_.chance(0.2) ? 5000 : 300);
    const bool clustered = rng_.chance(0.3);
    std::vector<double> centers, radii;
    for (size_t i = 0; i < count; i++) {
      for (int axis = 0; axis < domain_.dimension; axis++) {
        double x = rng_.uniform(-1, 2);
        if (clustered && !domain_.periodic[axis]) x = (x - 1) * 1e-4 + std::floor(rng_.uniform(0, 3)) * 1e6;
        centers.push_back(domain_.box_min[axis] + x * domain_.length[axis]);
      }
      radii.push_back(std::pow(10, rng_.uniform(-6, -1.3)));
    }
    store_.insert(count, centers.data(), radii.data());
  }

  hg::LevelPlan any_plan() {
    std::vector<double> sizes;
    double size = interaction_.diameter(bounds_.max_radius) * (rng_.chance(0.5) ? 1 : 1.5);
    for (int h = rng_.integer(1, 8); h > 0; h--) {
      sizes.push_back(size);
      size *= rng_.uniform(0.1, 0.9);
    }
    std::reverse(sizes.begin(), sizes.end());
    return hg::user_levels(sizes.data(), static_cast<int>(sizes.size()), interaction_);
  }

  void check_levels() {
    std::vector<int> seen(store_.slots(), 0);
    uint32_t begin = 0;
    for (int h = 0; h < index_.level_count; h++) {
      const IndexLevel &level = index_.levels[h];
      require(level.begin == begin && level.end >= begin, "level %d: [%u, %u)", h, level.begin, level.end);
      double largest = 0;
      for (uint32_t i = level.begin; i < level.end; i++) {
        const uint32_t slot = index_.particles.slot[i];
        require(slot < store_.slots() && seen[slot]++ == 0, "slot %u is there twice or not at all", slot);
        const double diameter = interaction_.diameter(store_.radius(slot));
        require(diameter <= plan_.levels[h].cell_size, "level %d: %g > %g", h, diameter, plan_.levels[h].cell_size);
        require(h == 0 || diameter > plan_.levels[h - 1].cell_size, "level %d: %g fits the finer level", h, diameter);
        largest = std::max(largest, store_.radius(slot));
      }
      require(level.largest_radius == largest, "level %d: largest radius %g instead of %g", h, level.largest_radius,
              largest);
      begin = level.end;
    }
    require(begin == store_.slots() || index_.level_count == 0, "%u of %zu particles", begin, store_.slots());
  }

  void check_places() {
    const hg::PointStore &points = index_.particles;
    for (uint32_t i = 0; i < store_.slots(); i++) {
      const double *center = store_.center(points.slot[i]);
      const int32_t place[3] = {points.x[i], points.y[i], domain_.dimension == 3 ? points.z[i] : 0};
      require_place(index_.map, domain_, center, place);
    }
  }

  void check_radii() {
    const hg::PointStore &points = index_.particles;
    for (uint32_t i = 0; i < store_.slots(); i++) {
      const double folded = interaction_.folded_radius(store_.radius(points.slot[i])) * index_.map.scale;
      require(std::fabs(static_cast<double>(points.radius[i]) - folded) <= 0x1p-23 * folded, "radius of %u", i);
    }
  }

  void check_cells(const IndexLevel &level) {
    if (level.begin == level.end) return;
    const hg::CellTable &table = level.cells;
    const auto count_x = static_cast<size_t>(table.count[0]), count_y = static_cast<size_t>(table.count[1]);
    const size_t cells = count_x * count_y * static_cast<size_t>(table.count[2]);
    require(table.cell_begin[0] == level.begin && table.cell_begin[cells] == level.end, "the table's ends");
    for (size_t c = 0; c < cells; c++) require(table.cell_begin[c] <= table.cell_begin[c + 1], "cell %zu", c);
    for (uint32_t i = level.begin; i < level.end; i++) {
      size_t c = plain_cell(table, 1, index_.particles.y[i]);
      if (domain_.dimension == 3) c += plain_cell(table, 2, index_.particles.z[i]) * count_y;
      c = c * count_x + plain_cell(table, 0, index_.particles.x[i]);
      require(i >= table.cell_begin[c] && i < table.cell_begin[c + 1], "particle %u is not in its cell %zu", i, c);
    }
    const float largest = static_cast<float>(interaction_.folded_radius(level.largest_radius) * index_.map.scale);
    require(table.largest_radius == largest, "largest folded radius");
  }

  Rng rng_;
  Domain domain_;
  hg::Interaction interaction_;
  Index index_;
  hg::BuildScratch scratch_;
  hg::ParticleStore store_;
  hg::Bounds bounds_;
  hg::LevelPlan plan_;
};

void check_scene(uint64_t seed) {
  hg::Memory memory(hg::system_allocator());
  Scene(seed, memory).check();
}

void any_scenes(void **) { assert_true(sweep(120, check_scene)); }

// One particle far away must not cost memory: cells stay bounded, the crowd goes to chunks of rows.
void check_outlier(uint64_t) {
  hg::Memory memory(hg::system_allocator());
  Index index(memory, open_space(3), {});
  hg::BuildScratch scratch(memory);
  hg::ParticleStore store = make_store(memory, index.domain);
  Rng rng(1);
  std::vector<double> centers, radii(20000, 0.5);
  for (size_t i = 0; i < 3 * radii.size(); i++) centers.push_back(rng.uniform(0, 30));
  centers[0] = 1e12;
  store.insert(radii.size(), centers.data(), radii.data());
  const double size = 1;
  index.map = hg::FixedPoint::over(hg::bounds_of(store, index.domain, 1), index.domain, size);
  hg::build_index(index, scratch, store, hg::user_levels(&size, 1, index.interaction), 1);
  require(index.chunked, "20000 particles in one cell");
  require(memory.bytes() < int64_t{20000} * 200, "%lld bytes", static_cast<long long>(memory.bytes()));
}

void outlier(void **) { assert_true(holds(0, check_outlier)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_scenes), cmocka_unit_test(outlier)};
  return cmocka_run_group_tests_name("build_index", tests, nullptr, nullptr);
}
