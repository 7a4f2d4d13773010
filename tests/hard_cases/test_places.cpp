// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where particles are: so far out that coordinates are coarser than radii, in a line or plane, just outside a periodic
// box, on the way through its faces, and the same set elsewhere.
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace {

using namespace hgtest;

// At 1e9 doubles are 1.2e-7 apart, so radii of 1e-6 span a few of them: the stored positions are the truth.
void tiny_radii_at_1e9(void **) {
  assert_true(holds(1, [](uint64_t seed) {
    Rng rng(seed);
    Particles particles;
    for (int i = 0; i < 600; i++) {
      const double side = i % 2 == 0 ? 1e9 : -1e9;
      const double center[3] = {side + rng.uniform(0, 2e-5), -side + rng.uniform(0, 2e-5), side + rng.uniform(0, 2e-5)};
      particles.add(center, 1e-6);
    }
    hg_grid_def def = hg_default_grid_def();
    const Grid grid = make_grid(def, particles);
    const Pairs expected = all_pairs(def, particles, exact_interact);
    require(expected.size() > 100, "too few pairs for a test");
    require_same("two clouds at 1e9", sorted_pairs_of(grid), expected);
    def.accuracy = HG_DOUBLE;
    require_same("two clouds at 1e9, HG_DOUBLE", sorted_pairs_of(make_grid(def, particles)),
                 all_pairs(def, particles, double_interact));
  }));
}

// A system without volume must not make the choice of levels divide by it.
void no_volume_gives_finite_levels(void **) {
  assert_true(holds(2, [](uint64_t seed) {
    Rng rng(seed);
    for (const double radius : {0.0, 1e-9, 1.0}) {
      for (int free_axes = 0; free_axes < 3; free_axes++) {
        Particles particles;
        for (int i = 0; i < 100; i++) {
          double center[3] = {7, -3, 5};
          for (int k = 0; k < free_axes; k++) center[k] = rng.uniform(0, 20);
          particles.add(center, radius * rng.uniform(0.5, 1));
        }
        for (const int32_t rule : {HG_LEVELS_AUTO, HG_LEVELS_PAPER}) {
          hg_grid_def def = hg_default_grid_def();
          def.level_rule = rule;
          const Grid grid = make_grid(def, particles);
          require_same("no volume", sorted_pairs_of(grid), all_pairs(def, particles, exact_interact));
          const hgrid::View<hg_level> levels = grid.query_levels();
          require(!levels.empty(), "no level");
          for (const hg_level &level : levels) {
            require(std::isfinite(level.cell_size) && std::isfinite(level.occupancy), "a level is not finite");
          }
        }
      }
    }
  }));
}

// x - L floor(x / L) of -1e-20 is L, not below it: the particle lies at both faces of the box, not outside.
void least_negative_wraps_to_the_upper_face(void **) {
  assert_true(holds(0, [](uint64_t) {
    hg_grid_def def = hg_default_grid_def();
    Particles particles;
    for (int k = 0; k < 3; k++) {
      def.periodic[k] = 1;
      def.box_max[k] = 1;
    }
    for (const double x : {-1e-20, -0x1p-1074, -0.0, 0.0, 1.0, 1 - 0x1p-53, 1 + 0x1p-52, -1.0, 2.0, 0.9, 0.1, 0.5}) {
      const double center[3] = {x, 0.5, -x};
      particles.add(center, 0.06);
    }
    require_exact("around the faces", def, particles);
    for (const double tilt : {-1e-20, 0.3, -0.5, 1.0, 41.5}) {
      def.tilt[0] = tilt;
      def.tilt[2] = -tilt;
      require_exact("around tilted faces", def, particles);
    }
  }));
}

// Two particles in contact drift through the faces of the box, tilted or not, wrapped or not: the contact never breaks.
void check_crossing(double tilt) {
  hg_grid_def def = hg_default_grid_def();
  for (int k = 0; k < 3; k++) {
    def.periodic[k] = 1;
    def.box_min[k] = -1;
    def.box_max[k] = 1;
    def.tilt[k] = tilt;
  }
  Grid grid(def);
  double centers[6] = {0, 0, 0, 0.19, 0, 0};
  const double radii[2] = {0.1, 0.1};
  grid.insert(2, centers, radii);
  for (int step = 0; step < 300; step++) {
    require_same("the contact", pairs_of(grid), {{0, 1}});
    for (int i = 0; i < 6; i++) centers[i] += 0.017 * (1 + i % 3);
    double wrapped[6];
    std::copy_n(centers, 6, wrapped);
    for (int axis = 2; axis >= 0 && step % 2 == 0; axis--) {
      for (double *x : {wrapped, wrapped + 3}) {
        double back[3] = {0, 0, 0};
        back[axis] = -std::floor((x[axis] + 1) / 2);
        move_by_cells(def, back, x);
      }
    }
    grid.move(2, wrapped);
  }
}
void contact_crosses_the_faces(void **) {
  assert_true(holds(0, [](uint64_t) {
    for (const double tilt : {0.0, 0.7, -1.0, 2.9}) check_crossing(tilt);
  }));
}

// Coordinates on a dyadic raster move by a raster vector without rounding: not a pair may change.
void dyadic_translation(void **) {
  assert_true(holds(3, [](uint64_t seed) {
    Rng rng(seed);
    const double raster = 0x1p-20;
    Particles here, there;
    double shift[3];
    for (double &s : shift) s = raster * rng.integer(-(1 << 29), 1 << 29);
    for (int i = 0; i < 400; i++) {
      double x[3], y[3];
      for (int k = 0; k < 3; k++) {
        x[k] = raster * rng.integer(0, 1 << 22);
        y[k] = x[k] + shift[k];
      }
      const double radius = raster * rng.integer(0, 1 << 19);
      here.add(x, radius);
      there.add(y, radius);
    }
    const hg_grid_def def = hg_default_grid_def();
    const Pairs pairs = sorted_pairs_of(make_grid(def, here));
    require(pairs.size() > 100, "too few pairs for a test");
    require_same("moved", sorted_pairs_of(make_grid(def, there)), pairs);
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(tiny_radii_at_1e9), cmocka_unit_test(no_volume_gives_finite_levels),
                              cmocka_unit_test(least_negative_wraps_to_the_upper_face),
                              cmocka_unit_test(contact_crosses_the_faces), cmocka_unit_test(dyadic_translation)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
