// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A plane through a packing: the disks in which it cuts the spheres.
#pragma once

#include "particles/particle_set.hpp"

#include <cstddef>
#include <vector>

namespace draw {

// What is drawn of a level.
struct Level {
  double cell_size = 0;
  double largest_radius = 0;
  size_t particle_count = 0;
};

// A rectangle of the plane, in the packing's length unit; u and v are the two axes of the plane in x, y, z order.
struct Window {
  double u = 0, v = 0;  // lower corner
  double width = 0, height = 0;
};

struct Disk {
  double u = 0, v = 0;  // centre, which is also the sphere's
  double radius = 0;    // of the cut, not of the sphere
  double sphere_radius = 0;
  size_t level = 0;
};

struct Slice {
  Window box;  // the packing's, or the smallest around all particles
  int axis = 2;
  double position = 0;  // of the plane on that axis
  std::vector<Disk> disks;
  std::vector<Level> levels;
};

// Cuts the packing at the fraction `at` of its extent along `axis` (0, 1 or 2). A set in two dimensions is its own
// slice. Spheres that reach through a periodic boundary show on both sides.
Slice cut(const particles::ParticleSet &set, const std::vector<Level> &levels, int axis, double at);

inline bool meets(const Window &window, const Disk &disk) {
  return disk.u + disk.radius > window.u && disk.u - disk.radius < window.u + window.width &&
         disk.v + disk.radius > window.v && disk.v - disk.radius < window.v + window.height;
}

// The number of disks whose cut meets the window.
size_t count_in(const Slice &slice, const Window &window);

}  // namespace draw
