// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The baseline searches and the library against a comparison of all pairs, on packings of all laws.
#include "packing/packing.hpp"
#include "packing/random.hpp"
#include "particles/insert.hpp"
#include "programs/bench/hashed_grid.hpp"
#include "programs/bench/hierarchical_grid.hpp"
#include "programs/bench/linked_cell.hpp"
#include "programs/bench/pair_sets.hpp"
#include "tests/support/frame.h"

#include <hgrid/hgrid.hpp>

#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace {

using packing::Law;

constexpr uint64_t kSeed = 99;

bench::Particles view(const particles::ParticleSet &set) { return {set.count(), set.centers.data(), set.radii.data()}; }

std::vector<hg_pair> all_pairs(const particles::ParticleSet &set) {
  const size_t d = static_cast<size_t>(set.dimension);
  std::vector<hg_pair> pairs;
  for (size_t i = 0; i < set.count(); i++) {
    for (size_t j = i + 1; j < set.count(); j++) {
      const double *x = &set.centers[i * d], *y = &set.centers[j * d];
      double square = (x[0] - y[0]) * (x[0] - y[0]) + (x[1] - y[1]) * (x[1] - y[1]);
      if (d == 3) square = square + (x[2] - y[2]) * (x[2] - y[2]);
      const double sum = set.radii[i] + set.radii[j];
      if (square < sum * sum) pairs.push_back({static_cast<int32_t>(i), static_cast<int32_t>(j)});
    }
  }
  return pairs;
}

std::vector<hg_pair> sorted(const std::vector<hg_pair> &pairs) { return bench::sorted(pairs.data(), pairs.size()); }

bool same(const char *what, const std::vector<hg_pair> &expected, const std::vector<hg_pair> &found) {
  const size_t odd = bench::differences(expected, sorted(found)).size();
  if (odd == 0) return true;
  std::fprintf(stderr, "%s, seed %llu: %zu pairs found, %zu expected, %zu differ\n", what,
               static_cast<unsigned long long>(kSeed), found.size(), expected.size(), odd);
  return false;
}

// Levels that double in size up to the largest diameter.
std::vector<double> doubling_sizes(const particles::ParticleSet &set) {
  const double largest = 2 * *std::max_element(set.radii.begin(), set.radii.end());
  std::vector<double> sizes;
  for (int k = 0; std::ldexp(2.5, k) < largest; k++) sizes.push_back(std::ldexp(2.5, k));
  sizes.push_back(largest);
  return sizes;
}

std::vector<hg_pair> library_pairs(const particles::ParticleSet &set, std::vector<double> &sizes) {
  hg_grid_def def = hg_default_grid_def();
  def.dimension = set.dimension;
  def.accuracy = HG_DOUBLE;
  def.level_rule = HG_LEVELS_PAPER;
  hgrid::Grid grid(def);
  particles::insert(set, grid);
  sizes.clear();
  for (const hg_level &level : grid.query_levels()) sizes.push_back(level.cell_size);
  const hgrid::View<hg_pair> pairs = grid.query_pairs();
  return std::vector<hg_pair>(pairs.begin(), pairs.end());
}

bool same_from_hashed_grid(const particles::ParticleSet &set, const std::vector<hg_pair> &expected,
                           const std::vector<double> &paper_sizes) {
  int64_t tested = 0;
  return same("hashed grid", expected, bench::hashed_grid_pairs(view(set), paper_sizes, &tested)) &&
         same("hashed grid, doubling", expected, bench::hashed_grid_pairs(view(set), doubling_sizes(set), nullptr)) &&
         tested >= static_cast<int64_t>(expected.size()) &&
         tested <= static_cast<int64_t>(set.count() * (set.count() - 1) / 2);
}

bool all_agree(const particles::ParticleSet &set) {
  const std::vector<hg_pair> expected = all_pairs(set);
  std::vector<double> paper_sizes;
  int64_t one_level = 0, many_levels = 0;
  const bool good = !expected.empty() && same("library", expected, library_pairs(set, paper_sizes)) &&
                    same("linked cells", expected, bench::linked_cell_pairs(set.dimension, view(set), &one_level)) &&
                    same("hierarchical grid", expected,
                         bench::hierarchical_grid_pairs(set.dimension, view(set), paper_sizes, &many_levels)) &&
                    same("hierarchical grid, doubling", expected,
                         bench::hierarchical_grid_pairs(set.dimension, view(set), doubling_sizes(set), nullptr)) &&
                    (set.dimension == 2 || same_from_hashed_grid(set, expected, paper_sizes));
  const int64_t all = static_cast<int64_t>(set.count() * (set.count() - 1) / 2);
  const int64_t found = static_cast<int64_t>(expected.size());
  return good && one_level >= found && one_level <= all && many_levels >= found && many_levels <= all;
}

particles::ParticleSet packed(Law law, double ratio, int dimension) {
  packing::Request request;
  request.law = {law, ratio, dimension};
  request.count = 3000;
  request.density = 0.6;
  request.seed = kSeed;
  request.sweeps = 10;
  return packing::make_packing(request, nullptr).particles;
}

bool all_laws_agree(int dimension) {
  return all_agree(packed(Law::kMono, 1, dimension)) && all_agree(packed(Law::kTwoSizes, 8, dimension)) &&
         all_agree(packed(Law::kUniformSize, 20, dimension)) && all_agree(packed(Law::kUniformVolume, 20, dimension));
}

bool searches_agree_on_spheres() { return all_laws_agree(3); }

bool searches_agree_on_disks() { return all_laws_agree(2); }

// A sparse cloud needs far more cells than particles, one coordinate may be the same for all, and cells meet at faces.
bool hard_places_agree() {
  packing::Random random(kSeed);
  particles::ParticleSet set;
  for (int k = 0; k < 500; k++) {
    const double far = k % 2 == 0 ? 0 : 1e7;
    for (int axis = 0; axis < 2; axis++) set.centers.push_back(far + static_cast<double>(random.below(32)));
    set.centers.push_back(-3);
    set.radii.push_back(0.5 + static_cast<double>(random.below(3)));
  }
  return all_agree(set);
}

bool edge_cases() {
  const particles::ParticleSet none;
  particles::ParticleSet points;
  points.centers = {0, 0, 0, 0, 0, 0};
  points.radii = {0, 0};
  particles::ParticleSet touching;
  touching.centers = {0, 0, 0, 2, 0, 0};
  touching.radii = {1, 1};
  const std::vector<double> sizes = {2};
  return bench::linked_cell_pairs(3, view(none), nullptr).empty() &&
         bench::linked_cell_pairs(3, view(points), nullptr).empty() &&
         bench::linked_cell_pairs(3, view(touching), nullptr).empty() &&
         bench::hierarchical_grid_pairs(3, view(none), {}, nullptr).empty() &&
         bench::hierarchical_grid_pairs(3, view(touching), sizes, nullptr).empty() &&
         bench::hashed_grid_pairs(view(none), {}, nullptr).empty() &&
         bench::hashed_grid_pairs(view(touching), sizes, nullptr).empty();
}

template <class Search>
bool refuses_small_cells(Search search) {
  particles::ParticleSet set;
  set.centers = {0, 0, 0};
  set.radii = {1};
  try {
    search(view(set), std::vector<double>{1.5});
  } catch (const std::invalid_argument &) {
    return true;
  }
  return false;
}

void cells_smaller_than_particles(void **) {
  const bool sorted = refuses_small_cells([](const bench::Particles &particles, const std::vector<double> &sizes) {
    bench::hierarchical_grid_pairs(3, particles, sizes, nullptr);
  });
  const bool hashed = refuses_small_cells([](const bench::Particles &particles, const std::vector<double> &sizes) {
    bench::hashed_grid_pairs(particles, sizes, nullptr);
  });
  assert_true(sorted);
  assert_true(hashed);
}

bool differences_are_found() {
  const std::vector<hg_pair> one = {{0, 1}, {0, 2}, {3, 4}}, other = {{0, 1}, {3, 4}, {3, 5}};
  particles::ParticleSet set;
  set.centers = {0, 0, 0, 2, 0, 0, 2.0000001, 0, 0};
  set.radii = {1, 1, 1};
  const std::vector<hg_pair> twice = {{0, 1}, {0, 1}};
  return bench::differences(one, other).size() == 2 && bench::differences(one, one).empty() &&
         bench::differences(twice, {{0, 1}}).size() == 1 && bench::touch_within(set, {0, 1}, bench::kDoubleRounding) &&
         !bench::touch_within(set, {0, 2}, bench::kDoubleRounding);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<searches_agree_on_spheres>), cmocka_unit_test(passes<searches_agree_on_disks>),
      cmocka_unit_test(passes<hard_places_agree>),         cmocka_unit_test(passes<edge_cases>),
      cmocka_unit_test(cells_smaller_than_particles),      cmocka_unit_test(passes<differences_are_found>),
  };
  return cmocka_run_group_tests_name("baselines", tests, nullptr, nullptr);
}
