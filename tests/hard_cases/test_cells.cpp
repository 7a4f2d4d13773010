// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where cells could go wrong: faces and corners, zero and just below it, numbers of cells beyond 32 and 64 bits, one
// cell for all, levels with the same cell numbers, periodic boxes of one or two cells.
#include "tests/support/compare.hpp"
#include "tests/support/rng.hpp"

#include <cmath>
#include <initializer_list>
#include <limits>

namespace {

using namespace hgtest;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double below(double x) { return std::nextafter(x, -kInfinity); }
double above(double x) { return std::nextafter(x, kInfinity); }

hg_grid_def with_cells(const double *cells, int count) {
  hg_grid_def def = hg_default_grid_def();
  def.level_rule = HG_LEVELS_USER;
  def.level_count = count;
  def.cell_sizes = cells;
  return def;
}

// Centres on the faces, edges and corners of cells of both levels, and one unit in the last place off them.
void faces_and_corners(void **) {
  assert_true(holds(0, [](uint64_t) {
    const double cells[] = {0.5, 2};
    Particles particles;
    for (int corner = 0; corner < 27; corner++) {
      const int c[3] = {corner % 3 - 1, corner / 3 % 3 - 1, corner / 9 - 1};
      for (int side = -1; side <= 1; side++) {
        double x[3];
        for (int k = 0; k < 3; k++) x[k] = side < 0 ? below(2.0 * c[k]) : side > 0 ? above(2.0 * c[k]) : 2.0 * c[k];
        particles.add(x, 0.25);
        particles.add(x, 1);
      }
    }
    require_exact("faces and corners", with_cells(cells, 2), particles);
  }));
}

// The coarsest cells hold the largest particle, but not with its margin.
void margin_wider_than_the_coarsest_cells(void **) {
  assert_true(sweep(20, [](uint64_t seed) {
    Rng rng(seed);
    const double cells[] = {0.5, 2};
    hg_grid_def def = with_cells(cells, 2);
    def.interaction = rng.chance(0.5) ? HG_CONTACT : HG_MAX_RANGE;
    def.margin = rng.uniform(0, 3);
    def.skin = rng.chance(0.5) ? 0.2 : 0;
    const double largest = def.interaction == HG_CONTACT ? 1 : 2;
    Particles particles;
    for (int i = 0; i < 200; i++) {
      const double x[3] = {rng.uniform(0, 20), rng.uniform(0, 20), rng.uniform(0, 20)};
      particles.add(x, i == 0 ? largest : rng.uniform(0.1, largest));
    }
    require_exact("wide margin", def, particles);
  }));
}

// The cell of -0.0 is that of 0.0, the cell of the least negative number is the one below.
void negative_zero_and_below(void **) {
  assert_true(holds(0, [](uint64_t) {
    const double cells[] = {1};
    const double at[] = {-0.0, 0.0, -0x1p-1074, 0x1p-1074, -1e-300, -1.0, 1.0, below(1.0), above(-1.0)};
    Particles particles;
    for (const double x : at) {
      for (const double y : {-0.0, 0.0, -1e-20}) {
        const double center[3] = {x, y, -y};
        particles.add(center, 0.5);
      }
    }
    require_exact("around zero", with_cells(cells, 1), particles);
  }));
}

// floor(0.3 / 0.1) = 2 but floor(0.3 * 10) = 3: equal spheres just below such faces lie one or two cells apart,
// depending on which of the two a search takes for the particle and which for its window.
void quotients_that_round_across_a_face(void **) {
  assert_true(holds(0, [](uint64_t) {
    for (const double edge : {0.1, 0.7, 1.0 / 3, 1e-3}) {
      const double cells[] = {edge};
      hg_grid_def def = with_cells(cells, 1);
      def.dimension = 2;
      Particles particles;
      particles.dimension = 2;
      for (int face = 1; face < 120; face++) {
        const double y = 10.0 * edge * face;
        for (const double x : {below(face * edge), face * edge, below((face + 1) * edge), below((face + 2) * edge)}) {
          const double center[2] = {x, y};
          particles.add(center, 0.5 * edge);
        }
      }
      require_exact("faces of cells of edge " + std::to_string(edge), def, particles);
    }
  }));
}

// Pairs so far apart that a cell number takes 31, 32, 53, 62, 63, 64 and 1000 bits.
void indices_beyond_2_31_and_2_62(void **) {
  assert_true(holds(0, [](uint64_t) {
    for (const int bits : {31, 32, 53, 62, 63, 64, 1000}) {
      const double cells[] = {1, 4};
      hg_grid_def def = with_cells(cells, 2);
      Particles particles;
      for (const double side : {-1.0, 0.0, 1.0}) {
        for (int i = 0; i < 12; i++) {
          const double far = side * std::ldexp(1, bits);
          const double center[3] = {far + 0.75 * (i % 3), -far + 0.75 * (i / 3 % 2),
                                    far + 0.75 * static_cast<double>(i / 6)};
          particles.add(center, i % 4 == 0 ? 2 : 0.5);
        }
      }
      require_exact("indices of " + std::to_string(bits) + " bits", def, particles);
      def.level_rule = HG_LEVELS_AUTO;
      def.level_count = 0;
      require_exact("indices of " + std::to_string(bits) + " bits, own choice of levels", def, particles);
    }
  }));
}

void all_in_one_cell(void **) {
  assert_true(holds(3, [](uint64_t seed) {
    Rng rng(seed);
    const double cells[] = {1e6};
    Particles particles;
    for (int i = 0; i < 400; i++) {
      const double center[3] = {rng.uniform(), rng.uniform(), rng.uniform()};
      particles.add(center, rng.uniform(0, 0.1));
    }
    require_exact("one cell", with_cells(cells, 1), particles);
  }));
}

// On each of three levels the particles fill cells with the same three numbers.
void equal_cell_numbers_on_several_levels(void **) {
  assert_true(holds(4, [](uint64_t seed) {
    Rng rng(seed);
    const double cells[] = {0x1p-10, 1, 0x1p10};
    Particles particles;
    for (const double cell : cells) {
      for (int i = 0; i < 150; i++) {
        double center[3];
        for (double &x : center) x = cell * rng.uniform(-3, 3);
        particles.add(center, 0.5 * cell);
      }
    }
    require_exact("equal numbers", with_cells(cells, 3), particles);
  }));
}

// Cells as long as the box, tilted or not, half as long, longer, and of lengths that do not divide it.
void periodic_boxes_of_few_cells(void **) {
  assert_true(sweep(40, [](uint64_t s) {
    Rng rng(s);
    for (const double cell : {1.0, 0.5, 10.0, 0.7, 0.3}) {
      const double cells[] = {0.25 * cell, cell};
      hg_grid_def def = with_cells(cells, 2);
      def.dimension = rng.integer(2, 3);
      Particles particles;
      particles.dimension = def.dimension;
      for (int k = 0; k < def.dimension; k++) {
        def.periodic[k] = rng.chance(0.8) ? 1 : 0;
        def.box_max[k] = 1;
      }
      const bool tilted = rng.chance(0.5) && def.periodic[0] + def.periodic[1] == 2;
      if (tilted) def.tilt[0] = rng.chance(0.5) ? 0.25 * rng.integer(-8, 8) : rng.uniform(-3, 3);
      if (tilted && def.periodic[2] != 0) def.tilt[2] = rng.uniform(-3, 3);
      for (int i = 0; i < 30; i++) {
        double center[3];
        for (double &x : center) x = rng.chance(0.2) ? rng.integer(-2, 2) * 0.5 : rng.uniform(-1, 2);
        particles.add(center, std::fmin(0.25, 0.5 * cell) * (rng.chance(0.3) ? 1 : rng.uniform()));
      }
      require_exact("cells of " + std::to_string(cell) + " in a box of 1", def, particles);
    }
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(faces_and_corners),
                              cmocka_unit_test(margin_wider_than_the_coarsest_cells),
                              cmocka_unit_test(negative_zero_and_below),
                              cmocka_unit_test(quotients_that_round_across_a_face),
                              cmocka_unit_test(indices_beyond_2_31_and_2_62),
                              cmocka_unit_test(all_in_one_cell),
                              cmocka_unit_test(equal_cell_numbers_on_several_levels),
                              cmocka_unit_test(periodic_boxes_of_few_cells)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
