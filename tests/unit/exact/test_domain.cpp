// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where positions lie in a periodic box: comparing where a quotient is not needed, and the same places with and without
// it; in a cell of any edges, with the edges that were taken off, in rational numbers. The numbers of periodic images,
// and sets of them.
#include "src/exact/domain.hpp"
#include "tests/unit/cells.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/exact_place.hpp"

#include <algorithm>
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

// The sum of the sizes of what is added up on each axis, in box lengths, once the edges are known that are taken off.
std::array<mpq_class, 3> lengths_added(const hg::Domain &domain, const double *center, const hg::Shift &taken) {
  std::array<mpq_class, 3> lengths;
  for (int axis = 0; axis < domain.dimension; axis++) {
    if (!domain.periodic[axis]) continue;
    mpq_class sum = abs(mpq_class(center[axis]) - mpq_class(domain.box_min[axis]));
    for (int edge = axis + 1; edge < domain.dimension; edge++) {
      sum += abs(taken.n[edge] * exact_edge(domain, edge, axis));
    }
    lengths[axis] = sum / exact_edge(domain, axis, axis);
  }
  return lengths;
}

// A place and the edges that were taken off are the centre, but for what wrapping may err.
void check_taken_in(uint64_t seed) {
  Rng rng(seed);
  const hg::Domain domain = any_cell(rng);
  for (int n = 0; n < 10; n++) {
    double center[3], place[3];
    any_center(rng, domain, center);
    const hg::Shift taken = domain.take_in(center, place);
    require(same_shift(taken, domain.boxes(center)), "other boxes");
    for (int axis = 0; axis < domain.dimension; axis++) {
      const double length = domain.length[axis];
      if (!domain.periodic[axis]) {
        require(place[axis] == center[axis] && taken.n[axis] == 0, "axis %d, which is open: %a", axis, place[axis]);
        continue;
      }
      require(place[axis] >= 0 && place[axis] <= length, "axis %d: %a of %a", axis, place[axis], length);
      const mpq_class from_low = mpq_class(center[axis]) - mpq_class(domain.box_min[axis]);
      const mpq_class error = (mpq_class(place[axis]) + exact_shift(domain, axis, taken) - from_low) / length;
      require(abs(error) < mpq_class(3 * 0x1p-33), "axis %d: %a is off by %g lengths", axis, center[axis],
              error.get_d());
    }
  }
}

// How far outside a centre lies: whole boxes where no tilt moves it, else all that is added up; on the axis where that
// is most.
void check_outside(uint64_t seed) {
  Rng rng(seed);
  const hg::Domain domain = any_cell(rng);
  for (int n = 0; n < 10; n++) {
    double center[3], place[3];
    any_center(rng, domain, center);
    const hg::Shift taken = domain.take_in(center, place);
    const auto added = lengths_added(domain, center, taken);
    const hg::Domain::Outside found = domain.outside(center);
    require(found.axis >= 0 && found.axis < domain.dimension, "axis %d", found.axis);
    double most = 0;
    for (size_t axis = 0; axis < 3; axis++) {
      most = std::max(most, domain.is_tilted() ? added[axis].get_d() : std::abs(static_cast<double>(taken.n[axis])));
    }
    const double there = domain.is_tilted() ? added[static_cast<size_t>(found.axis)].get_d()
                                            : std::abs(static_cast<double>(taken.n[found.axis]));
    require(std::fabs(found.boxes - most) <= 1e-9 * most, "%g lengths outside instead of %g", found.boxes, most);
    require(std::fabs(there - most) <= 1e-9 * most, "axis %d is not where it lies outside most", found.axis);
  }
}

// Far beyond what is allowed, also where numbers overflow.
void check_far_outside(uint64_t) {
  hg::Domain domain = open_space(3);
  for (int axis = 0; axis < 3; axis++) set_box(domain, axis, 1, 2);
  require(domain.most_outside() == 0x1p20, "most outside a box: %g", domain.most_outside());
  const auto boxes = [&](double x, double y, double z) {
    const double center[3] = {x, y, z};
    return domain.outside(center);
  };
  require(boxes(1.5, 1.5, 1.5).boxes == 0 && boxes(1, 1, 1).boxes == 0, "inside");
  require(boxes(1.5, 1 + 0x1p20, 1.5).boxes == 0x1p20 && boxes(1.5, 1 + 0x1p20, 1.5).axis == 1, "at the limit");
  require(boxes(1.5, 1.5, 2 + 0x1p20).boxes > domain.most_outside(), "beyond the limit");
  require(boxes(1.7e308, 1.5, 1.5).boxes > 1e300 && boxes(-1.7e308, 1.5, 1.5).boxes > 1e300, "very far");
  set_tilt(domain, 2, 0, 4);
  require(domain.most_outside() == 0x1p19, "most outside a tilted cell: %g", domain.most_outside());
  const hg::Domain::Outside sheared = boxes(1.5, 1.5, 1.5 + 0x1p18);
  require(sheared.axis == 0 && sheared.boxes == 0x1p20 + 0.5, "tilts do not count: %g on axis %d", sheared.boxes,
          sheared.axis);
  require(boxes(1.5, 1.5, 1.7e308).boxes > 1e300 && boxes(1.5, 1.5, -1.7e308).boxes > 1e300,
          "very far in a tilted cell");
}

void check_shifted(uint64_t seed) {
  Rng rng(seed);
  const hg::Domain domain = any_cell(rng);
  const hg::Shift shift = any_shift(rng, domain, 1 << rng.integer(0, 20));
  for (int axis = 0; axis < domain.dimension; axis++) {
    mpq_class size = 0;
    for (int edge = axis; edge < domain.dimension; edge++) size += abs(shift.n[edge] * exact_edge(domain, edge, axis));
    const mpq_class moved = exact_shift(domain, axis, shift), most = size * mpq_class(5 * 0x1p-53);
    require(abs(mpq_class(domain.shifted(axis, shift)) - moved) <= most, "axis %d: shifted by %a instead of %a", axis,
            domain.shifted(axis, shift), moved.get_d());
    require(abs(mpq_class(domain.shift_size(axis, shift)) - size) <= most, "axis %d: a size of %a instead of %a", axis,
            domain.shift_size(axis, shift), size.get_d());
  }
}

void taken_in(void **) { assert_true(sweep(2000, check_taken_in)); }
void outside(void **) { assert_true(sweep(2000, check_outside)); }
void far_outside(void **) { assert_true(holds(0, check_far_outside)); }
void shifted(void **) { assert_true(sweep(3000, check_shifted)); }

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
  const CMUnitTest tests[] = {cmocka_unit_test(near_places), cmocka_unit_test(taken_in),
                              cmocka_unit_test(outside),     cmocka_unit_test(far_outside),
                              cmocka_unit_test(shifted),     cmocka_unit_test(image_numbers),
                              cmocka_unit_test(image_sets)};
  return cmocka_run_group_tests_name("domain", tests, nullptr, nullptr);
}
