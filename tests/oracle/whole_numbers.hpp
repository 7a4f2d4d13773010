// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The oracle written a second time, to check the first: whole numbers of any length instead of rationals. All doubles
// are multiples of the least power of two among them, so coordinates, radii and box lengths become integers; nothing is
// rounded and no bound of an error is needed.
#pragma once

#include "particles/particle_set.hpp"

#include <hgrid/types.h>

#include <vector>

namespace hgtest {

// Ascending pairs of rows as ids (row + index_base), by looking at every pair. Ten thousand particles take 10 s.
std::vector<hg_pair> whole_number_pairs(const hg_grid_def &def, const particles::ParticleSet &particles);

}  // namespace hgtest
