// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Newton's iteration where it runs one way, so that it ends without a tolerance, and power series.
#include "packing/portable_math.hpp"

#include <cmath>

namespace packing {
namespace {

// Phi(x) - 1/2 = phi(x) (x + x^3 / 3 + x^5 / (3 5) + ...): G. Marsaglia, J. Stat. Softw. 11 (2004) 4.
double upper_half(double x, double density) {
  double term = x, sum = x;
  for (int odd = 3;; odd += 2) {
    term *= x * x / odd;
    if (!(sum + term > sum)) return density * sum;
    sum += term;
  }
}

// Phi is concave above 0, so from 0 on each step falls short of the root.
double quantile_above(double half) {
  constexpr double kOneOverSqrt2Pi = 0.398942280401432677940;
  double x = 0;
  for (;;) {
    const double density = kOneOverSqrt2Pi * exponential(-0.5 * x * x);
    const double next = x + (half - upper_half(x, density)) / density;
    if (!(next > x)) return x;
    x = next;
  }
}

}  // namespace

double power(double base, int exponent) {
  double result = 1;
  for (int n = 0; n < exponent; n++) result *= base;
  return result;
}

// Newton's iteration from above.
double root(double x, int degree) {
  if (degree == 1 || x == 0) return x;
  if (degree == 2) return std::sqrt(x);
  double found = x > 1 ? x : 1;
  for (;;) {
    const double next = found - (found - x / power(found, degree - 1)) / degree;
    if (!(next < found)) return found;
    found = next;
  }
}

double exponential(double x) {
  int halvings = 0;
  for (; x > 0.5 || x < -0.5; halvings++) x *= 0.5;
  double term = 1, sum = 1;
  for (int n = 1; n <= 18; n++) {  // 0.5^18 / 18! < 2^-70
    term *= x / n;
    sum += term;
  }
  for (; halvings > 0; halvings--) sum *= sum;
  return sum;
}

// x = m 2^e with m about 1, and ln m = 2 (t + t^3 / 3 + t^5 / 5 + ...), t = (m - 1) / (m + 1).
double logarithm(double x) {
  constexpr double kLn2 = 0.693147180559945309417, kRootOfHalf = 0.7071067811865476;
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < kRootOfHalf) {
    m *= 2;
    exponent--;
  }
  const double t = (m - 1) / (m + 1);
  double term = t, sum = t;
  for (int odd = 3;; odd += 2) {
    term *= t * t;
    const double next = sum + term / odd;
    if (next == sum) return 2 * sum + exponent * kLn2;
    sum = next;
  }
}

double real_power(double base, double exponent) { return exponential(exponent * logarithm(base)); }

double normal_quantile(double p) { return p < 0.5 ? -quantile_above(0.5 - p) : quantile_above(p - 0.5); }

double unit_ball(int dimension) {
  constexpr double kPi = 3.14159265358979323846;
  return dimension == 2 ? kPi : 4 * kPi / 3;
}

double volume_of(const std::vector<double> &radii, int dimension) {
  double sum = 0;
  for (const double r : radii) sum += power(r, dimension);
  return unit_ball(dimension) * sum;
}

}  // namespace packing
