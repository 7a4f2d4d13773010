// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The set of overlapping pairs of up to some ten thousand particles in whole numbers of any length: all doubles are
// multiples of the least power of two among them, so coordinates, radii and box lengths become integers and nothing is
// rounded. It shares no code with the library, nor with the oracle of the other tests, and needs no bounds of errors.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace oracle {

struct Set {
  std::vector<double> centers;  // [count][3]
  std::vector<double> radii;
  bool periodic[3] = {false, false, false};
  double box_min[3] = {0, 0, 0}, box_max[3] = {0, 0, 0};
};

enum class Arithmetic { kWhole, kFloat128, kDouble };

using Pairs = std::vector<std::pair<int32_t, int32_t>>;

// Ascending pairs of rows, by looking at every pair. In kFloat128 and kDouble the same formula is computed with
// rounding, to be compared.
Pairs overlapping_pairs(const Set &set, Arithmetic arithmetic);

// The same in whole numbers, but only pairs that overlap in x are looked at, which one pass over the particles in the
// order of their lower ends finds. The x axis must be open. Ten thousand particles take seconds.
Pairs swept_pairs(const Set &set);

}  // namespace oracle
