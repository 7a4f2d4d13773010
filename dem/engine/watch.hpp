// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Watches a run for what no sound simulation shows.
#pragma once

#include "dem/engine/engine.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace dem {

class Watch {
 public:
  explicit Watch(const Setup &setup);

  // What this measurement shows for the first time in the run, in words: overlaps above a tenth of a radius, centres
  // behind walls, a time step that the present contacts may make unstable, energy that rises by more than a hundredth
  // of what is in motion and in contacts where nothing puts any in (no shear, no growth, no fixed particle that moves,
  // none that come or go); planes that press and swing.
  std::vector<std::string> look(uint64_t step, const Measurement &measurement);

  // The worst of each that was seen, whether warned of or not.
  std::string summary() const;

  bool has_warned() const;

 private:
  struct Sight {
    double worst = 0;
    uint64_t step = 0;  // of the worst
    bool warned = false;

    // Whether this is worse than `bound` for the first time.
    bool note(double value, double bound, uint64_t now);
  };

  bool gains_;  // something may put energy in
  double lowest_ = kInfinity, scale_ = 0;
  Sight overlap_, outside_, load_, press_, rise_;
};

}  // namespace dem
