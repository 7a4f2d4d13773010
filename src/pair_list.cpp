// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pair_list.hpp"

#include "pair_search.hpp"
#include "parallel.hpp"

#include <algorithm>
#include <cstring>

namespace hg {
namespace {

// Appends to a buffer that grows.
class ListSink : public PairSink {
 public:
  explicit ListSink(Buffer<hg_pair> &pairs) : PairSink{}, pairs_(pairs) {
    pairs_.grow(kMaxPiece + kPadding);
    point_to(0);
    make_room = [](PairSink *sink, size_t more) {
      auto &self = *static_cast<ListSink *>(sink);
      self.settle(sink);
      const size_t used = self.count();
      self.pairs_.grow(used + more);
      self.point_to(used);
      return true;
    };
  }
  size_t count() const { return static_cast<size_t>(next - pairs_.data()); }

 private:
  void point_to(size_t used) {
    next = pairs_.data() + used;
    limit = pairs_.data() + pairs_.capacity();
  }
  Buffer<hg_pair> &pairs_;
};

// Each worker's sink on cache lines of its own.
struct alignas(128) WorkerSink : ListSink {
  using ListSink::ListSink;
};

}  // namespace

void to_ids(hg_pair *pairs, size_t count, const ParticleStore &store) {
  if (store.contiguous()) return;
  for (size_t p = 0; p < count; p++) {
    pairs[p] = {store.id(static_cast<size_t>(pairs[p].a)), store.id(static_cast<size_t>(pairs[p].b))};
  }
}

PairList::PairList(Memory &memory, int threads)
    : threads_(threads), pairs_(memory), segments_(memory), offsets_(memory) {
  if (threads == 1) return;
  found_.reserve(static_cast<size_t>(threads));
  for (int worker = 0; worker < threads; worker++) found_.emplace_back(memory);
}

SearchCounts PairList::search(const Index &index, const ParticleStore &store, const Overlap &overlap) {
  const bool together = threads_ > 1 && store.slots() >= kWorthThreads;
  return together ? search_together(index, store, overlap) : search_alone(index, store, overlap);
}

SearchCounts PairList::search_alone(const Index &index, const ParticleStore &store, const Overlap &overlap) {
  pairs_.grow(store.slots());
  ListSink sink(pairs_);
  prepare_sink(sink, index, store, overlap);
  for (size_t task = 0; task < index.task_count; task++) search_task(index.tasks[task], index, store, sink);
  count_ = sink.count();
  SearchCounts counts;
  counts.add(sink);
  return counts;
}

SearchCounts PairList::search_together(const Index &index, const ParticleStore &store, const Overlap &overlap) {
  std::vector<WorkerSink> sinks;
  sinks.reserve(found_.size());
  for (Buffer<hg_pair> &found : found_) {
    sinks.emplace_back(found);
    prepare_sink(sinks.back(), index, store, overlap);
  }
  segments_.require(index.task_count);
  parallel_for(threads_, index.task_count, [&](size_t task, int worker) {
    WorkerSink &sink = sinks[static_cast<size_t>(worker)];
    const size_t first = sink.count();
    search_task(index.tasks[task], index, store, sink);
    segments_[task] = {first, sink.count() - first, worker};
  });

  offsets_.require(index.task_count);
  count_ = 0;
  for (size_t task = 0; task < index.task_count; task++) {
    offsets_[task] = count_;
    count_ += segments_[task].count;
  }
  pairs_.require(std::max<size_t>(1, count_));
  parallel_for(threads_, index.task_count, [&](size_t task, int) {
    const Segment &segment = segments_[task];
    if (segment.count == 0) return;
    std::memcpy(pairs_.data() + offsets_[task], found_[static_cast<size_t>(segment.worker)].data() + segment.first,
                segment.count * sizeof(hg_pair));
  });
  SearchCounts counts;
  for (const WorkerSink &sink : sinks) counts.add(sink);
  return counts;
}

}  // namespace hg
