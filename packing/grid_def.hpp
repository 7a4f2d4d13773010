// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How packings use the library: results that depend on neither the levels nor the number of threads.
#pragma once

#include "packing/box.hpp"

#include <hgrid/hgrid.h>

namespace packing {

inline hg_grid_def grid_def(const Box &box) {
  hg_grid_def def = hg_default_grid_def();
  box.describe(def);
  def.thread_count = 1;  // most of a sweep is serial; small grids would wait for their threads
  def.accuracy = HG_DOUBLE;
  def.pair_order = HG_ORDER_ID;  // sums over pairs are then added in one order only
  return def;
}

}  // namespace packing
