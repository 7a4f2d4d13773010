// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The network of contacts as VTK PolyData: a line for each contact, with its forces.
#pragma once

#include "dem/engine/engine.hpp"

#include <string>
#include <vector>

namespace output {

// Numbers of the lines: normal and tangential force, overlap, the particles a and b (-1: a wall).
void write_network(const std::string &path, double time, const std::vector<dem::ContactLine> &lines);

}  // namespace output
