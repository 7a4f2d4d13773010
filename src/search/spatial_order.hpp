// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hg_query_order: an order of all particles in which near ones stand together.
#pragma once

#include "src/search/built_grid.hpp"

namespace hg {

class SpatialOrder {
 public:
  explicit SpatialOrder(Memory &memory) : memory_(memory), ids_(memory) {}

  // Of all particles of the store, which has no gaps: along a Morton curve, whatever the extents.
  void find(const BuiltGrid &grid);
  void forget() { found_ = false; }

  bool found() const { return found_; }
  const int32_t *ids() const { return ids_.data(); }

 private:
  Memory &memory_;
  Buffer<int32_t> ids_;
  bool found_ = false;
};

}  // namespace hg
