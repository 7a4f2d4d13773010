// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// Particles that are hard to decide: packings full of touching pairs, far from the origin, of very different sizes.
#ifndef APP_ACCURACY_SYSTEMS_HPP
#define APP_ACCURACY_SYSTEMS_HPP

#include "packing/size_law.hpp"
#include "particles/particle_set.hpp"

#include <cstddef>

namespace accuracy {

// A packing of density 0.62, smallest radius 1, pushed apart by `sweeps` sweeps: 60 leave many pairs within rounding of
// touching.
app::ParticleSet relaxed(const packing::SizeLaw &law, std::size_t count, int sweeps = 60);

// Spheres of which each touches the one before within rounding, on a random walk through a cube: of edge 20 for 1500,
// as dense for more. Radii are spread evenly in their logarithm from 1 / ratio to 1.
app::ParticleSet touching_chain(std::size_t count, double ratio);

// At least `count` equal spheres on a cubic lattice, each touching its neighbours, turned by some angle so that all
// coordinates are rounded.
app::ParticleSet turned_lattice(std::size_t count);

// All centres, and the box, moved by `offset` on each axis, and rounded.
app::ParticleSet moved(app::ParticleSet particles, double offset);

}  // namespace accuracy

#endif
