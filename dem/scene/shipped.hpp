// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The scenes of a folder, such as the one that comes with the program.
#pragma once

#include <string>
#include <vector>

namespace scene {

struct Entry {
  std::string path, title;
};

// All scenes of a folder by name. Throws dem::Error if there is none, or naming file and line of one that is not TOML.
std::vector<Entry> scenes_in(const std::string &folder);

}  // namespace scene
