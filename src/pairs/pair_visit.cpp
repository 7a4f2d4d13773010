// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/pairs/pair_visit.hpp"

#include <algorithm>

namespace hg {
namespace {

static_assert(kVisitBatch >= kMaxPiece + kPadding, "a piece of candidates must fit into an empty batch");

// A batch that is handed over when it is full.
class BatchOutput : public PairOutput {
 public:
  BatchOutput(Buffer<hg_pair> &batch, const ParticleStore &particles, hg_pair_visitor *visit, void *context)
      : PairOutput{}, batch_(batch), particles_(particles), visit_(visit), context_(context) {
    batch_.require(kVisitBatch);
    next = batch_.data();
    limit = batch_.data() + kVisitBatch;
    make_room = [](PairOutput *output, size_t) { return static_cast<BatchOutput *>(output)->flush(); };
  }

  // Hands over what has gathered. False once the visitor has had enough.
  bool flush() {
    const size_t count = static_cast<size_t>(next - batch_.data());
    next = batch_.data();
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
  BatchOutput output(batch, store, visit, context);
  PairStream stream(source.judge(), &output);
  bool go_on = true;
  for (size_t task = 0; go_on && task < source.task_count(); task++) go_on = source.send(task, stream);
  if (go_on) output.flush();
  VisitResult result;
  result.counts.add(stream);
  result.pairs = output.visited();
  return result;
}

void visit_list(const hg_pair *pairs, size_t count, hg_pair_visitor *visit, void *context) {
  for (size_t first = 0; first < count; first += kVisitBatch) {
    if (visit(context, pairs + first, std::min(kVisitBatch, count - first)) != 0) return;
  }
}

}  // namespace hg
