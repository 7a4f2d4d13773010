// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Functions of plain arithmetic against the C library.
#include "packing/portable_math.hpp"
#include "tests/support/frame.h"

#include <cmath>
#include <cstdio>

namespace {

bool near(const char *what, double at, double found, double expected, double relative) {
  if (std::fabs(found - expected) <= relative * std::fabs(expected)) return true;
  std::fprintf(stderr, "%s at %.17g: found %.17g, expected %.17g\n", what, at, found, expected);
  return false;
}

bool roots_and_powers() {
  for (int degree = 1; degree <= 8; degree++) {
    for (const double x : {1e-30, 0.001, 0.5, 1.0, 2.0, 7.7e6, 1e40}) {
      const double r = packing::root(x, degree);
      if (!near("root", x, r, std::pow(x, 1.0 / degree), 1e-14)) return false;
      if (!near("power", x, packing::power(r, degree), x, 1e-13)) return false;
    }
  }
  return packing::root(0, 3) == 0 && packing::power(3, 0) == 1;
}

bool exponentials() {
  for (const double x : {-40.0, -3.3, -0.1, 0.0, 1e-9, 0.5, 2.0, 30.0}) {
    if (!near("exponential", x, packing::exponential(x), std::exp(x), 1e-13)) return false;
  }
  return true;
}

bool logarithms() {
  for (const double x : {1e-300, 1e-9, 0.3, 0.70710678, 0.999999, 1.000001, 1.5, 2.0, 1e6, 1e300}) {
    if (!near("logarithm", x, packing::logarithm(x), std::log(x), 1e-15)) return false;
  }
  for (const double exponent : {-3.0, -0.5, 0.0, 0.37, 2.0}) {
    if (!near("power", exponent, packing::real_power(7.3, exponent), std::pow(7.3, exponent), 1e-14)) return false;
  }
  return packing::logarithm(1) == 0;
}

bool quantiles() {
  for (const double p : {1e-7, 0.001, 0.1, 0.4999, 0.6, 0.975, 0.999999}) {
    const double x = packing::normal_quantile(p);
    if (!near("Phi of the quantile", p, 0.5 * std::erfc(-x / std::sqrt(2.0)), p, 1e-14 / p)) return false;
  }
  const double low = packing::normal_quantile(0), high = packing::normal_quantile(1);
  return packing::normal_quantile(0.5) == 0 && low < -7.5 && low > -9 && high > 7.5 && high < 9;
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<roots_and_powers>),
      cmocka_unit_test(passes<exponentials>),
      cmocka_unit_test(passes<logarithms>),
      cmocka_unit_test(passes<quantiles>),
  };
  return cmocka_run_group_tests_name("portable_math", tests, nullptr, nullptr);
}
