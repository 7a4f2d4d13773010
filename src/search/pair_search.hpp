// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The contact detection phase (the paper's section 2.2): all pairs of a built index. Each level is searched with
// itself, and from each particle each finer level. Every pair is met once.
#pragma once

#include "src/exact/overlap.hpp"
#include "src/index/index.hpp"
#include "src/kernels/kernel_set.hpp"
#include "src/pairs/pair_source.hpp"
#include "src/particles/particle_store.hpp"
#include "src/search/search_tasks.hpp"

namespace hg {

// The pairs that interact, as slots, plus the id of slot 0 if ids have no gaps. The index may have been made for a
// wider reach than that of `overlap`; then every candidate is decided on the caller's doubles, which is slow.
class PairSearch : public PairSource {
 public:
  PairSearch(const Index &index, const SearchTasks &tasks, const ParticleStore &store, const Overlap &overlap)
      : index_(index), tasks_(tasks), store_(store), overlap_(overlap) {}
  size_t task_count() const override { return tasks_.count(); }
  PairJudge judge() const override;
  bool send(size_t task, PairStream &stream) const override;

 protected:
  // Task n, of `particles` and `images`, which name the pairs by their slots, or by whatever stands in place of them.
  bool send(size_t n, const PointArrays &particles, const PointArrays &images, PairStream &stream) const;

  const Index &index_;
  const SearchTasks &tasks_;
  const ParticleStore &store_;
  const Overlap &overlap_;
};

// HG_DOUBLE is its plain expression even where that under- or overflows. Only on such scales (quanta per length,
// largest reach) can the expression differ from a clear verdict of the fast test.
bool plain_squares_are_clear(int32_t accuracy, double scale, double reach);

}  // namespace hg
