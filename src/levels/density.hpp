// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How densely particles lie around each other, at each scale of length; N / V in evenly filled space.
#pragma once

#include "src/particles/participants.hpp"
#include "src/space/fixed_point.hpp"

namespace hg {

class Density {
 public:
  // Looks at 1024 particles at most, always the same of the same particles.
  static Density sample(const Participants &particles, const FixedPoint &map, int dimension);
  // All particles evenly in a volume of `extent`, in quanta; for tests and as the limit of sample.
  static Density even(const double *extent, int dimension);

  // The chance that another particle, drawn from all, lies in a given unit of volume (quanta^d) near a particle, "near"
  // meaning a distance of `length` quanta: the mean over particles, not over space.
  double at(double length) const;

 private:
  static constexpr int kOctaves = 31;  // edges 1, 2, 4 ... 2^30 quanta
  double per_octave_[kOctaves] = {};
};

}  // namespace hg
