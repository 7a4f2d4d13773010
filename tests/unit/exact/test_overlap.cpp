// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Overlap::holds() against rational numbers: balls that touch or nearly do, far images, tilted cells, squares out of
// range. Of two images at the same distance one is a pair.
#include "src/exact/overlap.hpp"
#include "tests/unit/cells.hpp"
#include "tests/unit/checks.hpp"

#include <hgrid/types.h>

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace {

using namespace hgtest;
using hg::Domain;
using hg::Interaction;
using hg::Overlap;
using hg::Shift;

// Two balls and the rule that decides about them.
struct Case {
  Domain domain;
  Interaction interaction;
  double a[3] = {0, 0, 0}, b[3] = {0, 0, 0};
  double ra = 0, rb = 0;
  Shift shift;  // of a
};

bool decide(const Case &c, int32_t accuracy, int64_t *exact = nullptr) {
  int64_t count = 0;
  const bool answer = Overlap(c.interaction, accuracy, c.domain).holds({c.a, c.ra}, {c.b, c.rb}, c.shift, count);
  if (exact != nullptr) *exact = count;
  return answer;
}

mpq_class rational_square(const Case &c) {
  mpq_class sum = 0;
  for (int axis = 0; axis < c.domain.dimension; axis++) {
    const mpq_class d = mpq_class(c.a[axis]) - mpq_class(c.b[axis]) + exact_shift(c.domain, axis, c.shift);
    sum += d * d;
  }
  return sum;
}

mpq_class rational_reach(const Case &c) {
  const mpq_class ra(c.ra), rb(c.rb), margin(c.interaction.margin);
  if (c.interaction.kind == HG_CONTACT) return ra + rb + margin;
  return std::max(ra, rb) + margin;
}

int rational_order(const Case &c) { return cmp(rational_square(c), rational_reach(c) * rational_reach(c)); }
bool rationally_holds(const Case &c) { return rational_order(c) < (c.interaction.touching ? 1 : 0); }

void require_exact(const char *what, const Case &c) {
  const bool expected = rationally_holds(c);
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
  c.interaction.touching = rng.chance(0.5);
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
  let_touch(rng, c);
  for (int axis = 0; axis < c.domain.dimension; axis++) {
    if (!c.domain.periodic[axis]) continue;
    const double most = rng.chance(0.5) ? 3 : hg::kMaxWraps - 2;
    const double boxes = std::floor(rng.uniform(-most, most));
    c.b[axis] = nudged(rng, c.b[axis] + (step[axis] + boxes) * c.domain.length[axis]);
    if (rng.chance(0.5)) c.a[axis] += std::floor(rng.uniform(-most, most)) * c.domain.length[axis];
    c.shift.n[axis] = step[axis];
  }
  c.shift = c.shift + c.domain.boxes(c.b) - c.domain.boxes(c.a);
  require_exact("periodic", c);
}

// b is near the reach of a, and then moved by edges of the cell, about as far as particles may be.
Case any_tilted(Rng &rng) {
  const Domain domain = any_cell(rng);
  Case c = any_radii(rng, domain.length[0]);
  c.domain = domain;
  for (int axis = 0; axis < domain.dimension; axis++)
    c.a[axis] = domain.box_min[axis] + domain.length[axis] * rng.uniform();
  let_touch(rng, c);
  c.shift = any_shift(rng, domain, rng.chance(0.5) ? 3 : 1 << 18);
  for (int axis = 0; axis < domain.dimension; axis++)
    c.b[axis] = nudged(rng, c.b[axis] + domain.shifted(axis, c.shift));
  return c;
}

void check_tilted(uint64_t seed) {
  Rng rng(seed);
  require_exact("tilted", any_tilted(rng));
}

// Whole numbers that touch exactly: a right triangle of sides 3, 4 and 5.
void check_exactly_touching(uint64_t seed) {
  Rng rng(seed);
  Case c;
  c.domain = whole_cell(rng, rng.integer(2, 3));
  const double unit = std::fmin(c.domain.length[0], c.domain.length[1]) / 64;
  const int size = rng.integer(1, 40), first = rng.integer(0, 1);
  for (int axis = 0; axis < c.domain.dimension; axis++) c.a[axis] = c.b[axis] = unit * rng.integer(-50, 50);
  c.b[first] += 3 * size * unit;
  c.b[1 - first] -= 4 * size * unit;
  c.ra = unit * rng.integer(0, 5 * size);
  c.rb = 5 * size * unit - c.ra;
  c.interaction.touching = rng.chance(0.5);
  c.shift = any_shift(rng, c.domain, 1000);
  for (int axis = 0; axis < c.domain.dimension; axis++) c.b[axis] += c.domain.shifted(axis, c.shift);
  require(rational_order(c) == 0, "no exact case");
  for (const int32_t accuracy : {HG_EXACT, HG_DOUBLE}) {
    require(decide(c, accuracy) == c.interaction.touching, "accuracy %d: touching balls", static_cast<int>(accuracy));
  }
  c.rb = std::nextafter(c.rb, rng.chance(0.5) ? 0 : HUGE_VAL);
  require_exact("beside touching", c);
}

// Two balls half a shortest vector apart, as large as the cell allows, in one array.
struct Antipodes {
  explicit Antipodes(Rng &rng) {
    domain = any_cell(rng);
    const hg::ShortVectors found = hg::find_short_vectors(domain);
    if (found.count == 0) return;
    const auto shorter = [&](const Shift &s, const Shift &t) {
      return exact_square(domain, s) < exact_square(domain, t);
    };
    const Shift shortest = *std::min_element(found.shift, found.shift + found.count, shorter);
    const mpq_class square = exact_square(domain, shortest);
    radius = std::sqrt(square.get_d()) / 4;
    while (16 * mpq_class(radius) * mpq_class(radius) > square) radius = std::nextafter(radius, 0);
    exact = 16 * mpq_class(radius) * mpq_class(radius) == square;
    for (int axis = 0; axis < domain.dimension; axis++) center[1][axis] = domain.shifted(axis, shortest) / 2;
  }
  hg::Ball ball(int k) const { return {center[k], radius}; }

  Domain domain;
  double center[2][3] = {}, radius = 0;
  bool exact = false;  // touch through two images
};

bool comes_before(const Shift &s, const Shift &t) {
  return std::lexicographical_compare(std::begin(s.n), std::end(s.n), std::begin(t.n), std::end(t.n));
}

// Through all images of the later ball: how many hold, and whether the first of them alone is a pair, seen from either
// ball.
size_t check_images(const Antipodes &balls, const Overlap &overlap) {
  std::vector<Shift> held, pairs;
  int64_t count = 0;
  double most[3] = {0, 0, 0};
  for (int axis = 0; axis < balls.domain.dimension; axis++) {
    most[axis] = 4 * balls.radius + std::fabs(balls.center[1][axis] - balls.center[0][axis]);
  }
  visit_near(balls.domain, most, [&](const Shift &shift) {
    const Shift back = Shift{} - shift;
    if (overlap.holds(balls.ball(0), balls.ball(1), back, count)) held.push_back(shift);
    const bool is_pair = overlap.is_pair(balls.ball(0), balls.ball(1), back, count);
    if (is_pair) pairs.push_back(shift);
    require(is_pair == overlap.is_pair(balls.ball(1), balls.ball(0), shift, count), "another pair from the other side");
  });
  std::sort(held.begin(), held.end(), comes_before);
  std::sort(pairs.begin(), pairs.end(), comes_before);
  if (!balls.domain.all_images && held.size() > 1) held.resize(1);
  require(std::equal(held.begin(), held.end(), pairs.begin(), pairs.end(), same_shift), "%zu pairs", pairs.size());
  return pairs.size();
}

struct Met {
  int exact = 0, twice = 0;
};

void check_two_images(uint64_t seed, Met &met) {
  Rng rng(seed);
  Antipodes balls(rng);
  if (!balls.domain.any_periodic) return;
  const Interaction touching{HG_CONTACT, 0, true};
  const size_t once = check_images(balls, Overlap(touching, HG_EXACT, balls.domain));
  require(once <= 1 && (!balls.exact || once == 1), "%zu pairs in a cell of exactly that length", once);
  check_images(balls, Overlap(touching, HG_DOUBLE, balls.domain));
  // As doubles are rounded, both may seem nearer than they are.
  for (double &x : balls.center[1]) x = rng.chance(0.5) ? x : nudged(rng, x);
  const Interaction plain{HG_CONTACT, 0, false};
  check_images(balls, Overlap(plain, HG_DOUBLE, balls.domain));
  balls.domain.all_images = true;
  met.exact += balls.exact ? 1 : 0;
  met.twice += check_images(balls, Overlap(plain, HG_DOUBLE, balls.domain)) == 2 ? 1 : 0;
}

// The expression of hgrid.h with all its terms.
bool plain_expression(const Case &c) {
  double square = 0;
  for (int axis = 0; axis < c.domain.dimension; axis++) {
    double d = c.a[axis] - c.b[axis], moved = c.shift.n[axis] * (c.domain.box_max[axis] - c.domain.box_min[axis]);
    if (axis == 0) moved = moved + c.shift.n[1] * c.domain.tilt[0];
    if (axis == 0) moved = moved + c.shift.n[2] * c.domain.tilt[1];
    if (axis == 1) moved = moved + c.shift.n[2] * c.domain.tilt[2];
    d = d + moved;
    square = square + d * d;
  }
  const double reach = c.interaction.reach(c.ra, c.rb);
  return c.interaction.touching ? square <= reach * reach : square < reach * reach;
}

// HG_DOUBLE is that, bit for bit, wherever its squares go.
void require_double(const Case &c) {
  const bool expected = plain_expression(c);
  require(decide(c, HG_DOUBLE) == expected, "HG_DOUBLE is not the plain expression, which gives %d", expected);
}

void check_double(uint64_t seed) {
  Rng rng(seed);
  Case c = any_radii(rng, std::ldexp(1.0, rng.chance(0.7) ? rng.integer(-5, 5) : rng.integer(-1070, 1020)));
  for (double &x : c.a) x = c.ra * rng.uniform(-100, 100);
  let_touch(rng, c);
  require_double(c);
}

void check_tilted_double(uint64_t seed) {
  Rng rng(seed);
  require_double(any_tilted(rng));
}

// HG_FLOAT adds only pairs that double arithmetic cannot tell from touching.
void check_float(uint64_t seed) {
  Rng rng(seed);
  Case c = any_radii(rng, std::ldexp(1.0, rng.integer(-1020, 1000)));
  for (double &x : c.a) x = c.ra * rng.uniform(-2, 2);
  let_touch(rng, c);
  const double away = 1 + std::ldexp(1.0, -rng.integer(1, 60));
  for (double &x : c.b) x *= away;
  if (!decide(c, HG_FLOAT) || rationally_holds(c)) return;
  const mpq_class reach = rational_reach(c), ratio = rational_square(c) / (reach * reach);
  require(ratio < 1 + mpq_class(std::ldexp(1.0, -46)), "HG_FLOAT takes a pair %g of the reach apart", ratio.get_d());
}

void touching(void **) { assert_true(sweep(50000, check_touching)); }
void out_of_range(void **) { assert_true(sweep(20000, check_out_of_range)); }
void periodic_images(void **) { assert_true(sweep(50000, check_periodic)); }
void plain_double(void **) { assert_true(sweep(50000, check_double)); }
void float_is_narrow(void **) { assert_true(sweep(50000, check_float)); }

void tilted(void **) { assert_true(sweep(30000, check_tilted)); }
void exactly_touching(void **) { assert_true(sweep(10000, check_exactly_touching)); }
void tilted_double(void **) { assert_true(sweep(50000, check_tilted_double)); }
void two_images(void **) {
  Met met;
  assert_true(sweep(5000, [&](uint64_t seed) { check_two_images(seed, met); }));
  assert_true(met.exact > 300);
  assert_true(met.twice > 30);
}

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
      cmocka_unit_test(tilted),
      cmocka_unit_test(exactly_touching),
      cmocka_unit_test(tilted_double),
      cmocka_unit_test(two_images),
      cmocka_unit_test(plain_double),
      cmocka_unit_test(float_is_narrow),
      cmocka_unit_test(float_refuses_the_far),
      cmocka_unit_test(integers_are_rarely_needed),
  };
  return cmocka_run_group_tests_name("overlap", tests, nullptr, nullptr);
}
