// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The size laws against closed forms and reference values of the paper's systems.
#include "packing/size_law.hpp"
#include "particles/error.hpp"
#include "tests/particles/cmocka_cpp.hpp"
#include "tests/particles/page.hpp"

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

void largest_sampled_radius(void **) {
  bool ok = largest_radius_is(50, kCount, 49.752);
  assert_true(ok);
  ok = largest_radius_is(100, kCount, 98.06);
  assert_true(ok);
  ok = largest_radius_is(1000, kCount, 447.2);
  assert_true(ok);
  ok = largest_radius_is(1000, 1000000, 816.5);
  assert_true(ok);
}

bool edge_is(const SizeLaw &law, double expected) {
  const std::vector<double> radii = packing::sample_radii(law, kCount, 0.5);
  return near("box edge", packing::box_edge(radii, kDensity, law.dimension), expected, 1e-8);
}

void box_edges(void **) {
  bool ok = edge_is({Law::kUniformVolume, 50, 3}, 435.847842);
  assert_true(ok);
  ok = edge_is({Law::kUniformSize, 50, 3}, 2997.4004);
  assert_true(ok);
  ok = edge_is({Law::kUniformVolume, 10, 3}, 248.551222);
  assert_true(ok);
  ok = edge_is({Law::kUniformVolume, 100, 3}, 550.905551);
  assert_true(ok);
  ok = edge_is({Law::kTwoSizes, 10, 3}, 119.071316);
  assert_true(ok);
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

void moments(void **) {
  bool ok = moments_of_uniform_volume(50) && moments_of_uniform_volume(10);
  assert_true(ok);
  ok = moments_of_uniform_size(50);
  assert_true(ok);
  ok = moments_of_uniform_area(50);
  assert_true(ok);
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
  for (int a = 2; a <= 6; a++) {
    const bool ok = moments_of_power_law(a);
    assert_true(ok);
  }
}

bool uniform_volume_is_a_power_law() {
  return packing::sample_radii({Law::kPowerLaw, 50, 3, 3}, 1000, 0.5) ==
             packing::sample_radii({Law::kUniformVolume, 50, 3}, 1000, 0.5) &&
         packing::sample_radii({Law::kPowerLaw, 50, 2, 2}, 1000, 0.5) ==
             packing::sample_radii({Law::kUniformVolume, 50, 2}, 1000, 0.5);
}

void a_power_law_of_equal_volumes(void **) {
  const bool ok = uniform_volume_is_a_power_law();
  assert_true(ok);
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

void log_normal(void **) {
  bool ok = moments_of_log_normal(0.3, 1e-4);
  assert_true(ok);
  ok = moments_of_log_normal(1, 6e-3);
  assert_true(ok);
}

bool giant_is_one() {
  const std::vector<double> radii = packing::sample_radii({Law::kOneGiant, 30, 3}, 1000, 0.5);
  return std::count(radii.begin(), radii.end(), 1.0) == 999 && radii.back() == 30;
}

void one_giant(void **) {
  const bool ok = giant_is_one();
  assert_true(ok);
}

// Every interval of radii as wide holds as much volume: the name of the law.
bool volume_is_uniform() {
  const double omega = 10;
  const std::vector<double> radii = packing::sample_radii({Law::kUniformVolume, omega, 3}, kCount, 0.5);
  double volume[3] = {0, 0, 0};
  for (const double r : radii) volume[std::min(static_cast<int>((r - 1) / 3), 2)] += r * r * r;
  return near("volume", volume[1], volume[0], 0.01) && near("volume", volume[2], volume[0], 0.01);
}

void equal_intervals_hold_equal_volume(void **) {
  const bool ok = volume_is_uniform();
  assert_true(ok);
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

void two_sizes(void **) {
  bool ok = two_sizes_hold_equal_volume();
  assert_true(ok);
  ok = two_sizes_in_the_plane();
  assert_true(ok);
}

bool mono_is_all_ones() {
  const std::vector<double> radii = packing::sample_radii({Law::kMono, 1, 3}, 1000, 0.5);
  return radii.size() == 1000 && std::count(radii.begin(), radii.end(), 1.0) == 1000;
}

// N disks of radius 1 at density nu: S^2 = N pi / nu; spheres: S^3 = N 4 pi / (3 nu).
void mono(void **) {
  const bool ok = mono_is_all_ones();
  assert_true(ok);
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

void offset(void **) {
  const bool ok = offset_shifts_the_sample();
  assert_true(ok);
}

bool refuses_name(const std::string &name) {
  try {
    packing::usual_law(name);
  } catch (const particles::Error &error) {
    return std::string(error.what()) == "no size law is called '" + name +
                                            "': use one of mono, two-sizes, uniform-size, uniform-volume, power-law, "
                                            "log-normal, one-giant";
  }
  return false;
}

// A name gives its law with values that are allowed.
bool every_law_is_usual() {
  for (const packing::LawRow &row : packing::size_laws()) {
    const SizeLaw law = packing::usual_law(row.name);
    const std::string fault = packing::law_fault(law, kCount);
    if (law.law == row.law && fault.empty()) continue;
    std::fprintf(stderr, "%s: %s\n", row.name, fault.c_str());
    return false;
  }
  return packing::usual_law("two-sizes").ratio == 10 && packing::usual_law("uniform-volume").ratio == 50 &&
         packing::law_with("log-normal", 0.5).sigma == 0.5 && packing::law_with("power-law", 7).ratio == 7;
}

void names(void **) {
  bool ok = every_law_is_usual();
  assert_true(ok);
  ok = refuses_name("normal");
  assert_true(ok);
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
                           "is for two-sizes, uniform-size, uniform-volume, power-law, one-giant, not for the law "
                           "log-normal"));
  assert_string_equal(packing::describe(parameter("exponent")).c_str(),
                      "power-law: a of p(r) ~ r^-a, a whole number, 2 to 9");
  assert_string_equal(packing::usual_values(parameter("ratio")).c_str(), "50; mono: 1; two-sizes: 10; one-giant: 10");
}

// docs/guide/command.md has a line for every row of the table.
bool page_tells_all() {
  for (const packing::LawRow &row : packing::size_laws()) {
    if (!test::page_has(HGRID_COMMAND_PAGE, std::string("| ") + row.name + " | " + row.radii + " |\n")) return false;
  }
  return true;
}

void the_page_tells_every_law(void **) {
  const bool ok = page_tells_all();
  assert_true(ok);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(largest_sampled_radius),
      cmocka_unit_test(box_edges),
      cmocka_unit_test(moments),
      cmocka_unit_test(power_laws),
      cmocka_unit_test(a_power_law_of_equal_volumes),
      cmocka_unit_test(log_normal),
      cmocka_unit_test(one_giant),
      cmocka_unit_test(equal_intervals_hold_equal_volume),
      cmocka_unit_test(two_sizes),
      cmocka_unit_test(mono),
      cmocka_unit_test(offset),
      cmocka_unit_test(names),
      cmocka_unit_test(parameters),
      cmocka_unit_test(the_page_tells_every_law),
  };
  return cmocka_run_group_tests_name("size_law", tests, nullptr, nullptr);
}
