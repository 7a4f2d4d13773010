// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How threads share the pairs without waiting for each other, and without a bit depending on how many they are.
#pragma once

#include "dem/state/contact_search.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dem {

// Each thread adds up the forces on a run of particles. It looks at all pairs that have one of them: first at those
// whose first particle comes before the run, which are copied for it, then at its own part of the list. So the sum of
// each particle goes through its pairs in the order of the list, as on one thread; pairs across two runs are reckoned
// twice.
struct Share {
  size_t first_body = 0, last_body = 0;
  size_t first_pair = 0, last_pair = 0;          // in the list
  size_t first_incoming = 0, last_incoming = 0;  // among the copies
  size_t first_wall = 0, last_wall = 0;          // in the list of walls
  size_t first_surface = 0, last_surface = 0;    // in that of walls beside the box's
};

struct Shares {
  std::vector<Share> of_thread;
  std::vector<hg_pair> incoming;  // copies, thread by thread
  std::vector<uint32_t> places;   // of these pairs in the list

  size_t bytes() const { return sizeof(hg_pair) * incoming.capacity() + sizeof(uint32_t) * places.capacity(); }
};

// `pairs` of `count` particles, and the walls and surfaces near them, all ascending.
void share_out(size_t count, int threads, PairView pairs, PairView walls, PairView surfaces, Shares &shares);

}  // namespace dem
