// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What contacts remember, in rows that follow a particle to another rank. The smaller particle of a pair keeps it, as
// its rank is the one that finds the pair.
#pragma once

#include "dem/setup/beginning.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dem::ranks {

// Of one contact of the particle that keeps it; vectors are those of the pair, smaller name first.
struct Spring {
  int64_t partner = -1;  // name of a particle; -2 - wall; -1: there is none
  double rows[kHistoryCount][3]{};
};

// Names, radii and memory of particles that a rank knows.
struct KnownParticles {
  const std::vector<int64_t> *names;
  const std::vector<double> *radii;
  size_t owned;  // come first
};

// Of each owned particle.
std::vector<std::vector<Spring>> springs_of(const KnownParticles &particles, const ContactMemory &pairs,
                                            const ContactMemory &walls, int dimension);

// The other way; `width` springs for each particle, one after the other.
struct Memories {
  ContactMemory pairs, walls;
};
Memories memories_of(const std::vector<int64_t> &names, const std::vector<Spring> &springs, size_t width,
                     int dimension);

// Several in one, ascending.
ContactMemory joined(const std::vector<ContactMemory> &memories, int dimension);

}  // namespace dem::ranks
