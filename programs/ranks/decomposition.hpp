// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Ranks that are not there: particles of one process dealt out as a bisection over ranks would, for plans and
// measurements. On real ranks Zoltan does that.
#pragma once

#include "particles/particle_set.hpp"

#include <cstdint>
#include <vector>

namespace ranks {

// Owners by recursive bisection: across the longest axis, at the plane that divides the weights in the ratio of the
// ranks on both sides. weights: [count], >= 0. Places count as they are, not wrapped.
std::vector<int32_t> bisect(const particles::ParticleSet &set, const std::vector<double> &weights, int rank_count);

// What one rank owns.
struct Part {
  std::vector<double> centers, radii;

  size_t count() const { return radii.size(); }
};

std::vector<Part> parts_of(const particles::ParticleSet &set, const std::vector<int32_t> &owners, int rank_count);

}  // namespace ranks
