// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Tabulated sizes: a sieve analysis or any other cumulative distribution, from a file.
#pragma once

#include "packing/sizes/curve.hpp"

#include <string>
#include <vector>

namespace packing {

struct SizeTable {
  std::vector<Knot> knots;  // shares from 0 to 1
  Measure measure = Measure::kVolume;
  bool is_diameter = false;  // what the file gives

  double radius_of(double size) const { return is_diameter ? size / 2 : size; }
  double size_of(double radius) const { return is_diameter ? 2 * radius : radius; }
};

// Reads a CSV file (separators and names of columns as in particle files): one of sizes, ascending, and a column
// passing or volume (by mass or volume) or number, the cumulative share of what is smaller, in percent up to 100 or in
// parts up to 1. Throws particles::Error naming file, line and value of what is wrong.
SizeTable read_size_table(const std::string &path);

}  // namespace packing
