// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// All pairs of a source in one array.
#pragma once

#include "src/base/memory.hpp"
#include "src/pairs/pair_source.hpp"
#include "src/particles/particle_store.hpp"

#include <hgrid/types.h>

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace hg {

// Replaces slots by ids where ids have gaps.
void to_ids(hg_pair *pairs, size_t count, const ParticleStore &store);

// What threads need to gather pairs, kept between calls. Several lists may take turns with it. Memory comes in chunks
// that whoever finds pairs takes next, so its size does not depend on who finds them.
class PairPool {
 public:
  PairPool(Memory &memory, int threads);
  ~PairPool();
  PairPool(const PairPool &) = delete;
  PairPool &operator=(const PairPool &) = delete;

 private:
  friend class PairList;

  // Pairs of one task that lie together. A task has several if they do not fit into one chunk.
  struct Piece {
    size_t task, offset;  // among the pairs of the task
    size_t count;
    const hg_pair *pairs;
  };
  struct Worker;

  // Forgets all pieces.
  void start(const PairSource &source, size_t most);
  hg_pair *take_chunk();
  void add_chunk();
  // As many chunks as that number of pairs can take, however the workers share them out: so that the next step, with
  // about as many, needs no more.
  void provide(size_t pairs);

  Memory *memory_;
  int threads_;
  std::mutex mutex_;
  std::vector<Buffer<hg_pair>> chunks_;
  size_t taken_ = 0;
  std::vector<Worker> workers_;
  Buffer<size_t> begin_;  // of each task in the list
};

class PairList {
 public:
  explicit PairList(Memory &memory) : pairs_(memory) {}

  // The same bytes for any number of threads. Gathering may stop early once there are more than `most` pairs; what it
  // has then is of no use.
  SearchCounts gather(const PairSource &source, PairPool &pool, size_t particles, size_t most = SIZE_MAX);

  // With room for kPadding more behind them.
  hg_pair *data() { return pairs_.data(); }
  const hg_pair *data() const { return pairs_.data(); }
  size_t count() const { return count_; }

 private:
  SearchCounts gather_alone(const PairSource &source, size_t particles, size_t most);
  SearchCounts gather_together(const PairSource &source, PairPool &pool, size_t most);

  Buffer<hg_pair> pairs_;
  size_t count_ = 0;
};

}  // namespace hg
