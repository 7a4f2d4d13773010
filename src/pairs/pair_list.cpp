// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/pairs/pair_list.hpp"

#include "src/base/parallel.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <optional>
#include <utility>

namespace hg {
namespace {

constexpr size_t kChunkPairs = 16384;
static_assert(kChunkPairs >= kMaxPiece + kPadding, "a piece of candidates must fit into an empty chunk");

// Room in a buffer that grows.
class GrowingRoom {
 public:
  GrowingRoom(Buffer<hg_pair> &pairs, size_t most) : pairs_(pairs), most_(most) { pairs_.grow(kMaxPiece + kPadding); }

  PairOutput output() {
    const auto make_room = [](PairOutput *output, size_t more) {
      auto &self = *static_cast<GrowingRoom *>(output->owner);
      const size_t used = self.used(*output);
      if (used > self.most_) return false;
      self.pairs_.grow(used + more);
      output->next = self.pairs_.data() + used;
      output->limit = self.pairs_.data() + self.pairs_.capacity();
      return true;
    };
    return {pairs_.data(), pairs_.data() + pairs_.capacity(), this, make_room};
  }
  size_t used(const PairOutput &output) const { return static_cast<size_t>(output.next - pairs_.data()); }

 private:
  Buffer<hg_pair> &pairs_;
  size_t most_;
};

}  // namespace

void to_ids(hg_pair *pairs, size_t count, const ParticleStore &store) {
  if (store.contiguous()) return;
  for (size_t p = 0; p < count; p++) {
    pairs[p] = {store.id(static_cast<size_t>(pairs[p].a)), store.id(static_cast<size_t>(pairs[p].b))};
  }
}

// On cache lines of its own. Fills chunks and notes what lies where.
struct alignas(128) PairPool::Worker {
  Worker(PairPool &all, Memory &memory) : pool(all), pieces(memory) {}

  void start(const PairSource &source, size_t most_pairs) {
    const auto make_room = [](PairOutput *output, size_t) {
      return static_cast<Worker *>(output->owner)->change_chunk();
    };
    stream.emplace(source.judge(), PairOutput{nullptr, nullptr, this, make_room});
    first = nullptr;
    piece_count = pairs = 0;
    most = most_pairs;
  }

  bool change_chunk() {
    end_piece();
    if (pairs > most) return false;
    first = stream->output.next = pool.take_chunk();
    stream->output.limit = first + kChunkPairs;
    return true;
  }

  void run(const PairSource &source, size_t new_task) {
    task = new_task;
    task_pairs = 0;
    first = stream->output.next;
    source.send(task, *stream);
    end_piece();
  }

  void end_piece() {
    const auto count = static_cast<size_t>(stream->output.next - first);
    if (count == 0) return;
    pieces.grow(piece_count + 1);
    pieces[piece_count++] = {task, task_pairs, count, first};
    task_pairs += count;
    pairs += count;
    first = stream->output.next;
  }

  PairPool &pool;
  Buffer<Piece> pieces;
  std::optional<PairStream> stream;
  size_t piece_count = 0, pairs = 0, most = 0;
  size_t task = 0, task_pairs = 0;
  hg_pair *first = nullptr;  // of the piece that is being filled
};

PairPool::PairPool(Memory &memory, int threads) : memory_(&memory), threads_(threads), begin_(memory) {
  if (threads == 1) return;
  workers_.reserve(static_cast<size_t>(threads));
  for (int worker = 0; worker < threads; worker++) workers_.emplace_back(*this, memory);
}

PairPool::~PairPool() = default;

void PairPool::start(const PairSource &source, size_t most) {
  taken_ = 0;
  for (Worker &worker : workers_) {
    worker.start(source, most);
    worker.pieces.grow(source.task_count() + chunks_.size() + 1);  // all tasks, cut where chunks end
  }
}

hg_pair *PairPool::take_chunk() {
  const std::lock_guard lock(mutex_);
  if (taken_ == chunks_.size()) add_chunk();
  return chunks_[taken_++].data();
}

void PairPool::add_chunk() {
  Buffer<hg_pair> chunk(*memory_);
  chunk.require(kChunkPairs);
  chunks_.push_back(std::move(chunk));
}

void PairPool::provide(size_t pairs) {
  const auto most = [&](size_t count) { return count / (kChunkPairs - kMaxPiece - kPadding) + workers_.size(); };
  if (chunks_.size() >= most(pairs)) return;
  while (chunks_.size() < most(pairs + pairs / 8)) add_chunk();
}

SearchCounts PairList::gather(const PairSource &source, PairPool &pool, size_t particles, size_t most) {
  const bool together = pool.threads_ > 1 && particles >= kWorthThreads;
  return together ? gather_together(source, pool, most) : gather_alone(source, particles, most);
}

SearchCounts PairList::gather_alone(const PairSource &source, size_t particles, size_t most) {
  pairs_.grow(particles);
  GrowingRoom room(pairs_, most);
  PairStream stream(source.judge(), room.output());
  bool go_on = true;
  for (size_t task = 0; go_on && task < source.task_count(); task++) go_on = source.send(task, stream);
  count_ = room.used(stream.output);
  pairs_.grow(count_ + kPadding);
  SearchCounts counts;
  counts.add(stream);
  return counts;
}

SearchCounts PairList::gather_together(const PairSource &source, PairPool &pool, size_t most) {
  const size_t tasks = source.task_count();
  pool.start(source, most);
  parallel_for(pool.threads_, tasks,
               [&](size_t task, int worker) { pool.workers_[static_cast<size_t>(worker)].run(source, task); });

  pool.begin_.require_room(tasks + 1);
  size_t *begin = pool.begin_.data();
  std::fill(begin, begin + tasks + 1, size_t{0});
  for (const PairPool::Worker &worker : pool.workers_) {
    for (size_t p = 0; p < worker.piece_count; p++) begin[worker.pieces[p].task + 1] += worker.pieces[p].count;
  }
  std::partial_sum(begin, begin + tasks + 1, begin);
  count_ = begin[tasks];
  pool.provide(count_);
  pairs_.require_room(count_ + kPadding);
  parallel_for(pool.threads_, pool.workers_.size(), [&](size_t n, int) {
    const PairPool::Worker &worker = pool.workers_[n];
    for (size_t p = 0; p < worker.piece_count; p++) {
      const PairPool::Piece &piece = worker.pieces[p];
      std::memcpy(pairs_.data() + begin[piece.task] + piece.offset, piece.pairs, piece.count * sizeof(hg_pair));
    }
  });
  SearchCounts counts;
  for (const PairPool::Worker &worker : pool.workers_) counts.add(*worker.stream);
  return counts;
}

}  // namespace hg
