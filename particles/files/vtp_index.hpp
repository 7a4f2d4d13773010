// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The index of a set whose parts stand in several VTK PolyData files (.pvtp), which ParaView opens as one.
#pragma once

#include "particles/particle_set.hpp"

#include <string>
#include <vector>

namespace particles {

// `part` is one of the sets, all of which have the same columns; pieces: the names of their files, relative to the
// index. Throws Error if the file cannot be written completely.
void write_vtp_index(const std::string &path, const ParticleSet &part, const std::vector<std::string> &pieces);

}  // namespace particles
