// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Who takes part in a search: every present particle once, in its class, as the store has it.
#include "src/particles/participants.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/domains.hpp"
#include "tests/unit/stores.hpp"

#include <vector>

namespace {

using namespace hgtest;

struct Crowd {
  explicit Crowd(Rng &rng) : dimension(static_cast<size_t>(rng.integer(2, 3))), count(rng.below(50)) {
    for (size_t k = 0; k < dimension * count; k++) centers.push_back(rng.uniform(-1, 1));
    const int last = rng.chance(0.3) ? HG_MAX_GROUPS - 1 : 2;
    const double absent = rng.chance(0.1) ? 1 : rng.chance(0.4) ? 0 : rng.uniform();
    for (size_t k = 0; k < count; k++) {
      radii.push_back(rng.uniform());
      groups.push_back(rng.chance(absent) ? hg::kAbsent : rng.integer(0, last));
    }
  }

  size_t dimension, count;
  std::vector<double> centers, radii;
  std::vector<int32_t> groups;
};

void require_all(const hg::Participants &found, const Crowd &crowd, const hg::GroupTable &table) {
  std::vector<int> seen(crowd.count, 0);
  found.ranges().each(0, found.count(), [&](int c, size_t begin, size_t end) {
    const hg::Participants part = found.of_class(c);
    require(part.count() == end - begin, "class %d has %zu particles, not %zu", c, part.count(), end - begin);
    for (size_t k = begin; k < end; k++) {
      const size_t slot = found.slots() != nullptr ? found.slots()[k] : k;
      seen[slot]++;
      require(found.radius(k) == crowd.radii[slot] && part.radius(k - begin) == crowd.radii[slot], "a radius");
      for (size_t axis = 0; axis < crowd.dimension; axis++) {
        const double x = crowd.centers[slot * crowd.dimension + axis];
        require(found.center(k)[axis] == x && part.center(k - begin)[axis] == x, "a centre");
        const hg::Interval &extent = found.summary().center[axis];
        require(extent.least <= x && x <= extent.greatest, "a centre beyond the extent");
      }
      found.ranges().each(0, found.count(), [&](int d, size_t first, size_t) {
        const size_t other = found.slots() != nullptr ? found.slots()[first] : first;
        const bool meet = table.meet(crowd.groups[slot], crowd.groups[other]);
        require(found.classes().meet(c, d) == meet, "whether classes %d and %d meet", c, d);
      });
    }
  });
  for (size_t slot = 0; slot < crowd.count; slot++) {
    require(seen[slot] == (crowd.groups[slot] == hg::kAbsent ? 0 : 1), "slot %zu takes part %d times", slot,
            seen[slot]);
  }
}

void check_crowd(uint64_t seed) {
  Rng rng(seed);
  Crowd crowd(rng);
  hg::Memory memory(hg::system_allocator());
  hg::ParticleStore store = make_store(memory, open_space(static_cast<int>(crowd.dimension)));
  store.insert(crowd.count, crowd.centers.data(), crowd.radii.data());
  hg::GroupTable table;
  hg::ParticipantList list(memory);
  const std::vector<int32_t> groups = crowd.groups;
  crowd.groups.assign(crowd.count, 0);
  require(list.of(store, table, 1).slots() == nullptr, "copies though nobody was told of groups");
  require_all(list.of(store, table, 1), crowd, table);
  crowd.groups = groups;
  store.set_groups(crowd.count, groups.data());
  for (int change = 0; change < 4; change++) {
    list.groups_changed();
    require_all(list.of(store, table, 1), crowd, table);
    table.set(rng.integer(0, 2), rng.integer(0, 2), rng.chance(0.5));
  }
}

void random_crowds(void **) { assert_true(sweep(2000, check_crowd)); }

// An absent particle far away does not widen the space.
void extent_of_those_present(void **) {
  const double centers[6] = {0, 0, 1, 0, 1e9, 1e9}, radii[3] = {1, 2, 1e6};
  const int32_t groups[3] = {0, 0, -1};
  hg::Memory memory(hg::system_allocator());
  hg::ParticleStore store = make_store(memory, open_space(2));
  store.insert(3, centers, radii);
  store.set_groups(3, groups);
  hg::ParticipantList list(memory);
  const hg::Participants found = list.of(store, hg::GroupTable(), 1);
  assert_int_equal(2, found.count());
  assert_true(found.summary().center[0].greatest == 1 && found.summary().radius.greatest == 2);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(random_crowds), cmocka_unit_test(extent_of_those_present)};
  return cmocka_run_group_tests_name("participants", tests, nullptr, nullptr);
}
