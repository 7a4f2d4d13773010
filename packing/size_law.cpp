// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Radii from a size law and the box edge from a density, by arithmetic that gives the same bits on every machine.
#include "packing/size_law.hpp"

#include "packing/portable_math.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace packing {
namespace {

constexpr double kPi = 3.14159265358979323846;

// F(r) = (1 - r^(1-a)) / (1 - omega^(1-a)), a > 1.
double inverse_of_power_law(double omega, int a, double f) {
  return 1 / root(1 - f * (1 - 1 / power(omega, a - 1)), a - 1);
}

}  // namespace

const char *const kLawNames[7] = {"mono",      "two-sizes",  "uniform-size", "uniform-volume",
                                  "power-law", "log-normal", "one-giant"};

Law law_from_name(const std::string &name) {
  const auto *const found = std::find(std::begin(kLawNames), std::end(kLawNames), name);
  if (found != std::end(kLawNames)) return static_cast<Law>(found - std::begin(kLawNames));
  std::string known;
  for (const char *const law : kLawNames) known += std::string(known.empty() ? "" : ", ") + law;
  throw std::invalid_argument("no size law is called '" + name + "': use one of " + known);
}

size_t large_count(const SizeLaw &law, size_t count) {
  const double share = 1 / (1 + power(law.ratio, law.dimension));
  return static_cast<size_t>(std::floor(static_cast<double>(count) * share + 0.5));
}

double inverse_cdf(const SizeLaw &law, double f) {
  const double omega = law.ratio;
  switch (law.law) {
    case Law::kUniformSize:
      return 1 + (omega - 1) * f;
    case Law::kUniformVolume:
      return inverse_of_power_law(omega, law.dimension, f);
    case Law::kPowerLaw:
      return inverse_of_power_law(omega, law.exponent, f);
    case Law::kLogNormal:
      return exponential(law.sigma * normal_quantile(f));
    case Law::kMono:
    case Law::kTwoSizes:
    case Law::kOneGiant:
      break;
  }
  throw std::invalid_argument("this size law has no density");
}

std::vector<double> sample_radii(const SizeLaw &law, size_t count, double u) {
  std::vector<double> radii(count, 1.0);
  if (law.law == Law::kMono) return radii;
  if (law.law == Law::kTwoSizes || law.law == Law::kOneGiant) {
    const size_t large = law.law == Law::kOneGiant ? 1 : large_count(law, count);
    std::fill(radii.end() - static_cast<ptrdiff_t>(large), radii.end(), law.ratio);
    return radii;
  }
  for (size_t i = 0; i < count; i++) {
    radii[i] = inverse_cdf(law, (static_cast<double>(i) + u) / static_cast<double>(count));
  }
  return radii;
}

double box_edge(const std::vector<double> &radii, double density, int dimension) {
  double sum = 0;
  for (const double r : radii) sum += power(r, dimension);
  if (dimension == 2) return std::sqrt(kPi * sum / density);
  return root(4 * kPi / 3 * sum / density, 3);
}

}  // namespace packing
