// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The extents of what takes part.
#pragma once

#include "src/particles/participants.hpp"
#include "src/space/bounds.hpp"

namespace hg {

// Without their widths.
Bounds spread_of(const Participants &particles, const Domain &domain);
// The same whatever the number of threads.
Bounds bounds_of(const Participants &particles, const Domain &domain, int threads);

}  // namespace hg
