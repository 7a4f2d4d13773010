// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The rules by which the skins of hulls follow density and sizes.
#include "packing/event/skins.hpp"

#include "packing/portable_math.hpp"
#include "particles/error.hpp"
#include "particles/text/number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace packing::event {
namespace {

// Skins to begin with, in mean distances of particles.
constexpr double kFirstInner = 0.45, kFirstOuter = 1;
// A wide skin makes predictions dear, a narrow one renewals: candidates tested over predictions made, about even work.
constexpr double kNarrow = 0.5, kWide = 0.25;
// An epoch should last long enough that building lists of outer hulls is a small part of its predictions, and until so
// many collisions per particle.
constexpr double kShortEpoch = 4;
constexpr double kLongOuterList = 120;  // per particle
constexpr double kStep = 1.15;
constexpr double kLeastRatio = 1.5;  // of outer to inner skin
constexpr double kLeastRoom = 1e-3;  // skin over radius below which hulls would be renewed without end

}  // namespace

Skins::Skins(const Box &box, size_t count) : largest_hull_(std::numeric_limits<double>::infinity()) {
  const double volume = box.volume() / static_cast<double>(std::max<size_t>(count, 1));
  const double distance = box.dimension() == 2 ? std::sqrt(volume) : root(volume, 3);
  inner_ = kFirstInner * distance;
  outer_ = kFirstOuter * distance;
  for (int axis = 0; axis < box.dimension(); axis++) {
    largest_skin_ = std::max(largest_skin_, box.edge(axis));
    // The library asks for twice the largest reach, the sum of two hulls; a little less for its rounding.
    if (box.is_periodic(axis)) largest_hull_ = std::min(largest_hull_, box.edge(axis) / 4 * (1 - 1e-9));
  }
}

double Skins::capped(double radius, double skin) const {
  const double room = largest_hull_ - radius;
  if (room < kLeastRoom * radius) {
    throw particles::Error("a particle of radius " + particles::text(radius) +
                           " is too large for its periodic box: a hull of " + particles::text(largest_hull_) +
                           " is all that the shortest axis allows");
  }
  return std::min(skin, room);
}

void Skins::learn(const EpochCounts &counts, size_t count) {
  const double n = static_cast<double>(count);
  if (counts.candidates > kNarrow * counts.predictions) {
    inner_ *= kStep;
  } else if (counts.candidates < kWide * counts.predictions) {
    inner_ /= kStep;
  }
  const bool too_short = 2 * counts.collisions < kShortEpoch * n;
  if (counts.outer_pairs > kLongOuterList * n || (!counts.ended_by_hulls && counts.few_strays)) {
    outer_ /= kStep;
  } else if (counts.ended_by_hulls && too_short) {
    outer_ *= kStep;
  }
  // In a thin gas no list ever gets long.
  inner_ = std::min(inner_, largest_skin_);
  outer_ = std::min(std::max(outer_, kLeastRatio * inner_), kLeastRatio * largest_skin_);
}

}  // namespace packing::event
