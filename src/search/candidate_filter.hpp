// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The stored candidates that interact now.
#pragma once

#include "src/kernels/kernel_set.hpp"
#include "src/pairs/pair_source.hpp"
#include "src/search/stored_candidates.hpp"

namespace hg {

class CandidateFilter final : public PairSource {
 public:
  CandidateFilter(const StoredCandidates &candidates, const ParticleStore &store, const Overlap &overlap)
      : candidates_(candidates), store_(store), overlap_(overlap) {}
  size_t task_count() const override;
  PairJudge judge() const override;
  bool send(size_t task, PairStream &stream) const override;

  // If the candidates are direct: what their kernels take.
  DirectInput direct_input(size_t first, size_t count) const;

 private:
  bool send_direct(size_t first, size_t count, PairStream &stream) const;

  const StoredCandidates &candidates_;
  const ParticleStore &store_;
  const Overlap &overlap_;
};

}  // namespace hg
