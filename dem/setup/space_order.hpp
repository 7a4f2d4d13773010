// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// An order of particles in which neighbours in space are neighbours in memory.
#pragma once

#include "dem/setup/setup.hpp"

#include <cstdint>
#include <vector>

namespace dem {

// order[k] is the particle that comes k-th along a Z curve through all centres (Morton 1966).
std::vector<uint32_t> space_order(const std::vector<double> &centers, int dimension);
inline std::vector<uint32_t> space_order(const Setup &setup) { return space_order(setup.centers, setup.dimension); }

// The same setup with its particles in that order.
Setup reordered(const Setup &setup, const std::vector<uint32_t> &order);

// Particle order[k] comes k-th, those that it leaves out are gone; the inverse of one that has all brings them back.
void reorder(ParticleArrays &particles, const std::vector<uint32_t> &order);
std::vector<uint32_t> inverse(const std::vector<uint32_t> &order);

}  // namespace dem
