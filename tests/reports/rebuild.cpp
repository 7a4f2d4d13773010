// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/reports/rebuild.hpp"

#include "tests/support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hgtest {
namespace {

double squared(double x) { return x * x; }

// `atom` of the cell that lies so many edges away.
Point at(const Edges &cell, const Point &atom, int i, int j, int k) {
  const auto &[length, tilt] = cell;
  return {atom[0] + i * length[0] + j * tilt[0] + k * tilt[1], atom[1] + j * length[1] + k * tilt[2],
          atom[2] + k * length[2]};
}

// Neighbours of all atoms of one cell, among all cells there are: each pair twice, an atom not with itself.
size_t neighbours_of_cell(double cutoff, const Edges &cell, const std::vector<Point> &atoms) {
  const auto &[length, tilt] = cell;
  const auto shells = [](double farthest, double edge) { return static_cast<int>(std::ceil(farthest / edge)) + 1; };
  const int nk = shells(cutoff, length[2]), nj = shells(cutoff + nk * std::fabs(tilt[2]), length[1]),
            ni = shells(cutoff + nj * std::fabs(tilt[0]) + nk * std::fabs(tilt[1]), length[0]);
  size_t count = 0;
  for (const Point &a : atoms) {
    for (const Point &b : atoms) {
      for (int i = -ni; i <= ni; i++) {
        for (int j = -nj; j <= nj; j++) {
          for (int k = -nk; k <= nk; k++) {
            if (&a == &b && i == 0 && j == 0 && k == 0) continue;
            const Point image = at(cell, b, i, j, k);
            const double d2 = squared(image[0] - a[0]) + squared(image[1] - a[1]) + squared(image[2] - a[2]);
            count += d2 < squared(cutoff) ? 1 : 0;
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

System tilted(System system, const Point &tilts) {
  std::copy(tilts.begin(), tilts.end(), system.def.tilt);
  return system;
}

System all_images(System system) {
  system.def.images = HG_ALL_IMAGES;
  return system;
}

System crystal(double cutoff, const Edges &cell, const std::vector<Point> &atoms, const std::array<int, 3> &repeats) {
  System system;
  system.cutoff = cutoff;
  for (int i = 0; i < repeats[0]; i++) {
    for (int j = 0; j < repeats[1]; j++) {
      for (int k = 0; k < repeats[2]; k++) {
        for (const Point &atom : atoms) system.centers.push_back(at(cell, atom, i, j, k));
      }
    }
  }
  const size_t cells = static_cast<size_t>(repeats[0]) * static_cast<size_t>(repeats[1] * repeats[2]);
  system.pairs = cells * neighbours_of_cell(cutoff, cell, atoms) / 2;
  const auto &[length, tilt] = cell;
  const auto &[n_a, n_b, n_c] = repeats;
  return tilted(periodic(system, {n_a * length[0], n_b * length[1], n_c * length[2]}),
                {n_b * tilt[0], n_c * tilt[1], n_c * tilt[2]});
}

std::vector<Point> fcc(double edge) {
  const double half = edge / 2;
  return {{0, 0, 0}, {0, half, half}, {half, 0, half}, {half, half, 0}};
}

std::vector<Point> diamond(double edge) {
  const double quarter = edge / 4;
  std::vector<Point> atoms = fcc(edge);
  for (size_t i = 0; i < 4; i++) atoms.push_back({atoms[i][0] + quarter, atoms[i][1] + quarter, atoms[i][2] + quarter});
  return atoms;
}

// Edges of equal length d, at angles of 60 degrees.
Edges primitive_fcc(double edge) {
  const double d = edge / std::sqrt(2);
  return {{d, d * std::sqrt(3) / 2, d * std::sqrt(2.0 / 3)}, {d / 2, d / 2, d * std::sqrt(3) / 6}};
}

// Of equal length d, at angles whose cosine is -1/3.
Edges primitive_bcc(double edge) {
  const double d = edge * std::sqrt(3) / 2;
  return {{d, d * std::sqrt(8) / 3, d * std::sqrt(2.0 / 3)}, {-d / 3, -d / 3, -d * std::sqrt(2) / 3}};
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
    double edges[3];
    for (double &n : edges) n = rng.integer(-boxes, boxes);
    move_by_cells(system.def, edges, center.data());
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
