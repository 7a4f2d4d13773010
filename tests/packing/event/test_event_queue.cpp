// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The queue of events against a plain search for the earliest.
#include "packing/event/event_queue.hpp"
#include "packing/random.hpp"
#include "tests/support/frame.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <vector>

namespace {

constexpr uint64_t kSeed = 4711;

bool first_is_earliest(size_t count) {
  packing::Random random(kSeed);
  std::vector<double> times(count);
  for (double &time : times) time = static_cast<double>(random.below(50));  // many are equal
  packing::event::EventQueue queue(count);
  queue.fill(times);
  for (int step = 0; step < 5000; step++) {
    const double earliest = *std::min_element(times.begin(), times.end());
    const auto first = static_cast<size_t>(queue.first());
    if (queue.first_time() != earliest || times[first] != earliest) {
      std::fprintf(stderr, "seed %llu, %zu particles, step %d: %g first, earliest %g\n",
                   static_cast<unsigned long long>(kSeed), count, step, queue.first_time(), earliest);
      return false;
    }
    // Mostly the first one goes on, as in a simulation; sometimes another changes, back or forth.
    const size_t changed = random.below(3) > 0 ? first : random.below(count);
    times[changed] = random.below(10) == 0
                         ? std::numeric_limits<double>::infinity()
                         : earliest + static_cast<double>(random.below(50)) - (changed == first ? 0 : 9);
    queue.set(static_cast<int32_t>(changed), times[changed]);
  }
  return true;
}

void the_first_is_the_earliest(void **) {
  for (const size_t count : {1, 2, 5, 6, 21, 100}) assert_true(first_is_earliest(count));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(the_first_is_the_earliest)};
  return cmocka_run_group_tests_name("event_queue", tests, nullptr, nullptr);
}
