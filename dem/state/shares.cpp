// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How threads share the pairs.
#include "dem/state/shares.hpp"

#include <algorithm>

namespace dem {
namespace {

// The first pair of an ascending list whose first particle is not before `body`.
size_t first_with(PairView pairs, size_t body) {
  const hg_pair *end = pairs.data() + pairs.size();
  const auto before = [](const hg_pair &pair, size_t wanted) { return static_cast<size_t>(pair.a) < wanted; };
  return static_cast<size_t>(std::lower_bound(pairs.data(), end, body, before) - pairs.data());
}

}  // namespace

void share_out(size_t count, int threads, PairView pairs, PairView walls, PairView surfaces, Shares &shares) {
  const auto parts = static_cast<size_t>(threads);
  std::vector<uint32_t> crossing;  // places of pairs across two runs
  shares.of_thread.resize(parts);
  for (size_t part = 0; part < parts; part++) {
    Share &share = shares.of_thread[part];
    share.first_body = count * part / parts;
    share.last_body = count * (part + 1) / parts;
    share.first_pair = first_with(pairs, share.first_body);
    share.last_pair = first_with(pairs, share.last_body);
    share.first_wall = first_with(walls, share.first_body);
    share.last_wall = first_with(walls, share.last_body);
    share.first_surface = first_with(surfaces, share.first_body);
    share.last_surface = first_with(surfaces, share.last_body);
    if (share.last_body == count) continue;
    for (size_t p = share.first_pair; p < share.last_pair; p++) {
      if (static_cast<size_t>(pairs[p].b) >= share.last_body) crossing.push_back(static_cast<uint32_t>(p));
    }
  }
  shares.incoming.clear();
  shares.places.clear();
  for (Share &share : shares.of_thread) {
    share.first_incoming = shares.incoming.size();
    for (const uint32_t p : crossing) {
      const auto b = static_cast<size_t>(pairs[p].b);
      if (p >= share.first_pair || b < share.first_body || b >= share.last_body) continue;
      shares.incoming.push_back(pairs[p]);
      shares.places.push_back(p);
    }
    share.last_incoming = shares.incoming.size();
  }
}

}  // namespace dem
