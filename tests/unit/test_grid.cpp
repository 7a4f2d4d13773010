// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Whole searches on inputs where rounding, overflow or a short period could lose, invent or repeat a pair.
#include "src/grid.hpp"
#include "tests/unit/same_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace {

using namespace hgtest;

struct Case {
  hg_grid_def def;
  Particles particles;

  explicit Case(int dimension) {
    hg::fill_defaults(&def, sizeof def);
    def.dimension = particles.dimension = dimension;
  }
  Case &box(int axis, double low, double high) {
    def.periodic[axis] = 1;
    def.box_min[axis] = low;
    def.box_max[axis] = high;
    return *this;
  }
  Case &particle(double x, double y, double z, double radius) {
    const double at[3] = {x, y, z};
    particles.add(at, radius);
    return *this;
  }
};

Pairs search(const Case &c) {
  hg::Grid grid(hg::check_definition(c.def), hg::system_allocator());
  grid.insert(c.particles.count(), c.particles.centers.data(), c.particles.radii.data());
  const hg_pair *pairs = nullptr;
  size_t count = 0;
  grid.query_pairs(&pairs, &count);
  return sorted(pairs, count);
}

void require_pairs(const char *what, const Case &c, Rule *rule = exact_interact) {
  hgtest::require_pairs(what, search(c), all_pairs(c.def, c.particles, rule));
}

// Each pair once, none missing.
void require_superset(const char *what, const Case &c) {
  const Pairs found = search(c), expected = all_pairs(c.def, c.particles, exact_interact);
  require(std::adjacent_find(found.begin(), found.end(), pair_equal) == found.end(), "%s: a pair came twice", what);
  for (const hg_pair &p : found) require(p.a < p.b, "%s: (%d, %d)", what, p.a, p.b);
  require(std::includes(found.begin(), found.end(), expected.begin(), expected.end(), pair_less),
          "%s: a pair is missing", what);
}

// A search that either is exact or says why it will not search.
void require_exact_or_refused(const char *what, const Case &c) {
  try {
    require_pairs(what, c);
  } catch (const hg::Error &error) {
    require(error.status() == HG_ERR_ARGUMENT || error.status() == HG_ERR_LIMIT, "%s: status %d (%s)", what,
            static_cast<int>(error.status()), error.what());
  }
}

// Two particles half a box apart meet through two images, but are one pair.
void check_half_box(uint64_t) {
  Case sum(3);
  sum.box(0, 0, 1).box(1, 0, 1).box(2, 0, 1).particle(0, 0, 0, 0.2).particle(0.5, 0, 0, 0.2);
  sum.def.margin = 0.1;  // 0.2 + 0.2 + 0.1 is a little more than half the box, but rounds to it
  require_exact_or_refused("rounded reach", sum);
  Case length(2);
  length.box(0, 0x1p-55, 1).particle(0x1p-55, 0, 0, 0.25).particle(0.5, 0, 0, 0.25);
  require_exact_or_refused("rounded length", length);
  for (int32_t accuracy : {HG_EXACT, HG_DOUBLE, HG_FLOAT}) {
    Case touch(3);
    touch.box(0, 0, 1).box(1, 0, 1).box(2, 0, 1).particle(0, 0, 0, 0.25).particle(0.5, 0, 0, 0.25);
    touch.def.accuracy = accuracy;
    require_superset("touching twice", touch);
  }
}

// A short period beside a long one is but a few quanta.
void check_short_period(uint64_t) {
  for (int32_t accuracy : {HG_EXACT, HG_FLOAT}) {
    Case c(2);
    c.box(0, 0, 1).box(1, 0, 1e-9).particle(0.1, 0, 0, 1e-10).particle(0.9, 0, 0, 1e-10);
    c.particle(0.1, 2.5e-10, 0, 1e-10).particle(0.1, 9e-10, 0, 1e-10);
    c.def.accuracy = accuracy;
    if (accuracy == HG_EXACT) require_pairs("short period", c);
    require_superset("short period", c);
  }
}

// Below a power of two doubles are finer than above: wrapping must not round to the coarser ones.
void check_far_box(uint64_t seed) {
  Rng rng(seed);
  const int exponent = rng.integer(20, 45);
  const double low = rng.chance(0.5) ? std::ldexp(1.0, exponent) : -std::ldexp(1.0, exponent) - 1;
  const double unit = std::ldexp(1.0, exponent - 53);  // half the spacing of doubles in the box
  Case c(2);
  c.box(0, low, low + 1).box(1, low, low + 1);
  for (int i = 0; i < 60; i++) {
    const double side = low > 0 ? low - unit * rng.integer(0, 40) : low + 1 + unit * rng.integer(0, 40);
    const double inside = low + unit * 2 * rng.integer(0, 20);
    c.particle(rng.chance(0.5) ? side : inside, rng.chance(0.5) ? side : inside, 0, unit * rng.uniform(0.2, 6));
  }
  require_pairs("far box", c);
}

// Centres of one coordinate far out, with radii that are nothing beside it; radii beyond all bounds.
void check_scales(uint64_t) {
  require_pairs("tiny radii far out", Case(2).particle(1e10, 1e10, 0, 1e-300).particle(1e10, 1e10, 0, 1e-300));
  require_pairs("one particle", Case(3).particle(1e300, 1e300, 1e300, 1e-9));
  require_pairs("a plane far out",
                Case(3).particle(1e300, 0, 0, 1e-9).particle(1e300, 1e-9, 0, 1e-9).particle(1e300, 3e-9, 0, 1e-9));
  require_exact_or_refused("huge radii", Case(2).particle(1, 1, 0, 1e308).particle(1e308, 1, 0, 1e308));
  require_exact_or_refused("huge radius",
                           Case(2).particle(-1e308, 1, 0, 1e308).particle(1e308, 1, 0, 1.5e308).particle(0, 0, 0, 1));
  require_pairs("whole range", Case(2).particle(-1.7e308, 0, 0, 1).particle(1.7e308, 0, 0, 1).particle(0, 0, 0, 8e307));
  require_pairs("subnormal",
                Case(2).particle(0, 0, 0, 5e-324).particle(5e-324, 0, 0, 5e-324).particle(1e-323, 0, 0, 0));
}

// HG_DOUBLE is its plain expression where squares vanish or overflow, too.
void check_double(uint64_t) {
  for (double unit : {1e-200, 1e-170, 1e-155, 1.0, 1e155, 1e170}) {
    Case c(2);
    c.def.accuracy = HG_DOUBLE;
    for (int i = 0; i < 12; i++)
      c.particle(unit * (i % 4), unit * 1.5 * static_cast<double>(i / 4), 0, unit * (0.4 + 0.1 * (i % 3)));
    require_pairs("plain expression", c, double_interact);
  }
}

// A cost that overflows must not cost the levels.
void check_overhead(uint64_t) {
  Case c(2);
  c.def.cell_overhead = 1e308;
  c.def.box_max[0] = c.def.box_max[1] = 1e-200;
  require_pairs("huge overhead", c.particle(0, 0, 0, 1e8).particle(1, 0, 0, 1e8));
}

// A crowd with particles 1e200 away, whose rows are all the last row.
void check_far_outliers(uint64_t seed) {
  Rng rng(seed);
  Case c(3);
  for (int i = 0; i < 400; i++) c.particle(rng.uniform(0, 8), rng.uniform(0, 8), rng.uniform(0, 8), 0.3);
  c.particle(0, 1e200, 0, 1).particle(0, 5e200, 0, 1).particle(0, -5e200, 1e100, 1);
  for (int32_t accuracy : {HG_EXACT, HG_FLOAT}) {
    c.def.accuracy = accuracy;
    require_pairs("far outliers", c);
  }
}

void half_box(void **) { assert_true(holds(0, check_half_box)); }
void short_period(void **) { assert_true(holds(0, check_short_period)); }
void far_box(void **) { assert_true(sweep(60, check_far_box)); }
void scales(void **) { assert_true(holds(0, check_scales)); }
void plain_double(void **) { assert_true(holds(0, check_double)); }
void huge_overhead(void **) { assert_true(holds(0, check_overhead)); }
void far_outliers(void **) { assert_true(sweep(2, check_far_outliers)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(half_box),     cmocka_unit_test(short_period), cmocka_unit_test(far_box),
      cmocka_unit_test(scales),       cmocka_unit_test(plain_double), cmocka_unit_test(huge_overhead),
      cmocka_unit_test(far_outliers),
  };
  return cmocka_run_group_tests_name("grid", tests, nullptr, nullptr);
}
