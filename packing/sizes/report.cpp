// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What so many particles can represent of a curve of sizes.
#include "packing/sizes/report.hpp"

#include "packing/portable_math.hpp"
#include "particles/text/formatted.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace packing {
namespace {

using particles::formatted;

// Particles that the coarsest fraction should have for its volume to be little more than chance.
constexpr double kManyGrains = 100;

std::string beyond(double share, const char *where, Measure measure) {
  if (!(share > 0)) return "";
  return formatted("left out: %.3g %% of the curve's %s, %s\n", 100 * share,
                   measure == Measure::kNumber ? "number" : "mass", where);
}

}  // namespace

SizeReport report_sizes(const SizeLaw &law, std::vector<double> radii, double scale) {
  const SizeCurve curve = row_of(law.law).curve(law);
  std::sort(radii.begin(), radii.end());
  const double volume = volume_of(radii, law.dimension);
  SizeReport report{{}, curve.measure(), curve.finer, curve.coarser};
  auto first = radii.begin();
  for (size_t n = 0; n + 1 < curve.sieves.size(); n++) {
    const size_t low = curve.sieves[n], high = curve.sieves[n + 1];
    const double to = scale * curve.radii()[high];
    const auto last = n + 2 == curve.sieves.size() ? radii.end() : std::upper_bound(first, radii.end(), to);
    const double number = curve.number_below()[high] - curve.number_below()[low];
    if (number > 0) {
      report.fractions.push_back({scale * curve.radii()[low], to, number * static_cast<double>(radii.size()),
                                  static_cast<size_t>(last - first),
                                  curve.volume_below()[high] - curve.volume_below()[low],
                                  volume_of(std::vector<double>(first, last), law.dimension) / volume});
    }
    first = last;
  }
  return report;
}

double count_for_coarsest(const SizeReport &report, double wanted) {
  double particles = 0;
  for (const Fraction &fraction : report.fractions) particles += fraction.expected;
  return std::ceil(particles * wanted / report.fractions.back().expected);
}

std::string words_of(const SizeReport &report) {
  std::string text = "        from           to  particles  volume wanted   found, %\n";
  double missing = 0;
  for (const Fraction &f : report.fractions) {
    if (f.particles == 0) missing += f.wanted;
    text += formatted("%12.6g %12.6g %10zu %14.2f %10.2f", f.from, f.to, f.particles, 100 * f.wanted, 100 * f.found);
    text += f.particles == 0 ? formatted("  <- no particle: its share is %.2g of one\n", f.expected) : "\n";
  }
  text += beyond(report.finer, "finer than the smallest size", report.measure);
  text += beyond(report.coarser, "coarser than the largest size", report.measure);
  if (missing > 0)
    text += formatted("missing: %.3g %% of the volume, in fractions without a particle\n", 100 * missing);
  const Fraction &coarsest = report.fractions.back();
  if (static_cast<double>(coarsest.particles) < kManyGrains)
    text += formatted("particles in the coarsest fraction: %zu; for %.0f it takes %.3g in all\n", coarsest.particles,
                      kManyGrains, count_for_coarsest(report, kManyGrains));
  return text;
}

}  // namespace packing
