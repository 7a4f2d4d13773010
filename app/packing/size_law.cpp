// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// Radii from a size law and the box edge from a density, by arithmetic that gives the same bits on every machine.
#include "packing/size_law.hpp"

#include "sim/cube_root.hpp"

#include <cmath>
#include <stdexcept>

namespace packing {
namespace {

constexpr double kPi = 3.14159265358979323846;

double power(double base, int exponent) {
  double result = 1;
  for (int k = 0; k < exponent; ++k) result *= base;
  return result;
}

}  // namespace

Law law_from_name(const std::string &name) {
  if (name == "mono") return Law::kMono;
  if (name == "two-sizes") return Law::kTwoSizes;
  if (name == "uniform-size") return Law::kUniformSize;
  if (name == "uniform-volume") return Law::kUniformVolume;
  throw std::invalid_argument("no size law is called '" + name +
                              "': use mono, two-sizes, uniform-size or uniform-volume");
}

std::size_t large_count(const SizeLaw &law, std::size_t count) {
  const double share = 1 / (1 + power(law.ratio, law.dimension));
  return static_cast<std::size_t>(std::floor(static_cast<double>(count) * share + 0.5));
}

double inverse_cdf(const SizeLaw &law, double f) {
  const double omega = law.ratio;
  switch (law.law) {
    case Law::kUniformSize:
      return 1 + (omega - 1) * f;
    case Law::kUniformVolume:
      // F(r) = (1 - r^(1-d)) / (1 - omega^(1-d)).
      if (law.dimension == 2) return 1 / (1 - f * (1 - 1 / omega));
      return 1 / std::sqrt(1 - f * (1 - 1 / (omega * omega)));
    case Law::kMono:
    case Law::kTwoSizes:
      break;
  }
  throw std::invalid_argument("this size law has no density");
}

std::vector<double> sample_radii(const SizeLaw &law, std::size_t count, double u) {
  std::vector<double> radii(count, 1.0);
  if (law.law == Law::kMono) return radii;
  if (law.law == Law::kTwoSizes) {
    for (std::size_t i = count - large_count(law, count); i < count; ++i) radii[i] = law.ratio;
    return radii;
  }
  for (std::size_t i = 0; i < count; ++i) {
    radii[i] = inverse_cdf(law, (static_cast<double>(i) + u) / static_cast<double>(count));
  }
  return radii;
}

double box_edge(const std::vector<double> &radii, double density, int dimension) {
  double sum = 0;
  for (const double r : radii) sum += power(r, dimension);
  if (dimension == 2) return std::sqrt(kPi * sum / density);
  return hgrid_sim::cube_root(4 * kPi / 3 * sum / density);
}

}  // namespace packing
