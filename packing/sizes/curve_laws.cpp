// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Curves by mass from their densities, whose tails cancel nothing, and curves from tables.
#include "packing/sizes/curve_laws.hpp"

#include "packing/portable_math.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace packing {
namespace {

// Between these the shares of a curve are linear in ln r. That is off by 0.05 (h / sigma)^2 for a distance h of knots
// and a bell of width sigma, less than 1e-6 for the narrowest that is allowed.
constexpr int kKnotsPerOctave = 4096;

// 1, 2, 4 ... and `last`.
std::vector<double> octaves(double last) {
  std::vector<double> ends = {1};
  while (2 * ends.back() < last) ends.push_back(2 * ends.back());
  ends.push_back(last);
  return ends;
}

// From radius 1 to the ratio; `density` is dF/d(ln r) up to a factor, taken in the middle between knots.
template <class Density>
SizeCurve smooth_curve(const SizeLaw &law, Density &&density) {
  const std::vector<double> ends = octaves(law.ratio);
  std::vector<Knot> knots = {{1, 0}};
  std::vector<size_t> sieves = {0};
  for (size_t n = 0; n + 1 < ends.size(); n++) {
    const double step = logarithm(ends[n + 1] / ends[n]) / kKnotsPerOctave;
    for (int k = 1; k <= kKnotsPerOctave; k++) {
      const double radius = k == kKnotsPerOctave ? ends[n + 1] : ends[n] * exponential(step * k);
      knots.push_back({radius, knots.back().share + step * density(ends[n] * exponential(step * (k - 0.5)))});
    }
    sieves.push_back(knots.size() - 1);
  }
  SizeCurve curve(knots, Measure::kVolume, law.dimension);
  curve.sieves = std::move(sieves);
  return curve;
}

// Share of a normal distribution below x.
double normal_below(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

}  // namespace

SizeCurve fuller_curve(const SizeLaw &law) {
  SizeCurve curve = smooth_curve(law, [&](double r) { return real_power(r / law.ratio, law.modulus); });
  curve.finer = real_power(1 / law.ratio, law.modulus);
  return curve;
}

SizeCurve rosin_rammler_curve(const SizeLaw &law) {
  const auto x = [&](double r) { return real_power(r / law.d63, law.uniformity); };
  SizeCurve curve = smooth_curve(law, [&](double r) { return x(r) * exponential(-x(r)); });
  curve.finer = -std::expm1(-x(1));
  curve.coarser = std::exp(-x(law.ratio));
  return curve;
}

SizeCurve log_normal_mass_curve(const SizeLaw &law) {
  const auto x = [&](double r) { return logarithm(r / law.median) / law.sigma; };
  SizeCurve curve = smooth_curve(law, [&](double r) { return exponential(-0.5 * x(r) * x(r)); });
  curve.finer = normal_below(x(1));
  curve.coarser = normal_below(-x(law.ratio));
  return curve;
}

SizeCurve table_curve(const SizeLaw &law) {
  const SizeTable &table = *law.table;
  const double from = table.radius_of(law.from);
  auto first = std::find_if(table.knots.begin(), table.knots.end(), [&](const Knot &k) { return k.radius > from; });
  std::vector<Knot> knots;
  if (first != table.knots.begin() && first != table.knots.end()) {
    const Knot below = *(first - 1);
    const double place = logarithm(from / below.radius) / logarithm(first->radius / below.radius);
    knots.push_back({from, below.share + place * (first->share - below.share)});
  }
  knots.insert(knots.end(), first, table.knots.end());
  SizeCurve curve(knots, table.measure, law.dimension);
  curve.finer = knots.front().share;
  return curve;
}

}  // namespace packing
