// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A list of VTK files with their times (.pvd), which ParaView opens as one animation.
#pragma once

#include <cstdint>
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

// "state-000000000100.vtp": files sort by step, by name too.
std::string name_of_step(const char *what, uint64_t step, const std::string &format);

// Those of the list up to the one of this name.
std::vector<TimedFile> files_until(const std::string &list, const std::string &last);

}  // namespace output
