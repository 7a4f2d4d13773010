// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The library as a contestant, in all its settings.
#pragma once

#include "programs/bench/search.hpp"

#include <string>
#include <vector>

namespace bench {

inline constexpr const char *kLibrary = "library";

// The instruction sets that this machine and build can run, fastest first: the library takes the first by itself. If
// HGRID_ISA is set, that one alone. Must not be called from a process that uses the library itself.
std::vector<std::string> usable_instruction_sets();

// How a library contestant differs from the defaults.
struct LibrarySetting {
  std::string isa;
  int threads = 1;
  Accuracy accuracy = Accuracy::kExact;
  bool by_id = false;            // HG_ORDER_ID
  bool levels_of_paper = false;  // HG_LEVELS_PAPER
  int level_count = 0;           // 0: as the rule chooses
};

// Times hg_clear, hg_insert and hg_query_pairs on a grid that keeps its memory between runs.
Contestant library_search(const LibrarySetting &setting);

// Times hg_move and hg_query_pairs over time steps in which each particle flies straight on, by up to `longest_step`
// per step; the time is that of a step, on average. Every run begins where `set` is.
Contestant library_steps(const LibrarySetting &setting, double skin, int steps, double longest_step);
// Where the particles are after so many steps.
particles::ParticleSet moved(const particles::ParticleSet &set, int steps, double longest_step);

// The cell sizes that the level rule of the paper gives for so many levels (0: as it chooses); may be fewer. To be
// called in a process of its own.
std::vector<double> cell_sizes_of_paper(const particles::ParticleSet &set, int level_count);

}  // namespace bench
