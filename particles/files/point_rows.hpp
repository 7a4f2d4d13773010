// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Particles of files that hold arrays instead of rows, as those of VTK.
#pragma once

#include "particles/files/reader.hpp"
#include "particles/particle_set.hpp"

#include <string>
#include <vector>

namespace particles {

struct PointArray {
  std::string name;
  size_t width;
  std::vector<double> values;  // [points][width]
};

// The points ([count][3]) with what their arrays tell, read as rows are. Messages name `file` and the point, from 1.
// Arrays of another length than the points' are passed over.
ParticleSet particles_of_points(const std::string &file, const std::vector<double> &points,
                                const std::vector<PointArray> &arrays, const ReadOptions &options);

}  // namespace particles
