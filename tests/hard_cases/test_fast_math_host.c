/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* A host program compiled and linked with -ffast-math: it starts with subnormal numbers flushed to zero, and its
 * compiler believes that NaN does not exist. The library is not compiled so; it must see what the host cannot. */
#include "tests/support/fixture.h"

#include <stdlib.h>
#include <string.h>

#if !defined(__FAST_MATH__)
#error "this test is about hosts compiled with -ffast-math"
#endif

static double from_bits(uint64_t bits) {
  double value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

TEST(nan_and_infinity_are_refused) {
  const uint64_t bad[] = {0x7ff8000000000000u, 0x7ff0000000000001u, 0xfff8000000000000u, 0x7ff0000000000000u,
                          0xfff0000000000000u};
  hg_grid *grid = make_chain(NULL);
  size_t k;
  for (k = 0; k < sizeof bad / sizeof *bad; ++k) {
    const double center[3] = {0, from_bits(bad[k]), 0}, origin[3] = {0, 0, 0}, radius = 1, wrong = from_bits(bad[k]);
    assert_status(HG_ERR_ARGUMENT, hg_insert(grid, 1, center, &radius));
    assert_error_names("centers[0][1]");
    assert_status(HG_ERR_ARGUMENT, hg_insert(grid, 1, origin, &wrong));
    assert_error_names("radii[0]");
  }
  assert_chain(grid, 0);
  hg_destroy(grid);
}

/* Else this program would test nothing. Only x86 has start-up code that does so. */
TEST(this_host_flushes_subnormals) {
#if defined(__x86_64__)
  const volatile double least = from_bits((uint64_t)1 << 52);
  const volatile double half = least / 2;
  uint64_t bits;
  memcpy(&bits, (const void *)&half, sizeof bits);
  assert_true(bits == 0);
#else
  skip();
#endif
}

/* Spheres of radius 0.1 that touch, or miss touching by a unit in the last place, on a line. */
TEST(near_ties_are_exact) {
  enum { PAIRS = 100 };
  static double centers[6 * PAIRS], radii[2 * PAIRS];
  hg_pair expected[PAIRS];
  size_t count = 0;
  hg_grid *grid;
  int i;
  for (i = 0; i < PAIRS; ++i) {
    uint64_t reach = 0x3fe0000000000000u; /* 0.5, plus or minus up to two units in the last place */
    reach += (uint64_t)(i % 5) - 2;
    centers[6 * i + 1] = centers[6 * i + 4] = 8.0 * i;
    centers[6 * i + 3] = from_bits(reach);
    radii[2 * i] = radii[2 * i + 1] = 0.25;
    if (i % 5 < 2) {
      expected[count].a = 2 * i;
      expected[count++].b = 2 * i + 1;
    }
  }
  grid = make_grid(NULL, 2 * PAIRS, centers, radii);
  assert_pairs(grid, expected, count);
  hg_destroy(grid);
}

/* 2^-1074 apart with radii of 2^-1074: they overlap, though the host takes all of it for zero. */
TEST(subnormal_pairs_are_found) {
  double centers[9] = {0}, radii[3];
  hg_pair expected[2] = {{0, 1}, {1, 2}};
  hg_grid *grid;
  centers[3] = from_bits(1);
  centers[6] = from_bits(2);
  radii[0] = radii[1] = radii[2] = from_bits(1);
  radii[0] = from_bits(0);
  radii[1] = from_bits(2);
  radii[2] = from_bits(0);
  grid = make_grid(NULL, 3, centers, radii);
  assert_pairs(grid, expected, 2);
  hg_destroy(grid);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(this_host_flushes_subnormals), cmocka_unit_test(nan_and_infinity_are_refused),
      cmocka_unit_test(near_ties_are_exact), cmocka_unit_test(subnormal_pairs_are_found)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
