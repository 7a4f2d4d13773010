// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A list that keeps its memory between runs, filled by a peer on the clock.
#include "programs/bench/peer_searches.hpp"

#include "programs/bench/peers/peer.hpp"
#include "programs/measure/timing.hpp"

#include <memory>
#include <utility>

namespace bench {

std::vector<Contestant> peer_searches(int dimension) {
  std::vector<Contestant> contestants;
  if (dimension != 3) return contestants;
  for (const Peer &peer : all_peers()) {
    Contestant contestant;
    contestant.name = peer.name;
    contestant.variant = peer.variant;
    contestant.tuned = !peer.variant.empty();
    contestant.prepare = [prepare = peer.prepare](const particles::ParticleSet &set) {
      Search search;
      const PairFinder find = prepare({set.count(), set.centers.data(), set.radii.data()});
      if (!find) return search;
      auto list = std::make_shared<std::vector<hg_pair>>();
      search.run = [find, list](PairView &pairs) {
        list->clear();
        const double seconds = measure::seconds_of([&] { find(*list); });
        pairs = {list->data(), list->size()};
        return seconds;
      };
      return search;
    };
    contestants.push_back(std::move(contestant));
  }
  return contestants;
}

}  // namespace bench
