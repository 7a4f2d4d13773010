// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Random points in a periodic box: the mean number of pairs is known for any radii.
//
// With v_ij the volume of the ball of radius r_i + r_j, a pair overlaps with probability v_ij / V. On a torus these
// events are pairwise independent (the third particle sees uniform positions whatever the other two do), so the
// variance of the count is below its mean.
#include "tests/support/compare.hpp"
#include "tests/support/rng.hpp"
#include "tests/support/size_laws.hpp"

#include <cmath>

namespace {

using namespace hgtest;

constexpr double kPi = 3.14159265358979323846;

// Sum over i < j of (r_i + r_j)^d from the sums of powers of r, d = 2 or 3.
double sum_of_powers(const std::vector<double> &radii, int dimension) {
  double s1 = 0;
  double s2 = 0;
  double s3 = 0;
  for (double r : radii) {
    s1 += r;
    s2 += r * r;
    s3 += r * r * r;
  }
  const double n = static_cast<double>(radii.size());
  if (dimension == 2) return 0.5 * (2 * n * s2 + 2 * s1 * s1 - 4 * s2);
  return 0.5 * (2 * n * s3 + 6 * s1 * s2 - 8 * s3);
}

void require_poisson(const char *what, uint64_t seed, int dimension, const std::vector<double> &radii, double edge) {
  Rng rng(seed);
  hg_grid_def def = hg_default_grid_def();
  def.dimension = dimension;
  Particles particles;
  particles.dimension = dimension;
  for (int k = 0; k < dimension; k++) {
    def.periodic[k] = 1;
    def.box_max[k] = edge;
  }
  for (double r : radii) {
    double x[3];
    for (int k = 0; k < dimension; k++) x[k] = rng.uniform(0, edge);
    particles.add(x, r);
  }
  const double ball = dimension == 2 ? kPi : 4 * kPi / 3;
  const double mean = ball * sum_of_powers(radii, dimension) / std::pow(edge, dimension);
  const double count = static_cast<double>(pairs_of(make_grid(def, particles)).size());
  const double sigmas = (count - mean) / std::sqrt(mean);
  require(mean > 1000 && std::fabs(sigmas) < 4.5, std::string(what) + ": " + std::to_string(count) + " pairs, mean " +
                                                      std::to_string(mean) + ", off by " + std::to_string(sigmas) +
                                                      " standard deviations");
}

void pairs_of_random_points(void **) {
  assert_true(sweep(3, [](uint64_t s) {
    require_poisson("equal sizes, 2D", s, 2, std::vector<double>(20000, 1), 250);
    require_poisson("equal sizes", s, 3, std::vector<double>(20000, 1), 60);
    require_poisson("two sizes", s, 3, two_sizes(10, 40000), 80);
    require_poisson("uniform size 50", s, 3, sample(uniform_size, 50, 20000), 1600);
    require_poisson("uniform volume 20, 2D", s, 2, sample(uniform_volume, 20, 20000), 400);
    require_poisson("uniform volume 20", s, 3, sample(uniform_volume, 20, 20000), 150);
    require_poisson("uniform volume 1000", s, 3, sample(uniform_volume, 1000, 50000), 1500);
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(pairs_of_random_points)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
