// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The particles of one file or one packing, with the box they live in.
#pragma once

#include <cstddef>
#include <vector>

namespace particles {

struct ParticleSet {
  int dimension = 3;            // 2 or 3
  std::vector<double> centers;  // [count][dimension]
  std::vector<double> radii;    // [count]
  bool has_box = false;
  double box_min[3]{}, box_max[3]{};  // the axes beyond `dimension` are 0
  int periodic[3]{};                  // only with a box

  size_t count() const { return radii.size(); }
  const double *center(size_t i) const { return &centers[i * static_cast<size_t>(dimension)]; }
  // `center` holds `dimension` numbers.
  void add(const double *center, double radius) {
    for (int axis = 0; axis < dimension; axis++) centers.push_back(center[axis]);
    radii.push_back(radius);
  }
};

}  // namespace particles
