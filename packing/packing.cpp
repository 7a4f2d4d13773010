// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The steps of making a packing, and what a request must fulfil.
#include "packing/packing.hpp"

#include "packing/placement.hpp"
#include "particles/error.hpp"
#include "particles/text/number.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <utility>

namespace packing {
namespace {

using particles::text;

// Ids are 32-bit numbers.
constexpr size_t kMostParticles = std::numeric_limits<int32_t>::max();

void check_box(const Box &box, double largest_radius) {
  const double edge = box.edge(0);
  if (box.any_wall() && edge < 2 * largest_radius) {
    throw particles::Error("the box (edge " + text(edge) + ") is smaller than the largest particle (diameter " +
                           text(2 * largest_radius) + "): raise the count or lower the density");
  }
  if (box.any_periodic() && edge < 4 * largest_radius) {
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
  if (!(request.offset >= 0) || !(request.offset < 1)) {
    throw particles::Error("the offset of the sampling lies in [0, 1), not at " + text(request.offset));
  }
  if (request.sweeps < 0) {
    throw particles::Error("the number of sweeps cannot be negative: " + std::to_string(request.sweeps));
  }
  const std::string fault = law_fault(law, request.count);
  if (!fault.empty()) throw particles::Error(fault);
}

Beginning begin_packing(const Request &request) {
  check_request(request);
  const int dimension = request.law.dimension;
  Random random(request.seed);
  std::vector<double> radii =
      sample_radii(request.law, request.count, request.random_offset ? random.uniform() : request.offset);
  const double density = request.density * row_of(request.arrangement).share(dimension);
  const double edge = box_edge(radii, density, dimension);
  const Box box(dimension, Vector::Constant(edge), request.periodic);
  check_box(box, radii.back());
  shuffle(radii, random);
  return {box, std::move(radii), random};
}

Packing make_packing(const Request &request, const SweepObserver &observe) {
  Beginning beginning = begin_packing(request);
  Packing packing;
  packing.particles = beginning.box.empty_set();
  packing.particles.radii = std::move(beginning.radii);
  place_at_random(beginning.box, request.arrangement, beginning.random, packing.particles);
  packing.overlaps = relax(beginning.box, request.sweeps, observe, packing.particles);
  return packing;
}

}  // namespace packing
