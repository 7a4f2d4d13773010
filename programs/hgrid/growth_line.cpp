// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A line on standard error that tells how far the growth of a packing has come.
#include "programs/hgrid/growth_line.hpp"

#include <unistd.h>

#include <cstdio>

namespace command {
namespace {

constexpr double kInterval = 0.5;  // seconds

}  // namespace

GrowthLine::GrowthLine() : terminal_(isatty(STDERR_FILENO) == 1) { try_.time = last_.time = Clock::now(); }

GrowthLine::~GrowthLine() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void GrowthLine::show(const packing::event::GrowthProgress &progress) {
  if (!terminal_) return;
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
  shown_ = true;
  std::fprintf(stderr, "\r\033[Kdensity %.4f, %.3g events per second", progress.density, rate);
  if (progress.retries > 0) std::fprintf(stderr, ", retry %d", progress.retries);
  if (now.share > try_.share) {
    const double since_try = std::chrono::duration<double>(now.time - try_.time).count();
    std::fprintf(stderr, ", %.0f s left", since_try * (1 - now.share) / (now.share - try_.share));
  }
  std::fflush(stderr);
}

}  // namespace command
