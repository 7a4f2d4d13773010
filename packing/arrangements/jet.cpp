// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What falls out of a hopper: a jet that grows longer, faster and thinner, and a flat pile below.
#include "packing/arrangements/families.hpp"

namespace packing {
namespace {

constexpr double kHopperShare = 0.45, kJetShare = 0.1;
constexpr double kJetLength = 200;  // in heights of the hopper
constexpr double kJetRadius = 6;    // at the hopper, a fifth of it at the end
constexpr double kThinning = 4;
constexpr double kHopperSlope = 1, kPileSlope = 0.4;

}  // namespace

void lay_jet(Places &places) {
  const Vector hole = Vector::Zero();
  const double length = kJetLength * places.add_cone(places.share(kHopperShare), hole, 1, kHopperSlope);
  for (size_t falling = places.share(kJetShare); falling > 0; falling--) {
    const double time = places.random().uniform();
    Vector place = Vector::Zero();
    for (int axis = 0; axis < places.last_axis(); axis++)
      place[axis] = kJetRadius / (1 + kThinning * time) * (2 * places.random().uniform() - 1);
    place[places.last_axis()] = -length * time * time;
    places.add(place);
  }
  Vector summit = hole;
  summit[places.last_axis()] = -length;
  places.add_cone(places.left(), summit, -1, kPileSlope);
}

}  // namespace packing
