// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Settles the pairs that the kernels' fast test left open.
#pragma once

#include "src/kernels/kernel.hpp"

#include <algorithm>

namespace hg {

// Takes the open pairs out of the sink for which decide(open pair) is false.
template <class Decide>
void settle_open(PairSink &sink, Decide &&decide) {
  hg_pair *to = nullptr;  // where the pairs from `from` on go, once one has been taken out
  hg_pair *from = nullptr;
  for (uint32_t k = 0; k < sink.open_count; k++) {
    const OpenPair &open = sink.open[k];
    if (decide(open)) continue;
    to = to == nullptr ? open.at : std::copy(from, open.at, to);
    from = open.at + 1;
  }
  if (to != nullptr) sink.next = std::copy(from, sink.next, to);
  sink.undecided_count += sink.open_count;
  sink.open_count = 0;
}

}  // namespace hg
