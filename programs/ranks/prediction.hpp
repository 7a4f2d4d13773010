// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How long a step of a simulation over ranks may take, from what each rank has to do and to exchange, and from what is
// assumed of machine and code. A model: nothing overlaps, the slowest rank tells.
#pragma once

#include "programs/ranks/ghosts.hpp"

#include <vector>

namespace ranks {

struct Assumptions {
  // Of the code, per step; the search and the choice of ghosts every `interval` steps.
  double particle_ns = 25, pair_ns = 30, search_ns = 50, choice_ns = 55, interval = 10;
  double forward_bytes = 72, back_bytes = 48;  // of a ghost: place, velocity, spin; force and torque
  // Of the machine. Ranks of a node form a block; what leaves it shares the node's network.
  double node_ranks = 64, node_gb_per_s = 25, rank_gb_per_s = 2, latency_us = 2;
};

// An assumption as an option: its name, place and meaning.
struct AssumptionRow {
  const char *option;
  double Assumptions::*value;
  const char *meaning;
};
const std::vector<AssumptionRow> &assumption_rows();

// What one rank does.
struct Load {
  Exchange exchange;
  double pairs = 0;  // that it finds
};

// The same for all ranks.
struct Machine {
  int rank_count = 1;
  int dimension = 3;
  double boxes = 0;  // that each rank tells all others, about
};

double bytes_per_step(const Load &load, const Assumptions &assumed);
// Seconds of one step of this rank.
double step_seconds(const Load &load, const Machine &machine, const Assumptions &assumed);
// Of the work alone, on one rank that has all.
double serial_seconds(double particles, double pairs, const Assumptions &assumed);

}  // namespace ranks
