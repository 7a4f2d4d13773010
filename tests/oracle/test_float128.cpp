// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// 113 bits are not enough: ordinary spheres, touching up to 1e-34, that quadruple precision takes for touching and that
// do overlap. Differences and squares of such doubles are exact in 113 bits, the sum of two squares is not.
#include "tests/oracle/whole_numbers.hpp"
#include "tests/support/compare.hpp"

namespace {

using namespace hgtest;

using Quadruple = __float128;

int quadruple_interact(const hg_grid_def &, const Sphere &a, const Sphere &b) {
  Quadruple square = 0;
  for (int axis = 0; axis < 3; axis++) {
    const Quadruple d = static_cast<Quadruple>(a.center[axis]) - b.center[axis];
    square += d * d;
  }
  const Quadruple reach = static_cast<Quadruple>(a.radius) + b.radius;
  return square < reach * reach ? 1 : 0;
}

// One pair, to all but 113 bits.
void check(const double *origin, const double *other, double radius) {
  const hg_grid_def def = hg_default_grid_def();
  const Pairs both = {{0, 1}};
  Particles particles;
  particles.add(origin, radius);
  particles.add(other, radius);
  require_same("whole numbers", whole_number_pairs(def, particles), both);
  require_same("oracle", all_pairs(def, particles, exact_interact), both);
  require_same("library", pairs_of(make_grid(def, particles)), both);
  require(all_pairs(def, particles, quadruple_interact).empty(), "113 bits were enough");
}

struct Case {
  double reach, x, y;
};
constexpr Case kCases[] = {{0x1.5994905021b0ap+0, 0x1.5994905021b09p+0, 0x1.a4a39251dc7f1p-26},
                           {0x1.bf0f5bd62d396p+0, 0x1.bf0f5bd62d393p+0, 0x1.9e5500792ecc4p-25},
                           {0x1.dbd5e0d6e5d3fp+0, 0x1.dbd5e0d6e5d3dp+0, 0x1.5d04b91fc2011p-25}};

void quadruple_precision_is_not_enough(void **) {
  assert_true(holds(0, [](uint64_t) {
    const double origin[3] = {0, 0, 0};
    for (const Case &c : kCases) {
      const double other[3] = {c.x, c.y, 0};
      check(origin, other, 0.5 * c.reach);
    }
  }));
}

// Coordinates far apart in size: already the difference takes more than 113 bits.
void differences_need_more_than_113_bits(void **) {
  assert_true(holds(0, [](uint64_t) {
    const double a[3] = {1, 0, 0}, b[3] = {0x1p-120, 0, 0};
    check(a, b, 0.5);
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(quadruple_precision_is_not_enough),
                              cmocka_unit_test(differences_need_more_than_113_bits)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
