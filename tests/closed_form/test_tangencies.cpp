// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Packings of tangent spheres of all sizes whose contacts are known from how they are made.
#include "tests/support/compare.hpp"

namespace {

using namespace hgtest;

size_t contacts(const hg_grid_def &def, Particles particles, double factor) {
  for (double &r : particles.radii) r *= factor;
  return pairs_of(make_grid(def, particles)).size();
}

void require_count(const char *what, size_t count, size_t expected) {
  require(count == expected,
          std::string(what) + ": " + std::to_string(count) + " contacts, expected " + std::to_string(expected));
}

// A circle of the gasket by its curvature k and k times its centre; all are integers in the gasket (-1, 2, 2, 3).
struct Circle {
  long k, kx, ky;
};

struct Gasket {
  Particles circles;
  size_t tangencies = 0;  // the enclosing circle does not count
};

void keep(Gasket &gasket, const Circle &c, size_t tangencies) {
  const double k = static_cast<double>(c.k);
  const double center[2] = {static_cast<double>(c.kx) / k, static_cast<double>(c.ky) / k};
  gasket.circles.add(center, 1 / k);
  gasket.tangencies += tangencies;
}

// The other circle tangent to a, b, c besides `old` (Descartes, solved for the second root: it is linear in k and in
// k times the centre). It fills the gap, touches just these three, and opens three new gaps.
void fill(Gasket &gasket, const Circle &a, const Circle &b, const Circle &c, const Circle &old, long largest) {
  const Circle next = {2 * (a.k + b.k + c.k) - old.k, 2 * (a.kx + b.kx + c.kx) - old.kx,
                       2 * (a.ky + b.ky + c.ky) - old.ky};
  if (next.k > largest) return;
  const size_t enclosing = (a.k < 0 ? 1 : 0) + (b.k < 0 ? 1 : 0) + (c.k < 0 ? 1 : 0);
  keep(gasket, next, 3 - enclosing);
  fill(gasket, a, b, next, c, largest);
  fill(gasket, a, c, next, b, largest);
  fill(gasket, b, c, next, a, largest);
}

Gasket make_gasket(long largest) {
  const Circle outer = {-1, 0, 0};
  const Circle left = {2, -1, 0};
  const Circle right = {2, 1, 0};
  const Circle top = {3, 0, 2};
  Gasket gasket;
  gasket.circles.dimension = 2;
  keep(gasket, left, 0);
  keep(gasket, right, 1);
  keep(gasket, top, 2);
  fill(gasket, outer, left, right, top, largest);
  fill(gasket, outer, left, top, right, largest);
  fill(gasket, outer, right, top, left, largest);
  fill(gasket, left, right, top, outer, largest);
  return gasket;
}

// Circles that are not tangent are farther apart than reach by 1 / (2 (k1 + k2)^2) relative, since all products are
// integers: 1.2e-8 for curvatures up to 3200. So a factor 1 + 1e-9 makes contacts of the tangencies and of nothing
// else, and 1 - 1e-9 leaves none.
void apollonian_gasket(void **) {
  assert_true(holds(0, [](uint64_t) {
    hg_grid_def def = hg_default_grid_def();
    def.dimension = 2;
    for (const long largest : {3L, 30L, 3200L}) {
      const Gasket gasket = make_gasket(largest);
      for (int32_t rule = HG_LEVELS_AUTO; rule <= HG_LEVELS_PAPER; rule++) {
        def.level_rule = rule;
        require_count("gasket", contacts(def, gasket.circles, 1 + 1e-9), gasket.tangencies);
        require_count("gasket, shrunk", contacts(def, gasket.circles, 1 - 1e-9), 0);
      }
    }
    // Its first curvatures: 2, 2, 3, 3 and four times 6.
    require(make_gasket(6).circles.count() == 8, "wrong number of circles of curvature <= 6");
  }));
}

// Spheres of radius 2^-k on a line, each touching the next: all dyadic, no contact until they grow.
void dyadic_row(void **) {
  assert_true(holds(0, [](uint64_t) {
    constexpr int kCount = 45;
    Particles row;
    double x[3] = {0, 0, 0};
    double radius = 1;
    for (int k = 0; k < kCount; k++) {
      row.add(x, radius);
      x[0] += 1.5 * radius;
      radius *= 0.5;
    }
    const hg_grid_def def = hg_default_grid_def();
    require_count("row", contacts(def, row, 1), 0);
    require_count("row, grown", contacts(def, row, 1 + 0x1p-10), kCount - 1);
  }));
}

// The unit cube is cut into octants again and again towards its corner at the origin; each octant that is not cut
// holds its inscribed sphere. Spheres touch over the faces between octants of one size: 9 where one octant of the
// eight is cut, 12 at the last step. Spheres of different steps stay apart.
void dyadic_octants(void **) {
  assert_true(holds(0, [](uint64_t) {
    constexpr int kSteps = 30;
    Particles octants;
    double edge = 1;
    for (int step = 0; step < kSteps; step++) {
      edge *= 0.5;
      for (int corner = step + 1 < kSteps ? 1 : 0; corner < 8; corner++) {
        const double center[3] = {edge * ((corner & 1) + 0.5), edge * ((corner >> 1 & 1) + 0.5),
                                  edge * ((corner >> 2) + 0.5)};
        octants.add(center, 0.5 * edge);
      }
    }
    const hg_grid_def def = hg_default_grid_def();
    require_count("octants", contacts(def, octants, 1), 0);
    require_count("octants, grown", contacts(def, octants, 1 + 0x1p-20), 9 * (kSteps - 1) + 12);
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(apollonian_gasket), cmocka_unit_test(dyadic_row),
                              cmocka_unit_test(dyadic_octants)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
