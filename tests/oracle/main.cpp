// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid_oracle FILE [exact | float128 | double]: prints the overlapping pairs of a particle file as `hgrid pairs FILE
// --order id` should, found by looking at every pair.
#include "oracle/particles.hpp"
#include "particles/error.hpp"
#include "particles/files/reader.hpp"

#include <cstdio>
#include <cstring>

int main(int count, char **arguments) {
  const char *wanted = count > 2 ? arguments[2] : "exact";
  const char *const names[] = {"exact", "float128", "double"};
  int arithmetic = 0;
  while (arithmetic < 3 && std::strcmp(wanted, names[arithmetic]) != 0) arithmetic++;
  if (count < 2 || count > 3 || arithmetic == 3) {
    std::fprintf(stderr, "usage: hgrid_oracle FILE [exact | float128 | double]\n");
    return 2;
  }
  try {
    const oracle::Set set = oracle::set_of(particles::read_particles(arguments[1]));
    std::printf("a,b\n");
    for (const auto &pair : overlapping_pairs(set, static_cast<oracle::Arithmetic>(arithmetic))) {
      std::printf("%d,%d\n", pair.first, pair.second);
    }
  } catch (const std::exception &error) {
    std::fprintf(stderr, "hgrid_oracle: %s\n", error.what());
    return 1;
  }
  return 0;
}
