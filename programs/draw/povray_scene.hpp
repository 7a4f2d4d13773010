// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Particles as a scene for the renderer POV-Ray.
#pragma once

#include "particles/particle_set.hpp"
#include "particles/wall_shapes.hpp"

#include <string>
#include <vector>

namespace draw {

// What the colours of particles stand for.
struct Shading {
  std::vector<double> values;  // [count]
  bool logarithmic = false;    // then all values are above 0
  std::string name;            // for the bar of colours
};

struct RenderedScene {
  std::string text;
  double aspect = 1;  // width over height of the picture
};

// Dark for the least value, light for the largest. Spheres are seen from the front, the right and above, within their
// walls, or in the edges of their box if there are none; discs from the front. `cut` leaves out the particles with
// their centre in the eighth of the view towards the viewer.
RenderedScene povray_scene(const particles::ParticleSet &set, const Shading &shading, bool cut,
                           const particles::WallShapes &walls);

}  // namespace draw
