// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a run stands when a simulation begins: of the first stage of a scene nowhere, of a later one where the stage
// before has ended.
#pragma once

#include "dem/effects/table.hpp"
#include "dem/setup/wall_body.hpp"

#include <hgrid/hgrid.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace dem {

// What contacts of one kind remember.
struct ContactMemory {
  std::vector<hg_pair> pairs;                           // ascending; of two particles, or of a particle and a wall
  std::array<std::vector<double>, kHistoryCount> rows;  // by history_of(effect), a vector for each pair, or empty
};

// Its arrays under the names that they have in checkpoints: what is written and what is read is one list.
template <class SomeMemory, class Visit>
void visit_memory(const std::string &name, SomeMemory &memory, Visit visit) {
  visit(name + " pairs", memory.pairs);
  for (size_t k = 0; k < kHistoryCount; k++) visit(name + " rows " + std::to_string(k), memory.rows[k]);
}

// Where a wall beside those of the box stands, and which numbers its surfaces have.
struct NamedPlace {
  std::string name;
  WallPlace place;
  size_t first_surface = 0, surface_count = 0;
};

struct Beginning {
  uint64_t step = 0;
  double time = 0;
  double image_offset = 0;  // how far the images above have moved along x (shear)
  ContactMemory pairs, walls, surfaces;
  std::vector<NamedPlace> wall_places;
};

}  // namespace dem
