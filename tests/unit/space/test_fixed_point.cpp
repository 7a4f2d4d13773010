// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Fixed-point coordinates against rational numbers, for extents and distances from the origin of all sizes.
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
      const int32_t c = map.coordinate(axis, x);
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
    require(map.coordinate(0, x[i - 1]) <= map.coordinate(0, x[i]), "%a comes after %a", x[i - 1], x[i]);
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
    const double low = domain.box_min[axis], length = domain.length[axis];
    const mpq_class exact_length = mpq_class(domain.box_max[axis]) - mpq_class(low);
    const mpq_class error = exact_length * mpq_class(map.scale) - map.period[axis];
    if (domain.periodic[axis]) {
      require(abs(error) <= mpq_class(1, 2) + mpq_class(1, 1000), "period[%d] is off by %g", axis, error.get_d());
    } else {
      require(map.period[axis] == 0, "period[%d] = %d on an open axis", axis, map.period[axis]);
    }
    for (int i = 0; i < 20; i++) {
      const double far = domain.periodic[axis] ? rng.integer(-1000000, 1000000) * (rng.chance(0.5) ? 1 : 1e-6) : 0;
      const double x = low + ((rng.chance(0.3) ? 0 : rng.uniform()) + std::rint(far)) * length;
      const int32_t c = map.coordinate(axis, x);
      require(c >= 0 && c < 1 << 30, "coordinate %d of %a", c, x);
      require_place(map, domain, axis, x, c);
    }
  }
}

void coincident(void **) { assert_true(holds(0, check_coincident)); }
void widest(void **) { assert_true(holds(0, check_widest)); }
void monotone(void **) { assert_true(sweep(500, check_monotone)); }
void periodic(void **) { assert_true(sweep(500, check_periodic)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(ordinary), cmocka_unit_test(extreme),  cmocka_unit_test(coincident),
      cmocka_unit_test(widest),   cmocka_unit_test(monotone), cmocka_unit_test(periodic),
  };
  return cmocka_run_group_tests_name("fixed_point", tests, nullptr, nullptr);
}
