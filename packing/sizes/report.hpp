// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What so many particles can represent of a curve of sizes.
#pragma once

#include "packing/size_law.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace packing {

struct Fraction {
  double from, to;  // radii
  double expected;  // particles, of which no more than whole ones can be there
  size_t particles;
  double wanted, found;  // shares of the volume (2D: area) between the ends of the curve
};

struct SizeReport {
  std::vector<Fraction> fractions;  // between sieves; those that the curve leaves empty are skipped
  Measure measure;                  // of the shares beyond the ends
  double finer, coarser;
};

// Of a law that is a curve, for radii in any order that are `scale` times those of the law.
SizeReport report_sizes(const SizeLaw &law, std::vector<double> radii, double scale);

// Fewest particles of which the coarsest fraction gets `wanted`.
double count_for_coarsest(const SizeReport &report, double wanted);

// A table of the fractions and what is left out, sizes in the unit of the radii.
std::string words_of(const SizeReport &report);

}  // namespace packing
