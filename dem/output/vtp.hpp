// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// VTK PolyData in XML (.vtp), for ParaView: one vertex per particle with its radius, velocity, mass and spin.
#pragma once

#include "dem/engine/engine.hpp"

#include <string>
#include <vector>

namespace output {

// Numbers are stored as the machine holds them, in base64. Two-dimensional states get z = 0. Throws dem::Error.
void write_vtp(const std::string &path, const dem::Snapshot &state);

// A list of such files with their times (.pvd), which ParaView opens as one animation.
struct TimedFile {
  double time;
  std::string name;  // relative to the list
};
void write_pvd(const std::string &path, const std::vector<TimedFile> &files);
// Empty if there is no such file; throws dem::Error if it is something else.
std::vector<TimedFile> read_pvd(const std::string &path);

}  // namespace output
