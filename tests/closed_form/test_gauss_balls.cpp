// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// One big sphere among tiny ones on the integer lattice: the contacts are the lattice points nearer than R (Gauss).
#include "tests/support/compare.hpp"

#include <vector>

namespace {

using namespace hgtest;

// Lattice points with |x|^2 < R^2, counted in integers.
size_t points_inside(int R) {
  size_t count = 0;
  for (int x = -R; x <= R; x++) {
    for (int y = -R; y <= R; y++) {
      for (int z = -R; z <= R; z++) count += x * x + y * y + z * z < R * R ? 1 : 0;
    }
  }
  return count;
}

// Tiny spheres at all integer points of a cube that holds the ball; the big one is the last.
Particles lattice_with_ball(int R, double tiny, const double *shift) {
  Particles particles;
  for (int x = -R - 1; x <= R + 1; x++) {
    for (int y = -R - 1; y <= R + 1; y++) {
      for (int z = -R - 1; z <= R + 1; z++) {
        const double center[3] = {x + shift[0], y + shift[1], z + shift[2]};
        particles.add(center, tiny);
      }
    }
  }
  particles.add(shift, R - tiny);
  return particles;
}

// All numbers are dyadic: the sum of two radii is R exactly, and points at distance R do not count.
void require_ball(int R, double tiny, size_t expected) {
  const double shifts[][3] = {{0, 0, 0}, {-1000.5, 0.25, 1048576}};
  for (const double(&shift)[3] : shifts) {
    const Particles particles = lattice_with_ball(R, tiny, shift);
    const int32_t ball = static_cast<int32_t>(particles.count()) - 1;
    for (int32_t accuracy = HG_EXACT; accuracy <= HG_DOUBLE; accuracy++) {
      hg_grid_def def = hg_default_grid_def();
      def.accuracy = accuracy;
      const Pairs pairs = pairs_of(make_grid(def, particles));
      for (const hg_pair &pair : pairs) require(pair.b == ball, "two tiny spheres overlap");
      require(pairs.size() == expected, "R = " + std::to_string(R) + ": " + std::to_string(pairs.size()) +
                                            " contacts, expected " + std::to_string(expected));
    }
  }
}

// |x| <= R holds 7, 33, 123, 257, 515 points; 6, 6, 30, 6, 30 of them lie at R.
void known_counts(void **) {
  assert_true(holds(0, [](uint64_t) {
    const size_t inside[] = {7 - 6, 33 - 6, 123 - 30, 257 - 6, 515 - 30};
    for (int R = 1; R <= 5; R++) {
      require(points_inside(R) == inside[R - 1], "the integer count is wrong");
      for (const double tiny : {0.0, 0x1p-3, 0x1p-20}) require_ball(R, tiny, inside[R - 1]);
    }
  }));
}

void larger_balls(void **) {
  assert_true(holds(0, [](uint64_t) {
    for (const int R : {7, 13, 25}) require_ball(R, 0x1p-10, points_inside(R));
  }));
}

// The same ball as a query instead of a particle.
void sphere_query(void **) {
  assert_true(holds(0, [](uint64_t) {
    const double origin[3] = {0, 0, 0};
    for (const int R : {1, 2, 3, 4, 5, 13}) {
      Particles particles = lattice_with_ball(R, 0x1p-10, origin);
      particles.centers.resize(particles.centers.size() - 3);
      particles.radii.pop_back();
      const Grid grid = make_grid(hg_default_grid_def(), particles);
      const hgrid::View<int32_t> ids = grid.query_sphere(origin, R - 0x1p-10);
      require(ids.size() == points_inside(R), "R = " + std::to_string(R) + ": " + std::to_string(ids.size()) + " hits");
    }
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(known_counts), cmocka_unit_test(larger_balls),
                              cmocka_unit_test(sphere_query)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
