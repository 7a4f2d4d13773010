// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Cells that are too short for two particles, by rational numbers: at the limit and beside it, in any cell.
#include "src/particles/short_cell.hpp"
#include "tests/unit/cells.hpp"
#include "tests/unit/checks.hpp"

#include <hgrid/types.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace hgtest;
using hg::Domain;
using hg::Interaction;
using hg::ShortCell;
using hg::TwoLargest;

TwoLargest largest_of(const std::vector<double> &radii) {
  TwoLargest largest;
  for (size_t i = 0; i < radii.size(); i++) largest.include(i, radii[i]);
  return largest;
}

void check_two_largest(uint64_t seed) {
  Rng rng(seed);
  std::vector<double> radii(rng.below(6));
  for (double &r : radii) r = rng.integer(0, 4);
  const TwoLargest found = largest_of(radii);
  require(found.count == std::min<size_t>(2, radii.size()), "%zu of %zu", found.count, radii.size());
  std::vector<double> descending = radii;
  std::sort(descending.rbegin(), descending.rend());
  for (size_t k = 0; k < found.count; k++) {
    require(found.radius[k] == descending[k], "largest %zu: %g", k, found.radius[k]);
    require(radii[found.place[k]] == descending[k], "largest %zu is not at %zu", k, found.place[k]);
  }
  require(found.count < 2 || found.place[0] != found.place[1], "one stands for both");
}

void two_largest(void **) { assert_true(sweep(1000, check_two_largest)); }

bool is_refused(const ShortCell &cell, const TwoLargest &largest) {
  const int32_t ids[2] = {17, 4};
  try {
    cell.check(largest, ids);
    return false;
  } catch (const hg::Error &error) {
    require(error.status() == HG_ERR_ARGUMENT, "status %d", static_cast<int>(error.status()));
    return true;
  }
}

mpq_class exact_reach(const Interaction &interaction, double r1, double r2) {
  const mpq_class base = interaction.kind == HG_CONTACT ? mpq_class(mpq_class(r1) + mpq_class(r2)) : mpq_class(r1);
  return base + mpq_class(interaction.margin);
}

// The shortest vectors themselves are held against all others in exact/test_lattice.cpp.
mpq_class shortest_square(const Domain &domain) {
  const hg::ShortVectors vectors = hg::find_short_vectors(domain);
  mpq_class shortest = exact_square(domain, vectors.shift[0]);
  for (int k = 1; k < vectors.count; k++) shortest = std::min(shortest, exact_square(domain, vectors.shift[k]));
  return shortest;
}

// Reaches half as long as the shortest vector, but for a few units in the last place. Returns whether exactly.
bool check_limit(uint64_t seed) {
  Rng rng(seed);
  const Domain domain = any_cell(rng);
  if (!domain.any_periodic) return false;
  const mpq_class square = shortest_square(domain);
  const double half = std::sqrt(square.get_d()) / 2;
  const Interaction interaction{rng.chance(0.5) ? HG_CONTACT : HG_MAX_RANGE, rng.chance(0.5) ? 0 : half / 8,
                                rng.chance(0.5)};
  const double share = interaction.kind == HG_MAX_RANGE ? 1 : 0.5 + 0.125 * rng.integer(0, 4);
  double larger = (half - interaction.margin) * share;
  const double smaller = half - interaction.margin - larger;
  for (int k = rng.integer(0, 2); k > 0; k--) larger = std::nextafter(larger, rng.chance(0.5) ? 0 : HUGE_VAL);
  const std::vector<double> radii = {0, std::max(0.0, smaller), larger, 0};
  const mpq_class twice = 2 * exact_reach(interaction, larger, radii[1]);
  require(is_refused(ShortCell(domain, interaction), largest_of(radii)) == (square < twice * twice),
          "a shortest vector of %a and a reach of %a", 2 * half, mpq_class(twice / 2).get_d());

  const ShortCell cell(domain, interaction);
  require(!is_refused(cell, largest_of({larger})) && !is_refused(cell, largest_of({})), "one particle is refused");
  Domain all = domain;
  all.all_images = true;
  require(!is_refused(ShortCell(all, interaction), largest_of(radii)), "refused though all images count");
  // What needs no closer look is not refused.
  const double radius = larger * rng.uniform(0.3, 1.1);
  if (cell.is_long_for(radius)) require(!is_refused(cell, largest_of({radius, radius})), "long, and yet refused");
  return square == twice * twice;
}

void limits(void **) {
  int exact = 0;
  assert_true(sweep(3000, [&](uint64_t seed) { exact += check_limit(seed) ? 1 : 0; }));
  assert_true(exact > 300);
}

Domain cube(double edge) {
  Domain domain = open_space(3);
  for (int axis = 0; axis < 3; axis++) set_box(domain, axis, 0, edge);
  return domain;
}

void check_long(uint64_t) {
  const ShortCell cell(cube(10), {});
  require(cell.is_long_for(2.49) && !cell.is_long_for(2.51), "twice the diameter");
  require(!ShortCell(cube(10), {HG_CONTACT, 1}).is_long_for(2.01), "the margin");
  require(ShortCell(cube(10), {HG_MAX_RANGE, 1}).is_long_for(3.99), "the larger range");
  require(ShortCell(open_space(3), {}).is_long_for(1e300), "an open space is short");
}

void check_messages(uint64_t) {
  const int32_t ids[2] = {17, 4};
  Domain domain = cube(10);
  set_tilt(domain, 1, 0, 6);  // b - a = (-4, 10, 0), c = (0, 0, 10)
  const auto refused = [&](hg_status status, const char *part, const std::vector<double> &radii) {
    require_refused(part, status, part, [&] { ShortCell(domain, {HG_CONTACT, 1}).check(largest_of(radii), ids); });
  };
  refused(HG_ERR_ARGUMENT, "particles 17 and 4 with radii 3 and 2", {1, 2, 3});
  refused(HG_ERR_ARGUMENT, "is 10 long", {3, 2});
  refused(HG_ERR_ARGUMENT, "reach 6", {3, 2});
  refused(HG_ERR_LIMIT, "particle 17 with radius 1000", {1000, 2});
  domain.all_images = true;
  refused(HG_ERR_LIMIT, "particle 17 with radius 1000 reaches across too many", {1000});
  require(!ShortCell(domain, {}).is_long_for(1000), "a reach across too many cells needs no look");
  ShortCell(domain, {}).check(largest_of({100}), ids);
}

// Vectors of more edges than can be counted belong to reaches that are refused.
void check_large_tilts(uint64_t) {
  Domain domain = open_space(3);
  for (int axis = 0; axis < 3; axis++) set_box(domain, axis, 0, axis == 2 ? 1 : 10);
  set_tilt(domain, 1, 0, 4e6);
  set_tilt(domain, 2, 1, 4e6);
  const int32_t ids[2] = {17, 4};
  for (const double radius : {0.2, 0.3}) {
    require_refused("large tilts", HG_ERR_LIMIT, "too many periodic cells", [&] {
      ShortCell(domain, {}).check(largest_of({radius, radius}), ids);
    });
    require(!ShortCell(domain, {}).is_long_for(radius), "large tilts need no look");
  }
}

void large_tilts(void **) { assert_true(holds(0, check_large_tilts)); }
void long_cells(void **) { assert_true(holds(0, check_long)); }
void messages(void **) { assert_true(holds(0, check_messages)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(two_largest), cmocka_unit_test(limits), cmocka_unit_test(long_cells),
                              cmocka_unit_test(messages), cmocka_unit_test(large_tilts)};
  return cmocka_run_group_tests_name("short_cell", tests, nullptr, nullptr);
}
