// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Particles that are hard to decide.
#include "programs/accuracy/search/systems.hpp"

#include "packing/packing.hpp"
#include "packing/random.hpp"

#include <cmath>

namespace accuracy {
namespace {

// A direction, all alike.
void draw_direction(packing::Random &random, double *direction) {
  double square = 0;
  do {
    square = 0;
    for (int axis = 0; axis < 3; axis++) {
      direction[axis] = 2 * random.uniform() - 1;
      square += direction[axis] * direction[axis];
    }
  } while (square > 1 || square < 1e-6);
  for (int axis = 0; axis < 3; axis++) direction[axis] /= std::sqrt(square);
}

}  // namespace

particles::ParticleSet relaxed(const packing::SizeLaw &law, size_t count, int sweeps) {
  packing::Request request;
  request.law = law;
  request.count = count;
  request.sweeps = sweeps;
  return packing::make_packing(request, nullptr).particles;
}

particles::ParticleSet touching_chain(size_t count, double ratio) {
  const double half_edge = 10 * std::cbrt(static_cast<double>(count) / 1500);
  packing::Random random(1);
  particles::ParticleSet particles;
  double x[3] = {0, 0, 0}, radius = 1;
  for (size_t i = 0; i < count; i++) {
    const double next = std::pow(ratio, -random.uniform());
    double direction[3];
    draw_direction(random, direction);
    for (int axis = 0; axis < 3; axis++) {
      const double step = (radius + next) * direction[axis];
      x[axis] += std::fabs(x[axis] + step) > half_edge ? -step : step;
    }
    radius = next;
    particles.centers.insert(particles.centers.end(), x, x + 3);
    particles.radii.push_back(radius);
  }
  return particles;
}

particles::ParticleSet turned_lattice(size_t count) {
  constexpr double kRadius = 0.1;
  // Turns about z by 0.3, then about x by 0.7.
  const double c = std::cos(0.3), s = std::sin(0.3), c2 = std::cos(0.7), s2 = std::sin(0.7);
  size_t side = 1;
  while (side * side * side < count) side++;
  particles::ParticleSet particles;
  for (size_t cell = 0; cell < side * side * side; cell++) {
    const size_t place[] = {cell % side, cell / side % side, cell / side / side};
    const double u = 2 * kRadius * static_cast<double>(place[0]), v = 2 * kRadius * static_cast<double>(place[1]),
                 w = 2 * kRadius * static_cast<double>(place[2]);
    const double turned = s * u + c * v;
    for (const double x : {c * u - s * v, c2 * turned - s2 * w, s2 * turned + c2 * w}) particles.centers.push_back(x);
    particles.radii.push_back(kRadius);
  }
  return particles;
}

particles::ParticleSet moved(particles::ParticleSet particles, double offset) {
  for (double &x : particles.centers) x += offset;
  for (int axis = 0; axis < particles.dimension && particles.has_box; axis++) {
    particles.box_min[axis] += offset;
    particles.box_max[axis] += offset;
  }
  return particles;
}

}  // namespace accuracy
