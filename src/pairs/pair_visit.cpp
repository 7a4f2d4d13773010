// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/pairs/pair_visit.hpp"

#include <algorithm>

namespace hg {
namespace {

static_assert(kVisitBatch >= kMaxPiece + kPadding, "a piece of candidates must fit into an empty batch");

// Room in a batch that is handed over when it is full.
class BatchRoom {
 public:
  BatchRoom(Buffer<hg_pair> &batch, const ParticleStore &particles, hg_pair_visitor *visit, void *context)
      : batch_(batch), particles_(particles), visit_(visit), context_(context) {
    batch_.require(kVisitBatch);
  }

  PairOutput output() {
    const auto make_room = [](PairOutput *output, size_t) {
      return static_cast<BatchRoom *>(output->owner)->hand_over(*output);
    };
    return {batch_.data(), batch_.data() + kVisitBatch, this, make_room};
  }

  // Hands over what has gathered. False once the visitor has had enough.
  bool hand_over(PairOutput &output) {
    const auto count = static_cast<size_t>(output.next - batch_.data());
    output.next = batch_.data();
    if (stopped_ || count == 0) return !stopped_;
    visited_ += count;
    to_ids(batch_.data(), count, particles_);
    stopped_ = visit_(context_, batch_.data(), count) != 0;
    return !stopped_;
  }
  size_t visited() const { return visited_; }

 private:
  Buffer<hg_pair> &batch_;
  const ParticleStore &particles_;
  hg_pair_visitor *visit_;
  void *context_;
  size_t visited_ = 0;
  bool stopped_ = false;
};

}  // namespace

VisitResult visit_source(const PairSource &source, const ParticleStore &store, Memory &memory, hg_pair_visitor *visit,
                         void *context) {
  Buffer<hg_pair> batch(memory);
  BatchRoom room(batch, store, visit, context);
  PairStream stream(source.judge(), room.output());
  bool go_on = true;
  for (size_t task = 0; go_on && task < source.task_count(); task++) go_on = source.send(task, stream);
  if (go_on) room.hand_over(stream.output);
  VisitResult result;
  result.counts.add(stream);
  result.pairs = room.visited();
  return result;
}

void visit_list(const hg_pair *pairs, size_t count, hg_pair_visitor *visit, void *context) {
  for (size_t first = 0; first < count; first += kVisitBatch) {
    if (visit(context, pairs + first, std::min(kVisitBatch, count - first)) != 0) return;
  }
}

}  // namespace hg
