// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How kernels write to a stream of pairs: room before they write, notes of what the fast test leaves undecided.
#pragma once

#include "src/kernels/pair_stream.hpp"

namespace hg {
namespace {

// False if the output stopped.
inline bool have_room(PairStream *stream, size_t pairs) {
  PairOutput &output = stream->output;
  if (static_cast<size_t>(output.limit - output.next) >= pairs) return true;
  stream->judge.decide(stream);
  return output.make_room(&output, pairs);
}

// Asks for the caller's numbers of a particle, which the judge will read soon.
inline void fetch_ahead(const PairJudge &judge, uint32_t slot) {
  const double *center = judge.centers + static_cast<size_t>(slot) * judge.dimension;
  __builtin_prefetch(center);
  __builtin_prefetch(center + (judge.dimension - 1));  // may lie on the next cache line
  __builtin_prefetch(judge.radii + slot);
}

inline void note_undecided(PairStream *stream, const UndecidedPair &pair) {
  stream->undecided[stream->undecided_count++] = pair;
}

}  // namespace
}  // namespace hg
