// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A crowd with stored candidates, and what of them interacts.
#pragma once

#include "src/search/candidate_filter.hpp"
#include "src/search/stored_candidates.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/crowd.hpp"

#include <algorithm>

namespace hgtest {

struct Stored {
  Stored(uint64_t seed, const CrowdShape &shape, int threads = 1)
      : memory(hg::system_allocator()),
        crowd(seed, memory, shape),
        pool(memory, threads),
        candidates(memory, threads) {}

  bool collect() {
    hg::SearchCounts counts;
    return candidates.collect(crowd.index, crowd.tasks, crowd.store, crowd.overlap.interaction(), pool, counts);
  }
  // The interacting ones, in their order.
  Pairs filtered() {
    hg::PairList list(memory);
    const hg::SearchCounts counts =
        list.gather(hg::CandidateFilter(candidates, crowd.store, crowd.overlap), pool, crowd.store.slots());
    require(counts.candidates == static_cast<int64_t>(candidates.count()), "%lld candidates were filtered",
            static_cast<long long>(counts.candidates));
    return Pairs(list.data(), list.data() + list.count());
  }
  // The same, asked for one by one.
  Pairs decided() const {
    Pairs pairs;
    int64_t exact = 0;
    for (size_t k = 0; k < candidates.count(); k++) {
      const auto a = static_cast<uint32_t>(candidates.pairs()[k].a), b = static_cast<uint32_t>(candidates.pairs()[k].b);
      if (candidates.interact(a, b, crowd.store, crowd.overlap, exact))
        pairs.push_back(slots_of(candidates.pairs()[k]));
    }
    return pairs;
  }
  // A candidate as a pair of particles.
  hg_pair slots_of(const hg_pair &pair) const {
    if (candidates.direct()) return pair;
    const auto a = static_cast<int32_t>(candidates.slots()[pair.a]),
               b = static_cast<int32_t>(candidates.slots()[pair.b]);
    return {std::min(a, b), std::max(a, b)};
  }

  hg::Memory memory;
  Crowd crowd;
  hg::PairPool pool;
  hg::StoredCandidates candidates;
};

inline CrowdShape skinned_shape(Rng &rng, size_t count) {
  CrowdShape shape = any_shape(rng, count);
  static constexpr double kSkins[] = {0.01, 0.5, 4};
  shape.skin = kSkins[rng.below(3)];
  shape.interaction = {rng.chance(0.5) ? HG_CONTACT : HG_MAX_RANGE, rng.chance(0.5) ? 0.0 : 1.0};
  return shape;
}

}  // namespace hgtest
