// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Cuts the search of an index into tasks of similar size. The cut, and so the order of the pairs, does not depend on
// the number of threads.
#pragma once

#include "src/index/index.hpp"

namespace hg {

// Fills index.tasks.
void list_tasks(Index &index);

}  // namespace hg
