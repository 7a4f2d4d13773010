// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// An order of particles in which neighbours in space are neighbours in memory.
#ifndef SIM_DEM_SPACE_ORDER_HPP
#define SIM_DEM_SPACE_ORDER_HPP

#include "setup.hpp"

#include <cstdint>
#include <vector>

namespace dem {

// order[k] is the particle that comes k-th along a Z curve through all centres (Morton 1966).
std::vector<std::uint32_t> space_order(const Setup &setup);

// The same setup with its particles in that order.
Setup reordered(const Setup &setup, const std::vector<std::uint32_t> &order);

}  // namespace dem

#endif
