// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The steps of making a packing, and what a request must fulfil.
#include "packing/packing.hpp"

#include "packing/placement.hpp"
#include "packing/portable_math.hpp"
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

std::vector<double> ascending_radii(const Request &request, Random &random) {
  return sample_radii(request.law, request.count, request.random_offset ? random.uniform() : request.offset);
}

// The particles at the places, wrapped into their box if they have one.
particles::ParticleSet in_its_box(Places &places, double scale, std::vector<double> radii) {
  const int dimension = places.dimension();
  particles::ParticleSet set;
  set.dimension = dimension;
  if (places.box_edge() > 0) {
    const Box box(dimension, Vector::Constant(scale * places.box_edge()), {true, true, true});
    set = box.empty_set();
    for (Vector &center : places.centers()) box.wrap(center);
  }
  for (const Vector &center : places.centers())
    set.centers.insert(set.centers.end(), center.data(), center.data() + dimension);
  set.radii = std::move(radii);
  return set;
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
  std::vector<double> radii = ascending_radii(request, random);
  const Box box(dimension, Vector::Constant(box_edge(radii, request.density, dimension)), request.periodic);
  check_box(box, radii.back());
  shuffle(radii, random);
  return {box, std::move(radii), random};
}

particles::ParticleSet lay_particles(const Request &request) {
  check_request(request);
  const int dimension = request.law.dimension;
  Random random(request.seed);
  std::vector<double> radii = ascending_radii(request, random);
  // The radius of the sphere of mean volume.
  const double scale =
      root(volume_of(radii, dimension) / (unit_ball(dimension) * static_cast<double>(radii.size())), dimension);
  shuffle(radii, random);
  Places places(dimension, request.count, request.density, random);
  request.arrangement->lay(places);
  shuffle(places.centers(), random);
  for (Vector &center : places.centers()) center *= scale;
  return in_its_box(places, scale, std::move(radii));
}

Packing make_packing(const Request &request, const SweepObserver &observe) {
  Packing packing;
  if (!request.arrangement->is_even()) {
    packing.particles = lay_particles(request);
    packing.overlaps = exact_overlaps(packing.particles);
    return packing;
  }
  Beginning beginning = begin_packing(request);
  packing.particles = beginning.box.empty_set();
  packing.particles.radii = std::move(beginning.radii);
  place_at_random(beginning.box, beginning.random, packing.particles);
  packing.overlaps = relax(beginning.box, request.sweeps, observe, packing.particles);
  return packing;
}

void scale(particles::ParticleSet &set, double factor) {
  for (double &x : set.centers) x *= factor;
  for (double &r : set.radii) r *= factor;
  for (double &x : set.box_max) x *= factor;
}

}  // namespace packing
