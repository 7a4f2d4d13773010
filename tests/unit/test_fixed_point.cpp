// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Fixed-point coordinates against rational numbers, for extents and distances from the origin of all sizes.
#include "src/space/fixed_point.hpp"
#include "tests/unit/checks.hpp"

#include <gmpxx.h>

#include <cmath>
#include <vector>

namespace {

using namespace hgtest;
using hg::Bounds;
using hg::Domain;
using hg::FixedPoint;

// Points along each axis, and the frame over them.
struct Scene {
  Domain domain;
  Bounds bounds;
  double least_extent = 0;
  std::vector<double> points[3];
};

void set_bounds(Scene &scene) {
  for (int k = 0; k < scene.domain.dimension; k++) {
    scene.bounds.min[k] = scene.bounds.max[k] = scene.points[k][0];
    for (double x : scene.points[k]) {
      scene.bounds.min[k] = std::min(scene.bounds.min[k], x);
      scene.bounds.max[k] = std::max(scene.bounds.max[k], x);
    }
  }
}

void require_frame(const Scene &scene) {
  const Frame frame = Frame::over(scene.bounds, scene.domain, scene.least_extent);
  int exponent = 0;
  require(std::frexp(frame.scale, &exponent) == 0.5, "the scale %a is no power of two", frame.scale);
  for (int k = 0; k < scene.domain.dimension; k++) {
    require(frame.extent[k] >= 0 && frame.extent[k] <= hg::kFixedPointQuanta, "extent[%d] = %g", k, frame.extent[k]);
    const mpq_class low(scene.bounds.min[k]), scale(frame.scale);
    for (double x : scene.points[k]) {
      const int32_t c = frame.coordinate(k, x);
      require(c >= 0 && c < 1 << 30, "coordinate %d of %a", c, x);
      const mpq_class error = (mpq_class(x) - low) * scale - c;
      require(abs(error) <= 1, "axis %d: %a in [%a, %a] is %g quanta from its coordinate %d", k, x, scene.bounds.min[k],
              scene.bounds.max[k], error.get_d(), c);
    }
  }
}

// The larger of widest axis and least extent must be resolved to 2^-30 of itself, unless it is all but nothing.
void require_resolution(const Scene &scene) {
  const Frame frame = Frame::over(scene.bounds, scene.domain, scene.least_extent);
  double widest = scene.least_extent;
  for (int k = 0; k < 3; k++) widest = std::max(widest, scene.bounds.max[k] - scene.bounds.min[k]);
  if (widest < 1e-280) return;
  require(widest * frame.scale >= 0x1p29 && widest * frame.scale <= 0x1p30, "%g is %g quanta wide", widest,
          widest * frame.scale);
}

Scene any_scene(Rng &rng, double offset, double extent) {
  Scene scene;
  scene.domain.dimension = rng.integer(2, 3);
  for (int k = 0; k < scene.domain.dimension; k++) {
    const double start = rng.chance(0.3) ? 0 : offset * rng.uniform(-1, 1);
    const double width = rng.chance(0.3) ? extent * rng.uniform() * 1e-9 : extent;
    for (int i = 0; i < 20; i++) scene.points[k].push_back(start + width * rng.uniform());
    if (rng.chance(0.2)) scene.points[k].assign(20, start);
  }
  set_bounds(scene);
  scene.least_extent = rng.chance(0.5) ? 0 : extent * rng.uniform();
  return scene;
}

void check_ordinary(uint64_t seed) {
  Rng rng(seed);
  const double extent = std::pow(10, rng.uniform(-20, 20));
  const Scene scene = any_scene(rng, extent * std::pow(10, rng.uniform(-3, 12)), extent);
  require_frame(scene);
  require_resolution(scene);
}

void check_extreme(uint64_t seed) {
  Rng rng(seed);
  const double extent = std::ldexp(1.0, rng.integer(-1074, 1022));
  const double offset = rng.chance(0.5) ? 0 : std::ldexp(1.0, rng.integer(-1074, 1020));
  require_frame(any_scene(rng, offset, extent));
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
      require_frame(scene);
    }
  }
}

void check_widest(uint64_t) {
  Scene scene;
  scene.domain.dimension = 2;
  scene.points[0] = {-1.7e308, 1.7e308, 0, 1};
  scene.points[1] = {1e300, 1e300, 1e300, 1e300};
  set_bounds(scene);
  require_frame(scene);
}

// Order is kept, so that windows in doubles and in quanta agree about who is inside.
void check_monotone(uint64_t seed) {
  Rng rng(seed);
  const Scene scene = any_scene(rng, 1e3, std::pow(10, rng.uniform(-10, 10)));
  const Frame frame = Frame::over(scene.bounds, scene.domain, scene.least_extent);
  std::vector<double> x = scene.points[0];
  std::sort(x.begin(), x.end());
  for (size_t i = 1; i < x.size(); i++) {
    require(frame.coordinate(0, x[i - 1]) <= frame.coordinate(0, x[i]), "%a comes after %a", x[i - 1], x[i]);
  }
}

void check_period(uint64_t seed) {
  Rng rng(seed);
  Domain domain;
  Bounds bounds;
  for (int k = 0; k < 3; k++) {
    domain.periodic[k] = rng.chance(0.7);
    bounds.min[k] = domain.box_min[k] = rng.uniform(-1e3, 1e3);
    bounds.max[k] = domain.box_max[k] = domain.box_min[k] + std::pow(10, rng.uniform(-5, 5));
    domain.length[k] = domain.box_max[k] - domain.box_min[k];
  }
  domain.any_periodic = domain.periodic[0] || domain.periodic[1] || domain.periodic[2];
  const Frame frame = Frame::over(bounds, domain, 0);
  for (int k = 0; k < 3; k++) {
    const mpq_class length = mpq_class(domain.box_max[k]) - mpq_class(domain.box_min[k]);
    const mpq_class error = length * mpq_class(frame.scale) - frame.period[k];
    if (domain.periodic[k]) {
      require(abs(error) <= mpq_class(1, 2) + mpq_class(1, 1000), "period[%d] is off by %g", k, error.get_d());
    } else {
      require(frame.period[k] == 0, "period[%d] = %d on an open axis", k, frame.period[k]);
    }
  }
}

void coincident(void **) { assert_true(holds(0, check_coincident)); }
void widest(void **) { assert_true(holds(0, check_widest)); }
void monotone(void **) { assert_true(sweep(500, check_monotone)); }
void periods(void **) { assert_true(sweep(500, check_period)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(ordinary), cmocka_unit_test(extreme),  cmocka_unit_test(coincident),
      cmocka_unit_test(widest),   cmocka_unit_test(monotone), cmocka_unit_test(periods),
  };
  return cmocka_run_group_tests_name("frame", tests, nullptr, nullptr);
}
