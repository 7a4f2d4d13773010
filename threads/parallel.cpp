// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Whose threads a loop runs on.
#include "threads/parallel.hpp"

#ifdef HGRID_THREADS
#include "threads/host_openmp.hpp"
#include "threads/worker_pool.hpp"

#include <algorithm>
#include <cstdlib>
#include <thread>

#if defined(__linux__)
#include <sched.h>
#endif

namespace hg {
namespace {

int cores() {
#if defined(__linux__)
  cpu_set_t mine;
  if (sched_getaffinity(0, sizeof mine, &mine) == 0) return CPU_COUNT(&mine);
#endif
  const auto all = static_cast<int>(std::thread::hardware_concurrency());
  return all > 0 ? all : 1;
}

// The first number of OMP_NUM_THREADS; 0 if it says nothing.
int wished_threads() {
  const char *wish = std::getenv("OMP_NUM_THREADS");
  const long threads = wish == nullptr ? 0 : std::strtol(wish, nullptr, 10);
  constexpr long kMost = 1024;
  if (threads <= 0) return 0;
  return static_cast<int>(threads < kMost ? threads : kMost);
}

}  // namespace

int usable_threads(int thread_count) {
  if (thread_count > 0) return thread_count;
  if (const int given = host_openmp::most_threads()) return given;
  if (const int wished = wished_threads()) return wished;
  return cores();
}

void run_tasks(int threads, SharedTasks &tasks) {
  if (host_openmp::run(threads, tasks)) return;
  const size_t helpers = std::min(tasks.count(), static_cast<size_t>(threads)) - 1;
  WorkerPool::of_process().run(tasks, static_cast<int>(helpers));
}

}  // namespace hg

#else

namespace hg {

int usable_threads(int) { return 1; }
void run_tasks(int, SharedTasks &tasks) { tasks.work(0); }

}  // namespace hg

#endif
