// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Turns a list of pairs into compressed rows, one per particle.
#pragma once

#include "src/base/memory.hpp"

#include <hgrid/types.h>

#include <cstddef>
#include <cstdint>

namespace hg {

class NeighborRows {
 public:
  explicit NeighborRows(Memory &memory) : offsets_(memory), neighbors_(memory) {}

  // Pairs of slots + `base`, a < b, into rows by slot; neighbours keep the base and ascend within each row.
  // O(rows + pairs) but for sorting within rows. `ascending`: the pairs are, so that the half list is one pass.
  void build(const hg_pair *pairs, size_t pair_count, size_t row_count, int32_t base, int32_t list, bool ascending);

  const int64_t *offsets() const { return offsets_.data(); }
  int32_t *neighbors() { return neighbors_.data(); }

 private:
  Buffer<int64_t> offsets_;
  Buffer<int32_t> neighbors_;
};

}  // namespace hg
