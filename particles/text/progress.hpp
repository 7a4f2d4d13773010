// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A line on standard error that tells how far a long job has come.
#pragma once

#include "particles/text/status_line.hpp"

#include <chrono>
#include <cstdint>
#include <string>

namespace particles {

// Silent unless standard error is a terminal and the job lasts longer than a moment. The line is wiped at the end.
class Progress {
 public:
  // `label` says what is done, `unit` what is counted; total 0 means unknown: no percentage is shown.
  Progress(std::string label, std::string unit, uint64_t total);

  // Cheap enough to be called every few thousand items.
  void update(uint64_t done);
  void set_total(uint64_t total) { total_ = total; }

 private:
  std::string label_, unit_;
  uint64_t total_;
  StatusLine line_;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace particles
