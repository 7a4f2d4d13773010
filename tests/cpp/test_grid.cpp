// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid::Grid: each member gives what its C call gives, each failure is thrown with its status and text.
#include "tests/cpp/chain.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace {

using namespace hgtest;

void defaults_are_those_of_the_library() {
  hgrid::Grid grid;
  require(grid.query_pairs().empty() && grid.get_stats().particle_count == 0, "a new grid is not empty");
  grid.insert(kChain, kCenters, kRadii);
  require(grid.query_pairs().size() == kChain - 1, "the chain is not found");
}

void views_show_what_c_lends() {
  hgrid::Grid grid = chain();
  const hg_pair *pairs = nullptr;
  size_t count = 0;
  hgrid::check(hg_query_pairs(grid.get(), &pairs, &count));
  const hgrid::View<hg_pair> view = grid.query_pairs();
  require(view.data() == pairs && view.size() == count && !view.empty(), "the view is not the list of C");
  require(view.begin() == pairs && view.end() == pairs + count && &view[1] == pairs + 1, "the view's ends");
  size_t seen = 0;
  for (const hg_pair pair : grid.query_pairs()) seen += static_cast<size_t>(pair.a == static_cast<int32_t>(seen));
  require(seen == count, "a loop does not see every pair");
  require(hgrid::View<hg_pair>().empty() && hgrid::View<hg_pair>().begin() == hgrid::View<hg_pair>().end(),
          "a view of nothing");
}

void neighbors_are_rows() {
  hgrid::Grid grid = chain();
  const hgrid::Rows half = grid.query_neighbors(HG_HALF);
  require(half.size() == kChain && half.offsets.size() == kChain + 1 && half.ids.size() == kChain - 1, "half list");
  const std::vector<std::vector<int32_t>> expected = {{1}, {0, 2}, {1, 3}, {2}};
  const hgrid::Rows full = grid.query_neighbors(HG_FULL);
  for (size_t row = 0; row < full.size(); row++) {
    require_same("row", std::vector<int32_t>(full[row].begin(), full[row].end()), expected[row]);
  }
  const int64_t *offsets = nullptr;
  const int32_t *ids = nullptr;
  hgrid::check(hg_query_neighbors(grid.get(), HG_FULL, &offsets, &ids));
  const auto [row_offsets, row_ids] = grid.query_neighbors(HG_FULL);
  require(row_offsets.data() == offsets && row_ids.data() == ids, "the views are not the lists of C");
  grid.clear();
  require(grid.query_neighbors(HG_FULL).size() == 0 && hgrid::Rows().size() == 0, "rows of nothing");
}

void a_sphere_finds_ids() {
  hgrid::Grid grid = chain();
  const double center[3] = {1.5, 0, 0};
  const hgrid::View<int32_t> ids = grid.query_sphere(center, 0.1);
  require_same("ids", std::vector<int32_t>(ids.begin(), ids.end()), {1, 2});
  const double nowhere[3] = {1e9, 0, 0};
  require(grid.query_sphere(nowhere, 0.1).empty(), "a sphere far away meets something");
}

void spheres_find_rows() {
  hgrid::Grid grid = chain();
  const double centers[6] = {1e9, 0, 0, 1.5, 0, 0}, radii[2] = {0.1, 0.1};
  const hgrid::Rows rows = grid.query_spheres(2, centers, radii);
  require(rows.size() == 2 && rows[0].empty(), "a sphere far away meets something");
  require_same("ids", std::vector<int32_t>(rows[1].begin(), rows[1].end()), {1, 2});
  require(grid.query_spheres(0, nullptr, nullptr).size() == 0, "no spheres have rows");
}

void shapes_find_rows() {
  hgrid::Grid grid = chain();
  const double low[3] = {0.9, 0, 0}, high[3] = {1.1, 0, 0};
  const double corners[9] = {1.5, -1, -1, 1.5, 1, -1, 1.5, 0, 1};
  const hgrid::Rows boxes = grid.query_boxes(1, low, high), triangles = grid.query_triangles(1, corners);
  require(boxes.size() == 1 && triangles.size() == 1, "rows are missing");
  require(std::count(boxes[0].begin(), boxes[0].end(), 1) == 1, "a box does not meet the particle inside");
  require_same("ids", std::vector<int32_t>(triangles[0].begin(), triangles[0].end()), {1, 2});
}

void levels_and_counters() {
  hgrid::Grid grid = chain();
  grid.build();
  int64_t particles = 0;
  for (const hg_level &level : grid.query_levels()) particles += level.particle_count;
  require(particles == static_cast<int64_t>(kChain), "the levels do not hold the particles");
  require(!grid.query_level_costs().empty() && grid.query_level_costs()[0].level_count == 1, "no costs");
  require(grid.query_pairs().size() == kChain - 1, "the chain is not found");
  const hg_grid_stats stats = grid.get_stats();
  require(stats.particle_count == particles && stats.pair_count == kChain - 1 && stats.build_count == 1, "counters");
}

void particles_come_move_and_go() {
  hgrid::Grid grid = chain();
  std::vector<double> centers(kCenters, kCenters + 3 * kChain), radii(kChain, 0.4);
  centers[0] = -9;
  grid.move(kChain, centers.data());
  require(grid.query_pairs().size() == kChain - 2, "a move without radii");
  grid.move(kChain, kCenters, radii.data());
  require(grid.query_pairs().empty(), "a move with radii");
  grid.move(kChain, kCenters, kRadii);
  const int32_t gone[1] = {1};
  grid.remove(1, gone);
  const hgrid::View<hg_pair> left = grid.query_pairs();
  require_same("pairs after a removal", Pairs(left.begin(), left.end()), {{2, 3}});
  grid.clear();
  require(grid.query_pairs().empty(), "a cleared grid has pairs");
  grid.insert(kChain, kCenters, kRadii);
  require_chain(grid);
}

void sets_replace_all() {
  hgrid::Grid grid = chain();
  grid.set(2, kCenters, kRadii);
  require(grid.query_pairs().size() == 1, "a set of two");
  grid.set(0, nullptr, nullptr);
  require(grid.query_pairs().empty(), "a set of nothing");
  grid.set(kChain, kCenters, kRadii);
  require_chain(grid);
  require_error(HG_ERR_NULL, "radii", [&] { grid.set(2, kCenters, nullptr); });
  require_chain(grid);
}

// Columns of the chain, its last number first.
void arrays_of_any_stride() {
  const float zero = 0;
  const auto last = static_cast<int64_t>(kChain - 1);
  const hg_array same{&zero, 0, HG_REAL32, 0}, radius{kRadii, sizeof(double), HG_REAL64, 0};
  const hg_array centers[3] = {{kCenters + 3 * last, -3 * int64_t{sizeof(double)}, HG_REAL64, 0}, same, same};
  hgrid::Grid grid = chain();
  grid.clear();
  grid.insert_arrays(kChain, centers, &radius);
  require_chain(grid);
  grid.set_arrays(kChain, centers, &radius);
  require_chain(grid);
  grid.move_arrays(kChain, centers);
  require_chain(grid);
  grid.move_arrays(kChain, centers, &same);
  require(grid.query_pairs().empty(), "particles without size");
  require_error(HG_ERR_ARGUMENT, "radius.type = 9", [&] {
    const hg_array none{kRadii, 8, 9, 0};
    grid.insert_arrays(1, centers, &none);
  });
  require_error(HG_ERR_ARGUMENT, "count is 1", [&] { grid.move_arrays(1, centers); });
  require_error(HG_ERR_NULL, "centers", [&] { grid.set_arrays(1, nullptr, &radius); });
}

void vectors_stand_beside_pairs() {
  for (const int dimension : {2, 3}) {
    const double centers[6] = {0.25, 1, 1, 3.75, 1, 1}, plane[4] = {0.25, 1, 3.75, 1}, radii[2] = {0.5, 0.5};
    hg_grid_def def = hg_default_grid_def();
    def.dimension = dimension;
    def.periodic[0] = 1;
    def.box_max[0] = 4;
    hgrid::Grid grid(def);
    grid.insert(2, dimension == 3 ? centers : plane, radii);
    const auto [vectors, shifts] = grid.query_pair_vectors();
    require(vectors.size() == static_cast<size_t>(dimension) && shifts.size() == vectors.size(), "as many numbers");
    require(vectors[0] == -0.5 && vectors[1] == 0 && shifts[0] == -1 && shifts[1] == 0, "through the face");
    grid.clear();
    require(grid.query_pair_vectors().vectors.empty() && grid.query_pair_vectors().shifts.empty(), "of nothing");
  }
}

void pairs_are_copied() {
  hgrid::Grid grid = chain();
  int32_t a[kChain] = {}, b[kChain] = {};
  require(grid.copy_pairs(kChain, a, b) == kChain - 1, "the number of pairs");
  for (size_t k = 0; k + 1 < kChain; k++) require(b[k] == a[k] + 1, "a pair of the chain");
  size_t need = 0;
  require_error(HG_ERR_CAPACITY, "capacity is 1", [&] { grid.copy_pairs(1, a, b, &need); });
  require(need == kChain - 1, "what is needed");
  require_error(HG_ERR_NULL, "a is NULL", [&] { grid.copy_pairs(kChain, nullptr, b, &need); });
}

void neighbors_are_copied() {
  hgrid::Grid grid = chain();
  int32_t offsets[kChain + 1] = {}, ids[kChain] = {};
  require(grid.copy_neighbors(HG_HALF, kChain, offsets, ids) == kChain - 1, "the number of neighbours");
  for (size_t k = 0; k + 1 < kChain; k++) require(ids[offsets[k]] == static_cast<int32_t>(k + 1), "a row of the chain");
  size_t need = 0;
  require_error(HG_ERR_CAPACITY, "capacity is 1", [&] { grid.copy_neighbors(HG_FULL, 1, offsets, ids, &need); });
  require(need == 2 * (kChain - 1) && offsets[kChain] == static_cast<int32_t>(need), "what is needed");
}

void order_and_verdict() {
  hgrid::Grid grid = chain();
  std::vector<int32_t> ids(grid.query_order().begin(), grid.query_order().end());
  std::sort(ids.begin(), ids.end());
  require_same("every id once", ids, {0, 1, 2, 3});
  const double apart[3] = {2, 0, 0};
  require(grid.overlap(kCenters, 1, apart, 1.25) && !grid.overlap(kCenters, 1, apart, 1), "two spheres");
  require_error(HG_ERR_ARGUMENT, "radius_b = -1", [&] { grid.overlap(kCenters, 1, apart, -1); });
}

void groups_and_bodies() {
  constexpr int32_t kGroups[kChain] = {0, 1, 1, -1}, kBodies[kChain] = {5, 5, -1, -1};
  hgrid::Grid grid = chain();
  grid.set_groups(kChain, kGroups);
  require(grid.query_pairs().size() == 2, "pairs without the absent one");
  grid.set_group_pair(1, 1, false);
  require(grid.query_pairs().size() == 1, "pairs without those of group 1");
  grid.set_bodies(kChain, kBodies);
  require(grid.query_pairs().empty(), "a pair of one body");
  grid.set_bodies(0, nullptr);
  grid.set_group_pair(1, 1, true);
  grid.set_groups(0, nullptr);
  require(grid.query_pairs().size() == kChain - 1, "the whole chain again");
  require_error(HG_ERR_ARGUMENT, "count is 2", [&] { grid.set_groups(2, kGroups); });
  require_error(HG_ERR_ARGUMENT, "count is 2", [&] { grid.set_bodies(2, kBodies); });
  require_error(HG_ERR_ARGUMENT, "group_a = 64", [&] { grid.set_group_pair(HG_MAX_GROUPS, 0, true); });
}

// Two spheres whose nearest images meet only where the upper one stands half a box to the right.
void a_box_may_change() {
  constexpr double kLow[3] = {0, 0, 0}, kHigh[3] = {4, 4, 4}, kTilt[3] = {2, 0, 0};
  const double centers[6] = {1, 0.5, 1, 3, 3.5, 1}, radii[2] = {0.75, 0.75};
  hg_grid_def def = hg_default_grid_def();
  std::fill_n(def.periodic, 3, 1);
  std::copy_n(kHigh, 3, def.box_max);
  hgrid::Grid grid(def);
  grid.insert(2, centers, radii);
  require(grid.query_pairs().empty(), "a pair in the upright box");
  grid.set_box(kLow, kHigh, kTilt);
  require(grid.query_pairs().size() == 1, "no pair in the tilted box");
  const double far[3] = {-9, 0, 0};
  require_error(HG_ERR_ARGUMENT, "box_max[0]", [&] { grid.set_box(kLow, far); });
  require_error(HG_ERR_NULL, "box_max", [&] { grid.set_box(kLow, nullptr); });
  require(grid.query_pairs().size() == 1, "a refused box has changed the grid");
  grid.set_box(kLow, kHigh);
  require(grid.query_pairs().empty(), "a pair in a box that is upright again");
}

void failures_tell_status_and_text() {
  hg_grid_def def = hg_default_grid_def();
  def.dimension = 4;
  require_error(HG_ERR_ARGUMENT, "dimension = 4", [&] { hgrid::Grid grid(def); });
  def.dimension = 3;
  def.level_count = HG_MAX_LEVELS + 1;
  require_error(HG_ERR_LIMIT, "level_count = 65", [&] { hgrid::Grid grid(def); });
  hgrid::Grid grid = chain();
  const double negative[1] = {-1}, center[3] = {0, 0, 0}, nan[3] = {0, std::numeric_limits<double>::quiet_NaN(), 0};
  require_error(HG_ERR_ARGUMENT, "radii[0] = -1", [&] { grid.insert(1, center, negative); });
  require_error(HG_ERR_NULL, "centers", [&] { grid.insert(1, nullptr, kRadii); });
  require_error(HG_ERR_ARGUMENT, "count is 1", [&] { grid.move(1, center); });
  const int32_t unknown[1] = {17};
  require_error(HG_ERR_NOT_FOUND, "17", [&] { grid.remove(1, unknown); });
  require_error(HG_ERR_ARGUMENT, "list = 2", [&] { grid.query_neighbors(2); });
  require_error(HG_ERR_ARGUMENT, "center", [&] { grid.query_sphere(nan, 1); });
  require_error(HG_ERR_ARGUMENT, "centers[0][1]", [&] { grid.query_spheres(1, nan, kRadii); });
  require_error(HG_ERR_NULL, "low", [&] { grid.query_boxes(1, nullptr, kCenters); });
  require_error(HG_ERR_NULL, "corners", [&] { grid.query_triangles(1, nullptr); });
  require_error(HG_ERR_NULL, "visit", [&] { grid.visit_pairs(nullptr, nullptr); });
  require_error(HG_ERR_NULL, "allocate", [] {
    const hg_allocator incomplete{};
    hgrid::check(hg_set_allocator(&incomplete));
  });
  require_chain(grid);
  hgrid::check(HG_OK);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(run<defaults_are_those_of_the_library>),
                              cmocka_unit_test(run<views_show_what_c_lends>),
                              cmocka_unit_test(run<neighbors_are_rows>),
                              cmocka_unit_test(run<a_sphere_finds_ids>),
                              cmocka_unit_test(run<spheres_find_rows>),
                              cmocka_unit_test(run<shapes_find_rows>),
                              cmocka_unit_test(run<levels_and_counters>),
                              cmocka_unit_test(run<particles_come_move_and_go>),
                              cmocka_unit_test(run<a_box_may_change>),
                              cmocka_unit_test(run<sets_replace_all>),
                              cmocka_unit_test(run<arrays_of_any_stride>),
                              cmocka_unit_test(run<vectors_stand_beside_pairs>),
                              cmocka_unit_test(run<pairs_are_copied>),
                              cmocka_unit_test(run<neighbors_are_copied>),
                              cmocka_unit_test(run<order_and_verdict>),
                              cmocka_unit_test(run<groups_and_bodies>),
                              cmocka_unit_test(run<failures_tell_status_and_text>)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
