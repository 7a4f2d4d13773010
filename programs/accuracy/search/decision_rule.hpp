// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How the rules by which overlap is decided are held against the truth.
#pragma once

#include "oracle/pairs.hpp"
#include "particles/particle_set.hpp"

#include <cstdint>

namespace accuracy {

// The pairs in real arithmetic, ascending. The x axis must be open.
oracle::Pairs true_pairs(const particles::ParticleSet &particles);

// The pairs that the library finds at this accuracy, in any order.
oracle::Pairs pairs_at(const particles::ParticleSet &particles, int32_t accuracy);

}  // namespace accuracy
