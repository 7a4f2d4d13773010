// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The search of a sparse level, in doubles: all candidates in a particle's search box go to the predicate at once.
#pragma once

#include "src/exact/overlap.hpp"
#include "src/index/index.hpp"
#include "src/kernels/pair_stream.hpp"
#include "src/particles/particle_store.hpp"
#include "src/search/search_tasks.hpp"
#include "src/space/search_box.hpp"

namespace hg {

class SparseSearch {
 public:
  // Pairs name `points`, which search, and `particles`, which are found, by what these have as slots.
  SparseSearch(const Index &index, const ParticleStore &store, const Overlap &overlap, const PointArrays &points,
               const PointArrays &particles, PairStream &stream)
      : index_(index), store_(store), overlap_(overlap), points_(points), particles_(particles), stream_(stream) {}

  // False if the output stopped. Of a task on its own level, only what comes after each particle is looked at.
  bool run(const SearchTask &task, bool own_level);

 private:
  uint32_t slot_of(uint32_t i) const {
    return points_.image != nullptr ? index_.images.slot[i] : index_.particles.slot[i];
  }
  Image image_of(uint32_t i) const { return points_.image != nullptr ? points_.image[i] : kNoImage; }
  SearchBox box_of(uint32_t i, const IndexLevel &target) const;
  bool test(uint32_t i, uint32_t begin, uint32_t end);

  const Index &index_;
  const ParticleStore &store_;
  const Overlap &overlap_;
  const PointArrays &points_;
  const PointArrays &particles_;
  PairStream &stream_;
};

}  // namespace hg
