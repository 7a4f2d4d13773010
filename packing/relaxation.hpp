// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Overlap relaxation: particles thrown onto each other are pushed apart until they hardly overlap.
#pragma once

#include "packing/box.hpp"

#include <cstddef>
#include <functional>

namespace packing {

// The overlaps of a packing. An overlap is r_i + r_j - |x_i - x_j| over the smaller of the two radii.
struct Overlaps {
  size_t contacts = 0;
  double mean = 0;
  double largest = 0;
};

// Those of a set in its box, if it has one, decided exactly.
Overlaps exact_overlaps(const particles::ParticleSet &set);

// Told the number of sweeps done and the overlaps found before the next.
using SweepObserver = std::function<void(int sweeps_done, const Overlaps &overlaps)>;

// Does `sweeps` sweeps, fewer if no overlap is left, and returns the overlaps that remain, decided exactly. Each sweep
// finds all contacts and then moves both particles of each along the line of centres, the light one farther (masses ~
// r^d).
Overlaps relax(const Box &box, int sweeps, const SweepObserver &observe, particles::ParticleSet &set);

}  // namespace packing
