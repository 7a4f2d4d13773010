// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// A line on standard error that tells how far the growth of a packing has come.
#ifndef APP_GROWTH_LINE_HPP
#define APP_GROWTH_LINE_HPP

#include "sim/event/growth.hpp"

#include <chrono>
#include <cstdint>

namespace app {

// Silent unless standard error is a terminal. The line is wiped at the end.
class GrowthLine {
 public:
  GrowthLine();
  ~GrowthLine();
  GrowthLine(const GrowthLine &) = delete;
  GrowthLine &operator=(const GrowthLine &) = delete;

  // Density, events per second, time left.
  void show(const hgrid_sim::event::GrowthProgress &progress);

 private:
  using Clock = std::chrono::steady_clock;
  // Where something began to be counted.
  struct Mark {
    Clock::time_point time;
    double share = 0;  // of the work
    std::uint64_t events = 0;
  };

  bool terminal_;
  bool shown_ = false;
  int retries_ = 0;
  Mark try_, last_;
};

}  // namespace app

#endif
