// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The extents of what is stored.
#pragma once

#include "src/particles/particle_store.hpp"
#include "src/space/bounds.hpp"

namespace hg {

// Without their widths.
Bounds spread_of(const ParticleStore &store, const Domain &domain);
// The same whatever the number of threads.
Bounds bounds_of(const ParticleStore &store, const Domain &domain, int threads);

}  // namespace hg
