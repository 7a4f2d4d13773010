// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "threads/host_openmp.hpp"

#include "threads/process.hpp"

#ifdef __ELF__
// What gcc's compiled code calls; the OpenMP of LLVM and Intel has the same. Weak: NULL where the program has no
// OpenMP.
extern "C" {
[[gnu::weak]] int omp_get_max_threads(void);
[[gnu::weak]] int omp_get_thread_num(void);
// NOLINTNEXTLINE(readability-identifier-naming)
[[gnu::weak]] void GOMP_parallel(void (*region)(void *), void *data, unsigned threads, unsigned flags);
}
#endif

namespace hg::host_openmp {

#ifdef __ELF__

namespace {

const long kLoadedIn = process_id();

bool is_there() { return omp_get_max_threads != nullptr && omp_get_thread_num != nullptr && GOMP_parallel != nullptr; }

void region(void *tasks) { static_cast<SharedTasks *>(tasks)->work(omp_get_thread_num()); }

}  // namespace

int most_threads() noexcept { return is_there() ? omp_get_max_threads() : 0; }

bool run(int threads, SharedTasks &tasks) noexcept {
  if (!is_there() || process_id() != kLoadedIn) return false;
  GOMP_parallel(region, &tasks, static_cast<unsigned>(threads), 0);
  return true;
}

#else

int most_threads() noexcept { return 0; }
bool run(int, SharedTasks &) noexcept { return false; }

#endif

}  // namespace hg::host_openmp
