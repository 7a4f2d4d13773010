// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/candidate_filter.hpp"

#include "src/exact/fast_test.hpp"
#include "src/kernels/kernel_set.hpp"
#include "src/pairs/undecided_pairs.hpp"

#include <algorithm>

namespace hg {
namespace {

constexpr size_t kFilterTask = 16384;  // candidates

}  // namespace

size_t CandidateFilter::task_count() const { return (candidates_.count() + kFilterTask - 1) / kFilterTask; }

PairJudge CandidateFilter::judge() const {
  PairJudge judge{};
  judge.decide = [](PairStream *stream) {
    const auto &self = *static_cast<const CandidateFilter *>(stream->judge.source);
    decide_each(*stream, [&](const UndecidedPair &pair) {
      return self.candidates_.interact(pair.a, pair.b, self.store_, self.overlap_, stream->exact_total);
    });
  };
  judge.source = this;
  judge.centers = store_.centers();
  judge.radii = store_.radii();
  judge.dimension = static_cast<uint32_t>(candidates_.index().domain.dimension);
  judge.id_offset = store_.id_offset();
  judge.band_constant = kBandConstant;
  return judge;
}

bool CandidateFilter::send(size_t task, PairStream &stream) const {
  const size_t first = task * kFilterTask;
  const FilterInput input{candidates_.points(), candidates_.slots(), candidates_.pairs() + first,
                          std::min(kFilterTask, candidates_.count() - first)};
  const bool go_on = active_kernels().filter[candidates_.index().interaction.kind](input, &stream);
  stream.judge.decide(&stream);
  return go_on;
}

}  // namespace hg
