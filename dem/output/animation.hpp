// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A list of VTK files with their times (.pvd), which ParaView opens as one animation.
#pragma once

#include <string>
#include <vector>

namespace output {

struct TimedFile {
  double time;
  std::string name;  // relative to the list
};

void write_animation(const std::string &path, const std::vector<TimedFile> &files);

// Empty if there is no such file. Throws particles::Error if it is something else.
std::vector<TimedFile> read_animation(const std::string &path);

}  // namespace output
