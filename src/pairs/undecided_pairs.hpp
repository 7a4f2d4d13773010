// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How a judge takes out of a stream what does not interact.
#pragma once

#include "src/kernels/pair_stream.hpp"

#include <algorithm>

namespace hg {

// Takes out the undecided pairs for which interact(pair) is false.
template <class Interact>
void decide_each(PairStream &stream, Interact &&interact) {
  hg_pair *to = nullptr;  // where the pairs from `from` on go, once one has been taken out
  hg_pair *from = nullptr;
  for (uint32_t n = 0; n < stream.undecided_count; n++) {
    const UndecidedPair &pair = stream.undecided[n];
    if (interact(pair)) continue;
    to = to == nullptr ? pair.at : std::copy(from, pair.at, to);
    from = pair.at + 1;
  }
  if (to != nullptr) stream.output.next = std::copy(from, stream.output.next, to);
  stream.undecided_total += stream.undecided_count;
  stream.undecided_count = 0;
}

}  // namespace hg
