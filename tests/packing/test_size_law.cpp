// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The size laws against closed forms and reference values of the paper's systems.
#include "packing/size_law.hpp"
#include "particles/error.hpp"
#include "tests/particles/page.hpp"
#include "tests/support/frame.h"
#include "tests/support/refusal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using packing::Law;
using packing::SizeLaw;

constexpr size_t kCount = 125001;
constexpr double kDensity = 0.62;

bool near(const char *what, double found, double expected, double relative) {
  if (std::fabs(found - expected) <= relative * std::fabs(expected)) return true;
  std::fprintf(stderr, "%s: found %.12g, expected %.12g\n", what, found, expected);
  return false;
}

double moment(const std::vector<double> &radii, int power) {
  double sum = 0;
  for (const double r : radii) sum += std::pow(r, power);
  return sum / static_cast<double>(radii.size());
}

bool largest_radius_is(double omega, size_t count, double expected) {
  const std::vector<double> radii = packing::sample_radii({Law::kUniformVolume, omega, 3}, count, 0.5);
  return std::is_sorted(radii.begin(), radii.end()) && radii.front() >= 1 &&
         near("largest radius", radii.back(), expected, 1e-4);
}

bool largest_sampled_radius() {
  return largest_radius_is(50, kCount, 49.752) && largest_radius_is(100, kCount, 98.06) &&
         largest_radius_is(1000, kCount, 447.2) && largest_radius_is(1000, 1000000, 816.5);
}

bool edge_is(const SizeLaw &law, double expected) {
  const std::vector<double> radii = packing::sample_radii(law, kCount, 0.5);
  return near("box edge", packing::box_edge(radii, kDensity, law.dimension), expected, 1e-8);
}

bool box_edges() {
  return edge_is({Law::kUniformVolume, 50, 3}, 435.847842) && edge_is({Law::kUniformSize, 50, 3}, 2997.4004) &&
         edge_is({Law::kUniformVolume, 10, 3}, 248.551222) && edge_is({Law::kUniformVolume, 100, 3}, 550.905551) &&
         edge_is({Law::kTwoSizes, 10, 3}, 119.071316);
}

// Sampling error of the midpoint rule: largest for <r^3>, whose weight lies in the few large radii.
bool moments_of_uniform_volume(double omega) {
  const std::vector<double> radii = packing::sample_radii({Law::kUniformVolume, omega, 3}, kCount, 0.5);
  return near("<r>", moment(radii, 1), 2 * omega / (omega + 1), 1e-4) &&
         near("<r^2>", moment(radii, 2), 2 * std::log(omega) * omega * omega / (omega * omega - 1), 1e-3) &&
         near("<r^3>", moment(radii, 3), 2 * omega * omega / (omega + 1), 2e-3);
}

bool moments_of_uniform_size(double omega) {
  const std::vector<double> radii = packing::sample_radii({Law::kUniformSize, omega, 3}, kCount, 0.5);
  return near("<r>", moment(radii, 1), (omega + 1) / 2, 1e-8) &&
         near("<r^3>", moment(radii, 3), (std::pow(omega, 4) - 1) / 4 / (omega - 1), 1e-8);
}

// p(r) ~ r^-2: <r> = ln(omega) / (1 - 1/omega), <r^2> = omega.
bool moments_of_uniform_area(double omega) {
  const std::vector<double> radii = packing::sample_radii({Law::kUniformVolume, omega, 2}, kCount, 0.5);
  return near("<r>", moment(radii, 1), std::log(omega) / (1 - 1 / omega), 1e-4) &&
         near("<r^2>", moment(radii, 2), omega, 1e-3);
}

bool moments() {
  return moments_of_uniform_volume(50) && moments_of_uniform_volume(10) && moments_of_uniform_size(50) &&
         moments_of_uniform_area(50);
}

// p(r) ~ r^-a: <r^n> = (a-1)/(a-1-n) (1 - omega^(n+1-a)) / (1 - omega^(1-a)), with a logarithm at n = a - 1.
bool moments_of_power_law(int a) {
  const double omega = 20;
  const std::vector<double> radii =
      packing::sample_radii({Law::kPowerLaw, omega, 3, static_cast<double>(a)}, kCount, 0.5);
  const double norm = (1 - std::pow(omega, 1 - a)) / (a - 1);
  for (int n = 1; n <= 3; n++) {
    const double integral = n == a - 1 ? std::log(omega) : (std::pow(omega, n + 1 - a) - 1) / (n + 1 - a);
    if (!near("<r^n> of a power law", moment(radii, n), integral / norm, 5e-3)) return false;
  }
  return true;
}

void power_laws(void **) {
  for (int a = 2; a <= 6; a++) assert_true(moments_of_power_law(a));
}

bool uniform_volume_is_a_power_law() {
  return packing::sample_radii({Law::kPowerLaw, 50, 3, 3}, 1000, 0.5) ==
             packing::sample_radii({Law::kUniformVolume, 50, 3}, 1000, 0.5) &&
         packing::sample_radii({Law::kPowerLaw, 50, 2, 2}, 1000, 0.5) ==
             packing::sample_radii({Law::kUniformVolume, 50, 2}, 1000, 0.5);
}

// <r^n> = exp(n^2 sigma^2 / 2); the sample misses the tail beyond 4.5 sigma, which counts for high moments.
bool moments_of_log_normal(double sigma, double relative) {
  SizeLaw law{Law::kLogNormal, 1, 3};
  law.sigma = sigma;
  const std::vector<double> radii = packing::sample_radii(law, kCount, 0.5);
  return std::is_sorted(radii.begin(), radii.end()) && near("median", radii[kCount / 2], 1, 1e-12) &&
         near("<r>", moment(radii, 1), std::exp(sigma * sigma / 2), 1e-4) &&
         near("<r^2>", moment(radii, 2), std::exp(2 * sigma * sigma), relative) &&
         near("<r^3>", moment(radii, 3), std::exp(4.5 * sigma * sigma), 20 * relative);
}

bool log_normal() { return moments_of_log_normal(0.3, 1e-4) && moments_of_log_normal(1, 6e-3); }

bool giant_is_one() {
  const std::vector<double> radii = packing::sample_radii({Law::kOneGiant, 30, 3}, 1000, 0.5);
  return std::count(radii.begin(), radii.end(), 1.0) == 999 && radii.back() == 30;
}

// Every interval of radii as wide holds as much volume: the name of the law.
bool volume_is_uniform() {
  const double omega = 10;
  const std::vector<double> radii = packing::sample_radii({Law::kUniformVolume, omega, 3}, kCount, 0.5);
  double volume[3] = {0, 0, 0};
  for (const double r : radii) volume[std::min(static_cast<int>((r - 1) / 3), 2)] += r * r * r;
  return near("volume", volume[1], volume[0], 0.01) && near("volume", volume[2], volume[0], 0.01);
}

bool two_sizes_hold_equal_volume() {
  const SizeLaw law{Law::kTwoSizes, 10, 3};
  const std::vector<double> radii = packing::sample_radii(law, kCount, 0.5);
  const auto large = std::count(radii.begin(), radii.end(), 10.0), small = std::count(radii.begin(), radii.end(), 1.0);
  return large == 125 && small == 124876;
}

bool two_sizes_in_the_plane() {
  const std::vector<double> radii = packing::sample_radii({Law::kTwoSizes, 10, 2}, 1010, 0.5);
  return std::count(radii.begin(), radii.end(), 10.0) == 10 && radii[999] == 1 && radii[1000] == 10;
}

bool two_sizes() { return two_sizes_hold_equal_volume() && two_sizes_in_the_plane(); }

bool mono_is_all_ones() {
  const std::vector<double> radii = packing::sample_radii({Law::kMono, 1, 3}, 1000, 0.5);
  return radii.size() == 1000 && std::count(radii.begin(), radii.end(), 1.0) == 1000;
}

// N disks of radius 1 at density nu: S^2 = N pi / nu; spheres: S^3 = N 4 pi / (3 nu).
void mono(void **) {
  assert_true(mono_is_all_ones());
  const double edge2 = packing::box_edge(std::vector<double>(100, 1.0), 0.5, 2);
  const double edge3 = packing::box_edge(std::vector<double>(1000, 0.01), 0.5, 3);
  assert_true(std::fabs(edge2 - 25.0662827463) < 1e-9);
  assert_true(std::fabs(edge3 - 0.203098) < 1e-6);
}

bool offset_shifts_the_sample() {
  const SizeLaw law{Law::kUniformSize, 3, 3};
  const std::vector<double> radii = packing::sample_radii(law, 4, 0.25);
  return radii == std::vector<double>{1.125, 1.625, 2.125, 2.625};
}

// A name gives its law with values that are allowed; a table alone needs a file.
bool every_law_is_usual() {
  for (const packing::LawRow &row : packing::size_laws()) {
    const SizeLaw law = packing::usual_law(row.name);
    const std::string fault = packing::law_fault(law, kCount);
    const std::string expected = row.law == Law::kTable ? "the law table needs a file of sizes" : "";
    if (law.law == row.law && fault == expected) continue;
    std::fprintf(stderr, "%s: %s\n", row.name, fault.c_str());
    return false;
  }
  return packing::usual_law("two-sizes").ratio == 10 && packing::usual_law("uniform-volume").ratio == 50 &&
         packing::law_with("log-normal", 0.5).sigma == 0.5 && packing::law_with("power-law", 7).ratio == 7;
}

bool an_unknown_law_is_refused() {
  return test::error_of([] { packing::usual_law("normal"); }) ==
         "no size law is called 'normal': use one of mono, two-sizes, uniform-size, uniform-volume, power-law, "
         "log-normal, one-giant, fuller, rosin-rammler, log-normal-mass, table";
}

const packing::LawParameter &parameter(const std::string &name) {
  for (const packing::LawParameter *found : packing::law_parameters())
    if (found->name == name) return *found;
  throw particles::Error("no parameter " + name);
}

bool setting_says(const std::string &law, const std::string &name, double value, const std::string &expected) {
  SizeLaw set = packing::usual_law(law);
  const std::string found = packing::set_parameter(set, parameter(name), value);
  if (found == expected && (!found.empty() || set.*parameter(name).value == value)) return true;
  std::fprintf(stderr, "%s of %s: %s\n", name.c_str(), law.c_str(), found.c_str());
  return false;
}

// A law takes its own parameters only.
void parameters(void **) {
  assert_true(setting_says("power-law", "exponent", 4, ""));
  assert_true(setting_says("power-law", "ratio", 4, ""));
  assert_true(setting_says("mono", "ratio", 1, ""));
  assert_true(setting_says("mono", "ratio", 3, "is 1 for the law mono, not 3"));
  assert_true(setting_says("mono", "exponent", 4, "is for power-law, not for the law mono"));
  assert_true(setting_says("log-normal", "ratio", 4,
                           "is for two-sizes, uniform-size, uniform-volume, power-law, one-giant, fuller, "
                           "rosin-rammler, log-normal-mass, not for the law log-normal"));
  assert_string_equal(packing::describe(parameter("exponent")).c_str(),
                      "power-law: a of p(r) ~ r^-a, a whole number, 2 to 9");
  assert_string_equal(packing::usual_values(parameter("ratio")).c_str(),
                      "50; mono: 1; two-sizes: 10; one-giant: 10; fuller: 16");
}

// docs/guide/command.md has a line for every row of the table.
bool page_tells_all() {
  for (const packing::LawRow &row : packing::size_laws()) {
    if (!test::page_has(HGRID_COMMAND_PAGE, std::string("| ") + row.name + " | " + row.radii + " |\n")) return false;
  }
  return true;
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<largest_sampled_radius>),
      cmocka_unit_test(passes<box_edges>),
      cmocka_unit_test(passes<moments>),
      cmocka_unit_test(power_laws),
      cmocka_unit_test(passes<uniform_volume_is_a_power_law>),
      cmocka_unit_test(passes<log_normal>),
      cmocka_unit_test(passes<giant_is_one>),
      cmocka_unit_test(passes<volume_is_uniform>),
      cmocka_unit_test(passes<two_sizes>),
      cmocka_unit_test(mono),
      cmocka_unit_test(passes<offset_shifts_the_sample>),
      cmocka_unit_test(passes<every_law_is_usual>),
      cmocka_unit_test(passes<an_unknown_law_is_refused>),
      cmocka_unit_test(parameters),
      cmocka_unit_test(passes<page_tells_all>),
  };
  return cmocka_run_group_tests_name("size_law", tests, nullptr, nullptr);
}
