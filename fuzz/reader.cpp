// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes the reader of the format FUZZ_FORMAT of particles/files: any bytes are read as particles that a grid may take,
// or refused with a text.
#include "particles/files/reader.hpp"

#include "fuzz/expect.hpp"
#include "fuzz/refusal.hpp"
#include "particles/text/text_file.hpp"

#include <cmath>
#include <cstdint>
#include <string>

namespace {

using fuzz::expect;

void check(const particles::ParticleSet &particles, bool needs_box) {
  expect(particles.dimension == 2 || particles.dimension == 3, "neither 2 nor 3 dimensions");
  expect(particles.centers.size() == particles.count() * static_cast<size_t>(particles.dimension),
         "centres and radii of different numbers of particles");
  for (const double x : particles.centers) expect(std::isfinite(x), "a centre is not finite");
  for (const double r : particles.radii) expect(std::isfinite(r) && r >= 0, "a radius is negative or not finite");
  for (int axis = 0; axis < 3; axis++) {
    const double low = particles.box_min[axis], high = particles.box_max[axis];
    expect(std::isfinite(low) && std::isfinite(high) && low <= high, "the box is upside down or not finite");
    expect(std::isfinite(particles.tilt[axis]), "a tilt is not finite");
    expect(particles.periodic[axis] == 0 || particles.has_box || !needs_box, "a periodic axis without a box");
  }
}

}  // namespace

// The first byte chooses the options, the rest is the file.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  if (size < 2) return 0;
  particles::ReadOptions options;
  options.dimension = data[0] % 4 == 1 ? 2 : data[0] % 4 == 2 ? 3 : 0;
  options.frame = data[0] / 4 % 4;
  options.needs_box = data[0] / 16 % 2 == 0;
  const int wish = data[0] / 32;
  if (wish == 1) options.radius = "size";
  if (wish == 2) options.radius = "0.5";
  if (wish == 3) options.diameter = "size";
  if (wish == 4) options.type_radii = {{"1", 0.5}, {"A", 0.25}};
  if (wish == 5) options.header = {"type", "x", "y", "z", "r"};
  const particles::TextFile file{"input", std::string(data + 1, data + size)};
  fuzz::done_or_refused([&] { check(particles::format_of_word(FUZZ_FORMAT)->read(file, options), options.needs_box); });
  return 0;
}
