// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What commands that run scenes say on the way, and how long they run before they look around.
#pragma once

#include "dem/engine/engine.hpp"
#include "dem/scene/scene.hpp"
#include "particles/text/status_line.hpp"
#include "programs/measure/timing.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

namespace command {

// A line about the run as it goes: wiped and rewritten on a terminal, one after the other elsewhere.
class RunLine {
 public:
  RunLine(uint64_t first, uint64_t last) : first_(first), last_(last) {}

  // How many steps to do until the next look at the clock: those of about a tenth of a second.
  uint64_t patience() const {
    return seconds_ > 0 ? std::max<uint64_t>(1, static_cast<uint64_t>(0.1 * done_ / seconds_)) : 1;
  }

  void worked(uint64_t steps, size_t particles, double seconds) {
    done_ += static_cast<double>(steps);
    moves_ += static_cast<double>(steps) * static_cast<double>(particles);
    seconds_ += seconds;
  }

  double ns_per_particle_step() const { return moves_ > 0 ? 1e9 * seconds_ / moves_ : 0; }
  double seconds() const { return seconds_; }

  bool is_due() const { return measure::seconds_since(shown_) > (line_.is_seen() ? 0.5 : 10.0); }

  void show(uint64_t step, const dem::Measurement &m);

  void wipe() { line_.wipe(); }

 private:
  uint64_t first_, last_;
  double done_ = 0, moves_ = 0, seconds_ = 0;  // steps, of particles
  particles::StatusLine line_;
  std::chrono::steady_clock::time_point shown_ = std::chrono::steady_clock::now();
};

// The next step at which something is recorded, if that comes before `until`.
uint64_t next_record(const scene::OutputPlan &plan, uint64_t step, uint64_t until);
// Whether what is recorded at this interval is due. The last step is always one, since intervals are rounded to steps
// and need not end there.
bool is_recorded(uint64_t interval, uint64_t step, uint64_t last);

// What the scene at `path` is.
void print_scene(const scene::Scene &scene, const std::string &path);

}  // namespace command
