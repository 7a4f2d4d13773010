// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Triangle meshes in STL files, as text or binary.
#pragma once

#include <string>
#include <vector>

namespace scene {

// The corners of all triangles, [count][3 corners][3], as they stand in the file; the normals in it are not looked at.
// Throws dem::Error naming the file and the place of what is wrong.
std::vector<double> read_stl(const std::string &path);

}  // namespace scene
