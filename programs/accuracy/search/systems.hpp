// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Particles that are hard to decide: packings full of touching pairs, far from the origin, of very different sizes.
#pragma once

#include "packing/size_law.hpp"
#include "particles/particle_set.hpp"

#include <cstddef>

namespace accuracy {

// A size law by the name that points have it under.
struct NamedLaw {
  const char *name;
  packing::SizeLaw law;
};
inline const NamedLaw kEqualSpheres{"equal spheres", {packing::Law::kMono, 1, 3}};
inline const NamedLaw kUniformVolume10{"uniform volume, ratio 10", {packing::Law::kUniformVolume, 10, 3}};
inline const NamedLaw kUniformVolume50{"uniform volume, ratio 50", {packing::Law::kUniformVolume, 50, 3}};
inline const NamedLaw kUniformSize50{"uniform size, ratio 50", {packing::Law::kUniformSize, 50, 3}};

// A packing of density 0.62, smallest radius 1, pushed apart by `sweeps` sweeps: 60 leave many pairs within rounding of
// touching.
particles::ParticleSet relaxed(const packing::SizeLaw &law, size_t count, int sweeps = 60);

// Spheres of which each touches the one before within rounding, on a random walk through a cube: of edge 20 for 1500,
// as dense for more. Radii are spread evenly in their logarithm from 1 / ratio to 1.
particles::ParticleSet touching_chain(size_t count, double ratio);

// At least `count` equal spheres on a cubic lattice, each touching its neighbours, turned by some angle so that all
// coordinates are rounded.
particles::ParticleSet turned_lattice(size_t count);

// All centres, and the box, moved by `offset` on each axis, and rounded.
particles::ParticleSet moved(particles::ParticleSet particles, double offset);

}  // namespace accuracy
