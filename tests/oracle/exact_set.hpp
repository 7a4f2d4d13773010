// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The set of overlapping pairs of up to some ten thousand particles in whole numbers of any length: all doubles are
// multiples of the least power of two among them, so coordinates, radii and box lengths become integers and nothing is
// rounded. It shares no code with the library, nor with the oracle of the other tests, and needs no bounds of errors.
#ifndef ORACLE_EXACT_SET_HPP
#define ORACLE_EXACT_SET_HPP

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

// Ascending pairs of rows. In kFloat128 and kDouble the same formula is computed with rounding, to be compared.
std::vector<std::pair<std::int32_t, std::int32_t>> overlapping_pairs(const Set &set, Arithmetic arithmetic);

}  // namespace oracle

#endif
