// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Boxes that a particle touches by less than doubles tell. Random ones are those of property/test_shapes.
#include "src/exact/box_overlap.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/domains.hpp"

#include <cmath>
#include <limits>

namespace {

using namespace hgtest;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool meets(const hg::Domain &domain, bool touching, double low, double high, double x, double radius) {
  const double lows[2] = {low, -kInfinity}, highs[2] = {high, kInfinity}, center[2] = {x, 0};
  return hg::BoxOverlap({HG_CONTACT, 0, touching}, domain).holds({lows, highs}, {center, radius});
}

// Doubles take the image beyond the box for the nearest: (low + high) / 2 - x seems to be half a length.
void images_that_seem_equally_near(void **) {
  assert_true(holds(0, [](uint64_t) {
    hg::Domain domain = open_space(2);
    set_box(domain, 0, 0, 1, true);
    const double high = 1 - 0x1p-53;
    require(meets(domain, true, 0.5, high, 0.25, 0.25), "the nearer image touches");
    require(!meets(domain, false, 0.5, high, 0.25, 0.25), "touching is no meeting");
    require(!meets(domain, true, 0.5, high, 0.25, 0.25 - 0x1p-54), "neither touches");
    require(!meets(domain, true, 0.5, high, 0.25 - 0x1p-54, 0.25), "an image a bit farther away");
  }));
}

void numbers_without_squares(void **) {
  assert_true(holds(0, [](uint64_t) {
    const hg::Domain domain = open_space(2);
    const double least = 0x1p-1074, greatest = std::numeric_limits<double>::max();
    require(meets(domain, true, least, 1, 0, least) && !meets(domain, false, least, 1, 0, least), "subnormal radii");
    require(meets(domain, false, least, 1, least, 0) && !meets(domain, true, least, 1, 0, 0), "subnormal places");
    require(meets(domain, false, 1e200, kInfinity, 0, 1.1e200) && !meets(domain, true, 1e200, kInfinity, 0, 1e199),
            "squares that overflow");
    require(!meets(domain, true, greatest, greatest, -greatest, greatest), "distances that overflow");
    require(meets(domain, true, -kInfinity, -1, 0, 1) && !meets(domain, false, 1, kInfinity, 0, 1), "half of space");
    require(meets(domain, false, -0.0, 0.0, 0, 0) && meets(domain, false, 0.0, 0.0, -0.0, 0), "both zeros are one");
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(images_that_seem_equally_near),
                              cmocka_unit_test(numbers_without_squares)};
  return cmocka_run_group_tests_name("box_overlap", tests, nullptr, nullptr);
}
