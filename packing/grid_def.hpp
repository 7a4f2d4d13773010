// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How packings use the library: results that depend on neither the levels nor the number of threads.
#pragma once

#include "packing/container.hpp"

#include <hgrid/hgrid.h>

namespace packing {

inline hg_grid_def grid_def(const Container &container) {
  hg_grid_def def = hg_default_grid_def();
  def.dimension = container.dimension;
  def.thread_count = 1;  // most of a sweep is serial; small grids would wait for their threads
  def.accuracy = HG_DOUBLE;
  def.pair_order = HG_ORDER_ID;  // sums over pairs are then added in one order only
  for (int k = 0; k < container.dimension; k++) {
    def.box_max[k] = container.edge;
    def.periodic[k] = container.periodic[static_cast<size_t>(k)] ? 1 : 0;
  }
  return def;
}

}  // namespace packing
