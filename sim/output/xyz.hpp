// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// Extended XYZ, for OVITO: position, radius, velocity, mass and spin.
#ifndef SIM_OUTPUT_XYZ_HPP
#define SIM_OUTPUT_XYZ_HPP

#include "sim/dem/engine.hpp"
#include "sim/dem/setup.hpp"

#include <string>

namespace output {

// `setup` gives the box. Every double reads back unchanged. Throws std::runtime_error if the file cannot be written.
void write_xyz(const std::string &path, const dem::Setup &setup, const dem::Snapshot &state);

}  // namespace output

#endif
