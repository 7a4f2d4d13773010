// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid_oracle FILE: prints the overlapping pairs of a particle file as `hgrid pairs FILE --order id` should, found by
// looking at every pair in whole numbers.
#include "particles/error.hpp"
#include "particles/files/reader.hpp"
#include "programs/measure/search_timer.hpp"
#include "tests/oracle/whole_numbers.hpp"

#include <cstdio>

int main(int count, char **arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: hgrid_oracle FILE\n");
    return 2;
  }
  try {
    const particles::ParticleSet particles = particles::read_particles(arguments[1]);
    std::printf("a,b\n");
    for (const hg_pair &pair : hgtest::whole_number_pairs(measure::def_of(particles), particles)) {
      std::printf("%d,%d\n", pair.a, pair.b);
    }
  } catch (const std::exception &error) {
    std::fprintf(stderr, "hgrid_oracle: %s\n", error.what());
    return 1;
  }
  return 0;
}
