// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/reports/rebuild.hpp"

#include <cmath>
#include <utility>

namespace hgtest {
namespace {

double squared(double x) { return x * x; }

// Neighbours of all atoms of one cell, among all cells there are: each pair twice, an atom not with itself.
size_t neighbours_of_cell(double cutoff, const Point &cell, const std::vector<Point> &atoms) {
  const auto shells = [&](int axis) { return static_cast<int>(std::ceil(cutoff / cell[axis])) + 1; };
  size_t count = 0;
  for (const Point &a : atoms) {
    for (const Point &b : atoms) {
      for (int i = -shells(0); i <= shells(0); i++) {
        for (int j = -shells(1); j <= shells(1); j++) {
          for (int k = -shells(2); k <= shells(2); k++) {
            if (&a == &b && i == 0 && j == 0 && k == 0) continue;
            count += squared(b[0] - a[0] + i * cell[0]) + squared(b[1] - a[1] + j * cell[1]) +
                                 squared(b[2] - a[2] + k * cell[2]) <
                             squared(cutoff)
                         ? 1
                         : 0;
          }
        }
      }
    }
  }
  return count;
}

}  // namespace

System within(double cutoff, std::vector<Point> centers, std::optional<size_t> pairs) {
  System system;
  system.cutoff = cutoff;
  system.centers = std::move(centers);
  system.pairs = pairs;
  return system;
}

System periodic(System system, const Point &lengths) {
  for (size_t axis = 0; axis < 3; axis++) {
    if (!(lengths[axis] > 0)) continue;
    system.def.periodic[axis] = 1;
    system.def.box_max[axis] = lengths[axis];
  }
  return system;
}

System crystal(double cutoff, const Point &cell, const std::vector<Point> &atoms, const std::array<int, 3> &repeats) {
  System system;
  system.cutoff = cutoff;
  Point lengths;
  for (size_t axis = 0; axis < 3; axis++) lengths[axis] = cell[axis] * repeats[axis];
  for (int i = 0; i < repeats[0]; i++) {
    for (int j = 0; j < repeats[1]; j++) {
      for (int k = 0; k < repeats[2]; k++) {
        for (const Point &atom : atoms) {
          system.centers.push_back({atom[0] + i * cell[0], atom[1] + j * cell[1], atom[2] + k * cell[2]});
        }
      }
    }
  }
  const size_t cells = static_cast<size_t>(repeats[0]) * static_cast<size_t>(repeats[1] * repeats[2]);
  system.pairs = cells * neighbours_of_cell(cutoff, cell, atoms) / 2;
  return periodic(system, lengths);
}

std::vector<Point> fcc(double edge) {
  const double half = edge / 2;
  return {{0, 0, 0}, {0, half, half}, {half, 0, half}, {half, half, 0}};
}

std::vector<Point> cloud(uint64_t seed, size_t count, const Point &low, const Point &high) {
  Rng rng(seed);
  std::vector<Point> centers(count);
  for (Point &center : centers) {
    for (size_t axis = 0; axis < 3; axis++) center[axis] = rng.uniform(low[axis], high[axis]);
  }
  return centers;
}

System in_other_images(System system, uint64_t seed, int boxes) {
  Rng rng(seed);
  for (Point &center : system.centers) {
    for (size_t axis = 0; axis < 3; axis++) {
      if (system.def.periodic[axis] == 0) continue;
      center[axis] += rng.integer(-boxes, boxes) * (system.def.box_max[axis] - system.def.box_min[axis]);
    }
  }
  return system;
}

System in_floats(System system) {
  for (Point &center : system.centers) {
    for (double &x : center) x = static_cast<double>(static_cast<float>(x));
  }
  return system;
}

System moved(System system, const Point &by) {
  for (Point &center : system.centers) {
    for (size_t axis = 0; axis < 3; axis++) center[axis] += by[axis];
  }
  return system;
}

System named(std::string name, System system) {
  system.name = std::move(name);
  return system;
}

Particles spheres(const std::vector<Point> &centers, double radius) {
  Particles particles;
  for (const Point &center : centers) particles.add(center.data(), radius);
  return particles;
}

}  // namespace hgtest
