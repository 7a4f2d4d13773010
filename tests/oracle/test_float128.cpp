// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// 113 bits are not enough: ordinary spheres, touching up to 1e-34, that quadruple precision takes for touching and that
// do overlap. Differences and squares of such doubles are exact in 113 bits, the sum of two squares is not.
#include "oracle/exact_set.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/frame.h"

namespace {

using namespace hgtest;

struct Case {
  double reach, x, y;
};
constexpr Case kCases[] = {{0x1.5994905021b0ap+0, 0x1.5994905021b09p+0, 0x1.a4a39251dc7f1p-26},
                           {0x1.bf0f5bd62d396p+0, 0x1.bf0f5bd62d393p+0, 0x1.9e5500792ecc4p-25},
                           {0x1.dbd5e0d6e5d3fp+0, 0x1.dbd5e0d6e5d3dp+0, 0x1.5d04b91fc2011p-25}};

Particles two_spheres(const Case &c) {
  Particles particles;
  const double origin[3] = {0, 0, 0}, other[3] = {c.x, c.y, 0};
  particles.add(origin, 0.5 * c.reach);
  particles.add(other, 0.5 * c.reach);
  return particles;
}

oracle::Set set_of(const Particles &particles) {
  oracle::Set set;
  set.centers = particles.centers;
  set.radii = particles.radii;
  return set;
}

void quadruple_precision_is_not_enough(void **) {
  assert_true(holds(0, [](uint64_t) {
    for (const Case &c : kCases) {
      const Particles particles = two_spheres(c);
      const oracle::Set set = set_of(particles);
      require(overlapping_pairs(set, oracle::Arithmetic::kWhole).size() == 1, "whole numbers see no overlap");
      require(overlapping_pairs(set, oracle::Arithmetic::kFloat128).empty(), "113 bits were enough");
      require_same("library", pairs_of(make_grid(hg_default_grid_def(), particles)), {{0, 1}});
    }
  }));
}

// Coordinates far apart in size: already the difference takes more than 113 bits.
void differences_need_more_than_113_bits(void **) {
  assert_true(holds(0, [](uint64_t) {
    Particles particles;
    const double a[3] = {1, 0, 0}, b[3] = {0x1p-120, 0, 0};
    particles.add(a, 0.5);
    particles.add(b, 0.5);
    const oracle::Set set = set_of(particles);
    require(overlapping_pairs(set, oracle::Arithmetic::kWhole).size() == 1, "whole numbers see no overlap");
    require(overlapping_pairs(set, oracle::Arithmetic::kFloat128).empty(), "113 bits were enough");
    require_same("library", pairs_of(make_grid(hg_default_grid_def(), particles)), {{0, 1}});
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(quadruple_precision_is_not_enough),
                              cmocka_unit_test(differences_need_more_than_113_bits)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
