// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// touching COUNT OFFSET RATIO: prints a particle file full of pairs within rounding of touching, radii over a range of
// RATIO, all coordinates moved by OFFSET.
#include "rng.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

int main(int count, char **arguments) {
  if (count != 4) {
    std::fprintf(stderr, "usage: touching COUNT OFFSET RATIO\n");
    return 2;
  }
  const long particles = std::strtol(arguments[1], nullptr, 10);
  const double offset = std::strtod(arguments[2], nullptr), ratio = std::strtod(arguments[3], nullptr);
  hgtest::Rng rng(1);
  double x[3] = {0, 0, 0}, radius = 1;
  std::printf("x,y,z,radius\n");
  // Each particle touches the one before, on a random walk in a box of 20.
  for (long i = 0; i < particles; ++i) {
    const double next = std::pow(ratio, -rng.uniform());
    double direction[3], norm2 = 0;
    for (int k = 0; k < 3; ++k) {
      direction[k] = rng.uniform(-1, 1);
      norm2 += direction[k] * direction[k];
    }
    for (int k = 0; k < 3; ++k) {
      const double step = (radius + next) * direction[k] / std::sqrt(norm2);
      x[k] += std::fabs(x[k] + step) > 10 ? -step : step;
    }
    radius = next;
    std::printf("%.17g,%.17g,%.17g,%.17g\n", offset + x[0], offset + x[1], offset + x[2], radius);
  }
  return 0;
}
