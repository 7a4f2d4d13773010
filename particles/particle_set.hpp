// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The particles of one file or one packing, with the box they live in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace particles {

// Further numbers of each particle, such as its velocity.
struct Column {
  std::string name;
  size_t width;                // 1, or 3 for vectors, in two dimensions too
  std::vector<double> values;  // [count][width]
};

// When in a simulation the particles are as they are.
struct Moment {
  uint64_t step;
  double time;
};

struct ParticleSet {
  int dimension = 3;            // 2 or 3
  std::vector<double> centers;  // [count][dimension]
  std::vector<double> radii;    // [count]
  bool has_box = false;
  double box_min[3]{}, box_max[3]{};  // the axes beyond `dimension` are 0 in what is read
  int periodic[3]{};                  // only with a box
  double tilt[3]{};                   // of the box: xy, xz, yz of hg_grid_def

  // Written where there are any. Of what is read: velocity, spin, mass, material, if they are asked for.
  std::vector<Column> columns;
  std::optional<Moment> moment;  // never read

  // Of a file, if they are asked for.
  std::vector<std::string> ids, types;  // [count]
  std::vector<std::string> unused;      // the names of the columns that were not read

  std::vector<std::string> notes;  // what a file did not tell

  size_t count() const { return radii.size(); }
  // The values of the column of that name; null: there is none.
  const double *column(const std::string &name) const {
    for (const Column &each : columns) {
      if (each.name == name) return each.values.data();
    }
    return nullptr;
  }
  bool is_tilted() const { return tilt[0] != 0 || tilt[1] != 0 || tilt[2] != 0; }
  const double *center(size_t i) const { return &centers[i * static_cast<size_t>(dimension)]; }
  // `center` holds `dimension` numbers.
  void add(const double *center, double radius) {
    for (int axis = 0; axis < dimension; axis++) centers.push_back(center[axis]);
    radii.push_back(radius);
  }
};

// [count][dimension] to [count][3], the third 0 in two dimensions.
inline std::vector<double> in_three_dimensions(std::vector<double> rows, int dimension) {
  if (dimension == 3) return rows;
  std::vector<double> result;
  result.reserve(rows.size() / 2 * 3);
  for (size_t k = 0; k + 1 < rows.size(); k += 2) result.insert(result.end(), {rows[k], rows[k + 1], 0.0});
  return result;
}

}  // namespace particles
