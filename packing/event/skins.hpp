// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How far hulls stand off their particles: learnt from what the last epoch counted, never from a clock.
#pragma once

#include "packing/box.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace packing::event {

// What an epoch counted.
struct EpochCounts {
  double collisions = 0;
  double predictions = 0;  // of meetings
  double candidates = 0;   // hulls tested when hulls were renewed
  double outer_pairs = 0;  // overlapping outer hulls, counted from both sides
  bool ended_by_hulls = false;
  bool few_strays = false;
};

class Skins {
 public:
  Skins(const Box &box, size_t count);

  void learn(const EpochCounts &counts, size_t count);

  // The skins of a particle whose radius is `radius` and grows at `growth`. The surface of a large particle in growth
  // moves steadily, where that of a small one rattles: it gets more. Throws Error if the box leaves no room.
  double inner(double radius, double growth) const { return capped(radius, inner_ + growth * kHorizon * inner_); }
  double outer(double radius, double growth) const { return capped(radius, outer_ + growth * kHorizon * outer_); }

 private:
  // Growth that a hull allows for, in units of the time to cross the skin at thermal speed.
  static constexpr double kHorizon = 4;

  double capped(double radius, double skin) const;

  double inner_, outer_;
  double largest_skin_ = 0;
  double largest_hull_;  // that the periodic axes allow
};

}  // namespace packing::event
