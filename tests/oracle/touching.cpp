// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// touching COUNT OFFSET RATIO: prints a particle file full of pairs within rounding of touching, radii over a range of
// RATIO, all coordinates moved by OFFSET.
#include "programs/accuracy/search/systems.hpp"

#include <cstdio>
#include <cstdlib>

int main(int count, char **arguments) {
  if (count != 4) {
    std::fprintf(stderr, "usage: touching COUNT OFFSET RATIO\n");
    return 2;
  }
  const auto particles = static_cast<size_t>(std::strtol(arguments[1], nullptr, 10));
  const double offset = std::strtod(arguments[2], nullptr), ratio = std::strtod(arguments[3], nullptr);
  const particles::ParticleSet set = accuracy::moved(accuracy::touching_chain(particles, ratio), offset);
  std::printf("x,y,z,radius\n");
  for (size_t i = 0; i < set.count(); i++) {
    const double *x = &set.centers[3 * i];
    std::printf("%.17g,%.17g,%.17g,%.17g\n", x[0], x[1], x[2], set.radii[i]);
  }
  return 0;
}
