// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The grids of FORTRAN 77, which knows them by numbers: a number that was never given out, or whose grid has ended,
// leads nowhere, so no program can crash by it.
#pragma once

#include <hgrid/hgrid.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>

namespace hgrid::f77 {

// A grid and its turn: calls on one number may come from several threads.
struct Numbered {
  explicit Numbered(const hg_grid_def &def) : grid(def), dimension(def.dimension) {}

  std::mutex turn;
  Grid grid;
  const int32_t dimension;
};

class Grids {
 public:
  // Its number; 0 if there are none left.
  int32_t add(std::shared_ptr<Numbered> grid) {
    const std::lock_guard lock(mutex_);
    if (next_ == INT32_MAX) return 0;
    alive_.emplace(next_, std::move(grid));
    return next_++;
  }

  // NULL if no living grid has that number. A grid that ends meanwhile lives on until the call is done.
  std::shared_ptr<Numbered> find(int32_t number) const {
    const std::lock_guard lock(mutex_);
    const auto found = alive_.find(number);
    return found != alive_.end() ? found->second : nullptr;
  }

  void end(int32_t number) {
    const std::lock_guard lock(mutex_);
    alive_.erase(number);
  }

 private:
  mutable std::mutex mutex_;
  std::map<int32_t, std::shared_ptr<Numbered>> alive_;
  // Far from what stands in memory by chance, and no number is given out twice.
  int32_t next_ = 1212612609;
};

}  // namespace hgrid::f77
