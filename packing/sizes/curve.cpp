// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Cumulative curves of sizes, by volume (mass) as of sieves or by number: what they mean for the number of particles.
#include "packing/sizes/curve.hpp"

#include "packing/portable_math.hpp"

#include <algorithm>
#include <numeric>

namespace packing {
namespace {

// From 0 on, the last being 1.
std::vector<double> accumulated(const std::vector<double> &parts) {
  std::vector<double> sums(1, 0.0);
  for (const double part : parts) sums.push_back(sums.back() + part);
  for (double &sum : sums) sum /= sums.back();
  return sums;
}

}  // namespace

SizeCurve::SizeCurve(const std::vector<Knot> &knots, Measure measure, int dimension)
    : sieves(knots.size()), measure_(measure), dimension_(dimension) {
  std::iota(sieves.begin(), sieves.end(), size_t{0});
  for (const Knot &knot : knots) radii_.push_back(knot.radius);
  std::vector<double> known, derived;
  for (size_t k = 0; k + 1 < knots.size(); k++) {
    const double step = radii_[k + 1] / radii_[k], share = knots[k + 1].share - knots[k].share;
    const double from = radii_[k] / radii_.front();
    // Means of r^d and r^-d over ln r in the interval.
    const double steepness = dimension * logarithm(step);
    const double rise = power(from, dimension) * (power(step, dimension) - 1) / steepness;
    const double fall = (1 - 1 / power(step, dimension)) / power(from, dimension) / steepness;
    known.push_back(share);
    derived.push_back(share * (measure == Measure::kNumber ? rise : fall));
  }
  const bool is_by_number = measure == Measure::kNumber;
  number_ = accumulated(is_by_number ? known : derived);
  volume_ = accumulated(is_by_number ? derived : known);
}

double SizeCurve::radius_at(double share) const {
  // The last knot with no more below it, before an interval that holds something.
  const auto above = std::upper_bound(number_.begin(), number_.end(), share);
  const auto k = static_cast<size_t>(above - number_.begin()) - 1;
  const double place = (share - number_[k]) / (number_[k + 1] - number_[k]);
  const double step = radii_[k + 1] / radii_[k];
  if (measure_ == Measure::kNumber) return radii_[k] * real_power(step, place);
  return radii_[k] / root(1 - place * (1 - 1 / power(step, dimension_)), dimension_);
}

}  // namespace packing
