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
  const size_t first = task * kFilterTask, count = std::min(kFilterTask, candidates_.count() - first);
  if (candidates_.direct()) return send_direct(first, count, stream);
  const FilterInput input{candidates_.points(), candidates_.slots(), candidates_.pairs() + first, count};
  const bool go_on = active_kernels().filter[candidates_.index().interaction.kind](input, &stream);
  stream.judge.decide(&stream);
  return go_on;
}

bool CandidateFilter::send_direct(size_t first, size_t count, PairStream &stream) const {
  const DirectInput input = direct_input(first, count);
  const Index &index = candidates_.index();
  return active_kernels().direct[index.domain.dimension - 2][index.interaction.kind].pairs(input, &stream);
}

DirectInput CandidateFilter::direct_input(size_t first, size_t count) const {
  const auto interact = [](const void *judge, const hg_pair &pair, int64_t *exact) {
    const auto &self = *static_cast<const CandidateFilter *>(judge);
    return self.candidates_.interact(static_cast<uint32_t>(pair.a), static_cast<uint32_t>(pair.b), self.store_,
                                     self.overlap_, *exact);
  };
  return {store_.centers(),
          store_.radii(),
          candidates_.pairs() + first,
          count,
          overlap_.interaction().margin,
          interact,
          this};
}

}  // namespace hg
