// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The table of shifts against all shifts that could belong to it, in rational numbers: complete, without those far off,
// in order, opposite ones opposite of each other; and what they are in quanta.
#include "src/space/shift_table.hpp"
#include "src/space/shifts.hpp"
#include "tests/unit/cells.hpp"
#include "tests/unit/checks.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace hgtest;
using hg::Domain;
using hg::Image;
using hg::Shift;
using hg::ShiftTable;

hg::FixedPoint map_over(const Domain &domain, double largest) {
  hg::Bounds bounds;
  for (int axis = 0; axis < domain.dimension; axis++) bounds.max[axis] = domain.length[axis];
  return hg::FixedPoint::over(bounds, domain, largest);
}

// By c, then b, then a.
bool comes_before(const Shift &s, const Shift &t) {
  return std::lexicographical_compare(std::rbegin(s.n), std::rend(s.n), std::rbegin(t.n), std::rend(t.n));
}

bool contains(const ShiftTable &table, const Shift &shift) {
  Image low = 0, high = table.count();
  while (low < high) {
    const Image middle = low + (high - low) / 2;
    if (comes_before(table[middle], shift)) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < table.count() && same_shift(table[low], shift);
}

// The least distance from the box, on all axes, that the box has when it is moved; below 0 where both share space.
double distance_from_box(const Domain &domain, const Shift &shift) {
  mpq_class most = -1e300;
  for (int axis = 0; axis < domain.dimension; axis++) {
    if (!domain.periodic[axis]) continue;
    most = std::max(most, mpq_class(abs(exact_shift(domain, axis, shift)) - exact_edge(domain, axis, axis)));
  }
  return most.get_d();
}

void require_order(const ShiftTable &table) {
  require(table.count() % 2 == 1 && table[table.middle()].is_none(), "no shift is not in the middle");
  require(table[hg::kNoImage].is_none(), "no image is shifted");
  for (Image k = 0; k < table.count(); k++) {
    require(k == 0 || comes_before(table[k - 1], table[k]), "shift %u does not ascend", k);
    require((table[k] + table[table.count() - 1 - k]).is_none(), "shift %u is not opposite of its opposite", k);
  }
}

void require_complete(const Domain &domain, const ShiftTable &table, double reach) {
  double most[3] = {0, 0, 0};
  for (int axis = 0; axis < domain.dimension; axis++) most[axis] = domain.length[axis] + reach;
  visit_near(domain, most, [&](const Shift &shift) {
    require(distance_from_box(domain, shift) > reach || contains(table, shift), "(%d, %d, %d) is missing", shift.n[0],
            shift.n[1], shift.n[2]);
  });
}

// Some farther ones cost only time.
void require_near(const Domain &domain, const ShiftTable &table, double reach) {
  for (Image k = 0; k < table.count(); k++) {
    require(distance_from_box(domain, table[k]) <= reach, "shift %u is far off", k);
    for (int axis = 0; axis < 3; axis++) {
      require(table[k].n[axis] == 0 || domain.periodic[axis], "shift %u along an open axis", k);
    }
  }
}

void require_quanta(const Domain &domain, const hg::FixedPoint &map, const ShiftTable &table) {
  for (Image k = 0; k < table.count(); k++) {
    for (int axis = 0; axis < 3; axis++) {
      const double quanta = table.quanta(k, axis);
      if (axis < domain.dimension && domain.periodic[axis]) {
        const mpq_class error = exact_shift(domain, axis, table[k]) * mpq_class(map.scale) - mpq_class(quanta);
        require(abs(error) <= mpq_class(0.5 + 0x1p-16), "shift %u is off by %g on axis %d", k, error.get_d(), axis);
      }
      require(quanta == std::rint(quanta), "shift %u is not whole on axis %d", k, axis);
      const auto word = static_cast<int32_t>(static_cast<uint32_t>(static_cast<int64_t>(quanta)));
      require(table.coordinate(k, axis) == word, "shift %u: coordinate %d", k, axis);
    }
  }
}

void check_table(uint64_t seed) {
  Rng rng(seed);
  const Domain domain = any_cell(rng);
  double shortest = HUGE_VAL;
  for (int axis = 0; axis < domain.dimension; axis++) shortest = std::min(shortest, domain.length[axis]);
  const double reach = shortest * (rng.chance(0.1) ? 1 : rng.uniform(0, rng.chance(0.7) ? 1.2 : 4));
  const hg::FixedPoint map = map_over(domain, reach);
  hg::Memory memory(hg::system_allocator());
  ShiftTable table(memory);
  if (rng.chance(0.5)) {  // made for another cell before
    const Domain other = any_cell(rng);
    table.list(other, map_over(other, 0), other.length[0]);
  }
  table.list(domain, map, reach);
  require_order(table);
  require_complete(domain, table, reach);
  require_quanta(domain, map, table);
  if (table.steps_by_one()) {
    require(!domain.is_tilted() && table.count() == hg::kImages, "%u steps", table.count());
    return;
  }
  require_near(domain, table, reach * 1.001 + 4100 / map.scale);
  require(hg::may_list(domain, reach), "a table that may not be listed");
  require(table.count() <= hg::most_shifts(domain, reach), "%u shifts instead of %g", table.count(),
          hg::most_shifts(domain, reach));
}

void tables(void **) { assert_true(sweep(1500, check_table)); }

// Where no reach is longer than a length of a cell with right angles.
void check_steps(uint64_t) {
  Domain domain = open_space(3);
  for (int axis = 0; axis < 3; axis++) set_box(domain, axis, 0, 1 + axis);
  hg::Memory memory(hg::system_allocator());
  ShiftTable table(memory);
  const auto by_one = [&](double reach) {
    table.list(domain, map_over(domain, reach), reach);
    return table.steps_by_one();
  };
  require(by_one(0.999), "a short reach takes many steps");
  for (int z = -1; z <= 1; z++) {
    for (int y = -1; y <= 1; y++) {
      for (int x = -1; x <= 1; x++) {
        require(same_shift(table[hg::make_image(x, y, z)], {{x, y, z}}), "(%d, %d, %d) has another number", x, y, z);
      }
    }
  }
  require(!by_one(1), "the shortest length is reached");
  set_tilt(domain, 2, 0, 1e-9);
  require(!by_one(0.5), "a tilted cell steps by one");
  set_tilt(domain, 2, 0, 0);
  set_box(domain, 0, 0, 1, false);
  require(by_one(1.5), "the length of an open axis counts");
}

void steps(void **) { assert_true(holds(0, check_steps)); }

// The same shifts in a cell that is a little other.
void check_another_cell(uint64_t seed) {
  Rng rng(seed);
  Domain domain = real_cell(rng, rng.integer(2, 3));
  const hg::FixedPoint map = map_over(domain, 0);
  hg::Memory memory(hg::system_allocator());
  ShiftTable table(memory);
  table.list(domain, map, 0.3 * domain.length[0]);
  std::vector<Shift> before;
  for (Image k = 0; k < table.count(); k++) before.push_back(table[k]);
  for (int axis = 0; axis < domain.dimension; axis++) {
    const double high = domain.box_max[axis] + rng.uniform(-0.1, 0.1) * domain.length[axis];
    set_box(domain, axis, domain.box_min[axis], high, domain.periodic[axis]);
  }
  for (double &tilt : domain.tilt) tilt *= rng.uniform(0.9, 1.1);
  table.set_cell(domain, map);
  require(table.count() == before.size(), "%u shifts instead of %zu", table.count(), before.size());
  for (Image k = 0; k < table.count(); k++) require(same_shift(table[k], before[k]), "shift %u has changed", k);
  require_quanta(domain, map, table);
}

void another_cell(void **) { assert_true(sweep(300, check_another_cell)); }

// Between any two boxes: those by which a place of one comes into the other, but for borders.
void check_visit(uint64_t seed) {
  Rng rng(seed);
  const Domain domain = any_cell(rng);
  hg::PlaceBox from, to;
  double most[3] = {0, 0, 0};
  for (int axis = 0; axis < domain.dimension; axis++) {
    const double length = domain.length[axis];
    from.low[axis] = length * rng.uniform(-2, 2);
    from.high[axis] = from.low[axis] + length * rng.uniform(0, 1.5);
    to.low[axis] = length * rng.uniform(-2, 2);
    to.high[axis] = to.low[axis] + length * rng.uniform(0, 1.5);
    most[axis] = 8 * length;
  }
  std::vector<Shift> visited;
  hg::visit_shifts(domain, from, to, [&](const Shift &shift) { visited.push_back(shift); });
  require(std::is_sorted(visited.begin(), visited.end(), comes_before), "not ascending");
  visit_near(domain, most, [&](const Shift &shift) {
    bool must = true, may = true;
    for (int axis = 0; axis < domain.dimension; axis++) {
      if (!domain.periodic[axis]) continue;
      const mpq_class moved = exact_shift(domain, axis, shift), slack(1e-9 * domain.length[axis]);
      const mpq_class below = mpq_class(from.high[axis]) + moved - mpq_class(to.low[axis]);
      const mpq_class above = mpq_class(to.high[axis]) - mpq_class(from.low[axis]) - moved;
      must = must && below > slack && above > slack;
      may = may && below > -slack && above > -slack;
    }
    const auto times =
        std::count_if(visited.begin(), visited.end(), [&](const Shift &s) { return same_shift(s, shift); });
    require(times <= 1 && (!must || times == 1) && (may || times == 0), "(%d, %d, %d) is visited %d times", shift.n[0],
            shift.n[1], shift.n[2], static_cast<int>(times));
  });
}

void between_boxes(void **) { assert_true(sweep(1000, check_visit)); }

// Too many shifts, or shifts of so many edges that roundings tell.
void check_limits(uint64_t) {
  Domain domain = open_space(3);
  for (int axis = 0; axis < 3; axis++) set_box(domain, axis, 0, axis == 2 ? 1 : 10);
  require(hg::may_list(domain, 50) && !hg::may_list(domain, 5000), "the number of shifts");
  set_box(domain, 0, 0, 10, false);
  set_box(domain, 1, 0, 10, false);
  require(hg::may_list(domain, 0x1p19 - 2) && !hg::may_list(domain, 0x1p19), "the edges of one shift");
  set_box(domain, 0, 0, 10);
  set_box(domain, 1, 0, 10);
  set_tilt(domain, 1, 0, 4e6);
  set_tilt(domain, 2, 1, 4);
  require(hg::may_list(domain, 0.9), "a large tilt");
  set_tilt(domain, 2, 1, 10);
  require(!hg::may_list(domain, 0.5), "two tilts whose product is large");
  require(hg::may_list(open_space(3), 1e300), "an open space");
}

void limits(void **) { assert_true(holds(0, check_limits)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(tables), cmocka_unit_test(steps), cmocka_unit_test(another_cell),
                              cmocka_unit_test(between_boxes), cmocka_unit_test(limits)};
  return cmocka_run_group_tests_name("shift_table", tests, nullptr, nullptr);
}
