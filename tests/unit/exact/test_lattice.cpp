// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The shortest vectors of a lattice against all that could be as short, in rational numbers; which is shorter than a
// length, at ties and beside them; and how far one cell is from another.
#include "src/exact/lattice.hpp"
#include "tests/unit/cells.hpp"
#include "tests/unit/checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace hgtest;
using hg::Domain;
using hg::Shift;

// Rounded to a double that is nearest, or next to it.
double root_of(const mpq_class &square) { return mpf_class(sqrt(mpf_class(square, 300))).get_d(); }

bool is_listed(const hg::ShortVectors &found, const Shift &shift) {
  return std::any_of(found.shift, found.shift + found.count,
                     [&](const Shift &s) { return same_shift(s, shift) || same_shift(s, Shift{} - shift); });
}

void require_vectors(const hg::ShortVectors &found) {
  require(found.count >= 0 && found.count <= hg::ShortVectors::kMost, "%d vectors", found.count);
  for (int k = 0; k < found.count; k++) {
    require(!found.shift[k].is_none(), "vector %d is 0", k);
    hg::ShortVectors others = found;
    others.count = k;
    require(!is_listed(others, found.shift[k]), "vector %d comes twice, or its opposite", k);
  }
}

// Of the vectors that are listed one bounds the shortest: all that short are looked at.
void require_shortest(const Domain &domain) {
  const hg::ShortVectors found = hg::find_short_vectors(domain);
  require_vectors(found);
  if (!domain.any_periodic) {
    require(found.count == 0 && found.shortest == HUGE_VAL, "an open space has vectors");
    return;
  }
  require(found.count > 0, "no vector");
  mpq_class shortest = exact_square(domain, found.shift[0]);
  for (int k = 1; k < found.count; k++) shortest = std::min(shortest, exact_square(domain, found.shift[k]));
  const double root = root_of(shortest), most[3] = {root, root, root};
  visit_near(domain, most, [&](const Shift &shift) {
    if (shift.is_none()) return;
    const mpq_class square = exact_square(domain, shift);
    require(square >= shortest, "(%d, %d, %d) is shorter than all that are listed", shift.n[0], shift.n[1], shift.n[2]);
    require(square > shortest || is_listed(found, shift), "(%d, %d, %d), a shortest one, is not listed", shift.n[0],
            shift.n[1], shift.n[2]);
  });
  // Edges that nearly cancel leave their roundings.
  double size = 0;
  for (int k = 0; k < found.count; k++) {
    for (int axis = 0; axis < 3; axis++) size = std::max(size, domain.shift_size(axis, found.shift[k]));
  }
  require(std::fabs(found.shortest - root) <= 0x1p-50 * (root + size), "the shortest is %a long instead of %a",
          found.shortest, root);
}

void check_shortest(uint64_t seed) {
  Rng rng(seed);
  require_shortest(any_cell(rng));
}

// A short vector of many edges, far from all of them.
void check_thin(uint64_t seed) {
  Rng rng(seed);
  Domain domain = open_space(rng.integer(2, 3));
  for (int axis = 0; axis < domain.dimension; axis++) {
    set_box(domain, axis, 0, std::pow(2, -rng.uniform(0, domain.dimension == 2 ? 26 : 20)));
  }
  tilt_some(rng, domain, [&](double length) { return length * rng.uniform(-1, 1); });
  require_shortest(domain);
}

void shortest(void **) { assert_true(sweep(3000, check_shortest)); }
void thin(void **) { assert_true(sweep(300, check_thin)); }

void check_sums(uint64_t seed) {
  Rng rng(seed);
  const Domain domain = any_cell(rng);
  for (int n = 0; n < 10; n++) {
    const Shift shift = any_shift(rng, domain, rng.chance(0.5) ? 2 : 1 << 30);
    const int times = rng.integer(-2, 2);
    for (int axis = 0; axis < domain.dimension; axis++) {
      hg::ExactSum sum;
      sum.add(0.75, 3);
      hg::add_shift(sum, domain, axis, shift, times);
      require(sum.count <= 5 && exact_value(sum) == mpq_class(2.25) + times * exact_shift(domain, axis, shift),
              "axis %d: another sum of edges", axis);
    }
  }
}

void sums(void **) { assert_true(sweep(1000, check_sums)); }

// Lengths that are those of the vector, or as near as doubles get; the sum of several terms.
int check_shorter(uint64_t seed) {
  Rng rng(seed);
  const Domain domain = any_cell(rng);
  int ties = 0;
  for (int n = 0; n < 20; n++) {
    const Shift shift = any_shift(rng, domain, 3);
    const mpq_class square = exact_square(domain, shift);
    double near = root_of(square);
    for (int k = rng.integer(0, 1); k > 0; k--) near = std::nextafter(near, rng.chance(0.5) ? 0 : HUGE_VAL);
    hg::ExactSum length;
    const double part = near * rng.uniform();
    length.add(near, 1);
    if (rng.chance(0.5)) {
      length.add(part, 2);
      length.add(part, -2);
    }
    const mpq_class value = exact_value(length);
    ties += square == value * value ? 1 : 0;
    require(hg::is_shorter(domain, shift, length) == (square < value * value), "a vector of %a is%s shorter than %a",
            root_of(square), square < value * value ? "" : " not", near);
  }
  return ties;
}

void shorter(void **) {
  int ties = 0;
  assert_true(sweep(3000, [&](uint64_t seed) { ties += check_shorter(seed); }));
  assert_true(ties > 3000);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(shortest), cmocka_unit_test(thin), cmocka_unit_test(sums),
                              cmocka_unit_test(shorter)};
  return cmocka_run_group_tests_name("lattice", tests, nullptr, nullptr);
}
