// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Finds all pairs of a built index: each level with itself, and each level with all finer ones. Every pair is met once.
#pragma once

#include "src/exact/overlap.hpp"
#include "src/index/index.hpp"
#include "src/kernels/kernel.hpp"
#include "src/pairs/pair_source.hpp"
#include "src/particles/particle_store.hpp"

namespace hg {

// The pairs that interact. A sink gets slots, plus the id of slot 0 if ids have no gaps. The index may have been made
// for a wider reach than that of `overlap`; then every candidate is decided on the caller's doubles, which is slow.
class PairSearch final : public PairSource {
 public:
  PairSearch(const Index &index, const ParticleStore &store, const Overlap &overlap)
      : index_(index), store_(store), overlap_(overlap) {}
  size_t task_count() const override { return index_.task_count; }
  void prepare(PairSink &sink) const override;
  bool run(size_t task, PairSink &sink) const override;

 private:
  const Index &index_;
  const ParticleStore &store_;
  const Overlap &overlap_;
};

// All pairs nearer than the reach that the index was made for, and some about as near. A sink gets names instead of
// slots: `names` holds those of the index's particles, in their order, then those of its images.
class CandidateSearch final : public PairSource {
 public:
  CandidateSearch(const Index &index, const ParticleStore &store, const uint32_t *names)
      : index_(index), store_(store), names_(names), overlap_(index.interaction, HG_FLOAT, index.domain) {}
  size_t task_count() const override { return index_.task_count; }
  void prepare(PairSink &sink) const override;
  bool run(size_t task, PairSink &sink) const override;

 private:
  const Index &index_;
  const ParticleStore &store_;
  const uint32_t *names_;
  Overlap overlap_;
};

// HG_DOUBLE is its plain expression even where that under- or overflows. Only on such scales (quanta per length,
// largest reach) can the expression differ from a clear verdict of the fast test.
bool plain_squares_are_clear(int32_t accuracy, double scale, double reach);

}  // namespace hg
