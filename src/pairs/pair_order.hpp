// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Brings a list of pairs into ascending order.
#pragma once

#include "src/base/memory.hpp"

#include <hgrid/types.h>

#include <cstddef>
#include <cstdint>

namespace hg {

class PairOrder {
 public:
  explicit PairOrder(Memory &memory) : begin_(memory), by_first_(memory) {}

  // Orders pairs of slots + `base`, a < b, by (a, b). O(slots + pairs) but for sorting within the pairs of one a.
  void ascend(hg_pair *pairs, size_t count, size_t slots, int32_t base);

 private:
  Buffer<uint64_t> begin_;    // where the pairs of each slot begin
  Buffer<hg_pair> by_first_;  // the pairs by a
};

}  // namespace hg
