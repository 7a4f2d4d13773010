// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where positions lie in a periodic box: comparing where a quotient is not needed, and the same places with and without
// it. The numbers of periodic images, and sets of them.
#include "src/exact/domain.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/exact_place.hpp"

#include <cmath>

namespace {

using namespace hgtest;

// A length of any size, and a place near one of the faces of the box or of its neighbours, or anywhere around.
struct Place {
  explicit Place(Rng &rng) {
    length = std::ldexp(rng.chance(0.3) ? 1 : rng.uniform(1, 2),
                        rng.chance(0.7) ? rng.integer(-30, 30) : rng.integer(-1074, 1000));
    above = rng.chance(0.5) ? length * rng.integer(-3, 3) : length * rng.uniform(-3, 3);
    for (int n = rng.integer(0, 2); n > 0; n--) above = std::nextafter(above, rng.chance(0.5) ? -INFINITY : INFINITY);
    if (rng.chance(0.1)) above = std::ldexp(rng.uniform(-1, 1), rng.integer(-1074, 0));
  }
  double length, above;
};

void check_place(uint64_t seed) {
  Rng rng(seed);
  const Place p(rng);
  const mpz_class boxes = floor_of(mpq_class(p.above) / mpq_class(p.length));
  const bool near = hg::are_near_box(p.above, p.above, 0, p.length);
  require(near == (boxes >= -1 && boxes <= 1), "%a of %a is %s", p.above, p.length, near ? "near" : "far");
  if (!near) return;
  const double found = hg::boxes_above(p.above, p.length);
  require(mpz_class(found) == boxes, "%a of %a is %g boxes above", p.above, p.length, found);
  const double place = hg::place_in_box(p.above, 0, p.length), quick = hg::near_place_in_box(p.above, 0, p.length);
  require(place >= 0 && place <= p.length, "%a of %a is put at %a", p.above, p.length, place);
  require(place == quick, "%a of %a: %a and %a", p.above, p.length, place, quick);
}

void near_places(void **) { assert_true(sweep(20000, check_place)); }

void image_numbers(void **) {
  assert_true(holds(0, [](uint64_t) {
    require(hg::make_image(0, 0, 0) == hg::kImages / 2, "no step");
    for (int z = -1; z <= 1; z++) {
      for (int y = -1; y <= 1; y++) {
        for (int x = -1; x <= 1; x++) {
          const hg::Image image = hg::make_image(x, y, z);
          require(hg::image_step(image, 0) == x && hg::image_step(image, 1) == y && hg::image_step(image, 2) == z,
                  "image %d is not (%d, %d, %d)", image, x, y, z);
        }
      }
    }
  }));
}

bool contains(hg::ImageSet set, hg::Image image) { return (set >> image & 1) != 0; }

void image_sets(void **) {
  assert_true(holds(0, [](uint64_t) {
    for (hg::Image image = 0; image < 32; image++) {
      const bool exists = image < hg::kImages;
      const int x = hg::image_step(image, 0), y = hg::image_step(image, 1), z = hg::image_step(image, 2);
      const int last_step = z != 0 ? z : (y != 0 ? y : x);
      require(contains(hg::kForwardImages, image) == (exists && last_step > 0), "image %d forward", image);
      require(contains(hg::kBackwardImages, image) == (exists && last_step < 0), "image %d backward", image);
      for (int axis = 0; axis < 3; axis++) {
        for (int step = -1; step <= 1; step++) {
          require(
              contains(hg::kImagesWithStep[axis][step + 1], image) == (exists && hg::image_step(image, axis) == step),
              "image %d and step %d on axis %d", image, step, axis);
        }
      }
    }
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(near_places), cmocka_unit_test(image_numbers),
                              cmocka_unit_test(image_sets)};
  return cmocka_run_group_tests_name("domain", tests, nullptr, nullptr);
}
