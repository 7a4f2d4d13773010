// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The only file that knows threads. Work is cut into tasks that do not depend on the number of threads; whoever is free
// takes the next one, and results are put together in the order of the tasks.
#pragma once

#include <cstddef>
#include <exception>

#if defined(_OPENMP)
#include <omp.h>
#endif
#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

namespace hg {

// Below this many particles, waking threads costs more than they save.
inline constexpr size_t kWorthThreads = 20000;

// Into how many tasks a pass over `count` particles is cut, so few that each may keep its result on the stack.
inline constexpr size_t kMostParts = 64;
inline size_t parts_of(size_t count) {
  constexpr size_t kLeastPart = 16384;  // particles
  const size_t parts = count / kLeastPart;
  return parts < 1 ? 1 : (parts < kMostParts ? parts : kMostParts);
}

// How many threads a grid uses that was asked for `thread_count` (0: all that the machine offers). Inside a parallel
// region of the caller OpenMP gives one unless nesting is enabled.
inline int usable_threads(int thread_count) {
#if defined(_OPENMP)
  return thread_count == 0 ? omp_get_max_threads() : thread_count;
#else
  (void)thread_count;
  return 1;
#endif
}

// False in a child that was forked after threads had been used: it has none of them, and the OpenMP of gcc would wait
// for them for ever.
inline bool process_has_its_threads() {
#if defined(__unix__) || defined(__APPLE__)
  static const pid_t first_user = getpid();
  return getpid() == first_user;
#else
  return true;
#endif
}

// Calls body(task, worker) for every task in [0, tasks), worker in [0, threads). The first exception is passed on after
// all have stopped. With one thread, or one task, or in a forked child, everything happens on the calling
// thread.
template <class Body>
void parallel_for(int threads, size_t tasks, Body &&body) {
#if defined(_OPENMP)
  if (threads > 1 && tasks > 1 && process_has_its_threads()) {
    std::exception_ptr failure;
    bool failed = false;
    const auto count = static_cast<long long>(tasks);
#pragma omp parallel num_threads(threads)
    {
      const int worker = omp_get_thread_num();
#pragma omp for schedule(dynamic, 1)
      for (long long task = 0; task < count; task++) {
        bool stop = false;
#pragma omp atomic read
        stop = failed;
        if (stop) continue;
        try {
          body(static_cast<size_t>(task), worker);
        } catch (...) {
#pragma omp critical(hgrid_parallel_failure)
          {
            if (!failure) failure = std::current_exception();
          }
#pragma omp atomic write
          failed = true;
        }
      }
    }
    if (failure) std::rethrow_exception(failure);
    return;
  }
#endif
  (void)threads;
  for (size_t task = 0; task < tasks; task++) body(task, 0);
}

// Calls body(begin, end) for parts of [0, count) that do not depend on the number of threads.
template <class Body>
void each_part(int threads, size_t count, Body &&body) {
  const size_t parts = parts_of(count);
  parallel_for(threads, parts, [&](size_t part, int) { body(count * part / parts, count * (part + 1) / parts); });
}

}  // namespace hg
