// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Radii of curves by mass or number against the share that is smaller, from closed forms and numeric integration.
#include "packing/size_law.hpp"
#include "packing/sizes/report.hpp"
#include "tests/support/frame.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace {

using packing::Measure;
using packing::SizeLaw;

bool near(const char *what, double found, double expected, double absolute) {
  if (std::fabs(found - expected) <= absolute) return true;
  std::fprintf(stderr, "%s: found %.12g, expected %.12g\n", what, found, expected);
  return false;
}

SizeLaw law_of(const char *name, double ratio, int dimension) {
  SizeLaw law = packing::law_with(name, ratio);
  law.dimension = dimension;
  return law;
}

SizeLaw table_law(std::vector<packing::Knot> knots, Measure measure, int dimension) {
  SizeLaw law = packing::usual_law("table");
  law.dimension = dimension;
  law.table = std::make_shared<packing::SizeTable>(packing::SizeTable{std::move(knots), measure, false});
  return law;
}

// Systematic sampling: of all particles, just i + 1/2 lie below particle i, so the sample is nowhere further from the
// curve than half a particle; 1e-6 is for the curve taken at knots.
bool follows(const SizeLaw &law, const std::function<double(double)> &number_below) {
  for (const size_t count : {1, 7, 1000, 50000}) {
    const std::vector<double> radii = packing::sample_radii(law, count, 0.5);
    if (!std::is_sorted(radii.begin(), radii.end())) return false;
    for (size_t i = 0; i < count; i++) {
      const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
      if (!near(packing::row_of(law.law).name, number_below(radii[i]), share, 1e-6)) return false;
    }
  }
  return true;
}

// dF ~ r^(q-1) dr and dN ~ dF / r^d: N(r) = (1 - r^(q-d)) / (1 - omega^(q-d)).
bool fuller_is_a_power_law(double q, double omega, int dimension) {
  SizeLaw law = law_of("fuller", omega, dimension);
  law.modulus = q;
  return follows(law, [&](double r) {
    return q == dimension ? std::log(r) / std::log(omega)
                          : (1 - std::pow(r, q - dimension)) / (1 - std::pow(omega, q - dimension));
  });
}

bool fuller() {
  return fuller_is_a_power_law(0.5, 16, 3) && fuller_is_a_power_law(0.37, 64, 3) && fuller_is_a_power_law(0.5, 5, 2) &&
         fuller_is_a_power_law(3, 10, 3) && fuller_is_a_power_law(0.5, 1e5, 3) && fuller_is_a_power_law(1, 1.01, 3);
}

// By number again log-normal, with the median exp(-d sigma^2) times that by mass.
bool log_normal_is_one_by_number(double median, double sigma, double omega, int dimension) {
  SizeLaw law = law_of("log-normal-mass", omega, dimension);
  law.median = median;
  law.sigma = sigma;
  const auto below = [&](double r) {
    const double middle = std::log(median) - dimension * sigma * sigma;
    return 0.5 * std::erfc((middle - std::log(r)) / sigma / std::sqrt(2.0));
  };
  return follows(law, [&](double r) { return (below(r) - below(1)) / (below(omega) - below(1)); });
}

bool log_normal_mass() {
  return log_normal_is_one_by_number(10, 1, 50, 3) && log_normal_is_one_by_number(4, 0.3, 20, 3) &&
         log_normal_is_one_by_number(6, 0.5, 40, 2) && log_normal_is_one_by_number(1.5, 0.05, 2, 3);
}

// The integral of f over ln r by Simpson's rule.
double integral(double from, double to, const std::function<long double(long double)> &f) {
  constexpr int kSteps = 400;
  const long double low = std::log(static_cast<long double>(from)),
                    step = (std::log(static_cast<long double>(to)) - low) / kSteps;
  long double sum = 0;
  for (int k = 0; k <= kSteps; k++)
    sum += f(std::exp(low + step * k)) * (k == 0 || k == kSteps ? 1 : k % 2 == 1 ? 4 : 2);
  return static_cast<double>(sum * step / 3);
}

bool rosin_rammler_is_integrated(double n, double d63, double omega, int dimension) {
  SizeLaw law = law_of("rosin-rammler", omega, dimension);
  law.uniformity = n;
  law.d63 = d63;
  const auto number = [&](long double r) {
    const long double x = std::pow(r / static_cast<long double>(d63), static_cast<long double>(n));
    return x * std::exp(-x) / std::pow(r, static_cast<long double>(dimension));
  };
  const double all = integral(1, omega, number);
  const std::vector<double> radii = packing::sample_radii(law, 300, 0.5);
  for (size_t i = 0; i < radii.size(); i++) {
    if (!near("rosin-rammler", integral(1, radii[i], number) / all, (static_cast<double>(i) + 0.5) / 300, 1e-6))
      return false;
  }
  return true;
}

bool rosin_rammler() {
  return rosin_rammler_is_integrated(1, 10, 50, 3) && rosin_rammler_is_integrated(3.3, 5, 8, 3) &&
         rosin_rammler_is_integrated(0.7, 20, 200, 2) && rosin_rammler_is_integrated(9, 10, 20, 3);
}

// What the curves leave out: e^-x at the size d63 is e^-1, half lies below the median, (1/16)^(1/2) = 1/4.
bool shares_beyond_the_ends() {
  SizeLaw rosin = law_of("rosin-rammler", 8, 3), normal = law_of("log-normal-mass", 8, 3);
  rosin.d63 = normal.median = 8;
  const auto curve = [](const SizeLaw &law) { return packing::row_of(law.law).curve(law); };
  return near("coarser", curve(rosin).coarser, std::exp(-1.0), 1e-14) &&
         near("finer", curve(rosin).finer, 1 - std::exp(-0.125), 1e-14) &&
         near("coarser", curve(normal).coarser, 0.5, 1e-14) &&
         near("finer", curve(normal).finer, 0.5 * std::erfc(std::log(8.0) / std::sqrt(2.0)), 1e-14) &&
         near("finer", curve(law_of("fuller", 16, 3)).finer, 0.25, 1e-14);
}

// Two fractions, a quarter of the mass from 1 to 2 and the rest from 3 to 6, nothing between: their numbers are as
// (1/4) (1 - 1/8) to (3/4) (1/27 - 1/216), as 7/32 to 7/288, 9 to 1. Within one, N ~ 1 - (a/r)^3.
bool table_by_mass() {
  const SizeLaw law = table_law({{1, 0}, {2, 0.25}, {3, 0.25}, {6, 1}}, Measure::kVolume, 3);
  return follows(law, [](double r) {
    const double fine = (1 - std::pow(std::min(r, 2.0), -3)) / (7.0 / 8);
    const double coarse = r < 3 ? 0 : (1 - std::pow(3 / r, 3)) / (7.0 / 8);
    return 0.9 * fine + 0.1 * coarse;
  });
}

// In the plane (1/4) (1 - 1/4) to (3/4) (1/9 - 1/36), 3 to 1.
bool table_by_area() {
  const SizeLaw law = table_law({{1, 0}, {2, 0.25}, {3, 0.25}, {6, 1}}, Measure::kVolume, 2);
  return follows(law, [](double r) {
    const double fine = (1 - std::pow(std::min(r, 2.0), -2)) / (3.0 / 4);
    const double coarse = r < 3 ? 0 : (1 - std::pow(3 / r, 2)) / (3.0 / 4);
    return 0.75 * fine + 0.25 * coarse;
  });
}

// By number nothing is weighted; the volume is as 0.4 (8 - 1) / 3 ln 2 to 0.6 (64 - 8) / 3 ln 2, 1 to 12.
bool table_by_number() {
  const SizeLaw law = table_law({{1, 0}, {2, 0.4}, {4, 1}}, Measure::kNumber, 3);
  const bool is_straight = follows(law, [](double r) {
    return r < 2 ? 0.4 * std::log(r) / std::log(2.0) : 0.4 + 0.6 * std::log(r / 2) / std::log(2.0);
  });
  return is_straight && near("volume", packing::row_of(law.law).curve(law).volume_below()[1], 1.0 / 13, 1e-14);
}

// From 4 on, half way in ln r: what is finer is left out.
bool table_is_cut() {
  SizeLaw law = table_law({{1, 0}, {2, 0.2}, {8, 1}}, Measure::kVolume, 3);
  law.from = 4;
  const packing::SizeCurve curve = packing::row_of(law.law).curve(law);
  law.from = 2;
  const packing::SizeCurve at_a_row = packing::row_of(law.law).curve(law);
  return near("finer", curve.finer, 0.6, 1e-14) && curve.radii() == std::vector<double>{4, 8} &&
         at_a_row.radii() == std::vector<double>{2, 8} && near("finer", at_a_row.finer, 0.2, 1e-14) &&
         packing::first_radius(law) == 2;
}

// Grains in all for 100 in the coarsest fraction of the curve A/B16 from 1, 0.5 and 0.25 mm: the number of a fraction
// is dF (a^-3 - b^-3) / (3 ln (b/a)).
bool coarse_grains_take_many() {
  SizeLaw law =
      table_law({{0.25, .08}, {0.5, .19}, {1, .30}, {2, .40}, {4, .53}, {8, .75}, {16, 1}}, Measure::kVolume, 3);
  const double froms[] = {1, 0.5, 0.25}, counts[] = {24600, 205000, 1.65e6};
  for (size_t k = 0; k < 3; k++) {
    law.from = froms[k];
    double all = 0, coarsest = 0;
    const std::vector<packing::Knot> &knots = law.table->knots;
    for (size_t n = 2 - k; n + 1 < knots.size(); n++) {
      const double a = knots[n].radius, b = knots[n + 1].radius;
      coarsest = (knots[n + 1].share - knots[n].share) * (std::pow(a, -3) - std::pow(b, -3)) / (3 * std::log(b / a));
      all += coarsest;
    }
    const packing::SizeReport report = packing::report_sizes(law, packing::sample_radii(law, 1000, 0.5), 1);
    const double found = packing::count_for_coarsest(report, 100);
    if (!near("count", found, 100 * all / coarsest, 1) || !near("count", found, counts[k], 0.01 * counts[k]))
      return false;
  }
  return true;
}

// The report counts what is there, whatever the order and scale; volumes come near the curve where grains are many.
bool report_tells_the_sample() {
  SizeLaw law = law_of("fuller", 8, 3);
  std::vector<double> radii = packing::sample_radii(law, 1000000, 0.5);
  for (double &r : radii) r *= 0.25;
  const auto largest_last = radii.end() - 1;
  const auto in = [&](double from, double to) {
    return static_cast<size_t>(
        std::count_if(radii.begin(), radii.end(), [&](double r) { return r > from && r <= to; }));
  };
  std::swap(radii.front(), *largest_last);
  const packing::SizeReport report = packing::report_sizes(law, radii, 0.25);
  if (report.fractions.size() != 3 || report.coarser != 0) return false;
  double low = 0.25;
  for (const packing::Fraction &fraction : report.fractions) {
    // F(2r) - F(r) over F(8) - F(1) of F ~ r^(1/2)
    const double wanted = (std::sqrt(2.0) - 1) * std::sqrt(4 * low) / (std::sqrt(8.0) - 1);
    if (fraction.from != low || fraction.to != 2 * low || fraction.particles != in(low, 2 * low) ||
        !near("expected", fraction.expected, static_cast<double>(fraction.particles), 1.5) ||
        !near("wanted", fraction.wanted, wanted, 1e-6) || !near("found", fraction.found, wanted, 1e-4))
      return false;
    low *= 2;
  }
  return true;
}

bool says(const std::string &text, const char *part) {
  if (text.find(part) != std::string::npos) return true;
  std::fprintf(stderr, "no '%s' in:\n%s", part, text.c_str());
  return false;
}

// Ten particles of which the coarse fraction would get 0.03: 3/4 of the volume is missing.
bool report_tells_what_is_missing() {
  const SizeLaw law = table_law({{1, 0.2}, {2, 0.4}, {4, 0.4}, {8, 1}}, Measure::kVolume, 3);
  const std::string text = packing::words_of(packing::report_sizes(law, packing::sample_radii(law, 10, 0.5), 1));
  return says(text, "left out: 20 % of the curve's mass, finer") && says(text, "its share is 0.45 of one") &&
         says(text, "missing: 75 % of the volume, in fractions without a particle") &&
         says(text, "coarsest fraction: 0; for 100 it takes 2.23e+03 in all");
}

bool laws_without_a_curve_are_refused() {
  SizeLaw normal = law_of("log-normal-mass", 2, 3);
  normal.median = 1e6;
  normal.sigma = 0.1;
  const bool is_far = packing::law_fault(normal, 10) == "nothing of the law log-normal-mass lies between its ends";
  normal.sigma = 0.01;
  return is_far && packing::law_fault(normal, 10) == "the sigma of log-normal-mass is 0.05 or more, not 0.01" &&
         packing::law_fault(law_of("fuller", 1, 3), 10) == "nothing of the law fuller lies between its ends";
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<fuller>),
      cmocka_unit_test(passes<log_normal_mass>),
      cmocka_unit_test(passes<rosin_rammler>),
      cmocka_unit_test(passes<shares_beyond_the_ends>),
      cmocka_unit_test(passes<table_by_mass>),
      cmocka_unit_test(passes<table_by_area>),
      cmocka_unit_test(passes<table_by_number>),
      cmocka_unit_test(passes<table_is_cut>),
      cmocka_unit_test(passes<coarse_grains_take_many>),
      cmocka_unit_test(passes<report_tells_the_sample>),
      cmocka_unit_test(passes<report_tells_what_is_missing>),
      cmocka_unit_test(passes<laws_without_a_curve_are_refused>),
  };
  return cmocka_run_group_tests_name("size_curve", tests, nullptr, nullptr);
}
