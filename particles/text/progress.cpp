// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A line on standard error that tells how far a long job has come.
#include "particles/text/progress.hpp"

#include "particles/text/formatted.hpp"

#include <utility>

namespace particles {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kFirst{500}, kInterval{100};

}  // namespace

Progress::Progress(std::string label, std::string unit, uint64_t total)
    : label_(std::move(label)), unit_(std::move(unit)), total_(total), next_(Clock::now() + kFirst) {}

void Progress::update(uint64_t done) {
  if (!line_.is_seen()) return;
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + kInterval;
  std::string text = label_ + ": " + std::to_string(done) + " " + unit_;
  if (total_ > 0) text += formatted(" (%.0f %%)", 100.0 * static_cast<double>(done) / static_cast<double>(total_));
  line_.show(text);
}

}  // namespace particles
