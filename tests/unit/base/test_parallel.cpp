// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// parallel_for(): every task once, workers in range, the first failure passed on. Holds with and without OpenMP.
#include "src/base/parallel.hpp"
#include "tests/unit/checks.hpp"

#include <atomic>
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

void every_task_once(void **) { assert_true(sweep(200, check_tasks)); }
void failures_are_passed_on(void **) { assert_true(sweep(100, check_failure)); }

void thread_counts(void **) {
  assert_int_equal(hg::usable_threads(1), 1);
  assert_true(hg::usable_threads(0) >= 1);
  assert_true(hg::usable_threads(3) == 3 || hg::usable_threads(3) == 1);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(every_task_once),
      cmocka_unit_test(failures_are_passed_on),
      cmocka_unit_test(thread_counts),
  };
  return cmocka_run_group_tests_name("parallel", tests, nullptr, nullptr);
}
