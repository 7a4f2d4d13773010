// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// HG_EXACT on open axes: every size law in every arrangement gives the pairs of real arithmetic.
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

namespace {

using namespace hgtest;

void check(uint64_t seed, int dimension, Places places, size_t largest_count) {
  Rng rng(seed + 1000 * static_cast<uint64_t>(places) + 100000 * static_cast<uint64_t>(dimension));
  const Sizes sizes = static_cast<Sizes>(rng.below(kSizesCount));
  const size_t count = rng.chance(0.1) ? rng.below(4) : rng.below(largest_count + 1);
  Scene scene = open_scene(rng, dimension, count, sizes, places);
  draw_levels(rng, scene);
  require_exact(scene.name, scene.def, scene.particles);
}

template <int dimension, Places places>
void any_sizes(void **) {
  // Piles and lattices leave most of their pairs to the rationals, which are slow.
  const bool slow = places == Places::kCoincident || places == Places::kLattice;
  assert_true(sweep(slow ? 40 : 120, [=](uint64_t seed) { check(seed, dimension, places, slow ? 120 : 400); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test((any_sizes<2, Places::kUniform>)),    cmocka_unit_test((any_sizes<3, Places::kUniform>)),
      cmocka_unit_test((any_sizes<2, Places::kNegative>)),   cmocka_unit_test((any_sizes<3, Places::kNegative>)),
      cmocka_unit_test((any_sizes<2, Places::kClusters>)),   cmocka_unit_test((any_sizes<3, Places::kClusters>)),
      cmocka_unit_test((any_sizes<2, Places::kPlummer>)),    cmocka_unit_test((any_sizes<3, Places::kPlummer>)),
      cmocka_unit_test((any_sizes<2, Places::kLine>)),       cmocka_unit_test((any_sizes<3, Places::kLine>)),
      cmocka_unit_test((any_sizes<2, Places::kPlane>)),      cmocka_unit_test((any_sizes<3, Places::kPlane>)),
      cmocka_unit_test((any_sizes<2, Places::kDiagonal>)),   cmocka_unit_test((any_sizes<3, Places::kDiagonal>)),
      cmocka_unit_test((any_sizes<2, Places::kFilaments>)),  cmocka_unit_test((any_sizes<3, Places::kFilaments>)),
      cmocka_unit_test((any_sizes<2, Places::kDust>)),       cmocka_unit_test((any_sizes<3, Places::kDust>)),
      cmocka_unit_test((any_sizes<2, Places::kFilm>)),       cmocka_unit_test((any_sizes<3, Places::kFilm>)),
      cmocka_unit_test((any_sizes<2, Places::kFarPair>)),    cmocka_unit_test((any_sizes<3, Places::kFarPair>)),
      cmocka_unit_test((any_sizes<2, Places::kScales>)),     cmocka_unit_test((any_sizes<3, Places::kScales>)),
      cmocka_unit_test((any_sizes<2, Places::kOutlier>)),    cmocka_unit_test((any_sizes<3, Places::kOutlier>)),
      cmocka_unit_test((any_sizes<2, Places::kOutliers>)),   cmocka_unit_test((any_sizes<3, Places::kOutliers>)),
      cmocka_unit_test((any_sizes<2, Places::kFarOrigin>)),  cmocka_unit_test((any_sizes<3, Places::kFarOrigin>)),
      cmocka_unit_test((any_sizes<2, Places::kCoincident>)), cmocka_unit_test((any_sizes<3, Places::kCoincident>)),
      cmocka_unit_test((any_sizes<2, Places::kLattice>)),    cmocka_unit_test((any_sizes<3, Places::kLattice>))};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
