// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The search of giants: particles of an index in chunks that are so much larger than its smallest that coordinates
// which wrap cannot tell distances as long as theirs. All that lies in their search boxes goes to the predicate, in
// doubles.
#pragma once

#include "src/exact/overlap.hpp"
#include "src/index/index.hpp"
#include "src/kernels/pair_stream.hpp"
#include "src/particles/particle_store.hpp"
#include "src/search/search_tasks.hpp"

namespace hg {

class GiantPairs {
 public:
  // Pairs name `points`, which search, and `particles`, which are found, by what these have as slots.
  GiantPairs(const Index &index, const ParticleStore &store, const Overlap &overlap, const PointArrays &points,
             const PointArrays &particles, PairStream &stream)
      : index_(index), store_(store), overlap_(overlap), points_(points), particles_(particles), stream_(stream) {}

  // False if the output stopped.
  bool run(const SearchTask &task);

 private:
  PlaceBox box_of(const SearchTask &task, uint32_t i, double radius) const;
  bool test(const SearchTask &task, uint32_t i, uint32_t slot, uint32_t begin, uint32_t end);

  const Index &index_;
  const ParticleStore &store_;
  const Overlap &overlap_;
  const PointArrays &points_;
  const PointArrays &particles_;
  PairStream &stream_;
};

}  // namespace hg
