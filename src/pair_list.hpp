// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// All pairs of an index in one array.
#pragma once

#include "index.hpp"
#include "memory.hpp"
#include "overlap.hpp"
#include "particle_store.hpp"

#include <hgrid/types.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hg {

// What a search did, for hg_grid_stats.
struct SearchCounts {
  int64_t candidates = 0, undecided = 0, exact = 0;
  void add(const PairSink &sink) {
    candidates += sink.candidate_count;
    undecided += sink.undecided_count;
    exact += sink.exact_count;
  }
};

// Replaces slots by ids where ids have gaps.
void to_ids(hg_pair *pairs, size_t count, const ParticleStore &store);

class PairList {
 public:
  PairList(Memory &memory, int threads);

  // The same bytes for any number of threads. Pairs hold slots, plus the id of slot 0 if ids have no gaps.
  SearchCounts search(const Index &index, const ParticleStore &store, const Overlap &overlap);

  hg_pair *data() { return pairs_.data(); }
  size_t count() const { return count_; }

 private:
  SearchCounts search_alone(const Index &index, const ParticleStore &store, const Overlap &overlap);
  SearchCounts search_together(const Index &index, const ParticleStore &store, const Overlap &overlap);

  // Where a worker put the pairs of a task.
  struct Segment {
    size_t first, count;
    int worker;
  };

  int threads_;
  Buffer<hg_pair> pairs_;
  size_t count_ = 0;
  std::vector<Buffer<hg_pair>> found_;  // by each worker
  Buffer<Segment> segments_;            // by each task
  Buffer<size_t> offsets_;
};

}  // namespace hg
