// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Cumulative curves of sizes, by volume (mass) as of sieves or by number: what they mean for the number of particles.
#pragma once

#include <cstddef>
#include <vector>

namespace packing {

enum class Measure { kNumber, kVolume };

// A size and the share of what is smaller, by any measure and in any unit.
struct Knot {
  double radius;
  double share;
};

// Between two knots the share is linear in the logarithm of the radius: by volume p(r) ~ r^-4 (2D: r^-3), by number
// p(r) ~ 1/r.
class SizeCurve {
 public:
  // At least two knots, radii ascending, shares not falling; what lies below the first share is left out.
  SizeCurve(const std::vector<Knot> &knots, Measure measure, int dimension);

  // F^-1(share) of F by number, share in [0, 1).
  double radius_at(double share) const;

  // The radii of the knots, and what is smaller, from 0 to 1, by number and by volume.
  const std::vector<double> &radii() const { return radii_; }
  const std::vector<double> &number_below() const { return number_; }
  const std::vector<double> &volume_below() const { return volume_; }

  Measure measure() const { return measure_; }

  // Bounds of the fractions that reports tell: places of knots, all of them unless set.
  std::vector<size_t> sieves;
  // Shares of the whole curve, by its measure, that are left out beyond both ends.
  double finer = 0, coarser = 0;

 private:
  std::vector<double> radii_, number_, volume_;
  Measure measure_;
  int dimension_;
};

}  // namespace packing
