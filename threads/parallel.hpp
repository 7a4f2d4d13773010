// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Loops on several threads. Their tasks must not depend on the number of threads, nor their results on who runs them.
#pragma once

#include "threads/shared_tasks.hpp"

#include <type_traits>

namespace hg {

// How many threads are meant by `thread_count`; 0: as many as OMP_NUM_THREADS says, or else as there are cores that
// this process may use.
int usable_threads(int thread_count);

// All tasks, on the calling thread and at most threads - 1 others.
void run_tasks(int threads, SharedTasks &tasks);

// Calls body(task, worker) for every task in [0, tasks), worker in [0, threads). The first exception is passed on after
// all have stopped. With one thread or one task everything happens on the calling thread.
template <class Body>
void parallel_for(int threads, size_t tasks, Body &&body) {
  if (threads > 1 && tasks > 1) {
    const auto run = [](void *context, size_t task, int worker) {
      (*static_cast<std::remove_reference_t<Body> *>(context))(task, worker);
    };
    SharedTasks shared(tasks, run, const_cast<void *>(static_cast<const volatile void *>(&body)));
    run_tasks(threads, shared);
    shared.rethrow();
    return;
  }
  for (size_t task = 0; task < tasks; task++) body(task, 0);
}

}  // namespace hg
