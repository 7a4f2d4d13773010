// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The steps of making a packing, and what a request must fulfil.
#include "packing/packing.hpp"

#include "packing/placement.hpp"
#include "particles/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace packing {
namespace {

std::string text(double number) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.10g", number);
  return buffer;
}

// Ids are 32-bit numbers.
constexpr size_t kMostParticles = std::numeric_limits<int32_t>::max();

void check_box(const Request &request, double edge, double largest_radius) {
  const bool any_wall = !std::all_of(request.periodic.begin(), request.periodic.begin() + request.law.dimension,
                                     [](bool p) { return p; });
  if (any_wall && edge < 2 * largest_radius) {
    throw particles::Error("the box (edge " + text(edge) + ") is smaller than the largest particle (diameter " +
                           text(2 * largest_radius) + "): raise the count or lower the density");
  }
  const bool any_periodic =
      std::any_of(request.periodic.begin(), request.periodic.begin() + request.law.dimension, [](bool p) { return p; });
  if (any_periodic && edge < 4 * largest_radius) {
    throw particles::Error("the periodic box (edge " + text(edge) + ") is shorter than two of the largest diameter (" +
                           text(2 * largest_radius) + "): raise the count or lower the density");
  }
}

}  // namespace

void check_request(const Request &request) {
  const SizeLaw &law = request.law;
  if (law.dimension != 2 && law.dimension != 3) {
    throw particles::Error("the dimension is 2 or 3, not " + std::to_string(law.dimension));
  }
  if (request.count < 1 || request.count > kMostParticles) {
    throw particles::Error("the count is 1 to " + std::to_string(kMostParticles) + ", not " +
                           std::to_string(request.count));
  }
  if (!(request.density > 0) || !(request.density < 1)) {
    throw particles::Error("the density lies between 0 and 1, not at " + text(request.density));
  }
  if (!(law.ratio >= 1) || !(law.ratio <= 1e6)) {
    throw particles::Error("the ratio of the largest to the smallest radius is 1 to 1e6, not " + text(law.ratio));
  }
  if (!(request.offset >= 0) || !(request.offset < 1)) {
    throw particles::Error("the offset of the sampling lies in [0, 1), not at " + text(request.offset));
  }
  if (request.sweeps < 0) {
    throw particles::Error("the number of sweeps cannot be negative: " + std::to_string(request.sweeps));
  }
  if (law.exponent < 2 || law.exponent > 9) {
    throw particles::Error("the exponent of a power law is 2 to 9, not " + std::to_string(law.exponent));
  }
  if (!(law.sigma > 0) || !(law.sigma <= 3)) {
    throw particles::Error("the deviation sigma lies above 0 and up to 3, not at " + text(law.sigma));
  }
  if (law.law == Law::kTwoSizes) {
    const size_t large = large_count(law, request.count);
    if (large == 0 || large == request.count) {
      throw particles::Error("two sizes of ratio " + text(law.ratio) + " and equal volume need more than " +
                             std::to_string(request.count) + " particles");
    }
  }
}

Beginning begin_packing(const Request &request) {
  check_request(request);
  Beginning beginning{{}, {}, packing::Random(request.seed)};
  const double u = request.random_offset ? beginning.random.uniform() : request.offset;
  beginning.radii = sample_radii(request.law, request.count, u);
  beginning.container.dimension = request.law.dimension;
  beginning.container.periodic = request.periodic;
  const double density = request.density * volume_share(request.arrangement, request.law.dimension);
  beginning.container.edge = box_edge(beginning.radii, density, request.law.dimension);
  check_box(request, beginning.container.edge, beginning.radii.back());
  packing::shuffle(beginning.radii, beginning.random);
  return beginning;
}

Packing make_packing(const Request &request, const SweepObserver &observe) {
  Beginning beginning = begin_packing(request);
  Packing packing;
  packing.particles = beginning.container.empty_set();
  packing.particles.radii = std::move(beginning.radii);
  place_at_random(beginning.container, request.arrangement, beginning.random, packing.particles);
  packing.overlaps = relax(beginning.container, request.sweeps, observe, packing.particles);
  return packing;
}

}  // namespace packing
