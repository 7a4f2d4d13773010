// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The OpenMP of the program that calls the library, whichever it is. Its threads wait for the program's next parallel
// region by spinning; other threads beside them would fight for the cores, so the library takes those.
#pragma once

#include "threads/shared_tasks.hpp"

namespace hg::host_openmp {

// How many threads a parallel region gets here; 0 in a program without OpenMP.
int most_threads() noexcept;

// Runs the tasks in a parallel region: in one thread inside another region, unless nesting is on. Returns false, and
// has done nothing, in a program without OpenMP, and in a forked child, where its threads do not exist and would be
// waited for for ever.
bool run(int threads, SharedTasks &tasks) noexcept;

}  // namespace hg::host_openmp
