// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Fixed-point coordinates against rational numbers, for extents and distances from the origin of all sizes; and those
// that wrap.
#include "src/space/fixed_point.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/domains.hpp"
#include "tests/unit/exact_place.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace hgtest;
using hg::Bounds;
using hg::Domain;
using hg::FixedPoint;

// What a map makes of a centre on one axis, where no tilt moves it.
template <class Found, class Find>
Found on_axis(int axis, double center, Find &&find) {
  double x[3] = {0, 0, 0};
  Found found[3];
  x[axis] = center;
  find(x, found);
  return found[axis];
}
double place_of(const FixedPoint &map, int axis, double center) {
  return on_axis<double>(axis, center, [&](const double *x, double *found) { map.find_place(x, 3, found); });
}
int32_t coordinate_of(const FixedPoint &map, int axis, double center) {
  return on_axis<int32_t>(axis, center, [&](const double *x, int32_t *found) { map.find_coordinates(x, 3, found); });
}

// Points along each axis, and the map over them.
struct Scene {
  Domain domain;
  Bounds bounds;
  double least_extent = 0;
  std::vector<double> points[3];
};

void set_bounds(Scene &scene) {
  for (int axis = 0; axis < scene.domain.dimension; axis++) {
    scene.bounds.min[axis] = scene.bounds.max[axis] = scene.points[axis][0];
    for (double x : scene.points[axis]) {
      scene.bounds.min[axis] = std::min(scene.bounds.min[axis], x);
      scene.bounds.max[axis] = std::max(scene.bounds.max[axis], x);
    }
  }
}

void require_map(const Scene &scene) {
  const FixedPoint map = FixedPoint::over(scene.bounds, scene.domain, scene.least_extent);
  int exponent = 0;
  require(std::frexp(map.scale, &exponent) == 0.5, "the scale %a is no power of two", map.scale);
  for (int axis = 0; axis < scene.domain.dimension; axis++) {
    require(map.extent[axis] >= 0 && map.extent[axis] <= hg::kFixedPointQuanta, "extent[%d] = %g", axis,
            map.extent[axis]);
    const mpq_class low(scene.bounds.min[axis]), scale(map.scale);
    for (double x : scene.points[axis]) {
      const int32_t c = coordinate_of(map, axis, x);
      require(c >= 0 && c < 1 << 30, "coordinate %d of %a", c, x);
      const mpq_class error = (mpq_class(x) - low) * scale - c;
      require(is_floor(error, place_slack(scene.domain, axis)),
              "axis %d: %a in [%a, %a] is %g quanta from its coordinate %d", axis, x, scene.bounds.min[axis],
              scene.bounds.max[axis], error.get_d(), c);
    }
  }
}

// The larger of widest axis and least extent must be resolved to 2^-30 of itself, unless it is all but nothing.
void require_resolution(const Scene &scene) {
  const FixedPoint map = FixedPoint::over(scene.bounds, scene.domain, scene.least_extent);
  double widest = scene.least_extent;
  for (int axis = 0; axis < 3; axis++) widest = std::max(widest, scene.bounds.max[axis] - scene.bounds.min[axis]);
  if (widest < 1e-280) return;
  require(widest * map.scale >= 0x1p29 && widest * map.scale <= 0x1p30, "%g is %g quanta wide", widest,
          widest * map.scale);
}

Scene any_scene(Rng &rng, double offset, double extent) {
  Scene scene;
  scene.domain.dimension = rng.integer(2, 3);
  for (int axis = 0; axis < scene.domain.dimension; axis++) {
    const double start = rng.chance(0.3) ? 0 : offset * rng.uniform(-1, 1);
    const double width = rng.chance(0.3) ? extent * rng.uniform() * 1e-9 : extent;
    for (int i = 0; i < 20; i++) scene.points[axis].push_back(start + width * rng.uniform());
    if (rng.chance(0.2)) scene.points[axis].assign(20, start);
  }
  set_bounds(scene);
  scene.least_extent = rng.chance(0.5) ? 0 : extent * rng.uniform();
  return scene;
}

void check_ordinary(uint64_t seed) {
  Rng rng(seed);
  const double extent = std::pow(10, rng.uniform(-20, 20));
  const Scene scene = any_scene(rng, extent * std::pow(10, rng.uniform(-3, 12)), extent);
  require_map(scene);
  require_resolution(scene);
}

void check_extreme(uint64_t seed) {
  Rng rng(seed);
  const double extent = std::ldexp(1.0, rng.integer(-1074, 1022));
  const double offset = rng.chance(0.5) ? 0 : std::ldexp(1.0, rng.integer(-1074, 1020));
  require_map(any_scene(rng, offset, extent));
}

void ordinary(void **) { assert_true(sweep(3000, check_ordinary)); }
void extreme(void **) { assert_true(sweep(5000, check_extreme)); }

// Coincident centres, far out or at zero, with radii from nothing to the largest doubles.
void check_coincident(uint64_t) {
  for (double x : {0.0, 1.0, -1e10, 1e300, 1.7e308, 5e-324}) {
    for (double least : {0.0, 5e-324, 1e-300, 1e-9, 1.0, 1e300, 1.7e308}) {
      Scene scene;
      for (auto &points : scene.points) points = {x, x};
      set_bounds(scene);
      scene.least_extent = least;
      require_map(scene);
    }
  }
}

void check_widest(uint64_t) {
  Scene scene;
  scene.domain.dimension = 2;
  scene.points[0] = {-1.7e308, 1.7e308, 0, 1};
  scene.points[1] = {1e300, 1e300, 1e300, 1e300};
  set_bounds(scene);
  require_map(scene);
}

// Order is kept, so that search boxes in doubles and in quanta agree about who is inside.
void check_monotone(uint64_t seed) {
  Rng rng(seed);
  const Scene scene = any_scene(rng, 1e3, std::pow(10, rng.uniform(-10, 10)));
  const FixedPoint map = FixedPoint::over(scene.bounds, scene.domain, scene.least_extent);
  std::vector<double> x = scene.points[0];
  std::sort(x.begin(), x.end());
  for (size_t i = 1; i < x.size(); i++) {
    require(coordinate_of(map, 0, x[i - 1]) <= coordinate_of(map, 0, x[i]), "%a comes after %a", x[i - 1], x[i]);
  }
}

// Periods, and the places of centres up to 2^20 boxes away, at faces now and then.
void check_periodic(uint64_t seed) {
  Rng rng(seed);
  Domain domain;
  Bounds bounds;
  for (int axis = 0; axis < 3; axis++) {
    const double low = rng.uniform(-1e3, 1e3);
    set_box(domain, axis, low, low + std::pow(10, rng.uniform(-5, 5)), rng.chance(0.7));
    bounds.min[axis] = domain.periodic[axis] ? 0 : domain.box_min[axis];
    bounds.max[axis] = domain.periodic[axis] ? domain.length[axis] : domain.box_max[axis];
  }
  const FixedPoint map = FixedPoint::over(bounds, domain, 0);
  for (int axis = 0; axis < 3; axis++) {
    const mpq_class exact_length = mpq_class(domain.box_max[axis]) - mpq_class(domain.box_min[axis]);
    const mpq_class error = exact_length * mpq_class(map.scale) - map.period[axis];
    if (domain.periodic[axis]) {
      require(abs(error) <= mpq_class(1, 2) + mpq_class(1, 1000), "period[%d] is off by %g", axis, error.get_d());
    } else {
      require(map.period[axis] == 0, "period[%d] = %d on an open axis", axis, map.period[axis]);
    }
  }
  for (int i = 0; i < 20; i++) {
    double center[3];
    int32_t coordinate[3];
    any_center(rng, domain, center);
    map.find_coordinates(center, 3, coordinate);
    for (const int32_t c : coordinate) require(c >= 0 && c < 1 << 30, "coordinate %d", c);
    require_place(map, domain, center, coordinate);
  }
}

// In a cell of any edges, in coordinates that wrap, too.
void check_tilted(uint64_t seed) {
  Rng rng(seed);
  const Domain domain = any_cell(rng);
  Bounds bounds;
  for (int axis = 0; axis < domain.dimension; axis++) {
    bounds.min[axis] = domain.periodic[axis] ? 0 : domain.box_min[axis];
    bounds.max[axis] = domain.periodic[axis] ? domain.length[axis] : domain.box_max[axis];
  }
  const FixedPoint map = FixedPoint::over(bounds, domain, 0);
  const FixedPoint wraps = FixedPoint::wrapping(bounds, domain, domain.length[0] * rng.uniform(), hg::kMaxWraps);
  require(map.tilted == domain.is_tilted(), "a map is%s tilted", map.tilted ? "" : " not");
  for (int i = 0; i < 20; i++) {
    double center[3], place[3];
    int32_t coordinate[3];
    any_center(rng, domain, center);
    map.find_coordinates(center, domain.dimension, coordinate);
    require_place(map, domain, center, coordinate);
    wraps.find_place(center, domain.dimension, place);
    const auto errors = place_errors(wraps, domain, center, place, 1);
    for (int axis = 0; axis < domain.dimension; axis++) {
      require(place[axis] == std::rint(place[axis]), "axis %d: %a is at %a", axis, center[axis], place[axis]);
      require(abs(errors[axis]) <= mpq_class(0.5 + (domain.periodic[axis] ? 0.375 : 0x1p-5)),
              "axis %d: the place of %a is off by %g quanta", axis, center[axis], errors[axis].get_d());
    }
  }
}

void coincident(void **) { assert_true(holds(0, check_coincident)); }
void widest(void **) { assert_true(holds(0, check_widest)); }
void monotone(void **) { assert_true(sweep(500, check_monotone)); }
void periodic(void **) { assert_true(sweep(500, check_periodic)); }
void tilted(void **) { assert_true(sweep(500, check_tilted)); }

// ---- coordinates that wrap

// Boxes and open axes of any size, with particles up to `most_wraps` boxes outside.
struct WrappingScene {
  explicit WrappingScene(Rng &rng) : most_wraps(std::floor(std::pow(2, rng.uniform(0, 20)))) {
    const double unit = std::ldexp(1.0, rng.chance(0.7) ? rng.integer(-30, 30) : rng.integer(-1074, 1022));
    domain = open_space(rng.integer(2, 3));
    if (rng.chance(0.2)) most_wraps = 0;
    for (int axis = 0; axis < domain.dimension; axis++) {
      const double low = rng.chance(0.3) ? 0 : unit * rng.uniform(-1, 1) * (unit < 1e290 ? 1e6 : 1);
      const double width = unit * rng.uniform() * (rng.chance(0.2) ? 1e-9 : 1);
      set_box(domain, axis, low, low + width, low + width > low && rng.chance(0.5));
      bounds.min[axis] = domain.periodic[axis] ? 0 : low;
      bounds.max[axis] = domain.periodic[axis] ? domain.length[axis] : low + width;
    }
    largest = rng.chance(0.1) ? 0 : unit * std::pow(10, rng.uniform(-18, 2));
  }

  // As far outside as the map is made for; on a face now and then.
  double any_center(Rng &rng, int axis) const {
    const double low = domain.box_min[axis], high = domain.box_max[axis], length = domain.length[axis];
    const double x = rng.chance(0.1) ? (rng.chance(0.5) ? low : high) : std::min(low + rng.uniform() * length, high);
    if (!domain.periodic[axis]) return x;
    const double far = x + std::rint(rng.uniform(-1, 1) * most_wraps) * length;
    return std::fabs(domain.wraps(axis, far)) <= most_wraps ? far : x;
  }

  Domain domain;
  Bounds bounds;
  double largest = 0, most_wraps;
};

// Whole quanta are as fine as the largest particle and the widest axis allow.
void require_wrapping_scale(const WrappingScene &scene, const FixedPoint &map) {
  int exponent = 0;
  require(std::frexp(map.scale, &exponent) == 0.5, "the scale %a is no power of two", map.scale);
  double widest = 0, farthest = 0;
  for (int axis = 0; axis < scene.domain.dimension; axis++) {
    require(map.extent[axis] >= 0 && map.extent[axis] <= 0x1p46, "extent[%d] = %g", axis, map.extent[axis]);
    widest = std::max(widest, 0.5 * scene.bounds.max[axis] - 0.5 * scene.bounds.min[axis]);
    if (scene.domain.periodic[axis]) farthest = std::max(farthest, scene.domain.length[axis] / 8);
  }
  const bool fine = 0.5 * scene.largest * map.scale > 0x1p23, spread = widest * map.scale > 0x1p43;
  const bool wrapped = farthest * (scene.most_wraps + 1) * map.scale > 0x1p45;
  require(0.5 * scene.largest * map.scale < 0x1p25, "a particle is %g quanta wide", scene.largest * map.scale);
  require(fine || spread || wrapped || map.scale == 1 || map.scale == 0x1p1000, "coarse without need: %a", map.scale);
}

int32_t lowest_word(double whole) {
  return static_cast<int32_t>(static_cast<uint32_t>(static_cast<uint64_t>(static_cast<int64_t>(whole))));
}

void check_period(const WrappingScene &scene, const FixedPoint &map, int axis) {
  const double period = map.period_place(axis);
  const mpq_class exact = (mpq_class(scene.domain.box_max[axis]) - mpq_class(scene.domain.box_min[axis])) * map.scale;
  require(period == std::rint(period) && abs(exact - period) <= mpq_class(0.5 + 0x1p-5), "period[%d]: %g instead of %g",
          axis, period, exact.get_d());
  require(map.period[axis] == lowest_word(period), "period[%d] does not wrap as places do", axis);
}

// A place is whole, near the exact one, and its lowest bits are the coordinate.
void check_place(Rng &rng, const WrappingScene &scene, const FixedPoint &map, int axis) {
  const double x = scene.any_center(rng, axis), place = place_of(map, axis, x);
  require(place == std::rint(place) && place >= 0 && place <= 0x1p46, "axis %d: %a is at %g", axis, x, place);
  const Domain &domain = scene.domain;
  const mpq_class low(domain.periodic[axis] ? domain.box_min[axis] : scene.bounds.min[axis]);
  mpq_class error = (mpq_class(x) - low) * mpq_class(map.scale) - mpq_class(place);
  const mpq_class most(0.5 + (domain.periodic[axis] ? 0.375 : 0x1p-5));
  if (domain.periodic[axis]) {
    const mpq_class length = (mpq_class(domain.box_max[axis]) - low) * map.scale;
    error -= floor_of(error / length + mpq_class(1, 2)) * length;
  }
  require(abs(error) <= most, "axis %d: the place of %a is off by %g quanta", axis, x, error.get_d());
  require(hg::low_word(place) == lowest_word(place), "axis %d: coordinate of place %g", axis, place);
  require(static_cast<double>(hg::whole_bits(place)) == place, "axis %d: bits of place %g", axis, place);

  // Near places have the difference of their coordinates, images too.
  const double near = std::min(std::max(place + rng.integer(-0x7fffffff, 0x7fffffff), 0.0), 0x1p46);
  if (std::fabs(near - place) < 0x1p31) {
    require(hg::near_difference(hg::low_word(near), hg::low_word(place)) == near - place, "%g - %g", near, place);
  }
  const int step = rng.integer(-1, 1);
  require(
      hg::moved_by(hg::low_word(place), step, map.period[axis]) == lowest_word(place + step * map.period_place(axis)),
      "axis %d: %g moved by %d periods", axis, place, step);
}

void check_wrapping(uint64_t seed) {
  Rng rng(seed);
  const WrappingScene scene(rng);
  const FixedPoint map = FixedPoint::wrapping(scene.bounds, scene.domain, scene.largest, scene.most_wraps);
  require_wrapping_scale(scene, map);
  for (int axis = 0; axis < scene.domain.dimension; axis++) {
    if (scene.domain.periodic[axis]) check_period(scene, map, axis);
    for (int n = 0; n < 20; n++) check_place(rng, scene, map, axis);
  }
}

// The nearest of three images, on either side of half a period.
void check_boxes_back(uint64_t) {
  for (const double period : {1.0, 7.0, 0x1p31, 0x1p46}) {
    for (const double share : {-1.0, -0.75, -0.51, -0.49, -0.1, 0.0, 0.3, 0.49, 0.51, 1.0}) {
      const double moved = share * period, back = hg::boxes_back(moved, period);
      require(std::fabs(moved + back * period) <= 0.5 * period, "%g periods are brought back by %g", share, back);
      require(back == -std::rint(share), "%g periods are brought back by %g", share, back);
    }
  }
}

void wrapping(void **) { assert_true(sweep(3000, check_wrapping)); }
void boxes_back(void **) { assert_true(holds(0, check_boxes_back)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(ordinary), cmocka_unit_test(extreme),  cmocka_unit_test(coincident),
      cmocka_unit_test(widest),   cmocka_unit_test(monotone), cmocka_unit_test(periodic),
      cmocka_unit_test(tilted),   cmocka_unit_test(wrapping), cmocka_unit_test(boxes_back),
  };
  return cmocka_run_group_tests_name("fixed_point", tests, nullptr, nullptr);
}
