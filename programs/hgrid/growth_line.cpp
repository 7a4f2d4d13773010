// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A line on standard error that tells how far the growth of a packing has come.
#include "programs/hgrid/growth_line.hpp"

#include "particles/text/formatted.hpp"

#include <string>

namespace command {
namespace {

constexpr double kInterval = 0.5;  // seconds

}  // namespace

void GrowthLine::show(const packing::event::GrowthProgress &progress) {
  if (!line_.is_seen()) return;
  const Mark now{Clock::now(), progress.share_done, progress.tally->events()};
  if (progress.retries != retries_) {
    // A new try starts from an earlier density: the time left is judged by it alone.
    retries_ = progress.retries;
    try_ = now;
  }
  const double since_last = std::chrono::duration<double>(now.time - last_.time).count();
  if (since_last < kInterval) return;
  const double rate = static_cast<double>(now.events - last_.events) / since_last;
  last_ = now;
  std::string text = particles::formatted("density %.4f, %.3g events per second", progress.density, rate);
  if (progress.retries > 0) text += ", retry " + std::to_string(progress.retries);
  if (now.share > try_.share) {
    const double since_try = std::chrono::duration<double>(now.time - try_.time).count();
    text += particles::formatted(", %.0f s left", since_try * (1 - now.share) / (now.share - try_.share));
  }
  line_.show(text);
}

}  // namespace command
