// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The ghosts of ranks that are not there, by the rule of libhgrid_mpi itself (mpi/selection.hpp).
#pragma once

#include "mpi/size_boxes.hpp"
#include "programs/ranks/decomposition.hpp"

#include <cstdint>
#include <vector>

namespace ranks {

// What one rank exchanges with others.
struct Exchange {
  int64_t owned = 0;
  int64_t ghosts = 0;         // that it receives
  int64_t sent = 0;           // rows that it sends
  int64_t send_ranks = 0;     // messages of one exchange
  int64_t receive_ranks = 0;  // messages of one exchange back
};

// Of each part.
std::vector<Exchange> exchanges_of(const hgrid::mpi::ReachRule &rule, const std::vector<Part> &parts);

// The same where a halo of one width serves all: every particle counts as large as the largest of all.
std::vector<Part> with_largest_radius(std::vector<Part> parts);

}  // namespace ranks
