// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A line on standard error that tells how far the growth of a packing has come.
#pragma once

#include "packing/event/growth.hpp"
#include "particles/text/status_line.hpp"

#include <chrono>
#include <cstdint>

namespace command {

// Silent unless standard error is a terminal. The line is wiped at the end.
class GrowthLine {
 public:
  GrowthLine() { try_.time = last_.time = Clock::now(); }

  // Density, events per second, time left.
  void show(const packing::event::GrowthProgress &progress);

 private:
  using Clock = std::chrono::steady_clock;
  // Where something began to be counted.
  struct Mark {
    Clock::time_point time;
    double share = 0;  // of the work
    uint64_t events = 0;
  };

  particles::StatusLine line_;
  int retries_ = 0;
  Mark try_, last_;
};

}  // namespace command
