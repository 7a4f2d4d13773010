// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Equations of state of hard spheres and disks in terms of the moments of their radii.
#include "packing/event/fluid.hpp"

namespace packing::event {

Fluid::Fluid(const std::vector<double> &radii, int dimension) : dimension_(dimension) {
  for (const double r : radii) {
    mean_[0] += r;
    mean_[1] += r * r;
    mean_[2] += r * r * r;
  }
  for (double &mean : mean_) mean /= static_cast<double>(radii.size());
}

double Fluid::compressibility(double density) const {
  const double free = 1 - density;
  if (dimension_ == 2) {
    return 1 / free + mean_[0] * mean_[0] / mean_[1] * density / (free * free);
  }
  const double o1 = mean_[0] * mean_[1] / mean_[2];
  const double o2 = mean_[1] * mean_[1] * mean_[1] / (mean_[2] * mean_[2]);
  return 1 / free + 3 * o1 * density / (free * free) + o2 * density * density * (3 - density) / (free * free * free);
}

}  // namespace packing::event
