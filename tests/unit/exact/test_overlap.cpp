// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Overlap::holds() against rational numbers: nearly touching balls, far periodic images, squares out of range.
#include "src/exact/overlap.hpp"
#include "tests/support/oracle.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/domains.hpp"

#include <hgrid/types.h>

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace hgtest;
using hg::Domain;
using hg::Image;
using hg::Interaction;
using hg::Overlap;

// Two balls and the rule that decides about them.
struct Case {
  Domain domain;
  Interaction interaction;
  double a[3] = {0, 0, 0}, b[3] = {0, 0, 0};
  double ra = 0, rb = 0;
  Image image = hg::make_image(0, 0, 0);
};

// Of a as the caller has it, if its place in the box is moved by the image.
hg::Shift shift_of(const Case &c) {
  const hg::Shift step{{hg::image_step(c.image, 0), hg::image_step(c.image, 1), hg::image_step(c.image, 2)}};
  return step + c.domain.boxes(c.b) - c.domain.boxes(c.a);
}

bool decide(const Case &c, int32_t accuracy, int64_t *exact = nullptr) {
  int64_t count = 0;
  const bool answer = Overlap(c.interaction, accuracy, c.domain).holds({c.a, c.ra}, {c.b, c.rb}, shift_of(c), count);
  if (exact != nullptr) *exact = count;
  return answer;
}

mpq_class rational_square(const Case &c) {
  mpq_class sum = 0;
  for (int axis = 0; axis < c.domain.dimension; axis++) {
    mpq_class d = mpq_class(c.a[axis]) - mpq_class(c.b[axis]);
    if (c.domain.periodic[axis]) {
      d += shift_of(c).n[axis] * (mpq_class(c.domain.box_max[axis]) - mpq_class(c.domain.box_min[axis]));
    }
    sum += d * d;
  }
  return sum;
}

mpq_class rational_reach(const Case &c) {
  const mpq_class ra(c.ra), rb(c.rb), margin(c.interaction.margin);
  if (c.interaction.kind == HG_CONTACT) return ra + rb + margin;
  return std::max(ra, rb) + margin;
}

bool rational_less(const Case &c) { return rational_square(c) < rational_reach(c) * rational_reach(c); }

void require_exact(const char *what, const Case &c) {
  const bool expected = rational_less(c);
  require(decide(c, HG_EXACT) == expected, "%s: x = %a %a %a and %a %a %a, r = %a, %a: must be %d", what, c.a[0],
          c.a[1], c.a[2], c.b[0], c.b[1], c.b[2], c.ra, c.rb, expected);
  if (expected) require(decide(c, HG_FLOAT), "%s: HG_FLOAT misses a pair", what);
}

double nudged(Rng &rng, double x) {
  const double to = rng.chance(0.5) ? -std::numeric_limits<double>::infinity() : HUGE_VAL;
  for (int k = rng.integer(0, 2); k > 0; k--) x = std::nextafter(x, to);
  return x;
}

void any_direction(Rng &rng, double *u) {
  double norm = 0;
  while (norm < 0.01) {
    norm = 0;
    for (int axis = 0; axis < 3; axis++) {
      u[axis] = rng.uniform(-1, 1);
      norm += u[axis] * u[axis];
    }
  }
  for (int axis = 0; axis < 3; axis++) u[axis] /= std::sqrt(norm);
}

Case any_radii(Rng &rng, double unit) {
  Case c;
  c.domain.dimension = rng.integer(2, 3);
  c.interaction.kind = rng.chance(0.5) ? HG_CONTACT : HG_MAX_RANGE;
  c.interaction.margin = rng.chance(0.5) ? 0 : unit * rng.uniform();
  c.ra = unit * rng.uniform(0.1, 1);
  c.rb = unit * (rng.chance(0.5) ? rng.uniform() : rng.uniform() * 1e-6);
  return c;
}

// Puts b at the reach of a but for a few units in the last place; exactly along an axis now and then.
void let_touch(Rng &rng, Case &c) {
  const double reach = c.interaction.reach(c.ra, c.rb);
  double u[3] = {1, 0, 0};
  if (rng.chance(0.8)) any_direction(rng, u);
  if (c.domain.dimension == 2) {
    const double norm = std::hypot(u[0], u[1]);
    u[0] /= norm;
    u[1] /= norm;
  }
  for (int axis = 0; axis < c.domain.dimension; axis++) c.b[axis] = nudged(rng, c.a[axis] + reach * u[axis]);
}

void check_touching(uint64_t seed) {
  Rng rng(seed);
  Case c = any_radii(rng, std::ldexp(1.0, rng.integer(-30, 30)));
  const double far = rng.chance(0.5) ? 0 : std::ldexp(c.ra, rng.integer(0, 40));
  for (double &x : c.a) x = far * rng.uniform(-1, 1);
  let_touch(rng, c);
  require_exact("touching", c);
}

// Squares below or above what doubles hold, subnormal numbers included.
void check_out_of_range(uint64_t seed) {
  Rng rng(seed);
  const bool tiny = rng.chance(0.5);
  Case c = any_radii(rng, std::ldexp(1.0, tiny ? rng.integer(-1070, -460) : rng.integer(490, 1021)));
  for (double &x : c.a) x = c.ra * rng.uniform(-1, 1);
  let_touch(rng, c);
  require_exact("out of range", c);
}

// Boxes of any length, particles up to 2^20 box lengths outside, every image.
void check_periodic(uint64_t seed) {
  Rng rng(seed);
  Case c = any_radii(rng, 1);
  const double reach = c.interaction.diameter(c.ra > c.rb ? c.ra : c.rb);
  const int step[3] = {rng.integer(-1, 1), rng.integer(-1, 1), c.domain.dimension == 3 ? rng.integer(-1, 1) : 0};
  for (int axis = 0; axis < c.domain.dimension; axis++) {
    const double low = rng.chance(0.3) ? 0 : rng.uniform(-100, 100);
    set_box(c.domain, axis, low, low + reach * rng.uniform(2.1, 30), rng.chance(0.7));
    c.a[axis] = c.domain.box_min[axis] + c.domain.length[axis] * rng.uniform();
  }
  c.image = hg::make_image(c.domain.periodic[0] ? step[0] : 0, c.domain.periodic[1] ? step[1] : 0,
                           c.domain.periodic[2] ? step[2] : 0);
  let_touch(rng, c);
  for (int axis = 0; axis < c.domain.dimension; axis++) {
    if (!c.domain.periodic[axis]) continue;
    const double most = rng.chance(0.5) ? 3 : hg::kMaxWraps - 2;
    const double boxes = std::floor(rng.uniform(-most, most));
    c.b[axis] = nudged(rng, c.b[axis] + (hg::image_step(c.image, axis) + boxes) * c.domain.length[axis]);
    if (rng.chance(0.5)) c.a[axis] += std::floor(rng.uniform(-most, most)) * c.domain.length[axis];
  }
  require_exact("periodic", c);
}

// HG_DOUBLE is the plain expression, bit for bit, wherever its squares go.
void check_double(uint64_t seed) {
  Rng rng(seed);
  Case c = any_radii(rng, std::ldexp(1.0, rng.chance(0.7) ? rng.integer(-5, 5) : rng.integer(-1070, 1020)));
  for (double &x : c.a) x = c.ra * rng.uniform(-100, 100);
  let_touch(rng, c);
  const bool expected = double_interact(rule_of(c.domain, c.interaction), {c.a, c.ra}, {c.b, c.rb});
  require(decide(c, HG_DOUBLE) == expected, "HG_DOUBLE is not the plain expression, which gives %d", expected);
}

// HG_FLOAT adds only pairs that double arithmetic cannot tell from touching.
void check_float(uint64_t seed) {
  Rng rng(seed);
  Case c = any_radii(rng, std::ldexp(1.0, rng.integer(-1020, 1000)));
  for (double &x : c.a) x = c.ra * rng.uniform(-2, 2);
  let_touch(rng, c);
  const double away = 1 + std::ldexp(1.0, -rng.integer(1, 60));
  for (double &x : c.b) x *= away;
  if (!decide(c, HG_FLOAT) || rational_less(c)) return;
  const mpq_class reach = rational_reach(c), ratio = rational_square(c) / (reach * reach);
  require(ratio < 1 + mpq_class(1, 1L << 46), "HG_FLOAT takes a pair %g of the reach apart", ratio.get_d());
}

void touching(void **) { assert_true(sweep(50000, check_touching)); }
void out_of_range(void **) { assert_true(sweep(20000, check_out_of_range)); }
void periodic_images(void **) { assert_true(sweep(50000, check_periodic)); }
void plain_double(void **) { assert_true(sweep(50000, check_double)); }
void float_is_narrow(void **) { assert_true(sweep(50000, check_float)); }

// A distance whose square overflows is far, not undecided.
void float_refuses_the_far(void **) {
  Case c;
  c.a[0] = 1e200;
  c.b[0] = 5e200;
  c.ra = c.rb = 1;
  const bool answer = decide(c, HG_FLOAT), exactly = decide(c, HG_EXACT);
  assert_false(answer);
  assert_false(exactly);
}

void integers_are_rarely_needed(void **) {
  Case near, touch;
  near.ra = near.rb = touch.ra = touch.rb = 0.5;
  near.b[0] = 1 - 1e-9;
  touch.b[0] = 1;
  int64_t near_exact = -1, touch_exact = -1;
  const bool near_answer = decide(near, HG_EXACT, &near_exact), touch_answer = decide(touch, HG_EXACT, &touch_exact);
  assert_true(near_answer);
  assert_int_equal(near_exact, 0);
  assert_false(touch_answer);
  assert_int_equal(touch_exact, 1);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(touching),
      cmocka_unit_test(out_of_range),
      cmocka_unit_test(periodic_images),
      cmocka_unit_test(plain_double),
      cmocka_unit_test(float_is_narrow),
      cmocka_unit_test(float_refuses_the_far),
      cmocka_unit_test(integers_are_rarely_needed),
  };
  return cmocka_run_group_tests_name("overlap", tests, nullptr, nullptr);
}
