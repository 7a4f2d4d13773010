// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a search sends its pairs: a list that grows, or a visitor in batches.
#pragma once

#include "kernels/kernel.hpp"
#include "memory.hpp"
#include "particle_store.hpp"

#include <hgrid/types.h>

namespace hg {

// Replaces slots by ids where ids have gaps.
inline void to_ids(hg_pair *pairs, size_t count, const ParticleStore &store) {
  if (store.contiguous()) return;
  for (size_t p = 0; p < count; p++) {
    pairs[p] = {store.id(static_cast<size_t>(pairs[p].a)), store.id(static_cast<size_t>(pairs[p].b))};
  }
}

class ListSink : public PairSink {
 public:
  ListSink(Buffer<hg_pair> &pairs, const ParticleStore &particles) : PairSink{}, pairs_(pairs) {
    pairs_.grow(particles.slots() + kMaxPiece + kPadding);
    next = pairs_.data();
    limit = pairs_.data() + pairs_.capacity();
    id_offset = particles.contiguous() ? particles.id_offset() : 0;
    make_room = [](PairSink *sink, size_t count) {
      auto &self = *static_cast<ListSink *>(sink);
      const size_t used = self.count();
      self.pairs_.grow(used + count);
      self.next = self.pairs_.data() + used;
      self.limit = self.pairs_.data() + self.pairs_.capacity();
      return true;
    };
  }
  size_t count() const { return static_cast<size_t>(next - pairs_.data()); }

 private:
  Buffer<hg_pair> &pairs_;
};

class VisitSink : public PairSink {
 public:
  static constexpr size_t kBatch = 8192;

  VisitSink(Buffer<hg_pair> &batch, const ParticleStore &particles, hg_pair_visitor *visit, void *context)
      : PairSink{}, batch_(batch), particles_(particles), visit_(visit), context_(context) {
    batch_.require(kBatch);
    next = batch_.data();
    limit = batch_.data() + kBatch;
    id_offset = particles.contiguous() ? particles.id_offset() : 0;
    make_room = [](PairSink *sink, size_t) { return static_cast<VisitSink *>(sink)->flush(); };
  }

  // Hands over what has gathered. False once the visitor has had enough.
  bool flush() {
    const size_t count = static_cast<size_t>(next - batch_.data());
    next = batch_.data();
    visited_ += count;
    if (stopped_ || count == 0) return !stopped_;
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

static_assert(VisitSink::kBatch >= kMaxPiece + kPadding, "a piece of candidates must fit into an empty batch");

}  // namespace hg
