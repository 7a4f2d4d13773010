// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Extended XYZ, for OVITO: position, radius, velocity, mass and spin.
#pragma once

#include "dem/engine/engine.hpp"
#include "dem/setup/setup.hpp"

#include <string>

namespace output {

// `setup` gives the box. Every double reads back unchanged. Throws std::runtime_error if the file cannot be written.
void write_xyz(const std::string &path, const dem::Setup &setup, const dem::Snapshot &state);

}  // namespace output
