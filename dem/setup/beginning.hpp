// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a run stands when a simulation begins: of the first stage of a scene nowhere, of a later one where the stage
// before has ended.
#pragma once

#include "dem/effects/table.hpp"

#include <hgrid/hgrid.h>

#include <array>
#include <cstdint>
#include <vector>

namespace dem {

// What contacts of one kind remember.
struct ContactMemory {
  std::vector<hg_pair> pairs;                           // ascending; of two particles, or of a particle and a wall
  std::array<std::vector<double>, kHistoryCount> rows;  // by history_of(effect), a vector for each pair, or empty
};

struct Beginning {
  uint64_t step = 0;
  double time = 0;
  double image_offset = 0;  // how far the images above have moved along x (shear)
  ContactMemory pairs, walls;
};

}  // namespace dem
