// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A grid of the library that frees itself, and its failures as exceptions.
#pragma once

#include "particles/error.hpp"

#include <hgrid/hgrid.h>

#include <memory>
#include <string>

namespace particles {

// Throws what the library says about its last failure unless `status` is HG_OK.
inline void require(hg_status status) {
  if (status != HG_OK) throw Error(std::string(hg_status_string(status)) + ": " + hg_last_error());
}

struct DestroyGrid {
  void operator()(hg_grid *grid) const { hg_destroy(grid); }
};
using GridPointer = std::unique_ptr<hg_grid, DestroyGrid>;

inline GridPointer create_grid(const hg_grid_def &def) {
  hg_grid *grid = nullptr;
  require(hg_create(&def, &grid));
  return GridPointer(grid);
}

}  // namespace particles
