// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// parallel_for(): every task once, workers in range, the first failure passed on, from one or many callers.
#include "src/base/error.hpp"
#include "tests/unit/checks.hpp"
#include "threads/parallel.hpp"

#include <atomic>
#include <thread>
#include <vector>

namespace {

using namespace hgtest;

void check_tasks(uint64_t seed) {
  Rng rng(seed);
  const int threads = rng.integer(1, 5);
  const size_t tasks = rng.below(200);
  std::vector<int> runs(tasks, 0);
  std::atomic<int> bad_workers{0};
  hg::parallel_for(threads, tasks, [&](size_t task, int worker) {
    runs[task]++;
    if (worker < 0 || worker >= threads) bad_workers++;
  });
  for (size_t task = 0; task < tasks; task++) require(runs[task] == 1, "task %zu ran %d times", task, runs[task]);
  require(bad_workers == 0, "%d workers beyond %d threads", bad_workers.load(), threads);
}

void check_failure(uint64_t seed) {
  Rng rng(seed);
  const size_t tasks = 1 + rng.below(100), bad = rng.below(tasks);
  require_refused("a task", HG_ERR_LIMIT, "task failed", [&] {
    hg::parallel_for(rng.integer(1, 4), tasks, [&](size_t task, int) {
      if (task >= bad) hg::fail(HG_ERR_LIMIT, "task failed: %zu", task);
    });
  });
}

// As many callers as the pool has desks, and some more.
void check_callers(uint64_t seed) {
  constexpr int kCallers = 20, kRounds = 20;
  std::vector<int> wrong(kCallers, 0);
  std::vector<std::thread> callers;
  callers.reserve(kCallers);
  for (int caller = 0; caller < kCallers; caller++) {
    callers.emplace_back([&, caller] {
      Rng rng(seed + static_cast<uint64_t>(caller));
      for (int round = 0; round < kRounds; round++) {
        std::vector<int> runs(2 + rng.below(50), 0);
        hg::parallel_for(3, runs.size(), [&](size_t task, int) { runs[task]++; });
        for (const int times : runs) wrong[static_cast<size_t>(caller)] += times == 1 ? 0 : 1;
      }
    });
  }
  for (std::thread &caller : callers) caller.join();
  for (const int faults : wrong) require(faults == 0, "%d tasks not run once", faults);
}

// A task that makes a loop of its own, while all helpers may be at work.
void check_nested(uint64_t seed) {
  Rng rng(seed);
  const size_t outer = 2 + rng.below(6), inner = 2 + rng.below(6);
  std::vector<std::atomic<int>> runs(outer * inner);
  hg::parallel_for(3, outer,
                   [&](size_t a, int) { hg::parallel_for(3, inner, [&](size_t b, int) { runs[a * inner + b]++; }); });
  for (const std::atomic<int> &times : runs) require(times == 1, "a task ran %d times", times.load());
}

// One task never ends before another has begun: only a second thread can begin it.
void a_second_thread_helps(void **) {
  if (hg::usable_threads(2) < 2) skip();
  std::atomic<int> begun{0};
  hg::parallel_for(2, 2, [&](size_t, int) {
    begun++;
    while (begun < 2) std::this_thread::yield();
  });
  assert_int_equal(begun.load(), 2);
}

void every_task_once(void **) { assert_true(sweep(200, check_tasks)); }
void failures_are_passed_on(void **) { assert_true(sweep(100, check_failure)); }

void many_callers(void **) { assert_true(sweep(10, check_callers)); }
void loops_in_loops(void **) { assert_true(sweep(100, check_nested)); }

void thread_counts(void **) {
  assert_int_equal(hg::usable_threads(1), 1);
  assert_true(hg::usable_threads(0) >= 1);
  assert_true(hg::usable_threads(3) == 3 || hg::usable_threads(3) == 1);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(every_task_once), cmocka_unit_test(failures_are_passed_on), cmocka_unit_test(many_callers),
      cmocka_unit_test(loops_in_loops),  cmocka_unit_test(a_second_thread_helps),  cmocka_unit_test(thread_counts),
  };
  return cmocka_run_group_tests_name("parallel", tests, nullptr, nullptr);
}
