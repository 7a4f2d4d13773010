// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Functions of plain arithmetic against the C library, and arrangements against the shares that define them.
#include "packing/arrangement.hpp"
#include "packing/portable_math.hpp"
#include "tests/particles/page.hpp"
#include "tests/support/frame.h"
#include "tests/support/refusal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using packing::Arrangement;

constexpr uint64_t kSeed = 99;
constexpr int kThrows = 20000;

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

bool quantiles() {
  for (const double p : {1e-7, 0.001, 0.1, 0.4999, 0.6, 0.975, 0.999999}) {
    const double x = packing::normal_quantile(p);
    if (!near("Phi of the quantile", p, 0.5 * std::erfc(-x / std::sqrt(2.0)), p, 1e-14 / p)) return false;
  }
  const double low = packing::normal_quantile(0), high = packing::normal_quantile(1);
  return packing::normal_quantile(0.5) == 0 && low < -7.5 && low > -9 && high > 7.5 && high < 9;
}

bool plain_arithmetic() { return roots_and_powers() && exponentials() && quantiles(); }

packing::Box box_of(int dimension) { return packing::Box(dimension, packing::Vector::Constant(10), {}); }

// The share of throws of which `where` is true; all must lie in the box.
template <class Where>
double share(Arrangement arrangement, int dimension, Where where) {
  const packing::Box box = box_of(dimension);
  packing::Random random(kSeed);
  packing::Thrower thrower(arrangement, box, random);
  int inside = 0;
  for (int i = 0; i < kThrows; i++) {
    double x[3] = {0, 0, 0};
    thrower(0.01, x);
    for (int axis = 0; axis < dimension; axis++) {
      if (!(x[axis] >= 0.01 && x[axis] <= 9.99)) return -1;
    }
    inside += where(x) ? 1 : 0;
  }
  return static_cast<double>(inside) / kThrows;
}

double distance_from_middle(const double *x, int dimension) {
  double square = 0;
  for (int axis = 0; axis < dimension; axis++) square += (x[axis] - 5) * (x[axis] - 5);
  return std::sqrt(square);
}

bool shares(int d) {
  const double even = share(Arrangement::kEven, d, [](const double *x) { return x[0] < 2.5; });
  const double film =
      share(Arrangement::kFilm, d, [d](const double *x) { return std::fabs(x[d - 1] - 5) <= 0.25 && x[0] < 2.5; });
  const double shell = share(Arrangement::kShell, d, [d](const double *x) {
    return std::fabs(distance_from_middle(x, d) - 4) <= 0.1000001 && x[1] < 5;
  });
  const double crowded = share(Arrangement::kCrowded, d, [d](const double *x) {
    return std::max({x[0], x[1], x[2]}) <= 10 * std::pow(0.01, 1.0 / d);
  });
  // Three standard deviations of a share of 20000 throws are 0.01 at most.
  return std::fabs(even - 0.25) < 0.01 && std::fabs(film - 0.25) < 0.01 && std::fabs(shell - 0.5) < 0.011 &&
         std::fabs(crowded - 0.9901) < 0.003;
}

bool arrangements_hold_their_shares() { return shares(3) && shares(2); }

// The share of pairs of throws nearer to each other than `reach`.
double close_share(double reach) {
  const packing::Box box = box_of(3);
  packing::Random random(kSeed);
  packing::Thrower thrower(Arrangement::kClusters, box, random);
  constexpr size_t kCount = 4000;
  std::vector<double> x(3 * kCount, 0.0);
  for (size_t i = 0; i < kCount; i++) thrower(0, &x[3 * i]);
  int close = 0;
  for (size_t i = 0; i < kCount; i++) {
    for (size_t j = 0; j < i; j++) {
      double square = 0;
      for (size_t axis = 0; axis < 3; axis++) {
        const double difference = x[3 * i + axis] - x[3 * j + axis];
        square += difference * difference;
      }
      close += square < reach * reach ? 1 : 0;
    }
  }
  return close / (0.5 * kCount * (kCount - 1));
}

bool clusters_are_plummer_spheres() {
  // Mean of (1 + u^2)^(-5/2) over the mass: 3 * integral of u^2 (1 + u^2)^-5 = 3 * 5 pi / 256.
  const double mean = 15 * M_PI / 256, reach = 0.05;
  const double density = mean / (1000 * packing::row_of(Arrangement::kClusters).share(3));
  const double expected = density * 4 * M_PI / 3 * reach * reach * reach;
  return near("close pairs", reach, close_share(reach), expected, 0.1);
}

void volumes(void **) {
  assert_true(packing::row_of(Arrangement::kEven).share(3) == 1);
  assert_true(std::fabs(packing::row_of(Arrangement::kShell).share(3) - 4 * M_PI * 0.16 * 0.02) < 1e-4);
  assert_true(std::fabs(packing::row_of(Arrangement::kShell).share(2) - 2 * M_PI * 0.4 * 0.02) < 1e-12);
  assert_true(std::fabs(packing::row_of(Arrangement::kClusters).share(2) - 20 * M_PI * 0.0004) < 1e-12);
}

// docs/guide/command.md has a line for every row of the table.
bool page_tells_all() {
  for (const packing::ArrangementRow &row : packing::arrangements()) {
    if (!test::page_has(HGRID_COMMAND_PAGE, std::string("| ") + row.name + " | " + row.places + " |\n")) return false;
  }
  return true;
}

bool names() {
  const auto &rows = packing::arrangements();
  return std::all_of(rows.begin(), rows.end(),
                     [](const auto &row) { return packing::arrangement_from_name(row.name) == row.arrangement; }) &&
         test::is_refused("'heap'", [] { packing::arrangement_from_name("heap"); });
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<plain_arithmetic>),
      cmocka_unit_test(passes<arrangements_hold_their_shares>),
      cmocka_unit_test(passes<clusters_are_plummer_spheres>),
      cmocka_unit_test(volumes),
      cmocka_unit_test(passes<names>),
      cmocka_unit_test(passes<page_tells_all>),
  };
  return cmocka_run_group_tests_name("arrangement", tests, nullptr, nullptr);
}
